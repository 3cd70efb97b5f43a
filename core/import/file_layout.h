// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Describes how a reference file is written, and what each of its columns is used for and why. Lines count from 1,
// columns from 0.

#include "core/import/unit_text.h"
#include "core/mechanism/channel.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace slidercrank
{

enum class DecimalSign { Point, Comma };

enum class ColumnRole {
    Ignored,
    Time,
    CrankAngle, ///< of a table without time stamps, which follow from the angle and the drive
    Channel
};

/// Why a column has its role.
enum class ColumnReason {
    // Certain.
    KnownName, ///< the heading names the time or a channel
    Chosen,    ///< by a person, for any role

    // Guessed: a person should confirm them.
    QuantityInName, ///< the heading and its unit denote a quantity, but not of which body: the usual one is assumed
    WideAngle,      ///< the crank angle, by its range or evenness; its derivative; the angle of a link numbered from it
    StraightPath,   ///< the only one of several points whose y does not change, or a derivative of its x or y
    UnknownWords,   ///< some words of the heading are unknown, but no other column is the quantity
    RisingValues,   ///< no column is named as the time; this is the first one, and its values only rise
    PathInSi,       ///< the heading is a path of a program that uses m, rad and s, such as Modelica and ROS
    AngleForTime,   ///< no column is the time; this is the crank angle, which does not change its direction

    // Ignored.
    UnknownName,    ///< the heading denotes no channel
    UnknownBody,    ///< the heading denotes a quantity, but of an unknown body
    RowNumber,      ///< it numbers the rows
    Magnitude,      ///< the magnitude of a vector whose components are other columns
    SameTimeStamps, ///< the time stamps of another signal, equal to those in the column of the time
    TimeOfDay,      ///< times of a clock, beside another column of times that contains numbers
    NoName,         ///< the heading is empty
    NoNumber,       ///< no cell contains a number
    MoreWords,      ///< more cells contain words than numbers, unlike in another column that may be a channel
    UnknownUnit,    ///< the unit is unknown, or does not suit the quantity
    Ratio,          ///< the ratio of two quantities, such as ω3/ω2
    OverAngle,      ///< a derivative with respect to the crank angle, such as dx/dθ, and not to the time
    LikeOther,      ///< another column could be the same channel: a person has to choose
    AngleOrLength,  ///< it is unknown whether it is an angle or a length
    TurnsOrRadians, ///< a speed in 1/s or Hz: it is unknown whether in rad/s or in turns per second
    CrankPin,       ///< it describes the crank pin A, which has no channel
    Constant        ///< it does not change, unlike that quantity in a moving mechanism; it may be a parameter
};

/// Returns whether the column was guessed, so that a person should confirm it.
constexpr bool isGuess(ColumnReason reason)
{
    using enum ColumnReason;
    return reason == QuantityInName || reason == WideAngle || reason == StraightPath || reason == UnknownWords ||
           reason == RisingValues || reason == PathInSi || reason == AngleForTime;
}

/// Returns whether the column is probably a channel, which only a person can choose.
constexpr bool leavesOpen(ColumnReason reason)
{
    return reason == ColumnReason::UnknownBody || reason == ColumnReason::LikeOther ||
           reason == ColumnReason::AngleOrLength || reason == ColumnReason::TurnsOrRadians;
}

/// A difference quotient of the values in two rows.
enum class Difference {
    Forward,  ///< from this row to the next one
    Backward, ///< from the previous row to this one
    Central   ///< from the previous row to the next one
};

/// A column of the file. The texts are UTF-8, whatever the encoding of the file.
struct FileColumn {
    std::string heading{}; ///< as printed, including a unit
    std::string unit{};    ///< as printed, in the heading or a line of units; empty: none, the default unit applies
    ColumnRole role = ColumnRole::Ignored;
    Channel channel{}; ///< if the role is Channel
    ColumnReason reason = ColumnReason::UnknownName;
    std::optional<Difference> difference{}; ///< kind of difference quotient in the column; nullopt: none, or unknown
    std::size_t file = 0;                   ///< index in FileLayout::files
    bool isInRadiansByValues = false; ///< read in rad without a printed unit, because the values of an angle suggest it
};

/// The layout of a file. If several files are joined, `columns` and `rows` contain the columns of all files side by
/// side, and the members before them describe the first file.
struct FileLayout {
    char delimiter = ',';
    DecimalSign decimalSign = DecimalSign::Point;
    bool mayBeThousands = false;     ///< whether each decimal sign could also separate thousands, as in "80,826"
    std::size_t headerLine = 0;      ///< 0: none, the file begins with numbers
    std::vector<FileColumn> columns; ///< all of them, in the order of the file
    std::vector<std::vector<std::string>> rows; ///< the first few rows of cells as printed, for a preview
    std::vector<std::string> files;             ///< names of the joined files; empty for a single file

    /// Returns whether the role of any column was guessed.
    bool isGuessed() const;
};

/// Returns the unit of a column with that role and channel: the default unit for an empty text; nullopt if the unit is
/// unknown or of a different quantity, or if the column is ignored.
std::optional<Unit> parseColumnUnit(const std::string &text, ColumnRole role, Channel channel);

/// The meaning that a person gives a column, which overrides its heading.
struct ColumnChoice {
    std::size_t column = 0; ///< from 0
    ColumnRole role = ColumnRole::Ignored;
    Channel channel{};     ///< if the role is Channel
    std::string unit{};    ///< as in a heading ("rad/s", "m", "ms"); empty: that of the file, or else the default unit
    std::string heading{}; ///< instead of `column`: as printed, with or without its unit; "#3": the third column

    friend bool operator==(const ColumnChoice &, const ColumnChoice &) = default;
};

} // namespace slidercrank
