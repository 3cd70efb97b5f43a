// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/convention_text.h"

#include "ui/text/channel_text.h"
#include "ui/text/comparison_text.h"
#include "ui/text/enum_table.h"
#include "ui/text/word_list.h"
#include "ui/text/written_number.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace slidercrank
{

namespace
{

using Kind = Convention::Kind;

struct ConventionText {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::ConventionText)

public:
    enum class Amount {
        None,
        Factor,
        Degrees,
        Seconds,
        OfChannel ///< in the unit of the first column
    };

    /// A row of the table of conventions. explanationText() replaces the placeholders in its text: {columns} by the
    /// names of the columns, {symbol} by the symbol of the first one, {shift} by "+ 5 mm" or "− 5 mm", {value} by
    /// "5 mm" or "−5 mm", {units} by "in radians, but read as degrees".
    struct Row {
        Kind key;
        const char *name; ///< in files and JSON
        Amount amount;
        const char *text;
    };
    static constexpr Row kRows[] = {
        {Kind::AngleUnit, "angle-unit", Amount::Factor, "{columns}: {units}."},
        {Kind::LengthUnit, "length-unit", Amount::Factor, "{columns}: {units}."},
        {Kind::TimeUnit, "time-unit", Amount::Factor, QT_TR_NOOP("The time is {units}.")},
        {Kind::Sign, "sign", Amount::Factor, QT_TR_NOOP("{columns}: with the opposite sign.")},
        {Kind::HalfTurn, "half-turn", Amount::Degrees,
         QT_TR_NOOP("{columns}: measured from the opposite direction; {symbol} = value in the file {shift}.")},
        {Kind::WholeTurns, "whole-turns", Amount::Degrees,
         QT_TR_NOOP("{columns}: off by whole turns; {symbol} = value in the file {shift}.")},
        {Kind::ZeroPoint, "zero-point", Amount::OfChannel,
         QT_TR_NOOP("{columns}: measured from a different origin; the zero of the file is at {symbol} = {value}.")},
        {Kind::SwappedColumns, "swapped-columns", Amount::None, QT_TR_NOOP("{columns}: the headings are swapped.")},
        {Kind::OtherAssembly, "branch", Amount::None,
         QT_TR_NOOP("The mechanism that produced the file has the other assembly: its slider is on the other side "
                    "of A.")},
        {Kind::TimeShift, "time-shift", Amount::Seconds,
         QT_TR_NOOP("The time stamps are shifted: t = time in the file {shift}.")},
        {Kind::NotDerivative, "not-derivative", Amount::None,
         QT_TR_NOOP("{columns}: not the time derivative of the position column.")},
        {Kind::Axis, "axis", Amount::None,
         QT_TR_NOOP("The slider moves along y instead of x, as in an upright engine.")}};

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
        {Kind::LengthUnit, 304.8, QT_TR_NOOP("feet"), QT_TR_NOOP("millimetres")},
        {Kind::TimeUnit, 60.0, QT_TR_NOOP("minutes"), QT_TR_NOOP("seconds")},
        {Kind::TimeUnit, 1000.0, QT_TR_NOOP("seconds"), QT_TR_NOOP("milliseconds")},
        {Kind::TimeUnit, 1e6, QT_TR_NOOP("seconds"), QT_TR_NOOP("microseconds")}};
};

static_assert(isCompleteTable(ConventionText::kRows, Kind::Axis));

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
    // The file states a unit that kUnits does not list. For such a unit, only the default unit is tried instead.
    return convention.kind == Kind::TimeUnit ? ConventionText::tr("in seconds, but read in a different unit")
                                             : ConventionText::tr("in millimetres, but read in a different unit");
}

/// Returns the sentence of a convention, with the placeholders of ConventionText::Row.
QString sentenceOf(const Convention &convention)
{
    if (convention.kind == Kind::HalfTurn && concerns(convention, {Theta3, Order::Position})) {
        return ConventionText::tr("{columns}: the angle of the coupler seen from B, as textbooks draw θ₃; {symbol} = "
                                  "value in the file {shift}.");
    }
    if (convention.kind == Kind::WholeTurns && convention.amount == 0.0) {
        return ConventionText::tr("{columns}: jumps by whole turns.");
    }
    return ConventionText::tr(rowOf(ConventionText::kRows, convention.kind).text);
}

bool isUnit(Kind kind)
{
    return kind == Kind::AngleUnit || kind == Kind::LengthUnit || kind == Kind::TimeUnit;
}

/// Returns what follows a number of the channel: "°" or " mm/s".
QString unitSuffix(Channel channel)
{
    const QString unit = unitText(channel);
    return unit == u"°" ? unit : u' ' + unit;
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

const char *conventionName(Kind kind)
{
    return rowOf(ConventionText::kRows, kind).name;
}

std::optional<Kind> conventionNamed(const QString &name)
{
    const auto hasName = [&name](const ConventionText::Row &row) { return name == QLatin1String(row.name); };
    const auto row = std::ranges::find_if(ConventionText::kRows, hasName);
    return row == std::end(ConventionText::kRows) ? std::nullopt : std::optional(row->key);
}

std::optional<QString> amountUnit(const Convention &convention)
{
    using Amount = ConventionText::Amount;
    switch (rowOf(ConventionText::kRows, convention.kind).amount) {
    case Amount::None: return std::nullopt;
    case Amount::Factor: return QString();
    case Amount::Degrees: return "°";
    case Amount::Seconds: return "s";
    case Amount::OfChannel: return unitText(convention.channels.front());
    }
    return std::nullopt;
}

QString explanationText(const Convention &convention)
{
    const Channel channel = convention.channels.empty() ? Channel() : convention.channels.front();
    const double amount = convention.amount;
    const QString unit = convention.kind == Kind::TimeShift ? " s" : unitSuffix(channel);
    QString text = sentenceOf(convention);
    text.replace("{columns}", columnNames(convention.channels));
    text.replace("{symbol}", symbolText(channel));
    text.replace("{shift}", (amount < 0.0 ? "− " : "+ ") + numberText(std::abs(amount)) + unit);
    text.replace("{value}", numberText(amount) + unit);
    if (isUnit(convention.kind)) {
        text.replace("{units}", misreadUnitText(convention));
    }
    return text;
}

QString findingText(const ConventionFinding &finding)
{
    const QString explanation = explanationText(finding.convention);
    return finding.convention.kind == Kind::NotDerivative // the column is left out, and has no error afterwards
               ? explanation
               : ConventionText::tr("%1 Largest error: %2 → %3 % of peak.")
                     .arg(explanation, errorText(finding.before), errorText(finding.after));
}

QString finiteDifferenceSentence(const FileLayout &layout)
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
