// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/session.h"

#include "core/closed_form/closed_form.h"

#include "tests/support/waiting.h"

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QThreadPool>

#include <algorithm>
#include <limits>

#ifdef Q_OS_UNIX
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#endif

using namespace slidercrank;

namespace
{

QString writeFile(const QTemporaryDir &folder, const QString &name, const QByteArray &bytes)
{
    const QString path = folder.filePath(name);
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size()) {
        qFatal("cannot write %s", qPrintable(path));
    }
    return path;
}

const QString kSample = QStringLiteral(SLIDERCRANK_SOURCE_DIR "/data/inventor_sample.csv"); // b = 60 mm
const QString kAuthorsFile = QStringLiteral(SLIDERCRANK_SOURCE_DIR "/../shared/reference/InventorData.csv");

bool allAgree(const std::vector<ChannelComparison> &comparison)
{
    return !comparison.empty() && std::ranges::all_of(comparison, [](const ChannelComparison &channel) {
        return channel.verdict == Verdict::Agrees;
    });
}

const QByteArray kSmallFile = "time,R4_x\n0,85\n0.5,45\n";

} // namespace

class TestSession : public QObject
{
    Q_OBJECT

private slots:
    void startsWithTable1Computed()
    {
        Session session;
        QCOMPARE(session.parameters(), Parameters());
        QCOMPARE(session.result()->trajectory.time.size(), std::size_t(201));
        QCOMPARE(session.result()->trajectory.summary.count(Status::Solved), std::size_t(201));
        QVERIFY(!session.result()->reference);
    }

    void publishesOneResultForOneEdit()
    {
        Session session;
        QSignalSpy results(&session, &Session::resultChanged);
        Parameters parameters;
        parameters.b = 70.0;
        session.setParameters(parameters);
        QCOMPARE(results.count(), 1);
        QCOMPARE(session.result()->mechanism.b(), 70.0);
        session.setParameters(parameters);
        QCOMPARE(results.count(), 1); // the same: nothing to do
    }

    void refusesWhatIsNoMechanism_data()
    {
        QTest::addColumn<double>("b");
        QTest::addColumn<QString>("hint");
        QTest::newRow("zero") << 0.0 << QStringLiteral("greater than 0");
        QTest::newRow("negative") << -1.0 << QStringLiteral("greater than 0");
        QTest::newRow("too short") << 1e-10 << QStringLiteral("at least");
        QTest::newRow("not a number") << std::numeric_limits<double>::quiet_NaN() << QStringLiteral("a number");
        QTest::newRow("too large") << 2e12 << QStringLiteral("exceed");
    }

    void refusesWhatIsNoMechanism()
    {
        QFETCH(const double, b);
        QFETCH(const QString, hint);
        Session session;
        const auto before = session.result();
        QSignalSpy problems(&session, &Session::problemFound);
        QSignalSpy returned(&session, &Session::parametersChanged);
        Parameters parameters;
        parameters.b = b;
        session.setParameters(parameters);
        QCOMPARE(problems.count(), 1);
        QVERIFY2(problems.first().first().toString().contains(hint), qPrintable(problems.first().first().toString()));
        QCOMPARE(returned.count(), 1); // the panel learns that its number did not hold
        QCOMPARE(session.parameters(), Parameters());
        QCOMPARE(session.result(), before);
    }

    void publishesTheImpossible()
    {
        Session session;
        Parameters parameters;
        parameters.b = 4.0;
        session.setParameters(parameters);
        QCOMPARE(session.result()->limits.mobility, Mobility::Impossible);
        QVERIFY(!session.pose().exists());
        session.setParameters(Parameters());
        QVERIFY(session.pose().exists());
    }

    void poseAgreesWithTheTextbook()
    {
        Session session;
        QSignalSpy times(&session, &Session::timeChanged);
        session.setTime(0.25); // crank straight up: h = 25 - 20
        QCOMPARE(times.count(), 1);
        const Pose pose = session.pose();
        QVERIFY(std::abs(pose.pinX) < 1e-12);
        QVERIFY(std::abs(pose.pinY - 20.0) < 1e-12);
        QVERIFY(std::abs(pose.theta3 - std::asin(5.0 / 65.0)) < 1e-14);
        QVERIFY(std::abs(pose.sliderX - std::sqrt(65.0 * 65.0 - 25.0)) < 1e-12);
    }

    void keepsTheTimeWithinTheRun()
    {
        Session session;
        session.setTime(7.0);
        QCOMPARE(session.time(), 1.0);
        session.setTime(-1.0);
        QCOMPARE(session.time(), 0.0);
        session.setTime(0.75);
        Sampling sampling;
        sampling.duration = 0.5;
        session.setSampling(sampling);
        QCOMPARE(session.time(), 0.5);
    }

