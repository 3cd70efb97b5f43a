// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/plot_figure.h"

#include "core/closed_form/closed_form.h"
#include "ui/document/session.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

using namespace slidercrank;

namespace
{

constexpr double kDegree = 180.0 / std::numbers::pi;
constexpr QSize kAxes(300, 150);

Parameters withCoupler(double b)
{
    Parameters parameters;
    parameters.b = b;
    return parameters;
}

/// The motion of another mechanism at 51 time stamps, as if a file had been read: all channels or the first ones.
std::shared_ptr<Reference> referenceOf(const Parameters &parameters, std::size_t channels = kPlottedChannels.size())
{
    Session session;
    session.setSampling({0.0, 1.0, 50});
    session.setParameters(parameters);
    const Trajectory &trajectory = session.result()->trajectory;
    auto reference = std::make_shared<Reference>();
    reference->name = QStringLiteral("simulation.csv");
    reference->data.time = trajectory.time;
    for (std::size_t i = 0; i < channels; ++i) {
        reference->data.series.push_back({kPlottedChannels[i], trajectory[kPlottedChannels[i]], {}});
    }
    return reference;
}

struct Shown {
    Parameters model = withCoupler(60.0);
    std::shared_ptr<const Reference> reference = {};
    std::vector<Parameters> pinned = {};
    Sampling sampling = {};
    Method method = Method::ClosedForm;
};

PlotFigure figureOf(const Shown &shown)
{
    SolverSettings solver;
    solver.method = shown.method;
    PlotFigure figure;
    figure.setResult(compute({Mechanism(shown.model), shown.sampling, solver, shown.reference, shown.pinned}, {}));
    return figure;
}

std::size_t plotAt(std::size_t row, std::size_t column)
{
    return row * kPlotColumns + column;
}

std::size_t gapsIn(const std::vector<CurvePoint> &points)
{
    return static_cast<std::size_t>(
        std::ranges::count_if(points, [](const CurvePoint &point) { return std::isnan(point.value); }));
}

PlotSettings settingsWith(ErrorMeasure measure, bool isLogarithmic = false)
{
    PlotSettings settings;
    settings.error = measure;
    settings.logarithmicError = isLogarithmic;
    return settings;
}

} // namespace

class TestPlotFigure : public QObject
{
    Q_OBJECT

private slots:
    void errorsAreInPercentOfThePeakUnlessChosenOtherwise()
    {
        // The textbook's formulas at t = 0: θ³ = asin(25/b), Rₓ⁴ = 20 + √(b² − 25²). Peaks: θ³ = asin(45/b) at 270°;
        // Rₓ⁴ where crank and coupler are in line, √((20 + b)² − 25²).
        const auto start = [](double b) {
            return std::array{std::asin(25.0 / b) * kDegree, 20.0 + std::sqrt(b * b - 625.0)};
        };
        const std::array model = start(60.0);
        const std::array reference = start(65.0);
        const std::array peak{std::asin(45.0 / 65.0) * kDegree, std::sqrt(85.0 * 85.0 - 625.0)};
        struct Row {
            PlotSettings settings;
            std::function<double(std::size_t)> expected;
        };
        const auto difference = [&](std::size_t i) { return std::abs(model[i] - reference[i]); };
        const auto ofPeak = [&](std::size_t i) { return 100.0 * difference(i) / peak[i]; };
        const auto pointwise = [&](std::size_t i) { return 100.0 * difference(i) / reference[i]; };
        const std::vector<Row> rows{
            {PlotSettings(), ofPeak},
            {settingsWith(ErrorMeasure::Percent), pointwise},
            {settingsWith(ErrorMeasure::Absolute), difference},
            {settingsWith(ErrorMeasure::Percent, true), [&](std::size_t i) { return std::log10(pointwise(i)); }},
            {settingsWith(ErrorMeasure::OfPeak, true), [&](std::size_t i) { return std::log10(ofPeak(i)); }}};
        for (const Row &row : rows) {
            for (const bool isPinned : {false, true}) {
                PlotFigure figure = figureOf(isPinned ? Shown{.pinned = {withCoupler(65.0)}}
                                                      : Shown{.reference = referenceOf(withCoupler(65.0))});
                figure.setSettings(row.settings);
                const PlotPicture picture = figure.picture(plotAt(0, kErrorColumn), kAxes);
                const std::vector<PlotReading> readings =
                    figure.readings(plotAt(0, kErrorColumn), figure.readTime(0.0));
                QCOMPARE(readings.size(), kChannelsPerRow);
                for (std::size_t i = 0; i < kChannelsPerRow; ++i) {
                    const double expected = row.expected(i);
                    constexpr double kPeakIsSampled = 2e-3; // of 51 samples none is just at the peak
                    QVERIFY(std::abs(readings[i].value - expected) <= kPeakIsSampled * std::abs(expected));
                    QVERIFY(picture.values.contains(readings[i].value));
                    const double drawn = picture.curves[i].points.front().value;
                    QVERIFY(std::abs(drawn - expected) <= kPeakIsSampled * std::abs(expected));
                }
            }
        }
    }

