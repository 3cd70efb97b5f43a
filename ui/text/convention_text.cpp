// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/convention_text.h"

#include "core/import/difference.h"

#include "ui/text/finding_text.h"
#include "ui/text/written_number.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace slidercrank
{

namespace
{

struct ConventionText {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::ConventionText)
};

QString columnsOf(const Convention &convention)
{
    QStringList names;
    for (const Channel channel : convention.channels) {
        names << columnNameOf(channel);
    }
    return listed(names);
}

/// What a unit that is so many times as large as the one it was read in must have been.
struct UnitPair {
    double factor;
    QString meant;
    QString read;
};

QString unitExplanation(const Convention &convention, std::span<const UnitPair> pairs, const QString &otherwise)
{
    constexpr double kSlack = 1e-9; // of a factor that was computed
    for (const UnitPair &pair : pairs) {
        if (std::abs(convention.amount - pair.factor) <= kSlack * pair.factor) {
            return ConventionText::tr("%1: in %2, but read as %3.").arg(columnsOf(convention), pair.meant, pair.read);
        }
    }
    return otherwise.arg(columnsOf(convention), numberText(convention.amount));
}

QString angleUnitExplanation(const Convention &convention)
{
    const QString degrees = ConventionText::tr("degrees");
    const QString radians = ConventionText::tr("radians");
    const QString turns = ConventionText::tr("turns");
    constexpr double kTurn = 360.0;
    const std::array pairs{UnitPair{kDegreesPerRadian, radians, degrees},
                           UnitPair{1.0 / kDegreesPerRadian, degrees, radians},
                           UnitPair{kTurn, turns, degrees},
                           UnitPair{1.0 / kTurn, degrees, turns},
                           UnitPair{2.0 * std::numbers::pi, turns, radians},
                           UnitPair{0.5 / std::numbers::pi, radians, turns}};
    return unitExplanation(convention, pairs,
                           ConventionText::tr("%1: in a unit of angle %2 times as large as the one read."));
}

QString lengthUnitExplanation(const Convention &convention)
{
    const QString millimetres = ConventionText::tr("millimetres");
    const QString centimetres = ConventionText::tr("centimetres");
    const QString metres = ConventionText::tr("metres");
    const QString inches = ConventionText::tr("inches");
    const std::array pairs{UnitPair{10.0, centimetres, millimetres}, UnitPair{0.1, millimetres, centimetres},
                           UnitPair{1000.0, metres, millimetres},    UnitPair{0.001, millimetres, metres},
                           UnitPair{100.0, metres, centimetres},     UnitPair{0.01, centimetres, metres},
                           UnitPair{25.4, inches, millimetres},      UnitPair{1.0 / 25.4, millimetres, inches},
                           UnitPair{0.0254, inches, metres},         UnitPair{1.0 / 0.0254, metres, inches},
                           UnitPair{2.54, inches, centimetres},      UnitPair{1.0 / 2.54, centimetres, inches}};
    return unitExplanation(convention, pairs,
                           ConventionText::tr("%1: in a unit of length %2 times as large as the one read."));
}

QString timeUnitExplanation(const Convention &convention)
{
    const double factor = convention.amount;
    QString text =
        factor == 0.001   ? ConventionText::tr("The time is in milliseconds, but was read as seconds")
        : factor == 1000. ? ConventionText::tr("The time is in seconds, but was read as milliseconds")
        : factor == 60.0
            ? ConventionText::tr("The time is in minutes, but was read as seconds")
            : ConventionText::tr("The unit of the time is %1 times as large as the one read").arg(numberText(factor));
    if (!convention.channels.empty()) {
        text += ConventionText::tr("; so are the derivatives %1").arg(columnsOf(convention));
    }
    return text + u'.';
}

/// " + 180°", " − 180°", or nothing for 0.
QString angleAdded(double degrees)
{
    if (degrees == 0.0) {
        return {};
    }
    return (degrees < 0.0 ? ConventionText::tr(" − %1°") : ConventionText::tr(" + %1°"))
        .arg(numberText(std::abs(degrees)));
}

/// "5 mm", "30°".
QString amountText(const Convention &convention)
{
    const QString number = numberText(std::abs(convention.amount));
    return isAngle(convention.channels.front().coordinate) ? ConventionText::tr("%1°").arg(number)
                                                           : ConventionText::tr("%1 mm").arg(number);
}

/// Whether the column begins at 0.
bool beginsAtZero(const ReferenceData &data, Channel channel)
{
    constexpr double kZero = 1e-9; // of the column's size
    const ReferenceSeries *series = data.find(channel);
    return series && !series->values.empty() &&
           std::abs(series->values.front()) <= kZero * rangeOf(series->values).size();
}

QString zeroPointExplanation(const Convention &convention, const ReferenceData &data)
{
    const Channel channel = convention.channels.front();
    const QString column = columnNameOf(channel);
    const bool fromStart = beginsAtZero(data, channel);
    if (isAngle(channel.coordinate)) {
        return (fromStart ? ConventionText::tr("%1: measured from where it began; %2 is %1%3.")
                          : ConventionText::tr("%1: measured from another direction; %2 is %1%3."))
            .arg(column, symbolOf(channel), angleAdded(convention.amount));
    }
    // What is missing from the column lies between O2 and its zero.
    const bool isAlongX = channel.coordinate == R4x;
    const QString where = isAlongX ? convention.amount > 0.0 ? ConventionText::tr("%1 to the right of O₂")
                                                             : ConventionText::tr("%1 to the left of O₂")
                          : convention.amount > 0.0 ? ConventionText::tr("%1 above O₂")
                                                    : ConventionText::tr("%1 below O₂");
    return (fromStart ? ConventionText::tr("%1: measured from where it began, %2.")
                      : ConventionText::tr("%1: measured from another origin, %2."))
        .arg(column, where.arg(amountText(convention)));
}

QString notDerivativeExplanation(const Convention &convention, const ReferenceData &data)
{
    const QString columns = columnsOf(convention);
    std::optional<Difference> all;
    for (const Channel channel : convention.channels) {
        const std::optional<Difference> one = differenceIn(data, channel);
        if (!one || (all && all != one)) {
            return ConventionText::tr("%1: not the time derivative of its position column.").arg(columns);
        }
        all = one;
    }
    switch (all.value_or(Difference::Central)) {
    case Difference::Forward:
        return ConventionText::tr("%1: forward differences, from each row to the next, and not the time derivative.")
            .arg(columns);
    case Difference::Backward:
        return ConventionText::tr("%1: backward differences, from each row to the one before, and not the time "
                                  "derivative.")
            .arg(columns);
    case Difference::Central: break;
    }
    return ConventionText::tr("%1: central differences of the rows on both sides, and not the time derivative.")
        .arg(columns);
}

QString actionOf(const Convention &convention)
{
    const QString columns = columnsOf(convention);
    switch (convention.kind) {
    case Convention::Kind::AngleUnit:
    case Convention::Kind::LengthUnit:
        return ConventionText::tr("Multiplies %1 by %2").arg(columns, numberText(convention.amount));
    case Convention::Kind::TimeUnit:
        return columns.isEmpty()
                   ? ConventionText::tr("Multiplies the instants by %1").arg(numberText(convention.amount))
                   : ConventionText::tr("Multiplies the instants by %1, and brings %2 to the same unit")
                         .arg(numberText(convention.amount), columns);
    case Convention::Kind::Sign: return ConventionText::tr("Changes the sign of %1").arg(columns);
    case Convention::Kind::HalfTurn:
    case Convention::Kind::WholeTurns:
        return convention.amount == 0.0
                   ? ConventionText::tr("Makes %1 continuous").arg(columns)
                   : ConventionText::tr("Adds %1° to %2, made continuous").arg(numberText(convention.amount), columns);
    case Convention::Kind::ZeroPoint:
        return (convention.amount < 0.0 ? ConventionText::tr("Subtracts %1 from %2")
                                        : ConventionText::tr("Adds %1 to %2"))
            .arg(amountText(convention), columns);
    case Convention::Kind::SwappedColumns: return ConventionText::tr("Exchanges %1").arg(columns);
    case Convention::Kind::Branch: return ConventionText::tr("Sets the model to the other assembly");
    case Convention::Kind::TimeShift:
        return ConventionText::tr("Adds %1 s to the instants").arg(numberText(convention.amount));
    case Convention::Kind::NotDerivative: return ConventionText::tr("Leaves %1 out").arg(columns);
    case Convention::Kind::Axis: return ConventionText::tr("Turns %1 by 90°, so that y becomes x").arg(columns);
    }
    return {};
}

} // namespace

