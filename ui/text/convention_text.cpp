// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/convention_text.h"

#include "ui/text/finding_text.h"
#include "ui/text/written_number.h"

#include <QCoreApplication>

#include <cmath>

namespace slidercrank
{

namespace
{

using Kind = Convention::Kind;

struct ConventionText {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::ConventionText)

public:
    // In the order of Convention::Kind. %1 are the columns, %2 "+ 5 mm" or "− 5 mm", %3 the symbol of the first column,
    // %4 "in radians, but read as degrees".
    static constexpr const char *kExplanations[] = {
        "%1: %4.", // AngleUnit
        "%1: %4.", // LengthUnit
        QT_TR_NOOP("The time is %4."),
        QT_TR_NOOP("%1: with the opposite sign."),
        QT_TR_NOOP("%1: measured from the opposite direction; %3 is %1 %2."),
        QT_TR_NOOP("%1: off by whole turns; %3 is %1 %2."),
        QT_TR_NOOP("%1: measured from another origin; %3 is %1 %2."),
        QT_TR_NOOP("%1: each has the heading of the other."),
        QT_TR_NOOP("The file belongs to the other assembly: its slider is on the other side of A."),
        QT_TR_NOOP("The time stamps are shifted: t is the time in the file %2."),
        QT_TR_NOOP("%1: not the time derivative of the position column."),
        QT_TR_NOOP("The slider moves along y instead of x, as in an upright engine.")};

    /// Two units, one of which is `factor` times as large as the other.
    struct UnitPair {
        Kind kind;
        double factor;
        const char *larger;
        const char *smaller;
    };
    static constexpr UnitPair kUnits[] = {
        {Kind::AngleUnit, kDegreesPerRadian, QT_TR_NOOP("radians"), QT_TR_NOOP("degrees")},
        {Kind::LengthUnit, 10.0, QT_TR_NOOP("centimetres"), QT_TR_NOOP("millimetres")},
        {Kind::LengthUnit, 25.4, QT_TR_NOOP("inches"), QT_TR_NOOP("millimetres")},
        {Kind::LengthUnit, 1000.0, QT_TR_NOOP("metres"), QT_TR_NOOP("millimetres")},
        {Kind::TimeUnit, 1000.0, QT_TR_NOOP("seconds"), QT_TR_NOOP("milliseconds")}};
};

static_assert(std::size(ConventionText::kExplanations) == static_cast<std::size_t>(Kind::Axis) + 1);

/// Returns "in radians, but read as degrees". The amount is one of the factors between units (convention.h).
QString misreadUnitText(const Convention &convention)
{
    constexpr double kSlack = 1e-9; // relative rounding error of a computed factor
    for (const auto &[kind, factor, larger, smaller] : ConventionText::kUnits) {
        const bool isLarger = std::abs(convention.amount / factor - 1.0) < kSlack;
        if (kind == convention.kind && (isLarger || std::abs(convention.amount * factor - 1.0) < kSlack)) {
            return ConventionText::tr("in %1, but read as %2")
                .arg(ConventionText::tr(isLarger ? larger : smaller), ConventionText::tr(isLarger ? smaller : larger));
        }
    }
    return {};
}

QString columnNames(const std::vector<Channel> &channels)
{
    QStringList names;
    for (const Channel channel : channels) {
        names << columnName(channel);
    }
    return listed(names);
}

} // namespace

QString explanationText(const Convention &convention)
{
    const Channel channel = convention.channels.empty() ? Channel() : convention.channels.front();
    const QString unit = convention.kind == Kind::TimeShift ? " s" : isAngle(channel.coordinate) ? "°" : " mm";
    const bool isOfCoupler = convention.kind == Kind::HalfTurn && channel.coordinate == Theta3;
    const bool onlyJumps = convention.kind == Kind::WholeTurns && convention.amount == 0.0;
    QString text = isOfCoupler ? ConventionText::tr("%1: the angle of the coupler seen from B, as textbooks draw θ₃; "
                                                    "%3 is %1 %2.")
                   : onlyJumps ? ConventionText::tr("%1: jumps by whole turns.")
                               : ConventionText::tr(ConventionText::kExplanations[static_cast<int>(convention.kind)]);
    return text.replace("%4", misreadUnitText(convention))
        .replace("%3", symbolText(channel))
        .replace("%2", (convention.amount < 0.0 ? "− " : "+ ") + numberText(std::abs(convention.amount)) + unit)
        .replace("%1", columnNames(convention.channels));
}

QString findingText(const ConventionFinding &finding)
{
    const QString explanation = explanationText(finding);
    return finding.kind == Kind::NotDerivative // the column is left out, and has no error afterwards
               ? explanation
               : ConventionText::tr("%1 Largest error: %2 → %3 % of peak.")
                     .arg(explanation, errorText(finding.before), errorText(finding.after));
}

QString differenceSentence(const FileLayout &layout)
{
    std::vector<Channel> channels;
    for (const FileColumn &column : layout.columns) {
        if (column.difference) {
            channels.push_back(column.channel);
        }
    }
    return channels.empty()
               ? QString()
               : ConventionText::tr("%1: finite differences, not the time derivative.").arg(columnNames(channels));
}

} // namespace slidercrank
