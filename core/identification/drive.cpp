// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/drive.h"

#include "core/identification/least_squares.h"
#include "core/identification/noise.h"

#include "core/comparison/comparison.h"
#include "core/mechanism/turn.h"

#include <algorithm>
#include <cmath>

namespace slidercrank
{

namespace
{

/// A polynomial of the time.
struct Polynomial {
    Eigen::VectorXd coefficients;
    Eigen::VectorXd standardErrors;
    bool isWithinRounding = false;
    bool isWithinNoise = false; ///< the residuals change their sign like noise, and are small
};

/// Fits a polynomial with some terms to the angles of the crank. `halfStep`: of the rounding of the angles, rad.
Polynomial fitPolynomial(const Observations &observations, const Values &angles, double halfStep, Index terms)
{
    constexpr double kMaxBounds = 2.5;   // of the largest error: an encoder truncates
    constexpr double kArithmetic = 1e-9; // rad: rounding errors of angles that are printed with all digits
    constexpr double kMaxNoise = 0.1;    // rad
    const double half = 0.5 * observations.span();
    Eigen::MatrixXd basis(angles.size(), terms);
    Eigen::ArrayXd scale(terms); // of the coefficients
    for (Index k = 0; k < terms; ++k) {
        basis.col(k) = (observations.time / half).pow(static_cast<double>(k));
        scale[k] = std::pow(half, -static_cast<double>(k));
    }
    const LinearFit line = fitLinearly(basis, angles);
    const Values &residuals = line.residuals;
    const Values errors = residuals.abs();
    const double bound = halfStep + std::abs(line.coefficients[1]) / half * observations.timeHalfStep + kArithmetic;
    const double variance = errors.square().mean() + bound * bound / 3.0;
    const double percentWithin = 100.0 * (errors <= bound).cast<double>().mean();
    return {.coefficients = line.coefficients.array() * scale,
            .standardErrors = (variance * line.variances).sqrt() * scale,
            .isWithinRounding =
                percentWithin >= static_cast<double>(kPercentWithinBound) && errors.maxCoeff() < kMaxBounds * bound,
            .isWithinNoise = changeSignLikeNoise(residuals) && errors.maxCoeff() < kMaxNoise};
}

} // namespace

Drive findDrive(const Observations &observations, const Model &model)
{
    constexpr Index kSlopeRows = 4; // between the two rows of a slope
    const Index slopes = observations.size() - kSlopeRows;
    if (observations.angle.size() == 0) {
        return {.kind = Drive::Kind::OverTime};
    }
    if (observations.time.size() == 0 || slopes < 2) {
        return {.kind = Drive::Kind::OverAngle};
    }
    const Values angles = model.angleFactor * observations.angle + model.mechanism.theta20;
    const double halfStep = std::abs(model.angleFactor) * observations.angleHalfStep;
    if (const Polynomial line = fitPolynomial(observations, angles, halfStep, 2);
        line.isWithinRounding || line.isWithinNoise) {
        return {.kind = Drive::Kind::Constant, .theta20 = line.coefficients[0], .omega2 = line.coefficients[1]};
    }
    const Values &time = observations.time;
    const Values speeds = (angles.tail(slopes) - angles.head(slopes)) / (time.tail(slopes) - time.head(slopes));
    Drive drive{.kind = Drive::Kind::Uneven, .least = speeds.minCoeff(), .greatest = speeds.maxCoeff()};
    if (const Polynomial parabola = fitPolynomial(observations, angles, halfStep, 3);
        parabola.isWithinRounding || parabola.isWithinNoise) {
        drive.kind = Drive::Kind::RunUp;
        drive.theta20 = parabola.coefficients[0];
        drive.omega2 = parabola.coefficients[1];
        drive.alpha2 = 2.0 * parabola.coefficients[2];
        // At t = 0 of the file, nearly: the errors of the three coefficients are taken as independent.
        const double t = observations.timeOrigin;
        const Eigen::Vector3d errors = parabola.standardErrors;
        drive.speedError = std::hypot(errors[1], 2.0 * errors[2] * t);
        drive.angleError = std::hypot(errors[0], errors[1] * t, errors[2] * t * t);
    } else {
        drive.omega2 = (angles[angles.size() - 1] - angles[0]) / (time[time.size() - 1] - time[0]);
    }
    return drive;
}

} // namespace slidercrank
