// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The constraints of the slider-crank in absolute coordinates, with the derivatives that Newton-Raphson, the velocities
// and the accelerations need. The derivations are in constraints.cpp, above each function.
//
// Source: A. A. Shabana, "Computational Dynamics", 3rd ed., sections 3.3 to 3.7; rows and signs as in the reference
// report. Lengths in mm, angles in rad, time in s.

#include "core/mechanism/state.h"

namespace slidercrank
{

/// Returns C(q, t): mm in the length rows, rad in the angle rows.
Vector12 constraints(const Mechanism &mechanism, const Vector12 &q, double t);

/// Returns C_q = ∂C/∂q. Its determinant is -b cos θ3.
Matrix12 constraintJacobian(const Mechanism &mechanism, const Vector12 &q);

/// Returns C_t = ∂C/∂t.
Vector12 constraintTimeDerivative(const Mechanism &mechanism);

/// Returns Q_d = -(C_q q̇)_q q̇ - 2 C_qt q̇ - C_tt: the right-hand side of C_q q̈ = Q_d.
Vector12 quadraticVelocityTerm(const Mechanism &mechanism, const Vector12 &q, const Vector12 &qDot);

} // namespace slidercrank
