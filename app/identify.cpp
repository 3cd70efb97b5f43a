// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/subcommands.h"

#include "app/comparison_text.h"
#include "app/diagnosis_json.h"
#include "app/json_text.h"
#include "app/output.h"
#include "core/identification/diagnosis.h"
#include "core/import/crank_angles.h"
#include "ui/document/reference_file.h"
#include "ui/text/convention_text.h"
#include "ui/text/diagnosis_text.h"
#include "ui/text/finding_text.h"

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
QByteArray jsonOf(const Reference &reference, const Diagnosis &diagnosis)
{
    const InEnglish inEnglish;
    const ReferenceData &data = reference.data;
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
    QByteArrayList excludedRows;
    for (const std::size_t line : found.excludedRows) {
        excludedRows += QByteArray::number(line);
    }
    return "{\"file\":" + jsonString(joinedName(reference.paths)) + ',' + jsonJoined(reference.paths) +
           "\"outcome\":\"" + wordOf(found.outcome) +
           "\",\"mechanism\":" + (isMechanism ? jsonMechanism(Mechanism(found.parameters)) : none) +
           ",\"standardError\":{" + errors.join(',') + "},\"identifiable\":{" + identifiable.join(',') +
           "},\"alternatives\":" + jsonOf(found.alternatives) +
           ",\"rounded\":" + (found.hasOneMechanism() ? jsonMechanism(Mechanism(diagnosis.rounded)) : none) +
           ",\"noise\":" + jsonOf(found.noise) + ",\"iterations\":" + QByteArray::number(found.iterations) +
           ",\"conditionNumber\":" + (found.stands() ? jsonNumber(found.conditionNumber) : none) +
           ",\"channels\":" + jsonOf(diagnosis.identified) + ",\"columns\":" + jsonColumns(data.layout) +
           ",\"conventions\":" + jsonOf(diagnosis.conventions, data) + ",\"leftOut\":" + jsonOf(found.leftOut) +
           ",\"excludedRows\":[" + excludedRows.join(',') + ']' + ",\"summary\":" + jsonString(summaryOf(diagnosis)) +
           '}';
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
    const Identification &found = diagnosis.identification;
    QString text = headlineOf(file, data);
    if (!found.stands()) {
        return text + summaryOf(diagnosis) + u'\n';
    }
    for (const ConventionFinding &finding : diagnosis.conventions) {
        text += explanationOf(finding.convention, data) + u' ' + effectOf(finding) + u'\n';
    }
    text += summaryOf(diagnosis) + u'\n';
    if (found.outcome != Outcome::Approximate) {
        text += CommandLine::tr("± one standard deviation; %1 iterations, condition number %2.")
                    .arg(found.iterations)
                    .arg(rounded(found.conditionNumber)) +
                u'\n';
    }
    const std::optional<ReferenceData> timed =
        data.crank ? timedBy(Mechanism(found.parameters), data) : std::nullopt; // what it was compared as
    text += u'\n' + tableOf(diagnosis.identified, timed ? *timed : data) + u'\n';
    if (found.noise.empty()) { // else it was said what is left
        text += summaryOf(diagnosis.identified) + u'\n';
    }
    if (const QString rounded = roundNumbersText(diagnosis); !rounded.isEmpty()) {
        text += rounded + u'\n';
    }
    const QString goOn = found.hasOneMechanism() ? CommandLine::tr("To go on with it: %1")
                                                 : CommandLine::tr("To go on with the first: %1");
    return text + goOn.arg(optionsFor(diagnosis.rounded)) + u'\n';
}

/// How many files have a mechanism, several, none; and how many could not be read.
class OutcomeTally
{
public:
    void add(const Identification &found)
    {
        ++(found.outcome == Outcome::Identified    ? m_identified
           : found.outcome == Outcome::Approximate ? m_approximate
           : found.outcome == Outcome::Ambiguous   ? m_ambiguous
                                                   : m_open);
    }
    void addUnreadable() { ++m_unreadable; }

    QString sentence() const
    {
        QString text = CommandLine::tr("%1 files: %2 identified, %3 ambiguous, %4 not identified")
                           .arg(m_identified + m_approximate + m_ambiguous + m_open + m_unreadable)
                           .arg(m_identified)
                           .arg(m_ambiguous)
                           .arg(m_open);
        if (m_approximate > 0) {
            text += CommandLine::tr(", %1 approximated").arg(m_approximate);
        }
        if (m_unreadable > 0) {
            text += CommandLine::tr(", %1 could not be read").arg(m_unreadable);
        }
        return text + u'.';
    }

private:
    int m_identified = 0;
    int m_approximate = 0;
    int m_ambiguous = 0;
    int m_open = 0;
    int m_unreadable = 0;
};

} // namespace

ExitStatus identifyFiles(const IdentifyOptions &options)
{
    const bool several = options.references.size() > 1;
    const bool isJson = options.format == Format::Json;
    ExitStatus status = ExitStatus::Done;
    OutcomeTally tally;
    PartedOutput output(options.output, isJson && several ? "{\"files\":[" : "", isJson ? "," : "\n");
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
        const Reference &reference = *std::get<std::shared_ptr<const Reference>>(outcome);
        const ReferenceData &data = reference.data;
        const Diagnosis diagnosis = diagnose(data, options.mechanism);
        const bool stands = diagnosis.identification.stands();
        tally.add(diagnosis.identification);

        // Of one file without a mechanism there is nothing for a person to read but the sentence that says so.
        if ((stands || several || isJson) &&
            !output.add(isJson ? jsonOf(reference, diagnosis) : textOf(file, data, diagnosis).toUtf8())) {
            break;
        }
        warnOf(file, data);
        if (!stands) {
            status = graver(status, ExitStatus::NotSolved);
            if (isJson || !several) {
                say(QStringLiteral("%1: %2").arg(shownNameOf(file), summaryOf(diagnosis)));
            }
        }
    }
    QByteArray tail;
    if (isJson) {
        tail = several ? "]}\n" : "\n";
    } else if (several) {
        tail = '\n' + tally.sentence().toUtf8() + '\n';
    }
    return graver(status, output.finish(tail));
}

} // namespace slidercrank
