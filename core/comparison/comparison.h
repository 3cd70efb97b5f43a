// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// How far reference data are from the model: largest and mean errors, the pointwise percentage, and whether the
// difference is within the file's own rounding. All values are in the units of files (mm, °, s); an error is model -
// reference.
//
// A value is uncertain by half its own step, and by how far the motion f goes while the time stamp t is uncertain by
// half of its step τ:
//
//     bound = step / 2 + max(|f(t + τ/2) - f(t)|, |f(t - τ/2) - f(t)|)
//
// (on both sides: at a turning point the rate is 0, and the error is not). What lies beyond the bound must also be
// small next to the motion, because a step may have been inferred too large, and a motion may be small next to its
// step. The time stamps of an even clock are taken as exact (τ = 0); if a file then differs, they may have been rounded
// all the same (0.0133 for 0.013303), and the file may still be close. If a clock does not show that it was rounded,
// what τ adds must be small next to the motion, too.

#include "core/import/reference_data.h"
#include "core/mechanism/channel.h"
#include "core/sampling/trajectory.h"

#include <limits>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

namespace slidercrank
{

enum class Verdict {
    Agrees, ///< at least 95 % of the errors within the bound, none beyond ten bounds, excess at most 0.5 %
    Close,  ///< none beyond a hundred bounds, excess at most 1 %
    Differs
};
inline constexpr std::size_t kPercentWithinBound = 95;
inline constexpr double kBoundsOfAgreement = 10.0;
inline constexpr double kBoundsOfCloseness = 100.0;
inline constexpr double kExcessOfAgreement = 0.005;
inline constexpr double kExcessOfCloseness = 0.01;

struct ChannelComparison {
    Channel channel;
    std::size_t count = 0;        ///< instants where both values exist
    std::size_t missingModel = 0; ///< instants where the file has a value and the model none

    // Absent where there is nothing to compare.
    std::optional<double> maxAbs;
    double timeOfMaxAbs = 0.0;
    std::optional<double> rms;

    /// |model - reference| / |reference| · 100, over the time stamps at which the reference is not zero within its
    /// rounding.
    std::optional<double> maxPercent;
    double timeOfMaxPercent = 0.0;
    std::size_t zeroReference = 0; ///< time stamps left out of maxPercent

    double peak = 0.0; ///< the reference's largest magnitude

    /// maxAbs as % of the peak.
    std::optional<double> percentOfPeak;

    /// The file's rounding step where it is largest; absent when the column gives no hint.
    std::optional<double> roundingStep;

    /// How far the values are off in the measure of the verdict: how many lie within their bound, how many bounds the
    /// worst is away, and how far beyond its bound any is at most, as a part of half the motion's range (infinite where
    /// those are no finite numbers).
    std::size_t withinBound = 0;
    double worstOver = 0.0;
    double excess = 0.0;

    /// The clock is even, and the file is close only if it was rounded nevertheless; the numbers above assume so.
    bool clockIsRounded = false;

    Verdict verdict = Verdict::Differs;
};

/// A file may carry more digits than any double-precision computation can promise. No step is taken to be smaller than
/// this part of the channel's size (the larger of its peak and its naturalSize()).
inline constexpr double kArithmeticStep = 1e-12;

/// Nor smaller than this part of its largest: a value of -7.4e-15 next to others of a hundred is a zero, and its digits
/// mean nothing.
inline constexpr double kSmallestPartOfLargestStep = 0.01;

/// What a channel's errors are compared with, in the unit of files.
struct ChannelSize {
    double natural = 1.0; ///< naturalSize()

    /// What counts as half the motion's range: for a channel that stands still, this; for the others the model's, at
    /// most `most`.
    double still = 0.0;
    double most = std::numeric_limits<double>::infinity();
};

/// A channel that stands still has the range of those that move with it: a or 1 rad, times |ω2|^k for the k-th
/// derivative. Of θ2 no more than π counts.
ChannelSize sizeOf(const Mechanism &mechanism, Channel channel);

/// Compares one channel, with exact time stamps. `time`, `model` and `reference.values` have one value per time stamp;
/// NaN means none.
ChannelComparison compareChannel(std::span<const double> time, std::span<const double> model,
                                 const ReferenceSeries &reference, const ChannelSize &size);

/// Compares every column of the file with a trajectory sampled at the file's own time stamps, by any method. The effect
/// of rounded time stamps is computed from the exact motion.
std::vector<ChannelComparison> compare(const Mechanism &mechanism, const Trajectory &model,
                                       const ReferenceData &reference);

/// Compares every column of the file with the exact motion. Incomplete when stopped.
struct ExactComparison {
    std::vector<ChannelComparison> channels;
    std::vector<Status> status; ///< of the motion, one per time stamp
};
ExactComparison compareExactly(const Mechanism &mechanism, const ReferenceData &reference, std::stop_token stop = {});

/// How far one mechanism's exact motion is from another's: in the order of kPlottedChannels, with the other one as the
/// reference.
struct MotionDifference {
    std::vector<ChannelComparison> channels;
    bool hasGaps = false; ///< at some time stamps one of the two cannot be assembled
};
using ChannelDifference = ChannelComparison;

/// Samples both from one time (s) to the other, and compares them like a file.
MotionDifference differenceOf(const Mechanism &mechanism, const Mechanism &other, double from, double to);

} // namespace slidercrank
