// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/subcommands.h"

#include "app/output.h"
#include "core/study/study.h"
#include "ui/text/finding_text.h"
#include "ui/text/study_text.h"

#include <QStringList>

#include <array>
#include <numeric>

namespace slidercrank
{

namespace
{

QString wordFor(Status status)
{
    switch (status) {
    case Status::Solved: return CommandLine::tr("solved");
    case Status::Singular: return CommandLine::tr("singular");
    case Status::IterationLimit: return CommandLine::tr("iteration-limit");
    case Status::NotAssemblable: return CommandLine::tr("not-assemblable");
    case Status::NotFinite: return CommandLine::tr("not-finite");
    }
    return {};
}

/// "solved", or "190 solved, 11 singular".
QString outcomeOf(const MethodResult &row, std::size_t instants)
{
    QStringList parts;
    for (std::size_t i = 0; i < kStatusCount; ++i) {
        if (row.counts[i] == instants) {
            return wordFor(static_cast<Status>(i));
        }
        if (row.counts[i] > 0) {
            parts += QString::number(row.counts[i]) + u' ' + wordFor(static_cast<Status>(i));
        }
    }
    return parts.join(QStringLiteral(", "));
}

/// As wide as anything that comes there.
constexpr std::array kWidths{25, 9, 8, 10, 9, 10, 9, 9};

QString lineOf(const QStringList &cells)
{
    QString line = cells.front().leftJustified(kWidths[0]);
    for (qsizetype i = 1; i < static_cast<qsizetype>(kWidths.size()); ++i) {
        line += u' ' + cells[i].rightJustified(kWidths[static_cast<std::size_t>(i)]);
    }
    return line + QStringLiteral("  ") + cells.back() + u'\n';
}

QString tableOf(const CaseResult &which)
{
    constexpr int kDigits = 9;
    QString text = CommandLine::tr("%1: %2; %3 instants")
                       .arg(caseText(which.traits), mechanismText(Mechanism(which.parameters), kDigits),
                            QString::number(which.instants)) +
                   u'\n';
    text += lineOf({CommandLine::tr("method"), CommandLine::tr("tolerance"), CommandLine::tr("channels"),
                    CommandLine::tr("ns/state"), CommandLine::tr("spread"), CommandLine::tr("iterations"),
                    CommandLine::tr("error"), CommandLine::tr("rounding"), CommandLine::tr("outcome")});
    for (const MethodResult &row : which.methods) {
        QString outcome = outcomeOf(row, std::accumulate(row.counts.begin(), row.counts.end(), std::size_t{0}));
        if (row.silentFailures.value_or(0) > 0) {
            outcome += CommandLine::tr(", %1 of them silently wrong").arg(*row.silentFailures);
        }
        text += lineOf({QString::fromStdString(nameOf(row.method)), rounded(row.tolerance),
                        QString::number(row.channels), rounded(row.nsPerState, 4), rounded(row.spread),
                        rounded(row.iterationsPerState), rounded(row.maxError), rounded(row.errorBound), outcome});
    }
    if (const QString sentence = closedFormSentence(which); !sentence.isEmpty()) {
        text += sentence + u'\n';
    }
    return text;
}

QString textOf(const StudyResult &result)
{
    QString text;
    std::size_t silentFailures = 0;
    for (const CaseResult &which : result.cases) {
        text += tableOf(which) + u'\n';
        for (const MethodResult &row : which.methods) {
            silentFailures += row.silentFailures.value_or(0);
        }
    }
    text += CommandLine::tr(
                "Errors are the worst of the six plotted channels, relative to the channel's peak, against "
                "50 to 100 digits, over the\n"
                "instants that a method calls solved. Rounding: what rounding the given numbers may cost by itself.\n"
                "Silently wrong instants: %1. Machine: %2. Done in %3 s.\n")
                .arg(QString::number(silentFailures), machineText(result.machine), rounded(result.seconds));
    return text;
}

} // namespace

ExitStatus study(const StudyOptions &options)
{
    Output output(options.output);
    if (!output.open()) {
        return ExitStatus::FileFailed;
    }
    StudyRequest request;
    request.cases = options.cases;
    const StudyResult result = runStudy(request);
    switch (options.format) {
    case Format::Text: output.write(textOf(result).toUtf8()); break;
    case Format::Csv: output.write(QByteArray::fromStdString(studyCsv(result))); break;
    case Format::Json: output.write(QByteArray::fromStdString(studyJson(result))); break;
    }
    return output.finish();
}

} // namespace slidercrank
