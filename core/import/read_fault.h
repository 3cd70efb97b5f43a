// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Why a file, or a row of it, cannot be read: the reasons, with what they speak of. Sentences are made of them where
// the language is known.

#include "core/import/file_layout.h"

#include <string>

namespace slidercrank
{

/// Why a row is left out.
enum class RowFault {
    NotANumber,
    TooLarge,      ///< for a double
    PointForComma, ///< a number but for its point: the file writes a decimal comma
    CommaForPoint, ///< the reverse
    OpenQuotation, ///< a quotation mark is not closed at the end of the cell
    TooManyCells,
    TooFewCells,
    NoTime,
    RepeatedTime, ///< a later row has the same time: the last one counts, as after an event of a simulation
    NotListed     ///< any of these: so many rows were left out that the others are only counted
};

/// Why nothing sensible could be read.
struct ReadFault {
    enum class Kind {
        Empty,
        Spreadsheet, ///< or another archive
        Pdf,
        Markup, ///< HTML or XML
        Json,
        NotText,
        LineTooLong,     ///< for any table
        UnitsContradict, ///< the line of units, and `heading`
        NamesMissing,    ///< numbers stand where the names should
        UnknownUnit,     ///< or one of another quantity than `channel`
        UnknownTimeUnit,
        NoSuchColumn,   ///< as the `heading` that a person named
        SeveralColumns, ///< of that `heading`
        ChannelTwice,   ///< in the names
        TimeTwice,
        ChannelChosenTwice, ///< `channel`, by a person
        TimeChosenTwice,    ///< or the crank's angle in its place
        NoTime,
        NoChannel,        ///< no name is known
        NoCertainChannel, ///< the column of `heading` could be one, were it not for `column`
        NoNumbers,        ///< below the names
        NoRow,            ///< that can be read, the first because of `row`
        NoValues,         ///< beside the time
        TimeNotRising,
        AngleTurnsBack, ///< the crank's, behind the angle `heading`

        // Of a file that is to be joined with others, `heading` among them.
        OtherInstants,
        CountsOtherwise, ///< by the crank's angle and not the time, or the reverse
        ChannelInBoth,

        TooLarge,   ///< the file: kLargestReferenceFile
        Stopped,    ///< by the caller
        Unreadable, ///< the file has become shorter
        NoMemory
    };
    Kind kind = Kind::Empty;
    Channel channel{};
    std::string heading{};
    ColumnReason column = ColumnReason::UnknownName;
    RowFault row = RowFault::NotANumber;

    friend bool operator==(const ReadFault &, const ReadFault &) = default;
};

} // namespace slidercrank
