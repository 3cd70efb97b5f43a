// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/findings.h"

#include "ui/document/result.h"
#include "ui/text/axis_scale.h"
#include "ui/text/convention_text.h"
#include "ui/text/diagnosis_text.h"
#include "ui/text/finding_text.h"
#include "ui/widgets/named.h"
#include "ui/widgets/paragraph.h"

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace slidercrank
{

namespace
{

/// Of a file that differs: how many channels do, and the largest error as % of its peak.
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

/// Whether the identified mechanism is worth taking over: fewer channels differ, or they differ by half at most.
bool isBetter(const std::vector<ChannelComparison> &identified, const std::vector<ChannelComparison> &now)
{
    constexpr double kMuchNearer = 0.5;
    const Distance found = distanceOf(identified);
    const Distance before = distanceOf(now);
    return !identified.empty() &&
           (found.differing < before.differing || found.percentOfPeak <= kMuchNearer * before.percentOfPeak);
}

/// A line a parameter: old → new, and how it was measured.
QString changesText(const Parameters &before, const Diagnosis &diagnosis)
{
    const Identification &found = diagnosis.identification;
    const Parameters &after = diagnosis.rounded;
    constexpr int kDigits = 9;
    QString rows;
    for (const Parameter parameter : kParameters) {
        const std::size_t i = indexOf(parameter);
        const double inShownUnit = shownFactor(parameter);
        const double value = valueOf(found.parameters, parameter);
        const QString measured =
            found.identifiable[i] ? measuredText(inShownUnit * value, inShownUnit * found.standardError[i], inShownUnit)
                                  : FindingList::tr("kept");
        rows += QStringLiteral("<tr><td>%1 </td><td align=right>%2</td><td> → </td><td>%3</td><td>  (%4)</td></tr>")
                    .arg(symbolOf(parameter), parameterText(parameter, valueOf(before, parameter)),
                         parameterText(parameter, valueOf(after, parameter), kDigits), measured);
    }
    if (before.branch != after.branch) {
        rows += QStringLiteral("<tr><td>%1 </td><td align=right>%2</td><td> → </td><td>%3</td></tr>")
                    .arg(FindingList::tr("assembly"), assemblyText(before.branch), assemblyText(after.branch));
    }
    return FindingList::tr("Now → then (as measured ± standard error)") +
           QStringLiteral("<table style='white-space:pre'>%1</table>").arg(rows);
}

/// What the file means otherwise, and how far it is off without and with that.
QString conventionSentence(const ConventionFinding &found, const ReferenceData &data)
{
    constexpr int kDigits = 3;
    const QString sentence = explanationOf(found.convention, data);
    if (found.convention.kind == Convention::Kind::NotDerivative) {
        return sentence; // left out, it has no error any more
    }
    return FindingList::tr("%1 Largest error: %2 → %3 % of peak.")
        .arg(sentence, shortNumber(found.before, kDigits), shortNumber(found.after, kDigits));
}

/// Which mechanism the file is of, where it is another one than that on show.
Finding mechanismFinding(const Result &result, const ReferenceDiagnosis &diagnosis)
{
    const Identification &found = diagnosis.found.identification;
    Finding finding;
    if (!diagnosis.found.conventions.empty() && diagnosis.found.isOfMechanismAtHand) {
        return finding; // read with the conventions, it is of the one on show
    }
    const QString summary = summaryOf(diagnosis.found);
    if (!found.stands()) {
        finding.sentence = summary;
        return finding;
    }
    const bool isOne = found.hasOneMechanism();
    finding.sentence = isOne ? changeText(diagnosis.found, Mechanism(diagnosis.parameters)) : summary;
    const bool takesOver = isBetter(diagnosis.found.identified, result.comparison);
    if (takesOver) {
        finding.remedy = Finding::Remedy::TakeOver;
        finding.remedyText = isOne ? FindingList::tr("Use this mechanism") : FindingList::tr("Use the first of them");
        finding.details = changesText(result.mechanism.parameters(), diagnosis.found);
    }
    if (finding.sentence.isEmpty() && (takesOver || !found.noise.empty())) {
        finding.sentence = FindingList::tr("The file fits %1").arg(summary);
    }
    return finding;
}

} // namespace

std::vector<Finding> findingsOf(const Result &result, const ReferenceDiagnosis *diagnosis)
{
    std::vector<Finding> findings;
    const auto worst = std::ranges::max_element(result.comparison, {}, &ChannelComparison::verdict);
    const bool agrees = worst == result.comparison.end() || worst->verdict == Verdict::Agrees;
    const bool differs = !agrees && worst->verdict == Verdict::Differs;
    if (diagnosis && !agrees) {
        for (const ConventionFinding &found : diagnosis->found.conventions) {
            findings.push_back({Finding::Remedy::Apply, found.convention,
                                conventionSentence(found, result.reference->data), FindingList::tr("Apply"),
                                effectOf(found)});
        }
        for (const QString &sentence : differenceSentences(result.reference->data, diagnosis->found.conventions)) {
            findings.push_back({Finding::Remedy::None, {}, sentence, {}, {}});
        }
        const Finding mechanism = mechanismFinding(result, *diagnosis);
        const bool isExplained = !differs || !findings.empty();
        if (!mechanism.sentence.isEmpty() && (mechanism.remedy != Finding::Remedy::None || !isExplained)) {
            findings.push_back(mechanism);
        }
    }
    if (!result.reference->conventions.empty()) {
        QStringList names;
        for (const Convention &convention : result.reference->conventions) {
            names << nameOf(convention);
        }
        findings.push_back(
            {Finding::Remedy::ReadAsPrinted,
             {},
             FindingList::tr("Read differently from how it is written: %1.").arg(names.join(FindingList::tr(", "))),
             FindingList::tr("Read as written"),
             {}});
    }
    return findings;
}

FindingList::FindingList(QWidget *parent)
    : QWidget(parent)
{
    setObjectName(QStringLiteral("findings"));
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    hide();
}

void FindingList::setFindings(const std::vector<Finding> &findings)
{
    if (findings == m_findings) {
        return;
    }
    m_findings = findings;
    m_sentences.clear();
    if (m_lines) {
        m_lines->hide();
        m_lines->deleteLater(); // its button may be the one just pressed
    }
    m_lines = new QWidget(this);
    auto *grid = new QGridLayout(m_lines);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setVerticalSpacing(2);
    grid->setColumnStretch(0, 1);
    for (const Finding &finding : findings) {
        const int row = grid->rowCount();
        auto *sentence = named("findingLabel", plainText(finding.sentence));
        grid->addWidget(sentence, row, 0);
        m_sentences.push_back(sentence);
        if (finding.remedy != Finding::Remedy::None) {
            auto *button = named("remedyButton", new QPushButton(finding.remedyText),
                                 tr("%1: %2").arg(finding.remedyText, finding.sentence));
            button->setToolTip(finding.details);
            button->setFocusPolicy(Qt::TabFocus); // it will vanish: a click must not leave the focus to chance
            grid->addWidget(button, row, 1);
            connect(button, &QPushButton::clicked, this, [this, finding] { emit remedyRequested(finding); });
        }
    }
    layout()->addWidget(m_lines);
    setVisible(!findings.empty());
    takeRoom();
}

void FindingList::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    takeRoom();
}

void FindingList::takeRoom()
{
    setMinimumHeight(layout()->hasHeightForWidth() ? layout()->heightForWidth(width()) : 0);
}

void FindingList::setUpToDate(bool upToDate)
{
    for (QLabel *sentence : m_sentences) {
        sentence->setEnabled(upToDate);
    }
}

} // namespace slidercrank
