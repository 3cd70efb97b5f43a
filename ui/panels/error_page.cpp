// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/error_page.h"

#include "ui/text/axis_scale.h"
#include "ui/text/column_text.h"
#include "ui/text/convention_text.h"
#include "ui/text/diagnosis_text.h"
#include "ui/text/finding_text.h"
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

struct ErrorPage {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::ErrorPage)
};

struct VerdictLook {
    QString mark;
    QString word;
    Tone tone;
};

VerdictLook lookOf(Verdict verdict)
{
    const VerdictLook looks[] = {{"✓", ErrorPage::tr("agrees"), Tone::Good}, // in the order of Verdict
                                 {"≈", ErrorPage::tr("close"), Tone::Fair},
                                 {"✗", ErrorPage::tr("differs"), Tone::Bad}};
    return looks[static_cast<std::size_t>(verdict)];
}

Verdict worstVerdict(const std::vector<ChannelComparison> &comparison)
{
    const auto worst = std::ranges::max_element(comparison, {}, &ChannelComparison::verdict);
    return worst == comparison.end() ? Verdict::Differs : worst->verdict;
}

QString readout(std::optional<double> value, const QString &unit = {})
{
    if (value && std::isinf(*value)) {
        return QStringLiteral("∞");
    }
    const QString space = unit.isEmpty() || unit == u"°" ? QString() : " ";
    return shortNumber(value, kReadoutDigits) + (value ? space + unit : QString());
}

TableCell numberCell(std::optional<double> value, const QString &unit, const QString &explanation)
{
    return {.text = readout(value, unit),
            .number = value && std::isfinite(*value) ? value : std::nullopt,
            .explanation = explanation,
            .csv = dash()};
}

/// Returns the quantity, its largest error, that error in percent of the peak, and its time.
TableRow rowOf(const ChannelComparison &channel, const QString &details, const QString &percentFormula)
{
    constexpr int kDigits = 6; // as many as files write
    const QString unit = unitText(channel.channel);
    const std::optional<double> time = channel.maxAbs ? std::optional(channel.timeOfMaxAbs) : std::nullopt;
    return {{{.text = QStringLiteral("%1 %2").arg(symbolText(channel.channel), quantityName(channel.channel)),
              .csv = QStringLiteral("%1 [%2]").arg(columnName(channel.channel), unit)},
             numberCell(channel.maxAbs, unit, details),
             numberCell(channel.percentOfPeak, {}, percentFormula),
             {.text = numberText(time, kDigits),
              .number = time,
              .explanation = ErrorPage::tr("Click to go there"),
              .csv = dash()}},
            time};
}

TableRow fileRow(const ChannelComparison &channel)
{
    const QString unit = unitText(channel.channel);
    const VerdictLook look = lookOf(channel.verdict);
    QString count = ErrorPage::tr("%1 in the file, %2 time steps compared")
                        .arg(columnName(channel.channel), QString::number(channel.count));
    if (channel.missingModel > 0) {
        count += ErrorPage::tr("; at %1 more time steps the mechanism cannot be assembled")
                     .arg(QString::number(channel.missingModel));
    }
    const QString rounding = channel.roundingStep
                                 ? ErrorPage::tr("The file writes this channel in steps of at most %1.")
                                       .arg(numberText(*channel.roundingStep, kReadoutDigits) + u' ' + unit)
                                 : ErrorPage::tr("How the file was rounded is not known.");
    QString details =
        ErrorPage::tr("Largest |model − reference|; root mean square %1.").arg(readout(channel.rms, unit));
    details += u'\n' + (channel.maxPercent ? ErrorPage::tr("Point by point, |model − reference| / |reference|: at most "
                                                           "%1 %, at t = %2 s.")
                                                 .arg(readout(channel.maxPercent), numberText(channel.timeOfMaxPercent))
                                           : ErrorPage::tr("Point by point, relative to the reference: undefined."));
    if (channel.zeroReference > 0) {
        details += u' ' + ErrorPage::tr("Undefined where the reference is zero: at %1 time steps.")
                              .arg(QString::number(channel.zeroReference));
    }
    TableRow row =
        rowOf(channel, details + u'\n' + rounding, ErrorPage::tr("max |model − reference| / max |reference| · 100"));
    row.cells[0].explanation = count;
    row.cells.insert(row.cells.begin() + 1,
                     {.text = look.mark + u' ' + look.word,
                      .explanation = verdictText(channel) + u'\n' + verdictNumbers(channel) + u'\n' + rounding,
                      .csv = verdictText(channel),
                      .tone = look.tone});
    return row;
}

