// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/what_is_fixed.h"

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

/// So many rows stand for all.
constexpr std::size_t kRows = 80;

bool canBeFitted(Channel channel)
{
    return channel.coordinate == Theta3 || channel.coordinate == R4x ||
           (channel.coordinate == Theta2 && channel.order != Order::Acceleration) ||
           channel == Channel{R4y, Order::Position};
}

class LinearizedFit
{
public:
    explicit LinearizedFit(const ClaimFile &file)
        : m_file(file)
        , m_truth(*file.truth)
        , m_sizes(partSizes(m_truth))
        , m_stride(std::max<std::size_t>(file.instants.size() / kRows, 1))
        , m_middle(0.5 * (file.instants.front() + file.instants.back()))
    {
        bool hasLength = false;
        for (const ClaimColumn &each : file.columns) {
            if (each.isMotion && canBeFitted(each.shown)) {
                m_columns.push_back(&each);
                m_leastSteps.push_back(leastStepOf(each));
                hasLength = hasLength || !isAngle(each.shown.coordinate);
                if (each.zero != 0.0) {
                    m_zeros.push_back(m_columns.size() - 1);
                }
            }
        }
        m_unknowns = {Parameter::B, Parameter::C, Parameter::Omega2, Parameter::Theta20};
        if (hasLength) {
            m_unknowns.insert(m_unknowns.begin(), Parameter::A);
        }
        for (std::size_t row = 0; row < file.instants.size(); row += m_stride) {
            addRow(row);
        }
    }

    WhatIsFixed result() const
    {
        WhatIsFixed fixed;
        const auto count = static_cast<Index>(m_unknowns.size() + m_zeros.size());
        fixed.unknowns = static_cast<double>(count);
        fixed.values = static_cast<double>(m_gradients.size() * m_stride);
        fixed.part.fill(0.0);

        MatrixXd normal = MatrixXd::Zero(count, count);
        for (const VectorXd &gradient : m_gradients) {
            normal += static_cast<double>(m_stride) * gradient * gradient.transpose();
        }
        const VectorXd scale = normal.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
        const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(scale.asDiagonal() * normal * scale.asDiagonal());
        constexpr double kRounded = 1e-14;
        if (eigen.eigenvalues().minCoeff() < kRounded) {
            fixed.part.fill(std::numeric_limits<double>::infinity());
            return fixed;
        }
        const MatrixXd inverse =
            eigen.eigenvectors() * eigen.eigenvalues().cwiseInverse().asDiagonal() * eigen.eigenvectors().transpose();
        const MatrixXd covariance = scale.asDiagonal() * inverse * scale.asDiagonal();
        for (std::size_t j = 0; j < m_unknowns.size(); ++j) {
            const auto at = static_cast<Index>(j);
            double variance = covariance(at, at);
            if (m_unknowns[j] == Parameter::Theta20) { // back to t = 0; before it stands ω
                const double lever = m_middle * std::abs(m_truth.omega2);
                variance += lever * lever * covariance(at - 1, at - 1) - 2.0 * lever * covariance(at, at - 1);
            }
            fixed.part[indexOf(m_unknowns[j])] = std::sqrt(std::max(variance, 0.0));
        }
        for (std::size_t j = 0; j < m_zeros.size(); ++j) {
            const auto at = static_cast<Index>(m_unknowns.size() + j);
            fixed.zeroErrors.emplace_back(m_columns[m_zeros[j]]->named, std::sqrt(covariance(at, at)));
        }
        fixed.evidence =
            (fixed.values - fixed.unknowns) / std::max(fixed.values, 1.0) * m_logs * static_cast<double>(m_stride);
        for (Index k = 0; k < count && !fixed.isBent; ++k) {
            constexpr double kErrors = 3.0;
            const VectorXd step =
                kErrors / std::sqrt(eigen.eigenvalues()[k]) * scale.cwiseProduct(eigen.eigenvectors().col(k));
            for (const double sign : {-1.0, 1.0}) {
                const double growth = growthBy(sign * step) / (kErrors * kErrors);
                fixed.isBent = fixed.isBent || !(growth > 0.5 && growth < 2.0);
            }
        }
        return fixed;
    }

private:
    /// The mechanism so many sizes away; θ20 in the middle of the file, lest it goes with ω.
    Parameters moved(const VectorXd &step) const
    {
        Parameters p = m_truth;
        for (std::size_t j = 0; j < m_unknowns.size(); ++j) {
            valueOf(p, m_unknowns[j]) += step[static_cast<Index>(j)] * m_sizes[indexOf(m_unknowns[j])];
        }
        p.theta20 -= (p.omega2 - m_truth.omega2) * m_middle;
        return p;
    }

