// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/motion_facts.h"

#include "core/closed_form/closed_form.h"
#include "core/limits/extremes.h"
#include "core/sampling/crank_time.h"
#include "ui/text/finding_text.h"
#include "ui/text/written_number.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>

namespace slidercrank
{

namespace
{

/// The context of these texts for translators.
struct MotionFacts {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::MotionFacts)
};

/// Returns two lengths with at least six digits, and with enough digits to distinguish them.
QStringList distinctTexts(double x, double y)
{
    constexpr int kMostDigits = 17;
    int digits = 6;
    while (x != y && digits < kMostDigits && numberText(x, digits) == numberText(y, digits)) {
        ++digits;
    }
    return {numberText(x, digits) + QStringLiteral(" mm"), numberText(y, digits) + QStringLiteral(" mm")};
}

/// Returns a limit (mm) with six digits, rounded up if it is a lower limit and down if it is an upper limit.
QString roundedText(double limit, bool isUp)
{
    constexpr double kSlack = 1e-6; // of the last digit: 0.1 + 0.2 equals 0.3 except for rounding
    const double unit = limit == 0.0 ? 1.0 : std::pow(10.0, 5.0 - std::floor(std::log10(std::abs(limit))));
    return numberText((isUp ? std::ceil(limit * unit - kSlack) : std::floor(limit * unit + kSlack)) / unit);
}

QString atLeast(const char *symbol, double limit)
{
    return QStringLiteral("%1 ≥ %2 mm").arg(QLatin1String(symbol), roundedText(limit, true));
}

QString atMost(const char *symbol, double limit)
{
    return QStringLiteral("%1 ≤ %2 mm").arg(QLatin1String(symbol), roundedText(limit, false));
}

/// States, for each length by itself, the values with which the crank makes full turns.
QString helpForFullTurn(const Mechanism &mechanism)
{
    QStringList bounds{atLeast("b", shortestCouplerForFullTurn(mechanism))};
    if (const double crank = longestCrankForFullTurn(mechanism); crank > 0.0) {
        bounds << atMost("a", crank);
    }
    if (const double offset = largestOffsetForFullTurn(mechanism); offset >= 0.0) {
        bounds << (offset == 0.0 ? QStringLiteral("c = 0") : atMost("|c|", offset));
    }
    return MotionFacts::tr("It would make full turns if %1.").arg(anyOf(bounds));
}

QString helpForAssembly(const Mechanism &mechanism)
{
    return MotionFacts::tr("It can be assembled if %1.")
        .arg(anyOf({atLeast("b", shortestCouplerForAnyPose(mechanism)),
                    atLeast("a", std::abs(mechanism.c()) - mechanism.b()),
                    atMost("|c|", mechanism.a() + mechanism.b())}));
}

QString fullTurnSentence(const Mechanism &mechanism, const MotionLimits &limits, const QStringList &lengths)
{
    if (limits.largestPressureAngle < 0.5 * std::numbers::pi) {
        return (mechanism.omega2() == 0.0
                    ? MotionFacts::tr("The crank is at rest, ω₂ = 0; it could make full turns: b = %1 ≥ a + |c| = %2.")
                    : MotionFacts::tr("The crank makes full turns: b = %1 ≥ a + |c| = %2."))
            .arg(lengths[0], lengths[1]);
    }
    const bool isInLine = mechanism.c() == 0.0;
    return (isInLine ? MotionFacts::tr("The crank just makes full turns: b = a = %1, c = 0, a change point. At θ₂ = %2 "
                                       "the coupler is perpendicular to the slider's line, and the velocities jump.")
                     : MotionFacts::tr("The crank just makes full turns: b = a + |c| = %1. At θ₂ = %2 the coupler is "
                                       "perpendicular to the slider's line, and the velocities jump."))
        .arg(lengths[0], isInLine              ? MotionFacts::tr("90° and 270°")
                         : mechanism.c() > 0.0 ? QStringLiteral("270°")
                                               : QStringLiteral("90°"));
}

/// Returns the first time within the time range at which the crank has an angle. Limit positions are known only up to a
/// rounding error; there, the time is one at which the mechanism can be assembled.
std::optional<double> firstTimeAt(double theta2, const Mechanism &mechanism, const Sampling &sampling)
{
    constexpr double kNudge = 1e-9; // rad, more than the rounding error of a crank angle
    constexpr double kSlack = 1e-9; // relative to the duration, to include the end of the time range
    const double end = sampling.start + sampling.duration;
    std::optional<double> first;
    for (const double nudge : {0.0, kNudge, -kNudge}) {
        const auto time = timeAtCrankAngle(mechanism, theta2 + nudge, sampling.start);
        if (time && *time <= end + kSlack * sampling.duration &&
            (!first || ClosedForm(mechanism).motionAt(*first).status == Status::NotAssemblable)) {
            first = std::min(*time, end);
        }
    }
    return first;
}

/// Returns a length, or 0 if it is only a rounding error of a + b + |c|.
double cleaned(double length, const Mechanism &mechanism)
{
    constexpr double kRounding = 1e-14;
    return std::abs(length) < kRounding * characteristicLength(mechanism.parameters()) ? 0.0 : length;
}

/// The facts of a mechanism that makes full turns about one stroke. `angle` is the rotation of the crank, rad.
std::vector<MotionFact> strokeFacts(bool isForward, double angle, double stroke, double speed)
{
    const QString explanation = isForward ? MotionFacts::tr("Crank rotation from the inner to the outer dead centre")
                                          : MotionFacts::tr("Crank rotation from the outer to the inner dead centre");
    std::vector<MotionFact> facts{{isForward ? "forward-angle" : "return-angle",
                                   isForward ? MotionFacts::tr("forward stroke") : MotionFacts::tr("return stroke"),
                                   kDegreesPerRadian * angle, QStringLiteral("°"), explanation}};
    if (speed > 0.0) {
        const double time = angle / speed;
        facts.push_back({isForward ? "forward-time" : "return-time",
                         isForward ? MotionFacts::tr("forward time") : MotionFacts::tr("return time"), time,
                         QStringLiteral("s"), explanation});
        facts.push_back({isForward ? "mean-forward-speed" : "mean-return-speed",
                         isForward ? MotionFacts::tr("mean forward speed") : MotionFacts::tr("mean return speed"),
                         stroke / time, unitText({R4x, Order::Velocity}),
                         MotionFacts::tr("The stroke divided by its time")});
    }
    return facts;
}

/// Fills in the times.
std::vector<MotionFact> withTimes(std::vector<MotionFact> facts, const Mechanism &mechanism, const Sampling &sampling)
{
    for (MotionFact &fact : facts) {
        if (fact.theta2) {
            fact.time = firstTimeAt(*fact.theta2, mechanism, sampling);
        }
    }
    return facts;
}

} // namespace

