// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/channels.h"
#include "ui/text/diagnosis_text.h"
#include "ui/text/finding_text.h"

#include <QLocale>
#include <QTest>

#include <numbers>

using namespace slidercrank;

namespace
{

using Lack = Identification::Lack;
using Outcome = Identification::Outcome;
using Why = Identification::Alternative::Why;

/// A mechanism that was identified; standard errors in mm, rad/s, rad.
Diagnosis identified()
{
    Diagnosis diagnosis;
    Identification &found = diagnosis.identification;
    found.outcome = Outcome::Identified;
    found.parameters = {20.0000012, 59.9999987, 24.9999744, 6.2831856, -3.8e-7};
    found.standardError = {3.4e-6, 9.8e-6, 7.6e-6, 3e-7, 2.3e-7};
    found.identifiable = {true, true, true, true, true};
    diagnosis.rounded = found.parameters;
    return diagnosis;
}

/// Beside Table 1, where b = 65 mm.
QString changed(Parameter parameter, double value, double explained)
{
    Diagnosis diagnosis;
    diagnosis.change = {parameter, value, explained};
    return changeText(diagnosis, Mechanism());
}

} // namespace

class TestDiagnosisText : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void namesTheMechanismWithItsStandardErrors()
    {
        QCOMPARE(summaryText(identified()),
                 QString("a = 20.000001 ± 0.000003 mm, b = 60.00000 ± 0.00001 mm, c = 24.999974 ± 0.000008 mm, "
                         "ω₂ = 6.2831856 ± 3·10⁻⁷ rad/s, θ₂₀ = −0.00002 ± 0.00001°, open assembly."));
        Diagnosis approximate = identified();
        approximate.identification.outcome = Outcome::Approximate;
        ChannelComparison channel;
        channel.percentOfPeak = 0.0213;
        approximate.identified = {channel};
        const QString text = summaryText(approximate);
        QVERIFY2(text.startsWith("a ≈ 20 mm, b ≈ 60 mm, c ≈ 25 mm, ω₂ ≈ 6.28 rad/s, ") && text.contains("0.0213 %"),
                 qPrintable(text));
        QCOMPARE(measuredText(Parameter::B, approximate.identification), QString("60 mm"));
    }

    void anAngleAloneDeterminesRatios()
    {
        Diagnosis diagnosis = identified();
        Identification &found = diagnosis.identification;
        found.onlyRatios = true;
        found.parameters.a = 10.0;
        found.parameters.b = 30.0;
        found.parameters.c = 12.5;
        found.identifiable = {false, false, false, true, true};
        found.standardError = {kNone, 2e-5, kNone, 3e-7, 2.3e-7};
        const QString text = summaryText(diagnosis);
        QVERIFY2(text.startsWith("b = 30.00000 ± 0.00002 mm, c = 12.5 mm, ω₂ = "), qPrintable(text));
        QVERIFY2(text.endsWith("open assembly. The coupler angle θ³ alone determines only b/a and c/a. The data do not "
                               "determine a = 10 mm: kept as given."),
                 qPrintable(text));
        QCOMPARE(measuredText(Parameter::A, found), QString("–"));
        QCOMPARE(measuredText(Parameter::B, found), QString("30.00000 ± 0.00002 mm"));
    }

    void addsEachCaveat()
    {
        QCOMPARE(caveatText(identified()), QString());
        struct Row {
            void (*change)(Diagnosis &);
            const char *sentence;
        };
        const Row rows[] = {
            {[](Diagnosis &d) {
                 d.identification.alternatives = {{Why::MirrorImage, {}}};
             },
             "These columns cannot tell it from its mirror image, with c, ω₂ and θ₂₀ negated."},
            {[](Diagnosis &d) {
                 d.identification.alternatives = {{Why::Reversed, {}}};
             },
             "These columns cannot tell it from one that rotates in the opposite direction, from 180° − θ₂₀."},
            {[](Diagnosis &d) {
                 d.identification.alternatives = {{Why::OtherAssembly, {}}};
             },
             "These columns cannot tell it from the other assembly, with c negated and θ₂₀ increased by 180°."},
            {[](Diagnosis &d) {
                 d.identification.identifiable[indexOf(Parameter::Omega2)] = false;
                 d.identification.identifiable[indexOf(Parameter::Theta20)] = false;
                 d.identification.parameters.omega2 = 2.0;
                 d.identification.parameters.theta20 = 0.0;
             },
             "The data do not determine ω₂ = 2 rad/s and θ₂₀ = 0°: kept as given."},
            {[](Diagnosis &d) {
                 d.identification.leftOut = {{kTheta3, 1.25}, {kSlider, 3.0}};
             },
             "Columns left out, because they deviate from the motion of the others: θ³ (1.25 % of its peak), Rₓ⁴ (3.00 "
             "% "
             "of its peak)."},
            {[](Diagnosis &d) {
                 d.identification.excludedRows = {3, 17};
             },
             "Rows left out, because they are far off the motion: 2. Lines of the file: 3, 17."},
            {[](Diagnosis &d) {
                 d.identification.noise = {{kTheta3, 0.0512}, {kSlider, 0.1234}};
             },
             "What remains looks like noise: θ³ 0.0512° and Rₓ⁴ 0.123 mm (rms)."},
            {[](Diagnosis &d) {
                 d.unevenCrank = {2.0 * std::numbers::pi, 9.5};
             },
             "The crank speed is not constant: 6.28319 rad/s at the start and 9.5 rad/s at the end."},
        };
        for (const auto &[change, sentence] : rows) {
            Diagnosis found = identified();
            change(found);
            QCOMPARE(caveatText(found), QString::fromUtf8(sentence));
            QVERIFY(summaryText(found).endsWith(u' ' + QString::fromUtf8(sentence)));
        }
    }

    void listsEachMechanismThatFits()
    {
        Diagnosis found = identified();
        found.identification.outcome = Outcome::Ambiguous;
        found.identification.alternatives = {{Why::Alias, {}}, {Why::AnotherMechanism, {}}};
        const QString text = summaryText(found);
        const QString table1 = mechanismText(Mechanism());
        QVERIFY2(text.startsWith("3 mechanisms fit this file equally well: a = 20.000001 ± 0.000003 mm, ") &&
                     text.endsWith("open assembly; " + table1 + "; " + table1 +
                                   ". More time steps per revolution, derivatives or θ₂ would tell them apart."),
                 qPrintable(text));
        QCOMPARE(roundNumbersText(found), QString());
    }

    void doesNotCallTheNearestMechanismAFit()
    {
        Diagnosis found;
        found.identification.outcome = Outcome::Nearest;
        found.identification.parameters.b = 61.23456;
        found.rounded = found.identification.parameters;
        ChannelComparison channel;
        channel.channel = kSlider;
        channel.percentOfPeak = 12.345;
        found.identified = {channel};
        const QString text = "No mechanism fits this file. The nearest: a = 20 mm, b = 61.23 mm, c = 25 mm, ω₂ = 6.283 "
                             "rad/s, θ₂₀ = 0°, open assembly, off by up to 12.3 % of peak, in Rₓ⁴.";
        QCOMPARE(summaryText(found), text);
        found.identification.leftOut = {{kTheta3, 40.0}};
        QCOMPARE(summaryText(found),
                 text + " It fits the other columns, but these disagree with them: θ³ (40.0 % of its peak).");
        QCOMPARE(roundNumbersText(found), QString());
    }

    void saysWhyThereIsNoMechanism()
    {
        Diagnosis none;
        Identification &found = none.identification;
        QStringList sentences{summaryText(none)};
        found.outcome = Outcome::Insufficient;
        found.openParameters = {false, true, true, false, true};
        for (const auto lack : {Lack::FewValues, Lack::NothingMoves, Lack::OpenParameters, Lack::NotParabolic}) {
            found.lack = lack;
            sentences << summaryText(none);
            QCOMPARE(foundText(none), sentences.last()); // does not announce a mechanism
        }
        QVERIFY(sentences[3].startsWith("These data do not determine b, c and θ₂₀: "));
        found.stopped = true;
        sentences << summaryText(none);
        for (const QString &sentence : sentences) {
            QVERIFY2(sentence.endsWith(u'.') && !sentence.contains("a =") && !sentence.contains(u'%'),
                     qPrintable(sentence));
        }
        QCOMPARE(sentences.removeDuplicates(), 0);
        Diagnosis uneven;
        uneven.unevenCrank = {2.0 * std::numbers::pi, 9.5};
        QCOMPARE(summaryText(uneven),
                 QString("The crank speed is not constant: 6.28319 rad/s at the start and 9.5 rad/s at "
                         "the end. No mechanism fits this file."));
    }

    void explanationsAgreeWithEachOther()
    {
        Diagnosis given; // read differently, it is the given mechanism, but too little to identify it
        given.identification.outcome = Outcome::Insufficient;
        given.conventions = {{{Convention::Kind::AngleUnit, {kTheta3}, kDegreesPerRadian}, 98.0, 1e-3}};
        given.agreesWithGiven = true;
        const QStringList lines = explanationLines(given, {}, Mechanism());
        QCOMPARE(lines.size(), qsizetype(2));
        QVERIFY(lines.first().startsWith("theta3: in radians, but read as degrees. Largest error: 98.0 → "));
        QCOMPARE(lines.last(), QString("Read this way, it does not differ from this mechanism."));

        Diagnosis none;
        none.identification.outcome = Outcome::None;
        QCOMPARE(explanationLines(none, {}, Mechanism()), QStringList(summaryText(none)));

        Diagnosis other = identified();
        other.change = {Parameter::B, 60.0, 0.9999999};
        other.rounded.a = 20.0;
        QCOMPARE(explanationLines(other, {}, Mechanism()),
                 QStringList({"With b = 60 mm instead of 65 mm, 99.9999 % of the difference disappears.",
                              "Mechanism found in this file: " + summaryText(other)}));
        QVERIFY(roundNumbersText(other).startsWith("Nominal values fit equally well: a = 20 mm, "));
    }

    void namesTheParameterThatExplainsTheDifference()
    {
        QCOMPARE(changeText(Diagnosis(), Mechanism()), QString());
        const std::pair<double, const char *> rows[] = {
            {1.0, "99.9999 %"},      {1.0 - 1e-15, "99.9999 %"}, {1.0 - 3e-9, "99.9999 %"},
            {0.999995, "99.9995 %"}, {0.9992, "99.92 %"},        {0.995, "99.5 %"},
            {0.99, "99 %"}};
        for (const auto &[explained, percent] : rows) { // never all of it
            QCOMPARE(changed(Parameter::B, 59.9999987, explained),
                     QString("With b = 60 mm instead of 65 mm, %1 of the difference disappears.").arg(percent));
        }
        QVERIFY(
            changed(Parameter::Theta20, std::numbers::pi / 36.0, 0.9999).startsWith("With θ₂₀ = 5° instead of 0°, "));
        QVERIFY(changed(Parameter::B, 65.00002, 0.9999).startsWith("With b = 65.00002 mm instead of 65 mm, "));
        QLocale::setDefault(QLocale(QLocale::Spanish, QLocale::Spain));
        const QString spanish = changed(Parameter::B, 60.5, 1.0 - 3e-9);
        QLocale::setDefault(QLocale::c());
        QVERIFY2(spanish.contains("60,5 mm instead of 65 mm, 99,9999 %"), qPrintable(spanish));
    }
};

QTEST_GUILESS_MAIN(TestDiagnosisText)
#include "tst_diagnosis_text.moc"