    void anUndefinedErrorIsAGapWithAMark()
    {
        const std::shared_ptr<Reference> reference = referenceOf(withCoupler(65.0));
        constexpr std::size_t kZero = 20;
        constexpr std::size_t kNearlyZero = 30;
        reference->data.series[0].values[kZero] = 0.0;
        reference->data.series[0].values[kNearlyZero] = 1e-15; // beside a peak of 40: a zero within rounding
        PlotFigure figure = figureOf({.reference = reference});
        figure.setSettings(settingsWith(ErrorMeasure::Percent));
        const PlotPicture picture = figure.picture(plotAt(0, kErrorColumn), kAxes);
        const std::vector<double> &time = reference->data.time;
        QCOMPARE(picture.curves[0].marks, (std::vector{time[kZero], time[kNearlyZero]}));
        QCOMPARE(gapsIn(picture.curves[0].points), std::size_t(2));
        QCOMPARE(gapsIn(picture.curves[1].points), std::size_t(0));
        QVERIFY(picture.values.upper < 1000.0);
        figure.setSettings(PlotSettings());
        QCOMPARE(gapsIn(figure.picture(plotAt(0, kErrorColumn), kAxes).curves[0].points), std::size_t(0));

        std::ranges::fill(reference->data.series[0].values, 0.0);
        reference->data.series.resize(1);
        PlotFigure zeros = figureOf({.reference = reference});
        zeros.setSettings(settingsWith(ErrorMeasure::Percent));
        QCOMPARE(zeros.picture(plotAt(0, kErrorColumn), kAxes).note, QStringLiteral("undefined: the reference is 0"));
        QCOMPARE(zeros.picture(plotAt(1, kErrorColumn), kAxes).note, QStringLiteral("not in the file"));
    }

    void everyPlotSaysThatTheMechanismCannotBeAssembled()
    {
        const QString missing = QStringLiteral("the mechanism cannot be assembled");
        for (const ErrorMeasure measure : {ErrorMeasure::OfPeak, ErrorMeasure::Percent, ErrorMeasure::Absolute}) {
            for (const Shown &shown : {Shown{withCoupler(1.0)}, Shown{withCoupler(1.0), referenceOf(Parameters())},
                                       Shown{withCoupler(1.0), nullptr, {Parameters()}}}) {
                PlotFigure figure = figureOf(shown);
                figure.setSettings(settingsWith(measure));
                for (std::size_t plot = 0; plot < kPlotCount; ++plot) {
                    if (!isErrorPlot(plot) || figure.hasErrors()) {
                        QCOMPARE(figure.picture(plot, kAxes).note, missing);
                    }
                }
            }
        }
        QCOMPARE(figureOf({.pinned = {withCoupler(60.0)}}).picture(plotAt(0, kErrorColumn), kAxes).note,
                 QStringLiteral("no difference"));
        PlotFigure whole = figureOf({.reference = referenceOf(Parameters())});
        for (std::size_t plot = 0; plot < kPlotCount; ++plot) {
            QVERIFY(whole.picture(plot, kAxes).note.isEmpty());
        }
    }

    void aFileWithoutAChannelLeavesThatPlotToTheModel()
    {
        PlotFigure figure = figureOf({.reference = referenceOf(withCoupler(65.0), 1)});
        QVERIFY(!figure.picture(0, kAxes).curves.back().points.empty());
        const PlotPicture slider = figure.picture(1, kAxes);
        QCOMPARE(slider.note, QStringLiteral("not in the file"));
        QVERIFY(!slider.curves.front().points.empty() && slider.curves.back().points.empty());
        const std::vector<PlotReading> readings = figure.readings(1, figure.readTime(0.0));
        QCOMPARE(readings.size(), std::size_t(1));
        QVERIFY(std::abs(readings[0].number - 20.0 - std::sqrt(60.0 * 60.0 - 625.0)) < 1e-9);
    }

    void rocksWithGapsAtMostAsManyPointsAsPixels()
    {
        for (const int steps : {200, 20000}) {
            for (const Method method : {Method::ClosedForm, Method::Newton}) {
                PlotFigure figure =
                    figureOf({.model = withCoupler(30.0), .sampling = {0.0, 1.0, steps}, .method = method});
                const std::vector<CurvePoint> points = figure.picture(0, kAxes).curves.front().points;
                QVERIFY(gapsIn(points) >= 1 && gapsIn(points) < points.size() / 2);
                QVERIFY(points.size() <= 2 * static_cast<std::size_t>(kAxes.width()) + 8);
                QVERIFY(points.size() >= 20);
            }
        }
    }