QString atLeastText(double limit)
{
    return roundedText(limit, true);
}

QString mobilitySentence(const Mechanism &mechanism, const MotionLimits &limits)
{
    const QStringList turning = distinctTexts(mechanism.b(), shortestCouplerForFullTurn(mechanism));
    const QString help = helpForFullTurn(mechanism);
    switch (limits.mobility) {
    case Mobility::FullTurn: return fullTurnSentence(mechanism, limits, turning);
    case Mobility::Rocker:
        return limits.ranges.size() > 1
                   ? MotionFacts::tr(
                         "The crank oscillates within one of two arcs and cannot make a full turn: b = %1 < "
                         "a + |c| = %2, and also less than a − |c| = %3 mm. %4")
                         .arg(turning[0], turning[1], numberText(mechanism.a() - std::abs(mechanism.c())), help)
                   : MotionFacts::tr("The crank oscillates and cannot make a full turn: b = %1 < a + |c| = %2. %3")
                         .arg(turning[0], turning[1], help);
    case Mobility::Locked:
        return MotionFacts::tr("The crank is locked in a single position: b = |c| − a = %1. %2").arg(turning[0], help);
    case Mobility::Impossible: {
        const QStringList reaching = distinctTexts(mechanism.b(), shortestCouplerForAnyPose(mechanism));
        return MotionFacts::tr("It cannot be assembled: b = %1 < |c| − a = %2. %3 %4")
            .arg(reaching[0], reaching[1], helpForAssembly(mechanism), help);
    }
    }
    return {};
}

