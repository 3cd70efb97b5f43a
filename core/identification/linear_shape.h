// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A mechanism's lengths by linear least squares, given positions over the crank's angle. With θ2 = W t + φ, u = a cos φ
// and v = a sin φ, so that a cos θ2 = u cos W t - v sin W t and a sin θ2 = v cos W t + u sin W t, everything but the
// speed W is linear. Let the file's θ3 be q = θ3 + z, and its R4x be r + m with mean m, the slider really being at
// r + R:
//
//     both       B1 cos q + B2 sin q + a cos θ2 + (m - R) = r + m,   B1 sin q - B2 cos q + a sin θ2 - c = 0
//     θ3 alone   sin q = tan z cos q + (c - a sin θ2) / (b cos z)
//     R4x alone  r² = -2 R r + 2 r a cos θ2 + (2 R u + 2 c v) cos W t + (2 c u - 2 R v) sin W t + D - R²,
//                D = b² - a² - c²
//
// with B1 = b cos z and B2 = b sin z. Where the origin of a column is trusted, z = 0 and R = m.

#include "core/mechanism/mechanism.h"

#include <functional>
#include <limits>
#include <vector>

namespace slidercrank
{

/// Positions at some instants; empty where there is none of the kind.
struct Positions {
    std::vector<double> phase; ///< W t
    std::vector<double> theta3;
    std::vector<double> R4x;
    bool isTheta3Whole = false; ///< its constant is in the file
    bool isR4xWhole = false;
};

struct Shape {
    Parameters parameters;                                 ///< the speed is not set
    double left = std::numeric_limits<double>::infinity(); ///< of the squares, as a part
};

/// Every way in which the positions give a mechanism.
struct Route {
    std::function<Shape(const Positions &)> shape;
    bool isOfTheta3 = false; ///< only: then the crank may as well turn the other way
};

/// `size`: the crank's length where the positions hold none.
std::vector<Route> routesFor(const Positions &positions, double size);

} // namespace slidercrank
