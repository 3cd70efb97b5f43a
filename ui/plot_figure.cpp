// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot_figure.h"

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
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// The plotted channel of a model plot.
constexpr std::size_t channelOf(std::size_t plot)
{
    return plot / kPlotColumns * kChannelsPerRow + plot % kPlotColumns;
}

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
    return unit.startsWith(u'°') ? number + unit : QStringLiteral("%1 %2").arg(number, unit);
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
AxisScale timeScale(const Interval &range, double width, double digitWidth)
{
    constexpr double kSpace = 14.0;
    double wanted = 44.0; // px from tick to tick
    for (;;) {
        const AxisScale scale = axisScale(range, width / wanted);
        const double needed = digitWidth * scale.labelLength(range) + kSpace;
        const double between = scale.step / range.length() * width;
        if (between >= needed || wanted >= width) {
            return scale;
        }
        wanted = std::max(needed, 1.3 * wanted);
    }
}

} // namespace

QString plotName(std::size_t plot)
{
    static const std::array<QString, 3> kErrors{QStringLiteral("plot_error_position"),
                                                QStringLiteral("plot_error_velocity"),
                                                QStringLiteral("plot_error_acceleration")};
    if (isErrorPlot(plot)) {
        return kErrors[plot / kPlotColumns];
    }
    const std::string_view name = nameOf(kPlottedChannels[channelOf(plot)]);
    return QStringLiteral("plot_") + QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size()));
}

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
    m_time = {};
    m_referenceTime = {};
    m_channels = {};
    if (!result) {
        return;
    }
    const Trajectory &trajectory = result->trajectory;
    m_time = trajectory.time;
    for (std::size_t i = 0; i < kChannels; ++i) {
        m_channels[i].model = trajectory[kPlottedChannels[i]];
    }
    if (m_time.size() > 1 && m_time.back() < m_time.front()) {
        m_reversed.clear();
        m_reversed.reserve((1 + kChannels) * m_time.size()); // spans into it must stay valid
        const auto reversed = [this](std::span<const double> values) {
            const auto begin = m_reversed.insert(m_reversed.end(), values.rbegin(), values.rend());
            return std::span<const double>(begin, m_reversed.end());
        };
        m_time = reversed(m_time);
        for (ShownChannel &channel : m_channels) {
            channel.model = reversed(channel.model);
        }
    }
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
        channel.percent.reserve(data.time.size());
        for (std::size_t k = 0; k < data.time.size(); ++k) {
            const double reference = channel.reference[k];
            if (reference == 0.0) {
                channel.zeroReference.push_back(data.time[k]);
            }
            constexpr double kPercent = 100.0;
            channel.percent.push_back(
                reference == 0.0 ? kNaN : std::abs((channel.modelAtReference[k] - reference) / reference) * kPercent);
        }
        for (const ChannelComparison &comparison : result->comparison) {
            if (comparison.channel == kPlottedChannels[i]) {
                channel.largestPercent = comparison.maxPercent;
            }
        }
    }
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
    picture.timeScale = timeScale(picture.time, axes.width(), digitWidth);
    const std::size_t columns = static_cast<std::size_t>(std::max(axes.width(), 1));
    if (isErrorPlot(plot)) {
        fillErrorPicture(picture, plot / kPlotColumns, columns);
    } else {
        fillModelPicture(picture, channelOf(plot), columns);
    }
    if (valueZoom[plot] && picture.hasValues) {
        picture.values = *valueZoom[plot];
    }
    picture.valueScale = axisScale(picture.values, axes.height() / kPixelsPerValueTick);
    const QString unit = isErrorPlot(plot) ? QStringLiteral("%") : unitOf(channelOf(plot));
    picture.title =
        QStringLiteral("%1 [%2]").arg(picture.title, picture.hasValues ? picture.valueScale.unit(unit) : unit);
    const DashPattern pattern{kDash, kDashGap, axes.width() / picture.time.length(),
                              axes.height() / picture.values.length()};
    constexpr double kInvisible = 0.1; // px
    const double tolerance = kInvisible / pattern.perValue;
    for (PlotPicture::Curve &curve : picture.curves) {
        curve.points = clip(curve.points, picture.time, picture.values);
        if (curve.ink != Ink::Reference) {
            curve.dots = isolatedPoints(curve.points);
            curve.points = withoutNeedlessPoints(curve.points, tolerance);
        } else {
            constexpr double kPixelsPerDot = 12.0;
            if (static_cast<double>(curve.points.size()) * kPixelsPerDot >= axes.width()) {
                curve.dots = isolatedPoints(curve.points);
            } else {
                std::copy_if(curve.points.begin(), curve.points.end(), std::back_inserter(curve.dots),
                             [](const CurvePoint &point) { return !std::isnan(point.value); });
            }
            curve.points = cutIntoDashes(withoutNeedlessPoints(curve.points, tolerance), pattern);
        }
    }
    return picture;
}

