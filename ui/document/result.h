// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The immutable data that the views draw. Session computes and publishes it.

#include "core/closed_form/closed_form.h"
#include "core/comparison/comparison.h"
#include "core/identification/identification.h"
#include "core/limits/mobility.h"
#include "core/sampling/trajectory.h"
#include "ui/document/reference_file.h"

#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

namespace slidercrank
{

/// Returns the solver settings with which the window and the commands begin.
SolverSettings initialSolver();

/// The mechanism at one time, in closed form.
struct Pose {
    double time = 0.0; ///< s
    Motion motion{};

    /// Returns whether the mechanism can be assembled at this time.
    bool exists() const { return motion.status == Status::Solved || motion.status == Status::Singular; }
};

Pose poseAt(const Parameters &parameters, double seconds);

inline constexpr std::size_t kMaxPinned = 4; ///< largest number of pinned motions: more curves could not be told apart

/// The settings that an edit may change.
struct Choices {
    Parameters parameters;
    Sampling sampling;
    SolverSettings solver;
    std::shared_ptr<const Reference> reference; ///< may be null
    std::vector<Parameters> pinned = {};        ///< the oldest first
    double alpha2 = 0.0; ///< rad/s²: acceleration of the crank in table, polygons and drawing, not in the curves

    friend bool operator==(const Choices &, const Choices &) = default;
};

/// Everything that the views draw.
struct Result {
    Choices choices; ///< from which the result was computed
    Mechanism mechanism;
    Sampling sampling;
    SolverSettings solver;
    SamplingSummary summary;
    /// The six plotted channels. Empty for a long motion in closed form, which is computed faster than it is stored.
    Trajectory trajectory;
    MotionLimits limits;
    std::shared_ptr<const Reference> reference; ///< may be null; an angle-indexed table has `mechanism`'s times
    std::vector<Parameters> pinned;             ///< the oldest first

    /// How far the model is from the motion that was pinned last; nullopt if there is a reference or no pinned motion.
    std::optional<MotionDifference> difference;

    /// Returns whether the model is compared with a file or with a pinned motion.
    bool isCompared() const { return reference || difference; }

    // If there is a reference: the model at the time stamps of the file, and the comparison of each series of the file.
    Trajectory atReference;
    std::vector<ChannelComparison> comparison;

    /// Computing time of the trajectory by Newton-Raphson; nullopt for the closed form, whose curves are computed again
    /// when they are drawn.
    std::optional<double> sampleSeconds;
};

/// The mechanism that produced a reference file, and what explains the difference from the model. Immutable once
/// published.
struct ReferenceIdentification {
    std::shared_ptr<const Reference> reference;
    Parameters parameters; ///< the model that the file was compared with
    Identification found;
};

/// Returns the mechanism that a person gets who uses the one found: in round numbers and, if the crank speed is not
/// constant, with its mean.
Parameters mechanismToUse(const Identification &found);

/// Computes the result of the choices, whose parameters must be valid. Returns null if stopped. May run in any thread.
std::shared_ptr<const Result> compute(const Choices &choices, std::stop_token stop);

/// Returns whether computing the result takes so long that it has to run in the background.
bool takesLong(const Choices &choices);

} // namespace slidercrank