    void movingTheTimeComputesNothing()
    {
        Session session;
        QSignalSpy results(&session, &Session::resultChanged);
        session.setTime(0.3);
        QCOMPARE(results.count(), 0);
    }

    /// What lies outside the run would not be shown, and could not be gone to.
    void theRunBecomesThatOfAFileThatLiesOutsideOfIt()
    {
        QTemporaryDir folder;
        const QString path = writeFile(folder, QStringLiteral("ten.csv"), "time,R4_x\n0.5,80\n4,70\n8,60\n10.5,75\n");
        Session session;
        session.setSampling({0.0, 1.0, 500});
        QSignalSpy loaded(&session, &Session::referenceLoaded);
        QSignalSpy follows(&session, &Session::runFollows);
        session.loadReference(path);
        QVERIFY(loaded.wait(kPatience));
        QCOMPARE(session.sampling(), (Sampling{0.5, 10.0, 500}));
        QCOMPARE(follows.count(), 1);
        QCOMPARE(session.time(), 0.5);
        session.setTime(8.0);
        QCOMPARE(session.time(), 8.0);
        session.undoStack().undo();
        QVERIFY(!session.reference());
        QCOMPARE(session.sampling(), (Sampling{0.0, 1.0, 500}));
        session.undoStack().redo();
        QVERIFY(session.reference());
        QCOMPARE(session.sampling(), (Sampling{0.5, 10.0, 500}));
    }

    void theRunStaysWhereItHoldsTheFile()
    {
        QTemporaryDir folder;
        Session session;
        session.setSampling({-1.0, 20.0, 500});
        QSignalSpy loaded(&session, &Session::referenceLoaded);
        QSignalSpy follows(&session, &Session::runFollows);
        session.loadReference(writeFile(folder, QStringLiteral("short.csv"), kSmallFile));
        QVERIFY(loaded.wait(kPatience));
        QCOMPARE(session.sampling(), (Sampling{-1.0, 20.0, 500}));
        QCOMPARE(follows.count(), 0);
    }

    void aSceneWithARunAndAFileStaysAsSaved()
    {
        QTemporaryDir folder;
        const QString path = writeFile(folder, QStringLiteral("ten.csv"), "time,R4_x\n0,80\n5,70\n10,75\n");
        Session session;
        Choices saved;
        saved.sampling = {0.0, 2.0, 40};
        QSignalSpy opened(&session, &Session::opened);
        session.open(saved, 1.0, ReferenceSource{{path}, {}, {}});
        QVERIFY(opened.wait(kPatience));
        QVERIFY(session.reference());
        QCOMPARE(session.sampling(), saved.sampling);
    }

    void readsAFileAsideAndCompares()
    {
        QTemporaryDir folder;
        const QString path = writeFile(folder, QStringLiteral("año 1 Δ.csv"), kSmallFile);
        Session session;
        QSignalSpy loaded(&session, &Session::referenceLoaded);
        QSignalSpy results(&session, &Session::resultChanged);
        session.loadReference(path);
        QVERIFY(loaded.wait(kPatience));
        AWAIT_COMPARE(results.count(), 1);
        QCOMPARE(session.reference()->name, QStringLiteral("año 1 Δ.csv"));
        QCOMPARE(session.result()->comparison.size(), std::size_t(1));
        const double exact = 20.0 + std::sqrt(65.0 * 65.0 - 25.0 * 25.0); // 80 mm at t = 0, 40 mm half a turn on
        QVERIFY(std::abs(*session.result()->comparison[0].maxAbs - (85.0 - exact)) < 1e-9);
        session.setReference(nullptr);
        QVERIFY(session.result()->comparison.empty());
    }

