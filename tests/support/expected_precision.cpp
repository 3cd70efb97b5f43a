// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/expected_precision.h"

#include "core/mechanism/turn.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace slidercrank
{

namespace
{

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr std::size_t kMostRows = 80; // number of rows that represent the file

/// Least-squares fit linearized at the truth. Time is counted from the middle of the file, so that ω2 and θ20 are
/// hardly correlated.
class LinearizedFit
{
public:
    LinearizedFit(const ClaimFile &file, bool areAllOriginsFree)
        : m_file(file)
        , m_truth(*file.truth)
        , m_stride(std::max<std::size_t>(file.instants.size() / kMostRows, 1))
        , m_middle(0.5 * (file.instants.front() + file.instants.back()))
    {
        const long double angle = static_cast<long double>(m_truth.omega2) * m_middle + m_truth.theta20;
        m_truth.theta20 = static_cast<double>(std::remainder(angle, static_cast<long double>(kTurn)));
        m_sizes = parameterSizes(m_truth);
        bool hasLength = false;
        for (const ClaimColumn &column : file.columns) {
            const Channel shown = column.shown;
            const bool canBeFitted = shown.coordinate == Theta3 || shown.coordinate == R4x || shown == kY ||
                                     (shown.coordinate == Theta2 && shown.order != Order::Acceleration);
            const bool isMotion = column.content == ClaimColumn::Content::Motion ||
                                  (column.content == ClaimColumn::Content::Systematic && file.mayBeApproximate);
            if (isMotion && canBeFitted) {
                hasLength = hasLength || !isAngle(shown.coordinate);
                m_columns.push_back(&column);
                const bool isPosition = shown == kX || shown == kTheta;
                if (column.origin != 0.0 || (areAllOriginsFree && isPosition)) {
                    m_freeOrigins.push_back(m_columns.size() - 1);
                }
            }
        }
        if (hasLength) {
            m_unknowns = {Parameter::A};
        }
        m_unknowns.insert(m_unknowns.end(), {Parameter::B, Parameter::C});
        if (!file.byAngle) {
            m_unknowns.insert(m_unknowns.end(), {Parameter::Omega2, Parameter::Theta20});
        }
        addValues();
    }

    ExpectedPrecision result() const
    {
        ExpectedPrecision precision;
        const Index count = unknownCount();
        const auto stride = static_cast<double>(m_stride);
        precision.unknowns = static_cast<double>(count);
        precision.values = static_cast<double>(m_values.size()) * stride;
        MatrixXd normal = MatrixXd::Zero(count, count);
        double logs = 0.0;
        for (const Value &value : m_values) {
            normal += stride * value.gradient * value.gradient.transpose();
            logs += stride * value.log;
        }
        precision.evidence = (precision.values - precision.unknowns) / std::max(precision.values, 1.0) * logs;
        const VectorXd scale = normal.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
        const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(scale.asDiagonal() * normal * scale.asDiagonal());
        constexpr double kRoundedToZero = 1e-14;
        if (m_values.empty() || eigen.eigenvalues().minCoeff() < kRoundedToZero) {
            precision.relativeError.fill(std::numeric_limits<double>::infinity());
            return precision;
        }
        const MatrixXd vectors = scale.asDiagonal() * eigen.eigenvectors();
        const MatrixXd covariance = vectors * eigen.eigenvalues().cwiseInverse().asDiagonal() * vectors.transpose();
        for (std::size_t j = 0; j < m_unknowns.size(); ++j) {
            const auto at = static_cast<Index>(j);
            double variance = covariance(at, at);
            if (m_unknowns[j] == Parameter::Theta20) { // converted back to t = 0; the unknown before it is ω2
                const double lever = m_middle * std::abs(m_truth.omega2);
                variance += lever * lever * covariance(at - 1, at - 1) - 2.0 * lever * covariance(at, at - 1);
            }
            precision.relativeError[indexOf(m_unknowns[j])] = std::sqrt(std::max(variance, 0.0));
        }
        for (std::size_t j = 0; j < m_freeOrigins.size(); ++j) {
            const auto at = static_cast<Index>(m_unknowns.size() + j);
            precision.originErrors.emplace_back(m_columns[m_freeOrigins[j]]->named, std::sqrt(covariance(at, at)));
        }
        VectorXd moved = VectorXd::Zero(count);
        for (const Value &value : m_values) {
            moved += stride * value.deviation * value.gradient;
        }
        moved = covariance * moved;
        for (const Value &value : m_values) {
            const double left = value.deviation - value.gradient.dot(moved);
            precision.unexplained += left * left / static_cast<double>(m_values.size());
        }
        precision.unexplained = std::sqrt(precision.unexplained);
        precision.fitted = m_truth;
        for (std::size_t j = 0; j < m_unknowns.size(); ++j) {
            valueOf(precision.fitted, m_unknowns[j]) += moved[static_cast<Index>(j)] * m_sizes[indexOf(m_unknowns[j])];
        }
        precision.fitted.theta20 -= precision.fitted.omega2 * m_middle;
        precision.originSteps.assign(moved.begin() + static_cast<Index>(m_unknowns.size()), moved.end());
        constexpr double kErrors = 3.0;
        for (Index k = 0; k < count; ++k) {
            const VectorXd step = kErrors / std::sqrt(eigen.eigenvalues()[k]) * vectors.col(k);
            for (const double sign : {-1.0, 1.0}) {
                const double growth = growthOfChiSquared(sign * step) / (kErrors * kErrors);
                precision.isBent = precision.isBent || !(growth > 0.5 && growth < 2.0);
            }
        }
        return precision;
    }

private:
    struct Value {
        std::size_t row;
        std::size_t column;
        long double exact; ///< without factor and origin
        double error;
        double log;        ///< logarithm of spread / error
        double deviation;  ///< from the exact motion, in errors; 0 in a column without systematic deviations
        VectorXd gradient; ///< by the scaled unknowns, then by the free origins, in errors
    };

    Index unknownCount() const { return static_cast<Index>(m_unknowns.size() + m_freeOrigins.size()); }

    /// Returns the pose of the mechanism whose parameters differ from the truth by `step`, in parameter sizes.
    Pose pose(std::size_t row, const VectorXd &step, long double late = 0.0L) const
    {
        Parameters p = m_truth;
        for (std::size_t j = 0; j < m_unknowns.size(); ++j) {
            valueOf(p, m_unknowns[j]) += step[static_cast<Index>(j)] * m_sizes[indexOf(m_unknowns[j])];
        }
        return motionAt(p, static_cast<long double>(m_file.instants[row]) - m_middle + late);
    }

    void addValues()
    {
        constexpr double kStep = 1e-6;
        const Index count = unknownCount();
        const long double late = kStep / std::abs(m_truth.omega2);
        for (std::size_t row = 0; row < m_file.instants.size(); row += m_stride) {
            const VectorXd zero = VectorXd::Zero(count);
            std::vector<std::array<Pose, 2>> moved;
            for (std::size_t j = 0; j < m_unknowns.size(); ++j) {
                const VectorXd step = kStep * VectorXd::Unit(count, static_cast<Index>(j));
                moved.push_back({pose(row, -step), pose(row, step)});
            }
            const Pose here = pose(row, zero);
            const Pose before = pose(row, zero, -late);
            const Pose after = pose(row, zero, late);
            for (std::size_t k = 0; k < m_columns.size() && !m_file.badRows.contains(row); ++k) {
                const ClaimColumn &column = *m_columns[k];
                if (!std::isfinite(column.values[row])) {
                    continue;
                }
                const std::size_t channel = indexOf(column.shown);
                const double step = std::max(column.form.stepAt(column.values[row]), 0.01 * largestStep(column));
                const double rate =
                    column.factor * static_cast<double>((after[channel] - before[channel]) / (2.0L * late));
                const double blur = std::isfinite(rate) ? rate * m_file.timeStep : 0.0;
                const double error = std::sqrt((step * step + blur * blur) / 12.0 + column.noise * column.noise);
                VectorXd gradient = zero;
                for (std::size_t j = 0; j < m_unknowns.size(); ++j) {
                    const long double difference = moved[j][1][channel] - moved[j][0][channel];
                    gradient[static_cast<Index>(j)] =
                        column.factor * static_cast<double>(difference / (2.0L * kStep)) / error;
                }
                for (std::size_t j = 0; j < m_freeOrigins.size(); ++j) {
                    gradient[static_cast<Index>(m_unknowns.size() + j)] = m_freeOrigins[j] == k ? 1.0 / error : 0.0;
                }
                if (gradient.allFinite()) {
                    const double log =
                        std::log(std::max(spread(column), step) / (std::sqrt(kTurn * std::numbers::e) * error));
                    const double exact = column.factor * static_cast<double>(here[channel]) + column.origin;
                    const bool isExact = column.content == ClaimColumn::Content::Motion;
                    const double deviation = isExact ? 0.0 : (column.values[row] - exact) / error;
                    m_values.push_back({row, k, here[channel], error, log, deviation, gradient});
                }
            }
        }
    }

    /// Returns the largest rounding step of a column, because the step of a single value close to zero is too small.
    static double largestStep(const ClaimColumn &column)
    {
        double largest = 0.0;
        for (const double value : column.values) {
            largest = std::isfinite(value) ? std::max(largest, column.form.stepAt(value)) : largest;
        }
        return largest;
    }

    static double spread(const ClaimColumn &column)
    {
        std::vector<double> values;
        std::ranges::copy_if(column.values, std::back_inserter(values),
                             [](double value) { return std::isfinite(value); });
        const Eigen::Map<const Eigen::ArrayXd> all(values.data(), static_cast<Index>(values.size()));
        return std::sqrt((all - all.mean()).square().mean());
    }

    double growthOfChiSquared(const VectorXd &step) const
    {
        if (m_truth.a + (m_unknowns[0] == Parameter::A ? step[0] * m_sizes[0] : 0.0) <= 0.0) {
            return std::numeric_limits<double>::infinity();
        }
        double growth = 0.0;
        std::size_t row = m_file.instants.size();
        Pose moved{};
        for (const Value &value : m_values) {
            if (value.row != row) {
                row = value.row;
                moved = pose(row, step);
            }
            const ClaimColumn &column = *m_columns[value.column];
            double difference = column.factor * static_cast<double>(moved[indexOf(column.shown)] - value.exact);
            for (std::size_t j = 0; j < m_freeOrigins.size(); ++j) {
                difference += m_freeOrigins[j] == value.column ? step[static_cast<Index>(m_unknowns.size() + j)] : 0.0;
            }
            growth += difference * difference / (value.error * value.error);
        }
        return static_cast<double>(m_stride) * growth;
    }

    const ClaimFile &m_file;
    Parameters m_truth; ///< θ20 is the angle in the middle of the file
    const std::size_t m_stride;
    const double m_middle;
    std::array<double, kParameterCount> m_sizes{};
    std::vector<const ClaimColumn *> m_columns;
    std::vector<std::size_t> m_freeOrigins; ///< columns
    std::vector<Parameter> m_unknowns;
    std::vector<Value> m_values;
};

/// Returns whether the speed is unambiguous. Equally spaced positions alone fit several speeds; four rows a turn are
/// enough.
bool hasEnoughRowsATurn(const ClaimFile &file)
{
    constexpr double kRowsATurn = 4.0;
    const auto tells = [](const ClaimColumn &column) {
        return column.shown.coordinate == Theta2 || column.shown.order != Order::Position;
    };
    const double turns = std::abs(file.truth->omega2) * (file.instants.back() - file.instants.front()) / kTurn;
    return std::ranges::any_of(file.columns, tells) || static_cast<double>(file.instants.size()) > kRowsATurn * turns;
}

} // namespace

std::array<double, kParameterCount> parameterSizes(const Parameters &p)
{
    return {p.a, p.b, std::max(std::abs(p.c), p.a), std::abs(p.omega2), 1.0};
}

ExpectedPrecision expectedPrecision(const ClaimFile &file, bool areAllOriginsFree)
{
    return LinearizedFit(file, areAllOriginsFree).result();
}

bool areDeviationsVisible(const ClaimFile &file)
{
    constexpr double kVisible = 1.5;
    const auto isSystematic = [](const ClaimColumn &column) {
        return column.content == ClaimColumn::Content::Systematic;
    };
    if (!file.truth || std::ranges::none_of(file.columns, isSystematic)) {
        return true;
    }
    ClaimFile fitted = file;
    fitted.truth = file.interpretations.back().mechanism;
    double unexplained = 0.0;
    for (int round = 0; round < 4; ++round) {
        const ExpectedPrecision precision = expectedPrecision(fitted, true);
        unexplained = precision.unexplained;
        for (std::size_t j = 0; j < precision.originSteps.size(); ++j) {
            fitted.at(precision.originErrors[j].first).origin += precision.originSteps[j];
        }
        if (precision.originSteps.empty() || findFault(precision.fitted)) {
            break;
        }
        fitted.truth = precision.fitted;
    }
    return unexplained > kVisible;
}

bool determinesItsMechanism(const ClaimFile &file)
{
    constexpr double kLargestError = 0.01;
    constexpr double kLeastEvidence = 40.0;      // more than the program requires
    constexpr std::size_t kFewestNoisyRows = 20; // needed to distinguish noise from misfit
    if (!file.truth || file.hasTooFewValues || file.mayBeMissed || file.instants.size() < 4 ||
        !hasEnoughRowsATurn(file)) {
        return false;
    }
    const bool isNoisy =
        std::ranges::any_of(file.columns, [](const ClaimColumn &column) { return column.noise > 0.0; });
    const ExpectedPrecision precision = expectedPrecision(file);
    return std::ranges::all_of(precision.relativeError, [](double error) { return error < kLargestError; }) &&
           precision.values >= 2.0 * precision.unknowns && precision.evidence >= kLeastEvidence && !precision.isBent &&
           (!isNoisy || file.instants.size() >= kFewestNoisyRows);
}

} // namespace slidercrank
