// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Identifies the mechanism that produced the data of a file: its lengths, its drive, its assembly, and how the columns
// of the file have to be read. README.md in this folder explains the steps. Lengths in mm, angles in rad, time in s;
// what concerns a column is in the units of files (mm, °, s).

#include "core/comparison/comparison.h"
#include "core/identification/convention.h"
#include "core/import/reference_data.h"
#include "core/mechanism/channel.h"
#include "core/mechanism/mechanism.h"

#include <array>
#include <cstddef>
#include <optional>
#include <stop_token>
#include <vector>

namespace slidercrank
{

/// A statement about each parameter, at indexOf(Parameter): whether it is true of this parameter.
using ParameterFlags = std::array<bool, kParameterCount>;

/// A different mechanism whose motion is the same in all columns that the fit uses, if they are read in the same way.
struct AlternativeMechanism {
    enum class Symmetry {
        MirrorImage,   ///< R4_x alone: c, ω2 and θ20 negated
        ReversedCrank, ///< θ3 alone: the crank rotates in the opposite direction, from π - θ20
        OtherAssembly  ///< derivatives of θ3 alone: c negated, θ20 increased by π
    };
    Symmetry symmetry = Symmetry::MirrorImage;
    Parameters parameters;
};

/// A column that the fit does not use.
struct LeftOutColumn {
    enum class Reason {
        FiniteDifferences, ///< it agrees with difference quotients of a column of lower order, but not with the
                           ///< derivative
        UnevenSpeed,       ///< the speed of the crank changes, so that nothing predicts this derivative
        OpenSpeed, ///< ω2, or the unit in which it is counted, is not known; for θ2: it has gaps, or its rows are too
                   ///< far apart to show how many turns the crank makes
        OtherMotion, ///< it is the motion of a slider-crank of other dimensions
        Unknown
    };
    Channel channel;
    Reason reason = Reason::Unknown;

    /// Its largest deviation from the mechanism found, at the speed that suits it best if the speed is open. NaN if the
    /// speed is uneven, for θ2, and if the column and its prediction are zero.
    double percentOfPeak = kNone;
};

/// How far a column and the mechanism found are apart, without excluded rows: after the conventions are applied or, if
/// no mechanism explains the file, without them.
struct ColumnResidual {
    Channel channel;
    double rms = 0.0;
    double max = 0.0;
    double percentOfRange = 0.0; ///< max, in percent of the range of the column (largest minus smallest value); 0 for
                                 ///< constant columns, such as R4_y
};

/// The speed of the crank in a file that contains both θ2 and the time, if it is not constant.
struct UnevenDrive {
    double omega2 = 0.0;            ///< rad/s: at t = 0 of a run-up, otherwise the mean speed
    double standardError = kNone;   ///< standard error of omega2 in a run-up, rad/s; otherwise NaN
    double least = 0.0;             ///< the smallest speed in the file, rad/s
    double greatest = 0.0;          ///< the largest speed in the file, rad/s
    std::optional<double> alpha2{}; ///< angular acceleration, rad/s², if the speed changes evenly (run-up, run-down)
};

/// The only length of the given mechanism that has to be changed so that it explains the file, read with the
/// conventions found. A typing error is a typical cause.
struct LengthChange {
    Parameter parameter = Parameter::A;
    double value = 0.0; ///< mm
};

struct Identification {
    enum class Outcome { // the best first
        Identified,      ///< every used column is within its rounding
        Approximate,     ///< a mechanism explains every used column with residuals (rms) below 2 % of its range if they
                         ///< are noise, below 0.7 % if they are systematic
        Insufficient,    ///< the file does not determine the mechanism: see `lack`
        None             ///< no mechanism explains the file: see `rejection`
    };
    Outcome outcome = Outcome::None;
    bool stopped = false; ///< the search was stopped: only the parameters are set, to the given ones

    /// Whether there is a mechanism that explains the file.
    bool hasMechanism() const
    {
        return !stopped && (outcome == Outcome::Identified || outcome == Outcome::Approximate);
    }

    /// The mechanism found, with θ20 in (-π, π]. What the file does not determine is that of the given mechanism. If it
    /// determines only ratios of lengths, the lengths have these ratios and the given a or ω2 (see `lengthScale`). With
    /// an uneven drive, ω2 is UnevenDrive::omega2. Without a mechanism, the given one, apart from the parameters that
    /// an insufficient file determines.
    Parameters parameters;

