// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The slips that are usual in the kinematics of a slider-crank, each with the values that it leads to. A slip is either
// a wrong input, such as ω2 with the opposite sign, or a wrong formula, such as a missing centripetal term. Lengths in
// mm, angles in rad, time in s.
//
// Source of the formulas: R. L. Norton, "Design of Machinery", eq. 6.22 and 7.15 (vector loop); 13.1 to 13.3
// (approximation by two harmonics).

#include "core/limits/output_channel.h"
#include "core/mechanism/mechanism.h"

#include <string_view>
#include <vector>

namespace slidercrank
{

/// A position of the mechanism with the motion of its crank.
struct CrankPosition {
    Mechanism mechanism; ///< at t = 0 its crank has the examined angle
    double alpha2 = 0.0; ///< crank acceleration, rad/s²
};

enum class Slip {
    OtherAssembly,
    OffsetSign,
    OffsetOmitted,
    CrankSpeedSign,
    CrankAccelerationSign,
    CrankAccelerationOmitted,
    CrankAngleSign,
    CrankAngleUnit,           ///< degrees taken as radians in sin θ2 and cos θ2, or the reverse
    CrankSpeedInRpm,          ///< rpm taken as rad/s, or the reverse
    CrankSpeedInDegrees,      ///< °/s taken as rad/s, or the reverse
    LinksExchanged,           ///< a and b exchanged
    DiameterForRadius,        ///< a doubled or halved
    CouplerAngleSign,         ///< measured clockwise
    CrankSineForCosine,       ///< sin θ2 and cos θ2 exchanged
    CouplerSineForCosine,     ///< sin θ3 and cos θ3 exchanged
    CouplerAngleEnd,          ///< θ3 at A in a formula for the angle at B, or the reverse
    CrankSpeedNotSquared,     ///< ω2 for ω2² in the accelerations
    CrankNormalOmitted,       ///< the centripetal term a ω2²
    CouplerNormalOmitted,     ///< the centripetal term b ω3²
    NormalsOmitted,           ///< both of them
    HarmonicMotion,           ///< the simple harmonic motion of the crank pin A, taken for that of the wrist pin B
    TwoHarmonics,             ///< the approximation x ≈ a cos θ2 + b - a²/4b (1 - cos 2θ2)
    SecondHarmonicDouble,     ///< sin 2θ2 / n instead of sin 2θ2 / 2n in the velocity of TwoHarmonics, n = b/a
    CouplerCentre,            ///< the midpoint of A-B instead of the wrist pin B
    FromOuterDeadCentre,      ///< x counted from the outer dead centre towards the crank
    FromInnerDeadCentre,      ///< x, or the displacement, counted from the inner dead centre outwards
    InchesAsMetricUnits,      ///< inches taken as mm or cm, or the reverse
    MetresAsMillimetres,      ///< m taken as mm, or the reverse
    CentimetresAsMillimetres, ///< cm taken as mm, or the reverse
    ValueInRadians,           ///< a value in radians given as degrees, or the reverse
    PressureAngle,            ///< 90° - μ instead of the transmission angle μ
    ObtuseAngle,              ///< 180° - μ instead of the transmission angle μ, which is acute
    CouplerAngleRounded       ///< θ3 rounded to three digits before it was used
};

/// Returns the name of a slip in JSON: "crank-speed-sign".
std::string_view nameOf(Slip slip);

/// The values that a slip leads to. A value that does not exist with the slip is NaN.
struct SlipOutcome {
    Slip slip;
    OutputState values;

    /// Whether the slip is made before the positions are computed or measured: it is a wrong input or a different way
    /// to measure. Such a slip cannot be the reason if a position that it changes is right.
    bool affectsPositions;
};

/// Returns the outcome of every slip. A slip that can be made in several ways, such as in one formula or in all
/// formulas, has one outcome for each way; a slip with which the mechanism is impossible has none. `exact`: the motion
/// at the position, which must be solved.
std::vector<SlipOutcome> slipOutcomes(const CrankPosition &position, const OutputState &exact);

/// Estimates the largest error of each value if θ3, ω3 and α3 are rounded to three digits before they are used: the sum
/// of the changes that half a unit of the third digit of each of them causes.
OutputState roundingErrors(const CrankPosition &position, const OutputState &exact);

} // namespace slidercrank
