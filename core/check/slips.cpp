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
void solveCoupler(Calculation &calculation)
{
    const auto &[a, b, c, omega2, theta2, branch] = calculation.parameters;
    const auto &[sin2, cos2] = calculation.crank;
    const auto &[sin3, cos3] = calculation.coupler;
    const double omega3 = -a * omega2 * cos2 / (b * cos3) + calculation.omega3Error;
    const double normals =
        a * calculation.crankNormal * sin2 + b * calculation.couplerNormalFactor * omega3 * omega3 * sin3;
    calculation.values.state.qDot[Theta3] = omega3;
    calculation.values.state.qDDot[Theta3] =
        (normals - a * calculation.alpha2 * cos2) / (b * cos3) + calculation.alpha3Error;
}

/// Computes the motion of the slider by the formulas above from ω3 and α3.
void solveSlider(Calculation &calculation)
{
    const auto &[a, b, c, omega2, theta2, branch] = calculation.parameters;
    const auto &[sin2, cos2] = calculation.crank;
    const auto &[sin3, cos3] = calculation.coupler;
    State &state = calculation.values.state;
    const double omega3 = state.qDot[Theta3];
    const double normals =
        a * calculation.crankNormal * cos2 + b * calculation.couplerNormalFactor * omega3 * omega3 * cos3;
    state.q[R4x] = a * cos2 + b * cos3;
    state.qDot[R4x] = -a * omega2 * sin2 - b * omega3 * sin3;
    state.qDDot[R4x] = -a * calculation.alpha2 * sin2 - b * state.qDDot[Theta3] * sin3 - normals;
}

void setSlider(Calculation &calculation, const QuantityMotion &motion)
{
    State &state = calculation.values.state;
    state.q[R4x] = motion.position;
    state.qDot[R4x] = motion.velocity;
    state.qDDot[R4x] = motion.acceleration;
}

/// Sets position, velocity and acceleration of the slider from x, dx/dθ2 and d²x/dθ2². Also sets the displacement from
/// the outer dead centre, at x = a + b if the slider is to the right of A, otherwise at -(a + b): the offset c is
/// neglected.
void setSlider(Calculation &calculation, double x, double firstDerivative, double secondDerivative)
{
    const double omega2 = calculation.parameters.omega2;
    const double velocity = firstDerivative * omega2;
    const double acceleration = secondDerivative * omega2 * omega2 + firstDerivative * calculation.alpha2;
    const double side = calculation.side();
    setSlider(calculation, {.position = x, .velocity = velocity, .acceleration = acceleration});
    calculation.values.derived.displacement = {.position =
                                                   calculation.parameters.a + calculation.parameters.b - side * x,
                                               .velocity = -side * velocity,
                                               .acceleration = -side * acceleration};
}

/// Sets the slider to the harmonic motion x = middle + a cos θ2.
void moveHarmonically(Calculation &calculation, double middle)
{
    const double a = calculation.parameters.a;
    const auto &[sin, cos] = calculation.crank;
    setSlider(calculation, middle + a * cos, -a * sin, -a * cos);
}

void moveLikeCrankPin(Calculation &calculation)
{
    moveHarmonically(calculation, 0.0);
}

/// Sets the slider to the motion of the crank pin, shifted by the length of the coupler towards the slider.
void moveLikeShiftedCrankPin(Calculation &calculation)
{
    moveHarmonically(calculation, calculation.directedCoupler());
}

void approximateByTwoHarmonics(Calculation &calculation)
{
    const double a = calculation.parameters.a;
    const double b = calculation.directedCoupler();
    const double omega2 = calculation.parameters.omega2;
    const auto &[sin, cos] = calculation.crank;
    const auto &[sinTwice, cosTwice] = sinCos({2.0 * calculation.parameters.theta20});
    setSlider(calculation, a * cos + b - a * a / (4.0 * b) * (1.0 - cosTwice), -a * sin - a * a / (2.0 * b) * sinTwice,
              -a * cos - a * a / b * cosTwice);
    calculation.values.state.qDot[Theta3] = -a * omega2 * cos / b;
    calculation.values.state.qDDot[Theta3] = a * (omega2 * omega2 * sin - calculation.alpha2 * cos) / b;
}

