// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The reasons why a file or a row of it cannot be read, with the parts of a message. The user interface makes sentences
// of them in its language.

#include "core/import/file_layout.h"

#include <cstddef>
#include <string>

namespace slidercrank
{

/// Why a row is skipped.
enum class RowFault {
    NotANumber,
    TooLarge,      ///< for a double
    PointForComma, ///< a number with a decimal point in a file with decimal commas
    CommaForPoint, ///< the reverse
    TooManyCells,
    TooFewCells,
    NoTime,
    RepeatedTime ///< a later row has the same time: the last one is used, as after an event of a simulation
};

/// Why no data could be read.
struct ReadFault {
    enum class Kind {
        Empty,
        Spreadsheet, ///< or an archive
        Pdf,
        Markup, ///< HTML or XML
        Json,
        NotText,
        NotATable, ///< text without rows of numbers
        LineTooLong,
        UnitsContradict, ///< the line of units contradicts `heading`
        NamesMissing,    ///< there are numbers but no headings
        MoreHeadings,    ///< `headings` are more than `numbers` in every row: a heading contains a delimiter
        FewerHeadings,   ///< `headings` are fewer than `numbers` in the rows
        Transposed,      ///< each line is a quantity
        CommonFactor,    ///< the numbers are printed without their common factor, as MATLAB and Octave do
        AnotherTable,    ///< begins with this line of headings
        UnknownUnit,     ///< or a unit of another quantity than `channel`
        UnknownTimeUnit,
        NoSuchColumn,   ///< called `heading`
        SeveralColumns, ///< called `heading`
        ChannelTwice,   ///< `channel`, in the headings or chosen by a person
        TimeTwice,      ///< or the crank angle instead of it
        NoTime,
        NoChannel,        ///< no heading is known
        NoCertainChannel, ///< the column with `heading` may be a channel, but is ignored because of `column`
        NoNumbers,        ///< below the headings
        NoRow,            ///< can be read; `row` is the reason for the first one
        MostRows,         ///< cannot be read, although they have numbers; `row` as for NoRow
        NoValues,         ///< besides the time
        TimeNotRising,
        TimeStartsAgain, ///< another motion begins
        AngleTurnsBack,  ///< the crank angle
        AngleStartsAgain,

        // About a file that has to be joined with others; `heading` is one of them.
        OtherTimeStamps,
        ChannelInBoth,

        TooLarge, ///< larger than kLargestReferenceFile
        Stopped,  ///< by the caller
        NoMemory
    };
    Kind kind = Kind::Empty;
    Channel channel{};
    std::string heading{};
    ColumnReason column = ColumnReason::UnknownName;
    RowFault row = RowFault::NotANumber;
    std::size_t headings = 0; ///< number of them
    std::size_t numbers = 0;  ///< in the longest row

    friend bool operator==(const ReadFault &, const ReadFault &) = default;
};

} // namespace slidercrank