    void addRow(std::size_t row)
    {
        const double t = m_file.instants[row];
        const double late = 1e-6 / std::abs(m_truth.omega2);
        const AllChannels before = motionAt(m_truth, t - late);
        const AllChannels after = motionAt(m_truth, t + late);
        const AllChannels here = motionAt(m_truth, t);
        std::vector<AllChannels> derivatives(m_unknowns.size());
        for (std::size_t j = 0; j < m_unknowns.size(); ++j) {
            if (m_unknowns[j] == Parameter::Omega2 || m_unknowns[j] == Parameter::Theta20) {
                for (std::size_t k = 0; k < kChannelCount; ++k) { // ω^n g(ω (t - middle) + θ20)
                    const long double byTime = (after[k] - before[k]) / (2.0L * late);
                    const long double byOmega =
                        (static_cast<long double>(channelAt(k).order) * here[k] + (t - m_middle) * byTime) /
                        m_truth.omega2;
                    derivatives[j][k] = m_unknowns[j] == Parameter::Omega2 ? byOmega * std::abs(m_truth.omega2)
                                                                           : byTime / m_truth.omega2;
                }
                continue;
            }
            constexpr long double kStep = 1e-7L;
            VectorXd step = VectorXd::Zero(static_cast<Index>(m_unknowns.size()));
            step[static_cast<Index>(j)] = static_cast<double>(kStep);
            const AllChannels less = motionAt(moved(-step), t);
            const AllChannels more = motionAt(moved(step), t);
            for (std::size_t k = 0; k < kChannelCount; ++k) {
                derivatives[j][k] = (more[k] - less[k]) / (2.0L * kStep);
            }
        }
        for (std::size_t k = 0; k < m_columns.size(); ++k) {
            const ClaimColumn &each = *m_columns[k];
            if (!std::isfinite(each.values[row])) {
                continue;
            }
            const std::size_t channel = indexOf(each.shown);
            const double step = std::max(each.form.stepAt(each.values[row]), m_leastSteps[k]);
            const double rate = each.factor * static_cast<double>((after[channel] - before[channel]) / (2.0L * late));
            const double blur = std::isfinite(rate) ? rate * m_file.timeStep : 0.0;
            const double error = std::sqrt((step * step + blur * blur) / 12.0 + each.noise * each.noise);
            VectorXd gradient = VectorXd::Zero(static_cast<Index>(m_unknowns.size() + m_zeros.size()));
            for (std::size_t j = 0; j < m_unknowns.size(); ++j) {
                gradient[static_cast<Index>(j)] = each.factor * static_cast<double>(derivatives[j][channel]) / error;
            }
            for (std::size_t j = 0; j < m_zeros.size(); ++j) {
                gradient[static_cast<Index>(m_unknowns.size() + j)] = m_zeros[j] == k ? 1.0 / error : 0.0;
            }
            if (gradient.allFinite()) {
                m_gradients.push_back(gradient);
                m_values.push_back({row, k, here[channel], error});
                const double spread = std::max(spreadOf(each), step);
                m_logs += std::log(spread / (std::sqrt(kTurn * std::numbers::e) * error));
            }
        }
    }

    /// A value that happens to be next to nothing must not decide alone.
    static double leastStepOf(const ClaimColumn &column)
    {
        constexpr double kPart = 0.01;
        double largest = 0.0;
        for (const double value : column.values) {
            largest = std::isfinite(value) ? std::max(largest, column.form.stepAt(value)) : largest;
        }
        return kPart * largest;
    }

