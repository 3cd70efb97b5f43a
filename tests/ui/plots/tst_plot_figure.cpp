// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/plot_figure.h"

#include "tests/support/pixels.h"
#include "tests/support/suite.h"
#include "tests/support/text_recorder.h"
#include "tests/ui/plots/plot_results.h"
#include "ui/plots/plot_cursor.h"
#include "ui/plots/plot_drawing.h"
#include "ui/plots/plot_grid.h"
#include "ui/text/written_number.h"

#include <QPainter>
#include <QScopeGuard>
#include <QSet>
#include <QTest>

#include <algorithm>

using namespace slidercrank;

namespace tst_plot_figure
{

// The plots are numbered row by row.
constexpr std::size_t kCouplerAngle = 0;
constexpr std::size_t kSliderPosition = 1;
constexpr std::size_t kPositionErrors = 2;
constexpr std::size_t kCouplerVelocity = 3;
constexpr std::size_t kVelocityErrors = 5;
constexpr std::size_t kSliderAcceleration = 7;
constexpr std::size_t kAccelerationErrors = 8;
const std::vector<std::size_t> kAllPlots{0, 1, 2, 3, 4, 5, 6, 7, 8};

/// Returns a figure that exists until the next call.
PlotFigure &figureOf(const PlotInput &shown)
{
    static std::unique_ptr<PlotFigure> figure;
    figure = std::make_unique<PlotFigure>();
    figure->setResult(resultOf(shown));
    return *figure;
}

/// Composes the figure with this plot alone, and returns the plot.
const Plot &plotOf(PlotFigure &figure, std::size_t plot)
{
    figure.compose({{plot}, QFont(), paletteFor(Theme::Light)}, {360, 200});
    return figure.shownPlot(plot);
}

std::vector<PlotReading> readingsOf(PlotFigure &figure, std::size_t plot, double t)
{
    plotOf(figure, plot);
    return figure.readings(plot, figure.readTime(t));
}

std::ptrdiff_t gapsIn(const std::vector<CurvePoint> &points)
{
    return std::ranges::count_if(points, [](const CurvePoint &point) { return std::isnan(point.value); });
}

/// Returns a curve of an error plot: the coupler's has the colour `couplerError`, the slider's `sliderError`.
const PlotCurve &curveIn(const Plot &plot, Ink ink)
{
    return *std::ranges::find(plot.curves, ink, &PlotCurve::ink);
}

constexpr std::array<Ink, 2> kErrorInks{&SeriesColours::couplerError, &SeriesColours::sliderError};

PlotSettings settingsWith(ErrorMeasure measure)
{
    return {.error = measure};
}

PlotSettings logarithmicSettingsWith(ErrorMeasure measure)
{
    return {.error = measure, .logarithmicError = true};
}

bool isNear(double value, double expected, double relativeTolerance)
{
    return std::abs(value - expected) <= relativeTolerance * std::max(1e-9, std::abs(expected));
}

class TestPlotFigure : public QObject
{
    Q_OBJECT

private:
    /// Checks that no value at the cursor of a figure with a file covers a curve, and that at most the fraction
    /// `mostLeftOut` of the values is left out.
    void checkValuesOfAFigure(int width, double mostLeftOut)
    {
        constexpr int kCorner = 6; // px: a corner may touch a curve
        QFont font;
        font.setPixelSize(12);
        PlotFigure &figure = figureOf({.reference = referenceOf(62.0)});
        figure.compose({kAllPlots, font, paletteFor(Theme::Light)},
                       {width, PlotFigure::heightFor(kAllPlots, width, font)});
        int values = 0;
        int leftOut = 0;
        for (const std::size_t plot : kAllPlots) {
            const Plot &shown = figure.shownPlot(plot);
            for (int step = 0; step <= 40; ++step) {
                std::vector<PlotCursor> cursors{*figure.cursorAt(plot, step / 40.0, {})};
                placeLabels(cursors, shown.axes->rect(), PlotFonts(font).tick, CrowdedLabelPolicy::LeaveOut);
                std::vector<QRectF> places;
                for (const PlotCursor::Label &label : cursors.front().labels) {
                    ++values;
                    leftOut += label.place.isEmpty() ? 1 : 0;
                    if (!label.place.isEmpty()) {
                        places.push_back(label.place.adjusted(0.0, 2.0, 0.0, -2.0));
                    }
                }
                for (const QRectF &place : places) {
                    QVERIFY(QRectF(shown.axes->rect()).contains(place));
                    for (const PlotCursor::Label &label : cursors.front().labels) {
                        QVERIFY(!label.dot || !place.contains(*label.dot));
                    }
                    for (const PlotCurve &curve : shown.curves) {
                        int columns = 0; // of pixels in which the curve is behind the value
                        for (double x = place.left(); curve.readout && x <= place.right(); x += 1.0) {
                            const double value = curve.readout(figure.readTime(shown.timeAxis->pixelToCoord(x))).value;
                            columns += place.contains(x, shown.valueAxis->coordToPixel(value)) ? 1 : 0;
                        }
                        QVERIFY2(columns <= kCorner, qPrintable(QString("plot %1, step %2").arg(plot).arg(step)));
                    }
                }
            }
        }
        qInfo("%d px: %d of %d values are left out", width, leftOut, values);
        QVERIFY(leftOut <= mostLeftOut * values);
    }

private slots:
    void errorsAreInPercentOfThePeakUnlessChosenOtherwise()
    {
        const std::array model = positionsAt(0.0, 60.0);
        const std::array reference = positionsAt(0.0, 65.0);
        // θ³ is largest at 270°, Rₓ⁴ where crank and coupler are in line
        const std::array peak{positionsAt(0.75, 65.0)[0], std::sqrt(85.0 * 85.0 - 625.0)};
        struct Row {
            PlotSettings settings;
            std::array<double, 2> divisor;
        };
        const std::array<double, 2> none{1.0, 1.0};
        for (const auto &[settings, divisor] :
             {Row{PlotSettings(), peak}, Row{settingsWith(ErrorMeasure::Percent), reference},
              Row{settingsWith(ErrorMeasure::Absolute), none},
              Row{logarithmicSettingsWith(ErrorMeasure::Percent), reference},
              Row{logarithmicSettingsWith(ErrorMeasure::OfPeak), peak}}) {
            for (const PlotInput &shown :
                 {PlotInput{.pinned = {withCoupler(65.0)}}, PlotInput{.reference = referenceOf(65.0)}}) {
                PlotFigure &figure = figureOf(shown);
                figure.setSettings(settings);
                const std::vector<PlotReading> readings = readingsOf(figure, kPositionErrors, 0.0);
                const Plot &plot = figure.shownPlot(kPositionErrors);
                QCOMPARE(readings.size(), std::size_t(2));
                for (std::size_t i = 0; i < 2; ++i) {
                    constexpr double kSampling = 2e-3; // relative: the largest of 41 samples misses the peak
                    const double scale = settings.error == ErrorMeasure::Absolute ? 1.0 : 100.0;
                    const double error = scale * std::abs(model[i] - reference[i]) / divisor[i];
                    const double expected = settings.logarithmicError ? std::log10(error) : error;
                    QVERIFY(isNear(readings[i].value, expected, kSampling));
                    QVERIFY(isNear(curveIn(plot, kErrorInks[i]).points.front().value, expected, kSampling));
                    QVERIFY(plot.values->contains(readings[i].value));
                }
            }
        }
    }

