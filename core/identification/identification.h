// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Which mechanism made these data: (a, b, c, ω2, θ20) and the assembly, from every column that a mechanism can say
// anything about, each read as the file says; and how sure that is. Starts come from the data themselves
// (motion_start.h); the fit weighs each value by what it is known to (motion_fit.h); a mechanism is claimed only where
// what is left is rounding or looks like noise (standing.h), where the data fix it, and where no other explains them as
// well (decision.h). θ2 and θ3 are taken up to whole turns.
//
// Lengths in mm, angles in rad, time in s; the data in the author's units (mm, °, s).

#include "core/mechanism/channel.h"
#include "core/mechanism/mechanism.h"
#include "core/import/reference_data.h"

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
        Approximate,  ///< explained up to a systematic deviation of at most 1 %: no standard errors
        Insufficient, ///< too few values, rows a turn or columns to tell
        Nearest,      ///< nothing found stands; this comes nearest
        None          ///< not even that
    };
    Outcome outcome = Outcome::None;
    bool stopped = false; ///< nothing else counts

    /// Whether there is a mechanism that explains the file, at least approximately.
    bool stands() const { return hasOneMechanism() || (!stopped && outcome == Outcome::Ambiguous); }

    /// Whether there is exactly one such mechanism.
    bool hasOneMechanism() const
    {
        return !stopped && (outcome == Outcome::Identified || outcome == Outcome::Approximate);
    }

    /// Identified, Approximate, Ambiguous: the (first) mechanism; Nearest: what comes nearest; else the mechanism at hand. θ20 in
    /// (-π, π]; what is not identifiable is as in the mechanism at hand.
    Parameters parameters;

    /// One standard deviation, by indexOf(Parameter), in the parameter's unit. NaN where not identifiable (but see
    /// onlyRatios), and unless Identified or Ambiguous.
    std::array<double, kParameterCount> standardError{};

    /// All true where stands() (but see onlyRatios), all false else.
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

    /// A column that takes no part in the fit.
    struct LeftOut {
        Channel channel;
        double percentOfPeak = 0.0; ///< its largest deviation from the mechanism found
    };
    std::vector<LeftOut> leftOut;

    std::vector<std::size_t> excludedRows; ///< outliers: their lines in the file, counted from 1

    int iterations = 0;           ///< of Levenberg-Marquardt, from the start that led here
    double conditionNumber = 0.0; ///< of the weighted Jacobian, columns scaled to length 1, identifiable parameters
    double rms = 0.0;             ///< of the residuals in steps of the file's rounding: 0.29 when only that is left

    /// Nothing is known of the parameters any more, whatever they are.
    void claimNothing();

    /// Finds nothing where a parameter is beyond what a mechanism may have: a fit may run off to there, or the file may
    /// be of lengths and speeds that nothing has. Then the mechanism at hand is what is given.
    void keepToMechanisms(const Parameters &atHand);
};

/// `start` gives the crank's length where the data hold no length, is the mechanism given where none is found, and is
/// itself one of the starts tried.
Identification identify(const ReferenceData &data, const Mechanism &start, std::stop_token stop = {});

} // namespace slidercrank
