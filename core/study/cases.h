// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Lists the named mechanisms that tests, benchmarks and the study share: ordinary ones, and those that are difficult
// for a solver, because accuracy is lost, the branch may be left, or no position exists at some crank angles.
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
    Sampling sampling{}; ///< about one revolution; one second if the crank does not turn
};

/// Returns the cases in which closed form and Newton-Raphson have to be accurate to the last digits.
std::vector<Case> nominalCases();

/// Returns the cases in which a method may fail, but has to report the failure.
std::vector<Case> hardCases();

/// Returns the times (s) within the sampled time span at which the coupler is closest to perpendicular to the slider's
/// line: θ2 an odd multiple of 90°, and the limit positions of a rocker. Covers the first ten revolutions; ascending.
std::vector<double> perpendicularTimes(const Case &namedCase);

/// Returns the time stamps of the sampling and perpendicularTimes(), ascending.
std::vector<double> timeStampsOf(const Case &namedCase);

} // namespace slidercrank