QString nameOf(const Convention &convention)
{
    switch (convention.kind) {
    case Convention::Kind::AngleUnit: return ConventionText::tr("angle unit");
    case Convention::Kind::LengthUnit: return ConventionText::tr("length unit");
    case Convention::Kind::TimeUnit: return ConventionText::tr("time unit");
    case Convention::Kind::Sign: return ConventionText::tr("sign");
    case Convention::Kind::HalfTurn: return ConventionText::tr("half a turn");
    case Convention::Kind::WholeTurns: return ConventionText::tr("whole turns");
    case Convention::Kind::ZeroPoint: return ConventionText::tr("origin");
    case Convention::Kind::SwappedColumns: return ConventionText::tr("swapped columns");
    case Convention::Kind::Branch: return ConventionText::tr("assembly");
    case Convention::Kind::TimeShift: return ConventionText::tr("time shift");
    case Convention::Kind::NotDerivative: return ConventionText::tr("no derivative");
    case Convention::Kind::Axis: return ConventionText::tr("axis");
    }
    return {};
}

QString explanationOf(const Convention &convention, const ReferenceData &data)
{
    const QString columns = columnsOf(convention);
    switch (convention.kind) {
    case Convention::Kind::AngleUnit: return angleUnitExplanation(convention);
    case Convention::Kind::LengthUnit: return lengthUnitExplanation(convention);
    case Convention::Kind::TimeUnit: return timeUnitExplanation(convention);
    case Convention::Kind::Sign: {
        const bool angles = std::all_of(convention.channels.begin(), convention.channels.end(),
                                        [](Channel channel) { return isAngle(channel.coordinate); });
        const bool lengths = std::none_of(convention.channels.begin(), convention.channels.end(),
                                          [](Channel channel) { return isAngle(channel.coordinate); });
        return angles    ? ConventionText::tr("%1: measured clockwise, against the sense of the model.").arg(columns)
               : lengths ? ConventionText::tr("%1: along an axis that points the other way.").arg(columns)
                         : ConventionText::tr("%1: of the opposite sign.").arg(columns);
    }
    case Convention::Kind::HalfTurn:
        return (convention.channels.front().coordinate == Theta3
                    ? ConventionText::tr("%1: the coupler's angle seen from B, as textbooks draw θ₃; %3 is %1%2.")
                    : ConventionText::tr("%1: measured from the opposite direction; %3 is %1%2."))
            .arg(columns, angleAdded(convention.amount), symbolOf(convention.channels.front()));
    case Convention::Kind::WholeTurns:
        return convention.amount == 0.0
                   ? ConventionText::tr("%1: jumps by whole turns.").arg(columns)
                   : ConventionText::tr("%1: off by whole turns; %3 is %1%2.")
                         .arg(columns, angleAdded(convention.amount), symbolOf(convention.channels.front()));
    case Convention::Kind::ZeroPoint: return zeroPointExplanation(convention, data);
    case Convention::Kind::SwappedColumns: return ConventionText::tr("%1: each has the other's name.").arg(columns);
    case Convention::Kind::Branch:
        return ConventionText::tr("The file is of the other assembly: its slider is on the other side of A.");
    case Convention::Kind::TimeShift:
        return (convention.amount < 0.0
                    ? ConventionText::tr("The file's clock is %1 s ahead: what it has at t happens that much earlier.")
                    : ConventionText::tr("The file's clock is %1 s behind: what it has at t happens that much later."))
            .arg(numberText(std::abs(convention.amount)));
    case Convention::Kind::NotDerivative: return notDerivativeExplanation(convention, data);
    case Convention::Kind::Axis:
        return ConventionText::tr("The slider moves along y and not along x: y is its axis, as in an upright engine.");
    }
    return {};
}

QString effectOf(const ConventionFinding &finding)
{
    const QString action = actionOf(finding.convention);
    // What is left out has no error any more.
    return finding.convention.kind == Convention::Kind::NotDerivative
               ? ConventionText::tr("%1: its largest error is %2 % of peak.").arg(action, errorText(finding.before))
               : ConventionText::tr("%1: largest error %2 % of peak instead of %3 %.")
                     .arg(action, errorText(finding.after), errorText(finding.before));
}

QStringList differenceSentences(const ReferenceData &data, std::span<const ConventionFinding> findings)
{
    QStringList sentences;
    for (const Difference kind : {Difference::Forward, Difference::Backward, Difference::Central}) {
        Convention none{Convention::Kind::NotDerivative, {}, 1.0};
        for (const ReferenceSeries &series : data.series) {
            const bool isLeftOut = std::ranges::any_of(findings, [&](const ConventionFinding &finding) {
                return finding.convention.kind == none.kind && concerns(finding.convention, series.channel);
            });
            if (!isLeftOut && differenceIn(data, series.channel) == kind) {
                none.channels.push_back(series.channel);
            }
        }
        if (!none.channels.empty()) {
            sentences << explanationOf(none, data);
        }
    }
    return sentences;
}

} // namespace slidercrank
