// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Compares reference data with the model: largest and rms errors, the largest pointwise percentage, and whether
// rounding in the file explains the difference. All values are in the units of files (mm, °, s); an error is model -
// reference. Crank angles are compared up to whole turns, as files may count them from zero again after each turn.
//
// Rounding explains an error within a bound: half the rounding step of the value, plus the change of the motion f
// within half the rounding step τ of the time stamp t:
//
//     bound = step / 2 + max(|f(t + τ/2) - f(t)|, |f(t - τ/2) - f(t)|)
//
// (on both sides, because at a turning point the rate of f is 0 and the error is not). The excess over the bound must
// also be small compared with the motion, because a step may have been inferred too large, and a motion may be small
// compared with its step. Evenly spaced time stamps are taken as exact (τ = 0). If the file then differs, they may
// nevertheless have been rounded (0.0133 for 0.013303), and the file may still be close. If time stamps do not show
// that they were rounded, the contribution of τ must also be small compared with the motion. If the mechanism was
// fitted to the same file, the bound contains the error of the fit, too (FittedMechanism).

#include "core/import/reference_data.h"
#include "core/mechanism/channel.h"
#include "core/sampling/trajectory.h"

#include <cmath>
#include <cstddef>
#include <optional>
#include <stop_token>
#include <vector>

namespace slidercrank
{

/// The verdict on a column. The bound of an error is the uncertainty of the value, from the rounding of the file; the
/// excess is ChannelComparison::excess.
enum class Verdict {
    Agrees, ///< at least 95 % of the errors within the bound, none beyond ten bounds, excess at most 0.5 %
    Close,  ///< none beyond a hundred bounds, excess at most 1 %
    Differs
};
inline constexpr std::size_t kMinPercentWithinBound = 95;
inline constexpr double kMaxBoundsToAgree = 10.0;
inline constexpr double kMaxBoundsToBeClose = 100.0;
inline constexpr double kMaxExcessToAgree = 0.005;
inline constexpr double kMaxExcessToBeClose = 0.01;

struct ChannelComparison {
    Channel channel;
    std::size_t count = 0; ///< time stamps at which both values exist

    /// Time stamps at which only the file has a value, except where their rounding explains that the model has none.
    std::size_t missingModelCount = 0;

    // Empty if there is nothing to compare.
    std::optional<double> largestError;
    double timeOfLargestError = 0.0; ///< s
    std::optional<double> rms;

    /// |model - reference| / |reference| · 100, over the time stamps at which the reference is not zero within its
    /// rounding.
    std::optional<double> maxPercent;
    double timeOfMaxPercent = 0.0;      ///< s
    std::size_t zeroReferenceCount = 0; ///< time stamps left out of maxPercent

    double peak = 0.0; ///< largest magnitude of the reference

    /// largestError in percent of the peak.
    std::optional<double> percentOfPeak;

    /// The largest rounding step of the column; empty if the column does not reveal it.
    std::optional<double> roundingStep;

    // The measures of the verdict: the number of errors within their bound, the largest ratio of an error to its bound,
    // and the largest excess over a bound relative to half the motion's range (infinite if that is not finite).
    std::size_t countWithinBound = 0;
    double largestErrorInBounds = 0.0;
    double excess = 0.0;

    /// The verdict and its measures assume rounded time stamps. The file does not show that rounding, because its time
    /// stamps are evenly spaced; with exact time stamps the column would differ.
    bool clockIsRounded = false;

    Verdict verdict = Verdict::Differs;

    /// The verdict is Differs, but the rounding of the time stamps explains the errors (findRoundedTime()).
    bool isWithinRoundedTime = false;
};

/// The smallest rounding step, relative to the channel's size (the larger of its peak and its naturalSize()): a file
/// may have more digits than a double-precision computation can guarantee.
inline constexpr double kArithmeticStep = 1e-12;

/// The smallest rounding step, relative to the largest one of the column: the digits of a value of -7.4e-15 next to
/// values near 100 have no meaning.
inline constexpr double kSmallestFractionOfLargestStep = 0.01;

/// How a mechanism was fitted to the file with which it is compared. Its parameters contain a part of the errors of the
/// values, so that its motion is off, too: by the rms of the errors times √(unknowns/values), one standard error.
struct FittedMechanism {
    std::size_t unknowns = 0; ///< 0: the mechanism was not fitted
    double values = 1.0;      ///< number of values that were fitted

    /// Returns three standard errors of the motion in a column, from the rms of its errors. compare() adds them
    /// to the bounds of the column, but at most the largest bound from rounding, because a fit of rounded values is no
    /// less exact than the least exact value.
    double errorOf(double rms) const { return 3.0 * rms * std::sqrt(static_cast<double>(unknowns) / values); }
};

/// Compares every column of the file with a trajectory sampled at the file's own time stamps, by any method. The effect
/// of rounded time stamps is computed from the exact motion. `fitted`: increases the bounds of a fitted mechanism.
std::vector<ChannelComparison> compare(const Mechanism &mechanism, const Trajectory &model,
                                       const ReferenceData &reference, const FittedMechanism &fitted = {});

/// Sets `isWithinRoundedTime` of the channels that differ. Requires `channels` to be the result of compare() for the
/// same mechanism, trajectory and file.
///
/// compare() limits the effect of time stamps that do not show whether they were rounded: without a limit, every
/// mechanism would agree with coarse time stamps. Uneven time stamps, however, are often the rounded ones of a solver
/// that chooses its steps. For uneven time stamps, this function finds whether errors of half a unit of their last
/// digit explain the differences, however large their effect is.
void findRoundedTime(std::vector<ChannelComparison> &channels, const Mechanism &mechanism, const Trajectory &model,
                     const ReferenceData &reference);

/// The comparison of every column of the file with the exact motion; incomplete if stopped.
struct ExactComparison {
    std::vector<ChannelComparison> channels;
    std::vector<Status> status; ///< the status of the motion at each time stamp
};

ExactComparison compareExactly(const Mechanism &mechanism, const ReferenceData &reference, std::stop_token stop = {},
                               const FittedMechanism &fitted = {});

/// The comparison of a mechanism's exact motion with that of a second mechanism, the reference, in the order of
/// kPlottedChannels.
struct MotionDifference {
    std::vector<ChannelComparison> channels;
    bool hasGaps = false; ///< one of the two cannot be assembled at some time stamps
};

/// Compares the motion of `mechanism` between two times (s) with that of `reference`, as with a file of exact values.
MotionDifference differenceOf(const Mechanism &mechanism, const Mechanism &reference, double from, double to);

} // namespace slidercrank
