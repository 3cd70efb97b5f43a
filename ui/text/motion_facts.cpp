// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/motion_facts.h"

#include "core/closed_form/closed_form.h"
#include "core/sampling/crank_instant.h"
#include "ui/text/axis_scale.h"
#include "ui/text/written_number.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <cmath>
#include <limits>

namespace slidercrank
{

namespace
{

/// The context of these words for translators.
struct MotionFacts {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::MotionFacts)
};

struct Amount {
    QString text;
    double number;
    QString unit;
};

Amount amount(double value, const QString &unit)
{
    constexpr int kDigits = 6;
    const double size = std::abs(value);
    const bool plain = size == 0.0 || (size >= 1e-3 && size < 1e7);
    const QString number = plain ? numberText(value, kDigits) : shortNumber(value, kDigits);
    return {QStringLiteral("%1 %2").arg(number, unit), value, unit};
}

/// `reach`: a + b + |c|; what is nothing but its rounding is 0.
Amount lengthOf(double value, double reach)
{
    constexpr double kNothing = 1e-14;
    return amount(std::abs(value) < kNothing * reach ? 0.0 : value, MotionFacts::tr("mm"));
}

/// An angle between two others, 0 to 360° both included.
Amount turnOf(double radians)
{
    const double degrees = kDegreesPerRadian * radians;
    return {QStringLiteral("%1°").arg(QLocale().toString(degrees, 'f', 2)), degrees, QStringLiteral("°")};
}

/// With as many digits as it takes to tell the two apart.
struct LengthPair {
    QString one;
    QString other;
};
LengthPair toldApart(double one, double other)
{
    constexpr int kMostDigits = 17;
    int digits = 6;
    while (one != other && digits < kMostDigits && numberText(one, digits) == numberText(other, digits)) {
        ++digits;
    }
    return {MotionFacts::tr("%1 mm").arg(numberText(one, digits)),
            MotionFacts::tr("%1 mm").arg(numberText(other, digits))};
}

/// Shortened to the side on which the limit holds: a length typed as it stands here will do.
enum class Bound { AtLeast, AtMost };
QString limitText(Bound bound, double limit)
{
    constexpr double kSameNumber = 1e-6; // of the last digit shown: 0.1 + 0.2 is 0.3
    const double unit = limit == 0.0 ? 1.0 : std::pow(10.0, 5.0 - std::floor(std::log10(std::abs(limit))));
    return numberText(bound == Bound::AtLeast ? std::ceil(limit * unit - kSameNumber) / unit
                                              : std::floor(limit * unit + kSameNumber) / unit);
}

QString boundText(const QString &symbol, Bound bound, double limit)
{
    const QString sign = bound == Bound::AtLeast ? QStringLiteral("≥") : QStringLiteral("≤");
    return MotionFacts::tr("%1 %2 %3 mm").arg(symbol, sign, limitText(bound, limit));
}

QString anyOf(const QStringList &bounds)
{
    if (bounds.size() == 1) {
        return bounds.first();
    }
    return MotionFacts::tr("%1 or %2").arg(bounds.mid(0, bounds.size() - 1).join(MotionFacts::tr(", ")), bounds.last());
}

const QString kA = QStringLiteral("a");
const QString kB = QStringLiteral("b");
const QString kOffset = QStringLiteral("|c|");

/// Each of the lengths changed by itself.
QString helpForFullTurn(const Mechanism &mechanism)
{
    QStringList bounds{boundText(kB, Bound::AtLeast, shortestCouplerForFullTurn(mechanism))};
    if (longestCrankForFullTurn(mechanism) > 0.0) {
        bounds << boundText(kA, Bound::AtMost, longestCrankForFullTurn(mechanism));
    }
    if (largestOffsetForFullTurn(mechanism) == 0.0) {
        bounds << QStringLiteral("c = 0");
    } else if (largestOffsetForFullTurn(mechanism) > 0.0) {
        bounds << boundText(kOffset, Bound::AtMost, largestOffsetForFullTurn(mechanism));
    }
    return MotionFacts::tr("It would make full turns if %1.").arg(anyOf(bounds));
}

QString helpForAnyPose(const Mechanism &mechanism)
{
    return MotionFacts::tr("It can be assembled if %1.")
        .arg(anyOf({boundText(kB, Bound::AtLeast, shortestCouplerForAnyPose(mechanism)),
                    boundText(kA, Bound::AtLeast, std::abs(mechanism.c()) - mechanism.b()),
                    boundText(kOffset, Bound::AtMost, mechanism.a() + mechanism.b())}));
}

bool isUnbounded(const Peak &peak)
{
    return std::isinf(peak.magnitude);
}

/// As they are read, from 0 to 360°.
std::vector<PeakPlace> inOrder(std::vector<PeakPlace> places)
{
    constexpr double kZero = 1e-9; // rad: 0 itself may have come out a little less
    const auto read = [](double theta2) { return theta2 < -kZero ? theta2 + 2.0 * std::numbers::pi : theta2; };
    std::sort(places.begin(), places.end(),
              [read](const PeakPlace &one, const PeakPlace &other) { return read(one.theta2) < read(other.theta2); });
    return places;
}

/// The end of a rocker's arc is known to a rounding, and beyond it there is no pose: the nearest instant that has one,
/// if it is within a few roundings of the crank angle.
double withAPose(const Mechanism &mechanism, double t)
{
    const ClosedForm motion(mechanism);
    const auto exists = [&motion](double instant) { return motion.motionAt(instant).status != Status::NotAssemblable; };
    if (exists(t) || mechanism.omega2() == 0.0) {
        return t;
    }
    const double rounding =
        std::numeric_limits<double>::epsilon() * 2.0 * std::numbers::pi / std::abs(mechanism.omega2());
    constexpr double kFew = 16.0;
    for (double steps = 0.5; steps <= kFew; steps += 0.5) {
        for (const double instant : {t - steps * rounding, t + steps * rounding}) {
            if (exists(instant)) {
                return instant;
            }
        }
    }
    return t;
}

/// The first instant of the run with the crank at that angle.
std::optional<double> instantWithin(const Mechanism &mechanism, const Sampling &run, double theta2)
{
    constexpr double kSlack = 1e-9; // of the run: its last instant counts
    const double end = run.start + run.duration;
    const std::optional<double> t = instantAtCrankAngle(mechanism, theta2, run.start);
    return t && *t <= end + kSlack * run.duration ? std::optional(withAPose(mechanism, std::min(*t, end)))
                                                  : std::nullopt;
}

/// Of one mechanism and run.
class FactList
{
public:
    FactList(const Mechanism &mechanism, const Sampling &run)
        : m_mechanism(mechanism)
        , m_run(run)
    {
    }

