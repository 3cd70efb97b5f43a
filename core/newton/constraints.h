// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The constraints of the slider-crank in absolute coordinates, and what Newton-Raphson, velocity and acceleration need
// of them. Derivations stand above the functions in constraints.cpp.
//
// Source: A. A. Shabana, "Computational Dynamics", 3rd ed., sections 3.3 to 3.7; rows and signs as in the report.
// Lengths in mm, angles in rad, time in s.

#include "core/mechanism/state.h"

namespace slidercrank
{

/// C(q, t): mm in length rows, rad in angle rows.
Vector12 constraints(const Mechanism &mechanism, const Vector12 &q, double t);

/// C_q = ∂C/∂q. Its determinant is -b cos θ3.
Matrix12 constraintJacobian(const Mechanism &mechanism, const Vector12 &q);

/// C_t = ∂C/∂t.
Vector12 constraintTimeDerivative(const Mechanism &mechanism);

/// Q_d = -(C_q q̇)_q q̇ - 2 C_qt q̇ - C_tt: the right-hand side of C_q q̈ = Q_d.
Vector12 quadraticVelocityTerm(const Mechanism &mechanism, const Vector12 &q, const Vector12 &qDot);

/// ‖C‖ with the length rows multiplied by `unit` before they are squared, and then by `perLength`: of lengths whose
/// squares would be 0.
double residualInUnits(const Vector12 &C, double perLength, double unit);

} // namespace slidercrank