    void anUndefinedErrorIsAGapWithAMark()
    {
        const std::shared_ptr<Reference> reference = referenceOf(65.0);
        reference->data.series[0].values[20] = 0.0;
        reference->data.series[0].values[30] = 1e-15; // zero within rounding, since the peak is 40
        PlotFigure &figure = figureOf({.reference = reference});
        QCOMPARE(plotOf(figure, kPositionErrors).curves.size(), std::size_t(2)); // defined in percent of the peak
        QCOMPARE(gapsIn(figure.shownPlot(kPositionErrors).curves[0].points), 0);
        figure.setSettings(settingsWith(ErrorMeasure::Percent));
        const Plot &plot = plotOf(figure, kPositionErrors);
        const std::vector<CurvePoint> &marks = plot.curves[1].dots;
        QVERIFY(marks.size() == 2 && marks[0].t == reference->data.time[20] && marks[1].t == reference->data.time[30]);
        QCOMPARE(plot.curves[1].name, "undefined: the reference is 0");
        QCOMPARE(gapsIn(plot.curves[0].points), 2);
        QCOMPARE(gapsIn(curveIn(plot, kErrorInks[1]).points), 0);
        QVERIFY(plot.values->upper < 1000.0);

        std::ranges::fill(reference->data.series[0].values, 0.0);
        reference->data.series.resize(1);
        PlotFigure &zeros = figureOf({.reference = reference});
        zeros.setSettings(settingsWith(ErrorMeasure::Percent));
        QCOMPARE(plotOf(zeros, kPositionErrors).note, "undefined: the reference is 0");
        QCOMPARE(plotOf(zeros, kVelocityErrors).note, "not in the file");
    }

    void showsHalfARoundingStepOfTheFile()
    {
        const std::shared_ptr<Reference> reference = referenceOf(65.0);
        reference->data.series[1].rounding = {Rounding::Rule::Decimals, 1}; // that of the other column is unknown
        PlotFigure &figure = figureOf({.reference = reference});
        for (const bool isShown : {true, false}) {
            figure.setSettings({.error = ErrorMeasure::Absolute, .roundingBand = isShown});
            const std::vector<PlotCurve> &curves = plotOf(figure, kPositionErrors).curves;
            QCOMPARE(curves.size(), std::size_t(isShown ? 3 : 2));
            QVERIFY(!isShown || isNear(curves[2].points.front().value, 0.05, 1e-6));
        }
    }

    /// In the legend, the errors come first.
    void theRoundingOfTheFileFollowsBothErrors()
    {
        const std::shared_ptr<Reference> reference = referenceOf(65.0);
        for (std::size_t series : {0U, 1U}) {
            reference->data.series[series].rounding = {Rounding::Rule::Decimals, 1};
        }
        PlotFigure &figure = figureOf({.reference = reference});
        figure.setSettings({.error = ErrorMeasure::Absolute, .roundingBand = true});
        QStringList names;
        for (const PlotCurve &curve : plotOf(figure, kPositionErrors).curves) {
            names << curve.name;
        }
        QCOMPARE(names,
                 QStringList({"error of the coupler", "error of the slider", "file's rounding", "file's rounding"}));
    }

    void everyPlotSaysThatTheMechanismCannotBeAssembled()
    {
        for (const ErrorMeasure measure : {ErrorMeasure::OfPeak, ErrorMeasure::Percent, ErrorMeasure::Absolute}) {
            for (const PlotInput &shown : {PlotInput{withCoupler(1.0)}, PlotInput{withCoupler(1.0), referenceOf(65.0)},
                                           PlotInput{withCoupler(1.0), nullptr, {Parameters()}}}) {
                PlotFigure &figure = figureOf(shown);
                figure.setSettings(settingsWith(measure));
                for (std::size_t plot = 0; plot < kPlotCount; ++plot) {
                    if (!isErrorPlot(plot) || figure.hasErrors()) {
                        QCOMPARE(plotOf(figure, plot).note, "the mechanism cannot be assembled");
                    }
                }
            }
        }
        QCOMPARE(plotOf(figureOf({.model = withCoupler(1.0), .method = Method::Newton}), kCouplerAngle).note,
                 "no time step is solved");
        QCOMPARE(plotOf(figureOf({.pinned = {withCoupler(60.0)}}), kPositionErrors).note, "no difference");
        QVERIFY(plotOf(figureOf({.reference = referenceOf(65.0)}), kPositionErrors).note.isEmpty());
    }

    /// A former defect: all pinned motions were solid grey lines.
    void pinnedMotionsDifferInColourAndDashes()
    {
        const std::vector<Parameters> pinned{withCoupler(62.0), withCoupler(66.0), withCoupler(70.0),
                                             withCoupler(75.0)};
        PlotFigure &figure = figureOf({.pinned = pinned});
        const std::vector<PlotCurve> curves = plotOf(figure, kCouplerAngle).curves;
        QCOMPARE(curves.size(), pinned.size() + 1);
        for (std::size_t i = 0; i < pinned.size(); ++i) {
            QVERIFY(curves[i].name.contains(QString::number(pinned[i].b)));
            for (std::size_t j = 0; j < i; ++j) {
                QVERIFY(curves[i].ink != curves[j].ink && curves[i].dashes != curves[j].dashes);
            }
        }
        const Plot &errors = plotOf(figure, kPositionErrors);
        QVERIFY2(errors.titles.front().text().contains("b = 75 mm"), qPrintable(errors.titles.front().text()));
        QVERIFY(curveIn(errors, &SeriesColours::couplerError).name.contains("b = 75 mm"));
    }

