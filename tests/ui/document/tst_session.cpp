// SPDX-License-Identifier: GPL-3.0-or-later

// Edits, undo, background computation and the opening of scenes.

#include "core/closed_form/closed_form.h"
#include "tests/support/files.h"
#include "tests/support/initial_mechanism.h"
#include "tests/support/suite.h"
#include "tests/support/waiting.h"
#include "ui/document/session.h"
#include "ui/document/with.h"

#include <QSignalSpy>
#include <QTest>

#include <cmath>
#include <limits>

using namespace slidercrank;

namespace tst_session
{

/// Reference data of one column that take long to compare.
std::shared_ptr<Reference> largeReference()
{
    auto large = std::make_shared<Reference>();
    for (int i = 0; i < 1000000; ++i) {
        large->data.time.push_back(i * 1e-6);
    }
    large->data.series = {{{R4x, Order::Position}, std::vector<double>(large->data.time.size(), 80.0), {}}};
    return large;
}

/// Selects Newton-Raphson, which takes long for a million time steps.
void useNewton(Session &session)
{
    session.setSolver(with(session.solver(), &SolverSettings::method, Method::Newton));
}

class TestSession : public QObject
{
    Q_OBJECT

private slots:
    void publishesOneResultPerEdit()
    {
        Session session;
        QCOMPARE(session.result()->trajectory.summary.count(Status::Solved),
                 std::size_t(201)); // the default, as in Table 1 of the reference report
        QSignalSpy results(&session, &Session::resultChanged);
        session.setParameters(withCoupler(70.0));
        session.setParameters(withCoupler(70.0)); // no change
        session.setTime(0.3);                     // does not compute a result
        QCOMPARE(results.count(), 1);
        QCOMPARE(session.result()->mechanism.b(), 70.0);
        session.setParameters(withCoupler(4.0));
        QCOMPARE(session.result()->limits.mobility, Mobility::Impossible);
        QVERIFY(!session.pose().exists());
        session.undoStack().undo();
        QVERIFY(session.pose().exists());
    }

    /// sin 330° = -1/2 = (c - b)/a. A former defect: because the angle is rounded, the drawing said that the mechanism
    /// could not be assembled.
    void theEndsOfARockersArcArePoses()
    {
        for (const double degrees : {210.0, 330.0}) {
            for (const double omega2 : {1.0, 7.0, -3.0, 0.0}) {
                const double theta2 = degrees / kDegreesPerRadian;
                const Pose pose = poseAt({.a = 60.0, .b = 50.0, .c = 20.0, .omega2 = omega2, .theta20 = theta2}, 0.0);
                QVERIFY(pose.exists());
                QCOMPARE(pose.motion.theta3 * kDegreesPerRadian, 90.0);
                QVERIFY(std::abs(pose.motion.R4x - 60.0 * std::cos(theta2)) < 1e-13);
                QCOMPARE(pose.motion.R4xDot == 0.0, omega2 == 0.0);
            }
        }
    }

    void refusesInvalidParameters()
    {
        const std::pair<double, const char *> rows[] = {{0.0, "at least"},
                                                        {-1.0, "at least"},
                                                        {1e-10, "at least"},
                                                        {std::numeric_limits<double>::quiet_NaN(), "a number"},
                                                        {2e12, "up to"}};
        for (const auto &[b, reason] : rows) {
            Session session;
            const auto before = session.result();
            QSignalSpy problems(&session, &Session::problemFound);
            QSignalSpy returned(&session, &Session::parametersChanged);
            session.setParameters(withCoupler(b));
            QCOMPARE(problems.count(), 1);
            QVERIFY2(problems[0][0].toString().contains(reason), reason);
            QCOMPARE(returned.count(), 1); // the widgets show the former value again
            QCOMPARE(session.result(), before);
            QCOMPARE(session.undoStack().count(), 0);
        }
    }

    void keepsTheTimeInTheTimeRange()
    {
        Session session;
        session.setTime(7.0);
        QCOMPARE(session.time(), 1.0);
        session.setTime(-1.0);
        QCOMPARE(session.time(), 0.0);
        session.setTime(0.75);
        session.setSampling({0.0, 0.5, 200});
        QCOMPARE(session.time(), 0.5);
    }

