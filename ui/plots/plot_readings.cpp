// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/plot_readings.h"

#include "ui/text/finding_text.h"
#include "ui/text/written_number.h"

#include <QFontMetrics>

#include <cmath>

namespace slidercrank
{

namespace
{

constexpr int kDigits = 6;
constexpr int kBriefDigits = 4; // where there is little room

/// "24.6°", "74.5 mm".
QString valueText(double value, const QString &unit, int digits = kDigits)
{
    if (!std::isfinite(value)) {
        return PlotFigure::tr("does not exist");
    }
    const QString number = shortNumber(value, digits);
    return unit.isEmpty() || unit.startsWith(u'°') ? number + unit : QStringLiteral("%1 %2").arg(number, unit);
}

/// Of a plotted channel.
QString channelText(double value, std::size_t channel, Wording wording)
{
    return wording == Wording::Full ? valueText(value, channelUnit(channel))
                                    : valueText(value, QString(), kBriefDigits);
}

/// "t = 0.25 s"; the crank angle first where that is the abscissa.
QString instantText(const PlotFigure &figure, double seconds, int digits = kDigits)
{
    const QString time = QStringLiteral("t = %1 s").arg(numberText(seconds, digits));
    if (figure.settings().abscissa == Abscissa::Time || !figure.result) {
        return time;
    }
    const Mechanism &mechanism = figure.result->mechanism;
    const double angle = (mechanism.theta20() + mechanism.omega2() * seconds) * kDegreesPerRadian;
    return QStringLiteral("θ₂ = %1, %2").arg(valueText(angle, QStringLiteral("°")), time);
}

QString errorText(const PlotFigure &figure, const ShownData &data, std::size_t index, std::size_t atReference)
{
    const ShownChannel &channel = data.channels[index];
    const PlotSettings &settings = figure.settings();
    if (settings.error == ErrorMeasure::Percent && channel.reference[atReference] == 0.0) {
        return PlotFigure::tr("no percentage, the reference is 0");
    }
    double error = 0.0;
    if (channel.modelAtReference[atReference] != channel.reference[atReference]) { // else it has no logarithm
        error = channel.errors[atReference];
        error = settings.logarithmicError ? std::pow(10.0, error) : error;
    }
    return valueText(error, figure.errorUnit(index), kErrorDigits);
}

QString differenceText(PlotFigure &figure, std::size_t index, double t)
{
    const double shown = figure.differenceAt(index, t);
    const double difference =
        figure.settings().logarithmicError && std::isfinite(shown) ? std::pow(10.0, shown) : shown;
    return valueText(difference, figure.errorUnit(index), kErrorDigits);
}

/// Next to time t (s): model and reference, or the two errors; empty where it shows nothing.
std::vector<InkedText> valuesAt(PlotFigure &figure, std::size_t plot, double t, Wording wording)
{
    const ShownData &data = figure.data();
    std::vector<InkedText> values;
    if (data.model.empty()) {
        return values;
    }
    if (!isErrorPlot(plot)) {
        const std::size_t index = channelOf(plot);
        const ShownChannel &channel = data.channels[index];
        values.push_back({channelText(data.model.value(index, data.model.instantNear(t)), index, wording), Ink::Model});
        if (!channel.reference.empty()) {
            values.push_back(
                {channelText(channel.reference[nearestIndex(data.referenceTime, t)], index, wording), Ink::Reference});
        }
        return values;
    }
    for (std::size_t i = 0; i < kChannelsPerRow; ++i) {
        const std::size_t index = plot / kPlotColumns * kChannelsPerRow + i;
        const Ink ink = i == 0 ? Ink::Error : Ink::ErrorOther;
        if (!data.channels[index].reference.empty()) {
            values.push_back({errorText(figure, data, index, nearestIndex(data.referenceTime, t)), ink});
        } else if (figure.result->difference) {
            values.push_back({differenceText(figure, index, data.model.instantNear(t)), ink});
        }
    }
    return values;
}

/// The differences of model and reference from one instant to another.
std::vector<InkedText> changesBetween(PlotFigure &figure, std::size_t plot, double from, double to, Wording wording)
{
    const ShownData &data = figure.data();
    std::vector<InkedText> changes;
    if (isErrorPlot(plot) || data.model.empty()) {
        return changes;
    }
    const std::size_t index = channelOf(plot);
    const ShownChannel &channel = data.channels[index];
    const double ofModel =
        data.model.value(index, data.model.instantNear(to)) - data.model.value(index, data.model.instantNear(from));
    changes.push_back({channelText(ofModel, index, wording), Ink::Model});
    if (!channel.reference.empty()) {
        const double inFile = channel.reference[nearestIndex(data.referenceTime, to)] -
                              channel.reference[nearestIndex(data.referenceTime, from)];
        changes.push_back({channelText(inFile, index, wording), Ink::Reference});
    }
    return changes;
}

/// At length: the instant, the values with their names, the textbook's θ₃.
std::vector<InkedRow> readout(PlotFigure &figure, std::size_t plot, double t, Wording wording)
{
    const ShownData &data = figure.data();
    std::vector<InkedRow> rows;
    if (data.model.empty() || (isErrorPlot(plot) && !figure.hasErrors())) {
        return rows;
    }
    const auto addRow = [&rows](const QString &text, Ink ink = Ink::Text) { rows.push_back({{text, ink}}); };
    if (isErrorPlot(plot) && figure.result->difference) {
        const double now = data.model.instantNear(t);
        addRow(instantText(figure, now));
        for (std::size_t i = 0; i < kChannelsPerRow; ++i) {
            const std::size_t index = plot / kPlotColumns * kChannelsPerRow + i;
            addRow(PlotFigure::tr("difference of %1: %2").arg(quantity(index), differenceText(figure, index, now)),
                   i == 0 ? Ink::Error : Ink::ErrorOther);
        }
        return rows;
    }
    if (isErrorPlot(plot)) {
        const std::size_t k = nearestIndex(data.referenceTime, t);
        addRow(instantText(figure, data.referenceTime[k]));
        for (std::size_t i = 0; i < kChannelsPerRow; ++i) {
            const std::size_t index = plot / kPlotColumns * kChannelsPerRow + i;
            if (!data.channels[index].reference.empty()) {
                addRow(PlotFigure::tr("error of %1: %2").arg(quantity(index), errorText(figure, data, index, k)),
                       i == 0 ? Ink::Error : Ink::ErrorOther);
            }
        }
        return rows;
    }
    const std::size_t index = channelOf(plot);
    const ShownChannel &channel = data.channels[index];
    const QString unit = channelUnit(index);
    const double now = data.model.instantNear(t);
    const double value = data.model.value(index, now);
    constexpr int kAllDigits = 15; // the value is that of this very instant
    addRow(instantText(figure, now, data.model.isMotion() ? kAllDigits : kDigits));
    addRow(PlotFigure::tr("%1 = %2").arg(quantity(index), valueText(value, unit)), Ink::Model);
    if (kPlottedChannels[index] == Channel{Theta3, Order::Position} && std::isfinite(value)) {
        constexpr double kHalfTurn = 180.0;
        const QString textbook = wording == Wording::Full ? PlotFigure::tr("textbook's θ₃ = θ³ + 180° = %1")
                                                          : PlotFigure::tr("textbook's θ₃ = %1");
        addRow(textbook.arg(valueText(value + kHalfTurn, unit)));
    }
    if (!channel.reference.empty()) {
        const std::size_t r = nearestIndex(data.referenceTime, t);
        const double instant = data.referenceTime[r];
        const double inFile = channel.reference[r];
        if (instant == now) {
            addRow(PlotFigure::tr("reference: %1").arg(valueText(inFile, unit)), Ink::Reference);
        } else {
            const QString when = wording == Wording::Full ? instantText(figure, instant)
                                                          : valueText(instant, QStringLiteral("s"), kBriefDigits);
            addRow(PlotFigure::tr("reference: %1 at %2").arg(channelText(inFile, index, wording), when),
                   Ink::Reference);
        }
    }
    for (const PlotFigure::KeptMotion &motion : figure.kept()) {
        const QString name = keptText(motion.parameters, figure.result->mechanism.parameters());
        addRow(PlotFigure::tr("%1: %2", "kept motion, its value")
                   .arg(name, channelText(motion.curves.value(index, now), index, wording)),
               Ink::Kept);
    }
    return rows;
}

} // namespace

std::vector<InkedRow> readingsOf(PlotFigure &figure, std::size_t plot, const ReadInstants &read, Wording wording)
{
    if (read.hovered == plot) {
        return readout(figure, plot, read.hoverTime, wording);
    }
    std::vector<InkedRow> rows;
    const auto addRow = [&rows](const QString &name, const std::vector<InkedText> &values) {
        InkedRow row{{name}};
        for (const InkedText &value : values) {
            row.push_back({row.size() > 1 ? QStringLiteral("   ") + value.text : value.text, value.ink});
        }
        if (!values.empty()) {
            rows.push_back(row);
        }
    };
    if (read.hovered) {
        addRow({}, valuesAt(figure, plot, read.hoverTime, wording));
    } else if (read.measured) {
        const auto [first, second] = *read.measured;
        addRow(QStringLiteral("1:  "), valuesAt(figure, plot, first, wording));
        addRow(QStringLiteral("2:  "), valuesAt(figure, plot, second, wording));
        addRow(QStringLiteral("Δ:  "), changesBetween(figure, plot, first, second, wording));
    }
    return rows;
}

std::vector<ReadPoint> pointsReadAt(PlotFigure &figure, std::size_t plot, double t)
{
    const ShownData &data = figure.data();
    std::vector<ReadPoint> points;
    const auto addUnlessMissing = [&points](Ink ink, double instant, double value) {
        if (std::isfinite(value)) {
            points.push_back({{instant, value}, ink});
        }
    };
    if (data.model.empty()) {
        return points;
    }
    const std::size_t k = data.referenceTime.empty() ? 0 : nearestIndex(data.referenceTime, t);
    if (isErrorPlot(plot)) {
        for (std::size_t i = 0; i < kChannelsPerRow; ++i) {
            const std::size_t index = plot / kPlotColumns * kChannelsPerRow + i;
            const Ink ink = i == 0 ? Ink::Error : Ink::ErrorOther;
            if (const std::vector<double> &errors = data.channels[index].errors; !errors.empty()) {
                addUnlessMissing(ink, data.referenceTime[k], errors[k]);
            } else if (figure.result->difference) {
                const double now = data.model.instantNear(t);
                addUnlessMissing(ink, now, figure.differenceAt(index, now));
            }
        }
        return points;
    }
    const std::size_t index = channelOf(plot);
    const double now = data.model.instantNear(t);
    for (const PlotFigure::KeptMotion &motion : figure.kept()) {
        addUnlessMissing(Ink::Kept, now, motion.curves.value(index, now));
    }
    addUnlessMissing(Ink::Model, now, data.model.value(index, now));
    if (const std::span<const double> reference = data.channels[index].reference; !reference.empty()) {
        addUnlessMissing(Ink::Reference, data.referenceTime[k], reference[k]);
    }
    return points;
}

QString measuredText(const PlotFigure &figure, const ReadInstants &read, const QFont &font, int room)
{
    if (!read.measured) {
        return {};
    }
    const auto [first, second] = *read.measured;
    QString change = QStringLiteral("Δt = %1 s").arg(shortNumber(second - first, kDigits));
    if (figure.result) {
        const double turned = figure.result->mechanism.omega2() * (second - first) * kDegreesPerRadian;
        change += QStringLiteral(" = %1°").arg(shortNumber(turned, kDigits));
    }
    const QString text =
        QStringLiteral("1: %1 s · 2: %2 s · %3").arg(shortNumber(first, kDigits), shortNumber(second, kDigits), change);
    return QFontMetrics(font).horizontalAdvance(text) <= room ? text : change;
}

} // namespace slidercrank
