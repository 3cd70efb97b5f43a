// SPDX-License-Identifier: GPL-3.0-or-later

// The reference file of a session: reading, time range, identification and conventions.

#include "tests/support/files.h"
#include "tests/support/initial_mechanism.h"
#include "tests/support/suite.h"
#include "tests/support/waiting.h"
#include "ui/document/session.h"
#include "ui/document/whole_file.h"

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <initializer_list>

#ifdef Q_OS_UNIX
#include <sys/stat.h>
#endif

using namespace slidercrank;

namespace tst_session_reference
{

/// Returns an angle-indexed table of the initial mechanism. Its angles are counted from the crank angle `origin` (°).
QByteArray angleTable(int origin)
{
    QByteArray table = "CAD,theta3,R4_x\n";
    for (int angle = 0; angle <= 360; angle += 15) {
        const double theta2 = (angle + origin) / kDegreesPerRadian;
        const double theta3 = std::asin((25.0 - 20.0 * std::sin(theta2)) / 65.0);
        table += QByteArray::number(angle) + ',' + QByteArray::number(theta3 * kDegreesPerRadian, 'f', 6) + ',' +
                 QByteArray::number(20.0 * std::cos(theta2) + 65.0 * std::cos(theta3), 'f', 6) + '\n';
    }
    return table;
}

struct Positions {
    double theta3 = 0.0; ///< degrees
    double slider = 0.0; ///< mm
};

/// Returns the positions of the initial mechanism with b = 60 mm at a crank angle (rad).
Positions positionsAt(double theta2)
{
    const double theta3 = std::asin((25.0 - 20.0 * std::sin(theta2)) / 60.0);
    return {theta3 * kDegreesPerRadian, 20.0 * std::cos(theta2) + 60.0 * std::cos(theta3)};
}

/// Returns a row of a table, with six decimals.
QByteArray tableRow(std::initializer_list<double> values)
{
    QByteArrayList cells;
    for (const double value : values) {
        cells += QByteArray::number(value, 'f', 6);
    }
    return cells.join(',') + '\n';
}

bool allAgree(const std::vector<ChannelComparison> &comparison)
{
    return !comparison.empty() && std::ranges::all_of(comparison, [](const ChannelComparison &channel) {
        return channel.verdict == Verdict::Agrees;
    });
}

const QByteArray kSmallFile = "time,R4_x\n0,85\n0.5,45\n";

class TestSessionReference : public QObject
{
    Q_OBJECT

private slots:
    /// A former defect: the tab Reference showed ":/data/inventor_sample.csv".
    void theSampleHasTheNameOfItsFile()
    {
        QCOMPARE(displayName(QString(":/data/inventor_sample.csv")), QString("inventor_sample.csv"));
        QCOMPARE(displayName(QString("/data/inventor_sample.csv")), QString("/data/inventor_sample.csv"));
    }

    void aFileOutsideTheTimeRangeReplacesIt()
    {
        const QTemporaryDir folder;
        const QString path = writeFile(folder, "x.csv", "time,R4_x\n0.5,80\n4,70\n8,60\n10.5,75\n");
        for (const Sampling &before : {Sampling{0.0, 1.0, 500}, Sampling{-1.0, 20.0, 500}}) {
            const bool isInside = before.duration > 10.0;
            const Sampling after = isInside ? before : Sampling{0.5, 10.0, 500};
            Session session;
            session.setSampling(before);
            session.loadReference(path);
            AWAIT(session.reference());
            QCOMPARE(session.sampling(), after);
            QCOMPARE(session.time(), isInside ? 0.0 : 0.5);
            session.undoStack().undo();
            QVERIFY(!session.reference());
            QCOMPARE(session.sampling(), before);
        }
        Session session; // a scene keeps its own time range
        Choices saved;
        saved.sampling = {0.0, 2.0, 40};
        session.open(saved, 1.0, ReferenceSource{{path}, {}, {}});
        AWAIT(session.reference());
        QCOMPARE(session.sampling(), saved.sampling);
    }

