// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/reference_data.h"

#include "tests/support/described_reading.h"
#include "tests/support/suite.h"

#include <QTest>

#include <algorithm>
#include <charconv>
#include <cmath>

using namespace slidercrank;

namespace tst_reference_data
{

using Kind = ReadFault::Kind;

struct ReadRow {
    const char *name;
    QByteArray bytes;
    const char *expected;
};

const std::vector<ReadRow> kRead{
    // Lines and delimiters.
    {"CR LF, but not after the last line", "time,R4_x\r\n0,74.5436\r\n0.005,74.8173",
     "time 0 0.005; R4_x 74.5436 74.8173"},
    {"CR", "time,R4_x\r0,74.5436\r0.005,74.8173\r", "time 0 0.005; R4_x 74.5436 74.8173"},
    {"blank lines and spaces", "\n \ntime , R4_x \n\n 0 , 74.5436 \n   \n0.005,\t74.8173\t\n,,\n\n",
     "time 0 0.005; R4_x 74.5436 74.8173"},
    {"delimiters at the end of lines", "time,R4_x,\n0,74.5436,,\n0.005,74.8173\n",
     "time 0 0.005; R4_x 74.5436 74.8173"},
    {"an empty last cell is a gap", "time,R4_x,theta3\n0,1,2\n1,3,\n", "time 0 1; R4_x 1 3; theta3 2 gap"},
    {"an unknown heading without cells", "time,R4_x,by hand\n0,1\n1,2\n", "time 0 1; R4_x 1 2"},
    {"line numbers with any line ending", "time,R4_x\r\n\r\n0,1\n\n1,a\r2,b\r\n3,1\n",
     "time 0 3; R4_x 1 1; skipped 5:2 a (not a number); skipped 6:2 b (not a number)"},
    // Decimal commas and separators of thousands.
    {"decimal commas, tabs", "time\tR4_x\n0\t74,5436\n0,005\t74,8173\n", "time 0 0.005; R4_x 74.5436 74.8173"},
    {"decimal commas, quoted", "time,R4_x\n\"0\",\"74,5436\"\n\"0,005\",\"74,8173\"\n",
     "time 0 0.005; R4_x 74.5436 74.8173"},
    {"three digits after every comma are decimals between semicolons", "time;R4_x\n1;1,234\n2;5,678\n",
     "time 1 2; R4_x 1.234 5.678"},
    {"thousands separators and decimal commas",
     "time;R4_x\n0,5;1.234,56\n1;-12.345.678,5\n2;1.234.567\n3;1.234\n4;12.34,5\n",
     "time 0.5 1 2; R4_x 1234.56 -12345678.5 1234567; skipped 5:2 1.234 (point for comma); skipped 6:2 12.34,5 (point "
     "for comma)"},
    {"thousands separators and decimal points", "time;R4_x\n0.5;1,234.56\n1;1,234\n2;3\n",
     "time 0.5 2; R4_x 1234.56 3; skipped 3:2 1,234 (comma for point)"},
    {"thousands separators show the decimal sign", "time;R4_x\n1;1.234,5\n2;2.345,5\n", "time 1 2; R4_x 1234.5 2345.5"},
    {"a quoted comma is not decimal between commas", "time,R4_x\n0,\"1,234\"\n1,5\n",
     "time 1; R4_x 5; skipped 2:2 1,234 (comma for point)"},
    {"zeros before quoted commas show decimals", "time,R4_x\n0,\"1,234\"\n1,\"0,234\"\n2,\"-0,034\"\n3,5\n",
     "time 0 1 2 3; R4_x 1.234 0.234 -0.034 5"},
    {"whole numbers beside quoted decimals", "time,theta2,theta4,R4_x\n0,7,0,\"1,25\"\n1,8,0,\"2,5\"\n",
     "time 0 1; theta2 7 8; theta4 0 0; R4_x 1.25 2.5"},
    {"no thousands begin with a zero", "time;R4_x\n0.5;0,234.5\n1.5;2\n",
     "time 1.5; R4_x 2; skipped 2:2 0,234.5 (comma for point)"},
    {"spaces and apostrophes separate thousands", "time;R4_x\n0;1 234,5\n1;-1\u202F234,5\n2;1'234,5\n3;12 34,5\n",
     "time 0 1 2; R4_x 1234.5 -1234.5 1234.5; skipped 5:2 12 34,5 (not a number)"},
    {"a blank behind the sign, and the brackets of accountants", "time;R4_x\n0;- 1.5\n1;(2.5)\n2;(-3)\n3;-(3)\n",
     "time 0 1; R4_x -1.5 -2.5; skipped 4:2 (-3) (not a number); skipped 5:2 -(3) (not a number)"},
    {"uncertainties behind the numbers", "time;R4_x\n0;1,5 ± 0,1\n1;2,5 ±0,1\n2;± 0,1\n",
     "time 0 1; R4_x 1.5 2.5; skipped 4:2 ± 0,1 (not a number)"},
    {"vertical bars", "|time|R4_x|\n|---|---|\n|0|1|\n|1|2|\n", "time 0 1; R4_x 1 2"},
    {"padding after the text", QByteArray("time,R4_x\n0,1\n1,2\n\x1A\0\0\0", 22), "time 0 1; R4_x 1 2"},
    // Clocks.
    {"a clock", "time;R4_x\n12:59:59,5;1,5\n01:00:00,25;2,5\n01:00:01;3,5\n", "time 0 0.75 1.5; R4_x 1.5 2.5 3.5"},
    {"a duration", "time,R4_x\n0 days 00:00:01.5,1\n0 days 00:01:00,2\n", "time 1.5 60; R4_x 1 2"},
    {"dates and a time zone", "Time,R4_x\n2024-03-01T23:59:59Z,1\n2024-03-02T00:00:01Z,2\n2024-03-02T00:00:02Z,3\n",
     "time 0 2 3; R4_x 1 2 3"},
    {"a date, after midnight", "Time,R4_x\n2024-03-01 00:33:10.5,1\n2024-03-01 00:33:11,2\n", "time 0 0.5; R4_x 1 2"},
    {"s since 1970", "time,R4_x\n1709634123.0250,1\n1709634123.0500,2\n", "time 0 0.025; R4_x 1 2"},
    {"ms since 1970", "time,R4_x\n1709290000000,1\n1709290000005,2\n", "time 0 0.005; R4_x 1 2"},
    // Names.
    {"columns in any order and case", "THETA3_Diff2,r4_X,Time\n3,2,1\n", "time 1; theta3_diff2 3; R4_x 2"},
    {"names after a percent sign, with another delimiter", "% time R4_x\n0,1\n1,2\n", "time 0 1; R4_x 1 2"},
    {"names directly after a percent sign", "%time  slider position (m)\n0 1\n1 2\n", "time 0 1; R4_x 1000 2000"},
    {"delimiters and quotation marks in quotes", "time,note,R4_x\n0,\"a, b \"\"c\"\"\",5\n", "time 0; R4_x 5"},
    {"text after a closing quotation mark, and no closing one", "time,R4_x\n0,\"12\"3\n1,\"1\n2,5\n3,6\n",
     "time 2 3; R4_x 5 6; skipped 2:2 \"12\"3 (not a number); skipped 3:2 \"1 (not a number)"},
    {"unknown columns may contain anything", "n,time,,R4_x,R4_x_diff3\nabc,0,1,5,inf\n", "time 0; R4_x 5"},
    // Numbers.
    {"Fortran's exponents", "time,R4_x\n0,1.5D+03\n1,2d0\n", "time 0 1; R4_x 1500 2"},
    {"forms of numbers", "time,R4_x\n-1.5e-3,+5\n.5,-.25\n1.,1E2\n2,-0\n3,\u22125\n4,74.543567890123451\n",
     "time -0.0015 0.5 1 2 3 4; R4_x 5 -0.25 100 -0 -5 74.54356789012346"},
    {"gaps", "time,R4_x,theta3\n0,,1\n1,nan,1\n2,-NaN,\n3,5\n4,NA,#N/A\n",
     "time 0 1 2 3 4; R4_x gap gap gap 5 gap; theta3 1 1 gap gap gap"},
    {"no numbers",
     "time,R4_x\n0,inf\n1,12abc\n2,0x1p3\n3,--1\n4,.\n5,1e999\n6,1.2.3\n7,1e-999\n8,1\n9,1\n10,1\n11,1\n12,1\n13,1\n",
     "time 7 8 9 10 11 12 13; R4_x 0 1 1 1 1 1 1; skipped 2:2 inf (not a number); skipped 3:2 12abc (not a number); "
     "skipped 4:2 0x1p3 (not a "
     "number); "
     "skipped 5:2 --1 (not a number); skipped 6:2 . (not a number); skipped 7:2 1e999 (too large); skipped 8:2 1.2.3 "
     "(not a number)"},
    {"too large once converted", "time,R4_x [m]\n0,1e307\n1,1\n", "time 1; R4_x 1000; skipped 2:2 1e307 (too large)"},
    {"a crank angle too large once converted", "theta2 (rad),R4_x\n0,3\n1e308,4\n",
     "time 0; R4_x 3; skipped 3:1 1e308 (too large)"},
    {"rows with too many or too few cells, or without time", "time,R4_x,theta3\n1,2,3,4\n,2,3\nnan,2,3\n2,3,4\n3\n",
     "time 2; R4_x 3; theta3 4; skipped 2:4 4 (too many cells); skipped 3:1  (no time); skipped 4:1 nan (no time); "
     "skipped "
     "6:1 3 (too few cells)"},
    {"a long cell is shortened between characters", "time,R4_x\n0,x" + QByteArray("±").repeated(30) + "\n1,2\n",
     "time 1; R4_x 2; skipped 2:2 x±±±±±±±±±±±±±±±±±±±… (not a number)"},
    {"the last one of several rows at the time of an event", "time,R4_x\n0,1\n1,2\n1,3\n1,4\n2,x\n3,5\n",
     "time 0 1 3; R4_x 1 4 5; skipped 3:1 1 (repeated time); skipped 4:1 1 (repeated time); skipped 6:2 x (not a "
     "number)"},
};

struct NamesRow {
    QByteArray bytes;
    const char *roles;
    const char *format = ", point line 1";
};

const QByteArray kRows = "\n0,1,2\n1,2,3\n2,4,1\n";
const QByteArray kUneven = "\n0,0,0\n1,1,2\n2,4,4\n3,9,6\n4,16,8\n5,25,10\n6,36,12\n7,49,14\n8,64,16\n";
const QByteArray kEven = "0,0,60\n1,1,60\n2,2,60\n3,3,60\n4,4,60\n5,5,60\n6,6,60\n7,7,60\n8,8,60\n9,9,60\n";
const QByteArray kSpanish = "Tiempo (s);Posición de la corredera (mm);Ángulo de la biela (°)\n0;1,5;2\n1;2,5;3\n";

const std::vector<NamesRow> kNames{
    {"\xEF\xBB\xBFtime,R4_x,theta3" + kRows, "time R4_x theta3", ", point line 1"},
    {utf16Of(kSpanish, true, true), "time R4_x theta3", "; comma line 1"},
    {utf16Of(kSpanish, false, true), "time R4_x theta3", "; comma line 1"},
    {utf16Of(kSpanish, true, false), "time R4_x theta3", "; comma line 1"},
    {utf16Of(kSpanish, false, false), "time R4_x theta3", "; comma line 1"},
    {QString::fromUtf8(kSpanish).toLatin1(), "time R4_x theta3", "; comma line 1"},
    {"sep=;\ntime;R4_x\n0;1\n", "time R4_x", "; point line 2"},
    {"200\nrun 7, 1 s\n# solved\ntime,R4_x\n0,1\n", "time R4_x", ", point line 4"},
    {"time,R4_x,theta3\n[ms],[cm],-" + kRows, "time R4_x theta3", ", point line 1"},
    {"% t R4_x theta3\n% s mm deg\n0 1 2\n1 2 3\n", "time R4_x theta3", "  point line 1"},
    {"Time_ms,SliderPosition_m,couplerAngle_rad" + kRows, "time R4_x theta3"},
    {"θ₂,θ₃ (deg),x_B (mm)" + kRows, "angle theta3 R4_x"}, // the symbols of a textbook, which leave nothing open
    {"theta2 [deg],d [in],d_dot [in/s]" + kRows, "angle R4_x R4_x_diff"},
    {"time,x_B (mm),theta" + kRows, "time R4_x? theta3?"},
    {"Zeit in s,Weg in mm,Pleuelwinkel in Grad" + kRows, "time R4_x? theta3"},
    {"% time, R4_x, theta3, comment\n0,1,2\n1,2,3\n", "time R4_x theta3 -", ", point line 1"},
    {"%\ttime\tR4_x\n0,1\n1,2\n", "time R4_x", ", point line 1"},
    {"t theta3 R4_x\n0\t1\t2\n1\t2\t3\n", "time theta3 R4_x", "\t point line 1"},
    {"time,angle,speed (rpm)\n" + kEven, "time theta2? theta2_diff?", ", point line 1"},
    {"timestamp,t (s),R4_x\n2024-03-01 12:00:00,0,1\n2024-03-01 12:00:01,1,2\n", "- time R4_x"},
    {"t,θ3 [°],ω3 (rad/s),θ₂,R4x ddot\n0,1,2,3,4\n", "time theta3 theta3_diff theta2 R4_x_diff2"},
    {"no.,X_Value,R4_x\n1,0,5\n1,2,6\n", "- time? R4_x"},
    {"time,slider position,pressure,,n,part 7 velocity\n0,1,2,3,4,5\n", "time R4_x - - - -"},
    // An angle that spans more than half a turn is that of the crank, and so is its derivative.
    {"time,angle (rad),angular velocity (rad/s)" + kUneven, "time theta2? theta2_diff?"},
    {"time,angle 1 (rad),angular velocity (rad/s),angle 2 (rad)" + QByteArray(kUneven).replace("\n", ",0\n").mid(2),
     "time theta2? - theta3?"},
    {"time,angle 1 (deg),angle 2 (deg)\n0,350,90\n1,355,180\n2,0,-90\n3,5,0\n4,0,90\n", "time theta3? theta2?"},
    {"time,P[2.1] (deg),V[2.1],P[3.1] (mm)\n0,1,2,3\n1,2,3,4\n2,4,1,5\n", "time theta3? - R4_x?"},
};

struct Refusal {
    const char *name;
    QByteArray bytes;
    const char *position; ///< line, column and text: "3:2 a"
    ReadFault fault;
};

const ReadFault kTimeRepeats{.kind = Kind::TimeNotRising, .rowFault = RowFault::RepeatedTime};

const std::vector<Refusal> kRefused{
    {"nothing", "", "0:0 ", {Kind::Empty}},
    {"blank lines after a byte order mark", "\xEF\xBB\xBF\r\n \r\n,,\r\n", "0:0 ", {Kind::Empty}},
    {"a spreadsheet", QByteArray("PK\x03\x04\0\0", 6), "0:0 ", {Kind::Spreadsheet}},
    {"a PDF", "%PDF-1.7\n1 0 obj\n", "0:0 ", {Kind::Pdf}},
    {"HTML in UTF-16", utf16Of("\n<!DOCTYPE html>\n", true, true), "0:0 ", {Kind::Markup}},
    {"JSON", "{ \"time\": [0, 1]}", "0:0 ", {Kind::Json}},
    {"a zero byte", QByteArray("time,R4_x\n0,1\n1,\0\n2,3\n", 22), "3:0 ", {Kind::NotText}},
    {"binary data that begin like markup", QByteArray("<!\x02\x05\x80", 5).repeated(9), "1:0 ", {Kind::NotText}},
    {"a long line", QByteArray(1'100'000, 'a'), "1:0 ", {Kind::LineTooLong}},
    {"numbers without headings", "\n0.0,74.5\n0.1,74.8\n", "2:0 ", {Kind::NamesMissing}},
    {"no time", "n,R4_x\n1,5\n2,6\n", "1:0 ", {Kind::NoTime}},
    {"a remark with one known word", "# Created By Octave 8.4\n0 1 2 3\n1 2 3 4\n", "2:0 ", {Kind::NamesMissing}},
    {"prose", "Lorem ipsum\ndolor\n", "1:0 ", {Kind::NoTime}},
    {"a long text", QByteArray("Lorem ipsum, dolor 7\n").repeated(12), "0:0 ", {Kind::NotATable}},
    {"no channel", "time,pressure\n0,1\n", "1:0 ", {Kind::NoChannel}},
    {"an unknown unit", "time,theta3,R4_x [ell]\n0,1,2\n", "1:3 R4_x [ell]", {Kind::UnknownUnit, kX}},
    {"the unit of another derivative", "time,R4_x_diff [m]\n0,1\n", "1:2 R4_x_diff [m]", {Kind::UnknownUnit, kV}},
    {"half a unit", "time,R4_x_diff [m/]\n0,1\n", "1:2 R4_x_diff [m/]", {Kind::UnknownUnit, kV}},
    {"contradicting units", "time,theta3 [rad]\ns,deg\n0,1\n", "2:2 deg", {Kind::UnitsContradict, {}, "theta3 [rad]"}},
    {"an unknown unit of time", "time [days],R4_x\n0,1\n", "1:1 time [days]", {Kind::UnknownTimeUnit}},
    {"ns or µs without a unit", "time,R4_x\n0,1\n500000000,2\n", "1:1 time", {Kind::UnknownTimeUnit}},
    {"two tables side by side",
     "theta2,x (mm),,theta2,x (mm)\n0,1,,0,5\n90,2,,90,6\n180,3,,180,7\n",
     "1:0 ",
     {.kind = Kind::NoCertainChannel, .heading = "x (mm)", .columnReason = ColumnReason::LikeOther}},
    {"a channel twice", "time,R4_x,r4x [m]\n0,1,2\n", "1:3 r4x [m]", {Kind::ChannelTwice, kX}},
    {"two different times", "time,R4_x,Tiempo\n0,1,2\n", "1:3 Tiempo", {Kind::TimeTwice}},
    {"only headings", "time,R4_x\n", "1:0 ", {Kind::NoNumbers}},
    {"no readable row", "time,R4_x\n\n0,a\n1,b\n", "3:2 a", {Kind::NoRow}},
    {"decimal commas between commas",
     "time,R4_x\n0,005,74,5436\n0,010,74,8173\n",
     "2:3 74",
     {.kind = Kind::NoRow, .rowFault = RowFault::TooManyCells}},
    {"no value", "time,R4_x\n0,\n1,nan\n", "2:0 ", {Kind::NoValues}},
    {"a time that mostly repeats", "R4_x,time\n1,0\n2,0\n3,0\n4,1\n5,1\n", "3:2 0", kTimeRepeats},
    {"a time that decreases", "time [ms],R4_x\n0,1\n1,x\n-250,2\n", "4:1 -250", kTimeRepeats},
    {"a crank angle that changes its direction",
     "Crank angle,R4_x\n0,3\n15,4\n10,5\n",
     "4:0 ",
     {.kind = Kind::AngleTurnsBack}},
    {"a time that starts again",
     "time,R4_x\n0,1\n1,2\n2,3\n3,4\n0,1\n",
     "6:1 0",
     {.kind = Kind::TimeStartsAgain, .rowFault = RowFault::RepeatedTime}},
    {"a crank angle that starts again with other values",
     "theta2,R4_x\n0,9\n90,5\n180,1\n270,5\n0,19\n90,15\n180,11\n270,15\n",
     "6:0 ",
     {Kind::AngleStartsAgain}},
    {"more headings than cells",
     "time,Slider, position\n0,1\n1,2\n",
     "1:0 ",
     {.kind = Kind::MoreHeadings, .headingCount = 3, .cellCount = 2}},
    {"fewer headings than cells",
     "time,R4_x\n0.1,1.5,2.5\n0.2,1.25,2.5\n",
     "2:0 ",
     {.kind = Kind::FewerHeadings, .headingCount = 2, .cellCount = 3}},
    {"decimal commas between commas",
     "time,R4_x\n0,1,1,5\n0,2,1,25\n",
     "2:3 1",
     {.kind = Kind::NoRow, .rowFault = RowFault::TooManyCells}},
    {"common factor of MATLAB", "t x\n\n   1.0e+03 *\n\n   0 0.085\n   0.001 0.084\n", "3:0 ", {Kind::CommonFactor}},
    {"quantities in rows", "time;0;0.1;0.2;0.3\nR4_x [mm];8;7;6;5\n", "1:0 ", {Kind::Transposed}},
    {"another table", "time,R4_x\n0,8\n1,7\n\ntime,theta3\n0,1\n", "5:0 time,theta3", {Kind::AnotherTable}},
    {"two lengths of unnamed bodies",
     "time,disp 1 (mm),disp 2 (mm)" + kRows,
     "1:0 ",
     {Kind::NoCertainChannel, {}, "disp 1 (mm)", ColumnReason::LikeOther}},
    {"a letter of Inventor",
     tableUnder("Time,P[3.1]"),
     "1:0 ",
     {Kind::NoCertainChannel, {}, "P[3.1]", ColumnReason::AngleOrLength}},
    {"an angle in mm",
     tableUnder("time,coupler angle (mm)"),
     "1:0 ",
     {Kind::NoCertainChannel, {}, "coupler angle (mm)", ColumnReason::UnknownUnit}},
};

class TestReferenceData : public QObject
{
    Q_OBJECT

private slots:
    void readsTables()
    {
        for (const ReadRow &row : kRead) {
            QVERIFY2(described(read(row.bytes)) == row.expected,
                     (row.name + (": " + described(read(row.bytes)))).c_str());
        }
    }