    void addAt(double theta2, const QString &name, const Amount &value, const QString &explanation)
    {
        m_facts.push_back({name,
                           value.text,
                           value.number,
                           value.unit,
                           explanation,
                           theta2,
                           {},
                           instantWithin(m_mechanism, m_run, theta2)});
    }

    void add(const QString &name, const Amount &value, const QString &explanation, const QString &remark = {})
    {
        m_facts.push_back({name, value.text, value.number, value.unit, explanation, {}, remark, {}});
    }

    const std::vector<MotionFact> &facts() const { return m_facts; }

private:
    const Mechanism &m_mechanism;
    const Sampling &m_run;
    std::vector<MotionFact> m_facts;
};

void addDeadCentres(FactList &list, const MotionLimits &limits, double reach)
{
    if (limits.outer) {
        list.addAt(limits.outer->theta2, MotionFacts::tr("outer dead centre"), lengthOf(limits.outer->R4x, reach),
                   MotionFacts::tr(
                       "Slider position Rₓ⁴ at which the slider reverses, crank and coupler extended in one line"));
    }
    if (limits.inner) {
        list.addAt(limits.inner->theta2, MotionFacts::tr("inner dead centre"), lengthOf(limits.inner->R4x, reach),
                   MotionFacts::tr(
                       "Slider position Rₓ⁴ at which the slider reverses, crank and coupler overlapping in one line"));
    }
}

/// Where the crank can go no further, with the slider's position there.
void addEnds(FactList &list, const Mechanism &mechanism, const MotionLimits &limits, double reach)
{
    const auto add = [&](const QString &name, double theta2) {
        list.addAt(theta2, name, lengthOf(mechanism.a() * std::cos(theta2), reach),
                   MotionFacts::tr("The crank can go no further: the coupler is perpendicular to the slider's line. "
                                   "The value is the slider position Rₓ⁴."));
    };
    for (const CrankRange &range : limits.ranges) {
        if (limits.mobility == Mobility::Locked) {
            add(MotionFacts::tr("only position"), range.from);
        } else {
            add(MotionFacts::tr("crank limit position"), range.from);
            add(MotionFacts::tr("crank limit position"), range.to);
        }
    }
}

void addStrokeTimes(FactList &list, const Mechanism &mechanism, const MotionLimits &limits)
{
    const auto timeOf = [&](double angle) {
        const double speed = std::abs(mechanism.omega2());
        return mechanism.omega2() == 0.0
                   ? QString()
                   : MotionFacts::tr("in %1 s").arg(secondsText(angle / speed, 2.0 * std::numbers::pi / speed));
    };
    list.add(MotionFacts::tr("forward stroke"), turnOf(*limits.angleOutwards),
             MotionFacts::tr("Crank rotation from the inner to the outer dead centre"), timeOf(*limits.angleOutwards));
    list.add(MotionFacts::tr("return stroke"), turnOf(*limits.angleInwards),
             MotionFacts::tr("Crank rotation from the outer to the inner dead centre"), timeOf(*limits.angleInwards));
    if (const double speed = std::abs(mechanism.omega2()); speed > 0.0) {
        const auto meanSpeed = [&](double angle) {
            return amount(*limits.stroke * speed / angle, QString::fromUtf8(fileUnit({R4x, Order::Velocity})));
        };
        list.add(MotionFacts::tr("mean forward speed"), meanSpeed(*limits.angleOutwards),
                 MotionFacts::tr("The stroke divided by the time of the forward stroke"));
        list.add(MotionFacts::tr("mean return speed"), meanSpeed(*limits.angleInwards),
                 MotionFacts::tr("The stroke divided by the time of the return stroke"));
    }
    list.add(MotionFacts::tr("time ratio"), {numberText(*limits.timeRatio), *limits.timeRatio, {}},
             MotionFacts::tr("Time of the slower stroke divided by the time of the faster one"));
}

QString peakName(Channel channel)
{
    const bool speed = channel.order == Order::Velocity;
    if (channel.coordinate == R4x) {
        return speed ? MotionFacts::tr("slider velocity") : MotionFacts::tr("slider acceleration");
    }
    return speed ? MotionFacts::tr("coupler angular velocity") : MotionFacts::tr("coupler angular acceleration");
}

Amount peakOf(Channel channel, double value)
{
    return amount(toFileUnit(channel, value), QString::fromUtf8(fileUnit(channel)));
}

void addPeak(FactList &list, const Peak &peak)
{
    const QString explanation =
        MotionFacts::tr("Largest value over one revolution of the crank, where its derivative is zero");
    for (const PeakPlace &place : inOrder(peak.places)) {
        list.addAt(place.theta2, peakName(peak.channel), peakOf(peak.channel, place.value), explanation);
    }
    if (peak.places.empty()) {
        list.add(peakName(peak.channel), peakOf(peak.channel, peak.magnitude), explanation,
                 peak.magnitude > 0.0 ? MotionFacts::tr("throughout") : MotionFacts::tr("crank at rest"));
    }
}

} // namespace