QString valueText(const MotionFact &fact, int digits)
{
    if (std::isinf(fact.number)) {
        return MotionFacts::tr("unbounded");
    }
    if (fact.unit == u"°") {
        return QLocale().toString(fact.number, 'f', 2) + fact.unit;
    }
    const double size = std::abs(fact.number);
    const bool isPlain = digits >= 6 && (fact.number == 0.0 || (size >= 1e-3 && size < 1e7));
    return QStringLiteral("%1 %2")
        .arg(isPlain ? numberText(fact.number, digits) : shortNumber(fact.number, digits), fact.unit)
        .trimmed();
}

double degreesFromZero(double theta2)
{
    constexpr double kRounding = 1e-9; // 0 may have been computed as slightly less
    const double angle = kDegreesPerRadian * theta2;
    return angle < -kRounding ? angle + 360.0 : std::max(angle, 0.0);
}

std::vector<MotionFact> positionFacts(const Mechanism &mechanism, const MotionLimits &limits, const Sampling &sampling)
{
    const QString mm = QStringLiteral("mm");
    const bool isFullTurn = limits.mobility == Mobility::FullTurn;
    std::vector<MotionFact> facts;
    const auto addPosition = [&](const char *key, const QString &name, double R4x, double theta2,
                                 const QString &explanation) {
        facts.push_back({key, name, cleaned(R4x, mechanism), mm, explanation, theta2});
    };
    if (limits.outer) {
        addPosition("outer-dead-centre", MotionFacts::tr("outer dead centre"), limits.outer->R4x, limits.outer->theta2,
                    MotionFacts::tr(
                        "Slider position Rₓ⁴ at which the slider reverses, crank and coupler extended in one line"));
    }
    if (limits.inner) {
        addPosition("inner-dead-centre", MotionFacts::tr("inner dead centre"), limits.inner->R4x, limits.inner->theta2,
                    MotionFacts::tr(
                        "Slider position Rₓ⁴ at which the slider reverses, crank and coupler overlapping in one line"));
    }
    for (const CrankRange &range : isFullTurn ? std::vector<CrankRange>() : limits.ranges) {
        const bool isLocked = limits.mobility == Mobility::Locked;
        for (const double theta2 : isLocked ? std::vector{range.from} : std::vector{range.from, range.to}) {
            addPosition("", isLocked ? MotionFacts::tr("only position") : MotionFacts::tr("crank limit position"),
                        mechanism.a() * std::cos(theta2), theta2,
                        MotionFacts::tr("The crank can go no further: the coupler is perpendicular to the slider's "
                                        "line. The value is the slider position Rₓ⁴."));
        }
    }
    if (limits.stroke) {
        facts.push_back({"stroke", MotionFacts::tr("stroke"), cleaned(*limits.stroke, mechanism), mm,
                         MotionFacts::tr("Travel of the slider: its largest position minus its smallest")});
    }
    if (isFullTurn) {
        const double speed = std::abs(mechanism.omega2());
        std::ranges::move(strokeFacts(true, *limits.angleOutwards, *limits.stroke, speed), std::back_inserter(facts));
        std::ranges::move(strokeFacts(false, *limits.angleInwards, *limits.stroke, speed), std::back_inserter(facts));
        facts.push_back({"time-ratio",
                         MotionFacts::tr("time ratio"),
                         *limits.timeRatio,
                         {},
                         MotionFacts::tr("Time of the slower stroke divided by the time of the faster one")});
    }
    if (limits.mobility != Mobility::Impossible) {
        const double theta2 = limits.largestPressureAngleAt;
        const bool isSymmetric = isFullTurn && mechanism.c() == 0.0;
        for (const double place : isSymmetric ? std::vector{theta2, -theta2} : std::vector{theta2}) {
            facts.push_back(
                {"least-transmission-angle", MotionFacts::tr("minimum transmission angle"),
                 90.0 - kDegreesPerRadian * limits.largestPressureAngle, QStringLiteral("°"),
                 MotionFacts::tr("Angle between the coupler and the normal to the slider's line, 90° − |θ³|, at its "
                                 "minimum. Mechanisms with less than about 40° tend to jam."),
                 place});
        }
    }
    return withTimes(facts, mechanism, sampling);
}