    void timesATableByTheCranksAngleAnew()
    {
        const QTemporaryDir folder;
        QByteArray table = "Crank angle (deg),R4_x\n"; // b = 65
        for (int angle = 0; angle <= 360; angle += 15) {
            const double theta2 = angle / kDegreesPerRadian;
            const double theta3 = std::asin((25.0 - 20.0 * std::sin(theta2)) / 65.0);
            table += QByteArray::number(angle) + ',' +
                     QByteArray::number(20.0 * std::cos(theta2) + 65.0 * std::cos(theta3), 'f', 6) + '\n';
        }
        Session session;
        QSignalSpy loaded(&session, &Session::referenceLoaded);
        QSignalSpy problems(&session, &Session::problemFound);
        QSignalSpy diagnosed(&session, &Session::diagnosisChanged);
        session.loadReference(writeFile(folder, QStringLiteral("table.csv"), table));
        AWAIT(session.reference() && session.diagnosis());
        const auto chosen = session.reference();
        const auto lastInstant = [&session] { return session.result()->reference->data.time.back(); };
        QVERIFY(allAgree(session.result()->comparison));
        QCOMPARE(lastInstant(), 1.0);

        // A slider is moved: the file stays, its instants do not, and it agrees as before.
        Parameters parameters;
        parameters.omega2 = -4.0;
        parameters.theta20 = 0.5;
        session.setParameters(parameters);
        QVERIFY(allAgree(session.result()->comparison));
        QVERIFY(std::abs(lastInstant() - (0.0 - 0.5) / -4.0) < 1e-12); // the other way: 0° comes last
        QVERIFY(std::abs(session.sampling().start - (2.0 * std::numbers::pi - 0.5) / -4.0) < 1e-12); // as the run did
        QVERIFY(std::abs(session.sampling().duration - 2.0 * std::numbers::pi / 4.0) < 1e-12);
        QCOMPARE(session.undoStack().undoText(), QStringLiteral("change of the mechanism"));
        QCOMPARE(session.reference(), chosen);
        QCOMPARE(loaded.count(), 1);
        QCOMPARE(session.result()->chosenReference(), chosen);
        AWAIT(session.diagnosis() && session.diagnosis()->parameters == parameters);
        QCOMPARE(session.diagnosis()->reference, chosen);
        QVERIFY(!session.diagnosis()->found.identification.identifiable[indexOf(Parameter::Omega2)]);
        session.undoStack().undo();
        QCOMPARE(lastInstant(), 1.0);
        QCOMPARE(session.sampling(), Sampling());
        session.setSampling({0.0, 2.0, 100}); // a person's own run stays
        session.setParameters(parameters);
        QCOMPARE(session.sampling(), (Sampling{0.0, 2.0, 100}));
        session.undoStack().undo();

        // A standing crank never comes there.
        parameters.omega2 = 0.0;
        session.setParameters(parameters);
        QCOMPARE(problems.count(), 1);
        QVERIFY2(problems.first().first().toString().contains(QStringLiteral("choose another ω₂")),
                 qPrintable(problems.first().first().toString()));
        QCOMPARE(session.parameters(), Parameters());

        session.setReference(nullptr);
        session.setParameters(parameters);
        QCOMPARE(session.parameters(), parameters);
        QSignalSpy refused(&session, &Session::referenceRefused);
        session.loadReference(chosen->paths);
        AWAIT(refused.count() == 1);
        QVERIFY(!session.reference());
    }

    void countsTheAnglesFromWhereTheyAreCounted()
    {
        const QTemporaryDir folder;
        QByteArray table = "CAD,theta3,R4_x\n"; // b = 65, counted from 30° on
        for (int angle = 0; angle <= 360; angle += 15) {
            const double theta2 = (angle + 30) / kDegreesPerRadian;
            const double theta3 = std::asin((25.0 - 20.0 * std::sin(theta2)) / 65.0);
            table += QByteArray::number(angle) + ',' + QByteArray::number(theta3 * kDegreesPerRadian, 'f', 6) + ',' +
                     QByteArray::number(20.0 * std::cos(theta2) + 65.0 * std::cos(theta3), 'f', 6) + '\n';
        }
        Session session;
        session.loadReference(writeFile(folder, QStringLiteral("engine.csv"), table));
        AWAIT(session.reference() && session.diagnosis());
        QVERIFY(!allAgree(session.result()->comparison));
        const std::vector<ConventionFinding> findings = session.diagnosis()->found.conventions;
        QCOMPARE(findings.size(), std::size_t(1));
        QCOMPARE(findings.front().convention.amount, 30.0);
        session.apply(findings.front().convention);
        QVERIFY(allAgree(session.result()->comparison));
        session.setParameter(Parameter::Omega2, 100.0); // and stays so, whatever the drive
        QVERIFY(allAgree(session.result()->comparison));
        session.readAsPrinted();
        QVERIFY(!allAgree(session.result()->comparison));
    }

    void keepsWhatIsThereWhenAFileIsBad_data()
    {
        QTest::addColumn<QByteArray>("bytes");
        QTest::newRow("empty") << QByteArray();
        QTest::newRow("no known column") << QByteArray("time,banana\n0,1\n");
        QTest::newRow("binary") << QByteArray("\x7f\0\1\2\xff", 5);
    }

