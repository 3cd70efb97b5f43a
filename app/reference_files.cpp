// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/reference_files.h"

#include "app/output.h"
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

/// "3 files: 2 identified, 1 could not be read."
QString countedText(const std::map<QString, int> &counts, qsizetype fileCount)
{
    QStringList parts;
    for (const auto &[category, count] : counts) {
        parts += QStringLiteral("%1 %2").arg(count).arg(category);
    }
    return CommandLine::tr("%1 files: %2.").arg(QString::number(fileCount), parts.join(QStringLiteral(", ")));
}

QString columnMeaning(const FileColumn &column)
{
    switch (column.role) {
    case ColumnRole::Ignored: return {};
    case ColumnRole::Time: return "time";
    case ColumnRole::CrankAngle: return "crank-angle";
    case ColumnRole::Channel: return columnNameOf(column.channel);
    }
    return {};
}

/// By Convention::Kind.
constexpr std::array kConventionNames{"angle-unit", "length-unit", "time-unit",  "sign",            "half-turn", "whole-turns",
                                      "zero-point", "swapped-columns", "branch", "time-shift", "not-derivative", "axis"};

/// The unit of a convention's amount; nothing for a factor, or if there is no amount.
QString unitOfAmount(const Convention &convention)
{
    using Kind = Convention::Kind;
    if (convention.kind == Kind::ZeroPoint) {
        return unitOf(convention.channels.front());
    }
    const bool isAngle = convention.kind == Kind::HalfTurn || convention.kind == Kind::WholeTurns;
    return isAngle ? "°" : convention.kind == Kind::TimeShift ? "s" : "";
}

bool hasAmount(Convention::Kind kind)
{
    using Kind = Convention::Kind;
    return kind != Kind::SwappedColumns && kind != Kind::Branch && kind != Kind::NotDerivative && kind != Kind::Axis;
}

QJsonValue textOrNull(const QString &text)
{
    return text.isEmpty() ? QJsonValue() : QJsonValue(text);
}

std::optional<double> timeIfAny(std::optional<double> value, double time)
{
    return value ? std::optional(time) : std::nullopt;
}

} // namespace

ReferenceFiles readReferenceOptions(const OptionReader &options)
{
    ReferenceFiles references;
    references.format = readFormat(options, Format::Text);
    references.files = readReferenceFiles(options);
    references.columns = readColumns(options);
    references.output = readOutput(options, options.files());
    return references;
}

ExitStatus answerEach(const Streams &streams, const ReferenceFiles &references, const Mechanism &mechanism,
                      const QByteArray &csvHeading, const std::function<ReferenceAnswer(const Reference &)> &answer)
{
    ExitStatus status = ExitStatus::Success;
    std::map<QString, int> counts;
    QStringList texts;
    QByteArray csv;
    QJsonArray json;
    for (const QStringList &files : references.files) {
        const auto outcome = readTimedReference({files, {}, {}}, references.columns, mechanism);
        if (const QString *message = std::get_if<QString>(&outcome)) {
            streams.report(*message);
            status = moreSevere(status, ExitStatus::FileError);
            ++counts[CommandLine::tr("could not be read")];
            continue;
        }
        const Reference &reference = *std::get<std::shared_ptr<const Reference>>(outcome);
        reportDoubts(streams, reference);
        const ReferenceAnswer answered = answer(reference);
        status = moreSevere(status, answered.status);
        ++counts[answered.category];
        texts += answered.text;
        csv += answered.csv;
        json += answered.json;
    }
    if (json.isEmpty()) { // nothing could be read: no output file is made
        return status;
    }
    if (references.files.size() > 1) {
        texts += countedText(counts, references.files.size()) + u'\n';
    }
    texts.removeAll(QString());
    const QByteArray bytes = references.format == Format::Json  ? jsonText({{"files", json}})
                             : references.format == Format::Csv ? csvHeading + '\n' + csv
                                                                : texts.join(u'\n').toUtf8();
    return bytes.isEmpty() ? status : moreSevere(status, writeOutput(streams, references.output, bytes));
}

std::variant<std::shared_ptr<const Reference>, QString>
readTimedReference(const ReferenceSource &source, const std::vector<NamedChoice> &columns, const Mechanism &mechanism)
{
    const auto outcome = readReference(source, {}, {{}, {}, columns});
    const auto *reference = std::get_if<std::shared_ptr<const Reference>>(&outcome);
    return reference ? timedBy(mechanism, *reference) : outcome;
}

void reportDoubts(const Streams &streams, const Reference &reference)
{
    const QString name = displayName(joinedName(reference.paths));
    const ReferenceData &data = reference.data;
    if (!data.skipped.empty()) {
        const SkippedRow &first = data.skipped.front();
        streams.report(CommandLine::tr("%1: %2 rows could not be read and were skipped, the first in line %3, column %4 "
                                       "(\"%5\"): %6.")
                           .arg(name, QString::number(data.skippedRowCount()), lineText(data.layout, first),
                                QString::number(first.column), QString::fromStdString(first.text), reasonOf(first)));
    }
    QStringList ignored;
    for (const std::size_t i : ignoredColumns(data.layout)) {
        ignored += QStringLiteral("%1 (%2)").arg(headingText(data.layout, i), reasonText(data.layout, i));
    }
    if (!ignored.isEmpty()) {
        streams.report(
            CommandLine::tr("%1: these columns were not used: %2.").arg(name, ignored.join(QStringLiteral(", "))));
    }
    QStringList guesses;
    for (std::size_t i = 0; i < data.layout.columns.size(); ++i) {
        const FileColumn &column = data.layout.columns[i];
        if (column.role != ColumnRole::Ignored && isGuess(column.reason)) {
            guesses += CommandLine::tr("\"%1\" as %2 (%3)")
                           .arg(headingText(data.layout, i), columnMeaning(column), reasonText(data.layout, i));
        }
    }
    if (!guesses.isEmpty()) {
        streams.report(CommandLine::tr("%1: the meaning of these columns was guessed: %2. Correct it with --column.")
                           .arg(name, guesses.join(QStringLiteral(", "))));
    }
}