    /// A former defect: the note hid the peak of the curve.
    void aNoteHidesNoCurve_data()
    {
        QTest::addColumn<QSize>("size");
        QTest::addRow("wide") << QSize(360, 200);
        QTest::addRow("narrower than the note") << QSize(120, 150);
    }
    void aNoteHidesNoCurve()
    {
        QFETCH(QSize, size);
        for (std::size_t plot : {0, 1, 3, 4, 6, 7}) {
            PlotFigure &figure = figureOf({.reference = referenceOf(65.0, 0)});
            figure.compose({{plot}, QFont(), paletteFor(Theme::Light)}, size);
            QCOMPARE(figure.shownPlot(plot).note, "not in the file");
            TextRecorder recorder(size);
            QPainter texts(&recorder);
            figure.paint(texts);
            texts.end();
            QImage picture(size, QImage::Format_RGB32);
            QPainter painter(&picture);
            figure.paint(painter);
            painter.end();
            const auto isNote = [](const TextRecorder::Text &text) { return text.first.startsWith("not"); };
            const auto note = std::ranges::find_if(recorder.texts, isNote);
            QVERIFY(note != recorder.texts.end());
            const QRect box = note->second.toAlignedRect();
            QCOMPARE(countPixels(picture.copy(box), seriesColours(paletteFor(Theme::Light)).model), 0);
        }
    }

    void withoutAColumnInTheFileAPlotShowsOnlyTheModel()
    {
        PlotFigure &figure = figureOf({.reference = referenceOf(65.0, 1)});
        QCOMPARE(plotOf(figure, kCouplerAngle).curves.size(), std::size_t(2));
        const std::vector<PlotReading> readings = readingsOf(figure, 1, 0.0);
        QCOMPARE(figure.shownPlot(kSliderPosition).note, "not in the file");
        QCOMPARE(plotOf(figure, kPositionErrors).curves.size(), std::size_t(1)); // of the coupler only
        QVERIFY(readings.size() == 1 && isNear(readings[0].number, positionsAt(0.0, 60.0)[1], 1e-9));
    }

    void theClosedFormNeedsNoSamples()
    {
        for (const auto &[method, steps] : {std::pair(Method::ClosedForm, 3), {Method::Newton, 400}}) {
            PlotFigure &figure = figureOf({.sampling = {0.0, 1.0, steps}, .method = method});
            for (const double t : {0.1, 0.35, 0.8}) {
                for (const std::size_t plot : {0, 1}) {
                    QVERIFY(isNear(readingsOf(figure, plot, t)[0].value, positionsAt(t, 60.0)[plot], 1e-6));
                }
            }
        }
    }

    void valueAxesFitTheTimeShown()
    {
        struct Row {
            Method method;
            int steps;
            double chord; ///< mm, largest distance of the drawn lines from the motion
        };
        for (const auto &[method, steps, chord] :
             {Row{Method::ClosedForm, 1, 0.1}, Row{Method::Newton, 400, 0.1}, Row{Method::Newton, 8, 4.0}}) {
            PlotFigure &figure =
                figureOf({.reference = referenceOf(65.0), .sampling = {0.0, 1.0, steps}, .method = method});
            const Interval whole = *plotOf(figure, kSliderPosition).values;
            for (const Interval &time : {Interval{0.3, 0.4}, Interval{0.55, 0.62}, Interval{0.81, 0.83}}) {
                double smallest = 1e9;
                double largest = -1e9;
                for (int i = 0; i <= 1000; ++i) {
                    for (const double b : {60.0, 65.0}) {
                        const double value = positionsAt(time.lower + time.length() * i / 1000.0, b)[1];
                        smallest = std::min(smallest, value);
                        largest = std::max(largest, value);
                    }
                }
                figure.zoomTime(time);
                const Interval shown = *plotOf(figure, kSliderPosition).values;
                QVERIFY(shown.lower <= smallest + chord && shown.upper >= largest - chord);
                QVERIFY(shown.length() < 1.5 * (largest - smallest) + 4.0 * chord &&
                        shown.length() < 0.8 * whole.length());
            }
            figure.zoomValues(kSliderPosition, {10.0, 20.0}); // a chosen range does not depend on the time shown
            figure.zoomTime({0.5, 0.6});
            QCOMPARE(*plotOf(figure, kSliderPosition).values, (Interval{10.0, 20.0}));
        }
    }

    void shorterTitlesStillTellWhichQuantityTheyName()
    {
        PlotFigure &figure = figureOf({});
        QStringList titles;
        for (const QStaticText &title : plotOf(figure, kCouplerVelocity).titles) {
            titles << title.text();
        }
        QCOMPARE(titles, (QStringList{"coupler angular velocity ω³ = dθ³/dt [°/s]", "coupler angular velocity ω³ [°/s]",
                                      "coupler angular velocity [°/s]", "velocity ω³ [°/s]", "ω³ [°/s]"}));
        QVERIFY(
            plotOf(figure, kSliderAcceleration).titles.front().text().startsWith("slider acceleration a⁴ = dv⁴/dt"));
        QCOMPARE(plotOf(figure, kCouplerAngle).titles.front().text(), "coupler angle θ³ [°]");
    }

    /// Former defects: "velocity [°/s]" beside "slider velocity v⁴ [mm/s]", and "coupler angular velocity" above
    /// "acceleration".
    void theTitlesOfAFigureAreShortenedAlike()
    {
        PlotFigure &figure = figureOf({});
        QSet<std::size_t> variants;
        for (int width = 1200; width > 300; width -= 50) {
            figure.compose({{0, 1, 3, 4, 6, 7}, QFont(), QPalette()}, {width, 600});
            for (const std::size_t plot : figure.plots()) {
                QCOMPARE(figure.shownPlot(plot).title, figure.shownPlot(0).title);
            }
            variants << figure.shownPlot(kCouplerVelocity).title;
        }
        QVERIFY(variants.contains(3)); // "velocity ω³"
        // A former defect: "Rₓ⁴" beside "velocity v⁴", where a position and a velocity share a row.
        figure.compose({{1, 4}, QFont(), QPalette()}, {400, 300});
        QCOMPARE(figure.shownPlot(kSliderPosition).titles.size(), figure.shownPlot(4).titles.size());
        QCOMPARE(figure.shownPlot(kSliderPosition).title, figure.shownPlot(4).title);
    }

