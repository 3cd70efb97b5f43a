// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/reference_files.h"

#include "app/output.h"
#include "ui/document/settings_fields.h"
#include "ui/text/column_text.h"
#include "ui/text/convention_text.h"
#include "ui/text/finding_text.h"
#include "ui/text/read_fault_text.h"

#include <array>
#include <map>

namespace slidercrank
{

namespace
{

/// "theta3" or "time"; empty for a column that is ignored.
QString columnMeaning(const FileColumn &column)
{
    return column.role == ColumnRole::Ignored ? QString() : meaningName(column.role, column.channel);
}

/// The unit of a convention's amount, by Convention::Kind; null if there is no amount. That of a ZeroPoint is the unit
/// of its channel.
constexpr std::array<const char *, 12> kAmountUnits{"", "",      "",      "",  "°",     "°",
                                                    "", nullptr, nullptr, "s", nullptr, nullptr};

/// Reports rows that were skipped, columns that were not used, and columns whose meaning was guessed.
void reportDoubts(const Streams &streams, const Reference &reference)
{
    const QString name = displayName(reference.paths);
    const ReferenceData &data = reference.data;
    const FileLayout &layout = data.layout;
    if (!data.skipped.empty()) {
        const SkippedRow &first = data.skipped.front();
        streams.report(CommandLine::tr("%1: rows that were skipped: %2, the first in line %3, column %4 (\"%5\"): %6.")
                           .arg(name, QString::number(data.skippedRowCount()), lineText(layout, first),
                                QString::number(first.column), QString::fromStdString(first.text), reasonOf(first)));
    }
    QStringList ignored, guesses;
    for (const std::size_t i : ignoredColumns(layout)) {
        ignored += headingText(layout, i) + " (" + reasonText(layout, i) + ')';
    }
    for (std::size_t i = 0; i < layout.columns.size(); ++i) {
        const FileColumn &column = layout.columns[i];
        if (column.role != ColumnRole::Ignored && isGuess(column.reason)) {
            guesses += CommandLine::tr("\"%1\" as %2 (%3)")
                           .arg(headingText(layout, i), columnMeaning(column), reasonText(layout, i));
        }
    }
    if (!ignored.isEmpty()) {
        streams.report(CommandLine::tr("%1: these columns were not used: %2.").arg(name, ignored.join(", ")));
    }
    if (!guesses.isEmpty()) {
        streams.report(CommandLine::tr("%1: the meaning of these columns was guessed: %2. Correct it with --column.")
                           .arg(name, guesses.join(", ")));
    }
}

} // namespace

ReferenceQuestion::ReferenceQuestion(const OptionReader &options)
    : mechanism(readMechanism(options))
    , columns(readColumns(options))
    , format(readFormat(options, Format::Text))
    , output(readOutput(options, options.files()))
{
    if (options.files().isEmpty()) {
        throw UsageError{
            CommandLine::tr("\"slidercrank %1\" needs a file: slidercrank %1 FILE…").arg(options.command().name)};
    }
    for (const QString &file : options.files()) {
        if (options.has("join") && !files.isEmpty()) {
            files.first() += file;
        } else {
            files += QStringList(file);
        }
    }
}

ExitStatus ReferenceQuestion::answerEach(const Streams &streams, const AnswerOne &answerOne) const
{
    useLanguageOf(format);
    ExitStatus status = ExitStatus::Success;
    std::map<QString, int> counts; // of the references in each category
    QStringList texts;
    std::vector<Record> rows;
    QJsonArray json;
    for (const QStringList &paths : files) {
        const auto reference = readTimedReference(streams, {paths, {}, {}}, columns, mechanism);
        if (!reference) {
            status = moreSevere(status, ExitStatus::FileError);
            ++counts[CommandLine::tr("could not be read")];
            continue;
        }
        ReferenceAnswer answer = answerOne(*reference);
        const QString file = paths.join(" + ");
        status = moreSevere(status, answer.status);
        ++counts[answer.category];
        texts += answer.text;
        for (Record &row : answer.rows) {
            row.insert(row.begin(), {"file", file});
            rows.push_back(row);
        }
        answer.json.insert("file", file);
        if (paths.size() > 1) {
            answer.json.insert("joined", QJsonArray::fromStringList(paths));
        }
        json += answer.json;
    }
    if (json.isEmpty()) { // no file could be read: writes no output file
        return status;
    }
    if (files.size() > 1) {
        QStringList parts;
        for (const auto &[category, count] : counts) {
            parts += QString::number(count) + ' ' + category;
        }
        texts += CommandLine::tr("%1 files: %2.").arg(QString::number(files.size()), parts.join(", ")) + '\n';
    }
    texts.removeAll(QString());
    const QByteArray bytes = format == Format::Json  ? jsonDocument({{"files", json}})
                             : format == Format::Csv ? csvText(rows)
                                                     : texts.join('\n').toUtf8();
    return bytes.isEmpty() ? status : moreSevere(status, writeOutput(streams, output, bytes));
}

std::shared_ptr<const Reference> readTimedReference(const Streams &streams, const ReferenceSource &source,
                                                    const std::vector<NamedChoice> &columns, const Mechanism &mechanism)
{
    ReferenceOutcome outcome = readReference(source, {}, {{}, {}, columns});
    if (const auto *read = std::get_if<std::shared_ptr<const Reference>>(&outcome)) {
        outcome = timedBy(mechanism, *read);
    }
    if (const QString *message = std::get_if<QString>(&outcome)) {
        streams.report(*message);
        return nullptr;
    }
    const auto reference = std::get<std::shared_ptr<const Reference>>(outcome);
    reportDoubts(streams, *reference);
    return reference;
}

QString headline(const Reference &reference)
{
    const ReferenceData &data = reference.data;
    return CommandLine::tr("%1: %2, %3 rows")
               .arg(displayName(reference.paths), abscissaText(data), QString::number(data.time.size())) +
           '\n';
}

QJsonArray jsonColumns(const FileLayout &layout)
{
    QJsonArray columns;
    for (std::size_t i = 0; i < layout.columns.size(); ++i) {
        const FileColumn &column = layout.columns[i];
        QJsonObject object{{"heading", jsonText(QString::fromUtf8(column.heading))},
                           {"unit", jsonText(QString::fromUtf8(column.unit))},
                           {"channel", jsonText(columnMeaning(column))},
                           {"guessed", isGuess(column.reason)},
                           {"why", reasonText(layout, i)}};
        if (column.file < layout.files.size()) {
            object.insert("file", QString::fromUtf8(layout.files[column.file]));
        }
        columns += object;
    }
    return columns;
}

QJsonArray jsonConventions(const std::vector<ConventionFinding> &findings, const ReferenceData &data)
{
    return jsonList(findings, [&data](const ConventionFinding &finding) {
        const Convention &convention = finding.convention;
        const char *unit = kAmountUnits[static_cast<std::size_t>(convention.kind)];
        const bool isZeroPoint = convention.kind == Convention::Kind::ZeroPoint;
        QStringList channels;
        for (const Channel channel : convention.channels) {
            channels += columnNameOf(channel);
        }
        return QJsonObject{{"name", toJson(convention)["kind"]},
                           {"channel", jsonText(channels.join(','))},
                           {"amount", unit ? QJsonValue(convention.amount) : QJsonValue()},
                           {"unit", jsonText(isZeroPoint ? unitOf(convention.channels.front()) : QString(unit))},
                           {"explanation", explanationOf(convention, data)},
                           {"standardError", jsonNumber(finding.standardError)},
                           {"before", jsonNumber(finding.before)},
                           {"after", jsonNumber(finding.after)}};
    });
}

const char *verdictName(Verdict verdict)
{
    constexpr std::array kNames{"agrees", "close", "differs"};
    return kNames[static_cast<std::size_t>(verdict)];
}

Record comparisonRecord(const ChannelComparison &channel)
{
    const auto timeOf = [](std::optional<double> value, double time) {
        return value ? jsonNumber(time) : QJsonValue();
    };
    return {{"name", columnNameOf(channel.channel)},
            {"unit", unitOf(channel.channel)},
            {"count", jsonNumber(channel.count)},
            {"maxAbs", jsonNumber(channel.maxAbs)},
            {"timeOfMaxAbs", timeOf(channel.maxAbs, channel.timeOfMaxAbs)},
            {"rms", jsonNumber(channel.rms)},
            {"maxPercent", jsonNumber(channel.maxPercent)},
            {"timeOfMaxPercent", timeOf(channel.maxPercent, channel.timeOfMaxPercent)},
            {"zeroReference", jsonNumber(channel.zeroReference)},
            {"percentOfPeak", jsonNumber(channel.percentOfPeak)},
            {"roundingStep", jsonNumber(channel.roundingStep)},
            {"verdict", verdictName(channel.verdict)}};
}

QString comparisonTable(const std::vector<ChannelComparison> &channels, const ReferenceData &data)
{
    std::vector<Record> rows;
    for (const ChannelComparison &channel : channels) {
        ChannelComparison shown = channel;
        if (data.crank) { // shows crank angles instead of times
            for (double *place : {&shown.timeOfMaxAbs, &shown.timeOfMaxPercent}) {
                *place = (data.crank->omega2 * *place + data.crank->theta20) * kDegreesPerRadian;
            }
        }
        rows.push_back(comparisonRecord(shown));
        rows.back().back().second = verdictText(channel);
    }
    const QString where = data.crank ? CommandLine::tr("at θ₂ [°]") : CommandLine::tr("at t [s]");
    return recordTable({{"name", CommandLine::tr("channel")},
                        {"unit", CommandLine::tr("unit")},
                        {"maxAbs", CommandLine::tr("largest error")},
                        {"timeOfMaxAbs", where, 6},
                        {"rms", CommandLine::tr("rms")},
                        {"maxPercent", CommandLine::tr("largest %")},
                        {"timeOfMaxPercent", where, 6},
                        {"zeroReference", CommandLine::tr("zeros")},
                        {"percentOfPeak", CommandLine::tr("% of peak")},
                        {"roundingStep", CommandLine::tr("rounding step")},
                        {"verdict", CommandLine::tr("verdict")}},
                       rows);
}

} // namespace slidercrank
