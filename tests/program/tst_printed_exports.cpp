// SPDX-License-Identifier: GPL-3.0-or-later

// Exported figures and reports on paper: curves against the exact motion, in mm, and the pages of the report. Programs
// that do not use Qt read the files.

#include "core/sampling/trajectory.h"
#include "tests/program/run_program.h"
#include "tests/support/initial_mechanism.h"
#include "tests/support/pixels.h"
#include "tests/support/printed_picture.h"
#include "tests/support/suite.h"
#include "ui/document/scene.h"
#include "ui/export/motion_table.h"
#include "ui/export/report.h"
#include "ui/mechanism/mechanism_view.h"
#include "ui/plots/plot_grid.h"
#include "ui/text/language.h"
#include "ui/text/notation.h"
#include "ui/text/theme.h"
#include "ui/text/written_number.h"

#include <QDir>
#include <QFileInfo>
#include <QImage>
#include <QRegularExpression>
#include <QScopeGuard>
#include <QTemporaryDir>
#include <QTest>
#include <QTransform>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

using namespace slidercrank;

namespace tst_printed_exports
{

constexpr double kFigureWidth = 160.0; // mm, of an exported figure

std::vector<double> numbersIn(const QString &text)
{
    static const QRegularExpression kNumber(QStringLiteral("-?[0-9.]+(?:e-?[0-9]+)?"));
    std::vector<double> numbers;
    for (auto match = kNumber.globalMatch(text); match.hasNext();) {
        numbers.push_back(match.next().captured().toDouble());
    }
    return numbers;
}

QString attribute(const QString &element, const QString &name)
{
    return QRegularExpression(QStringLiteral("\\b%1=\"([^\"]*)\"").arg(name)).match(element).captured(1);
}

/// Returns the points (mm) of the curve in the colour of the model that has the most points.
std::vector<QPointF> curveIn(const QString &svg)
{
    static const QRegularExpression kElement(QStringLiteral("<(g|svg|path|polyline)\\b[^>]*>"));
    const QString colour = seriesColours(paletteFor(Theme::Light)).model.name();
    const std::vector<double> box = numbersIn(attribute(kElement.match(svg).captured(), "viewBox"));
    // pdftocairo writes points, and colours as a style or, from cairo 1.18 on, as attributes.
    static const QRegularExpression kStrokeOfPdf(QStringLiteral("stroke(?::|=\")rgb\\(0%, ?44\\.7"));
    static const QRegularExpression kUnfilledInPdf(QStringLiteral("fill(?::|=\")none"));
    const bool isPdf = svg.contains(QRegularExpression(QStringLiteral("stroke(?::|=\")rgb")));
    const double mmPerUnit = isPdf ? 25.4 / 72.0 : kFigureWidth / box[2];
    QString group; // the innermost group that states a colour
    std::vector<QPointF> longest;
    for (auto match = kElement.globalMatch(svg); match.hasNext();) {
        const QString element = match.next().captured();
        group = element.startsWith("<g") ? element : group;
        const bool isModel = isPdf ? element.contains(kStrokeOfPdf) && element.contains(kUnfilledInPdf)
                                   : attribute(group, "stroke") == colour && attribute(group, "fill") == u"none";
        const std::vector<double> numbers = numbersIn(attribute(element, element.startsWith("<path") ? "d" : "points"));
        if (!isModel || numbers.size() / 2 <= longest.size()) {
            continue;
        }
        const std::vector<double> m = numbersIn(attribute(isPdf ? element : group, "transform"));
        const QTransform matrix = m.size() == 6 ? QTransform(m[0], m[1], m[2], m[3], m[4], m[5]) : QTransform();
        longest.clear();
        for (std::size_t i = 0; i + 1 < numbers.size(); i += 2) {
            longest.push_back(mmPerUnit * matrix.map(QPointF(numbers[i], numbers[i + 1])));
        }
    }
    return longest;
}

double distanceToSegment(const QPointF &point, const QPointF &from, const QPointF &to)
{
    const QPointF along = to - from;
    const double length = QPointF::dotProduct(along, along);
    const double fraction =
        length > 0.0 ? std::clamp(QPointF::dotProduct(point - from, along) / length, 0.0, 1.0) : 0.0;
    const QPointF away = point - (from + fraction * along);
    return std::hypot(away.x(), away.y());
}

/// Returns the largest distance (mm) of 1000 points of the motion from the curve. The scales of the axes follow from
/// the curve, whose ends are at 0 and 1 s, and whose extremes are those of the motion.
double largestDistance(const std::vector<QPointF> &curve, const Parameters &parameters, Channel channel)
{
    constexpr int kSamples = 400'000;
    constexpr int kPoints = 1000;
    constexpr double kOffset = 0.37; // so that the points are hardly those of the curve
    std::vector<double> times;
    for (int i = 0; i <= kSamples; ++i) {
        times.push_back(static_cast<double>(i) / kSamples);
    }
    const Trajectory motion = sample(Mechanism(parameters), times, ChannelSet(plottedChannels()), {});
    const std::vector<double> &values = motion[channel];
    const auto [smallest, largest] = std::ranges::minmax(values);
    const auto [top, bottom] = std::ranges::minmax(curve, {}, &QPointF::y);
    const double mmPerValue = (bottom.y() - top.y()) / (largest - smallest);
    double worst = 0.0;
    for (int i = 0; i < kPoints; ++i) {
        const auto sampled = static_cast<std::size_t>((i + kOffset) / kPoints * kSamples);
        const QPointF exact(std::lerp(curve.front().x(), curve.back().x(), times[sampled]),
                            bottom.y() - mmPerValue * (values[sampled] - smallest));
        double nearest = 1e9;
        for (std::size_t j = 1; j < curve.size(); ++j) {
            nearest = std::min(nearest, distanceToSegment(exact, curve[j - 1], curve[j]));
        }
        worst = std::max(worst, nearest);
    }
    return worst;
}

struct ReportCase {
    Parameters parameters = {};
    bool hasFile = false;
    int pinnedMotions = 0;
    double alpha2 = 0.0; ///< rad/s²
    MotionTableSettings table = {.columns = usualTableChannels()};
    Notation notation = {};
    int maxPages = 0;
};

class TestPrintedExports : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { QApplication::setStyle(QStringLiteral("Fusion")); }
    void cleanup() { setLanguage(Language::English); }