TableRow pinnedRow(const ChannelComparison &channel)
{
    const bool isUnbounded = channel.maxAbs && std::isinf(*channel.maxAbs);
    return rowOf(channel,
                 isUnbounded ? ErrorPage::tr("Unbounded: one of the two reaches a limit position")
                             : ErrorPage::tr("Largest |this − pinned|; root mean square %1.")
                                   .arg(readout(channel.rms, unitText(channel.channel))),
                 ErrorPage::tr("max |this − pinned| / max |pinned| · 100"));
}

/// Returns a table without rows, with the columns of rowOf(); `largest` is the column of the largest error.
PageTable tableWith(const QString &name, const QString &title, const TableColumn &largest)
{
    return {name,
            title,
            {{ErrorPage::tr("quantity"), ErrorPage::tr("What is compared"), "channel", false},
             largest,
             {ErrorPage::tr("% of peak"), ErrorPage::tr("Largest error relative to the largest value of the reference"),
              "percent_of_peak"},
             {ErrorPage::tr("t [s]"), ErrorPage::tr("Time of the largest error"), "max_error_at [s]"}},
            {}};
}

/// Returns how many rows and columns of the file were not used; the reference page lists them.
QString leftOutText(const ReferenceData &data)
{
    QStringList parts;
    if (const std::size_t skipped = data.skippedRowCount(); skipped == 1) {
        parts << ErrorPage::tr("1 row of the file was skipped (line %1)").arg(lineText(data.layout, data.skipped[0]));
    } else if (skipped > 1) {
        parts << ErrorPage::tr("%1 rows of the file were skipped").arg(QString::number(skipped));
    }
    if (const qsizetype ignored = ignoredHeadings(data.layout).size(); ignored > 0) {
        parts << (ignored == 1 ? ErrorPage::tr("1 column was ignored")
                               : ErrorPage::tr("%1 columns were ignored").arg(ignored));
    }
    return parts.isEmpty() ? QString() : ErrorPage::tr("%1 (see Reference).").arg(parts.join("; "));
}

Page filePage(const Result &result, const ReferenceDiagnosis *diagnosis)
{
    const Verdict verdict = worstVerdict(result.comparison);
    const VerdictLook look = lookOf(verdict);
    Page page;
    page.sentence = QStringLiteral("%1 %2: %3").arg(look.mark, result.reference->name, summaryText(result.comparison));
    page.tone = look.tone;
    page.keepsFindings = verdict != Verdict::Agrees && isOfFile(diagnosis, result) && !isUpToDate(diagnosis, result);
    if (!page.keepsFindings) {
        page.findings = findingsOf(result, diagnosis);
        bool isOffered = false; // one remedy at a time
        for (Finding &finding : page.findings) {
            if (finding.remedy != Remedy::None && std::exchange(isOffered, true)) {
                finding.remedy = Remedy::None;
            }
        }
    }
    PageTable table =
        tableWith("errorTable", ErrorPage::tr("Errors, a row for each channel"),
                  {ErrorPage::tr("largest error"), ErrorPage::tr("max |model − reference|"), "max_error"});
    table.columns.insert(
        table.columns.begin() + 1,
        {ErrorPage::tr("verdict"),
         ErrorPage::tr("Rounding: half a unit of the last digit of the value, plus the motion during half a unit of "
                       "the last digit of the time stamp\n"
                       "agrees: at least 95 % of the values within the rounding, none beyond ten times that, or "
                       "beyond it by 0.5 % of half the motion's range\n"
                       "close: none beyond a hundred times, or by 1 %\n"
                       "differs: anything else"),
         "verdict", false});
    std::ranges::transform(result.comparison, std::back_inserter(table.rows), fileRow);
    page.tables = {table};
    page.note = leftOutText(result.reference->data);
    return page;
}

Page pinnedPage(const Result &result)
{
    const Parameters &present = result.mechanism.parameters();
    const Parameters &pinned = result.pinned.back();
    Page page;
    page.sentence = present == pinned
                        ? ErrorPage::tr("This mechanism is the pinned one: change it to see the difference.")
                        : ErrorPage::tr("This mechanism − pinned (%1).").arg(pinnedText(pinned, present));
    if (result.difference->hasGaps) {
        page.sentence += u' ' + ErrorPage::tr("Where one of the two cannot be assembled there is nothing to compare.");
    }
    PageTable table =
        tableWith("differenceTable", ErrorPage::tr("Differences from the pinned motion, a row for each channel"),
                  {ErrorPage::tr("largest difference"), ErrorPage::tr("max |this − pinned|"), "max_difference"});
    std::ranges::transform(result.difference->channels, std::back_inserter(table.rows), pinnedRow);
    page.tables = {table};
    return page;
}

