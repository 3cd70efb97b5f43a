// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The named mechanisms that tests, benchmarks and the study share: ordinary ones, and those where accuracy, the branch
// or the existence of a position is at risk.
//
// Lengths in mm, angles in rad, time in s.

#include "core/mechanism/mechanism.h"
#include "core/sampling/trajectory.h"

#include <span>
#include <string>
#include <vector>

namespace slidercrank
{

struct Case {
    std::string name; ///< unique; comma-separated properties: "toggle gap 1e-4, crossed"
    Parameters parameters;
    Sampling sampling{}; ///< one turn, unless the case is about time
};

/// Where every method has to be right to the last digits.
std::span<const Case> nominalCases();

/// Where a method may fail, but has to say so.
std::span<const Case> hardCases();

/// nominalCases(), then hardCases().
std::vector<Case> allCases();

/// The doubles nearest to the sampled times at which the coupler comes closest to perpendicular to the slider's line:
/// θ2 an odd multiple of 90°, and the limits of a rocker. Of the first ten turns; ascending.
std::vector<double> squareInstants(const Case &which);

/// The time stamps of the sampling and squareInstants(), ascending.
std::vector<double> instantsOf(const Case &which);

} // namespace slidercrank