    void exportedCurvesAreTheMotion_data()
    {
        QTest::addColumn<QStringList>("options");
        QTest::addColumn<double>("b");
        QTest::newRow("a single plot") << QStringList{"--what", "theta3"} << 60.0;
        QTest::newRow("a velocity") << QStringList{"--what", "theta3_diff"} << 60.0;
        QTest::newRow("a sharp peak") << QStringList{"--what", "theta3_diff"} << 45.2;
        QTest::newRow("a small plot") << QStringList{"--plots", "theta3_diff", "--width", "160mm"} << 47.0;
    }

    void exportedCurvesAreTheMotion()
    {
        if (const QString missing = missingProgram({"pdftocairo"}); !missing.isEmpty()) {
            QSKIP(qPrintable(QStringLiteral("%1 is missing: tests/run installs it.").arg(missing)));
        }
        constexpr double kAllowed = 0.02; // mm
        QFETCH(const QStringList, options);
        QFETCH(const double, b);
        const Channel channel{Coordinate::Theta3, options.contains("theta3") ? Order::Position : Order::Velocity};
        const QStringList command = QStringList{"render", "--b", QString::number(b)} + options;
        QCOMPARE(run(command + QStringList{"-o", path("x.svg")}).status, 0);
        QCOMPARE(run(command + QStringList{"-o", path("x.pdf")}).status, 0);
        outputOf("pdftocairo", {"-svg", path("x.pdf"), path("pdf.svg")});
        for (const QString &file : {path("x.svg"), path("pdf.svg")}) {
            const std::vector<QPointF> curve = curveIn(QString::fromUtf8(contentOf(file)));
            QVERIFY2(curve.size() > 60, qPrintable(QString::number(curve.size())));
            const double worst = largestDistance(curve, withCoupler(b), channel);
            QVERIFY2(worst < kAllowed, qPrintable(QStringLiteral("%1: %2 mm").arg(file).arg(worst)));
        }
    }