void PlotFigure::fillModelPicture(PlotPicture &picture, std::size_t index, std::size_t columns) const
{
    const ShownChannel &channel = m_channels[index];
    picture.title = quantity(index);
    picture.curves[0].ink = Ink::Model;
    picture.curves[1].ink = Ink::Reference;
    if (!result) {
        return;
    }
    picture.curves[0].points = decimate(m_time, channel.model, pixelColumns(m_time, picture.time, columns));
    if (!channel.reference.empty()) {
        picture.curves[1].points =
            decimate(m_referenceTime, channel.reference, pixelColumns(m_referenceTime, picture.time, columns));
    } else if (result->reference) {
        picture.remarks = picture.shortRemarks = {{tr("not in the file"), Ink::Reference}};
    }
    // The axis of values stays that of the whole run while one looks at a part of it.
    const std::optional<Interval> model =
        picture.time == wholeRange() ? extremes(picture.curves[0].points) : extremes(channel.model);
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
    std::optional<Interval> values;
    bool isCompared = false;
    for (std::size_t i = 0; i < kChannelsPerRow; ++i) {
        const ShownChannel &channel = m_channels[row * kChannelsPerRow + i];
        if (channel.reference.empty()) {
            continue;
        }
        isCompared = true;
        PlotPicture::Curve &curve = picture.curves[i];
        curve.points = decimate(m_referenceTime, channel.percent, pixels);
        curve.marks = channel.zeroReference;
        values = united(values, extremesWithin(united(wholeRange(), picture.time), m_referenceTime, channel.percent));
        if (channel.largestPercent) {
            constexpr int kDigits = 3;
            constexpr int kFewDigits = 2;
            const double largest = *channel.largestPercent;
            const QString number = shortNumber(largest, kDigits, QLocale());
            if (!picture.remarks.empty()) {
                picture.remarks.push_back({QStringLiteral(" · ")});
                picture.shortRemarks.push_back({QStringLiteral(" · ")});
            }
            picture.remarks.push_back(
                {tr("%1 % %2", "largest error: number, quantity").arg(number, quantity(row * kChannelsPerRow + i)),
                 curve.ink});
            picture.shortRemarks.push_back({shortNumber(largest, kFewDigits, QLocale()), curve.ink});
        }
    }
    if (!picture.remarks.empty()) {
        const InkedText largest{tr("max ", "largest error, before the numbers")};
        picture.remarks.insert(picture.remarks.begin(), largest);
        picture.shortRemarks.insert(picture.shortRemarks.begin(), largest);
        picture.shortRemarks.push_back({QStringLiteral(" %")});
    }
    picture.hasValues = values.has_value();
    if (values) {
        picture.values = roundedOutwards(united(*values, Interval{0.0, 0.0}));
    } else {
        picture.note = isCompared ? tr("nothing to compare") : tr("not in the file");
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
        entries.push_back({Sample::Solid, Ink::Error, tr("error of %1").arg(quantity(0))});
        entries.push_back({Sample::Solid, Ink::ErrorOther, tr("error of %1").arg(quantity(1))});
        entries.push_back({Sample::Mark, Ink::Text, tr("reference is 0")});
    }
    return entries;
}

QString PlotFigure::readout(std::size_t plot, double t)
{
    convert();
    if (!result || m_time.empty()) {
        return {};
    }
    const QLocale locale;
    constexpr int kDigits = 6;
    const auto nearest = [t](std::span<const double> instants) {
        const auto after = std::lower_bound(instants.begin(), instants.end(), t);
        const auto index = static_cast<std::size_t>(after - instants.begin());
        if (index == instants.size() || (index > 0 && t - instants[index - 1] < instants[index] - t)) {
            return index - 1;
        }
        return index;
    };
    const auto number = [&](double value, const QString &unit) {
        return std::isfinite(value) ? withUnit(shortNumber(value, kDigits, locale), unit) : tr("does not exist");
    };
    const auto instant = [&](double seconds) {
        return QStringLiteral("t = %1").arg(number(seconds, QStringLiteral("s")));
    };
    QStringList lines;
    if (isErrorPlot(plot)) {
        if (m_referenceTime.empty()) {
            return {};
        }
        const std::size_t k = nearest(m_referenceTime);
        lines << instant(m_referenceTime[k]);
        for (std::size_t i = 0; i < kChannelsPerRow; ++i) {
            const std::size_t index = plot / kPlotColumns * kChannelsPerRow + i;
            const ShownChannel &channel = m_channels[index];
            if (channel.reference.empty()) {
                continue;
            }
            lines << tr("error of %1: %2")
                         .arg(quantity(index), channel.reference[k] == 0.0
                                                   ? tr("no percentage, the reference is 0")
                                                   : number(channel.percent[k], QStringLiteral("%")));
        }
        return lines.join(u'\n');
    }
    const std::size_t index = channelOf(plot);
    const ShownChannel &channel = m_channels[index];
    const QString unit = unitOf(index);
    const std::size_t k = nearest(m_time);
    lines << instant(m_time[k]);
    lines << tr("%1 = %2").arg(quantity(index), number(channel.model[k], unit));
    if (kPlottedChannels[index] == Channel{Theta3, Order::Position} && std::isfinite(channel.model[k])) {
        constexpr double kHalfTurn = 180.0;
        lines << tr("textbook's θ₃ = θ³ + 180° = %1").arg(number(channel.model[k] + kHalfTurn, unit));
    }
    if (!channel.reference.empty()) {
        const std::size_t r = nearest(m_referenceTime);
        const QString value = number(channel.reference[r], unit);
        lines << (m_referenceTime[r] == m_time[k] ? tr("reference: %1").arg(value)
                                                  : tr("reference: %1 at %2").arg(value, instant(m_referenceTime[r])));
    }
    return lines.join(u'\n');
}
} // namespace slidercrank
