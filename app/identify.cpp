// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/subcommands.h"

#include "app/comparison_text.h"
#include "app/diagnosis_json.h"
#include "app/json_text.h"
#include "app/output.h"
#include "core/diagnosis/diagnosis.h"
#include "ui/document/reference_file.h"
#include "ui/words/convention_text.h"
#include "ui/words/diagnosis_text.h"
#include "ui/words/finding_text.h"

#include <QDir>
#include <QLocale>

#include <memory>
#include <optional>
#include <variant>

namespace slidercrank
{

namespace
{

using Outcome = Identification::Outcome;

/// What was not found is null; what comes nearest is the mechanism only under that name.
QByteArray jsonOf(const QString &file, const ReferenceData &data, const Diagnosis &diagnosis)
{
    const InEnglish inEnglish;
    const Identification &found = diagnosis.identification;
    const bool isMechanism = found.stands() || found.outcome == Outcome::Nearest;
    const QByteArray none("null");
    QByteArrayList errors;
    QByteArrayList identifiable;
    for (const Parameter parameter : kParameters) {
        const std::size_t i = indexOf(parameter);
        const QByteArray name = '"' + QByteArray(wordOf(parameter)) + "\":";
        errors += name + (found.identifiable[i] ? jsonNumber(found.standardError[i]) : none);
        identifiable += name + (found.identifiable[i] ? "true" : "false");
    }
    return "{\"file\":" + jsonString(file) + ",\"outcome\":\"" + wordOf(found.outcome) +
           "\",\"mechanism\":" + (isMechanism ? jsonMechanism(Mechanism(found.parameters)) : none) +
           ",\"standardError\":{" + errors.join(',') + "},\"identifiable\":{" + identifiable.join(',') +
           "},\"alternatives\":" + jsonOf(found.alternatives) + ",\"rounded\":" +
           (found.outcome == Outcome::Identified ? jsonMechanism(Mechanism(diagnosis.rounded)) : none) +
           ",\"noise\":" + jsonOf(found.noise) + ",\"iterations\":" + QByteArray::number(found.iterations) +
           ",\"conditionNumber\":" + (found.stands() ? jsonNumber(found.conditionNumber) : none) +
           ",\"channels\":" + jsonOf(diagnosis.identified) + ",\"columns\":" + jsonColumns(data.layout) +
           ",\"conventions\":" + jsonOf(diagnosis.conventions, data) +
           ",\"summary\":" + jsonString(summaryOf(diagnosis)) + "}\n";
}

/// "--a 20 --b …": to go on with.
QString optionsFor(const Parameters &parameters)
{
    QString text;
    for (const Parameter parameter : kParameters) {
        text += QStringLiteral("--%1 %2 ")
                    .arg(QLatin1String(wordOf(parameter)),
                         QString::number(valueOf(parameters, parameter), 'g', QLocale::FloatingPointShortest));
    }
    return text +
           (parameters.branch == Branch::Open ? QStringLiteral("--branch open") : QStringLiteral("--branch crossed"));
}

/// Of a mechanism that stands.
QString textOf(const QString &file, const ReferenceData &data, const Diagnosis &diagnosis)
{
    const Identification &found = diagnosis.identification;
    QString text = headlineOf(file, data);
    for (const ConventionFinding &finding : diagnosis.conventions) {
        text += explanationOf(finding.convention, data) + u' ' + effectOf(finding) + u'\n';
    }
    text += summaryOf(diagnosis) + u'\n';
    text += CommandLine::tr("± one standard deviation; %1 iterations, condition number %2.")
                .arg(found.iterations)
                .arg(QString::number(found.conditionNumber, 'g', 3)) +
            u'\n';
    text += u'\n' + tableOf(diagnosis.identified) + u'\n';
    if (found.noise.empty()) { // else it was said what is left
        text += summaryOf(diagnosis.identified) + u'\n';
    }
    if (const QString rounded = roundNumbersText(diagnosis); !rounded.isEmpty()) {
        text += rounded + u'\n';
    }
    const QString goOn = found.outcome == Outcome::Identified ? CommandLine::tr("To go on with it: %1")
                                                              : CommandLine::tr("To go on with the first: %1");
    return text + goOn.arg(optionsFor(diagnosis.rounded)) + u'\n';
}

} // namespace

ExitStatus identifyFile(const IdentifyOptions &options)
{
    const std::variant<std::shared_ptr<const Reference>, QString> outcome = readReference(options.file);
    if (const QString *sentence = std::get_if<QString>(&outcome)) {
        say(*sentence);
        return ExitStatus::FileFailed;
    }
    const ReferenceData &data = std::get<std::shared_ptr<const Reference>>(outcome)->data;
    const Diagnosis diagnosis = diagnose(data, options.mechanism);
    const bool stands = diagnosis.identification.stands();

    // Without a mechanism there is nothing for a person to read but the sentence that says so.
    if (stands || options.format == Format::Json) {
        const QByteArray bytes = options.format == Format::Json ? jsonOf(options.file, data, diagnosis)
                                                                : textOf(options.file, data, diagnosis).toUtf8();
        if (writeAll(options.output, bytes) != ExitStatus::Done) {
            return ExitStatus::FileFailed;
        }
    }
    warnOf(options.file, data);
    if (!stands) {
        say(QStringLiteral("%1: %2").arg(QDir::toNativeSeparators(options.file), summaryOf(diagnosis)));
        return ExitStatus::NotSolved;
    }
    return ExitStatus::Done;
}

} // namespace slidercrank