QString atLeastText(double limit)
{
    return limitText(Bound::AtLeast, limit);
}

QString mobilitySentence(const Mechanism &mechanism, const MotionLimits &limits)
{
    const LengthPair turning = toldApart(mechanism.b(), shortestCouplerForFullTurn(mechanism));
    switch (limits.mobility) {
    case Mobility::FullTurn:
        if (limits.largestPressureAngle < 0.5 * std::numbers::pi && mechanism.omega2() == 0.0) {
            return MotionFacts::tr("The crank is at rest, ω₂ = 0; it could make full turns: b = %1 ≥ a + |c| = %2.")
                .arg(turning.one, turning.other);
        }
        if (limits.largestPressureAngle < 0.5 * std::numbers::pi) {
            return MotionFacts::tr("The crank makes full turns: b = %1 ≥ a + |c| = %2.")
                .arg(turning.one, turning.other);
        }
        if (mechanism.c() == 0.0) {
            return MotionFacts::tr(
                       "The crank just makes full turns: b = a = %1, c = 0, a change point. At θ₂ = 90° and 270° the "
                       "coupler is perpendicular to the slider's line, and the velocities jump.")
                .arg(turning.one);
        }
        return MotionFacts::tr("The crank just makes full turns: b = a + |c| = %1. At θ₂ = %2° the coupler is "
                               "perpendicular to the slider's line, and the velocities jump.")
            .arg(turning.one, numberText(mechanism.c() > 0.0 ? 270.0 : 90.0));
    case Mobility::Rocker: {
        const QString help = helpForFullTurn(mechanism);
        if (limits.ranges.size() > 1) {
            return MotionFacts::tr("The crank oscillates within one of two arcs and cannot make a full turn: b = %1 < "
                                   "a + |c| = %2, and also less than a − |c| = %3 mm. %4")
                .arg(turning.one, turning.other, numberText(mechanism.a() - std::abs(mechanism.c())), help);
        }
        return MotionFacts::tr("The crank oscillates and cannot make a full turn: b = %1 < a + |c| = %2. %3")
            .arg(turning.one, turning.other, help);
    }
    case Mobility::Locked:
        return MotionFacts::tr("The crank is locked in a single position: b = |c| − a = %1. %2")
            .arg(turning.one, helpForFullTurn(mechanism));
    case Mobility::Impossible: {
        const LengthPair reaching = toldApart(mechanism.b(), shortestCouplerForAnyPose(mechanism));
        return MotionFacts::tr("It cannot be assembled: b = %1 < |c| − a = %2. %3 %4")
            .arg(reaching.one, reaching.other, helpForAnyPose(mechanism), helpForFullTurn(mechanism));
    }
    }
    return {};
}

