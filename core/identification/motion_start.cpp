// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/motion_start.h"

#include "core/identification/candidate.h"

#include <Eigen/Cholesky>
#include <Eigen/QR>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>

namespace slidercrank
{

namespace
{

constexpr double kPi = std::numbers::pi;
constexpr double kUnbounded = std::numeric_limits<double>::infinity();

constexpr int kMostHarmonics = 6;
constexpr int kMostTerms = 1 + 2 * kMostHarmonics;

const FitColumn *columnOf(const FitProblem &problem, Channel channel)
{
    const auto found = std::ranges::find(problem.columns, channel, &FitColumn::channel);
    return found == problem.columns.end() ? nullptr : &*found;
}

// ---- the speed by harmonics ----------------------------------------------------------------------------------------

/// One coordinate as a constant and harmonics of W t: 1, cos, sin, cos 2, sin 2, …
struct Series {
    double speed = 0.0;
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

Family familyOf(const FitProblem &problem, Coordinate coordinate)
{
    Family family;
    for (const Order order : {Order::Position, Order::Velocity, Order::Acceleration}) {
        if (const FitColumn *column = columnOf(problem, {coordinate, order}); column && column->spread > 0.0) {
            family.columns.push_back(column);
            family.hasPosition = family.hasPosition || order == Order::Position;
        }
    }
    return family;
}

/// Least squares of a family at a speed; what is left as part of the columns' squares (each counting alike), times
/// their number.
double leftBy(const FitProblem &problem, const Family &family, double speed, int harmonics, Series *series)
{
    using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMostTerms, kMostTerms>;
    using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMostTerms, 1>;
    const Eigen::Index first = family.hasPosition ? 0 : 1;
    const Eigen::Index terms = 1 + 2 * harmonics - first;
    std::array<double, kMostTerms * kMostTerms> sums{};
    std::array<double, kMostTerms> right{};
    double squares = 0.0;
    double left = 0.0;
    for (std::size_t row = 0; row < problem.time.size(); ++row) {
        const double cosine = std::cos(speed * problem.time[row]);
        const double sine = std::sin(speed * problem.time[row]);
        std::array<double, kMostTerms> basis{};
        std::array<double, kMostTerms> turned{};
        basis[0] = 1.0;
        basis[1] = cosine;
        basis[2] = sine;
        for (int h = 2; h <= harmonics; ++h) {
            const auto i = static_cast<std::size_t>(2 * h - 1);
            basis[i] = basis[i - 2] * cosine - basis[i - 1] * sine;
            basis[i + 1] = basis[i - 1] * cosine + basis[i - 2] * sine;
        }
        for (const FitColumn *column : family.columns) {
            const double value = column->values[row];
            if (std::isnan(value)) {
                continue;
            }
            const int order = static_cast<int>(column->channel.order);
            const double weight = 1.0 / column->spread;
            turned[0] = order == 0 ? weight : 0.0;
            for (int h = 1; h <= harmonics; ++h) {
                const auto i = static_cast<std::size_t>(2 * h - 1);
                const double rate = h * speed;
                const double scale = weight * (order == 0 ? 1.0 : order == 1 ? rate : rate * rate);
                turned[i] = scale * (order == 0 ? basis[i] : order == 1 ? -basis[i + 1] : -basis[i]);
                turned[i + 1] = scale * (order == 0 ? basis[i + 1] : order == 1 ? basis[i] : -basis[i + 1]);
            }
            const double scaled = weight * value;
            squares += scaled * scaled;
            for (Eigen::Index i = first; i < 1 + 2 * harmonics; ++i) {
                const double one = turned[static_cast<std::size_t>(i)];
                right[static_cast<std::size_t>(i)] += one * scaled;
                double *const line = sums.data() + i * kMostTerms;
                for (Eigen::Index j = first; j <= i; ++j) {
                    line[j] += one * turned[static_cast<std::size_t>(j)];
                }
            }
        }
    }
    Matrix matrix(terms, terms);
    Vector vector(terms);
    for (Eigen::Index i = 0; i < terms; ++i) {
        vector[i] = right[static_cast<std::size_t>(i + first)];
        for (Eigen::Index j = 0; j <= i; ++j) {
            const double sum = sums[static_cast<std::size_t>((i + first) * kMostTerms + j + first)];
            matrix(i, j) = sum;
            matrix(j, i) = sum;
        }
    }
    // Over less than a turn the harmonics are nearly the same: no term may grow without bound.
    constexpr double kRidge = 1e-11;
    matrix.diagonal().array() += kRidge * matrix.diagonal().maxCoeff();
    const Vector solution = matrix.ldlt().solve(vector);
    left = squares - vector.dot(solution);
    if (series) {
        series->speed = speed;
        series->harmonics = harmonics;
        series->hasConstant = family.hasPosition;
        series->terms.setZero();
        series->terms.segment(first, terms) = solution;
    }
    return std::max(left, 0.0);
}

/// All coordinates that a motion is seen in.
std::vector<Family> familiesOf(const FitProblem &problem)
{
    std::vector<Family> families;
    for (const Coordinate coordinate : {Theta3, R4x, R3x, R3y, R2x, R2y}) {
        if (Family family = familyOf(problem, coordinate); !family.columns.empty()) {
            families.push_back(std::move(family));
        }
    }
    return families;
}

double rootMeanSquare(const FitColumn &column, bool lessMean)
{
    double sum = 0.0;
    double squares = 0.0;
    for (const double value : column.values) {
        if (!std::isnan(value)) {
            sum += value;
            squares += value * value;
        }
    }
    const auto n = static_cast<double>(column.count);
    return std::sqrt(std::max(squares / n - (lessMean ? sum * sum / (n * n) : 0.0), 0.0));
}

/// Where f is least between the two.
template <class Function>
double leastBetween(double low, double high, int steps, Function f)
{
    const double golden = 0.5 * (std::sqrt(5.0) - 1.0);
    double x = high - golden * (high - low);
    double y = low + golden * (high - low);
    double fx = f(x);
    double fy = f(y);
    for (int i = 0; i < steps; ++i) {
        if (fx < fy) {
            high = y;
            y = x;
            fy = fx;
            x = high - golden * (high - low);
            fx = f(x);
        } else {
            low = x;
            x = y;
            fx = fy;
            y = low + golden * (high - low);
            fy = f(y);
        }
    }
    return fx < fy ? x : y;
}

/// The lowest few local minima over ascending places, each refined.
template <class Function>
std::vector<double> minimaOver(const std::vector<double> &places, std::size_t most, int steps, Function f)
{
    std::vector<double> values;
    values.reserve(places.size());
    for (const double place : places) {
        values.push_back(f(place));
    }
    std::vector<std::size_t> minima;
    for (std::size_t i = 0; i < places.size(); ++i) {
        if ((i == 0 || values[i] <= values[i - 1]) && (i + 1 == places.size() || values[i] <= values[i + 1]) &&
            std::isfinite(values[i])) {
            minima.push_back(i);
        }
    }
    std::ranges::sort(minima, {}, [&](std::size_t i) { return values[i]; });
    minima.resize(std::min(minima.size(), most));
    std::vector<double> found;
    for (const std::size_t i : minima) {
        const double low = places[i == 0 ? i : i - 1];
        const double high = places[std::min(i + 1, places.size() - 1)];
        found.push_back(leastBetween(low, high, steps, f));
    }
    return found;
}

std::vector<double> speedsByHarmonics(const FitProblem &problem, const std::vector<Family> &families,
                                      const std::stop_token &stop)
{
    constexpr double kFewestTurns = 0.7;
    constexpr double kStep = 1.2; // of W times the whole time
    constexpr std::size_t kMostMinima = 4;
    constexpr int kRefinements = 14;
    const auto rows = static_cast<double>(problem.time.size());
    double low = 2.0 * kPi * kFewestTurns;
    double high = kPi * rows;
    // rms of a derivative over rms of its function, about its mean, is at least the speed.
    double ratio = kUnbounded;
    double largestRatio = 0.0;
    for (const Family &family : families) {
        for (std::size_t i = 0; i + 1 < family.columns.size(); ++i) {
            const FitColumn &function = *family.columns[i];
            const FitColumn &derivative = *family.columns[i + 1];
            if (static_cast<int>(derivative.channel.order) != static_cast<int>(function.channel.order) + 1) {
                continue;
            }
            const double one = rootMeanSquare(derivative, false) / rootMeanSquare(function, true);
            if (one > 0.0 && std::isfinite(one)) {
                ratio = std::min(ratio, one);
                largestRatio = std::max(largestRatio, one);
            }
        }
    }
    if (std::isfinite(ratio)) {
        constexpr double kFewRowsATurn = 5.0;
        const bool isSparse = 1.15 * ratio / (2.0 * kPi) * kFewRowsATurn > rows;
        high = std::min((isSparse ? 3.0 : 1.15) * ratio, 10.0 * kPi * rows);
        low = std::max(low, std::min(0.2 * largestRatio, 0.5 * high));
    }
    if (!(low < high)) {
        return {};
    }
    std::vector<double> places;
    for (double speed = low; speed < high + kStep; speed += kStep) {
        places.push_back(speed);
    }
    return minimaOver(places, kMostMinima, kRefinements, [&](double speed) {
        double left = 0.0;
        for (const Family &family : families) {
            left += stop.stop_requested() ? kUnbounded : leftBy(problem, family, speed, 2, nullptr);
        }
        return left;
    });
}

// ---- given the speed, the rest is linear ---------------------------------------------------------------------------

/// Positions at some instants; empty where there is none of the kind.
struct Positions {
    std::vector<double> phase; ///< W t
    std::vector<double> theta3;
    std::vector<double> R4x;
    bool isTheta3Whole = false; ///< its constant is in the file
    bool isR4xWhole = false;
};

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
        double left = kUnbounded; ///< of the squares about the mean
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

struct Shape {
    Parameters parameters; ///< the speed is not set
    double left = kUnbounded;
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
    const double turned = isTurned ? std::atan2(x[4], x[0]) : x[0] < 0.0 ? kPi : 0.0;
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

/// Every way in which the positions give a mechanism.
struct Route {
    std::function<Shape(const Positions &)> shape;
    bool isOfTheta3 = false; ///< only: then the crank may as well turn the other way
};

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

/// From six harmonics, at the phases of one turn.
Positions positionsOverATurn(const FitProblem &problem, double speed)
{
    constexpr int kPhases = 48;
    const auto seriesOf = [&](Coordinate coordinate) {
        std::optional<Series> series;
        if (const Family family = familyOf(problem, coordinate); !family.columns.empty()) {
            std::size_t values = 0;
            for (const FitColumn *column : family.columns) {
                values += column->count;
            }
            const int harmonics = std::clamp((static_cast<int>(values) - 3) / 2, 1, kMostHarmonics);
            leftBy(problem, family, speed, harmonics, &series.emplace());
        }
        return series;
    };
    const std::optional<Series> theta3 = seriesOf(Theta3);
    const std::optional<Series> slider = seriesOf(R4x);
    std::optional<Series> coupler;
    std::optional<Series> pin; // half of A, or the same a quarter of a turn later
    bool isQuarterLate = false;
    if (!slider) {
        coupler = seriesOf(R3x);
        pin = seriesOf(R2x);
        if (coupler && !pin) {
            isQuarterLate = true;
            pin = seriesOf(R2y);
            pin = pin ? pin : seriesOf(R3y);
        }
    }
    Positions positions;
    for (int i = 0; i < kPhases; ++i) {
        const double phase = 2.0 * kPi * i / kPhases;
        positions.phase.push_back(phase);
        if (theta3) {
            positions.theta3.push_back(theta3->at(phase));
            positions.isTheta3Whole = theta3->hasConstant;
        }
        if (slider) {
            positions.R4x.push_back(slider->at(phase));
            positions.isR4xWhole = slider->hasConstant;
        } else if (coupler && pin) {
            // sin θ2 a quarter of a turn later is cos θ2.
            const double half = pin->fundamentalAt(phase, isQuarterLate ? 0.5 * kPi : 0.0);
            positions.R4x.push_back(2.0 * (coupler->at(phase) - half));
            positions.isR4xWhole = coupler->hasConstant;
        }
    }
    return positions;
}

/// A coordinate on the rows, a derivative summed up by the trapezoidal rule; empty where there are accelerations only.
std::vector<double> courseOf(const FitProblem &problem, Coordinate coordinate, bool &isWhole)
{
    if (const FitColumn *position = columnOf(problem, {coordinate, Order::Position})) {
        isWhole = true;
        return position->values;
    }
    const FitColumn *velocity = columnOf(problem, {coordinate, Order::Velocity});
    isWhole = false;
    if (!velocity) {
        return {};
    }
    std::vector<double> sums(velocity->values.size(), kNone);
    double sum = 0.0;
    double lastTime = kNone;
    double lastValue = 0.0;
    for (std::size_t i = 0; i < sums.size(); ++i) {
        if (std::isnan(velocity->values[i])) {
            continue;
        }
        if (std::isfinite(lastTime)) {
            sum += 0.5 * (velocity->values[i] + lastValue) * (problem.time[i] - lastTime);
        }
        sums[i] = sum;
        lastTime = problem.time[i];
        lastValue = velocity->values[i];
    }
    return sums;
}

/// The rows themselves, few enough; `phase` holds the times.
Positions positionsOnRows(const FitProblem &problem)
{
    constexpr std::size_t kMostRows = 64;
    Positions whole;
    const std::vector<double> theta3 = courseOf(problem, Theta3, whole.isTheta3Whole);
    const std::vector<double> slider = courseOf(problem, R4x, whole.isR4xWhole);
    std::vector<std::size_t> rows;
    for (std::size_t row = 0; row < problem.time.size(); ++row) {
        if ((theta3.empty() || !std::isnan(theta3[row])) && (slider.empty() || !std::isnan(slider[row]))) {
            rows.push_back(row);
        }
    }
    for (const std::size_t row : thinned(rows, kMostRows)) {
        whole.phase.push_back(problem.time[row]);
        if (!theta3.empty()) {
            whole.theta3.push_back(theta3[row]);
        }
        if (!slider.empty()) {
            whole.R4x.push_back(slider[row]);
        }
    }
    return whole;
}

Positions atSpeed(const Positions &rows, double speed)
{
    Positions positions = rows;
    for (double &phase : positions.phase) {
        phase *= speed;
    }
    return positions;
}

} // namespace

double crankSpeedOf(const FitProblem &problem)
{
    double speed = 0.0;
    const FitColumn *rate = columnOf(problem, {Theta2, Order::Velocity});
    if (rate) {
        double sum = 0.0;
        for (const double value : rate->values) {
            sum += std::isnan(value) ? 0.0 : value;
        }
        speed = sum / static_cast<double>(rate->count);
    }
    const FitColumn *angle = columnOf(problem, {Theta2, Order::Position});
    if (!angle || angle->count < 2) {
        return speed;
    }
    // Made continuous: by the known rate, or, where it goes on in one direction anyway, not at all.
    std::vector<double> times;
    std::vector<double> angles;
    for (std::size_t i = 0; i < problem.time.size(); ++i) {
        if (!std::isnan(angle->values[i])) {
            times.push_back(problem.time[i]);
            angles.push_back(angle->values[i]);
        }
    }
    const bool isMonotonic = std::ranges::is_sorted(angles) || std::ranges::is_sorted(angles, std::ranges::greater());
    for (std::size_t i = 1; i < angles.size() && (!isMonotonic || rate); ++i) {
        const double expected = rate ? speed * (times[i] - times[i - 1]) : 0.0;
        angles[i] = angles[i - 1] + expected + withoutTurns(angles[i] - angles[i - 1] - expected);
    }
    const double n = static_cast<double>(times.size());
    const double meanTime = std::accumulate(times.begin(), times.end(), 0.0) / n;
    const double meanAngle = std::accumulate(angles.begin(), angles.end(), 0.0) / n;
    double products = 0.0;
    double squares = 0.0;
    for (std::size_t i = 0; i < times.size(); ++i) {
        products += (times[i] - meanTime) * (angles[i] - meanAngle);
        squares += (times[i] - meanTime) * (times[i] - meanTime);
    }
    return squares > 0.0 ? products / squares : speed;
}

void lengthenCoupler(const FitProblem &problem, Parameters &parameters)
{
    constexpr double kMore = 1.0 + 1e-9;
    double longest = 0.0;
    for (const double t : problem.time) {
        const double theta2 = parameters.omega2 * t + parameters.theta20;
        longest = std::max(longest, std::abs(parameters.c - parameters.a * std::sin(theta2)));
    }
    parameters.b = std::max(parameters.b, kMore * longest);
}

void scaleToFit(const FitProblem &problem, Parameters &parameters)
{
    struct Sums {
        double xy = 0.0, xx = 0.0, x = 0.0, y = 0.0, n = 0.0;
    };
    std::vector<Sums> sums(problem.columns.size());
    InstantMotion motion;
    for (std::size_t row = 0; row < problem.time.size(); ++row) {
        if (!motion.computeValues(parameters, problem.time[row])) {
            return;
        }
        for (std::size_t k = 0; k < problem.columns.size(); ++k) {
            const FitColumn &column = problem.columns[k];
            if (isAngle(column.channel.coordinate) || std::isnan(column.values[row]) || !(column.spread > 0.0)) {
                continue;
            }
            const double x = motion.valueOf(column.channel) / column.spread;
            const double y = column.values[row] / column.spread;
            sums[k].xy += x * y;
            sums[k].xx += x * x;
            sums[k].x += x;
            sums[k].y += y;
            sums[k].n += 1.0;
        }
    }
    // About the means, so that an origin elsewhere does no harm.
    double products = 0.0;
    double squares = 0.0;
    for (const Sums &one : sums) {
        if (one.n > 0.0) {
            products += one.xy - one.x * one.y / one.n;
            squares += one.xx - one.x * one.x / one.n;
        }
    }
    const double scale = products / squares;
    if (squares > 0.0 && scale > 0.0 && std::isfinite(scale)) {
        parameters.a *= scale;
        parameters.b *= scale;
        parameters.c *= scale;
    }
}

double misfitOf(const FitProblem &problem, const Parameters &parameters)
{
    struct Sums {
        double residuals = 0.0, squares = 0.0, variance = 0.0;
    };
    std::vector<Sums> sums(problem.columns.size());
    InstantMotion motion;
    for (std::size_t row = 0; row < problem.time.size(); ++row) {
        if (!motion.computeValues(parameters, problem.time[row])) {
            return kUnbounded;
        }
        for (std::size_t k = 0; k < problem.columns.size(); ++k) {
            const FitColumn &column = problem.columns[k];
            if (std::isnan(column.values[row])) {
                continue;
            }
            double residual = motion.valueOf(column.channel) - column.values[row];
            if (isAngle(column.channel.coordinate) && column.channel.order == Order::Position) {
                residual = withoutTurns(residual);
            }
            sums[k].residuals += residual;
            sums[k].squares += residual * residual;
            sums[k].variance += column.variance[row];
        }
    }
    double misfit = 0.0;
    for (std::size_t k = 0; k < problem.columns.size(); ++k) {
        const auto n = static_cast<double>(problem.columns[k].count);
        const double squares =
            sums[k].squares - (problem.columns[k].zero >= 0 ? sums[k].residuals * sums[k].residuals / n : 0.0);
        const double mean = std::max({squares / n, sums[k].variance / n, 1e-300});
        misfit += n * std::log(mean / (problem.columns[k].spread * problem.columns[k].spread));
    }
    return misfit;
}

std::vector<double> speedsOf(const FitProblem &problem, const std::stop_token &stop)
{
    const double speed = crankSpeedOf(problem);
    return speed != 0.0 ? std::vector<double>{std::abs(speed)} : speedsByHarmonics(problem, familiesOf(problem), stop);
}

std::vector<Parameters> startsOf(const FitProblem &problem, const std::vector<double> &speeds, double size,
                                 const std::stop_token &stop)
{
    constexpr std::size_t kRowMinima = 3;
    constexpr int kRowRefinements = 10;
    std::vector<Parameters> starts;
    const auto add = [&](const Route &route, const Positions &positions, double speed) {
        Shape shape = route.shape(positions);
        shape.parameters.omega2 = speed;
        const Parameters &p = shape.parameters;
        if (std::isfinite(p.a) && std::isfinite(p.b) && std::isfinite(p.c) && std::isfinite(p.theta20) && p.a > 0.0) {
            lengthenCoupler(problem, shape.parameters);
            // Angles alone know no size, and lengths have another one if the crank turns the other way. The size that
            // R4x tells may be better, or worse, than that of the shape when scaled.
            Parameters scaled = p;
            Parameters reversed{p.a, p.b, p.c, -p.omega2, kPi - p.theta20, p.branch};
            scaleToFit(problem, scaled);
            starts.push_back(scaled);
            if (route.isOfTheta3) {
                scaleToFit(problem, reversed);
                starts.push_back(reversed);
            } else if (!isSameMechanism(scaled, p)) {
                starts.push_back(p);
            }
        }
    };
    const double crankSpeed = crankSpeedOf(problem);
    for (const double speed : speeds) {
        constexpr double kWholeTurn = 0.7;
        if (speed < 2.0 * kPi * kWholeTurn) {
            continue;
        }
        const Positions positions = positionsOverATurn(problem, speed);
        for (const Route &route : routesFor(positions, size)) {
            add(route, positions, speed);
        }
    }
    const Positions rows = positionsOnRows(problem);
    constexpr std::size_t kFewestRows = 5;
    if (rows.phase.size() < kFewestRows || (rows.theta3.empty() && rows.R4x.empty())) {
        return starts;
    }
    std::vector<double> few;
    constexpr double kMostRadians = 2.0 * kPi * 6.0;
    for (double speed = 0.1; speed < 4.0; speed *= 1.25) {
        few.push_back(speed);
    }
    for (double speed = 4.0; speed < kMostRadians; speed += 0.8) {
        few.push_back(speed);
    }
    for (const Route &route : routesFor(rows, size)) {
        const auto left = [&](double speed) {
            return stop.stop_requested() ? kUnbounded : route.shape(atSpeed(rows, speed)).left;
        };
        const std::vector<double> best = crankSpeed != 0.0 ? std::vector<double>{std::abs(crankSpeed)}
                                                           : minimaOver(few, kRowMinima, kRowRefinements, left);
        for (const double speed : best) {
            add(route, atSpeed(rows, speed), speed);
        }
    }
    return starts;
}

} // namespace slidercrank