    void keepsWhatIsThereWhenAFileIsBad()
    {
        QFETCH(const QByteArray, bytes);
        QTemporaryDir folder;
        Session session;
        QSignalSpy loaded(&session, &Session::referenceLoaded);
        session.loadReference(writeFile(folder, QStringLiteral("good.csv"), kSmallFile));
        QVERIFY(loaded.wait(kPatience));
        const auto before = session.reference();
        QSignalSpy problems(&session, &Session::referenceRefused);
        session.loadReference(writeFile(folder, QStringLiteral("bad.csv"), bytes));
        QVERIFY(problems.wait(kPatience));
        QVERIFY(problems.first()[1].toString().contains(QStringLiteral("bad.csv")));
        QCOMPARE(session.reference(), before);
    }

    void tellsHowFarALargeFileIsRead()
    {
        QByteArray bytes = "time,theta3,R4_x\n";
        for (int row = 0; row < 1'000'000; ++row) {
            bytes += QByteArray::number(row) + ",20,75\n";
        }
        QTemporaryDir folder;
        Session session;
        QSignalSpy loaded(&session, &Session::referenceLoaded);
        QSignalSpy parts(&session, &Session::readingProgressed);
        session.loadReference(writeFile(folder, QStringLiteral("large.csv"), bytes));
        QVERIFY(loaded.wait(kPatience));
        QVERIFY(parts.count() > 5);
        double before = 0.0;
        for (const QList<QVariant> &told : parts) {
            const double part = told.first().toDouble();
            QVERIFY(part > before && part <= 1.0);
            before = part;
        }
        QVERIFY(before > 0.8);
    }

    void doesNotWaitForAPipeOnceItIsCancelled()
    {
#ifdef Q_OS_UNIX
        QTemporaryDir folder;
        const QByteArray pipe = QFile::encodeName(folder.filePath(QStringLiteral("pipe")));
        QCOMPARE(mkfifo(pipe.constData(), 0600), 0);
        Session session;
        session.loadReference(QFile::decodeName(pipe));
        int writer = -1; // who writes nothing
        AWAIT((writer = ::open(pipe.constData(), O_WRONLY | O_NONBLOCK)) >= 0);
        session.cancel();
        QVERIFY(QThreadPool::globalInstance()->waitForDone(kPatience));
        ::close(writer);
#endif
    }

    void saysThatAFileIsMissing()
    {
        Session session;
        QSignalSpy problems(&session, &Session::referenceRefused);
        session.loadReference(QStringLiteral("no/such/file.csv"));
        QVERIFY(problems.wait(kPatience));
        QVERIFY(problems.first()[1].toString().contains(QStringLiteral("file.csv")));
    }

    void computesLongRunsAsideAndTheLastEditWins()
    {
        Session session;
        QSignalSpy results(&session, &Session::resultChanged);
        QSignalSpy busy(&session, &Session::busyChanged);
        Sampling sampling;
        sampling.steps = 400000;
        SolverSettings solver = session.solver();
        solver.method = Method::Newton;
        session.setSolver(solver);
        results.clear();
        session.setSampling(sampling);
        QCOMPARE(results.count(), 0); // not yet: the window stays alive
        QCOMPARE(busy.count(), 1);
        Parameters parameters;
        for (const double b : {66.0, 67.0, 68.0}) {
            parameters.b = b;
            session.setParameters(parameters);
        }
        AWAIT_COMPARE(busy.count(), 2);
        QCOMPARE(session.result()->mechanism.b(), 68.0);
        QCOMPARE(session.result()->trajectory.time.size(), std::size_t(400001));
        for (int i = 0; i < results.count(); ++i) {
            QVERIFY(results.at(i).first().value<std::shared_ptr<const Result>>());
        }
    }

    void cancelKeepsWhatIsOnShow()
    {
        Session session;
        SolverSettings solver;
        solver.method = Method::Newton;
        session.setSolver(solver);
        const auto before = session.result();
        QSignalSpy busy(&session, &Session::busyChanged);
        Sampling sampling;
        sampling.steps = 1000000;
        session.setSampling(sampling);
        session.cancel();
        AWAIT_COMPARE(busy.count(), 2);
        QCOMPARE(session.result(), before);
    }

