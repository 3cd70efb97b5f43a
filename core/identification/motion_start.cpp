// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/motion_start.h"

#include <Eigen/QR>
#include <boost/math/tools/minima.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <iterator>
#include <limits>
#include <numbers>
#include <numeric>

namespace slidercrank
{

namespace
{

constexpr double kPi = std::numbers::pi;
constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();

/// So many rows tell a motion of a few turns from any other.
constexpr std::size_t kMostRows = 64;
constexpr int kMostUnknowns = 6;
constexpr std::size_t kFewestRows = 8;

/// A window holds at most so many turning points, two a turn.
constexpr std::size_t kMostTurningPoints = 7;

// ---- the courses ---------------------------------------------------------------------------------------------------

/// By the trapezoidal rule over the rows that have a value; 0 at the first.
std::vector<double> summedUp(const std::vector<double> &time, const std::vector<double> &values)
{
    std::vector<double> sums(values.size(), kMissing);
    double sum = 0.0;
    double lastTime = kMissing;
    double lastValue = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (!std::isfinite(values[i])) {
            continue;
        }
        if (std::isfinite(lastTime)) {
            sum += 0.5 * (values[i] + lastValue) * (time[i] - lastTime);
        }
        sums[i] = sum;
        lastTime = time[i];
        lastValue = values[i];
    }
    return sums;
}

std::optional<Course> courseOf(const ReferenceData &data, const FitUnits &units, const std::vector<double> &time,
                               Coordinate coordinate)
{
    for (const Order order : {Order::Position, Order::Velocity, Order::Acceleration}) {
        const ReferenceSeries *series = data.find({coordinate, order});
        if (!series) {
            continue;
        }
        Course course{series->values, order};
        const double factor = units.factor(series->channel);
        std::size_t count = 0;
        for (double &value : course.values) {
            value = std::isfinite(value) ? factor * value : kMissing;
            count += std::isfinite(value) ? 1 : 0;
        }
        if (count < kFewestRows) {
            continue;
        }
        if (order != Order::Position) {
            course.values = summedUp(time, course.values);
        }
        return course;
    }
    return std::nullopt;
}

/// Rows where a course turns back by more than a small part of its range.
std::vector<std::size_t> turningPoints(const std::vector<double> &values, std::size_t most)
{
    constexpr double kPartOfRange = 0.03;
    const double back = kPartOfRange * rangeOf(values).width();
    std::vector<std::size_t> points;
    std::optional<std::size_t> lowest;
    std::optional<std::size_t> highest;
    int direction = 0;
    for (std::size_t i = 0; i < values.size() && points.size() < most; ++i) {
        if (!std::isfinite(values[i])) {
            continue;
        }
        if (!lowest || values[i] < values[*lowest]) {
            lowest = i;
        }
        if (!highest || values[i] > values[*highest]) {
            highest = i;
        }
        if (direction >= 0 && values[i] < values[*highest] - back) {
            if (direction > 0) {
                points.push_back(*highest);
            }
            direction = -1;
            lowest = i;
        } else if (direction <= 0 && values[i] > values[*lowest] + back) {
            if (direction < 0) {
                points.push_back(*lowest);
            }
            direction = 1;
            highest = i;
        }
    }
    return points;
}

// ---- given the speed, the rest is linear ---------------------------------------------------------------------------

/// The rows that a route looks at.
struct Samples {
    std::vector<double> time;
    std::vector<double> theta3;
    std::vector<double> R4x;
};

struct Candidate {
    double speed = 0.0;
    double misfit = std::numeric_limits<double>::infinity(); ///< of the linear equations
    Parameters parameters;
};

/// The linear least-squares problem of a route: a few unknowns, at most two equations a row. One type for all routes;
/// it takes no memory from the heap.
class Equations
{
public:
    Equations(std::size_t count, Eigen::Index unknowns)
        : m_matrix(static_cast<Eigen::Index>(count), unknowns)
        , m_right(static_cast<Eigen::Index>(count))
    {
    }

    template <typename... Coefficients>
    void add(double right, Coefficients... coefficients)
    {
        Eigen::Index column = 0;
        ((m_matrix(m_used, column++) = coefficients), ...);
        m_right[m_used++] = right;
    }

