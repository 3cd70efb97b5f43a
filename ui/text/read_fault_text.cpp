// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/read_fault_text.h"

#include <QCoreApplication>

namespace slidercrank
{

namespace
{

struct ReadFaultText {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::ReadFaultText)

public:
    /// Explains why a column is ignored although its heading suggests a channel.
    static QString clause(ColumnReason reason)
    {
        switch (reason) {
        case ColumnReason::LikeOther: return tr("another column could be the same quantity");
        case ColumnReason::AngleOrLength: return tr("neither unit nor values tell whether it is an angle or a length");
        case ColumnReason::UnknownBody: return tr("its heading does not name the body");
        default: return tr("its unit is unknown, or does not suit the quantity");
        }
    }

    /// %1 is the heading or the file, %2 the channel or its unit, %3 the fault of a row, %4 that of a column.
    static QString sentence(ReadFault::Kind kind)
    {
        using enum ReadFault::Kind;
        switch (kind) {
        case Empty: return tr("The file is empty: it needs a line of headings, and numbers below it.");
        case Spreadsheet: return tr("The file is a spreadsheet or an archive, not text: save the table as CSV.");
        case Pdf: return tr("The file is a PDF document, not a table: export the table as CSV.");
        case Markup: return tr("The file is HTML or XML, not a table of text: export the table as CSV.");
        case Json: return tr("The file is JSON, not a table of text: export the table as CSV.");
        case NotText: return tr("the file holds bytes that are not text: export the table as CSV.");
        case LineTooLong:
            return tr("the line has more than a million characters: export the table as CSV, a row a line.");
        case UnitsContradict: return tr("the line of units contradicts the heading, %1: correct one of the two.");
        case NamesMissing:
            return tr("numbers where the headings should be: put a line such as time,theta3,R4_x above them.");
        case UnknownUnit: return tr("unknown unit, or one of another quantity: write for example [%2], or none.");
        case UnknownTimeUnit: return tr("unknown unit of time: write [s] or [ms], or none for seconds.");
        case NoSuchColumn: return tr("there is no column \"%1\".");
        case SeveralColumns: return tr("several columns are called \"%1\": give the number of one of them, as in #3.");
        case ChannelTwice: return tr("there is a column of that name already: keep one of the two.");
        case TimeTwice: return tr("there is a time column already: keep one of the two.");
        case ChannelChosenTwice: return tr("two columns are chosen as %2: keep one of the two.");
        case TimeChosenTwice: return tr("two columns are chosen as the time: keep one of the two.");
        case NoTime:
            return tr(
                "there is no time column: call the column of the time stamps \"time\", or that of the crank angle "
                "\"theta2\".");
        case NoChannel:
            return tr("no column beside the time has a known heading: use theta3, theta3_diff, theta3_diff2, R4_x, "
                      "R4_x_diff, R4_x_diff2.");
        case NoCertainChannel:
            return tr("the columns beside the time are unknown (%1: %4): use theta3, theta3_diff, theta3_diff2, R4_x, "
                      "R4_x_diff, R4_x_diff2.");
        case NoNumbers: return tr("there are no numbers below the headings.");
        case NoRow:
            return tr("no row can be read, this one because of: %3. Write numbers as 0.005, or as 0,005 with columns "
                      "separated by semicolons or tabs.");
        case NoValues: return tr("no column beside the time contains a number.");
        case TimeNotRising:
            return tr("the time does not increase: sort the rows by time, and keep one row for each time.");
        case AngleTurnsBack:
            return tr("the crank angle goes back after %1: sort the rows by it, and keep one row for each angle.");
        case OtherTimeStamps:
            return tr(
                "its time stamps are not those of %1: export the plots with the same start, end and step, or open "
                "one file at a time.");
        case ChannelInBoth:
            return tr(
                "both this file and %1 contain %2: leave one of them out, or choose the meaning of their columns.");
        case TooLarge: return tr("The file is larger than 2 GB: export fewer rows or columns.");
        case Stopped: return tr("Reading was stopped.");
        case Unreadable: return tr("The file became shorter while it was read: open it again.");
        case NoMemory: return tr("There is not enough memory: leave out rows or columns.");
        }
        return {};
    }

    static QString row(RowFault fault)
    {
        using enum RowFault;
        switch (fault) {
        case NotANumber: return tr("not a number");
        case TooLarge: return tr("not a number: too large");
        case PointForComma: return tr("not a number: this file uses a decimal comma");
        case CommaForPoint: return tr("not a number: this file uses a decimal point");
        case TooManyCells: return tr("too many cells");
        case TooFewCells: return tr("too few cells");
        case NoTime: return tr("no time");
        case RepeatedTime: return tr("the same time as the next row, which is used");
        case NotListed: return tr("this line and %1 more below it cannot be read either");
        }
        return {};
    }
};

} // namespace

QString reasonOf(const SkippedRow &row)
{
    return ReadFaultText::row(row.fault).replace(QStringLiteral("%1"), QString::number(row.rows - 1));
}

QString sentenceOf(const ReadFault &fault)
{
    const bool namesUnit = fault.kind == ReadFault::Kind::UnknownUnit;
    return ReadFaultText::sentence(fault.kind)
        .replace(QStringLiteral("%4"), ReadFaultText::clause(fault.column))
        .replace(QStringLiteral("%3"), ReadFaultText::row(fault.row))
        .replace(QStringLiteral("%2"), QString::fromUtf8(namesUnit ? fileUnit(fault.channel) : nameOf(fault.channel)))
        .replace(QStringLiteral("%1"), QString::fromUtf8(fault.heading));
}

} // namespace slidercrank
