// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/convention_text.h"

#include "core/import/difference.h"
#include "ui/text/column_text.h"
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
    /// In the explanation and the action, %1 are the columns, %2 "+ 5 mm" or "− 5 mm", %3 "5", %4 the symbol of the
    /// first column, %5 "-5 mm".
    struct Row {
        const char *name;
        const char *explanation;
        const char *action;
    };

    // In the order of Convention::Kind.
    static constexpr Row kRows[] = {
        {QT_TR_NOOP("angle unit"), QT_TR_NOOP("%1: in a unit of angle %3 times as large as the one read."),
         QT_TR_NOOP("Multiplies %1 by %3")},
        {QT_TR_NOOP("length unit"), QT_TR_NOOP("%1: in a unit of length %3 times as large as the one read."),
         QT_TR_NOOP("Multiplies %1 by %3")},
        {QT_TR_NOOP("time unit"), QT_TR_NOOP("The unit of time is %3 times as large as the one read."),
         QT_TR_NOOP("Multiplies the time stamps by %3, and converts derivatives")},
        {QT_TR_NOOP("sign"), QT_TR_NOOP("%1: with the opposite sign."), QT_TR_NOOP("Changes the sign of %1")},
        {QT_TR_NOOP("half a turn"), QT_TR_NOOP("%1: measured from the opposite direction; %4 is %1 %2."),
         QT_TR_NOOP("Adds %5 to %1, made continuous")},
        {QT_TR_NOOP("whole turns"), QT_TR_NOOP("%1: off by whole turns; %4 is %1 %2."),
         QT_TR_NOOP("Adds %5 to %1, made continuous")},
        {QT_TR_NOOP("origin"), QT_TR_NOOP("%1: measured from another origin; %4 is %1 %2."),
         QT_TR_NOOP("Adds %5 to %1")},
        {QT_TR_NOOP("swapped columns"), QT_TR_NOOP("%1: each has the heading of the other."),
         QT_TR_NOOP("Exchanges %1")},
        {QT_TR_NOOP("assembly"),
         QT_TR_NOOP("The file belongs to the other assembly: its slider is on the other side of A."),
         QT_TR_NOOP("Sets the model to the other assembly")},
        {QT_TR_NOOP("time shift"), QT_TR_NOOP("The time stamps of the file are shifted by %3 s."),
         QT_TR_NOOP("Adds %5 to the time stamps")},
        {QT_TR_NOOP("not a derivative"), QT_TR_NOOP("%1: not the time derivative of the position column."),
         QT_TR_NOOP("Leaves %1 out")},
        {QT_TR_NOOP("axis"), QT_TR_NOOP("The slider moves along y instead of x, as in an upright engine."),
         QT_TR_NOOP("Turns %1 by 90°, so that y becomes x")}};
    /// A unit and its size relative to the other units of its kind.
    struct Unit {
        Kind kind;
        double size;
        const char *name;
    };
    static constexpr Unit kUnits[] = {{Kind::AngleUnit, 1.0, QT_TR_NOOP("degrees")},
                                      {Kind::AngleUnit, kDegreesPerRadian, QT_TR_NOOP("radians")},
                                      {Kind::AngleUnit, 360.0, QT_TR_NOOP("turns")},
                                      {Kind::LengthUnit, 1.0, QT_TR_NOOP("millimetres")},
                                      {Kind::LengthUnit, 10.0, QT_TR_NOOP("centimetres")},
                                      {Kind::LengthUnit, 25.4, QT_TR_NOOP("inches")},
                                      {Kind::LengthUnit, 1000.0, QT_TR_NOOP("metres")},
                                      {Kind::TimeUnit, 0.001, QT_TR_NOOP("milliseconds")},
                                      {Kind::TimeUnit, 1.0, QT_TR_NOOP("seconds")},
                                      {Kind::TimeUnit, 60.0, QT_TR_NOOP("minutes")}};
};

static_assert(std::size(ConventionText::kRows) == static_cast<std::size_t>(Kind::Axis) + 1);

/// Returns "in radians, but read as degrees" if the factor is the ratio of two known units; otherwise an empty string.
QString misreadUnitText(const Convention &convention)
{
    constexpr double kSlack = 1e-9; // relative rounding error of a computed factor
    for (const ConventionText::Unit &read : ConventionText::kUnits) {
        for (const ConventionText::Unit &meant : ConventionText::kUnits) {
            if (read.kind == convention.kind && meant.kind == convention.kind && &meant != &read &&
                std::abs(convention.amount * read.size - meant.size) <= kSlack * meant.size) {
                return ConventionText::tr("in %1, but read as %2")
                    .arg(ConventionText::tr(meant.name), ConventionText::tr(read.name));
            }
        }
    }
    return {};
}

const ConventionText::Row &row(const Convention &convention)
{
    return ConventionText::kRows[static_cast<int>(convention.kind)];
}

/// Inserts the columns and the amount into a text.
QString filled(QString text, const Convention &convention)
{
    QStringList names;
    for (const Channel channel : convention.channels) {
        names << columnName(channel);
    }
    const bool isTime = convention.kind == Kind::TimeShift;
    const QString unit = isTime                                            ? " s"
                         : convention.channels.empty()                     ? QString()
                         : isAngle(convention.channels.front().coordinate) ? "°"
                                                                           : " mm";
    const QString magnitude = numberText(std::abs(convention.amount));
    const QString sign = convention.amount < 0.0 ? "−" : "+";
    text.replace("%5", numberText(convention.amount) + unit);
    text.replace("%2", sign + u' ' + magnitude + unit).replace("%3", magnitude);
    if (!convention.channels.empty()) {
        text.replace("%4", symbolText(convention.channels.front()));
    }
    return text.replace("%1", listed(names));
}

bool onlyMakesContinuous(const Convention &convention)
{
    return convention.kind == Kind::WholeTurns && convention.amount == 0.0;
}

/// Returns "%1: forward differences, not the time derivative."
QString notDerivativeText(Difference difference)
{
    return ConventionText::tr("%1: %2, not the time derivative.").arg("%1", differenceText(difference));
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

QString conventionName(const Convention &convention)
{
    return ConventionText::tr(row(convention).name);
}

QString explanationText(const Convention &convention, const ReferenceData &data)
{
    if (const QString unit = misreadUnitText(convention); !unit.isEmpty()) {
        return convention.kind == Kind::TimeUnit ? ConventionText::tr("The time is %1.").arg(unit)
                                                 : filled("%1: " + unit + u'.', convention);
    }
    const std::optional<Difference> difference =
        convention.kind == Kind::NotDerivative ? commonDifference(convention, data) : std::nullopt;
    const bool isOfCoupler = convention.kind == Kind::HalfTurn && convention.channels.front().coordinate == Theta3;
    return filled(difference    ? notDerivativeText(*difference)
                  : isOfCoupler ? ConventionText::tr("%1: the angle of the coupler seen from B, as textbooks draw θ₃; "
                                                     "%4 is %1 %2.")
                  : onlyMakesContinuous(convention) ? ConventionText::tr("%1: jumps by whole turns.")
                                                    : ConventionText::tr(row(convention).explanation),
                  convention);
}

QString effectText(const ConventionFinding &finding)
{
    const Convention &convention = finding.convention;
    const QString action = filled(onlyMakesContinuous(convention) ? ConventionText::tr("Makes %1 continuous")
                                                                  : ConventionText::tr(row(convention).action),
                                  convention);
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
            sentences << filled(notDerivativeText(kind), columns);
        }
    }
    return sentences;
}

} // namespace slidercrank
