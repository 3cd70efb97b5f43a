// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/channels.h"
#include "tests/support/suite.h"
#include "ui/text/explanation.h"
#include "ui/text/identification_text.h"

#include <QLocale>
#include <QTest>

using namespace slidercrank;

namespace tst_explanation
{

using Action = Explanation::Action;
using Cause = Explanation::Cause;
using Outcome = Identification::Outcome;

const ConventionFinding kInDegrees{{Convention::Kind::AngleUnit, {kTheta3}, kDegreesPerRadian}, 98.0, 1e-3};

Identification mechanismFound()
{
    Identification found;
    found.outcome = Outcome::Identified;
    found.identifiable.fill(true);
    found.parameters.b = found.rounded.b = 60.0;
    return found;
}

std::vector<Cause> causesOf(const std::vector<Explanation> &explanations)
{
    std::vector<Cause> causes;
    for (const Explanation &explanation : explanations) {
        causes.push_back(explanation.cause);
    }
    return causes;
}

std::vector<Explanation> explainDifferences(const Identification &found)
{
    return explainDifferences(found, Parameters(), FileLayout());
}

class TestExplanation : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void aConventionCanBeApplied()
    {
        Identification found = mechanismFound();
        found.conventions = {kInDegrees};
        found.agreesWithGiven = true;
        const std::vector<Explanation> explanations = explainDifferences(found);
        QCOMPARE(causesOf(explanations), (std::vector{Cause::Convention, Cause::Agreement}));
        QCOMPARE(explanations[0].action, Action::Apply);
        QCOMPARE(explanations[0].convention, kInDegrees.convention);
        QVERIFY(explanations[0].text.startsWith("theta3: in radians, but read as degrees. Largest error: 98.0 → "));
        QCOMPARE(explanations[1].text, QString("With these corrections, the file agrees with this mechanism."));
        QCOMPARE(explanations[1].action, Action::None);
    }

    void aWrongLengthIsNamedBeforeTheMechanism()
    {
        Identification found = mechanismFound();
        found.change = {Parameter::B, 60.0};
        const std::vector<Explanation> explanations = explainDifferences(found);
        QCOMPARE(causesOf(explanations), (std::vector{Cause::Length, Cause::Mechanism}));
        QCOMPARE(
            textsOf(explanations),
            QStringList({"With b = 60 mm instead of 65 mm, this mechanism agrees with the file.", summaryText(found)}));
        for (const Explanation &explanation : explanations) {
            QCOMPARE(explanation.action, Action::UseMechanism);
        }
    }

    void aFileWithoutAMechanismOffersNothing()
    {
        Identification none;
        none.outcome = Outcome::None;
        const std::vector<Explanation> explanations = explainDifferences(none);
        QCOMPARE(textsOf(explanations), QStringList(summaryText(none)));
        QCOMPARE(explanations.front().action, Action::None);
    }

    void columnsThatWereLeftOutExplainADifferenceOfTheGivenMechanism()
    {
        Identification found = mechanismFound();
        found.agreesWithGiven = true;
        found.leftOut = {{kSliderSpeed, LeftOutColumn::Reason::FiniteDifferences, 2.5}};
        const std::vector<Explanation> explanations = explainDifferences(found);
        QCOMPARE(causesOf(explanations), (std::vector{Cause::LeftOut, Cause::Agreement}));
        QCOMPARE(textsOf(explanations),
                 QStringList({leftOutText(found), "The other columns agree with this mechanism."}));
    }

    void aChangingSpeedExplainsADifferenceOfTheGivenMechanism()
    {
        Identification found = mechanismFound();
        found.agreesWithGiven = true;
        found.drive = {5.0, 0.01, 4.0, 6.0, {}};
        const std::vector<Explanation> explanations = explainDifferences(found);
        QCOMPARE(causesOf(explanations), (std::vector{Cause::Drive, Cause::Agreement}));
        QCOMPARE(textsOf(explanations),
                 QStringList({driveText(found), "Over the crank angle, the file agrees with this mechanism."}));
        QCOMPARE(explanations[0].action, Action::UseMechanism); // which reads the file over the crank angle
    }

    void finiteDifferencesAreNamedOnce()
    {
        FileLayout layout;
        layout.columns = {{.channel = kSlider}, {.channel = kSliderSpeed, .difference = Difference::Forward}};
        Identification none;
        none.outcome = Outcome::None;
        QCOMPARE(causesOf(explainDifferences(none, Parameters(), layout)),
                 (std::vector{Cause::LeftOut, Cause::Mechanism}));
        Identification found = mechanismFound();
        found.leftOut = {{kSliderSpeed, LeftOutColumn::Reason::FiniteDifferences, 2.5}};
        QCOMPARE(textsOf(explainDifferences(found, Parameters(), layout)), QStringList(summaryText(found)));
    }

    void aFileThatAgreesNeedsNoExplanation()
    {
        Identification found = mechanismFound();
        found.agreesWithGiven = true;
        QVERIFY(explainDifferences(found).empty());
    }
};

const Suite<TestExplanation> suite("tst_explanation");

} // namespace tst_explanation

#include "tst_explanation.moc"
