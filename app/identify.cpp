// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/subcommands.h"

#include "app/comparison_text.h"
#include "app/json_text.h"
#include "app/output.h"
#include "core/diagnosis/diagnosis.h"
#include "ui/document/reference_file.h"
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

/// As JSON names it, in every language.
const char *wordOf(Convention::Kind kind)
{
    switch (kind) {
    case Convention::Kind::AngleUnit: return "angle-unit";
    case Convention::Kind::LengthUnit: return "length-unit";
    case Convention::Kind::TimeUnit: return "time-unit";
    case Convention::Kind::Sign: return "sign";
    case Convention::Kind::HalfTurn: return "half-turn";
    case Convention::Kind::WholeTurns: return "whole-turns";
    case Convention::Kind::ZeroPoint: return "zero-point";
    case Convention::Kind::SwappedColumns: return "swapped-columns";
    case Convention::Kind::Branch: return "branch";
    case Convention::Kind::TimeShift: return "time-shift";
    case Convention::Kind::NotDerivative: return "not-derivative";
    }
    return "";
}

bool isFound(const Diagnosis &diagnosis)
{
    return diagnosis.identification.outcome == Identification::Outcome::Identified;
}

/// What was not found is null.
QByteArray jsonOf(const QString &file, const Diagnosis &diagnosis)
{
    const Identification &identification = diagnosis.identification;
    const bool found = isFound(diagnosis);
    QByteArrayList errors;
    QByteArrayList identifiable;
    for (const Parameter parameter : kParameters) {
        const std::size_t i = indexOf(parameter);
        const QByteArray name = '"' + QByteArray(wordOf(parameter)) + "\":";
        const bool isFixed = found && identification.identifiable[i];
        errors += name + jsonNumber(isFixed ? std::optional(identification.standardError[i]) : std::nullopt);
        identifiable += name + (isFixed ? "true" : "false");
    }
    QByteArrayList conventions;
    for (const ConventionFinding &finding : diagnosis.conventions) {
        conventions += "{\"name\":\"" + QByteArray(wordOf(finding.convention.kind)) +
                       "\",\"explanation\":" + jsonString(explanationOf(finding.convention)) +
                       ",\"before\":" + jsonNumber(finding.before) + ",\"after\":" + jsonNumber(finding.after) + '}';
    }
    return "{\"file\":" + jsonString(file) +
           ",\"mechanism\":" + (found ? jsonMechanism(Mechanism(identification.parameters)) : QByteArray("null")) +
           ",\"rounded\":" + (found ? jsonMechanism(Mechanism(diagnosis.rounded)) : QByteArray("null")) +
           ",\"standardError\":{" + errors.join(',') + "},\"identifiable\":{" + identifiable.join(',') +
           "},\"iterations\":" + QByteArray::number(identification.iterations) +
           ",\"conditionNumber\":" + jsonNumber(found ? std::optional(identification.conditionNumber) : std::nullopt) +
           ",\"channels\":" + jsonOf(diagnosis.identified) + ",\"conventions\":[" + conventions.join(',') +
           "],\"summary\":" + jsonString(summaryOf(identification)) + "}\n";
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

QString textOf(const QString &file, const ReferenceData &data, const Diagnosis &diagnosis)
{
    const Identification &identification = diagnosis.identification;
    QString text = headlineOf(file, data);
    for (const ConventionFinding &finding : diagnosis.conventions) {
        text += explanationOf(finding.convention) + u' ' + effectOf(finding) + u'\n';
    }
    text += summaryOf(identification) + u'\n';
    text += CommandLine::tr("± one standard deviation; %1 iterations, condition number %2.")
                .arg(identification.iterations)
                .arg(QString::number(identification.conditionNumber, 'g', 3)) +
            u'\n';
    text += u'\n' + tableOf(diagnosis.identified) + u'\n' + summaryOf(diagnosis.identified) + u'\n';
    if (const QString rounded = roundNumbersText(diagnosis); !rounded.isEmpty()) {
        text += rounded + u'\n';
    }
    return text + CommandLine::tr("To go on with it: %1").arg(optionsFor(diagnosis.rounded)) + u'\n';
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

    // Without a mechanism there is nothing for a person to read but the sentence that says so.
    if (isFound(diagnosis) || options.format == Format::Json) {
        const QByteArray bytes = options.format == Format::Json ? jsonOf(options.file, diagnosis)
                                                                : textOf(options.file, data, diagnosis).toUtf8();
        if (writeAll(options.output, bytes) != ExitStatus::Done) {
            return ExitStatus::FileFailed;
        }
    }
    warnOf(options.file, data);
    if (!isFound(diagnosis)) {
        say(QStringLiteral("%1: %2").arg(QDir::toNativeSeparators(options.file), summaryOf(diagnosis.identification)));
        return ExitStatus::NotSolved;
    }
    return ExitStatus::Done;
}

} // namespace slidercrank
