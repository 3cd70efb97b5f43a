// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The result of an identification: the parameters of the mechanism that made the data, their standard errors, and the
// columns and rows that were not used. Lengths in mm, angles in rad, time in s; data in the units of files (mm, °, s).

#include "core/mechanism/channel.h"
#include "core/mechanism/mechanism.h"

#include <array>
#include <cstddef>
#include <vector>

namespace slidercrank
{

struct Identification {
    enum class Outcome {
        Identified,   ///< the residuals are rounding errors or white noise
        Ambiguous,    ///< several mechanisms or interpretations explain the file equally well
        Approximate,  ///< the residuals are systematic, at most 1 % of the range: no standard errors
        Insufficient, ///< the file does not determine the mechanism
        Nearest,      ///< no mechanism explains the file; this is the nearest one
        None          ///< no mechanism is near
    };
    Outcome outcome = Outcome::None;
    bool stopped = false; ///< the search was stopped, and the rest is incomplete

    /// Whether there is a mechanism that explains the file, at least approximately.
    bool hasMechanism() const { return hasOneMechanism() || (!stopped && outcome == Outcome::Ambiguous); }

    /// Whether there is exactly one such mechanism.
    bool hasOneMechanism() const
    {
        return !stopped && (outcome == Outcome::Identified || outcome == Outcome::Approximate);
    }

    /// The mechanism found (Ambiguous: the first one), or the nearest one; otherwise the given mechanism. θ20 is in
    /// (-π, π]. Parameters that are not identifiable are those of the given mechanism.
    Parameters parameters;

    /// Standard errors by indexOf(Parameter). NaN for parameters that are not identifiable (but see onlyRatios), and
    /// unless the outcome is Identified or Ambiguous.
    std::array<double, kParameterCount> standardError{kNone, kNone, kNone, kNone, kNone};

    /// Whether the file determines the parameter. All false unless hasMechanism().
    std::array<bool, kParameterCount> identifiable{};

    /// The file contains no length but θ3, which determines only b/a and c/a. a is that of the given mechanism, and b
    /// and c and their standard errors are for this a. None of the three is identifiable.
    bool onlyRatios = false;

    /// Another mechanism that explains the file equally well.
    struct Alternative {
        enum class Why {
            // Images that no column excludes, however exact. Listed for Identified, too.
            MirrorImage,     ///< R4x alone: c, ω2 and θ20 negated
            Reversed,        ///< θ3 alone: the crank rotates in the opposite direction, from π - θ20
            OtherAssembly,   ///< derivatives of θ3 alone: c negated, θ20 increased by π
            Alias,           ///< another speed gives the same values at the same times
            AnotherMechanism ///< another mechanism, or another interpretation of the file
        };
        Why why = Why::AnotherMechanism;
        Parameters parameters;
    };
    std::vector<Alternative> alternatives;

    /// The reason for Insufficient; the first that applies.
    enum class Lack {
        FewValues,      ///< too few values or time stamps for the number of parameters: the fit could be chance
        NothingMoves,   ///< all values of each column are equal
        OpenParameters, ///< the file does not determine openParameters
        NotParabolic,   ///< a family of other mechanisms fits nearly as well
        Nothing         ///< the outcome is not Insufficient
    };
    Lack lack = Lack::Nothing;
    std::array<bool, kParameterCount> openParameters{};

    struct Noise {
        Channel channel;
        double rms = 0.0; ///< in the unit of files
    };
    std::vector<Noise> noise; ///< the columns with noise in addition to rounding

    /// A column that the fit does not use.
    struct LeftOut {
        Channel channel;
        double percentOfPeak = 0.0; ///< its largest deviation from the mechanism found
    };
    std::vector<LeftOut> leftOut;

    std::vector<std::size_t> excludedRows; ///< outliers: their lines in the file, counted from 1

    int iterations = 0;           ///< of Levenberg-Marquardt, from the start that led here
    double conditionNumber = 0.0; ///< of the weighted Jacobian, columns scaled to length 1, identifiable parameters
};

} // namespace slidercrank
