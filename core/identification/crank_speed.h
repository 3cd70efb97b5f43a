// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// How fast the crank turns: by what the file says of θ2, or because every column is periodic in W t, so that a constant
// and two harmonics, each derivative differentiated exactly, leave least at the right speed. Two only: with four, half
// the speed fits as well.

#include "core/identification/motion_fit.h"

#include <Eigen/Core>

#include <functional>
#include <stop_token>
#include <vector>

namespace slidercrank
{

/// None where the column is not in use.
const FitColumn *columnOf(const FitProblem &problem, Channel channel);

inline constexpr int kMostHarmonics = 6;
inline constexpr int kMostTerms = 1 + 2 * kMostHarmonics;

/// One coordinate as a constant and harmonics of W t: 1, cos, sin, cos 2, sin 2, …
struct Series {
    Eigen::Matrix<double, kMostTerms, 1> terms = Eigen::Matrix<double, kMostTerms, 1>::Zero();
    bool hasConstant = false;
    int harmonics = 0;

    double at(double phase) const
    {
        double sum = terms[0];
        for (int h = 1; h <= harmonics; ++h) {
            sum += terms[2 * h - 1] * std::cos(h * phase) + terms[2 * h] * std::sin(h * phase);
        }
        return sum;
    }

    /// Of the first harmonic only, `quarter` of a turn later.
    double fundamentalAt(double phase, double quarter = 0.0) const
    {
        return terms[1] * std::cos(phase + quarter) + terms[2] * std::sin(phase + quarter);
    }
};

/// A coordinate with its derivatives.
struct Family {
    std::vector<const FitColumn *> columns;
    bool hasPosition = false;
};

/// Empty where nothing of it moves.
Family familyOf(const FitProblem &problem, Coordinate coordinate);

/// cos W t and sin W t of all rows.
struct Phases {
    double speed = 0.0;
    std::vector<double> cosine;
    std::vector<double> sine;
};

Phases phasesAt(const FitProblem &problem, double speed);

/// To the sum of both speeds, without a sine.
void advance(Phases &phases, const Phases &step);

/// Least squares of a family at a speed; what is left as part of the columns' squares (each counting alike), times
/// their number.
double leftBy(const FitProblem &problem, const Family &family, const Phases &phases, int harmonics, Series *series);

/// The lowest few local minima of f, whose values at some ascending places are given; each refined in so many steps.
std::vector<double> minimaOver(const std::vector<double> &places, const std::vector<double> &values, std::size_t most,
                               int steps, const std::function<double(double)> &f);

/// Magnitudes of the speed that the columns may have, in whatever units and senses; some, the best first.
std::vector<double> speedsOf(const FitProblem &problem, const std::stop_token &stop);

/// The speed that θ2 or its derivative tells (FitUnits, signed); 0: neither is there.
double crankSpeedOf(const FitProblem &problem);

} // namespace slidercrank
