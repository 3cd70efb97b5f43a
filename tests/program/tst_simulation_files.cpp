// SPDX-License-Identifier: GPL-3.0-or-later

// The program reads the files of simulation programs correctly, or refuses them with advice. It refuses other files.

#include "core/import/reference_data.h"
#include "tests/support/printed_motion.h"
#include "tests/support/simulation_files.h"
#include "tests/support/suite.h"
#include "ui/document/reference_file.h"

#include <QFile>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <set>

using namespace slidercrank;

namespace
{

/// Describes the role and the unit of each column as SimulationFile::becomes does.
std::string describeColumns(const FileLayout &layout)
{
    std::string text;
    for (const FileColumn &column : layout.columns) {
        text += text.empty() ? "" : " ";
        if (column.role == ColumnRole::Ignored) {
            text += '-';
            continue;
        }
        text += column.role == ColumnRole::Time         ? "time"
                : column.role == ColumnRole::CrankAngle ? "angle"
                                                        : std::string(nameOf(column.channel));
        text += (isGuess(column.reason) ? "?[" : "[") + column.unit + ']';
    }
    return text;
}

/// Whether column i was read with the written values. Returns true for an ignored column.
bool hasWrittenValues(const ReferenceData &data, std::size_t i, const WrittenColumn &written)
{
    const FileColumn &column = data.layout.columns[i];
    if (column.role == ColumnRole::Ignored) {
        return true;
    }
    const std::vector<double> &values = column.role == ColumnRole::Time         ? data.time
                                        : column.role == ColumnRole::CrankAngle ? data.crank->degrees
                                                                                : data.find(column.channel)->values;
    double peak = 1e-9;
    double largestError = 0.0;
    for (int row = 0; row < kWrittenRows; ++row) {
        const double value = writtenValue(written.content, row) * written.readFactor;
        peak = std::max(peak, std::abs(value));
        largestError = std::max(largestError, std::abs(values[static_cast<std::size_t>(row)] - value));
    }
    return largestError <= 1e-6 * peak;
}

QString sentenceFor(const std::variant<ReferenceData, ReadError> &outcome)
{
    const ReadError *error = std::get_if<ReadError>(&outcome);
    return error ? readErrorText(*error, {QStringLiteral("file")}) : QStringLiteral("the file was read");
}

} // namespace

Q_DECLARE_METATYPE(SimulationFile)
Q_DECLARE_METATYPE(SimulationPlots)
Q_DECLARE_METATYPE(OtherFile)

class TestSimulationFiles : public QObject
{
    Q_OBJECT

private slots:
    void readsFilesOfSimulationPrograms_data()
    {
        QTest::addColumn<SimulationFile>("file");
        std::set<std::string> programs;
        std::size_t count = 0;
        for (const SimulationFile &file : simulationFiles()) {
            QVERIFY(!file.source.empty());
            programs.insert(file.program.substr(0, file.program.find(',')));
            ++count;
            QTest::newRow(file.program.c_str()) << file;
        }
        QVERIFY(count >= 40 && programs.size() >= 15);
    }

    void readsFilesOfSimulationPrograms()
    {
        QFETCH(const SimulationFile, file);
        const auto outcome = readReferenceData(file.bytes);
        if (!file.refusal.empty()) {
            const QString sentence = sentenceFor(outcome);
            QVERIFY2(sentence.contains(QString::fromStdString(file.refusal)), qPrintable(sentence));
            return;
        }
        QVERIFY2(std::holds_alternative<ReferenceData>(outcome), qPrintable(sentenceFor(outcome)));
        const ReferenceData &data = std::get<ReferenceData>(outcome);
        QCOMPARE(QString::fromStdString(describeColumns(data.layout)), QString::fromStdString(file.becomes));
        QVERIFY(data.skipped.empty());
        QCOMPARE(data.crank ? data.crank->degrees.size() : data.time.size(), std::size_t{kWrittenRows});
        for (std::size_t i = 0; i < file.columns.size(); ++i) {
            QVERIFY2(hasWrittenValues(data, i, file.columns[i]), file.columns[i].heading.c_str());
        }
    }

    void readsPlotsOfOneMotionTogether_data()
    {
        QTest::addColumn<SimulationPlots>("plots");
        for (const SimulationPlots &plots : simulationPlots()) {
            QVERIFY(!plots.source.empty());
            QTest::newRow(plots.program.c_str()) << plots;
        }
    }

