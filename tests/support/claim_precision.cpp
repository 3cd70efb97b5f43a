// SPDX-License-Identifier: GPL-3.0-or-later
// Computes how well a file of known origin determines its mechanism.
#include "core/mechanism/turn.h"
#include "tests/support/claim_judge.h"

#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace slidercrank
{

namespace
{

using Eigen::MatrixXd;
using Eigen::VectorXd;
using Content = ClaimColumn::Content;

constexpr Index kParameters = kParameterCount;

/// The values that a fit uses. About 80 rows represent the file. Time is counted from the middle of the file, so that
/// ω2 and θ20 are hardly correlated. The unknowns are the changes of the parameters, relative to their sizes, and of
/// the origins of the columns. a is fixed if the file has only angles, ω2 and θ20 if its rows are given by crank angle,
/// and origins that the file has not shifted.
struct LinearizedFit {
    Parameters truth;
    double middle; ///< s
    Index stride;  ///< rows of the file that a row represents
    Values times;  ///< since the middle
    std::vector<ClaimColumn> columns{};
    std::vector<Index> freeUnknowns{}; ///< indices of the unknowns: parameters, then origins
    Values weights{};                  ///< 1 / error of each value, one column after the other; 0 for unused values
    Values deviations{};               ///< systematic deviation of each value / its error
    double count = 0.0;                ///< number of used values
    double information = 0.0;          ///< sum of ln(spread / (√(2πe) error)) over the used values, in nats
    bool isClose = true;               ///< systematic deviations are below half a percent of the range

    explicit LinearizedFit(const ClaimTable &file)
        : truth(*file.truth)
        , middle(0.5 * (file.times[0] + file.times.tail(1)[0]))
        , stride(std::max<Index>(file.times.size() / 80, 1))
        , times(file.times(Eigen::seq(0, file.times.size() - 1, stride)) - middle)
    {
        truth.theta20 += middle * truth.omega2;
        bool hasLength = false;
        for (const ClaimColumn &column : file.columns) {
            if (column.content != Content::Foreign && canBeFitted(column.shown) &&
                !(file.isOverAngle && column.shown.coordinate == Theta2)) {
                addColumn(file, column);
                hasLength = hasLength || !isAngle(column.shown.coordinate);
            }
        }
        for (Index i = hasLength ? 0 : 1; i < (file.isOverAngle ? 3 : kParameters); ++i) {
            freeUnknowns.push_back(i);
        }
    }

    void addColumn(const ClaimTable &file, const ClaimColumn &column)
    {
        constexpr double kRelativeTolerance = 0.005;
        const auto represented = static_cast<double>(stride);
        const Values exact = column.factor * valuesOf(truth, column.shown, times - file.delay);
        const Values changeByTimeStep =
            column.factor * valuesOf(truth, column.shown, times - file.delay + file.timeStep()) - exact;
        const Values values = column.values(Eigen::seq(0, file.times.size() - 1, stride));
        const double range = 2.0 * file.swing(column.shown) * std::abs(column.factor);
        const Values steps = column.stepsAt(values).max(
            0.01 * column.stepAt(range)); // the step of a value near 0 may be arbitrarily small
        const Values errors =
            ((steps.square() + changeByTimeStep.square()) / 12.0 + column.noise * column.noise).sqrt();
        const Index first = weights.size();
        weights.conservativeResize(first + times.size());
        deviations.conservativeResize(weights.size());
        for (Index i = 0; i < times.size(); ++i) {
            const bool isUsed = std::isfinite(values[i] + errors[i]) && !file.badRows.contains(i * stride);
            weights[first + i] = isUsed ? std::sqrt(represented) / errors[i] : 0.0;
            const bool isSystematic = isUsed && column.content != Content::Motion;
            deviations[first + i] = isSystematic ? (values[i] - exact[i]) * weights[first + i] : 0.0;
            if (isUsed) {
                const double spread = std::max(0.35 * range, steps[i]);
                count += represented;
                information += represented * std::log(spread / (std::sqrt(kTurn * std::numbers::e) * errors[i]));
                isClose = isClose && (column.content == Content::Motion ||
                                      std::abs(values[i] - exact[i]) <= kRelativeTolerance * range + 4.0 * errors[i]);
            }
        }
        columns.push_back(column);
        if (column.hasOrigin) {
            freeUnknowns.push_back(kParameters + static_cast<Index>(columns.size()) - 1);
        }
    }

    /// Returns each value / its error after the unknowns have changed by `step`.
    VectorXd valuesFor(const VectorXd &step) const
    {
        const std::array sizes = parameterSizes(truth);
        Parameters p = truth;
        for (std::size_t i = 0; i < kParameterCount; ++i) {
            valueOf(p, static_cast<Parameter>(i)) += step[static_cast<Index>(i)] * sizes[i];
        }
        Values values(weights.size());
        for (std::size_t k = 0; k < columns.size(); ++k) {
            const auto at = static_cast<Index>(k);
            values.segment(at * times.size(), times.size()) =
                valuesOf(p, columns[k].shown, times) * columns[k].factor + step[kParameters + at];
        }
        return (weights > 0.0).select(values * weights, 0.0);
    }
};

/// Returns whether the standard errors of all parameters at t = 0 are below 1 %, and so are the errors that follow from
/// systematic deviations, and the linearization still holds three standard errors away.
bool isAccurate(const LinearizedFit &fit)
{
    constexpr double kStep = 1e-6;
    constexpr double kStandardErrors = 3.0;
    const Index unknowns = kParameters + static_cast<Index>(fit.columns.size());
    MatrixXd jacobian(fit.weights.size(), static_cast<Index>(fit.freeUnknowns.size()));
    for (Index j = 0; j < jacobian.cols(); ++j) {
        const VectorXd step = kStep * VectorXd::Unit(unknowns, fit.freeUnknowns[static_cast<std::size_t>(j)]);
        jacobian.col(j) = (fit.valuesFor(step) - fit.valuesFor(-step)) / (2.0 * kStep);
    }
    jacobian = jacobian.array().isFinite().select(jacobian, 0.0);
    const VectorXd scale = jacobian.colwise().norm().cwiseMax(1e-150).cwiseInverse();
    const MatrixXd scaled = jacobian * scale.asDiagonal();
    const Eigen::JacobiSVD<MatrixXd, Eigen::NoQRPreconditioner> svd(scaled.transpose().lazyProduct(scaled),
                                                                    Eigen::ComputeFullV);
    if (!(svd.singularValues().minCoeff() > 1e-14)) {
        return false;
    }
    const MatrixXd freeErrors =
        scale.asDiagonal() * svd.matrixV() * svd.singularValues().cwiseSqrt().cwiseInverse().asDiagonal();
    MatrixXd errors = MatrixXd::Zero(unknowns, jacobian.cols()); // a column for each singular vector
    for (Index j = 0; j < freeErrors.rows(); ++j) {
        errors.row(fit.freeUnknowns[static_cast<std::size_t>(j)]) = freeErrors.row(j);
    }
    const VectorXd values = fit.valuesFor(VectorXd::Zero(unknowns));
    for (Index k = 0; k < errors.cols(); ++k) {
        for (const double sign : {-kStandardErrors, kStandardErrors}) {
            const double growth =
                (fit.valuesFor(sign * errors.col(k)) - values).squaredNorm() / (kStandardErrors * kStandardErrors);
            if (!(growth > 0.5 && growth < 2.0)) {
                return false;
            }
        }
    }
    const VectorXd projections = freeErrors.transpose() * jacobian.transpose() * fit.deviations.matrix();
    errors.row(kParameters - 1) -= fit.middle * std::abs(fit.truth.omega2) * errors.row(kParameters - 2);
    return errors.topRows(kParameters).rowwise().norm().maxCoeff() < 0.01 &&
           (errors.topRows(kParameters) * projections).cwiseAbs().maxCoeff() < 0.01;
}

/// Returns whether the speed is unambiguous. Equally spaced positions alone fit several speeds; four rows a turn are
/// enough.
bool hasEnoughRowsPerTurn(const ClaimTable &file)
{
    const double turns = std::abs(file.truth->omega2) * (file.times.tail(1)[0] - file.times[0]) / kTurn;
    return static_cast<double>(file.times.size()) > 4.0 * turns ||
           std::ranges::any_of(file.columns, [](const ClaimColumn &column) {
               return column.shown.coordinate == Theta2 || column.shown.order != Order::Position;
           });
}

} // namespace

std::array<double, kParameterCount> parameterSizes(const Parameters &p)
{
    return {p.a, p.b, std::max(std::abs(p.c), p.a), std::abs(p.omega2), 1.0};
}

bool canBeFitted(Channel channel)
{
    return channel.coordinate == Theta3 || channel.coordinate == R4x || channel == Channel{R4y, Order::Position} ||
           (channel.coordinate == Theta2 && channel.order != Order::Acceleration);
}

bool determinesItsMechanism(const ClaimTable &file)
{
    constexpr double kMinEvidence = 40.0; // nats; more than the program requires
    const bool isNoisy = std::ranges::any_of(
        file.columns, [](double rms) { return rms > 0.0; }, &ClaimColumn::noise);
    const Index fewestRows = isNoisy ? 20 : 4; // noise has to be distinguished from misfit
    if (!file.truth || file.hasTooFewValues || file.isMissable || file.times.size() < fewestRows ||
        !hasEnoughRowsPerTurn(file)) {
        return false;
    }
    LinearizedFit fit(file);
    const auto unknowns = static_cast<double>(fit.freeUnknowns.size());
    return fit.isClose && fit.count >= 2.0 * unknowns &&
           (1.0 - unknowns / fit.count) * fit.information >= kMinEvidence && isAccurate(fit);
}

} // namespace slidercrank