    void cancelWhileComparingTakesTheFileBack()
    {
        Session session;
        session.setReference(std::make_shared<Reference>());
        SolverSettings solver;
        solver.method = Method::Newton;
        session.setSolver(solver);
        const auto before = session.result();
        auto large = std::make_shared<Reference>();
        for (int i = 0; i < 1000000; ++i) {
            large->data.time.push_back(i * 1e-6);
        }
        large->data.series = {{{R4x, Order::Position}, std::vector<double>(large->data.time.size(), 80.0), {}}};
        QSignalSpy busy(&session, &Session::busyChanged);
        QSignalSpy references(&session, &Session::referenceLoaded);
        session.setReference(large);
        QCOMPARE(session.result(), before); // still being compared
        session.cancel();
        QCOMPARE(session.result(), before);
        QCOMPARE(session.reference(), before->reference);
        QCOMPARE(references.count(), 2); // there and back
        QCOMPARE(session.undoStack().undoText(), QStringLiteral("change of the method"));
        AWAIT_COMPARE(busy.count(), 2);
        QCOMPARE(session.result(), before);
    }

    void cancelTakesBackOnlyWhatIsNotOnShowYet()
    {
        Session session;
        SolverSettings solver;
        solver.method = Method::Newton;
        session.setSolver(solver);
        Parameters parameters;
        session.beginDrag();
        parameters.b = 66.0;
        session.setParameters(parameters);
        session.endDrag();
        Sampling sampling;
        sampling.steps = 1000000;
        session.setSampling(sampling);
        parameters.b = 67.0;
        session.setParameters(parameters);
        session.cancel();
        QCOMPARE(session.parameters().b, 66.0);
        QCOMPARE(session.sampling(), Sampling());
        QCOMPARE(session.result()->mechanism.b(), 66.0);
    }

    /// The panels had the million steps, the plots the other run.
    void cancelAfterAnUndoGoesBackToWhatIsOnShow()
    {
        Session session;
        Choices opened{session.parameters(), session.sampling(), session.solver(), nullptr};
        opened.solver.method = Method::Newton;
        opened.sampling.steps = 1000000;
        session.open(opened, 0.0, std::nullopt); // from a scene
        session.setSampling(Sampling());
        const auto before = session.result();
        QCOMPARE(before->sampling, Sampling());
        session.undoStack().undo();
        QCOMPARE(session.sampling(), opened.sampling);
        session.cancel();
        QCOMPARE(session.result(), before);
        QCOMPARE(session.sampling(), Sampling());
        QCOMPARE(session.undoStack().undoText(), QStringLiteral("change of the time range"));

        session.undoStack().undo(); // the same over two steps, then forward again
        session.cancel();
        session.setParameter(Parameter::B, 66.0);
        session.undoStack().setIndex(0);
        session.cancel();
        QCOMPARE(session.sampling(), session.result()->sampling);
        QCOMPARE(session.parameters(), session.result()->mechanism.parameters());
        QCOMPARE(session.parameters().b, 65.0);
        QCOMPARE(session.undoStack().redoText(), QStringLiteral("change of b"));
    }

    /// The panels had the scene's million steps, the plots what was there before it.
    void cancelOfWhatASceneAsksForShowsItInLess()
    {
        Session session;
        Choices opened{session.parameters(), session.sampling(), session.solver(), nullptr};
        opened.parameters.b = 80.0;
        opened.solver.method = Method::Newton;
        opened.sampling.steps = 1000000;
        session.open(opened, 0.0, std::nullopt);
        QSignalSpy problems(&session, &Session::problemFound);
        session.cancel();
        QCOMPARE(problems.count(), 1);
        QCOMPARE(session.parameters(), opened.parameters);
        QCOMPARE(session.result()->mechanism.parameters(), opened.parameters);
        QCOMPARE(session.result()->solver, session.solver());
        QCOMPARE(session.result()->sampling, session.sampling());
        QVERIFY(!session.undoStack().isClean());
        session.undoStack().undo();
        QCOMPARE(session.solver(), opened.solver);
        AWAIT_COMPARE(session.result()->solver, opened.solver);
        QCOMPARE(session.result()->sampling, opened.sampling);
    }

    void cancelOfAScenesLargeFileLeavesTheFileOut()
    {
        Session session;
        auto large = std::make_shared<Reference>();
        for (int i = 0; i < 1000000; ++i) {
            large->data.time.push_back(i * 1e-6);
        }
        large->data.series = {{{R4x, Order::Position}, std::vector<double>(large->data.time.size(), 80.0), {}}};
        session.undoStack().clear();
        session.setReference(large);
        session.undoStack().clear(); // as if it had come with a scene
        session.cancel();
        QCOMPARE(session.reference(), nullptr);
        QCOMPARE(session.result()->reference, nullptr);
        session.undoStack().undo();
        QCOMPARE(session.reference(), large);
        session.cancel();
        QCOMPARE(session.reference(), session.result()->reference);
    }

