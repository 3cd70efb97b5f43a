// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/read_fault_text.h"

#include "ui/text/channel_text.h"
#include "ui/text/column_text.h"
#include "ui/text/enum_table.h"

#include <QCoreApplication>
#include <QStringList>

namespace slidercrank
{

namespace
{

using FaultKind = ReadFault::Kind;

struct ReadFaultText {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::ReadFaultText)

public:
    // %1 is the heading or the file, %2 the channel or its unit, %3 the fault of a
    // row, %4 why a column is ignored, %5 and %6 the numbers of headings and cells.
    static constexpr EnumText<FaultKind> kFaults[] = {
        {FaultKind::Empty, QT_TR_NOOP("The file is empty: it needs a line of headings, and numbers below it.")},
        {FaultKind::Spreadsheet,
         QT_TR_NOOP("The file is a spreadsheet or an archive, not text: save the table as CSV.")},
        {FaultKind::Pdf, QT_TR_NOOP("The file is a PDF document, not a table: export the table as CSV.")},
        {FaultKind::Markup, QT_TR_NOOP("The file is HTML or XML, not a table of text: export the table as CSV.")},
        {FaultKind::Json, QT_TR_NOOP("The file is JSON, not a table of text: export the table as CSV.")},
        {FaultKind::NotText, QT_TR_NOOP("the file holds bytes that are not text: export the table as CSV.")},
        {FaultKind::NotATable,
         QT_TR_NOOP("The file is a text without rows of numbers: export the motion as a table, with a line of headings "
                    "and one row for each time stamp.")},
        {FaultKind::LineTooLong,
         QT_TR_NOOP("the line has more than a million characters: export the table as CSV, with one row per line.")},
        {FaultKind::UnitsContradict,
         QT_TR_NOOP("the line of units contradicts the heading, %1: correct one of the two.")},
        {FaultKind::NamesMissing,
         QT_TR_NOOP("numbers where the headings should be: put a line such as time,theta3,R4_x above them.")},
        {FaultKind::MoreHeadings,
         QT_TR_NOOP(
             "there are %5 headings, but at most %6 cells in each row: put headings that contain the delimiter in "
             "quotation marks.")},
        {FaultKind::FewerHeadings,
         QT_TR_NOOP("there are %5 headings, but %6 cells in the row: give every column a heading.")},
        {FaultKind::Transposed,
         QT_TR_NOOP("the quantities are rows: transpose the table, so that each quantity is a column.")},
        {FaultKind::CommonFactor,
         QT_TR_NOOP("the numbers below have to be multiplied by this factor: print them in full, in MATLAB and Octave "
                    "with “format long g”.")},
        {FaultKind::AnotherTable,
         QT_TR_NOOP("another table begins here, with other headings or units: keep one of the tables.")},
        {FaultKind::UnknownUnit,
         QT_TR_NOOP("unknown unit, or one of another quantity: write for example [%2], or none.")},
        {FaultKind::UnknownTimeUnit, QT_TR_NOOP("unknown unit of time: write [s] or [ms], or none for seconds.")},
        {FaultKind::NoSuchColumn, QT_TR_NOOP("there is no column “%1”.")},
        {FaultKind::SeveralColumns,
         QT_TR_NOOP("several columns are called “%1”: give the number of one of them, as in #3.")},
        {FaultKind::ChannelTwice, QT_TR_NOOP("two columns contain %2: keep one of the two.")},
        {FaultKind::TimeTwice,
         QT_TR_NOOP("two columns contain the time, or the crank angle instead of it: keep one of the two, with the "
                    "columns that were sampled at it.")},
        {FaultKind::NoTime,
         QT_TR_NOOP("there is no time column: call the column of the time stamps “time”, or that of the crank "
                    "angle “theta2”.")},
        {FaultKind::NoChannel,
         QT_TR_NOOP("no column other than the time has a known heading: use theta3, theta3_diff, theta3_diff2, R4_x, "
                    "R4_x_diff, R4_x_diff2.")},
        {FaultKind::NoCertainChannel,
         QT_TR_NOOP("no column besides the time or crank angle can be used (%1: %4): use the headings theta3, "
                    "theta3_diff, theta3_diff2, R4_x, R4_x_diff, R4_x_diff2.")},
        {FaultKind::NoNumbers, QT_TR_NOOP("there are no numbers below the headings.")},
        {FaultKind::NoRow,
         QT_TR_NOOP("no row can be read, this one because of: %3. Write numbers as 0.005, or as 0,005 with columns "
                    "separated by semicolons or tabs.")},
        {FaultKind::MostRows,
         QT_TR_NOOP("most rows cannot be read, the first one because of: %3. Write every value as a number, such as "
                    "0.005, or leave the column out.")},
        {FaultKind::NoValues, QT_TR_NOOP("no column other than the time contains a number.")},
        {FaultKind::TimeNotRising,
         QT_TR_NOOP(
             "the time does not increase: sort the rows by time, and write it with more decimals if many rows have the "
             "same time.")},
        {FaultKind::TimeStartsAgain,
         QT_TR_NOOP("the time starts again: this file holds several motions; keep one of them.")},
        {FaultKind::AngleTurnsBack,
         QT_TR_NOOP("the crank angle goes back: sort the rows by it, and keep one row for each angle.")},
        {FaultKind::AngleStartsAgain,
         QT_TR_NOOP("the angle starts again: this file holds several motions; keep one of them.")},
        {FaultKind::OtherTimeStamps,
         QT_TR_NOOP("its time stamps are not those of %1: export the plots with the same start, end and step, or "
                    "open one file at a time.")},
        {FaultKind::ChannelInBoth,
         QT_TR_NOOP("both this file and %1 contain %2: leave one of them out, or choose the meaning of their "
                    "columns.")},
        {FaultKind::TooLarge, QT_TR_NOOP("The file is larger than 2 GB: export fewer rows or columns.")},
        {FaultKind::Stopped, QT_TR_NOOP("Reading was stopped.")},
        {FaultKind::NoMemory, QT_TR_NOOP("There is not enough memory: leave out rows or columns.")},
    };

