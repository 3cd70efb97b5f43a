// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/subcommands.h"

#include "app/comparison_text.h"
#include "app/diagnosis_json.h"
#include "app/json_text.h"
#include "app/output.h"
#include "app/shortfall.h"
#include "core/identification/diagnosis.h"
#include "ui/document/reference_file.h"
#include "ui/text/column_text.h"
#include "ui/text/diagnosis_text.h"
#include "ui/text/finding_text.h"
#include "ui/text/read_fault_text.h"

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

namespace slidercrank
{

namespace
{

/// One reference, held against the mechanism.
struct Compared {
    QString file;
    std::shared_ptr<const Reference> reference;
    std::vector<ChannelComparison> channels;
    std::optional<Diagnosis> diagnosis; ///< where it differs

    Verdict worstVerdict() const
    {
        const auto worst = std::ranges::max_element(channels, {}, &ChannelComparison::verdict);
        return worst == channels.end() ? Verdict::Differs : worst->verdict;
    }
};

/// Why the file differs; none where it does not.
QStringList explanationOf(const Compared &compared, const Mechanism &mechanism)
{
    return compared.diagnosis ? explanationLines(*compared.diagnosis, compared.reference->data, mechanism)
                              : QStringList();
}

QByteArray jsonExplanation(const Compared &compared, const Mechanism &mechanism)
{
    if (!compared.diagnosis) {
        return "null";
    }
    const Identification &found = compared.diagnosis->identification;
    return "{\"sentence\":" + jsonString(explanationOf(compared, mechanism).join(u' ')) +
           ",\"mechanism\":" + (found.stands() ? jsonMechanism(Mechanism(found.parameters)) : QByteArray("null")) +
           ",\"conventions\":" + jsonOf(compared.diagnosis->conventions, compared.reference->data) + '}';
}

QByteArray jsonOf(const Compared &compared, const Mechanism &mechanism)
{
    const InEnglish inEnglish;
    const ReferenceData &data = compared.reference->data;
    QByteArrayList skipped;
    for (const SkippedRow &row : data.skipped) {
        skipped += '{' + jsonFile(data.layout, row.file) + "\"line\":" + QByteArray::number(row.line) +
                   ",\"column\":" + QByteArray::number(row.column) +
                   ",\"text\":" + jsonString(QString::fromStdString(row.text)) +
                   ",\"reason\":" + jsonString(reasonOf(row)) + '}';
    }
    QByteArrayList ignored;
    for (const QString &heading : ignoredHeadings(data.layout)) {
        ignored += jsonString(heading);
    }
    return "{\"file\":" + jsonString(compared.file) + ',' + jsonJoined(compared.reference->paths) +
           "\"mechanism\":" + jsonMechanism(mechanism) + ",\"verdict\":\"" + wordOf(compared.worstVerdict()) +
           "\",\"channels\":" + jsonOf(compared.channels) + ",\"columns\":" + jsonColumns(data.layout) +
           ",\"explanation\":" + jsonExplanation(compared, mechanism) + ",\"skipped\":[" + skipped.join(',') +
           "],\"ignoredColumns\":[" + ignored.join(',') + "]}";
}

QString textOf(const Compared &compared, const Mechanism &mechanism)
{
    constexpr int kDigits = 9;
    QString text = headlineOf(compared.file, compared.reference->data);
    text += CommandLine::tr("Model: %1").arg(mechanismText(mechanism, kDigits)) + QStringLiteral("\n\n");
    text += tableOf(compared.channels, compared.reference->data) + u'\n' + summaryOf(compared.channels) + u'\n';
    for (const QString &line : explanationOf(compared, mechanism)) {
        text += line + u'\n';
    }
    return text;
}

QByteArray csvOf(const Compared &compared, const Mechanism &mechanism)
{
    const InEnglish inEnglish;
    return csvOf(compared.file, compared.channels, compared.worstVerdict(),
                 explanationOf(compared, mechanism).join(u' '));
}

QByteArray bytesOf(const Compared &compared, const CompareOptions &options)
{
    switch (options.format) {
    case Format::Text: return textOf(compared, options.mechanism).toUtf8();
    case Format::Csv: return csvOf(compared, options.mechanism);
    case Format::Json: return jsonOf(compared, options.mechanism);
    }
    return {};
}

PartedOutput outputOf(const CompareOptions &options)
{
    switch (options.format) {
    case Format::Text: return {options.output, {}, "\n"};
    case Format::Csv: return {options.output, csvHeader(), {}};
    case Format::Json: return {options.output, "{\"files\":[", ","};
    }
    return {options.output, {}, {}};
}

/// How many files agree, are close, differ; and how many could not be read.
class Tally
{
public:
    void add(Verdict verdict) { ++m_counts[static_cast<std::size_t>(verdict)]; }
    void addUnreadable() { ++m_unreadable; }

    QString sentence() const
    {
        const int all = m_counts[0] + m_counts[1] + m_counts[2] + m_unreadable;
        QString text = CommandLine::tr("%1 files: %2 agree, %3 come close, %4 differ")
                           .arg(all)
                           .arg(m_counts[0])
                           .arg(m_counts[1])
                           .arg(m_counts[2]);
        if (m_unreadable > 0) {
            text += CommandLine::tr(", %1 could not be read").arg(m_unreadable);
        }
        return text + u'.';
    }

private:
    std::array<int, 3> m_counts{}; ///< by Verdict
    int m_unreadable = 0;
};

} // namespace

ExitStatus compareFiles(const CompareOptions &options)
{
    const bool several = options.references.size() > 1;
    ExitStatus status = ExitStatus::Done;
    Tally tally;
    PartedOutput output = outputOf(options);
    for (const QStringList &files : options.references) {
        const QString file = joinedName(files);
        const std::variant<std::shared_ptr<const Reference>, QString> outcome =
            readTimed({files, {}, {}}, options.columns, options.mechanism);
        if (const QString *sentence = std::get_if<QString>(&outcome)) {
            say(*sentence);
            status = ExitStatus::FileFailed;
            tally.addUnreadable();
            continue;
        }
        Compared compared;
        compared.file = file;
        compared.reference = std::get<std::shared_ptr<const Reference>>(outcome);
        const ReferenceData &data = compared.reference->data;
        ExactComparison exact = compareExactly(options.mechanism, data);
        compared.channels = std::move(exact.channels);
        if (compared.worstVerdict() == Verdict::Differs) {
            compared.diagnosis = diagnose(data, options.mechanism);
        }
        if (!output.add(bytesOf(compared, options))) {
            return graver(status, output.finish({}));
        }
        warnOf(file, data);

        tally.add(compared.worstVerdict());
        Shortfall shortfall;
        shortfall.add(data.time, exact.status);
        const QString before = several ? shownNameOf(file) + QStringLiteral(": ") : QString();
        status = graver(status, shortfall.report(options.mechanism, SolverSettings().newton.maxIterations, before));
        if (options.failOnDifference && compared.diagnosis) {
            status = graver(status, ExitStatus::Differs);
        }
    }
    QByteArray tail;
    if (options.format == Format::Json) {
        tail = "]}\n";
    } else if (several && options.format == Format::Text) {
        tail = '\n' + tally.sentence().toUtf8() + '\n';
    }
    return graver(status, output.finish(tail));
}

} // namespace slidercrank