    void recognizesHeadingsAndLayouts()
    {
        for (const NamesRow &row : kNames) {
            const Outcome outcome = read(row.bytes);
            const ReferenceData *const data = std::get_if<ReferenceData>(&outcome);
            QVERIFY2(data && rolesOf(data->layout) == row.roles, (row.bytes.constData() + described(outcome)).c_str());
            const FileLayout &layout = data->layout;
            QCOMPARE(formatOf(layout), std::string(row.format));
            QCOMPARE(layout.isGuessed(), QByteArray(row.roles).contains('?'));
        }
    }

    void refusesOtherFiles()
    {
        for (const Refusal &row : kRefused) {
            const Outcome outcome = read(row.bytes);
            const ReadError *error = std::get_if<ReadError>(&outcome);
            QVERIFY2(error && error->fault == row.fault, (row.name + (": " + described(outcome))).c_str());
            QCOMPARE(std::to_string(error->line) + ':' + std::to_string(error->column) + ' ' + error->text,
                     std::string(row.position));
        }
    }

    void appliesTheChoicesOfAPerson()
    {
        const QByteArray bytes = "n,time,a,R4_x\n1,5,0.1,3\n2,4,0.2,4\n3,3,0.3,5\n";
        QCOMPARE(described(read(bytes, {{2, ColumnRole::Time, {}, "ms"},
                                        {3, ColumnRole::Ignored, {}, {}},
                                        {0, ColumnRole::Channel, kX, "m"}})),
                 std::string("time 1e-04 2e-04 3e-04; R4_x 1000 2000 3000"));
        const QByteArray nameless = "0;1,5\n0,5;2,5\n";
        const Outcome refused = read(nameless);
        QCOMPARE(std::get<ReadError>(refused).layout.columns.size(), std::size_t(2));
        QCOMPARE(std::get<ReadError>(refused).layout.rows.size(), std::size_t(2));
        const std::vector<ColumnChoice> choices{{0, ColumnRole::Time, {}, {}},
                                                {1, ColumnRole::Channel, {Theta3, Order::Velocity}, "rad/s"}};
        QCOMPARE(described(read(nameless, choices)),
                 std::string("time 0 0.5; theta3_diff 85.94366926962348 143.2394487827058"));
    }

