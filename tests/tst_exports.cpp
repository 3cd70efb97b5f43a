// SPDX-License-Identifier: GPL-3.0-or-later

// What leaves the window, as its user takes it: files and clipboard.

#include "ui/language.h"
#include "ui/main_window.h"
#include "ui/mechanism_view.h"
#include "ui/message_bar.h"
#include "ui/plot_grid.h"

#include <QAbstractButton>
#include <QApplication>
#include <QClipboard>
#include <QDir>
#include <QFile>
#include <QMenuBar>
#include <QProcess>
#include <QSettings>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

#include <bit>
#include <cmath>
#include <cstdint>
#include <memory>

using namespace slidercrank;

namespace
{

const QString kSample = QStringLiteral(SLIDERCRANK_SOURCE_DIR "/data/inventor_sample.csv"); // b = 60 mm

Parameters withCoupler(double b)
{
    Parameters parameters;
    parameters.b = b;
    return parameters;
}

QByteArray contentOf(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// The same bits but for the sign of a zero, which is not written; or both nothing.
bool isSame(double written, double read)
{
    return std::bit_cast<std::uint64_t>(written) == std::bit_cast<std::uint64_t>(read) ||
           (written == 0.0 && read == 0.0) || (std::isnan(written) && std::isnan(read));
}

QAction *actionNamed(const QWidget &window, const QString &text)
{
    for (QAction *action : window.findChildren<QAction *>()) {
        if (QString(action->text()).remove(u'&') == text) {
            return action;
        }
    }
    return nullptr;
}

} // namespace

class TestExports : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QStandardPaths::setTestModeEnabled(true);
        QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_settings.path());
        QApplication::setStyle(QStringLiteral("Fusion"));
    }

    void init()
    {
        QSettings().clear();
        m_folder = std::make_unique<QTemporaryDir>();
        m_window = std::make_unique<MainWindow>();
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
        m_said = m_window->findChild<MessageBar *>();
    }

    void cleanup() { m_window.reset(); }

    void theDataAreReadBackToTheLastBit_data()
    {
        QTest::addColumn<double>("b");
        QTest::addColumn<Method>("method");
        QTest::addColumn<bool>("all");
        QTest::newRow("the plotted channels") << 60.0 << Method::ClosedForm << false;
        QTest::newRow("all channels") << 60.0 << Method::ClosedForm << true;
        QTest::newRow("the plotted channels by Newton-Raphson") << 65.0 << Method::Newton << false;
        QTest::newRow("all channels by Newton-Raphson") << 65.0 << Method::Newton << true;
        QTest::newRow("a rocker, with gaps where there is no pose") << 40.0 << Method::ClosedForm << false;
        QTest::newRow("all channels of a rocker") << 40.0 << Method::Newton << true;
    }

    void theDataAreReadBackToTheLastBit()
    {
        QFETCH(const double, b);
        QFETCH(const Method, method);
        QFETCH(const bool, all);
        Session &session = m_window->session();
        session.setParameters(withCoupler(b));
        SolverSettings solver = session.solver();
        solver.method = method;
        session.setSolver(solver);
        Sampling sampling;
        sampling.start = -0.1;
        sampling.duration = 1.7;
        sampling.steps = 321;
        session.setSampling(sampling);

        const QString path = m_folder->filePath(QStringLiteral("motion.csv"));
        m_window->exportDataTo(path, all ? allChannels() : plottedChannels());
        QTRY_VERIFY2(m_said->text().startsWith(QStringLiteral("Written: ")), qPrintable(m_said->text()));
        QVERIFY(!contentOf(path).contains('\r'));

        QSignalSpy loaded(&session, &Session::referenceLoaded);
        m_window->openReference(path);
        QVERIFY(loaded.wait());
        const Result &result = *session.result();
        const ReferenceData &read = result.reference->data;
        QCOMPARE(read.time.size(), result.trajectory.time.size());
        QCOMPARE(read.series.size(), std::size_t(all ? 36 : 6));
        for (std::size_t i = 0; i < read.time.size(); ++i) {
            QVERIFY(isSame(result.trajectory.time[i], read.time[i]));
        }
        const Trajectory whole =
            sample(result.mechanism, sampling.instants(), all ? allChannels() : plottedChannels(), solver);
        for (const ReferenceSeries &series : read.series) {
            for (std::size_t i = 0; i < read.time.size(); ++i) {
                QVERIFY2(isSame(whole[series.channel][i], series.values[i]), nameOf(series.channel).data());
            }
        }
        for (const ChannelComparison &comparison : result.comparison) {
            QCOMPARE(comparison.verdict, Verdict::Agrees);
        }
        QCOMPARE(result.comparison.size(), read.series.size());
    }

    void aLongRunIsWrittenAside()
    {
        Sampling sampling;
        sampling.steps = 200000;
        QSignalSpy computed(&m_window->session(), &Session::resultChanged);
        m_window->session().setSampling(sampling);
        QVERIFY(!computed.isEmpty() || computed.wait());
        const QString path = m_folder->filePath(QStringLiteral("long.csv"));
        int turns = 0; // of the event loop, while it is written
        QTimer clock;
        connect(&clock, &QTimer::timeout, this, [&turns] { ++turns; });
        clock.start(10);
        m_window->exportDataTo(path, plottedChannels());
        QVERIFY(!QFile::exists(path));
        QTRY_VERIFY(m_said->text().startsWith(QStringLiteral("Written: ")));
        QVERIFY2(turns >= 3, qPrintable(QString::number(turns)));
        QCOMPARE(contentOf(path).count('\n'), qsizetype(200002));
    }

    void aCancelledExportLeavesWhatWasThere()
    {
        const QString path = m_folder->filePath(QStringLiteral("long.csv"));
        QFile older(path);
        QVERIFY(older.open(QIODevice::WriteOnly) && older.write("older") == 5);
        older.close();
        Sampling sampling;
        sampling.steps = 1000000;
        QSignalSpy computed(&m_window->session(), &Session::resultChanged);
        m_window->session().setSampling(sampling);
        QVERIFY(!computed.isEmpty() || computed.wait());
        auto *cancel = m_window->findChild<QAbstractButton *>(QStringLiteral("cancelButton"));
        QVERIFY(!cancel->isVisible());
        m_window->exportDataTo(path, allChannels());
        QTRY_VERIFY(cancel->isVisible());
        m_window->exportDataTo(m_folder->filePath(QStringLiteral("other.csv")), plottedChannels());
        QVERIFY2(m_said->text().contains(QStringLiteral("still being written")), qPrintable(m_said->text()));
        QTest::mouseClick(cancel, Qt::LeftButton);
        QTRY_VERIFY(!cancel->isVisible());
        QVERIFY2(m_said->text().contains(QStringLiteral("nothing was written")), qPrintable(m_said->text()));
        QCOMPARE(contentOf(path), QByteArray("older"));
        QCOMPARE(QDir(m_folder->path()).entryList(QDir::Files), QStringList(QStringLiteral("long.csv")));
    }

    void anotherLanguageMeanwhileDoesNoHarm()
    {
        Sampling sampling;
        sampling.steps = 200000;
        QSignalSpy computed(&m_window->session(), &Session::resultChanged);
        m_window->session().setSampling(sampling);
        QVERIFY(!computed.isEmpty() || computed.wait());
        const QString path = m_folder->filePath(QStringLiteral("long.csv"));
        m_window->exportDataTo(path, plottedChannels());
        setLanguage(Language::Spanish);
        QTRY_COMPARE(contentOf(path).count('\n'), qsizetype(200002));
        setLanguage(Language::English);
        const auto *cancel = m_window->findChild<QAbstractButton *>(QStringLiteral("cancelButton"));
        QTRY_VERIFY(!cancel->isVisible());
    }

    void whatCannotBeWrittenIsSaid()
    {
        const QString nowhere = m_folder->filePath(QStringLiteral("missing/file"));
        m_window->exportDataTo(nowhere + QStringLiteral(".csv"), plottedChannels());
        QTRY_VERIFY2(m_said->text().contains(QStringLiteral("file.csv cannot be written")), qPrintable(m_said->text()));
        m_window->exportReportTo(nowhere + QStringLiteral(".pdf"));
        QTRY_VERIFY2(m_said->text().contains(QStringLiteral("file.pdf cannot be written")), qPrintable(m_said->text()));
    }

    void theReportIsOfWhatIsOnShow_data()
    {
        QTest::addColumn<bool>("hasReference");
        QTest::addColumn<bool>("isDiagnosed");
        QTest::newRow("no reference") << false << false;
        QTest::newRow("the reference is understood already") << true << true;
        QTest::newRow("a slider was moved just now") << true << false;
    }

    void theReportIsOfWhatIsOnShow()
    {
        QFETCH(const bool, hasReference);
        QFETCH(const bool, isDiagnosed);
        Session &session = m_window->session();
        if (hasReference) {
            QSignalSpy diagnosed(&session, &Session::diagnosisChanged);
            m_window->openReference(kSample);
            QTRY_VERIFY(session.diagnosis());
        }
        if (!isDiagnosed) {
            session.setParameters(withCoupler(64.0));
        }
        const QString path = m_folder->filePath(QStringLiteral("report.pdf"));
        m_window->exportReportTo(path);
        QTRY_VERIFY2(m_said->text().startsWith(QStringLiteral("Written: ")), qPrintable(m_said->text()));
        QVERIFY(contentOf(path).startsWith("%PDF"));
        const QString reader = QStandardPaths::findExecutable(QStringLiteral("pdftotext"));
        if (reader.isEmpty()) {
            QSKIP("There is no pdftotext (poppler-utils) here to read the report with.");
        }
        QProcess process;
        process.start(reader, {QStringLiteral("-layout"), path, QStringLiteral("-")});
        QVERIFY(process.waitForFinished());
        const QString text = QString::fromUtf8(process.readAllStandardOutput()).replace(QChar::Nbsp, u' ');
        QCOMPARE(text.contains(QStringLiteral("inventor_sample.csv")), hasReference);
        const QString instead = QStringLiteral("b: 60.000 instead of %1 mm").arg(isDiagnosed ? 65 : 64);
        QVERIFY2(text.contains(instead) == hasReference, qPrintable(text));
    }

    void aReportOfWhatWasChangedMeanwhileIsNotWritten()
    {
        Session &session = m_window->session();
        m_window->openReference(kSample);
        QTRY_VERIFY(session.diagnosis());
        session.setParameters(withCoupler(64.0));
        const QString path = m_folder->filePath(QStringLiteral("report.pdf"));
        m_window->exportReportTo(path);
        session.setParameters(withCoupler(63.0));
        QTRY_VERIFY2(m_said->text().contains(QStringLiteral("Export it again")), qPrintable(m_said->text()));
        QVERIFY(!QFile::exists(path));
    }

    void figurePlotAndMechanismAreCopied()
    {
        const std::pair<const char *, const QWidget *> copies[] = {
            {"Copy figure", m_window->findChild<PlotGrid *>()},
            {"Copy mechanism", m_window->findChild<MechanismView *>()}};
        for (const auto &[name, widget] : copies) {
            const QSize size = widget->size(); // before the message takes some of it
            QAction *action = actionNamed(*m_window, QLatin1String(name));
            QVERIFY2(action, name);
            action->trigger();
            QCOMPARE(QGuiApplication::clipboard()->image().size(), size * 2);
            QVERIFY2(m_said->text().contains(QStringLiteral("in the clipboard")), qPrintable(m_said->text()));
        }
        QMenu *plots = actionNamed(*m_window, QStringLiteral("Copy plot"))->menu();
        QCOMPARE(plots->actions().size(), PlotGrid::plotNames().size());
        QImage before;
        for (QAction *action : plots->actions()) {
            action->trigger();
            const QImage image = QGuiApplication::clipboard()->image();
            QCOMPARE(image.size(), QSize(1800, 1200));
            QVERIFY(image != before);
            before = image;
        }
        // From a plot's own menu, too.
        QGuiApplication::clipboard()->clear();
        emit m_window->findChild<PlotGrid *>()->copyPlotRequested(QStringLiteral("plot_error_acceleration"));
        QCOMPARE(QGuiApplication::clipboard()->image(), before);
    }

private:
    QTemporaryDir m_settings;
    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<MainWindow> m_window;
    MessageBar *m_said = nullptr;
};

QTEST_MAIN(TestExports)

#include "tst_exports.moc"
