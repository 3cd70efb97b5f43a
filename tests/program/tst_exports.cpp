// SPDX-License-Identifier: GPL-3.0-or-later

// Files and pictures that the window and the command line export. Programs that do not use Qt read them.

#include "tests/program/picture_fault.h"
#include "tests/program/run_program.h"
#include "tests/support/initial_mechanism.h"
#include "tests/support/pixels.h"
#include "tests/support/printed_picture.h"
#include "tests/support/study_of_a_turn.h"
#include "tests/support/suite.h"
#include "tests/support/waiting.h"
#include "tests/support/widget_parts.h"
#include "ui/export/animation_export.h"
#include "ui/mechanism/mechanism_view.h"
#include "ui/panels/study_panel.h"
#include "ui/panels/table_panel.h"
#include "ui/plots/plot_grid.h"
#include "ui/text/language.h"
#include "ui/text/theme.h"
#include "ui/widgets/message_bar.h"
#include "ui/window/exports.h"
#include "ui/window/main_window.h"
#include "ui/window/scene_file.h"

#include <QAbstractButton>
#include <QApplication>
#include <QClipboard>
#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QLineEdit>
#include <QMenuBar>
#include <QProcess>
#include <QProgressBar>
#include <QRegularExpression>
#include <QSettings>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

using namespace slidercrank;

