// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/motion_table.h"

#include "core/mechanism/turn.h"
#include "core/mechanism/two_part_angle.h"
#include "core/sampling/crank_time.h"
#include "ui/export/motion_csv.h"
#include "ui/text/motion_facts.h"
#include "ui/text/notation.h"
#include "ui/text/record.h"
#include "ui/text/written_number.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <cmath>

namespace slidercrank
{

namespace
{

struct MotionTable {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::MotionTable)
};

constexpr int kTableDigits = 5;

std::vector<OutputChannel> coordinateChannels(Coordinate coordinate)
{
    return {Channel{coordinate, Order::Position}, Channel{coordinate, Order::Velocity},
            Channel{coordinate, Order::Acceleration}};
}

std::vector<OutputChannel> derivedChannels(DerivedQuantity quantity)
{
    return {DerivedChannel{quantity, Order::Position}, DerivedChannel{quantity, Order::Velocity},
            DerivedChannel{quantity, Order::Acceleration}};
}

constexpr Channel kCouplerAngle{Theta3, Order::Position};

bool isMeasuredAtB(const OutputChannel &channel)
{
    return notation().symbols == Symbols::Textbook && channel == OutputChannel(kCouplerAngle);
}

void append(std::vector<OutputChannel> &channels, const std::vector<OutputChannel> &appended)
{
    channels.insert(channels.end(), appended.begin(), appended.end());
}

TableCell tableNumber(double value)
{
    return numberCell(value, shortNumber(value, kTableDigits));
}

/// Gives the row of 360° the time at the end of the revolution if the row of 0° has the time at its beginning: t = 0
/// and t = 1 s instead of t = 0 twice.
void endRevolution(std::vector<TablePosition> &positions, const Mechanism &mechanism, const Sampling &sampling)
{
    constexpr double kRounding = 1e-9; // rad, or fraction of the duration
    const bool isRevolution = positions.size() > 1 && std::abs(positions.back().theta2 - kTurn) < kRounding;
    if (!isRevolution || mechanism.omega2() <= 0.0) {
        return;
    }
    const std::optional<double> first = positions.front().time;
    const std::optional<double> beforeLast = positions[positions.size() - 2].time;
    if (!first || !beforeLast || *beforeLast < *first) {
        return; // the crank starts at a different angle
    }
    const double end = *first + kTurn / mechanism.omega2();
    const double endOfRange = sampling.start + sampling.duration;
    if (end <= endOfRange + kRounding * sampling.duration) {
        positions.back().time = std::min(end, endOfRange);
    }
}

QString numberInFile(double value, const CsvStyle &style)
{
    constexpr int kDigits = 6;
    const QString text = style.hasEveryDigit ? QString::number(value, 'g', QLocale::FloatingPointShortest)
                                             : QString::number(value, 'g', kDigits);
    return style.isLocal ? QString(text).replace('.', QLocale().decimalPoint()) : text;
}

} // namespace

std::vector<OutputChannel> usualTableChannels()
{
    std::vector<OutputChannel> channels;
    append(channels, coordinateChannels(Theta3));
    append(channels, coordinateChannels(R4x));
    append(channels, {DerivedChannel{DerivedQuantity::TransmissionAngle, Order::Position},
                      DerivedChannel{DerivedQuantity::Displacement, Order::Position}});
    return channels;
}

std::vector<OutputChannel> tableChannels()
{
    std::vector<OutputChannel> channels = usualTableChannels();
    append(channels, derivedChannels(DerivedQuantity::PinX));
    append(channels, derivedChannels(DerivedQuantity::PinY));
    append(channels, coordinateChannels(R3x));
    append(channels, coordinateChannels(R3y));
    return channels;
}

std::vector<TablePosition> tablePositions(const MotionTableSettings &settings, const Mechanism &mechanism,
                                          const Sampling &sampling)
{
    constexpr double kDegreesPerTurn = 360.0;
    constexpr double kRounding = 1.0 + 1e-12; // keeps the last step despite rounding errors
    std::vector<TablePosition> positions;
    if (settings.step == TableStep::Time) {
        const int steps = static_cast<int>(
            std::min(sampling.duration / settings.timeStep * kRounding, static_cast<double>(kMaxTableRows - 1)));
        for (int i = 0; i <= steps; ++i) {
            const double t = sampling.start + i * settings.timeStep;
            positions.push_back({crankAngle(mechanism.omega2(), t, mechanism.theta20()).hi, t});
        }
        return positions;
    }
    const int steps = static_cast<int>(
        std::min(kDegreesPerTurn / settings.angleStep * kRounding, static_cast<double>(kMaxTableRows - 1)));
    for (int i = 0; i <= steps; ++i) {
        const double theta2 = i * settings.angleStep / kDegreesPerRadian;
        positions.push_back({theta2, timeOf({.theta2 = theta2}, mechanism, sampling)});
    }
    endRevolution(positions, mechanism, sampling);
    return positions;
}

