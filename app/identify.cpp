// SPDX-License-Identifier: GPL-3.0-or-later

// `slidercrank identify`: the mechanism that each reference file belongs to.

#include "app/commands.h"
#include "app/reference_files.h"
#include "core/identification/diagnosis.h"
#include "core/import/crank_angles.h"
#include "ui/text/convention_text.h"
#include "ui/text/diagnosis_text.h"
#include "ui/text/finding_text.h"

#include <QLocale>

#include <array>

namespace slidercrank
{

namespace
{

using Outcome = Identification::Outcome;

struct IdentifyRequest {
    Mechanism mechanism; ///< supplies what a file does not determine
    ReferenceFiles references;
};

/// By Identification::Outcome.
constexpr std::array kOutcomeNames{"identified", "ambiguous", "approximate", "insufficient", "nearest", "none"};

/// By Identification::Alternative::Why.
constexpr std::array kAlternativeNames{"mirror-image", "reversed", "other-assembly", "alias", "another-mechanism"};

QString outcomeText(Outcome outcome)
{
    switch (outcome) {
    case Outcome::Identified: return CommandLine::tr("identified");
    case Outcome::Approximate: return CommandLine::tr("approximate");
    case Outcome::Ambiguous: return CommandLine::tr("ambiguous");
    case Outcome::Insufficient:
    case Outcome::Nearest:
    case Outcome::None: return CommandLine::tr("not identified");
    }
    return {};
}

QJsonObject jsonIdentification(const Reference &reference, const Diagnosis &diagnosis)
{
    const Identification &found = diagnosis.identification;
    const bool hasMechanism = found.stands() || found.outcome == Outcome::Nearest;
    QJsonObject standardErrors, identifiable, noise;
    for (const Parameter parameter : kParameters) {
        const std::size_t i = indexOf(parameter);
        const QLatin1String name(wordOf(parameter));
        standardErrors.insert(name, found.identifiable[i] ? jsonNumber(found.standardError[i]) : QJsonValue());
        identifiable.insert(name, found.identifiable[i]);
    }
    for (const Identification::Noise &column : found.noise) {
        noise.insert(columnNameOf(column.channel), jsonNumber(column.rms));
    }
    QJsonArray alternatives, leftOut, excludedRows;
    for (const Identification::Alternative &alternative : found.alternatives) {
        alternatives += QJsonObject{{"mechanism", jsonMechanism(alternative.parameters)},
                                    {"why", kAlternativeNames[static_cast<std::size_t>(alternative.why)]}};
    }
    for (const auto &column : found.leftOut) {
        leftOut += QJsonObject{{"channel", columnNameOf(column.channel)},
                               {"percentOfPeak", jsonNumber(column.percentOfPeak)}};
    }
    for (const std::size_t line : found.excludedRows) {
        excludedRows += static_cast<double>(line);
    }
    QJsonObject object = jsonFileMembers(reference);
    object.insert("outcome", kOutcomeNames[static_cast<std::size_t>(found.outcome)]);
    object.insert("mechanism", hasMechanism ? QJsonValue(jsonMechanism(found.parameters)) : QJsonValue());
    object.insert("standardError", standardErrors);
    object.insert("identifiable", identifiable);
    object.insert("alternatives", alternatives);
    object.insert("rounded",
                  found.outcome == Outcome::Identified ? QJsonValue(jsonMechanism(diagnosis.rounded)) : QJsonValue());
    object.insert("noise", noise);
    object.insert("iterations", found.iterations);
    object.insert("conditionNumber", found.stands() ? jsonNumber(found.conditionNumber) : QJsonValue());
    object.insert("channels", jsonComparisons(diagnosis.identified, reference.data));
    object.insert("columns", jsonColumns(reference.data.layout));
    object.insert("conventions", jsonConventions(diagnosis.conventions, reference.data));
    object.insert("leftOut", leftOut);
    object.insert("excludedRows", excludedRows);
    object.insert("summary", summaryOf(diagnosis));
    return object;
}

/// "--a 20 --b …": options for the next command.
QString optionsFor(const Parameters &parameters)
{
    QString text;
    for (const Parameter parameter : kParameters) {
        text += QStringLiteral("--%1 %2%3 ")
                    .arg(QLatin1String(wordOf(parameter)),
                         QString::number(valueOf(parameters, parameter), 'g', QLocale::FloatingPointShortest),
                         parameter == Parameter::Theta20 ? QStringLiteral("rad") : QString());
    }
    return text + (parameters.branch == Branch::Open ? QStringLiteral("--branch open") : QStringLiteral("--branch crossed"));
}

QString identificationText(const Reference &reference, const Diagnosis &diagnosis)
{
    const Identification &found = diagnosis.identification;
    const ReferenceData &data = reference.data;
    if (!found.stands()) {
        return headline(reference) + summaryOf(diagnosis) + u'\n';
    }
    QStringList lines{headline(reference).trimmed()};
    for (const ConventionFinding &finding : diagnosis.conventions) {
        lines += explanationOf(finding.convention, data) + u' ' + effectOf(finding);
    }
    lines += summaryOf(diagnosis);
    if (found.outcome != Outcome::Approximate) {
        lines += CommandLine::tr("± one standard deviation; %1 iterations, condition number %2.")
                     .arg(QString::number(found.iterations), roundedText(found.conditionNumber));
    }
    const std::optional<ReferenceData> timed =
        data.crank ? timedBy(Mechanism(found.parameters), data) : std::nullopt; // the data that were compared
    lines += u'\n' + recordTable(comparisonFields(timed ? *timed : data), diagnosis.identified);
    if (found.noise.empty()) { // otherwise the summary has named the noise
        lines += summaryOf(diagnosis.identified);
    }
    lines += roundNumbersText(diagnosis);
    lines += (found.outcome == Outcome::Ambiguous ? CommandLine::tr("Options for the first of them: %1")
                                                  : CommandLine::tr("Options for this mechanism: %1"))
                 .arg(optionsFor(diagnosis.rounded));
    lines.removeAll(QString());
    return lines.join(u'\n') + u'\n';
}

ReferenceAnswer identifyOne(const Streams &streams, const IdentifyRequest &request, const Reference &reference)
{
    const Diagnosis diagnosis = diagnose(reference.data, request.mechanism);
    const bool isFound = diagnosis.identification.stands();
    const bool isText = request.references.format == Format::Text;
    ReferenceAnswer answer;
    answer.category = outcomeText(diagnosis.identification.outcome);
    answer.status = isFound ? ExitStatus::Success : ExitStatus::NotSolved;
    if (!isFound && (!isText || request.references.files.size() == 1)) {
        streams.report(QStringLiteral("%1: %2").arg(displayName(joinedName(reference.paths)), summaryOf(diagnosis)));
    } else if (isText) {
        answer.text = identificationText(reference, diagnosis);
    }
    const EnglishTexts english(!isText);
    answer.json = jsonIdentification(reference, diagnosis);
    return answer;
}

} // namespace

Command prepareIdentify(OptionReader &options)
{
    const IdentifyRequest request{readMechanism(options), readReferenceOptions(options)};
    Command command;
    command.run = [request](const Streams &streams) {
        return answerEach(streams, request.references, request.mechanism, {},
                          [&](const Reference &reference) { return identifyOne(streams, request, reference); });
    };
    return command;
}

} // namespace slidercrank
