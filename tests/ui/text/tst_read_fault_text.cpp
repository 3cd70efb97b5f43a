// SPDX-License-Identifier: GPL-3.0-or-later

// Why a file, or a row of it, cannot be read: a sentence for each reason, in both languages.

#include "ui/text/read_fault_text.h"

#include "ui/text/language.h"

#include <QTest>

using namespace slidercrank;

using Kind = ReadFault::Kind;

namespace
{

/// One of each kind, some with other values, too.
struct Said {
    ReadFault fault;
    const char *english;
};

const std::vector<Said> &allFaults()
{
    static const std::vector<Said> all{
        {{Kind::Empty}, "The file is empty: it needs a line with the names of the columns, and numbers below."},
        {{Kind::Spreadsheet}, "The file is a spreadsheet or an archive, not text: save the table as CSV."},
        {{Kind::Pdf}, "The file is a PDF document, not a table: export the table as CSV."},
        {{Kind::Markup}, "The file is HTML or XML, not a table of text: export the table as CSV."},
        {{Kind::Json}, "The file is JSON, not a table of text: export the table as CSV."},
        {{Kind::NotText}, "the file holds bytes that are not text: export the table as CSV."},
        {{.kind = Kind::UnitsContradict, .heading = "R4_x [mm]"},
         "the line of units contradicts the heading, R4_x [mm]: correct one of the two."},
        {{Kind::NamesMissing},
         "numbers stand where the names of the columns should: put a line such as time,theta3,R4_x above them."},
        {{Kind::UnknownUnit, {Theta3, Order::Velocity}},
         "the unit is not known or does not suit the quantity: write for example [°/s], rad in its place, or none."},
        {{Kind::UnknownUnit, {R4x, Order::Acceleration}},
         "the unit is not known or does not suit the quantity: write for example [mm/s²], m, cm or in in its place, or "
         "none."},
        {{Kind::UnknownTimeUnit}, "the unit of the time is not known: write [s] or [ms], or none for seconds."},
        {{.kind = Kind::NoSuchColumn, .heading = "x"}, "there is no column \"x\"."},
        {{.kind = Kind::SeveralColumns, .heading = "x"},
         "several columns are called \"x\": give the number of the one, as in #3."},
        {{Kind::ChannelTwice}, "there is a column of that name already: keep one of the two."},
        {{Kind::TimeTwice}, "there is a time column already: keep one of the two."},
        {{Kind::ChannelChosenTwice, {R4x, Order::Position}}, "two columns are chosen as R4_x: keep one of the two."},
        {{Kind::TimeChosenTwice}, "two columns are chosen as the time: keep one of the two."},
        {{Kind::NoTime},
         "there is no time column: name the column of the instants \"time\", or that of the crank's angle \"theta2\"."},
        {{Kind::NoChannel},
         "no column beside the time has a known name: name them as in theta3, theta3_diff, theta3_diff2, R4_x, "
         "R4_x_diff, R4_x_diff2."},
        {{.kind = Kind::NoCertainChannel, .heading = "P[1]", .column = ColumnReason::AngleOrLength},
         "the columns beside the time are unknown (P[1]: neither its unit nor its values tell an angle from a "
         "length): name them as in theta3, theta3_diff, theta3_diff2, R4_x, R4_x_diff, R4_x_diff2."},
        {{.kind = Kind::NoCertainChannel, .heading = "x", .column = ColumnReason::LikeOther},
         "the columns beside the time are unknown (x: another column could be the same quantity): name them "
         "as in theta3, theta3_diff, theta3_diff2, R4_x, R4_x_diff, R4_x_diff2."},
        {{.kind = Kind::NoCertainChannel, .heading = "J1_x", .column = ColumnReason::UnknownBody},
         "the columns beside the time are unknown (J1_x: its name does not say of which body it is): name them as "
         "in "
         "theta3, theta3_diff, theta3_diff2, R4_x, R4_x_diff, R4_x_diff2."},
        {{.kind = Kind::NoCertainChannel, .heading = "x", .column = ColumnReason::UnknownUnit},
         "the columns beside the time are unknown (x: its unit is not known or does not suit the quantity): "
         "name them as in theta3, theta3_diff, theta3_diff2, R4_x, R4_x_diff, R4_x_diff2."},
        {{.kind = Kind::NoCertainChannel, .heading = "x", .column = ColumnReason::NotDerivative},
         "the columns beside the time are unknown (x: its values are not the derivative that its name says): "
         "name them as in theta3, theta3_diff, theta3_diff2, R4_x, R4_x_diff, R4_x_diff2."},
        {{Kind::NoNumbers}, "there are no numbers below the names of the columns."},
        {{.kind = Kind::NoRow, .row = RowFault::TooManyCells},
         "no row can be read; here the reason is: too many cells. Numbers look like 0.005, or like 0,005 where "
         "semicolons or tabs separate the columns."},
        {{Kind::NoValues}, "no column beside the time holds a number."},
        {{Kind::TimeNotRising},
         "the time does not increase from the row before: sort the rows by time and keep one of each instant."},
        {{.kind = Kind::AngleTurnsBack, .heading = "20°"},
         "the crank angle goes back after 20°: sort the rows by it, one row for each angle."},
        {{.kind = Kind::OtherInstants, .heading = "a.csv"},
         "its instants are not those of a.csv: export the plots with the same start, end and step, or open one file at "
         "a time."},
        {{.kind = Kind::CountsOtherwise, .heading = "a.csv"},
         "of this file and a.csv, one goes by the time and the other by the crank angle: export both by the same, or "
         "open one file at a time."},
        {{.kind = Kind::ChannelInBoth, .channel = {R4x, Order::Velocity}, .heading = "a.csv"},
         "it holds R4_x_diff, and a.csv does, too: leave one of the two out, or choose what their columns are."},
        {{Kind::LineTooLong}, "the line has more than a million characters: export the table as CSV, a row a line."},
        {{Kind::TooLarge}, "The file is larger than 2 GB: export fewer rows or columns."},
        {{Kind::Stopped}, "Reading was stopped."},
        {{Kind::Unreadable}, "The file became shorter while it was read: open it again."},
        {{Kind::NoMemory}, "There is not enough memory for a file of that size: leave out rows or columns."},
    };
    return all;
}

const std::vector<std::pair<RowFault, const char *>> kRows{
    {RowFault::NotANumber, "not a number"},
    {RowFault::TooLarge, "not a number: too large"},
    {RowFault::PointForComma, "not a number: this file writes a decimal comma"},
    {RowFault::CommaForPoint, "not a number: this file writes a decimal point"},
    {RowFault::OpenQuotation, "a quotation mark that is not closed at the end of the cell"},
    {RowFault::TooManyCells, "too many cells"},
    {RowFault::TooFewCells, "too few cells"},
    {RowFault::NoTime, "no time"},
    {RowFault::RepeatedTime, "the next row has the same time, and the last of such rows counts"},
    {RowFault::NotListed, "this line and 1499 more below it cannot be read either"},
};

SkippedRow rowOf(RowFault fault)
{
    return {3, 1, {}, fault, 1500};
}

} // namespace

