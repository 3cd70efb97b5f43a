// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Conventions in which a file may differ from its headings: radians instead of degrees, metres instead of millimetres,
// an axis in the opposite direction, a different origin, the textbook's θ_3 instead of θ³, the other assembly, a late
// start, a column that is not the derivative it claims to be. The program reports them and lets the user apply them.
//
// Some conventions cannot be distinguished from a different mechanism. The set of the motions of all mechanisms does
// not change if they are
//
//     mirrored in the x axis    θ → -θ, x → x            c → -c, ω2 → -ω2, θ20 → -θ20
//     mirrored in the y axis    θ → 180° - θ, x → -x     ω2 → -ω2, θ20 → 180° - θ20, the other assembly
//     turned by 180°            θ → θ + 180°, x → -x     c → -c, θ20 → θ20 + 180°, the other assembly
//     enlarged                  θ → θ, x → k x           a, b, c times k
//     started late              t → t + τ                θ20 → θ20 - ω2 τ
//     timed otherwise           t → f t, derivatives times powers of 1/f     ω2 → ω2 / f
//
// (θ and x with their derivatives, θ up to whole turns), and, for θ alone, if
//
//     the crank is reversed     θ → θ                    ω2 → -ω2, θ20 → 180° - θ20
//
// Therefore the length unit of the whole file, times in milliseconds, a late start and the other assembly are reported
// only if the file then agrees with the given mechanism. Otherwise the result is a different mechanism without a
// convention. (Milliseconds are also reported if derivatives show them, see table_conventions.h.) Some files can be
// described by either of two conventions:
//
//     θ turned by 180°, or x negated
//     one of two columns negated, or the other one
//     R4x measured from a different origin in the opposite direction (a depth), or θ turned by 180°
//
// The simplest description is chosen, then the one whose mechanism is near the given one (mirror_images.h).
//
// If the slider moves along y and not along x, the axes are rotated first. Angles are not rotated with them, unless
// that leads to a better outcome or to fewer conventions.

#include "core/import/reference_data.h"
#include "core/mechanism/channel.h"

#include <array>
#include <optional>
#include <vector>

namespace slidercrank
{

// The units that occur in files, as multiples of the default unit (°, mm, s).
inline constexpr std::array kAngleUnits{1.0, kDegreesPerRadian};
inline constexpr std::array kLengthUnits{1.0, 10.0, 25.4, 1000.0};
inline constexpr double kMillisecond = 1e-3;
inline constexpr std::array kTimeUnits{1.0, kMillisecond};

inline constexpr double kTurnInDegrees = 360.0;

/// A convention and the columns that it changes. In a table over the crank angle, AngleUnit, Sign and ZeroPoint of θ2
/// change the abscissa.
struct Convention {
    enum class Kind {
        AngleUnit,      ///< angles are multiplied by amount
        LengthUnit,     ///< lengths are multiplied by amount
        TimeUnit,       ///< times are multiplied by amount, derivatives in that unit by its inverse powers
        Sign,           ///< opposite axis or sense of rotation: values are multiplied by amount = -1
        HalfTurn,       ///< the textbook's θ_3, measured at B and not at A: jumps by a turn are removed, and an odd
                        ///< multiple of 180° is added
        WholeTurns,     ///< jumps by a turn are removed, and amount = 0, ±360°, … is added
        ZeroPoint,      ///< a different origin: amount (in the unit of files) is added to one column
        SwappedColumns, ///< two columns have each other's headings
        OtherAssembly,  ///< the motion of the other assembly: changes the model, not the data
        TimeShift,      ///< the clock started early or late: amount (s) is added to the times
        NotDerivative,  ///< a column is not the derivative of its position: it is removed
        Axis            ///< the slider moves along y: y becomes x, and x becomes -y
    };
    Kind kind = Kind::AngleUnit;

    /// The columns that it changes, named as before the change. TimeUnit: the derivatives in that unit. OtherAssembly,
    /// TimeShift: empty.
    std::vector<Channel> channels;
    double amount = 1.0;

    friend bool operator==(const Convention &, const Convention &) = default;
};

/// Applies a convention to the data. OtherAssembly changes nothing. Crank angles are changed without their time stamps.
ReferenceData applied(const Convention &convention, ReferenceData data);

/// A convention that was found in a file.
struct ConventionFinding {
    Convention convention;

    /// The largest error without and with the convention, in percent of the peak of the column, after all other
    /// conventions are applied: of the columns that the convention changes, or of all if it changes the times, the
    /// axes, the model, or θ2 where this is the abscissa. 0 without values.
    double before = 0.0;
    double after = 0.0;

    std::optional<double> standardError{}; ///< standard error of the amount of a ZeroPoint, in its unit
};

/// Whether the convention changes a channel.
bool concerns(const Convention &convention, Channel channel);

} // namespace slidercrank
