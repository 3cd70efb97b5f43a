// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/finding_text.h"

#include "core/import/reference_data.h"
#include "ui/text/enum_table.h"
#include "ui/text/notation.h"
#include "ui/text/written_number.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>

#include <algorithm>
#include <cmath>

namespace slidercrank
{

namespace
{

constexpr bool isAlongX(Coordinate coordinate)
{
    return coordinate == R1x || coordinate == R2x || coordinate == R3x || coordinate == R4x;
}

struct BodyWords {
    const char *name;        ///< untranslated
    const char *superscript; ///< in absolute coordinates
};

struct FindingText {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::FindingText)

public:
    struct ParameterWords {
        Parameter key;
        const char *name;   ///< untranslated
        const char *symbol; ///< in equations
        const char *option; ///< on the command line and in JSON
    };
    static constexpr ParameterWords kParameters[] = {
        {Parameter::A, QT_TR_NOOP("crank"), "a", "a"},
        {Parameter::B, QT_TR_NOOP("coupler"), "b", "b"},
        {Parameter::C, QT_TR_NOOP("offset"), "c", "c"},
        {Parameter::Omega2, QT_TR_NOOP("crank speed"), "ω₂", "omega2"},
        {Parameter::Theta20, QT_TR_NOOP("initial angle"), "θ₂₀", "theta20"}};
    static_assert(isCompleteTable(kParameters, Parameter::Theta20));

    static BodyWords bodyOf(Coordinate coordinate)
    {
        switch (coordinate) {
        case R1x:
        case R1y:
        case Theta1: break;
        case R2x:
        case R2y:
        case Theta2: return {QT_TR_NOOP("crank"), "²"};
        case R3x:
        case R3y:
        case Theta3: return {QT_TR_NOOP("coupler"), "³"};
        case R4x:
        case R4y:
        case Theta4: return {QT_TR_NOOP("slider"), "⁴"};
        }
        return {QT_TR_NOOP("ground"), "¹"};
    }

    /// The names of a position and of its derivatives, for any body. Untranslated.
    struct QuantityNames {
        const char *position;
        const char *velocity;
        const char *acceleration;

        const char *of(Order order) const
        {
            switch (order) {
            case Order::Position: break;
            case Order::Velocity: return velocity;
            case Order::Acceleration: return acceleration;
            }
            return position;
        }
    };

    static QuantityNames namesOf(Coordinate coordinate)
    {
        if (isAngle(coordinate)) {
            return {QT_TR_NOOP("%1 angle"), QT_TR_NOOP("%1 angular velocity"), QT_TR_NOOP("%1 angular acceleration")};
        }
        if (coordinate == R4x) {
            return {QT_TR_NOOP("%1 position"), QT_TR_NOOP("%1 velocity"), QT_TR_NOOP("%1 acceleration")};
        }
        if (isAlongX(coordinate)) {
            return {QT_TR_NOOP("%1 centre in x"), QT_TR_NOOP("%1 centre's velocity in x"),
                    QT_TR_NOOP("%1 centre's acceleration in x")};
        }
        return {QT_TR_NOOP("%1 centre in y"), QT_TR_NOOP("%1 centre's velocity in y"),
                QT_TR_NOOP("%1 centre's acceleration in y")};
    }

    static QString quantity(Channel channel)
    {
        return tr(namesOf(channel.coordinate).of(channel.order)).arg(tr(bodyOf(channel.coordinate).name));
    }
};

int exponentOf(double magnitude)
{
    return static_cast<int>(std::floor(std::log10(magnitude)));
}

/// Joins words by a pattern such as "%1 and %2", and all but the last one by commas.
QString joined(const QStringList &words, const QString &pattern)
{
    return words.size() < 2 ? words.join(QString())
                            : pattern.arg(words.first(words.size() - 1).join(", "), words.last());
}

/// Returns an equation for each parameter, and the assembly.
QStringList equationTexts(const Parameters &parameters, int digits = 6)
{
    QStringList parts;
    for (const Parameter parameter : kAllParameters) {
        parts << equationText(parameter, valueOf(parameters, parameter), digits);
    }
    return parts << withNoun(parameters.branch);
}

} // namespace

QString listed(const QStringList &words)
{
    return joined(words, FindingText::tr("%1 and %2"));
}

