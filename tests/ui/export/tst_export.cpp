// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/files.h"
#include "tests/support/suite.h"
#include "tests/support/waiting.h"
#include "ui/document/background_task.h"
#include "ui/document/session.h"
#include "ui/export/animation_export.h"
#include "ui/export/figure_export.h"
#include "ui/export/motion_csv.h"
#include "ui/export/motion_table.h"
#include "ui/export/report.h"
#include "ui/text/language.h"
#include "ui/text/notation.h"
#include "ui/text/theme.h"

#include <QApplication>
#include <QClipboard>
#include <QDir>
#include <QFile>
#include <QImage>
#include <QPainter>
#include <QScopeGuard>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <QTextDocument>
#include <QThread>
#include <QXmlStreamReader>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <stop_token>
#include <vector>

using namespace slidercrank;

namespace tst_export
{

void drawSquare(QPainter &painter, const QSize &size)
{
    painter.fillRect(QRect(QPoint(), size), Qt::white);
    painter.fillRect(QRect(size.width() / 4, size.height() / 4, size.width() / 2, size.height() / 2), Qt::blue);
    painter.setPen(Qt::black);
    painter.drawText(QPoint(5, 20), "θ³ [°]");
}

/// Draws a shade of grey for the time: 0 s is black, 1 s is white.
void drawGrey(QPainter &painter, const QSize &size, double time)
{
    const int grey = static_cast<int>(255.0 * time + 0.5);
    painter.fillRect(QRect(QPoint(), size), QColor(grey, grey, grey));
}

Animation shortAnimation()
{
    Animation animation;
    animation.framesPerSecond = 10;
    animation.size.size = QSize(61, 41);
    return animation;
}

const AnimationProgress kGoOn = [](int) { return true; };

QStringList entriesOf(const QString &folder)
{
    return QDir(folder).entryList(QDir::AllEntries | QDir::NoDotAndDotDot, QDir::Name);
}

std::shared_ptr<const Reference> referenceIn(const QStringList &paths)
{
    const auto outcome = readReference({paths, {}, {}});
    const auto *reference = std::get_if<std::shared_ptr<const Reference>>(&outcome);
    return reference ? *reference : nullptr;
}

ReportContent contentWith(double b, const std::shared_ptr<const Reference> &reference)
{
    Session session;
    session.setParameter(Parameter::B, b);
    session.setReference(reference);
    ReportContent content{session.result(), {}};
    if (reference) {
        content.found = identify(reference->data, session.result()->mechanism);
    }
    return content;
}

/// A report as plain text.
struct ReportText {
    QString text;

    explicit ReportText(const ReportContent &content)
    {
        QTextDocument document;
        document.setHtml(reportHtml(content));
        text = document.toPlainText().replace(QChar::Nbsp, u' ');
    }

