// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/explanation.h"

#include "ui/text/convention_text.h"
#include "ui/text/identification_text.h"

#include <QCoreApplication>

namespace slidercrank
{

namespace
{

using Cause = Explanation::Cause;
using Action = Explanation::Action;

struct ExplanationText {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::ExplanationText)
};

/// Returns the sentence that the file agrees with the model, apart from the other explanations.
QString agreementText(const Identification &found)
{
    if (found.drive) {
        return ExplanationText::tr("Over the crank angle, the file agrees with this mechanism.");
    }
    if (!found.conventions.empty()) {
        return ExplanationText::tr("With these corrections, the file agrees with this mechanism.");
    }
    return found.leftOut.empty() ? ExplanationText::tr("The other rows agree with this mechanism.")
                                 : ExplanationText::tr("The other columns agree with this mechanism.");
}

} // namespace

std::vector<Explanation> explainDifferences(const Identification &found, const Parameters &given,
                                            const FileLayout &layout)
{
    std::vector<Explanation> explanations;
    const auto add = [&explanations](const QString &text, Cause cause, Action action = Action::None) {
        if (!text.isEmpty()) {
            explanations.push_back({.text = text, .cause = cause, .action = action});
        }
    };
    for (const ConventionFinding &finding : found.conventions) {
        explanations.push_back({.text = findingText(finding),
                                .cause = Cause::Convention,
                                .action = Action::Apply,
                                .convention = finding.convention});
    }
    // Otherwise summaryText() or leftOutText() already names the columns of finite differences.
    if (!found.hasMechanism() || found.leftOut.empty()) {
        add(finiteDifferenceSentence(layout), Cause::LeftOut);
    }
    if (!found.agreesWithGiven) {
        add(singleLengthExplanation(found, given), Cause::Length, Action::UseMechanism);
        add(summaryText(found), Cause::Mechanism, found.hasMechanism() ? Action::UseMechanism : Action::None);
        return explanations;
    }
    add(driveText(found), Cause::Drive, Action::UseMechanism);
    add(leftOutText(found), Cause::LeftOut);
    add(outlierText(found), Cause::Outlier);
    if (!explanations.empty()) {
        add(agreementText(found), Cause::Agreement);
    }
    return explanations;
}

QStringList textsOf(const std::vector<Explanation> &explanations)
{
    QStringList texts;
    for (const Explanation &explanation : explanations) {
        texts << explanation.text;
    }
    return texts;
}

} // namespace slidercrank
