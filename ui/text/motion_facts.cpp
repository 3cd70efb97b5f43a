// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/motion_facts.h"

#include "core/closed_form/closed_form.h"
#include "core/mechanism/enum_table.h"
#include "core/sampling/crank_time.h"
#include "ui/text/channel_text.h"
#include "ui/text/parameter_text.h"
#include "ui/text/written_number.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace slidercrank
{

namespace
{

/// The texts of a limit, untranslated. Those of a peak follow from its channel.
struct LimitText {
    LimitKind key;
    const char *name;
    const char *explanation;
};

struct MotionFacts {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::MotionFacts)

public:
    static constexpr LimitText kTexts[] = {
        {LimitKind::OuterDeadCentre, QT_TR_NOOP("outer dead centre"),
         QT_TR_NOOP("Slider position at which the slider reverses, crank and coupler extended in one line")},
        {LimitKind::InnerDeadCentre, QT_TR_NOOP("inner dead centre"),
         QT_TR_NOOP("Slider position at which the slider reverses, crank and coupler overlapping in one line")},
        {LimitKind::CrankLimit, QT_TR_NOOP("crank limit position"),
         QT_TR_NOOP("The crank can go no further: the coupler is perpendicular to the slider's line. The value "
                    "is the slider position.")},
        {LimitKind::Stroke, QT_TR_NOOP("stroke"),
         QT_TR_NOOP("Travel of the slider: its largest position minus its smallest")},
        {LimitKind::ForwardAngle, QT_TR_NOOP("crank angle, forward stroke"),
         QT_TR_NOOP("Crank rotation from the inner to the outer dead centre")},
        {LimitKind::ForwardTime, QT_TR_NOOP("time, forward stroke"),
         QT_TR_NOOP("Time from the inner to the outer dead centre: the crank rotation divided by |ω₂|")},
        {LimitKind::MeanForwardSpeed, QT_TR_NOOP("mean speed, forward stroke"),
         QT_TR_NOOP("The stroke divided by the time of the forward stroke")},
        {LimitKind::ReturnAngle, QT_TR_NOOP("crank angle, return stroke"),
         QT_TR_NOOP("Crank rotation from the outer to the inner dead centre")},
        {LimitKind::ReturnTime, QT_TR_NOOP("time, return stroke"),
         QT_TR_NOOP("Time from the outer to the inner dead centre: the crank rotation divided by |ω₂|")},
        {LimitKind::MeanReturnSpeed, QT_TR_NOOP("mean speed, return stroke"),
         QT_TR_NOOP("The stroke divided by the time of the return stroke")},
        {LimitKind::TimeRatio, QT_TR_NOOP("time ratio"),
         QT_TR_NOOP("Time of the slower stroke divided by the time of the faster one")},
        {LimitKind::MinimumTransmissionAngle, QT_TR_NOOP("minimum transmission angle"),
         QT_TR_NOOP("The transmission angle μ is the acute angle between the coupler and the normal to the "
                    "slider's line. Mechanisms with a minimum of less than about 40° tend to jam.")},
        {LimitKind::MaximumTransmissionAngle, QT_TR_NOOP("maximum transmission angle"),
         QT_TR_NOOP("90° where the coupler is parallel to the slider's line")},
        {LimitKind::MinimumCouplerAngle, QT_TR_NOOP("minimum coupler angle"),
         QT_TR_NOOP("Smallest angle of the coupler over a revolution of the crank")},
        {LimitKind::MaximumCouplerAngle, QT_TR_NOOP("maximum coupler angle"),
         QT_TR_NOOP("Largest angle of the coupler over a revolution of the crank")},
        {LimitKind::CouplerSwing, QT_TR_NOOP("swing of the coupler"),
         QT_TR_NOOP("The largest angle of the coupler minus its smallest")},
        {LimitKind::PeakSliderSpeed, "", ""},
        {LimitKind::PeakSliderAcceleration, "", ""},
        {LimitKind::PeakCouplerSpeed, "", ""},
        {LimitKind::PeakCouplerAcceleration, "", ""}};
    static_assert(isCompleteTable(kTexts, kLimitDescriptions.back().kind));
};

/// The coupler length and its bound, with enough digits to distinguish them.
struct LengthAndBound {
    QString length;
    QString bound;
};

LengthAndBound distinctTexts(double length, double bound)
{
    const int digits = digitsToTellApart(length, bound);
    return {.length = parameterText(Parameter::B, length, digits), .bound = parameterText(Parameter::B, bound, digits)};
}

/// Returns the first time (s) in the time range at which the crank has the angle theta2 (rad). A limit of
/// the motion is known only up to a rounding error: if the mechanism cannot be assembled at that time, tries the times
/// of the neighbouring angles.
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

/// Returns the value as it is shown. In the notation of textbooks, the angles of the coupler are those at B.
double shownLimit(const Limit &limit, Branch branch, const Notation &notation)
{
    const Measure measure = describe(limit.kind).measure;
    if (limit.kind == LimitKind::MinimumCouplerAngle || limit.kind == LimitKind::MaximumCouplerAngle) {
        const ShownScale scale = shownScale(Channel{Theta3, Order::Position}, branch, notation);
        return scale.shown(toFileUnit(measure, limit.value));
    }
    return shownValue(measure, limit.value, notation.units);
}

QString limitExplanation(const Limit &limit)
{
    if (!peakChannel(limit.kind)) {
        return MotionFacts::tr(rowOf(MotionFacts::kTexts, limit.kind).explanation);
    }
    return std::isinf(limit.value)
               ? MotionFacts::tr("Unbounded where the coupler is perpendicular to the slider's line")
               : MotionFacts::tr("Largest value over one revolution of the crank, where its derivative is zero");
}

/// Returns the reason why a peak belongs to no crank angle; empty for other limits.
QString peakRemark(const Limit &limit)
{
    if (!peakChannel(limit.kind) || limit.theta2) {
        return {};
    }
    return limit.value > 0.0 ? MotionFacts::tr("throughout") : MotionFacts::tr("crank at rest");
}

} // namespace