/// Approximates by two harmonics, but omits the factor 1/2 of sin 2θ2 in the velocity.
void doubleSecondHarmonicOfVelocity(Calculation &calculation)
{
    const double a = calculation.parameters.a;
    approximateByTwoHarmonics(calculation);
    const double change = -a * a / (2.0 * calculation.directedCoupler()) *
                          sinCos({2.0 * calculation.parameters.theta20}).sin * calculation.parameters.omega2;
    calculation.values.state.qDot[R4x] += change;
    calculation.values.derived.displacement.velocity -= calculation.side() * change;
}

void measureFromInnerDeadCentre(Calculation &calculation)
{
    const auto &[a, b, c, omega2, theta2, branch] = calculation.parameters;
    const double side = calculation.side();
    const State &state = calculation.values.state;
    calculation.values.derived.displacement = {side * state.q[R4x] - std::sqrt((b - a) * (b - a) - c * c),
                                               side * state.qDot[R4x], side * state.qDDot[R4x]};
    setSlider(calculation, calculation.values.derived.displacement);
}

/// Replaces ω2² by ω2 in all accelerations q'' ω2² + q' α2, where ' is d/dθ2.
void omitSquareOfSpeed(Calculation &calculation)
{
    State &state = calculation.values.state;
    const double omega2 = calculation.parameters.omega2;
    const Vector12 alpha2Term = state.qDot / omega2 * calculation.alpha2;
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

void scaleLengths(Calculation &calculation, double factor)
{
    DerivedState &derived = calculation.values.derived;
    scaleCoordinates(
        calculation.values.state, [](Coordinate coordinate) { return !isAngle(coordinate); }, factor);
    for (QuantityMotion *motion : {&derived.displacement, &derived.pinX, &derived.pinY}) {
        scale(*motion, factor);
    }
}

/// Multiplies all angles by the factor. Adds half turns to θ3 first, because θ3 may be measured at A or at B, and in
/// either direction.
template <int halfTurns>
void scaleAngles(Calculation &calculation, double factor)
{
    calculation.values.state.q[Theta3] += halfTurns * kHalfTurn;
    scaleCoordinates(calculation.values.state, isAngle, factor);
    scale(calculation.values.derived.transmissionAngle, factor);
}

/// Measures all angles clockwise.
void measureAnglesClockwise(Calculation &calculation)
{
    scaleAngles<0>(calculation, -1.0);
}

void measureFromOuterDeadCentre(Calculation &calculation)
{
    setSlider(calculation, calculation.values.derived.displacement);
}

/// Measures as many textbooks do: the slider from the outer dead centre towards the crank, and the coupler clockwise.
void measureTowardsCrank(Calculation &calculation)
{
    measureFromOuterDeadCentre(calculation);
    measureAnglesClockwise(calculation);
}

/// Makes the slip `makeFirst`, then measures towards the crank.
template <void (*makeFirst)(Calculation &)>
void thenMeasureTowardsCrank(Calculation &calculation)
{
    makeFirst(calculation);
    measureTowardsCrank(calculation);
}

void takeCouplerCentre(Calculation &calculation)
{
    const State &state = calculation.values.state;
    setSlider(calculation, {state.q[R3x], state.qDot[R3x], state.qDDot[R3x]});
}

void turnCouplerByHalfTurn(Calculation &calculation)
{
    calculation.coupler = {-calculation.coupler.sin, -calculation.coupler.cos};
}

void subtractTransmissionAngleFrom(Calculation &calculation, double angle)
{
    double &transmissionAngle = calculation.values.derived.transmissionAngle.position;
    transmissionAngle = angle - transmissionAngle;
}

template <int halfTurns>
void takeRadiansAsDegrees(Calculation &calculation)
{
    scaleAngles<halfTurns>(calculation, 1.0 / kDegreesPerRadian);
}

template <int halfTurns>
void takeDegreesAsRadians(Calculation &calculation)
{
    scaleAngles<halfTurns>(calculation, kDegreesPerRadian);
}

/// Returns half a unit of the third significant digit.
double halfUnitOfThirdDigit(double value)
{
    return value == 0.0 ? 0.0 : 0.5 * std::pow(10.0, std::floor(std::log10(std::abs(value))) - 2.0);
}

/// Rounds the angle θ3 + shift, in degrees, to three digits. `shift` (rad): 0 for the angle at A, -π for that at B.
void roundTheta3(Calculation &calculation, double shift)
{
    const double degrees = (calculation.values.state.q[Theta3] + shift) * kDegreesPerRadian;
    const double unit = 2.0 * halfUnitOfThirdDigit(degrees);
    calculation.coupler = sinCos({std::round(degrees / unit) * unit / kDegreesPerRadian - shift});
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
    void (*make)(Calculation &calculation); ///< makes the slip; nullptr: there is no further way
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
    static constexpr SlipRow kSlips[] = {
        {OtherAssembly,
         "other-assembly",
         {{Input,
           [](Calculation &calculation) {
               calculation.parameters.branch = oppositeBranch(calculation.parameters.branch);
           }}}},
        {OffsetSign, "offset-sign", {{Input, [](Calculation &calculation) { calculation.parameters.c *= -1.0; }}}},
        {OffsetOmitted, "offset-omitted", {{Input, [](Calculation &calculation) { calculation.parameters.c = 0.0; }}}},
        {CrankSpeedSign,
         "crank-speed-sign",
         {{Input, [](Calculation &calculation) { calculation.parameters.omega2 *= -1.0; }}}},
        {CrankAccelerationSign,
         "crank-acceleration-sign",
         {{Input, [](Calculation &calculation) { calculation.alpha2 *= -1.0; }}}},
        {CrankAccelerationOmitted,
         "crank-acceleration-omitted",
         {{Input, [](Calculation &calculation) { calculation.alpha2 = 0.0; }}}},
        {CrankAngleSign,
         "crank-angle-sign",
         {{Input, [](Calculation &calculation) { calculation.parameters.theta20 *= -1.0; }}}},
        {CrankAngleUnit,
         "crank-angle-unit",
         {{Input, [](Calculation &calculation) { calculation.parameters.theta20 *= kDegreesPerRadian; }},
          {Input, [](Calculation &calculation) { calculation.parameters.theta20 /= kDegreesPerRadian; }}}},
        {CrankSpeedInRpm,
         "crank-speed-in-rpm",
         {{Input, [](Calculation &calculation) { calculation.parameters.omega2 *= kRadiansPerSecondPerRpm; }},
          {Input, [](Calculation &calculation) { calculation.parameters.omega2 /= kRadiansPerSecondPerRpm; }}}},
        {CrankSpeedInDegrees,
         "crank-speed-in-degrees",
         {{Input, [](Calculation &calculation) { calculation.parameters.omega2 *= kDegreesPerRadian; }},
          {Input, [](Calculation &calculation) { calculation.parameters.omega2 /= kDegreesPerRadian; }}}},
        {LinksExchanged,
         "links-exchanged",
         {{Input, [](Calculation &calculation) { std::swap(calculation.parameters.a, calculation.parameters.b); }}}},
        {DiameterForRadius,
         "diameter-for-radius",
         {{Input, [](Calculation &calculation) { calculation.parameters.a *= 2.0; }},
          {Input, [](Calculation &calculation) { calculation.parameters.a /= 2.0; }}}},
        {CouplerAngleSign,
         "coupler-angle-sign",
         {{Measurement, [](Calculation &calculation) { calculation.values.state.q[Theta3] *= -1.0; }},
          {Measurement, measureAnglesClockwise}}},
        {CrankSineForCosine,
         "crank-sine-for-cosine",
         {{Input,
           [](Calculation &calculation) {
               calculation.parameters.theta20 = kQuarterTurn - calculation.parameters.theta20;
           }},
          {Formula, [](Calculation &calculation) { std::swap(calculation.crank.sin, calculation.crank.cos); }}}},
        {CouplerSineForCosine,
         "coupler-sine-for-cosine",
         {{Formula, [](Calculation &calculation) { std::swap(calculation.coupler.sin, calculation.coupler.cos); }}}},
        {CouplerAngleEnd, "coupler-angle-end", {{Formula, turnCouplerByHalfTurn}}},
        {CrankSpeedNotSquared,
         "crank-speed-not-squared",
         {{Formula, [](Calculation &calculation) { calculation.crankNormal = calculation.parameters.omega2; }},
          {Result, omitSquareOfSpeed}}},
        {CrankNormalOmitted,
         "crank-normal-omitted",
         {{Formula, [](Calculation &calculation) { calculation.crankNormal = 0.0; }}}},
        {CouplerNormalOmitted,
         "coupler-normal-omitted",
         {{Formula, [](Calculation &calculation) { calculation.couplerNormalFactor = 0.0; }}}},
        {NormalsOmitted,
         "normals-omitted",
         {{Formula,
           [](Calculation &calculation) { calculation.crankNormal = calculation.couplerNormalFactor = 0.0; }}}},
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
         {{Result, [](Calculation &calculation) { scaleLengths(calculation, kMillimetresPerInch); }},
          {Result, [](Calculation &calculation) { scaleLengths(calculation, 1.0 / kMillimetresPerInch); }},
          {Result, [](Calculation &calculation) { scaleLengths(calculation, kCentimetresPerInch); }},
          {Result, [](Calculation &calculation) { scaleLengths(calculation, 1.0 / kCentimetresPerInch); }}}},
        {MetresAsMillimetres,
         "metres",
         {{Result, [](Calculation &calculation) { scaleLengths(calculation, 1000.0); }},
          {Result, [](Calculation &calculation) { scaleLengths(calculation, 0.001); }}}},
        {CentimetresAsMillimetres,
         "centimetres",
         {{Result, [](Calculation &calculation) { scaleLengths(calculation, 10.0); }},
          {Result, [](Calculation &calculation) { scaleLengths(calculation, 0.1); }}}},
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
         {{Result, [](Calculation &calculation) { subtractTransmissionAngleFrom(calculation, kQuarterTurn); }}}},
        {ObtuseAngle,
         "obtuse-angle",
         {{Result, [](Calculation &calculation) { subtractTransmissionAngleFrom(calculation, kHalfTurn); }}}},
        {CouplerAngleRounded,
         "coupler-angle-rounded",
         {{Formula, [](Calculation &calculation) { roundTheta3(calculation, 0.0); }},
          {Formula, [](Calculation &calculation) { roundTheta3(calculation, -kHalfTurn); }}}},
    };
    static_assert(isCompleteTable(kSlips, CouplerAngleRounded));
    return kSlips;
}