    void refusesContradictingChoices()
    {
        struct Row {
            std::vector<ColumnChoice> choices;
            ReadFault fault;
        };
        const std::vector<Row> rows{
            {{{0, ColumnRole::Time, {}, {}}, {1, ColumnRole::CrankAngle, {}, "deg"}}, {Kind::TimeTwice}},
            {{{1, ColumnRole::Channel, {Theta3, Order::Position}, {}}}, {Kind::UnknownUnit, {Theta3, Order::Position}}},
            {{{0, ColumnRole::Channel, kX, {}}, {1, ColumnRole::Channel, kX, {}}}, {Kind::ChannelTwice, kX}},
            {{{0, ColumnRole::CrankAngle, {}, "mm"}}, {Kind::UnknownUnit, {Theta2, Order::Position}}},
        };
        for (const Row &row : rows) {
            const Outcome outcome = read("time,R4_x [mm]\n0,1\n1,2\n", row.choices);
            QVERIFY(std::get<ReadError>(outcome).fault == row.fault);
        }
    }

    void givesTheReasonForEachRole()
    {
        const Outcome outcome =
            read("time,R4_x,Linear Velocity1 (mm/s),pressure,,R4_y\n0,0,2,5,1,\n1,2,2,5,1,\n2,4,2,5,1,\n");
        const std::vector<FileColumn> &columns = std::get<ReferenceData>(outcome).layout.columns;
        const std::vector reasons{ColumnReason::KnownName,   ColumnReason::KnownName, ColumnReason::QuantityInName,
                                  ColumnReason::UnknownName, ColumnReason::NoName,    ColumnReason::NoNumber};
        QVERIFY(std::ranges::equal(columns, reasons, {}, &FileColumn::reason));
        QCOMPARE(columns.at(2).unit, std::string("mm/s"));
        QCOMPARE(columns.at(2).heading, std::string("Linear Velocity1 (mm/s)"));
    }