    void figuresHaveTheSizeThatWasAskedFor()
    {
        struct Row {
            const char *options;
            int width; // px
        };
        for (const Row &row : {Row{"", 1890}, Row{"--width 80mm", 945}, Row{"--width 900px", 900},
                               Row{"--width 900px --scale 2", 1800}, Row{"--width 120mm --font-size 11pt", 1417}}) {
            QCOMPARE(run("render -o " + path("x.png") + ' ' + row.options).status, 0);
            const QImage picture(path("x.png"));
            QCOMPARE(picture.width(), row.width);
        }
        QCOMPARE(run("render --width 85mm -o " + path("x.svg")).status, 0);
        QVERIFY(contentOf(path("x.svg")).contains("width=\"85mm\""));
        QCOMPARE(run("render --width 85mm -o " + path("x.pdf")).status, 0);
        QVERIFY(contentOf(path("x.pdf")).contains("/MediaBox [0 0 241.0")); // 85 / 25.4 · 72, in whole points
    }

    void figuresShowTheChosenPlotsAndValues()
    {
        const QString file = path("x.svg");
        QCOMPARE(run("render --b 60 --plots theta3,R4_x --at 0.25 -o " + file).status, 0);
        const QByteArray both = contentOf(file);
        QVERIFY(both.contains("θ³") && both.contains("Rₓ⁴") && !both.contains("ω³"));
        QVERIFY(both.contains("4.780") && both.contains("t = 0.2500 s"));           // asin(5/60) in degrees
        QCOMPARE(run("render --b 60 --plots θ₃,x --at 0.25 -o " + file).status, 0); // as --channels
        QCOMPARE(contentOf(file), both);
        QCOMPARE(run("render --b 60 --what v -o " + file).status, 0);
        QVERIFY(contentOf(file).contains("slider velocity"));
        QCOMPARE(run("render --b 60 --plots theta3,R4_x --at 0.25 --no-cursor -o " + file).status, 0);
        QVERIFY(!contentOf(file).contains("4.780"));
    }

    /// A former defect: a crank with 3000 rpm gave fifty revolutions, which print as a solid area.
    void aFigureOfAFastCrankShowsOneRevolution()
    {
        struct Row {
            const char *options;
            const char *lastNumber; ///< on the time axis
        };
        for (const Row &row : {Row{"--omega2 3000rpm", "0.02"}, Row{"--omega2 3000rpm --at-angle 60", "0.02"},
                               Row{"--omega2 3000rpm --duration 1", "1"}, Row{"--omega2 3000rpm --at 0.5", "1"},
                               Row{"--omega2 60rpm", "1"}}) {
            QCOMPARE(run("render --what theta3 -o " + path("x.svg") + ' ' + row.options).status, 0);
            static const QRegularExpression kText(QStringLiteral(">([^<>]+)</text>"));
            QString last; // number before the title of the time axis
            for (auto match = kText.globalMatch(QString::fromUtf8(contentOf(path("x.svg")))); match.hasNext();) {
                const QString text = match.next().captured(1).trimmed();
                if (text == u"t [s]") {
                    break;
                }
                last = text;
            }
            QCOMPARE(last, row.lastNumber);
        }
    }

    /// A link contains no settings of the drawing, so that the default ones apply.
    void aLinkIsDrawnLikeItsMechanism()
    {
        const QString render = "render --what mechanism -o ";
        QCOMPARE(run(render + path("link.svg") + " --scene slidercrank.html#a=40&b=120&c=20&omega2=60rpm").status, 0);
        QCOMPARE(run(render + path("options.svg") + " --a 40 --b 120 --c 20 --omega2 60rpm").status, 0);
        QVERIFY(contentOf(path("link.svg")).contains("θ₂ = 0"));
        QCOMPARE(contentOf(path("link.svg")), contentOf(path("options.svg")));
    }

