// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/motion_facts.h"

#include "core/closed_form/closed_form.h"
#include "core/limits/extremes.h"
#include "core/sampling/crank_time.h"
#include "ui/text/finding_text.h"
#include "ui/text/written_number.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace slidercrank
{

namespace
{

struct MotionFacts {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::MotionFacts)

public:
    // In the order of Limit. The name and the explanation of a peak depend on the mechanism.
    static constexpr LimitDescription kLimits[] = {
        {"outer-dead-centre", "mm", QT_TR_NOOP("outer dead centre"),
         QT_TR_NOOP("Slider position Rₓ⁴ at which the slider reverses, crank and coupler extended in one line")},
        {"inner-dead-centre", "mm", QT_TR_NOOP("inner dead centre"),
         QT_TR_NOOP("Slider position Rₓ⁴ at which the slider reverses, crank and coupler overlapping in one line")},
        {"stroke", "mm", QT_TR_NOOP("stroke"),
         QT_TR_NOOP("Travel of the slider: its largest position minus its smallest")},
        {"forward-angle", "°", QT_TR_NOOP("forward stroke"),
         QT_TR_NOOP("Crank rotation from the inner to the outer dead centre")},
        {"return-angle", "°", QT_TR_NOOP("return stroke"),
         QT_TR_NOOP("Crank rotation from the outer to the inner dead centre")},
        {"forward-time", "s", QT_TR_NOOP("forward time"),
         QT_TR_NOOP("Crank rotation from the inner to the outer dead centre")},
        {"return-time", "s", QT_TR_NOOP("return time"),
         QT_TR_NOOP("Crank rotation from the outer to the inner dead centre")},
        {"time-ratio", "", QT_TR_NOOP("time ratio"),
         QT_TR_NOOP("Time of the slower stroke divided by the time of the faster one")},
        {"least-transmission-angle", "°", QT_TR_NOOP("minimum transmission angle"),
         QT_TR_NOOP("Angle between the coupler and the normal to the slider's line, 90° − |θ³|, at its minimum. "
                    "Mechanisms with less than about 40° tend to jam.")},
        {"mean-forward-speed", "mm/s", QT_TR_NOOP("mean forward speed"), QT_TR_NOOP("The stroke divided by its time")},
        {"mean-return-speed", "mm/s", QT_TR_NOOP("mean return speed"), QT_TR_NOOP("The stroke divided by its time")},
        {"peak-slider-speed", "mm/s", "", ""},
        {"peak-slider-acceleration", "mm/s²", "", ""},
        {"peak-coupler-speed", "°/s", "", ""},
        {"peak-coupler-acceleration", "°/s²", "", ""},
        {"", "mm", QT_TR_NOOP("crank limit position"),
         QT_TR_NOOP("The crank can go no further: the coupler is perpendicular to the slider's line. The value is the "
                    "slider position Rₓ⁴.")}};
};

/// Indices of MotionFacts::kLimits. Where there are two strokes, that of the forward stroke; the other one follows.
enum Limit : std::size_t {
    kOuter,
    kInner,
    kStroke,
    kStrokeAngle,
    kStrokeTime = 5,
    kTimeRatio = 7,
    kTransmissionAngle,
    kMeanStrokeSpeed,
    kFirstPeak = 11,
    kCrankLimit = 15
};

MotionFact makeFact(std::size_t limit, double number, std::optional<double> theta2 = {})
{
    const auto &[key, unit, name, explanation] = MotionFacts::kLimits[limit];
    return {key, MotionFacts::tr(name), number, unit, MotionFacts::tr(explanation), theta2};
}

/// Returns two lengths with enough digits to distinguish them.
QStringList distinctTexts(double x, double y)
{
    const int digits = digitsToTellApart(x, y);
    return {parameterText(Parameter::B, x, digits), parameterText(Parameter::B, y, digits)};
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

/// Appends a fact for each place of each peak.
void addPeaks(std::vector<MotionFact> &facts, const Mechanism &mechanism)
{
    const std::vector<Peak> peaks = motionPeaks(mechanism);
    for (std::size_t i = 0; i < peaks.size(); ++i) {
        const Peak &peak = peaks[i];
        MotionFact fact = makeFact(kFirstPeak + i, toFileUnit(peak.channel, peak.magnitude));
        fact.name = MotionFacts::tr("peak %1", "of a velocity or an acceleration").arg(quantityName(peak.channel));
        fact.explanation =
            std::isinf(peak.magnitude)
                ? MotionFacts::tr("Unbounded where the coupler is perpendicular to the slider's line")
                : MotionFacts::tr("Largest value over one revolution of the crank, where its derivative is zero");
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
}

} // namespace

QString atLeastText(double limit)
{
    constexpr double kSlack = 1e-6; // of the last digit: 0.1 + 0.2 equals 0.3 except for rounding
    const double unit = limit == 0.0 ? 1.0 : std::pow(10.0, 5.0 - std::floor(std::log10(std::abs(limit))));
    return numberText(std::ceil(limit * unit - kSlack) / unit);
}

QString mobilitySentence(const Mechanism &mechanism, const MotionLimits &limits)
{
    const QStringList turning = distinctTexts(mechanism.b(), shortestCouplerForFullTurn(mechanism));
    switch (limits.mobility) {
    case Mobility::FullTurn: {
        const QString text =
            MotionFacts::tr("The crank can make full turns: b = %1 ≥ a + |c| = %2.").arg(turning[0], turning[1]);
        return limits.largestPressureAngle < 0.5 * std::numbers::pi
                   ? text
                   : text + u' ' +
                         MotionFacts::tr(
                             "Where the coupler is perpendicular to the slider's line, the velocities jump.");
    }
    case Mobility::Rocker:
        return limits.ranges.size() > 1
                   ? MotionFacts::tr(
                         "The crank oscillates within one of two arcs and cannot make a full turn: b = %1 < "
                         "a + |c| = %2, and also less than a − |c| = %3.")
                         .arg(turning[0], turning[1],
                              parameterText(Parameter::B, mechanism.a() - std::abs(mechanism.c())))
                   : MotionFacts::tr("The crank oscillates and cannot make a full turn: b = %1 < a + |c| = %2.")
                         .arg(turning[0], turning[1]);
    case Mobility::Locked:
        return MotionFacts::tr("The crank is locked in a single position: b = |c| − a = %1. It makes full turns if "
                               "b ≥ a + |c| = %2.")
            .arg(turning[0], turning[1]);
    case Mobility::Impossible: {
        const QStringList reaching = distinctTexts(mechanism.b(), shortestCouplerForAnyPose(mechanism));
        return MotionFacts::tr(
                   "The mechanism cannot be assembled: b = %1 < |c| − a = %2. The crank makes full turns if "
                   "b ≥ a + |c| = %3.")
            .arg(reaching[0], reaching[1], turning[1]);
    }
    }
    return {};
}

QString valueText(const MotionFact &fact, int digits)
{
    const QString text = shortNumber(fact.number, digits);
    return fact.unit == u"°" ? text + fact.unit : (text + u' ' + fact.unit).trimmed();
}

double degreesFromZero(double theta2)
{
    constexpr double kRounding = 1e-9; // 0 may have been computed as slightly less
    const double angle = kDegreesPerRadian * theta2;
    return std::max(0.0, angle - 360.0 * std::floor((angle + kRounding) / 360.0));
}

std::span<const LimitDescription> limitsInFiles()
{
    return std::span(MotionFacts::kLimits).first(kCrankLimit);
}

std::vector<MotionFact> motionFacts(const Mechanism &mechanism, const MotionLimits &limits, const Sampling &sampling)
{
    const bool isFullTurn = limits.mobility == Mobility::FullTurn;
    std::vector<MotionFact> facts;
    const auto add = [&facts](std::size_t limit, double number, std::optional<double> theta2 = {}) {
        facts.push_back(makeFact(limit, number, theta2));
    };
    if (limits.outer) {
        add(kOuter, cleaned(limits.outer->R4x, mechanism), limits.outer->theta2);
    }
    if (limits.inner) {
        add(kInner, cleaned(limits.inner->R4x, mechanism), limits.inner->theta2);
    }
    for (const CrankRange &range : isFullTurn ? std::vector<CrankRange>() : limits.ranges) {
        for (const double theta2 : {range.from, range.to}) {
            add(kCrankLimit, cleaned(mechanism.a() * std::cos(theta2), mechanism), theta2);
        }
    }
    if (limits.mobility == Mobility::Locked) {
        facts.pop_back(); // both limits are the only position
    }
    if (limits.stroke) {
        add(kStroke, cleaned(*limits.stroke, mechanism));
    }
    if (isFullTurn) {
        const double angles[] = {*limits.angleOutwards, *limits.angleInwards}; // of the crank, rad
        for (std::size_t i = 0; i < std::size(angles); ++i) {
            add(kStrokeAngle + i, kDegreesPerRadian * angles[i]);
            if (mechanism.omega2() != 0.0) {
                const double time = angles[i] / std::abs(mechanism.omega2());
                add(kStrokeTime + i, time);
                add(kMeanStrokeSpeed + i, *limits.stroke / time);
            }
        }
        add(kTimeRatio, *limits.timeRatio);
    }
    if (limits.mobility != Mobility::Impossible) {
        const double theta2 = limits.largestPressureAngleAt;
        const double angle = 90.0 - kDegreesPerRadian * limits.largestPressureAngle;
        add(kTransmissionAngle, angle, theta2);
        if (isFullTurn && mechanism.c() == 0.0) { // symmetric
            add(kTransmissionAngle, angle, -theta2);
        }
    }
    addPeaks(facts, mechanism);
    for (MotionFact &fact : facts) {
        fact.time = fact.theta2 ? firstTimeAt(*fact.theta2, mechanism, sampling) : std::nullopt;
    }
    return facts;
}

std::vector<QStringList> limitTable(const std::vector<MotionFact> &facts)
{
    std::vector<QStringList> rows{{MotionFacts::tr("limit"), MotionFacts::tr("value"), "θ₂ [°]", "t [s]"}};
    for (const MotionFact &fact : facts) {
        rows.push_back({fact.name, valueText(fact), fact.theta2 ? crankAngleText(*fact.theta2) : fact.remark,
                        fact.time ? numberText(fact.time) : QString()});
    }
    return rows;
}

QString fewSamplesSentence(const Mechanism &mechanism, const Sampling &sampling)
{
    constexpr double kRounding = 1e-9;
    const double perTurn = timeStepsPerTurn(mechanism, sampling);
    return perTurn >= kFewestPerTurn * (1.0 - kRounding)
               ? QString()
               : MotionFacts::tr("%1 samples per revolution are too few for a curve: at least %2 are needed.")
                     .arg(numberText(perTurn, 2), numberText(kFewestPerTurn));
}

QString iterationsText(const SamplingSummary &run)
{
    return run.found() == 0
               ? dash()
               : MotionFacts::tr("%1 in total, at most %2 at a time step").arg(run.iterations).arg(run.mostIterations);
}

QString crankAngleText(double theta2)
{
    return fixedText(degreesFromZero(theta2), 2);
}

} // namespace slidercrank