    struct Solution {
        Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMostUnknowns, 1> x;
        double misfit; ///< norm of what is left
    };
    Solution solve() const
    {
        const Eigen::ColPivHouseholderQR<Matrix> qr(m_matrix);
        Solution solution;
        solution.x = qr.solve(m_right);
        solution.misfit = (m_matrix * solution.x - m_right).norm();
        return solution;
    }

private:
    static constexpr int kMostEquations = 2 * static_cast<int>(kMostRows);
    using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMostEquations, kMostUnknowns>;
    Matrix m_matrix;
    Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMostEquations, 1> m_right;
    Eigen::Index m_used = 0;
};

double mean(const std::vector<double> &values)
{
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

Candidate fromBoth(const Samples &samples, double speed)
{
    Equations equations(2 * samples.time.size(), 4);
    double cosines = 0.0;
    for (std::size_t i = 0; i < samples.time.size(); ++i) {
        const double sine = std::sin(speed * samples.time[i]);
        const double cosine = std::cos(speed * samples.time[i]);
        const double cos3 = std::cos(samples.theta3[i]);
        equations.add(samples.R4x[i], cos3, 0.0, cosine, -sine);
        equations.add(0.0, std::sin(samples.theta3[i]), -1.0, sine, cosine);
        cosines += cos3;
    }
    const auto [x, misfit] = equations.solve();
    return {speed,
            misfit,
            {std::hypot(x[2], x[3]), std::abs(x[0]), x[1], speed, std::atan2(x[3], x[2]),
             cosines >= 0.0 ? Branch::Open : Branch::Crossed}};
}

Candidate fromTheta3(const Samples &samples, double speed, Order order, double size)
{
    // tan δ, c/b, u/b, v/b; the last three times cos δ as well where δ is unknown.
    const bool isWhole = order == Order::Position;
    const double centre = isWhole ? 0.0 : mean(samples.theta3);
    Equations equations(samples.time.size(), isWhole ? 3 : 4);
    double cosines = 0.0;
    for (std::size_t i = 0; i < samples.time.size(); ++i) {
        const double t = speed * samples.time[i];
        const double sine = std::sin(samples.theta3[i] - centre);
        const double cosine = std::cos(samples.theta3[i] - centre);
        if (isWhole) {
            equations.add(sine, 1.0, -std::sin(t), -std::cos(t));
            cosines += cosine;
        } else {
            equations.add(sine, 1.0, -std::sin(t), -std::cos(t), -cosine);
        }
    }
    const auto [x, misfit] = equations.solve();
    const double cosDelta = isWhole ? 1.0 : 1.0 / std::sqrt(1.0 + x[3] * x[3]);
    const double u = x[1] * cosDelta;
    const double v = x[2] * cosDelta;
    const double ratioA = std::max(std::hypot(u, v), 1e-9);
    return {speed,
            misfit,
            {size, size / ratioA, size * (x[0] * cosDelta) / ratioA, speed, std::atan2(v, u),
             cosines >= 0.0 ? Branch::Open : Branch::Crossed}};
}

Candidate fromR4x(const Samples &samples, double speed, Order order)
{
    // r = R4x - R: (r + R)² = 2 (r + R) (u cos - v sin) + 2 c (v cos + u sin) + D.
    const bool isWhole = order == Order::Position;
    const double centre = mean(samples.R4x);
    Equations equations(samples.time.size(), isWhole ? 5 : 6);
    for (std::size_t i = 0; i < samples.time.size(); ++i) {
        const double sine = std::sin(speed * samples.time[i]);
        const double cosine = std::cos(speed * samples.time[i]);
        const double r = samples.R4x[i] - centre;
        if (isWhole) {
            equations.add(r * (r + 2.0 * centre), r * cosine, -r * sine, cosine, sine, 1.0);
        } else {
            equations.add(r * r, r * cosine, -r * sine, cosine, sine, 1.0, -2.0 * r);
        }
    }
    const auto [x, misfit] = equations.solve();
    const double u = x[0], v = x[1], inCos = x[2], inSin = x[3], rest = x[4];
    const double R = isWhole ? centre : x[5];
    // Twice a, and its direction; inCos = R u + c v, inSin = -R v + c u, rest = D - R².
    const double square = std::max(u * u + v * v, 1e-18);
    const double a = 0.5 * std::sqrt(square);
    const double c = (v * inCos + u * inSin) / square;
    const double b = std::sqrt(std::max(rest + R * R + a * a + c * c, 0.0));
    return {speed, misfit, {a, b, c, speed, std::atan2(v, u), R >= 0.0 ? Branch::Open : Branch::Crossed}};
}

// ---- the search over the speed -------------------------------------------------------------------------------------

using Route = std::function<Candidate(double speed)>;

/// The best between two speeds.
Candidate refined(const Route &route, double from, double to, const Candidate &best)
{
    constexpr int kBits = 16; // a fit does the rest
    std::uintmax_t most = 14;
    const auto misfitAt = [&](double speed) { return route(speed).misfit; };
    const Candidate found = route(boost::math::tools::brent_find_minima(misfitAt, from, to, kBits, most).first);
    return found.misfit < best.misfit ? found : best;
}

/// The best few of the local minima over the speed.
void search(const Route &route, std::vector<double> speeds, std::vector<Parameters> &found)
{
    constexpr std::size_t kMostMinima = 3;
    std::vector<Candidate> candidates;
    for (const double speed : speeds) {
        candidates.push_back(route(speed));
    }
    std::vector<std::size_t> minima;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        const bool fallsBefore = i == 0 || candidates[i].misfit <= candidates[i - 1].misfit;
        const bool risesAfter = i + 1 == candidates.size() || candidates[i].misfit <= candidates[i + 1].misfit;
        if (fallsBefore && risesAfter) {
            minima.push_back(i);
        }
    }
    std::ranges::sort(minima, {}, [&](std::size_t i) { return candidates[i].misfit; });
    minima.resize(std::min(minima.size(), kMostMinima));
    for (const std::size_t i : minima) {
        const double from = speeds[i == 0 ? i : i - 1];
        const double to = speeds[std::min(i + 1, speeds.size() - 1)];
        found.push_back(refined(route, from, to, candidates[i]).parameters);
    }
}

Samples samplesOf(const Courses &courses, bool theta3, bool R4x)
{
    const auto usable = [&](std::size_t row) {
        return (!theta3 || std::isfinite(courses.theta3->values[row])) &&
               (!R4x || std::isfinite(courses.R4x->values[row]));
    };
    std::vector<std::size_t> rows;
    for (std::size_t row = courses.firstRow; row < courses.endRow; ++row) {
        if (usable(row)) {
            rows.push_back(row);
        }
    }
    Samples samples;
    for (const std::size_t row : thinned(rows, kMostRows)) {
        samples.time.push_back(courses.time[row]);
        if (theta3) {
            samples.theta3.push_back(courses.theta3->values[row]);
        }
        if (R4x) {
            samples.R4x.push_back(courses.R4x->values[row]);
        }
    }
    return samples;
}

} // namespace

