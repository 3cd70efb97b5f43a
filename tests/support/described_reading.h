// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Reads reference files from memory and describes the results in one line.

#include "tests/support/reading.h"

#include <QByteArray>
#include <QFile>
#include <QString>

#include <array>
#include <charconv>
#include <cmath>
#include <string>
#include <vector>

namespace slidercrank
{

using Outcome = std::variant<ReferenceData, ReadError>;

inline constexpr Channel kX{R4x, Order::Position};
inline constexpr Channel kV{R4x, Order::Velocity};

inline Outcome read(const QByteArray &bytes, const std::vector<ColumnChoice> &choices = {})
{
    ReadOptions options;
    options.columns = choices;
    return readReferenceData({bytes.constData(), static_cast<std::size_t>(bytes.size())}, options);
}

/// Reads files with the names "a", "b", "c". If `areBeginnings`, only the beginning of each file was loaded.
inline Outcome readJoined(const QByteArrayList &files, const ReadOptions &options = {}, bool areBeginnings = false)
{
    std::vector<FileBytes> sources;
    for (const QByteArray &file : files) {
        const std::string name(1, static_cast<char>('a' + sources.size()));
        sources.push_back({{file.constData(), static_cast<std::size_t>(file.size())}, name, areBeginnings});
    }
    return readFiles(sources, options);
}

/// Returns the shortest text of a number. Two numbers with the same text are equal.
inline std::string exactText(double value)
{
    std::array<char, 32> text{};
    return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

inline std::string described(const std::vector<double> &values)
{
    std::string text;
    for (const double value : values) {
        text += ' ' + (std::isnan(value) ? std::string("gap") : exactText(value));
    }
    return text;
}

inline constexpr std::array kRowFaultNames{"not a number",   "too large",     "point for comma", "comma for point",
                                           "too many cells", "too few cells", "no time",         "repeated time"};

/// Returns the roles of the columns: "time R4_x theta3? -", with a question mark for a guess.
inline std::string rolesOf(const FileLayout &layout)
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

/// Returns delimiter, decimal sign and line of the headings: "; comma line 3".
inline std::string formatOf(const FileLayout &layout)
{
    const std::string sign = layout.decimalSign == DecimalSign::Comma ? " comma" : " point";
    return layout.delimiter + sign + " line " + std::to_string(layout.headerLine);
}

/// Returns the data, "time 0 0.5; R4_x 85 gap; skipped 3:2 abc (not a number)", or the error.
inline std::string described(const Outcome &outcome)
{
    if (const ReadError *error = std::get_if<ReadError>(&outcome)) {
        return "error " + std::to_string(static_cast<int>(error->fault.kind)) + ' ' + rolesOf(error->layout);
    }
    const ReferenceData &data = std::get<ReferenceData>(outcome);
    std::string text = "time" + described(data.time);
    for (const ReferenceSeries &series : data.series) {
        text += "; " + std::string(nameOf(series.channel)) + described(series.values);
    }
    for (const SkippedRow &row : data.skipped) {
        const std::string file = row.file == 0 ? "" : "file " + std::to_string(row.file) + ' ';
        text += "; skipped " + file + std::to_string(row.line) + ':' + std::to_string(row.column) + ' ' + row.text +
                " (" + kRowFaultNames[static_cast<std::size_t>(row.fault)] + ')';
    }
    return text;
}

inline QByteArray utf16Of(const QByteArray &text, bool isLittleEndian, bool hasByteOrderMark)
{
    QByteArray bytes = hasByteOrderMark ? isLittleEndian ? "\xFF\xFE" : "\xFE\xFF" : "";
    for (const QChar c : QString::fromUtf8(text)) {
        const char low = static_cast<char>(c.unicode() & 0xFFU);
        const char high = static_cast<char>(c.unicode() >> 8U);
        bytes += isLittleEndian ? low : high;
        bytes += isLittleEndian ? high : low;
    }
    return bytes;
}

/// Returns some columns of a table whose delimiter is a comma.
inline QByteArray columnsOf(const QByteArray &table, const QList<int> &columns)
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

inline QByteArray sampleTable()
{
    QFile file(QStringLiteral(SLIDERCRANK_SOURCE_DIR "/data/inventor_sample.csv"));
    return file.open(QIODevice::ReadOnly) ? file.readAll().replace("\xEF\xBB\xBF", "") : QByteArray();
}

/// Returns a table with these headings and 20 rows. The first column counts from 0, all others are 7.5.
inline QByteArray tableUnder(const QByteArray &names)
{
    QByteArray bytes = names + '\n';
    for (int row = 0; row < 20; ++row) {
        bytes += QByteArray::number(row) + QByteArray(",7.5").repeated(names.count(',')) + '\n';
    }
    return bytes;
}

} // namespace slidercrank
