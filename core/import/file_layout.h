// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// How a reference file is written and what each of its columns became, and why: where numbers come from, for whoever
// asks, and what a person needs who wants to choose the columns otherwise. Lines count from 1, columns from 0.

#include "core/mechanism/channel.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace slidercrank
{

enum class TextEncoding { Utf8, Utf16LittleEndian, Utf16BigEndian, Windows1252 };

enum class DecimalSign { Point, Comma };

enum class ColumnRole {
    Ignored,
    Time,
    CrankAngle, ///< counted by instead of the time, which follows from it
    Channel
};

/// Why a column became what it is. `otherColumn` is FileColumn::otherColumn.
enum class ColumnReason {
    // Certain.
    KnownName, ///< the name is one of the time or of a channel
    Chosen,    ///< a person chose it, for any role

    // Guessed: to be confirmed by a person.
    QuantityInName, ///< the name, with its unit, says the quantity but leaves open of which body: the usual one
    LetterAndUnit,  ///< Inventor's P, V or A says the order, the unit angle or length
    OtherOfJoint,   ///< Inventor's P, V or A says the order, another column of the same joint angle or length
    EvenRate,       ///< an angle that grows at an even rate is the crank's
    BeyondOneTurn,  ///< an angle that spans more than a turn is the crank's; or a derivative of it, otherColumn
    RisingValues,   ///< no column is named as the time; this is the first that only rises
    FileName,       ///< the heading says nothing ("Value"), the name of the file does
    ModelicaName,   ///< named as Modelica names it, and so taken to be in m, rad and s
    AngleForTime,   ///< no column is the time; this is the crank's angle, which goes one way throughout

    // Ignored.
    UnknownName,   ///< the name means no channel
    UnknownBody,   ///< the name says a quantity of something, and nothing of what
    RowNumber,     ///< it counts the rows
    Magnitude,     ///< of a vector whose components are other columns, otherColumn the first
    SameInstants,  ///< the instants of another column's values, the same as the time's
    OtherInstants, ///< its values stand at other instants than the time's, which is otherColumn
    NoName,        ///< the heading is empty
    NoNumber,      ///< no cell holds a number
    UnknownUnit,   ///< the name suggests a channel, but the unit is none of that quantity
    LikeOther,     ///< could be the same channel as otherColumn: which one, a person must say
    NotDerivative, ///< the values are not the derivative that the name says, of otherColumn
    AngleOrLength  ///< nothing tells an angle from a length
};

constexpr bool isGuess(ColumnReason reason)
{
    return reason >= ColumnReason::QuantityInName && reason <= ColumnReason::AngleForTime;
}

/// Whether the column may well be a channel: which, only a person can say.
constexpr bool leavesOpen(ColumnReason reason)
{
    return reason == ColumnReason::UnknownBody || reason == ColumnReason::LikeOther ||
           reason == ColumnReason::AngleOrLength;
}

/// Between the values of two rows, by the time between them.
enum class Difference {
    Forward, ///< this row and the next
    Backward,
    Central ///< the row before and the next
};

/// One column of the file, UTF-8 whatever the file's encoding.
struct FileColumn {
    std::string heading{}; ///< as printed, with the unit where it stands there; empty: none
    std::string unit{};    ///< as printed, in the heading or in the line of units; empty: none given, the author's
    ColumnRole role = ColumnRole::Ignored;
    Channel channel{}; ///< where the role is Channel
    ColumnReason reason = ColumnReason::UnknownName;
    std::optional<std::size_t> otherColumn{}; ///< that the reason speaks of
    std::optional<Difference> difference{};   ///< what a column of derivatives is made of
    std::size_t file = 0;                     ///< that it stands in, of FileLayout::files
};

/// What was found of a file's form. Of several that are joined, the columns of one follow those of the other; the rest
/// is that of the first.
struct FileLayout {
    TextEncoding encoding = TextEncoding::Utf8;
    bool byteOrderMark = false;
    char delimiter = ',';
    DecimalSign decimalSign = DecimalSign::Point;
    std::size_t headerLine = 0;                 ///< 0: none, the file begins with numbers
    std::vector<std::size_t> preambleLines;     ///< before the header: titles, comments, a delimiter announced
    std::size_t unitsLine = 0;                  ///< 0: none
    std::vector<FileColumn> columns;            ///< all of them, in the file's order
    std::vector<std::vector<std::string>> rows; ///< the first few rows of cells as printed, for a preview
    std::vector<std::string> files;             ///< the names of those that are joined; empty: it is one

    /// Whether names did not tell all that was taken from the file: a person should look at the columns.
    bool isGuessed() const;

    /// Whether there are columns whose names differ only in what they belong to, and none of them is used: a person
    /// has to say which of them is what.
    bool isOpen() const;
};

/// What a person says of one column, over whatever its name says.
struct ColumnChoice {
    std::size_t column = 0; ///< from 0
    ColumnRole role = ColumnRole::Ignored;
    Channel channel;  ///< where the role is Channel
    std::string unit; ///< as a heading would give it ("rad/s", "m", "ms"); empty: the file's, or the author's
};

/// The same of a column by its heading.
struct NamedChoice {
    std::string heading; ///< as printed, with or without its unit; "#3": the third column
    ColumnRole role = ColumnRole::Ignored;
    Channel channel;
    std::string unit;
};

} // namespace slidercrank
