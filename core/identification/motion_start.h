// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Where to start looking for the mechanism that made some data: from the data themselves.
//
// With θ2 = W t + φ, u = a cos φ and v = a sin φ, so that a cos θ2 = u cos W t - v sin W t and
// a sin θ2 = v cos W t + u sin W t, everything else is linear once the speed W is given:
//
//     θ3 and R4x known    b cos θ3 + a cos θ2 = R4x,  b sin θ3 + a sin θ2 - c = 0               in b, c, u, v
//     θ3 known            sin θ3 = c/b - (a/b) sin θ2                                           in c/b, u/b, v/b
//     R4x known           R4x² = 2 R4x a cos θ2 + 2 c a sin θ2 + D,  D = b² - a² - c²           in u, v, c u, c v, D
//
// Where only a velocity is known it is summed up; the constant that this leaves open is one more unknown: θ3 = θ + δ,
// sin θ + tan δ cos θ = …, and R4x = r + R, r² + 2 r R = …. So there is one number left to search for, W, and the
// turning points of the series tell it roughly: both θ3 and R4x have two a turn, where the crank turns round.

#include "core/identification/motion_fit.h"

#include <optional>
#include <vector>

namespace slidercrank
{

/// θ3 or R4x over the rows of the data, in FitUnits, of their lowest order there is. A velocity is summed up, so that
/// the position is known up to a constant; an acceleration too, and then tells no more than the turning points of a
/// velocity.
struct Course {
    std::vector<double> values; ///< NaN: none
    Order order = Order::Position;
};

/// What is known of the motion before any mechanism is.
struct Courses {
    std::optional<Course> theta3;
    std::optional<Course> R4x;
    std::vector<double> time;
    std::size_t firstRow = 0; ///< of the data; from there to endRow there are no more than a few turns
    std::size_t endRow = 0;
    std::size_t turningPoints = 0; ///< of the better known course, in those rows
    double speed = 0.0;            ///< that they tell: magnitude, rad per unit of time; 0: less than a turn or so
    double speedUncertainty = 0.0; ///< relative
};

/// Precondition: at least two rows with values.
Courses coursesOf(const ReferenceData &data, const Supply &supply, const FitUnits &units);

/// Magnitudes of the speed to look at, ascending: about the one that the turning points tell, or all that are possible.
std::vector<double> likelySpeeds(const Courses &courses);
std::vector<double> allSpeeds(const Courses &courses);

/// Mechanisms worth trying, in FitUnits, with every mirror image the data may have; none where there are accelerations
/// only. `size`: the crank's length where the data hold no length.
std::vector<Parameters> startsFrom(const Courses &courses, const std::vector<double> &speeds, double size);

/// The same for any data, slowly: for each speed the best of a grid of mechanisms and crank angles.
std::vector<Parameters> startsFromGrid(const Observations &observations, const std::vector<double> &speeds,
                                       bool bothDirections, double size, const std::stop_token &stop);

} // namespace slidercrank
