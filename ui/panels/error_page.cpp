// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/error_page.h"

#include "ui/text/axis_scale.h"
#include "ui/text/channel_text.h"
#include "ui/text/column_text.h"
#include "ui/text/comparison_text.h"
#include "ui/text/convention_text.h"
#include "ui/text/explanation.h"
#include "ui/text/identification_text.h"
#include "ui/text/notation.h"
#include "ui/text/parameter_text.h"
#include "ui/text/read_fault_text.h"
#include "ui/text/written_number.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace slidercrank
{

namespace
{

struct VerdictLook {
    QString mark;
    QString word;
    Tone tone;
};

struct ErrorPage {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::ErrorPage)

public:
    static VerdictLook lookOf(Verdict verdict)
    {
        switch (verdict) {
        case Verdict::Agrees: return {"✓", tr("agrees"), Tone::Good};
        case Verdict::Close: return {"≈", tr("close"), Tone::Fair};
        case Verdict::Differs: break;
        }
        return {"✗", tr("differs"), Tone::Bad};
    }

    static Verdict worstVerdict(const std::vector<ChannelComparison> &comparison)
    {
        const auto worst = std::ranges::max_element(comparison, {}, &ChannelComparison::verdict);
        return worst == comparison.end() ? Verdict::Differs : worst->verdict;
    }

    static TableCell numberCell(std::optional<double> value, const QString &unit = {})
    {
        const QString text = shortNumber(value);
        const QString space = unit.isEmpty() || unit == u"°" ? QString() : " ";
        return {.text = value ? text + space + unit : text, .number = value};
    }

    /// Returns a row: the quantity, its largest error in the unit that is shown and in percent of the peak, and the
    /// time of this error.
    static TableRow rowOf(const ChannelComparison &channel, const QString &explanation)
    {
        const QString unit = shownUnit(channel.channel);
        const std::optional<double> error = shownDifference(channel.channel, channel.largestError);
        const std::optional<double> time =
            channel.largestError ? std::optional(channel.timeOfLargestError) : std::nullopt;
        return {{{.text = QStringLiteral("%1 %2").arg(symbolText(channel.channel), quantityName(channel.channel)),
                  .csv = nameWithAsciiUnit(columnName(channel.channel), measureOf(channel.channel), notation().units)},
                 numberCell(error, unit),
                 numberCell(channel.percentOfPeak),
                 {.text = numberText(time), .number = time, .tone = Tone::Link}},
                time,
                MechanismPart::None,
                explanation};
    }

    static constexpr int kVerdictColumn = 1; // after the quantity

    /// Returns the row of a channel that is compared with a file. Its tool tip contains all numbers of the comparison.
    static TableRow fileRow(const ChannelComparison &channel, const ReferenceData &data)
    {
        const std::vector<QStringList> table = comparisonTable({&channel, 1}, data);
        const QStringList &headings = table.front();
        const QStringList &values = table.back();
        QString explanation;
        for (qsizetype i = 0; i < headings.size(); ++i) {
            explanation += QStringLiteral("%1: %2\n").arg(headings[i], values[i]);
        }
        explanation.chop(1);
        if (channel.missingModelCount > 0) {
            explanation += u'\n' + tr("The mechanism cannot be assembled at %1 time steps of the file.")
                                       .arg(QString::number(channel.missingModelCount));
        }
        TableRow row = rowOf(channel, explanation);
        const VerdictLook look = lookOf(channel.verdict);
        row.cells.insert(row.cells.begin() + kVerdictColumn,
                         {.text = look.mark + u' ' + look.word, .csv = verdictText(channel), .tone = look.tone});
        return row;
    }

    static TableRow pinnedRow(const ChannelComparison &channel)
    {
        const bool isUnbounded = channel.largestError && std::isinf(*channel.largestError);
        return rowOf(channel, isUnbounded ? tr("Infinite: one of the two mechanisms reaches a limit position")
                                          : tr("Root mean square: %1 %2")
                                                .arg(shortNumber(shownDifference(channel.channel, channel.rms)),
                                                     shownUnit(channel.channel)));
    }

    /// Returns a table without rows, with the columns of rowOf().
    static PageTable tableWithoutRows(const QString &name, const QString &title, const TableColumn &largestErrorColumn)
    {
        return {
            name,
            title,
            {{.title = tr("quantity"),
              .explanation = tr("What is compared"),
              .csvName = "channel",
              .isNumber = false,
              .isFormula = true},
             largestErrorColumn,
             {tr("% of peak"), tr("Largest error relative to the largest value of the reference"), "percent_of_peak"},
             {tr("t [s]"), tr("Time of the largest error"), "max_error_at [s]"}}};
    }

    /// Says how many rows and columns of the file were not used; the reference page lists them.
    static QString leftOutText(const ReferenceData &data)
    {
        const std::size_t rows = data.skippedCount;
        const qsizetype columns = ignoredHeadings(data.layout).size();
        QStringList sentences;
        if (rows > 0) {
            sentences << tr("Rows that were skipped: %1.").arg(rows);
        }
        if (columns > 0) {
            sentences << tr("Columns that were not used: %1.").arg(columns);
        }
        if (!sentences.isEmpty()) {
            sentences << tr("See the tab Reference.");
        }
        return sentences.join(u' ');
    }

    static Page filePage(const Result &result, const ReferenceIdentification *identification)
    {
        const Verdict verdict = worstVerdict(result.comparison);
        const VerdictLook look = lookOf(verdict);
        Page page;
        page.sentence =
            QStringLiteral("%1 %2: %3").arg(look.mark, result.reference->name, summaryText(result.comparison));
        page.tone = look.tone;
        page.findings = findingsOf(result, identification);
        page.isSearching =
            belongsToCurrentFile(identification, result) && identification->parameters != result.mechanism.parameters();
        bool isOffered = false; // only the first remedy is offered
        for (Finding &finding : page.findings) {
            if (finding.remedy != Remedy::None && std::exchange(isOffered, true)) {
                finding.remedy = Remedy::None;
            }
        }
        PageTable table = tableWithoutRows("errorTable", tr("Errors, a row for each channel"),
                                           {tr("largest error"), tr("max |model − reference|"), "max_error"});
        table.columns.insert(
            table.columns.begin() + kVerdictColumn,
            {.title = tr("verdict"),
             .explanation =
                 tr("Rounding: half a unit of the last digit of the value, plus the motion during half a unit of "
                    "the last digit of the time stamp\n"
                    "agrees: at least 95 % of the errors are within the rounding, and none exceeds it tenfold or "
                    "by more than 0.5 % of half the range of the motion\n"
                    "close: none exceeds it a hundredfold or by more than 1 % of half that range\n"
                    "differs: anything else"),
             .csvName = "verdict",
             .isNumber = false});
        for (const ChannelComparison &channel : result.comparison) {
            table.rows.push_back(fileRow(channel, result.reference->data));
        }
        page.tables = {table};
        page.note = leftOutText(result.reference->data);
        return page;
    }

    static Page pinnedPage(const Result &result)
    {
        const Parameters &current = result.mechanism.parameters();
        const Parameters &pinned = result.pinned.back();
        Page page;
        page.sentence =
            current == pinned
                ? tr("This mechanism is the pinned one: change it to see the difference.")
                : tr("Difference: this mechanism minus the pinned one (%1).").arg(pinnedText(pinned, current));
        if (result.difference->hasGaps) {
            page.sentence +=
                u' ' + tr("Time steps at which one of the two mechanisms cannot be assembled are not compared.");
        }
        PageTable table =
            tableWithoutRows("differenceTable", tr("Differences from the pinned motion, a row for each channel"),
                             {tr("largest difference"), tr("max |this − pinned|"), "max_difference"});
        std::ranges::transform(result.difference->channels, std::back_inserter(table.rows), pinnedRow);
        page.tables = {table};
        return page;
    }
};

} // namespace

