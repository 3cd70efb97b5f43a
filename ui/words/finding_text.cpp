// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/words/finding_text.h"

#include "ui/words/axis_scale.h"
#include "ui/words/written_number.h"

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

constexpr int kErrorDigits = 3; ///< of errors: what a person compares

QString errorText(double value)
{
    return std::isinf(value) ? QStringLiteral("∞") : shortNumber(value, kErrorDigits);
}

int powerOfTenBelow(double magnitude)
{
    return static_cast<int>(std::floor(std::log10(magnitude)));
}

/// From the core's unit to the one that is shown.
double shownFactor(Parameter parameter)
{
    return parameter == Parameter::Theta20 ? kDegreesPerRadian : 1.0;
}

/// With the space that belongs before it.
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

QString withNoun(Branch branch)
{
    return FindingText::tr("%1 assembly").arg(assemblyText(branch));
}

/// "x", "x and y", "x, y and z".
QString listed(const QStringList &words)
{
    if (words.size() < 2) {
        return words.join(QString());
    }
    return FindingText::tr("%1 and %2").arg(words.first(words.size() - 1).join(FindingText::tr(", ")), words.last());
}

QString columnsOf(const Convention &convention)
{
    QStringList names;
    for (const Channel channel : convention.channels) {
        names << columnNameOf(channel);
    }
    return listed(names);
}

/// b/a or c/a, a being given.
QString measuredRatio(Parameter parameter, const Identification &found)
{
    const Parameters &p = found.parameters;
    return measuredText(valueOf(p, parameter) / p.a, found.standardError[indexOf(parameter)] / p.a,
                        (p.a + p.b + std::abs(p.c)) / p.a);
}

bool isLength(Parameter parameter)
{
    return parameter == Parameter::A || parameter == Parameter::B || parameter == Parameter::C;
}

/// The parameters found and those kept, each of them written out.
struct FoundAndKept {
    QStringList found;
    QStringList kept;
};

FoundAndKept foundAndKept(const Identification &identification)
{
    FoundAndKept lists;
    for (const Parameter parameter : kParameters) {
        if (identification.onlyRatios && isLength(parameter)) {
            if (parameter != Parameter::A) {
                lists.found
                    << FindingText::tr("%1/a = %2").arg(symbolOf(parameter), measuredRatio(parameter, identification));
            }
        } else if (identification.identifiable[indexOf(parameter)]) {
            lists.found << FindingText::tr("%1 = %2").arg(symbolOf(parameter), measuredText(parameter, identification));
        } else {
            lists.kept << FindingText::tr("%1 = %2").arg(
                symbolOf(parameter), parameterText(parameter, valueOf(identification.parameters, parameter)));
        }
    }
    return lists;
}

/// As many decimals as it takes to see how much is missing, four at most; never rounded up.
QString percentText(double part)
{
    constexpr int kMostDecimals = 4;
    constexpr double kSlack = 1e-9; // 99.5 is 995 tenths, whatever its last digit
    const double missing = 100.0 * (1.0 - part);
    const int decimals =
        missing > 0.0 ? std::clamp(-powerOfTenBelow(missing * (1.0 + kSlack)), 0, kMostDecimals) : kMostDecimals;
    const double unit = std::pow(10.0, -decimals);
    const double shown = std::min(std::floor((100.0 - missing) / unit + kSlack) * unit, 100.0 - unit);
    return QLocale().toString(shown, 'f', decimals);
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
            return FindingText::tr("%1: in %2, but read as %3.").arg(columnsOf(convention), pair.meant, pair.read);
        }
    }
    return otherwise.arg(columnsOf(convention), numberText(convention.amount));
}

QString angleUnitExplanation(const Convention &convention)
{
    const QString degrees = FindingText::tr("degrees");
    const QString radians = FindingText::tr("radians");
    const QString turns = FindingText::tr("turns");
    constexpr double kTurn = 360.0;
    const std::array pairs{UnitPair{kDegreesPerRadian, radians, degrees},
                           UnitPair{1.0 / kDegreesPerRadian, degrees, radians},
                           UnitPair{kTurn, turns, degrees},
                           UnitPair{1.0 / kTurn, degrees, turns},
                           UnitPair{2.0 * std::numbers::pi, turns, radians},
                           UnitPair{0.5 / std::numbers::pi, radians, turns}};
    return unitExplanation(convention, pairs,
                           FindingText::tr("%1: in a unit of angle %2 times as large as the one read."));
}

