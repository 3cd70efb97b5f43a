// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What a file may mean otherwise than it says: radians for degrees, metres for millimetres, an axis that points the
// other way, another origin, the textbook's θ_3 for θ³, the other assembly, a late start, a derivative that is none.
// Each is found by trying it, and offered; nothing is ever applied silently.
//
// Some readings cannot be told from another mechanism. The motions of all mechanisms are the same set
//
//     mirrored at x     θ → -θ, x → x            c → -c, ω2 → -ω2, θ20 → -θ20
//     mirrored at y     θ → 180° - θ, x → -x     ω2 → -ω2, θ20 → 180° - θ20, the other assembly
//     turned by 180°    θ → θ + 180°, x → -x     c → -c, θ20 → θ20 + 180°, the other assembly
//     enlarged          θ → θ, x → k x           a, b, c times k
//     started late      t → t + τ                θ20 + ω2 τ
//     timed otherwise   t → f t and every derivative by its power of f     ω2 / f
//
// θ and x with their derivatives, θ up to whole turns; and of θ alone
//
//     crank reversed     θ → θ                   ω2 → -ω2, θ20 → 180° - θ20
//
// So the sense of rotation, the length unit of the whole file, instants and derivatives per millisecond, a late start
// and the other assembly are found only where the file agrees with the mechanism at hand; where it does not, they are
// taken for another mechanism and no finding. And some faults have two names:
//
//     θ turned by 180°, or x negated (without the mechanism at hand): what brings the data nearer to the mechanism at
//         hand if it resembles it, else the half turn
//     the other assembly, or the other sign, in a file of θ̇3 and θ̈3 only: the sign
//     one of two columns negated, or the other: the derivative
//     a crossed mechanism's angles negated, or its mirror image's less a whole turn: the latter
//
// A file whose slider moves along y, and not along x, is turned before all this: no reading as it stands could be
// right. Angles are not turned with it: where they are counted from the file's x, that is found as another origin.
//
// What a finding costs stands in interpretation.h.

#include "core/import/reference_data.h"
#include "core/mechanism/channel.h"

#include <optional>
#include <vector>

namespace slidercrank
{

/// In a file that counts by the crank's angle, AngleUnit, Sign and ZeroPoint of θ2 are of what it counts by.
struct Convention {
    enum class Kind {
        AngleUnit,      ///< angles in another unit than the heading says (or the author's): multiplied by amount
        LengthUnit,     ///< lengths: multiplied by amount
        TimeUnit,       ///< the instants: multiplied by amount; derivatives per that unit too: by its inverse powers
        Sign,           ///< the axis, or the sense of rotation, is the opposite one: multiplied by amount = -1
        HalfTurn,       ///< the textbook's θ_3, seen from B: made continuous, and amount = ±180°, … is added
        WholeTurns,     ///< made continuous where it jumps by a turn, and amount = 0, ±360°, … is added
        ZeroPoint,      ///< one column, counted from another origin: amount (in the author's unit) is added
        SwappedColumns, ///< the two channels stand under each other's names
        Branch,         ///< the motion of the other assembly: the model changes, not the data
        TimeShift,      ///< the clock of the file started early or late: amount (s) is added to its instants
        NotDerivative,  ///< a derivative column is not the derivative of its position column: it is left out
        Axis            ///< the slider moves along y: its columns are turned by -90°, y becoming x and x becoming -y
    };
    Kind kind = Kind::AngleUnit;

    /// The columns that it changes, of Axis by the names that they have before. Of TimeUnit the derivatives that count
    /// in that unit too, maybe none; of Branch and TimeShift none.
    std::vector<Channel> channels;
    double amount = 1.0;

    friend bool operator==(const Convention &, const Convention &) = default;
};

/// Where the slider moves along y and not along x: its columns, and perhaps the angles, which are then counted from the
/// file's x, too.
std::optional<Convention> axisAlongY(const ReferenceData &data, bool withAngles);

/// The data as they read with that convention. Branch changes nothing here.
ReferenceData applied(const Convention &convention, ReferenceData data);

/// A convention that brings the data nearer to the mechanism, or to some mechanism.
struct ConventionFinding {
    Convention convention;

    /// Largest error of the columns that it changes (of all where it changes the instants or the model), as % of the
    /// motion's peak, without and with it, all other findings being applied. 0 where nothing is left to compare.
    double before = 0.0;
    double after = 0.0;

    std::optional<double> standardError{}; ///< of the amount of a ZeroPoint, in its unit
};

/// Whether the convention changes that channel.
bool concerns(const Convention &convention, Channel channel);

} // namespace slidercrank
