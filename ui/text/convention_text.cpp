// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/convention_text.h"

#include "core/import/difference.h"

#include "ui/text/finding_text.h"
#include "ui/text/written_number.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace slidercrank
{

namespace
{

using Kind = Convention::Kind;

struct ConventionText {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::ConventionText)

public:
    static QString name(Kind kind)
    {
        using enum Convention::Kind;
        switch (kind) {
        case AngleUnit: return tr("angle unit");
        case LengthUnit: return tr("length unit");
        case TimeUnit: return tr("time unit");
        case Sign: return tr("sign");
        case HalfTurn: return tr("half a turn");
        case WholeTurns: return tr("whole turns");
        case ZeroPoint: return tr("origin");
        case SwappedColumns: return tr("swapped columns");
        case Branch: return tr("assembly");
        case TimeShift: return tr("time shift");
        case NotDerivative: return tr("no derivative");
        case Axis: return tr("axis");
        }
        return {};
    }

    /// %1 are the columns, %2 "+ 5 mm" or "− 5 mm", %3 "5", %4 the symbol of the first column, %5 "-5 mm".
    static QString explanation(Kind kind)
    {
        using enum Convention::Kind;
        switch (kind) {
        case AngleUnit: return tr("%1: in a unit of angle %3 times as large as the one read.");
        case LengthUnit: return tr("%1: in a unit of length %3 times as large as the one read.");
        case TimeUnit: return tr("The unit of time is %3 times as large as the one read.");
        case Sign: return tr("%1: with the opposite sign.");
        case HalfTurn: return tr("%1: measured from the opposite direction; %4 is %1 %2.");
        case WholeTurns: return tr("%1: off by whole turns; %4 is %1 %2.");
        case ZeroPoint: return tr("%1: measured from another origin; %4 is %1 %2.");
        case SwappedColumns: return tr("%1: each has the heading of the other.");
        case Branch: return tr("The file belongs to the other assembly: its slider is on the other side of A.");
        case TimeShift: return tr("The time stamps of the file are shifted by %3 s.");
        case NotDerivative: return tr("%1: not the time derivative of the position column.");
        case Axis: return tr("The slider moves along y instead of x, as in an upright engine.");
        }
        return {};
    }

    static QString action(Kind kind)
    {
        using enum Convention::Kind;
        switch (kind) {
        case AngleUnit:
        case LengthUnit: return tr("Multiplies %1 by %3");
        case TimeUnit: return tr("Multiplies the time stamps by %3, and converts derivatives");
        case Sign: return tr("Changes the sign of %1");
        case HalfTurn:
        case WholeTurns: return tr("Adds %5 to %1, made continuous");
        case ZeroPoint: return tr("Adds %5 to %1");
        case SwappedColumns: return tr("Exchanges %1");
        case Branch: return tr("Sets the model to the other assembly");
        case TimeShift: return tr("Adds %5 to the time stamps");
        case NotDerivative: return tr("Leaves %1 out");
        case Axis: return tr("Turns %1 by 90°, so that y becomes x");
        }
        return {};
    }

    static QString differences(Difference difference)
    {
        switch (difference) {
        case Difference::Forward: return tr("%1: forward differences, not the time derivative.");
        case Difference::Backward: return tr("%1: backward differences, not the time derivative.");
        case Difference::Central: return tr("%1: central differences, not the time derivative.");
        }
        return {};
    }
};

/// A unit and its size relative to the other units of the table.
struct NamedUnit {
    double size;
    const char *name;
};

constexpr NamedUnit kAngleUnits[] = {{1.0, QT_TRANSLATE_NOOP("slidercrank::ConventionText", "degrees")},
                                     {kDegreesPerRadian, QT_TRANSLATE_NOOP("slidercrank::ConventionText", "radians")},
                                     {360.0, QT_TRANSLATE_NOOP("slidercrank::ConventionText", "turns")}};
constexpr NamedUnit kLengthUnits[] = {{1.0, QT_TRANSLATE_NOOP("slidercrank::ConventionText", "millimetres")},
                                      {10.0, QT_TRANSLATE_NOOP("slidercrank::ConventionText", "centimetres")},
                                      {25.4, QT_TRANSLATE_NOOP("slidercrank::ConventionText", "inches")},
                                      {1000.0, QT_TRANSLATE_NOOP("slidercrank::ConventionText", "metres")}};
constexpr NamedUnit kTimeUnits[] = {{0.001, QT_TRANSLATE_NOOP("slidercrank::ConventionText", "milliseconds")},
                                    {1.0, QT_TRANSLATE_NOOP("slidercrank::ConventionText", "seconds")},
                                    {60.0, QT_TRANSLATE_NOOP("slidercrank::ConventionText", "minutes")}};

/// Returns "in radians, but read as degrees" if two units of the table differ by the factor; otherwise an empty string.
QString unitText(double factor, std::span<const NamedUnit> units)
{
    constexpr double kSlack = 1e-9; // relative rounding error of a computed factor
    for (const NamedUnit &read : units) {
        for (const NamedUnit &meant : units) {
            if (&meant != &read && std::abs(factor * read.size - meant.size) <= kSlack * meant.size) {
                return ConventionText::tr("in %1, but read as %2")
                    .arg(ConventionText::tr(meant.name), ConventionText::tr(read.name));
            }
        }
    }
    return {};
}

QString unitText(const Convention &convention)
{
    switch (convention.kind) {
    case Kind::AngleUnit: return unitText(convention.amount, kAngleUnits);
    case Kind::LengthUnit: return unitText(convention.amount, kLengthUnits);
    case Kind::TimeUnit: return unitText(convention.amount, kTimeUnits);
    default: return {};
    }
}

/// Inserts the columns and the amount into a text.
QString filled(QString text, const Convention &convention)
{
    QStringList names;
    for (const Channel channel : convention.channels) {
        names << columnNameOf(channel);
    }
    const bool isTime = convention.kind == Kind::TimeShift;
    const QString unit = isTime                                            ? QStringLiteral(" s")
                         : convention.channels.empty()                     ? QString()
                         : isAngle(convention.channels.front().coordinate) ? QStringLiteral("°")
                                                                           : QStringLiteral(" mm");
    const QString magnitude = numberText(std::abs(convention.amount));
    const QString sign = convention.amount < 0.0 ? QStringLiteral("−") : QStringLiteral("+");
    text.replace(QStringLiteral("%5"), numberText(convention.amount) + unit);
    text.replace(QStringLiteral("%2"), sign + u' ' + magnitude + unit).replace(QStringLiteral("%3"), magnitude);
    if (!convention.channels.empty()) {
        text.replace(QStringLiteral("%4"), symbolOf(convention.channels.front()));
    }
    return text.replace(QStringLiteral("%1"), listed(names));
}

/// Returns the kind of differences that all columns contain, or nullopt if they do not agree.
std::optional<Difference> commonDifference(const Convention &convention, const ReferenceData &data)
{
    std::optional<Difference> common;
    for (const Channel channel : convention.channels) {
        const std::optional<Difference> found = differenceIn(data, channel);
        if (!found || (common && common != found)) {
            return std::nullopt;
        }
        common = found;
    }
    return common;
}

} // namespace