QString anyOf(const QStringList &words)
{
    return joined(words, FindingText::tr("%1 or %2"));
}

QString errorText(std::optional<double> value)
{
    constexpr int kDigits = 3;
    return shortNumber(value, kDigits);
}

QString symbolText(Channel channel)
{
    if (notation().symbols == Symbols::Textbook && (channel.coordinate == Theta3 || channel.coordinate == R4x)) {
        const bool isCoupler = channel.coordinate == Theta3;
        switch (channel.order) {
        case Order::Position: break;
        case Order::Velocity: return isCoupler ? "ω₃" : "v_B";
        case Order::Acceleration: return isCoupler ? "α₃" : "a_B";
        }
        return isCoupler ? "θ₃" : "x_B";
    }
    return absoluteSymbolText(channel);
}

QString absoluteSymbolText(Channel channel)
{
    const bool isAngular = isAngle(channel.coordinate);
    const bool isStroke = channel.coordinate == R4x && channel.order != Order::Position;
    const QString body = channel.coordinate == Theta2 ? "₂" : FindingText::bodyOf(channel.coordinate).superscript;
    QString direction;
    if (!isAngular && !isStroke) {
        direction = isAlongX(channel.coordinate) ? "ₓ" : "_y";
    }
    switch (channel.order) {
    case Order::Position: break;
    case Order::Velocity: return (isAngular ? "ω" : "v") + direction + body;
    case Order::Acceleration: return (isAngular ? "α" : "a") + direction + body;
    }
    return (isAngular ? "θ" : "R") + direction + body;
}

QString quantityName(Channel channel)
{
    return FindingText::quantity(channel);
}

QString columnName(Channel channel)
{
    return QString::fromUtf8(nameOf(channel));
}

QString unitText(Channel channel)
{
    return QString::fromUtf8(fileUnit(channel));
}

QString parameterName(Parameter parameter)
{
    return FindingText::tr(rowOf(FindingText::kParameters, parameter).name);
}

QString symbolText(Parameter parameter)
{
    return rowOf(FindingText::kParameters, parameter).symbol;
}

const char *optionName(Parameter parameter)
{
    return rowOf(FindingText::kParameters, parameter).option;
}

QString assemblyText(Branch branch)
{
    return branch == Branch::Open ? FindingText::tr("open") : FindingText::tr("crossed");
}

QString withNoun(Branch branch)
{
    return FindingText::tr("%1 assembly").arg(assemblyText(branch));
}

double shownFactor(Parameter parameter)
{
    switch (parameter) {
    case Parameter::A:
    case Parameter::B:
    case Parameter::C: return shownValue(Measure::Length, 1.0, notation().units);
    case Parameter::Omega2: return crankSpeedFactor(notation().crankSpeed);
    case Parameter::Theta20: break;
    }
    return shownValue(Measure::Angle, 1.0, notation().units);
}

QString unitBehind(Parameter parameter)
{
    switch (parameter) {
    case Parameter::A:
    case Parameter::B:
    case Parameter::C: return u' ' + shownUnit(Measure::Length);
    case Parameter::Omega2: return u' ' + crankSpeedUnitText(notation().crankSpeed);
    case Parameter::Theta20: break;
    }
    const QString unit = shownUnit(Measure::Angle);
    return unit == u"°" ? unit : u' ' + unit;
}

QString parameterText(Parameter parameter, double value, int digits)
{
    return numberText(shownFactor(parameter) * value, digits) + unitBehind(parameter);
}

QString equationText(Parameter parameter, double value, int digits)
{
    return QStringLiteral("%1 = %2").arg(symbolText(parameter), parameterText(parameter, value, digits));
}

QString mechanismText(const Mechanism &mechanism, int digits)
{
    return equationTexts(mechanism.parameters(), digits).join(", ");
}

QString pinnedText(const Parameters &pinned, const Parameters &present)
{
    QStringList parts = equationTexts(pinned);
    for (const QString &part : equationTexts(present)) {
        parts.removeOne(part);
    }
    return parts.isEmpty() ? FindingText::tr("pinned") : parts.join(", ");
}