    void aStepKeepsItsNameInAnotherLanguage()
    {
        Session session;
        session.setReference(std::get<std::shared_ptr<const Reference>>(readReference({{kSample}, {}, {}})));
        AWAIT(session.diagnosis());
        session.takeOver();
        const QString name = session.undoStack().undoText();
        QVERIFY(name.startsWith(QLatin1String("use of")));
        session.retranslateEdits();
        QCOMPARE(session.undoStack().undoText(), name);
    }

    void aSearchThatWasCancelledIsOver()
    {
        Session session;
        QSignalSpy busy(&session, &Session::busyChanged);
        session.setReference(std::get<std::shared_ptr<const Reference>>(readReference({{kSample}, {}, {}})));
        letTimePass(session);
        QCOMPARE(busy.count(), 1); // it is being searched
        session.cancel();
        QVERIFY(session.diagnosis());
        QVERIFY(session.diagnosis()->found.identification.stopped);
        finishAside(); // what was under way does not come back
        letTimePass(session);
        QCOMPARE(busy.count(), 2);
        QVERIFY(session.diagnosis()->found.identification.stopped);
        session.setParameter(Parameter::B, 64.0);
        AWAIT_COMPARE(session.diagnosis()->found.identification.outcome, Identification::Outcome::Identified);
    }

    void oneClickTakesTheFoundMechanismOver_data()
    {
        QTest::addColumn<QString>("path");
        QTest::newRow("the sample") << kSample;
        QTest::newRow("the author's file") << kAuthorsFile;
    }

    void oneClickTakesTheFoundMechanismOver()
    {
        QFETCH(const QString, path);
        if (!QFile::exists(path)) {
            QSKIP("the author's InventorData.csv is not at hand");
        }
        Session session; // Table 1: b = 65 mm
        QSignalSpy diagnoses(&session, &Session::diagnosisChanged);
        session.loadReference(path);
        AWAIT_COMPARE(diagnoses.count(), 1);
        const ReferenceDiagnosis &diagnosis = *session.diagnosis();
        QCOMPARE(diagnosis.reference, session.reference());
        QCOMPARE(diagnosis.found.identification.outcome, Identification::Outcome::Identified);
        QVERIFY(diagnosis.found.change);
        QCOMPARE(diagnosis.found.change->parameter, Parameter::B);
        QVERIFY(std::abs(diagnosis.found.change->value - 60.0) < 1e-4);
        QVERIFY(diagnosis.found.change->explained > 0.999999);
        QVERIFY(allAgree(diagnosis.found.identified));

        session.takeOver();
        Parameters inRoundNumbers; // not 19.9999997 and 60.0000003
        inRoundNumbers.b = 60.0;
        QCOMPARE(session.parameters(), inRoundNumbers);
        QCOMPARE(session.result()->comparison.size(), std::size_t(6));
        QVERIFY(allAgree(session.result()->comparison));
        session.undoStack().undo();
        QCOMPARE(session.parameters(), Parameters());
        QVERIFY(!allAgree(session.result()->comparison));
        session.undoStack().redo();
        QVERIFY(allAgree(session.result()->comparison));
    }

    void diagnosesAnewWhenTheParametersRest()
    {
        Session session;
        session.loadReference(kSample);
        AWAIT(session.diagnosis());
        const auto first = session.diagnosis();
        QSignalSpy diagnoses(&session, &Session::diagnosisChanged);
        QSignalSpy busy(&session, &Session::busyChanged);
        const auto timers = session.findChildren<QTimer *>();
        Parameters parameters;
        for (int i = 1; i <= 20; ++i) {
            for (QTimer *timer : timers) {
                timer->setInterval(kPatience);
            }
            parameters.b = 65.0 + i;
            session.setParameters(parameters);
            for (const QTimer *timer : timers) {
                QVERIFY(timer->isActive() && timer->interval() < kPatience); // each edit begins the rest anew
            }
            if (i == 10) { // a rest after all, but a short one
                letTimePass(session);
                QCOMPARE(busy.count(), 1);
            }
        }
        QCOMPARE(diagnoses.count(), 0);
        QCOMPARE(session.diagnosis(), first); // what was found of the file stands
        AWAIT_COMPARE(diagnoses.count(), 1);
        QCOMPARE(session.diagnosis()->parameters.b, 85.0);
        QCOMPARE(session.diagnosis()->found.change->parameter, Parameter::B);
        QCOMPARE(session.diagnosis()->found.identification.parameters, first->found.identification.parameters);
    }

