// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/session.h"

#include "core/closed_form/closed_form.h"
#include "tests/support/suite.h"

#include "tests/support/waiting.h"
#include "ui/document/with.h"

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <limits>

#ifdef Q_OS_UNIX
#include <sys/stat.h>
#endif

using namespace slidercrank;

namespace
{

const QString kSample = QStringLiteral(SLIDERCRANK_SOURCE_DIR "/data/inventor_sample.csv"); // b = 60 mm

QString writeFile(const QTemporaryDir &folder, const QByteArray &bytes,
                  const QString &name = QStringLiteral("motion.csv"))
{
    QFile file(folder.filePath(name));
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size()) {
        qFatal("cannot write %s", qPrintable(file.fileName()));
    }
    return file.fileName();
}

/// A table by the crank angle of the default mechanism; its angles are counted from `zero` degrees on.
QByteArray angleTable(int zero)
{
    QByteArray table = "CAD,theta3,R4_x\n";
    for (int angle = 0; angle <= 360; angle += 15) {
        const double theta2 = (angle + zero) / kDegreesPerRadian;
        const double theta3 = std::asin((25.0 - 20.0 * std::sin(theta2)) / 65.0);
        table += QByteArray::number(angle) + ',' + QByteArray::number(theta3 * kDegreesPerRadian, 'f', 6) + ',' +
                 QByteArray::number(20.0 * std::cos(theta2) + 65.0 * std::cos(theta3), 'f', 6) + '\n';
    }
    return table;
}

bool allAgree(const std::vector<ChannelComparison> &comparison)
{
    return !comparison.empty() && std::ranges::all_of(comparison, [](const ChannelComparison &channel) {
        return channel.verdict == Verdict::Agrees;
    });
}

Parameters withCoupler(double b)
{
    Parameters parameters;
    parameters.b = b;
    return parameters;
}

/// Reference data of one column, that takes long to compare.
std::shared_ptr<Reference> largeReference()
{
    auto large = std::make_shared<Reference>();
    for (int i = 0; i < 1000000; ++i) {
        large->data.time.push_back(i * 1e-6);
    }
    large->data.series = {{{R4x, Order::Position}, std::vector<double>(large->data.time.size(), 80.0), {}}};
    return large;
}

/// Newton-Raphson: a million steps take long.
void useNewton(Session &session)
{
    session.setSolver(with(session.solver(), &SolverSettings::method, Method::Newton));
}

const QByteArray kSmallFile = "time,R4_x\n0,85\n0.5,45\n";

} // namespace

class TestSession : public QObject
{
    Q_OBJECT

private slots:
    void publishesOneResultForOneEdit()
    {
        Session session;
        QCOMPARE(session.result()->trajectory.summary.count(Status::Solved), std::size_t(201)); // Table 1
        QSignalSpy results(&session, &Session::resultChanged);
        session.setParameters(withCoupler(70.0));
        session.setParameters(withCoupler(70.0)); // no change
        session.setTime(0.3);                     // computes nothing
        QCOMPARE(results.count(), 1);
        QCOMPARE(session.result()->mechanism.b(), 70.0);
        session.setParameters(withCoupler(4.0));
        QCOMPARE(session.result()->limits.mobility, Mobility::Impossible);
        QVERIFY(!session.pose().exists());
        session.undoStack().undo();
        QVERIFY(session.pose().exists());
    }

