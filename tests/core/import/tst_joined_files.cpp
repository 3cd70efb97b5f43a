// SPDX-License-Identifier: GPL-3.0-or-later

// Joins several files of one motion.

#include "tests/support/described_reading.h"
#include "tests/support/suite.h"

#include <QTest>

using namespace slidercrank;

namespace tst_joined_files
{

using Kind = ReadFault::Kind;

class TestJoinedFiles : public QObject
{
    Q_OBJECT

private slots:
    void joinsRows()
    {
        struct Row {
            QByteArrayList files;
            const char *expected;
            std::vector<ColumnChoice> choices{};
            bool areBeginnings = false;
        };
        const QByteArrayList files{"T,Value\n0,1\n1,2\n", "T,Value\n0,3\n1,4\n"};
        constexpr ColumnRole kChannel = ColumnRole::Channel;
        const std::vector<Row> rows{
            {{"time,R4_x\n0,1\n1,2\n2,?\n3,4\n", "time,theta3\n0,5\n1,\n2,7\n3,oh\n"},
             "time 0 1; R4_x 1 2; theta3 5 gap; skipped 4:2 ? (not a number); skipped file 1 5:2 oh (not a number)"},
            {{"theta2,R4_x\n0,1\n90,2\n180,3\n", "theta2,theta3\n0.0,4\n90.0,5\n180.0,6\n"},
             "time 0 0.25 0.5; R4_x 1 2 3; theta3 4 5 6"},
            {{"time,R4_x\n0,1\n1,2\n2,3\n", "time,theta3\n0,5\n1,6\n"}, "time 0 1; R4_x 1 2; theta3 5 6", {}, true},
            // The columns of all files are numbered consecutively.
            {files, "time 0 1; R4_x 1 2; R4_x_diff 3000 4000", {{1, kChannel, kX, {}}, {3, kChannel, kV, "m/s"}}},
            {files, "time 0 1; R4_x 1 2; R4_x_diff 3 4", {{0, kChannel, kX, {}, "#2"}, {0, kChannel, kV, {}, "#4"}}},
            // The choice for the first column applies to the same heading in the other files.
            {{"q,R4_x\n0,1\n90,2\n", "q,theta3\n0,3\n90,4\n"},
             "time 0 0.25; R4_x 1 2; theta3 3 4",
             {{0, ColumnRole::CrankAngle, {}, {}}}},
        };
        for (const Row &row : rows) {
            QCOMPARE(described(readJoined(row.files, {row.choices, {}}, row.areBeginnings)), std::string(row.expected));
        }
        const Outcome several = readJoined(files, {{{0, kChannel, kX, {}, "Value"}}, {}});
        QCOMPARE(std::get<ReadError>(several).fault.kind, Kind::SeveralColumns);
        QCOMPARE(std::get<ReadError>(several).layout.columns.size(), std::size_t(4));
    }

    void refusesFilesOfDifferentMotions()
    {
        struct Row {
            const char *name;
            QByteArrayList files;
            ReadFault fault;
            std::size_t file = 1;
        };
        const QByteArray a = "time,R4_x\n0,1\n1,2\n2,3\n";
        const ReadFault otherTimes{Kind::OtherTimeStamps, {}, "a"};
        const std::vector<Row> rows{
            {"twice the step", {a, "time,theta3\n0,1\n2,2\n4,3\n"}, otherTimes},
            {"a little later", {a, "time,theta3\n0.1,1\n1.1,2\n2.1,3\n"}, otherTimes},
            {"other digits", {"time,R4_x\n0,1\n0.033,2\n", "time,theta3\n0,1\n0.03333,2\n"}, otherTimes},
            {"one row less", {a, "time,theta3\n0,1\n1,2\n"}, otherTimes},
            {"a different unit of time", {a, "time [ms],theta3\n0,1\n1,2\n2,3\n"}, otherTimes},
            {"the third", {a, "time,theta3\n0,1\n1,2\n2,3\n", "time,theta2\n0,1\n1.5,2\n2,3\n"}, otherTimes, 2},
            {"a channel twice", {a, "time,r4x\n0,1\n1,2\n2,3\n"}, {Kind::ChannelInBoth, kX, "a"}},
            {"angles beside time stamps", {a, "theta2,theta3\n0,1\n1,2\n2,3\n"}, {Kind::NoTime}},
            {"no table", {a, "%PDF-1.7\n"}, {Kind::Pdf}},
            {"an empty first file", {"", a}, {Kind::Empty}, 0},
            {"an unknown column", {a, "time,humidity\n0,1\n1,2\n2,3\n"}, {Kind::NoChannel}},
        };
        for (const Row &row : rows) {
            const Outcome outcome = readJoined(row.files);
            const ReadError *error = std::get_if<ReadError>(&outcome);
            QVERIFY2(error && error->fault == row.fault && error->file == row.file, row.name);
        }
    }
};

const Suite<TestJoinedFiles> suite("tst_joined_files");

} // namespace tst_joined_files

#include "tst_joined_files.moc"