    void reportsProgressAndStops()
    {
        const QByteArray bytes = "time,R4_x\n" + QByteArray("0,1\n").repeated(200'000);
        std::vector<double> done;
        ReadOptions options;
        options.progress = [&](double fraction) {
            done.push_back(fraction);
            return true;
        };
        const FileBytes file{{bytes.constData(), static_cast<std::size_t>(bytes.size())}};
        readFiles({&file, 1}, options);
        QVERIFY(done.size() >= 4 && std::is_sorted(done.begin(), done.end()));
        QCOMPARE(done.back(), 1.0);
        options.progress = [](double) { return false; };
        const Outcome outcome = readFiles({&file, 1}, options);
        QCOMPARE(std::get<ReadError>(outcome).fault.kind, Kind::Stopped);
    }

    void convertsUnits()
    {
        const double degree = kDegreesPerRadian;
        const std::vector<std::pair<QByteArray, double>> rows{{"theta3 []", 1.0},
                                                              {"R4_x[cm]", 10.0},
                                                              {"R4_x ( in )", 25.4},
                                                              {"theta3 [gon]", 0.9},
                                                              {"theta3_diff (1/min)", 6.0},
                                                              {"R4_x_diff2 (g)", 9806.65},
                                                              {"theta3 [º]", 1.0},
                                                              {"theta3 [\xB0]", 1.0},
                                                              {"theta3 [RAD]", degree},
                                                              {"R4_x_diff [m / s]", 1000.0},
                                                              {"R4_x_diff (mm/ms)", 1000.0},
                                                              {"R4_x_diff2 [m/s^2]", 1000.0},
                                                              {"R4_x_diff2 [cm/s2]", 10.0},
                                                              {"R4_x_diff2 [in/s/s]", 25.4},
                                                              {"R4_x_diff2 [mm/ms²]", 1e6},
                                                              {"theta3_diff2 [rad/s\xB2]", degree}};
        for (const auto &[heading, one] : rows) {
            const Outcome outcome =
                read("time\t" + heading + "\n0\t1\n1\t2.50\n2\t3.75\n3\t1.37\n4\t8.13\n5\t0.25\n6\t4.94\n");
            const ReferenceSeries &series = std::get<ReferenceData>(outcome).series.at(0);
            QCOMPARE(exactText(series.values[1]), exactText(2.5 * one));
            QVERIFY(std::abs(series.rounding.stepAt(series.values[1]) - 0.01 * one) < 1e-12 * one);
        }
        const Outcome outcome = read("R4_x,time [ms]\n1,0\n1,5\n1,7\n1,199\n");
        QCOMPARE(described(std::get<ReferenceData>(outcome).time),
                 std::string(" 0 0.005 0.007 0.199")); // to the last bit
    }

    void listsSkippedRowsAndTheLinesOfTheOthers()
    {
        const Outcome outcome = read("title\ntime,R4_x\n\n0,1\n" + QByteArray("n,x\n").repeated(2500) + "2,3\n2,4\n");
        const ReferenceData &data = std::get<ReferenceData>(outcome);
        QCOMPARE(data.lines, (std::vector<std::size_t>{4, 2506}));
        QVERIFY(data.skipped.size() == 1000 && data.skipped.back().line == 1004);
        QCOMPARE(data.skippedCount, std::size_t(2501));
    }

    void findsTheStepsOfEncodersAndConverters()
    {
        constexpr double kEncoder = 360.0 / 1024.0;
        constexpr double kConverter = 100.0 / 1023.0;
        const auto table = [&](bool isQuantized) {
            QByteArray bytes = "time,theta2,R4_x,theta3 [rad],R4_y\n";
            for (int row = 0; row < 200; ++row) {
                const double t = 0.005 * row;
                const auto quantized = [&](double value, double step) {
                    return isQuantized ? step * std::floor(value / step) : value;
                };
                const double x = 60.0 + 25.0 * std::cos(6.2 * t);
                bytes += QByteArray::number(t) + ',' + QByteArray::number(quantized(400.0 * t, kEncoder), 'f', 4) +
                         ',' + QByteArray::number(quantized(x, kConverter), 'f', 4) + ',' +
                         QByteArray::number(quantized(0.3 * std::sin(6.2 * t), kEncoder / kDegreesPerRadian), 'g', 17) +
                         ',' + QByteArray::number(row % 50 == 3 ? 20 : 10) + '\n';
            }
            return std::get<ReferenceData>(read(bytes));
        };
        const ReferenceData quantized = table(true);
        const std::vector<double> steps{kEncoder, kConverter, kEncoder, 1.0};
        for (std::size_t i = 0; i < steps.size(); ++i) {
            const double step = quantized.series[i].rounding.stepAt(50.0);
            QVERIFY2(std::abs(step - steps[i]) <= 1e-4 * steps[i], exactText(step).c_str());
        }
        for (const ReferenceSeries &series : table(false).series) {
            QVERIFY(series.rounding.rule != Rounding::Rule::Multiples);
        }
    }
};

const Suite<TestReferenceData> suite("tst_reference_data");

} // namespace tst_reference_data

#include "tst_reference_data.moc"