namespace tst_exports
{

/// Whether both numbers have the same bits or are NaN. The sign of a zero may differ, because it is not written.
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
        m_messages = m_window->findChild<MessageBar *>();
    }

    void cleanup() { m_window.reset(); }

    void exportedDataAreReadBackExactly()
    {
        struct Row {
            double b;
            Method method;
            ChannelSet channels;
        };
        for (const Row &row :
             {Row{60.0, Method::ClosedForm, plottedChannels()}, Row{65.0, Method::Newton, allChannels()},
              Row{40.0, Method::ClosedForm, plottedChannels()}, Row{40.0, Method::Newton, allChannels()}}) {
            init(); // opens another window
            checkReadBack(row.b, row.method, row.channels);
        }
    }

    void theUserChoosesTheColumns()
    {
        for (const auto &[choice, columns] : {std::pair(0, 8), std::pair(1, 37)}) { // the plotted columns, or all
            actionNamed(*m_window, QStringLiteral("Data…"))->trigger();
            auto *dialog = m_window->findChild<QFileDialog *>();
            QVERIFY(dialog);
            dialog->setDirectory(m_folder->path());
            dialog->selectNameFilter(dialog->nameFilters().at(choice));
            auto *name = dialog->findChild<QLineEdit *>();
            const QString chosen =
                m_folder->filePath(QStringLiteral("chosen%1").arg(choice)); // the dialog adds the suffix
            name->setText(chosen);
            QTest::keyClick(name, Qt::Key_Return);
            AWAIT(QFile::exists(chosen + QStringLiteral(".csv")));
            const QByteArray header = contentOf(chosen + QStringLiteral(".csv")).split('\n').first();
            QCOMPARE(header.split(',').size(), columns);
            settle();
            delete m_window->findChild<QFileDialog *>();
        }
    }

    void aLongMotionIsWrittenInTheBackground()
    {
        Sampling sampling;
        sampling.steps = 200000;
        QSignalSpy computed(&m_window->session(), &Session::resultChanged);
        m_window->session().setSampling(sampling);
        QVERIFY(!computed.isEmpty() || computed.wait(kPatience));
        const QString path = m_folder->filePath(QStringLiteral("long.csv"));
        QSignalSpy steps(m_window->findChild<QProgressBar *>(), &QProgressBar::valueChanged);
        m_window->exports().writeData(path, plottedChannels());
        QVERIFY(!QFile::exists(path)); // the call returns before the file is written
        AWAIT(messageText(*m_messages).startsWith(QStringLiteral("Exported to ")));
        QVERIFY2(steps.count() >= 3, qPrintable(QString::number(steps.count())));
        QCOMPARE(contentOf(path).count('\n'), qsizetype(200002));
    }

    void aCancelledExportLeavesTheOlderFile()
    {
        const QString path = m_folder->filePath(QStringLiteral("long.csv"));
        QFile older(path);
        QVERIFY(older.open(QIODevice::WriteOnly) && older.write("older") == 5);
        older.close();
        Sampling sampling;
        sampling.steps = 1000000;
        QSignalSpy computed(&m_window->session(), &Session::resultChanged);
        m_window->session().setSampling(sampling);
        QVERIFY(!computed.isEmpty() || computed.wait(kPatience));
        auto *cancel = m_window->findChild<QAbstractButton *>(QStringLiteral("cancelButton"));
        QVERIFY(!cancel->isVisible());
        m_window->exports().writeData(path, allChannels());
        letTimePassIn(*m_window);
        QVERIFY(cancel->isVisible());
        m_window->exports().writeData(m_folder->filePath(QStringLiteral("other.csv")), plottedChannels());
        QVERIFY2(messageText(*m_messages).contains(QStringLiteral("still being written")),
                 qPrintable(messageText(*m_messages)));
        QTest::mouseClick(cancel, Qt::LeftButton);
        AWAIT(!cancel->isVisible());
        QVERIFY2(messageText(*m_messages).contains(QStringLiteral("Cancelled")), qPrintable(messageText(*m_messages)));
        QCOMPARE(contentOf(path), QByteArray("older"));
        QCOMPARE(QDir(m_folder->path()).entryList(QDir::Files), QStringList(QStringLiteral("long.csv")));
    }

    void reportsFilesThatCannotBeWritten()
    {
        const QString nowhere = m_folder->filePath(QStringLiteral("missing/file"));
        m_window->exports().writeData(nowhere + QStringLiteral(".csv"), plottedChannels());
        AWAIT2(messageText(*m_messages).contains(QStringLiteral("file.csv cannot be written")),
               qPrintable(messageText(*m_messages)));
        m_window->exports().writeReport(nowhere + QStringLiteral(".pdf"));
        AWAIT2(messageText(*m_messages).contains(QStringLiteral("file.pdf cannot be written")),
               qPrintable(messageText(*m_messages)));
    }

    void theReportShowsTheCurrentState_data()
    {
        QTest::addColumn<bool>("hasReference");
        QTest::addColumn<bool>("isIdentified");
        QTest::newRow("no reference") << false << false;
        QTest::newRow("the reference is identified") << true << true;
        QTest::newRow("a parameter has just changed") << true << false;
    }

    void theReportShowsTheCurrentState()
    {
        QFETCH(const bool, hasReference);
        QFETCH(const bool, isIdentified);
        Session &session = m_window->session();
        if (hasReference) {
            QSignalSpy identified(&session, &Session::identificationChanged);
            m_window->openReference(kSample);
            AWAIT(session.identification());
        }
        if (!isIdentified) {
            session.setParameters(withCoupler(64.0));
        }
        const QString path = m_folder->filePath(QStringLiteral("report.pdf"));
        m_window->exports().writeReport(path);
        if (hasReference && !isIdentified) {
            QVERIFY(messageText(*m_messages).contains(QStringLiteral("Export it again")));
            AWAIT(session.identification()->parameters.b == 64.0);
            m_window->exports().writeReport(path);
        }
        session.setParameters(withCoupler(50.0)); // does not change a report that is being written
        AWAIT(!m_window->exports().isWriting());
        QVERIFY(contentOf(path).startsWith("%PDF"));
        if (!missingProgram({"pdftotext"}).isEmpty()) {
            QSKIP("pdftotext (poppler-utils) is missing: tests/run installs it.");
        }
        const QString text =
            QString::fromUtf8(outputOf(QStringLiteral("pdftotext"), {"-layout", path, "-"})).replace(QChar::Nbsp, u' ');
        QCOMPARE(text.contains(QStringLiteral("inventor_sample.csv")), hasReference);
        const QString explanation = QStringLiteral("b = 60 mm instead of %1 mm").arg(isIdentified ? 65 : 64);
        QVERIFY2(text.contains(explanation) == hasReference, qPrintable(text));
    }

    /// Checks the pictures of the window and those of the command `render`.
    void picturesShowTheirSubject()
    {
        if (const QString missing = missingProgram({"pdftoppm", "pdftotext", "rsvg-convert", "pngtopnm"});
            !missing.isEmpty()) {
            QSKIP(qPrintable(QStringLiteral("%1 is missing: tests/run installs it.").arg(missing)));
        }
        auto *plots = m_window->findChild<PlotGrid *>();
        m_window->openReference(kSample);
        AWAIT(m_window->session().identification());
        m_window->resize(1800, 1000); // wide enough for the explanations in the titles
        settle(*m_window);
        plots->setZoom(zoomInsideCurves());
        const QString scene = m_folder->filePath(QStringLiteral("scene.json"));
        QVERIFY(m_window->scene().saveTo(scene));
        QCoreApplication::processEvents();

        StudyPanel panel(&m_window->session());
        panel.setResult(studyOfATurn());
        Exports &exports = m_window->exports();
        FigureOptions wide; // wide enough for the explanations in the titles
        wide.width = 1800.0;
        wide.unit = FigureOptions::Unit::Pixel;
        const auto writeTo = [&](const QString &path, const FigureSubject &figure) {
            exports.write(figure, wide, path);
            finishBackgroundTasks();
            return figureSize(wide, figure.height(wide));
        };
        const auto exportTo = [&](const QString &path, PictureSubject subject) {
            switch (subject) {
            case PictureSubject::Figure: return writeTo(path, exports.plot());
            case PictureSubject::Plot:
            case PictureSubject::Errors: return writeTo(path, exports.plot("plot_" + describe(subject).renderName));
            case PictureSubject::Mechanism: return writeTo(path, exports.mechanism());
            case PictureSubject::Study: panel.exportTo(path); return FigureSize{QSize(900, 600), 2.0};
            }
            return FigureSize();
        };
        for (const auto subject : {PictureSubject::Figure, PictureSubject::Plot, PictureSubject::Errors,
                                   PictureSubject::Mechanism, PictureSubject::Study}) {
            const QString name = describe(subject).renderName;
            for (const char *suffix : {"png", "svg", "pdf"}) {
                const QString path = m_folder->filePath(QStringLiteral("%1.%2").arg(describe(subject).name, suffix));
                const FigureSize size = exportTo(path, subject);
                QString fault = pictureFault(path, subject, size.size, size.scale);
                QVERIFY2(fault.isEmpty(), qPrintable(path + u' ' + fault));
                if (name.isEmpty()) {
                    continue;
                }
                QVERIFY(QFile::remove(path));
                run({"render", "--scene", scene, "--what", name, "--size", "1000x1100", "--scale", "1.5", "-o", path});
                fault = pictureFault(path, subject, QSize(1000, 1100), 1.5);
                QVERIFY2(fault.isEmpty(), qPrintable(path + u' ' + fault));
            }
        }
    }

    void framesShowTheMotion()
    {
        if (!missingProgram({"pngtopnm"}).isEmpty()) {
            QSKIP("pngtopnm is missing: tests/run installs it.");
        }
        Sampling sampling;
        sampling.duration = 0.1;
        m_window->session().setSampling(sampling);
        const QString folder = m_folder->filePath(QStringLiteral("motion"));
        m_window->exports().writeAnimation(folder, m_window->exports().animationShown());
        run({"render", "--what", "frames", "--duration", "0.1", "--size", "400x300", "-o",
             m_folder->filePath(QStringLiteral("rendered"))});
        QImage before;
        for (int frame = 1; frame <= 3; ++frame) {
            const QString name = QStringLiteral("/frame_000%1.png").arg(frame);
            const QImage rendered = printedPicture(m_folder->filePath(QStringLiteral("rendered")) + name);
            QCOMPARE(rendered.size(), QSize(400, 300));
            const QImage picture = printedPicture(folder + name);
            QVERIFY(!picture.isNull() && !isBlank(picture) && !isBlank(rendered));
            QVERIFY(picture != before);
            before = picture;
        }
        QVERIFY(!QFile::exists(folder + QStringLiteral("/frame_0004.png")));
    }

    void theReportIsAPrintablePdf()
    {
        if (const QString missing = missingProgram({"pdfinfo", "pdftoppm", "pdftotext"}); !missing.isEmpty()) {
            QSKIP(qPrintable(QStringLiteral("%1 is missing: tests/run installs it.").arg(missing)));
        }
        m_window->openReference(kSample);
        AWAIT(m_window->session().identification());
        const QString path = m_folder->filePath(QStringLiteral("report.pdf"));
        m_window->exports().writeReport(path);
        AWAIT2(messageText(*m_messages).startsWith(QStringLiteral("Exported to ")),
               qPrintable(messageText(*m_messages)));
        const QString rendered = m_folder->filePath(QStringLiteral("rendered.pdf"));
        run({"render", "--what", "report", "--reference", kSample, "-o", rendered});
        for (const QString &report : {path, rendered}) {
            const QByteArray facts = outputOf(QStringLiteral("pdfinfo"), {report});
            QVERIFY2(facts.contains("(A4)") && facts.contains("Pages:           2"), facts.constData());
            for (const char *page : {"1", "2"}) {
                const QImage picture = imageIn(
                    outputOf(QStringLiteral("pdftoppm"), {"-r", "48", "-f", page, "-l", page, "-singlefile", report}));
                QVERIFY(!picture.isNull() && !isBlank(picture));
            }
            const QString text = QString::fromUtf8(outputOf(QStringLiteral("pdftotext"), {report, "-"}));
            for (const char *word : {"inventor_sample.csv", "coupler angle θ³", "mm/s²", "Method", "page 2 of 2"}) {
                QVERIFY2(text.contains(QString::fromUtf8(word)), qPrintable(QString::fromUtf8(word) + text));
            }
        }
    }

    void figurePlotAndMechanismAreCopied()
    {
        constexpr int kWidth = 1890; // 160 mm at 300 dots per inch
        for (const char *name : {"Copy figure", "Copy mechanism"}) {
            QAction *action = actionNamed(*m_window, QLatin1String(name));
            QVERIFY2(action, name);
            action->trigger();
            QCOMPARE(QGuiApplication::clipboard()->image().width(), kWidth);
            QVERIFY2(messageText(*m_messages).contains(QStringLiteral("in the clipboard")),
                     qPrintable(messageText(*m_messages)));
        }
        QImage before;
        for (const QString &name : PlotGrid::plotNames()) {
            emit m_window->findChild<PlotGrid *>()->copyPlotRequested(name); // from the plot's menu
            const QImage image = QGuiApplication::clipboard()->image();
            QCOMPARE(image.width(), kWidth);
            QVERIFY(image != before);
            before = image;
        }
    }

