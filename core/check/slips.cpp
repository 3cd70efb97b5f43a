// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/check/slips.h"

#include "core/mechanism/enum_table.h"
#include "core/mechanism/turn.h"
#include "core/mechanism/two_part_angle.h"

#include <cmath>
#include <span>
#include <string_view>
#include <utility>

namespace slidercrank
{

namespace
{

// The textbook derives the motion from the vector loop a e^(iθ2) + b e^(iθ3) = x + ic:
//
//     ω3 = -a ω2 cos θ2 / (b cos θ3)
//     α3 = (-a α2 cos θ2 + a ω2² sin θ2 + b ω3² sin θ3) / (b cos θ3)
//     x  =  a cos θ2 + b cos θ3
//     ẋ  = -a ω2 sin θ2 - b ω3 sin θ3
//     ẍ  = -a α2 sin θ2 - a ω2² cos θ2 - b α3 sin θ3 - b ω3² cos θ3

/// A calculation by hand. A slip replaces some of its members.
struct Calculation {
    Parameters parameters; ///< with θ2 as the initial angle
    double alpha2;
    OutputState values; ///< the results

    // The quantities that the formulas above use.
    SinCos crank;                     ///< sine and cosine of θ2
    SinCos coupler;                   ///< sine and cosine of θ3
    double crankNormal;               ///< replaces ω2² in the terms a ω2² sin θ2 and a ω2² cos θ2
    double couplerNormalFactor = 1.0; ///< multiplies the terms b ω3² sin θ3 and b ω3² cos θ3
    double omega3Error = 0.0;         ///< is added to ω3
    double alpha3Error = 0.0;         ///< is added to α3

    Calculation(const CrankPosition &position, const OutputState &exact)
        : parameters(position.mechanism.parameters())
        , alpha2(position.alpha2)
        , values(exact)
        , crank(sinCos({parameters.theta20}))
        , coupler(sinCos({exact.state.q[Theta3]}))
        , crankNormal(parameters.omega2 * parameters.omega2)
    {
    }

    /// Returns 1 if the slider is to the right of A, otherwise -1: the direction from A to B along the slider's line.
    double side() const { return parameters.branch == Branch::Open ? 1.0 : -1.0; }

