// SPDX-License-Identifier: GPL-3.0-or-later

// `slidercrank compare`: how far reference files are from the model.

#include "app/commands.h"
#include "app/reference_files.h"
#include "app/time_step_report.h"
#include "core/identification/diagnosis.h"
#include "ui/text/column_text.h"
#include "ui/text/diagnosis_text.h"
#include "ui/text/finding_text.h"
#include "ui/text/read_fault_text.h"

#include <algorithm>

namespace slidercrank
{

namespace
{

struct CompareRequest {
    Mechanism mechanism;
    SolverSettings solver;
    ReferenceFiles references;
    bool failsOnDifference = false;
};

QJsonArray jsonSkippedRows(const ReferenceData &data)
{
    QJsonArray rows;
    for (const SkippedRow &row : data.skipped) {
        QJsonObject object{{"line", static_cast<double>(row.line)},
                           {"column", static_cast<double>(row.column)},
                           {"text", QString::fromStdString(row.text)},
                           {"reason", reasonOf(row)}};
        if (row.file < data.layout.files.size()) {
            object.insert("file", QString::fromUtf8(data.layout.files[row.file]));
        }
        rows += object;
    }
    return rows;
}

/// The model by the chosen method, at the file's own time stamps.
ExactComparison compareByMethod(const CompareRequest &request, const ReferenceData &data)
{
    if (request.solver.method == Method::ClosedForm) {
        return compareExactly(request.mechanism, data);
    }
    const Trajectory model = sample(request.mechanism, data.time, channelsOf(data), request.solver);
    return {compare(request.mechanism, model, data), model.status};
}

/// One reference, compared with the model.
struct Compared {
    const CompareRequest &request;
    const Reference &reference;
    ExactComparison comparison;
    Verdict verdict = Verdict::Differs;
    std::optional<Diagnosis> diagnosis; ///< if it differs

    Compared(const CompareRequest &compareRequest, const Reference &file)
        : request(compareRequest)
        , reference(file)
        , comparison(compareByMethod(request, reference.data))
    {
        const auto worst = std::ranges::max_element(comparison.channels, {}, &ChannelComparison::verdict);
        verdict = worst == comparison.channels.end() ? Verdict::Differs : worst->verdict;
        if (verdict == Verdict::Differs) {
            diagnosis = diagnose(reference.data, request.mechanism);
        }
    }

    QStringList explanation() const
    {
        return diagnosis ? explanationLines(*diagnosis, reference.data, request.mechanism) : QStringList();
    }

    QString text() const
    {
        QString text = headline(reference);
        text += CommandLine::tr("Model: %1").arg(mechanismText(request.mechanism, 9)) + QStringLiteral("\n\n");
        text += recordTable(comparisonFields(reference.data), comparison.channels) + u'\n' + summaryOf(comparison.channels);
        return (QStringList(text) + explanation()).join(u'\n') + u'\n';
    }

    QJsonObject json() const
    {
        QJsonValue explanationObject;
        if (diagnosis) {
            const Identification &found = diagnosis->identification;
            explanationObject = QJsonObject{
                {"sentence", explanation().join(u' ')},
                {"mechanism", found.stands() ? QJsonValue(jsonMechanism(found.parameters)) : QJsonValue()},
                {"conventions", jsonConventions(diagnosis->conventions, reference.data)}};
        }
        QJsonObject object = jsonFileMembers(reference);
        object.insert("mechanism", jsonMechanism(request.mechanism.parameters()));
        object.insert("verdict", verdictName(verdict));
        object.insert("channels", jsonComparisons(comparison.channels, reference.data));
        object.insert("columns", jsonColumns(reference.data.layout));
        object.insert("explanation", explanationObject);
        object.insert("skipped", jsonSkippedRows(reference.data));
        object.insert("ignoredColumns", QJsonArray::fromStringList(ignoredHeadings(reference.data.layout)));
        return object;
    }

    QByteArray csv() const
    {
        QByteArray rows;
        const Fields<ChannelComparison> fields = comparisonFields(reference.data);
        for (const ChannelComparison &channel : comparison.channels) {
            rows += QByteArrayList{csvCell(joinedName(reference.paths)), csvRecord(fields, channel),
                                   csvCell(verdictName(verdict)), csvCell(explanation().join(u' '))}
                        .join(',') +
                    '\n';
        }
        return rows;
    }
};

ReferenceAnswer compareOne(const Streams &streams, const CompareRequest &request, const Reference &reference)
{
    const Compared compared(request, reference);
    ReferenceAnswer answer;
    const EnglishTexts english(request.references.format != Format::Text);
    switch (request.references.format) {
    case Format::Text: answer.text = compared.text(); break;
    case Format::Csv: answer.csv = compared.csv(); break;
    case Format::Json: break;
    }
    answer.json = compared.json();
    answer.category = compared.verdict == Verdict::Agrees  ? CommandLine::tr("agree")
                      : compared.verdict == Verdict::Close ? CommandLine::tr("close")
                                                           : CommandLine::tr("differ");
    TimeStepReport steps;
    steps.add(reference.data.time, compared.comparison.status);
    const bool isOneOfSeveral = request.references.files.size() > 1;
    answer.status = steps.finish(streams, request.mechanism, request.solver.newton,
                                 isOneOfSeveral ? displayName(joinedName(reference.paths)) + QStringLiteral(": ") : QString());
    if (request.failsOnDifference && compared.verdict == Verdict::Differs) {
        answer.status = moreSevere(answer.status, ExitStatus::Differs);
    }
    return answer;
}

} // namespace

Command prepareCompare(OptionReader &options)
{
    CompareRequest request{readMechanism(options), readSolver(options), readReferenceOptions(options),
                           options.has("fail-on-difference")};
    Command command;
    command.run = [request](const Streams &streams) {
        const QByteArray heading = "file," + csvHeading(comparisonFields({})) + ",fileVerdict,sentence";
        return answerEach(streams, request.references, request.mechanism, heading,
                          [&](const Reference &reference) { return compareOne(streams, request, reference); });
    };
    return command;
}

} // namespace slidercrank