    static double spreadOf(const ClaimColumn &column)
    {
        double sum = 0.0;
        double squares = 0.0;
        double count = 0.0;
        for (const double value : column.values) {
            if (std::isfinite(value)) {
                sum += value;
                squares += value * value;
                count += 1.0;
            }
        }
        return std::sqrt(std::max(squares / count - sum / count * sum / count, 0.0));
    }

    /// What chi² grows by.
    double growthBy(const VectorXd &step) const
    {
        const Parameters p = moved(step);
        if (!(p.a > 0.0) || !(p.b > 0.0)) {
            return std::numeric_limits<double>::infinity();
        }
        double growth = 0.0;
        std::size_t row = m_file.instants.size();
        AllChannels all{};
        for (const Value &value : m_values) {
            if (value.row != row) {
                row = value.row;
                all = motionAt(p, m_file.instants[row]);
            }
            const ClaimColumn &each = *m_columns[value.column];
            double off = each.factor * static_cast<double>(all[indexOf(each.shown)] - value.exact);
            for (std::size_t j = 0; j < m_zeros.size(); ++j) {
                off += m_zeros[j] == value.column ? step[static_cast<Index>(m_unknowns.size() + j)] : 0.0;
            }
            growth += off * off / (value.error * value.error);
        }
        return static_cast<double>(m_stride) * growth;
    }

    struct Value {
        std::size_t row;
        std::size_t column;
        long double exact; ///< of the motion, without factor and zero
        double error;
    };

    const ClaimFile &m_file;
    const Parameters m_truth;
    const std::array<double, kParameterCount> m_sizes;
    const std::size_t m_stride;
    const double m_middle;
    std::vector<const ClaimColumn *> m_columns;
    std::vector<double> m_leastSteps; ///< of each column
    std::vector<std::size_t> m_zeros; ///< columns whose zero is free
    std::vector<Parameter> m_unknowns;
    std::vector<VectorXd> m_gradients; ///< by unknown in its size, and by zero, in errors
    std::vector<Value> m_values;
    double m_logs = 0.0;
};

/// Positions alone at even instants meet other speeds as well; four rows a turn are taken to be enough to tell.
bool hasEnoughRowsATurn(const ClaimFile &file)
{
    constexpr double kRowsATurn = 4.0;
    const auto tells = [](const ClaimColumn &each) {
        return each.shown.coordinate == Theta2 || each.shown.order != Order::Position;
    };
    const double turns = std::abs(file.truth->omega2) * (file.instants.back() - file.instants.front()) / kTurn;
    return std::ranges::any_of(file.columns, tells) || static_cast<double>(file.instants.size()) > kRowsATurn * turns;
}

} // namespace

std::array<double, kParameterCount> partSizes(const Parameters &p)
{
    return {p.a, p.b, std::max(std::abs(p.c), p.a), std::abs(p.omega2), 1.0};
}

WhatIsFixed whatIsFixed(const ClaimFile &file)
{
    return LinearizedFit(file).result();
}

bool fixesTheMechanism(const ClaimFile &file)
{
    constexpr double kLargestPart = 0.01;
    constexpr double kLeastEvidence = 40.0;    // some more than the program asks for
    constexpr std::size_t kFewestOfNoise = 20; // rows, of which noise can be told from misfit
    if (!file.truth || file.tooFew || file.mayBeMissed || file.instants.size() < 4 || !hasEnoughRowsATurn(file)) {
        return false;
    }
    const bool isNoisy = std::ranges::any_of(file.columns, [](const ClaimColumn &each) { return each.noise > 0.0; });
    const WhatIsFixed fixed = whatIsFixed(file);
    return std::ranges::all_of(fixed.part, [](double part) { return part < kLargestPart; }) &&
           fixed.values >= 2.0 * fixed.unknowns && fixed.evidence >= kLeastEvidence && !fixed.isBent &&
           (!isNoisy || file.instants.size() >= kFewestOfNoise);
}

} // namespace slidercrank
