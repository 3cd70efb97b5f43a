// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/comparison_text.h"

#include "app/command_line.h"
#include "app/json_text.h"
#include "ui/document/reference_file.h"
#include "ui/text/column_text.h"
#include "ui/text/finding_text.h"
#include "ui/text/read_fault_text.h"

#include <QStringList>

#include <algorithm>
#include <optional>

namespace slidercrank
{

namespace
{

/// Without a value there is no instant of it either.
std::optional<double> timeOf(std::optional<double> value, double time)
{
    return value ? std::optional(time) : std::nullopt;
}

QByteArray jsonOf(const ChannelComparison &channel)
{
    return "{\"name\":" + jsonString(columnNameOf(channel.channel)) +
           ",\"unit\":" + jsonString(unitOf(channel.channel)) + ",\"count\":" + QByteArray::number(channel.count) +
           ",\"maxAbs\":" + jsonNumber(channel.maxAbs) +
           ",\"timeOfMaxAbs\":" + jsonNumber(timeOf(channel.maxAbs, channel.timeOfMaxAbs)) +
           ",\"rms\":" + jsonNumber(channel.rms) + ",\"maxPercent\":" + jsonNumber(channel.maxPercent) +
           ",\"timeOfMaxPercent\":" + jsonNumber(timeOf(channel.maxPercent, channel.timeOfMaxPercent)) +
           ",\"zeroReference\":" + QByteArray::number(channel.zeroReference) +
           ",\"percentOfPeak\":" + jsonNumber(channel.percentOfPeak) +
           ",\"roundingStep\":" + jsonNumber(channel.roundingStep) + ",\"verdict\":\"" + wordOf(channel.verdict) +
           "\"}";
}

/// Empty for what does not exist.
QByteArray csvNumber(std::optional<double> value)
{
    return value ? jsonNumber(value) : QByteArray();
}

QByteArray csvText(const QString &text)
{
    QString quoted = text;
    return '"' + quoted.replace(u'"', QStringLiteral("\"\"")).toUtf8() + '"';
}

/// Columns as wide as their widest cell; text to the left, numbers to the right.
QString aligned(const std::vector<QStringList> &rows, const std::vector<bool> &isNumber)
{
    QString table;
    for (const QStringList &row : rows) {
        QString line;
        for (qsizetype column = 0; column < row.size(); ++column) {
            qsizetype width = 0;
            for (const QStringList &other : rows) {
                width = std::max(width, other[column].size());
            }
            line += isNumber[static_cast<std::size_t>(column)] ? row[column].rightJustified(width)
                                                               : row[column].leftJustified(width);
            line += QStringLiteral("  ");
        }
        table += line.trimmed() + u'\n';
    }
    return table;
}

/// "P[3.1] (deg)" as theta3 (guessed by its unit)
QStringList guessesIn(const FileLayout &layout)
{
    QStringList guesses;
    for (std::size_t i = 0; i < layout.columns.size(); ++i) {
        const FileColumn &column = layout.columns[i];
        if (column.role == ColumnRole::Ignored || !isGuess(column.reason)) {
            continue;
        }
        const QString meaning = column.role == ColumnRole::Time ? CommandLine::tr("the time", "a column is taken for")
                                : column.role == ColumnRole::CrankAngle
                                    ? CommandLine::tr("the crank angle", "a column is taken for")
                                    : columnNameOf(column.channel);
        guesses +=
            CommandLine::tr("\"%1\" as %2 (%3)").arg(headingText(layout, i), meaning, shortReasonText(layout, i));
    }
    return guesses;
}

} // namespace

QString joinedName(const QStringList &files)
{
    return files.join(QStringLiteral(" + "));
}

QByteArray jsonJoined(const QStringList &files)
{
    QByteArrayList names;
    for (const QString &file : files) {
        names += jsonString(file);
    }
    return files.size() > 1 ? "\"joined\":[" + names.join(',') + "]," : QByteArray();
}

std::variant<std::shared_ptr<const Reference>, QString>
readTimed(const ReferenceSource &source, const std::vector<NamedChoice> &columns, const Mechanism &mechanism)
{
    const auto outcome = readReference(source, {}, {{}, {}, columns});
    const auto *reference = std::get_if<std::shared_ptr<const Reference>>(&outcome);
    return reference ? timedBy(mechanism, *reference) : outcome;
}

const char *wordOf(Verdict verdict)
{
    switch (verdict) {
    case Verdict::Agrees: return "agrees";
    case Verdict::Close: return "close";
    case Verdict::Differs: return "differs";
    }
    return "";
}

QString headlineOf(const QString &file, const ReferenceData &data)
{
    const auto number = [](double value) { return rounded(value, 9); };
    if (data.crank) {
        const CrankAngles &crank = *data.crank;
        return CommandLine::tr("%1: θ₂ = %3° to %4°, %2 angles, timed by ω₂ = %5 rad/s and θ₂₀ = %6°")
                   .arg(shownNameOf(file), QString::number(data.time.size()), number(crank.degrees.front()),
                        number(crank.degrees.back()), number(crank.omega2), number(crank.theta20 * kDegreesPerRadian)) +
               u'\n';
    }
    if (data.time.size() == 1) {
        return CommandLine::tr("%1: t = %2 s, one instant").arg(shownNameOf(file), number(data.time.front())) + u'\n';
    }
    return CommandLine::tr("%1: t = %3 s to %4 s, %2 instants")
               .arg(shownNameOf(file), QString::number(data.time.size()), number(data.time.front()),
                    number(data.time.back())) +
           u'\n';
}

QString tableOf(const std::vector<ChannelComparison> &channels, const ReferenceData &data)
{
    const QString where = data.crank ? CommandLine::tr("at θ₂ [°]") : CommandLine::tr("at t [s]");
    const auto placeOf = [&data](std::optional<double> value, double time) {
        const std::optional<double> place = value && data.crank
                                                ? (data.crank->omega2 * time + data.crank->theta20) * kDegreesPerRadian
                                                : timeOf(value, time);
        return rounded(place, 6);
    };
    std::vector<QStringList> rows{
        {CommandLine::tr("channel"), CommandLine::tr("unit"), CommandLine::tr("largest error"), where,
         CommandLine::tr("rms"), CommandLine::tr("largest %"), where, CommandLine::tr("zeros"),
         CommandLine::tr("% of peak"), CommandLine::tr("rounding step"), CommandLine::tr("verdict")}};
    for (const ChannelComparison &channel : channels) {
        rows.push_back({columnNameOf(channel.channel), unitOf(channel.channel), rounded(channel.maxAbs),
                        placeOf(channel.maxAbs, channel.timeOfMaxAbs), rounded(channel.rms),
                        rounded(channel.maxPercent), placeOf(channel.maxPercent, channel.timeOfMaxPercent),
                        QString::number(channel.zeroReference), rounded(channel.percentOfPeak),
                        rounded(channel.roundingStep), verdictText(channel)});
    }
    return aligned(rows, {false, false, true, true, true, true, true, true, true, true, false});
}

QByteArray csvHeader()
{
    return "file,name,unit,count,maxAbs,timeOfMaxAbs,rms,maxPercent,timeOfMaxPercent,zeroReference,percentOfPeak,"
           "roundingStep,verdict,fileVerdict,sentence\n";
}

QByteArray csvOf(const QString &file, const std::vector<ChannelComparison> &channels, Verdict verdict,
                 const QString &sentence)
{
    QByteArray csv;
    for (const ChannelComparison &channel : channels) {
        const QByteArrayList cells{csvText(file),
                                   columnNameOf(channel.channel).toUtf8(),
                                   unitOf(channel.channel).toUtf8(),
                                   QByteArray::number(channel.count),
                                   csvNumber(channel.maxAbs),
                                   csvNumber(timeOf(channel.maxAbs, channel.timeOfMaxAbs)),
                                   csvNumber(channel.rms),
                                   csvNumber(channel.maxPercent),
                                   csvNumber(timeOf(channel.maxPercent, channel.timeOfMaxPercent)),
                                   QByteArray::number(channel.zeroReference),
                                   csvNumber(channel.percentOfPeak),
                                   csvNumber(channel.roundingStep),
                                   wordOf(channel.verdict),
                                   wordOf(verdict),
                                   sentence.isEmpty() ? QByteArray() : csvText(sentence)};
        csv += cells.join(',') + '\n';
    }
    return csv;
}

QByteArray jsonOf(const std::vector<ChannelComparison> &channels)
{
    QByteArrayList comparisons;
    for (const ChannelComparison &channel : channels) {
        comparisons += jsonOf(channel);
    }
    return '[' + comparisons.join(',') + ']';
}

void warnOf(const QString &file, const ReferenceData &data)
{
    if (!data.skipped.empty()) {
        const SkippedRow &first = data.skipped.front();
        say(CommandLine::tr("%1: rows that could not be read and were skipped: %2, the first in line %3, column %4 "
                            "(\"%5\"): %6.")
                .arg(shownNameOf(file), QString::number(data.skippedRowCount()), lineText(data.layout, first),
                     QString::number(first.column), QString::fromStdString(first.text), reasonOf(first)));
    }
    QStringList ignored;
    for (const std::size_t i : ignoredColumns(data.layout)) {
        ignored += QStringLiteral("%1 (%2)").arg(headingText(data.layout, i), shortReasonText(data.layout, i));
    }
    if (!ignored.isEmpty()) {
        say(CommandLine::tr("%1: these columns were not used: %2.")
                .arg(shownNameOf(file), ignored.join(QStringLiteral(", "))));
    }
    if (const QStringList guesses = guessesIn(data.layout); !guesses.empty()) {
        say(CommandLine::tr("%1: what these columns are is guessed: %2. Where that is wrong, say it with --column.")
                .arg(shownNameOf(file), guesses.join(QStringLiteral(", "))));
    }
}

} // namespace slidercrank