    void thereIsNothingToExplainWhereEverythingAgrees()
    {
        Session session;
        Parameters parameters;
        parameters.b = 60.0;
        session.setParameters(parameters);
        session.loadReference(kSample);
        AWAIT(session.diagnosis());
        QVERIFY(allAgree(session.result()->comparison));
        QVERIFY(!session.diagnosis()->found.change);
        QVERIFY(session.diagnosis()->found.conventions.empty());
    }

    void withoutAReferenceThereIsNoDiagnosis()
    {
        Session session;
        session.takeOver();
        QCOMPARE(session.parameters(), Parameters());
        session.loadReference(kSample);
        AWAIT(session.diagnosis());
        QSignalSpy busy(&session, &Session::busyChanged);
        session.setParameter(Parameter::B, 70.0);
        letTimePass(session);
        QCOMPARE(busy.count(), 1); // it is being searched again
        session.setReference(nullptr);
        QVERIFY(!session.diagnosis());
        finishAside(); // what was under way does not come back
        letTimePass(session);
        QCOMPARE(busy.count(), 2);
        QVERIFY(!session.diagnosis());
        session.setParameter(Parameter::B, 65.0);
        session.takeOver();
        QCOMPARE(session.parameters(), Parameters());
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
    }

    void anOriginIsMovedAndMovedBack()
    {
        const Channel slider{R4x, Order::Position};
        auto printed = std::make_shared<Reference>();
        printed->data.time = {0.0, 0.5};
        printed->data.series = {{slider, {0.0, kNone}, {Rounding::Rule::SignificantDigits, 6}}};
        Session session;
        session.setReference(printed);
        session.apply({Convention::Kind::ZeroPoint, {slider}, 74.5});
        const ReferenceSeries &moved = *session.reference()->data.find(slider);
        QCOMPARE(moved.values[0], 74.5);
        QVERIFY(std::isnan(moved.values[1]));
        QCOMPARE(moved.rounding.rule, Rounding::Rule::Decimals); // six digits of the distance are not six of the place
        session.undoStack().undo();
        QCOMPARE(session.reference(), printed);
        session.undoStack().redo();
        QCOMPARE(session.reference()->data.find(slider)->values[0], 74.5);
        session.readAsPrinted();
        QCOMPARE(session.reference(), printed);
    }

    void theOtherAssemblyIsTheModelsNotTheFiles()
    {
        Session session;
        session.setReference(std::make_shared<Reference>());
        const auto before = session.reference();
        session.apply({Convention::Kind::Branch, {}, 1.0});
        QCOMPARE(session.parameters().branch, Branch::Crossed);
        QCOMPARE(session.reference(), before);
        session.undoStack().undo();
        QCOMPARE(session.parameters().branch, Branch::Open);
    }

    void everyEditIsUndoneAndRedone()
    {
        QTemporaryDir folder;
        Session session;
        Parameters parameters;
        parameters.b = 70.0;
        session.setParameters(parameters);
        Sampling sampling;
        sampling.steps = 100;
        session.setSampling(sampling);
        SolverSettings solver = session.solver();
        solver.method = Method::Newton;
        session.setSolver(solver);
        const auto reference = std::make_shared<Reference>();
        session.setReference(reference);

        QStringList names;
        for (int i = 0; i < session.undoStack().count(); ++i) {
            names << session.undoStack().text(i);
        }
        QCOMPARE(names.size(), 4);
        QCOMPARE(names.first(), QStringLiteral("change of b"));

        session.undoStack().undo();
        QVERIFY(!session.reference() && !session.result()->reference);
        session.undoStack().undo();
        QCOMPARE(session.result()->solver.method, Method::ClosedForm);
        session.undoStack().undo();
        QCOMPARE(session.result()->trajectory.time.size(), std::size_t(201));
        session.undoStack().undo();
        QCOMPARE(session.result()->mechanism.b(), 65.0);
        QVERIFY(!session.undoStack().canUndo());
        session.undoStack().setIndex(4);
        QCOMPARE(session.parameters(), parameters);
        QCOMPARE(session.sampling(), sampling);
        QCOMPARE(session.solver(), solver);
        QCOMPARE(session.reference(), reference);
    }