private:
    void checkReadBack(double b, Method method, const ChannelSet &channels)
    {
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
        m_window->exports().writeData(path, channels);
        AWAIT2(messageText(*m_messages).startsWith(QStringLiteral("Exported to ")),
               qPrintable(messageText(*m_messages)));
        QVERIFY(!contentOf(path).contains('\r'));

        QSignalSpy loaded(&session, &Session::referenceLoaded);
        m_window->openReference(path);
        QVERIFY(loaded.wait(kPatience));
        const Result &result = *session.result();
        const ReferenceData &read = result.reference->data;
        QCOMPARE(read.time.size(), result.trajectory.time.size());
        ChannelSet exported = channels;
        exported.set(indexOf({Theta2, Order::Position})); // is always exported
        QCOMPARE(read.series.size(), exported.count());
        for (std::size_t i = 0; i < read.time.size(); ++i) {
            QVERIFY(isSame(result.trajectory.time[i], read.time[i]));
        }
        const Trajectory computed = sample(result.mechanism, sampling.timeStamps(), allChannels(), solver);
        for (const ReferenceSeries &series : read.series) {
            for (std::size_t i = 0; i < read.time.size(); ++i) {
                QVERIFY2(isSame(computed[series.channel][i], series.values[i]), nameOf(series.channel).data());
            }
        }
        for (const ChannelComparison &comparison : result.comparison) {
            QCOMPARE(comparison.verdict, Verdict::Agrees);
        }
        QCOMPARE(result.comparison.size(), read.series.size());
    }

    QTemporaryDir m_settings;
    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<MainWindow> m_window;
    MessageBar *m_messages = nullptr;
};

const Suite<TestExports> suite("tst_exports");

} // namespace tst_exports

#include "tst_exports.moc"