    void withAFileValuesAreReadAtItsTimeStamps()
    {
        const std::shared_ptr<Reference> reference = referenceOf(65.0);
        for (const Method method : {Method::ClosedForm, Method::Newton}) {
            PlotFigure &figure = figureOf({.reference = reference, .method = method});
            figure.setSettings(settingsWith(ErrorMeasure::Absolute));
            QCOMPARE(figure.readTime(0.3333).t, reference->data.time[13]);
            for (std::size_t plot = 0; plot < kPlotCount; ++plot) {
                if (!isErrorPlot(plot)) {
                    const std::vector<PlotReading> values = readingsOf(figure, plot, 0.3333);
                    const std::vector<PlotReading> errors =
                        readingsOf(figure, plot / kPlotColumns * kPlotColumns + kErrorColumn, 0.3333);
                    QCOMPARE(values.size(), std::size_t(2));
                    QCOMPARE(errors[plot % kPlotColumns].number, std::abs(values[0].number - values[1].number));
                }
            }
            QVERIFY(!figureOf({.reference = reference, .sampling = {0.0, 2.0, 200}}).readTime(1.7).row);
        }
    }

    /// A former defect: the line stood at 0.1250 s, and the value beside it was the model's at the nearest row, 0.1 s.
    void valuesOfTheModelAreThoseOfTheTimeOfTheCursor_data()
    {
        QTest::addColumn<double>("time");
        QTest::addColumn<bool>("isARow"); // the file has a row every 0.025 s
        QTest::addRow("between two rows") << 0.13 << false;
        QTest::addRow("at a row") << 0.125 << true;
        QTest::addRow("at a row within the digits shown") << 0.12500001 << true;
    }
    void valuesOfTheModelAreThoseOfTheTimeOfTheCursor()
    {
        QFETCH(double, time);
        QFETCH(bool, isARow);
        constexpr double kRow = 0.125;
        PlotFigure &figure = figureOf({.reference = referenceOf(65.0)});
        for (const std::size_t plot : {kCouplerAngle, kSliderPosition}) {
            plotOf(figure, plot);
            const PlotCursor cursor = *figure.cursorAt(plot, time, {});
            QCOMPARE(cursor.labels.size(), std::size_t(2));
            const QString file = shortNumber(positionsAt(kRow, 65.0)[plot]);
            QCOMPARE(cursor.labels[0].text.text(), shortNumber(positionsAt(time, 60.0)[plot]));
            QCOMPARE(cursor.labels[1].text.text(), isARow ? file : u'≈' + file);
            const QCPAxis &axis = *figure.shownPlot(plot).timeAxis;
            QVERIFY(isNear(cursor.labels[0].dot->x(), axis.coordToPixel(time), 1e-9));
            QVERIFY(isNear(cursor.labels[1].dot->x(), axis.coordToPixel(kRow), 1e-9));
        }
        TextRecorder recorder(QSize(800, 600));
        QPainter painter(&recorder);
        figure.compose({.plots = {kSliderPosition}, .cursorTime = time}, {800, 600});
        figure.paint(painter);
        painter.end();
        const QString wanted = isARow ? "t = 0.1250 s" : "t = 0.1300 s; ≈ file: t = 0.1250 s";
        QVERIFY(std::ranges::count(recorder.texts, wanted, &TextRecorder::Text::first) == 1);
    }

    /// A former defect: in a narrow figure, the time stood over the curves of the first plot.
    void theTimeOfTheCursorCoversNoPlot_data()
    {
        QTest::addColumn<std::vector<std::size_t>>("plots");
        QTest::addColumn<QSize>("size");
        QTest::addColumn<int>("letters"); // px
        QTest::addRow("a wide figure") << kAllPlots << QSize(900, 700) << 12;
        QTest::addRow("half a column of text") << kAllPlots << QSize(302, 400) << 12;
        QTest::addRow("large letters") << kAllPlots << QSize(605, 600) << 19;
        QTest::addRow("larger than the figure") << kAllPlots << QSize(302, 600) << 24;
        QTest::addRow("a single plot") << std::vector{kSliderPosition} << QSize(302, 200) << 12;
        QTest::addRow("a single plot of errors") << std::vector{kVelocityErrors} << QSize(302, 200) << 12;
    }
    void theTimeOfTheCursorCoversNoPlot()
    {
        QFETCH(std::vector<std::size_t>, plots);
        QFETCH(QSize, size);
        QFETCH(int, letters);
        QFont font;
        font.setPixelSize(letters);
        PlotFigure &figure = figureOf({.reference = referenceOf(65.0)});
        figure.compose({.plots = plots, .font = font, .cursorTime = 0.13}, size);
        TextRecorder recorder(size);
        QPainter painter(&recorder);
        figure.paint(painter);
        painter.end();
        int times = 0;
        for (const auto &[text, box] : recorder.texts) {
            if (text.contains("t = 0.1")) {
                ++times;
                QVERIFY(box.bottom() < figure.shownPlot(plots.front()).axes->top());
                QVERIFY(box.left() >= 0.0 && box.right() <= size.width());
                for (const auto &[other, place] : recorder.texts) {
                    QVERIFY2(other == text || !place.intersects(box), qPrintable(other));
                }
            }
        }
        QVERIFY(times > 0);
    }

