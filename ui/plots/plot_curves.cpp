// SPDX-License-Identifier: GPL-3.0-or-later

// Computes what the plots show: the curves, the errors and the values at a time.

#include "ui/plots/plot_figure.h"

#include "ui/text/axis_scale.h"
#include "ui/text/finding_text.h"
#include "ui/text/motion_facts.h"
#include "ui/text/written_number.h"

#include <algorithm>
#include <cmath>

namespace slidercrank
{

namespace
{

constexpr double kSmallestPart = 1e-10; // of the largest number on an axis; limits the zoom
constexpr std::size_t kErrorsPerRow = 2;

/// Lengths of dashes and gaps, px. Each pinned motion has its own pattern.
const QVector<double> kReferenceDashes{7.0, 6.0};
const std::array<QVector<double>, kMaxPinned> kPinnedDashes{{{}, {13.0, 4.0}, {5.0, 4.0}, {2.0, 3.0}}};

Interval unite(const Interval &a, const Interval &b)
{
    return {std::min(a.lower, b.lower), std::max(a.upper, b.upper)};
}

void include(std::optional<Interval> &range, const std::optional<Interval> &other)
{
    range = range && other ? unite(*range, *other) : range ? range : other;
}

std::optional<Interval> extremesWithin(const Interval &time, const std::vector<CurvePoint> &points)
{
    return extremes(clip(points, time, {-1e300, 1e300}));
}

/// Returns the range of the error axis. It starts at zero or, if logarithmic, contains at most eight decades. Where
/// errors are unbounded, it contains nine tenths of them.
Interval errorRange(const std::vector<CurvePoint> &points, const Interval &extent, bool isUnbounded, bool isLogarithmic)
{
    const double largest = isUnbounded ? quantile(points, 0.9) : extent.upper;
    if (!isLogarithmic) {
        return {0.0, roundedOutwards({0.0, largest}).upper};
    }
    constexpr double kMostDecades = 8.0;
    const double upper = std::ceil(largest);
    return {std::min(std::max(std::floor(extent.lower), upper - kMostDecades), upper - 1.0), upper};
}

} // namespace

void PlotFigure::setResult(const std::shared_ptr<const Result> &result)
{
    const Interval before = sampledRange();
    const bool isFirst = !m_result;
    m_result = result;
    m_model.reset();
    m_pinned.clear();
    m_errors.reset();
    if (isFirst || sampledRange() != before) {
        zoom.time.reset();
    }
}

void PlotFigure::setSettings(const PlotSettings &settings)
{
    for (std::size_t plot = kErrorColumn; plot < kPlotCount; plot += kPlotColumns) {
        zoom.values[plot].reset(); // the ranges are not valid for another measure
    }
    m_settings = settings;
    m_errors.reset();
}

bool PlotFigure::hasErrors() const
{
    return m_result && !m_isPresentation && (m_result->reference || m_result->difference);
}

Interval PlotFigure::sampledRange() const
{
    const Sampling sampling = m_result ? m_result->sampling : Sampling();
    const auto [first, last] = std::minmax({sampling.start, sampling.start + sampling.duration});
    return last > first ? Interval{first, last} : Interval{first - 0.5, last + 0.5};
}

void PlotFigure::zoomTime(const Interval &range)
{
    Interval outer = sampledRange();
    if (m_result && m_result->reference && !m_result->reference->data.time.empty()) {
        const std::vector<double> &time = m_result->reference->data.time;
        outer = unite(outer, Interval{time.front(), time.back()});
    }
    const double largest = std::max(std::abs(outer.lower), std::abs(outer.upper));
    const double length = std::clamp(range.length(), kSmallestPart * largest, outer.length());
    const double lower = std::clamp(range.lower, outer.lower, outer.upper - length);
    zoom.time = Interval{lower, length < outer.length() ? lower + length : outer.upper};
    if (*zoom.time == sampledRange()) {
        zoom.time.reset();
    }
}

void PlotFigure::zoomValues(std::size_t plot, const Interval &range)
{
    constexpr double kLargestValue = 1e60;
    const double largest = std::max(std::abs(range.lower), std::abs(range.upper));
    if (range.length() >= kSmallestPart * largest && largest <= kLargestValue) {
        zoom.values[plot] = range;
    }
}

bool PlotFigure::isOverAngle() const
{
    return m_settings.abscissa == Abscissa::CrankAngle && m_result && m_result->mechanism.omega2() != 0.0;
}

MotionCurves &PlotFigure::model()
{
    if (!m_model) {
        const Interval time = sampledRange();
        m_model = m_result->solver.method == Method::ClosedForm ? MotionCurves(m_result->mechanism, time)
                                                                : MotionCurves(m_result->trajectory);
        for (const Parameters &parameters : m_result->pinned) {
            m_pinned.emplace_back(Mechanism(parameters), time);
        }
    }
    return *m_model;
}

const MotionErrors &PlotFigure::errors()
{
    if (!m_errors) {
        m_errors.emplace(*m_result, m_settings, timeRange(), m_columns);
    }
    return *m_errors;
}

void PlotFigure::computeMotions(Plot &plot, std::size_t channel)
{
    const Interval time = timeRange();
    std::optional<Interval> extent;
    const auto add = [&](const QString &name, Ink ink, const MotionCurves::Curve &curve) -> PlotCurve & {
        include(extent, curve.extremes);
        return plot.curves.emplace_back(PlotCurve{name, ink, curve.points});
    };
    const auto isDense = [this](const PlotCurve &curve) { return 2 * curve.points.size() >= 3 * m_columns; };
    const MotionCurves::Curve &motion = model().curves(time, m_columns)[channel];
    for (std::size_t i = 0; i < m_pinned.size(); ++i) {
        PlotCurve &curve = add(pinnedText(m_result->pinned[i], m_result->mechanism.parameters()),
                               &SeriesColours::pinned, m_pinned[i].curves(time, m_columns)[channel]);
        curve.dashes = isDense(curve) ? QVector<double>() : kPinnedDashes[i];
        curve.width = m_isPresentation ? curve.width : 1.0;
    }
    PlotCurve &curve = add(modelName(), &SeriesColours::model, motion);
    if (!model().isExact()) {
        constexpr std::size_t kPixelsPerDot = 12;
        const bool isTooFew = !fewSamplesSentence(m_result->mechanism, m_result->sampling).isEmpty();
        if (isTooFew || curve.points.size() * kPixelsPerDot < m_columns) {
            curve.dots = curve.points;
        }
        if (isTooFew && !isDense(curve)) { // dense samples look like a band
            curve.points.clear();
        }
    }
    if (!motion.extremes) {
        plot.note = tr("the mechanism cannot be assembled");
    }
    if (const Reference *reference = m_result->reference.get()) {
        if (const ReferenceSeries *series = reference->data.find(kPlottedChannels[channel])) {
            const std::vector<CurvePoint> points = decimate(reference->data.time, series->values, time, m_columns);
            add(reference->name, &SeriesColours::reference, {points, extremesWithin(time, points)}).dashes =
                kReferenceDashes;
        } else if (plot.note.isEmpty()) {
            plot.note = tr("not in the file");
        }
    }
    if (extent) {
        plot.values = roundedOutwards(*extent);
    }
}

PlotCurve PlotFigure::errorCurve(std::size_t channel)
{
    const bool isCoupler = isAngle(kPlottedChannels[channel].coordinate);
    const QString ofFile = isCoupler ? tr("error of the coupler") : tr("error of the slider");
    const QString ofPinned = isCoupler ? tr("difference of the coupler") : tr("difference of the slider");
    PlotCurve curve{m_result->reference ? ofFile : ofPinned,
                    isCoupler ? &SeriesColours::error : &SeriesColours::errorOther};
    curve.width = 1.6; // thin, since the errors of a matching file are noise
    const MotionErrors::Errors &errors = this->errors()[channel];
    const auto isSeen = [this](double error) {
        return m_settings.logarithmicError ? std::isfinite(error) : error > 0.0;
    };
    if (!m_result->reference && std::ranges::none_of(errors.values, isSeen)) {
        return curve; // no difference
    }
    const std::span<const double> time = this->errors().time().first(errors.values.size());
    curve.points = decimate(time, errors.values, timeRange(), m_columns);
    return curve;
}

/// Returns the error that the rounding of the file alone can cause.
PlotCurve PlotFigure::roundingCurve(std::size_t channel)
{
    const MotionErrors::Errors &errors = this->errors()[channel];
    PlotCurve curve{tr("file's rounding"), &SeriesColours::text};
    curve.width = 1.0;
    curve.dashes = {2.0, 3.0};
    curve.points = decimate(this->errors().time(), errors.reference, timeRange(), m_columns);
    for (CurvePoint &point : curve.points) {
        const double half = 0.5 * errors.series->rounding.stepAt(point.value);
        point.value = this->errors().error(channel, point.value + half, point.value);
    }
    return curve;
}

void PlotFigure::computeErrors(Plot &plot, std::size_t row)
{
    for (std::size_t channel = kErrorsPerRow * row; hasErrors() && channel < kErrorsPerRow * (row + 1); ++channel) {
        const MotionErrors::Errors &errors = this->errors()[channel];
        const PlotCurve curve = plot.curves.emplace_back(errorCurve(channel));
        if (const std::optional<Interval> extent = extremesWithin(timeRange(), curve.points)) {
            include(plot.values, errorRange(curve.points, *extent, errors.isUnbounded, m_settings.logarithmicError));
        }
        if (errors.series && m_settings.roundingBand && errors.series->rounding.stepAt(errors.peak) > 0.0) {
            plot.curves.push_back(roundingCurve(channel));
        }
        if (!errors.undefined.empty()) {
            PlotCurve &marks = plot.curves.emplace_back(PlotCurve{tr("undefined: the reference is 0"), curve.ink});
            for (const double t : errors.undefined) {
                marks.dots.push_back({t, PlotCurve::kUpperEdge});
            }
        }
    }
    if (hasErrors() && !plot.values) {
        plot.note = missingErrors(row);
    }
}

/// Returns the reason why a plot shows no errors.
QString PlotFigure::missingErrors(std::size_t row)
{
    const std::size_t channel = kErrorsPerRow * row;
    if (errors()[channel].reference.empty() && errors()[channel + 1].reference.empty()) {
        return tr("not in the file");
    }
    if (!model().curves(timeRange(), m_columns)[channel].extremes) {
        return tr("the mechanism cannot be assembled");
    }
    if (!errors()[channel].undefined.empty() || !errors()[channel + 1].undefined.empty()) {
        return tr("undefined: the reference is 0");
    }
    return m_result->difference && m_result->difference->channels[channel].maxAbs == 0.0 ? tr("no difference")
                                                                                         : tr("nothing to compare");
}

/// Returns "model", or in presentation mode the parameters that differ from the motion pinned last.
QString PlotFigure::modelName() const
{
    const Parameters &model = m_result->mechanism.parameters();
    const QString tooFew = model.omega2 != 0.0 && m_result->solver.method == Method::Newton
                               ? fewSamplesSentence(m_result->mechanism, m_result->sampling)
                               : QString();
    const bool isNamed = m_isPresentation && !m_result->pinned.empty() && m_result->pinned.back() != model;
    return !tooFew.isEmpty() ? tooFew : isNamed ? pinnedText(model, m_result->pinned.back()) : tr("model");
}

QString PlotFigure::errorUnit(std::size_t channel) const
{
    switch (m_settings.error) {
    case ErrorMeasure::Percent: return QStringLiteral("%");
    case ErrorMeasure::Absolute:
        return QStringLiteral("%1; %2").arg(unitOf(kPlottedChannels[channel]), unitOf(kPlottedChannels[channel + 1]));
    case ErrorMeasure::OfPeak: return tr("% of peak");
    }
    return {};
}

ReadTime PlotFigure::readTime(double t)
{
    if (m_result && m_result->reference) {
        const std::vector<double> &time = m_result->reference->data.time;
        if (!time.empty() && t >= time.front() && t <= time.back()) {
            const std::size_t row = nearestIndex(time, t);
            return {time[row], row};
        }
    }
    return {m_result ? model().nearestTime(t) : t, std::nullopt};
}

std::vector<PlotReading> PlotFigure::readings(std::size_t plot, const ReadTime &time)
{
    std::vector<PlotReading> readings;
    if (!m_result) {
        return readings;
    }
    const auto add = [&](double value, Ink ink, bool isLogarithm = false) {
        if (std::isfinite(value)) {
            readings.push_back({value, isLogarithm ? std::pow(10.0, value) : value, ink});
        }
    };
    const MotionCurves &motion = model();
    // At the file's time stamps only the channels of the file are sampled.
    const auto modelAt = [&](std::size_t channel) {
        const std::vector<double> &sampled = m_result->atReference[kPlottedChannels[channel]];
        return time.row && *time.row < sampled.size() ? sampled[*time.row] : motion.value(channel, time.t);
    };
    if (!isErrorPlot(plot)) {
        const std::size_t channel = channelOf(plot);
        add(modelAt(channel), &SeriesColours::model);
        for (const MotionCurves &pinned : m_pinned) {
            add(pinned.value(channel, time.t), &SeriesColours::pinned);
        }
        if (time.row) {
            const ReferenceSeries *series = m_result->reference->data.find(kPlottedChannels[channel]);
            add(series ? series->values[*time.row] : kNoValue, &SeriesColours::reference);
        }
        return readings;
    }
    const std::size_t first = plot / kPlotColumns * kErrorsPerRow;
    for (std::size_t channel = first; hasErrors() && channel < first + kErrorsPerRow; ++channel) {
        const std::vector<double> &values = errors()[channel].values;
        double error = kNoValue;
        if (time.row && !values.empty()) {
            error = values[*time.row];
        } else if (!m_result->reference) {
            error = errors().error(channel, modelAt(channel), m_pinned.back().value(channel, time.t));
        }
        add(error, channel == first ? &SeriesColours::error : &SeriesColours::errorOther, m_settings.logarithmicError);
    }
    return readings;
}

QString PlotFigure::timeText(double t) const
{
    if (!isOverAngle()) {
        return QStringLiteral("t = %1").arg(durationText(t));
    }
    return QStringLiteral("θ₂ = %1").arg(
        durationText(t + m_result->mechanism.theta20() / m_result->mechanism.omega2()));
}

QString PlotFigure::durationText(double seconds) const
{
    return isOverAngle() ? numberText(seconds * m_result->mechanism.omega2() * kDegreesPerRadian) + u'°'
                         : tr("%1 s").arg(numberText(seconds));
}

} // namespace slidercrank
