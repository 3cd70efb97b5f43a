// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/reference_data.h"

#include "core/import/crank_angles.h"
#include "core/import/joined_files.h"

#include "core/comparison/comparison.h"
#include "core/sampling/trajectory.h"
#include "tests/support/file_variants.h"
#include "tests/support/long_tests.h"

#include <QFile>
#include <QTest>

#include <algorithm>
#include <array>
#include <atomic>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>
#include <new>
#include <random>
#include <span>
#include <string>
#include <string_view>

using namespace slidercrank;

namespace
{

constexpr int kPlenty = std::numeric_limits<int>::max();
std::atomic<int> allocationsLeft = kPlenty; // before there is no memory left

void *allocated(std::size_t size)
{
    if (allocationsLeft != kPlenty && --allocationsLeft < 0) {
        allocationsLeft = 0;
        return nullptr;
    }
    return std::malloc(std::max<std::size_t>(size, 1));
}

} // namespace

void *operator new(std::size_t size)
{
    if (void *memory = allocated(size)) {
        return memory;
    }
    throw std::bad_alloc();
}

void *operator new(std::size_t size, const std::nothrow_t &) noexcept
{
    return allocated(size);
}

// Not inlined, lest g++ 14 take new and free for a mistaken pair.
[[gnu::noinline]] void operator delete(void *memory) noexcept
{
    std::free(memory);
}

[[gnu::noinline]] void operator delete(void *memory, std::size_t) noexcept
{
    std::free(memory);
}

namespace
{

using Kind = ReadFault::Kind;

constexpr std::size_t kOnePiece = std::size_t{1} << 30U;

std::variant<ReferenceData, ReadError> read(const QByteArray &bytes, std::stop_token stop = {})
{
    return readReferenceData({bytes.constData(), static_cast<std::size_t>(bytes.size())}, stop);
}

/// The shortest text that gives the number back: two numbers with the same text are the same number.
std::string exactText(double value)
{
    std::array<char, 32> text;
    const auto [end, fault] = std::to_chars(text.data(), text.data() + text.size(), value);
    return {text.data(), end};
}

std::string described(const std::vector<double> &values)
{
    if (constexpr std::size_t kMany = 10'000; values.size() > kMany) {
        const auto bytes = std::as_bytes(std::span(values));
        const auto sum = std::hash<std::string_view>()({reinterpret_cast<const char *>(bytes.data()), bytes.size()});
        return ' ' + std::to_string(values.size()) + " of " + std::to_string(sum);
    }
    std::string text;
    for (const double value : values) {
        text += ' ' + (std::isnan(value) ? std::string("gap") : exactText(value));
    }
    return text;
}

std::string wordsOf(RowFault fault)
{
    switch (fault) {
    case RowFault::NotANumber: return "not a number";
    case RowFault::TooLarge: return "not a number: too large";
    case RowFault::PointForComma: return "not a number: this file writes a decimal comma";
    case RowFault::CommaForPoint: return "not a number: this file writes a decimal point";
    case RowFault::OpenQuotation: return "a quotation mark that is not closed at the end of the cell";
    case RowFault::TooManyCells: return "too many cells";
    case RowFault::TooFewCells: return "too few cells";
    case RowFault::NoTime: return "no time";
    case RowFault::NotListed: return "not listed";
    }
    return {};
}

/// All that was read, as one line: "time 0 0.5; R4_x 85 gap; skipped 3:2 abc (not a number); ignored notes".
QString described(const std::variant<ReferenceData, ReadError> &outcome)
{
    if (const ReadError *error = std::get_if<ReadError>(&outcome)) {
        return QStringLiteral("error: reason %1").arg(static_cast<int>(error->fault.kind));
    }
    const ReferenceData &data = std::get<ReferenceData>(outcome);
    std::string text = "time" + described(data.time);
    for (const ReferenceSeries &series : data.series) {
        text += "; " + std::string(nameOf(series.channel)) + described(series.values);
    }
    for (const SkippedRow &row : data.skipped) {
        text += "; skipped " + std::to_string(row.line) + ':' + std::to_string(row.column) + ' ' + row.text + " (" +
                wordsOf(row.fault) + ')';
    }
    for (std::size_t i = 0; i < data.layout.columns.size(); ++i) {
        const FileColumn &column = data.layout.columns[i];
        if (column.role == ColumnRole::Ignored) {
            text += "; ignored " + (column.heading.empty() ? "column " + std::to_string(i + 1) : column.heading);
        }
    }
    return QString::fromStdString(text);
}

/// Some 5 MB: three columns, lines of different lengths, now and then a gap.
QByteArray largeFile(const QByteArray &head, const QByteArray &lineEnd)
{
    QByteArray bytes = head;
    for (int row = 0; row < 220000; ++row) {
        const double t = row * 0.001;
        bytes += QByteArray::number(t) + ',' +
                 (row % 1000 == 7 ? QByteArray() : QByteArray::number(std::sin(t), 'g', 9)) + ',' +
                 QByteArray::number(80.0 + std::cos(t), 'f', 3) + lineEnd;
    }
    return bytes;
}

ByteSource sourceOf(const QByteArray &bytes, std::size_t piece)
{
    const auto size = static_cast<std::size_t>(bytes.size());
    const auto read = [bytes, size](std::size_t offset, std::span<char> room) {
        if (offset > size || size - offset < room.size()) {
            return false;
        }
        std::copy_n(bytes.constData() + offset, room.size(), room.begin());
        return true;
    };
    return {size, read, piece};
}

QByteArray utf16Of(const QByteArray &text)
{
    QByteArray bytes;
    for (const char c : text) {
        bytes += c;
        bytes += '\0';
    }
    return bytes;
}

/// What each column became: "time R4_x theta3? -", with a question mark where it was guessed.
std::string rolesOf(const FileLayout &layout)
{
    std::string roles;
    for (const FileColumn &column : layout.columns) {
        roles += roles.empty() ? "" : " ";
        switch (column.role) {
        case ColumnRole::Ignored: roles += '-'; break;
        case ColumnRole::Time: roles += "time"; break;
        case ColumnRole::CrankAngle: roles += "angle"; break;
        case ColumnRole::Channel: roles += nameOf(column.channel); break;
        }
        roles += isGuess(column.reason) ? "?" : "";
    }
    return roles;
}

/// "UTF-8 with mark ; comma line 3 units 4".
std::string formOf(const FileLayout &layout)
{
    std::string form;
    switch (layout.encoding) {
    case TextEncoding::Utf8: form = "UTF-8"; break;
    case TextEncoding::Utf16LittleEndian: form = "UTF-16LE"; break;
    case TextEncoding::Utf16BigEndian: form = "UTF-16BE"; break;
    case TextEncoding::Windows1252: form = "Windows-1252"; break;
    }
    form += layout.byteOrderMark ? " with mark " : " ";
    form += layout.delimiter == '\t' ? std::string("tab") : std::string(1, layout.delimiter);
    form += layout.decimalSign == DecimalSign::Comma ? " comma" : " point";
    form += " line " + std::to_string(layout.headerLine);
    return form + (layout.unitsLine > 0 ? " units " + std::to_string(layout.unitsLine) : "");
}

/// All that a person could come to see.
QString told(const std::variant<ReferenceData, ReadError> &outcome)
{
    const ReferenceData *data = std::get_if<ReferenceData>(&outcome);
    const FileLayout &layout = data ? data->layout : std::get<ReadError>(outcome).layout;
    std::string text = "; " + formOf(layout) + "; " + rolesOf(layout);
    for (const std::vector<std::string> &row : layout.rows) {
        for (const std::string &cell : row) {
            text += '|' + cell;
        }
    }
    if (!data) {
        const ReadError &error = std::get<ReadError>(outcome);
        text += "; " + std::to_string(error.line) + ':' + std::to_string(error.column) + ' ' + error.text + ' ' +
                error.fault.heading;
    } else {
        const auto add = [&text](const Rounding &rounding) {
            text += "; rounded " + exactText(rounding.stepAt(1.0)) + ' ' + std::to_string(rounding.digits);
        };
        add(data->timeRounding);
        for (const ReferenceSeries &series : data->series) {
            add(series.rounding);
        }
    }
    return described(outcome) + QString::fromStdString(text);
}

std::variant<ReferenceData, ReadError> read(const QByteArray &bytes, const std::vector<ColumnChoice> &choices)
{
    ReadOptions options;
    options.columns = choices;
    return readReferenceData({bytes.constData(), static_cast<std::size_t>(bytes.size())}, {}, options);
}

/// Those columns of a table of commas.
QByteArray columnsOf(const QByteArray &table, const QList<int> &columns)
{
    QByteArray plot;
    for (const QByteArray &line : table.trimmed().split('\n')) {
        QByteArrayList cells;
        for (const int column : columns) {
            cells << line.trimmed().split(',').value(column);
        }
        plot += cells.join(',') + '\n';
    }
    return plot;
}

/// As files "a", "b", "c".
std::variant<ReferenceData, ReadError> readJoined(const QByteArrayList &files, const ReadOptions &options = {})
{
    std::vector<ByteSource> sources;
    for (const QByteArray &file : files) {
        sources.push_back(sourceOf(file, kOnePiece));
        sources.back().name = static_cast<char>('a' + sources.size() - 1);
    }
    return slidercrank::readJoined(sources, {}, options);
}

QByteArray sampleTable()
{
    QFile file(QStringLiteral(SLIDERCRANK_SOURCE_DIR "/data/inventor_sample.csv"));
    return file.open(QIODevice::ReadOnly) ? file.readAll().replace("\xEF\xBB\xBF", "") : QByteArray();
}

} // namespace

