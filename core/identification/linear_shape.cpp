// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/linear_shape.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

namespace slidercrank
{

namespace
{

using std::numbers::pi;

/// A linear least-squares problem of a few unknowns.
class Equations
{
public:
    explicit Equations(Eigen::Index unknowns)
        : m_sums(unknowns, unknowns)
        , m_right(unknowns)
    {
        m_sums.setZero();
        m_right.setZero();
    }

    template <typename... Coefficients>
    void add(double right, Coefficients... coefficients)
    {
        const std::array<double, sizeof...(coefficients)> line{static_cast<double>(coefficients)...};
        for (std::size_t i = 0; i < line.size(); ++i) {
            m_right[static_cast<Eigen::Index>(i)] += line[i] * right;
            for (std::size_t j = 0; j <= i; ++j) {
                m_sums(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) += line[i] * line[j];
            }
        }
        m_squares += right * right;
        m_sum += right;
        ++m_count;
    }

    struct Solution {
        std::array<double, 7> x{};
        double left = std::numeric_limits<double>::infinity(); ///< of the squares about the mean
    };
    Solution solve() const
    {
        Matrix sums = m_sums.template selfadjointView<Eigen::Lower>();
        const Vector scale = sums.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
        sums = scale.asDiagonal() * sums * scale.asDiagonal();
        sums.diagonal().array() += 1e-13;
        const Vector right = scale.asDiagonal() * m_right;
        const Vector scaled = sums.ldlt().solve(right);
        Solution solution;
        for (Eigen::Index i = 0; i < scaled.size(); ++i) {
            solution.x[static_cast<std::size_t>(i)] = scaled[i] * scale[i];
        }
        const double centred = m_squares - m_sum * m_sum / static_cast<double>(m_count);
        solution.left = std::max(m_squares - right.dot(scaled), 0.0) / std::max(centred, 1e-300);
        return solution;
    }

private:
    using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 7, 7>;
    using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 7, 1>;
    Matrix m_sums;
    Vector m_right;
    double m_squares = 0.0;
    double m_sum = 0.0;
    std::size_t m_count = 0;
};

Shape shapeOfBoth(const Positions &positions, bool isTurned, bool isShifted)
{
    const Eigen::Index unknowns = 4 + (isTurned ? 1 : 0) + (isShifted ? 1 : 0);
    Equations equations(unknowns);
    double cosines = 0.0;
    for (std::size_t i = 0; i < positions.phase.size(); ++i) {
        const double cosine = std::cos(positions.phase[i]);
        const double sine = std::sin(positions.phase[i]);
        const double cos3 = std::cos(positions.theta3[i]);
        const double sin3 = std::sin(positions.theta3[i]);
        const double x = positions.R4x[i];
        cosines += cos3;
        if (isTurned && isShifted) {
            equations.add(x, cos3, 0.0, cosine, -sine, sin3, 1.0);
            equations.add(0.0, sin3, -1.0, sine, cosine, -cos3, 0.0);
        } else if (isTurned) {
            equations.add(x, cos3, 0.0, cosine, -sine, sin3);
            equations.add(0.0, sin3, -1.0, sine, cosine, -cos3);
        } else if (isShifted) {
            equations.add(x, cos3, 0.0, cosine, -sine, 1.0);
            equations.add(0.0, sin3, -1.0, sine, cosine, 0.0);
        } else {
            equations.add(x, cos3, 0.0, cosine, -sine);
            equations.add(0.0, sin3, -1.0, sine, cosine);
        }
    }
    const auto [x, left] = equations.solve();
    const double turned = isTurned ? std::atan2(x[4], x[0]) : x[0] < 0.0 ? pi : 0.0;
    return {{std::hypot(x[2], x[3]), isTurned ? std::hypot(x[0], x[4]) : std::abs(x[0]), x[1], 0.0,
             std::atan2(x[3], x[2]), (cosines >= 0.0) == (std::cos(turned) >= 0.0) ? Branch::Open : Branch::Crossed},
            left};
}

Shape shapeOfTheta3(const Positions &positions, bool isTurned, double size)
{
    const double centre = isTurned ? std::accumulate(positions.theta3.begin(), positions.theta3.end(), 0.0) /
                                         static_cast<double>(positions.theta3.size())
                                   : 0.0;
    Equations equations(isTurned ? 4 : 3);
    double cosines = 0.0;
    for (std::size_t i = 0; i < positions.phase.size(); ++i) {
        const double cosine = std::cos(positions.phase[i]);
        const double sine = std::sin(positions.phase[i]);
        const double sin3 = std::sin(positions.theta3[i] - centre);
        const double cos3 = std::cos(positions.theta3[i] - centre);
        cosines += cos3;
        if (isTurned) {
            equations.add(sin3, 1.0, -sine, -cosine, cos3);
        } else {
            equations.add(sin3, 1.0, -sine, -cosine);
        }
    }
    const auto [x, left] = equations.solve();
    const double cosZ = isTurned ? 1.0 / std::sqrt(1.0 + x[3] * x[3]) : 1.0;
    const double ratio = std::max(std::hypot(x[1], x[2]) * cosZ, 1e-9); // a / b
    return {{size, size / ratio, size * x[0] * cosZ / ratio, 0.0, std::atan2(x[2], x[1]),
             isTurned || cosines >= 0.0 ? Branch::Open : Branch::Crossed},
            left};
}

Shape shapeOfR4x(const Positions &positions, bool isShifted)
{
    const double m =
        std::accumulate(positions.R4x.begin(), positions.R4x.end(), 0.0) / static_cast<double>(positions.R4x.size());
    Equations equations(isShifted ? 6 : 5);
    for (std::size_t i = 0; i < positions.phase.size(); ++i) {
        const double cosine = std::cos(positions.phase[i]);
        const double sine = std::sin(positions.phase[i]);
        const double r = positions.R4x[i] - m;
        if (isShifted) {
            equations.add(r * r, r * cosine, -r * sine, cosine, sine, 1.0, -2.0 * r);
        } else {
            equations.add(r * (r + 2.0 * m), r * cosine, -r * sine, cosine, sine, 1.0);
        }
    }
    const auto [x, left] = equations.solve();
    const double R = isShifted ? x[5] : m;
    const double square = std::max(x[0] * x[0] + x[1] * x[1], 1e-18); // of twice the crank
    const double a = 0.5 * std::sqrt(square);
    const double c = (x[1] * x[2] + x[0] * x[3]) / square;
    const double b = std::sqrt(std::max(x[4] + R * R + a * a + c * c, 0.0));
    return {{a, b, c, 0.0, std::atan2(x[1], x[0]), R >= 0.0 ? Branch::Open : Branch::Crossed}, left};
}

} // namespace

std::vector<Route> routesFor(const Positions &positions, double size)
{
    const bool hasTheta3 = !positions.theta3.empty();
    const bool hasR4x = !positions.R4x.empty();
    std::vector<Route> routes;
    for (const bool isTurned : {false, true}) {
        for (const bool isShifted : {false, true}) {
            const bool isTheta3Known = isTurned || positions.isTheta3Whole;
            const bool isR4xKnown = isShifted || positions.isR4xWhole;
            if (hasTheta3 && hasR4x && isTheta3Known && isR4xKnown) {
                routes.push_back({[=](const Positions &some) { return shapeOfBoth(some, isTurned, isShifted); }});
            }
            if (hasR4x && isR4xKnown && !isTurned) {
                routes.push_back({[=](const Positions &some) { return shapeOfR4x(some, isShifted); }});
            }
            if (hasTheta3 && isTheta3Known && !isShifted) {
                routes.push_back({[=](const Positions &some) { return shapeOfTheta3(some, isTurned, size); }, true});
            }
        }
    }
    return routes;
}

} // namespace slidercrank
