// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Which mechanism made these data: (a, b, c, ω2, θ20) and the assembly, from any of the six plotted channels, by
// weighted least squares. A start is found from the data themselves, then Levenberg-Marquardt with exact derivatives;
// each value weighs by the step that the file rounded it to, less where a channel scatters more than that. What the
// given columns cannot fix is said, and kept as it was. θ3 is taken up to whole turns.
//
// Source: K. Levenberg 1944, D. W. Marquardt 1963 as in J. J. Moré, "The Levenberg-Marquardt algorithm", 1978.
// Lengths in mm, angles in rad, time in s; the data in the author's units (mm, °, s).

#include "core/mechanism/mechanism.h"
#include "core/reading/reference_data.h"

#include <array>
#include <cstddef>
#include <stop_token>
#include <vector>

namespace slidercrank
{

struct Identification {
    enum class Status {
        Found,        ///< the data agree with it, or come as close as a least-squares minimum does
        TooFewData,   ///< fewer values than parameters, or none of the six channels
        NothingMoves, ///< the values are the same throughout
        NotFound,     ///< no start led to a mechanism that resembles the data; what came nearest, if anything
        Stopped
    };
    Status status = Status::NotFound;

    Parameters parameters; ///< θ20 in (-π, π]; what is not identifiable is as in the start

    /// One standard deviation, by indexOf(Parameter), in the parameter's unit; NaN where not identifiable (but see
    /// onlyRatios).
    std::array<double, kParameterCount> standardError{};

    /// Not so: what would be known no better than to its own size, and may as well be as in the start.
    std::array<bool, kParameterCount> identifiable{};

    // What no data of such columns can tell apart, however exact. Of two mechanisms that move alike, the one that turns
    // like the start is given.

    /// θ3 alone, with or without its derivatives: only the ratios b/a and c/a are fixed. a is as in the start, b and c
    /// follow from it and have the standard errors they have for that a; none of the three counts as identifiable.
    bool onlyRatios = false;

    /// θ3 alone: the crank may as well turn the other way, from π - θ20.
    bool reversePossible = false;

    /// Derivatives of θ3 alone: it may as well be the other assembly, with c negated and θ20 half a turn on.
    bool otherBranchPossible = false;

    /// R4x alone: it may as well be the mirror image, with c, ω2 and θ20 negated.
    bool mirrorImagePossible = false;

    int iterations = 0;           ///< of Levenberg-Marquardt, from the start that led here
    double conditionNumber = 0.0; ///< of the weighted Jacobian, columns scaled to length 1, identifiable parameters
    double rms = 0.0;             ///< of the residuals in steps of the file's rounding: 0.29 when only that is left
};

/// `start` gives what the data cannot fix, and is itself one of the starts tried.
Identification identify(const ReferenceData &data, const Mechanism &start, std::stop_token stop = {});

/// One parameter of the mechanism fitted alone, all others held: how much of the squared error that explains. Here
/// every channel weighs alike, by how much it varies: what is to be explained is far larger than rounding.
struct Attribution {
    Parameter parameter = Parameter::A;
    double value = 0.0;     ///< fitted
    double explained = 0.0; ///< 0 … 1: the part of the weighted sum of squares that is gone
};

/// Each of the five parameters, the one that explains most first. Empty when stopped, or where there is nothing to
/// compare.
std::vector<Attribution> attribute(const ReferenceData &data, const Mechanism &mechanism, std::stop_token stop = {});

} // namespace slidercrank