    /// Returns b, or -b if the slider is to the left of A.
    double directedCoupler() const { return side() * parameters.b; }
};

/// Computes ω3 and α3 by the formulas above.
void solveCoupler(Calculation &hand)
{
    const auto &[a, b, c, omega2, theta2, branch] = hand.parameters;
    const auto &[sin2, cos2] = hand.crank;
    const auto &[sin3, cos3] = hand.coupler;
    const double omega3 = -a * omega2 * cos2 / (b * cos3) + hand.omega3Error;
    const double normals = a * hand.crankNormal * sin2 + b * hand.couplerNormalFactor * omega3 * omega3 * sin3;
    hand.values.state.qDot[Theta3] = omega3;
    hand.values.state.qDDot[Theta3] = (normals - a * hand.alpha2 * cos2) / (b * cos3) + hand.alpha3Error;
}

/// Computes the slider by the formulas above from ω3 and α3.
void solveSlider(Calculation &hand)
{
    const auto &[a, b, c, omega2, theta2, branch] = hand.parameters;
    const auto &[sin2, cos2] = hand.crank;
    const auto &[sin3, cos3] = hand.coupler;
    State &state = hand.values.state;
    const double omega3 = state.qDot[Theta3];
    const double normals = a * hand.crankNormal * cos2 + b * hand.couplerNormalFactor * omega3 * omega3 * cos3;
    state.q[R4x] = a * cos2 + b * cos3;
    state.qDot[R4x] = -a * omega2 * sin2 - b * omega3 * sin3;
    state.qDDot[R4x] = -a * hand.alpha2 * sin2 - b * state.qDDot[Theta3] * sin3 - normals;
}

void setSlider(Calculation &hand, const QuantityMotion &motion)
{
    State &state = hand.values.state;
    state.q[R4x] = motion.position;
    state.qDot[R4x] = motion.velocity;
    state.qDDot[R4x] = motion.acceleration;
}

/// Sets position, velocity and acceleration of the slider from x, dx/dθ2 and d²x/dθ2². Also sets the displacement from
/// the outer dead centre, which is at x = a + b: the formulas that lead here neglect the offset c.
void setSlider(Calculation &hand, double x, double firstDerivative, double secondDerivative)
{
    const double omega2 = hand.parameters.omega2;
    const double velocity = firstDerivative * omega2;
    const double acceleration = secondDerivative * omega2 * omega2 + firstDerivative * hand.alpha2;
    const double side = hand.side();
    setSlider(hand, {.position = x, .velocity = velocity, .acceleration = acceleration});
    hand.values.derived.displacement = {.position = hand.parameters.a + hand.parameters.b - side * x,
                                        .velocity = -side * velocity,
                                        .acceleration = -side * acceleration};
}

/// Sets the slider to the harmonic motion x = middle + a cos θ2.
void moveHarmonically(Calculation &hand, double middle)
{
    const double a = hand.parameters.a;
    const auto &[sin, cos] = hand.crank;
    setSlider(hand, middle + a * cos, -a * sin, -a * cos);
}

void moveLikeCrankPin(Calculation &hand)
{
    moveHarmonically(hand, 0.0);
}

/// Sets the slider to the motion of the crank pin, shifted by the length of the coupler.
void moveLikeShiftedCrankPin(Calculation &hand)
{
    moveHarmonically(hand, hand.directedCoupler());
}

void approximateByTwoHarmonics(Calculation &hand)
{
    const double a = hand.parameters.a;
    const double b = hand.directedCoupler();
    const double omega2 = hand.parameters.omega2;
    const auto &[sin, cos] = hand.crank;
    const auto &[sinTwice, cosTwice] = sinCos({2.0 * hand.parameters.theta20});
    setSlider(hand, a * cos + b - a * a / (4.0 * b) * (1.0 - cosTwice), -a * sin - a * a / (2.0 * b) * sinTwice,
              -a * cos - a * a / b * cosTwice);
    hand.values.state.qDot[Theta3] = -a * omega2 * cos / b;
    hand.values.state.qDDot[Theta3] = a * (omega2 * omega2 * sin - hand.alpha2 * cos) / b;
}

/// Approximates by two harmonics, but omits the factor 1/2 of sin 2θ2 in the velocity.
void doubleSecondHarmonicOfVelocity(Calculation &hand)
{
    const double a = hand.parameters.a;
    approximateByTwoHarmonics(hand);
    const double change =
        -a * a / (2.0 * hand.directedCoupler()) * sinCos({2.0 * hand.parameters.theta20}).sin * hand.parameters.omega2;
    hand.values.state.qDot[R4x] += change;
    hand.values.derived.displacement.velocity -= hand.side() * change;
}

void measureFromInnerDeadCentre(Calculation &hand)
{
    const auto &[a, b, c, omega2, theta2, branch] = hand.parameters;
    const double side = hand.side();
    const State &state = hand.values.state;
    hand.values.derived.displacement = {side * state.q[R4x] - std::sqrt((b - a) * (b - a) - c * c),
                                        side * state.qDot[R4x], side * state.qDDot[R4x]};
    setSlider(hand, hand.values.derived.displacement);
}

/// Replaces ω2² by ω2 in all accelerations q'' ω2² + q' α2, where ' is d/dθ2.
void omitSquareOfSpeed(Calculation &hand)
{
    State &state = hand.values.state;
    const double omega2 = hand.parameters.omega2;
    const Vector12 alpha2Term = state.qDot / omega2 * hand.alpha2;
    state.qDDot = (state.qDDot - alpha2Term) / omega2 + alpha2Term;
}

void scale(QuantityMotion &motion, double factor)
{
    motion = {factor * motion.position, factor * motion.velocity, factor * motion.acceleration};
}

void scaleCoordinates(State &state, bool (*isScaled)(Coordinate), double factor)
{
    for (std::ptrdiff_t i = 0; i < kCoordinateCount; ++i) {
        if (isScaled(static_cast<Coordinate>(i))) {
            state.q[i] *= factor;
            state.qDot[i] *= factor;
            state.qDDot[i] *= factor;
        }
    }
}

void scaleLengths(Calculation &hand, double factor)
{
    DerivedState &derived = hand.values.derived;
    scaleCoordinates(
        hand.values.state, [](Coordinate coordinate) { return !isAngle(coordinate); }, factor);
    for (QuantityMotion *motion : {&derived.displacement, &derived.pinX, &derived.pinY}) {
        scale(*motion, factor);
    }
}

/// Multiplies all angles by the factor. Adds half turns to θ3 first, because θ3 may be measured at A or at B, and in
/// either direction.
template <int halfTurns>
void scaleAngles(Calculation &hand, double factor)
{
    hand.values.state.q[Theta3] += halfTurns * kHalfTurn;
    scaleCoordinates(hand.values.state, isAngle, factor);
    scale(hand.values.derived.transmissionAngle, factor);
}

/// Measures all angles clockwise.
void measureAnglesClockwise(Calculation &hand)
{
    scaleAngles<0>(hand, -1.0);
}

void measureFromOuterDeadCentre(Calculation &hand)
{
    setSlider(hand, hand.values.derived.displacement);
}

/// Measures as many textbooks do: the slider from the outer dead centre towards the crank, and the coupler clockwise.
void measureTowardsCrank(Calculation &hand)
{
    measureFromOuterDeadCentre(hand);
    measureAnglesClockwise(hand);
}

/// Makes another slip first.
template <void (*makeFirst)(Calculation &)>
void thenMeasureTowardsCrank(Calculation &hand)
{
    makeFirst(hand);
    measureTowardsCrank(hand);
}

void takeCouplerCentre(Calculation &hand)
{
    const State &state = hand.values.state;
    setSlider(hand, {state.q[R3x], state.qDot[R3x], state.qDDot[R3x]});
}

void turnCouplerByHalfTurn(Calculation &hand)
{
    hand.coupler = {-hand.coupler.sin, -hand.coupler.cos};
}

void subtractTransmissionAngleFrom(Calculation &hand, double angle)
{
    double &transmissionAngle = hand.values.derived.transmissionAngle.position;
    transmissionAngle = angle - transmissionAngle;
}

template <int halfTurns>
void takeRadiansAsDegrees(Calculation &hand)
{
    scaleAngles<halfTurns>(hand, 1.0 / kDegreesPerRadian);
}

template <int halfTurns>
void takeDegreesAsRadians(Calculation &hand)
{
    scaleAngles<halfTurns>(hand, kDegreesPerRadian);
}

/// Returns half a unit of the third significant digit.
double halfUnitOfThirdDigit(double value)
{
    return value == 0.0 ? 0.0 : 0.5 * std::pow(10.0, std::floor(std::log10(std::abs(value))) - 2.0);
}

/// Rounds the angle θ3 + shift, in degrees, to three digits. `shift` (rad): 0 for the angle at A, -π for that at B.
void roundTheta3(Calculation &hand, double shift)
{
    const double degrees = (hand.values.state.q[Theta3] + shift) * kDegreesPerRadian;
    const double unit = 2.0 * halfUnitOfThirdDigit(degrees);
    hand.coupler = sinCos({std::round(degrees / unit) * unit / kDegreesPerRadian - shift});
}

constexpr double kMillimetresPerInch = 25.4;
constexpr double kCentimetresPerInch = 2.54;
constexpr double kRadiansPerSecondPerRpm = kTurn / 60.0;

/// Where a slip is made.
enum class Stage {
    Input,       ///< in a given value, from which everything is then computed
    Measurement, ///< in the origin or the direction from which a position, and so its derivatives, are measured
    Formula,     ///< in the formulas for the slider, or also in those for ω3 and α3; θ3 is right
    Result       ///< in a result alone: nothing is computed from it
};

/// One way to make a slip; a slip may have several.
struct Way {
    Stage stage;
    void (*make)(Calculation &hand); ///< nullptr: there is no further way
};
constexpr std::size_t kMaxWays = 8;

struct SlipRow {
    Slip key;
    std::string_view name; ///< in JSON
    Way ways[kMaxWays];
};

std::span<const SlipRow> allSlips()
{
    using enum Slip;
    using enum Stage;
    using Hand = Calculation;
    static constexpr SlipRow kSlips[] = {
        {OtherAssembly,
         "other-assembly",
         {{Input, [](Hand &hand) { hand.parameters.branch = oppositeBranch(hand.parameters.branch); }}}},
        {OffsetSign, "offset-sign", {{Input, [](Hand &hand) { hand.parameters.c *= -1.0; }}}},
        {OffsetOmitted, "offset-omitted", {{Input, [](Hand &hand) { hand.parameters.c = 0.0; }}}},
        {CrankSpeedSign, "crank-speed-sign", {{Input, [](Hand &hand) { hand.parameters.omega2 *= -1.0; }}}},
        {CrankAccelerationSign, "crank-acceleration-sign", {{Input, [](Hand &hand) { hand.alpha2 *= -1.0; }}}},
        {CrankAccelerationOmitted, "crank-acceleration-omitted", {{Input, [](Hand &hand) { hand.alpha2 = 0.0; }}}},
        {CrankAngleSign, "crank-angle-sign", {{Input, [](Hand &hand) { hand.parameters.theta20 *= -1.0; }}}},
        {CrankAngleUnit,
         "crank-angle-unit",
         {{Input, [](Hand &hand) { hand.parameters.theta20 *= kDegreesPerRadian; }},
          {Input, [](Hand &hand) { hand.parameters.theta20 /= kDegreesPerRadian; }}}},
        {CrankSpeedInRpm,
         "crank-speed-in-rpm",
         {{Input, [](Hand &hand) { hand.parameters.omega2 *= kRadiansPerSecondPerRpm; }},
          {Input, [](Hand &hand) { hand.parameters.omega2 /= kRadiansPerSecondPerRpm; }}}},
        {CrankSpeedInDegrees,
         "crank-speed-in-degrees",
         {{Input, [](Hand &hand) { hand.parameters.omega2 *= kDegreesPerRadian; }},
          {Input, [](Hand &hand) { hand.parameters.omega2 /= kDegreesPerRadian; }}}},
        {LinksExchanged,
         "links-exchanged",
         {{Input, [](Hand &hand) { std::swap(hand.parameters.a, hand.parameters.b); }}}},
        {DiameterForRadius,
         "diameter-for-radius",
         {{Input, [](Hand &hand) { hand.parameters.a *= 2.0; }},
          {Input, [](Hand &hand) { hand.parameters.a /= 2.0; }}}},
        {CouplerAngleSign,
         "coupler-angle-sign",
         {{Measurement, [](Hand &hand) { hand.values.state.q[Theta3] *= -1.0; }},
          {Measurement, measureAnglesClockwise}}},
        {CrankSineForCosine,
         "crank-sine-for-cosine",
         {{Input, [](Hand &hand) { hand.parameters.theta20 = kQuarterTurn - hand.parameters.theta20; }},
          {Formula, [](Hand &hand) { std::swap(hand.crank.sin, hand.crank.cos); }}}},
        {CouplerSineForCosine,
         "coupler-sine-for-cosine",
         {{Formula, [](Hand &hand) { std::swap(hand.coupler.sin, hand.coupler.cos); }}}},
        {CouplerAngleEnd, "coupler-angle-end", {{Formula, turnCouplerByHalfTurn}}},
        {CrankSpeedNotSquared,
         "crank-speed-not-squared",
         {{Formula, [](Hand &hand) { hand.crankNormal = hand.parameters.omega2; }}, {Result, omitSquareOfSpeed}}},
        {CrankNormalOmitted, "crank-normal-omitted", {{Formula, [](Hand &hand) { hand.crankNormal = 0.0; }}}},
        {CouplerNormalOmitted,
         "coupler-normal-omitted",
         {{Formula, [](Hand &hand) { hand.couplerNormalFactor = 0.0; }}}},
        {NormalsOmitted,
         "normals-omitted",
         {{Formula, [](Hand &hand) { hand.crankNormal = hand.couplerNormalFactor = 0.0; }}}},
        {HarmonicMotion,
         "harmonic-motion",
         {{Result, moveLikeCrankPin},
          {Result, moveLikeShiftedCrankPin},
          {Result, thenMeasureTowardsCrank<moveLikeShiftedCrankPin>}}},
        {TwoHarmonics,
         "two-harmonics",
         {{Result, approximateByTwoHarmonics}, {Result, thenMeasureTowardsCrank<approximateByTwoHarmonics>}}},
        {SecondHarmonicDouble,
         "second-harmonic-double",
         {{Result, doubleSecondHarmonicOfVelocity}, {Result, thenMeasureTowardsCrank<doubleSecondHarmonicOfVelocity>}}},
        {CouplerCentre, "coupler-centre", {{Result, takeCouplerCentre}}},
        {FromOuterDeadCentre,
         "from-outer-dead-centre",
         {{Measurement, measureFromOuterDeadCentre}, {Measurement, measureTowardsCrank}}},
        {FromInnerDeadCentre, "from-inner-dead-centre", {{Measurement, measureFromInnerDeadCentre}}},
        {InchesAsMetricUnits,
         "inches",
         {{Result, [](Hand &hand) { scaleLengths(hand, kMillimetresPerInch); }},
          {Result, [](Hand &hand) { scaleLengths(hand, 1.0 / kMillimetresPerInch); }},
          {Result, [](Hand &hand) { scaleLengths(hand, kCentimetresPerInch); }},
          {Result, [](Hand &hand) { scaleLengths(hand, 1.0 / kCentimetresPerInch); }}}},
        {MetresAsMillimetres,
         "metres",
         {{Result, [](Hand &hand) { scaleLengths(hand, 1000.0); }},
          {Result, [](Hand &hand) { scaleLengths(hand, 0.001); }}}},
        {CentimetresAsMillimetres,
         "centimetres",
         {{Result, [](Hand &hand) { scaleLengths(hand, 10.0); }},
          {Result, [](Hand &hand) { scaleLengths(hand, 0.1); }}}},
        // θ3 may be measured at A or B and in either direction, so that up to two half turns are added to it.
        {ValueInRadians,
         "value-in-radians",
         {{Result, takeRadiansAsDegrees<-2>},
          {Result, takeRadiansAsDegrees<-1>},
          {Result, takeRadiansAsDegrees<0>},
          {Result, takeRadiansAsDegrees<1>},
          {Result, takeDegreesAsRadians<-2>},
          {Result, takeDegreesAsRadians<-1>},
          {Result, takeDegreesAsRadians<0>},
          {Result, takeDegreesAsRadians<1>}}},
        {PressureAngle,
         "pressure-angle",
         {{Result, [](Hand &hand) { subtractTransmissionAngleFrom(hand, kQuarterTurn); }}}},
        {ObtuseAngle, "obtuse-angle", {{Result, [](Hand &hand) { subtractTransmissionAngleFrom(hand, kHalfTurn); }}}},
        {CouplerAngleRounded,
         "coupler-angle-rounded",
         {{Formula, [](Hand &hand) { roundTheta3(hand, 0.0); }},
          {Formula, [](Hand &hand) { roundTheta3(hand, -kHalfTurn); }}}},
    };
    static_assert(isCompleteTable(kSlips, CouplerAngleRounded));
    return kSlips;
}

/// Computes the motion from a wrong input. Returns whether there is such a mechanism.
bool solveMechanism(Calculation &hand)
{
    if (findFault(hand.parameters)) {
        return false;
    }
    hand.values = outputStateAt(Mechanism(hand.parameters), 0.0, hand.alpha2);
    return hand.values.state.status == Status::Solved;
}

/// Appends what a slip leads to if it is made in this way: nothing if the mechanism is impossible then.
void addOutcomes(std::vector<SlipOutcome> &outcomes, Slip slip, const Way &way, Calculation hand)
{
    way.make(hand);
    if (way.stage == Stage::Input && !solveMechanism(hand)) {
        return;
    }
    if (way.stage == Stage::Formula) { // in the formulas of the slider only, or in those of the coupler, too
        solveSlider(hand);
        outcomes.push_back({.slip = slip, .values = hand.values, .affectsPositions = false});
        solveCoupler(hand);
        solveSlider(hand);
    }
    const bool affectsPositions = way.stage == Stage::Input || way.stage == Stage::Measurement;
    outcomes.push_back({.slip = slip, .values = hand.values, .affectsPositions = affectsPositions});
}

} // namespace

std::string_view nameOf(Slip slip)
{
    return allSlips()[static_cast<std::size_t>(slip)].name;
}

std::vector<SlipOutcome> slipOutcomes(const CrankPosition &position, const OutputState &exact)
{
    std::vector<SlipOutcome> outcomes;
    for (const SlipRow &row : allSlips()) {
        for (const Way &way : row.ways) {
            if (way.make) {
                addOutcomes(outcomes, row.key, way, Calculation(position, exact));
            }
        }
    }
    return outcomes;
}

OutputState roundingErrors(const CrankPosition &position, const OutputState &exact)
{
    Calculation theta3Rounded(position, exact);
    Calculation omega3Rounded(position, exact);
    Calculation alpha3Rounded(position, exact);
    // θ3 is rounded in degrees. Its acute angle with the slider's line is the same at A and at B.
    const double elevation = std::asin(theta3Rounded.coupler.sin) * kDegreesPerRadian;
    const double theta3Error = halfUnitOfThirdDigit(elevation) / kDegreesPerRadian;
    theta3Rounded.coupler = sinCos({exact.state.q[Theta3] + theta3Error});
    omega3Rounded.omega3Error = halfUnitOfThirdDigit(exact.state.qDot[Theta3]);
    alpha3Rounded.alpha3Error = halfUnitOfThirdDigit(exact.state.qDDot[Theta3]);
    OutputState errors{State{Vector12::Zero(), Vector12::Zero(), Vector12::Zero()}, {}};
    for (Calculation *rounded : {&theta3Rounded, &omega3Rounded, &alpha3Rounded}) {
        solveCoupler(*rounded);
        solveSlider(*rounded);
        errors.state.q += (rounded->values.state.q - exact.state.q).cwiseAbs();
        errors.state.qDot += (rounded->values.state.qDot - exact.state.qDot).cwiseAbs();
        errors.state.qDDot += (rounded->values.state.qDDot - exact.state.qDDot).cwiseAbs();
    }
    return errors;
}

} // namespace slidercrank