    /// A former defect: in a narrow figure, the middle of a name was left out: "difference of the co…m b = 80 mm".
    void aLongNameInTheLegendHasSeveralLines()
    {
        constexpr QSize kSize(302, 260);
        QFont font;
        font.setPixelSize(12);
        PlotFigure &figure = figureOf({.pinned = {{.a = 25.0, .b = 80.0, .c = -12.5}}});
        figure.compose({.plots = {kVelocityErrors}, .font = font, .cursorTime = 0.13}, kSize);
        TextRecorder recorder(kSize);
        QPainter painter(&recorder);
        figure.paint(painter);
        painter.end();
        QStringList legend;
        for (const auto &[text, box] : recorder.texts) {
            if (box.bottom() < figure.shownPlot(kVelocityErrors).axes->top()) {
                legend << QString(text).replace(QChar::Nbsp, u' ');
                QVERIFY2(box.left() >= 0.0 && box.right() <= kSize.width(), qPrintable(text));
                for (const auto &[other, place] : recorder.texts) {
                    QVERIFY2(other == text || !place.intersects(box), qPrintable(other));
                }
            }
        }
        const QString all = legend.join(u' ').simplified();
        QVERIFY2(all.contains("difference of the slider from a = 25 mm, b = 80 mm, c = −12.5 mm"), qPrintable(all));
    }

    /// A former defect: the plots of errors of a figure with a choice of plots all had the title "error".
    void theTitleOfErrorsNamesTheQuantity()
    {
        for (const bool isOfFile : {true, false}) {
            PlotFigure &figure = figureOf(isOfFile ? PlotInput{.reference = referenceOf(65.0)}
                                                   : PlotInput{.pinned = {withCoupler(80.0)}});
            figure.compose({.plots = {kPositionErrors, kVelocityErrors}}, {700, 300});
            const auto title = [&figure](std::size_t plot) {
                const Plot &shown = figure.shownPlot(plot);
                return shown.titles[shown.title].text();
            };
            QVERIFY2(title(kPositionErrors).startsWith("position "), qPrintable(title(kPositionErrors)));
            QVERIFY2(title(kVelocityErrors).startsWith("velocity "), qPrintable(title(kVelocityErrors)));
        }
    }

    /// A former defect: in Spanish, and in narrow figures, all of these plots had the title "error".
    void shortTitlesOfErrorsNameTheQuantity()
    {
        PlotFigure &figure = figureOf({.reference = referenceOf(65.0)});
        for (const ErrorMeasure measure : {ErrorMeasure::OfPeak, ErrorMeasure::Percent, ErrorMeasure::Absolute}) {
            figure.setSettings(settingsWith(measure));
            for (int width = 1000; width > 400; width -= 25) {
                figure.compose({.plots = kAllPlots}, {width, 600});
                QSet<QString> titles;
                for (const std::size_t plot : {kPositionErrors, kVelocityErrors, kAccelerationErrors}) {
                    const Plot &shown = figure.shownPlot(plot);
                    titles << shown.titles[shown.title].text();
                    QCOMPARE(shown.title, figure.shownPlot(kPositionErrors).title);
                }
                QCOMPARE(titles.size(), 3);
            }
        }
    }

    /// Former defects: in a figure of 80 mm, nine plots were 12 mm wide, and with large letters their titles were cut
    /// off.
    void aNarrowFigureHasFewerColumns_data()
    {
        QTest::addColumn<std::vector<std::size_t>>("plots");
        QTest::addColumn<int>("width");   // px
        QTest::addColumn<int>("letters"); // px
        QTest::addColumn<int>("columns");
        const std::vector<std::size_t> motions{0, 1, 3, 4, 6, 7};
        QTest::newRow("nine plots, 80 mm, 9 pt") << kAllPlots << 302 << 12 << 2;
        QTest::newRow("nine plots, 80 mm, 6 pt") << kAllPlots << 302 << 8 << 3;
        QTest::newRow("nine plots, 80 mm, 14 pt") << kAllPlots << 302 << 19 << 1;
        QTest::newRow("nine plots, 120 mm, 9 pt") << kAllPlots << 453 << 12 << 3;
        QTest::newRow("nine plots, 160 mm, 9 pt") << kAllPlots << 605 << 12 << 3;
        QTest::newRow("six plots, 80 mm, 9 pt") << motions << 302 << 12 << 2;
        QTest::newRow("six plots, 80 mm, 14 pt") << motions << 302 << 19 << 1;
        QTest::newRow("three plots, 80 mm, 9 pt") << std::vector<std::size_t>{0, 1, 4} << 302 << 12 << 1;
        QTest::newRow("three plots, 160 mm, 9 pt") << std::vector<std::size_t>{0, 1, 4} << 605 << 12 << 3;
    }
    void aNarrowFigureHasFewerColumns()
    {
        constexpr double kMinWidth = 4.0; // of the axes, in heights of the letters
        QFETCH(const std::vector<std::size_t>, plots);
        QFETCH(const int, width);
        QFETCH(const int, letters);
        QFETCH(const int, columns);
        QFont font;
        font.setPixelSize(letters);
        PlotGrid grid;
        grid.setResult(resultOf({.reference = referenceOf(65.0)}));
        const int height = grid.figureHeight({.plots = plots}, width, font);
        QSet<int> lefts;
        QPixmap picture(width, height);
        QPainter painter(&picture);
        painter.setFont(font);
        grid.paintFigure(painter, {.plots = plots}, {width, height}, paletteFor(Theme::Light));
        for (const std::size_t plot : plots) {
            const Plot &shown = grid.shownPlot(plot);
            const QRect axes = shown.axes->rect();
            lefts << axes.left();
            QVERIFY(axes.width() > kMinWidth * letters);
            QVERIFY(axes.left() + shown.titles[shown.title].size().width() <= width);
        }
        QCOMPARE(lefts.size(), columns);
        // The errors follow the motions where the columns of the window do not fit.
        const auto topOf = [&grid](std::size_t plot) { return grid.shownPlot(plot).axes->rect().top(); };
        QVERIFY(columns == 3 || plots.size() < kPlotCount || topOf(kPositionErrors) > topOf(kSliderAcceleration));
    }

    /// The legend says why a curve has gaps: the mechanism cannot be assembled there.
    void theLegendExplainsGaps()
    {
        const auto nameOf = [](double b, std::size_t plot) {
            return plotOf(figureOf({.model = withCoupler(b)}), plot).curves.back().name;
        };
        for (const std::size_t plot : {kCouplerAngle, kSliderAcceleration}) {
            QCOMPARE(nameOf(40.0, plot), "model (gaps: cannot be assembled)");
            QCOMPARE(nameOf(45.0, plot), "model"); // b = a + c: velocities that do not exist at one position
            QCOMPARE(nameOf(60.0, plot), "model");
        }
    }