Courses coursesOf(const ReferenceData &data, const Supply &supply, const FitUnits &units)
{
    Courses courses;
    courses.time = data.time;
    std::vector<double> &time = courses.time;
    for (double &t : time) {
        t = units.timeOf(t);
    }
    courses.theta3 = courseOf(data, units, time, Theta3);
    courses.R4x = courseOf(data, units, time, R4x);
    courses.firstRow = supply.rows.front();
    courses.endRow = supply.rows.back() + 1;
    const std::optional<Course> *best = &courses.theta3;
    if (!*best || (courses.R4x && courses.R4x->order < (*best)->order)) {
        best = &courses.R4x;
    }
    if (!*best) {
        return courses;
    }
    const std::vector<double> &values = (*best)->values;
    const std::vector<std::size_t> points = turningPoints(values, kMostTurningPoints);
    courses.turningPoints = points.size();
    if (points.size() == kMostTurningPoints) {
        courses.endRow = points.back() + 1;
    }
    if (points.size() >= 3) {
        // From one turning point to the last of the same kind there are whole turns.
        const std::size_t turns = (points.size() - 1) / 2;
        const std::size_t last = points[2 * turns];
        double widest = 0.0;
        for (std::size_t row = points[0], before = row; row <= last; ++row) {
            if (std::isfinite(values[row])) {
                widest = std::max(widest, time[row] - time[before]);
                before = row;
            }
        }
        const double whole = time[last] - time[points[0]];
        courses.speed = 2.0 * kPi * static_cast<double>(turns) / whole;
        courses.speedUncertainty = std::min(2.0 * widest / whole, 0.5);
    }
    return courses;
}