Q_DECLARE_METATYPE(ReadFault)

class TestReferenceData : public QObject
{
    Q_OBJECT

private slots:
    void reads_data()
    {
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<QString>("expected");
        const QString two = QStringLiteral("time 0 0.005; R4_x 74.5436 74.8173");

        // Lines, marks and delimiters.
        QTest::newRow("LF") << QByteArray("time,R4_x\n0,74.5436\n0.005,74.8173\n") << two;
        QTest::newRow("CR LF") << QByteArray("time,R4_x\r\n0,74.5436\r\n0.005,74.8173\r\n") << two;
        QTest::newRow("CR") << QByteArray("time,R4_x\r0,74.5436\r0.005,74.8173\r") << two;
        QTest::newRow("no line end at the end") << QByteArray("time,R4_x\n0,74.5436\n0.005,74.8173") << two;
        QTest::newRow("byte order mark") << QByteArray("\xEF\xBB\xBFtime,R4_x\n0,74.5436\n0.005,74.8173\n") << two;
        QTest::newRow("semicolons") << QByteArray("time;R4_x\n0;74.5436\n0.005;74.8173\n") << two;
        QTest::newRow("tabs") << QByteArray("time\tR4_x\n0\t74.5436\n0.005\t74.8173\n") << two;
        QTest::newRow("a delimiter announced in the first line")
            << QByteArray("sep=;\ntime;R4_x\n0;74.5436\n0.005;74.8173\n") << two;
        QTest::newRow("blank lines and spaces")
            << QByteArray("\n \ntime , R4_x \n\n 0 , 74.5436 \n   \n0.005,\t74.8173\t\n,,\n\n") << two;
        QTest::newRow("a delimiter at the end of each line")
            << QByteArray("time,R4_x,\n0,74.5436,\n0.005,74.8173,\n") << two;
        QTest::newRow("delimiters at the end of the rows")
            << QByteArray("time,R4_x\n0,74.5436,,\n0.005,74.8173,\n") << two;
        QTest::newRow("a delimiter at the end of the header")
            << QByteArray("time,R4_x,\n0,74.5436\n0.005,74.8173\n") << two;
        QTest::newRow("an empty last cell is a gap")
            << QByteArray("time,R4_x,theta3\n0,1,2\n1,3,\n") << "time 0 1; R4_x 1 3; theta3 2 gap";

        // Decimal commas.
        QTest::newRow("decimal comma, semicolons") << QByteArray("time;R4_x\n0;74,5436\n0,005;74,8173\n") << two;
        QTest::newRow("decimal comma, tabs") << QByteArray("time\tR4_x\n0\t74,5436\n0,005\t74,8173\n") << two;
        QTest::newRow("decimal comma, quoted")
            << QByteArray("time;R4_x\n\"0\";\"74,5436\"\n\"0,005\";\"74,8173\"\n") << two;
        QTest::newRow("three digits behind every comma are decimals where semicolons separate")
            << QByteArray("time;R4_x\n1;1,234\n2;5,678\n") << "time 1 2; R4_x 1.234 5.678";
        QTest::newRow("thousands are no numbers where a point is decimal")
            << QByteArray("time;R4_x\n1,000;74.5436\n1.5;1,234\n2;1,234.5\n2.5;3\n")
            << "time 2.5; R4_x 3; skipped 2:1 1,000 (not a number: this file writes a decimal point); skipped 3:2 "
               "1,234 "
               "(not a number: this file writes a decimal point); skipped 4:2 1,234.5 (not a number: this file writes "
               "a "
               "decimal point)";
        QTest::newRow("thousands are no numbers where a comma is decimal")
            << QByteArray("time;R4_x\n0,500;1.234\n1;1.234,5\n2;3,500\n")
            << "time 2; R4_x 3.5; skipped 2:2 1.234 (not a number: this file writes a decimal comma); skipped 3:2 "
               "1.234,5 (not a number: this file writes a decimal comma)";
        QTest::newRow("a quoted comma is not decimal where commas separate")
            << QByteArray("time,R4_x\n0,\"1,234\"\n1,5\n")
            << "time 1; R4_x 5; skipped 2:2 1,234 (not a number: this file writes a decimal point)";

        // Names.
        QTest::newRow("columns in any order and case")
            << QByteArray("THETA3_Diff2,r4_X,Time\n3,2,1\n") << "time 1; theta3_diff2 3; R4_x 2";
        QTest::newRow("quoted names and doubled quotation marks")
            << QByteArray("\"time\",\"the \"\"x\"\", in mm\",\"R4_x\"\n0,\"a,\"\"b,5\n0,7,2\n")
            << "time 0; R4_x 2; skipped 2:2 a,\"\"b,5 (a quotation mark that is not closed at the end of the "
               "cell); ignored the \"x\", in mm";
        QTest::newRow("text behind a closing quotation mark")
            << QByteArray("time,R4_x\n0,\"12\"3\n0,5\n")
            << "time 0; R4_x 5; skipped 2:2 12 (a quotation mark that is not closed at the end of the cell)";
        QTest::newRow("delimiters in quotes")
            << QByteArray("time,note,R4_x\n0,\"a, b \"\"c\"\"\",5\n") << "time 0; R4_x 5; ignored note";
        QTest::newRow("unknown columns are listed, whatever they hold")
            << QByteArray("n,time,,\"P[1,1] ( deg )\",R4_x,R4_x_diff3\nabc,0,1,1e999,5,inf\n")
            << "time 0; R4_x 5; ignored n; ignored column 3; ignored P[1,1] ( deg ); ignored R4_x_diff3";
        QTest::newRow("a column without a number is listed too")
            << QByteArray("time,R4_x,theta3\n0,1,\n1,2,nan\n") << "time 0 1; R4_x 1 2; ignored theta3";

        // Numbers.
        QTest::newRow("forms of numbers") << QByteArray("time,R4_x\n-1.5e-3,+5\n.5,-.25\n1.,1E2\n2,-0\n")
                                          << "time -0.0015 0.5 1 2; R4_x 5 -0.25 100 -0";
        QTest::newRow("17 digits") << QByteArray("time,R4_x\n0,74.543567890123451\n")
                                   << "time 0; R4_x 74.54356789012346";
        QTest::newRow("gaps") << QByteArray("time,R4_x,theta3\n0,,1\n1,nan,1\n2,NaN,1\n3,-nan,\n4,5,1\n")
                              << "time 0 1 2 3 4; R4_x gap gap gap gap 5; theta3 1 1 1 gap 1";
        QTest::newRow("too small for a double is zero") << QByteArray("time,R4_x\n0,1e-400\n") << "time 0; R4_x 0";
        QTest::newRow("what is no number")
            << QByteArray(
                   "time,R4_x\n0,inf\n1,-Infinity\n2,12abc\n3,1 2\n4,0x1p3\n5,--1\n6,+-1\n7,.\n8,1e999\n9,n/a\n10,+\n"
                   "11,1.2.3\n12,7\n")
            << "time 12; R4_x 7; skipped 2:2 inf (not a number); skipped 3:2 -Infinity (not a number); skipped 4:2 "
               "12abc "
               "(not a number); skipped 5:2 1 2 (not a number); skipped 6:2 0x1p3 (not a number); skipped 7:2 --1 (not "
               "a "
               "number); skipped 8:2 +-1 (not a number); skipped 9:2 . (not a number); skipped 10:2 1e999 (not a "
               "number: "
               "too large); skipped 11:2 n/a (not a number); skipped 12:2 + (not a number); skipped 13:2 1.2.3 (not a "
               "number)";
        QTest::newRow("too large once converted") << QByteArray("time,R4_x [m]\n0,1e308\n1,1\n")
                                                  << "time 1; R4_x 1000; skipped 2:2 1e308 (not a number: too large)";
        QTest::newRow("rows of another width, or without time")
            << QByteArray("time,R4_x,theta3\n0,1\n1,2,3,4\n,2,3\nnan,2,3\n2,3,4\n")
            << "time 2; R4_x 3; theta3 4; skipped 2:2  (too few cells); skipped 3:4 4 (too many cells); skipped 4:1  "
               "(no "
               "time); skipped 5:1 nan (no time)";
        QTest::newRow("a long cell is shortened between characters")
            << QByteArray("time,R4_x\n0,x") + QByteArray("\u00B1").repeated(30) + "\n1,2\n"
            << "time 1; R4_x 2; skipped 2:2 x" + QString(QChar(0xB1)).repeated(19) + QChar(0x2026) + " (not a number)";
        QTest::newRow("lines count with any end")
            << QByteArray("time,R4_x\r\n\r\n0,1\n\n1,a\r2,b\r\n3,1\n")
            << "time 0 3; R4_x 1 1; skipped 5:2 a (not a number); skipped 6:2 b (not a number)";
    }

