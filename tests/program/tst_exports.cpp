// SPDX-License-Identifier: GPL-3.0-or-later

// What leaves the program, as its user takes it: files and clipboard. Every file is opened by a program that is none of
// ours and uses no Qt.

#include "tests/support/printed_picture.h"
#include "tests/support/study_of_a_turn.h"
#include "tests/support/suite.h"
#include "tests/support/waiting.h"
#include "ui/export/animation_export.h"
#include "ui/mechanism/mechanism_view.h"
#include "ui/panels/study_panel.h"
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

enum class Subject { Figure, Plot, Errors, Mechanism, Study };

/// What of it has a name on the command line.
QString wordOf(Subject subject)
{
    switch (subject) {
    case Subject::Figure: return QStringLiteral("figure");
    case Subject::Plot: return QStringLiteral("theta3");
    case Subject::Errors: return QStringLiteral("error_velocity");
    case Subject::Mechanism: return QStringLiteral("mechanism");
    case Subject::Study: break;
    }
    return {};
}

/// What can be read in it.
QStringList wordsIn(Subject subject)
{
    switch (subject) {
    case Subject::Figure:
        return {"t [s]",
                "coupler angle θ³ [°]",
                "slider position Rₓ⁴ [mm]",
                "ω³ = dθ³/dt [°/s]",
                "a⁴ = dv⁴/dt [mm/s²]",
                "error [% of peak]",
                "inventor_sample.csv"};
    case Subject::Plot: return {"t [s]", "coupler angle θ³ [°]", "model", "inventor_sample.csv"};
    case Subject::Errors: return {"t [s]", "error [% of peak]", "error of the coupler"};
    case Subject::Mechanism: return {"mm", "-20", "60"};
    case Subject::Study: return {"closed form"};
    }
    return {};
}

int plotsIn(Subject subject)
{
    switch (subject) {
    case Subject::Figure: return 9;
    case Subject::Plot:
    case Subject::Errors: return 1;
    case Subject::Mechanism:
    case Subject::Study: break;
    }
    return 0;
}

/// Zoomed in, so that the curves go on beyond their axes on every side.
PlotZoom closeView()
{
    PlotZoom zoom;
    zoom.time = Interval{0.2, 0.6};
    zoom.values[0] = Interval{10.0, 15.0};  // °
    zoom.values[1] = Interval{60.0, 70.0};  // mm
    zoom.values[3] = Interval{-50.0, 50.0}; // °/s
    zoom.values[5] = Interval{5.0, 100.0};  // %
    return zoom;
}

/// As far as two colours are the same but for the smoothing of edges.
bool isNear(const PrintedPicture::Colour &one, const QColor &other)
{
    constexpr int kFar = 70;
    return std::abs(one.red - other.red()) + std::abs(one.green - other.green()) + std::abs(one.blue - other.blue()) <
           kFar;
}

/// Empty where the curves are there and stay within their axes, else where they do not. `scale`: of its pixels.
QString curvesAstray(const PrintedPicture &picture, Subject subject, double scale)
{
    const int plots = plotsIn(subject);
    const std::vector<QRect> axes = axesIn(picture, plots == 9 ? 3 : 1);
    if (axes.size() != static_cast<std::size_t>(plots)) {
        return QStringLiteral("%1 axes").arg(axes.size());
    }
    const int pen = static_cast<int>(2.0 * scale);    // half a line's width and its smoothing
    const int title = static_cast<int>(15.0 * scale); // its height, above the axes; the legend is above that
    const SeriesColours colours = seriesColours(paletteFor(Theme::Light));
    const std::array<QColor, 4> curves{colours.model, colours.reference, colours.error, colours.errorOther};
    std::vector<int> within(axes.size(), 0);
    const int legend = static_cast<int>(25.0 * scale);
    for (int y = std::max(legend, axes.front().top() - title); y < picture.size.height(); ++y) {
        for (int x = 0; x < picture.size.width(); ++x) {
            const PrintedPicture::Colour colour = picture.at(x, y);
            const auto isDrawn = [&](const QColor &curve) { return isNear(colour, curve); };
            if (colour.isGrey() || std::none_of(curves.begin(), curves.end(), isDrawn)) {
                continue;
            }
            bool hasPlace = false;
            for (std::size_t i = 0; i < axes.size(); ++i) {
                // The title of errors ends with the largest ones in their curves' colours.
                const bool hasColours = subject == Subject::Errors || (subject == Subject::Figure && i % 3 == 2);
                const bool isWithin = axes[i].adjusted(-pen, -pen, pen, pen).contains(x, y);
                const bool isTitle = hasColours && axes[i].adjusted(0, -title, 0, -axes[i].height()).contains(x, y);
                within[i] += isWithin ? 1 : 0;
                hasPlace = hasPlace || isWithin || isTitle;
            }
            if (!hasPlace) {
                return QStringLiteral("a curve at %1, %2").arg(x).arg(y);
            }
        }
    }
    const auto empty = std::find_if(within.begin(), within.end(), [](int pixels) { return pixels < 50; });
    return empty == within.end() ? QString() : QStringLiteral("no curve in plot %1").arg(empty - within.begin());
}

