// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/plot_figure.h"

#include <QLocale>
#include <QStringList>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace slidercrank
{

namespace
{

constexpr std::size_t kChannels = kPlottedChannels.size();
constexpr std::size_t kChannelsPerRow = 2;

/// Derivatives as fractions: fonts set the dots of θ̇ and R̈ badly or not at all.
QString quantity(std::size_t channel)
{
    static const std::array<QString, kChannels> kNames{QStringLiteral("θ³"),       QStringLiteral("Rₓ⁴"),
                                                       QStringLiteral("dθ³/dt"),   QStringLiteral("dRₓ⁴/dt"),
                                                       QStringLiteral("d²θ³/dt²"), QStringLiteral("d²Rₓ⁴/dt²")};
    return kNames[channel];
}

QString unitOf(std::size_t channel)
{
    const std::string_view unit = authorUnitOf(kPlottedChannels[channel]);
    return QString::fromUtf8(unit.data(), static_cast<qsizetype>(unit.size()));
}

/// "24.6°", "74.5 mm".
QString withUnit(const QString &number, const QString &unit)
{
    return unit.isEmpty() || unit.startsWith(u'°') ? number + unit : QStringLiteral("%1 %2").arg(number, unit);
}

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

constexpr int kDigits = 6;
constexpr int kErrorDigits = 3;
constexpr int kBriefDigits = 4; // where there is little room

/// For reading, with its unit.
QString numberText(double value, const QString &unit, int digits = kDigits)
{
    return std::isfinite(value) ? withUnit(shortNumber(value, digits, QLocale()), unit)
                                : PlotFigure::tr("does not exist");
}

/// Which of them is nearest; there must be one.
std::size_t nearest(std::span<const double> instants, double t)
{
    return nearestIndex(
        instants.size(), [instants](std::size_t i) { return instants[i]; }, t);
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
    const DashPattern pattern{kDash, kDashGap, axes.width() / time.length(), axes.height() / values.length()};
    constexpr double kInvisible = 0.1; // px
    const double tolerance = kInvisible / pattern.perValue;
    curve.points = clip(curve.points, time, values);
    if (curve.ink != Ink::Reference) {
        curve.dots = isolatedPoints(curve.points);
        curve.points = withoutNeedlessPoints(curve.points, tolerance);
        return;
    }
    constexpr double kPixelsPerDot = 12.0;
    if (static_cast<double>(curve.points.size()) * kPixelsPerDot >= axes.width()) {
        curve.dots = isolatedPoints(curve.points);
    } else {
        std::copy_if(curve.points.begin(), curve.points.end(), std::back_inserter(curve.dots),
                     [](const CurvePoint &point) { return !std::isnan(point.value); });
    }
    curve.points = cutIntoDashes(withoutNeedlessPoints(curve.points, tolerance), pattern);
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

} // namespace

void PlotFigure::setResult(const std::shared_ptr<const Result> &newResult)
{
    if (!newResult || !result || sampledRange(newResult->sampling) != sampledRange(result->sampling)) {
        timeZoom.reset();
    }
    result = newResult;
    m_isConverted = false;
}

void PlotFigure::convert()
{
    if (m_isConverted) {
        return;
    }
    m_isConverted = true;
    m_model = {};
    m_referenceTime = {};
    m_channels = {};
    if (!result) {
        return;
    }
    m_model = ModelCurves(*result);
    if (!result->reference) {
        return;
    }
    const ReferenceData &data = result->reference->data;
    m_referenceTime = data.time;
    for (std::size_t i = 0; i < kChannels; ++i) {
        ShownChannel &channel = m_channels[i];
        const ReferenceSeries *series = data.find(kPlottedChannels[i]);
        if (!series) {
            continue;
        }
        channel.reference = series->values;
        channel.modelAtReference = result->atReference[kPlottedChannels[i]];
        for (const ChannelComparison &comparison : result->comparison) {
            if (comparison.channel == kPlottedChannels[i]) {
                channel.comparison = &comparison;
            }
        }
        channel.series = series;
        convertErrors(channel);
    }
}

void PlotFigure::convertErrors(ShownChannel &channel) const
{
    constexpr double kPercent = 100.0;
    const ChannelComparison *comparison = channel.comparison;
    switch (m_settings.error) {
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
    const std::size_t count = channel.reference.size();
    channel.errors.resize(count);
    for (std::size_t k = 0; k < count; ++k) {
        const double reference = channel.reference[k];
        channel.errors[k] = shownError(channel, channel.modelAtReference[k] - reference, reference);
        if (reference == 0.0 && m_settings.error == ErrorMeasure::Percent) {
            channel.zeroReference.push_back(m_referenceTime[k]);
        }
    }
}

/// In the chosen measure, as the axis has it; NaN where it is infinite or has no logarithm.
double PlotFigure::shownError(const ShownChannel &channel, double difference, double reference) const
{
    double error = std::abs(difference) * channel.perDifference;
    if (m_settings.error == ErrorMeasure::Percent) {
        error = reference == 0.0 ? kNoValue : error / std::abs(reference);
    }
    if (m_settings.logarithmicError) {
        error = error > 0.0 ? std::log10(error) : kNoValue;
    }
    return error;
}

/// Half a rounding step of the file, where its curve has the points that are drawn.
std::vector<CurvePoint> PlotFigure::bandOf(const ShownChannel &channel, const PixelColumns &pixels) const
{
    constexpr double kHalf = 0.5;
    std::vector<CurvePoint> band = decimate(m_referenceTime, channel.reference, pixels);
    for (CurvePoint &point : band) {
        point.value = shownError(channel, kHalf * channel.series->rounding.stepAt(point.value), point.value);
    }
    return band;
}

void PlotFigure::setSettings(const PlotSettings &settings)
{
    for (std::size_t plot = 0; plot < kPlotCount; ++plot) {
        if (isErrorPlot(plot)) {
            valueZoom[plot].reset(); // another measure, other numbers
        }
    }
    m_settings = settings;
    m_isConverted = false;
}

bool PlotFigure::hasRightAxis(std::size_t plot) const
{
    return isErrorPlot(plot) && m_settings.error == ErrorMeasure::Absolute && result && result->reference;
}

QString PlotFigure::errorUnit(std::size_t channel) const
{
    switch (m_settings.error) {
    case ErrorMeasure::Percent: return QStringLiteral("%");
    case ErrorMeasure::Absolute: return unitOf(channel);
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
    const Interval within = broughtInto(outerRange(), range);
    timeZoom = within;
    if (within == wholeRange()) {
        timeZoom.reset();
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

std::optional<Interval> PlotFigure::extremesWithin(const Interval &range, std::span<const double> instants,
                                                   std::span<const double> values) const
{
    if (values.empty()) {
        return std::nullopt; // a channel that the file lacks
    }
    const auto begin = std::lower_bound(instants.begin(), instants.end(), range.lower);
    const auto end = std::upper_bound(begin, instants.end(), range.upper);
    return extremes(
        values.subspan(static_cast<std::size_t>(begin - instants.begin()), static_cast<std::size_t>(end - begin)));
}

PlotPicture PlotFigure::picture(std::size_t plot, const QSize &axes, double digitWidth)
{
    convert();
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
    QString unit = isErrorPlot(plot) ? errorUnit(channel) : unitOf(channel);
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
    return picture;
}

void PlotFigure::fillModelPicture(PlotPicture &picture, std::size_t index, std::size_t columns)
{
    const ShownChannel &channel = m_channels[index];
    picture.title = quantity(index);
    picture.curves[0].ink = Ink::Model;
    picture.curves[1].ink = Ink::Reference;
    if (!result) {
        return;
    }
    picture.curves[0].points = m_model.decimated(index, picture.time, columns);
    if (!channel.reference.empty()) {
        picture.curves[1].points =
            decimate(m_referenceTime, channel.reference, pixelColumns(m_referenceTime, picture.time, columns));
    } else if (result->reference) {
        picture.remarks = picture.shortRemarks = {{tr("not in the file"), Ink::Reference}};
    }
    // The axis of values stays that of the whole run while one looks at a part of it.
    const std::optional<Interval> model =
        picture.time == wholeRange() ? extremes(picture.curves[0].points) : m_model.extremes(index);
    const std::optional<Interval> values =
        united(model, extremesWithin(united(wholeRange(), picture.time), m_referenceTime, channel.reference));
    picture.hasValues = values.has_value();
    if (values) {
        picture.values = roundedOutwards(*values);
    } else {
        picture.note = tr("does not exist");
    }
}

void PlotFigure::fillErrorPicture(PlotPicture &picture, std::size_t row, std::size_t columns) const
{
    picture.title = tr("error");
    picture.curves[0].ink = Ink::Error;
    picture.curves[1].ink = Ink::ErrorOther;
    if (!result || !result->reference) {
        constexpr std::size_t kMiddleRow = 1;
        if (row == kMiddleRow) {
            picture.note = tr("no reference data");
        }
        return;
    }
    const PixelColumns pixels = pixelColumns(m_referenceTime, picture.time, columns);
    const bool isSplit = m_settings.error == ErrorMeasure::Absolute;
    std::array<std::optional<Interval>, kChannelsPerRow> extents;
    bool isCompared = false;
    for (std::size_t i = 0; i < kChannelsPerRow; ++i) {
        const std::size_t index = row * kChannelsPerRow + i;
        const ShownChannel &channel = m_channels[index];
        if (channel.reference.empty()) {
            continue;
        }
        isCompared = true;
        PlotPicture::Curve &curve = picture.curves[i];
        curve.points = decimate(m_referenceTime, channel.errors, pixels);
        if (m_settings.roundingBand) {
            curve.band = bandOf(channel, pixels);
        }
        curve.marks = channel.zeroReference;
        extents[i] = extremesWithin(united(wholeRange(), picture.time), m_referenceTime, channel.errors);
        if (channel.largestError) {
            constexpr int kFewDigits = 2;
            const double largest = *channel.largestError;
            const QString unit = isSplit ? unitOf(index) : QStringLiteral("%");
            const QString number = QStringLiteral("%1 %2").arg(shortNumber(largest, kErrorDigits, QLocale()), unit);
            if (!picture.remarks.empty()) {
                picture.remarks.push_back({QStringLiteral(" · ")});
                picture.shortRemarks.push_back({QStringLiteral(" · ")});
            }
            picture.remarks.push_back(
                {tr("%1 %2", "largest error: number with unit, quantity").arg(number, quantity(index)), curve.ink});
            picture.shortRemarks.push_back({shortNumber(largest, kFewDigits, QLocale()), curve.ink});
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
        picture.note = isCompared ? tr("nothing to compare") : tr("not in the file");
        return;
    }
    picture.values = errorRange(isSplit ? extents[0].value_or(*both) : *both, m_settings.logarithmicError);
    if (isSplit) {
        picture.rightValues = errorRange(extents[1].value_or(*both), m_settings.logarithmicError);
    }
}

std::vector<LegendEntry> PlotFigure::legend(bool hasModel, bool hasErrors) const
{
    using Sample = LegendEntry::Sample;
    std::vector<LegendEntry> entries;
    if (hasModel) {
        entries.push_back({Sample::Solid, Ink::Model, tr("model")});
    }
    if (!result || !result->reference) {
        return entries;
    }
    if (hasModel) {
        entries.push_back({Sample::Dashed, Ink::Reference, result->reference->name, true});
    }
    if (hasErrors) {
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

double PlotFigure::nearestInstant(double t)
{
    convert();
    return m_model.empty() ? t : m_model.instant(m_model.nearest(t));
}

QString PlotFigure::instantText(double seconds) const
{
    const QString time = QStringLiteral("t = %1").arg(numberText(seconds, QStringLiteral("s")));
    if (m_settings.abscissa == Abscissa::Time || !result) {
        return time;
    }
    const double angle = (result->mechanism.theta20() + result->mechanism.omega2() * seconds) * kDegreesPerRadian;
    return QStringLiteral("θ₂ = %1, %2").arg(numberText(angle, QStringLiteral("°")), time);
}

QString PlotFigure::errorText(std::size_t channel, std::size_t atReference) const
{
    const ShownChannel &shown = m_channels[channel];
    if (m_settings.error == ErrorMeasure::Percent && shown.reference[atReference] == 0.0) {
        return tr("no percentage, the reference is 0");
    }
    if (shown.modelAtReference[atReference] == shown.reference[atReference]) { // has no logarithm
        return numberText(0.0, errorUnit(channel), kErrorDigits);
    }
    const double error = shown.errors[atReference];
    return numberText(m_settings.logarithmicError ? std::pow(10.0, error) : error, errorUnit(channel), kErrorDigits);
}

std::vector<InkedText> PlotFigure::valuesAt(std::size_t plot, double t, Wording wording)
{
    convert();
    std::vector<InkedText> values;
    if (m_model.empty()) {
        return values;
    }
    if (!isErrorPlot(plot)) {
        const std::size_t index = channelOf(plot);
        const ShownChannel &channel = m_channels[index];
        const auto text = [&](double value) {
            return wording == Wording::Full ? numberText(value, unitOf(index))
                                            : numberText(value, QString(), kBriefDigits);
        };
        values.push_back({text(m_model.value(index, m_model.nearest(t))), Ink::Model});
        if (!channel.reference.empty()) {
            values.push_back({text(channel.reference[nearest(m_referenceTime, t)]), Ink::Reference});
        }
        return values;
    }
    for (std::size_t i = 0; i < kChannelsPerRow; ++i) {
        const std::size_t index = plot / kPlotColumns * kChannelsPerRow + i;
        if (!m_channels[index].reference.empty()) {
            values.push_back({errorText(index, nearest(m_referenceTime, t)), i == 0 ? Ink::Error : Ink::ErrorOther});
        }
    }
    return values;
}

std::vector<InkedText> PlotFigure::changesBetween(std::size_t plot, double from, double to, Wording wording)
{
    convert();
    std::vector<InkedText> changes;
    if (isErrorPlot(plot) || m_model.empty()) {
        return changes;
    }
    const std::size_t index = channelOf(plot);
    const ShownChannel &channel = m_channels[index];
    const auto text = [&](double difference) {
        return wording == Wording::Full ? numberText(difference, unitOf(index))
                                        : numberText(difference, QString(), kBriefDigits);
    };
    changes.push_back(
        {text(m_model.value(index, m_model.nearest(to)) - m_model.value(index, m_model.nearest(from))), Ink::Model});
    if (!channel.reference.empty()) {
        const double inFile =
            channel.reference[nearest(m_referenceTime, to)] - channel.reference[nearest(m_referenceTime, from)];
        changes.push_back({text(inFile), Ink::Reference});
    }
    return changes;
}

std::vector<InkedText> PlotFigure::readout(std::size_t plot, double t, Wording wording)
{
    convert();
    std::vector<InkedText> rows;
    if (m_model.empty() || (isErrorPlot(plot) && m_referenceTime.empty())) {
        return rows;
    }
    if (isErrorPlot(plot)) {
        const std::size_t k = nearest(m_referenceTime, t);
        rows.push_back({instantText(m_referenceTime[k])});
        for (std::size_t i = 0; i < kChannelsPerRow; ++i) {
            const std::size_t index = plot / kPlotColumns * kChannelsPerRow + i;
            if (!m_channels[index].reference.empty()) {
                rows.push_back({tr("error of %1: %2").arg(quantity(index), errorText(index, k)),
                                i == 0 ? Ink::Error : Ink::ErrorOther});
            }
        }
        return rows;
    }
    const std::size_t index = channelOf(plot);
    const ShownChannel &channel = m_channels[index];
    const QString unit = unitOf(index);
    const std::size_t k = m_model.nearest(t);
    const double value = m_model.value(index, k);
    rows.push_back({instantText(m_model.instant(k))});
    rows.push_back({tr("%1 = %2").arg(quantity(index), numberText(value, unit)), Ink::Model});
    if (kPlottedChannels[index] == Channel{Theta3, Order::Position} && std::isfinite(value)) {
        constexpr double kHalfTurn = 180.0;
        const QString textbook =
            wording == Wording::Full ? tr("textbook's θ₃ = θ³ + 180° = %1") : tr("textbook's θ₃ = %1");
        rows.push_back({textbook.arg(numberText(value + kHalfTurn, unit))});
    }
    if (!channel.reference.empty()) {
        const std::size_t r = nearest(m_referenceTime, t);
        const double inFile = channel.reference[r];
        QString text = tr("reference: %1").arg(numberText(inFile, unit));
        if (m_referenceTime[r] != m_model.instant(k)) {
            text =
                tr("reference: %1 at %2")
                    .arg(wording == Wording::Full ? numberText(inFile, unit)
                                                  : numberText(inFile, QString(), kBriefDigits),
                         wording == Wording::Full ? instantText(m_referenceTime[r])
                                                  : numberText(m_referenceTime[r], QStringLiteral("s"), kBriefDigits));
        }
        rows.push_back({text, Ink::Reference});
    }
    return rows;
}

} // namespace slidercrank
