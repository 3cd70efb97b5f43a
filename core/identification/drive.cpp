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

/// A polynomial of the time that was fitted to the angles of the crank.
struct Polynomial {
    Eigen::VectorXd coefficients;
    Eigen::VectorXd standardErrors;
    bool explainsAngles = false; ///< the residuals are rounding or noise
};

/// Fits the powers of the time with the exponents 0, 1, … to the angles, as many as `terms`. The unit of the time is
/// half the span of the file, so that all powers are between -1 and 1.
LinearFit fitPowers(const Observations &observations, const Values &angles, Index terms)
{
    Eigen::MatrixXd basis(angles.size(), terms);
    for (Index k = 0; k < terms; ++k) {
        basis.col(k) = (observations.time.values / (0.5 * observations.span())).pow(static_cast<double>(k));
    }
    return fitLinearly(basis, angles);
}

/// Whether the residuals of a polynomial with `terms` coefficients are errors of a sensor: small, different from row to
/// row, and not, in large part, a curve that a polynomial with two more terms describes.
bool areNoise(const Values &residuals, const Observations &observations, const Values &angles, Index terms)
{
    constexpr double kMaxNoise = 0.1; // rad (6°): larger deviations are not those of a sensor
    // Two more terms leave at least this fraction of the sum of squares of noise. Of a curve, they leave less.
    constexpr double kMinFraction = 0.5;
    constexpr double kMinProbability = 0.001; // that noise in few rows looks like a curve by chance
    if (residuals.abs().maxCoeff() > kMaxNoise || !changeSignLikeNoise(residuals) || !differLikeNoise(residuals)) {
        return false;
    }
    const LinearFit curved = fitPowers(observations, angles, terms + 2);
    const double fraction = curved.residuals.square().sum() / residuals.square().sum();
    // Two more terms reduce the sum of squares of n independent errors to a fraction q or less with the probability
    // q^((n - terms - 2) / 2) (the beta distribution).
    const double probability = std::pow(fraction, 0.5 * static_cast<double>(angles.size() - terms - 2));
    return fraction > kMinFraction || probability > kMinProbability;
}

/// Fits a polynomial with `terms` coefficients, the constant first. `halfStep`: half of the rounding step of the
/// angles, rad.
Polynomial fitPolynomial(const Observations &observations, const Values &angles, double halfStep, Index terms)
{
    constexpr double kMaxBounds = 2.5; // the largest error, in bounds of rounding: an encoder truncates
    const double halfSpan = 0.5 * observations.span();
    const LinearFit fit = fitPowers(observations, angles, terms);
    const Values errors = fit.residuals.abs();
    // Half a rounding step of the angle, the motion of the crank during half a step of the time, and the arithmetic of
    // the program that printed all digits of the angle (of 1 rad).
    const double bound =
        halfStep + std::abs(fit.coefficients[1]) / halfSpan * observations.time.halfStep + kArithmeticError;
    // As in the misfit (fit.h), not below the variance of rounding, even if a few residuals happen to be smaller. If
    // all errors are rounding, it counts twice, so that the standard errors become too large and not too small.
    const double variance = errors.square().mean() + bound * bound / 3.0;
    const double percentWithin = 100.0 * (errors <= bound).cast<double>().mean();
    const bool areRounding =
        percentWithin >= static_cast<double>(kMinPercentWithinBound) && errors.maxCoeff() < kMaxBounds * bound;
    Eigen::ArrayXd scale(terms); // turns the coefficients of powers of half spans into those of powers of the time
    for (Index k = 0; k < terms; ++k) {
        scale[k] = std::pow(halfSpan, -static_cast<double>(k));
    }
    return {.coefficients = fit.coefficients.array() * scale,
            .standardErrors = (variance * fit.variances).sqrt() * scale,
            .explainsAngles = areRounding || areNoise(fit.residuals, observations, angles, terms)};
}

/// The difference quotients from each row to the one `step` rows later.
Values computeSlopes(const Values &values, const Values &abscissa, Index step)
{
    const Index count = values.size() - step;
    return (values.tail(count) - values.head(count)) / (abscissa.tail(count) - abscissa.head(count));
}

/// The drive whose angle is a parabola of the time t of the observations, with the standard errors of angle and speed
/// at time 0 of the file, which is t = -timeOrigin.
Drive makeRunUp(const Polynomial &parabola, double timeOrigin)
{
    Drive drive{.kind = Drive::Kind::RunUp,
                .theta20 = parabola.coefficients[0],
                .omega2 = parabola.coefficients[1],
                .alpha2 = 2.0 * parabola.coefficients[2]};
    // The errors of the coefficients are taken as independent. As t is zero in the middle of the file, and the rows are
    // evenly spaced or nearly so, only those of the constant and of t² depend on each other. Their covariance is
    // negative: without it, the error of the angle becomes too large, and not too small.
    const Eigen::Vector3d errors = parabola.standardErrors;
    drive.speedErrorAtZero = std::hypot(errors[1], 2.0 * errors[2] * timeOrigin);
    drive.angleErrorAtZero = std::hypot(errors[0], errors[1] * timeOrigin, errors[2] * timeOrigin * timeOrigin);
    return drive;
}

} // namespace

Drive findDrive(const Observations &observations, const Model &model)
{
    constexpr Index kSlopeStep = 4; // rows: over five rows, the rounding of the angle hardly shows in the speed
    constexpr Index kLineTerms = 2;
    constexpr Index kParabolaTerms = 3;
    if (!observations.hasAngle()) {
        return {.kind = Drive::Kind::OverTime};
    }
    const bool hasSeveralSlopes = observations.size() >= kSlopeStep + 2; // a single one cannot show a change of speed
    if (!observations.hasTime() || !hasSeveralSlopes) {
        return {.kind = Drive::Kind::OverAngle};
    }
    const Values angles = model.angleFactor * observations.angle.values + model.mechanism.theta20;
    const double halfStep = std::abs(model.angleFactor) * observations.angle.halfStep;
    const Polynomial line = fitPolynomial(observations, angles, halfStep, kLineTerms);
    const Polynomial parabola = fitPolynomial(observations, angles, halfStep, kParabolaTerms);
    const Index fromFirstToLastRow = observations.size() - 1;
    const double meanSpeed = computeSlopes(angles, observations.time.values, fromFirstToLastRow)[0];
    Drive drive{.kind = Drive::Kind::Uneven, .omega2 = meanSpeed};
    if (line.explainsAngles) {
        drive = {.kind = Drive::Kind::Constant, .theta20 = line.coefficients[0], .omega2 = line.coefficients[1]};
    } else if (parabola.explainsAngles) {
        drive = makeRunUp(parabola, observations.timeOrigin);
    }
    const Values speeds = computeSlopes(angles, observations.time.values, kSlopeStep);
    drive.minSpeed = speeds.minCoeff();
    drive.maxSpeed = speeds.maxCoeff();
    return drive;
}

} // namespace slidercrank
