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

// The lengths of the mechanism in the sample file (mm), from which most cases differ in one or two lengths.
constexpr double kCrank = 20.0;
constexpr double kCoupler = 60.0;
constexpr double kOffset = 25.0;

/// A mechanism with a crank of length kCrank that makes one revolution per second. Lengths in mm.
struct Row {
    const char *name;
    double b;
    double c = kOffset;
    Branch branch = Open;
};

/// Returns a coupler length that exceeds the shortest one for full turns by the fraction `gap` of it. With a small gap,
/// the mechanism passes a toggle closely.
constexpr double couplerNearToggle(double gap, double c = kOffset)
{
    return (kCrank + (c < 0.0 ? -c : c)) * (1.0 + gap);
}

const std::vector<Row> kNominalRows = {
    {"initial mechanism", 65.0},
    {"b = 60, sample file", kCoupler},
    {"b = 60, crossed", kCoupler, kOffset, Crossed},
    {"c = 0", kCoupler, 0.0},
    {"c = 0, crossed", kCoupler, 0.0, Crossed},
    {"c < 0", kCoupler, -kOffset},
    {"c < 0, crossed", kCoupler, -kOffset, Crossed},
    {"b/a = 10", 200.0},
};

const std::vector<Row> kHardRows{
    {"toggle gap 1e-4, crossed", couplerNearToggle(1e-4), kOffset, Crossed},
    {"toggle gap 1e-8, crossed", couplerNearToggle(1e-8), kOffset, Crossed},
    {"exact toggle, c > 0", couplerNearToggle(0.0)},
    {"exact toggle, c < 0", couplerNearToggle(0.0), -kOffset},
    {"exact toggle, crossed", couplerNearToggle(0.0), kOffset, Crossed},
    {"change point, a = b and c = 0", kCrank, 0.0},
    {"change point, crossed", kCrank, 0.0, Crossed},
    {"rocker, one arc", 40.0},
    {"rocker, one arc, c < 0", 40.0, -kOffset},
    {"rocker, one arc, crossed", 40.0, kOffset, Crossed},
    {"rocker, two arcs", 10.0, 5.0},
    {"rocker, two arcs, crossed", 10.0, 5.0, Crossed},
    {"rocker, two arcs, c = 0", 10.0, 0.0},
    {"barely a rocker, gap -1e-8", couplerNearToggle(-1e-8)},
    {"locked, b = |c| - a", 5.0},
    {"never assemblable", 4.0},
    {"b/a = 1e3", 2e4},
    {"b/a = 1e9", 2e10},
    {"c/a = 5e4", 1.1e6, 1e6},
};

/// Adds a mechanism with the relative gap 10^-exponent to a toggle for each exponent. `c`: its offset, mm.
void addCasesNearToggle(const char *suffix, double c, std::initializer_list<int> exponents, std::vector<Case> &cases)
{
    for (const int exponent : exponents) {
        const std::string gap = "1e-" + std::to_string(exponent);
        cases.push_back({.name = "toggle gap " + gap + suffix,
                         .parameters = {.a = kCrank, .b = couplerNearToggle(std::stod(gap), c), .c = c}});
    }
}

void addCases(const std::vector<Row> &rows, std::vector<Case> &cases)
{
    for (const Row &row : rows) {
        cases.push_back(
            {.name = row.name,
             .parameters = {
                 .a = kCrank, .b = row.b, .c = row.c, .omega2 = kTurn, .theta20 = 0.0, .branch = row.branch}});
    }
}

/// Returns the mechanism of the sample file with all lengths multiplied by the factor.
Parameters scaledSampleMechanism(double factor)
{
    return {.a = kCrank * factor, .b = kCoupler * factor, .c = kOffset * factor};
}

/// Returns a case with few time steps per revolution. `gap`: the relative gap to a toggle, such as "1e-4".
Case caseWithFewSteps(int steps, const std::string &gap)
{
    return {.name = std::to_string(steps) + " steps a turn, gap " + gap,
            .parameters = {.a = kCrank, .b = couplerNearToggle(std::stod(gap)), .c = kOffset},
            .sampling = {.steps = steps}};
}

} // namespace

std::vector<Case> nominalCases()
{
    std::vector<Case> cases;
    addCases(kNominalRows, cases);
    cases.push_back({.name = "omega2 < 0", .parameters = {.a = kCrank, .b = kCoupler, .c = kOffset, .omega2 = -kTurn}});
    cases.push_back({.name = "theta20 = 1 rad",
                     .parameters = {.a = kCrank, .b = kCoupler, .c = kOffset, .omega2 = kTurn, .theta20 = 1.0}});
    return cases;
}

std::vector<Case> hardCases()
{
    std::vector<Case> cases;
    addCasesNearToggle(", c > 0", kOffset, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15}, cases);
    addCasesNearToggle(", c = 0", 0.0, {1, 2, 3, 4, 6, 8, 12, 15}, cases);
    addCasesNearToggle(", c < 0", -kOffset, {1, 2, 3, 4, 6, 8, 12, 15}, cases);
    addCases(kHardRows, cases);
    for (const int steps : {2, 3, 4, 5, 8}) {
        cases.push_back(caseWithFewSteps(steps, "1e-1"));
    }
    cases.push_back(caseWithFewSteps(5, "1e-2"));
    cases.push_back(caseWithFewSteps(8, "1e-3"));
    cases.push_back({.name = "lengths x 1e-9", .parameters = scaledSampleMechanism(1e-9)});
    cases.push_back({.name = "lengths x 1e9", .parameters = scaledSampleMechanism(1e9)});
    cases.push_back({.name = "t near 1e9 s", .parameters = scaledSampleMechanism(1.0), .sampling = {.start = 1e9}});
    cases.push_back({.name = "omega2 = 0",
                     .parameters = {.a = kCrank, .b = kCoupler, .c = kOffset, .omega2 = 0.0, .theta20 = 1.0}});
    cases.push_back({.name = "omega2 = 1e6 rad/s",
                     .parameters = {.a = kCrank, .b = kCoupler, .c = kOffset, .omega2 = 1e6},
                     .sampling = {.duration = 6.25e-6}}); // about one revolution
    return cases;
}

std::vector<double> perpendicularTimes(const Case &namedCase)
{
    const Mechanism mechanism(namedCase.parameters);
    if (mechanism.omega2() == 0.0) {
        return {};
    }
    // |c - a sin θ2| is stationary at ±90°, and equals b where sin θ2 = (c ± b)/a.
    std::vector<double> angles{kQuarterTurn, -kQuarterTurn};
    for (const double height : {mechanism.b(), -mechanism.b()}) {
        const double angle = std::asin((mechanism.c() + height) / mechanism.a());
        if (!std::isnan(angle)) {
            angles.insert(angles.end(), {angle, std::numbers::pi - angle});
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