    /// A former defect: a scene that was saved in inches and textbook symbols was drawn in mm.
    void aSceneIsDrawnInItsNotation()
    {
        const auto restore = qScopeGuard([] { setNotation({}); });
        Scene scene;
        scene.parameters = {.a = 76.2, .b = 203.2, .c = 50.8, .omega2 = std::numbers::pi};
        scene.notation =
            Notation{Symbols::Textbook, {LengthUnit::Inch, AngleUnit::Degree}, CrankSpeedUnit::TurnPerMinute};
        QCOMPARE(writeScene(scene, path("inches.slidercrank")), std::nullopt);
        const QString render = "render --scene " + path("inches.slidercrank") + " -o " + path("s.svg");
        QCOMPARE(run(render).status, 0);
        const QString drawing = QString::fromUtf8(contentOf(path("s.svg")));
        QVERIFY(drawing.contains("a = 3 in") && drawing.contains("ω₂ = 30 ") && drawing.contains("[in]"));
        QCOMPARE(run(render + " --length-unit cm").status, 0);
        QVERIFY(QString::fromUtf8(contentOf(path("s.svg"))).contains("a = 7.62 cm"));
    }

    /// A crank at rest has no acceleration but that of α2, so that without α₂ there is no arrow, and no scale of
    /// arrows.
    void arrowsOfASceneIncludeTheAccelerationOfTheCrank()
    {
        Scene scene;
        scene.parameters = {.a = 40.0, .b = 120.0, .c = 20.0, .omega2 = 0.0, .theta20 = 1.0};
        scene.mechanism = {.acceleration = true};
        QCOMPARE(writeScene(scene, path("rest.slidercrank")), std::nullopt);
        const QString render = "render --what mechanism --scene " + path("rest.slidercrank") + " -o " + path("a.svg");
        QCOMPARE(run(render).status, 0);
        QVERIFY(!contentOf(path("a.svg")).contains("Scale"));
        QCOMPARE(run(render + " --alpha2 30").status, 0);
        QVERIFY(contentOf(path("a.svg")).contains("Scale"));
    }

    /// θ3 at B by a pocket calculator: 180° + asin(3.5/8) = 205.9°.
    void picturesAreInTheChosenNotationAndUnits()
    {
        const auto restore = qScopeGuard([] { setNotation({}); });
        const QString file = path("x.svg");
        const QString mechanism = "render --a 3in --b 8in --c 2in --at-angle 330 -o " + file;
        const QString units = " --notation textbook --length-unit in --angle-unit deg-rad/s";
        QCOMPARE(run(mechanism + " --what mechanism" + units).status, 0);
        const QString drawing = QString::fromUtf8(contentOf(file));
        QVERIFY(drawing.contains("θ₃ = 205.9°") && drawing.contains("a = 3 in"));
        QCOMPARE(run(mechanism + units).status, 0);
        const QString figure = QString::fromUtf8(contentOf(file));
        QVERIFY(figure.contains("rad/s]") && figure.contains("[in/s]") && figure.contains("9.792"));
        QCOMPARE(run(mechanism).status, 0);
        QVERIFY(QString::fromUtf8(contentOf(file)).contains("[mm/s]"));
    }

    /// A former defect: the area in which the pin A can be dragged was a transparent circle, and black in some
    /// programs.
    void picturesHaveNoInvisibleShapes()
    {
        const QString file = path("x.svg");
        for (const char *what : {"mechanism", "figure", "polygons"}) {
            QCOMPARE(run(QStringLiteral("render --what %1 -o ").arg(what) + file).status, 0);
            QVERIFY2(!contentOf(file).contains("opacity=\"0\""), what);
        }
    }

    /// A former defect: the comma at the end of a line of magnitudes was cut off.
    void polygonsLeaveAMargin()
    {
        const QString file = path("x.png");
        for (const char *options : {"--alpha2 0", "--alpha2 30", "--alpha2 3000", "--alpha2 30 --width 85mm"}) {
            const QString mechanism = "render --what polygons --a 40 --b 120 --c 20 --omega2 60rpm --at-angle 60 ";
            QCOMPARE(run(mechanism + options + " -o " + file).status, 0);
            const QImage image(file);
            QVERIFY(!image.isNull());
            const int last = image.width() - 1;
            for (int y = 0; y < image.height(); ++y) {
                for (const int x : {0, 1, 2, last - 2, last - 1, last}) {
                    QVERIFY2(image.pixel(x, y) == image.pixel(0, 0), options);
                }
            }
        }
    }