    static constexpr EnumText<RowFault> kRowFaults[] = {
        {RowFault::NotANumber, QT_TR_NOOP("not a number")},
        {RowFault::TooLarge, QT_TR_NOOP("not a number: too large")},
        {RowFault::PointForComma, QT_TR_NOOP("not a number: this file uses a decimal comma")},
        {RowFault::CommaForPoint, QT_TR_NOOP("not a number: this file uses a decimal point")},
        {RowFault::TooManyCells, QT_TR_NOOP("too many cells")},
        {RowFault::TooFewCells, QT_TR_NOOP("too few cells")},
        {RowFault::NoTime, QT_TR_NOOP("no time")},
        {RowFault::RepeatedTime, QT_TR_NOOP("the same time as the next row, which is used")},
    };

    static QString row(RowFault fault) { return tr(rowOf(kRowFaults, fault).text); }
};

static_assert(isCompleteTable(ReadFaultText::kFaults, FaultKind::NoMemory));
static_assert(isCompleteTable(ReadFaultText::kRowFaults, RowFault::RepeatedTime));

} // namespace

QString rowFaultText(const SkippedRow &row)
{
    return ReadFaultText::row(row.fault);
}

QString faultText(const ReadFault &fault)
{
    const bool namesUnit = fault.kind == FaultKind::UnknownUnit;
    return ReadFaultText::tr(rowOf(ReadFaultText::kFaults, fault.kind).text)
        .replace("%6", QString::number(fault.cellCount))
        .replace("%5", QString::number(fault.headingCount))
        .replace("%4", reasonText(fault.columnReason))
        .replace("%3", ReadFaultText::row(fault.rowFault))
        .replace("%2", QString::fromUtf8(namesUnit ? fileUnit(fault.channel) : nameOf(fault.channel)))
        .replace("%1", QString::fromUtf8(fault.heading));
}

/// Returns the word with which --column chooses this meaning.
static QString meaningWord(const ColumnChoice &choice)
{
    switch (choice.role) {
    case ColumnRole::Ignored: return "ignored";
    case ColumnRole::Time: return "time";
    case ColumnRole::CrankAngle: return "theta2";
    case ColumnRole::Channel: break;
    }
    return columnName(choice.channel);
}

QString optionText(const std::vector<ColumnChoice> &choices)
{
    QStringList options;
    for (const ColumnChoice &choice : choices) {
        const QString unit =
            choice.unit.empty() ? QString() : QStringLiteral(" [%1]").arg(QString::fromUtf8(choice.unit));
        options +=
            QStringLiteral("--column \"%1=%2%3\"").arg(QString::fromUtf8(choice.heading), meaningWord(choice), unit);
    }
    return options.join(u' ');
}

} // namespace slidercrank