    void timeMayRunBackwards()
    {
        for (const Method method : {Method::ClosedForm, Method::Newton}) {
            PlotFigure backwards = figureOf({.sampling = {1.0, -1.0, 400}, .method = method});
            PlotFigure forwards = figureOf({.sampling = {0.0, 1.0, 400}, .method = method});
            for (const double t : {0.1, 0.35, 0.8}) {
                for (std::size_t plot : {0, 1, 3, 4, 6, 7}) {
                    const double one = backwards.readings(plot, backwards.readTime(t)).front().value;
                    const double other = forwards.readings(plot, forwards.readTime(t)).front().value;
                    QVERIFY(std::abs(one - other) <= 1e-6 * std::max(1.0, std::abs(other)));
                }
            }
            QVERIFY(std::ranges::is_sorted(backwards.picture(0, kAxes).curves[0].points, {}, &CurvePoint::t));
        }
    }

    void valuesFitTheTimeOnShow()
    {
        for (const int steps : {0, 400, 8}) { // of Newton-Raphson; 0: closed form
            PlotFigure figure = figureOf({.reference = referenceOf(withCoupler(65.0)),
                                          .sampling = {0.0, 1.0, std::max(steps, 1)},
                                          .method = steps > 0 ? Method::Newton : Method::ClosedForm});
            const Interval whole = figure.picture(1, kAxes).values;
            for (const Interval &time : {Interval{0.3, 0.4}, Interval{0.55, 0.62}, Interval{0.81, 0.83}}) {
                double least = 1e9;
                double most = -1e9;
                for (int i = 0; i <= 1000; ++i) { // Rₓ⁴ = a cos θ₂ + √(b² − (c − a sin θ₂)²)
                    const double angle = 2.0 * std::numbers::pi * (time.lower + time.length() * i / 1000.0);
                    for (const double b : {60.0, 65.0}) {
                        const double height = 25.0 - 20.0 * std::sin(angle);
                        const double value = 20.0 * std::cos(angle) + std::sqrt(b * b - height * height);
                        least = std::min(least, value);
                        most = std::max(most, value);
                    }
                }
                figure.zoomTime(time);
                const Interval seen = figure.picture(1, kAxes).values;
                const double chord = steps == 8 ? 4.0 : 0.1; // mm between eight samples' lines and the motion
                QVERIFY(seen.lower <= least + chord && seen.upper >= most - chord);
                QVERIFY(seen.length() < 1.5 * (most - least) + 4.0 * chord && seen.length() < 0.8 * whole.length());
            }
            figure.zoomValues(1, {10.0, 20.0}); // chosen values stay, whatever the time on show
            figure.zoomTime({0.5, 0.6});
            QCOMPARE(figure.picture(1, kAxes).values, (Interval{10.0, 20.0}));
        }
    }

    void titlesNameAndExplainTheSymbolsWhichGoFirst()
    {
        PlotFigure figure = figureOf({});
        const QStringList velocity = figure.picture(3, kAxes).titles;
        QCOMPARE(velocity,
                 (QStringList{"coupler angular velocity ω³ = dθ³/dt [°/s]", "coupler angular velocity ω³ [°/s]",
                              "coupler angular velocity [°/s]", "velocity [°/s]"}));
        QVERIFY(figure.picture(7, kAxes).titles.first().startsWith(QStringLiteral("slider acceleration a⁴ = dv⁴/dt")));
        QCOMPARE(figure.picture(0, kAxes).titles.first(), QStringLiteral("coupler angle θ³ [°]"));
    }

    void whatIsReadWithAFileIsReadAtItsTimeStamps()
    {
        const std::shared_ptr<Reference> reference = referenceOf(withCoupler(65.0));
        for (const Method method : {Method::ClosedForm, Method::Newton}) {
            PlotFigure figure = figureOf({.reference = reference, .method = method});
            figure.setSettings(settingsWith(ErrorMeasure::Absolute));
            const ReadTime time = figure.readTime(0.3333);
            QCOMPARE(time.t, reference->data.time[17]);
            for (std::size_t row = 0; row < kPlotRows; ++row) {
                const std::vector<PlotReading> errors = figure.readings(plotAt(row, kErrorColumn), time);
                for (std::size_t column = 0; column < kErrorColumn; ++column) {
                    const std::vector<PlotReading> values = figure.readings(plotAt(row, column), time);
                    QCOMPARE(values.size(), std::size_t(2));
                    QCOMPARE(errors[column].number, std::abs(values[0].number - values[1].number));
                }
            }
            QVERIFY(!figureOf({.reference = reference, .sampling = {0.0, 2.0, 200}}).readTime(1.7).row);
        }
    }