    void readsPlotsOfOneMotionTogether()
    {
        QFETCH(const SimulationPlots, plots);
        QStringList names;
        QByteArrayList bytes;
        std::vector<WrittenColumn> columns;
        for (const SimulationFile &file : plots.files) {
            names += QString::fromStdString(file.program);
            bytes += QByteArray::fromStdString(file.bytes);
            columns.insert(columns.end(), file.columns.begin(), file.columns.end());
        }
        const auto outcome = readBytes(names, bytes);
        if (const ReadError *error = std::get_if<ReadError>(&outcome)) {
            const QString sentence = readErrorText(*error, names);
            QVERIFY2(!plots.refusal.empty() && sentence.startsWith(QString::fromStdString(plots.refusal)),
                     qPrintable(sentence));
            return;
        }
        QVERIFY(plots.refusal.empty());
        const ReferenceData &data = std::get<ReferenceData>(outcome);
        QCOMPARE(QString::fromStdString(describeColumns(data.layout)), QString::fromStdString(plots.becomes));
        QCOMPARE(data.time.size(), std::size_t{kWrittenRows});
        for (std::size_t i = 0; i < columns.size(); ++i) {
            QVERIFY2(hasWrittenValues(data, i, columns[i]), columns[i].heading.c_str());
        }
    }

    void asksForColumnsThatCannotBeRecognized()
    {
        const auto isOpen = [](const QByteArray &names) {
            QByteArray bytes = names + '\n';
            for (int row = 0; row < 20; ++row) {
                bytes += QByteArray::number(row);
                for (int column = 1; column <= names.count(','); ++column) {
                    bytes += ',' + QByteArray::number(std::sin(row + column));
                }
                bytes += '\n';
            }
            return layoutOf(readReferenceData(bytes.toStdString())).isOpen();
        };
        QVERIFY(isOpen("time,J1_x,J1_y,J2_x,J2_y"));
        QVERIFY(isOpen("time,body 1 velocity,body 2 velocity"));
        QVERIFY(isOpen("time,Linear Displacement1 (mm),Linear Displacement2 (mm)"));
        QVERIFY(isOpen("time,theta3,Linear Displacement1 (mm),Linear Displacement2 (mm)"));
        QVERIFY(!isOpen("time,R4_x,J1_x"));
        QVERIFY(!isOpen("time,R4_x,Linear Displacement2 (mm)"));
        QVERIFY(!isOpen("time,x"));
        QVERIFY(!isOpen("time,temperature,humidity"));
        QVERIFY(!isOpen("J1_x,J2_x"));
        for (const OtherFile &file : otherFiles()) {
            QVERIFY2(!layoutOf(readReferenceData(file.bytes)).isOpen(), file.name.c_str());
        }
    }

    void refusesOtherFiles_data()
    {
        QTest::addColumn<OtherFile>("file");
        for (const OtherFile &file : otherFiles()) {
            QTest::newRow(file.name.c_str()) << file;
        }
        QVERIFY(otherFiles().size() >= 20);
    }

    void refusesOtherFiles()
    {
        QFETCH(const OtherFile, file);
        const QString sentence = sentenceFor(readReferenceData(file.bytes));
        QVERIFY2(sentence.contains(QString::fromStdString(file.refusal)), qPrintable(sentence));
    }

    /// The sample holds the values of the textbook's formulas with six significant digits and six decimals.
    void theSampleAgreesWithTheTextbook()
    {
        const auto print = [](long double value) {
            const double rounded = QByteArray::number(static_cast<double>(value), 'e', 5).toDouble();
            const QByteArray text = QByteArray::number(rounded, 'f', 6);
            return text == "-0.000000" ? text.sliced(1) : text;
        };
        Parameters parameters;
        parameters.b = 60.0;
        QByteArray expected = "\xEF\xBB\xBFtime,R4_x,R4_x_diff,R4_x_diff2,theta3,theta3_diff,theta3_diff2\n";
        for (int step = 0; step <= 200; ++step) {
            const long double time = step / 200.0L;
            const PrintedRow row = textbookMotion(parameters, time);
            QByteArrayList cells{print(time)};
            for (const std::size_t channel : {1U, 3U, 5U, 0U, 2U, 4U}) { // R4_x and its derivatives come first
                cells += print(row[channel]);
            }
            expected += cells.join(',') + '\n';
        }
        QFile sample(SLIDERCRANK_SOURCE_DIR "/data/inventor_sample.csv");
        QVERIFY(sample.open(QIODevice::ReadOnly));
        QCOMPARE(sample.readAll(), expected);
    }
};

const Suite suite("tst_simulation_files", runWithoutApplication<TestSimulationFiles>);

#include "tst_simulation_files.moc"
