// SPDX-License-Identifier: GPL-3.0-or-later

// Computes what the plots show: the curves, the errors and the values at a time.

#include "ui/plots/plot_figure.h"

#include "ui/plots/plot_drawing.h"
#include "ui/text/axis_scale.h"
#include "ui/text/motion_facts.h"
#include "ui/text/parameter_text.h"
#include "ui/text/written_number.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace slidercrank
{

namespace
{

constexpr double kThinWidth = 1.0;          // px, of a curve that is less important than the model's
constexpr double kErrorWidth = 1.6;         // px: thin, since the errors of a matching file are noise
constexpr double kMinRangeFraction = 1e-10; // smallest range, relative to the largest number on an axis

/// The indices in kPlottedChannels of the channels whose errors a plot shows.
struct ErrorChannels {
    std::size_t coupler;
    std::size_t slider;
};

ErrorChannels errorChannels(Order order)
{
    return {.coupler = plottedIndexOf({Theta3, order}), .slider = plottedIndexOf({R4x, order})};
}

/// Lengths of dashes and gaps, in line widths. Each pinned motion has its own pattern.
const QVector<double> kReferenceDashes{3.5, 3.0};
const QVector<double> kRoundingDashes{2.0, 3.0};
const auto kPinnedDashes = std::to_array<QVector<double>>({{}, {13.0, 4.0}, {5.0, 4.0}, {2.0, 3.0}});
static_assert(kPinnedDashes.size() == kMaxPinned && kPinnedColours.size() == kMaxPinned);

Ink errorInk(std::size_t channel)
{
    return kPlottedChannels[channel].coordinate == R4x ? &SeriesColours::sliderError : &SeriesColours::couplerError;
}

/// Extends the range so that it contains the added one. Either of them may not exist.
void include(std::optional<Interval> &range, const std::optional<Interval> &added)
{
    if (added) {
        range = range.value_or(*added);
        range->include(added->lower);
        range->include(added->upper);
    }
}

} // namespace

void PlotFigure::requestRefresh()
{
    m_isStale = true;
    QCoreApplication::postEvent(this, new QEvent(QEvent::LayoutRequest));
}

void PlotFigure::setResult(const std::shared_ptr<const Result> &result)
{
    const Interval before = m_result ? sampledRange() : Interval();
    m_result = result;
    m_pinned.clear();
    const Interval time = sampledRange();
    for (const Parameters &parameters : result->pinned) {
        m_pinned.push_back({MotionCurves(Mechanism(parameters), time)});
    }
    const bool isExact = result->solver.method == Method::ClosedForm;
    m_model = ShownMotion{isExact ? MotionCurves(result->mechanism, time) : MotionCurves(result->trajectory)};
    for (Plot &plot : m_plots) {
        plot.curves.clear();
    }
    if (time != before) {
        m_zoom.time.reset();
    }
    requestRefresh();
}

void PlotFigure::setSettings(const PlotSettings &settings)
{
    for (std::size_t plot = kErrorColumn; plot < kPlotCount; plot += kPlotColumns) {
        m_zoom.values[plot].reset(); // the ranges belong to the previous measure
    }
    m_settings = settings;
    requestRefresh();
}

void PlotFigure::setPresentation(bool isPresentation)
{
    m_isPresentation = isPresentation;
    requestRefresh();
}

void PlotFigure::setZoom(const PlotZoom &zoom)
{
    m_zoom = zoom;
    requestRefresh();
}

bool PlotFigure::hasErrors() const
{
    return m_result && !m_isPresentation && m_result->isCompared();
}

Interval PlotFigure::sampledRange() const
{
    const Sampling &sampling = m_result->sampling;
    const Interval range{sampling.start, sampling.start + sampling.duration};
    return range.length() > 0.0 ? range : Interval{range.lower - 0.5, range.upper + 0.5};
}

void PlotFigure::zoomTime(const Interval &range)
{
    const Interval outer = sampledRange();
    const double largest = std::max(std::abs(outer.lower), std::abs(outer.upper));
    const double length = std::max(range.length(), kMinRangeFraction * largest);
    m_zoom.time.reset();
    if (length < outer.length()) {
        const double lower = std::clamp(range.lower, outer.lower, outer.upper - length);
        m_zoom.time = {lower, lower + length};
    }
    requestRefresh();
}

void PlotFigure::zoomValues(std::size_t plot, const Interval &range)
{
    constexpr double kLargestValue = 1e60;
    const double largest = std::max(std::abs(range.lower), std::abs(range.upper));
    if (range.length() >= kMinRangeFraction * largest && largest <= kLargestValue) {
        m_zoom.values[plot] = range;
        requestRefresh();
    }
}

bool PlotFigure::isOverAngle() const
{
    return m_settings.abscissa == Abscissa::CrankAngle && m_result->mechanism.omega2() != 0.0;
}

double PlotFigure::perSecond() const
{
    return isOverAngle() ? shownValue(Measure::Angle, m_result->mechanism.omega2(), notation().units) : 1.0;
}

double PlotFigure::zeroTime() const
{
    return isOverAngle() ? -m_result->mechanism.theta20() / m_result->mechanism.omega2() : 0.0;
}

/// Returns how the values of a plot are shown. Errors need no conversion: they are computed in the unit that is shown.
ShownScale PlotFigure::shownScaleOf(std::size_t plot) const
{
    return isErrorPlot(plot) ? ShownScale()
                             : shownScale(kPlottedChannels[channelIndex(plot)], m_result->mechanism.branch());
}

bool PlotFigure::isLogarithmic(std::size_t plot) const
{
    return isErrorPlot(plot) && m_settings.logarithmicError;
}

/// Returns the name of a motion in the legend, which says why its curves have gaps.
QString PlotFigure::nameWithGaps(const QString &name, const ShownMotion &shown)
{
    constexpr std::size_t kAnyChannel = 0; // all of them have the same gaps
    const auto isGap = [](const CurvePoint &point) { return std::isnan(point.value); };
    const bool hasGaps = std::ranges::any_of(shown.curves[kAnyChannel].points, isGap) && shown.motion.canHaveGaps();
    return hasGaps ? tr("%1 (gaps: cannot be assembled)").arg(name) : name;
}

/// Returns the curve of a pinned motion. `pinned`: its index, from the oldest.
PlotCurve PlotFigure::pinnedCurve(std::size_t pinned, std::size_t channel) const
{
    const MotionCurves &motion = m_pinned[pinned].motion;
    const MotionCurves::Curve &computed = m_pinned[pinned].curves[channel];
    PlotCurve curve;
    curve.name = nameWithGaps(pinnedText(m_result->pinned[pinned], m_result->mechanism.parameters()), m_pinned[pinned]);
    curve.ink = kPinnedColours[pinned];
    curve.points = computed.points;
    curve.readout = [&motion, channel](const ReadTime &at) { return CurvePoint{at.t, motion.value(channel, at.t)}; };
    curve.valueAt = [&motion, channel](double t) { return motion.value(channel, t); };
    curve.rank = PlotCursor::Rank::Pinned;
    curve.dashes = computed.isDense ? QVector<double>() : kPinnedDashes[pinned];
    curve.width = m_isPresentation ? kCurveWidth : kThinWidth;
    return curve;
}

/// Returns the curve of the model. Samples that are too few for a curve are drawn as dots, and the name says so.
PlotCurve PlotFigure::modelCurve(std::size_t channel) const
{
    const std::vector<Parameters> &pinned = m_result->pinned;
    const Parameters &parameters = m_result->mechanism.parameters();
    const bool isNamed = m_isPresentation && !pinned.empty() && pinned.back() != parameters;
    PlotCurve curve;
    curve.name = isNamed ? pinnedText(parameters, pinned.back()) : tr("model");
    curve.points = m_model->curves[channel].points;
    curve.readout = [this, channel](const ReadTime &at) { return modelPoint(channel, at); };
    if (model().isExact()) {
        curve.valueAt = [this, channel](double t) { return model().value(channel, t); };
        curve.name = nameWithGaps(curve.name, *m_model);
        return curve;
    }
    constexpr std::size_t kPixelsPerDot = 12;
    const QString fewSamples = fewSamplesSentence(m_result->mechanism, m_result->sampling);
    if (!fewSamples.isEmpty()) {
        curve.name = fewSamples;
    }
    if (!fewSamples.isEmpty() || curve.points.size() * kPixelsPerDot < m_columns) {
        curve.dots = curve.points;
    }
    if (!fewSamples.isEmpty() && !m_model->curves[channel].isDense) { // dense samples look like a band
        curve.points.clear();
    }
    return curve;
}

/// Requires the channel to be in the file.
PlotCurve PlotFigure::fileCurve(std::size_t channel) const
{
    const Reference &file = *m_result->reference;
    const ReferenceSeries &series = *file.data.find(kPlottedChannels[channel]);
    PlotCurve curve;
    curve.name = file.name;
    curve.ink = &SeriesColours::reference;
    curve.points = decimate(file.data.time, series.values, timeRange(), m_columns);
    curve.readout = [this, channel](const ReadTime &at) { return filePoint(channel, at); };
    curve.rank = PlotCursor::Rank::File;
    curve.dashes = kReferenceDashes;
    return curve;
}

/// Returns why a curve of the channel is missing, or an empty text.
QString PlotFigure::noteOfMotions(std::size_t channel) const
{
    if (!m_model->curves[channel].values) {
        return missingModel();
    }
    const Reference *file = m_result->reference.get();
    return file && !file->data.find(kPlottedChannels[channel]) ? tr("not in the file") : QString();
}

/// Adds the curves of a channel, and sets the note and the range of values.
void PlotFigure::computeMotions(Plot &plot, std::size_t channel)
{
    for (std::size_t i = 0; i < m_pinned.size(); ++i) {
        plot.curves.push_back(pinnedCurve(i, channel));
        include(plot.values, m_pinned[i].curves[channel].values);
    }
    plot.curves.push_back(modelCurve(channel));
    include(plot.values, m_model->curves[channel].values);
    const Reference *file = m_result->reference.get();
    if (file && file->data.find(kPlottedChannels[channel])) {
        const PlotCurve &curve = plot.curves.emplace_back(fileCurve(channel));
        include(plot.values, usualRange(curve.points, timeRange()));
    }
    plot.note = noteOfMotions(channel);
    if (plot.values) {
        plot.values = roundedOutwards(*plot.values);
    }
}

PlotCurve PlotFigure::errorCurve(std::size_t channel) const
{
    const bool hasFile = m_result->reference != nullptr;
    const bool isSlider = kPlottedChannels[channel].coordinate == R4x;
    PlotCurve curve;
    curve.ink = errorInk(channel);
    if (hasFile) {
        curve.name = isSlider ? tr("error of the slider") : tr("error of the coupler");
    } else {
        const QString name =
            isSlider ? tr("difference of the slider from %1") : tr("difference of the coupler from %1");
        curve.name = name.arg(m_style.comparedWith);
    }
    const bool isNarrow = m_style.maxColumns < kPlotColumns; // then the titles have no space for the measure
    if (isNarrow && m_style.error == ErrorMeasure::OfPeak) {
        curve.name += QStringLiteral(" (%1)").arg(tr("% of peak"));
    }
    curve.width = kErrorWidth;
    curve.readout = [this, channel](const ReadTime &at) { return errorPoint(channel, at); };
    if (!hasFile && model().isExact()) {
        curve.valueAt = [this, channel](double t) {
            return m_errors->error(channel, model().value(channel, t), lastPinnedValue(channel, t));
        };
    }
    const std::vector<double> &values = (*m_errors)[channel].values;
    const auto isVisibleError = [this](double error) {
        return m_settings.logarithmicError ? std::isfinite(error) : error > 0.0;
    };
    if (hasFile || std::ranges::any_of(values, isVisibleError)) { // pinned motions without any difference have no curve
        curve.points = decimate(m_errors->time().first(values.size()), values, timeRange(), m_columns);
    }
    return curve;
}

/// Returns the error that the rounding of the file alone can cause.
PlotCurve PlotFigure::roundingCurve(std::size_t channel) const
{
    const MotionErrors::Errors &errors = (*m_errors)[channel];
    PlotCurve curve{tr("file's rounding"), &SeriesColours::text};
    curve.width = kThinWidth;
    curve.dashes = kRoundingDashes;
    curve.points = decimate(m_errors->time(), errors.reference, timeRange(), m_columns);
    for (CurvePoint &point : curve.points) {
        const double halfStep = 0.5 * errors.series->rounding.stepAt(point.value);
        point.value = m_errors->error(channel, point.value + halfStep, point.value);
    }
    return curve;
}

/// Returns marks at the upper edge of the axes, at the time stamps at which the error of a channel is undefined. Of
/// several marks within a pixel, one is drawn.
PlotCurve PlotFigure::undefinedMarks(std::size_t channel) const
{
    PlotCurve marks;
    marks.name = tr("undefined: the reference is 0");
    marks.ink = errorInk(channel);
    const double pixel = timeRange().length() / static_cast<double>(m_columns);
    for (const double t : (*m_errors)[channel].undefined) {
        if (marks.dots.empty() || t - marks.dots.back().t >= pixel) {
            marks.dots.push_back({t, PlotCurve::kUpperEdge});
        }
    }
    return marks;
}

/// Returns the range of an axis for errors in the given range. It starts at zero or, if the axis is logarithmic,
/// contains whole decades, at least one and at most kMaxDecades.
Interval PlotFigure::errorRange(const Interval &errors) const
{
    constexpr double kMaxDecades = 8.0;
    if (!m_settings.logarithmicError) {
        return {0.0, roundedOutwards({0.0, errors.upper}).upper};
    }
    const double upper = std::ceil(errors.upper);
    const double lower = std::max(std::floor(errors.lower), upper - kMaxDecades);
    return {std::min(lower, upper - 1.0), upper};
}

/// Adds the errors of both channels of that order, and sets the note and the range of values.
void PlotFigure::computeErrors(Plot &plot, Order order)
{
    std::vector<PlotCurve> roundings; // added last, so that they follow the errors in the legend
    const auto [coupler, slider] = errorChannels(order);
    for (const std::size_t channel : {coupler, slider}) {
        const MotionErrors::Errors &errors = (*m_errors)[channel];
        if (errors.reference.empty()) {
            continue;
        }
        const PlotCurve &curve = plot.curves.emplace_back(errorCurve(channel));
        if (const std::optional<Interval> range = usualRange(curve.points, timeRange(), errors.isUnbounded)) {
            include(plot.values, errorRange(*range));
        }
        if (errors.series && m_settings.roundingBand && errors.series->rounding.stepAt(errors.peak) > 0.0) {
            roundings.push_back(roundingCurve(channel));
        }
        if (!errors.undefined.empty()) {
            plot.curves.push_back(undefinedMarks(channel));
        }
    }
    std::ranges::move(roundings, std::back_inserter(plot.curves));
    if (!plot.values) {
        plot.note = missingErrors(order);
    }
}

/// Returns the reason why a plot shows no values of the model.
QString PlotFigure::missingModel() const
{
    return model().isExact() ? tr("the mechanism cannot be assembled") : tr("no time step is solved");
}

/// Returns the reason why a plot shows no errors.
QString PlotFigure::missingErrors(Order order) const
{
    const ErrorChannels channels = errorChannels(order);
    const MotionErrors::Errors &coupler = (*m_errors)[channels.coupler];
    const MotionErrors::Errors &slider = (*m_errors)[channels.slider];
    if (coupler.reference.empty() && slider.reference.empty()) {
        return tr("not in the file");
    }
    if (!m_model->curves[channels.coupler].values) {
        return missingModel();
    }
    if (!coupler.undefined.empty() || !slider.undefined.empty()) {
        return tr("undefined: the reference is 0");
    }
    const std::optional<MotionDifference> &difference = m_result->difference;
    const bool isEqual = difference && difference->channels[channels.coupler].largestError == 0.0;
    return isEqual ? tr("no difference") : tr("nothing to compare");
}

ReadTime PlotFigure::readTime(double t) const
{
    const std::optional<std::size_t> row = nearestRow(t);
    return {row ? m_result->reference->data.time[*row] : model().nearestTime(t), row};
}

/// Returns the row of the file that is nearest to that time, or nullopt if there is no file or the time is outside it.
std::optional<std::size_t> PlotFigure::nearestRow(double t) const
{
    if (!m_result->reference) {
        return std::nullopt;
    }
    const std::vector<double> &time = m_result->reference->data.time;
    return t >= time.front() && t <= time.back() ? std::optional(nearestIndex(time, t)) : std::nullopt;
}

/// Returns the value of the model at the nearest time at which it is known. A sampled motion is known at its time steps
/// and at the rows of the file.
CurvePoint PlotFigure::modelPoint(std::size_t channel, const ReadTime &time) const
{
    const double nearest = model().nearestTime(time.t);
    // At the file's time stamps only the channels of the file are sampled.
    const std::vector<double> &sampled = m_result->atReference[kPlottedChannels[channel]];
    if (time.row && *time.row < sampled.size()) {
        const double timeOfRow = m_result->reference->data.time[*time.row];
        if (std::abs(timeOfRow - time.t) <= std::abs(nearest - time.t)) {
            return {timeOfRow, sampled[*time.row]};
        }
    }
    return {nearest, model().value(channel, nearest)};
}

CurvePoint PlotFigure::filePoint(std::size_t channel, const ReadTime &time) const
{
    const ReferenceSeries *series = m_result->reference->data.find(kPlottedChannels[channel]);
    return series && time.row ? CurvePoint{m_result->reference->data.time[*time.row], series->values[*time.row]}
                              : CurvePoint{time.t, kNone};
}

double PlotFigure::lastPinnedValue(std::size_t channel, double t) const
{
    return m_pinned.back().motion.value(channel, t);
}

/// Returns the difference from the file at its nearest row, or from the last pinned motion.
CurvePoint PlotFigure::errorPoint(std::size_t channel, const ReadTime &time) const
{
    if (!m_result->reference) {
        const CurvePoint model = modelPoint(channel, time);
        return {model.t, m_errors->error(channel, model.value, lastPinnedValue(channel, model.t))};
    }
    const CurvePoint file = filePoint(channel, time);
    return {file.t, m_errors->error(channel, modelPoint(channel, {file.t, time.row}).value, file.value)};
}

/// Returns the value of a drawn curve at that time, or nullopt where it has a gap.
static std::optional<double> drawnValue(const std::vector<CurvePoint> &points, double t)
{
    const auto after = std::ranges::lower_bound(points, t, {}, &CurvePoint::t);
    if (after == points.begin() || after == points.end()) {
        return std::nullopt;
    }
    const CurvePoint &before = *std::prev(after);
    const double value = std::lerp(before.value, after->value, (t - before.t) / (after->t - before.t));
    return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::optional<PlotCursor> PlotFigure::cursorAt(std::size_t index, double time, const QStringList &headings) const
{
    constexpr double kRoundingError = 1e-9; // fraction of the length of the axis
    constexpr double kPixel = 1.0;          // px by which a dot on the edge of the axes may lie outside
    const Plot &plot = m_plots[index];
    if (!plot.values || !timeRange().contains(time)) {
        return std::nullopt;
    }
    const QString timeOfCursor = timeText(time);
    PlotCursor cursor{std::round(plot.timeAxis->coordToPixel(time))};
    for (const QString &heading : headings) {
        cursor.labels.push_back({QStaticText(heading), m_colours.text});
    }
    for (const PlotReading &reading : readings(index, {time, nearestRow(time)})) {
        const QPointF place(plot.timeAxis->coordToPixel(reading.t), plot.valueAxis->coordToPixel(reading.value));
        if (QRectF(plot.axes->rect()).adjusted(-kPixel, -kPixel, kPixel, kPixel).contains(place)) {
            // On a linear axis, a value that is far below a pixel is the rounding error of zero.
            const double range = shownScaleOf(index).factor * plot.valueAxis->range().size();
            const bool isZero = !isLogarithmic(index) && std::abs(reading.number) < kRoundingError * range;
            const QString number = shortNumber(isZero ? 0.0 : reading.number);
            const bool isOfCursor = timeText(reading.t) == timeOfCursor;
            PlotCursor::Label &label = cursor.labels.emplace_back();
            label.text = QStaticText(isOfCursor ? number : u'≈' + number);
            label.colour = m_colours.*reading.ink;
            label.dot = place;
            label.rank = reading.rank;
            if (const std::optional<double> drawn = drawnValue(plot.curves[reading.curve].points, time)) {
                label.crossing = plot.valueAxis->coordToPixel(*drawn);
            }
        }
    }
    addCurvesBeside(cursor, plot);
    return cursor;
}

/// Adds points of the straight line from one point (left out) to another, both in px, `spacing` (px) apart.
static void addLine(std::vector<QPointF> &points, QPointF from, QPointF to, double spacing)
{
    const double steps = std::ceil(std::max(std::abs(to.x() - from.x()), std::abs(to.y() - from.y())) / spacing);
    for (int i = 1; i <= static_cast<int>(steps); ++i) {
        points.push_back(from + (i / steps) * (to - from));
    }
}

/// Adds to the cursor closely spaced points of the plot's curves on both sides of its line.
void PlotFigure::addCurvesBeside(PlotCursor &cursor, const Plot &plot) const
{
    const double reach = curveReach(m_fonts.tick);
    const double spacing = curveSpacing(m_fonts.tick);
    const QRectF axes(plot.axes->rect());
    std::vector<std::optional<QPointF>> previous(plot.curves.size());
    for (double x = cursor.x - reach; x <= cursor.x + reach; x += spacing) {
        const double time = plot.timeAxis->pixelToCoord(x);
        if (!timeRange().contains(time)) {
            continue;
        }
        const ReadTime read{time, nearestRow(time)};
        for (std::size_t i = 0; i < plot.curves.size(); ++i) {
            const PlotCurve &curve = plot.curves[i];
            const CurvePoint point = curve.readout ? curve.readout(read) : CurvePoint{time, kNone};
            if (!std::isfinite(point.value)) {
                previous[i].reset();
                continue;
            }
            const double y = std::clamp(plot.valueAxis->coordToPixel(point.value), axes.top(), axes.bottom());
            const QPointF place(plot.timeAxis->coordToPixel(point.t), y);
            addLine(cursor.curvePoints, previous[i].value_or(place - QPointF(spacing, 0.0)), place, spacing);
            previous[i] = place;
        }
    }
}

/// Returns the time of a cursor and, where they differ, the times of the values that begin with "≈".
QStringList PlotFigure::cursorTexts(double t) const
{
    const QString time = timeText(t);
    QStringList texts(time);
    const auto addIfDifferent = [&](const QString &name, double other) {
        if (timeText(other) != time) {
            texts << name.arg(timeText(other));
        }
    };
    constexpr std::size_t kAnyChannel = 0; // all channels of the model have the same time steps
    addIfDifferent(tr("≈ time step: %1"), modelPoint(kAnyChannel, {t, nearestRow(t)}).t);
    if (const std::optional<std::size_t> row = nearestRow(t)) {
        addIfDifferent(tr("≈ file: %1"), m_result->reference->data.time[*row]);
    }
    return texts;
}

std::vector<PlotReading> PlotFigure::readings(std::size_t plot, const ReadTime &time) const
{
    std::vector<PlotReading> readings;
    const std::vector<PlotCurve> &curves = m_plots[plot].curves;
    for (std::size_t i = 0; i < curves.size(); ++i) {
        const PlotCurve &curve = curves[i];
        const CurvePoint point = curve.readout ? curve.readout(time) : CurvePoint{time.t, kNone};
        if (std::isfinite(point.value)) {
            const double number =
                isLogarithmic(plot) ? std::pow(10.0, point.value) : shownScaleOf(plot).shown(point.value);
            readings.push_back({.t = point.t,
                                .value = point.value,
                                .number = number,
                                .ink = curve.ink,
                                .rank = curve.rank,
                                .curve = i});
        }
    }
    return readings;
}

QString PlotFigure::timeText(double t, const std::optional<double> &since) const
{
    const double number = (t - since.value_or(zeroTime())) * perSecond();
    const QString unit = isOverAngle() ? shownUnit(Measure::Angle) : QStringLiteral("s");
    return QStringLiteral("%1%2 = %3")
        .arg(since ? "Δ" : "", isOverAngle() ? "θ₂" : "t", withUnit(shortNumber(number), unit));
}

} // namespace slidercrank
