// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/channels.h"
#include "tests/support/suite.h"
#include "ui/text/identification_text.h"
#include "ui/text/notation.h"
#include "ui/text/written_number.h"

#include <QLocale>
#include <QScopeGuard>
#include <QTest>

#include <numbers>

using namespace slidercrank;

namespace tst_identification_text
{

using Lack = Identification::Lack;
using Rejection = Identification::Rejection;
using Outcome = Identification::Outcome;
using Reason = LeftOutColumn::Reason;
using Symmetry = AlternativeMechanism::Symmetry;

/// A mechanism that was identified; standard errors in mm, rad/s, rad.
Identification identifiedMechanism()
{
    Identification found;
    found.outcome = Outcome::Identified;
    found.parameters = {20.0000012, 59.9999987, 24.9999744, 6.2831856, -3.8e-7};
    found.standardErrors = {3.4e-6, 9.8e-6, 7.6e-6, 3e-7, 2.3e-7};
    found.identifiable = {true, true, true, true, true};
    found.rounded = found.parameters;
    return found;
}

/// The same mechanism with residuals of up to 1.2 % of the range of R4_x and 0.5 % of that of theta3.
Identification approximateMechanism()
{
    Identification found = identifiedMechanism();
    found.outcome = Outcome::Approximate;
    found.residuals = {{kTheta3, 0.02, 0.1, 0.5}, {kSlider, 0.123, 0.48, 1.2}};
    return found;
}

constexpr const char *kMechanism = "a = 20.000001 ± 0.000003 mm, b = 60.00000 ± 0.00001 mm, c = 24.999974 ± 0.000008 "
                                   "mm, ω₂ = 6.2831856 ± 3·10⁻⁷ rad/s, θ₂₀ = −0.00002 ± 0.00001°, open assembly.";

/// Returns the text that a different value of one parameter explains the file. The given mechanism is that of Table 1,
/// where b = 65 mm.
QString singleLengthExplanationFor(Parameter parameter, double value, Outcome outcome = Outcome::Identified)
{
    Identification found;
    found.outcome = outcome;
    found.change = {parameter, value};
    return singleLengthExplanation(found, Parameters());
}

class TestIdentificationText : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void namesTheMechanismWithItsStandardErrors()
    {
        QCOMPARE(summaryText(identifiedMechanism()), QString("Mechanism identified in this file: ") + kMechanism);
    }

    void statesTheResidualsOfAnApproximateMechanism()
    {
        QCOMPARE(summaryText(approximateMechanism()),
                 QString("Mechanism that approximately explains this file: ") + kMechanism +
                     " The columns deviate from its motion by up to 1.20 % of the range of Rₓ⁴, more than by rounding; "
                     "± holds if these errors are independent.");

        Identification byFormula = approximateMechanism();
        byFormula.followsApproximateFormula = true;
        QCOMPARE(
            summaryText(byFormula),
            QString("Mechanism that approximately explains this file: ") + kMechanism +
                " The columns agree with the approximate formula Rₓ⁴ ≈ a cos θ₂ + b − (a sin θ₂ − c)²/2b. From the "
                "exact motion they deviate by up to 1.20 % of the range of Rₓ⁴.");

        Identification systematic = approximateMechanism();
        systematic.hasSystematicResiduals = true;
        systematic.standardErrors.fill(kNone);
        QCOMPARE(
            summaryText(systematic),
            QString("Mechanism that approximately explains this file: a ≈ 20 mm, b ≈ 60 mm, c ≈ 25 mm, "
                    "ω₂ ≈ 6.283 rad/s, θ₂₀ ≈ −2.177·10⁻⁵°, open assembly. The columns deviate from its motion by "
                    "up to 1.20 % of the range of Rₓ⁴. The residuals are systematic, so that no standard errors can be "
                    "given: the data may be filtered, interpolated or integrated, or the crank speed may vary."));
        QCOMPARE(measuredText(Parameter::B, systematic, notation()), QString("60 mm"));

        QCOMPARE(residualTable(systematic.residuals),
                 (std::vector<QStringList>{{"channel", "rms residual", "largest residual", "% of range"},
                                           {"theta3 [°]", "0.0200", "0.100", "0.500"},
                                           {"R4_x [mm]", "0.123", "0.480", "1.20"}}));
    }