/// How many channels differ, and the largest error in percent of the peak.
struct Distance {
    std::ptrdiff_t differing = 0;
    double percentOfPeak = 0.0;
};

Distance distanceOf(const std::vector<ChannelComparison> &comparison)
{
    Distance distance;
    for (const ChannelComparison &channel : comparison) {
        distance.differing += channel.verdict == Verdict::Differs ? 1 : 0;
        distance.percentOfPeak = std::max(distance.percentOfPeak, channel.percentOfPeak.value_or(0.0));
    }
    return distance;
}

/// Whether the mechanism found is worth taking over: fewer channels differ, or by half as much at most.
bool isBetter(const std::vector<ChannelComparison> &found, const std::vector<ChannelComparison> &now)
{
    constexpr double kMuchNearer = 0.5;
    const Distance after = distanceOf(found);
    const Distance before = distanceOf(now);
    return !found.empty() &&
           (after.differing < before.differing || after.percentOfPeak <= kMuchNearer * before.percentOfPeak);
}

/// Which mechanism the file belongs to, if it is another one than the model.
Finding mechanismFinding(const Result &result, const ReferenceDiagnosis &diagnosis)
{
    const Diagnosis &found = diagnosis.found;
    if (!found.conventions.empty() && found.agreesWithGiven) {
        return {}; // read with the conventions, the file belongs to the model
    }
    const Identification &identification = found.identification;
    const QString summary = summaryText(found);
    Finding finding{identification.hasOneMechanism() ? changeText(found, Mechanism(diagnosis.parameters)) : summary};
    if (!identification.hasMechanism()) {
        return finding;
    }
    const bool takesOver = isBetter(found.identified, result.comparison);
    if (takesOver) {
        offerMechanism(finding, found);
    }
    if (finding.sentence.isEmpty() && (takesOver || !identification.noise.empty())) {
        finding.sentence = ErrorPage::tr("The file fits %1").arg(summary);
    }
    return finding;
}

} // namespace

void offerMechanism(Finding &finding, const Diagnosis &found)
{
    constexpr int kDigits = 9;
    finding.remedy = Remedy::UseFoundMechanism;
    finding.remedyText = found.identification.hasOneMechanism() ? ErrorPage::tr("Use this mechanism")
                                                                : ErrorPage::tr("Use the first of them");
    finding.details = ErrorPage::tr("Sets %1").arg(mechanismText(Mechanism(found.rounded), kDigits));
}

bool isOfFile(const ReferenceDiagnosis *diagnosis, const Result &result)
{
    return diagnosis && result.reference && diagnosis->reference == result.choices.reference;
}

bool isUpToDate(const ReferenceDiagnosis *diagnosis, const Result &result)
{
    return isOfFile(diagnosis, result) && diagnosis->parameters == result.mechanism.parameters();
}

std::vector<Finding> findingsOf(const Result &result, const ReferenceDiagnosis *diagnosis)
{
    std::vector<Finding> findings;
    const Verdict verdict = worstVerdict(result.comparison);
    if (isUpToDate(diagnosis, result) && !result.comparison.empty() && verdict != Verdict::Agrees) {
        for (const ConventionFinding &found : diagnosis->found.conventions) {
            findings.push_back({findingText(found), Remedy::Apply, ErrorPage::tr("Apply"), {}, found.convention});
        }
        for (const QString &sentence : differenceSentences(result.reference->data)) {
            findings.push_back({sentence});
        }
        const Finding mechanism = mechanismFinding(result, *diagnosis);
        const bool isExplained = verdict != Verdict::Differs || !findings.empty();
        if (!mechanism.sentence.isEmpty() && (mechanism.remedy != Remedy::None || !isExplained)) {
            findings.push_back(mechanism);
        }
    }
    if (!result.reference->conventions.empty()) {
        QStringList sentences;
        for (const Convention &convention : result.reference->conventions) {
            sentences << explanationText(convention);
        }
        findings.push_back(
            {ErrorPage::tr("The file is read differently from how it is written. %1").arg(sentences.join(u' ')),
             Remedy::ReadAsPrinted, ErrorPage::tr("Read as written")});
    }
    return findings;
}

Page errorPage(const Result &result, const ReferenceDiagnosis *diagnosis)
{
    if (result.reference) {
        return filePage(result, diagnosis);
    }
    if (result.difference) {
        return pinnedPage(result);
    }
    return {ErrorPage::tr("There is nothing to compare with: no file is open and no motion is pinned."), Tone::Muted};
}

QString errorTitle(const Result &result)
{
    const QString title = ErrorPage::tr("Errors");
    return result.reference ? title + u' ' + lookOf(worstVerdict(result.comparison)).mark : title;
}

} // namespace slidercrank
