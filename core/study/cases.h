// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The named mechanisms that tests, benchmarks and the study share: the ordinary ones, and those where accuracy, a
// branch or the very existence of a position is at stake.
//
// Lengths in mm, angles in rad, time in s.

#include "core/mechanism/mechanism.h"
#include "core/sampling/trajectory.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace slidercrank
{

/// One of the things that make a case what it is.
struct CaseTrait {
    enum class Kind {
        Formula, ///< `value` itself: "c > 0"
        ReportTable,
        ThisMechanism, ///< of whoever asks
        AuthorsFile,
        Crossed,
        ToggleGap, ///< `value`
        ExactToggle,
        ChangePoint,
        EqualAndInLine, ///< a = b, c = 0
        Rocker,
        OneArc,
        TwoArcs,
        RockerByAHair,
        Gap, ///< `value`, to a toggle
        Locked,
        NeverAssemblable,
        LengthsTimes, ///< `value`
        TimeNear,     ///< `value`, with its unit
        StepsATurn    ///< `value`
    };
    Kind kind = Kind::Formula;
    std::string_view value{};

    friend bool operator==(const CaseTrait &, const CaseTrait &) = default;
};

/// "toggle gap 1e-4, crossed": what files and the command line call it; a window has words of its own.
std::string nameOf(std::span<const CaseTrait> traits);

struct Case {
    std::vector<CaseTrait> traits;
    Parameters parameters;
    Sampling sampling{};               ///< one turn, unless the case is about time
    std::string name = nameOf(traits); ///< unique
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
