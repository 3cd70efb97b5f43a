// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/cases.h"

#include "core/mechanism/turn.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace slidercrank
{

namespace
{

/// One turn in one second of a crank of 20 mm, which all but the scaled cases have.
Case lengths(std::string_view name, double b, double c, Branch branch = Branch::Open)
{
    return {name, {20.0, b, c, kTurn, 0.0, branch}, {}};
}

/// The coupler is longer than a full turn needs by one part in `1/gap`.
Case toggle(std::string_view name, double gap, double c, Branch branch = Branch::Open)
{
    return lengths(name, (20.0 + std::abs(c)) * (1.0 + gap), c, branch);
}

Case scaled(std::string_view name, double factor)
{
    return {name, {20.0 * factor, 60.0 * factor, 25.0 * factor, kTurn, 0.0, Branch::Open}, {}};
}

/// One turn in one second, or in the time that the speed asks for.
Case driven(std::string_view name, double omega2, double theta20, Sampling sampling)
{
    return {name, {20.0, 60.0, 25.0, omega2, theta20, Branch::Open}, sampling};
}

/// Few steps a turn, where a warm start begins far from its answer.
Case coarse(std::string_view name, int steps, double gap)
{
    Case result = toggle(name, gap, 25.0);
    result.sampling.steps = steps;
    return result;
}

} // namespace

std::span<const Case> nominalCases()
{
    static const std::array kCases{
        Case{"Table 1 of the report", {}, {}},
        lengths("b = 60, the author's file", 60.0, 25.0),
        lengths("b = 60, crossed", 60.0, 25.0, Branch::Crossed),
        lengths("c = 0", 60.0, 0.0),
        lengths("c = 0, crossed", 60.0, 0.0, Branch::Crossed),
        lengths("c < 0", 60.0, -25.0),
        lengths("c < 0, crossed", 60.0, -25.0, Branch::Crossed),
        driven("omega2 < 0", -kTurn, 0.0, {}),
        driven("theta20 = 1 rad", kTurn, 1.0, {}),
        lengths("b/a = 10", 200.0, 25.0),
    };
    return kCases;
}

std::span<const Case> hardCases()
{
    static const std::array kCases{
        toggle("toggle gap 1e-1, c > 0", 1e-1, 25.0),
        toggle("toggle gap 1e-2, c > 0", 1e-2, 25.0),
        toggle("toggle gap 1e-3, c > 0", 1e-3, 25.0),
        toggle("toggle gap 1e-4, c > 0", 1e-4, 25.0),
        toggle("toggle gap 1e-5, c > 0", 1e-5, 25.0),
        toggle("toggle gap 1e-6, c > 0", 1e-6, 25.0),
        toggle("toggle gap 1e-7, c > 0", 1e-7, 25.0),
        toggle("toggle gap 1e-8, c > 0", 1e-8, 25.0),
        toggle("toggle gap 1e-9, c > 0", 1e-9, 25.0),
        toggle("toggle gap 1e-10, c > 0", 1e-10, 25.0),
        toggle("toggle gap 1e-11, c > 0", 1e-11, 25.0),
        toggle("toggle gap 1e-12, c > 0", 1e-12, 25.0),
        toggle("toggle gap 1e-13, c > 0", 1e-13, 25.0),
        toggle("toggle gap 1e-14, c > 0", 1e-14, 25.0),
        toggle("toggle gap 1e-15, c > 0", 1e-15, 25.0),
        toggle("toggle gap 1e-1, c = 0", 1e-1, 0.0),
        toggle("toggle gap 1e-2, c = 0", 1e-2, 0.0),
        toggle("toggle gap 1e-3, c = 0", 1e-3, 0.0),
        toggle("toggle gap 1e-4, c = 0", 1e-4, 0.0),
        toggle("toggle gap 1e-6, c = 0", 1e-6, 0.0),
        toggle("toggle gap 1e-8, c = 0", 1e-8, 0.0),
        toggle("toggle gap 1e-12, c = 0", 1e-12, 0.0),
        toggle("toggle gap 1e-15, c = 0", 1e-15, 0.0),
        toggle("toggle gap 1e-1, c < 0", 1e-1, -25.0),
        toggle("toggle gap 1e-2, c < 0", 1e-2, -25.0),
        toggle("toggle gap 1e-3, c < 0", 1e-3, -25.0),
        toggle("toggle gap 1e-4, c < 0", 1e-4, -25.0),
        toggle("toggle gap 1e-6, c < 0", 1e-6, -25.0),
        toggle("toggle gap 1e-8, c < 0", 1e-8, -25.0),
        toggle("toggle gap 1e-12, c < 0", 1e-12, -25.0),
        toggle("toggle gap 1e-15, c < 0", 1e-15, -25.0),
        toggle("toggle gap 1e-4, crossed", 1e-4, 25.0, Branch::Crossed),
        toggle("toggle gap 1e-8, crossed", 1e-8, 25.0, Branch::Crossed),

        toggle("exact toggle, c > 0", 0.0, 25.0),
        toggle("exact toggle, c < 0", 0.0, -25.0),
        toggle("exact toggle, crossed", 0.0, 25.0, Branch::Crossed),
        toggle("change point, a = b and c = 0", 0.0, 0.0),
        toggle("change point, crossed", 0.0, 0.0, Branch::Crossed),

        lengths("rocker, one arc", 40.0, 25.0),
        lengths("rocker, one arc, c < 0", 40.0, -25.0),
        lengths("rocker, one arc, crossed", 40.0, 25.0, Branch::Crossed),
        lengths("rocker, two arcs", 10.0, 5.0),
        lengths("rocker, two arcs, crossed", 10.0, 5.0, Branch::Crossed),
        lengths("rocker, two arcs, c = 0", 10.0, 0.0),
        toggle("rocker by a hair, gap -1e-8", -1e-8, 25.0),
        lengths("locked, b = |c| - a", 5.0, 25.0),
        lengths("never assemblable", 4.0, 25.0),

        lengths("b/a = 1e3", 2e4, 25.0),
        lengths("b/a = 1e9", 2e10, 25.0),
        lengths("c/a = 5e4", 1.1e6, 1e6),
        scaled("lengths x 1e-9", 1e-9),
        scaled("lengths x 1e9", 1e9),

        driven("t near 1e9 s", kTurn, 0.0, {1e9, 1.0, 200}),
        driven("omega2 = 0", 0.0, 1.0, {}),
        driven("omega2 = 1e6 rad/s", 1e6, 0.0, {0.0, 6.25e-6, 200}),

        coarse("2 steps a turn, gap 1e-1", 2, 1e-1),
        coarse("3 steps a turn, gap 1e-1", 3, 1e-1),
        coarse("4 steps a turn, gap 1e-1", 4, 1e-1),
        coarse("5 steps a turn, gap 1e-1", 5, 1e-1),
        coarse("8 steps a turn, gap 1e-1", 8, 1e-1),
        coarse("5 steps a turn, gap 1e-2", 5, 1e-2),
        coarse("8 steps a turn, gap 1e-3", 8, 1e-3),
    };
    return kCases;
}

std::vector<Case> allCases()
{
    const std::span<const Case> nominal = nominalCases();
    const std::span<const Case> hard = hardCases();
    std::vector<Case> result(nominal.begin(), nominal.end());
    result.insert(result.end(), hard.begin(), hard.end());
    return result;
}

std::vector<double> squareInstants(const Case &which)
{
    const Parameters &parameters = which.parameters;
    if (parameters.omega2 == 0.0) {
        return {};
    }

    // |c - a sin θ2| is stationary at ±90°, and b where sin θ2 = (c ± b)/a.
    std::vector<double> angles{0.5 * std::numbers::pi, -0.5 * std::numbers::pi};
    for (const double height : {parameters.b, -parameters.b}) {
        const double sine = (parameters.c + height) / parameters.a;
        if (std::abs(sine) < 1.0) {
            angles.push_back(std::asin(sine));
            angles.push_back(std::numbers::pi - std::asin(sine));
        }
    }

    constexpr int kMostTurns = 10;
    const double from = which.sampling.start;
    const double to = from + which.sampling.duration;
    const double turnTime = kTurn / std::abs(parameters.omega2);
    std::vector<double> result;
    for (const double angle : angles) {
        const double once = (angle - parameters.theta20) / parameters.omega2;
        const double turns = std::ceil((from - once) / turnTime);
        for (int k = 0; k < kMostTurns; ++k) {
            const double t = once + turnTime * (turns + k);
            if (t >= from && t <= to) {
                result.push_back(t);
            }
        }
    }
    std::sort(result.begin(), result.end());
    return result;
}

std::vector<double> instantsOf(const Case &which)
{
    std::vector<double> result = which.sampling.instants();
    const std::vector<double> square = squareInstants(which);
    result.insert(result.end(), square.begin(), square.end());
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
}

} // namespace slidercrank
