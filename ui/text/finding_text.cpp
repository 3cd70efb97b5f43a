// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/finding_text.h"

#include "ui/text/axis_scale.h"
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

struct FindingText {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::FindingText)
};

int powerOfTenBelow(double magnitude)
{
    return static_cast<int>(std::floor(std::log10(magnitude)));
}

} // namespace

QString listed(const QStringList &words)
{
    if (words.size() < 2) {
        return words.join(QString());
    }
    return FindingText::tr("%1 and %2").arg(words.first(words.size() - 1).join(FindingText::tr(", ")), words.last());
}

QString errorText(double value)
{
    constexpr int kErrorDigits = 3; // what a person compares
    return std::isinf(value) ? QStringLiteral("∞") : shortNumber(value, kErrorDigits);
}

QString symbolOf(Channel channel)
{
    const auto axis = static_cast<int>(channel.coordinate) % 3;
    // The crank's angle is the drive's, too: one letter for both.
    const QString body =
        channel.coordinate == Theta2 ? QStringLiteral("₂") : QStringLiteral("¹²³⁴").mid(channel.coordinate / 3, 1);
    const bool isRate = channel.order != Order::Position;
    const QString direction = isAngle(channel.coordinate) || (channel.coordinate == R4x && isRate) ? QString()
                              : axis == 0 ? QStringLiteral("ₓ")
                                          : QStringLiteral("_y");
    const auto order = static_cast<std::size_t>(channel.order);
    const char *letter =
        isAngle(channel.coordinate) ? std::array{"θ", "ω", "α"}[order] : std::array{"R", "v", "a"}[order];
    return QString::fromUtf8(letter) + direction + body;
}

QString quantityOf(Channel channel)
{
    static constexpr const char *kBodies[] = {QT_TRANSLATE_NOOP("slidercrank::FindingText", "ground"),
                                              QT_TRANSLATE_NOOP("slidercrank::FindingText", "crank"),
                                              QT_TRANSLATE_NOOP("slidercrank::FindingText", "coupler"),
                                              QT_TRANSLATE_NOOP("slidercrank::FindingText", "slider")};
    static constexpr const char *kAngle[] = {QT_TRANSLATE_NOOP("slidercrank::FindingText", "%1 angle"),
                                             QT_TRANSLATE_NOOP("slidercrank::FindingText", "%1 angular velocity"),
                                             QT_TRANSLATE_NOOP("slidercrank::FindingText", "%1 angular acceleration")};
    static constexpr const char *kStroke[] = {QT_TRANSLATE_NOOP("slidercrank::FindingText", "%1 position"),
                                              QT_TRANSLATE_NOOP("slidercrank::FindingText", "%1 velocity"),
                                              QT_TRANSLATE_NOOP("slidercrank::FindingText", "%1 acceleration")};
    static constexpr const char *kInX[] = {
        QT_TRANSLATE_NOOP("slidercrank::FindingText", "%1 centre in x"),
        QT_TRANSLATE_NOOP("slidercrank::FindingText", "%1 centre's velocity in x"),
        QT_TRANSLATE_NOOP("slidercrank::FindingText", "%1 centre's acceleration in x")};
    static constexpr const char *kInY[] = {
        QT_TRANSLATE_NOOP("slidercrank::FindingText", "%1 centre in y"),
        QT_TRANSLATE_NOOP("slidercrank::FindingText", "%1 centre's velocity in y"),
        QT_TRANSLATE_NOOP("slidercrank::FindingText", "%1 centre's acceleration in y")};
    const auto coordinate = static_cast<std::size_t>(channel.coordinate);
    const auto &quantities = isAngle(channel.coordinate) ? kAngle
                             : channel.coordinate == R4x ? kStroke
                             : coordinate % 3 == 0       ? kInX
                                                         : kInY;
    return FindingText::tr(quantities[static_cast<std::size_t>(channel.order)])
        .arg(FindingText::tr(kBodies[coordinate / 3]));
}

QString columnNameOf(Channel channel)
{
    return QString::fromUtf8(nameOf(channel));
}

QString unitOf(Channel channel)
{
    return QString::fromUtf8(fileUnit(channel));
}

QString symbolOf(Parameter parameter)
{
    switch (parameter) {
    case Parameter::A: return QStringLiteral("a");
    case Parameter::B: return QStringLiteral("b");
    case Parameter::C: return QStringLiteral("c");
    case Parameter::Omega2: return QStringLiteral("ω₂");
    case Parameter::Theta20: return QStringLiteral("θ₂₀");
    }
    return {};
}