std::vector<MotionFact> peakFacts(const Mechanism &mechanism, const MotionLimits &limits, const Sampling &sampling)
{
    constexpr std::array kKeys{"peak-slider-speed", "peak-slider-acceleration", "peak-coupler-speed",
                               "peak-coupler-acceleration"}; // in the order of motionPeaks()
    std::vector<MotionFact> facts;
    const std::vector<Peak> peaks = motionPeaks(mechanism);
    for (std::size_t i = 0; i < peaks.size(); ++i) {
        const Peak &peak = peaks[i];
        MotionFact fact{kKeys[i], quantityName(peak.channel), toFileUnit(peak.channel, peak.magnitude),
                        unitText(peak.channel)};
        fact.explanation =
            !std::isinf(peak.magnitude)
                ? MotionFacts::tr("Largest value over one revolution of the crank, where its derivative is zero")
            : limits.mobility == Mobility::FullTurn
                ? MotionFacts::tr("The coupler is perpendicular to the slider's line, and the velocities jump")
                : MotionFacts::tr("The velocities grow without bound as the crank approaches its limit position");
        if (peak.places.empty()) {
            fact.remark = peak.magnitude > 0.0 ? MotionFacts::tr("throughout") : MotionFacts::tr("crank at rest");
            facts.push_back(fact);
        }
        std::vector<PeakPlace> places = peak.places;
        std::ranges::sort(places, {}, [](const PeakPlace &place) { return degreesFromZero(place.theta2); });
        for (const PeakPlace &place : places) {
            fact.number = toFileUnit(peak.channel, place.value);
            fact.theta2 = place.theta2;
            facts.push_back(fact);
        }
    }
    return withTimes(facts, mechanism, sampling);
}

QString fewSamplesSentence(const Mechanism &mechanism, const Sampling &sampling)
{
    constexpr double kRounding = 1e-9;
    const double perTurn = timeStepsPerTurn(mechanism, sampling);
    const double wanted = sampling.steps * kFewestPerTurn / perTurn * (1.0 - kRounding);
    return wanted <= sampling.steps
               ? QString()
               : MotionFacts::tr("%1 samples per revolution are too few for a curve: %2 steps are enough.")
                     .arg(numberText(perTurn, 2), countText(static_cast<std::size_t>(nextRoundNumber(wanted))));
}

QString iterationsText(const SamplingSummary &run, const NewtonOptions &options)
{
    if (run.found() == 0) {
        return dash();
    }
    const bool hasColdStart = run.mostIterations > options.maxIterations && run.mostWarmIterations > 0;
    return MotionFacts::tr("%1 in total, at most %2 at a time step")
        .arg(countText(static_cast<std::size_t>(run.iterations)))
        .arg(hasColdStart ? run.mostWarmIterations : run.mostIterations);
}

QString crankAngleText(double radians)
{
    double hundredths = std::round(100.0 * kDegreesPerRadian * radians);
    hundredths -= 36000.0 * std::floor(hundredths / 36000.0);
    return QLocale().toString(0.01 * hundredths, 'f', 2);
}

QString secondsText(double seconds, double length)
{
    constexpr int kDigits = 4;
    const bool isPlain = length >= 1e-3 && length < 1e4;
    return isPlain ? localeWithoutGroups().toString(seconds, 'f',
                                                    kDigits - static_cast<int>(std::floor(std::log10(length))))
                   : numberText(seconds, kDigits);
}

} // namespace slidercrank