    /// With Newton-Raphson, the motion is known at its time steps only.
    void aValueOfTheNearestTimeStepSaysSo()
    {
        PlotFigure &figure = figureOf({.sampling = {0.0, 1.0, 10}, .method = Method::Newton});
        plotOf(figure, kSliderPosition);
        const QString value = shortNumber(positionsAt(0.1, 60.0)[kSliderPosition]);
        QCOMPARE(figure.cursorAt(kSliderPosition, 0.12, {})->labels[0].text.text(), u'≈' + value);
        QCOMPARE(figure.cursorAt(kSliderPosition, 0.1, {})->labels[0].text.text(), value);
    }

    /// A former defect: of a figure with a pinned motion, the pinned value stood where the model's had no place.
    void theModelsValueIsTheLastToBeLeftOut_data()
    {
        QTest::addColumn<std::shared_ptr<Reference>>("reference");
        QTest::addRow("a pinned motion") << std::shared_ptr<Reference>();
        QTest::addRow("a file and a pinned motion") << referenceOf(62.0);
    }
    void theModelsValueIsTheLastToBeLeftOut()
    {
        QFETCH(std::shared_ptr<Reference>, reference);
        QFont font;
        font.setPixelSize(12);
        PlotFigure &figure = figureOf({.reference = reference, .pinned = {withCoupler(65.0)}});
        figure.compose({kAllPlots, font, paletteFor(Theme::Light)}, {605, PlotFigure::heightFor(kAllPlots, 605, font)});
        std::array<int, 3> shown{}; // by rank
        for (const std::size_t plot : kAllPlots) {
            for (int step = 0; step <= 200; ++step) {
                std::vector<PlotCursor> cursors{*figure.cursorAt(plot, step / 200.0, {})};
                placeLabels(cursors, figure.shownPlot(plot).axes->rect(), PlotFonts(font).tick,
                            CrowdedLabelPolicy::LeaveOut);
                std::optional<PlotCursor::Rank> missing;
                for (const PlotCursor::Label &label : cursors.front().labels) {
                    const bool isMissing = label.place.isEmpty();
                    missing = isMissing ? std::min(missing.value_or(label.rank), label.rank) : missing;
                    shown[static_cast<std::size_t>(label.rank)] += isMissing ? 0 : 1;
                }
                for (const PlotCursor::Label &label : cursors.front().labels) {
                    QVERIFY(!missing || label.place.isEmpty() == (label.rank >= *missing));
                }
            }
        }
        qInfo("%d values of the model are shown, %d of the file, %d pinned", shown[0], shown[1], shown[2]);
        QVERIFY(shown[0] > shown[2] && shown[2] > 0);
    }

    void overTheCrankAngleEverythingIsReadInDegrees()
    {
        Parameters parameters;
        parameters.omega2 = -2.0 * std::numbers::pi;
        parameters.theta20 = 0.5 * std::numbers::pi;
        PlotFigure &figure = figureOf({parameters});
        QCOMPARE(figure.timeText(0.25), "t = 0.2500 s");
        QCOMPARE(figure.timeText(0.75, 0.25), "Δt = 0.5000 s");
        QCOMPARE(plotOf(figure, kCouplerAngle).axes->axis(QCPAxis::atBottom)->label(), "t [s]");
        figure.setSettings({.abscissa = Abscissa::CrankAngle});
        QCOMPARE(figure.timeText(0.5), "θ₂ = −90.00°");
        QCOMPARE(figure.timeText(0.75, 0.25), "Δθ₂ = −180.0°");
        const QCPAxis &axis = *plotOf(figure, kCouplerAngle).axes->axis(QCPAxis::atBottom);
        QCOMPARE(axis.label(), "θ₂ [°]");
        const auto zero = axis.tickVectorLabels().indexOf(QStringLiteral("0")); // a quarter of a second after 90°
        QVERIFY(zero >= 0 && isNear(axis.tickVector()[zero], 0.25, 1e-9));
    }

    /// A former defect: on a small screen with an open tab, the numbers of the axis of the positions touched.
    void numbersOfALowPlotDoNotTouch()
    {
        const std::vector<std::size_t> plots{0, 1, 3, 4, 6, 7};
        QFont font;
        font.setPixelSize(12);
        const double numberHeight = QFontMetricsF(PlotFonts(font).tick).height();
        PlotFigure &figure = figureOf({});
        for (int height = 220; height <= 600; height += 5) { // px, 220 in a window of 764×450
            figure.compose({plots, font, paletteFor(Theme::Light)}, {420, height});
            for (const std::size_t plot : plots) {
                const QCPAxis &axis = *figure.shownPlot(plot).axes->axis(QCPAxis::atLeft);
                std::vector<double> numbers; // px
                for (qsizetype i = 0; i < axis.tickVector().size(); ++i) {
                    if (!axis.tickVectorLabels()[i].isEmpty()) {
                        numbers.push_back(axis.coordToPixel(axis.tickVector()[i]));
                    }
                }
                QVERIFY(numbers.size() >= 2);
                for (std::size_t i = 1; i < numbers.size(); ++i) {
                    QVERIFY2(numbers[i - 1] - numbers[i] >= numberHeight - 1.0,
                             qPrintable(QStringLiteral("%1 px, plot %2").arg(height).arg(plot)));
                }
            }
        }
    }