QString atLeastText(double limit)
{
    constexpr double kSlack = 1e-6; // fraction of the last digit: 0.1 + 0.2 equals 0.3 except for rounding
    const double shownLimit = shownValue(Measure::Length, limit, notation().units);
    const double exponent = shownLimit == 0.0 ? 0.0 : std::floor(std::log10(std::abs(shownLimit)));
    const double lastDigitsInOne = std::pow(10.0, kUsualDigits - 1 - exponent); // 1 over a unit of the last digit
    return withUnit(numberText(std::ceil(shownLimit * lastDigitsInOne - kSlack) / lastDigitsInOne),
                    shownUnit(Measure::Length));
}

QString jumpSentence()
{
    return MotionFacts::tr(
        "Here the coupler is perpendicular to the slider's line, and the velocities jump: just before "
        "and just after this position, velocities and accelerations are different.");
}

QString mobilitySentence(const Mechanism &mechanism, const MotionLimits &limits)
{
    const LengthAndBound fullTurn = distinctTexts(mechanism.b(), shortestCouplerForFullTurn(mechanism));
    switch (limits.mobility) {
    case Mobility::FullTurn: {
        const QString text = MotionFacts::tr("The crank can make full turns: b = %1 ≥ a + |c| = %2.")
                                 .arg(fullTurn.length, fullTurn.bound);
        return limits.coupler.minimumTransmissionAngle.angle > 0.0
                   ? text
                   : text + u' ' +
                         MotionFacts::tr(
                             "Where the coupler is perpendicular to the slider's line, the velocities jump.");
    }
    case Mobility::Rocker:
        if (fullTurn.length == fullTurn.bound) {
            return MotionFacts::tr("The crank oscillates and cannot make a full turn: b is less than a + |c| = %1, by "
                                   "less than the last digit shown.")
                .arg(fullTurn.bound);
        }
        return limits.ranges.size() > 1
                   ? MotionFacts::tr(
                         "The crank oscillates within one of two arcs and cannot make a full turn: b = %1 < "
                         "a + |c| = %2, and also less than a − |c| = %3.")
                         .arg(fullTurn.length, fullTurn.bound,
                              parameterText(Parameter::B, mechanism.a() - std::abs(mechanism.c())))
                   : MotionFacts::tr("The crank oscillates and cannot make a full turn: b = %1 < a + |c| = %2.")
                         .arg(fullTurn.length, fullTurn.bound);
    case Mobility::Locked:
        return MotionFacts::tr("The crank is locked in a single position: b = |c| − a = %1. It makes full turns if "
                               "b ≥ a + |c| = %2.")
            .arg(fullTurn.length, fullTurn.bound);
    case Mobility::Impossible: {
        const LengthAndBound anyPose = distinctTexts(mechanism.b(), shortestCouplerForAnyPose(mechanism));
        return MotionFacts::tr(
                   "The mechanism cannot be assembled: b = %1 < |c| − a = %2. The crank makes full turns if "
                   "b ≥ a + |c| = %3.")
            .arg(anyPose.length, anyPose.bound, fullTurn.bound);
    }
    }
    return {};
}

QString valueText(const MotionFact &fact, int digits)
{
    constexpr double kRounding = 1e-12; // rad, of an angle that is zero
    const double perRadian = fact.unit == u"rad" ? 1.0 : kDegreesPerRadian;
    const bool isZero = describe(fact.kind).measure == Measure::Angle && std::abs(fact.number) < kRounding * perRadian;
    return withUnit(shortNumber(isZero ? 0.0 : fact.number, digits), fact.unit);
}

