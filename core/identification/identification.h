// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Which mechanism made these data: (a, b, c, ω2, θ20) and the assembly, from any of the six plotted channels, by
// weighted least squares. A start is found from the data themselves, then Levenberg-Marquardt with exact derivatives;
// each value weighs by the step that the file rounded it to, less where a channel scatters more than that. What the
// given columns cannot fix is said, and kept as it was. θ3 is taken up to whole turns.
//
// Source: K. Levenberg 1944, D. W. Marquardt 1963 as in J. J. Moré, "The Levenberg-Marquardt algorithm", 1978.
// Lengths in mm, angles in rad, time in s; the data in the author's units (mm, °, s).

#include "core/mechanism/channel.h"
#include "core/mechanism/mechanism.h"
#include "core/reading/reference_data.h"

#include <array>
#include <cstddef>
#include <stop_token>
#include <vector>

namespace slidercrank
{

struct Identification {
    enum class Outcome {
        Identified,   ///< what is left is rounding, or noise that looks like noise
        Ambiguous,    ///< several mechanisms explain the file equally
        Insufficient, ///< too few values, rows a turn or columns to tell
        Nearest,      ///< nothing found stands; this comes nearest
        None          ///< not even that
    };
    Outcome outcome = Outcome::None;
    bool stopped = false; ///< nothing else counts

    /// Whether there is a mechanism that explains the file.
    bool stands() const { return !stopped && (outcome == Outcome::Identified || outcome == Outcome::Ambiguous); }

    /// Identified, Ambiguous: the (first) mechanism; Nearest: what comes nearest; else the mechanism at hand. θ20 in
    /// (-π, π]; what is not identifiable is as in the mechanism at hand.
    Parameters parameters;

    /// One standard deviation, by indexOf(Parameter), in the parameter's unit. NaN where not identifiable (but see
    /// onlyRatios), and unless Identified or Ambiguous.
    std::array<double, kParameterCount> standardError{};

    /// Not so: what would be known no better than to its own size, and may as well be as it was. All false unless
    /// Identified or Ambiguous.
    std::array<bool, kParameterCount> identifiable{};

    /// θ3 alone, with or without its derivatives: only the ratios b/a and c/a are fixed. a is as it was, b and c follow
    /// from it and have the standard errors they have for that a; none of the three counts as identifiable.
    bool onlyRatios = false;

    /// Another mechanism that the file may as well be of.
    struct Alternative {
        enum class Why {
            // Images that no column excludes, however exact; given where the mechanism is Identified, too.
            MirrorImage,     ///< R4x alone: c, ω2 and θ20 negated
            Reversed,        ///< θ3 alone: the crank turns the other way, from π - θ20
            OtherAssembly,   ///< derivatives of θ3 alone: c negated, θ20 half a turn on
            Alias,           ///< another speed meets the same instants
            AnotherMechanism ///< explains the file as well
        };
        Why why = Why::AnotherMechanism;
        Parameters parameters;
    };
    std::vector<Alternative> alternatives;

    /// Why Insufficient, the first that holds.
    enum class Lack {
        Nothing,        ///< it is not
        FewValues,      ///< of the six channels
        FewInstants,    ///< with values
        NothingMoves,   ///< the values are the same throughout
        NoEvidence,     ///< what fits could fit by chance: too few values for so many free parameters
        OpenParameters, ///< some parameters are not fixed: openParameters names them
        Crooked         ///< fits, but a family of others nearly as well
    };
    Lack lack = Lack::Nothing;
    std::array<bool, kParameterCount> openParameters{};

    struct Noise {
        Channel channel;
        double rms = 0.0; ///< in the author's unit
    };
    std::vector<Noise> noise; ///< the columns whose residuals are noise beyond rounding

    int iterations = 0;           ///< of Levenberg-Marquardt, from the start that led here
    double conditionNumber = 0.0; ///< of the weighted Jacobian, columns scaled to length 1, identifiable parameters
    double rms = 0.0;             ///< of the residuals in steps of the file's rounding: 0.29 when only that is left
};

/// `start` gives what the data cannot fix, and is itself one of the starts tried.
Identification identify(const ReferenceData &data, const Mechanism &start, std::stop_token stop = {});

} // namespace slidercrank
