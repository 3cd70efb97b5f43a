// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Lists the named mechanisms that tests, benchmarks and the study share: ordinary ones, and those that are difficult
// for a solver because of accuracy, of the branch, or because they cannot always be assembled.
//
// Lengths in mm, angles in rad, time in s.

#include "core/mechanism/mechanism.h"
#include "core/sampling/trajectory.h"

#include <string>
#include <vector>

namespace slidercrank
{

struct Case {
    std::string name; ///< unique; comma-separated properties: "toggle gap 1e-4, crossed"
    Parameters parameters;
    Sampling sampling{}; ///< one revolution, unless the case is about time
};

/// Returns the cases in which every method has to be accurate to the last digits.
std::vector<Case> nominalCases();

/// Returns the cases in which a method may fail, but has to report it.
std::vector<Case> hardCases();

/// Returns the times (s) within the sampled time span at which the coupler is closest to perpendicular to the slider's
/// line: θ2 an odd multiple of 90°, and the limit positions of a rocker. Covers the first ten revolutions; ascending.
std::vector<double> perpendicularTimes(const Case &namedCase);

/// Returns the time stamps of the sampling and perpendicularTimes(), ascending.
std::vector<double> timeStampsOf(const Case &namedCase);

} // namespace slidercrank
