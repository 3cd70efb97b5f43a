// SPDX-License-Identifier: GPL-3.0-or-later

// `slidercrank identify`: finds the mechanism that each reference file belongs to.

#include "app/commands.h"
#include "app/reference_files.h"
#include "core/identification/diagnosis.h"
#include "core/import/crank_angles.h"
#include "ui/document/settings_fields.h"
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

/// Names in JSON, by Identification::Outcome.
constexpr std::array kOutcomeNames{"identified", "ambiguous", "approximate", "insufficient", "nearest", "none"};

/// Names in JSON, by Identification::Alternative::Why.
constexpr std::array kAlternativeNames{"mirror-image", "reversed", "other-assembly", "alias", "another-mechanism"};

QJsonObject jsonIdentification(const Diagnosis &diagnosis)
{
    const Identification &found = diagnosis.identification;
    QJsonObject standardErrors, identifiable, noise;
    for (const Parameter parameter : kAllParameters) {
        const std::size_t i = indexOf(parameter);
        const QLatin1String name(optionName(parameter));
        standardErrors.insert(name, jsonNumber(found.standardError[i]));
        identifiable.insert(name, found.identifiable[i]);
    }
    for (const Identification::Noise &column : found.noise) {
        noise.insert(columnName(column.channel), jsonNumber(column.rms));
    }
    const auto jsonAlternative = [](const Identification::Alternative &alternative) {
        return QJsonObject{{"mechanism", toJson(alternative.parameters)},
                           {"why", kAlternativeNames[static_cast<std::size_t>(alternative.why)]}};
    };
    const auto jsonLeftOut = [](const auto &column) {
        return QJsonObject{{"channel", columnName(column.channel)},
                           {"percentOfPeak", jsonNumber(column.percentOfPeak)}};
    };
    const auto jsonComparison = [](const ChannelComparison &channel) { return jsonObject(comparisonRecord(channel)); };
    return {{"outcome", kOutcomeNames[static_cast<std::size_t>(found.outcome)]},
            {"mechanism", jsonMechanism(found.hasMechanism() || found.outcome == Outcome::Nearest, found.parameters)},
            {"standardError", standardErrors},
            {"identifiable", identifiable},
            {"alternatives", jsonList(found.alternatives, jsonAlternative)},
            {"rounded", jsonMechanism(found.outcome == Outcome::Identified, diagnosis.rounded)},
            {"noise", noise},
            {"iterations", found.iterations},
            {"conditionNumber", found.hasMechanism() ? jsonNumber(found.conditionNumber) : QJsonValue()},
            {"channels", jsonList(diagnosis.identified, jsonComparison)},
            {"conventions", jsonConventions(diagnosis.conventions)},
            {"leftOut", jsonList(found.leftOut, jsonLeftOut)},
            {"excludedRows", jsonList(found.excludedRows, jsonNumber)},
            {"summary", summaryText(diagnosis)}};
}

/// The options of the mechanism for another command: "--a 20 --b …".
QString optionsFor(const Parameters &parameters)
{
    QString text;
    for (const Parameter parameter : kAllParameters) {
        text += QString("--%1 %2%3 ")
                    .arg(optionName(parameter),
                         QString::number(valueOf(parameters, parameter), 'g', QLocale::FloatingPointShortest),
                         parameter == Parameter::Theta20 ? "rad" : "");
    }
    return text + (parameters.branch == Branch::Open ? "--branch open" : "--branch crossed");
}

/// Describes an identification that found a mechanism.
QString identificationText(const Reference &reference, const Diagnosis &diagnosis)
{
    const Identification &found = diagnosis.identification;
    const ReferenceData &data = reference.data;
    QStringList lines{headline(reference).trimmed()};
    for (const ConventionFinding &finding : diagnosis.conventions) {
        lines += findingText(finding);
    }
    lines += summaryText(diagnosis);
    const std::optional<ReferenceData> timed = data.crank ? timedBy(Mechanism(found.parameters), data) : std::nullopt;
    lines += '\n' + alignedTable(comparisonTable(diagnosis.identified, timed ? *timed : data));
    if (found.noise.empty()) { // otherwise the summary reports the noise
        lines += summaryText(diagnosis.identified);
    }
    lines += CommandLine::tr("As options: %1").arg(optionsFor(diagnosis.rounded));
    lines.removeAll(QString());
    return lines.join('\n') + '\n';
}

Answer identifyOne(const ReferenceQuestion &question, const Reference &reference, const Streams &streams)
{
    const Diagnosis diagnosis = diagnose(reference.data, question.mechanism);
    const bool isFound = diagnosis.identification.hasMechanism();
    Answer answer;
    answer.json = jsonIdentification(diagnosis);
    if (isFound) {
        answer.text = identificationText(reference, diagnosis);
    } else {
        answer.status = ExitStatus::NotSolved;
        streams.report(displayName(reference.paths) + ": " + summaryText(diagnosis));
    }
    return answer;
}

} // namespace

ExitStatus identifyCommand(const OptionReader &options, const Streams &streams)
{
    const ReferenceQuestion question(options);
    return question.answerEach(streams,
                               [&](const Reference &reference) { return identifyOne(question, reference, streams); });
}

} // namespace slidercrank
