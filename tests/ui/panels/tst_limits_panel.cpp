// SPDX-License-Identifier: GPL-3.0-or-later

// The response of the limits to a parameter, and the design for a stroke and a time ratio.

#include "core/limits/design.h"
#include "core/limits/extremes.h"
#include "ui/export/polygon_figure.h"
#include "ui/panels/design_form.h"
#include "ui/panels/parameter_panel.h"
#include "ui/panels/polygon_view.h"
#include "ui/panels/response_view.h"
#include "ui/text/notation.h"
#include "ui/text/record.h"
#include "ui/text/theme.h"
#include "ui/widgets/number_box.h"
#include "ui/widgets/number_slider.h"
#include "ui/window/main_window.h"

#include "tests/support/files.h"
#include "tests/support/suite.h"
#include "tests/support/text_recorder.h"
#include "tests/support/waiting.h"
#include "tests/support/widget_parts.h"

#include <QApplication>
#include <QBuffer>
#include <QCheckBox>
#include <QClipboard>
#include <QFile>
#include <QLabel>
#include <QMenuBar>
#include <QMouseEvent>
#include <QPainter>
#include <QRegularExpression>
#include <QScopeGuard>
#include <QStandardPaths>
#include <QSvgGenerator>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

using namespace slidercrank;

namespace tst_limits_panel
{

// The line widths in figures of polygons, px, as in the SVG file: those of scales, of components, and of the sums of
// components. The first of the three lines of a scale is its bar, and the other two are its ends.
const QString kScaleWidth = "1.2";
const QString kComponentWidth = "1.6";
const QString kSumWidth = "2.5";
constexpr std::size_t kLinesOfAScale = 3;

/// Returns the lines of `width` (px) in an SVG file, in their order.
std::vector<QLineF> linesIn(const QString &svg, const QString &width)
{
    static const QRegularExpression kElement(
        "<g [^>]*stroke-width=\"([^\"]*)\"|"
        "<polyline [^>]*points=\"([-0-9.e]+),([-0-9.e]+) ([-0-9.e]+),([-0-9.e]+) \"");
    std::vector<QLineF> lines;
    QString group;
    for (auto match = kElement.globalMatch(svg); match.hasNext();) {
        const QRegularExpressionMatch element = match.next();
        if (element.hasCaptured(1)) {
            group = element.captured(1);
        } else if (group == width) {
            lines.push_back({element.captured(2).toDouble(), element.captured(3).toDouble(),
                             element.captured(4).toDouble(), element.captured(5).toDouble()});
        }
    }
    return lines;
}

/// Returns the vectors of the velocity polygon (mm/s) and then of the acceleration polygon (mm/s²), each ending with
/// its sum, with y upwards. The equations a cos θ₂ + b cos θ₃ = x and a sin θ₂ + b sin θ₃ = c are differentiated by
/// hand.
std::vector<QPointF> expectedVectors(const Parameters &parameters, double theta2, double alpha2)
{
    const auto &[a, b, c, omega2, theta20, branch] = parameters;
    const auto polar = [](double length, double angle) {
        return QPointF(length * std::cos(angle), length * std::sin(angle));
    };
    constexpr double kRightAngle = 0.5 * std::numbers::pi;
    const double theta3 = std::asin((c - a * std::sin(theta2)) / b);
    const double omega3 = -a * omega2 * std::cos(theta2) / (b * std::cos(theta3));
    const double alpha3 = (a * omega2 * omega2 * std::sin(theta2) - a * alpha2 * std::cos(theta2) +
                           b * omega3 * omega3 * std::sin(theta3)) /
                          (b * std::cos(theta3));
    const std::vector<QPointF> velocities{polar(a * omega2, theta2 + kRightAngle),
                                          polar(b * omega3, theta3 + kRightAngle)};
    const std::vector<QPointF> accelerations{
        polar(-a * omega2 * omega2, theta2), polar(a * alpha2, theta2 + kRightAngle),
        polar(-b * omega3 * omega3, theta3), polar(b * alpha3, theta3 + kRightAngle)};
    std::vector<QPointF> vectors;
    for (const auto &chain : {velocities, accelerations}) {
        vectors.insert(vectors.end(), chain.begin(), chain.end());
        vectors.push_back(std::accumulate(chain.begin(), chain.end(), QPointF()));
    }
    return vectors;
}

// Indices of the limits in LimitValues.
constexpr std::size_t kStroke = 0, kRatio = 1, kTransmissionAngle = 2, kSpeed = 3, kAcceleration = 4;

/// Whether two lists of limits are equal except for the rounding of a unit conversion. NaN equals NaN.
bool isSame(const LimitValues &first, const LimitValues &second)
{
    return std::ranges::equal(first, second, [](double x, double y) {
        return std::isnan(x) ? std::isnan(y) : std::abs(x - y) <= 1e-15 * std::abs(y);
    });
}

/// Computes the limits directly from the core.
LimitValues expectedLimits(const Parameters &parameters)
{
    LimitValues expected{kNone, kNone, kNone, kNone, kNone};
    const Mechanism mechanism(parameters);
    const MotionLimits limits = motionLimits(mechanism);
    expected[kStroke] = limits.stroke.value_or(kNone);
    if (limits.mobility == Mobility::FullTurn) {
        const std::vector<Peak> peaks = motionPeaks(mechanism);
        const auto finitePeak = [&peaks](Channel channel) {
            const double magnitude = std::ranges::find(peaks, channel, &Peak::channel)->magnitude;
            return std::isfinite(magnitude) ? magnitude : kNone;
        };
        expected = {*limits.stroke, *limits.timeRatio,
                    kDegreesPerRadian * limits.coupler.minimumTransmissionAngle.angle,
                    finitePeak({R4x, Order::Velocity}), finitePeak({R4x, Order::Acceleration})};
    } else if (limits.mobility != Mobility::Impossible) {
        expected[kTransmissionAngle] = 0.0;
    }
    return expected;
}

struct ShownResponse {
    Session session;
    ResponseView view{&session};

