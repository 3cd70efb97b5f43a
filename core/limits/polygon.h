// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The velocity polygon and the acceleration polygon of the graphical method. A and B are the vectors from the crank
// pivot to the pins, so that B - A is that of the coupler:
//
//     v_B = v_A + v_BA                        v_A = ω2 × A                  v_BA = ω3 × (B - A)
//     a_B = a_Aⁿ + a_Aᵗ + a_BAⁿ + a_BAᵗ       a_Aⁿ = -ω2² A                 a_BAⁿ = -ω3² (B - A)
//                                             a_Aᵗ = α2 × A                 a_BAᵗ = α3 × (B - A)
//
// Each vector begins where the previous one ends, and the last one, that of B, leads from the pole to the same
// end: it is parallel to the slider's line. Source: R. L. Norton, "Design of Machinery", sections 6.2 and 7.2.
// Lengths in mm, time in s.

#include "core/limits/linkage_point.h"

#include <vector>

namespace slidercrank
{

enum class PolygonVector {
    PinVelocity,        ///< v_A
    CouplerVelocity,    ///< v_BA
    SliderVelocity,     ///< v_B
    PinNormal,          ///< a_Aⁿ
    PinTangential,      ///< a_Aᵗ
    CouplerNormal,      ///< a_BAⁿ
    CouplerTangential,  ///< a_BAᵗ
    SliderAcceleration, ///< a_B
};

/// A vector of a polygon, from its start to its end (mm/s or mm/s²). The pole is at the origin.
struct PlacedVector {
    PolygonVector vector = PolygonVector::PinVelocity;
    PlaneVector from;
    PlaneVector to;
};

struct Polygons {
    std::vector<PlacedVector> velocity;
    std::vector<PlacedVector> acceleration;
};

/// Returns the polygons at time t (s), at which the crank has the acceleration alpha2 (rad/s²); both are empty if
/// velocities do not exist.
Polygons polygonsAt(const Mechanism &mechanism, double t, double alpha2);

} // namespace slidercrank
