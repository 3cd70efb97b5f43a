// SPDX-License-Identifier: GPL-3.0-or-later

// The program reads the files of simulation programs correctly, or refuses them with advice. It refuses other files.

#include "core/import/reference_data.h"
#include "tests/support/files.h"
#include "tests/support/printed_motion.h"
#include "tests/support/suite.h"
#include "ui/document/reference_file.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string_view>

using namespace slidercrank;

namespace tst_simulation_files
{

const QString kFolder = QStringLiteral(SLIDERCRANK_SOURCE_DIR "/tests/support/simulation_files/");

Parameters parametersOfTheFiles()
{
    Parameters parameters;
    parameters.b = 60.0;
    return parameters;
}

/// Files that are read together, and what is expected: the columns, or a part of the error message (see the README of
/// kFolder).
struct Sample {
    QString name;
    QStringList files;
    QString columns;
    QString refusal;
};

std::vector<Sample> samples()
{
    std::vector<Sample> samples;
    for (const QJsonValue &sample : QJsonDocument::fromJson(contentOf(kFolder + "index.json")).array()) {
        samples.push_back({sample["name"].toString(), sample["files"].toVariant().toStringList(),
                           sample["columns"].toString(), sample["refusal"].toString()});
    }
    return samples;
}

std::variant<ReferenceData, ReadError> readSample(const QStringList &files)
{
    QByteArrayList bytes;
    for (const QString &file : files) {
        bytes += contentOf(kFolder + file);
    }
    return readBytes(files, bytes);
}

/// Returns the value of a channel in the unit of files.
double exactValue(Channel channel, double time)
{
    const Parameters p = parametersOfTheFiles();
    return static_cast<double>(textbookValue(p, channel, p.omega2 * time + p.theta20));
}

/// The name and the values of a column that is used, and the exact value at a time (s).
struct UsedColumn {
    std::string_view name;
    const std::vector<double> &values;
    std::function<double(double)> exactAt;
};

UsedColumn usedColumn(const ReferenceData &data, const FileColumn &column)
{
    switch (column.role) {
    case ColumnRole::Time: return {"time", data.time, [](double time) { return time; }};
    case ColumnRole::CrankAngle:
        return {"angle", data.crank->degrees, [](double time) { return exactValue({Theta2, Order::Position}, time); }};
    case ColumnRole::Ignored:
    case ColumnRole::Channel: break;
    }
    const Channel channel = column.channel;
    return {nameOf(channel), data.find(channel)->values, [channel](double time) { return exactValue(channel, time); }};
}

/// Compares the values of a column with the exact ones. Returns "" if they are equal, "/1000" if they are in m instead
/// of mm, and otherwise "!".
QString differenceMark(const UsedColumn &column)
{
    constexpr double kTolerance = 1e-6; // relative to the peak
    constexpr double kRowsPerSecond = 20.0;
    double peak = 1e-9;
    double error = 0.0;
    double errorInMetres = 0.0;
    for (std::size_t row = 0; row < column.values.size(); ++row) {
        const double value = column.exactAt(static_cast<double>(row) / kRowsPerSecond);
        peak = std::max(peak, std::abs(value));
        error = std::max(error, std::abs(column.values[row] - value));
        errorInMetres = std::max(errorInMetres, std::abs(1000.0 * column.values[row] - value));
    }
    if (error <= kTolerance * peak) {
        return {};
    }
    return errorInMetres <= kTolerance * peak ? "/1000" : "!";
}

/// Describes the role and the unit of each column, and whether its values are those of the motion.
QString describeColumns(const ReferenceData &data)
{
    QStringList columns;
    for (const FileColumn &column : data.layout.columns) {
        if (column.role == ColumnRole::Ignored) {
            columns += "-";
            continue;
        }
        const UsedColumn used = usedColumn(data, column);
        columns += QString::fromUtf8(used.name) + (isGuess(column.reason) ? "?[" : "[") +
                   QString::fromStdString(column.unit) + ']' + differenceMark(used);
    }
    return columns.join(' ');
}

class TestSimulationFiles : public QObject
{
    Q_OBJECT

private slots:
    void readsOrRefuses_data()
    {
        QTest::addColumn<Sample>("sample");
        for (const Sample &sample : samples()) {
            QTest::newRow(qPrintable(sample.name)) << sample;
        }
        QVERIFY(samples().size() > 70);
    }