QString nameOf(const Convention &convention)
{
    return ConventionText::name(convention.kind);
}

QString explanationOf(const Convention &convention, const ReferenceData &data)
{
    if (const QString unit = unitText(convention); !unit.isEmpty()) {
        return convention.kind == Kind::TimeUnit ? ConventionText::tr("The time is %1.").arg(unit)
                                                 : filled(QStringLiteral("%1: ") + unit + u'.', convention);
    }
    if (convention.kind == Kind::NotDerivative) {
        const std::optional<Difference> difference = commonDifference(convention, data);
        return filled(difference ? ConventionText::differences(*difference)
                                 : ConventionText::explanation(convention.kind),
                      convention);
    }
    const bool isOfCoupler = convention.kind == Kind::HalfTurn && convention.channels.front().coordinate == Theta3;
    if (isOfCoupler) {
        return filled(
            ConventionText::tr("%1: the angle of the coupler seen from B, as textbooks draw θ₃; %4 is %1 %2."),
            convention);
    }
    if (convention.kind == Kind::WholeTurns && convention.amount == 0.0) {
        return filled(ConventionText::tr("%1: jumps by whole turns."), convention);
    }
    return filled(ConventionText::explanation(convention.kind), convention);
}

QString effectOf(const ConventionFinding &finding)
{
    const Convention &convention = finding.convention;
    const bool isContinuous = convention.kind == Kind::WholeTurns && convention.amount == 0.0;
    const QString action = filled(
        isContinuous ? ConventionText::tr("Makes %1 continuous") : ConventionText::action(convention.kind), convention);
    return convention.kind == Kind::NotDerivative // then there is no error afterwards
               ? ConventionText::tr("%1: its largest error is %2 % of peak.").arg(action, errorText(finding.before))
               : ConventionText::tr("%1: largest error %2 % of peak instead of %3 %.")
                     .arg(action, errorText(finding.after), errorText(finding.before));
}

QStringList differenceSentences(const ReferenceData &data, std::span<const ConventionFinding> findings)
{
    QStringList sentences;
    for (const Difference kind : {Difference::Forward, Difference::Backward, Difference::Central}) {
        Convention columns{Kind::NotDerivative, {}, 1.0};
        for (const ReferenceSeries &series : data.series) {
            const bool isLeftOut = std::ranges::any_of(findings, [&](const ConventionFinding &finding) {
                return finding.convention.kind == columns.kind && concerns(finding.convention, series.channel);
            });
            if (!isLeftOut && differenceIn(data, series.channel) == kind) {
                columns.channels.push_back(series.channel);
            }
        }
        if (!columns.channels.empty()) {
            sentences << filled(ConventionText::differences(kind), columns);
        }
    }
    return sentences;
}

} // namespace slidercrank