QString lengthUnitExplanation(const Convention &convention)
{
    const QString millimetres = FindingText::tr("millimetres");
    const QString centimetres = FindingText::tr("centimetres");
    const QString metres = FindingText::tr("metres");
    const QString inches = FindingText::tr("inches");
    const std::array pairs{UnitPair{10.0, centimetres, millimetres}, UnitPair{0.1, millimetres, centimetres},
                           UnitPair{1000.0, metres, millimetres},    UnitPair{0.001, millimetres, metres},
                           UnitPair{100.0, metres, centimetres},     UnitPair{0.01, centimetres, metres},
                           UnitPair{25.4, inches, millimetres},      UnitPair{1.0 / 25.4, millimetres, inches},
                           UnitPair{0.0254, inches, metres},         UnitPair{1.0 / 0.0254, metres, inches},
                           UnitPair{2.54, inches, centimetres},      UnitPair{1.0 / 2.54, centimetres, inches}};
    return unitExplanation(convention, pairs,
                           FindingText::tr("%1: in a unit of length %2 times as large as the one read."));
}

QString timeUnitExplanation(const Convention &convention)
{
    const double factor = convention.amount;
    QString text =
        factor == 0.001   ? FindingText::tr("The time is in milliseconds, but was read as seconds")
        : factor == 1000. ? FindingText::tr("The time is in seconds, but was read as milliseconds")
        : factor == 60.0
            ? FindingText::tr("The time is in minutes, but was read as seconds")
            : FindingText::tr("The unit of the time is %1 times as large as the one read").arg(numberText(factor));
    if (!convention.channels.empty()) {
        text += FindingText::tr("; so are the derivatives %1").arg(columnsOf(convention));
    }
    return text + u'.';
}

/// " + 180°", " − 180°", or nothing for 0.
QString angleAdded(double degrees)
{
    if (degrees == 0.0) {
        return {};
    }
    return (degrees < 0.0 ? FindingText::tr(" − %1°") : FindingText::tr(" + %1°")).arg(numberText(std::abs(degrees)));
}

/// What is added where the origin is another one: "-5 mm", "30°".
QString shiftText(const Convention &convention)
{
    const QString number = numberText(convention.amount);
    return isAngle(convention.channels.front().coordinate) ? number + FindingText::tr("°")
                                                           : number + FindingText::tr(" mm");
}

QString actionOf(const Convention &convention)
{
    const QString columns = columnsOf(convention);
    switch (convention.kind) {
    case Convention::Kind::AngleUnit:
    case Convention::Kind::LengthUnit:
        return FindingText::tr("Multiplies %1 by %2").arg(columns, numberText(convention.amount));
    case Convention::Kind::TimeUnit:
        return columns.isEmpty() ? FindingText::tr("Multiplies the instants by %1").arg(numberText(convention.amount))
                                 : FindingText::tr("Multiplies the instants by %1, and brings %2 to the same unit")
                                       .arg(numberText(convention.amount), columns);
    case Convention::Kind::Sign: return FindingText::tr("Changes the sign of %1").arg(columns);
    case Convention::Kind::HalfTurn:
    case Convention::Kind::WholeTurns:
        return convention.amount == 0.0
                   ? FindingText::tr("Makes %1 continuous").arg(columns)
                   : FindingText::tr("Adds %1° to %2, made continuous").arg(numberText(convention.amount), columns);
    case Convention::Kind::ZeroPoint: return FindingText::tr("Adds %1 to %2").arg(shiftText(convention), columns);
    case Convention::Kind::SwappedColumns: return FindingText::tr("Exchanges %1").arg(columns);
    case Convention::Kind::Branch: return FindingText::tr("Takes the other assembly for the model");
    case Convention::Kind::TimeShift:
        return FindingText::tr("Adds %1 s to the instants").arg(numberText(convention.amount));
    case Convention::Kind::NotDerivative: return FindingText::tr("Leaves %1 out").arg(columns);
    }
    return {};
}

} // namespace

QString symbolOf(Channel channel)
{
    const auto body = static_cast<int>(channel.coordinate) / 3;
    const auto axis = static_cast<int>(channel.coordinate) % 3;
    const QString letter = isAngle(channel.coordinate) ? QStringLiteral("θ")
                           : axis == 0                 ? QStringLiteral("Rₓ")
                                                       : QStringLiteral("R_y");
    const QString symbol = letter + QStringLiteral("¹²³⁴")[body];
    switch (channel.order) {
    case Order::Position: return symbol;
    case Order::Velocity: return QStringLiteral("d%1/dt").arg(symbol);
    case Order::Acceleration: return QStringLiteral("d²%1/dt²").arg(symbol);
    }
    return {};
}

