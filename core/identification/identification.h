// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The answer to "which mechanism made these data": its parameters, how sure they are, and what took no part in finding
// them. Lengths in mm, angles in rad, time in s; the data in the units of the files (mm, °, s).

#include "core/mechanism/channel.h"
#include "core/mechanism/mechanism.h"

#include <array>
#include <cstddef>
#include <vector>

namespace slidercrank
{

struct Identification {
    enum class Outcome {
        Identified,   ///< what is left is rounding, or noise that looks like noise
        Ambiguous,    ///< several mechanisms explain the file equally
        Approximate,  ///< explained up to a systematic deviation of at most 1 %: no standard errors
        Insufficient, ///< too few values, rows a turn or columns to tell
        Nearest,      ///< nothing found stands; this comes nearest
        None          ///< not even that
    };
    Outcome outcome = Outcome::None;
    bool stopped = false; ///< nothing else counts

    /// Whether there is a mechanism that explains the file, at least approximately.
    bool hasMechanism() const { return hasOneMechanism() || (!stopped && outcome == Outcome::Ambiguous); }

    /// Whether there is exactly one such mechanism.
    bool hasOneMechanism() const
    {
        return !stopped && (outcome == Outcome::Identified || outcome == Outcome::Approximate);
    }

    /// Identified, Approximate, Ambiguous: the (first) mechanism; Nearest: what comes nearest; else the mechanism at
    /// hand. θ20 in
    /// (-π, π]; what is not identifiable is as in the mechanism at hand.
    Parameters parameters;

    /// One standard deviation, by indexOf(Parameter), in the parameter's unit. NaN where not identifiable (but see
    /// onlyRatios), and unless Identified or Ambiguous.
    std::array<double, kParameterCount> standardError{};

    /// All true where hasMechanism() (but see onlyRatios), all false else.
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
        FewTimeStamps,  ///< with values
        NothingMoves,   ///< the values are the same throughout
        NoEvidence,     ///< what fits could fit by chance: too few values for so many free parameters
        OpenParameters, ///< some parameters are not fixed: openParameters names them
        NotParabolic    ///< fits, but a family of others nearly as well
    };
    Lack lack = Lack::Nothing;
    std::array<bool, kParameterCount> openParameters{};

    struct Noise {
        Channel channel;
        double rms = 0.0; ///< in the author's unit
    };
    std::vector<Noise> noise; ///< the columns whose residuals are noise beyond rounding

    /// A column that takes no part in the fit.
    struct LeftOut {
        Channel channel;
        double percentOfPeak = 0.0; ///< its largest deviation from the mechanism found
    };
    std::vector<LeftOut> leftOut;

    std::vector<std::size_t> excludedRows; ///< outliers: their lines in the file, counted from 1

    int iterations = 0;           ///< of Levenberg-Marquardt, from the start that led here
    double conditionNumber = 0.0; ///< of the weighted Jacobian, columns scaled to length 1, identifiable parameters

    /// Nothing is known of the parameters any more, whatever they are.
    void claimNothing();

    /// Becomes None, with the given parameters, where a parameter is beyond what a mechanism may have.
    void rejectImpossible(const Parameters &given);
};

} // namespace slidercrank