    void refusesWhatIsNoMechanism()
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
            QVERIFY2(problems[0][0].toString().contains(QLatin1String(reason)), reason);
            QCOMPARE(returned.count(), 1); // the controls return to the value before
            QCOMPARE(session.result(), before);
            QCOMPARE(session.undoStack().count(), 0);
        }
    }

    void poseAgreesWithTheTextbook()
    {
        Session session;
        QSignalSpy times(&session, &Session::timeChanged);
        session.setTime(0.25); // the crank points up: A is 20 - 25 mm below the slider's line
        QCOMPARE(times.count(), 1);
        const Pose pose = session.pose();
        QVERIFY(std::abs(pose.pinX) < 1e-12);
        QVERIFY(std::abs(pose.pinY - 20.0) < 1e-12);
        QVERIFY(std::abs(pose.theta3 - std::asin(5.0 / 65.0)) < 1e-14);
        QVERIFY(std::abs(pose.sliderX - std::sqrt(65.0 * 65.0 - 25.0)) < 1e-12);
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

    /// Data outside the time range would not be shown.
    void theTimeRangeBecomesThatOfAFileOutsideIt()
    {
        const QTemporaryDir folder;
        const QString path = writeFile(folder, "time,R4_x\n0.5,80\n4,70\n8,60\n10.5,75\n");
        for (const Sampling &before : {Sampling{0.0, 1.0, 500}, Sampling{-1.0, 20.0, 500}}) {
            const bool isInside = before.duration > 10.0;
            const Sampling after = isInside ? before : Sampling{0.5, 10.0, 500};
            Session session;
            session.setSampling(before);
            QSignalSpy loaded(&session, &Session::referenceLoaded);
            QSignalSpy follows(&session, &Session::timeRangeReplaced);
            session.loadReference(path);
            QVERIFY(loaded.wait(kPatience));
            QCOMPARE(session.sampling(), after);
            QCOMPARE(follows.count(), isInside ? 0 : 1);
            QCOMPARE(session.time(), isInside ? 0.0 : 0.5);
            session.undoStack().undo();
            QVERIFY(!session.reference());
            QCOMPARE(session.sampling(), before);
            session.undoStack().redo();
            QVERIFY(session.reference());
            QCOMPARE(session.sampling(), after);
        }
        Session session; // but that of a scene stays as it was saved
        Choices saved;
        saved.sampling = {0.0, 2.0, 40};
        QSignalSpy opened(&session, &Session::opened);
        session.open(saved, 1.0, ReferenceSource{{path}, {}, {}});
        QVERIFY(opened.wait(kPatience));
        QVERIFY(session.reference());
        QCOMPARE(session.sampling(), saved.sampling);
    }

    void readsAFileInTheBackgroundAndCompares()
    {
        const QTemporaryDir folder;
        const QString path = writeFile(folder, kSmallFile, QStringLiteral("año 1 Δ.csv"));
        Session session;
        QSignalSpy loaded(&session, &Session::referenceLoaded);
        QSignalSpy results(&session, &Session::resultChanged);
        session.loadReference(path);
        QCOMPARE(results.count(), 0);
        QVERIFY(loaded.wait(kPatience));
        AWAIT_COMPARE(results.count(), 1);
        QCOMPARE(session.reference()->name, QStringLiteral("año 1 Δ.csv"));
        QCOMPARE(session.result()->comparison.size(), std::size_t(1));
        const double exact = 20.0 + std::sqrt(65.0 * 65.0 - 25.0 * 25.0); // 80 mm at t = 0
        QVERIFY(std::abs(*session.result()->comparison[0].maxAbs - (85.0 - exact)) < 1e-9);

        // A file that is opened is no change of the scene, whether or not that is undone.
        QVERIFY(session.undoStack().canUndo() && !session.isModified());
        session.setReference(nullptr);
        QVERIFY(session.result()->comparison.empty() && !session.isModified());
        session.undoStack().undo();
        session.setParameter(Parameter::B, 66.0);
        QVERIFY(session.isModified());
        session.undoStack().setClean();
        session.undoStack().setIndex(0);
        QVERIFY(session.isModified());
    }

    void timesATableByTheCrankAngleWithEachCrankSpeed()
    {
        const QTemporaryDir folder;
        Session session;
        QSignalSpy loaded(&session, &Session::referenceLoaded);
        QSignalSpy problems(&session, &Session::problemFound);
        session.loadReference(writeFile(folder, angleTable(0)));
        AWAIT(session.reference() && session.diagnosis());
        const auto chosen = session.reference();
        const auto lastTime = [&session] { return session.result()->reference->data.time.back(); };
        QVERIFY(allAgree(session.result()->comparison));
        QCOMPARE(lastTime(), 1.0);

        // Another speed: the file stays, its time stamps and the time range change, and it agrees as before.
        Parameters parameters;
        parameters.omega2 = -4.0;
        parameters.theta20 = 0.5;
        session.setParameters(parameters);
        QVERIFY(allAgree(session.result()->comparison));
        QVERIFY(std::abs(lastTime() - (0.0 - 0.5) / -4.0) < 1e-12); // the other way: 0° comes last
        QVERIFY(std::abs(session.sampling().start - (2.0 * std::numbers::pi - 0.5) / -4.0) < 1e-12);
        QVERIFY(std::abs(session.sampling().duration - 2.0 * std::numbers::pi / 4.0) < 1e-12);
        QCOMPARE(session.undoStack().undoText(), QStringLiteral("change of the mechanism"));
        QCOMPARE(session.reference(), chosen);
        QCOMPARE(loaded.count(), 1);
        QCOMPARE(session.result()->choices.reference, chosen);
        AWAIT(session.diagnosis() && session.diagnosis()->parameters == parameters);
        QCOMPARE(session.diagnosis()->reference, chosen);
        QVERIFY(!session.diagnosis()->found.identification.identifiable[indexOf(Parameter::Omega2)]);
        session.undoStack().undo();
        QCOMPARE(lastTime(), 1.0);
        QCOMPARE(session.sampling(), Sampling());
        session.setSampling({0.0, 2.0, 100}); // a time range that a person chose stays
        session.setParameters(parameters);
        QCOMPARE(session.sampling(), (Sampling{0.0, 2.0, 100}));
        session.undoStack().undo();

        // A crank at rest never reaches those angles.
        parameters.omega2 = 0.0;
        session.setParameters(parameters);
        QCOMPARE(problems.count(), 1);
        QVERIFY(problems[0][0].toString().contains(QStringLiteral("choose another ω₂")));
        QCOMPARE(session.parameters(), Parameters());
        session.setReference(nullptr);
        session.setParameters(parameters);
        QCOMPARE(session.parameters(), parameters);
        QSignalSpy refused(&session, &Session::referenceRefused);
        session.loadReference(chosen->paths);
        AWAIT(refused.count() == 1);
        QVERIFY(!session.reference());
    }

    void findsWhereTheAnglesOfATableAreCountedFrom()
    {
        const QTemporaryDir folder;
        Session session;
        session.loadReference(writeFile(folder, angleTable(30)));
        AWAIT(session.reference() && session.diagnosis());
        QVERIFY(!allAgree(session.result()->comparison));
        const std::vector<ConventionFinding> findings = session.diagnosis()->found.conventions;
        QCOMPARE(findings.size(), std::size_t(1));
        QCOMPARE(findings.front().convention.amount, 30.0);
        session.apply(findings.front().convention);
        QVERIFY(allAgree(session.result()->comparison));
        QVERIFY(session.isModified());
        session.setParameter(Parameter::Omega2, 100.0);
        QVERIFY(allAgree(session.result()->comparison));
        session.readAsPrinted();
        QVERIFY(!allAgree(session.result()->comparison));
    }

    void changesNothingIfAFileCannotBeRead()
    {
        const QTemporaryDir folder;
        Session session;
        session.loadReference(writeFile(folder, kSmallFile));
        AWAIT(session.reference());
        const auto before = session.reference();
        QStringList paths{folder.filePath(QStringLiteral("missing.csv"))};
        for (const QByteArray &bytes :
             {QByteArray(), QByteArray("time,banana\n0,1\n"), QByteArray("\x7f\0\1\2\xff", 5)}) {
            paths += writeFile(folder, bytes, QStringLiteral("bad%1.csv").arg(paths.size()));
        }
#ifdef Q_OS_UNIX
        paths += folder.filePath(QStringLiteral("pipe.csv")); // nobody writes into it, and nobody waits for that
        QCOMPARE(mkfifo(QFile::encodeName(paths.last()).constData(), 0600), 0);
#endif
        QSignalSpy refused(&session, &Session::referenceRefused);
        for (const QString &path : paths) {
            session.loadReference(path);
            AWAIT(refused.count() == 1);
            QVERIFY(refused.takeFirst()[1].toString().contains(QFileInfo(path).fileName()));
            QCOMPARE(session.reference(), before);
        }
    }

    void reportsHowFarALargeFileIsRead()
    {
        QByteArray bytes = "time,theta3,R4_x\n";
        for (int row = 0; row < 1'000'000; ++row) {
            bytes += QByteArray::number(row) + ",20,75\n";
        }
        const QTemporaryDir folder;
        Session session;
        QSignalSpy parts(&session, &Session::readingProgressed);
        session.loadReference(writeFile(folder, bytes));
        AWAIT(session.reference());
        QVERIFY(parts.count() > 1);
        for (qsizetype i = 0; i < parts.size(); ++i) {
            const double part = parts[i][0].toDouble();
            QVERIFY(part >= (i == 0 ? 0.0 : parts[i - 1][0].toDouble()) && part <= 1.0);
        }
    }

    void computesLongRunsInTheBackgroundAndTheLastEditWins()
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

    /// To what is shown, as one more edit.
    void cancelReturnsToTheChoicesOfTheResult()
    {
        Session session;
        session.setReference(std::make_shared<Reference>());
        useNewton(session);
        session.setParameter(Parameter::B, 66.0);
        const auto before = session.result();
        QSignalSpy busy(&session, &Session::busyChanged);
        QSignalSpy references(&session, &Session::referenceLoaded);
        session.setSampling({0.0, 1.0, 1000000});
        session.setParameter(Parameter::B, 67.0);
        session.setReference(largeReference());
        QCOMPARE(session.result(), before);
        QVERIFY(session.cancel());
        QCOMPARE(session.result(), before);
        QCOMPARE(session.parameters().b, 66.0);
        QCOMPARE(session.sampling(), Sampling());
        QCOMPARE(session.reference(), before->reference);
        QCOMPARE(references.count(), 2); // there and back
        QCOMPARE(session.undoStack().undoText(), QStringLiteral("cancelling"));
        AWAIT_COMPARE(busy.count(), 2);
        session.undoStack().undo();
        QCOMPARE(session.parameters().b, 67.0);
        session.cancel();
        QCOMPARE(session.parameters().b, 66.0);
    }

    /// A result of the scene before would be shown beside the choices of this one.
    void cancelSimplifiesASceneThatTakesLong()
    {
        Session session;
        Choices opened{withCoupler(80.0), session.sampling(), session.solver(), nullptr};
        opened.solver.method = Method::Newton;
        opened.sampling.steps = 1000000;
        session.open(opened, 0.0, std::nullopt);
        QSignalSpy problems(&session, &Session::problemFound);
        QVERIFY(!session.cancel());
        QCOMPARE(problems.count(), 1);
        QCOMPARE(session.parameters(), opened.parameters);
        QCOMPARE(session.result()->mechanism.parameters(), opened.parameters);
        QCOMPARE(session.result()->solver, session.solver());
        QCOMPARE(session.result()->sampling, session.sampling());
        QVERIFY(session.isModified());
        session.undoStack().undo();
        AWAIT_COMPARE(session.result()->solver, opened.solver);
        QCOMPARE(session.result()->sampling, opened.sampling);

        Session other; // and leaves out a large file
        const auto large = largeReference();
        other.setReference(large);
        other.undoStack().clear(); // as if it had been opened with a scene
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
        Choices choices;
        choices.parameters.b = 80.0;
        session.open(choices, 0.0, std::nullopt);
        QVERIFY(!session.isModified() && session.undoStack().count() == 0);
        QCOMPARE(session.result()->mechanism.b(), 80.0);
    }

    void asksBeforeASceneReplacesWhatWasEditedMeanwhile()
    {
        Session session;
        Choices choices;
        choices.parameters.b = 80.0;
        std::function<void()> open;
        connect(&session, &Session::editedMeanwhile, this, [&open](const auto &ready) { open = ready; });
        QSignalSpy opened(&session, &Session::opened);
        session.open(choices, 0.5, ReferenceSource{{kSample}, {}, {}});
        session.setParameters(withCoupler(70.0));
        AWAIT(open);
        QCOMPARE(opened.count(), 0);
        QCOMPARE(session.parameters().b, 70.0);
        open();
        QCOMPARE(opened.count(), 1);
        QCOMPARE(session.parameters().b, 80.0);
        QVERIFY(session.reference());
    }

    void aSearchThatIsCancelledIsOver()
    {
        Session session;
        QSignalSpy busy(&session, &Session::busyChanged);
        session.setReference(std::get<std::shared_ptr<const Reference>>(readReference({{kSample}, {}, {}})));
        letTimePass(session);
        QCOMPARE(busy.count(), 1);
        session.cancel();
        QVERIFY(session.diagnosis() && session.diagnosis()->found.identification.stopped);
        finishAside();
        letTimePass(session);
        QCOMPARE(busy.count(), 2);
        QVERIFY(session.diagnosis()->found.identification.stopped);
        session.setParameter(Parameter::B, 64.0);
        AWAIT_COMPARE(session.diagnosis()->found.identification.outcome, Identification::Outcome::Identified);

        // Nor does one come back whose file is closed.
        session.setParameter(Parameter::B, 70.0);
        letTimePass(session);
        session.setReference(nullptr);
        finishAside();
        letTimePass(session);
        QVERIFY(!session.diagnosis());
        session.useFoundMechanism();
        QCOMPARE(session.parameters().b, 70.0);
    }

    void oneClickTakesTheFoundMechanismOver()
    {
        Session session; // Table 1: b = 65 mm
        QSignalSpy diagnoses(&session, &Session::diagnosisChanged);
        session.loadReference(kSample);
        AWAIT_COMPARE(diagnoses.count(), 1);
        const ReferenceDiagnosis &diagnosis = *session.diagnosis();
        QCOMPARE(diagnosis.reference, session.reference());
        QCOMPARE(diagnosis.found.identification.outcome, Identification::Outcome::Identified);
        QVERIFY(diagnosis.found.change);
        QCOMPARE(diagnosis.found.change->parameter, Parameter::B);
        QVERIFY(std::abs(diagnosis.found.change->value - 60.0) < 1e-4);
        QVERIFY(diagnosis.found.change->explained > 0.999999);

        session.useFoundMechanism();
        QCOMPARE(session.parameters(), withCoupler(60.0)); // not 19.9999997 and 60.0000003
        QCOMPARE(session.result()->comparison.size(), std::size_t(6));
        QVERIFY(allAgree(session.result()->comparison));
        AWAIT(session.diagnosis()->parameters == session.parameters());
        QVERIFY(!session.diagnosis()->found.change && session.diagnosis()->found.conventions.empty());
        session.undoStack().undo();
        QCOMPARE(session.parameters(), Parameters());
        QVERIFY(!allAgree(session.result()->comparison));
        session.undoStack().redo();
        QCOMPARE(session.undoStack().undoText(), QStringLiteral("use of the file's mechanism"));
    }

    void identifiesTheFileAgainWhenTheParametersRest()
    {
        Session session;
        session.loadReference(kSample);
        AWAIT(session.diagnosis());
        const auto first = session.diagnosis();
        QSignalSpy diagnoses(&session, &Session::diagnosisChanged);
        const auto timers = session.findChildren<QTimer *>();
        for (int i = 1; i <= 5; ++i) {
            for (QTimer *timer : timers) {
                timer->setInterval(kPatience);
            }
            session.setParameters(withCoupler(65.0 + i));
            for (const QTimer *timer : timers) {
                QVERIFY(timer->isActive() && timer->interval() < kPatience); // each edit starts the rest again
            }
        }
        QCOMPARE(diagnoses.count(), 0);
        QCOMPARE(session.diagnosis(), first);
        AWAIT_COMPARE(diagnoses.count(), 1);
        QCOMPARE(session.diagnosis()->parameters.b, 70.0);
        QCOMPARE(session.diagnosis()->found.identification.parameters, first->found.identification.parameters);
    }

    void aConventionIsAppliedAndTakenBack()
    {
        const Channel theta3{Theta3, Order::Position};
        auto printed = std::make_shared<Reference>();
        printed->data.time = {0.0, 0.5};
        printed->data.series = {{theta3, {0.25, 0.5}, {}}};
        Session session;
        session.setReference(printed);
        const Convention radians{Convention::Kind::AngleUnit, {theta3}, 2.0};
        session.apply(radians);
        session.apply(radians);
        QCOMPARE(session.reference()->data.find(theta3)->values[1], 2.0);
        QCOMPARE(session.reference()->conventions.size(), std::size_t(2));
        QCOMPARE(session.result()->reference, session.reference());
        session.undoStack().undo();
        QCOMPARE(session.reference()->data.find(theta3)->values[1], 1.0);
        session.undoStack().redo();
        session.readAsPrinted();
        QCOMPARE(session.reference(), printed);
        session.undoStack().undo();
        QCOMPARE(session.reference()->conventions.size(), std::size_t(2));

        const auto before = session.reference(); // the assembly is one of the model, not of the data
        session.apply({Convention::Kind::Branch, {}, 1.0});
        QCOMPARE(session.parameters().branch, Branch::Crossed);
        QCOMPARE(session.reference(), before);
    }

    void everyEditIsUndoneAndRedone()
    {
        Session session;
        const auto reference = std::make_shared<Reference>();
        session.setParameter(Parameter::B, 70.0);
        session.setSampling({0.0, 1.0, 100});
        useNewton(session);
        session.setReference(reference);
        session.pinMotion();
        const QStringList names{"change of b", "change of the time range", "change of the method", "opening of ",
                                "pinning of the motion"};
        QCOMPARE(session.undoStack().count(), names.size());
        QSignalSpy parameters(&session, &Session::parametersChanged);
        QSignalSpy settings(&session, &Session::settingsChanged);
        QSignalSpy results(&session, &Session::resultChanged);
        for (qsizetype i = names.size() - 1; i >= 0; --i) {
            QCOMPARE(session.undoStack().undoText(), names[i]);
            session.undoStack().undo();
        }
        QCOMPARE(results.count(), names.size());
        QCOMPARE(parameters.count(), 1);
        QCOMPARE(settings.count(), 2);
        QVERIFY(!session.reference() && session.pinned().empty() && !session.result()->reference);
        QCOMPARE(session.result()->solver.method, Method::ClosedForm);
        QCOMPARE(session.result()->trajectory.time.size(), std::size_t(201));
        QCOMPARE(session.result()->mechanism.b(), 65.0);
        session.undoStack().setIndex(static_cast<int>(names.size()));
        QCOMPARE(session.parameters().b, 70.0);
        QCOMPARE(session.sampling().steps, 100);
        QCOMPARE(session.solver().method, Method::Newton);
        QCOMPARE(session.reference(), reference);
        QCOMPARE(session.pinned().size(), std::size_t(1));
    }

    void motionsArePinnedAndRemoved()
    {
        Session session;
        QSignalSpy problems(&session, &Session::problemFound);
        session.pinMotion();
        session.pinMotion(); // is already pinned
        QCOMPARE(problems.count(), 1);
        session.setParameter(Parameter::B, 80.0);
        const std::shared_ptr<const Result> result = session.result();
        QVERIFY(result->pinned == session.pinned() && !result->reference && result->isCompared());
        const Motion now = ClosedForm(Mechanism(session.parameters())).motionAt(0.0);
        const Motion pinned = ClosedForm(Mechanism(Parameters())).motionAt(0.0);
        QVERIFY(result->difference->channels[1].maxAbs >= now.R4x - pinned.R4x);
        session.setReference(std::make_shared<Reference>()); // is compared instead
        QVERIFY(session.result()->reference && !session.result()->difference);
        session.setReference(nullptr);

        session.pinMotion();
        QCOMPARE(session.result()->difference->channels[1].maxAbs, 0.0); // from the one pinned last
        for (const double b : {81.0, 82.0, 83.0}) {
            session.setParameter(Parameter::B, b);
            session.pinMotion();
        }
        QCOMPARE(session.pinned().size(), kMaxPinned);
        QCOMPARE(problems.count(), 2);
        session.unpinMotions();
        QVERIFY(session.pinned().empty() && !session.result()->isCompared());
        QCOMPARE(session.undoStack().undoText(), QStringLiteral("removal of the pinned motions"));
        session.undoStack().undo();
        QCOMPARE(session.pinned().size(), kMaxPinned);
    }

    void oneDragIsOneStep()
    {
        Session session;
        const auto dragTo = [&session](std::initializer_list<double> couplers) {
            session.beginDrag();
            for (const double b : couplers) {
                session.setParameter(Parameter::B, b);
                letTimePass(session); // held still for long
            }
            session.endDrag();
        };
        dragTo({66.0, 67.0, 68.0});
        dragTo({69.0, 70.0}); // pressed again
        QCOMPARE(session.undoStack().count(), 2);
        session.undoStack().undo();
        QCOMPARE(session.parameters().b, 68.0);
        session.undoStack().undo();
        QCOMPARE(session.parameters().b, 65.0);
        dragTo({70.0, 65.0}); // there and back
        QVERIFY(!session.undoStack().canUndo());
        session.beginDrag(); // of a design, which changes one length or several
        session.setParameter(Parameter::A, 21.0);
        session.setParameters(withCoupler(66.0));
        session.endDrag();
        QCOMPARE(session.undoStack().count(), 1);
    }

    void aKeyHeldDownIsOneStepAndAnotherParameterIsAnother()
    {
        Session session;
        for (const double b : {66.0, 67.0, 68.0}) {
            session.setParameter(Parameter::B, b);
        }
        session.setParameter(Parameter::A, 21.0);
        QCOMPARE(session.undoStack().count(), 2);
        QCOMPARE(session.undoStack().undoText(), QStringLiteral("change of a"));
        letTimePass(session); // pressed again later
        session.setParameter(Parameter::A, 22.0);
        QCOMPARE(session.undoStack().count(), 3);
        Parameters parameters = session.parameters();
        for (const double b : {70.0, 71.0}) { // a and b together
            parameters.a = 0.4 * b;
            parameters.b = b;
            session.setParameters(parameters);
        }
        QCOMPARE(session.undoStack().count(), 4);
        parameters.b = 72.0;
        parameters.c = 20.0;
        session.setParameters(parameters); // has the same name, but changes others
        QCOMPARE(session.undoStack().count(), 5);
    }
};

const Suite suite("tst_session", runWithEventLoop<TestSession>);
#include "tst_session.moc"