    void computesLongMotionsInTheBackground()
    {
        Session session;
        useNewton(session);
        QSignalSpy results(&session, &Session::resultChanged);
        QSignalSpy busy(&session, &Session::busyChanged);
        session.setSampling({0.0, 1.0, 400000});
        QCOMPARE(results.count(), 0);
        QCOMPARE(busy.count(), 1);
        for (const double b : {66.0, 67.0, 68.0}) {
            session.setParameters(withCoupler(b));
        }
        AWAIT_COMPARE(busy.count(), 2);
        QCOMPARE(session.result()->mechanism.b(), 68.0);
        QCOMPARE(session.result()->trajectory.time.size(), std::size_t(400001));
    }

    /// Cancelling is an edit of its own, which can be undone.
    void cancelReturnsToTheChoicesOfTheResult()
    {
        Session session;
        session.setReference(std::make_shared<Reference>());
        useNewton(session);
        const auto before = session.result();
        QSignalSpy busy(&session, &Session::busyChanged);
        session.setSampling({0.0, 1.0, 1000000});
        session.setParameter(Parameter::B, 67.0);
        session.setReference(largeReference());
        QCOMPARE(session.result(), before);
        session.cancel();
        QCOMPARE(session.result(), before);
        QCOMPARE(session.parameters().b, 65.0);
        QCOMPARE(session.sampling(), Sampling());
        QCOMPARE(session.reference(), before->reference);
        QCOMPARE(session.undoStack().undoText(), "cancelling");
        AWAIT_COMPARE(busy.count(), 2);
        session.undoStack().undo();
        QCOMPARE(session.parameters().b, 67.0);
        session.cancel();
    }

    /// Without the simplification, the result of the previous scene would be shown with the choices of the new one.
    void aSceneThatTakesLongIsSimplifiedUntilItIsComputed()
    {
        Session session;
        Choices opened{withCoupler(80.0), session.sampling(), session.solver(), nullptr};
        opened.solver.method = Method::Newton;
        opened.sampling.steps = 1000000;
        session.open(opened, 0.0, std::nullopt);
        QCOMPARE(session.result()->choices.parameters, opened.parameters);
        QVERIFY(session.parameters() == opened.parameters && session.solver() == opened.solver);
        session.cancel();
        QCOMPARE(session.result()->choices.solver, session.solver());
        QCOMPARE(session.result()->choices.sampling, session.sampling());
        QVERIFY(session.isModified());
        session.undoStack().undo();
        AWAIT(session.result()->choices == opened);

        Session other; // a large file is left out
        const auto large = largeReference();
        other.open(with(Choices(), &Choices::reference, large), 0.0, std::nullopt);
        other.cancel();
        QVERIFY(!other.reference() && !other.result()->reference);
        other.undoStack().undo();
        QCOMPARE(other.reference(), large);
        other.cancel();
    }

    void openingASceneCannotBeUndone()
    {
        Session session;
        session.setParameters(withCoupler(70.0));
        QVERIFY(session.isModified());
        session.open(Choices(), 0.0, std::nullopt);
        QVERIFY(!session.isModified() && session.undoStack().count() == 0);
        QCOMPARE(session.result()->mechanism.b(), 65.0);
    }

    void theReferenceOfASceneDoesNotReplaceEdits()
    {
        Session session;
        Choices choices;
        choices.parameters.a = 12.0;
        session.open(choices, 0.5, ReferenceSource{{kSample}, {}, {}});
        QCOMPARE(session.time(), 0.5);
        session.setParameter(Parameter::B, 70.0); // while the reference is being read
        AWAIT(session.reference());
        QCOMPARE(session.parameters().a, 12.0);
        QCOMPARE(session.parameters().b, 70.0);
    }