    void reads()
    {
        QFETCH(const QByteArray, bytes);
        QTEST(described(read(bytes)), "expected");
    }

    void readsWhatProgramsWrite_data()
    {
        QTest::addColumn<GoodFile>("file");
        for (const GoodFile &file : goodFiles()) {
            QTest::newRow(file.name.c_str()) << file;
        }
    }

    void readsWhatProgramsWrite()
    {
        QFETCH(const GoodFile, file);
        const auto outcome = readReferenceData(file.bytes);
        QVERIFY2(std::holds_alternative<ReferenceData>(outcome), qPrintable(described(outcome)));
        const ReferenceData &data = std::get<ReferenceData>(outcome);
        QCOMPARE(QString::fromStdString(rolesOf(data.layout)), QString::fromStdString(file.columns));
        QCOMPARE(QString::fromStdString(formOf(data.layout)), QString::fromStdString(file.form));
        QCOMPARE(data.layout.isGuessed(), file.columns.find('?') != std::string::npos);
        QVERIFY(data.skipped.empty());

        // Every column is what it is taken for, in its unit: the motion that the file was written from.
        Parameters parameters;
        parameters.b = 60.0;
        const Mechanism mechanism(parameters);
        SolverSettings exact;
        exact.method = Method::ClosedForm;
        const Trajectory motion = sample(mechanism, data.time, allChannels(), exact);
        for (const ChannelComparison &channel : compare(mechanism, motion, data)) {
            const ReferenceSeries &series = *data.find(channel.channel);
            const double peak =
                std::abs(*std::max_element(series.values.begin(), series.values.end(),
                                           [](double x, double y) { return std::abs(x) < std::abs(y); }));
            QVERIFY2(*channel.maxAbs <= 1e-5 * peak, std::string(nameOf(channel.channel)).c_str());
        }
    }

    void refusesWhatItCannotTell_data()
    {
        QTest::addColumn<BadFile>("file");
        for (const BadFile &file : badFiles()) {
            QTest::newRow(file.name.c_str()) << file;
        }
    }

    void refusesWhatItCannotTell()
    {
        QFETCH(const BadFile, file);
        const auto outcome = readReferenceData(file.bytes);
        const ReadError *error = std::get_if<ReadError>(&outcome);
        QVERIFY2(error, qPrintable(described(outcome)));
        QVERIFY2(error->fault == file.fault, qPrintable(described(outcome)));
    }

    void knowsDifferencesForWhatTheyAre_data()
    {
        QTest::addColumn<int>("from"); // rows
        QTest::addColumn<int>("to");
        QTest::addColumn<int>("decimals"); // of the positions
        QTest::addColumn<std::optional<Difference>>("kind");
        using Kind = std::optional<Difference>;
        QTest::newRow("forward") << 0 << 1 << 3 << Kind(Difference::Forward);
        QTest::newRow("backward") << -1 << 0 << 3 << Kind(Difference::Backward);
        QTest::newRow("central") << -1 << 1 << 3 << Kind(Difference::Central);
        QTest::newRow("central, of many digits") << -1 << 1 << 9 << Kind(Difference::Central);
        QTest::newRow("the derivative") << 0 << 0 << 9 << Kind();
        QTest::newRow("the derivative beside few digits") << 0 << 0 << 1 << Kind();
    }

    void knowsDifferencesForWhatTheyAre()
    {
        QFETCH(const int, from);
        QFETCH(const int, to);
        QFETCH(const int, decimals);
        using Found = std::optional<Difference>;
        QFETCH(const Found, kind);
        constexpr double kStep = 0.01;
        const auto position = [&](int row) {
            const QByteArray text = QByteArray::number(50.0 * std::cos(7.0 * kStep * row), 'f', decimals);
            return text.toDouble();
        };
        QByteArray bytes = "time,R4_x,R4_x_diff,theta2,theta2_diff\n";
        for (int row = 0; row < 60; ++row) {
            const double speed = from == to ? -350.0 * std::sin(7.0 * kStep * row)
                                            : (position(row + to) - position(row + from)) / (kStep * (to - from));
            bytes += QByteArray::number(kStep * row) + ',' + QByteArray::number(position(row), 'f', decimals) + ',' +
                     QByteArray::number(speed, 'f', 6) + ',' + QByteArray::number(30.0 * row) + ",3000\n";
        }
        const auto outcome = read(bytes);
        const std::vector<FileColumn> &columns = std::get<ReferenceData>(outcome).layout.columns;
        QVERIFY(columns[2].difference == kind);
        QVERIFY(!columns[1].difference && !columns[4].difference); // of an even motion they are the derivative
    }

    void letsAPersonChooseTheColumns()
    {
        const QByteArray bytes = "n,time,a,R4_x\n1,5,0.1,3\n2,4,0.2,4\n3,3,0.3,5\n";
        QCOMPARE(described(read(bytes, {{2, ColumnRole::Time, {}, "ms"},
                                        {3, ColumnRole::Ignored, {}, {}},
                                        {0, ColumnRole::Channel, {R4x, Order::Position}, "m"}})),
                 QStringLiteral("time 1e-04 2e-04 3e-04; R4_x 1000 2000 3000; ignored time; ignored R4_x"));
    }

    void readsAFileWithoutNamesAsAPersonChooses()
    {
        const QByteArray bytes = "0;1,5\n0,5;2,5\n";
        const auto refused = read(bytes);
        QCOMPARE(std::get<ReadError>(refused).layout.columns.size(), std::size_t(2));
        QCOMPARE(std::get<ReadError>(refused).layout.rows.size(), std::size_t(2));
        const auto outcome =
            read(bytes, {{0, ColumnRole::Time, {}, {}}, {1, ColumnRole::Channel, {Theta3, Order::Velocity}, "rad/s"}});
        QCOMPARE(described(outcome), QStringLiteral("time 0 0.5; theta3_diff 85.94366926962348 143.2394487827058"));
        QCOMPARE(std::get<ReferenceData>(outcome).layout.headerLine, std::size_t(0));
    }

    void refusesAChoiceThatContradictsItself()
    {
        const QByteArray bytes = "time,R4_x [mm]\n0,1\n1,2\n";
        const auto twice = read(bytes, {{0, ColumnRole::Time, {}, {}}, {1, ColumnRole::Time, {}, "s"}});
        QVERIFY(std::get<ReadError>(twice).fault == ReadFault{Kind::TimeChosenTwice});
        const auto unit = read(bytes, {{1, ColumnRole::Channel, {Theta3, Order::Position}, {}}});
        QVERIFY((std::get<ReadError>(unit).fault == ReadFault{Kind::UnknownUnit, {Theta3, Order::Position}}));
        QCOMPARE(std::get<ReadError>(unit).column, std::size_t(2));
    }

