// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/plot_figure.h"

#include "ui/document/with.h"
#include "ui/text/finding_text.h"
#include "ui/text/motion_facts.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace slidercrank
{

namespace
{

constexpr double kSmallestPart = 1e-10; // of the largest number on an axis: what one can zoom to

Interval sampledRange(const Sampling &sampling)
{
    const double end = sampling.start + sampling.duration;
    const Interval range{std::min(sampling.start, end), std::max(sampling.start, end)};
    return range.length() > 0.0 ? range : Interval{range.lower - 0.5, range.upper + 0.5};
}

Interval united(const Interval &a, const Interval &b)
{
    return {std::min(a.lower, b.lower), std::max(a.upper, b.upper)};
}

std::optional<Interval> united(const std::optional<Interval> &a, const std::optional<Interval> &b)
{
    return a && b ? united(*a, *b) : a ? a : b;
}

/// Shifted into the bounds, cut where it is longer than they are.
Interval broughtInto(const Interval &bounds, Interval range)
{
    if (range.length() >= bounds.length()) {
        return bounds;
    }
    const double lower = std::clamp(range.lower, bounds.lower, bounds.upper - range.length());
    return {lower, lower + range.length()};
}

/// Shrunk or widened about one of its points.
Interval scaled(const Interval &range, double about, double factor)
{
    return {about - (about - range.lower) * factor, about + (range.upper - about) * factor};
}

/// As many ticks as labels fit side by side.
AxisScale timeScale(const Interval &range, bool isAngle, double width, double digitWidth)
{
    constexpr double kSpace = 14.0;
    double wanted = 44.0; // px from tick to tick
    for (;;) {
        const AxisScale scale = isAngle ? degreeScale(range, width / wanted) : axisScale(range, width / wanted);
        const double needed = digitWidth * scale.labelLength(range) + kSpace;
        const double between = scale.step / range.length() * width;
        if (between >= needed || wanted >= width) {
            return scale;
        }
        wanted = std::max(needed, 1.3 * wanted);
    }
}

/// In the chosen measure, as the axis has it; NaN where it is infinite or has no logarithm.
double shownError(const ShownChannel &channel, const PlotSettings &settings, double difference, double reference)
{
    double error = std::abs(difference) * channel.perDifference;
    if (settings.error == ErrorMeasure::Percent) {
        error = reference == 0.0 ? kNoValue : error / std::abs(reference);
    }
    if (settings.logarithmicError) {
        error = error > 0.0 ? std::log10(error) : kNoValue;
    }
    return error;
}

void setMeasure(ShownChannel &channel, ErrorMeasure measure, const ChannelComparison *comparison)
{
    constexpr double kPercent = 100.0;
    switch (measure) {
    case ErrorMeasure::Percent:
        channel.perDifference = kPercent;
        channel.largestError = comparison ? comparison->maxPercent : std::nullopt;
        break;
    case ErrorMeasure::Absolute: channel.largestError = comparison ? comparison->maxAbs : std::nullopt; break;
    case ErrorMeasure::OfPeak: {
        const std::optional<Interval> range = extremes(channel.reference);
        const double peak = range ? std::max(std::abs(range->lower), std::abs(range->upper)) : 0.0;
        channel.perDifference = peak > 0.0 ? kPercent / peak : kNoValue;
        channel.largestError = comparison ? comparison->percentOfPeak : std::nullopt;
        break;
    }
    }
}

/// Of a difference from a motion that was kept.
void setMeasure(ShownChannel &channel, ErrorMeasure measure, const ChannelDifference &difference)
{
    const bool isOfPeak = measure == ErrorMeasure::OfPeak;
    constexpr double kPercent = 100.0;
    if (isOfPeak) {
        channel.perDifference = difference.percentOfPeak ? kPercent / difference.peak : kNoValue;
    }
    channel.largestError = isOfPeak ? difference.percentOfPeak : difference.maxAbs;
    if (channel.largestError && !std::isfinite(*channel.largestError)) {
        channel.largestError.reset();
    }
}

/// What an axis holds of differences: where they grow beyond all bounds, nine tenths of them.
std::optional<Interval> extentOf(const std::vector<CurvePoint> &points, bool isBounded, bool isLogarithmic)
{
    std::vector<double> values;
    for (const CurvePoint &point : points) {
        if (std::isfinite(point.value)) {
            values.push_back(point.value);
        }
    }
    if (values.empty()) {
        return std::nullopt;
    }
    constexpr std::size_t kOneInSoMany = 10;
    const auto last = values.end() - 1 - (isBounded ? 0 : static_cast<std::ptrdiff_t>(values.size() / kOneInSoMany));
    std::ranges::nth_element(values, last);
    const double largest = *last;
    constexpr double kDecades = 4.0; // down to where the motions cross it goes for ever
    return Interval{isLogarithmic ? largest - kDecades : 0.0, largest};
}

/// The part of `whole` that lies as `part` lies in `of`.
Interval correspondingRange(const Interval &part, const Interval &of, const Interval &whole)
{
    const double perUnit = whole.length() / of.length();
    return {whole.lower + (part.lower - of.lower) * perUnit, whole.lower + (part.upper - of.lower) * perUnit};
}

/// Cuts it off at the axes and makes of it what is drawn.
void finishCurve(PlotPicture::Curve &curve, const Interval &time, const Interval &values, const QSize &axes)
{
    const DashPattern pattern{curve.dashes.length, curve.dashes.gap, axes.width() / time.length(),
                              axes.height() / values.length()};
    constexpr double kInvisible = 0.1; // px
    constexpr double kPixelsPerDot = 12.0;
    const bool areFew = static_cast<double>(curve.points.size()) * kPixelsPerDot < axes.width();
    if (!curve.isJoined || (curve.isOfSamples && areFew)) {
        std::ranges::copy_if(curve.points, std::back_inserter(curve.dots), [&](const CurvePoint &point) {
            return time.contains(point.t) && values.contains(point.value);
        });
    }
    if (!curve.isJoined) {
        curve.points.clear();
        return;
    }
    curve.points = clip(curve.points, time, values);
    if (curve.dots.empty()) {
        curve.dots = isolatedPoints(curve.points);
    }
    curve.points = withoutNeedlessPoints(curve.points, kInvisible / pattern.perValue);
    if (curve.dashes.gap > 0.0) {
        curve.points = cutIntoDashes(curve.points, pattern);
    }
}

/// The errors' axis begins at zero; in decades, where the smallest that matters is.
Interval errorRange(const Interval &extent, bool isLogarithmic)
{
    if (!isLogarithmic) {
        return roundedOutwards(united(extent, Interval{0.0, 0.0}));
    }
    constexpr double kMostDecades = 12.0;
    const double upper = std::ceil(extent.upper);
    const double lower = std::max(std::floor(extent.lower), upper - kMostDecades);
    return {std::min(lower, upper - 1.0), upper};
}

/// "coupler angular velocity ", and without the body, which the plot above names.
std::array<QString, 2> wordsBefore(Channel channel)
{
    const QString whole = quantityOf(channel) + u' ';
    switch (channel.order) {
    case Order::Position:
        return {whole, isAngle(channel.coordinate) ? PlotFigure::tr("angle ") : PlotFigure::tr("position ")};
    case Order::Velocity: return {whole, PlotFigure::tr("velocity ")};
    case Order::Acceleration: return {whole, PlotFigure::tr("acceleration ")};
    }
    return {};
}

} // namespace

QString quantity(std::size_t channel)
{
    // Derivatives as fractions: fonts set the dots of θ̇ and R̈ badly or not at all.
    static const std::array<QString, kPlottedChannels.size()> kNames{
        QStringLiteral("θ³"),      QStringLiteral("Rₓ⁴"),      QStringLiteral("dθ³/dt"),
        QStringLiteral("dRₓ⁴/dt"), QStringLiteral("d²θ³/dt²"), QStringLiteral("d²Rₓ⁴/dt²")};
    return kNames[channel];
}

QString channelUnit(std::size_t channel)
{
    return QString::fromUtf8(fileUnit(kPlottedChannels[channel]));
}

ShownData::ShownData(const Result &result, const PlotSettings &shown)
    : settings(shown)
    , model(result)
{
    for (std::size_t i = 0; result.difference && i < channels.size(); ++i) {
        setMeasure(channels[i], settings.error, result.difference->channels[i]);
    }
    if (!result.reference) {
        return;
    }
    const ReferenceData &data = result.reference->data;
    referenceTime = data.time;
    for (std::size_t i = 0; i < channels.size(); ++i) {
        ShownChannel &channel = channels[i];
        channel.series = data.find(kPlottedChannels[i]);
        if (!channel.series) {
            continue;
        }
        channel.reference = channel.series->values;
        channel.modelAtReference = result.atReference[kPlottedChannels[i]];
        const auto comparison = std::ranges::find(result.comparison, kPlottedChannels[i], &ChannelComparison::channel);
        setMeasure(channel, settings.error, comparison == result.comparison.end() ? nullptr : &*comparison);
        channel.errors.reserve(channel.reference.size());
        for (std::size_t k = 0; k < channel.reference.size(); ++k) {
            const double reference = channel.reference[k];
            channel.errors.push_back(shownError(channel, settings, channel.modelAtReference[k] - reference, reference));
            if (reference == 0.0 && settings.error == ErrorMeasure::Percent) {
                channel.zeroReference.push_back(referenceTime[k]);
            }
        }
    }
}

std::vector<CurvePoint> ShownData::roundingBand(std::size_t index, const PixelColumns &pixels) const
{
    constexpr double kHalf = 0.5;
    const ShownChannel &channel = channels[index];
    std::vector<CurvePoint> band = decimate(referenceTime, channel.reference, pixels);
    for (CurvePoint &point : band) {
        point.value = shownError(channel, settings, kHalf * channel.series->rounding.stepAt(point.value), point.value);
    }
    return band;
}

ShownData &PlotFigure::data()
{
    if (!m_data) {
        m_data = result ? ShownData(*result, with(m_settings, &PlotSettings::error, measure())) : ShownData();
    }
    return *m_data;
}

std::vector<PlotFigure::KeptMotion> &PlotFigure::kept()
{
    const std::size_t count = result ? result->kept.size() : 0;
    m_kept.erase(m_kept.begin() + static_cast<std::ptrdiff_t>(std::min(count, m_kept.size())), m_kept.end());
    const Interval run = wholeRange();
    for (std::size_t i = 0; i < count; ++i) {
        const Parameters &parameters = result->kept[i];
        if (i < m_kept.size() && m_kept[i].parameters == parameters && m_kept[i].run == run) {
            continue; // with what it has computed for the pixels
        }
        KeptMotion motion{parameters, run, ModelCurves(Mechanism(parameters), run)};
        if (i < m_kept.size()) {
            m_kept[i] = std::move(motion);
        } else {
            m_kept.push_back(std::move(motion));
        }
    }
    return m_kept;
}

const DifferenceCurves &PlotFigure::differences()
{
    if (!m_differences) {
        m_differences.emplace(result->mechanism, Mechanism(result->kept.back()), wholeRange());
    }
    return *m_differences;
}

double PlotFigure::differenceAt(std::size_t channel, double t)
{
    const ShownData &shown = data();
    return shownError(shown.channels[channel], shown.settings, differences().value(channel, t), 0.0);
}

/// In the chosen measure, as the axis has them.
std::vector<CurvePoint> PlotFigure::differencePoints(std::size_t channel, const Interval &range, std::size_t columns)
{
    if (!m_differenceView || m_differenceView->range != range || m_differenceView->columns != columns) {
        m_differenceView = {range, columns, differences().curves(range, columns)};
    }
    const ShownData &shown = data();
    std::vector<CurvePoint> points = m_differenceView->curves[channel];
    for (CurvePoint &point : points) {
        point.value = shownError(shown.channels[channel], shown.settings, point.value, 0.0);
    }
    return points;
}

double PlotFigure::nearestInstant(double t)
{
    const ModelCurves &model = data().model;
    return model.empty() ? t : model.instantNear(t);
}

double PlotFigure::pointedInstant(double t) const
{
    constexpr double kPart = 1e-4; // of the range: less than a pixel
    const double place = std::pow(10.0, std::floor(std::log10(kPart * timeRange().length())));
    const double rounded = std::round(t / place) * place;
    return std::isfinite(rounded) ? rounded : t;
}

void PlotFigure::setResult(const std::shared_ptr<const Result> &newResult)
{
    if (!newResult || !result || sampledRange(newResult->sampling) != sampledRange(result->sampling)) {
        timeZoom.reset();
    }
    result = newResult;
    m_data.reset();
    m_differences.reset();
    m_differenceView.reset();
}

void PlotFigure::setSettings(const PlotSettings &settings)
{
    for (std::size_t plot = 0; plot < kPlotCount; ++plot) {
        if (isErrorPlot(plot)) {
            valueZoom[plot].reset(); // another measure, other numbers
        }
    }
    m_settings = settings;
    m_data.reset();
}

bool PlotFigure::hasRightAxis(std::size_t plot) const
{
    return isErrorPlot(plot) && m_settings.error == ErrorMeasure::Absolute && hasErrors();
}

ErrorMeasure PlotFigure::measure() const
{
    const bool isOfFile = !result || !result->difference;
    return isOfFile || m_settings.error == ErrorMeasure::Absolute ? m_settings.error : ErrorMeasure::OfPeak;
}

QString PlotFigure::errorUnit(std::size_t channel) const
{
    switch (measure()) {
    case ErrorMeasure::Percent: return QStringLiteral("%");
    case ErrorMeasure::Absolute: return channelUnit(channel);
    case ErrorMeasure::OfPeak: return tr("% of peak");
    }
    return {};
}

PlotPicture::TimeLabels PlotFigure::timeLabels(double width, double digitWidth) const
{
    PlotPicture::TimeLabels labels;
    const double omega2 = result ? result->mechanism.omega2() : 0.0;
    const bool isAngle = m_settings.abscissa == Abscissa::CrankAngle && omega2 != 0.0;
    if (isAngle) {
        labels.perUnit = 1.0 / (omega2 * kDegreesPerRadian);
        labels.zero = -result->mechanism.theta20() / omega2;
    }
    const Interval range = timeRange();
    const Interval shown{labels.at(range.lower), labels.at(range.upper)};
    labels.scale =
        timeScale({std::min(shown.lower, shown.upper), std::max(shown.lower, shown.upper)}, isAngle, width, digitWidth);
    labels.title = isAngle ? QStringLiteral("θ₂ [%1]").arg(labels.scale.unit(QStringLiteral("°")))
                           : QStringLiteral("t [%1]").arg(labels.scale.unit(QStringLiteral("s")));
    return labels;
}

Interval PlotFigure::wholeRange() const
{
    return result ? sampledRange(result->sampling) : Interval{};
}

void PlotFigure::zoomTime(const Interval &range)
{
    const Interval outer = outerRange();
    // Closer, neighbouring instants could not be told apart on the axis any more.
    const double largest = std::max({std::abs(outer.lower), std::abs(outer.upper), outer.length()});
    if (range.length() < std::min(timeRange().length(), kSmallestPart * largest)) {
        return;
    }
    const Interval within = broughtInto(outer, range);
    timeZoom = within;
    if (within == wholeRange()) {
        timeZoom.reset();
    }
}

void PlotFigure::zoomTime(double about, double factor)
{
    zoomTime(scaled(timeRange(), about, factor));
}

void PlotFigure::zoomValues(std::size_t plot, const Interval &shown, double about, double factor)
{
    zoomValues(plot, scaled(shown, about, factor));
}

void PlotFigure::zoomValues(std::size_t plot, const Interval &range)
{
    const double largest = std::max(std::abs(range.lower), std::abs(range.upper));
    constexpr double kLargestValue = 1e60;
    if (range.length() >= kSmallestPart * largest && largest <= kLargestValue) {
        valueZoom[plot] = range;
    }
}

Interval PlotFigure::outerRange() const
{
    const Interval whole = wholeRange();
    if (!result || !result->reference || result->reference->data.time.empty()) {
        return whole;
    }
    const std::vector<double> &instants = result->reference->data.time;
    return united(whole, Interval{instants.front(), instants.back()});
}

/// What `extremesIn` tells of the time on show; of all there is where that is empty.
template <class ExtremesIn>
std::optional<Interval> PlotFigure::valuesSeen(const ExtremesIn &extremesIn) const
{
    const std::optional<Interval> seen = extremesIn(timeRange());
    return seen || !timeZoom ? seen : extremesIn(outerRange());
}

PlotPicture PlotFigure::picture(std::size_t plot, const QSize &axes, double digitWidth)
{
    constexpr double kPixelsPerValueTick = 30.0;
    PlotPicture picture;
    picture.time = timeRange();
    picture.timeLabels = timeLabels(axes.width(), digitWidth);
    const std::size_t columns = static_cast<std::size_t>(std::max(axes.width(), 1));
    if (isErrorPlot(plot)) {
        fillErrorPicture(picture, plot / kPlotColumns, columns);
    } else {
        fillModelPicture(picture, channelOf(plot), columns);
    }
    if (valueZoom[plot] && picture.hasValues) {
        if (picture.rightValues) { // both axes show the same part of theirs
            picture.rightValues = correspondingRange(*valueZoom[plot], picture.values, *picture.rightValues);
        }
        picture.values = *valueZoom[plot];
    }
    const double ticks = axes.height() / kPixelsPerValueTick;
    const bool isLogarithmic = isErrorPlot(plot) && m_settings.logarithmicError;
    const auto scaleOf = [&](const Interval &range) {
        return isLogarithmic ? logarithmicScale(range, ticks) : axisScale(range, ticks);
    };
    picture.valueScale = scaleOf(picture.values);
    const std::size_t channel = isErrorPlot(plot) ? plot / kPlotColumns * kChannelsPerRow : channelOf(plot);
    QString unit = isErrorPlot(plot) ? errorUnit(channel) : channelUnit(channel);
    if (picture.hasValues) {
        unit = picture.valueScale.unit(unit);
    }
    if (picture.rightValues) {
        picture.rightScale = scaleOf(*picture.rightValues);
        unit = tr("%1; %2", "units of the left and of the right axis")
                   .arg(unit, picture.rightScale.unit(errorUnit(channel + 1)));
    }
    picture.title = QStringLiteral("%1 [%2]").arg(picture.title, unit);
    for (std::size_t i = 0; i < picture.curves.size(); ++i) {
        const bool isRight = picture.rightValues && i == 1;
        finishCurve(picture.curves[i], picture.time, isRight ? *picture.rightValues : picture.values, axes);
    }
    for (PlotPicture::Curve &curve : picture.kept) {
        finishCurve(curve, picture.time, picture.values, axes);
    }
    return picture;
}

void PlotFigure::fillModelPicture(PlotPicture &picture, std::size_t index, std::size_t columns)
{
    ShownData &shown = data();
    const ShownChannel &channel = shown.channels[index];
    picture.title = quantity(index);
    picture.words = wordsBefore(kPlottedChannels[index]);
    picture.curves[0].ink = Ink::Model;
    picture.curves[1].ink = Ink::Reference;
    picture.curves[1].dashes = kReferenceDashes;
    if (!result) {
        return;
    }
    picture.curves[0].points = shown.model.points(index, picture.time, columns);
    picture.curves[0].isOfSamples = !shown.model.isMotion();
    // Where every pixel column has its samples, what joins them stays within it.
    const bool areDense = 2 * picture.curves[0].points.size() >= 3 * columns;
    picture.curves[0].isJoined = areDense || fewSamples().isEmpty();
    picture.curves[1].isOfSamples = true;
    if (!channel.reference.empty()) {
        picture.curves[1].points =
            decimate(shown.referenceTime, channel.reference, pixelColumns(shown.referenceTime, picture.time, columns));
    } else if (result->reference) {
        picture.remarks = picture.shortRemarks = {{tr("not in the file"), Ink::Reference}};
    }
    for (KeptMotion &motion : kept()) {
        PlotPicture::Curve &curve = picture.kept.emplace_back();
        curve.points = motion.curves.points(index, picture.time, columns);
        curve.ink = Ink::Kept;
        curve.dashes = kKeptDashes[picture.kept.size() - 1];
    }
    const std::optional<Interval> values = valuesSeen([&](const Interval &range) {
        std::optional<Interval> seen =
            united(shown.model.extremes(index, range), extremesWithin(shown.referenceTime, channel.reference, range));
        for (const KeptMotion &motion : kept()) {
            seen = united(seen, motion.curves.extremes(index, range));
        }
        return seen;
    });
    picture.hasValues = values.has_value();
    if (values) {
        picture.values = roundedOutwards(*values);
    } else {
        picture.note = tr("does not exist");
    }
}

void PlotFigure::fillErrorPicture(PlotPicture &picture, std::size_t row, std::size_t columns)
{
    picture.title = result && result->difference ? tr("difference") : tr("error");
    picture.curves[0].ink = Ink::Error;
    picture.curves[1].ink = Ink::ErrorOther;
    if (!hasErrors()) {
        constexpr std::size_t kMiddleRow = 1;
        if (row == kMiddleRow) {
            picture.note = tr("no reference data");
        }
        return;
    }
    const ShownData &shown = data();
    const PixelColumns pixels = pixelColumns(shown.referenceTime, picture.time, columns);
    const bool isSplit = m_settings.error == ErrorMeasure::Absolute;
    std::array<std::optional<Interval>, kChannelsPerRow> extents;
    bool isCompared = false;
    for (std::size_t i = 0; i < kChannelsPerRow; ++i) {
        const std::size_t index = row * kChannelsPerRow + i;
        const ShownChannel &channel = shown.channels[index];
        if (channel.reference.empty() && !(result->difference && result->difference->channels[index].maxAbs)) {
            continue;
        }
        isCompared = true;
        if (result->difference && channel.largestError == 0.0) {
            continue;
        }
        PlotPicture::Curve &curve = picture.curves[i];
        if (result->difference) {
            curve.points = differencePoints(index, picture.time, columns);
            extents[i] = extentOf(curve.points, channel.largestError.has_value(), m_settings.logarithmicError);
        } else {
            curve.points = decimate(shown.referenceTime, channel.errors, pixels);
            if (m_settings.roundingBand) {
                curve.band = shown.roundingBand(index, pixels);
            }
            curve.marks = channel.zeroReference;
            extents[i] = valuesSeen(
                [&](const Interval &range) { return extremesWithin(shown.referenceTime, channel.errors, range); });
        }
        if (channel.largestError) {
            constexpr int kFewDigits = 2;
            const double largest = *channel.largestError;
            const QString unit = isSplit ? channelUnit(index) : QStringLiteral("%");
            const QString number = QStringLiteral("%1 %2").arg(shortNumber(largest, kErrorDigits), unit);
            if (!picture.remarks.empty()) {
                picture.remarks.push_back({QStringLiteral(" · ")});
                picture.shortRemarks.push_back({QStringLiteral(" · ")});
            }
            picture.remarks.push_back(
                {tr("%1 %2", "largest error: number with unit, quantity").arg(number, quantity(index)), curve.ink});
            picture.shortRemarks.push_back({shortNumber(largest, kFewDigits), curve.ink});
        }
    }
    if (!picture.remarks.empty()) {
        const InkedText largest{tr("max ", "largest error, before the numbers")};
        picture.remarks.insert(picture.remarks.begin(), largest);
        picture.shortRemarks.insert(picture.shortRemarks.begin(), largest);
        if (!isSplit) {
            picture.shortRemarks.push_back({QStringLiteral(" %")});
        }
    }
    const std::optional<Interval> both = united(extents[0], extents[1]);
    picture.hasValues = both.has_value();
    if (!both) {
        const bool isInfinite = !picture.curves[0].marks.empty() || !picture.curves[1].marks.empty();
        picture.note = result->difference ? tr("no difference")
                       : isInfinite       ? tr("infinite: the reference is 0")
                       : isCompared       ? tr("nothing to compare")
                                          : tr("not in the file");
        return;
    }
    picture.values = errorRange(isSplit ? extents[0].value_or(*both) : *both, m_settings.logarithmicError);
    if (isSplit) {
        picture.rightValues = errorRange(extents[1].value_or(*both), m_settings.logarithmicError);
    }
}

QString PlotFigure::fewSamples() const
{
    return result && result->solver.method == Method::Newton ? fewSamplesSentence(result->mechanism, result->sampling)
                                                             : QString();
}

std::vector<LegendEntry> PlotFigure::legend(std::optional<std::size_t> only) const
{
    const bool hasModel = !only || !isErrorPlot(*only);
    const bool showsErrors = !only || isErrorPlot(*only);
    using Sample = LegendEntry::Sample;
    std::vector<LegendEntry> entries;
    if (hasModel) {
        const QString few = fewSamples();
        entries.push_back(few.isEmpty() ? LegendEntry{Sample::Solid, Ink::Model, tr("model")}
                                        : LegendEntry{Sample::Dots, Ink::Model, few});
    }
    for (std::size_t i = 0; hasModel && result && i < result->kept.size(); ++i) {
        const QString name = keptText(result->kept[i], result->mechanism.parameters());
        const Dashes &dashes = kKeptDashes[i];
        entries.push_back({dashes.gap > 0.0 ? Sample::Dashed : Sample::Solid, Ink::Kept, name, true, false, dashes});
    }
    if (showsErrors && result && result->difference) {
        entries.push_back({Sample::Solid, Ink::Error, tr("difference of %1").arg(quantity(0)), false, true});
        entries.push_back({Sample::Solid, Ink::ErrorOther, tr("difference of %1").arg(quantity(1)), false, true});
    }
    if (!result || !result->reference) {
        return entries;
    }
    if (hasModel) {
        entries.push_back({Sample::Dashed, Ink::Reference, result->reference->name, true});
    }
    if (showsErrors) {
        entries.push_back({Sample::Solid, Ink::Error, tr("error of %1").arg(quantity(0)), false, true});
        entries.push_back({Sample::Solid, Ink::ErrorOther, tr("error of %1").arg(quantity(1)), false, true});
        if (m_settings.roundingBand) {
            entries.push_back({Sample::Band, Ink::Error, tr("file's rounding"), false, true});
        }
        if (m_settings.error == ErrorMeasure::Percent) {
            entries.push_back({Sample::Mark, Ink::Text, tr("reference is 0"), false, true});
        }
    }
    return entries;
}

} // namespace slidercrank
