// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// How far reference data lie from the model: largest and mean errors, the report's percentage, and whether the
// difference is within the file's own rounding. Everything in the author's units (mm, °, s); errors are model -
// reference.

#include "core/mechanism/channel.h"
#include "core/reading/reference_data.h"
#include "core/run/trajectory.h"

#include <optional>
#include <span>
#include <stop_token>
#include <vector>

namespace slidercrank
{

enum class Verdict {
    Agrees, ///< at least 95 % of the values within half a rounding step, none beyond ten halves
    Close,  ///< none beyond a hundred halves
    Differs
};
inline constexpr std::size_t kPercentWithinHalfStep = 95;
inline constexpr double kHalfStepsOfAgreement = 10.0;
inline constexpr double kHalfStepsOfCloseness = 100.0;

struct ChannelComparison {
    Channel channel;
    std::size_t count = 0;        ///< instants where both values exist
    std::size_t missingModel = 0; ///< instants where the file has a value and the model none

    // Absent where there is nothing to compare.
    std::optional<double> maxAbs;
    double timeOfMaxAbs = 0.0;
    std::optional<double> rms;

    /// |model - reference| / |reference| · 100, over the instants where the reference is not zero (nor so
    /// near it that no double holds the ratio).
    std::optional<double> maxPercent;
    double timeOfMaxPercent = 0.0;
    std::size_t zeroReference = 0; ///< instants left out of maxPercent

    /// maxAbs as % of the reference's largest magnitude.
    std::optional<double> percentOfPeak;

    /// The file's rounding step where it is largest; absent when the column gives no hint.
    std::optional<double> roundingStep;

    /// How far the values are off in the measure of the verdict, half a rounding step each at its own value: how many
    /// lie within one, and how many of them the worst is away (infinite where that is no finite number).
    std::size_t withinHalfStep = 0;
    double worstHalfSteps = 0.0;

    Verdict verdict = Verdict::Differs;
};

/// A file may carry more digits than any double-precision computation can promise. No step is taken to be smaller than
/// this part of the channel's size (the larger of its peak and its naturalScale()).
inline constexpr double kArithmeticStep = 1e-12;

/// One channel. `time`, `model` and `reference.values` have one value an instant; NaN means none.
/// `scale`: naturalScale() of the channel.
ChannelComparison compareChannel(std::span<const double> time, std::span<const double> model,
                                 const ReferenceSeries &reference, double scale);

/// Every series of the file against the exact motion, which is never in memory as a whole. Incomplete when stopped.
struct ExactComparison {
    std::vector<ChannelComparison> channels;
    std::vector<Status> status; ///< of the motion, one an instant
};
ExactComparison compareExactly(const Mechanism &mechanism, const ReferenceData &reference, std::stop_token stop = {});

/// Every series of the file against a trajectory sampled at the file's own instants.
std::vector<ChannelComparison> compare(const Mechanism &mechanism, const Trajectory &model,
                                       const ReferenceData &reference);

} // namespace slidercrank