class TestReadFaultText : public QObject
{
    Q_OBJECT

private slots:
    void saysWhatToDo()
    {
        setLanguage(Language::English);
        for (const Said &said : allFaults()) {
            QCOMPARE(sentenceOf(said.fault), QString::fromUtf8(said.english));
        }
        for (const auto &[fault, english] : kRows) {
            QCOMPARE(reasonOf(rowOf(fault)), QString::fromUtf8(english));
        }
    }

    void eachReasonHasASentenceOfItsOwnInEitherLanguage()
    {
        QSet<QString> sentences;
        QSet<QString> clauses;
        for (const Language language : {Language::English, Language::Spanish}) {
            setLanguage(language);
            for (const Said &said : allFaults()) {
                const QString sentence = sentenceOf(said.fault);
                QVERIFY2(sentence.size() > 1 && sentence.endsWith(u'.') && !sentence.contains(u'%'),
                         qPrintable(sentence));
                QVERIFY2(!sentences.contains(sentence), qPrintable(sentence));
                sentences += sentence;
            }
            for (const auto &[fault, english] : kRows) {
                const QString clause = reasonOf(rowOf(fault));
                QVERIFY2(!clause.isEmpty() && !clause.contains(u'%') && !clauses.contains(clause), english);
                clauses += clause;
            }
        }
        setLanguage(Language::English);
        // None was forgotten above: the enumerators end with these.
        QCOMPARE(kRows.size(), static_cast<std::size_t>(RowFault::NotListed) + 1);
        for (int kind = 0; kind <= static_cast<int>(Kind::NoMemory); ++kind) {
            const bool said = std::any_of(allFaults().begin(), allFaults().end(), [kind](const Said &each) {
                return each.fault.kind == static_cast<Kind>(kind);
            });
            QVERIFY2(said, qPrintable(QString::number(kind)));
        }
    }

    void reasonsAreInTheLanguageInUse()
    {
        for (const auto &[fault, english] : kRows) {
            setLanguage(Language::Spanish);
            QVERIFY(reasonOf(rowOf(fault)) != QString::fromUtf8(english));
            setLanguage(Language::English);
            QCOMPARE(reasonOf(rowOf(fault)), QString::fromUtf8(english));
        }
    }
};

QTEST_GUILESS_MAIN(TestReadFaultText)
#include "tst_read_fault_text.moc"
