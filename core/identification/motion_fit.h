// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Least squares of a slider-crank's motion on observations, by one model of errors and one score.
//
// A value is uncertain by its own rounding, by its instant's rounding times the motion's rate, and by noise where the
// residuals say so:
//
//     V = step²/12 + (rate τ)²/12 + σ²
//
// with one σ a column: 0, unless the mean of r²/V at σ = 0 lies beyond chance; then the one that makes that mean 1.
// The score of a way to read the file, lower is better, compares ways with different columns, units and freedoms:
//
//     S = Σ r²/V + ln(V / z²) + k ln N        z the spread of the column, k free parameters, N values
//
// A free constant pays for what it might have been: ln(size² Σ 1/V) instead of ln N where that is more. A column that
// is left out counts as explained by its own spread.
//
// Sources: K. Levenberg 1944, D. W. Marquardt 1963; G. Schwarz, "Estimating the dimension of a model", 1978.

#include "core/identification/observations.h"

#include <Eigen/Core>

#include <array>
#include <limits>
#include <span>
#include <stop_token>
#include <vector>

namespace slidercrank
{

/// How one column of a file is read: as which channel, in which unit and sense, from where it is counted.
struct ColumnReading {
    Channel channel;         ///< may be another than the file says
    double factor = 1.0;     ///< multiplies the file's number, which is then in the author's unit of the channel
    double turn = 0.0;       ///< degrees, then added to an angle
    bool isUsed = true;      ///< false: left out
    bool isZeroFree = false; ///< an unknown constant is added

    friend bool operator==(const ColumnReading &, const ColumnReading &) = default;
};

/// One for each column of the Observations, in their order.
using FileReading = std::vector<ColumnReading>;

FileReading asWritten(const Observations &observations);

/// The columns of one reading in FitUnits.
struct FitColumn {
    Channel channel;
    std::vector<double> values; ///< NaN: none
    std::vector<double> variance;
    std::size_t count = 0;
    double repetition = 1.0;
    std::size_t source = 0; ///< which of the observations
    double spread = 0.0;
    double step = 0.0;
    Eigen::Index zero = -1; ///< which of the free constants, or none
};

struct FitProblem {
    std::vector<double> time;
    double clockStep = 0.0;
    double farthest = 0.0;          ///< largest distance of an instant from the file's t = 0
    std::vector<FitColumn> columns; ///< those in use
    Eigen::Index zeroCount = 0;
    std::size_t valueCount = 0;
    std::size_t leftOut = 0; ///< values of columns not in use
};

FitProblem problemOf(const Observations &observations, const FileReading &reading);

/// What arithmetic makes of a column at that speed: after so many radians a double has lost so many digits.
double arithmeticVariance(const FitProblem &problem, const FitColumn &column, double omega2);

/// By enum Parameter.
using FreeParameters = std::array<bool, kParameterCount>;
inline constexpr FreeParameters kAllFree{true, true, true, true, true};

inline constexpr Eigen::Index kMostZeros = 4;

/// At most all parameters and constants.
using FitMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kParameterCount + kMostZeros,
                                kParameterCount + kMostZeros>;
using FitVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kParameterCount + kMostZeros, 1>;

struct Fit {
    Parameters parameters; ///< in FitUnits
    std::array<double, kMostZeros> zeros{};
    std::vector<double> noise; ///< σ² by column of the problem
    double chiSquared = std::numeric_limits<double>::infinity();
    double score = std::numeric_limits<double>::infinity();
    double deviance = std::numeric_limits<double>::infinity(); ///< the score without what freedom costs
    int iterations = 0;

    bool exists() const { return chiSquared < std::numeric_limits<double>::infinity(); }
};

/// From that start: noise estimated from what it leaves, fitted, and so on until nothing changes.
Fit fit(const FitProblem &problem, const Parameters &start, const FreeParameters &isFree, int mostRounds,
        const std::stop_token &stop);

/// Residuals and variances at a fit, by column of the problem; NaN where there is no value.
struct FitResiduals {
    std::vector<std::vector<double>> residuals;
    std::vector<std::vector<double>> variance;
};

/// None where the mechanism has no motion at some row.
bool residualsOf(const FitProblem &problem, const Fit &fit, FitResiduals &result);

/// The matrix of the normal equations at a fit, free parameters in the order of enum Parameter, then the constants.
/// In long double: a condition number is squared in it.
using ExactFitMatrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;
ExactFitMatrix informationOf(const FitProblem &problem, const Fit &fit, const FreeParameters &isFree);

/// Σ r²/V at other parameters and constants (by the vector of the free ones), the variances being those at the fit.
double chiSquaredAt(const FitProblem &problem, const Fit &fit, const FreeParameters &isFree, const FitVector &step);

std::size_t freeCount(const FitProblem &problem, const FreeParameters &isFree);

/// A position in angle: known up to whole turns.
bool isTurning(Channel channel);

/// A difference of angles without them.
double withoutTurns(double radians);

} // namespace slidercrank