    void countsByTheCranksAngleWhereThereIsNoTime_data()
    {
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<QByteArray>("roles");
        QTest::addColumn<QByteArray>("degrees");
        const auto row = [](const char *name, const char *bytes, const char *roles, const char *degrees) {
            QTest::newRow(name) << QByteArray(bytes) << QByteArray(roles) << QByteArray(degrees);
        };
        const char *const three = "0,3\n15,4\n30,5\n";
        const auto under = [three](const char *heading) { return QByteArray(heading) + ",R4_x\n" + three; };
        row("English words", under("Crank angle (deg)").constData(), "angle? R4_x", " 0 15 30");
        row("theta2", under("theta2").constData(), "angle? R4_x", " 0 15 30");
        row("Greek", under("\u03b8\u2082 [\u00b0]").constData(), "angle? R4_x", " 0 15 30");
        row("Spanish", under("\u00c1ngulo de la manivela (grados)").constData(), "angle? R4_x", " 0 15 30");
        row("German", under("Kurbelwinkel").constData(), "angle? R4_x", " 0 15 30");
        row("engines", under("\u00b0CA").constData(), "angle? R4_x", " 0 15 30");
        row("engines, as a unit", under("Crank angle [CAD]").constData(), "angle? R4_x", " 0 15 30");
        row("beside another column", "R4_x,CAD\n3,0\n4,15\n5,30\n", "R4_x angle?", " 0 15 30");
        row("radians", "theta2 (rad),R4_x\n0,3\n3.141592653589793,4\n6.283185307179586,5\n", "angle? R4_x",
            " 0 180 360");
        row("two turns", "theta2,R4_x\n0,3\n270,4\n540,5\n720,3\n", "angle? R4_x", " 0 270 540 720");
        row("from the other side", "theta2,R4_x\n-180,3\n0,4\n180,5\n", "angle? R4_x", " -180 0 180");
        row("kept within a turn", "theta2,R4_x\n350,3\n359,4\n0,5\n1,5\n", "angle? R4_x", " 350 359 360 361");
        row("kept within a half turn", "theta2,R4_x\n170,3\n180,4\n-170,5\n", "angle? R4_x", " 170 180 190");
        row("backwards, within a turn", "theta2,R4_x\n10,5\n0,4\n350,3\n", "angle? R4_x", " -10 0 10");
        // What has a time is read as before.
        row("beside a time", "time,theta2,R4_x\n0,0,3\n1,15,4\n2,30,5\n", "time theta2 R4_x", "");
        row("beside a time behind it", "theta2,R4_x,t\n0,3,0\n15,4,1\n30,5,2\n", "theta2 R4_x time", "");
        row("beside what only rises", "clock,theta2,R4_x\n0,0,3\n1,15,4\n2,30,5\n", "time? theta2 R4_x", "");
    }

    void countsByTheCranksAngleWhereThereIsNoTime()
    {
        QFETCH(const QByteArray, bytes);
        QFETCH(const QByteArray, roles);
        QFETCH(const QByteArray, degrees);
        const auto outcome = read(bytes);
        const ReferenceData *data = std::get_if<ReferenceData>(&outcome);
        QVERIFY2(data, qPrintable(described(outcome)));
        QCOMPARE(rolesOf(data->layout), roles.toStdString());
        QCOMPARE(data->crank ? described(data->crank->degrees) : std::string(), degrees.toStdString());
    }

    void refusesAnglesThatTurnBack()
    {
        for (const char *const rows : {"0,3\n15,4\n10,5\n", "0,3\n15,4\n15,5\n", "30,3\n15,4\n20,5\n"}) {
            const auto outcome = read(QByteArray("Crank angle,R4_x\n") + rows);
            const ReadError *error = std::get_if<ReadError>(&outcome);
            QVERIFY(error);
            QVERIFY2((error->fault == ReadFault{.kind = Kind::AngleTurnsBack, .heading = "15°"}),
                     qPrintable(described(outcome)));
            QCOMPARE(error->line, std::size_t(1));
        }
        const auto large = read("theta2 (rad),R4_x\n0,3\n1e308,4\n");
        QCOMPARE(std::get<ReadError>(large).fault.row, RowFault::TooLarge);
        const auto unit = read("a,R4_x\n0,3\n", {{0, ColumnRole::CrankAngle, {}, "mm"}});
        QVERIFY((std::get<ReadError>(unit).fault == ReadFault{Kind::UnknownUnit, {Theta2, Order::Position}}));
        const auto twice =
            read("t,a,R4_x\n0,0,3\n", {{0, ColumnRole::Time, {}, {}}, {1, ColumnRole::CrankAngle, {}, {}}});
        QVERIFY((std::get<ReadError>(twice).fault.kind == Kind::TimeChosenTwice));
    }

    void makesTheInstantsOfACrank_data()
    {
        QTest::addColumn<double>("omega2");
        QTest::addColumn<double>("theta20");
        QTest::addColumn<QString>("is");
        const double turn = 2.0 * std::numbers::pi;
        QTest::newRow("once a second") << turn << 0.0 << "time 0 0.25 1; R4_x 3 4 5";
        QTest::newRow("twice a second") << 2.0 * turn << 0.0 << "time 0 0.125 0.5; R4_x 3 4 5";
        QTest::newRow("from 90 degrees on") << turn << 0.25 * turn << "time -0.25 0 0.75; R4_x 3 4 5";
        QTest::newRow("the other way") << -turn << 0.0 << "time -1 -0.25 -0; R4_x 5 4 3";
        QTest::newRow("standing still") << 0.0 << 0.0 << "none";
        QTest::newRow("too slow for doubles") << 1e-320 << 0.0 << "none";
    }

    void makesTheInstantsOfACrank()
    {
        QFETCH(const double, omega2);
        QFETCH(const double, theta20);
        QFETCH(const QString, is);
        Parameters parameters;
        parameters.omega2 = omega2;
        parameters.theta20 = theta20;
        const ReferenceData data = std::get<ReferenceData>(read("theta2,R4_x\n0,3\n90,4\n360,5\n"));
        const std::optional<ReferenceData> timed = timedBy(Mechanism(parameters), data);
        QCOMPARE(timed ? described(*timed) : QStringLiteral("none"), is);
        if (timed) { // whatever was in between
            QCOMPARE(described(*timedBy(Mechanism(), *timed)), described(data));
            const std::vector<double> angles = timed->crank->degrees;
            for (std::size_t i = 0; i < angles.size(); ++i) {
                const double angle = kDegreesPerRadian * (omega2 * timed->time[i] + theta20);
                QVERIFY(std::abs(angle - angles[i]) < 1e-12 * 360.0);
            }
            // A degree is as long as it takes the crank.
            const double step = 1.0 / (kDegreesPerRadian * std::abs(omega2));
            QVERIFY(std::abs(timed->timeRounding.finestStep() - step) < 1e-12 * step);
        }
    }

    void saysWhyAColumnIsWhatItIs()
    {
        const auto outcome =
            read("time,R4_x,Linear Velocity1 (mm/s),pressure,,R4_y\n0,0,2,5,1,\n1,2,2,5,1,\n2,4,2,5,1,\n");
        const std::vector<FileColumn> &columns = std::get<ReferenceData>(outcome).layout.columns;
        QCOMPARE(columns.at(1).reason, ColumnReason::KnownName);
        QCOMPARE(columns.at(2).reason, ColumnReason::QuantityInName);
        QCOMPARE(columns.at(2).unit, std::string("mm/s"));
        QCOMPARE(columns.at(2).heading, std::string("Linear Velocity1 (mm/s)"));
        QCOMPARE(columns.at(3).reason, ColumnReason::UnknownName);
        QCOMPARE(columns.at(4).reason, ColumnReason::NoName);
        QCOMPARE(columns.at(5).reason, ColumnReason::NoNumber);
        QCOMPARE(columns.at(5).role, ColumnRole::Ignored);
    }

