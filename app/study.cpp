// SPDX-License-Identifier: GPL-3.0-or-later

// `slidercrank study`: speed against error of every method.

#include "core/study/study.h"
#include "app/commands.h"
#include "app/option_groups.h"
#include "app/output.h"
#include "app/records.h"
#include "ui/text/finding_text.h"
#include "ui/text/study_text.h"

#include <QStringList>

#include <algorithm>
#include <iterator>

namespace slidercrank
{

namespace
{

/// "solved", or "190 solved, 11 singular".
QString outcomeText(const MethodResult &method)
{
    const QStringList names{CommandLine::tr("solved"), CommandLine::tr("singular"), CommandLine::tr("iteration-limit"),
                            CommandLine::tr("not-assemblable"), CommandLine::tr("not-finite")}; // by Status
    QStringList parts;
    for (std::size_t i = 0; i < kStatusCount; ++i) {
        if (method.counts[i] > 0) {
            parts += QString::number(method.counts[i]) + ' ' + names[static_cast<qsizetype>(i)];
        }
    }
    return parts.size() == 1 ? parts.front().section(' ', 1) : parts.join(", ");
}

QString caseTable(const CaseResult &result)
{
    QString text = CommandLine::tr("%1: %2; %3 time stamps")
                       .arg(caseText(result.name), mechanismText(Mechanism(result.parameters), 9),
                            QString::number(result.instants)) +
                   u'\n';
    std::vector<QStringList> rows{{CommandLine::tr("method"), CommandLine::tr("tolerance"), CommandLine::tr("channels"),
                                   CommandLine::tr("ns/state"), CommandLine::tr("spread"),
                                   CommandLine::tr("iterations"), CommandLine::tr("error"), CommandLine::tr("rounding"),
                                   CommandLine::tr("outcome")}};
    for (const MethodResult &method : result.methods) {
        QString outcome = outcomeText(method);
        if (method.silentFailures.value_or(0) > 0) {
            outcome += CommandLine::tr(", %1 of them wrong without a warning").arg(*method.silentFailures);
        }
        rows.push_back({QString::fromStdString(nameOf(method.method)), roundedText(method.tolerance),
                        QString::number(method.channels), roundedText(method.nsPerState, 4), roundedText(method.spread),
                        roundedText(method.iterationsPerState), roundedText(method.maxError),
                        roundedText(method.errorBound), outcome});
    }
    text += alignedTable(rows, {false, true, true, true, true, true, true, true, false});
    const QString sentence = closedFormSentence(result);
    return sentence.isEmpty() ? text : text + sentence + u'\n';
}

QString studyText(const StudyResult &result)
{
    QString text;
    std::size_t silentFailures = 0;
    for (const CaseResult &each : result.cases) {
        text += caseTable(each) + u'\n';
        for (const MethodResult &method : each.methods) {
            silentFailures += method.silentFailures.value_or(0);
        }
    }
    text +=
        CommandLine::tr(
            "Errors are the worst of the six plotted channels, relative to the channel's peak, against "
            "50 to 100 digits,\n"
            "over the time stamps that a method reports as solved. Rounding: the error that rounding the parameters "
            "causes by itself.\n"
            "Time stamps that are wrong without a warning: %1. Machine: %2. Time: %3 s.\n")
            .arg(QString::number(silentFailures), machineText(result.machine), roundedText(result.seconds));
    return text;
}

enum class CaseChoice { Nominal, Hard, All };

std::vector<Case> readCases(const OptionReader &options, const Mechanism &mechanism)
{
    const CaseChoice choice = options.choice("cases", CaseChoice::Nominal);
    std::vector<Case> cases;
    if (choice == CaseChoice::Nominal || mechanism != Mechanism()) {
        cases.push_back(studyCase(mechanism.parameters()));
    }
    if (choice == CaseChoice::All) {
        std::ranges::copy(nominalCases(), std::back_inserter(cases));
    }
    if (choice != CaseChoice::Nominal) {
        std::ranges::copy(hardCases(), std::back_inserter(cases));
    }
    return cases;
}

} // namespace

Command prepareStudy(OptionReader &options)
{
    StudyRequest request;
    request.cases = readCases(options, readMechanism(options));
    const Format format = readFormat(options, Format::Text);
    const QString output = readOutput(options);
    refuseFiles(options);
    return {[request, format, output](const Streams &streams) {
        const StudyResult result = runStudy(request);
        const QByteArray bytes = format == Format::Text  ? studyText(result).toUtf8()
                                 : format == Format::Csv ? QByteArray::fromStdString(studyCsv(result))
                                                         : QByteArray::fromStdString(studyJson(result));
        return writeOutput(streams, output, bytes);
    }};
}

} // namespace slidercrank
