// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What the views draw: of one moment, as plain data. Session publishes it.

#include "core/comparison/comparison.h"
#include "core/identification/diagnosis.h"
#include "core/limits/mobility.h"
#include "core/sampling/trajectory.h"
#include "ui/document/reference_file.h"

#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

namespace slidercrank
{

/// The mechanism at one instant, by one closed-form evaluation. Lengths mm, angles rad.
struct Pose {
    double time = 0.0;
    double theta2 = 0.0; ///< not wrapped
    double theta3 = 0.0;
    double pinX = 0.0, pinY = 0.0;  ///< A
    double sliderX = 0.0;           ///< B, at y = c
    Status status = Status::Solved; ///< Solved or Singular: the pose exists
    bool exists() const { return status == Status::Solved || status == Status::Singular; }
};

Pose poseAt(const Parameters &parameters, double seconds);

inline constexpr std::size_t kMaxPinned = 4; ///< Largest number of pinned motions: more curves could not be told apart.

/// Everything that an edit may change.
struct Choices {
    Parameters parameters;
    Sampling sampling;
    SolverSettings solver;
    std::shared_ptr<const Reference> reference; ///< may be null
    std::vector<Parameters> pinned = {};        ///< pinned motions, the oldest first

    friend bool operator==(const Choices &, const Choices &) = default;
};

/// Everything that the views draw; immutable once published.
struct Result {
    Choices choices; ///< from which it was computed
    Mechanism mechanism;
    Sampling sampling;
    SolverSettings solver;
    SamplingSummary summary;
    Trajectory trajectory; ///< the six plotted channels; empty where !hasSamples()
    MotionLimits limits;
    std::shared_ptr<const Reference> reference; ///< may be null; a table by the crank angle timed for this mechanism
    std::vector<Parameters> pinned;             ///< pinned motions, the oldest first

    /// How far the model is from the motion that was pinned last; nullopt if there is a reference.
    std::optional<MotionDifference> difference;

    /// Whether the model is compared with a file or with a pinned motion.
    bool isCompared() const { return reference || difference; }

    // Filled when there is a reference: the model at the file's own instants, one comparison per series of the file.
    Trajectory atReference;
    std::vector<ChannelComparison> comparison;

    /// What Newton-Raphson took for the trajectory. None in closed form: what is on show is not the trajectory then.
    std::optional<double> sampleSeconds;

    /// A long run in closed form is not: it takes less time to compute than to store.
    bool hasSamples() const { return trajectory.time.size() == summary.instants; }
};

/// Whose motion a file is: the mechanism it belongs to, the one parameter that explains the difference, the conventions
/// by which it would read better. Immutable once published.
struct ReferenceDiagnosis {
    std::shared_ptr<const Reference> reference;
    Parameters parameters; ///< the model that the file was held against
    Diagnosis found;
};

/// Null when stopped. May run in any thread.
std::shared_ptr<const Result> compute(const Choices &choices, std::stop_token stop);

/// Whether that would keep the window waiting for more than a moment.
bool takesLong(const Choices &choices);

} // namespace slidercrank
