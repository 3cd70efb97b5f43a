// SPDX-License-Identifier: GPL-3.0-or-later

// The reader understands the headings of textbooks, laboratories, programs and languages. Each line of
// tests/support/heading_notations.txt is a way to write the headings of one table. The numbers below them are those of
// the textbook's formulas in the stated units.

#include "tests/support/described_reading.h"
#include "tests/support/files.h"
#include "tests/support/printed_motion.h"
#include "tests/support/suite.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <map>

using namespace slidercrank;

namespace tst_headings
{

constexpr int kHeadingRows = 41; // of one turn in a second

struct ExpectedColumn {
    QString name; ///< "time", "angle", the name of a channel, or "-"
    double unit;  ///< in mm, degrees or seconds
};

/// Reads columns such as "time[s] R4_x[mm] -".
std::vector<ExpectedColumn> expectedColumns(const QString &text)
{
    const std::map<QString, double> units{
        {"mm", 1.0},   {"cm", 10.0},     {"m", 1e3},          {"in", 25.4},    {"dm", 100.0},
        {"yd", 914.4}, {"thou", 0.0254}, {"halfturn", 180.0}, {"deg", 1.0},    {"rad", 180.0 / M_PI},
        {"rpm", 6.0},  {"s", 1.0},       {"ft", 304.8},       {"mph", 447.04}, {"arcmin", 1.0 / 60.0},
        {"ms", 1e-3},  {"um", 1e-3},     {"us", 1e-6},        {"turn", 360.0}};
    std::vector<ExpectedColumn> columns;
    for (const QString &column : text.simplified().split(' ')) {
        const QString unit = column.section('[', 1).section(']', 0, 0).section('/', 0, 0);
        columns.push_back({column.section('[', 0, 0), unit.isEmpty() ? 1.0 : units.at(unit)});
    }
    return columns;
}

/// Returns a value of a column in mm, degrees and seconds. Of the ignored columns, "-#" counts the rows, and the others
/// swing like a cosine.
double valueIn(const QString &column, int row)
{
    const double time = row / (kHeadingRows - 1.0);
    Parameters mechanism;
    mechanism.b = 60.0;
    if (column == u"time") {
        return time;
    }
    if (column.startsWith('-')) {
        return column == u"-#" ? row : 3.0 + 2.0 * std::cos(1.3 * row);
    }
    const std::string name = column == u"angle" ? "theta2" : column.toStdString();
    return static_cast<double>(textbookValue(mechanism, *channelNamed(name), mechanism.omega2 * time));
}

const std::vector<double> &valuesOfColumn(const ReferenceData &data, const FileColumn &column)
{
    if (column.role == ColumnRole::Time) {
        return data.time;
    }
    return column.role == ColumnRole::CrankAngle ? data.crank->degrees : data.find(column.channel)->values;
}

class TestHeadings : public QObject
{
    Q_OBJECT

private slots:
    void understandsEveryNotation_data()
    {
        QTest::addColumn<QString>("headings");
        QTest::addColumn<QString>("columns");
        const QString list = contentOf(SLIDERCRANK_SOURCE_DIR "/tests/support/heading_notations.txt");
        for (const QString &line : list.split('\n', Qt::SkipEmptyParts)) {
            const QStringList parts = line.split(" | ");
            if (!line.startsWith('#')) {
                QTest::newRow(qPrintable(parts.at(0))) << parts.at(1) << parts.at(2);
            }
        }
    }

    void understandsEveryNotation()
    {
        QFETCH(const QString, headings);
        QFETCH(const QString, columns);
        const std::vector<ExpectedColumn> expected = expectedColumns(columns);
        QByteArray table = headings.toUtf8();
        for (int row = 0; row < kHeadingRows; ++row) {
            char separator = '\n';
            for (const ExpectedColumn &column : expected) {
                table += separator + QByteArray::number(valueIn(column.name, row) / column.unit, 'g', 9);
                separator = ';';
            }
        }
        const Outcome outcome = read(table);
        const ReferenceData *const data = std::get_if<ReferenceData>(&outcome);
        QVERIFY2(data, described(outcome).c_str());
        const std::string roles = rolesOf(data->layout);
        QStringList found = QString::fromStdString(roles).remove('?').split(' ');
        for (std::size_t i = 0; i < expected.size(); ++i) {
            const QString name = expected[i].name.startsWith('-') ? "-" : expected[i].name;
            QCOMPARE(found.value(static_cast<qsizetype>(i)), name);
            if (name == u"-") {
                continue;
            }
            const std::vector<double> &values = valuesOfColumn(*data, data->layout.columns[i]);
            QCOMPARE(values.size(), std::size_t(kHeadingRows));
            const double size = rangeOf(values).size();
            for (int row = 0; row < kHeadingRows; ++row) {
                QVERIFY(std::abs(values[static_cast<std::size_t>(row)] - valueIn(name, row)) <= 1e-7 * size);
            }
        }
    }
};

const Suite<TestHeadings> suite("tst_headings");

} // namespace tst_headings

#include "tst_headings.moc"