    void readsOrRefuses()
    {
        QFETCH(const Sample, sample);
        const auto outcome = readSample(sample.files);
        if (const ReadError *error = std::get_if<ReadError>(&outcome)) {
            const QString sentence = readErrorText(*error, sample.files);
            QVERIFY2(!sample.refusal.isEmpty() && sentence.contains(sample.refusal), qPrintable(sentence));
            return;
        }
        const ReferenceData &data = std::get<ReferenceData>(outcome);
        QVERIFY(sample.refusal.isEmpty() && data.skipped.empty());
        QCOMPARE(describeColumns(data), sample.columns);
        QCOMPARE(data.crank ? data.crank->degrees.size() : data.time.size(), std::size_t{21});
    }

    void asksForColumnsThatCannotBeRecognized()
    {
        const auto asksForColumns = [](const std::variant<ReferenceData, ReadError> &outcome) {
            const ReadError *error = std::get_if<ReadError>(&outcome);
            return error && error->fault.kind == ReadFault::Kind::NoCertainChannel;
        };
        const auto table = [](const QByteArray &names) {
            QByteArray bytes = names + '\n';
            for (int row = 0; row < 20; ++row) {
                bytes += QByteArray::number(row);
                for (int column = 1; column <= names.count(','); ++column) {
                    bytes += ',' + QByteArray::number(std::sin(row + column));
                }
                bytes += '\n';
            }
            return readReferenceData(bytes.toStdString());
        };
        QVERIFY(asksForColumns(table("time,J1_x,J1_y,J2_x,J2_y")));
        QVERIFY(asksForColumns(table("time,body 1 velocity,body 2 velocity")));
        QVERIFY(asksForColumns(table("time,Linear Displacement1 (mm),Linear Displacement2 (mm)")));
        QVERIFY(!asksForColumns(table("time,R4_x,J1_x")));
        QVERIFY(!asksForColumns(table("time,R4_x,Linear Displacement2 (mm)")));
        QVERIFY(!asksForColumns(table("time,x")));
        QVERIFY(!asksForColumns(table("time,temperature,humidity")));
        QVERIFY(!asksForColumns(table("J1_x,J2_x")));
        for (const Sample &sample : samples()) {
            const bool isOther = sample.files.front().startsWith("other/");
            QVERIFY2(!isOther || !asksForColumns(readSample(sample.files)), qPrintable(sample.name));
        }
    }

    /// The sample holds the values of the textbook's formulas with six significant digits and six decimals.
    void theSampleAgreesWithTheTextbook()
    {
        const auto print = [](double value) {
            const QByteArray text = QByteArray::number(QByteArray::number(value, 'e', 5).toDouble(), 'f', 6);
            return text == "-0.000000" ? text.sliced(1) : text;
        };
        QByteArray expected = "\xEF\xBB\xBFtime,R4_x,R4_x_diff,R4_x_diff2,theta3,theta3_diff,theta3_diff2\n";
        for (int step = 0; step <= 200; ++step) {
            const double time = step / 200.0;
            QByteArrayList cells{print(time)};
            for (const Coordinate coordinate : {R4x, Theta3}) {
                for (const Order order : {Order::Position, Order::Velocity, Order::Acceleration}) {
                    cells += print(exactValue({coordinate, order}, time));
                }
            }
            expected += cells.join(',') + '\n';
        }
        QCOMPARE(contentOf(kSample), expected);
    }
};

const Suite<TestSimulationFiles> suite("tst_simulation_files");

} // namespace tst_simulation_files

#include "tst_simulation_files.moc"