    explicit ShownResponse(Parameter parameter)
    {
        view.setParameter(parameter);
        view.resize(900, 200);
        view.show();
        finish();
    }

    /// Waits for the curves, which are computed in the background.
    void finish()
    {
        settle(view);
        finishBackgroundTasks();
    }

    Chart *chart(std::size_t limit) const { return child<Chart>(view, QStringLiteral("responseChart%1").arg(limit)); }

    /// Returns the value of the parameter and of the limit at the first of the dots.
    QPointF dot(std::size_t limit, ResponseView::Series dots = ResponseView::Present) const
    {
        return chart(limit)->content().series[dots].points.at(0);
    }
};

struct ShownDesign {
    Session session;
    DesignForm form{&session};

    ShownDesign() { form.show(); }
    const Parameters &parameters() const { return session.parameters(); }
    const MotionLimits &limits() const { return session.result()->limits; }
    void type(const QString &box, const QString &text) const { typeNumber(child<NumberBox>(form, box), text); }
    QString refusal() const { return child<QLabel>(form, "designRefusal")->text(); }

    /// Whether the stroke and the time ratio are these.
    bool has(double stroke, double timeRatio) const
    {
        return std::abs(*limits().stroke / stroke - 1.0) < 1e-12 &&
               std::abs(limits().timeRatio.value_or(0.0) / timeRatio - 1.0) < 1e-12;
    }
};

class TestLimitsPanel : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QStandardPaths::setTestModeEnabled(true);
        QLocale::setDefault(QLocale::c());
    }

    void computesEveryCurveFromTheLimitsOfTheMechanism()
    {
        std::mt19937 random(24);
        std::uniform_real_distribution<double> length(1.0, 100.0);
        int fullTurns = 0;
        for (int i = 0; i < 60; ++i) {
            const Parameters parameters{length(random), length(random), length(random) - 50.0, length(random) - 50.0};
            const Parameter parameter = kVariedParameters[static_cast<std::size_t>(i) % kVariedParameters.size()];
            const Response response = computeResponse(parameters, parameter, 20);
            const auto &[assembled, fullTurn] = response.range;
            QVERIFY(std::ranges::is_sorted(response.values));
            QCOMPARE((Interval{response.values.front(), response.values.back()}), assembled);
            for (const double end : {fullTurn.lower, fullTurn.upper}) {
                const bool isInside = fullTurn.length() >= 0.0 && assembled.contains(end);
                QVERIFY(!isInside || std::ranges::binary_search(response.values, end));
            }
            for (std::size_t k = 0; k < response.values.size(); ++k) {
                const double value = response.values[k];
                Parameters varied = parameters;
                valueOf(varied, parameter) = value;
                QVERIFY(isSame(response.limits[k], expectedLimits(varied)));
                const double slack = 1e-12 * assembled.length(); // the ends have a rounding error
                if (motionLimits(Mechanism(varied)).mobility == Mobility::FullTurn) {
                    ++fullTurns;
                    QVERIFY(fullTurn.lower - slack <= value && value <= fullTurn.upper + slack);
                } else {
                    QVERIFY(!(fullTurn.lower + slack <= value && value <= fullTurn.upper - slack));
                }
            }
        }
        QVERIFY(fullTurns > 200);
    }

    /// A former defect: next to b = a + |c|, the curve of the stroke had visible corners.
    void curvesAreRoundWhereTheCrankBeginsToTurnFully()
    {
        constexpr int kPixels = 145;       // of a chart at 1400×900
        constexpr double kMaxError = 0.01; // fraction of the largest stroke: about the width of the line
        for (const Parameter parameter : {Parameter::A, Parameter::B, Parameter::C}) {
            const Response response = computeResponse({}, parameter, kPixels);
            const double largest =
                std::ranges::max(response.limits, {}, [](const auto &limits) { return limits[kStroke]; })[kStroke];
            for (std::size_t i = 1; i < response.values.size(); ++i) {
                Parameters middle;
                valueOf(middle, parameter) = std::midpoint(response.values[i - 1], response.values[i]);
                const double stroke = motionLimits(Mechanism(middle)).stroke.value_or(0.0); // mm, as in the charts
                const double drawn = std::midpoint(response.limits[i - 1][kStroke], response.limits[i][kStroke]);
                QVERIFY2(std::abs(drawn - stroke) < kMaxError * largest,
                         qPrintable(QString::number(response.values[i])));
            }
        }
    }

    void knowsTheRangeOfEachParameter()
    {
        struct Row {
            Parameter parameter;
            double b;
            Interval assembled;
            Interval fullTurn;
        };
        for (const Row &row : {Row{Parameter::A, 65.0, {kShortestLink, 60.0}, {kShortestLink, 40.0}},
                               Row{Parameter::B, 65.0, {5.0, 135.0}, {45.0, kLargestParameter}},
                               Row{Parameter::B, 200.0, {5.0, 250.0}, {45.0, kLargestParameter}},
                               Row{Parameter::C, 65.0, {-85.0, 85.0}, {-45.0, 45.0}},
                               Row{Parameter::Omega2, 65.0, {-10.0, 10.0}, {-10.0, 10.0}},
                               Row{Parameter::Omega2, 40.0, {-10.0, 10.0}, {1.0, -1.0}}}) { // no full turns
            const ResponseRange range = responseRange({.b = row.b}, row.parameter);
            QCOMPARE(range.assembled, row.assembled);
            QCOMPARE(range.fullTurn, row.fullTurn);
        }
    }

    void showsTheResponseFromAParameterName()
    {
        MainWindow window;
        window.resize(1400, 900);
        window.show();
        const auto *view = window.findChild<ResponseView *>();
        const auto shown = [&] {
            settle(window);
            finishBackgroundTasks();
            return view->response().parameter;
        };
        QVERIFY(!view->isVisible());
        for (QLabel *label : window.findChild<ParameterPanel *>()->findChildren<QLabel *>()) {
            QTest::mouseClick(label, Qt::LeftButton);
        }
        QCOMPARE(shown(), Parameter::Omega2); // nothing depends on θ₂₀
        QVERIFY(view->isVisible());
    }

    void changesTheParameterByDraggingTheDotWithinItsRange()
    {
        ShownResponse shown(Parameter::B);
        const Response before = shown.view.response();
        Chart *chart = shown.chart(kSpeed);
        QVERIFY(static_cast<int>(before.values.size()) >= chart->width());
        const QPoint from = chart->positionOf({ResponseView::Present, 0}).toPoint();
        const double width = chart->positionOf({ResponseView::Curve, before.values.size() - 1}).x() -
                             chart->positionOf({ResponseView::Curve, 0}).x();
        const auto dragTo = [&](int x) {
            const QPointF to = from + QPoint(x, 0);
            QMouseEvent move(QEvent::MouseMove, to, chart->mapToGlobal(to), Qt::NoButton, Qt::LeftButton, {});
            QApplication::sendEvent(chart, &move);
        };
        QTest::mousePress(chart, Qt::LeftButton, {}, from);
        for (int x = 1; x <= 20; ++x) {
            dragTo(x);
        }
        const double b = shown.session.parameters().b;
        const double pixel = before.range.assembled.length() / width;
        QVERIFY2(std::abs(b - (65.0 + 20.0 * pixel)) <= 1.1 * pixel, qPrintable(QString::number(b)));
        for (const std::size_t limit : {kStroke, kAcceleration}) {
            QCOMPARE(shown.dot(limit), QPointF(b, expectedLimits(shown.session.parameters())[limit]));
        }
        QCOMPARE(shown.view.response().values, before.values); // the curves do not depend on this value
        dragTo(-1000);
        QCOMPARE(shown.session.parameters().b, 5.0); // |c| - a: it can just be assembled
        QTest::mouseRelease(chart, Qt::LeftButton);
        QCOMPARE(shown.session.undoStack().count(), 1);
    }

    void recomputesTheCurvesAndShowsPinnedMotionsAsDots()
    {
        ShownResponse shown(Parameter::B);
        shown.session.pinMotion();
        shown.session.setParameter(Parameter::A, 30.0);
        shown.finish();
        const Response &response = shown.view.response();
        QCOMPARE(response.parameters.a, 30.0);
        const QPointF &point = shown.chart(kRatio)->content().series[ResponseView::Curve].points.back();
        QCOMPARE(point, QPointF(response.values.back(), response.limits.back()[kRatio]));
        QCOMPARE(shown.dot(kRatio, ResponseView::Pinned), QPointF(65.0, expectedLimits({})[kRatio]));
        for (const double b : {1e6, 65.0}) {
            shown.session.setParameter(Parameter::B, b);
            shown.finish();
            QVERIFY(response.range.assembled.upper < 5.0 * b); // the dot is not at the left edge
        }
    }

    /// A former defect: a line of the sentence ended between ≥ and the number.
    void theSentenceIsNotBrokenWithinAnEquation()
    {
        const ShownResponse shown(Parameter::B);
        QVERIFY(child<QLabel>(shown.view, "responseSentence")->text().contains(u"b\u00a0≥\u00a045\u00a0mm"));
    }

    /// A former defect: only the table of the motion had the separators of the language.
    void writesTheNumbersWithTheChosenSeparators()
    {
        const auto restore = qScopeGuard([] {
            setCsvSeparators(CsvSeparators::Standard);
            QLocale::setDefault(QLocale::c());
        });
        const ShownResponse shown(Parameter::B);
        const QTemporaryDir folder;
        QLocale::setDefault(QLocale(QLocale::Spanish, QLocale::Spain));
        setCsvSeparators(CsvSeparators::OfLanguage);
        QVERIFY(!shown.view.exportTo(folder.filePath("r.csv")));
        QFile file(folder.filePath("r.csv"));
        QVERIFY(file.open(QFile::ReadOnly));
        const QByteArray text = file.readAll();
        QVERIFY2(text.startsWith("b;stroke;time-ratio;") && text.contains(',') && !text.contains('.'),
                 text.first(200).constData());
    }

    void exportsTheChartsAndTheNumbersOfTheCurves()
    {
        const ShownResponse shown(Parameter::C);
        const Response &response = shown.view.response();
        const QTemporaryDir folder;
        QVERIFY(!shown.view.exportTo(folder.filePath("r.csv")));
        QVERIFY(shown.view.exportTo("/no/such/folder/r.csv"));
        QFile file(folder.filePath("r.csv"));
        QVERIFY(file.open(QFile::ReadOnly));
        const QList<QByteArray> lines = file.readAll().trimmed().split('\n');
        QCOMPARE(
            lines[0],
            QByteArray("c,stroke,time-ratio,minimum-transmission-angle,peak-slider-speed,peak-slider-acceleration"));
        QCOMPARE(lines.size() - 1, static_cast<qsizetype>(response.values.size()));
        const QList<QByteArray> cells = lines[lines.size() / 2].split(',');
        const std::size_t middle = static_cast<std::size_t>(lines.size() / 2 - 1);
        QCOMPARE(cells[0].toDouble(), response.values[middle]);
        QCOMPARE(cells[5].toDouble(), response.limits[middle][kAcceleration]);
        QVERIFY(lines[1].endsWith(",,0,,")); // in the locked mechanism only the stroke and this angle exist
        const FigureSubject figure = shown.view.figure();
        for (const double width : {85.0, 160.0, 350.0}) {
            FigureOptions options;
            options.width = width;
            const QString path = folder.filePath("r.svg");
            QCOMPARE(exportFigure(path, figure, options), std::nullopt);
            const QByteArray svg = contentOf(path);
            QVERIFY2(svg.contains(QByteArray("width=\"") + QByteArray::number(width) + "mm\""), svg.left(400));
            QVERIFY(svg.contains("b = 65 mm") && svg.contains("c [mm]"));
            const int height = figure.height(options)(1000, QFont());
            QVERIFY(height > 100 && height < 3000);
        }
        child<QToolButton>(shown.view, "responseCopy")->click();
        QVERIFY(!QApplication::clipboard()->image().isNull());
    }

    /// A former defect: the exported charts did not say what their hollow dots are.
    void exportedChartsExplainTheDotsOfPinnedMotions()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath("response.svg");
        ShownResponse shown(Parameter::B);
        const auto isExplained = [&] {
            QFile file(path);
            return exportFigure(path, shown.view.figure(), {}) == std::nullopt && file.open(QIODevice::ReadOnly) &&
                   file.readAll().contains("Hollow dots: pinned motions, b = 65 mm.");
        };
        QVERIFY(!isExplained());
        shown.session.pinMotion();
        shown.session.setParameter(Parameter::B, 80.0);
        AWAIT(isExplained());
    }

    /// A former defect: the outcome stood beside the fields, outside a window of 1024 px.
    void theDesignFormFitsBesideTheMechanism()
    {
        const ShownDesign shown;
        QVERIFY(shown.form.minimumSizeHint().width() < 400); // px
    }

    void scalesTheMechanismToAGivenStroke()
    {
        ShownDesign shown;
        const double stroke = *shown.limits().stroke;
        shown.type("designStroke", "100");
        QVERIFY(std::abs(*shown.limits().stroke - 100.0) < 1e-12 * 100.0);
        const auto &[a, b, c, omega2, theta20, branch] = shown.parameters();
        QVERIFY(std::abs(a / 20.0 / (100.0 / stroke) - 1.0) < 1e-14);
        QVERIFY(std::abs(b / a / 3.25 - 1.0) < 1e-14 && std::abs(c / a / 1.25 - 1.0) < 1e-14);
        shown.session.undoStack().undo(); // a, b and c in one step
        QCOMPARE(shown.parameters(), Parameters());
        shown.type("designStroke", "1e-9");
        QCOMPARE(shown.parameters(), Parameters()); // the links would be too short
    }

    void designsForATimeRatioWithTheSliderForTheRatioOfLengths()
    {
        ShownDesign shown;
        shown.type("designStroke", "80");
        shown.type("designTimeRatio", "1.4");
        QVERIFY(shown.has(80.0, 1.4));
        const auto angle = [&] { return shown.limits().coupler.minimumTransmissionAngle.angle; };
        const double best = angle();
        QCOMPARE(static_cast<float>(shown.parameters().b / shown.parameters().a),
                 static_cast<float>(findDesignRange(1.4)->bestRatio));
        letTimePass(shown.session); // otherwise the edits would form one undo step
        const int steps = shown.session.undoStack().count();
        auto *slider = child<NumberSlider>(shown.form, "designRatio");
        slider->setSliderDown(true);
        for (const int position : {slider->minimum(), slider->maximum() / 3, slider->maximum()}) {
            slider->setValue(position);
            QVERIFY(shown.has(80.0, 1.4));
            QVERIFY(shown.limits().mobility == Mobility::FullTurn && angle() < best);
        }
        slider->setSliderDown(false);
        QCOMPARE(shown.session.undoStack().count(), steps + 1);
        child<QToolButton>(shown.form, "designBest")->click();
        QVERIFY(std::abs(angle() - best) < 1e-12);
        shown.type("designTimeRatio", "0.5"); // forward and return stroke exchanged
        QVERIFY(shown.has(80.0, 2.0) && shown.parameters().c < 0.0);
        shown.type("designTimeRatio", "1.5"); // the strokes remain exchanged
        QVERIFY(shown.has(80.0, 1.5) && shown.parameters().c < 0.0);
    }

    void refusesAnImpossibleRequestWithItsBound()
    {
        ShownDesign shown;
        shown.type("designTimeRatio", "3.5");
        QVERIFY2(shown.refusal().contains("below 3") && shown.refusal().contains("3.5"), qPrintable(shown.refusal()));
        QCOMPARE(shown.parameters(), Parameters());
        QCOMPARE(child<NumberBox>(shown.form, "designTimeRatio")->value(), *shown.limits().timeRatio);
        shown.type("designTimeRatio", "1.5");
        QVERIFY(shown.refusal().isEmpty());
        shown.type("designTransmissionAngle", "70");
        const std::variant<Lengths, DesignFault> designed =
            design({*shown.limits().stroke, 1.5, 70.0 / kDegreesPerRadian});
        const DesignFault &fault = std::get<DesignFault>(designed);
        for (const double bound : {fault.bound * kDegreesPerRadian, fault.timeRatioBound}) {
            QVERIFY2(shown.refusal().contains(QString::number(bound, 'g', 4)), qPrintable(shown.refusal()));
        }
        shown.session.setParameter(Parameter::B, 60.0); // another edit removes the message
        QVERIFY(shown.refusal().isEmpty());
    }

    /// Checks that the mechanism that is found has the time ratio that was typed.
    void designsTheOffsetAlone()
    {
        ShownDesign shown;
        shown.session.setParameters({.a = 40.0, .b = 120.0});
        child<QCheckBox>(shown.form, "designKeepsLinks")->setChecked(true);
        shown.type("designTimeRatio", "1.2");
        const Parameters &found = shown.session.parameters();
        QCOMPARE(found.a, 40.0);
        QCOMPARE(found.b, 120.0);
        QVERIFY(std::abs(*shown.limits().timeRatio - 1.2) < 1e-12);
        QVERIFY(std::abs(child<NumberBox>(shown.form, "designStroke")->value() - *shown.limits().stroke) < 1e-9);
        shown.type("designTimeRatio", "2.9");
        QVERIFY2(shown.refusal().contains("with these lengths a and b"), qPrintable(shown.refusal()));
        QCOMPARE(shown.session.parameters().b, 120.0);
    }

    /// Reads the vectors and the scales back from the exported SVG.
    void exportsPolygonsThatCloseAndAreToScale()
    {
        constexpr double kRounding = 2e-3; // px: coordinates below 1000 are written with six digits
        std::mt19937 random(46);
        const auto between = [&](double lower, double upper) {
            return std::uniform_real_distribution(lower, upper)(random);
        };
        const QTemporaryDir folder;
        const QString path = folder.filePath("polygons.svg");
        for (int round = 0; round < 200; ++round) {
            Session session;
            Parameters parameters{between(10.0, 50.0), 0.0, between(-30.0, 30.0), between(-20.0, 20.0),
                                  between(-3.0, 3.0)};
            parameters.b = between(1.2, 4.0) * (parameters.a + std::abs(parameters.c));
            session.setParameters(parameters);
            session.setTime(between(0.0, 1.0));
            const double theta2 = parameters.theta20 + parameters.omega2 * session.time();
            const double alpha2 = between(-300.0, 300.0);
            session.setAlpha2(alpha2);
            QCOMPARE(exportFigure(path, polygonSubject(session), {}), std::nullopt);
            QFile file(path);
            QVERIFY(file.open(QIODevice::ReadOnly));
            const QString svg = QString::fromUtf8(file.readAll());
            const std::vector<QLineF> components = linesIn(svg, kComponentWidth);
            const std::vector<QLineF> sums = linesIn(svg, kSumWidth);
            const std::vector<QLineF> scales = linesIn(svg, kScaleWidth);
            QVERIFY(components.size() == 6 && sums.size() == 2 && scales.size() == 2 * kLinesOfAScale);
            static const QRegularExpression kScale(QStringLiteral(">\\s*([-0-9.]+) mm/s"));
            auto amounts = kScale.globalMatch(svg);
            const std::vector<QPointF> expected = expectedVectors(parameters, theta2, alpha2);
            for (const std::size_t polygon : {0U, 1U}) {
                const std::size_t count = polygon == 0 ? 2 : 4;
                std::vector<QLineF> vectors(components.begin() + (polygon == 0 ? 0 : 2),
                                            components.begin() + (polygon == 0 ? 2 : 6));
                vectors.push_back(sums[polygon]);
                const double pixelsPerUnit =
                    scales[kLinesOfAScale * polygon].length() / amounts.next().captured(1).toDouble();
                for (std::size_t i = 0; i <= count; ++i) {
                    const QPointF from = i == 0 || i == count ? vectors.front().p1() : vectors[i - 1].p2();
                    QVERIFY(QLineF(vectors[i].p1(), from).length() < kRounding);
                    const QPointF vector = expected[(polygon == 0 ? 0 : 3) + i];
                    const QPointF drawn(vectors[i].dx(), -vectors[i].dy());
                    const QPointF deviation = drawn - pixelsPerUnit * vector;
                    QVERIFY2(std::hypot(deviation.x(), deviation.y()) <
                                 2.0 * kRounding + 1e-5 * std::hypot(drawn.x(), drawn.y()),
                             qPrintable(QString("%1 %2 %3").arg(round).arg(i).arg(deviation.y())));
                }
                QVERIFY(QLineF(vectors[count - 1].p2(), vectors[count].p2()).length() < kRounding);
            }
        }
    }

    /// A former defect: in a figure of 85 mm the magnitudes were left out, and the scales of both polygons overlapped.
    void narrowPolygonsHaveMagnitudesAndScalesOfTheirOwn()
    {
        constexpr double kFigureMiddle = 160.5; // px: half of 321 px, the width of 85 mm at 96 pixels per inch
        const QTemporaryDir folder;
        const QString path = folder.filePath("polygons.svg");
        Session session;
        for (int round = 0; round < 50; ++round) {
            session.setParameters({.omega2 = std::pow(1.2, round)});
            session.setTime(0.05 * round / session.parameters().omega2);
            QCOMPARE(exportFigure(path, polygonSubject(session), {.width = 85.0}), std::nullopt);
            QFile file(path);
            QVERIFY(file.open(QIODevice::ReadOnly));
            const QString svg = QString::fromUtf8(file.readAll());
            const std::vector<QLineF> scales = linesIn(svg, kScaleWidth);
            QCOMPARE(scales.size(), 2 * kLinesOfAScale);
            const QLineF &barOfVelocities = scales[0];
            const QLineF &barOfAccelerations = scales[kLinesOfAScale];
            QVERIFY2(barOfVelocities.p1().x() > 0.0 && barOfVelocities.p2().x() < kFigureMiddle,
                     qPrintable(QString::number(round)));
            QVERIFY2(barOfAccelerations.p1().x() > kFigureMiddle && barOfAccelerations.p2().x() < 2.0 * kFigureMiddle,
                     qPrintable(QString::number(round)));
            QCOMPARE(svg.count("mm/s"), qsizetype(4)); // of both scales, and behind both lists of magnitudes
        }
    }

    /// A former defect: polygons in the window, which is lower than a figure, had no magnitudes.
    void lowPolygonsHaveTheirMagnitudesBesideThem()
    {
        struct Row {
            QSizeF area;
            bool hasMagnitudes;
        };
        const Polygons polygons = polygonsAt(Mechanism(), 0.2, 0.0);
        for (const Row &row : {Row{{740.0, 170.0}, true}, Row{{740.0, 400.0}, true}, Row{{300.0, 120.0}, false}}) {
            QBuffer svg;
            QSvgGenerator generator;
            generator.setOutputDevice(&svg);
            QPainter painter(&generator);
            drawPolygons(painter, {{0.0, 0.0}, row.area}, polygons, paletteFor(Theme::Light));
            painter.end();
            QCOMPARE(svg.data().count("mm/s"), row.hasMagnitudes ? 4 : 2); // of the scales, and of the magnitudes
            static const QRegularExpression kText("<text[^>]* x=\"([-0-9.]+)\" y=\"([-0-9.]+)\"");
            for (auto match = kText.globalMatch(QString::fromUtf8(svg.data())); match.hasNext();) {
                const QRegularExpressionMatch text = match.next();
                const QPointF place(text.captured(1).toDouble(), text.captured(2).toDouble());
                QVERIFY2(QRectF({0.0, 0.0}, row.area).contains(place), qPrintable(text.captured()));
            }
        }
    }

    /// A former defect: on a screen of 764×450 the polygons were 30 px high, with their names over each other.
    void polygonsAreLegibleAtTheirSmallestSize()
    {
        Session session;
        session.setParameters({.a = 35.56, .b = 101.6, .c = 25.4, .omega2 = 10.0});
        session.setTime(0.25 * std::numbers::pi / 10.0);
        session.setAlpha2(30.0);
        PolygonView view(&session);
        view.resize(view.minimumSizeHint().expandedTo({300, 0}));
        view.show();
        letTimePass(view);
        const QImage picture = view.grab().toImage().convertToFormat(QImage::Format_RGB32);
        const QRgb colour = seriesColours(view.palette()).acceleration.rgb();
        int top = picture.height();
        int bottom = 0;
        for (int y = 0; y < picture.height(); ++y) {
            for (int x = 0; x < picture.width(); ++x) {
                if (picture.pixel(x, y) == colour) {
                    top = std::min(top, y);
                    bottom = std::max(bottom, y);
                }
            }
        }
        constexpr int kLegible = 40; // px
        QVERIFY2(bottom - top >= kLegible, qPrintable(QString::number(bottom - top)));
    }

    /// A former defect: in a figure of half a column, two names stood so close that they read as one, "aBaBAᵗ".
    void namesInPolygonsStandApart()
    {
        constexpr double kGap = 3.0; // px
        const QSize size(302, 230);
        QFont font;
        font.setPixelSize(12);
        for (int degrees = 0; degrees < 360; degrees += 5) {
            const Mechanism mechanism(Parameters{.theta20 = degrees / kDegreesPerRadian});
            TextRecorder recorder(size);
            QPainter painter(&recorder);
            painter.setFont(font);
            drawPolygons(painter, QRectF({0.0, 0.0}, QSizeF(size)), polygonsAt(mechanism, 0.0, 3.0),
                         paletteFor(Theme::Light));
            painter.end();
            std::vector<QRectF> names; // each consists of a letter and its indices, which follow it
            bool isName = false;
            for (const auto &[text, box] : recorder.texts) {
                if (text == u"v" || text == u"a") {
                    names.push_back(box);
                    isName = true;
                } else if (isName && text.front().isLetter()) {
                    names.back() |= box;
                } else {
                    isName = false; // a magnitude or a scale
                }
            }
            QVERIFY(names.size() >= 6);
            for (std::size_t i = 0; i < names.size(); ++i) {
                for (std::size_t j = 0; j < i; ++j) {
                    QVERIFY2(!names[i].adjusted(-kGap, 0.0, kGap, 0.0).intersects(names[j]),
                             qPrintable(QStringLiteral("θ₂ = %1°").arg(degrees)));
                }
            }
        }
    }

    void designsInTheChosenUnits()
    {
        const auto restore = qScopeGuard([] { setNotation({}); });
        ShownDesign shown;
        setNotation({.units = {LengthUnit::Inch, AngleUnit::Radian}});
        emit shown.session.resultChanged(shown.session.result()); // as the window does
        const auto *angle = child<NumberBox>(shown.form, "designTransmissionAngle");
        const auto *stroke = child<NumberBox>(shown.form, "designStroke");
        QVERIFY(angle->suffix() == " rad" && stroke->suffix() == " in");
        QCOMPARE(angle->value(), shown.limits().coupler.minimumTransmissionAngle.angle);
        QVERIFY(std::abs(25.4 * stroke->value() - *shown.limits().stroke) < 1e-9);
        shown.type("designTransmissionAngle", "1.5"); // 86°
        QVERIFY(!shown.refusal().isEmpty());
    }

    void designsFromAMechanismThatCannotBeAssembled()
    {
        ShownDesign shown;
        shown.session.setParameters({20.0, 4.0, 25.0}); // b < |c| - a
        QVERIFY(!child<NumberSlider>(shown.form, "designRatio")->isEnabled());
        shown.type("designStroke", "30");
        QVERIFY(std::abs(*shown.limits().stroke - 30.0) < 1e-10 && shown.limits().mobility == Mobility::FullTurn);
    }
};

const Suite<TestLimitsPanel> suite("tst_limits_panel");

} // namespace tst_limits_panel

#include "tst_limits_panel.moc"