    bool has(const QString &words) const { return text.contains(words); }
    bool hasPolygons() const { return text.contains("polygons", Qt::CaseInsensitive); } ///< or words about them
    bool has(const QStringList &list) const
    {
        return std::ranges::all_of(list, [this](const QString &words) { return has(words); });
    }
};

class TestExport : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }
    void init() { m_folder = std::make_unique<QTemporaryDir>(); }

    void writesPicturesOfTheExactSize()
    {
        const FigureSize size{QSize(200, 100), 2.5};
        for (const QString name : {"a.png", "a.SVG", "a.pdf"}) {
            QCOMPARE(exportFigure(path(name), size, QStringLiteral("Stroke"), drawSquare), std::nullopt);
        }
        const QImage image(path("a.png"));
        QCOMPARE(image.size(), QSize(500, 250));
        QCOMPARE(image.pixelColor(250, 125), QColor(Qt::blue));
        QCOMPARE(image.text(QStringLiteral("Title")), QStringLiteral("Stroke"));
        QVERIFY(contentOf(path("a.pdf")).contains("/MediaBox [0 0 150.0")); // a pixel is 3/4 point
        const QByteArray svg = contentOf(path("a.SVG"));
        QVERIFY(svg.contains("width=\"200\" height=\"100\"") && svg.contains("', sans-serif\""));
        QXmlStreamReader xml(svg);
        QStringList texts;
        while (!xml.atEnd()) {
            xml.readNext();
            texts << xml.text().toString();
        }
        QVERIFY2(!xml.hasError(), qPrintable(xml.errorString()));
        QVERIFY(texts.contains("Stroke") && texts.join(QString()).contains("θ³ [°]"));

        QCOMPARE(copyFigureToClipboard({QSize(64, 48), 2.0}, drawSquare), std::nullopt);
        QCOMPARE(QApplication::clipboard()->image().size(), QSize(128, 96));
    }

    void refusesImpossiblePictures()
    {
        struct Row {
            const char *name;
            QSize size;
            double scale;
        };
        const QSize usual(100, 100);
        bool isDrawn = false;
        const auto draw = [&isDrawn](QPainter &, const QSize &) { isDrawn = true; };
        const Row rows[] = {{"a.png", {0, 100}, 1.0},
                            {"a.png", {100, -1}, 1.0},
                            {"a.png", usual, 0.0},
                            {"a.png", usual, 1e-3},
                            {"a.jpg", usual, 1.0}};
        for (const Row &row : rows) {
            const std::optional<QString> fault = exportFigure(path(row.name), {row.size, row.scale}, {}, draw);
            QVERIFY(fault && fault->endsWith(u'.') && !isDrawn);
        }
        QVERIFY(exportFigure(path("gone/a.png"), {}, {}, drawSquare)->contains("gone"));
        QVERIFY(entriesOf(m_folder->path()).isEmpty());
    }

    void namesTheParametersBelowAFigure()
    {
        const FigureDrawing draw = withParameters(drawSquare, Mechanism(), paletteFor(Theme::Light));
        for (int width = 150; width <= 600; width += 10) { // a former defect: "rad/" and "s" in two lines
            QCOMPARE(exportFigure(path("a.svg"), {QSize(width, 200)}, {}, draw), std::nullopt);
            const QByteArray svg = contentOf(path("a.svg"));
            for (const char *equation : {"a = 20 mm", "b = 65 mm", "c = 25 mm", "rad/s"}) {
                QVERIFY2(svg.contains(equation), qPrintable(QString("%1 %2").arg(width).arg(equation)));
            }
        }
    }

    /// A former defect: in narrow figures with large letters, the parameters touched both edges.
    void theParametersKeepAwayFromTheEdges()
    {
        const FigureDrawing drawNothing = [](QPainter &, const QSize &) {};
        const FigureDrawing draw = withParameters(drawNothing, Mechanism(), paletteFor(Theme::Light));
        for (int width = 300; width <= 600; width += 5) {
            const FigureSize size{.size = {width, 200}, .fontPixels = 19};
            const QImage picture = figureImage(size, draw);
            for (int y = 0; y < picture.height(); ++y) {
                for (const int x : {0, 1, 2, width - 3, width - 2, width - 1}) {
                    QCOMPARE(picture.pixelColor(x, y), QColor(Qt::white));
                }
            }
        }
    }

    /// A former defect: a light line divided a dark figure from its parameters.
    void noLineDividesAFigureFromItsParameters()
    {
        const QColor background = paletteFor(Theme::Dark).color(QPalette::Base);
        const auto drawBackground = [&background](QPainter &painter, const QSize &size) {
            painter.fillRect(QRect(QPoint(), size), background);
        };
        const FigureDrawing draw = withParameters(drawBackground, Mechanism(), paletteFor(Theme::Dark));
        for (const double scale : {1.0, 1.3, 2.1, 3.125}) {
            FigureSize size;
            size.size = QSize(400, 201);
            size.scale = scale;
            const auto drawSmoothly = [&draw](QPainter &painter, const QSize &drawn) { // as viewers of SVG do
                painter.setRenderHint(QPainter::Antialiasing);
                draw(painter, drawn);
            };
            const QImage image = figureImage(size, drawSmoothly);
            for (int y = 0; y < static_cast<int>(scale * size.size.height()); ++y) {
                QCOMPARE(image.pixelColor(1, y), background);
            }
        }
    }

    void writesFramesIntoANewFolder()
    {
        int frames = 0;
        const auto progress = [&frames](int done) {
            frames = done;
            return true;
        };
        QVERIFY(QDir(m_folder->path()).mkdir("empty"));
        for (const QString name : {"new", "empty"}) {
            QCOMPARE(exportAnimation(path(name), shortAnimation(), drawGrey, progress), std::nullopt);
            QCOMPARE(frames, 10);
            const QStringList names = entriesOf(path(name));
            QCOMPARE(names.size(), qsizetype(10));
            QCOMPARE(names.first(), QStringLiteral("frame_0001.png"));
            const QImage sixth(path(name + "/frame_0006.png"));
            QCOMPARE(sixth.size(), QSize(61, 41));
            QCOMPARE(sixth.pixelColor(30, 20).red(), 128); // half a second
            const QImage last(path(name + "/frame_0010.png"));
            QCOMPARE(last.pixelColor(30, 20).red(), 230); // one frame before a whole turn
        }
        QCOMPARE(entriesOf(m_folder->path()), QStringList({"empty", "new"}));

        Animation backwards = shortAnimation();
        backwards.start = 2.0;
        backwards.duration = -4.0;
        backwards.speed = 0.5;
        QCOMPARE(backwards.frameCount(), 80);
        QCOMPARE(backwards.timeOfFrame(40), 0.0);
        backwards.duration = 0.0;
        QCOMPARE(backwards.frameCount(), 1);
    }

    /// The letters of a video are legible from the back of a lecture room, whatever its size and shape.
    void framesHaveLargeLetters()
    {
        for (const QSize &pixels :
             {QSize(1920, 1080), {3840, 2160}, {1280, 720}, {1080, 1920}, {1919, 1079}, {854, 480}, {1000, 1080}}) {
            const FigureSize size = videoSize(pixels);
            QCOMPARE((QSizeF(size.size) * size.scale).toSize(), pixels);
            const double letters = size.fontPixels * size.scale / std::min(pixels.width(), pixels.height());
            QVERIFY2(letters > 0.9 / 30.0 && letters < 1.1 / 30.0, qPrintable(QString::number(letters)));
        }
        QCOMPARE(videoSize({200, 150}).fontPixels, 12);
    }

    void leavesNoFilesAfterAFailureOrACancel()
    {
        QVERIFY(QDir(m_folder->path()).mkdir("full"));
        writeFile(*m_folder, "full/note.txt", "note");
        for (const QString name : {"full", "full/note.txt", "gone/new"}) {
            const std::optional<QString> problem = exportAnimation(path(name), shortAnimation(), drawGrey, kGoOn);
            QVERIFY2(problem && problem->contains("cannot be written"), qPrintable(name));
        }
        // A former defect: on a full disk the message named a temporary folder. Here that folder is gone.
        const auto removeFolder = [this](QPainter &, const QSize &, double) {
            for (const QString &name : entriesOf(m_folder->path()).filter("frames-")) {
                QVERIFY(QDir(path(name)).removeRecursively());
            }
        };
        const QString problem = exportAnimation(path("new"), shortAnimation(), removeFolder, kGoOn).value_or("none");
        QVERIFY2(problem.startsWith(path("new") + " cannot be written"), qPrintable(problem));
        for (const QString name : {"new", "new.mp4"}) {
            if (!isVideo(name) || !QStandardPaths::findExecutable("ffmpeg").isEmpty()) {
                QCOMPARE(exportAnimation(path(name), shortAnimation(), drawGrey, [](int done) { return done < 3; }),
                         QString());
            }
        }
        QCOMPARE(entriesOf(m_folder->path()), QStringList(QStringLiteral("full")));
        QCOMPARE(entriesOf(path("full")), QStringList(QStringLiteral("note.txt")));
    }

    void makesVideosWithFfmpeg()
    {
        struct Row {
            QByteArray lastLine; // of the script that replaces ffmpeg
            QByteArray content;
            QString problem;
        };
        const QTemporaryDir programs;
        const QByteArray before = qgetenv("PATH");
        const auto restore = qScopeGuard([&before] { qputenv("PATH", before); });
        const Row rows[] = {{"printf newer > $film", "newer", {}},
                            {"echo full >&2; exit 1", "older", "the video: full"},
                            {": > $film", "older", "could not make"},
                            {"true", "older", "could not make"}};
        for (const Row &row : rows) {
            const QString program =
                writeFile(programs, "ffmpeg", "#!/bin/sh\nfor film; do :; done\n" + row.lastLine + '\n');
            QVERIFY(QFile::setPermissions(program, QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner));
            qputenv("PATH", QFile::encodeName(programs.path()) + ':' + before);
            const QString video = writeFile(*m_folder, "motion.gif", "older");
            const QString problem = exportAnimation(video, shortAnimation(), drawGrey, kGoOn).value_or(QString());
            QVERIFY2(problem.contains(row.problem) && problem.isEmpty() == row.problem.isEmpty(), qPrintable(problem));
            QCOMPARE(contentOf(video), row.content);
            QCOMPARE(entriesOf(m_folder->path()).size(), qsizetype(1));
        }
        qputenv("PATH", QFile::encodeName(m_folder->path())); // no ffmpeg
        const std::optional<QString> problem = exportAnimation(path("m.gif"), shortAnimation(), drawGrey, kGoOn);
        QVERIFY(problem && problem->contains("ffmpeg") && problem->contains("nstall"));
    }

    void writesTimeAndCrankAngleWithTheData()
    {
        Session session;
        QCOMPARE(exportMotion(path("steps.csv"), *session.result(), {plottedChannels()}), std::nullopt);
        const QList<QByteArray> steps = contentOf(path("steps.csv")).trimmed().split('\n');
        QCOMPARE(steps.size(), qsizetype(202));
        QVERIFY(steps.first().startsWith("time,theta2,") && steps.first().count(',') == 7);
        for (qsizetype i = 1; i < steps.size(); ++i) {
            QVERIFY(std::abs(steps[i].split(',')[1].toDouble() - 1.8 * double(i - 1)) < 1e-9);
        }
        const MotionCsvOptions inInches{plottedChannels(), {.units = {LengthUnit::Inch, AngleUnit::Radian}}};
        QCOMPARE(exportMotion(path("inches.csv"), *session.result(), inInches), std::nullopt);
        const QList<QByteArray> inches = contentOf(path("inches.csv")).trimmed().split('\n');
        const QList<QByteArray> names = inches.first().split(',');
        QVERIFY2(names[1] == "theta2 [rad]" && names.contains("theta3_diff [rad/s]"), inches.first());
        const qsizetype speed = names.indexOf("R4_x_diff [in/s]");
        const qsizetype inFile = steps.first().split(',').indexOf("R4_x_diff");
        QVERIFY2(speed > 0 && speed == inFile, inches.first());
        for (qsizetype i = 1; i < inches.size(); ++i) {
            QVERIFY(std::abs(inches[i].split(',')[1].toDouble() - std::numbers::pi / 100.0 * double(i - 1)) < 1e-12);
            QVERIFY(std::abs(25.4 * inches[i].split(',')[speed].toDouble() - steps[i].split(',')[inFile].toDouble()) <
                    1e-9);
        }
        QVERIFY(exportMotion(path("gone/x.csv"), *session.result(), {plottedChannels()})->contains("gone"));
    }

    /// A former defect: in the notation of textbooks, θ₃ in the data was not that of the window and its table.
    void writesTheCouplerAngleOfTextbooks()
    {
        const auto restore = qScopeGuard([] { setNotation({}); });
        setNotation({.symbols = Symbols::Textbook});
        for (const Branch branch : {Branch::Open, Branch::Crossed}) {
            Session session;
            session.setParameters({.branch = branch});
            const MotionCsvOptions options{plottedChannels(), notation()};
            QCOMPARE(exportMotion(path("textbook.csv"), *session.result(), options), std::nullopt);
            const QList<QByteArray> lines = contentOf(path("textbook.csv")).trimmed().split('\n');
            const qsizetype column = lines.first().split(',').indexOf("theta3 at B");
            QVERIFY2(column > 0, lines.first());
            const MotionTableSettings table{.columns = {Channel{Theta3, Order::Position}}};
            const TableRow row = motionTableRow(table, session.result()->mechanism, 0.0, {.theta2 = 0.0});
            const double inTable = *row.cells.back().number;
            QVERIFY(std::abs(lines[1].split(',')[column].toDouble() - inTable) < 1e-12);

            session.setReference(referenceIn({path("textbook.csv")}));     // reads it back
            QCOMPARE(session.result()->comparison.size(), std::size_t(7)); // with θ₂
            for (const ChannelComparison &channel : session.result()->comparison) {
                QVERIFY(channel.largestError && *channel.largestError < 1e-9);
            }
        }
    }

    void reportsTheMechanismFirstThenPlotsThenErrors()
    {
        const ReportText report(contentWith(65.0, referenceIn({kSample})));
        qsizetype at = 0;
        for (const char *words :
             {"b, coupler", "[mechanism]", "At θ₂ = 0°", "Motion limits", "[figure]", "Method", "Errors"}) {
            at = report.text.indexOf(words, at);
            QVERIFY2(at >= 0, words);
        }
        QVERIFY2(report.has({"65 mm", "60.0", " ± ", "identified in this file", "coupler angle θ³", "stroke",
                             "inventor_sample.csv, t = 0 … 1 s, 201 rows", "± is one standard error"}),
                 qPrintable(report.text));
        QVERIFY(!report.has("Table") && !report.hasPolygons()); // exercises, of no use in a comparison
        const ReportText alone(contentWith(65.0, nullptr));
        QVERIFY(!alone.has("eference") && !alone.has("found in"));
        QVERIFY(ReportText(contentWith(60.0, referenceIn({kSample}))).has("within the rounding of the file"));
        QVERIFY(reportHtml(contentWith(60.0, referenceIn({kSample})))
                    .contains("\u00a0±\u00a0")); // a former defect: a line ended before ±
    }

    void reportsTheTableWithItsSettings()
    {
        ReportContent content = contentWith(65.0, nullptr);
        const ReportText usual(content);
        qsizetype at = 0;
        for (const char *words : {"Motion limits", "Table, every 15°", "345.00", "Velocity and acceleration polygons",
                                  "[polygons]", "Motion", "[figure]", "Method"}) {
            at = usual.text.indexOf(words, at);
            QVERIFY2(at >= 0, words);
        }
        const std::vector<OutputChannel> position{Channel{R4x, Order::Position}};
        content.table = MotionTableSettings{.step = TableStep::Time, .timeStep = 0.25, .columns = position};
        content.alpha2 = 50.0;
        const ReportText overTime(content);
        QVERIFY2(overTime.has({"Table, every 0.25 s, α₂ = 50 rad/s²", "0.75000"}), qPrintable(overTime.text));
        QVERIFY(!overTime.has("345.00"));
        content.table->timeStep = 1e-3; // 1001 rows
        QVERIFY(ReportText(content).has("Table, every 15°"));
    }

    void reportsOnlyTablesAndPolygonsThatExist()
    {
        Session session;
        session.setParameter(Parameter::Omega2, 0.0);
        ReportContent content{session.result(), {}};
        QVERIFY(ReportText(content).has("Table, every 15°") && !ReportText(content).hasPolygons());
        QVERIFY(ReportText(content).has("angles that the crank does not reach"));
        content.alpha2 = 5.0;
        QVERIFY(ReportText(content).hasPolygons());
        session.setParameters({.b = 4.0}); // cannot be assembled
        const ReportText impossible({session.result(), {}});
        QVERIFY2(!impossible.has("Table") && !impossible.hasPolygons() && !impossible.has("[figure]"),
                 qPrintable(impossible.text));
    }

    /// A former defect: "θ³ = –°" and the headings of a table without rows.
    void reportsDashesWithoutUnits()
    {
        const ReportText impossible(contentWith(4.0, nullptr));
        QVERIFY2(impossible.has({"θ³ = –", "s = –."}) && !impossible.has("–°") && !impossible.has("– mm"),
                 qPrintable(impossible.text));
        QVERIFY(!impossible.has("limit\n"));
        const QString html = reportHtml(contentWith(4.0, nullptr)); // a former defect: a line ended within |c| = 45 mm
        QVERIFY2(html.contains("b\u00a0≥\u00a0a\u00a0+\u00a0|\u2060c|\u2060\u00a0=\u00a045\u00a0mm"), qPrintable(html));
    }

    void reportNamesItsFilesAndColumns()
    {
        const QByteArray rows = "time,Linear Displacement1 (mm),theta3\n0,80,22.6\n0.01,80.3,21.5\n0.02,80.5,20.5\n";
        const QString file = writeFile(*m_folder, "motion.csv", rows);
        ReportContent content = contentWith(65.0, referenceIn({file}));
        content.timeOfWriting = QDateTime({2024, 5, 17}, {9, 41, 5}); // local time
        const ReportText report(content);
        QVERIFY2(report.has({"17 May 2024, 09:41", "“Linear Displacement1 (mm)” as R4_x", file}),
                 qPrintable(report.text));
        QVERIFY(!report.has("theta3”")); // its name is known

        auto changed = std::make_shared<Reference>(*referenceIn({kSample}));
        changed->data.skipped.push_back({17, 2, "oops", RowFault::NotANumber});
        changed->data.layout.columns.emplace_back().heading = "colour";
        const ReportText skipping(contentWith(60.0, changed));
        QVERIFY2(skipping.has({"the first in line 17, column 2 (“oops”): not a number", "not used: colour"}),
                 qPrintable(skipping.text));
    }

    /// With α₂, the acceleration of the slider may exceed its peak in the table of the limits.
    void reportsThatLimitsAndPlotsAreWithoutTheCrankAcceleration()
    {
        ReportContent content = contentWith(65.0, nullptr);
        QVERIFY(!ReportText(content).has("without α₂"));
        content.alpha2 = 50.0;
        const ReportText report(content);
        QVERIFY2(report.has({"α₂ = 50 rad/s²", "plots are those of a constant crank speed, without α₂."}),
                 qPrintable(report.text));
    }

    /// A former defect: a⁴ = 0 on the same page as a peak acceleration of ∞ at the same position.
    void reportsNoVelocitiesWhereTheyJump()
    {
        Session session;
        session.setParameters({.a = 40.0, .b = 60.0, .c = 20.0});
        ReportContent content{session.result(), {}};
        content.time = 0.75; // 270°
        const ReportText report(content);
        QVERIFY2(report.has({"v⁴ = –", "a⁴ = –", "the velocities jump: just before", "velocities do not exist."}),
                 qPrintable(report.text));
        QVERIFY(!report.hasPolygons());
        content.time = 0.7;
        QVERIFY(!ReportText(content).has("v⁴ = –") && !ReportText(content).has("just before"));
    }

    void reportsPinnedMotionsAndTheMethod()
    {
        Session session;
        session.pinMotion();
        session.setParameter(Parameter::B, 80.0);
        SolverSettings solver;
        solver.newton.tolerance = 2.5e-12;
        solver.newton.toleranceKind = ToleranceKind::Relative;
        solver.method = Method::Newton;
        session.setSolver(solver);
        const ReportText pinned({session.result(), {}});
        QVERIFY2(pinned.has({"pinned motions (b = 65 mm)", "the pinned mechanism.", "largest difference",
                             "2.5·10⁻¹² (relative), at most 10 iterations"}),
                 qPrintable(pinned.text));
        session.pinMotion(); // a former defect: the parameters of two motions were a single list
        session.setParameters({.a = 30.0, .b = 90.0});
        QVERIFY(ReportText({session.result(), {}}).has("(a = 20 mm, b = 65 mm; a = 20 mm, b = 80 mm)"));
        session.setSolver({});
        session.unpinMotions();
        const ReportText alone({session.result(), {}});
        QVERIFY(alone.has("Closed form, exact to rounding.") && !alone.has("pinned"));
    }

    void saysWhyTimeStepsAreNotSolved()
    {
        Session session;
        session.setParameters({.a = 60.0, .b = 50.0, .c = 20.0}); // 120° of 360° cannot be reached
        const ReportText rocker({session.result(), {}});
        QVERIFY2(rocker.has("134 of them solved. 67 time steps: The mechanism cannot be assembled"),
                 qPrintable(rocker.text));
        session.setParameters({});
        SolverSettings solver;
        solver.method = Method::Newton;
        solver.newton.maxIterations = 2;
        session.setSolver(solver);
        QVERIFY(ReportText({session.result(), {}}).has("did not converge within 2 iterations"));
    }

    /// A former defect: the exact curves of a fast crank were said to have too few samples.
    void onlyASampledMotionCanHaveTooFewSamples()
    {
        Session session;
        session.setParameters({.omega2 = 100.0 * std::numbers::pi}); // 4 samples per revolution
        QVERIFY(!ReportText({session.result(), {}}).has("too few"));
        SolverSettings solver;
        solver.method = Method::Newton;
        session.setSolver(solver);
        QVERIFY(ReportText({session.result(), {}}).has("too few"));
    }

    /// A former defect: fifty revolutions of an engine were a band, in which no curve could be read.
    void thePlotsShowTheFirstRevolutionOfAFastCrank()
    {
        Session session;
        session.setParameters({.omega2 = -100.0 * std::numbers::pi});
        session.setSampling({0.5, 1.0, 200});
        const std::optional<Interval> time = plottedTime(*session.result(), {});
        QVERIFY(time && time->lower == 0.5 && std::abs(time->upper - 0.52) < 1e-12);
        QVERIFY(ReportText({.result = session.result(), .found = {}, .plottedTime = time}).has("t = 0.5 s to 0.52 s"));
        const Interval zoomed{0.6, 0.7};
        QCOMPARE(plottedTime(*session.result(), {.time = zoomed, .values = {}}), zoomed);
        session.pinMotion();
        session.setParameter(Parameter::B, 80.0);
        QCOMPARE(plottedTime(*session.result(), {}), std::nullopt);
        session.unpinMotions();
        session.setParameters({.omega2 = 10.0 * std::numbers::pi}); // five revolutions
        QCOMPARE(plottedTime(*session.result(), {}), std::nullopt);
        QVERIFY(!ReportText({session.result(), {}}).has("The plots show"));
    }

    void putsTextAndDrawingsOnA4()
    {
        const auto draw = [](QPainter &painter, const QSize &size) {
            painter.fillRect(QRect(QPoint(), size), Qt::red);
            painter.translate(1000.0, 1000.0); // this must not affect the rest of the page
        };
        const ReportContent content = contentWith(65.0, referenceIn({kSample}));
        QCOMPARE(exportReport(path("report.pdf"), content, draw, draw), std::nullopt);
        const QByteArray pdf = contentOf(path("report.pdf"));
        QVERIFY(pdf.startsWith("%PDF") && pdf.contains("/Type /Font")); // text is not drawn as an image
        QVERIFY2(pdf.count("/Type /Page\n") == 2, QByteArray::number(pdf.count("/Type /Page\n")));
        QVERIFY(exportReport(path("gone/report.pdf"), content, draw, draw)->contains("cannot be written"));
        QCOMPARE(entriesOf(m_folder->path()), QStringList(QStringLiteral("report.pdf")));
    }

    void aReportIsWrittenInPiecesWithProgress()
    {
        const auto report = beginReport(path("report.pdf"), contentWith(65.0, nullptr), drawSquare, drawSquare);
        std::vector<double> parts{report->progress()};
        while (report->advance()) {
            parts.push_back(report->progress());
            QVERIFY(!QFile::exists(path("report.pdf")));
        }
        QCOMPARE(report->problem(), std::nullopt);
        QCOMPARE(report->progress(), 1.0);
        QVERIFY2(parts.size() > 10, qPrintable(QString::number(parts.size()))); // the sections and the pages
        QVERIFY(parts.front() == 0.0 && parts.back() < 1.0 && std::ranges::is_sorted(parts));
        QVERIFY(contentOf(path("report.pdf")).startsWith("%PDF"));
    }

    void aReportThatIsCancelledLeavesNoFile()
    {
        const auto drawSlowly = [](QPainter &painter, const QSize &size) {
            QThread::msleep(50); // longer than the 40 ms after which events are handled
            drawSquare(painter, size);
        };
        BackgroundTask task;
        connect(&task, &BackgroundTask::progressed, this, [&task](double part) {
            if (part > 0.6) { // a page has been printed
                task.discard();
            }
        });
        const auto fail = [](const auto &) { QFAIL("must not be called"); };
        const auto report = beginReport(path("report.pdf"), contentWith(65.0, nullptr), drawSlowly, drawSlowly);
        task.startPiecesInGuiThread(report, fail, fail);
        AWAIT(!task.isRunning());
        settle();
        QVERIFY(report->progress() > 0.6 && report->progress() < 1.0);
        QVERIFY(entriesOf(m_folder->path()).isEmpty());
    }

    /// The window may change its notation while a report is written.
    void aReportKeepsTheNotationWithWhichItWasBegun()
    {
        const Notation before = notation();
        const auto restore = qScopeGuard([&before] { setNotation(before); });
        QStringList units;
        const auto draw = [&units](QPainter &, const QSize &) { units << shownUnit(Measure::Length); };
        const auto report = beginReport(path("report.pdf"), contentWith(65.0, nullptr), draw, draw);
        setNotation({.units = {.length = LengthUnit::Inch}});
        while (report->advance()) {
            QCOMPARE(shownUnit(Measure::Length), QStringLiteral("in"));
        }
        QCOMPARE(units, QStringList({"mm", "mm"}));
    }

    void aFigureThatIsCancelledIsNotWritten()
    {
        const FigureWriter write = drawFigure(path("a.png"), {QSize(64, 48)}, {}, drawSquare);
        std::stop_source stop;
        stop.request_stop();
        QCOMPARE(write(stop.get_token()), std::nullopt);
        QVERIFY(entriesOf(m_folder->path()).isEmpty());
        QCOMPARE(write({}), std::nullopt);
        QCOMPARE(entriesOf(m_folder->path()), QStringList("a.png"));
    }

    /// A former defect: with the longer Spanish names of a comparison, the mechanism was drawn 71 mm wide.
    void theDrawingIsLargeInEveryReport()
    {
        const auto restore = qScopeGuard([usual = QLocale()] {
            setLanguage(Language::English);
            QLocale::setDefault(usual);
        });
        for (const Language language : {Language::English, Language::Spanish}) {
            setLanguage(language);
            for (const PaperSize paper : {PaperSize::A4, PaperSize::Letter}) {
                for (const bool isCompared : {true, false}) {
                    QSize drawn;
                    const auto note = [&drawn](QPainter &, const QSize &size) { drawn = size; };
                    ReportContent content = contentWith(62.0, isCompared ? referenceIn({kSample}) : nullptr);
                    content.paper = paper;
                    QCOMPARE(exportReport(path("report.pdf"), content, note, [](QPainter &, const QSize &) {}),
                             std::nullopt);
                    QVERIFY2(drawn.width() >= 310, qPrintable(QString::number(drawn.width()))); // px, 82 mm
                }
            }
        }
    }

private:
    QString path(const QString &name) const { return m_folder->filePath(name); }

    std::unique_ptr<QTemporaryDir> m_folder;
};

const Suite<TestExport> suite("tst_export");

} // namespace tst_export

#include "tst_export.moc"