    /// A former defect: in a figure of 85 mm, values at the cursor covered a part of their curve.
    void valuesStandBesideTheirCurve()
    {
        constexpr std::array<std::size_t, 2> kPlots{0, 1}; // θ³ and Rₓ⁴
        constexpr int kCorner = 6;                         // px: where no place is free, a corner is covered
        constexpr double kBesideNumbers = 3.0; // px: a value that touches the axis looks like one of its numbers
        QFont font;
        font.setPixelSize(12);
        int covering = 0;
        for (const std::size_t plot : kPlots) {
            PlotFigure &figure = figureOf({});
            const int width = 321; // px, 85 mm
            figure.compose({{0, 1}, font, paletteFor(Theme::Light)},
                           {width, PlotFigure::heightFor({0, 1}, width, font)});
            const Plot &shown = figure.shownPlot(plot);
            for (int step = 0; step <= 50; ++step) {
                std::vector<PlotCursor> cursors{*figure.cursorAt(plot, step / 50.0, {})};
                placeLabels(cursors, shown.axes->rect(), PlotFonts(font).tick, CrowdedLabelPolicy::CoverLeast);
                const QRectF place = cursors.front().labels.front().place.adjusted(0.0, 2.0, 0.0, -2.0);
                QVERIFY(QRectF(shown.axes->rect()).contains(place));
                QVERIFY(place.left() >= shown.axes->rect().left() + kBesideNumbers);
                int columns = 0; // of pixels in which the curve is behind the value
                for (double x = place.left(); x <= place.right(); x += 1.0) {
                    const double value = positionsAt(shown.timeAxis->pixelToCoord(x), 60.0)[plot];
                    columns += place.contains(x, shown.valueAxis->coordToPixel(value));
                }
                covering += columns > kCorner;
            }
        }
        QVERIFY2(covering == 0, qPrintable(QString::number(covering)));
    }

    /// A former defect: in a figure of 85 mm with a file, white boxes with values lay over parts of other curves.
    void valuesOfAFigureCoverNoCurve()
    {
        struct Row {
            int width;          // px
            double mostLeftOut; // fraction of the values
        };
        for (const Row &row : {Row{321, 0.7}, Row{605, 0.2}}) { // 85 mm: each plot is 12 mm wide; 160 mm
            checkValuesOfAFigure(row.width, row.mostLeftOut);
        }
    }

    /// A former defect: of two curves close together, the value of the lower one could stand above that of the upper
    /// one.
    void valuesAreInTheOrderOfTheirCurves()
    {
        QFont font;
        font.setPixelSize(12);
        PlotFigure &figure = figureOf({.reference = referenceOf(62.0)});
        figure.compose({kAllPlots, font, paletteFor(Theme::Light)}, {1400, 900});
        int inOrder = 0;
        int exchanged = 0;
        for (const std::size_t plot : kAllPlots) {
            for (int step = 0; step <= 100; ++step) {
                std::vector<PlotCursor> cursors{*figure.cursorAt(plot, step / 100.0, {})};
                placeLabels(cursors, figure.shownPlot(plot).axes->rect(), PlotFonts(font).tick,
                            CrowdedLabelPolicy::CoverLeast);
                const std::vector<PlotCursor::Label> &labels = cursors.front().labels;
                for (std::size_t i = 1; i < labels.size(); ++i) {
                    const bool isAbove = labels[i].place.center().y() < labels[i - 1].place.center().y();
                    const double y = anchorOf(cursors.front(), labels[i]).y();
                    const bool isHigher = y < anchorOf(cursors.front(), labels[i - 1]).y();
                    ++(isHigher == isAbove ? inOrder : exchanged);
                }
            }
        }
        qInfo("%d pairs of values are in the order of their curves, %d are exchanged", inOrder, exchanged);
        QVERIFY(exchanged < inOrder / 20);
    }

    /// A former defect: beside three pinned motions, the values were in any order.
    void valuesOfPinnedMotionsAreInTheOrderOfTheirDots_data()
    {
        QTest::addColumn<CrowdedLabelPolicy>("policy");
        QTest::newRow("window") << CrowdedLabelPolicy::CoverLeast;
        QTest::newRow("figure") << CrowdedLabelPolicy::LeaveOut;
    }
    void valuesOfPinnedMotionsAreInTheOrderOfTheirDots()
    {
        QFETCH(const CrowdedLabelPolicy, policy);
        QFont font;
        font.setPixelSize(12);
        PlotFigure &figure =
            figureOf({.model = withCoupler(65.0), .pinned = {withCoupler(66.0), withCoupler(67.0), withCoupler(68.0)}});
        int inOrder = 0;
        int exchanged = 0;
        for (const std::size_t plot : {0U, 1U, 3U, 4U, 6U, 7U}) {
            figure.compose({{plot}, font, paletteFor(Theme::Light)}, {605, PlotFigure::heightFor({plot}, 605, font)});
            for (int step = 0; step <= 100; ++step) {
                std::vector<PlotCursor> cursors{*figure.cursorAt(plot, step / 100.0, {})};
                placeLabels(cursors, figure.shownPlot(plot).axes->rect(), PlotFonts(font).tick, policy);
                const std::vector<PlotCursor::Label> &labels = cursors.front().labels; // from the highest dot on
                for (std::size_t i = 1; i < labels.size(); ++i) {
                    if (!labels[i].place.isEmpty() && !labels[i - 1].place.isEmpty()) {
                        ++(labels[i - 1].place.top() <= labels[i].place.top() ? inOrder : exchanged);
                    }
                }
            }
        }
        qInfo("%d pairs of values are in the order of their dots, %d are exchanged", inOrder, exchanged);
        QVERIFY(inOrder > 900);
        QVERIFY(exchanged <= (policy == CrowdedLabelPolicy::LeaveOut ? 0 : inOrder / 50));
    }

    /// A former defect: while the motion was played, every fourth value jumped from one side of its curve to the other.
    void valuesKeepTheirPlacesWhilePlaying()
    {
        constexpr int kFrames = 240;
        constexpr double kJump = 8.0; // px
        QFont font;
        font.setPixelSize(12);
        PlotFigure &figure = figureOf({.reference = referenceOf(62.0)});
        figure.compose({kAllPlots, font, paletteFor(Theme::Light)}, {1400, 900});
        int values = 0;
        int jumps = 0;
        for (const std::size_t plot : kAllPlots) {
            std::vector<PlotCursor> before;
            for (int frame = 0; frame <= kFrames; ++frame) {
                std::vector<PlotCursor> cursors{*figure.cursorAt(plot, static_cast<double>(frame) / kFrames, {})};
                setPreviousPlaces(cursors, before);
                placeLabels(cursors, figure.shownPlot(plot).axes->rect(), PlotFonts(font).tick,
                            CrowdedLabelPolicy::CoverLeast);
                for (const PlotCursor::Label &label : cursors.front().labels) {
                    const QPointF fromDot = label.place.center() - anchorOf(cursors.front(), label);
                    ++values;
                    jumps +=
                        label.previousPlace && QLineF(label.previousPlace->center(), fromDot).length() > kJump ? 1 : 0;
                }
                before = cursors;
            }
        }
        qInfo("%d of %d values jumped", jumps, values);
        QVERIFY2(jumps < values / 15, qPrintable(QString::number(jumps)));
    }