QString columnNameOf(Channel channel)
{
    return QString::fromUtf8(nameOf(channel));
}

QString unitOf(Channel channel)
{
    return QString::fromUtf8(authorUnitOf(channel));
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

QString mechanismText(const Mechanism &mechanism, int digits)
{
    QStringList parts;
    for (const Parameter parameter : kParameters) {
        parts << FindingText::tr("%1 = %2").arg(
            symbolOf(parameter), parameterText(parameter, valueOf(mechanism.parameters(), parameter), digits));
    }
    return (parts << withNoun(mechanism.branch())).join(FindingText::tr(", "));
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

QString measuredText(Parameter parameter, const Identification &found)
{
    const Parameters &p = found.parameters;
    if (found.onlyRatios && (parameter == Parameter::B || parameter == Parameter::C)) {
        return FindingText::tr("%1 a").arg(measuredRatio(parameter, found));
    }
    if (!found.identifiable[indexOf(parameter)]) {
        return QStringLiteral("–");
    }
    const double scale = parameter == Parameter::Omega2    ? std::abs(p.omega2)
                         : parameter == Parameter::Theta20 ? 1.0
                                                           : p.a + p.b + std::abs(p.c);
    const double factor = shownFactor(parameter);
    return measuredText(factor * valueOf(p, parameter), factor * found.standardError[indexOf(parameter)],
                        factor * scale) +
           unitBehind(parameter);
}

QString caveatsOf(const Identification &identification)
{
    using Why = Identification::Alternative::Why;
    const auto isPossible = [&](Why why) {
        return std::ranges::count(identification.alternatives, why, &Identification::Alternative::why) > 0;
    };
    QStringList sentences;
    if (identification.onlyRatios) {
        sentences << FindingText::tr("θ³ alone fixes only b/a and c/a; a = %1 is taken as given.")
                         .arg(parameterText(Parameter::A, identification.parameters.a));
    }
    if (isPossible(Why::Reversed)) {
        sentences << FindingText::tr("θ³ alone cannot tell it from one that turns the other way, from 180° − θ₂₀.");
    }
    if (isPossible(Why::OtherAssembly)) {
        sentences << FindingText::tr(
            "The derivatives of θ³ alone cannot tell it from the other assembly with c negated "
            "and θ₂₀ half a turn on.");
    }
    if (isPossible(Why::MirrorImage)) {
        sentences << FindingText::tr("Rₓ⁴ alone cannot tell this mechanism from its mirror image (c, ω₂ and θ₂₀ "
                                     "negated).");
    }
    if (const QStringList kept = foundAndKept(identification).kept; !kept.isEmpty()) {
        sentences << FindingText::tr("The data do not fix %1: kept as given.").arg(listed(kept));
    }
    // Rounding alone leaves 0.29 of a step; so much more is something else.
    constexpr double kStepsOfSomethingElse = 5.0;
    if (identification.rms > kStepsOfSomethingElse) {
        sentences << FindingText::tr("It comes nearest of all, but the data are still off by %1 × the file's rounding "
                                     "step (rms).")
                         .arg(errorText(identification.rms));
    }
    return sentences.join(u' ');
}

QString summaryOf(const Identification &identification)
{
    if (identification.stopped) {
        return FindingText::tr("The search was stopped.");
    }
    switch (identification.outcome) {
    case Identification::Outcome::Identified:
    case Identification::Outcome::Ambiguous: break;
    case Identification::Outcome::Insufficient:
        if (identification.lack == Identification::Lack::NothingMoves) {
            return FindingText::tr("Nothing moves in these data: export the motion of a turning crank.");
        }
        return FindingText::tr("There are too few values of θ³, Rₓ⁴ and their derivatives to find the mechanism by: "
                               "export more instants, or more columns.");
    case Identification::Outcome::Nearest:
    case Identification::Outcome::None:
        return FindingText::tr("Nothing found explains this file: check which column is which, and their units.");
    }
    const QStringList parts = foundAndKept(identification).found << withNoun(identification.parameters.branch);
    const QString caveats = caveatsOf(identification);
    return parts.join(FindingText::tr(", ")) + (caveats.isEmpty() ? QStringLiteral(".") : QStringLiteral(". ")) +
           caveats;
}

QString roundNumbersText(const Diagnosis &diagnosis)
{
    const Identification &found = diagnosis.identification;
    if (found.outcome != Identification::Outcome::Identified || diagnosis.rounded == found.parameters) {
        return {};
    }
    constexpr int kDigits = 9;
    return FindingText::tr("Round numbers come as near to the data: %1.")
        .arg(mechanismText(Mechanism(diagnosis.rounded), kDigits));
}

QString changeText(const Diagnosis &diagnosis, const Mechanism &mechanism)
{
    if (!diagnosis.change) {
        return {};
    }
    const ParameterChange &found = *diagnosis.change;
    const double factor = shownFactor(found.parameter);
    const double before = factor * valueOf(mechanism.parameters(), found.parameter);
    const double after = factor * found.value;
    constexpr int kMostDigits = 12;
    int digits = 5; // of what was measured; more where those do not tell the two apart
    while (digits < kMostDigits && numberText(after, digits) == numberText(before, digits)) {
        ++digits;
    }
    return FindingText::tr("This error looks like %1 = %2 instead of %3%4, which explains %5 % of it.")
        .arg(symbolOf(found.parameter), numberText(after, digits), numberText(before, digits + 1),
             unitBehind(found.parameter), percentText(found.explained));
}

QString nameOf(const Convention &convention)
{
    switch (convention.kind) {
    case Convention::Kind::AngleUnit: return FindingText::tr("angle unit");
    case Convention::Kind::LengthUnit: return FindingText::tr("length unit");
    case Convention::Kind::TimeUnit: return FindingText::tr("time unit");
    case Convention::Kind::Sign: return FindingText::tr("sign");
    case Convention::Kind::HalfTurn: return FindingText::tr("half a turn");
    case Convention::Kind::WholeTurns: return FindingText::tr("whole turns");
    case Convention::Kind::ZeroPoint: return FindingText::tr("zero point");
    case Convention::Kind::SwappedColumns: return FindingText::tr("swapped columns");
    case Convention::Kind::Branch: return FindingText::tr("assembly");
    case Convention::Kind::TimeShift: return FindingText::tr("time shift");
    case Convention::Kind::NotDerivative: return FindingText::tr("no derivative");
    }
    return {};
}

QString explanationOf(const Convention &convention)
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
        return angles    ? FindingText::tr("%1: counted clockwise, against the sense of the model.").arg(columns)
               : lengths ? FindingText::tr("%1: along an axis that points the other way.").arg(columns)
                         : FindingText::tr("%1: of the opposite sign.").arg(columns);
    }
    case Convention::Kind::HalfTurn:
        return FindingText::tr("%1: the coupler's angle seen from B, as textbooks draw θ₃; θ³ is %1%2.")
            .arg(columns, angleAdded(convention.amount));
    case Convention::Kind::WholeTurns:
        return convention.amount == 0.0
                   ? FindingText::tr("%1: jumps by whole turns.").arg(columns)
                   : FindingText::tr("%1: off by whole turns; θ³ is %1%2.").arg(columns, angleAdded(convention.amount));
    case Convention::Kind::ZeroPoint:
        return FindingText::tr("%1: counted from another origin, at %2.").arg(columns, shiftText(convention));
    case Convention::Kind::SwappedColumns:
        return FindingText::tr("%1: each stands under the other's name.").arg(columns);
    case Convention::Kind::Branch:
        return FindingText::tr("The file moves as the other assembly: the slider on the other side of A.");
    case Convention::Kind::TimeShift:
        return (convention.amount < 0.0
                    ? FindingText::tr("The file's clock is %1 s ahead: what it has at t happens that much earlier.")
                    : FindingText::tr("The file's clock is %1 s behind: what it has at t happens that much later."))
            .arg(numberText(std::abs(convention.amount)));
    case Convention::Kind::NotDerivative:
        return FindingText::tr("%1: not the time derivative of its position column.").arg(columns);
    }
    return {};
}

QString effectOf(const ConventionFinding &finding)
{
    const QString action = actionOf(finding.convention);
    // What is left out has no error any more.
    return finding.convention.kind == Convention::Kind::NotDerivative
               ? FindingText::tr("%1: its largest error is %2 % of peak.").arg(action, errorText(finding.before))
               : FindingText::tr("%1: largest error %2 % of peak instead of %3 %.")
                     .arg(action, errorText(finding.after), errorText(finding.before));
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
                ? FindingText::tr(
                      "The bound: half a step of the value's last digit, and what the motion does in half a "
                      "step of the instant's, though the instants are evenly spaced.")
                : FindingText::tr(
                      "The bound: half a step of the value's last digit, and what the motion does in half a "
                      "step of the instant's; evenly spaced instants count as exact.")) +
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
            return FindingText::tr("Comes close to this mechanism in every channel, if the file's instants, evenly "
                                   "spaced as they are, were rounded.");
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
                           .arg(QLocale().toString(static_cast<qulonglong>(missing)));
    }
    return text;
}

} // namespace slidercrank