QString joinedName(const QStringList &files)
{
    return files.join(QStringLiteral(" + "));
}

QString headline(const Reference &reference)
{
    const ReferenceData &data = reference.data;
    const QString name = displayName(joinedName(reference.paths));
    const auto number = [](double value) { return roundedText(value, 9); };
    if (data.crank) {
        return CommandLine::tr("%1: θ₂ = %3° to %4°, %2 angles, timed by ω₂ = %5 rad/s and θ₂₀ = %6°")
                   .arg(name, QString::number(data.time.size()), number(data.crank->degrees.front()),
                        number(data.crank->degrees.back()), number(data.crank->omega2),
                        number(data.crank->theta20 * kDegreesPerRadian)) +
               u'\n';
    }
    return CommandLine::tr("%1: t = %3 s to %4 s, %2 time stamps")
               .arg(name, QString::number(data.time.size()), number(data.time.front()), number(data.time.back())) +
           u'\n';
}

QJsonObject jsonFileMembers(const Reference &reference)
{
    QJsonObject members{{"file", joinedName(reference.paths)}};
    if (reference.paths.size() > 1) {
        members.insert("joined", QJsonArray::fromStringList(reference.paths));
    }
    return members;
}

QJsonArray jsonColumns(const FileLayout &layout)
{
    QJsonArray columns;
    for (std::size_t i = 0; i < layout.columns.size(); ++i) {
        const FileColumn &column = layout.columns[i];
        QJsonObject object{{"heading", textOrNull(QString::fromUtf8(column.heading))},
                           {"unit", textOrNull(QString::fromUtf8(column.unit))},
                           {"channel", textOrNull(columnMeaning(column))},
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
    QJsonArray conventions;
    for (const ConventionFinding &finding : findings) {
        const Convention &convention = finding.convention;
        QStringList channels;
        for (const Channel channel : convention.channels) {
            channels += columnNameOf(channel);
        }
        conventions += QJsonObject{
            {"name", kConventionNames[static_cast<std::size_t>(convention.kind)]},
            {"channel", textOrNull(channels.join(u','))},
            {"amount", hasAmount(convention.kind) ? QJsonValue(convention.amount) : QJsonValue()},
            {"unit", textOrNull(unitOfAmount(convention))},
            {"explanation", explanationOf(convention, data)},
            {"standardError", jsonNumber(finding.standardError)},
            {"before", jsonNumber(finding.before)},
            {"after", jsonNumber(finding.after)}};
    }
    return conventions;
}

QString verdictName(Verdict verdict)
{
    constexpr std::array kNames{"agrees", "close", "differs"};
    return QString::fromLatin1(kNames[static_cast<std::size_t>(verdict)]);
}

Fields<ChannelComparison> comparisonFields(const ReferenceData &data)
{
    using Row = ChannelComparison;
    const std::optional<CrankAngles> crank = data.crank;
    const QString where = crank ? CommandLine::tr("at θ₂ [°]") : CommandLine::tr("at t [s]");
    const auto place = [crank](std::optional<double> value, double time) {
        const double shown = crank ? (crank->omega2 * time + crank->theta20) * kDegreesPerRadian : time;
        return roundedText(timeIfAny(value, shown), 6);
    };
    return {
        {"name", [](const Row &row) { return columnNameOf(row.channel); }, CommandLine::tr("channel")},
        {"unit", [](const Row &row) { return unitOf(row.channel); }, CommandLine::tr("unit")},
        {"count", [](const Row &row) { return static_cast<double>(row.count); }},
        {"maxAbs", [](const Row &row) { return jsonNumber(row.maxAbs); }, CommandLine::tr("largest error")},
        {"timeOfMaxAbs", [](const Row &row) { return jsonNumber(timeIfAny(row.maxAbs, row.timeOfMaxAbs)); }, where,
         [place](const Row &row) { return place(row.maxAbs, row.timeOfMaxAbs); }},
        {"rms", [](const Row &row) { return jsonNumber(row.rms); }, CommandLine::tr("rms")},
        {"maxPercent", [](const Row &row) { return jsonNumber(row.maxPercent); }, CommandLine::tr("largest %")},
        {"timeOfMaxPercent", [](const Row &row) { return jsonNumber(timeIfAny(row.maxPercent, row.timeOfMaxPercent)); },
         where, [place](const Row &row) { return place(row.maxPercent, row.timeOfMaxPercent); }},
        {"zeroReference", [](const Row &row) { return static_cast<double>(row.zeroReference); }, CommandLine::tr("zeros")},
        {"percentOfPeak", [](const Row &row) { return jsonNumber(row.percentOfPeak); }, CommandLine::tr("% of peak")},
        {"roundingStep", [](const Row &row) { return jsonNumber(row.roundingStep); }, CommandLine::tr("rounding step")},
        {"verdict", [](const Row &row) { return verdictName(row.verdict); }, CommandLine::tr("verdict"),
         [](const Row &row) { return verdictText(row); }},
    };
}

QJsonArray jsonComparisons(const std::vector<ChannelComparison> &channels, const ReferenceData &data)
{
    QJsonArray comparisons;
    const Fields<ChannelComparison> fields = comparisonFields(data);
    for (const ChannelComparison &channel : channels) {
        comparisons += jsonRecord(fields, channel);
    }
    return comparisons;
}

} // namespace slidercrank