/// Empty where the file is a picture of that size (px at 96 to the inch) as it should be, else what is wrong with it.
QString pictureFault(const QString &path, Subject subject, const QSize &size, double scale)
{
    const QString suffix = QFileInfo(path).suffix();
    const PrintedPicture picture = printedPicture(path);
    const bool isPdf = suffix == QLatin1String("pdf");
    const double pixels = isPdf ? 2.0 : suffix == QLatin1String("png") ? scale : 1.0;
    const QSize difference = picture.size - size * pixels;
    const int rounding = isPdf ? 2 : 0; // to whole points
    if (std::max(std::abs(difference.width()), std::abs(difference.height())) > rounding) {
        return QStringLiteral("%1 x %2 pixels").arg(picture.size.width()).arg(picture.size.height());
    }
    if (picture.isBlank()) {
        return QStringLiteral("blank");
    }
    if (plotsIn(subject) > 0) {
        if (const QString astray = curvesAstray(picture, subject, pixels); !astray.isEmpty()) {
            return astray;
        }
    }
    QString text;
    if (isPdf) {
        text = QString::fromUtf8(outputOf(QStringLiteral("pdftotext"), {"-layout", path, "-"}));
    } else if (suffix == QLatin1String("svg")) {
        static const QRegularExpression kText(QStringLiteral("<text[^>]*>([^<]*)</text>"));
        QRegularExpressionMatchIterator matches = kText.globalMatch(QString::fromUtf8(contentOf(path)));
        while (matches.hasNext()) {
            text += matches.next().captured(1);
        }
    } else {
        return {};
    }
    text.remove(u' '); // a word may be written in pieces, each in its place
    for (const QString &word : wordsIn(subject)) {
        if (!text.contains(QString(word).remove(u' '))) {
            return QStringLiteral("nowhere \"%1\", but %2").arg(word, text);
        }
    }
    return {};
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

    void theDataAreReadBackToTheLastBit()
    {
        struct Row {
            double b;
            Method method;
            bool all;
        };
        for (const Row &row : {Row{60.0, Method::ClosedForm, false}, Row{65.0, Method::Newton, true},
                               Row{40.0, Method::ClosedForm, false}, Row{40.0, Method::Newton, true}}) {
            init(); // another window
            isReadBack(row.b, row.method, row.all);
        }
    }

    void theUserChoosesTheColumns()
    {
        for (const auto &[choice, columns] : {std::pair(0, 8), std::pair(1, 37)}) { // time, θ₂ and those of the plots
            actionNamed(*m_window, QStringLiteral("Data…"))->trigger();
            auto *dialog = m_window->findChild<QFileDialog *>();
            QVERIFY(dialog);
            dialog->setDirectory(m_folder->path());
            dialog->selectNameFilter(dialog->nameFilters().at(choice));
            auto *name = dialog->findChild<QLineEdit *>();
            const QString chosen = m_folder->filePath(QStringLiteral("chosen%1").arg(choice)); // without its ending
            name->setText(chosen);
            QTest::keyClick(name, Qt::Key_Return);
            AWAIT(QFile::exists(chosen + QStringLiteral(".csv")));
            const QByteArray header = contentOf(chosen + QStringLiteral(".csv")).split('\n').first();
            QCOMPARE(header.split(',').size(), columns);
            settle();
            delete m_window->findChild<QFileDialog *>();
        }
    }

    void aLongRunIsWrittenAside()
    {
        Sampling sampling;
        sampling.steps = 200000;
        QSignalSpy computed(&m_window->session(), &Session::resultChanged);
        m_window->session().setSampling(sampling);
        QVERIFY(!computed.isEmpty() || computed.wait(kPatience));
        const QString path = m_folder->filePath(QStringLiteral("long.csv"));
        QSignalSpy steps(m_window->findChild<QProgressBar *>(), &QProgressBar::valueChanged);
        m_window->exports().writeData(path, plottedChannels());
        QCOMPARE(steps.count(), 0); // it came back at once
        AWAIT(m_said->text().startsWith(QStringLiteral("Exported to ")));
        QVERIFY2(steps.count() >= 3, qPrintable(QString::number(steps.count()))); // told while it is written
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
        QVERIFY(!computed.isEmpty() || computed.wait(kPatience));
        auto *cancel = m_window->findChild<QAbstractButton *>(QStringLiteral("cancelButton"));
        QVERIFY(!cancel->isVisible());
        m_window->exports().writeData(path, allChannels());
        letTimePassIn(*m_window);
        QVERIFY(cancel->isVisible());
        m_window->exports().writeData(m_folder->filePath(QStringLiteral("other.csv")), plottedChannels());
        QVERIFY2(m_said->text().contains(QStringLiteral("still being written")), qPrintable(m_said->text()));
        QTest::mouseClick(cancel, Qt::LeftButton);
        AWAIT(!cancel->isVisible());
        QVERIFY2(m_said->text().contains(QStringLiteral("nothing was written")), qPrintable(m_said->text()));
        QCOMPARE(contentOf(path), QByteArray("older"));
        QCOMPARE(QDir(m_folder->path()).entryList(QDir::Files), QStringList(QStringLiteral("long.csv")));
    }

    void whatCannotBeWrittenIsSaid()
    {
        const QString nowhere = m_folder->filePath(QStringLiteral("missing/file"));
        m_window->exports().writeData(nowhere + QStringLiteral(".csv"), plottedChannels());
        AWAIT2(m_said->text().contains(QStringLiteral("file.csv cannot be written")), qPrintable(m_said->text()));
        m_window->exports().writeReport(nowhere + QStringLiteral(".pdf"));
        AWAIT2(m_said->text().contains(QStringLiteral("file.pdf cannot be written")), qPrintable(m_said->text()));
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
            AWAIT(session.diagnosis());
        }
        if (!isDiagnosed) {
            session.setParameters(withCoupler(64.0));
        }
        const QString path = m_folder->filePath(QStringLiteral("report.pdf"));
        m_window->exports().writeReport(path);
        AWAIT2(m_said->text().startsWith(QStringLiteral("Exported to ")), qPrintable(m_said->text()));
        QVERIFY(contentOf(path).startsWith("%PDF"));
        const QString reader = QStandardPaths::findExecutable(QStringLiteral("pdftotext"));
        if (reader.isEmpty()) {
            QSKIP("There is no pdftotext (poppler-utils) here to read the report with.");
        }
        QProcess process;
        process.start(reader, {QStringLiteral("-layout"), path, QStringLiteral("-")});
        QVERIFY(process.waitForFinished(kPatience));
        const QString text = QString::fromUtf8(process.readAllStandardOutput()).replace(QChar::Nbsp, u' ');
        QCOMPARE(text.contains(QStringLiteral("inventor_sample.csv")), hasReference);
        const QString instead = QStringLiteral("b = 60 mm instead of %1 mm").arg(isDiagnosed ? 65 : 64);
        QVERIFY2(text.contains(instead) == hasReference, qPrintable(text));
    }

    void aReportOfWhatWasChangedMeanwhileIsNotWritten()
    {
        Session &session = m_window->session();
        m_window->openReference(kSample);
        AWAIT(session.diagnosis());
        session.setParameters(withCoupler(64.0));
        const QString path = m_folder->filePath(QStringLiteral("report.pdf"));
        m_window->exports().writeReport(path);
        session.setParameters(withCoupler(63.0));
        AWAIT2(m_said->text().contains(QStringLiteral("Export it again")), qPrintable(m_said->text()));
        QVERIFY(!QFile::exists(path));
    }

    void picturesAreWhatTheyShouldBe_data()
    {
        QTest::addColumn<Subject>("subject");
        QTest::addColumn<QString>("suffix");
        const std::pair<const char *, Subject> subjects[] = {{"figure", Subject::Figure},
                                                             {"plot", Subject::Plot},
                                                             {"plot of errors", Subject::Errors},
                                                             {"mechanism", Subject::Mechanism},
                                                             {"study", Subject::Study}};
        for (const auto &[name, subject] : subjects) {
            for (const char *suffix : {"png", "svg", "pdf"}) {
                QTest::addRow("%s as %s", name, suffix) << subject << QString(QLatin1String(suffix));
            }
        }
    }

    /// From the window, and the same from `render`, where there is one.
    void picturesAreWhatTheyShouldBe()
    {
        QFETCH(const Subject, subject);
        QFETCH(const QString, suffix);
        if (const QString missing = missingProgram({"pdftoppm", "pdftotext", "rsvg-convert", "pngtopnm"});
            !missing.isEmpty()) {
            QSKIP(qPrintable(QStringLiteral("There is no %1 here: tests/run installs it.").arg(missing)));
        }
        Session &session = m_window->session();
        auto *plots = m_window->findChild<PlotGrid *>();
        m_window->openReference(kSample);
        AWAIT(session.diagnosis());
        m_window->resize(1800, 1000); // the titles have space for their explanations
        settle(*m_window); // everything has its place
        plots->setZoom(closeView());
        const QString scene = m_folder->filePath(QStringLiteral("scene.json"));
        QVERIFY(m_window->scene().saveTo(scene));
        QCoreApplication::processEvents();

        const QString path = m_folder->filePath(QStringLiteral("window.") + suffix);
        QSize size;
        switch (subject) {
        case Subject::Figure:
            size = plots->size();
            m_window->exports().write(m_window->exports().figure(), path);
            break;
        case Subject::Plot:
        case Subject::Errors:
            size = QSize(900, 600);
            m_window->exports().write(m_window->exports().plot(QStringLiteral("plot_") + wordOf(subject)), path);
            break;
        case Subject::Mechanism:
            size = m_window->findChild<MechanismView *>()->pictureSize();
            m_window->exports().write(m_window->exports().mechanism(), path);
            break;
        case Subject::Study: {
            size = QSize(900, 600);
            StudyPanel panel;
            panel.setResult(studyOfATurn());
            QCOMPARE(panel.exportPicture(path), std::nullopt);
            break;
        }
        }
        QString fault = pictureFault(path, subject, size, 2.0);
        QVERIFY2(fault.isEmpty(), qPrintable(fault));

        if (const QString what = wordOf(subject); !what.isEmpty()) {
            const QString rendered = m_folder->filePath(QStringLiteral("rendered.") + suffix);
            outputOf(QStringLiteral(SLIDERCRANK_PROGRAM), {"render", "--scene", scene, "--what", what, "--size",
                                                           "1000x1100", "--scale", "1.5", "--output", rendered});
            fault = pictureFault(rendered, subject, QSize(1000, 1100), 1.5);
            QVERIFY2(fault.isEmpty(), qPrintable(fault));
        }
    }

    void framesAreWhatTheyShouldBe()
    {
        if (!missingProgram({"pngtopnm"}).isEmpty()) {
            QSKIP("There is no pngtopnm here: tests/run installs it.");
        }
        Sampling sampling;
        sampling.duration = 0.1;
        m_window->session().setSampling(sampling);
        const QString folder = m_folder->filePath(QStringLiteral("motion"));
        m_window->exports().writeAnimation(folder, m_window->exports().animationShown());
        outputOf(QStringLiteral(SLIDERCRANK_PROGRAM),
                 {"render", "--what", "frames", "--duration", "0.1", "--size", "400x300", "--output",
                  m_folder->filePath(QStringLiteral("rendered"))});
        PrintedPicture before;
        for (int frame = 1; frame <= 3; ++frame) {
            const QString name = QStringLiteral("/frame_000%1.png").arg(frame);
            const PrintedPicture rendered = printedPicture(m_folder->filePath(QStringLiteral("rendered")) + name);
            QCOMPARE(rendered.size, QSize(400, 300));
            const PrintedPicture picture = printedPicture(folder + name);
            QVERIFY(!picture.size.isEmpty() && !picture.isBlank() && !rendered.isBlank());
            QVERIFY(picture.rgb != before.rgb);
            before = picture;
        }
        QVERIFY(!QFile::exists(folder + QStringLiteral("/frame_0004.png")));
    }

    void theReportIsOnPaper()
    {
        if (const QString missing = missingProgram({"pdfinfo", "pdftoppm", "pdftotext"}); !missing.isEmpty()) {
            QSKIP(qPrintable(QStringLiteral("There is no %1 here: tests/run installs it.").arg(missing)));
        }
        m_window->openReference(kSample);
        AWAIT(m_window->session().diagnosis());
        const QString path = m_folder->filePath(QStringLiteral("report.pdf"));
        m_window->exports().writeReport(path);
        AWAIT2(m_said->text().startsWith(QStringLiteral("Exported to ")), qPrintable(m_said->text()));
        const QString checksum = QString::fromLatin1(outputOf(QStringLiteral("sha256sum"), {kSample}).left(64));
        QCOMPARE(checksum.size(), qsizetype(64));
        const QString rendered = m_folder->filePath(QStringLiteral("rendered.pdf"));
        outputOf(QStringLiteral(SLIDERCRANK_PROGRAM),
                 {"render", "--what", "report", "--reference", kSample, "--output", rendered});
        for (const QString &report : {path, rendered}) {
            const QByteArray facts = outputOf(QStringLiteral("pdfinfo"), {report});
            QVERIFY2(facts.contains("(A4)") && facts.contains("Pages:           3"), facts.constData());
            for (const char *page : {"1", "2"}) {
                const PrintedPicture picture = pictureInPpm(
                    outputOf(QStringLiteral("pdftoppm"), {"-r", "48", "-f", page, "-l", page, "-singlefile", report}));
                QVERIFY(!picture.size.isEmpty() && !picture.isBlank());
            }
            const QString text = QString::fromUtf8(outputOf(QStringLiteral("pdftotext"), {report, "-"}));
            for (const char *word : {"inventor_sample.csv", "θ³ [°]", "a⁴ [mm/s²]", "Method"}) {
                QVERIFY2(text.contains(QString::fromUtf8(word)), qPrintable(QString::fromUtf8(word) + text));
            }
            QVERIFY2(text.contains(checksum), qPrintable(text));
        }
    }

    /// awk computes R4x at the file's own instants by the textbook's formula.
    void theDataAreNumbersToOthers()
    {
        if (!missingProgram({"awk"}).isEmpty()) {
            QSKIP("There is no awk here.");
        }
        const QString path = m_folder->filePath(QStringLiteral("motion.csv"));
        m_window->exports().writeData(path, plottedChannels());
        AWAIT2(m_said->text().startsWith(QStringLiteral("Exported to ")), qPrintable(m_said->text()));
        const QByteArray judged = outputOf(QStringLiteral("awk"), {"-F,", R"(
                NR == 1 { for (i = 1; i <= NF; ++i) if ($i == "R4_x") column = i; next }
                { angle = 8 * atan2(1, 1) * $1; height = 25 - 20 * sin(angle)
                  off = $column - (20 * cos(angle) + sqrt(65 * 65 - height * height))
                  if (off < 0) off = -off
                  if (off > most) most = off
                  fields += NF }
                END { print NR, fields, (most < 1e-10) })",
                                                                   path});
        QCOMPARE(judged.trimmed(), QByteArray("202 1608 1")); // 201 rows of 8 columns
    }

    void figurePlotAndMechanismAreCopied()
    {
        const std::pair<const char *, QSize> copies[] = {
            // before the message takes some of it
            {"Copy figure", m_window->findChild<PlotGrid *>()->size()},
            {"Copy mechanism", m_window->findChild<MechanismView *>()->pictureSize()}};
        for (const auto &[name, size] : copies) {
            QAction *action = actionNamed(*m_window, QLatin1String(name));
            QVERIFY2(action, name);
            action->trigger();
            QCOMPARE(QGuiApplication::clipboard()->image().size(), size * 2);
            QVERIFY2(m_said->text().contains(QStringLiteral("in the clipboard")), qPrintable(m_said->text()));
        }
        QImage before;
        for (const QString &name : PlotGrid::plotNames()) {
            emit m_window->findChild<PlotGrid *>()->copyPlotRequested(name); // from the plot's menu
            const QImage image = QGuiApplication::clipboard()->image();
            QCOMPARE(image.size(), QSize(1800, 1200));
            QVERIFY(image != before);
            before = image;
        }
    }

private:
    void isReadBack(double b, Method method, bool all)
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
        m_window->exports().writeData(path, all ? allChannels() : plottedChannels());
        AWAIT2(m_said->text().startsWith(QStringLiteral("Exported to ")), qPrintable(m_said->text()));
        QVERIFY(!contentOf(path).contains('\r'));

        QSignalSpy loaded(&session, &Session::referenceLoaded);
        m_window->openReference(path);
        QVERIFY(loaded.wait(kPatience));
        const Result &result = *session.result();
        const ReferenceData &read = result.reference->data;
        QCOMPARE(read.time.size(), result.trajectory.time.size());
        QCOMPARE(read.series.size(), std::size_t(all ? 36 : 7));
        for (std::size_t i = 0; i < read.time.size(); ++i) {
            QVERIFY(isSame(result.trajectory.time[i], read.time[i]));
        }
        const Trajectory whole = sample(result.mechanism, sampling.instants(), allChannels(), solver);
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

    QTemporaryDir m_settings;
    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<MainWindow> m_window;
    MessageBar *m_said = nullptr;
};

const Suite suite("tst_exports", runWithWidgets<TestExports>);

#include "tst_exports.moc"
