// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What a file may mean otherwise than it says: radians for degrees, metres for millimetres, an axis that points the
// other way, the textbook's θ_3 for θ³, the other assembly, a late start, a derivative that is none. Each is found by
// trying it, and offered; nothing is ever applied silently.

#include "core/mechanism.h"
#include "core/reference_data.h"

#include <stop_token>
#include <vector>

namespace slidercrank
{

struct Convention {
    enum class Kind {
        AngleUnit,      ///< angles in another unit than the heading says (or the author's): multiplied by amount
        LengthUnit,     ///< lengths: multiplied by amount
        TimeUnit,       ///< the instants: multiplied by amount
        Sign,           ///< the axis, or the sense of rotation, is the opposite one: multiplied by amount = -1
        HalfTurn,       ///< the textbook's θ_3, seen from B: amount = ±180° is added
        WholeTurns,     ///< amount = ±360°, … is added
        SwappedColumns, ///< the two channels stand under each other's names
        Branch,         ///< the motion of the other assembly: the model changes, not the data
        TimeShift,      ///< the clock of the file started early or late: amount (s) is added to its instants
        NotDerivative   ///< a derivative column is not the derivative of its position column: it is left out
    };
    Kind kind = Kind::AngleUnit;
    std::vector<Channel> channels; ///< whose columns it concerns
    double amount = 1.0;

    friend bool operator==(const Convention &, const Convention &) = default;
};

/// The data as they read with that convention. Branch changes nothing here.
ReferenceData applied(const Convention &convention, ReferenceData data);

/// A convention that brings the data nearer to the mechanism, or to some mechanism.
struct ConventionFinding {
    Convention convention;

    /// Largest error of the channels concerned, as % of their peak, without and with it (and all findings before it).
    double before = 0.0;
    double after = 0.0;
};

/// What explains the data, in the order in which it is to be applied; empty where the data need no other reading.
/// Compared with `mechanism` first; where that cannot be it, with whatever mechanism fits the data best.
std::vector<ConventionFinding> findConventions(const ReferenceData &data, const Mechanism &mechanism,
                                               std::stop_token stop = {});

} // namespace slidercrank
