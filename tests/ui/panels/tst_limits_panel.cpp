// SPDX-License-Identifier: GPL-3.0-or-later

// Through the window: the response of the limits to a parameter, and the design for a stroke and a time ratio.

#include "core/limits/design.h"
#include "core/limits/extremes.h"
#include "tests/support/suite.h"
#include "ui/document/with.h"
#include "ui/panels/limits_panel.h"
#include "ui/panels/parameter_panel.h"
#include "ui/panels/response_chart.h"
#include "ui/widgets/number_box.h"
#include "ui/widgets/number_slider.h"
#include "ui/window/main_window.h"

#include "tests/support/waiting.h"
#include "tests/support/widget_parts.h"

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QMenuBar>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>

#include <algorithm>
#include <cmath>
#include <random>

using namespace slidercrank;

namespace
{

constexpr std::size_t kStroke = 0, kRatio = 1, kAngle = 2, kSpeed = 3, kAcceleration = 4;

/// Compares two values; NaN equals NaN.
bool isSame(double first, double second)
{
    return first == second || (std::isnan(first) && std::isnan(second));
}

/// Computes the limits directly from the core.
LimitValues expectedLimits(const Parameters &parameters)
{
    LimitValues expected{kNone, kNone, kNone, kNone, kNone};
    const Mechanism mechanism(parameters);
    const MotionLimits limits = motionLimits(mechanism);
    expected[kStroke] = limits.stroke.value_or(kNone);
    if (limits.mobility == Mobility::FullTurn) {
        const std::vector<Peak> peaks = motionPeaks(mechanism); // slider velocity and acceleration come first
        expected = {*limits.stroke, *limits.timeRatio, 90.0 - kDegreesPerRadian * limits.largestPressureAngle, peaks[0].magnitude,
                    peaks[1].magnitude};
    }
    return expected;
}

/// A shown window with empty settings.
struct Shown {
    MainWindow window;
    LimitsPanel *limits = child<LimitsPanel>(window, "limits");
    ResponseView *view = child<ResponseView>(window, "responseView");

    Shown()
    {
        window.resize(1400, 900);
        window.show();
        finishAside();
    }

    Session &session() { return window.session(); }
    MotionLimits motion() { return session().result()->limits; }

    const Response &respond(Parameter parameter)
    {
        limits->showResponse(parameter);
        finish();
        return view->response();
    }

    /// Waits for the curves, which are computed in the background.
    void finish()
    {
        settle(window);
        finishAside();
    }

    ResponseChart *chart(std::size_t limit) { return child<ResponseChart>(window, QStringLiteral("responseChart%1").arg(limit)); }

    void showDesign()
    {
        limits->setCurrent(2);
        settle(window);
    }