    /// A former defect: in a narrow figure the time lay over a curve.
    void theTimeStandsAboveThePlots()
    {
        const QString file = path("x.svg");
        for (const char *width : {"160mm", "85mm"}) {
            QCOMPARE(run(QStringLiteral("render --at 0.25 --width %1 -o ").arg(width) + file).status, 0);
            const QString svg = QString::fromUtf8(contentOf(file));
            const auto heightOf = [&svg](const QString &text) {
                const QRegularExpression element(" y=\"([0-9.]+)\"[^>]*>[^<]*" + text);
                return element.match(svg).captured(1).toDouble();
            };
            QVERIFY(heightOf("t = 0.2500 s") > 0.0);
            QVERIFY(heightOf("t = 0.2500 s") < heightOf("θ³"));
        }
    }

    void reportsStayWithinTheirMargins_data()
    {
        constexpr Parameters kInInches{.a = 35.56, .b = 101.6, .c = 25.4, .omega2 = 10.0}; // 1.4, 4 and 1 in
        const Notation inches{Symbols::Textbook, {LengthUnit::Inch, AngleUnit::DegreeAndRadianPerSecond}};
        QTest::addColumn<ReportCase>("report");
        QTest::newRow("the model alone") << ReportCase{.parameters = withCoupler(60.0), .maxPages = 3};
        QTest::newRow("a file") << ReportCase{.parameters = withCoupler(65.0), .hasFile = true, .maxPages = 2};
        QTest::newRow("a file that agrees")
            << ReportCase{.parameters = withCoupler(60.0), .hasFile = true, .maxPages = 2};
        QTest::newRow("pins") << ReportCase{.parameters = withCoupler(60.0), .pinnedMotions = 4, .maxPages = 3};
        QTest::newRow("a file and pins") << ReportCase{
            .parameters = withCoupler(65.0), .hasFile = true, .pinnedMotions = 4, .maxPages = 3};
        QTest::newRow("an oscillating crank") << ReportCase{.parameters = withCoupler(40.0), .maxPages = 3};
        QTest::newRow("an oscillating crank with many limits")
            << ReportCase{.parameters = {.a = 80.0, .b = 40.0, .c = 10.0}, .maxPages = 4};
        QTest::newRow("a mechanism that cannot be assembled")
            << ReportCase{.parameters = withCoupler(4.0), .alpha2 = 5.0, .maxPages = 1};
        QTest::newRow("a mechanism that cannot be assembled, beside a file")
            << ReportCase{.parameters = withCoupler(4.0), .hasFile = true, .maxPages = 2};
        QTest::newRow("a crank at rest") << ReportCase{.parameters = {.omega2 = 0.0}, .maxPages = 2};
        QTest::newRow("a crank at rest that is accelerated")
            << ReportCase{.parameters = {.omega2 = 0.0}, .alpha2 = 5.0, .maxPages = 2};
        QTest::newRow("a fast crank") << ReportCase{.parameters = {.omega2 = 600.0}, .alpha2 = -1e4, .maxPages = 3};
        QTest::newRow("inches") << ReportCase{
            .parameters = kInInches, .alpha2 = 30.0, .notation = inches, .maxPages = 3};
        QTest::newRow("rows every 5°") << ReportCase{.table = {.angleStep = 5.0, .columns = usualTableChannels()},
                                                     .maxPages = 4};
        QTest::newRow("every column") << ReportCase{.table = {.columns = tableChannels()}, .maxPages = 5};
        QTest::newRow("time steps") << ReportCase{.table = {.step = TableStep::Time, .columns = usualTableChannels()},
                                                  .maxPages = 3};
    }

    /// A former defect: the last column of the table and the drawing were cut off.
    void reportsStayWithinTheirMargins()
    {
        if (const QString missing = missingProgram({"pdftotext", "pdftoppm"}); !missing.isEmpty()) {
            QSKIP(qPrintable(QStringLiteral("%1 is missing: tests/run installs it.").arg(missing)));
        }
        const auto restore = qScopeGuard([] { setNotation({}); });
        QFETCH(const ReportCase, report);
        setNotation(report.notation);
        ReportContent content = contentFor(report);
        for (const Language language : {Language::English, Language::Spanish}) {
            for (const PaperSize paper : {PaperSize::A4, PaperSize::Letter}) {
                setLanguage(language);
                content.paper = paper;
                writeReport(content);
                checkWords(report.maxPages);
                checkPixels();
            }
        }
    }