void offerMechanism(Finding &finding, const Identification &found, const Parameters &given)
{
    constexpr int kDigits = 9;
    const Parameters parameters = mechanismToUse(found);
    if (!found.hasMechanism() || parameters == given) {
        return;
    }
    finding.remedy = Remedy::UseFoundMechanism;
    finding.remedyText = ErrorPage::tr("Use this mechanism");
    QStringList details{ErrorPage::tr("Sets %1.").arg(mechanismText(Mechanism(parameters), kDigits))};
    for (const ConventionFinding &conventionFinding : found.conventions) {
        details << explanationText(conventionFinding.convention);
    }
    details << shownDriveText(found, parameters.omega2);
    details.removeAll(QString());
    finding.details = details.join("<br>");
}

bool belongsToCurrentFile(const ReferenceIdentification *identification, const Result &result)
{
    return identification && result.reference && identification->reference == result.choices.reference;
}

std::vector<Finding> findingsOf(const Result &result, const ReferenceIdentification *identification)
{
    std::vector<Finding> findings;
    if (belongsToCurrentFile(identification, result) && ErrorPage::worstVerdict(result.comparison) != Verdict::Agrees) {
        const auto &[reference, given, found] = *identification;
        for (const Explanation &explanation : explainDifferences(found, given, reference->data.layout)) {
            if (explanation.cause == Explanation::Cause::Mechanism && found.change) {
                continue; // the wrong length is named instead; the reference page shows the mechanism
            }
            Finding finding{explanation.text};
            if (explanation.action == Explanation::Action::Apply) {
                finding.remedy = Remedy::ApplyConvention;
                finding.remedyText = ErrorPage::tr("Apply");
                finding.convention = explanation.convention;
            } else if (explanation.action == Explanation::Action::UseMechanism) {
                offerMechanism(finding, found, given);
            }
            findings.push_back(std::move(finding));
        }
    }
    if (!result.reference->source.conventions.empty()) {
        QStringList sentences;
        for (const Convention &convention : result.reference->source.conventions) {
            sentences << explanationText(convention);
        }
        findings.push_back({ErrorPage::tr("These corrections are applied to the file: %1").arg(sentences.join(u' ')),
                            Remedy::ReadAsPrinted, ErrorPage::tr("Remove corrections")});
    }
    return findings;
}

Page errorPage(const Result &result, const ReferenceIdentification *identification)
{
    if (result.reference) {
        return ErrorPage::filePage(result, identification);
    }
    if (result.difference) {
        return ErrorPage::pinnedPage(result);
    }
    Page page;
    page.findings = {
        noOpenFileFinding(ErrorPage::tr("There is nothing to compare with: no file is open and no motion is "
                                        "pinned. Edit > Pin this motion keeps the present curves."))};
    return page;
}

Finding noOpenFileFinding(const QString &sentence)
{
    return {.sentence = sentence, .remedy = Remedy::OpenFile, .remedyText = ErrorPage::tr("Open a CSV…")};
}

QString errorTitle(const Result &result)
{
    const QString title = ErrorPage::tr("Errors");
    return result.reference ? title + u' ' + ErrorPage::lookOf(ErrorPage::worstVerdict(result.comparison)).mark : title;
}

} // namespace slidercrank
