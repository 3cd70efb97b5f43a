// SPDX-License-Identifier: GPL-3.0-or-later

// `slidercrank study`: measures the speed and the error of every method.

#include "core/study/study.h"
#include "app/command_output.h"
#include "app/commands.h"
#include "app/option_words.h"
#include "ui/panels/study_page.h"
#include "ui/text/parameter_text.h"
#include "ui/text/study_text.h"
#include "ui/text/written_number.h"

#include <QStringList>

#include <algorithm>
#include <iterator>

namespace slidercrank
{

namespace
{

/// Returns the tables of the study's tab in the window, as text below a heading.
QString tablesWithHeading(const QString &heading, const Page &page)
{
    QString text = heading + u'\n';
    for (const PageTable &table : page.tables) {
        std::vector<QStringList> rows(1); // the headings
        for (const TableColumn &column : table.columns) {
            rows.front() += column.title;
        }
        for (const TableRow &row : table.rows) {
            rows.emplace_back();
            for (const TableCell &cell : row.cells) {
                rows.back() += cell.text;
            }
        }
        text += alignedTable(rows) + u'\n';
    }
    return page.sentence.isEmpty() ? text : text + page.sentence + u'\n';
}

QString caseReport(const CaseResult &result)
{
    const QString heading =
        CommandLine::tr("%1: %2; %3 time stamps")
            .arg(caseText(result.name), mechanismText(Mechanism(result.parameters), kMechanismDigits),
                 QString::number(result.timeStampCount));
    return tablesWithHeading(heading, studyPage(result));
}

/// Returns the table of the methods over all cases: largest error, median time, and how many time steps have each
/// status.
QString summaryReport(const StudyResult &result)
{
    const CaseResult allCases{
        .name = {}, .parameters = {}, .timeStampCount = 0, .methods = resultsOverAllCases(result)};
    return tablesWithHeading(CommandLine::tr("All %1 cases together").arg(QString::number(result.cases.size())),
                             studyPage(allCases));
}

QString studyReport(const StudyResult &result)
{
    QString text;
    if (result.cases.size() > 1) {
        text += summaryReport(result) + u'\n';
    }
    for (const CaseResult &each : result.cases) {
        text += caseReport(each) + u'\n';
    }
    return text + CommandLine::tr("Errors are the largest of the six plotted channels, relative to the channel's peak, "
                                  "over the time steps that a method solves.\n"
                                  "They are measured against a computation with 115 digits.\n"
                                  "Machine: %1. Time: %2 s.\n")
                      .arg(machineText(), numberText(result.seconds, 3));
}

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

ExitStatus studyCommand(const OptionReader &options, const Streams &streams)
{
    const Request request(options);
    StudyRequest study;
    study.cases = readCases(options, request.mechanism);
    options.refuseFiles();
    const StudyResult result = runStudy(study);
    return request.write(streams,
                         {.text = studyReport(result), .rows = studyRecords(result), .json = studyJson(result)});
}

} // namespace slidercrank