    /// The table and the polygons of a report, against the equations of the mechanism by hand: θ3 at B, in inches and
    /// radians per second.
    void reportsContainTheTableAndThePolygons()
    {
        if (const QString missing = missingProgram({"pdftotext"}); !missing.isEmpty()) {
            QSKIP(qPrintable(QStringLiteral("%1 is missing: tests/run installs it.").arg(missing)));
        }
        QCOMPARE(run("render --a 1.4in --b 4in --c 1in --omega2 10 --alpha2 30 --at-angle 45 --notation textbook "
                     "--length-unit in --angle-unit deg-rad/s --what report -o " +
                     path("report.pdf"))
                     .status,
                 0);
        const QString text =
            QString::fromUtf8(outputOf("pdftotext", {"-layout", path("report.pdf"), "-"})).replace(QChar::Nbsp, u' ');
        const QStringList lines = text.split('\n');
        constexpr double a = 1.4, b = 4.0, c = 1.0, omega2 = 10.0, alpha2 = 30.0;
        for (int degrees = 0; degrees <= 360; degrees += 15) {
            const double theta2 = degrees / kDegreesPerRadian;
            const double theta3 = std::asin((c - a * std::sin(theta2)) / b); // at A
            const double omega3 = -a * omega2 * std::cos(theta2) / (b * std::cos(theta3));
            const double alpha3 = (a * omega2 * omega2 * std::sin(theta2) - a * alpha2 * std::cos(theta2) +
                                   b * omega3 * omega3 * std::sin(theta3)) /
                                  (b * std::cos(theta3));
            const double x = a * std::cos(theta2) + b * std::cos(theta3);
            const double v = -a * omega2 * std::sin(theta2) - b * omega3 * std::sin(theta3);
            const double acceleration = -a * (alpha2 * std::sin(theta2) + omega2 * omega2 * std::cos(theta2)) -
                                        b * (alpha3 * std::sin(theta3) + omega3 * omega3 * std::cos(theta3));
            const double outer = std::sqrt((a + b) * (a + b) - c * c);
            QStringList row;
            for (const double value : {theta2 * kDegreesPerRadian, 180.0 + theta3 * kDegreesPerRadian, omega3, alpha3,
                                       x, v, acceleration, 90.0 - std::abs(theta3) * kDegreesPerRadian, outer - x}) {
                constexpr double kRounding = 1e-12;
                row << shortNumber(std::abs(value) < kRounding ? 0.0 : value, 5);
            }
            const auto hasRow = [&row](const QString &line) {
                return line.simplified().endsWith(QLatin1Char(' ') + row.join(' '));
            };
            QVERIFY2(std::ranges::any_of(lines, hasRow), qPrintable(row.join(' ')));
        }
        const double bOmega3 = 9.8996; // in/s: a ω2 cos θ2 / cos θ3 with θ3 = asin((c - a sin θ2)/b) = 0.144°
        for (const double magnitude : {14.0, bOmega3, 140.0, 42.0, bOmega3 * bOmega3 / b}) {
            QVERIFY2(text.contains(" = " + shortNumber(magnitude)), qPrintable(QString::number(magnitude)));
        }
    }

private:
    QString path(const char *name) const { return m_folder.filePath(name); }

    static ReportContent contentFor(const ReportCase &report)
    {
        Choices choices{report.parameters, {}, {}, nullptr, {}};
        if (report.hasFile) {
            choices.reference = std::get<std::shared_ptr<const Reference>>(readReference({{kSample}, {}, {}}));
        }
        for (int i = 0; i < report.pinnedMotions; ++i) {
            choices.pinned.push_back({.a = 15.0 + i, .b = 70.0 + 10.0 * i, .c = -12.5, .omega2 = 3.0 + i});
        }
        ReportContent content{
            .result = compute(choices, {}), .found = {}, .time = 0.2, .alpha2 = report.alpha2, .table = report.table};
        if (report.hasFile) {
            content.found = identify(content.result->reference->data, content.result->mechanism);
        }
        return content;
    }

