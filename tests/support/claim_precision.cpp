// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/claim_precision.h"

#include "core/import/reference_data.h"
#include "core/mechanism/turn.h"

#include <Eigen/Dense>

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

/// Least-squares fit linearized at the truth. The unknowns are the parameters, relative to their sizes, and the origins
/// of the columns. a is fixed if the file has only angles, ω2 and θ20 if its rows are given by crank angle, and origins
/// that the file has not shifted. Time is counted from the middle of the file, so that ω2 and θ20 are hardly
/// correlated. About 80 rows represent the file.
class LinearizedFit
{
public:
    /// Requires a truth and computed values.
    LinearizedFit(const ClaimFile &file, bool areAllOriginsFree)
        : m_middle(0.5 * (file.instants[0] + file.instants.tail(1)[0]))
        , m_centred(*file.truth)
    {
        m_centred.theta20 += m_middle * m_centred.omega2;
        bool hasLength = false;
        for (const ClaimColumn &column : file.columns) {
            const bool isMotion =
                column.content == Content::Motion || (column.content == Content::Systematic && file.mayBeApproximate);
            if (isMotion && canBeFitted(column.shown)) {
                hasLength = hasLength || !isAngle(column.shown.coordinate);
                m_columns.push_back(column);
                if (column.origin != 0.0 || (areAllOriginsFree && (column.shown == kX || column.shown == kTheta))) {
                    m_free.push_back(kParameters + static_cast<Index>(m_columns.size()) - 1);
                }
            }
        }
        for (Index i = hasLength ? 0 : 1; i < (file.isByAngle ? 3 : kParameters); ++i) {
            m_free.push_back(i);
        }
        linearize(file);
    }

    bool isSingular() const { return m_valueCount == 0.0 || !(m_eigenvalues.minCoeff() > 1e-14); }

    /// Returns whether the errors of all parameters at t = 0 are below 1 %, the evidence against a fit by chance is
    /// sufficient, and the linearization still holds three standard errors away.
    bool determinesAll() const
    {
        constexpr double kLeastEvidence = 40.0; // nats; more than the program requires
        constexpr double kErrors = 3.0;
        const auto unknowns = static_cast<double>(m_free.size());
        if (isSingular() || m_valueCount < 2.0 * unknowns ||
            (1.0 - unknowns / m_valueCount) * m_information.sum() < kLeastEvidence) {
            return false;
        }
        for (Index k = 0; k < m_eigenvalues.size(); ++k) {
            for (const double errors : {-kErrors, kErrors}) {
                const VectorXd step = errors / std::sqrt(m_eigenvalues[k]) * m_vectors.col(k);
                const double growth = deviations(step).squaredNorm() / (kErrors * kErrors);
                if (!(growth > 0.5 && growth < 2.0)) {
                    return false;
                }
            }
        }
        MatrixXd toStart = MatrixXd::Identity(m_covariance.rows(), m_covariance.cols());
        toStart(kParameters - 1, kParameters - 2) = -m_middle * std::abs(m_centred.omega2);
        return (toStart * m_covariance * toStart.transpose()).diagonal().head(kParameters).maxCoeff() < 0.01 * 0.01;
    }

    double originError(Channel channel) const
    {
        const auto at = std::ranges::find(m_columns, channel, &ClaimColumn::named) - m_columns.begin() + kParameters;
        return isSingular() || at == m_covariance.rows() ? 0.0 : std::sqrt(m_covariance(at, at));
    }

    /// Moves the truth and the origins of the file of this fit to those that fit best. Returns the rms of the
    /// systematic deviations that then remain, in errors.
    double improve(ClaimFile &file) const
    {
        const VectorXd step = m_covariance * m_jacobian.transpose() * m_systematic;
        file.truth = moved(step);
        file.truth->theta20 -= file.truth->omega2 * m_middle;
        for (std::size_t k = 0; k < m_columns.size(); ++k) {
            file.at(m_columns[k].named).origin += step[kParameters + static_cast<Index>(k)];
        }
        return std::sqrt((m_systematic - m_jacobian * step).squaredNorm() / m_valueCount);
    }

private:
    Parameters moved(const VectorXd &step) const
    {
        const std::array sizes = parameterSizes(m_centred);
        Parameters p = m_centred;
        for (std::size_t i = 0; i < kParameterCount; ++i) {
            valueOf(p, static_cast<Parameter>(i)) += step[static_cast<Index>(i)] * sizes[i];
        }
        return p;
    }

    /// Returns the change of all values, in errors, if the unknowns change by `step`.
    VectorXd deviations(const VectorXd &step) const
    {
        const Poses change = motionOf(moved(step), m_times) - m_motion;
        VectorXd result(m_weights.size());
        for (std::size_t k = 0; k < m_columns.size(); ++k) {
            const auto at = static_cast<Index>(k);
            result.segment(at * m_times.size(), m_times.size()) =
                change.col(columnOf(m_columns[k].shown)).cast<double>() * m_columns[k].factor + step[kParameters + at];
        }
        return (m_weights > 0.0).select(result.array() * m_weights, 0.0);
    }