double degreesFromZero(double theta2)
{
    constexpr double kDegreesPerTurn = 360.0;
    constexpr double kRounding = 1e-9; // °: 0 may have been computed as slightly less
    const double angle = kDegreesPerRadian * theta2;
    return std::max(0.0, angle - kDegreesPerTurn * std::floor((angle + kRounding) / kDegreesPerTurn));
}

QString limitName(LimitKind kind)
{
    const std::optional<Channel> channel = peakChannel(kind);
    return channel ? MotionFacts::tr("peak %1", "of a velocity or an acceleration").arg(quantityName(*channel))
                   : MotionFacts::tr(rowOf(MotionFacts::kTexts, kind).name);
}

std::optional<double> timeOf(const Limit &limit, const Mechanism &mechanism, const Sampling &sampling)
{
    return limit.theta2 ? firstTimeAt(*limit.theta2, mechanism, sampling) : std::nullopt;
}

std::vector<MotionFact> motionFacts(const Mechanism &mechanism, const MotionLimits &motion, const Sampling &sampling,
                                    const Notation &notation)
{
    std::vector<MotionFact> facts;
    for (const Limit &limit : findLimits(mechanism, motion)) {
        facts.push_back({.kind = limit.kind,
                         .name = limitName(limit.kind),
                         .number = shownLimit(limit, mechanism.branch(), notation),
                         .unit = unitText(describe(limit.kind).measure, notation.units),
                         .explanation = limitExplanation(limit),
                         .theta2 = limit.theta2,
                         .remark = peakRemark(limit),
                         .time = timeOf(limit, mechanism, sampling)});
    }
    return facts;
}

std::vector<QStringList> limitTable(const std::vector<MotionFact> &facts)
{
    std::vector<QStringList> rows{{MotionFacts::tr("limit"), MotionFacts::tr("value"),
                                   QStringLiteral("θ₂ [%1]").arg(shownUnit(Measure::Angle)), "t [s]"}};
    for (const MotionFact &fact : facts) {
        rows.push_back({fact.name, valueText(fact), fact.theta2 ? crankAngleText(*fact.theta2) : fact.remark,
                        fact.time ? numberText(fact.time) : QString()});
    }
    return rows;
}

QString fewSamplesSentence(const Mechanism &mechanism, const Sampling &sampling)
{
    constexpr double kRounding = 1e-9; // relative rounding error of the number of samples
    constexpr int kDigits = 2;
    const double perTurn = timeStepsPerTurn(mechanism, sampling);
    return perTurn >= kMinSamplesPerTurn * (1.0 - kRounding)
               ? QString()
               : MotionFacts::tr("%1 samples per revolution are too few for a curve: at least %2 are needed.")
                     .arg(numberText(perTurn, kDigits), numberText(kMinSamplesPerTurn));
}

QString statusSentence(Status status, const NewtonOptions &options)
{
    switch (status) {
    case Status::Solved: break;
    case Status::Singular:
        return MotionFacts::tr("The coupler is perpendicular to the slider's line: the position exists, velocity and "
                               "acceleration do not, because the Jacobian is singular.");
    case Status::IterationLimit:
        return MotionFacts::tr("Newton-Raphson did not converge within %n iterations: allow more iterations or a "
                               "larger tolerance.",
                               nullptr, options.maxIterations);
    case Status::NotAssemblable: return MotionFacts::tr("The mechanism cannot be assembled: the coupler is too short.");
    case Status::NotFinite: // kLargestDrive; the closed form has no such limit
        return MotionFacts::tr("The crank angle is too large for Newton-Raphson, which stores θ₂ with 16 digits: "
                               "choose the closed form, a smaller ω₂, or times nearer to 0.");
    }
    return {};
}

QString iterationsText(const SamplingSummary &summary)
{
    return summary.positionCount() == 0 ? dash()
                                        : MotionFacts::tr("%1 in total, at most %2 at a time step")
                                              .arg(summary.iterations)
                                              .arg(summary.maxIterationsOfStep);
}

double shownCrankAngle(double theta2)
{
    return shownValue(Measure::Angle, degreesFromZero(theta2) / kDegreesPerRadian, notation().units);
}

QString crankAngleText(double theta2)
{
    constexpr int kDecimalsOfRadians = 4;
    constexpr int kDecimalsOfDegrees = 2;
    const bool isRadian = notation().units.angle == AngleUnit::Radian;
    return isRadian ? fixedText(shownCrankAngle(theta2), kDecimalsOfRadians)
                    : fixedText(degreesFromZero(theta2), kDecimalsOfDegrees);
}

QString crankAngleWithUnit(double theta2)
{
    return withUnit(crankAngleText(theta2), shownUnit(Measure::Angle));
}

} // namespace slidercrank