std::vector<MotionFact> positionFacts(const Mechanism &mechanism, const MotionLimits &limits, const Sampling &run)
{
    FactList list(mechanism, run);
    const double reach = mechanism.a() + mechanism.b() + std::abs(mechanism.c());
    switch (limits.mobility) {
    case Mobility::Impossible: return {};
    case Mobility::Locked: addEnds(list, mechanism, limits, reach); return list.facts();
    case Mobility::Rocker:
        addDeadCentres(list, limits, reach);
        addEnds(list, mechanism, limits, reach);
        break;
    case Mobility::FullTurn: addDeadCentres(list, limits, reach); break;
    }
    list.add(MotionFacts::tr("stroke"), lengthOf(*limits.stroke, reach),
             MotionFacts::tr("Travel of the slider: its largest position minus its smallest"));
    if (limits.mobility == Mobility::Rocker) {
        return list.facts();
    }
    addStrokeTimes(list, mechanism, limits);
    const auto addTransmission = [&](double theta2) {
        list.addAt(theta2, MotionFacts::tr("minimum transmission angle"),
                   turnOf(0.5 * std::numbers::pi - limits.largestPressureAngle),
                   MotionFacts::tr("Angle between the coupler and the normal to the slider's line, 90° − |θ³|, at its "
                                   "minimum. Mechanisms with less than about 40° tend to jam."));
    };
    if (mechanism.c() == 0.0) {
        addTransmission(0.5 * std::numbers::pi); // the same on both sides
        addTransmission(-0.5 * std::numbers::pi);
    } else {
        addTransmission(limits.largestPressureAngleAt);
    }
    return list.facts();
}

std::vector<MotionFact> peakFacts(const Mechanism &mechanism, const MotionLimits &limits,
                                  const std::vector<Peak> &peaks, const Sampling &run)
{
    FactList list(mechanism, run);
    const Peak *unbounded = nullptr;
    for (const Peak &peak : peaks) {
        if (isUnbounded(peak)) {
            unbounded = &peak;
        } else {
            addPeak(list, peak);
        }
    }
    if (unbounded) {
        // All that grow without bound do so at the same places.
        const bool turns = limits.mobility == Mobility::FullTurn;
        for (const PeakPlace &place : inOrder(unbounded->places)) {
            list.addAt(
                place.theta2, turns ? MotionFacts::tr("accelerations") : MotionFacts::tr("velocities, accelerations"),
                {MotionFacts::tr("unbounded"), unbounded->magnitude, {}}, // of several units
                turns
                    ? MotionFacts::tr("The coupler is perpendicular to the slider's line, and the velocities jump")
                    : MotionFacts::tr("The velocities grow without bound as the crank approaches its limit position"));
        }
    }
    return list.facts();
}

QString fewSamplesSentence(const Mechanism &mechanism, const Sampling &run)
{
    constexpr double kRounding = 1e-9;
    const double perTurn = instantsPerTurn(mechanism, run);
    const double wanted = run.steps * kFewestPerTurn / perTurn * (1.0 - kRounding);
    if (wanted <= run.steps) {
        return {};
    }
    return MotionFacts::tr("%1 samples a turn are too few for a curve: %2 steps would do.")
        .arg(numberText(perTurn, 2), countText(static_cast<std::size_t>(nextRoundNumber(wanted))));
}

QString iterationsText(const SamplingSummary &run, const NewtonOptions &options)
{
    if (run.found() == 0) {
        return dash();
    }
    const QString all = countText(static_cast<std::size_t>(run.iterations));
    const QString most = QString::number(run.mostIterations);
    if (run.mostIterations <= options.maxIterations) {
        return MotionFacts::tr("%1 in all, at most %2 an instant").arg(all, most);
    }
    return run.mostWarmIterations == 0
               ? MotionFacts::tr("%1 in all, at most %2 where it had a rough start").arg(all, most)
               : MotionFacts::tr("%1 in all, at most %2 from one instant to the next, %3 where it had a rough start")
                     .arg(all, QString::number(run.mostWarmIterations), most);
}

QString crankAngleText(double radians)
{
    double hundredths = std::round(100.0 * kDegreesPerRadian * radians);
    hundredths -= 36000.0 * std::floor(hundredths / 36000.0);
    return QLocale().toString(0.01 * hundredths, 'f', 2);
}

QString secondsText(double seconds, double length)
{
    constexpr double kShortest = 1e-3;
    constexpr double kLongest = 1e4;
    constexpr int kDigits = 4;
    if (length < kShortest || length >= kLongest) {
        return numberText(seconds, kDigits);
    }
    return localeWithoutGroups().toString(seconds, 'f', kDigits - static_cast<int>(std::floor(std::log10(length))));
}

} // namespace slidercrank
