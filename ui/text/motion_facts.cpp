// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/motion_facts.h"

#include "core/closed_form/closed_form.h"
#include "core/sampling/crank_time.h"
#include "ui/text/finding_text.h"
#include "ui/text/written_number.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace slidercrank
{

namespace
{

/// The context of these texts for translators.
struct MotionFacts {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::MotionFacts)
};

constexpr double kTurn = 2.0 * std::numbers::pi;

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

QString anyOf(const QStringList &bounds)
{
    return bounds.size() == 1 ? bounds.first()
                              : MotionFacts::tr("%1 or %2")
                                    .arg(bounds.first(bounds.size() - 1).join(QStringLiteral(", ")), bounds.last());
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
    if (limits.largestPressureAngle < 0.25 * kTurn) {
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

/// The facts of one mechanism and time range.
class FactList
{
public:
    FactList(const Mechanism &mechanism, const Sampling &sampling)
        : m_mechanism(mechanism)
        , m_sampling(sampling)
    {
    }

    void add(const QString &name, double number, const QString &unit, const QString &explanation,
             const QString &remark = {})
    {
        m_facts.push_back({name, valueText(number, unit), number, unit, explanation, {}, remark, {}});
    }

    /// Adds a fact at a crank angle, with the first time at which the crank has that angle. Limit positions are known
    /// only up to a rounding error; there, the time is one at which the mechanism can be assembled.
    void addAt(double theta2, const QString &name, double number, const QString &unit, const QString &explanation)
    {
        constexpr double kNudge = 1e-9; // rad, more than the rounding error of a crank angle
        constexpr double kSlack = 1e-9; // relative to the duration, to include the end of the time range
        add(name, number, unit, explanation);
        MotionFact &fact = m_facts.back();
        fact.theta2 = theta2;
        const double end = m_sampling.start + m_sampling.duration;
        for (const double nudge : {0.0, kNudge, -kNudge}) {
            const auto time = timeAtCrankAngle(m_mechanism, theta2 + nudge, m_sampling.start);
            if (time && *time <= end + kSlack * m_sampling.duration &&
                (!fact.time || !isAssemblable(*fact.time))) {
                fact.time = std::min(*time, end);
            }
        }
    }

    const std::vector<MotionFact> &facts() const { return m_facts; }

private:
    bool isAssemblable(double time) const
    {
        return ClosedForm(m_mechanism).motionAt(time).status != Status::NotAssemblable;
    }

    static QString valueText(double number, const QString &unit)
    {
        if (std::isinf(number)) {
            return MotionFacts::tr("unbounded");
        }
        if (unit == u"°") {
            return QLocale().toString(number, 'f', 2) + unit;
        }
        const double size = std::abs(number);
        const bool isPlain = number == 0.0 || (size >= 1e-3 && size < 1e7);
        return (isPlain ? numberText(number) : shortNumber(number, 6)) + (unit.isEmpty() ? unit : u' ' + unit);
    }

    const Mechanism &m_mechanism;
    const Sampling &m_sampling;
    std::vector<MotionFact> m_facts;
};

/// Returns a length, or 0 if it is only a rounding error of a + b + |c|.
double cleaned(double length, const Mechanism &mechanism)
{
    constexpr double kRounding = 1e-14;
    return std::abs(length) < kRounding * characteristicLength(mechanism.parameters()) ? 0.0 : length;
}

void addDeadCentres(FactList &list, const Mechanism &mechanism, const MotionLimits &limits)
{
    if (limits.outer) {
        list.addAt(limits.outer->theta2, MotionFacts::tr("outer dead centre"), cleaned(limits.outer->R4x, mechanism),
                   QStringLiteral("mm"),
                   MotionFacts::tr(
                       "Slider position Rₓ⁴ at which the slider reverses, crank and coupler extended in one line"));
    }
    if (limits.inner) {
        list.addAt(limits.inner->theta2, MotionFacts::tr("inner dead centre"), cleaned(limits.inner->R4x, mechanism),
                   QStringLiteral("mm"),
                   MotionFacts::tr(
                       "Slider position Rₓ⁴ at which the slider reverses, crank and coupler overlapping in one line"));
    }
}

/// Adds the limit positions of the crank.
void addLimitPositions(FactList &list, const Mechanism &mechanism, const MotionLimits &limits)
{
    const bool isLocked = limits.mobility == Mobility::Locked;
    const auto add = [&](double theta2) {
        list.addAt(theta2, isLocked ? MotionFacts::tr("only position") : MotionFacts::tr("crank limit position"),
                   cleaned(mechanism.a() * std::cos(theta2), mechanism), QStringLiteral("mm"),
                   MotionFacts::tr("The crank can go no further: the coupler is perpendicular to the slider's line. "
                                   "The value is the slider position Rₓ⁴."));
    };
    for (const CrankRange &range : limits.ranges) {
        add(range.from);
        if (!isLocked) {
            add(range.to);
        }
    }
}

void addStrokeTimes(FactList &list, const Mechanism &mechanism, const MotionLimits &limits)
{
    const double speed = std::abs(mechanism.omega2());
    const auto addAngle = [&](const QString &name, double angle, const QString &explanation) {
        const QString time =
            speed == 0.0 ? QString() : MotionFacts::tr("in %1 s").arg(secondsText(angle / speed, kTurn / speed));
        list.add(name, kDegreesPerRadian * angle, QStringLiteral("°"), explanation, time);
    };
    addAngle(MotionFacts::tr("forward stroke"), *limits.angleOutwards,
             MotionFacts::tr("Crank rotation from the inner to the outer dead centre"));
    addAngle(MotionFacts::tr("return stroke"), *limits.angleInwards,
             MotionFacts::tr("Crank rotation from the outer to the inner dead centre"));
    if (speed > 0.0) {
        const double product = *limits.stroke * speed;
        const QString unit = unitOf({R4x, Order::Velocity});
        list.add(MotionFacts::tr("mean forward speed"), product / *limits.angleOutwards, unit,
                 MotionFacts::tr("The stroke divided by the time of the forward stroke"));
        list.add(MotionFacts::tr("mean return speed"), product / *limits.angleInwards, unit,
                 MotionFacts::tr("The stroke divided by the time of the return stroke"));
    }
    list.add(MotionFacts::tr("time ratio"), *limits.timeRatio, {},
             MotionFacts::tr("Time of the slower stroke divided by the time of the faster one"));
}

/// Sorts places by crank angle, from 0 to 360°.
std::vector<PeakPlace> sorted(std::vector<PeakPlace> places)
{
    constexpr double kZero = 1e-9; // rad: 0 may have been computed as slightly less
    std::ranges::sort(
        places, {}, [](const PeakPlace &place) { return place.theta2 < -kZero ? place.theta2 + kTurn : place.theta2; });
    return places;
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

std::vector<MotionFact> positionFacts(const Mechanism &mechanism, const MotionLimits &limits, const Sampling &run)
{
    FactList list(mechanism, run);
    const bool isFullTurn = limits.mobility == Mobility::FullTurn;
    if (isFullTurn || limits.mobility == Mobility::Rocker) {
        addDeadCentres(list, mechanism, limits);
    }
    if (!isFullTurn) {
        addLimitPositions(list, mechanism, limits);
    }
    if (isFullTurn || limits.mobility == Mobility::Rocker) {
        list.add(MotionFacts::tr("stroke"), cleaned(*limits.stroke, mechanism), QStringLiteral("mm"),
                 MotionFacts::tr("Travel of the slider: its largest position minus its smallest"));
    }
    if (!isFullTurn) {
        return list.facts();
    }
    addStrokeTimes(list, mechanism, limits);
    const double angle = 90.0 - kDegreesPerRadian * limits.largestPressureAngle;
    const auto addTransmission = [&](double theta2) {
        list.addAt(theta2, MotionFacts::tr("minimum transmission angle"), angle, QStringLiteral("°"),
                   MotionFacts::tr("Angle between the coupler and the normal to the slider's line, 90° − |θ³|, at its "
                                   "minimum. Mechanisms with less than about 40° tend to jam."));
    };
    addTransmission(mechanism.c() == 0.0 ? 0.25 * kTurn : limits.largestPressureAngleAt);
    if (mechanism.c() == 0.0) {
        addTransmission(-0.25 * kTurn); // a second minimum, by symmetry
    }
    return list.facts();
}

std::vector<MotionFact> peakFacts(const Mechanism &mechanism, const MotionLimits &limits,
                                  const std::vector<Peak> &peaks, const Sampling &run)
{
    FactList list(mechanism, run);
    std::vector<PeakPlace> unbounded; // the same places for all unbounded channels
    for (const Peak &peak : peaks) {
        if (std::isinf(peak.magnitude)) {
            unbounded = sorted(peak.places);
            continue;
        }
        const QString name = quantityOf(peak.channel);
        const QString unit = unitOf(peak.channel);
        const QString explanation =
            MotionFacts::tr("Largest value over one revolution of the crank, where its derivative is zero");
        for (const PeakPlace &place : sorted(peak.places)) {
            list.addAt(place.theta2, name, toFileUnit(peak.channel, place.value), unit, explanation);
        }
        if (peak.places.empty()) {
            list.add(name, toFileUnit(peak.channel, peak.magnitude), unit, explanation,
                     peak.magnitude > 0.0 ? MotionFacts::tr("throughout") : MotionFacts::tr("crank at rest"));
        }
    }
    const bool isFullTurn = limits.mobility == Mobility::FullTurn;
    for (const PeakPlace &place : unbounded) {
        list.addAt(
            place.theta2, isFullTurn ? MotionFacts::tr("accelerations") : MotionFacts::tr("velocities, accelerations"),
            std::numeric_limits<double>::infinity(), {},
            isFullTurn
                ? MotionFacts::tr("The coupler is perpendicular to the slider's line, and the velocities jump")
                : MotionFacts::tr("The velocities grow without bound as the crank approaches its limit position"));
    }
    return list.facts();
}

QString fewSamplesSentence(const Mechanism &mechanism, const Sampling &run)
{
    constexpr double kRounding = 1e-9;
    const double perTurn = timeStepsPerTurn(mechanism, run);
    const double wanted = run.steps * kFewestPerTurn / perTurn * (1.0 - kRounding);
    return wanted <= run.steps
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