const char *wordOf(Parameter parameter)
{
    switch (parameter) {
    case Parameter::A: return "a";
    case Parameter::B: return "b";
    case Parameter::C: return "c";
    case Parameter::Omega2: return "omega2";
    case Parameter::Theta20: return "theta20";
    }
    return "";
}

QString assemblyText(Branch branch)
{
    return branch == Branch::Open ? FindingText::tr("open") : FindingText::tr("crossed");
}

QString parameterText(Parameter parameter, double value, int digits)
{
    return numberText(shownFactor(parameter) * value, digits) + unitBehind(parameter);
}

QString withNoun(Branch branch)
{
    return FindingText::tr("%1 assembly").arg(assemblyText(branch));
}

double shownFactor(Parameter parameter)
{
    return parameter == Parameter::Theta20 ? kDegreesPerRadian : 1.0;
}

QString unitBehind(Parameter parameter)
{
    switch (parameter) {
    case Parameter::A:
    case Parameter::B:
    case Parameter::C: return FindingText::tr(" mm");
    case Parameter::Omega2: return FindingText::tr(" rad/s");
    case Parameter::Theta20: return FindingText::tr("°");
    }
    return {};
}

QString mechanismText(const Mechanism &mechanism, int digits)
{
    QStringList parts;
    for (const Parameter parameter : kParameters) {
        parts << FindingText::tr("%1 = %2").arg(
            symbolOf(parameter), parameterText(parameter, valueOf(mechanism.parameters(), parameter), digits));
    }
    return (parts << withNoun(mechanism.branch())).join(FindingText::tr(", "));
}

QString keptText(const Parameters &kept, const Parameters &present)
{
    QStringList parts;
    for (const Parameter parameter : kParameters) {
        if (valueOf(kept, parameter) != valueOf(present, parameter)) {
            parts << FindingText::tr("%1 = %2").arg(symbolOf(parameter),
                                                    parameterText(parameter, valueOf(kept, parameter)));
        }
    }
    if (kept.branch != present.branch) {
        parts << withNoun(kept.branch);
    }
    return parts.isEmpty() ? FindingText::tr("pinned") : parts.join(FindingText::tr(", "));
}

QString measuredText(double value, double standardError, double scale)
{
    constexpr double kArithmetic = 1e-13; // of the scale: a smaller error says nothing of the data
    constexpr int kDigitsAlone = 9;
    if (!(std::isfinite(standardError) && standardError > kArithmetic * scale)) {
        return numberText(value, kDigitsAlone);
    }
    // The place of the first digit once it is rounded to that one: 0.96 is 1.
    const int firstPlace = powerOfTenBelow(standardError);
    const int place = standardError >= 9.5 * std::pow(10.0, firstPlace) ? firstPlace + 1 : firstPlace;
    const double unit = std::pow(10.0, place);
    const double rounded = std::round(value / unit) * unit + 0.0; // never -0
    const double roundedError = std::round(standardError / unit) * unit;
    const QString text = FindingText::tr("%1 ± %2");
    constexpr int kFinestPlain = -9;
    constexpr double kLargestPlain = 1e6;
    if (place >= kFinestPlain && std::abs(rounded) < kLargestPlain) {
        const int decimals = std::max(0, -place);
        return text.arg(QLocale().toString(rounded, 'f', decimals), QLocale().toString(roundedError, 'f', decimals));
    }
    const int digits = rounded == 0.0 ? 1 : std::max(1, powerOfTenBelow(std::abs(rounded)) - place + 1);
    return text.arg(shortNumber(rounded, digits), shortNumber(roundedError, 1));
}

QString verdictText(const ChannelComparison &channel)
{
    switch (channel.verdict) {
    case Verdict::Agrees: return FindingText::tr("agrees within the file's rounding");
    case Verdict::Close: {
        if (channel.clockIsRounded) {
            return FindingText::tr("close, if the file's instants are rounded");
        }
        // Rounded up: no value lies beyond.
        const double worst = channel.worstOver < kBoundsOfAgreement ? std::ceil(10.0 * channel.worstOver) / 10.0
                                                                    : std::ceil(channel.worstOver);
        return FindingText::tr("close: within %1 × the file's rounding").arg(numberText(worst));
    }
    case Verdict::Differs: break;
    }
    return channel.count == 0 ? FindingText::tr("differs: nothing to compare with") : FindingText::tr("differs");
}