    void anAngleAloneDeterminesRatios()
    {
        Identification found = identifiedMechanism();
        found.lengthScale = Identification::LengthScale::GivenCrank;
        found.parameters.a = 10.0;
        found.parameters.b = 30.0;
        found.parameters.c = 12.5;
        found.identifiable = {false, false, false, true, true};
        found.standardErrors = {kNone, 2e-5, kNone, 3e-7, 2.3e-7};
        const QString text = summaryText(found);
        QVERIFY2(text.contains(": b = 30.00000 ± 0.00002 mm, c = 12.5 mm, ω₂ = "), qPrintable(text));
        QVERIFY2(text.endsWith("open assembly. The coupler angle θ³ alone determines only b/a and c/a. The data do not "
                               "determine a. Kept as given: a = 10 mm."),
                 qPrintable(text));
        QCOMPARE(measuredText(Parameter::A, found, notation()), QString("–"));
        QCOMPARE(measuredText(Parameter::B, found, notation()), QString("30.00000 ± 0.00002 mm"));
    }

    void derivativesOverTheAngleDetermineTheLengthsForTheGivenSpeed()
    {
        Identification found = identifiedMechanism();
        found.lengthScale = Identification::LengthScale::GivenSpeed;
        found.parameters.a = 10.0;
        found.identifiable = {};
        const QString text = summaryText(found);
        QVERIFY2(text.contains(": a = 10"), qPrintable(text));
        QVERIFY2(text.contains("the lengths hold for the given ω₂. The data do not determine ω₂ and θ₂₀."),
                 qPrintable(text));
    }