QString measuredText(double value, double standardError, double scale)
{
    constexpr double kArithmetic = 1e-13; // relative to the scale: smaller errors are rounding errors
    if (!(standardError > kArithmetic * scale) || std::isinf(standardError)) {
        constexpr int kDigitsAlone = 9;
        return numberText(std::abs(value) > kArithmetic * scale ? value : 0.0, kDigitsAlone);
    }
    // Power of ten of the error, rounded to one digit: 0 for 0.96, which is rounded to 1.
    const int place = exponentOf(standardError / 0.95);
    const double unit = std::pow(10.0, place);
    const double rounded = std::round(value / unit) * unit + 0.0; // never -0
    const double roundedError = std::round(standardError / unit) * unit;
    const int digits = rounded == 0.0 ? 1 : std::max(1, exponentOf(std::abs(rounded)) - place + 1);
    return QStringLiteral("%1 ± %2").arg(shortNumber(rounded, digits), shortNumber(roundedError, 1));
}

QString verdictText(const ChannelComparison &channel)
{
    if (channel.verdict == Verdict::Agrees) {
        return FindingText::tr("agrees within the rounding of the file");
    }
    if (channel.verdict == Verdict::Close) {
        return channel.clockIsRounded ? FindingText::tr("close, if the time stamps of the file are rounded")
                                      : FindingText::tr("close: at most %1 times the rounding of the file")
                                            .arg(errorText(channel.worstOver));
    }
    return channel.count == 0 ? FindingText::tr("differs: nothing to compare with") : FindingText::tr("differs");
}

QString placeText(const ChannelComparison &channel, const ReferenceData &file)
{
    const double time = channel.timeOfMaxAbs;
    return !channel.maxAbs ? dash()
           : file.crank    ? numberText(shownValue(Measure::Angle, file.crank->omega2 * time + file.crank->theta20,
                                                   notation().units))
                           : numberText(time);
}

std::vector<QStringList> comparisonTable(std::span<const ChannelComparison> channels, const ReferenceData &file)
{
    std::vector<QStringList> rows{
        {FindingText::tr("channel"), FindingText::tr("largest error"),
         file.crank ? FindingText::tr("at θ₂ [%1]").arg(shownUnit(Measure::Angle)) : FindingText::tr("at t [s]"),
         FindingText::tr("rms"), FindingText::tr("% of peak"), FindingText::tr("max. relative error [%]"),
         FindingText::tr("rounding step"), FindingText::tr("verdict")}};
    for (const ChannelComparison &channel : channels) {
        const auto shown = [&channel](std::optional<double> error) { return shownDifference(channel.channel, error); };
        rows.push_back({QStringLiteral("%1 [%2]").arg(columnName(channel.channel), shownUnit(channel.channel)),
                        errorText(shown(channel.maxAbs)), placeText(channel, file), errorText(shown(channel.rms)),
                        errorText(channel.percentOfPeak), errorText(channel.maxPercent),
                        numberText(shown(channel.roundingStep), 3), verdictText(channel)});
    }
    return rows;
}

QString summaryText(std::span<const ChannelComparison> channels)
{
    if (channels.empty()) {
        return FindingText::tr("The file has no column that this program knows.");
    }
    const auto count = [&](Verdict verdict) {
        return QString::number(std::ranges::count(channels, verdict, &ChannelComparison::verdict));
    };
    const QString all = QString::number(channels.size());
    if (count(Verdict::Agrees) == all) {
        return FindingText::tr("Match. Quantities that agree within the rounding of the file: %1 of %2.").arg(all, all);
    }
    const auto worst = std::ranges::max_element(channels, {}, [](const ChannelComparison &channel) {
        return channel.verdict == Verdict::Differs ? channel.percentOfPeak.value_or(0.0) : -1.0;
    });
    if (worst->verdict != Verdict::Differs) {
        return FindingText::tr(
                   "Close match. Quantities that agree within the rounding of the file: %1 of %2, the others nearly.")
            .arg(count(Verdict::Agrees), all);
    }
    if (!worst->percentOfPeak) {
        return worst->count == 0 && worst->missingModel > 0
                   ? FindingText::tr("No match: the mechanism cannot be assembled at any time step of the file.")
                   : FindingText::tr("No match: %1 of %2 quantities differ.").arg(count(Verdict::Differs), all);
    }
    return FindingText::tr("No match: %1 of %2 quantities differ, most of all the %3, by %4 % of its peak.")
        .arg(count(Verdict::Differs), all, quantityName(worst->channel), errorText(worst->percentOfPeak));
}

} // namespace slidercrank
