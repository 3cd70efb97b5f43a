// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/cases.h"

#include "core/mechanism/turn.h"
#include "core/sampling/crank_time.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

namespace slidercrank
{

namespace
{

using enum Branch;

/// A mechanism with a crank of 20 mm that makes one revolution per second.
struct Row {
    const char *name;
    double b;
    double c = 25.0;
    Branch branch = Open;
};

/// Returns a coupler length that exceeds the shortest for full turns by the relative `gap`.
constexpr double toggle(double gap, double c = 25.0)
{
    return (20.0 + (c < 0.0 ? -c : c)) * (1.0 + gap);
}

const std::vector<Row> kNominal = {
    {"initial mechanism", 65.0},
    {"b = 60, sample file", 60.0},
    {"b = 60, crossed", 60.0, 25.0, Crossed},
    {"c = 0", 60.0, 0.0},
    {"c = 0, crossed", 60.0, 0.0, Crossed},
    {"c < 0", 60.0, -25.0},
    {"c < 0, crossed", 60.0, -25.0, Crossed},
    {"b/a = 10", 200.0},
};

const std::vector<Row> kHard{
    {"toggle gap 1e-4, crossed", toggle(1e-4), 25.0, Crossed},
    {"toggle gap 1e-8, crossed", toggle(1e-8), 25.0, Crossed},
    {"exact toggle, c > 0", toggle(0.0)},
    {"exact toggle, c < 0", toggle(0.0), -25.0},
    {"exact toggle, crossed", toggle(0.0), 25.0, Crossed},
    {"change point, a = b and c = 0", 20.0, 0.0},
    {"change point, crossed", 20.0, 0.0, Crossed},
    {"rocker, one arc", 40.0},
    {"rocker, one arc, c < 0", 40.0, -25.0},
    {"rocker, one arc, crossed", 40.0, 25.0, Crossed},
    {"rocker, two arcs", 10.0, 5.0},
    {"rocker, two arcs, crossed", 10.0, 5.0, Crossed},
    {"rocker, two arcs, c = 0", 10.0, 0.0},
    {"barely a rocker, gap -1e-8", toggle(-1e-8)},
    {"locked, b = |c| - a", 5.0},
    {"never assemblable", 4.0},
    {"b/a = 1e3", 2e4},
    {"b/a = 1e9", 2e10},
    {"c/a = 5e4", 1.1e6, 1e6},
};

/// Adds mechanisms with relative gaps of 1e-1 … 1e-15 to a toggle.
void addToggles(const char *suffix, double c, std::initializer_list<int> exponents, std::vector<Case> &cases)
{
    for (const int exponent : exponents) {
        const std::string gap = "1e-" + std::to_string(exponent);
        cases.push_back({"toggle gap " + gap + suffix, {20.0, toggle(std::stod(gap), c), c}});
    }
}

void add(const std::vector<Row> &rows, std::vector<Case> &cases)
{
    for (const Row &row : rows) {
        cases.push_back({row.name, {20.0, row.b, row.c, kTurn, 0.0, row.branch}});
    }
}

Parameters scaled(double factor)
{
    return {20.0 * factor, 60.0 * factor, 25.0 * factor};
}

} // namespace

std::vector<Case> nominalCases()
{
    std::vector<Case> cases;
    add(kNominal, cases);
    cases.push_back({"omega2 < 0", {20.0, 60.0, 25.0, -kTurn}});
    cases.push_back({"theta20 = 1 rad", {20.0, 60.0, 25.0, kTurn, 1.0}});
    return cases;
}

std::vector<Case> hardCases()
{
    std::vector<Case> cases;
    addToggles(", c > 0", 25.0, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15}, cases);
    addToggles(", c = 0", 0.0, {1, 2, 3, 4, 6, 8, 12, 15}, cases);
    addToggles(", c < 0", -25.0, {1, 2, 3, 4, 6, 8, 12, 15}, cases);
    add(kHard, cases);
    for (const int steps : {2, 3, 4, 5, 8}) {
        cases.push_back(
            {std::to_string(steps) + " steps a turn, gap 1e-1", {20.0, toggle(1e-1), 25.0}, {0.0, 1.0, steps}});
    }
    cases.push_back({"5 steps a turn, gap 1e-2", {20.0, toggle(1e-2), 25.0}, {0.0, 1.0, 5}});
    cases.push_back({"8 steps a turn, gap 1e-3", {20.0, toggle(1e-3), 25.0}, {0.0, 1.0, 8}});
    cases.push_back({"lengths x 1e-9", scaled(1e-9)});
    cases.push_back({"lengths x 1e9", scaled(1e9)});
    cases.push_back({"t near 1e9 s", scaled(1.0), {1e9, 1.0, 200}});
    cases.push_back({"omega2 = 0", {20.0, 60.0, 25.0, 0.0, 1.0}});
    cases.push_back({"omega2 = 1e6 rad/s", {20.0, 60.0, 25.0, 1e6}, {0.0, 6.25e-6, 200}});
    return cases;
}

std::vector<double> perpendicularTimes(const Case &namedCase)
{
    const Mechanism mechanism(namedCase.parameters);
    if (mechanism.omega2() == 0.0) {
        return {};
    }
    // |c - a sin θ2| is stationary at ±90°, and b where sin θ2 = (c ± b)/a.
    std::vector<double> angles{kQuarterTurn, -kQuarterTurn};
    for (const double height : {mechanism.b(), -mechanism.b()}) {
        const double angle = std::asin((mechanism.c() + height) / mechanism.a());
        if (!std::isnan(angle)) {
            angles.insert(angles.end(), {angle, 2.0 * kQuarterTurn - angle});
        }
    }

    constexpr int kMaxRevolutions = 10;
    const double start = namedCase.sampling.start;
    const double turnTime = kTurn / std::abs(mechanism.omega2());
    std::vector<double> result;
    for (const double angle : angles) {
        const std::optional<double> first = timeAtCrankAngle(mechanism, angle, start);
        for (int k = 0; first && k < kMaxRevolutions && *first + turnTime * k <= start + namedCase.sampling.duration;
             ++k) {
            result.push_back(*first + turnTime * k);
        }
    }
    std::ranges::sort(result);
    return result;
}

std::vector<double> timeStampsOf(const Case &namedCase)
{
    std::vector<double> result = namedCase.sampling.timeStamps();
    std::ranges::copy(perpendicularTimes(namedCase), std::back_inserter(result));
    std::ranges::sort(result);
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
}

} // namespace slidercrank