std::vector<double> likelySpeeds(const Courses &courses)
{
    if (!(courses.speed > 0.0)) {
        return allSpeeds(courses);
    }
    constexpr int kEachSide = 4;
    std::vector<double> speeds;
    for (int i = -kEachSide; i <= kEachSide; ++i) {
        speeds.push_back(courses.speed * (1.0 + courses.speedUncertainty * i / kEachSide));
    }
    return speeds;
}

std::vector<double> allSpeeds(const Courses &courses)
{
    const double oneTurn = 2.0 * kPi / (courses.time[courses.endRow - 1] - courses.time[courses.firstRow]);
    const double mostTurns = 2.0 + 0.5 * static_cast<double>(courses.turningPoints);
    std::vector<double> speeds;
    for (double turns = 0.02; turns < 0.3; turns *= 1.3) {
        speeds.push_back(turns * oneTurn);
    }
    for (double turns = 0.3; turns < mostTurns; turns += 0.07) {
        speeds.push_back(turns * oneTurn);
    }
    return speeds;
}

std::vector<Parameters> startsFrom(const Courses &courses, const std::vector<double> &speeds, double size)
{
    std::vector<Parameters> found;
    const bool bothPositions = courses.theta3 && courses.R4x && courses.theta3->order == Order::Position &&
                               courses.R4x->order == Order::Position;
    if (bothPositions) {
        const Samples samples = samplesOf(courses, true, true);
        if (samples.time.size() >= kFewestRows) {
            search([&](double speed) { return fromBoth(samples, speed); }, speeds, found);
            std::vector<double> backwards;
            for (const double speed : speeds) {
                backwards.push_back(-speed);
            }
            search([&](double speed) { return fromBoth(samples, speed); }, backwards, found);
            return found;
        }
    }
    if (courses.theta3 && courses.theta3->order != Order::Acceleration) {
        const Samples samples = samplesOf(courses, true, false);
        if (samples.time.size() >= kFewestRows) {
            const Order order = courses.theta3->order;
            search([&](double speed) { return fromTheta3(samples, speed, order, size); }, speeds, found);
        }
    }
    if (courses.R4x && courses.R4x->order != Order::Acceleration) {
        const Samples samples = samplesOf(courses, false, true);
        if (samples.time.size() >= kFewestRows) {
            const Order order = courses.R4x->order;
            search([&](double speed) { return fromR4x(samples, speed, order); }, speeds, found);
        }
    }
    std::vector<Parameters> all; // one channel alone does not tell them apart
    for (const Parameters &one : found) {
        std::ranges::copy(imagesOf(one), std::back_inserter(all));
    }
    return all;
}

std::vector<Parameters> startsFromGrid(const Observations &observations, const std::vector<double> &speeds,
                                       bool bothDirections, double size, const std::stop_token &stop)
{
    constexpr int kAngles = 12;
    constexpr double kOffsets[] = {-1.2, -0.5, 0.0, 0.5, 1.2}; // c / a
    constexpr double kCouplers[] = {0.6, 1.05, 1.3, 2.0, 4.0}; // b / (a + |c|)
    std::vector<Parameters> found;
    for (const double magnitude : speeds) {
        for (const double speed : {magnitude, -magnitude}) {
            if ((speed < 0.0 && !bothDirections) || stop.stop_requested()) {
                continue;
            }
            Parameters best;
            double least = std::numeric_limits<double>::infinity();
            for (const double offset : kOffsets) {
                for (const double coupler : kCouplers) {
                    for (const Branch branch : {Branch::Open, Branch::Crossed}) {
                        for (int i = 0; i < kAngles; ++i) {
                            Parameters trial{size,
                                             size * coupler * (1.0 + std::abs(offset)),
                                             size * offset,
                                             speed,
                                             2.0 * kPi * i / kAngles,
                                             branch};
                            const double distance = misfitAtBestSize(observations, trial);
                            if (distance < least) {
                                least = distance;
                                best = trial;
                            }
                        }
                    }
                }
            }
            found.push_back(best);
        }
    }
    return found;
}

} // namespace slidercrank
