// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/reference_files.h"

#include "ui/document/settings_fields.h"
#include "ui/text/channel_text.h"
#include "ui/text/column_text.h"
#include "ui/text/convention_text.h"
#include "ui/text/read_fault_text.h"
#include "ui/text/written_number.h"

#include <QFileInfo>

namespace slidercrank
{

namespace
{

QJsonArray jsonColumns(const FileLayout &layout)
{
    QJsonArray columns;
    for (std::size_t i = 0; i < layout.columns.size(); ++i) {
        const FileColumn &column = layout.columns[i];
        columns += QJsonObject{
            {"heading", jsonText(QString::fromUtf8(column.heading))},
            {"unit", jsonText(QString::fromUtf8(column.unit))},
            {"channel", column.role == ColumnRole::Ignored ? QJsonValue() : meaningName(column.role, column.channel)},
            {"guessed", isGuess(column.reason)},
            {"why", reasonText(layout, i)},
            {"file", jsonFile(layout, column.file)}};
    }
    return columns;
}

} // namespace

ReferenceRequest::ReferenceRequest(const OptionReader &options)
    : request(options)
    , columns(readColumns(options))
{
    if (options.files().isEmpty()) {
        throw UsageError{
            CommandLine::tr("\"slidercrank %1\" needs a file: slidercrank %1 FILE…").arg(options.command().name)};
    }
    for (const QString &file : options.files()) {
        if (!QFileInfo::exists(file)) {
            options.refuseOptionWithoutDashes(file);
        }
    }
    if (options.has("join")) {
        files = {options.files()};
        return;
    }
    for (const QString &file : options.files()) {
        files += QStringList(file);
    }
}

ExitStatus ReferenceRequest::reportEach(const Streams &streams, const ReportOne &reportOne) const
{
    QStringList texts;
    CommandOutput all;
    QJsonArray json;
    for (const QStringList &paths : files) {
        const auto reference = readTimedReference(streams, {.paths = paths}, columns, request.mechanism);
        if (!reference) {
            all.status = moreSevere(all.status, ExitStatus::FileError);
            continue;
        }
        CommandOutput output = reportOne(*reference);
        const QString file = paths.join(" + ");
        all.status = moreSevere(all.status, output.status);
        texts += output.text;
        for (Record &row : output.rows) {
            row.insert(row.begin(), {"file", file});
            all.rows.push_back(row);
        }
        output.json.insert("file", file);
        output.json.insert("columns", jsonColumns(reference->data.layout));
        if (paths.size() > 1) {
            output.json.insert("joined", QJsonArray::fromStringList(paths));
        }
        json += output.json;
    }
    if (json.isEmpty()) { // no file could be read: writes no output file
        return all.status;
    }
    texts.removeAll(QString());
    all.text = texts.join('\n');
    all.json.insert("files", json);
    return request.write(streams, all);
}

std::shared_ptr<const Reference> readTimedReference(const Streams &streams, const ReferenceSource &source,
                                                    const std::vector<ColumnChoice> &columns,
                                                    const Mechanism &mechanism)
{
    ReferenceOutcome outcome = readReference(source, {columns, {}}, Advice::Option);
    if (const auto *read = std::get_if<std::shared_ptr<const Reference>>(&outcome)) {
        outcome = timedBy(mechanism, *read);
    }
    if (const QString *message = std::get_if<QString>(&outcome)) {
        streams.report(*message);
        return nullptr;
    }
    const auto reference = std::get<std::shared_ptr<const Reference>>(outcome);
    for (const QString &doubt : doubtTexts(reference->data) + optionHints(reference->data)) {
        streams.report(displayName(reference->source.paths) + ": " + doubt);
    }
    return reference;
}

QString headline(const Reference &reference)
{
    const ReferenceData &data = reference.data;
    return CommandLine::tr("%1: %2, %n rows", nullptr, static_cast<int>(data.time.size()))
               .arg(displayName(reference.source.paths), abscissaText(data)) +
           '\n';
}

QJsonValue jsonFile(const FileLayout &layout, std::size_t file)
{
    return file < layout.files.size() ? QJsonValue(QString::fromUtf8(layout.files[file]))
                                      : QJsonValue(QJsonValue::Undefined);
}

QJsonValue jsonMechanism(bool exists, const Parameters &parameters)
{
    return exists ? QJsonValue(toJson(parameters)) : QJsonValue();
}

QJsonArray jsonConventions(const std::vector<ConventionFinding> &findings)
{
    return jsonList(findings, [](const ConventionFinding &finding) {
        const Convention &convention = finding.convention;
        const std::optional<QString> unit = amountUnit(convention);
        QStringList channels;
        for (const Channel channel : convention.channels) {
            channels += columnName(channel);
        }
        return QJsonObject{{"name", conventionName(convention.kind)},
                           {"channel", jsonText(channels.join(','))},
                           {"amount", unit ? QJsonValue(convention.amount) : QJsonValue()},
                           {"unit", jsonText(unit.value_or(QString()))},
                           {"explanation", explanationText(convention)},
                           {"standardError", jsonNumber(finding.standardError)},
                           {"before", jsonNumber(finding.before)},
                           {"after", jsonNumber(finding.after)}};
    });
}

const char *verdictName(Verdict verdict)
{
    switch (verdict) {
    case Verdict::Agrees: return "agrees";
    case Verdict::Close: return "close";
    case Verdict::Differs: break;
    }
    return "differs";
}

Record comparisonRecord(const ChannelComparison &channel)
{
    const auto timeOf = [](std::optional<double> value, double time) {
        return value ? jsonNumber(time) : QJsonValue();
    };
    return {{"name", columnName(channel.channel)},
            {"unit", unitText(channel.channel)},
            {"count", jsonNumber(channel.count)},
            {"maxAbs", jsonNumber(channel.largestError)},
            {"timeOfMaxAbs", timeOf(channel.largestError, channel.timeOfLargestError)},
            {"rms", jsonNumber(channel.rms)},
            {"maxPercent", jsonNumber(channel.maxPercent)},
            {"timeOfMaxPercent", timeOf(channel.maxPercent, channel.timeOfMaxPercent)},
            {"zeroReference", jsonNumber(channel.zeroReferenceCount)},
            {"percentOfPeak", jsonNumber(channel.percentOfPeak)},
            {"roundingStep", jsonNumber(channel.roundingStep)},
            {"verdict", verdictName(channel.verdict)}};
}

} // namespace slidercrank