    void aMotionIsKeptAndForgottenAStepEach()
    {
        Session session;
        QSignalSpy problems(&session, &Session::problemFound);
        session.keep();
        session.keep(); // once is enough
        QCOMPARE(problems.count(), 1);
        QVERIFY(session.kept() == std::vector<Parameters>{Parameters()});
        session.setParameter(Parameter::B, 80.0);
        const std::shared_ptr<const Result> result = session.result();
        QVERIFY(result->kept == session.kept() && !result->reference && result->isCompared());
        const Motion now = ClosedForm(Mechanism(session.parameters())).motionAt(0.0);
        const Motion kept = ClosedForm(Mechanism(Parameters())).motionAt(0.0);
        QVERIFY(result->difference->channels[1].maxAbs >= now.R4x - kept.R4x);

        session.keep();
        QCOMPARE(session.kept().size(), std::size_t(2));
        QCOMPARE(session.result()->difference->channels[1].maxAbs, 0.0); // from the last
        session.undoStack().undo();
        QCOMPARE(session.kept().size(), std::size_t(1));
        for (const double b : {81.0, 82.0, 83.0, 84.0}) {
            session.setParameter(Parameter::B, b);
            session.keep();
        }
        QCOMPARE(session.kept().size(), std::size_t(4)); // the last found no room
        QCOMPARE(problems.count(), 2);
        QVERIFY(problems.last().first().toString().contains(QStringLiteral("remove them")));
        session.forgetKept();
        QVERIFY(session.kept().empty() && !session.result()->isCompared());
        QCOMPARE(session.undoStack().undoText(), QStringLiteral("removal of the pinned motions"));
        session.undoStack().undo();
        QCOMPARE(session.kept().size(), std::size_t(4));
    }

    void aFileIsComparedBeforeWhatIsKept()
    {
        Session session;
        session.keep();
        session.setParameter(Parameter::B, 80.0);
        session.setReference(std::make_shared<Reference>());
        QVERIFY(session.result()->kept.size() == 1 && session.result()->reference && !session.result()->difference);
        session.setReference(nullptr);
        QVERIFY(session.result()->difference);
    }

    void anUndoTellsThePanels()
    {
        Session session;
        Parameters parameters;
        parameters.c = -3.0;
        session.setParameters(parameters);
        QSignalSpy parametersBack(&session, &Session::parametersChanged);
        QSignalSpy settingsBack(&session, &Session::settingsChanged);
        QSignalSpy results(&session, &Session::resultChanged);
        session.undoStack().undo();
        QCOMPARE(parametersBack.count(), 1);
        QCOMPARE(parametersBack.first().first().value<Parameters>(), Parameters());
        QCOMPARE(settingsBack.count(), 0);
        QCOMPARE(results.count(), 1);
    }

    void oneDragIsOneStep()
    {
        Session session;
        Parameters parameters;
        const auto dragTo = [&](std::initializer_list<double> couplers) {
            session.beginDrag();
            for (const double b : couplers) {
                parameters.b = b;
                session.setParameters(parameters);
            }
            session.endDrag();
        };
        dragTo({66.0, 67.0, 68.0});
        dragTo({69.0, 70.0}); // pressed anew
        QCOMPARE(session.undoStack().count(), 2);
        session.beginDrag();
        for (const double b : {71.0, 72.0}) {
            parameters.b = b;
            session.setParameters(parameters);
            letTimePass(session); // held still for long, but not let go
        }
        session.endDrag();
        QCOMPARE(session.undoStack().count(), 3);
        session.undoStack().undo();
        session.undoStack().undo();
        QCOMPARE(session.parameters().b, 68.0);
        session.undoStack().undo();
        QCOMPARE(session.parameters().b, 65.0);

        parameters.b = 65.0;
        dragTo({70.0, 65.0}); // there and back: nothing was done
        QVERIFY(!session.undoStack().canUndo());
    }

    void aKeyHeldDownIsOneStepAndAnotherParameterIsAnother()
    {
        Session session;
        Parameters parameters;
        for (const double b : {66.0, 67.0, 68.0}) {
            parameters.b = b;
            session.setParameters(parameters);
        }
        parameters.a = 21.0;
        session.setParameters(parameters);
        QCOMPARE(session.undoStack().count(), 2);
        QCOMPARE(session.undoStack().undoText(), QStringLiteral("change of a"));
        letTimePass(session); // pressed again later
        parameters.a = 22.0;
        session.setParameters(parameters);
        QCOMPARE(session.undoStack().count(), 3);
        session.undoStack().undo();
        session.undoStack().undo();
        session.undoStack().undo();
        QCOMPARE(session.parameters(), Parameters());
    }

    void whatIsNoMechanismIsNoStep()
    {
        Session session;
        Parameters parameters;
        parameters.a = -1.0;
        session.setParameters(parameters);
        QCOMPARE(session.undoStack().count(), 0);
    }
};

QTEST_GUILESS_MAIN(TestSession)
#include "tst_session.moc"