    /// Sets the weights, which are 0 for values that are not used, and the systematic deviations.
    void weigh(const ClaimFile &file, Index stride)
    {
        const auto sampled = Eigen::seq(0, file.instants.size() - 1, stride);
        const Index rows = m_times.size();
        const Values half = Values::Constant(rows, 0.5 * file.timeStep);
        const Poses blur = motionOf(m_centred, m_times + half) - motionOf(m_centred, m_times - half);
        for (Index at = 0; const ClaimColumn &column : m_columns) {
            const Index k = columnOf(column.shown);
            const Values values = column.values(sampled);
            const ValueRange range = rangeOf({column.values.data(), static_cast<std::size_t>(column.values.size())});
            // The step of a single value that is close to zero is too small.
            const Values steps = column.form.stepsAt(values).max(0.01 * column.form.stepAt(range.size()));
            const Values late = column.factor * blur.col(k).cast<double>();
            const Values errors = ((steps.square() + late.square()) / 12.0 + column.noise * column.noise).sqrt();
            const Values exact = column.factor * m_motion.col(k).cast<double>() + column.origin;
            for (Index i = 0; i < rows; ++i, ++at) {
                if (std::isfinite(values[i] + errors[i]) && !file.badRows.contains(i * stride)) {
                    m_weights[at] = std::sqrt(static_cast<double>(stride)) / errors[i];
                    m_information[at] =
                        static_cast<double>(stride) * std::log(std::max(0.35 * range.width(), steps[i]) /
                                                               (std::sqrt(kTurn * std::numbers::e) * errors[i]));
                    m_systematic[at] =
                        column.content == Content::Systematic ? (values[i] - exact[i]) * m_weights[at] : 0.0;
                }
            }
        }
    }

    void linearize(const ClaimFile &file)
    {
        constexpr double kStep = 1e-6;
        const Index stride = std::max<Index>(file.instants.size() / 80, 1);
        m_times = file.instants(Eigen::seq(0, file.instants.size() - 1, stride)) - m_middle;
        m_motion = motionOf(m_centred, m_times);
        const auto columns = static_cast<Index>(m_columns.size());
        const Index values = m_times.size() * columns;
        m_weights = m_information = Values::Zero(values);
        m_systematic = VectorXd::Zero(values);
        weigh(file, stride);
        m_jacobian = MatrixXd::Zero(values, kParameters + columns);
        for (const Index j : m_free) {
            const VectorXd step = kStep * VectorXd::Unit(kParameters + columns, j);
            m_jacobian.col(j) = (deviations(step) - deviations(-step)) / (2.0 * kStep);
        }
        for (Index i = 0; i < values; ++i) {
            if (!m_jacobian.row(i).allFinite()) {
                m_jacobian.row(i).setZero();
                m_weights[i] = m_information[i] = m_systematic[i] = 0.0;
            }
        }
        m_valueCount = static_cast<double>(stride * (m_weights > 0.0).count());
        const MatrixXd normal = (m_jacobian.transpose() * m_jacobian)(m_free, m_free);
        const VectorXd scale = normal.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
        const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(scale.asDiagonal() * normal * scale.asDiagonal());
        m_eigenvalues = eigen.eigenvalues();
        m_vectors = MatrixXd::Zero(kParameters + columns, m_eigenvalues.size());
        m_vectors(m_free, Eigen::all) = scale.asDiagonal() * eigen.eigenvectors();
        m_covariance = m_vectors * m_eigenvalues.cwiseInverse().asDiagonal() * m_vectors.transpose();
    }

    static constexpr Index kParameters = kParameterCount;

    double m_middle;      ///< s
    Parameters m_centred; ///< the truth; θ20 is the angle in the middle of the file
    std::vector<ClaimColumn> m_columns;
    std::vector<Index> m_free; ///< indices of the unknowns: parameters, then origins
    Values m_times;            ///< since the middle
    Poses m_motion;
    // Of the values of all columns, one column after the other:
    Values m_weights;      ///< 1 / error, times the root of the number of rows that a value represents; 0: not used
    Values m_information;  ///< logarithms of spread / error
    VectorXd m_systematic; ///< weighted deviations from the exact motion
    MatrixXd m_jacobian;   ///< weighted
    double m_valueCount = 0.0;
    VectorXd m_eigenvalues;
    MatrixXd m_vectors;
    MatrixXd m_covariance;
};

/// Returns whether the speed is unambiguous. Equally spaced positions alone fit several speeds; four rows a turn are
/// enough.
bool hasEnoughRowsPerTurn(const ClaimFile &file)
{
    const double turns = std::abs(file.truth->omega2) * (file.instants.tail(1)[0] - file.instants[0]) / kTurn;
    return static_cast<double>(file.instants.size()) > 4.0 * turns ||
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
    return channel.coordinate == Theta3 || channel.coordinate == R4x || channel == kY ||
           (channel.coordinate == Theta2 && channel.order != Order::Acceleration);
}

double originError(const ClaimFile &file, Channel channel)
{
    return LinearizedFit(file, false).originError(channel);
}

bool areDeviationsVisible(const ClaimFile &file)
{
    constexpr double kVisible = 1.5;
    if (!file.truth || std::ranges::count(file.columns, Content::Systematic, &ClaimColumn::content) == 0) {
        return true;
    }
    ClaimFile fitted = file;
    fitted.truth = file.interpretations.back().mechanism;
    double remaining = 0.0;
    for (int round = 0; round < 4; ++round) {
        const LinearizedFit fit(fitted, true);
        if (fit.isSingular()) {
            break;
        }
        remaining = fit.improve(fitted);
    }
    return remaining > kVisible;
}

bool determinesItsMechanism(const ClaimFile &file)
{
    const bool isNoisy = std::ranges::any_of(
        file.columns, [](double rms) { return rms > 0.0; }, &ClaimColumn::noise);
    const Index fewestRows = isNoisy ? 20 : 4; // noise has to be distinguished from misfit
    return file.truth && !file.hasTooFewValues && !file.mayBeMissed && file.instants.size() >= fewestRows &&
           hasEnoughRowsPerTurn(file) && LinearizedFit(file, false).determinesAll();
}

} // namespace slidercrank