    void everyEditIsUndoneAndRedone()
    {
        Session session;
        std::vector<Choices> choices{session.result()->choices};
        const std::pair<std::function<void()>, const char *> edits[] = {
            {[&] { session.setParameter(Parameter::B, 70.0); }, "change of b"},
            {[&] {
                 session.setSampling({0.0, 1.0, 100});
             },
             "change of the time range"},
            {[&] { useNewton(session); }, "change of the method"},
            {[&] { session.setAlpha2(-10.0); }, "change of α₂"},
            {[&] { session.setReference(std::make_shared<Reference>()); }, "opening of "},
            {[&] { session.pinMotion(); }, "pinning of the motion"},
            {[&] { session.unpinMotions(); }, "removal of the pinned motions"}};
        for (const auto &[edit, name] : edits) {
            edit();
            QCOMPARE(session.undoStack().undoText(), QString(name));
            QVERIFY(session.result()->choices != choices.back());
            choices.push_back(session.result()->choices);
        }
        QSignalSpy parameters(&session, &Session::parametersChanged);
        QSignalSpy settings(&session, &Session::settingsChanged);
        QSignalSpy results(&session, &Session::resultChanged);
        for (std::size_t i = choices.size() - 1; i-- > 0;) {
            session.undoStack().undo();
            QVERIFY(session.result()->choices == choices[i]);
        }
        QCOMPARE(results.count(), session.undoStack().count());
        QCOMPARE(parameters.count(), 1);
        QCOMPARE(settings.count(), 2);
        session.undoStack().setIndex(session.undoStack().count());
        QVERIFY(session.result()->choices == choices.back());
    }

    void motionsArePinnedAndRemoved()
    {
        Session session;
        session.pinMotion();
        session.pinMotion(); // is already pinned
        QCOMPARE(session.pinned().size(), std::size_t(1));
        session.setParameter(Parameter::B, 80.0);
        QVERIFY(session.result()->pinned == session.pinned() && session.result()->isCompared());
        const Motion now = ClosedForm(Mechanism(session.parameters())).motionAt(0.0);
        const Motion pinned = ClosedForm(Mechanism(Parameters())).motionAt(0.0);
        const auto difference = [&session] { return session.result()->difference->channels[1].largestError; };
        QVERIFY(difference() >= now.R4x - pinned.R4x);
        session.setReference(std::make_shared<Reference>()); // takes precedence over pinned motions
        QVERIFY(session.result()->reference && !session.result()->difference);
        session.setReference(nullptr);
        for (const double b : {80.0, 81.0, 82.0, 83.0}) {
            session.setParameter(Parameter::B, b);
            session.pinMotion();
            QCOMPARE(difference(), 0.0); // compared with the motion that was pinned last
        }
        QCOMPARE(session.pinned().size(), kMaxPinned);
        QCOMPARE(session.pinned().front().b, 80.0); // the oldest motion was replaced
        session.unpinMotions();
        QVERIFY(session.pinned().empty() && !session.result()->isCompared());
    }

    void aDragIsUndoneInOneStep()
    {
        Session session;
        const auto dragTo = [&session](std::initializer_list<double> couplers) {
            session.beginDrag();
            for (const double b : couplers) {
                session.setParameter(Parameter::B, b);
                letTimePass(session); // without a drag, a later edit would be a new step
            }
            session.endDrag();
        };
        dragTo({66.0, 67.0, 68.0});
        dragTo({69.0, 70.0}); // a second drag
        QCOMPARE(session.undoStack().count(), 2);
        session.undoStack().undo();
        QCOMPARE(session.parameters().b, 68.0);
        session.undoStack().undo();
        QCOMPARE(session.parameters().b, 65.0);
        dragTo({70.0, 65.0}); // back to the initial value
        QVERIFY(!session.undoStack().canUndo());
        session.beginDrag(); // a drag in the design form changes several lengths
        session.setParameter(Parameter::A, 21.0);
        session.setParameters(withCoupler(66.0));
        session.endDrag();
        QCOMPARE(session.undoStack().count(), 1);
    }

    void repeatedEditsOfOneParameterAreOneStep()
    {
        Session session;
        for (const double b : {66.0, 67.0, 68.0}) {
            session.setParameter(Parameter::B, b);
        }
        session.setParameter(Parameter::A, 21.0);
        QCOMPARE(session.undoStack().count(), 2);
        QCOMPARE(session.undoStack().undoText(), "change of a");
        letTimePass(session); // the key is pressed again later
        session.setParameter(Parameter::A, 22.0);
        QCOMPARE(session.undoStack().count(), 3);
        Parameters parameters = session.parameters();
        for (const double b : {70.0, 71.0}) { // changes a and b together
            parameters.a = 0.4 * b;
            parameters.b = b;
            session.setParameters(parameters);
        }
        QCOMPARE(session.undoStack().count(), 4);
        parameters.b = 72.0;
        parameters.c = 20.0;
        session.setParameters(parameters); // has the same name, but changes other parameters
        QCOMPARE(session.undoStack().count(), 5);
    }
};

const Suite<TestSession> suite("tst_session");

} // namespace tst_session

#include "tst_session.moc"
