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
        Spreadsheet, ///< a spreadsheet or an archive
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
        AnotherTable,    ///< a second table begins with this line of headings
        UnknownUnit,     ///< the unit is unknown, or of a quantity other than `channel`
        UnknownTimeUnit,
        NoSuchColumn,   ///< no column is called `heading`
        SeveralColumns, ///< several columns are called `heading`
        ChannelTwice,   ///< two columns are `channel` by their headings or by choice
        TimeTwice,      ///< two columns are the time, or the crank angle instead of it
        NoTime,
        NoChannel,        ///< no heading is known
        NoCertainChannel, ///< the column with `heading` may be a channel, but is ignored because of `column`
        NoNumbers,        ///< there are no numbers below the headings
        NoRow,            ///< no row can be read; `row` is the reason for the first one
        MostRows,         ///< most rows cannot be read, although they have numbers; `row` as for NoRow
        NoValues,         ///< only the time has values
        TimeNotRising,
        TimeStartsAgain, ///< a second motion begins
        AngleTurnsBack,  ///< the crank angle changes its direction
        AngleStartsAgain,

        // About a file that has to be joined with others; `heading` is one of them.
        OtherTimeStamps,
        ChannelInBoth,

        TooLarge, ///< larger than kLargestReferenceFile
        Stopped,  ///< the caller has stopped reading
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

/// Why no data could be read, and where. The line is 0 if the error concerns the file as a whole.
struct ReadError {
    std::size_t line = 0;
    std::size_t column = 0;
    std::string text{};
    ReadFault fault{};
    FileLayout layout{}; ///< as far as it was found; if it has columns, a person can choose their meaning

    std::optional<std::size_t> file{};  ///< index of the joined file with the error; nullopt if it concerns all of them
    std::vector<ColumnChoice> advice{}; ///< choices of columns that would help; empty if there are none
};

} // namespace slidercrank