    void addsEachReservation()
    {
        struct Row {
            void (*change)(Identification &);
            const char *sentence;
        };
        const Row rows[] = {
            {[](Identification &found) {
                 found.alternatives = {{Symmetry::MirrorImage, {}}};
             },
             "Its mirror image, with c, ω₂ and θ₂₀ negated, gives the same values."},
            {[](Identification &found) {
                 found.alternatives = {{Symmetry::ReversedCrank, {}}};
             },
             "A crank that rotates in the opposite direction, from 180° − θ₂₀, gives the same values."},
            {[](Identification &found) {
                 found.alternatives = {{Symmetry::OtherAssembly, {}}};
             },
             "The other assembly, with c negated and θ₂₀ increased by 180°, gives the same values."},
            {[](Identification &found) {
                 found.identifiable[indexOf(Parameter::Omega2)] = false;
                 found.identifiable[indexOf(Parameter::Theta20)] = false;
                 found.parameters.omega2 = 2.0;
                 found.parameters.theta20 = 0.0;
             },
             "The data do not determine ω₂ and θ₂₀. Kept as given: ω₂ = 2 rad/s, θ₂₀ = 0°."},
            {[](Identification &found) {
                 found.possibleSpeeds = {2.0 * std::numbers::pi, 360.0};
             },
             "The derivatives allow ω₂ = 6.28319 or 360 rad/s, because their unit is uncertain (radians or "
             "degrees, mm or cm?): state it in the headings."},
            {[](Identification &found) {
                 found.leftOut = {{kSliderSpeed, Reason::FiniteDifferences, 1.25}, {kTheta3, Reason::Unknown, 3.0}};
             },
             "Columns left out of the fit: v⁴ (agrees with finite differences, not with the derivative; off by up to "
             "1.25 % of its "
             "peak), θ³ (does not fit the other columns; off by up to 3.00 % of its peak)."},
            {[](Identification &found) {
                 found.leftOut = {{kSliderSpeed, Reason::UnevenSpeed}};
             },
             "Columns left out of the fit: v⁴ (the crank speed is not constant)."},
            {[](Identification &found) {
                 found.excludedRows = {3, 17};
             },
             "Outliers that were excluded: 2 (lines 3, 17)."},
            {[](Identification &found) { found.excludedRows = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}; },
             "Outliers that were excluded: 12 (lines 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, …)."},
        };
        for (const auto &[change, sentence] : rows) {
            Identification found = identifiedMechanism();
            change(found);
            const QString text = summaryText(found);
            QVERIFY2(text.endsWith(u' ' + QString::fromUtf8(sentence)), qPrintable(text));
        }
    }

    void saysHowTheCrankSpeedVaries()
    {
        Identification found = identifiedMechanism();
        QCOMPARE(driveText(found), QString());
        QCOMPARE(shownDriveText(found, 8.0), QString());
        found.drive = {6.2831856, 3e-7, 5.0, 9.5, {}};
        QCOMPARE(driveText(found), QString("The crank speed varies from 5 to 9.5 rad/s."));
        QVERIFY(summaryText(found).contains("ω₂ = 6.2831856 ± 3·10⁻⁷ rad/s on average, "));
        QVERIFY(summaryText(found).endsWith(driveText(found)));
        found.drive->alpha2 = 10.0;
        QCOMPARE(driveText(found),
                 QString("The crank speed varies from 5 to 9.5 rad/s; it changes evenly, α₂ = 10 rad/s²."));
        QVERIFY(summaryText(found).contains("ω₂ = 6.2831856 ± 3·10⁻⁷ rad/s at t = 0, "));
        QCOMPARE(shownDriveText(found, 7.25),
                 driveText(found) + " The window shows the motion at the mean speed, 7.25 rad/s, because a changing "
                                    "speed is not modelled: compare the positions over the crank angle.");
    }

    void saysWhatAnInsufficientFileDetermines()
    {
        Identification found;
        found.outcome = Outcome::Insufficient;
        found.lack = Lack::OpenParameters;
        found.parameters = {20.1, 65.0, 25.0, 6.28, 0.0};
        found.standardErrors[indexOf(Parameter::A)] = 0.3;
        found.standardErrors[indexOf(Parameter::Omega2)] = 0.01;
        found.openParameters = {false, true, true, false, true};
        QCOMPARE(summaryText(found),
                 QString("This file does not determine the mechanism. It determines a = 20.1 ± 0.3 mm and ω₂ = 6.28 ± "
                         "0.01 rad/s. Open: b, c and θ₂₀. A longer part of a revolution, derivatives, θ₂ or more "
                         "digits would help."));
    }

    void saysWhyThereIsNoMechanism()
    {
        Identification found;
        QStringList sentences;
        found.outcome = Outcome::Insufficient;
        for (const auto lack :
             {Lack::FewValues, Lack::NothingMoves, Lack::FewRowsPerTurn, Lack::UnevenSpeed, Lack::OpenParameters}) {
            found.lack = lack;
            sentences << summaryText(found);
        }
        found.outcome = Outcome::None;
        for (const auto rejection : {Rejection::LargeResiduals, Rejection::SliderLine, Rejection::CannotBeAssembled}) {
            found.rejection = rejection;
            sentences << summaryText(found);
        }
        found.stopped = true;
        sentences << summaryText(found);
        for (const QString &sentence : sentences) {
            QVERIFY2(sentence.endsWith(u'.') && !sentence.contains("a =") && !sentence.contains(u'%'),
                     qPrintable(sentence));
        }
        QCOMPARE(sentences.removeDuplicates(), 0);
    }

    void statesTheDeviationOfTheBestAttemptWithoutItsParameters()
    {
        Identification none;
        none.outcome = Outcome::None;
        none.residuals = {{kTheta3, 1.0, 4.0, 12.345}, {kSlider, 1.0, 3.0, 5.0}};
        QCOMPARE(summaryText(none), QString("No mechanism explains this file. The best attempt deviates by up to 12.3 "
                                            "% of the range of θ³: check the meaning and the units of the columns. "
                                            "Unless the crank speed is constant, the file must contain θ₂."));
        QCOMPARE(roundNumbersText(none), QString());
    }

    void namesRoundNumbersThatFitEquallyWell()
    {
        Identification found = identifiedMechanism();
        QCOMPARE(roundNumbersText(found), QString());
        found.rounded = {20.0, 60.0, 25.0, 6.25, 0.0};
        QCOMPARE(roundNumbersText(found), QString("Rounded values that fit equally well: a = 20 mm, b = 60 mm, c = 25 "
                                                  "mm, ω₂ = 6.25 rad/s, θ₂₀ = 0°."));
        found.identifiable[indexOf(Parameter::Theta20)] = false;
        found.drive = {6.25, 0.1, 5.0, 7.0, {}}; // a speed that is not constant
        QCOMPARE(roundNumbersText(found),
                 QString("Rounded values that fit equally well: a = 20 mm, b = 60 mm, c = 25 mm."));
    }

    /// A former defect: in a window in inches, 20 mm was the "rounded" 0.787401575 in.
    void roundNumbersAreRoundInTheirUnit()
    {
        const auto restore = qScopeGuard([] { setNotation({}); });
        Identification found = identifiedMechanism();
        found.rounded = {20.0, 60.0, 25.0, 6.25, 0.0};
        setNotation({.units = {.length = LengthUnit::Inch}});
        QVERIFY2(roundNumbersText(found).contains(": a = 20 mm, b = 60 mm, c = 25 mm, "),
                 qPrintable(roundNumbersText(found)));
        found.rounded = {50.8, 152.4, 12.7, 6.25, 0.0};
        QVERIFY2(roundNumbersText(found).contains(": a = 2 in, b = 6 in, c = 0.5 in, "),
                 qPrintable(roundNumbersText(found)));
        setNotation({.units = {.length = LengthUnit::Metre}});
        QVERIFY2(roundNumbersText(found).contains(": a = 0.0508 m, b = 0.1524 m, c = 0.0127 m, "),
                 qPrintable(roundNumbersText(found)));
    }

    void namesTheLengthThatExplainsTheDifference()
    {
        QCOMPARE(singleLengthExplanation(Identification(), Parameters()), QString());
        QCOMPARE(singleLengthExplanationFor(Parameter::B, 59.9999987),
                 QString("With b = 60 mm instead of 65 mm, this mechanism agrees with the file."));
        QCOMPARE(singleLengthExplanationFor(Parameter::B, 60.0, Outcome::Approximate),
                 QString("With b = 60 mm instead of 65 mm, this mechanism fits the file as well as any other."));
        Identification uneven = identifiedMechanism();
        uneven.change = {Parameter::B, 60.0};
        uneven.drive = {5.0, 0.1, 4.0, 6.0, {}};
        QVERIFY(singleLengthExplanation(uneven, Parameters())
                    .endsWith("the file. The crank speed of the file is not constant."));
        QVERIFY(
            singleLengthExplanationFor(Parameter::B, 65.00002).startsWith("With b = 65.00002 mm instead of 65 mm, "));
        QLocale::setDefault(QLocale(QLocale::Spanish, QLocale::Spain));
        const QString spanish = singleLengthExplanationFor(Parameter::B, 60.5);
        QLocale::setDefault(QLocale::c());
        QVERIFY2(spanish.contains("60,5 mm instead of 65 mm"), qPrintable(spanish));
    }

    void writesLengthsInTheUnitOfTheFileUnlessOneIsChosen()
    {
        Identification found = identifiedMechanism();
        found.lengthUnit = 25.4;
        found.parameters.a = 50.7999;
        found.rounded.a = 50.8;
        found.standardErrors[indexOf(Parameter::A)] = 2.54e-4;
        found.change = {Parameter::B, 152.4};
        const auto allTexts = [&found] {
            return QStringList{summaryText(found), roundNumbersText(found),
                               singleLengthExplanation(found, Parameters())};
        };
        QStringList texts = allTexts();
        QVERIFY2(texts[0].contains("a = 2.00000 ± 0.00001 in, "), qPrintable(texts[0]));
        QVERIFY2(texts[1].contains("a = 2 in, "), qPrintable(texts[1]));
        QVERIFY2(texts[2].contains("b = 6 in instead of 2.55906 in, "), qPrintable(texts[2]));
        found.identifiable[indexOf(Parameter::A)] = false;
        QVERIFY2(summaryText(found).contains("Kept as given: a = 2 in."), qPrintable(summaryText(found)));
        found.identifiable[indexOf(Parameter::A)] = true;

        setNotation({.units = {.length = LengthUnit::Centimetre}});
        texts = allTexts();
        setNotation({});
        QVERIFY2(texts[0].contains("a = 5.07999 ± 0.00003 cm, "), qPrintable(texts[0]));
        QVERIFY2(texts[1].contains("a = 5.08 cm, "), qPrintable(texts[1]));
        QVERIFY2(texts[2].contains("b = 15.24 cm instead of 6.5 cm, "), qPrintable(texts[2]));

        found.lengthUnit = 304.8; // feet are not shown
        QVERIFY2(summaryText(found).contains("a = 50.7999 ± 0.0003 mm, "), qPrintable(summaryText(found)));
    }

    void namesInJsonAreFrozen()
    {
        QCOMPARE(outcomeName(Outcome::Identified), "identified");
        QCOMPARE(outcomeName(Outcome::Approximate), "approximate");
        QCOMPARE(outcomeName(Outcome::Insufficient), "insufficient");
        QCOMPARE(outcomeName(Outcome::None), "none");
        QCOMPARE(reasonName(Reason::FiniteDifferences), "finite-differences");
        QCOMPARE(reasonName(Reason::UnevenSpeed), "uneven-speed");
        QCOMPARE(reasonName(Reason::OpenSpeed), "open-speed");
        QCOMPARE(reasonName(Reason::OtherMotion), "other-motion");
        QCOMPARE(reasonName(Reason::Unknown), "unknown");
        QCOMPARE(symmetryName(Symmetry::MirrorImage), "mirror-image");
        QCOMPARE(symmetryName(Symmetry::ReversedCrank), "reversed");
        QCOMPARE(symmetryName(Symmetry::OtherAssembly), "other-assembly");
    }
};

const Suite<TestIdentificationText> suite("tst_identification_text");

} // namespace tst_identification_text

#include "tst_identification_text.moc"
