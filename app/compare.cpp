// SPDX-License-Identifier: GPL-3.0-or-later

// `slidercrank compare`: prints how far reference files are from the model.

#include "app/commands.h"
#include "app/reference_files.h"
#include "app/time_step_report.h"
#include "core/identification/identification.h"
#include "ui/document/settings_fields.h"
#include "ui/text/column_text.h"
#include "ui/text/comparison_text.h"
#include "ui/text/explanation.h"
#include "ui/text/parameter_text.h"
#include "ui/text/read_fault_text.h"

#include <algorithm>

namespace slidercrank
{

namespace
{

QJsonArray jsonSkippedRows(const ReferenceData &data)
{
    return jsonList(data.skipped, [&data](const SkippedRow &row) {
        return QJsonObject{{"line", jsonNumber(row.line)},
                           {"column", jsonNumber(row.column)},
                           {"text", QString::fromStdString(row.text)},
                           {"reason", rowFaultText(row)},
                           {"file", jsonFile(data.layout, row.file)}};
    });
}

/// Compares one reference with the mechanism, whose motion at the time stamps of the file is computed by `solver`.
CommandOutput compareOne(const Mechanism &mechanism, const SolverSettings &solver, const Reference &reference,
                         const Streams &streams)
{
    const ReferenceData &data = reference.data;
    const Trajectory model = sample(mechanism, data.time, channelsOf(data), solver);
    std::vector<ChannelComparison> comparison = compare(mechanism, model, data);
    findRoundedTime(comparison, mechanism, model, data);
    const auto worst = std::ranges::max_element(comparison, {}, &ChannelComparison::verdict);
    const Verdict verdict = worst == comparison.end() ? Verdict::Differs : worst->verdict;

    CommandOutput output;
    QStringList explanation;
    QJsonValue jsonExplanation;
    if (verdict == Verdict::Differs) {
        const Identification found = identify(data, mechanism);
        explanation = textsOf(explainDifferences(found, mechanism.parameters(), data.layout));
        jsonExplanation = QJsonObject{{"sentence", explanation.join(' ')},
                                      {"mechanism", jsonMechanism(found.hasMechanism(), found.parameters)},
                                      {"conventions", jsonConventions(found.conventions)}};
    }
    QJsonArray channels;
    for (const ChannelComparison &channel : comparison) {
        Record row = comparisonRecord(channel);
        channels += jsonObject(row);
        row.insert(row.end(), {{"fileVerdict", verdictName(verdict)}, {"sentence", explanation.join(' ')}});
        output.rows.push_back(row);
    }
    output.json = {{"mechanism", toJson(mechanism.parameters())},
                   {"verdict", verdictName(verdict)},
                   {"channels", channels},
                   {"explanation", jsonExplanation},
                   {"skipped", jsonSkippedRows(data)},
                   {"ignoredColumns", QJsonArray::fromStringList(ignoredHeadings(data.layout))}};
    const QString text = headline(reference) +
                         CommandLine::tr("Model: %1").arg(mechanismText(mechanism, kMechanismDigits)) + "\n\n" +
                         alignedTable(comparisonTable(comparison, data)) + '\n' + summaryText(comparison);
    output.text = (QStringList(text) + explanation).join('\n') + '\n';
    output.status = moreSevere(
        reportTimeSteps(streams, model.summary, mechanism, solver.newton, displayName(reference.source.paths) + ": "),
        verdict == Verdict::Differs ? ExitStatus::Differs : ExitStatus::Success);
    return output;
}

} // namespace

ExitStatus compareCommand(const OptionReader &options, const Streams &streams)
{
    const ReferenceRequest references(options);
    const SolverSettings solver = readSolver(options);
    const ExitStatus status = references.reportEach(streams, [&](const Reference &reference) {
        return compareOne(references.request.mechanism, solver, reference, streams);
    });
    return status == ExitStatus::Differs && !options.has("fail-on-difference") ? ExitStatus::Success : status;
}

} // namespace slidercrank
