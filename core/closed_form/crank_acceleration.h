// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Computes the motion at an instant at which the crank also accelerates. Every coordinate q is a function of the crank
// angle θ2 alone, so that the chain rule gives, with ' for d/dθ2 (the kinematic coefficients q' and q'' of the
// textbook),
//
//     q̇ = q' ω2        q̈ = q'' ω2² + q' α2
//
// The motion at constant speed has q̈ = q'' ω2²; what α2 adds is q' α2, also for a crank that starts from rest. Position
// and velocity do not depend on α2.
//
// Source: J. J. Uicker, G. R. Pennock, J. E. Shigley, "Theory of Machines and Mechanisms", 4th ed., ch. 3 and 4
// (kinematic coefficients). Lengths in mm, angles in rad, time in s.

#include "core/mechanism/state.h"

namespace slidercrank
{

/// Returns dq/dθ2 of all coordinates at time t (s); NaN where velocities do not exist.
Vector12 kinematicCoefficients(const Mechanism &mechanism, double t);

/// Adds to `state`, the motion at constant speed at time t (s), what a crank acceleration alpha2 (rad/s²) adds. With 0
/// the state remains the same to the last bit.
void addCrankAcceleration(const Mechanism &mechanism, double t, double alpha2, State &state);

} // namespace slidercrank