    void writeReport(const ReportContent &content)
    {
        PlotGrid plots;
        plots.setResult(content.result);
        MechanismView mechanism;
        mechanism.setResult(content.result);
        mechanism.setPose(poseAt(content.result->choices.parameters, content.time));
        mechanism.setSettings({.velocity = true, .names = true, .dimensions = true, .angles = true});
        const QPalette palette = paletteFor(Theme::Light);
        const auto drawMechanism = [&](QPainter &painter, const QSize &size) {
            mechanism.paintMechanism(painter, size, palette);
        };
        const auto drawPlots = [&](QPainter &painter, const QSize &size) {
            plots.paintFigure(painter, {}, size, palette);
        };
        QCOMPARE(exportReport(path("report.pdf"), content, drawMechanism, drawPlots), std::nullopt);
    }

    /// Checks that all words are between the side margins, and that every page but the last one is filled.
    void checkWords(qsizetype largestPageCount)
    {
        constexpr double kMargin = 50.0;      // pt, 17.6 mm
        constexpr double kFooter = 20.0;      // pt, height of the footer above the lower margin
        constexpr double kMinFullness = 0.44; // part of the page's height above its lowest word
        static const QRegularExpression kPage(QStringLiteral("<page width=\"([0-9.]+)\" height=\"([0-9.]+)\">"));
        static const QRegularExpression kWord(QStringLiteral(
            "<word xMin=\"([-0-9.]+)\" yMin=\"([-0-9.]+)\" xMax=\"([-0-9.]+)\" yMax=\"([-0-9.]+)\">([^<]*)"));
        const QString text = QString::fromUtf8(outputOf("pdftotext", {"-bbox", path("report.pdf"), "-"}));
        const QStringList pages = text.split("</page>");
        QVERIFY2(pages.size() - 1 <= largestPageCount, qPrintable(QString::number(pages.size() - 1)));
        for (qsizetype page = 0; page + 1 < pages.size(); ++page) {
            const QRegularExpressionMatch size = kPage.match(pages[page]);
            const double height = size.captured(2).toDouble();
            const QRectF inside = QRectF(0.0, 0.0, size.captured(1).toDouble(), height)
                                      .adjusted(kMargin, 0.0, -kMargin, 0.0); // above and below, see checkPixels()
            int words = 0;
            double lowest = 0.0;
            for (auto match = kWord.globalMatch(pages[page]); match.hasNext(); ++words) {
                const QRegularExpressionMatch word = match.next();
                const QRectF box(QPointF(word.captured(1).toDouble(), word.captured(2).toDouble()),
                                 QPointF(word.captured(3).toDouble(), word.captured(4).toDouble()));
                QVERIFY2(inside.contains(box), qPrintable(word.captured()));
                if (box.bottom() < height - kMargin - kFooter) {
                    lowest = std::max(lowest, box.bottom());
                }
            }
            QVERIFY2(words > 30, qPrintable(pages[page]));
            QVERIFY2(lowest > kMinFullness * height || page + 2 == pages.size(),
                     qPrintable(QString::number(lowest / height)));
        }
    }

    /// Checks that all pixels of the margins are white.
    void checkPixels()
    {
        constexpr int kMargin = 35; // px of 1/50 inch, 17.8 mm
        const QTemporaryDir folder;
        outputOf("pdftoppm", {"-r", "50", path("report.pdf"), folder.filePath("page")});
        const QFileInfoList pages = QDir(folder.path()).entryInfoList({"page*.ppm"}, QDir::Files, QDir::Name);
        QVERIFY(!pages.isEmpty());
        for (const QFileInfo &page : pages) {
            const QImage picture = imageIn(contentOf(page.filePath()));
            QVERIFY(!picture.isNull());
            const QRect inside = picture.rect().adjusted(kMargin, kMargin, -kMargin, -kMargin);
            for (int y = 0; y < picture.height(); ++y) {
                for (int x = 0; x < picture.width(); ++x) {
                    if (!inside.contains(x, y) &&
                        qGray(picture.pixel(x, y)) <= 250) { // QVERIFY2 would compose its text for every pixel
                        QFAIL(qPrintable(QStringLiteral("%1: %2, %3").arg(page.fileName()).arg(x).arg(y)));
                    }
                }
            }
        }
    }

    QTemporaryDir m_folder;
};

const Suite<TestPrintedExports> suite("tst_printed_exports");

} // namespace tst_printed_exports

#include "tst_printed_exports.moc"