std::vector<TableColumn> motionTableColumns(const MotionTableSettings &settings)
{
    const auto titled = [](const QString &symbol, const QString &unit) {
        return QStringLiteral("%1 [%2]").arg(symbol, unit);
    };
    const QString angle = shownUnit(Measure::Angle);
    std::vector<TableColumn> columns{
        {.title = "t [s]",
         .explanation = MotionTable::tr("Time; a dash where the crank does not reach this angle within the time range"),
         .csvName = settings.step == TableStep::Time ? QStringLiteral("time [s]") : QStringLiteral("first time [s]")},
        {.title = titled("θ₂", angle),
         .explanation = MotionTable::tr("Crank angle"),
         .csvName = nameWithAsciiUnit("theta2", Measure::Angle, notation().units)}};
    for (const OutputChannel &channel : settings.columns) {
        const QString name = isMeasuredAtB(channel) ? QString(kCouplerAngleAtB) : columnName(channel);
        columns.push_back({.title = titled(symbolOf(channel), shownUnit(channel)),
                           .explanation = nameText(channel),
                           .csvName = nameWithAsciiUnit(name, measureOf(channel), notation().units)});
    }
    return columns;
}

TableRow motionTableRow(const MotionTableSettings &settings, const Mechanism &mechanism, double alpha2,
                        const TablePosition &position)
{
    const OutputState state = unambiguousStateAt(withCrankAt(mechanism, position.theta2), 0.0, alpha2);
    TableRow row;
    row.explanation = velocitiesJumpAt(mechanism, position.theta2) ? jumpSentence() : QString();
    row.time = position.time;
    TableCell timeCell = position.time ? tableNumber(*position.time) : TableCell{.text = dash()};
    timeCell.tone = position.time ? Tone::Link : Tone::Normal;
    row.cells.push_back(timeCell);
    constexpr double kRounding = 1e-12; // relative
    const bool isInFirstTurn =
        position.theta2 >= 0.0 && position.theta2 <= kTurn * (1.0 + kRounding); // then 360° is shown, not 0°
    row.cells.push_back(tableNumber(isInFirstTurn ? shownValue(Measure::Angle, position.theta2, notation().units)
                                                  : shownCrankAngle(position.theta2)));
    for (const OutputChannel &channel : settings.columns) {
        const double value = withoutNoise(state.valueOf(channel), channel, mechanism, alpha2);
        row.cells.push_back(tableNumber(shownChannel(channel, mechanism.branch(), value)));
    }
    return row;
}

QByteArray csvText(const std::vector<TableColumn> &columns, const std::vector<TableRow> &rows, const CsvStyle &style)
{
    const QChar separator = delimiter(style.isLocal ? CsvSeparators::OfLanguage : CsvSeparators::Standard);
    QStringList line;
    for (const TableColumn &column : columns) {
        line << column.csvName;
    }
    QString text = line.join(separator) + '\n';
    for (const TableRow &row : rows) {
        line.clear();
        for (const TableCell &cell : row.cells) {
            line << (cell.number ? numberInFile(*cell.number, style) : QString());
        }
        text += line.join(separator) + '\n';
    }
    return text.toUtf8();
}

std::optional<double> nextTime(const std::vector<double> &angles, const Mechanism &mechanism, const Sampling &sampling,
                               double t)
{
    constexpr double kMaxDistance = 1e-9; // rad: an angle nearer than this has been reached
    if (mechanism.omega2() == 0.0) {
        return std::nullopt;
    }
    const double end = sampling.start + sampling.duration;
    const double slack = 1e-9 * sampling.duration; // includes the end of the time range
    for (const double from : {t + kMaxDistance / std::abs(mechanism.omega2()), sampling.start}) {
        std::optional<double> first;
        for (const double theta2 : angles) {
            const std::optional<double> time = timeAtCrankAngle(mechanism, theta2, from);
            if (time && *time <= end + slack && (!first || *time < *first)) {
                first = std::min(*time, end);
            }
        }
        if (first) {
            return first;
        }
    }
    return std::nullopt;
}

} // namespace slidercrank