    /// A former defect: six plots, which are drawn in three rows, had the height of two.
    void figuresAreHighEnoughForTheirRows()
    {
        struct Row {
            std::vector<std::size_t> plots;
            double minRatio; // height of the axes over their width
        };
        for (const auto &[plots, minRatio] : {Row{{0, 1, 3, 4, 6, 7}, 0.4}, Row{{0, 1, 2, 3, 4, 5, 6, 7, 8}, 0.4},
                                              Row{{0}, 0.3}, Row{{0, 1, 3, 4}, 0.4}}) {
            for (const int width : {321, 605, 1400}) { // 85 mm, 160 mm
                QFont font;
                font.setPixelSize(12);
                PlotFigure &figure = figureOf({.pinned = {withCoupler(65.0)}});
                const int height = PlotFigure::heightFor(plots, width, font);
                figure.compose({plots, font, QPalette()}, {width, height});
                for (const std::size_t plot : plots) {
                    const QRect axes = figure.shownPlot(plot).axes->rect();
                    QVERIFY2(axes.height() >= minRatio * axes.width() && axes.height() > 40,
                             qPrintable(QString("%1 plots, %2 px: %3×%4")
                                            .arg(plots.size())
                                            .arg(width)
                                            .arg(axes.width())
                                            .arg(axes.height())));
                }
            }
        }
    }

    void theCrankAngleAndErrorsAreInTheChosenUnits()
    {
        const auto restore = qScopeGuard([] { setNotation({}); });
        const std::shared_ptr<Reference> reference = referenceOf(65.0);
        PlotFigure &inMillimetres = figureOf({.reference = reference});
        inMillimetres.setSettings(settingsWith(ErrorMeasure::Absolute));
        const std::vector<PlotReading> mm = readingsOf(inMillimetres, kPositionErrors, 0.3);
        setNotation({.units = {LengthUnit::Inch, AngleUnit::Radian}});
        PlotFigure &figure = figureOf({.reference = reference});
        figure.setSettings({.error = ErrorMeasure::Absolute, .roundingBand = false, .abscissa = Abscissa::CrankAngle});
        const std::vector<PlotReading> inches = readingsOf(figure, kPositionErrors, 0.3);
        QVERIFY(isNear(inches[0].number, mm[0].number * std::numbers::pi / 180.0, 1e-12));
        QVERIFY(isNear(inches[1].number, mm[1].number / 25.4, 1e-12));
        QVERIFY2(figure.shownPlot(kPositionErrors).titles.front().text().contains("[rad; in]"),
                 qPrintable(figure.shownPlot(kPositionErrors).titles.front().text()));
        QCOMPARE(figure.timeText(0.5), "θ₂ = 3.142 rad");
        const QCPAxis &axis = *plotOf(figure, kCouplerAngle).axes->axis(QCPAxis::atBottom);
        QCOMPARE(axis.label(), "θ₂ [rad]");
        const auto half = axis.tickVectorLabels().indexOf(QStringLiteral("π"));
        QVERIFY(half >= 0 && isNear(axis.tickVector()[half], 0.5, 1e-9));
    }

    void inPresentationModeMotionsAreEquallyThickAndNamedByTheirDifference()
    {
        PlotFigure &figure = figureOf({.model = withCoupler(146.0), .pinned = {withCoupler(65.0), withCoupler(80.0)}});
        QVERIFY(plotOf(figure, kSliderPosition).curves.front().width <
                    figure.shownPlot(kSliderPosition).curves.back().width &&
                figure.hasErrors());
        figure.setPresentation(true);
        QVERIFY(!figure.hasErrors());
        QStringList names;
        for (const PlotCurve &curve : plotOf(figure, kSliderPosition).curves) {
            QCOMPARE(curve.width, figure.shownPlot(kSliderPosition).curves.back().width);
            names << curve.name;
        }
        QCOMPARE(names, (QStringList{"b = 65 mm", "b = 80 mm", "b = 146 mm"}));
    }

    void aPinnedCurveIsAsExactAsTheModels()
    {
        struct Row {
            double duration;
            Interval time;
            double b;
        };
        for (const auto &[duration, time, b] :
             {Row{1.0, {0.0, 1.0}, 80.0}, Row{1.0, {0.23, 0.26}, 80.0}, Row{1000.0, {0.0, 1000.0}, 80.0},
              Row{1000.0, {700.0, 700.5}, 80.0}, Row{1.0, {0.0, 1.0}, 40.0}}) {
            const Sampling sampling{0.0, duration, 7};
            const PlotInput pinned{withCoupler(60.0), nullptr, {withCoupler(b)}, sampling};
            const PlotInput swapped{withCoupler(b), nullptr, {withCoupler(60.0)}, sampling};
            std::array<QStringList, 2> curves;
            for (const bool isPinned : {false, true}) {
                PlotFigure &figure = figureOf(isPinned ? pinned : swapped);
                figure.zoomTime(time);
                for (const std::size_t plot : {0, 1, 3, 4, 6, 7}) {
                    const std::vector<PlotCurve> &shown = plotOf(figure, plot).curves;
                    curves[isPinned ? 1 : 0] << textOfPoints((isPinned ? shown.front() : shown.back()).points);
                }
            }
            QVERIFY(!curves[0].contains(QString()));
            QCOMPARE(curves[0], curves[1]);
            PlotFigure &figure = figureOf(pinned);
            figure.zoomTime(time);
            const Plot &errors = plotOf(figure, kPositionErrors);
            const double peak = figure.result()->difference->channels[1].peak;
            for (const CurvePoint &point : errors.curves[1].points) {
                const double wanted =
                    100.0 / peak * std::abs(positionsAt(point.t, 60.0)[1] - positionsAt(point.t, b)[1]);
                QVERIFY(std::isnan(point.value) || std::abs(point.value - wanted) <= 1e-6 * errors.values->upper);
            }
        }
    }
};

const Suite<TestPlotFigure> suite("tst_plot_figure");

} // namespace tst_plot_figure

#include "tst_plot_figure.moc"