    /// The parameters in as few decimals as explain the file equally well; otherwise equal to `parameters`. Lengths are
    /// rounded in `lengthUnit`.
    Parameters rounded;

    /// The unit of the lengths in the file, mm: 25.4 for inches. 1 if its columns are in different units, or none is a
    /// length.
    double lengthUnit = 1.0;

    /// Standard errors by indexOf(Parameter), if the residuals are independent errors. NaN for parameters that the file
    /// does not determine, and for all if the residuals are systematic. Insufficient: errors of what is determined,
    /// enlarged if the residuals are systematic.
    std::array<double, kParameterCount> standardErrors{kNone, kNone, kNone, kNone, kNone};

    /// Whether the file can contain the parameter and determines it. All false unless hasMechanism().
    ParameterFlags identifiable{};

    /// What determines the scale of the lengths. If it is not the file, only b/a and c/a are found, and none of the
    /// three lengths is identifiable.
    enum class LengthScale {
        Measured,
        GivenCrank, ///< the file contains only angles: a is that of the given mechanism
        GivenSpeed  ///< derivatives over the crank angle show only a · ω2: ω2 is that of the given mechanism
    };
    LengthScale lengthScale = LengthScale::Measured;

    /// The file proves that the residuals are systematic (filtered, interpolated or integrated values), so that nothing
    /// bounds the errors of the parameters.
    bool hasSystematicResiduals = false;

    /// Approximate: the columns were computed by the approximate formula of the textbooks, which takes the first two
    /// terms of a series, R4_x ≈ a cos θ2 ± (b - (c - a sin θ2)²/2b). It explains them within their rounding, and the
    /// parameters are those of this formula.
    bool followsApproximateFormula = false;

    /// The possible magnitudes of ω2 (rad/s) if the derivatives in a table over the crank angle do not show in which
    /// unit of angles they are: if "1/s" may mean rad/s or °/s, 360 rad/s and 360 °/s = 2π rad/s are possible. A
    /// tenth of the given ω2 and the given ω2 are both possible if the values may be in cm although their heading says
    /// mm. Empty if ω2 is determined or the table has no derivatives.
    std::vector<double> possibleSpeeds{};

    // These belong to Identified and Approximate only.
    std::vector<ConventionFinding> conventions{}; ///< how the file has to be read, in the order of application
    std::vector<AlternativeMechanism> alternatives{};
    /// Comparisons of the used columns with the mechanism found, read with the conventions, without excluded rows.
    std::vector<ChannelComparison> channels{};
    std::optional<UnevenDrive> drive{};
    std::optional<LengthChange> change{}; ///< set only if the given mechanism does not explain the file
    bool agreesWithGiven = false; ///< read with the conventions, no used column differs from the given mechanism

    std::vector<ColumnResidual> residuals{}; ///< residuals of the used columns; None: those of the best attempt
    std::vector<LeftOutColumn> leftOut{};
    std::vector<std::size_t> excludedRows{}; ///< lines in the file, from 1, of rows with outliers or typing errors

    /// The reason for Insufficient; the first that applies.
    enum class Lack {
        FewValues,      ///< too few values or rows for the number of unknowns
        NothingMoves,   ///< neither R4_x nor θ3 nor the centre of a link changes
        FewRowsPerTurn, ///< a file over the time with positions only: other speeds give the same values in all rows
        UnevenSpeed,    ///< derivatives only, and the crank speed varies: nothing predicts them
        OpenParameters, ///< the file does not determine openParameters
        Nothing         ///< the outcome is not Insufficient
    };
    Lack lack = Lack::Nothing;
    ParameterFlags openParameters{};

    /// The reason for None.
    enum class Rejection {
        LargeResiduals,   ///< the best attempt leaves `residuals`
        SliderLine,       ///< R4_y is not constant: the slider does not move along x
        CannotBeAssembled ///< no mechanism can be assembled in all rows
    };
    Rejection rejection = Rejection::LargeResiduals;

    int iterations = 0; ///< number of iterations of the last fit

    /// How much worse the last fit determines one combination of its (scaled) unknowns than another: the square root of
    /// the condition number of its normal matrix, scaled to a unit diagonal. 0 without a fit.
    double conditionNumber = 0.0;
};

/// Identifies the mechanism of a file. `given` supplies what the file does not determine, and is preferred among equal
/// answers. `stop`: ends the search early, see Identification::stopped.
Identification identify(const ReferenceData &data, const Mechanism &given, std::stop_token stop = {});

} // namespace slidercrank
