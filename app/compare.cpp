// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/compare.h"

#include "app/json_text.h"
#include "app/output.h"
#include "app/shortfall.h"
#include "core/comparison.h"
#include "ui/reference_file.h"

#include <QDir>
#include <QStringList>

#include <algorithm>
#include <memory>
#include <string_view>
#include <variant>
#include <vector>

namespace slidercrank
{

namespace
{

QString toQString(std::string_view text)
{
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

/// As the contract names it in CSV and JSON.
const char *wordOf(Verdict verdict)
{
    switch (verdict) {
    case Verdict::Agrees: return "agrees";
    case Verdict::Close: return "close";
    case Verdict::Differs: return "differs";
    }
    return "";
}

QString shown(Verdict verdict)
{
    switch (verdict) {
    case Verdict::Agrees: return CommandLine::tr("agrees");
    case Verdict::Close: return CommandLine::tr("close");
    case Verdict::Differs: return CommandLine::tr("differs");
    }
    return {};
}

/// Without a value there is no instant of it either.
std::optional<double> timeOf(std::optional<double> value, double time)
{
    return value ? std::optional(time) : std::nullopt;
}

QByteArray jsonOf(const ChannelComparison &channel)
{
    return "{\"name\":" + jsonString(toQString(nameOf(channel.channel))) +
           ",\"unit\":" + jsonString(toQString(authorUnitOf(channel.channel))) +
           ",\"count\":" + QByteArray::number(channel.count) + ",\"maxAbs\":" + jsonNumber(channel.maxAbs) +
           ",\"timeOfMaxAbs\":" + jsonNumber(timeOf(channel.maxAbs, channel.timeOfMaxAbs)) +
           ",\"rms\":" + jsonNumber(channel.rms) + ",\"maxPercent\":" + jsonNumber(channel.maxPercent) +
           ",\"timeOfMaxPercent\":" + jsonNumber(timeOf(channel.maxPercent, channel.timeOfMaxPercent)) +
           ",\"zeroReference\":" + QByteArray::number(channel.zeroReference) +
           ",\"percentOfPeak\":" + jsonNumber(channel.percentOfPeak) +
           ",\"roundingStep\":" + jsonNumber(channel.roundingStep) + ",\"verdict\":\"" + wordOf(channel.verdict) +
           "\"}";
}

QByteArray jsonOf(const CompareOptions &options, const ReferenceData &data,
                  const std::vector<ChannelComparison> &channels)
{
    QByteArrayList comparisons;
    for (const ChannelComparison &channel : channels) {
        comparisons += jsonOf(channel);
    }
    QByteArrayList skipped;
    for (const SkippedRow &row : data.skipped) {
        skipped += "{\"line\":" + QByteArray::number(row.line) + ",\"column\":" + QByteArray::number(row.column) +
                   ",\"text\":" + jsonString(QString::fromStdString(row.text)) +
                   ",\"reason\":" + jsonString(QString::fromStdString(row.reason)) + '}';
    }
    QByteArrayList ignored;
    for (const std::string &name : data.ignoredColumns) {
        ignored += jsonString(QString::fromStdString(name));
    }
    return "{\"files\":[{\"file\":" + jsonString(options.file) + ",\"mechanism\":" + jsonMechanism(options.mechanism) +
           ",\"channels\":[" + comparisons.join(',') + "],\"skipped\":[" + skipped.join(',') +
           "],\"ignoredColumns\":[" + ignored.join(',') + "]}]}\n";
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

QByteArray csvOf(const CompareOptions &options, const std::vector<ChannelComparison> &channels)
{
    QByteArray csv("file,name,unit,count,maxAbs,timeOfMaxAbs,rms,maxPercent,timeOfMaxPercent,zeroReference,"
                   "percentOfPeak,roundingStep,verdict\n");
    for (const ChannelComparison &channel : channels) {
        const QByteArrayList cells{csvText(options.file),
                                   toQString(nameOf(channel.channel)).toUtf8(),
                                   toQString(authorUnitOf(channel.channel)).toUtf8(),
                                   QByteArray::number(channel.count),
                                   csvNumber(channel.maxAbs),
                                   csvNumber(timeOf(channel.maxAbs, channel.timeOfMaxAbs)),
                                   csvNumber(channel.rms),
                                   csvNumber(channel.maxPercent),
                                   csvNumber(timeOf(channel.maxPercent, channel.timeOfMaxPercent)),
                                   QByteArray::number(channel.zeroReference),
                                   csvNumber(channel.percentOfPeak),
                                   csvNumber(channel.roundingStep),
                                   wordOf(channel.verdict)};
        csv += cells.join(',') + '\n';
    }
    return csv;
}

/// Three digits are what a person compares.
QString rounded(std::optional<double> value, int digits = 3)
{
    return value ? QString::number(*value, 'g', digits) : QStringLiteral("–");
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

QString tableOf(const std::vector<ChannelComparison> &channels)
{
    std::vector<QStringList> rows{{CommandLine::tr("channel"), CommandLine::tr("unit"),
                                   CommandLine::tr("largest error"), CommandLine::tr("at t [s]"),
                                   CommandLine::tr("rms"), CommandLine::tr("largest %"), CommandLine::tr("at t [s]"),
                                   CommandLine::tr("zeros"), CommandLine::tr("% of peak"),
                                   CommandLine::tr("rounding step"), CommandLine::tr("verdict")}};
    for (const ChannelComparison &channel : channels) {
        rows.push_back({toQString(nameOf(channel.channel)), toQString(authorUnitOf(channel.channel)),
                        rounded(channel.maxAbs), rounded(timeOf(channel.maxAbs, channel.timeOfMaxAbs), 6),
                        rounded(channel.rms), rounded(channel.maxPercent),
                        rounded(timeOf(channel.maxPercent, channel.timeOfMaxPercent), 6),
                        QString::number(channel.zeroReference), rounded(channel.percentOfPeak),
                        rounded(channel.roundingStep), shown(channel.verdict)});
    }
    return aligned(rows, {false, false, true, true, true, true, true, true, true, true, false});
}

QString summaryOf(const std::vector<ChannelComparison> &channels)
{
    const auto count = [&](Verdict verdict) {
        return std::count_if(channels.begin(), channels.end(),
                             [verdict](const ChannelComparison &channel) { return channel.verdict == verdict; });
    };
    const auto total = static_cast<qsizetype>(channels.size());
    if (count(Verdict::Differs) == 0) {
        const QString agrees =
            CommandLine::tr("Agrees with this mechanism in %1 of %2 channels, within the rounding of "
                            "the file")
                .arg(count(Verdict::Agrees))
                .arg(total);
        return count(Verdict::Close) == 0 ? agrees + u'.' : CommandLine::tr("%1; close in the others.").arg(agrees);
    }
    const auto worst =
        std::max_element(channels.begin(), channels.end(), [](const ChannelComparison &x, const ChannelComparison &y) {
            return x.percentOfPeak.value_or(0.0) < y.percentOfPeak.value_or(0.0);
        });
    return CommandLine::tr(
               "Differs in %1 of %2 channels, most in %3 (%4 % of its peak): the file was made with another "
               "mechanism, or means something else by its columns; try other lengths (--a, --b, --c), "
               "speed (--omega2), start (--theta20) or --branch.")
        .arg(count(Verdict::Differs))
        .arg(total)
        .arg(toQString(nameOf(worst->channel)), rounded(worst->percentOfPeak));
}

QString textOf(const CompareOptions &options, const ReferenceData &data, const std::vector<ChannelComparison> &channels)
{
    const Mechanism &mechanism = options.mechanism;
    const auto number = [](double value) { return QString::number(value, 'g', 9); };
    QString text = CommandLine::tr("%1: t = %3 s to %4 s, %2 instants")
                       .arg(QDir::toNativeSeparators(options.file), QString::number(data.time.size()),
                            number(data.time.front()), number(data.time.back())) +
                   u'\n';
    text += CommandLine::tr("Model: a = %1 mm, b = %2 mm, c = %3 mm, ω2 = %4 rad/s, θ20 = %5 rad, %6")
                .arg(number(mechanism.a()), number(mechanism.b()), number(mechanism.c()), number(mechanism.omega2()),
                     number(mechanism.theta20()),
                     mechanism.branch() == Branch::Open ? CommandLine::tr("open") : CommandLine::tr("crossed")) +
            QStringLiteral("\n\n");
    text += tableOf(channels);
    return text + u'\n' + summaryOf(channels) + u'\n';
}

void warnOf(const QString &file, const ReferenceData &data)
{
    if (!data.skipped.empty()) {
        const SkippedRow &first = data.skipped.front();
        say(CommandLine::tr("%1: rows that could not be read and were skipped: %2, the first in line %3, column %4 "
                            "(\"%5\"): %6.")
                .arg(QDir::toNativeSeparators(file), QString::number(data.skipped.size()), QString::number(first.line),
                     QString::number(first.column), QString::fromStdString(first.text),
                     QString::fromStdString(first.reason)));
    }
    if (!data.ignoredColumns.empty()) {
        QStringList names;
        for (const std::string &name : data.ignoredColumns) {
            names += QString::fromStdString(name);
        }
        say(CommandLine::tr("%1: these columns are no channels and were ignored: %2.")
                .arg(QDir::toNativeSeparators(file), names.join(QStringLiteral(", "))));
    }
}

} // namespace

ExitStatus compareFile(const CompareOptions &options)
{
    const std::variant<std::shared_ptr<const Reference>, QString> outcome = readReference(options.file);
    if (const QString *sentence = std::get_if<QString>(&outcome)) {
        say(*sentence);
        return ExitStatus::FileFailed;
    }
    const ReferenceData &data = std::get<std::shared_ptr<const Reference>>(outcome)->data;

    Output output(options.output);
    if (const std::optional<QString> sentence = output.open()) {
        say(*sentence);
        return ExitStatus::FileFailed;
    }
    ChannelSet asked;
    for (const ReferenceSeries &series : data.series) {
        asked.set(indexOf(series.channel));
    }
    SolverSettings exact;
    exact.method = Method::ClosedForm;
    const Trajectory model = sample(options.mechanism, data.time, asked, exact);
    const std::vector<ChannelComparison> channels = compare(options.mechanism, model, data);

    switch (options.format) {
    case Format::Text: output.write(textOf(options, data, channels).toUtf8()); break;
    case Format::Csv: output.write(csvOf(options, channels)); break;
    case Format::Json: output.write(jsonOf(options, data, channels)); break;
    }
    if (const std::optional<QString> sentence = output.finish()) {
        say(*sentence);
        return ExitStatus::FileFailed;
    }
    warnOf(options.file, data);

    Shortfall shortfall;
    shortfall.add(model.time, model.status);
    if (shortfall.exitStatus() != ExitStatus::Done) {
        say(shortfall.sentence(options.mechanism, exact.newton.maxIterations));
        return shortfall.exitStatus();
    }
    const bool differs = std::any_of(channels.begin(), channels.end(), [](const ChannelComparison &channel) {
        return channel.verdict == Verdict::Differs;
    });
    return options.failOnDifference && differs ? ExitStatus::Differs : ExitStatus::Done;
}

} // namespace slidercrank