    void tellsHowFarItIs()
    {
        QByteArray bytes = "time,R4_x\n";
        for (int i = 0; i < 20'000; ++i) {
            bytes += QByteArray::number(i) + ",1\n";
        }
        std::vector<std::size_t> done;
        std::size_t all = 0;
        ReadOptions options;
        options.progress = [&](std::size_t bytesDone, std::size_t ofAll) {
            done.push_back(bytesDone);
            all = ofAll;
        };
        readReferenceData(sourceOf(bytes, 10'000), {}, options);
        QVERIFY(done.size() >= 4);
        QVERIFY(std::is_sorted(done.begin(), done.end()));
        QVERIFY(done.back() > all / 2 && done.back() <= all);
    }

    void convertsUnits_data()
    {
        QTest::addColumn<QByteArray>("heading");
        QTest::addColumn<double>("one"); // what a 1 in the file is in the author's unit
        const double degree = kDegreesPerRadian;
        QTest::newRow("none: length") << QByteArray("R4_x") << 1.0;
        QTest::newRow("none: angle") << QByteArray("theta3") << 1.0;
        QTest::newRow("empty brackets") << QByteArray("theta3 []") << 1.0;
        QTest::newRow("mm") << QByteArray("R4_x [mm]") << 1.0;
        QTest::newRow("cm") << QByteArray("R4_x[cm]") << 10.0;
        QTest::newRow("m") << QByteArray("R4_x (m)") << 1000.0;
        QTest::newRow("in") << QByteArray("R4_x ( in )") << 25.4;
        QTest::newRow("deg") << QByteArray("theta3 [deg]") << 1.0;
        QTest::newRow("degree sign") << QByteArray("theta3 [\u00B0]") << 1.0;
        QTest::newRow("ordinal sign") << QByteArray("theta3 [\u00BA]") << 1.0;
        QTest::newRow("degree sign, 8 bits") << QByteArray("theta3 [\xB0]") << 1.0;
        QTest::newRow("rad") << QByteArray("theta3 [RAD]") << degree;
        QTest::newRow("mm/s") << QByteArray("R4_x_diff [mm/s]") << 1.0;
        QTest::newRow("m / s") << QByteArray("R4_x_diff [m / s]") << 1000.0;
        QTest::newRow("mm/ms") << QByteArray("R4_x_diff (mm/ms)") << 1000.0;
        QTest::newRow("rad/s") << QByteArray("theta3_diff [rad/s]") << degree;
        QTest::newRow("degree sign/s") << QByteArray("theta3_diff [\u00B0/s]") << 1.0;
        QTest::newRow("m/s^2") << QByteArray("R4_x_diff2 [m/s^2]") << 1000.0;
        QTest::newRow("cm/s2") << QByteArray("R4_x_diff2 [cm/s2]") << 10.0;
        QTest::newRow("in/s/s") << QByteArray("R4_x_diff2 [in/s/s]") << 25.4;
        QTest::newRow("mm/ms²") << QByteArray("R4_x_diff2 [mm/ms\u00B2]") << 1e6;
        QTest::newRow("rad/s²") << QByteArray("theta3_diff2 [rad/s\u00B2]") << degree;
        QTest::newRow("rad/s², 8 bits") << QByteArray("theta3_diff2 [rad/s\xB2]") << degree;
    }

    void convertsUnits()
    {
        QFETCH(const QByteArray, heading);
        QFETCH(const double, one);
        const auto outcome =
            read("time\t" + heading +
                 "\n0\t1\n1\t2.50\n2\t3.75\n3\t1.37\n4\t8.13\n5\t0.25\n6\t4.94\n7\t6.66\n8\t7.21\n9\t3.12\n");
        QVERIFY2(std::holds_alternative<ReferenceData>(outcome), qPrintable(described(outcome)));
        const ReferenceSeries &series = std::get<ReferenceData>(outcome).series.at(0);
        QCOMPARE(exactText(series.values[0]), exactText(one));
        QCOMPARE(exactText(series.values[1]), exactText(2.5 * one));
        QVERIFY(std::abs(series.rounding.stepAt(series.values[1]) - 0.01 * one) < 1e-12 * one);
    }

    void convertsMilliseconds()
    {
        QByteArray bytes = "R4_x,time [ms]\n";
        for (int i = 0; i < 200; ++i) {
            bytes += "1," + QByteArray::number(i) + '\n';
        }
        const auto outcome = read(bytes);
        const ReferenceData &data = std::get<ReferenceData>(outcome);
        for (int i = 0; i < 200; ++i) {
            QCOMPARE(exactText(data.time.at(static_cast<std::size_t>(i))), exactText(i / 1000.0));
        }
    }

    void refuses_data()
    {
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<std::size_t>("line");
        QTest::addColumn<std::size_t>("column");
        QTest::addColumn<QString>("text");
        QTest::addColumn<ReadFault>("fault");
        const auto row = [](const char *name, const QByteArray &bytes, std::size_t line, std::size_t column,
                            const char *text, const ReadFault &fault) {
            QTest::newRow(name) << bytes << line << column << QString::fromUtf8(text) << fault;
        };
        row("nothing", "", 0, 0, "", {Kind::Empty});
        row("blank lines", "\r\n \r\n,,\r\n", 0, 0, "", {Kind::Empty});
        row("only a byte order mark", "\xEF\xBB\xBF", 0, 0, "", {Kind::Empty});
        row("a spreadsheet", QByteArray("PK\x03\x04\0\0", 6), 0, 0, "", {Kind::Spreadsheet});
        row("zero bytes", QByteArray("time,R4_x\n0,1\n1,\0\n", 18), 3, 0, "", {Kind::NotText});
        row("numbers without names", "\n0.0,74.5\n0.1,74.8\n", 2, 1, "0.0", {Kind::NamesMissing});
        row("no time", "pressure,R4_x\n1,1\n0,2\n", 1, 0, "pressure,R4_x", {Kind::NoTime});
        row("prose", "Lorem ipsum\ndolor\n", 1, 0, "Lorem ipsum", {Kind::NoTime});
        row("no channel", "time,pressure\n0,1\n", 1, 0, "time,pressure", {Kind::NoChannel});
        row("an unknown unit", "time,theta3,R4_x [ell]\n0,1,2\n", 1, 3, "R4_x [ell]",
            {Kind::UnknownUnit, {R4x, Order::Position}});
        row("a unit of another quantity", "time,theta3_diff [mm/s]\n0,1\n", 1, 2, "theta3_diff [mm/s]",
            {Kind::UnknownUnit, {Theta3, Order::Velocity}});
        row("a unit of another derivative", "time,R4_x_diff2 [m/s]\n0,1\n", 1, 2, "R4_x_diff2 [m/s]",
            {Kind::UnknownUnit, {R4x, Order::Acceleration}});
        row("half a unit", "time,R4_x_diff [m/]\n0,1\n", 1, 2, "R4_x_diff [m/]",
            {Kind::UnknownUnit, {R4x, Order::Velocity}});
        row("an unknown unit of time", "time [h],R4_x\n0,1\n", 1, 1, "time [h]", {Kind::UnknownTimeUnit});
        row("a channel twice", "time,R4_x,R4_x [m]\n0,1,2\n", 1, 3, "R4_x [m]",
            {Kind::ChannelTwice, {R4x, Order::Position}});
        row("the time twice", "time,R4_x,Time\n0,1,2\n", 1, 3, "Time", {Kind::TimeTwice});
        row("only a header", "time,R4_x\n", 1, 0, "", {Kind::NoNumbers});
        row("no row can be read", "time,R4_x\n\n0,a\n1,b\n", 3, 2, "a", {Kind::NoRow});
        row("decimal commas between commas", "time,R4_x\n0,005,74,5436\n0,010,74,8173\n", 2, 3, "74",
            {.kind = Kind::NoRow, .row = RowFault::TooManyCells});
        row("no value at all", "time,R4_x\n0,\n1,nan\n", 2, 0, "", {Kind::NoValues});
        row("time stands still", "R4_x,time\n1,0\n2,0.5\n3,0.5\n", 4, 2, "0.5", {Kind::TimeNotRising});
        row("time falls", "time,R4_x\n0,1\n1,x\n-0.25,2\n", 4, 1, "-0.25", {Kind::TimeNotRising});
    }

    void refuses()
    {
        QFETCH(const QByteArray, bytes);
        QFETCH(const ReadFault, fault);
        const auto outcome = read(bytes);
        const ReadError *error = std::get_if<ReadError>(&outcome);
        QVERIFY2(error, qPrintable(described(outcome)));
        QTEST(error->line, "line");
        QTEST(error->column, "column");
        QTEST(QString::fromStdString(error->text), "text");
        QVERIFY2(error->fault == fault, qPrintable(described(outcome)));
    }

    void readsManyRows()
    {
        constexpr int kRows = 100'000;
        QByteArray bytes = "time,R4_x,theta3\n";
        for (int i = 0; i < kRows; ++i) {
            bytes += QByteArray::number(i) + ',' + QByteArray::number(i % 977) + ".5," + QByteArray::number(-i) + '\n';
        }
        const auto outcome = read(bytes);
        const ReferenceData &data = std::get<ReferenceData>(outcome);
        QCOMPARE(data.time.size(), std::size_t(kRows));
        QVERIFY(data.skipped.empty());
        for (std::size_t i = 0; i < kRows; ++i) {
            const int n = static_cast<int>(i);
            if (data.time[i] != n || data.series[0].values[i] != n % 977 + 0.5 || data.series[1].values[i] != -n) {
                QFAIL(qPrintable(QStringLiteral("row %1").arg(i)));
            }
        }
    }

    void countsTheRowsItDoesNotList()
    {
        QByteArray bytes = "time,R4_x\n0,1\n";
        for (int i = 0; i < 2500; ++i) {
            bytes += "1,x\n";
        }
        const auto outcome = read(bytes);
        const std::vector<SkippedRow> &skipped = std::get<ReferenceData>(outcome).skipped;
        QCOMPARE(skipped.size(), std::size_t(1001));
        QCOMPARE(std::get<ReferenceData>(outcome).skippedRowCount(), std::size_t(2500));
        QCOMPARE(skipped.back().line, std::size_t(1003));
        QCOMPARE(skipped.back().fault, RowFault::NotListed);
        QCOMPARE(skipped.back().rows, std::size_t(1500));
    }

    void readsALargeFileInOnePiece_data()
    {
        QTest::addColumn<QByteArray>("lineEnd");
        QTest::newRow("LF") << QByteArray("\n");
        QTest::newRow("CR LF") << QByteArray("\r\n");
        QTest::newRow("CR") << QByteArray("\r");
    }

    /// Several megabytes are read by several threads: nothing of that may show.
    void readsALargeFileInOnePiece()
    {
        QFETCH(QByteArray, lineEnd);
        constexpr int kRows = 300000;
        constexpr int kBadEvery = 9973;
        constexpr int kGapEvery = 7919;
        QByteArray bytes = "time,R4_x" + lineEnd;
        std::vector<double> time;
        std::vector<double> values;
        std::vector<std::size_t> badLines;
        std::vector<QByteArray> lines;
        for (int i = 1; i <= kRows; ++i) {
            const QByteArray instant = QByteArray::number(i) + ".5";
            const QByteArray value = QByteArray::number(i % 1000) + "." + QByteArray::number(100 + i % 900);
            const bool bad = i % kBadEvery == 0;
            const bool gap = i % kGapEvery == 0;
            lines.push_back(instant + ',' + (bad ? QByteArray("oops") : gap ? QByteArray() : value));
            if (bad) {
                badLines.push_back(static_cast<std::size_t>(i) + 1);
                continue;
            }
            time.push_back(i + 0.5);
            values.push_back(gap ? std::numeric_limits<double>::quiet_NaN() : value.toDouble());
        }
        const auto fileOf = [&](const std::vector<QByteArray> &rows) {
            QByteArray file = bytes;
            for (const QByteArray &row : rows) {
                file += row + lineEnd;
            }
            return file;
        };
        const QByteArray file = fileOf(lines);
        QVERIFY(file.size() > 4 << 20);
        const auto outcome = read(file);
        const ReferenceData *data = std::get_if<ReferenceData>(&outcome);
        QVERIFY(data);
        QVERIFY(data->time == time);
        QVERIFY(std::ranges::equal(data->series[0].values, values,
                                   [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); }));
        QCOMPARE(data->series[0].rounding.digits, 3);
        QCOMPARE(data->skipped.size(), badLines.size());
        for (std::size_t i = 0; i < badLines.size(); ++i) {
            QCOMPARE(data->skipped[i].line, badLines[i]);
        }

        // The first fault counts, wherever it stands: here in the last quarter, and right where it is easily missed.
        for (const std::size_t row : {std::size_t{kRows} / 4 * 3, std::size_t{kRows} / 2, std::size_t{kRows} - 2}) {
            std::vector<QByteArray> faulty = lines;
            faulty[row] = lines[row - 1].left(lines[row - 1].indexOf(',')) + ",1.5";
            const auto refusal = read(fileOf(faulty));
            const ReadError *error = std::get_if<ReadError>(&refusal);
            QVERIFY(error);
            QCOMPARE(error->line, row + 2);
        }
    }

    void aFileReadsTheSameInPiecesOfAnySize_data()
    {
        QTest::addColumn<QByteArray>("bytes");
        for (const GoodFile &file : goodFiles()) {
            QTest::newRow(file.name.c_str()) << QByteArray::fromStdString(file.bytes);
        }
        for (const BadFile &file : badFiles()) {
            QTest::newRow(file.name.c_str()) << QByteArray::fromStdString(file.bytes);
        }
        QTest::newRow("rows left out, all over")
            << QByteArray("time,R4_x\r\n0,1\r\n\r\n1,x\n2,3\r3,\"\n\n4,5\r\n,,\r\n5,6,7\r\n6,y");
    }

    void aFileReadsTheSameInPiecesOfAnySize()
    {
        QFETCH(const QByteArray, bytes);
        const QString whole = told(readReferenceData(sourceOf(bytes, kOnePiece)));
        for (const std::size_t piece : {1, 3, 7, 16, 64}) {
            QCOMPARE(told(readReferenceData(sourceOf(bytes, piece))), whole);
        }
    }

    void aLargeFileReadsInPiecesAsItReadsAsAWhole_data()
    {
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<QString>("end");
        const QByteArray names = "time,theta3,R4_x\n";
        const QString good = QStringLiteral("fine");
        const auto row = [](const char *name, const QByteArray &bytes, const QString &end) {
            QTest::newRow(name) << bytes << end;
        };
        row("plain", largeFile(names, "\n"), good);
        row("CR LF", largeFile("time,theta3,R4_x\r\n", "\r\n"), good);
        row("CR", largeFile("time,theta3,R4_x\r", "\r"), good);
        row("last line not ended", largeFile(names, "\n") + "1e9,1,2", good);
        row("preamble, units, a mark",
            largeFile("\xEF\xBB\xBF"
                      "A title\ntime,theta3,R4_x\ns,\xC2\xB0,m\n",
                      "\n"),
            good);
        row("a column left out", largeFile("time,theta3,notes\n", "\n"), good);
        row("blank lines at the end", largeFile(names, "\n") + "\n\n\n", good);
        row("names that leave a guess", largeFile("t,P[1] (deg),P[2] (mm)\n", "\n"), good);
        row("a row that cannot be read, late", largeFile(names, "\n") + "1e9,oops,2\n1e10,1,2", good);
        row("beyond ASCII, late", largeFile(names, "\n") + "1e9,1,2,\xB0\n", good);
        row("Latin-1", largeFile("time,theta3 [\xB0],R4_x\n", "\n"), good);
        row("a long line, late", largeFile(names, "\n") + "1e9,1,2" + QByteArray(300'000, ' ') + "\n1e10,1,2", good);
        row("a very long line, late", largeFile(names, "\n") + "1e9,1,2" + QByteArray(1'100'000, ' ') + "\n1e10,1,2",
            QStringLiteral("line 220002: reason %1").arg(static_cast<int>(Kind::LineTooLong)));
        row("no text, late", largeFile(names, "\n") + QByteArray("1e9,1,2\n1e10,1,\0\n", 18),
            QStringLiteral("line 220003: reason %1").arg(static_cast<int>(Kind::NotText)));
        row("zeros to the end", largeFile(names, "\n") + QByteArray(3'000'000, '\0'),
            QStringLiteral("line 220002: reason %1").arg(static_cast<int>(Kind::NotText)));
        row("a time that does not increase, and worse behind",
            largeFile(names, "\n") + "0,1,2\n" + QByteArray(3'000'000, '\0'),
            QStringLiteral("line 220002: reason %1").arg(static_cast<int>(Kind::TimeNotRising)));
        row("UTF-16", utf16Of(largeFile(names, "\r\n")), good);
        row("UTF-16, half a character at the end", utf16Of(largeFile(names, "\n")) + 'x', good);
    }

    void aLargeFileReadsInPiecesAsItReadsAsAWhole()
    {
        QFETCH(const QByteArray, bytes);
        QFETCH(const QString, end);
        const auto whole = readReferenceData(sourceOf(bytes, kOnePiece));
        QVERIFY(told(readReferenceData(sourceOf(bytes, 99'991))) == told(whole));
        if (const ReadError *error = std::get_if<ReadError>(&whole)) {
            QCOMPARE(QStringLiteral("line %1: reason %2").arg(error->line).arg(static_cast<int>(error->fault.kind)),
                     end);
        } else {
            QCOMPARE(QStringLiteral("fine"), end);
            QVERIFY(std::get<ReferenceData>(whole).time.size() >= 220'000);
        }
    }

    void ofALargeFileThatIsNoTableLittleIsRead_data()
    {
        QTest::addColumn<QByteArray>("again"); // and again, to the end
        QTest::addColumn<int>("fault");
        QTest::newRow("zeros") << QByteArray(1, '\0') << static_cast<int>(Kind::NotText);
        QTest::newRow("one line") << QByteArray("x") << static_cast<int>(Kind::LineTooLong);
        QTest::newRow("blank lines") << QByteArray("\n") << static_cast<int>(Kind::Empty);
        QTest::newRow("prose") << QByteArray("and so on\n") << static_cast<int>(Kind::NoTime);
        QTest::newRow("numbers") << QByteArray("3,2\n") << static_cast<int>(Kind::NamesMissing);
        QTest::newRow("a page") << QByteArray("<html>\n") << static_cast<int>(Kind::Markup);
    }

    void ofALargeFileThatIsNoTableLittleIsRead()
    {
        QFETCH(const QByteArray, again);
        QFETCH(const int, fault);
        std::size_t read = 0;
        const auto repeat = [&](std::size_t offset, std::span<char> room) {
            for (std::size_t i = 0; i < room.size(); ++i) {
                room[i] = again[static_cast<qsizetype>((offset + i) % static_cast<std::size_t>(again.size()))];
            }
            read += room.size();
            return true;
        };
        const auto outcome = readReferenceData(ByteSource{std::size_t{1} << 40U, repeat});
        QCOMPARE(static_cast<int>(std::get<ReadError>(outcome).fault.kind), fault);
        QVERIFY(read <= std::size_t{64} << 20U); // the beginning, and some lines from all over
    }

    void saysWhenAFileBecomesShorter()
    {
        const QByteArray bytes = largeFile("time,theta3,R4_x\n", "\n");
        for (const std::size_t cut : {std::size_t{1}, std::size_t{1} << 20U, std::size_t{5} << 20U}) {
            ByteSource source = sourceOf(bytes.chopped(static_cast<qsizetype>(cut)), 1U << 18U);
            source.size += cut;
            const auto outcome = readReferenceData(source);
            QCOMPARE(std::get<ReadError>(outcome).fault.kind, Kind::Unreadable);
            QCOMPARE(std::get<ReadError>(outcome).line, std::size_t(0));
        }
    }

    void saysWhenThereIsNoMemory_data()
    {
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<std::size_t>("piece");
        QTest::addColumn<int>("step");
        QTest::newRow("one thread") << largeFile("t;P[1] (deg);P[2] (mm)\n", "\n").left(30'000).replace(',', ';') + '"'
                                    << std::size_t{4'000} << 1;
        QTest::newRow("several threads") << largeFile("time,theta3,R4_x\n", "\n") << std::size_t{600'000} << 7;
    }

    /// Whatever is the first thing that there is no memory for, in whatever thread.
    void saysWhenThereIsNoMemory()
    {
        QFETCH(const QByteArray, bytes);
        QFETCH(const std::size_t, piece);
        QFETCH(const int, step);
        const ByteSource source = sourceOf(bytes, piece);
        const QString expected = told(readReferenceData(source));
        int refused = 0;
        for (int some = 0;; some += step) {
            allocationsLeft = some;
            const auto outcome = readReferenceData(source);
            allocationsLeft = kPlenty;
            const ReadError *error = std::get_if<ReadError>(&outcome);
            if (!error || error->fault.kind != Kind::NoMemory) {
                QCOMPARE(told(outcome), expected);
                break;
            }
            ++refused;
        }
        QVERIFY2(refused > 20, qPrintable(QString::number(refused)));
    }

    void stopsWhenAsked()
    {
        std::stop_source stop;
        stop.request_stop();
        const auto outcome = read("time,R4_x\n0,1\n", stop.get_token());
        QCOMPARE(std::get<ReadError>(outcome).fault.kind, Kind::Stopped);
        const std::vector<ByteSource> two(2, sourceOf("time,R4_x\n0,1\n", kOnePiece));
        const auto joined = slidercrank::readJoined(two, stop.get_token());
        QCOMPARE(std::get<ReadError>(joined).fault.kind, Kind::Stopped);
    }

    void findsASeries()
    {
        const auto outcome = read("time,theta3,R4_x\n0,1,2\n");
        const ReferenceData &data = std::get<ReferenceData>(outcome);
        QCOMPARE(data.find({R4x, Order::Position}), &data.series[1]);
        QVERIFY(!data.find({R4x, Order::Velocity}));
    }

    void aPlotAFileIsReadAsTheWholeTable_data()
    {
        QTest::addColumn<QByteArrayList>("files");
        const QByteArray table = sampleTable();
        const QByteArray position = columnsOf(table, {0, 1});
        const QByteArray velocity = columnsOf(table, {0, 2, 3});
        const QByteArray coupler = columnsOf(table, {0, 4, 5, 6});
        QTest::newRow("three files") << QByteArrayList{position, velocity, coupler};
        QTest::newRow("in another order") << QByteArrayList{coupler, position, velocity};
        QTest::newRow("a plot each") << QByteArrayList{position,
                                                       columnsOf(table, {0, 2}),
                                                       columnsOf(table, {0, 3}),
                                                       columnsOf(table, {0, 4}),
                                                       columnsOf(table, {0, 5}),
                                                       columnsOf(table, {0, 6})};
        QTest::newRow("written otherwise")
            << QByteArrayList{position, "plot 2\n\n" + QByteArray(velocity).replace(',', ';').replace('.', ','),
                              utf16Of(QByteArray(coupler).replace(',', '\t'))};
        QTest::newRow("the instants elsewhere") << QByteArrayList{position, columnsOf(table, {2, 3, 0}), coupler};
        // Of 201 instants every other needs the third decimal.
        QByteArray coarse = position;
        for (int i = 0; i <= 200; ++i) {
            const QByteArray fine = QByteArray::number(0.005 * i, 'f', 6);
            coarse.replace('\n' + fine + ',', '\n' + QByteArray::number(0.005 * i, 'f', 3) + ',');
        }
        QTest::newRow("instants of fewer digits") << QByteArrayList{coarse, velocity, coupler};
    }

    void aPlotAFileIsReadAsTheWholeTable()
    {
        QFETCH(const QByteArrayList, files);
        const auto expected = read(sampleTable());
        const ReferenceData &whole = std::get<ReferenceData>(expected);
        const auto outcome = readJoined(files);
        QVERIFY2(std::holds_alternative<ReferenceData>(outcome), qPrintable(told(outcome)));
        const ReferenceData &data = std::get<ReferenceData>(outcome);
        QCOMPARE(data.time, whole.time);
        QVERIFY(data.timeRounding == whole.timeRounding);
        QCOMPARE(data.series.size(), whole.series.size());
        for (const ReferenceSeries &series : whole.series) {
            QVERIFY(data.find(series.channel));
            QCOMPARE(data.find(series.channel)->values, series.values);
            QVERIFY(data.find(series.channel)->rounding == series.rounding);
        }
        QCOMPARE(data.layout.files.size(), static_cast<std::size_t>(files.size()));
        QCOMPARE(std::ranges::count(data.layout.columns, ColumnReason::SameInstants, &FileColumn::reason),
                 files.size() - 1);
    }

    void whatIsLeftOutOfOnePlotIsLeftOutOfAll()
    {
        const auto outcome = readJoined({"time,R4_x\n0,1\n1,2\n2,?\n3,4\n", "time,theta3\n0,5\n1,\n2,7\n3,8\n"});
        QCOMPARE(described(outcome),
                 QStringLiteral("time 0 1 3; R4_x 1 2 4; theta3 5 gap 8; skipped 4:2 ? (not a number); ignored time"));
        QCOMPARE(std::get<ReferenceData>(outcome).skipped.front().file, std::size_t(0));
    }

    void instantsAreThoseOfThePlotThatPrintsMostDigits()
    {
        QCOMPARE(described(readJoined(
                     {"time,R4_x\n0,1\n0.033,2\n0.067,3\n0.1,4\n", "time,theta3\n0,5\n0.03333,6\n0.06667,7\n0.1,8\n"})),
                 QStringLiteral("time 0 0.03333 0.06667 0.1; R4_x 1 2 3 4; theta3 5 6 7 8; ignored time"));
    }

    void beginningsOfPlotsMayBreakOffAnywhere()
    {
        const QByteArrayList plots{"time,R4_x\n0,1\n1,2\n2,3\n", "time,theta3\n0,5\n1,6\n"};
        std::vector<ByteSource> sources{sourceOf(plots[0], kOnePiece), sourceOf(plots[1], kOnePiece)};
        QVERIFY(std::holds_alternative<ReadError>(slidercrank::readJoined(sources)));
        sources[1].isBeginning = true;
        QCOMPARE(described(slidercrank::readJoined(sources)),
                 QStringLiteral("time 0 1; R4_x 1 2; theta3 5 6; ignored time"));
        const QByteArray late = "time,theta3\n0.5,5\n1,6\n";
        sources[1] = sourceOf(late, kOnePiece);
        sources[1].isBeginning = true;
        QVERIFY(std::holds_alternative<ReadError>(slidercrank::readJoined(sources)));
    }

    void plotsOfAnglesAreJoinedToo()
    {
        const auto outcome = readJoined({"theta2,R4_x\n0,1\n90,2\n180,3\n", "theta2,theta3\n0.0,4\n90.0,5\n180.0,6\n"});
        QCOMPARE(described(outcome), QStringLiteral("time 0 0.25 0.5; R4_x 1 2 3; theta3 4 5 6; ignored theta2"));
        QVERIFY(std::get<ReferenceData>(outcome).crank);
    }

    void derivativesInAFileOfTheirOwnAreKnownAsDifferences()
    {
        QByteArray position = "time,R4_x\n";
        QByteArray velocity = "time,R4_x_diff\n";
        const auto at = [](int row) { return std::round(80e3 + 20e3 * std::cos(0.1 * row)) / 1e3; };
        for (int row = 0; row < 60; ++row) {
            const QByteArray time = QByteArray::number(0.01 * row, 'f', 2) + ',';
            position += time + QByteArray::number(at(row), 'f', 3) + '\n';
            velocity += time + QByteArray::number((at(row + 1) - at(row)) / 0.01, 'f', 3) + '\n';
        }
        const auto outcome = readJoined({position, velocity});
        QVERIFY(std::get<ReferenceData>(outcome).layout.columns.back().difference == Difference::Forward);
    }

    void choicesCountTheColumnsOfAllPlots()
    {
        const QByteArrayList files{"T,Value\n0,1\n1,2\n", "T,Value\n0,3\n1,4\n"};
        const Channel x{R4x, Order::Position};
        const Channel v{R4x, Order::Velocity};
        QCOMPARE(
            described(readJoined(files, {{{1, ColumnRole::Channel, x, {}}, {3, ColumnRole::Channel, v, "m/s"}}, {}})),
            QStringLiteral("time 0 1; R4_x 1 2; R4_x_diff 3000 4000; ignored T"));
        QCOMPARE(described(readJoined(
                     files, {{}, {}, {{"#2", ColumnRole::Channel, x, {}}, {"#4", ColumnRole::Channel, v, {}}}})),
                 QStringLiteral("time 0 1; R4_x 1 2; R4_x_diff 3 4; ignored T"));
        // What the first column is, it is in all.
        const auto byAngle =
            readJoined({"q,R4_x\n0,1\n90,2\n", "q,theta3\n0,3\n90,4\n"}, {{{0, ColumnRole::CrankAngle, {}, {}}}, {}});
        QCOMPARE(described(byAngle), QStringLiteral("time 0 0.25; R4_x 1 2; theta3 3 4; ignored q"));
        const auto elsewhere =
            readJoined({"q,R4_x\n0,1\n1,2\n", "theta3,time\n3,0\n4,1\n"}, {{{0, ColumnRole::Time, {}, {}}}, {}});
        QCOMPARE(described(elsewhere), QStringLiteral("time 0 1; R4_x 1 2; theta3 3 4; ignored time"));
        const auto several = readJoined(files, {{}, {}, {{"Value", ColumnRole::Channel, x, {}}}});
        QCOMPARE(std::get<ReadError>(several).fault.kind, Kind::SeveralColumns);
        QCOMPARE(std::get<ReadError>(several).layout.columns.size(), std::size_t(4));
    }

    void aPlotWhoseHeadingSaysNothingIsNamedByItsFile_data()
    {
        QTest::addColumn<std::string>("name");
        QTest::addColumn<QByteArray>("names");
        QTest::addColumn<std::string>("becomes");
        const auto row = [](const char *name, const char *names, const char *becomes) {
            QTest::addRow("%s: %s", name, names) << std::string(name) << QByteArray(names) << std::string(becomes);
        };
        row("slider_velocity.csv", "Time (sec),Value", "time R4_x_diff?");
        row("slider velocity.txt", "t,y", "time R4_x_diff?");
        row("coupler-angle.csv", "Time,Value [rad]", "time theta3?");
        row("position_mm.csv", "Time,Series1", "time R4_x?");
        row("theta3_diff2.csv", "t,Plot 1", "time theta3_diff2?");
        row("velocidad.csv", "Tiempo,Valor", "time R4_x_diff?");
        // Where the heading says something, or the name of the file nothing.
        row("slider_velocity.csv", "time,R4_x", "time R4_x");
        row("slider_velocity.csv", "time,temperature", "refused");
        row("slider_velocity.csv", "time,Value [mm]", "refused");
        row("slider_velocity.csv", "time,Value,Data", "refused");
        row("slider_velocity.csv", "Value,Data", "refused");
        row("plot2.csv", "time,Value", "refused");
        row("", "time,Value", "refused");
        row("plot.csv", "t,y", "time R4_y?");
    }

    void aPlotWhoseHeadingSaysNothingIsNamedByItsFile()
    {
        QFETCH(const std::string, name);
        QFETCH(const QByteArray, names);
        QFETCH(const std::string, becomes);
        QByteArray bytes = names + '\n';
        for (int row = 0; row < 20; ++row) {
            bytes += QByteArray::number(row) + QByteArray(",7.5").repeated(names.count(',')) + '\n';
        }
        ByteSource source = sourceOf(bytes, kOnePiece);
        source.name = name;
        const auto outcome = readReferenceData(source);
        const ReferenceData *data = std::get_if<ReferenceData>(&outcome);
        QCOMPARE(data ? rolesOf(data->layout) : "refused", becomes);
        const bool isGuessed = becomes.ends_with('?') && !name.starts_with("plot");
        QCOMPARE(data && data->layout.columns[1].reason == ColumnReason::FileName, isGuessed);
    }

    void refusesPlotsThatAreNotOfOneMotion_data()
    {
        QTest::addColumn<QByteArrayList>("files");
        QTest::addColumn<ReadFault>("fault");
        QTest::addColumn<std::size_t>("file");
        const Channel x{R4x, Order::Position};
        const QByteArray a = "time,R4_x\n0,1\n1,2\n2,3\n";
        const auto row = [&](const char *name, const QByteArrayList &files, const ReadFault &fault, std::size_t file) {
            QTest::newRow(name) << files << fault << file;
        };
        const auto ofFirst = [](Kind kind, Channel channel = {}) { return ReadFault{kind, channel, "a"}; };
        row("twice the step", {a, "time,theta3\n0,1\n2,2\n4,3\n"}, ofFirst(Kind::OtherInstants), 1);
        row("another start", {a, "time,theta3\n1,1\n2,2\n3,3\n"}, ofFirst(Kind::OtherInstants), 1);
        row("a little later", {a, "time,theta3\n0.1,1\n1.1,2\n2.1,3\n"}, ofFirst(Kind::OtherInstants), 1);
        row("one row more", {a, "time,theta3\n0,1\n1,2\n2,3\n3,4\n"}, ofFirst(Kind::OtherInstants), 1);
        row("one row less", {a, "time,theta3\n0,1\n1,2\n"}, ofFirst(Kind::OtherInstants), 1);
        row("another unit of time", {a, "time [ms],theta3\n0,1\n1,2\n2,3\n"}, ofFirst(Kind::OtherInstants), 1);
        row("the third", {a, "time,theta3\n0,1\n1,2\n2,3\n", "time,theta2\n0,1\n1.5,2\n2,3\n"},
            ofFirst(Kind::OtherInstants), 2);
        row("a channel twice", {a, "time,x_slider\n0,1\n1,2\n2,3\n"}, ofFirst(Kind::ChannelInBoth, x), 1);
        row("twice the same", {a, a}, ofFirst(Kind::ChannelInBoth, x), 1);
        row("angles beside instants", {a, "theta2,theta3\n0,1\n1,2\n2,3\n"}, ofFirst(Kind::CountsOtherwise), 1);
        row("one that is no table", {a, "%PDF-1.7\n"}, {Kind::Pdf}, 1);
        row("the first that is none", {"", a}, {Kind::Empty}, 0);
        row("a column that means nothing", {a, "time,humidity\n0,1\n1,2\n2,3\n"}, {Kind::NoChannel}, 1);
    }

    void refusesPlotsThatAreNotOfOneMotion()
    {
        QFETCH(const QByteArrayList, files);
        QFETCH(const ReadFault, fault);
        QFETCH(const std::size_t, file);
        const auto outcome = readJoined(files);
        QVERIFY2(std::holds_alternative<ReadError>(outcome), qPrintable(described(outcome)));
        const ReadError &error = std::get<ReadError>(outcome);
        QVERIFY2(error.fault == fault, qPrintable(described(outcome) + QString::fromStdString(error.fault.heading)));
        QCOMPARE(error.file, std::optional(file));
    }

    void survivesDamage()
    {
        QFile file(QStringLiteral(SLIDERCRANK_SOURCE_DIR "/data/inventor_sample.csv"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray whole = file.read(2000);
        constexpr char kPieces[] = "0123456789,;.\t\r\n\"-+eE[]() tR4_x\xB0\xC2\xFF";
        std::mt19937 random(20240607); // fixed: a failure can be repeated
        for (int i = 0; i < runs(3000, 100'000); ++i) {
            QByteArray bytes = whole.left(static_cast<qsizetype>(random() % 2000));
            for (int damage = 0; damage < 8 && !bytes.isEmpty(); ++damage) {
                bytes[static_cast<qsizetype>(random() % static_cast<unsigned>(bytes.size()))] =
                    kPieces[random() % (sizeof kPieces - 1)];
            }
            // A copy of just this size, so that a sanitizer sees every read beyond the end.
            const std::vector<char> exact(bytes.begin(), bytes.end());
            const auto outcome = readReferenceData({exact.data(), exact.size()});
            if (const ReferenceData *data = std::get_if<ReferenceData>(&outcome)) {
                QVERIFY(!data->time.empty() && std::is_sorted(data->time.begin(), data->time.end()));
                for (const ReferenceSeries &series : data->series) {
                    QCOMPARE(series.values.size(), data->time.size());
                }
            }
        }
    }
};

QTEST_APPLESS_MAIN(TestReferenceData)
#include "tst_reference_data.moc"
