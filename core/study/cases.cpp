// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/cases.h"

#include "core/mechanism/turn.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <utility>

namespace slidercrank
{

namespace
{

using Trait = CaseTrait::Kind;
using Traits = std::vector<CaseTrait>;

/// By CaseTrait::Kind.
constexpr std::array<std::string_view, 19> kWords{"",
                                                  "Table 1 of the report",
                                                  "this mechanism",
                                                  "the author's file",
                                                  "crossed",
                                                  "toggle gap ",
                                                  "exact toggle",
                                                  "change point",
                                                  "a = b and c = 0",
                                                  "rocker",
                                                  "one arc",
                                                  "two arcs",
                                                  "rocker by a hair",
                                                  "gap ",
                                                  "locked",
                                                  "never assemblable",
                                                  "lengths x ",
                                                  "t near ",
                                                  " steps a turn"};

/// One turn in one second of a crank of 20 mm, which all but the scaled cases have.
Case lengths(Traits traits, double b, double c, Branch branch = Branch::Open)
{
    if (branch == Branch::Crossed) {
        traits.push_back({Trait::Crossed});
    }
    return {std::move(traits), {20.0, b, c, kTurn, 0.0, branch}};
}

/// The coupler is longer than a full turn needs by one part in `1/gap`.
Case toggle(Traits traits, double gap, double c, Branch branch = Branch::Open)
{
    return lengths(std::move(traits), (20.0 + std::abs(c)) * (1.0 + gap), c, branch);
}

double numberIn(std::string_view text)
{
    double number = 0.0;
    std::from_chars(text.data(), text.data() + text.size(), number);
    return number;
}

Case toggle(std::string_view gap, double c, Branch branch = Branch::Open)
{
    Traits traits{{Trait::ToggleGap, gap}};
    if (branch == Branch::Open) {
        traits.push_back({Trait::Formula, c > 0.0 ? "c > 0" : c < 0.0 ? "c < 0" : "c = 0"});
    }
    return toggle(std::move(traits), numberIn(gap), c, branch);
}

Case scaled(std::string_view factor)
{
    const double by = numberIn(factor);
    return {{{Trait::LengthsTimes, factor}}, {20.0 * by, 60.0 * by, 25.0 * by, kTurn, 0.0, Branch::Open}};
}

/// One turn in one second, or in the time that the speed asks for.
Case driven(CaseTrait trait, double omega2, double theta20, Sampling sampling)
{
    return {{trait}, {20.0, 60.0, 25.0, omega2, theta20, Branch::Open}, sampling};
}

/// Few steps a turn, where a warm start begins far from its answer.
Case coarse(std::string_view steps, std::string_view gap)
{
    Case result = toggle({{Trait::StepsATurn, steps}, {Trait::Gap, gap}}, numberIn(gap), 25.0);
    result.sampling.steps = static_cast<int>(numberIn(steps));
    return result;
}

std::vector<Case> makeHardCases()
{
    std::vector<Case> cases;
    for (const char *gap : {"1e-1", "1e-2", "1e-3", "1e-4", "1e-5", "1e-6", "1e-7", "1e-8", "1e-9", "1e-10", "1e-11",
                            "1e-12", "1e-13", "1e-14", "1e-15"}) {
        cases.push_back(toggle(gap, 25.0));
    }
    for (const double c : {0.0, -25.0}) {
        for (const char *gap : {"1e-1", "1e-2", "1e-3", "1e-4", "1e-6", "1e-8", "1e-12", "1e-15"}) {
            cases.push_back(toggle(gap, c));
        }
    }
    const std::array others{
        toggle("1e-4", 25.0, Branch::Crossed),
        toggle("1e-8", 25.0, Branch::Crossed),

        toggle({{Trait::ExactToggle}, {Trait::Formula, "c > 0"}}, 0.0, 25.0),
        toggle({{Trait::ExactToggle}, {Trait::Formula, "c < 0"}}, 0.0, -25.0),
        toggle({{Trait::ExactToggle}}, 0.0, 25.0, Branch::Crossed),
        toggle({{Trait::ChangePoint}, {Trait::EqualAndInLine}}, 0.0, 0.0),
        toggle({{Trait::ChangePoint}}, 0.0, 0.0, Branch::Crossed),

        lengths({{Trait::Rocker}, {Trait::OneArc}}, 40.0, 25.0),
        lengths({{Trait::Rocker}, {Trait::OneArc}, {Trait::Formula, "c < 0"}}, 40.0, -25.0),
        lengths({{Trait::Rocker}, {Trait::OneArc}}, 40.0, 25.0, Branch::Crossed),
        lengths({{Trait::Rocker}, {Trait::TwoArcs}}, 10.0, 5.0),
        lengths({{Trait::Rocker}, {Trait::TwoArcs}}, 10.0, 5.0, Branch::Crossed),
        lengths({{Trait::Rocker}, {Trait::TwoArcs}, {Trait::Formula, "c = 0"}}, 10.0, 0.0),
        toggle({{Trait::RockerByAHair}, {Trait::Gap, "-1e-8"}}, -1e-8, 25.0),
        lengths({{Trait::Locked}, {Trait::Formula, "b = |c| - a"}}, 5.0, 25.0),
        lengths({{Trait::NeverAssemblable}}, 4.0, 25.0),

        lengths({{Trait::Formula, "b/a = 1e3"}}, 2e4, 25.0),
        lengths({{Trait::Formula, "b/a = 1e9"}}, 2e10, 25.0),
        lengths({{Trait::Formula, "c/a = 5e4"}}, 1.1e6, 1e6),
        scaled("1e-9"),
        scaled("1e9"),

        driven({Trait::TimeNear, "1e9 s"}, kTurn, 0.0, {1e9, 1.0, 200}),
        driven({Trait::Formula, "omega2 = 0"}, 0.0, 1.0, {}),
        driven({Trait::Formula, "omega2 = 1e6 rad/s"}, 1e6, 0.0, {0.0, 6.25e-6, 200}),

        coarse("2", "1e-1"),
        coarse("3", "1e-1"),
        coarse("4", "1e-1"),
        coarse("5", "1e-1"),
        coarse("8", "1e-1"),
        coarse("5", "1e-2"),
        coarse("8", "1e-3"),
    };
    cases.insert(cases.end(), others.begin(), others.end());
    return cases;
}

} // namespace

std::string nameOf(std::span<const CaseTrait> traits)
{
    std::string name;
    for (const auto &[kind, value] : traits) {
        const std::string word(kWords[static_cast<std::size_t>(kind)]);
        const std::string number(value);
        name += (name.empty() ? "" : ", ") + (kind == Trait::StepsATurn ? number + word : word + number);
    }
    return name;
}

std::span<const Case> nominalCases()
{
    static const std::array kCases{
        Case{{{Trait::ReportTable}}, {}},
        lengths({{Trait::Formula, "b = 60"}, {Trait::AuthorsFile}}, 60.0, 25.0),
        lengths({{Trait::Formula, "b = 60"}}, 60.0, 25.0, Branch::Crossed),
        lengths({{Trait::Formula, "c = 0"}}, 60.0, 0.0),
        lengths({{Trait::Formula, "c = 0"}}, 60.0, 0.0, Branch::Crossed),
        lengths({{Trait::Formula, "c < 0"}}, 60.0, -25.0),
        lengths({{Trait::Formula, "c < 0"}}, 60.0, -25.0, Branch::Crossed),
        driven({Trait::Formula, "omega2 < 0"}, -kTurn, 0.0, {}),
        driven({Trait::Formula, "theta20 = 1 rad"}, kTurn, 1.0, {}),
        lengths({{Trait::Formula, "b/a = 10"}}, 200.0, 25.0),
    };
    return kCases;
}

std::span<const Case> hardCases()
{
    static const std::vector<Case> kCases = makeHardCases();
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
