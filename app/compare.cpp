// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/subcommands.h"

#include "app/comparison_text.h"
#include "app/diagnosis_json.h"
#include "app/json_text.h"
#include "app/output.h"
#include "app/shortfall.h"
#include "core/diagnosis/diagnosis.h"
#include "ui/document/reference_file.h"
#include "ui/words/column_text.h"
#include "ui/words/diagnosis_text.h"
#include "ui/words/finding_text.h"
#include "ui/words/read_fault_text.h"

#include <QDir>

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

/// One file, held against the mechanism.
struct Compared {
    QString file;
    std::shared_ptr<const Reference> reference;
    std::vector<ChannelComparison> channels;

    bool differs() const { return worstVerdict() == Verdict::Differs; }
    Verdict worstVerdict() const
    {
        const auto worst = std::ranges::max_element(channels, {}, &ChannelComparison::verdict);
        return worst == channels.end() ? Verdict::Differs : worst->verdict;
    }
};

/// Why the file differs; null where it does not.
QByteArray jsonExplanation(const Compared &compared, const Mechanism &mechanism)
{
    if (!compared.differs()) {
        return "null";
    }
    const ReferenceData &data = compared.reference->data;
    const Diagnosis diagnosis = diagnose(data, mechanism);
    const Identification &found = diagnosis.identification;
    return "{\"sentence\":" + jsonString(explanationLines(diagnosis, data, mechanism).join(u' ')) +
           ",\"mechanism\":" + (found.stands() ? jsonMechanism(Mechanism(found.parameters)) : QByteArray("null")) +
           ",\"conventions\":" + jsonOf(diagnosis.conventions, data) + '}';
}

QByteArray jsonOf(const Compared &compared, const Mechanism &mechanism)
{
    const InEnglish inEnglish;
    const ReferenceData &data = compared.reference->data;
    QByteArrayList skipped;
    for (const SkippedRow &row : data.skipped) {
        skipped += "{\"line\":" + QByteArray::number(row.line) + ",\"column\":" + QByteArray::number(row.column) +
                   ",\"text\":" + jsonString(QString::fromStdString(row.text)) +
                   ",\"reason\":" + jsonString(reasonOf(row)) + '}';
    }
    QByteArrayList ignored;
    for (const FileColumn &column : data.layout.columns) {
        if (column.role == ColumnRole::Ignored) {
            const auto number = std::to_string(&column - data.layout.columns.data() + 1);
            ignored += jsonString(QString::fromUtf8(column.heading.empty() ? "column " + number : column.heading));
        }
    }
    return "{\"file\":" + jsonString(compared.file) + ",\"mechanism\":" + jsonMechanism(mechanism) + ",\"verdict\":\"" +
           wordOf(compared.worstVerdict()) + "\",\"channels\":" + jsonOf(compared.channels) +
           ",\"columns\":" + jsonColumns(data.layout) + ",\"explanation\":" + jsonExplanation(compared, mechanism) +
           ",\"skipped\":[" + skipped.join(',') + "],\"ignoredColumns\":[" + ignored.join(',') + "]}";
}

QString textOf(const Compared &compared, const Mechanism &mechanism)
{
    const auto number = [](double value) { return QString::number(value, 'g', 9); };
    QString text = headlineOf(compared.file, compared.reference->data);
    text += CommandLine::tr("Model: a = %1 mm, b = %2 mm, c = %3 mm, ω2 = %4 rad/s, θ20 = %5 rad, %6")
                .arg(number(mechanism.a()), number(mechanism.b()), number(mechanism.c()), number(mechanism.omega2()),
                     number(mechanism.theta20()), assemblyText(mechanism.branch())) +
            QStringLiteral("\n\n");
    text += tableOf(compared.channels) + u'\n' + summaryOf(compared.channels) + u'\n';
    if (compared.differs()) {
        const ReferenceData &data = compared.reference->data;
        text += explanationLines(diagnose(data, mechanism), data, mechanism).join(u'\n') + u'\n';
    }
    return text;
}

/// What goes before the first file, between two, and after the last.
struct Frame {
    QByteArray head;
    QByteArray between;
    QByteArray tail;
};

Frame frameOf(Format format)
{
    switch (format) {
    case Format::Text: return {{}, "\n", {}};
    case Format::Csv: return {csvHeader(), {}, {}};
    case Format::Json: return {"{\"files\":[", ",", "]}\n"};
    }
    return {};
}

QByteArray bytesOf(const Compared &compared, const CompareOptions &options)
{
    switch (options.format) {
    case Format::Text: return textOf(compared, options.mechanism).toUtf8();
    case Format::Csv: return csvOf(compared.file, compared.channels);
    case Format::Json: return jsonOf(compared, options.mechanism);
    }
    return {};
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

/// Of several, a failed file comes first, then the order of their numbers from NotAssemblable on, then Differs.
ExitStatus graver(ExitStatus x, ExitStatus y)
{
    for (const ExitStatus status :
         {ExitStatus::FileFailed, ExitStatus::NotAssemblable, ExitStatus::NotSolved, ExitStatus::Differs}) {
        if (x == status || y == status) {
            return status;
        }
    }
    return ExitStatus::Done;
}

} // namespace

ExitStatus compareFiles(const CompareOptions &options)
{
    const bool several = options.files.size() > 1;
    const Frame frame = frameOf(options.format);
    ExitStatus status = ExitStatus::Done;
    Tally tally;
    Output output(options.output);
    bool isOpen = false;
    for (const QString &file : options.files) {
        const std::variant<std::shared_ptr<const Reference>, QString> outcome = readReference(file);
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

        // Opened late: where no file can be read, none is written.
        if (!isOpen) {
            if (!output.open()) {
                return ExitStatus::FileFailed;
            }
            output.write(frame.head);
            isOpen = true;
        } else {
            output.write(frame.between);
        }
        output.write(bytesOf(compared, options));
        warnOf(file, data);

        tally.add(compared.worstVerdict());
        Shortfall shortfall;
        shortfall.add(data.time, exact.status);
        const QString before = several ? QDir::toNativeSeparators(file) + QStringLiteral(": ") : QString();
        status = graver(status, shortfall.report(options.mechanism, SolverSettings().newton.maxIterations, before));
        if (options.failOnDifference && compared.differs()) {
            status = graver(status, ExitStatus::Differs);
        }
    }
    if (!isOpen) {
        return status;
    }
    output.write(frame.tail);
    if (several && options.format == Format::Text) {
        output.write('\n' + tally.sentence().toUtf8() + '\n');
    }
    return graver(status, output.finish());
}

} // namespace slidercrank