    void type(const QString &box, const QString &text) { typeNumber(child<NumberBox>(window, box), text); }
    QString refusal() { return child<QLabel>(window, "designRefusal")->text(); }
};

/// Returns the position of the dot at the current value.
QPointF presentDot(ResponseChart &chart)
{
    return chart.positionOf(chart.dots()[0]);
}

} // namespace

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
            const ResponseRange range = responseRange(parameters, parameter);
            const Response response = computeResponse(parameters, parameter, range, 20);
            QCOMPARE(response.values.front(), range.assembled.lower);
            QCOMPARE(response.values.back(), range.assembled.upper);
            for (std::size_t k = 0; k < response.values.size(); ++k) {
                Parameters varied = parameters;
                valueOf(varied, parameter) = response.values[k];
                const LimitValues expected = expectedLimits(varied);
                QVERIFY(std::ranges::equal(response.limits[k], expected, isSame));
                const bool turns = motionLimits(Mechanism(varied)).mobility == Mobility::FullTurn;
                const double slack = 1e-12 * range.assembled.length(); // the ends have a rounding error
                const Interval &fullTurn = range.fullTurn;
                if (turns) {
                    ++fullTurns;
                    QVERIFY(fullTurn.lower - slack <= response.values[k] && response.values[k] <= fullTurn.upper + slack);
                } else {
                    QVERIFY(!(fullTurn.lower + slack <= response.values[k] && response.values[k] <= fullTurn.upper - slack));
                }
            }
        }
        QVERIFY(fullTurns > 200);
    }

    void containsTheEndsOfTheRanges()
    {
        const Parameters table1; // 20, 65, 25
        struct Row {
            Parameters parameters;
            Parameter parameter;
            ResponseRange range;
        };
        for (const Row &row : {Row{table1, Parameter::A, {{kShortestLink, 60.0}, {kShortestLink, 40.0}}},
                               Row{table1, Parameter::B, {{5.0, 135.0}, {45.0, kLargestParameter}}},
                               Row{table1, Parameter::C, {{-85.0, 85.0}, {-45.0, 45.0}}},
                               Row{table1, Parameter::Omega2, {{-10.0, 10.0}, {-10.0, 10.0}}},
                               Row{with(table1, &Parameters::b, 200.0), Parameter::B, {{5.0, 250.0}, {45.0, kLargestParameter}}}}) {
            const ResponseRange range = responseRange(row.parameters, row.parameter);
            QCOMPARE(range.assembled, row.range.assembled);
            QCOMPARE(range.fullTurn, row.range.fullTurn);
            const Response response = computeResponse(row.parameters, row.parameter, range, 10);
            for (const double end : {range.assembled.lower, range.fullTurn.lower, range.fullTurn.upper, range.assembled.upper}) {
                QVERIFY(end == kLargestParameter || std::ranges::binary_search(response.values, end));
            }
        }
        QVERIFY(responseRange({20.0, 20.0, 25.0}, Parameter::A).fullTurn.length() < 0.0); // no crank makes full turns
    }

    void showsTheResponseFromAParameterNameOrTheMenu()
    {
        Shown shown;
        QVERIFY(!shown.view->isVisible());
        emit shown.window.findChild<ParameterPanel *>()->responseRequested(Parameter::B);
        shown.finish();
        QVERIFY(shown.view->isVisible());
        QCOMPARE(shown.view->response().parameter, Parameter::B);
        QVERIFY(static_cast<int>(shown.view->response().values.size()) >= shown.chart(kStroke)->width());
        for (QMenu *menu : shown.window.menuBar()->findChildren<QMenu *>()) {
            if (menu->title().remove(u'&').startsWith("Response")) {
                QCOMPARE(menu->actions().size(), 4);
                menu->actions()[2]->trigger();
            }
        }
        shown.finish();
        QCOMPARE(shown.view->response().parameter, Parameter::C);
    }

    void changesTheParameterByDraggingTheDot()
    {
        Shown shown;
        const Response before = shown.respond(Parameter::B);
        ResponseChart *chart = shown.chart(kSpeed);
        const QPointF from = presentDot(*chart);
        const int steps = shown.session().undoStack().count();
        QTest::mousePress(chart, Qt::LeftButton, {}, from.toPoint());
        for (int x = 1; x <= 20; ++x) {
            QTest::mouseMove(chart, from.toPoint() + QPoint(x, 0));
        }
        QTest::mouseRelease(chart, Qt::LeftButton, {}, from.toPoint() + QPoint(20, 0));
        const double b = shown.session().parameters().b;
        const double pixel = before.range.assembled.length() / (chart->positionOf({135.0, {}}) - chart->positionOf({5.0, {}})).x();
        QVERIFY2(std::abs(b - (65.0 + 20.0 * pixel)) <= 1.1 * pixel, qPrintable(QString::number(b)));
        QCOMPARE(shown.session().undoStack().count(), steps + 1);
        for (const std::size_t limit : {kStroke, kAngle, kAcceleration}) {
            const ResponseChart::Dot &dot = shown.chart(limit)->dots()[0];
            QCOMPARE(dot.value, b);
            QCOMPARE(dot.limits[limit], expectedLimits(shown.session().parameters())[limit]);
        }
        QCOMPARE(shown.view->response().values, before.values); // the curves do not depend on this value
        shown.session().undoStack().undo();
        QCOMPARE(shown.session().parameters(), Parameters());
    }

    void movesTheDotWithKeysWithinItsRange()
    {
        Shown shown;
        shown.respond(Parameter::B);
        ResponseChart *chart = shown.chart(kStroke);
        chart->setFocus();
        QTest::keyClick(chart, Qt::Key_Right);
        QCOMPARE(shown.session().parameters().b, 65.5);
        QTest::keyClick(chart, Qt::Key_PageDown);
        QCOMPARE(shown.session().parameters().b, 60.5);
        for (int i = 0; i < 20; ++i) {
            QTest::keyClick(chart, Qt::Key_PageDown);
        }
        QCOMPARE(shown.session().parameters().b, 5.0); // |c| - a: it can just be assembled
    }

    void recomputesTheCurvesAndShowsPinnedMotionsAsDots()
    {
        Shown shown;
        shown.respond(Parameter::B);
        shown.session().pinMotion();
        shown.session().setParameter(Parameter::A, 30.0);
        shown.finish();
        QCOMPARE(shown.view->response().parameters.a, 30.0);
        const Response &response = shown.view->response();
        const std::vector<QPointF> &curve = shown.chart(kRatio)->content().series[1].points;
        for (std::size_t k = 0; k < curve.size(); ++k) {
            Parameters varied = shown.session().parameters();
            varied.b = response.values[k];
            QVERIFY(isSame(curve[k].y(), expectedLimits(varied)[kRatio]));
        }
        const ResponseChart::Dot &pinned = shown.chart(kRatio)->dots()[1];
        QCOMPARE(pinned.value, 65.0);
        QCOMPARE(pinned.limits[kRatio], expectedLimits({})[kRatio]);
    }

    void exportsTheChartsAndTheNumbersOfTheCurves()
    {
        Shown shown;
        const Response &response = shown.respond(Parameter::C);
        QTemporaryDir folder;
        for (const char *name : {"r.png", "r.svg", "r.pdf", "r.csv"}) {
            QVERIFY(!shown.view->exportTo(folder.filePath(name)));
            QVERIFY(QFile(folder.filePath(name)).size() > 1000);
        }
        QVERIFY(shown.view->exportTo("/no/such/folder/r.png"));
        QFile file(folder.filePath("r.csv"));
        QVERIFY(file.open(QFile::ReadOnly));
        const QList<QByteArray> lines = file.readAll().trimmed().split('\n');
        QCOMPARE(lines[0], QByteArray("c,stroke,time-ratio,least-transmission-angle,peak-slider-speed,peak-slider-acceleration"));
        QCOMPARE(lines.size() - 1, static_cast<qsizetype>(response.values.size()));
        const QList<QByteArray> cells = lines[lines.size() / 2].split(',');
        const std::size_t middle = static_cast<std::size_t>(lines.size() / 2 - 1);
        QCOMPARE(cells[0].toDouble(), response.values[middle]);
        QCOMPARE(cells[5].toDouble(), response.limits[middle][kAcceleration]);
        QVERIFY(lines[1].endsWith(",,,,")); // in the locked mechanism only the stroke exists
        child<QToolButton>(shown.window, "responseCopy")->click();
        QVERIFY(!QApplication::clipboard()->image().isNull());
    }

    void scalesTheMechanismToAGivenStroke()
    {
        Shown shown;
        shown.showDesign();
        const double stroke = *shown.motion().stroke;
        shown.type("designStroke", "100");
        const Parameters &scaled = shown.session().parameters();
        QVERIFY(std::abs(*shown.motion().stroke - 100.0) < 1e-12 * 100.0);
        QVERIFY(std::abs(scaled.a / 20.0 / (100.0 / stroke) - 1.0) < 1e-14);
        QVERIFY(std::abs(scaled.b / scaled.a / 3.25 - 1.0) < 1e-14 && std::abs(scaled.c / scaled.a / 1.25 - 1.0) < 1e-14);
        QCOMPARE(shown.session().undoStack().count(), 1);
        shown.session().undoStack().undo();
        QCOMPARE(shown.session().parameters(), Parameters());
    }

    void designsForATimeRatioWithTheSliderForTheRatioOfLengths()
    {
        Shown shown;
        shown.showDesign();
        shown.type("designStroke", "80");
        letTimePass(shown.session()); // otherwise both edits would form one undo step
        shown.type("designTimeRatio", "1.4");
        QCOMPARE(shown.session().undoStack().count(), 2); // a, b and c in one step each
        const auto isDesigned = [&](double ratio) {
            return std::abs(*shown.motion().stroke / 80.0 - 1.0) < 1e-12 && std::abs(*shown.motion().timeRatio / ratio - 1.0) < 1e-12;
        };
        QVERIFY(isDesigned(1.4));
        const double best = shown.motion().largestPressureAngle;
        QCOMPARE(static_cast<float>(shown.session().parameters().b / shown.session().parameters().a),
                 static_cast<float>(findDesignRange(1.4)->bestRatio));
        auto *slider = child<NumberSlider>(shown.window, "designRatio");
        slider->setSliderDown(true);
        for (const int position : {slider->minimum(), slider->maximum() / 3, slider->maximum()}) {
            slider->setValue(position);
            QVERIFY(isDesigned(1.4));
            QVERIFY(shown.motion().mobility == Mobility::FullTurn && shown.motion().largestPressureAngle > best);
        }
        slider->setSliderDown(false);
        QCOMPARE(shown.session().undoStack().count(), 3);
        child<QToolButton>(shown.window, "designBest")->click();
        QVERIFY(std::abs(shown.motion().largestPressureAngle - best) < 1e-12);
        shown.type("designTimeRatio", "0.5"); // forward and return stroke exchanged
        QVERIFY(isDesigned(2.0) && shown.session().parameters().c < 0.0);
        shown.type("designTimeRatio", "1.5"); // the strokes remain exchanged
        QVERIFY(isDesigned(1.5) && shown.session().parameters().c < 0.0);
    }

    void refusesAnImpossibleRequestWithItsBound()
    {
        Shown shown;
        shown.showDesign();
        shown.type("designTimeRatio", "3.5");
        QVERIFY2(shown.refusal().contains("below 3") && shown.refusal().contains("3.5"), qPrintable(shown.refusal()));
        QCOMPARE(shown.session().parameters(), Parameters());
        QCOMPARE(shown.session().undoStack().count(), 0);
        QCOMPARE(child<NumberBox>(shown.window, "designTimeRatio")->value(), *shown.motion().timeRatio);
        shown.type("designTimeRatio", "1.5");
        QVERIFY(shown.refusal().isEmpty());
        shown.type("designTransmissionAngle", "70");
        const std::variant<Lengths, DesignFault> designed = design({*shown.motion().stroke, 1.5, 70.0 / kDegreesPerRadian});
        const DesignFault &fault = std::get<DesignFault>(designed);
        const QString bound = QString::number(fault.bound * kDegreesPerRadian, 'g', 4);
        QVERIFY2(shown.refusal().contains(bound + u'°') && shown.refusal().contains(QString::number(fault.timeRatioBound, 'g', 4)),
                 qPrintable(shown.refusal()));
        shown.session().setParameter(Parameter::B, 60.0); // another edit removes the message
        QVERIFY(shown.refusal().isEmpty());
    }

    void designsFromAMechanismThatCannotBeAssembled()
    {
        Shown shown;
        shown.session().setParameters({20.0, 4.0, 25.0}); // b < |c| - a
        shown.showDesign();
        QVERIFY(!child<NumberSlider>(shown.window, "designRatio")->isEnabled());
        shown.type("designStroke", "30");
        QVERIFY(std::abs(*shown.motion().stroke - 30.0) < 1e-10 && shown.motion().mobility == Mobility::FullTurn);
    }
};

const Suite suite("tst_limits_panel", runWithWidgets<TestLimitsPanel>);
#include "tst_limits_panel.moc"
