// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A mechanism together with the conventions that make a file its motion: how one is found column by column, what there
// is to believe in it, and whether it stands. What convention.h offers is the cheapest that does.

#include "core/comparison/comparison.h"
#include "core/identification/convention.h"
#include "core/identification/observations.h"
#include "core/sampling/trajectory.h"

#include <optional>
#include <span>
#include <stop_token>
#include <vector>

namespace slidercrank
{

/// A mechanism, and how the file is to be read to be its motion.
struct Explanation {
    Parameters parameters;
    std::vector<Convention> conventions; ///< in the order of application
    double timeUnit = 1.0;               ///< that of the TimeUnit among them
};

/// The explanation with what is wrong with the columns if its mechanism is right; none where a column cannot be
/// understood. It comes with the conventions that concern the file as a whole.
std::optional<Explanation> explain(const ReferenceData &data, Explanation explanation);

/// How much there is to believe: first the number of findings, then of columns that they change.
double costOf(const Explanation &explanation);

/// The explanation with every column that is no derivative found out, or none where it does not stand: the position
/// columns have to agree with the mechanism as far as the file's digits go.
std::optional<Explanation> proven(const ReferenceData &data, Explanation explanation);

/// Each convention with the errors without and with it.
std::vector<ConventionFinding> findingsOf(const ReferenceData &data, const Explanation &explanation);

/// The file as the motion of this very mechanism.
std::optional<Explanation> explainedAtHand(const ReferenceData &data, const Parameters &atHand,
                                           const std::stop_token &stop);

// ---- what these share ----------------------------------------------------------------------------------------------

/// The data read by all these conventions, and the motion that they are then to be.
struct ReadMotion {
    ReferenceData read;
    Trajectory model;

    ReadMotion(const ReferenceData &data, const Explanation &explanation);
};

ReferenceData allApplied(std::span<const Convention> conventions, ReferenceData data);
bool concerns(const Convention &convention, Channel channel);

/// Whether the file has the coordinate of that channel, or a lower derivative of it.
bool hasLowerOrder(const ReferenceData &data, Channel channel);

/// The closed form, in the author's units.
Trajectory motionOf(const Parameters &parameters, std::span<const double> time, const ChannelSet &channels);

/// Root mean square of the errors, as part of that of the model about its mean.
double rmsMisfit(std::span<const double> values, std::span<const double> model);

/// So many rows at least, spread evenly.
ReferenceData everySoManyth(const ReferenceData &data, std::size_t rows);

} // namespace slidercrank