    void readsAFileInTheBackgroundAndCompares()
    {
        const QTemporaryDir folder;
        const QString path = writeFile(folder, "año 1 Δ.csv", kSmallFile);
        Session session;
        QSignalSpy loaded(&session, &Session::referenceLoaded);
        QSignalSpy results(&session, &Session::resultChanged);
        session.loadReference(path);
        QCOMPARE(results.count(), 0);
        QVERIFY(loaded.wait(kPatience));
        AWAIT_COMPARE(results.count(), 1);
        QCOMPARE(session.reference()->name, "año 1 Δ.csv");
        QCOMPARE(session.result()->comparison.size(), std::size_t(1));
        const double exact = 20.0 + std::sqrt(65.0 * 65.0 - 25.0 * 25.0); // 80 mm at t = 0
        QVERIFY(std::abs(*session.result()->comparison[0].largestError - (85.0 - exact)) < 1e-9);

        // Opening a file does not modify the scene, and undoing that does not either.
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

    void theTimesOfAnAngleIndexedTableFollowTheSpeed()
    {
        const QTemporaryDir folder;
        Session session;
        QSignalSpy problems(&session, &Session::problemFound);
        session.loadReference(writeFile(folder, "x.csv", angleTable(0)));
        AWAIT(session.reference() && session.identification());
        const auto chosen = session.reference();
        const auto lastTime = [&session] { return session.result()->reference->data.time.back(); };
        QVERIFY(allAgree(session.result()->comparison));
        QCOMPARE(lastTime(), 1.0);

        // With a different speed, the time stamps and the time range change, and the file still agrees.
        Parameters parameters;
        parameters.omega2 = -4.0;
        parameters.theta20 = 0.5;
        session.setParameters(parameters);
        QVERIFY(allAgree(session.result()->comparison));
        QVERIFY(std::abs(lastTime() - (0.0 - 0.5) / -4.0) < 1e-12); // the crank turns the other way, so 0° is last
        QVERIFY(std::abs(session.sampling().start - (2.0 * std::numbers::pi - 0.5) / -4.0) < 1e-12);
        QVERIFY(std::abs(session.sampling().duration - 2.0 * std::numbers::pi / 4.0) < 1e-12);
        QCOMPARE(session.reference(), chosen);
        AWAIT(session.identification() && session.identification()->parameters == parameters);
        QVERIFY(!session.identification()->found.identifiable[indexOf(Parameter::Omega2)]);
        session.undoStack().undo();
        QCOMPARE(lastTime(), 1.0);
        QCOMPARE(session.sampling(), Sampling());
        session.setSampling({0.0, 2.0, 100}); // a time range that the user chose stays
        session.setParameters(parameters);
        QCOMPARE(session.sampling(), (Sampling{0.0, 2.0, 100}));

        parameters.omega2 = 0.0; // a crank at rest does not reach those angles
        session.setParameters(parameters);
        QCOMPARE(problems.count(), 1);
        QVERIFY(problems[0][0].toString().contains("choose a different ω₂"));
        QCOMPARE(session.parameters().omega2, -4.0);
        session.setReference(nullptr);
        session.setParameters(parameters);
        QCOMPARE(session.parameters(), parameters);
        QSignalSpy refused(&session, &Session::referenceRefused);
        session.loadReference(chosen->source.paths);
        AWAIT(refused.count() == 1);
        QVERIFY(!session.reference());
    }

    void findsTheOriginOfTheAnglesOfATable()
    {
        const QTemporaryDir folder;
        Session session;
        session.loadReference(writeFile(folder, "x.csv", angleTable(30)));
        AWAIT(session.reference() && session.identification());
        QVERIFY(!allAgree(session.result()->comparison));
        const std::vector<ConventionFinding> findings = session.identification()->found.conventions;
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
        session.loadReference(writeFile(folder, "x.csv", kSmallFile));
        AWAIT(session.reference());
        const auto before = session.reference();
        QStringList paths{folder.filePath("missing.csv")};
        for (const QByteArray &bytes :
             {QByteArray(), QByteArray("time,banana\n0,1\n"), QByteArray("\x7f\0\1\2\xff", 5)}) {
            paths += writeFile(folder, QStringLiteral("bad%1.csv").arg(paths.size()), bytes);
        }
#ifdef Q_OS_UNIX
        paths += folder.filePath("pipe.csv"); // is not opened, because that would wait for a writer
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

    void reportsTheProgressOfReading()
    {
        QByteArray bytes = "time,theta3,R4_x\n";
        for (int row = 0; row < 1'000'000; ++row) {
            bytes += QByteArray::number(row) + ",20,75\n";
        }
        const QTemporaryDir folder;
        Session session;
        QSignalSpy progress(&session, &Session::progressed);
        session.loadReference(writeFile(folder, "x.csv", bytes));
        AWAIT(session.reference());
        QVERIFY(progress.count() > 1);
        for (qsizetype i = 0; i < progress.size(); ++i) {
            const double done = progress[i][0].toDouble();
            QVERIFY(done >= (i == 0 ? 0.0 : progress[i - 1][0].toDouble()) && done <= 1.0);
        }
    }

    void aCancelledIdentificationIsNotPublished()
    {
        Session session;
        QSignalSpy busy(&session, &Session::busyChanged);
        session.setReference(std::get<std::shared_ptr<const Reference>>(readReference({{kSample}, {}, {}})));
        letTimePass(session);
        QCOMPARE(busy.count(), 1);
        session.cancel();
        QVERIFY(session.identification() && session.identification()->found.stopped);
        finishBackgroundTasks();
        letTimePass(session);
        QCOMPARE(busy.count(), 2);
        QVERIFY(session.identification()->found.stopped);
        session.setParameter(Parameter::B, 64.0);
        AWAIT_COMPARE(session.identification()->found.outcome, Identification::Outcome::Identified);

        // An identification is not published after its file was closed.
        session.setParameter(Parameter::B, 70.0);
        letTimePass(session);
        session.setReference(nullptr);
        finishBackgroundTasks();
        letTimePass(session);
        QVERIFY(!session.identification());
        session.useFoundMechanism();
        QCOMPARE(session.parameters().b, 70.0);
    }

    void usesTheMechanismFoundInTheFile()
    {
        Session session; // Table 1: b = 65 mm
        QSignalSpy identifications(&session, &Session::identificationChanged);
        session.loadReference(kSample);
        AWAIT_COMPARE(identifications.count(), 1);
        const ReferenceIdentification &identification = *session.identification();
        QCOMPARE(identification.reference, session.reference());
        QCOMPARE(identification.found.outcome, Identification::Outcome::Identified);
        QVERIFY(identification.found.change);
        QCOMPARE(identification.found.change->parameter, Parameter::B);
        QVERIFY(std::abs(identification.found.change->value - 60.0) < 1e-4);

        session.useFoundMechanism();
        QCOMPARE(session.parameters(), withCoupler(60.0)); // nominal values, not 60.0000003
        QCOMPARE(session.undoStack().undoText(), "use of the file's mechanism");
        QCOMPARE(session.result()->comparison.size(), std::size_t(6));
        QVERIFY(allAgree(session.result()->comparison));
        AWAIT(session.identification()->parameters == session.parameters());
        QVERIFY(!session.identification()->found.change && session.identification()->found.conventions.empty());
    }

    void readsTheFileAsTheMechanismFoundInItRequires()
    {
        const QTemporaryDir folder;
        QByteArray bytes = "time,theta3,R4_x\n"; // theta3 in radians
        for (int row = 0; row <= 100; ++row) {
            const double angle = row / 100.0 * 2.0 * std::numbers::pi;
            const auto [theta3, slider] = positionsAt(angle);
            bytes += tableRow({row / 100.0, theta3 / kDegreesPerRadian, slider});
        }
        Session session;
        session.loadReference(writeFile(folder, "x.csv", bytes));
        AWAIT(session.reference() && session.identification());
        const auto printed = session.reference();
        session.useFoundMechanism();
        QCOMPARE(session.parameters(), withCoupler(60.0));
        QCOMPARE(session.reference()->source.conventions.size(), std::size_t(1));
        QVERIFY(allAgree(session.result()->comparison));
        session.undoStack().undo(); // in one step
        QCOMPARE(session.reference(), printed);
        QCOMPARE(session.parameters(), Parameters());
    }

    void showsAChangingSpeedByItsMeanOverTheCrankAngle()
    {
        const QTemporaryDir folder;
        QByteArray bytes = "time,theta2,R4_x\n"; // from rest with 10 rad/s²
        for (int row = 0; row <= 150; ++row) {
            const double time = row / 100.0;
            const double angle = 0.5 * 10.0 * time * time;
            bytes += tableRow({time, angle * kDegreesPerRadian, positionsAt(angle).slider});
        }
        Session session;
        QSignalSpy confirmed(&session, &Session::confirmed);
        session.loadReference(writeFile(folder, "x.csv", bytes));
        AWAIT(session.reference() && session.identification());
        QVERIFY(session.identification()->found.drive);
        session.useFoundMechanism();
        AWAIT_COMPARE(confirmed.count(), 1);
        QVERIFY2(confirmed[0][0].toString().contains("mean speed, 7.5 rad/s"), qPrintable(confirmed[0][0].toString()));
        QVERIFY(session.reference()->data.crank);
        QCOMPARE(session.parameters().b, 60.0);
        QVERIFY(std::abs(session.parameters().omega2 - 7.5) < 0.01);
        QVERIFY(allAgree(session.result()->comparison));
    }

    void identifiesAgainWhenTheParametersAreUnchanged()
    {
        Session session;
        session.loadReference(kSample);
        AWAIT(session.identification());
        const auto first = session.identification();
        QSignalSpy identifications(&session, &Session::identificationChanged);
        const auto timers = session.findChildren<QTimer *>();
        for (int i = 1; i <= 5; ++i) {
            for (QTimer *timer : timers) {
                timer->setInterval(kPatience);
            }
            session.setParameters(withCoupler(65.0 + i));
            for (const QTimer *timer : timers) {
                QVERIFY(timer->isActive() && timer->interval() < kPatience); // each edit restarts the timer
            }
        }
        QCOMPARE(identifications.count(), 0);
        QCOMPARE(session.identification(), first);
        AWAIT_COMPARE(identifications.count(), 1);
        QCOMPARE(session.identification()->parameters.b, 70.0);
        QCOMPARE(session.identification()->found.parameters, first->found.parameters);
    }

    void appliesAndRemovesConventions()
    {
        const Channel theta3{Theta3, Order::Position};
        auto printed = std::make_shared<Reference>();
        printed->data.time = {0.0, 0.5};
        printed->data.series = {{theta3, {0.25, 0.5}, {}}};
        Session session;
        session.setReference(printed);
        for (const double value : {1.0, 2.0}) {
            session.apply({Convention::Kind::AngleUnit, {theta3}, 2.0});
            QCOMPARE(session.reference()->data.find(theta3)->values[1], value);
        }
        const auto twice = session.reference();
        QCOMPARE(twice->source.conventions.size(), std::size_t(2));
        QCOMPARE(session.result()->reference, twice);
        session.readAsPrinted();
        QCOMPARE(session.reference(), printed);
        session.undoStack().undo();
        QCOMPARE(session.reference(), twice);
        session.apply({Convention::Kind::OtherAssembly, {}, 1.0}); // belongs to the model, not to the data
        QCOMPARE(session.parameters().branch, Branch::Crossed);
        QCOMPARE(session.reference(), twice);
    }
};

const Suite<TestSessionReference> suite("tst_session_reference");

} // namespace tst_session_reference

#include "tst_session_reference.moc"