QString verdictFormula(const ChannelComparison &channel)
{
    if (channel.count == 0) {
        return FindingText::tr("At no instant of the file do both the model and the file have a value.");
    }
    const auto percent = [](double part) { return numberText(100.0 * part); };
    QString rule;
    switch (channel.verdict) {
    case Verdict::Agrees:
        rule =
            FindingText::tr("|model − reference| ≤ bound for at least %1 % of the values, ≤ %2 · bound for all; none "
                            "beyond it by more than %3 % of half the motion's range.")
                .arg(kPercentWithinBound)
                .arg(numberText(kBoundsOfAgreement), percent(kExcessOfAgreement));
        break;
    case Verdict::Close:
        rule = FindingText::tr("|model − reference| ≤ %1 · bound for all values; none beyond it by more than %2 % of "
                               "half the motion's range.")
                   .arg(numberText(kBoundsOfCloseness), percent(kExcessOfCloseness));
        break;
    case Verdict::Differs:
        rule = FindingText::tr("|model − reference| > %1 · bound somewhere, or beyond it by more than %2 % of half the "
                               "motion's range.")
                   .arg(numberText(kBoundsOfCloseness), percent(kExcessOfCloseness));
        break;
    }
    if (channel.missingModel > 0) {
        rule += FindingText::tr(" At %1 instants the model has no value to compare with.").arg(channel.missingModel);
    }
    return rule + u'\n' +
           (channel.clockIsRounded
                ? FindingText::tr("The bound: half a unit of the value's last digit, plus how far the motion goes in "
                                  "half a unit of the instant's, though the instants are evenly spaced.")
                : FindingText::tr("The bound: half a unit of the value's last digit, plus how far the motion goes in "
                                  "half a unit of the instant's; evenly spaced instants count as exact.")) +
           u'\n' +
           FindingText::tr("Here: %1 of %2 within the bound, the worst %3 · bound, beyond it by %4 %.")
               .arg(channel.withinBound)
               .arg(channel.count)
               .arg(errorText(channel.worstOver), errorText(100.0 * channel.excess));
}

QString summaryOf(std::span<const ChannelComparison> channels)
{
    if (channels.empty()) {
        return FindingText::tr("The file has no column that this program knows.");
    }
    const auto count = [&](Verdict verdict) {
        return std::ranges::count(channels, verdict, &ChannelComparison::verdict);
    };
    const auto within = [&](Verdict verdict) {
        return channels.size() == 1 ? FindingText::tr("in its one channel")
                                    : FindingText::tr("in %1 of %2 channels").arg(count(verdict)).arg(channels.size());
    };
    if (count(Verdict::Differs) == 0) {
        if (std::ranges::all_of(channels, &ChannelComparison::clockIsRounded)) {
            return FindingText::tr("Comes close to this mechanism in every channel, provided that the file's instants, "
                                   "though evenly spaced, were rounded.");
        }
        if (count(Verdict::Agrees) == 0) {
            return FindingText::tr("Comes close to this mechanism in every channel, a little beyond the rounding of "
                                   "the file.");
        }
        const QString agrees = FindingText::tr("Agrees with this mechanism %1, within the rounding of the file")
                                   .arg(within(Verdict::Agrees));
        return count(Verdict::Close) == 0 ? agrees + u'.' : FindingText::tr("%1; close in the others.").arg(agrees);
    }
    const auto worst = std::ranges::max_element(channels, {}, [](const ChannelComparison &channel) {
        return channel.verdict == Verdict::Differs ? channel.percentOfPeak.value_or(0.0) : -1.0;
    });
    QString text = FindingText::tr("Differs from this mechanism %1").arg(within(Verdict::Differs));
    if (worst->percentOfPeak) {
        text += FindingText::tr(", most in %1: by up to %2 % of its peak")
                    .arg(symbolOf(worst->channel), errorText(*worst->percentOfPeak));
    }
    text += u'.';
    std::size_t missing = 0;
    for (const ChannelComparison &channel : channels) {
        missing = std::max(missing, channel.missingModel);
    }
    if (missing > 0) {
        text += u' ' + FindingText::tr("At %1 of the file's instants the mechanism cannot be assembled, or has no "
                                       "derivatives.")
                           .arg(countText(missing));
    }
    return text;
}

} // namespace slidercrank
