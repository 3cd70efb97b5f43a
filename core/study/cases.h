// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The named mechanisms that tests, benchmarks and the study share: the ordinary ones, and those where accuracy, a
// branch or the very existence of a position is at stake. A name reads as a case; it is unique.
//
// Lengths in mm, angles in rad, time in s.

#include "core/mechanism/mechanism.h"
#include "core/run/trajectory.h"

#include <span>
#include <string_view>
#include <vector>

namespace slidercrank
{

struct Case {
    std::string_view name;
    Parameters parameters;
    Sampling sampling; ///< one turn, unless the case is about time
};

/// Where every method has to be right to the last digits.
std::span<const Case> nominalCases();

/// Where a method may fail, but has to say so.
std::span<const Case> hardCases();

/// nominalCases(), then hardCases().
std::vector<Case> allCases();

/// The nearest doubles to those instants of a run at which the coupler comes closest to standing square to the slider's
/// line: θ2 an odd multiple of 90°, and the limits of a rocker. Of the first ten turns; ascending.
std::vector<double> squareInstants(const Case &which);

/// The instants of the run and squareInstants(), ascending.
std::vector<double> instantsOf(const Case &which);

} // namespace slidercrank