/// Computes the motion of `calculation.parameters`. Returns false if there is no such mechanism, or if it cannot be
/// assembled or is singular at this position.
bool solveMechanism(Calculation &calculation)
{
    if (findFault(calculation.parameters)) {
        return false;
    }
    calculation.values = outputStateAt(Mechanism(calculation.parameters), 0.0, calculation.alpha2);
    return calculation.values.state.status == Status::Solved;
}

/// Appends the outcomes of making a slip in this way: none if the slip is in the input and the mechanism cannot be
/// solved with it; two if it is in a formula: made for the slider only, and for the coupler as well; otherwise one.
void addOutcomes(std::vector<SlipOutcome> &outcomes, Slip slip, const Way &way, Calculation calculation)
{
    way.make(calculation);
    if (way.stage == Stage::Input && !solveMechanism(calculation)) {
        return;
    }
    if (way.stage == Stage::Formula) {
        solveSlider(calculation);
        outcomes.push_back({.slip = slip, .values = calculation.values, .affectsPositions = false});
        solveCoupler(calculation);
        solveSlider(calculation);
    }
    const bool affectsPositions = way.stage == Stage::Input || way.stage == Stage::Measurement;
    outcomes.push_back({.slip = slip, .values = calculation.values, .affectsPositions = affectsPositions});
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
    // θ3 is rounded in degrees. Its acute angle with the slider's line determines the third digit, because that angle
    // is the same at A and at B.
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
