// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/read_fault_text.h"

#include "ui/text/column_text.h"

#include <QCoreApplication>

namespace slidercrank
{

namespace
{

struct ReadFaultText {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::ReadFaultText)
};

/// Why a column whose name suggests a channel is none.
QString clauseOf(ColumnReason reason)
{
    switch (reason) {
    case ColumnReason::LikeOther: return ReadFaultText::tr("another column could be the same quantity");
    case ColumnReason::NotDerivative: return ReadFaultText::tr("its values are not the derivative that its name says");
    case ColumnReason::AngleOrLength:
        return ReadFaultText::tr("neither its unit nor its values tell an angle from a length");
    case ColumnReason::UnknownBody: return ReadFaultText::tr("its name does not say of which body it is");
    case ColumnReason::UnknownUnit:
    default: return ReadFaultText::tr("its unit is not known or does not suit the quantity");
    }
}

} // namespace

QString reasonOf(const SkippedRow &row)
{
    switch (row.fault) {
    case RowFault::NotANumber: return ReadFaultText::tr("not a number");
    case RowFault::TooLarge: return ReadFaultText::tr("not a number: too large");
    case RowFault::PointForComma: return ReadFaultText::tr("not a number: this file writes a decimal comma");
    case RowFault::CommaForPoint: return ReadFaultText::tr("not a number: this file writes a decimal point");
    case RowFault::OpenQuotation:
        return ReadFaultText::tr("a quotation mark that is not closed at the end of the cell");
    case RowFault::TooManyCells: return ReadFaultText::tr("too many cells");
    case RowFault::TooFewCells: return ReadFaultText::tr("too few cells");
    case RowFault::NoTime: return ReadFaultText::tr("no time");
    case RowFault::RepeatedTime:
        return ReadFaultText::tr("the next row has the same time, and the last of such rows counts");
    case RowFault::NotListed:
        return ReadFaultText::tr("this line and %1 more below it cannot be read either").arg(row.rows - 1);
    }
    return {};
}

QString sentenceOf(const ReadFault &fault)
{
    using Kind = ReadFault::Kind;
    switch (fault.kind) {
    case Kind::Empty:
        return ReadFaultText::tr(
            "The file is empty: it needs a line with the names of the columns, and numbers below.");
    case Kind::Spreadsheet:
        return ReadFaultText::tr("The file is a spreadsheet or an archive, not text: save the table as CSV.");
    case Kind::Pdf: return ReadFaultText::tr("The file is a PDF document, not a table: export the table as CSV.");
    case Kind::Markup:
        return ReadFaultText::tr("The file is HTML or XML, not a table of text: export the table as CSV.");
    case Kind::Json: return ReadFaultText::tr("The file is JSON, not a table of text: export the table as CSV.");
    case Kind::NotText: return ReadFaultText::tr("the file holds bytes that are not text: export the table as CSV.");
    case Kind::LineTooLong:
        return ReadFaultText::tr("the line has more than a million characters: export the table as CSV, a row a line.");
    case Kind::UnitsContradict:
        return ReadFaultText::tr("the line of units contradicts the heading, %1: correct one of the two.")
            .arg(QString::fromUtf8(fault.heading));
    case Kind::NamesMissing:
        return ReadFaultText::tr("numbers stand where the names of the columns should: put a line such as "
                                 "time,theta3,R4_x above them.");
    case Kind::UnknownUnit:
        return (isAngle(fault.channel.coordinate)
                    ? ReadFaultText::tr("the unit is not known or does not suit the quantity: write for example [%1], "
                                        "rad in its place, or none.")
                    : ReadFaultText::tr("the unit is not known or does not suit the quantity: write for example [%1], "
                                        "m, cm or in in its place, or none."))
            .arg(QString::fromUtf8(fileUnit(fault.channel)));
    case Kind::UnknownTimeUnit:
        return ReadFaultText::tr("the unit of the time is not known: write [s] or [ms], or none for seconds.");
    case Kind::NoSuchColumn:
        return ReadFaultText::tr("there is no column \"%1\".").arg(QString::fromUtf8(fault.heading));
    case Kind::SeveralColumns:
        return ReadFaultText::tr("several columns are called \"%1\": give the number of the one, as in #3.")
            .arg(QString::fromUtf8(fault.heading));
    case Kind::ChannelTwice: return ReadFaultText::tr("there is a column of that name already: keep one of the two.");
    case Kind::TimeTwice: return ReadFaultText::tr("there is a time column already: keep one of the two.");
    case Kind::ChannelChosenTwice:
        return ReadFaultText::tr("two columns are chosen as %1: keep one of the two.")
            .arg(QString::fromUtf8(nameOf(fault.channel)));
    case Kind::TimeChosenTwice: return ReadFaultText::tr("two columns are chosen as the time: keep one of the two.");
    case Kind::NoTime:
        return ReadFaultText::tr("there is no time column: name the column of the instants \"time\", or that of the "
                                 "crank's angle \"theta2\".");
    case Kind::NoChannel:
        return ReadFaultText::tr("no column beside the time has a known name: name them as in theta3, theta3_diff, "
                                 "theta3_diff2, R4_x, R4_x_diff, R4_x_diff2.");
    case Kind::NoCertainChannel:
        return ReadFaultText::tr("the columns beside the time are unknown (%1: %2): name them as in theta3, "
                                 "theta3_diff, theta3_diff2, R4_x, R4_x_diff, R4_x_diff2.")
            .arg(QString::fromUtf8(fault.heading), clauseOf(fault.column));
    case Kind::NoNumbers: return ReadFaultText::tr("there are no numbers below the names of the columns.");
    case Kind::NoRow:
        return ReadFaultText::tr("no row can be read; here the reason is: %1. Numbers look like 0.005, or like 0,005 "
                                 "where semicolons or tabs separate the columns.")
            .arg(reasonOf(SkippedRow{0, 0, {}, fault.row}));
    case Kind::NoValues: return ReadFaultText::tr("no column beside the time holds a number.");
    case Kind::TimeNotRising:
        return ReadFaultText::tr("the time does not increase from the row before: sort the rows by time and keep one "
                                 "of each instant.");
    case Kind::AngleTurnsBack:
        return ReadFaultText::tr("the crank angle goes back after %1: sort the rows by it, one row for each angle.")
            .arg(QString::fromUtf8(fault.heading));
    case Kind::OtherInstants:
        return ReadFaultText::tr("its instants are not those of %1: export the plots with the same start, end and "
                                 "step, or open one file at a time.")
            .arg(QString::fromUtf8(fault.heading));
    case Kind::CountsOtherwise:
        return ReadFaultText::tr("of this file and %1, one goes by the time and the other by the crank angle: export "
                                 "both by the same, or open one file at a time.")
            .arg(QString::fromUtf8(fault.heading));
    case Kind::ChannelInBoth:
        return ReadFaultText::tr("it holds %1, and %2 does, too: leave one of the two out, or choose what their "
                                 "columns are.")
            .arg(QString::fromUtf8(nameOf(fault.channel)), QString::fromUtf8(fault.heading));
    case Kind::TooLarge: return ReadFaultText::tr("The file is larger than 2 GB: export fewer rows or columns.");
    case Kind::Stopped: return ReadFaultText::tr("Reading was stopped.");
    case Kind::Unreadable: return ReadFaultText::tr("The file became shorter while it was read: open it again.");
    case Kind::NoMemory:
        return ReadFaultText::tr("There is not enough memory for a file of that size: leave out rows or columns.");
    }
    return {};
}

} // namespace slidercrank