    void overTheCrankAngleEverythingIsReadInDegrees()
    {
        Parameters parameters = withCoupler(60.0);
        parameters.omega2 = -2.0 * std::numbers::pi;
        parameters.theta20 = 0.5 * std::numbers::pi;
        PlotFigure figure = figureOf({parameters});
        QCOMPARE(figure.timeText(0.25), QStringLiteral("t = 0.25 s"));
        QCOMPARE(figure.durationText(0.5), QStringLiteral("0.5 s"));
        PlotSettings settings;
        settings.abscissa = Abscissa::CrankAngle;
        figure.setSettings(settings);
        QCOMPARE(figure.timeText(0.5), QStringLiteral("θ₂ = -90°"));
        QCOMPARE(figure.durationText(0.5), QStringLiteral("-180°"));
        const TimeAxis axis = figure.timeAxis(600.0, 6.0);
        QCOMPARE(axis.zero, 0.25); // θ₂ is 0 a quarter of a second after it was 90°
        QVERIFY(std::abs(axis.perUnit + 1.0 / 360.0) < 1e-12);
        QCOMPARE(axis.title, QStringLiteral("θ₂ [°]"));
    }

    void inPresentationModeMotionsAreEqualAndNamedByWhatDiffers()
    {
        PlotFigure figure = figureOf({.model = withCoupler(146.0), .pinned = {withCoupler(65.0), withCoupler(80.0)}});
        const auto curves = [&] { return figure.picture(1, kAxes).curves; };
        QVERIFY(curves()[0].width < curves().back().width);
        QVERIFY(figure.hasErrors());
        figure.setPresentation(true);
        QVERIFY(!figure.hasErrors());
        QStringList names;
        for (const PlotCurve &curve : curves()) {
            QCOMPARE(curve.width, curves().back().width);
            names << curve.name;
        }
        QCOMPARE(names, (QStringList{"b = 65 mm", "b = 80 mm", "b = 146 mm"}));
    }

    void aPinnedCurveIsAsTrueAsTheModels()
    {
        struct Row {
            double duration;
            Interval time;
            double b;
        };
        for (const auto &[duration, time, b] :
             {Row{1.0, {0.0, 1.0}, 80.0}, Row{1.0, {0.23, 0.26}, 80.0}, Row{1000.0, {0.0, 1000.0}, 80.0},
              Row{1000.0, {700.0, 700.5}, 80.0}, Row{1.0, {0.0, 1.0}, 40.0}}) {
            PlotFigure figure = figureOf({.pinned = {withCoupler(b)}, .sampling = {0.0, duration, 7}});
            PlotFigure swapped =
                figureOf({.model = withCoupler(b), .pinned = {withCoupler(60.0)}, .sampling = {0.0, duration, 7}});
            figure.zoomTime(time);
            swapped.zoomTime(time);
            for (const std::size_t plot : {0, 1, 3, 4, 6, 7}) {
                const std::vector<CurvePoint> points = figure.picture(plot, kAxes).curves.front().points;
                const std::vector<CurvePoint> wanted = swapped.picture(plot, kAxes).curves.back().points;
                QVERIFY(!points.empty() && std::ranges::equal(points, wanted, [](const auto &p, const auto &q) {
                    return p.t == q.t && (p.value == q.value || (std::isnan(p.value) && std::isnan(q.value)));
                }));
            }
            const ClosedForm motions[]{ClosedForm(Mechanism(withCoupler(60.0))), ClosedForm(Mechanism(withCoupler(b)))};
            const PlotPicture errors = figure.picture(plotAt(0, kErrorColumn), kAxes);
            const double peak = figure.result()->difference->channels[1].peak;
            for (const CurvePoint &point : errors.curves[1].points) {
                const double expected =
                    100.0 / peak * std::abs(motions[0].motionAt(point.t).R4x - motions[1].motionAt(point.t).R4x);
                QVERIFY(std::isnan(point.value) || std::abs(point.value - expected) <= 1e-6 * errors.values.upper);
            }
        }
    }

    void tooFewSamplesAreSaidWithTheNumberThatWouldDo()
    {
        Parameters parameters = withCoupler(65.0);
        parameters.omega2 = 2.0 * std::numbers::pi * 50.0;
        const auto nameAt = [&](Method method, int steps) {
            return figureOf({.model = parameters, .sampling = {0.0, 1.0, steps}, .method = method})
                .picture(0, kAxes)
                .curves.front()
                .name;
        };
        QCOMPARE(nameAt(Method::Newton, 200),
                 QStringLiteral("4 samples a turn are too few for a curve: 1,000 steps would do."));
        QCOMPARE(nameAt(Method::Newton, 1000), QStringLiteral("model"));
        QCOMPARE(nameAt(Method::ClosedForm, 2), QStringLiteral("model"));
    }
};

QTEST_GUILESS_MAIN(TestPlotFigure)
#include "tst_plot_figure.moc"
