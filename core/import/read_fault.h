// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The reasons why a file or a row of it cannot be read, with the parts of a message. The user interface makes sentences
// of them in its language.

#include "core/import/file_layout.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace slidercrank
{

/// Why a row is skipped.
enum class RowFault {
    NotANumber,
    TooLarge,      ///< for a double
    PointForComma, ///< a number with a decimal point in a file with decimal commas
    CommaForPoint, ///< a number with a decimal comma in a file with decimal points
    TooManyCells,
    TooFewCells,
    NoTime,
    RepeatedTime ///< a later row has the same time; the last one is used, as it contains the state after an event
};

/// Why no data could be read.
struct ReadFault {
    enum class Kind {
        Empty,
        Spreadsheet, ///< a spreadsheet or an archive
        Pdf,
        Markup, ///< HTML or XML
        Json,
        NotText,
        NotATable, ///< text without rows of numbers
        LineTooLong,
        UnitsContradict, ///< the line of units contradicts `heading`
        NamesMissing,    ///< there are numbers but no headings
        MoreHeadings,    ///< there are more headings than cells in every row: a heading contains a delimiter
        FewerHeadings,   ///< there are fewer headings than cells in the first row that was skipped
        Transposed,      ///< each line is a quantity
        CommonFactor,    ///< the numbers are printed without their common factor, as MATLAB and Octave do
        AnotherTable,    ///< a second table begins with this line of headings
        UnknownUnit,     ///< the unit is unknown, or of a quantity other than `channel`
        UnknownTimeUnit,
        NoSuchColumn,   ///< no column is called `heading`
        SeveralColumns, ///< several columns are called `heading`
        ChannelTwice,   ///< two columns are `channel` by their headings or by choice
        TimeTwice,      ///< two columns are the time, or the crank angle instead of it
        NoTime,
        NoChannel,        ///< no heading is known
        NoCertainChannel, ///< the column with `heading` may be a channel, but is ignored because of `columnReason`
        NoNumbers,        ///< there are no numbers below the headings
        NoRow,            ///< no row can be read; `rowFault` is the reason for the first one
        MostRows,         ///< most rows with numbers cannot be read; `rowFault` is the reason for the first one
        NoValues,         ///< only the time has values
        TimeNotRising,
        TimeStartsAgain, ///< a second motion begins
        AngleTurnsBack,  ///< the crank angle changes its direction
        AngleStartsAgain,

        // About a file that has to be joined with others; `heading` is the name of one of the others.
        OtherTimeStamps,
        ChannelInBoth,

        TooLarge, ///< larger than kLargestReferenceFile
        Stopped,  ///< the caller has stopped reading
        NoMemory
    };
    Kind kind = Kind::Empty;
    Channel channel{};
    std::string heading{};
    ColumnReason columnReason = ColumnReason::UnknownName;
    RowFault rowFault = RowFault::NotANumber;
    std::size_t headingCount = 0; ///< number of headings
    std::size_t cellCount = 0; ///< number of cells in the longest row (MoreHeadings) or the skipped row (FewerHeadings)

    friend bool operator==(const ReadFault &, const ReadFault &) = default;
};

/// Why no data could be read, and where. The line is 0 if the error concerns the file as a whole.
struct ReadError {
    std::size_t line = 0;
    std::size_t column = 0; ///< from 1; 0: unknown
    std::string text{};     ///< the beginning of the cell, heading or line
    ReadFault fault{};
    FileLayout layout{}; ///< as far as it was found; if it has columns, a person can choose their meaning

    std::optional<std::size_t> file{};  ///< index of the joined file with the error; nullopt if it concerns all of them
    std::vector<ColumnChoice> advice{}; ///< choices of columns that would help; empty if there are none
};

} // namespace slidercrank
