// SPDX-License-Identifier: GPL-3.0-or-later
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

constexpr Channel kTheta3{Theta3, Order::Position};
constexpr Channel kSlider{R4x, Order::Position};

/// As the author's own file gives it, measured: formulation and standard errors in mm, rad/s, rad.
Diagnosis authorsFile()
{
    Diagnosis diagnosis;
    Identification &found = diagnosis.identification;
    found.outcome = Outcome::Identified;
    found.parameters.a = 20.0000012;
    found.parameters.b = 59.9999987;
    found.parameters.c = 24.9999744;
    found.parameters.omega2 = 6.2831856;
    found.parameters.theta20 = -3.8e-7;
    found.standardError = {3.4e-6, 9.8e-6, 7.6e-6, 3e-7, 2.3e-7};
    found.identifiable = {true, true, true, true, true};
    diagnosis.rounded = found.parameters;
    return diagnosis;
}

Identification::Alternative alternative(Why why)
{
    return {why, Parameters()};
}

/// Against Table 1.
QString textOfChange(Parameter parameter, double value, double explained)
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

    void saysWhichMechanismWasFound()
    {
        QCOMPARE(summaryOf(authorsFile()),
                 QString("a = 20.000001 ± 0.000003 mm, b = 60.00000 ± 0.00001 mm, c = 24.999974 ± 0.000008 mm, "
                         "ω₂ = 6.2831856 ± 0.0000003 rad/s, θ₂₀ = -0.00002 ± 0.00001°, open assembly."));
    }

    void saysWhatAnAngleAloneCannotFix()
    {
        Diagnosis diagnosis = authorsFile();
        Identification &found = diagnosis.identification;
        found.onlyRatios = true;
        found.parameters.a = 10.0;
        found.parameters.b = 30.0;
        found.parameters.c = 12.5;
        found.identifiable = {false, false, false, true, true};
        found.standardError = {kNone, kNone, kNone, 3e-7, 2.3e-7};
        const QString text = summaryOf(diagnosis);
        QVERIFY2(text.startsWith("b/a = 3, c/a = 1.25, ω₂ = "), qPrintable(text));
        QVERIFY2(
            text.endsWith(
                "open assembly. The coupler angle θ³ alone determines only b/a and c/a; a = 10 mm is taken as given."),
            qPrintable(text));
        QVERIFY(!text.contains("do not fix"));
        found.standardError[indexOf(Parameter::B)] = 2e-5; // with a held
        QVERIFY2(summaryOf(diagnosis).startsWith("b/a = 3.000000 ± 0.000002, c/a = 1.25"),
                 qPrintable(summaryOf(diagnosis)));
        QCOMPARE(measuredText(Parameter::A, found), QString("–"));
        QCOMPARE(measuredText(Parameter::B, found), QString("3.000000 ± 0.000002 a"));
    }

    void keepsCaveatsApart()
    {
        QCOMPARE(caveatsOf(authorsFile()), QString());
        Diagnosis found = authorsFile();
        found.identification.alternatives = {alternative(Why::MirrorImage)};
        QCOMPARE(summaryOf(found), summaryOf(authorsFile()) + u' ' + caveatsOf(found));
        QCOMPARE(measuredText(Parameter::B, found.identification), QString("60.00000 ± 0.00001 mm"));
    }

    void saysThatLengthsMayBeMetres()
    {
        Diagnosis found = authorsFile();
        found.rounded.a = 0.04;
        found.mayBeInMetres = true;
        QCOMPARE(caveatsOf(found),
                 QString("The file does not say the unit of its lengths, and they were read as mm: if "
                         "they are metres, a = 40 mm; then write [m] behind the names."));
    }

    void saysWhatElseMovesAlike_data()
    {
        QTest::addColumn<Why>("why");
        QTest::addColumn<QString>("sentence");
        QTest::newRow("mirror image") << Why::MirrorImage
                                      << "These columns cannot tell it from its mirror image (c, ω₂ and θ₂₀ negated).";
        QTest::newRow("reversed") << Why::Reversed
                                  << "These columns cannot tell it from one that turns the other way, from 180° − θ₂₀.";
        QTest::newRow("other assembly")
            << Why::OtherAssembly
            << "These columns cannot tell it from the other assembly with c negated and θ₂₀ half a turn on.";
    }

    void saysWhatElseMovesAlike()
    {
        QFETCH(const Why, why);
        QFETCH(const QString, sentence);
        Diagnosis found = authorsFile();
        found.identification.alternatives = {alternative(why)};
        QCOMPARE(caveatsOf(found), sentence);
    }

    void saysWhatElseTheDataDoNotFix()
    {
        Diagnosis diagnosis = authorsFile();
        Identification &found = diagnosis.identification;
        found.identifiable[indexOf(Parameter::Omega2)] = false;
        found.identifiable[indexOf(Parameter::Theta20)] = false;
        found.parameters.omega2 = 2.0;
        found.parameters.theta20 = 0.0;
        const QString text = summaryOf(diagnosis);
        QVERIFY2(text.endsWith(" The data do not determine ω₂ = 2 rad/s and θ₂₀ = 0°: kept as given."),
                 qPrintable(text));
        QVERIFY(!text.contains("ω₂ = 2 ±"));
    }

    void saysWhatNoiseIsLeft()
    {
        Diagnosis found = authorsFile();
        found.identification.noise = {{kTheta3, 0.0512}, {kSlider, 0.1234}};
        QCOMPARE(caveatsOf(found), QString("What remains looks like noise: θ³ 0.0512° and Rₓ⁴ 0.123 mm (rms)."));
    }

    void listsEachMechanismThatExplainsTheFile()
    {
        Diagnosis found = authorsFile();
        found.identification.outcome = Outcome::Ambiguous;
        found.identification.alternatives = {alternative(Why::Alias), alternative(Why::AnotherMechanism)};
        const QString text = summaryOf(found);
        QVERIFY2(text.startsWith("3 mechanisms explain this file equally: a = 20.000001 ± 0.000003 mm, "),
                 qPrintable(text));
        const QString table1 = mechanismText(Mechanism());
        QVERIFY2(text.endsWith("open assembly; or " + table1 + " (another speed that meets the same instants); or " +
                               table1 + ". More instants a turn, derivatives or θ₂ would tell them apart."),
                 qPrintable(text));
        QCOMPARE(roundNumbersText(found), QString());
    }

    void saysWhatComesNearestAsJustThat()
    {
        Diagnosis found;
        found.identification.outcome = Outcome::Nearest;
        found.identification.parameters.b = 61.23456;
        found.rounded = found.identification.parameters;
        ChannelComparison channel;
        channel.channel = kSlider;
        channel.percentOfPeak = 12.345;
        found.identified = {channel};
        QCOMPARE(summaryOf(found),
                 QString("No mechanism was found that explains this file. The nearest: a = 20 mm, b = 61.23 mm, c = 25 "
                         "mm, ω₂ = 6.283 rad/s, θ₂₀ = 0°, open assembly, off by up to 12.3 % of peak, in Rₓ⁴."));
        QCOMPARE(roundNumbersText(found), QString());
    }

    void saysWhyThereIsNoMechanism()
    {
        Diagnosis none;
        Identification &found = none.identification;
        QStringList sentences{summaryOf(none)};
        found.outcome = Outcome::Insufficient;
        for (const auto lack : {Lack::FewValues, Lack::FewInstants, Lack::NothingMoves, Lack::NoEvidence,
                                Lack::OpenParameters, Lack::Crooked}) {
            found.lack = lack;
            sentences << summaryOf(none);
        }
        found.stopped = true;
        sentences << summaryOf(none);
        for (const QString &sentence : sentences) {
            QVERIFY2(sentence.endsWith(u'.') && !sentence.contains("a =") && !sentence.contains("No slider-crank"),
                     qPrintable(sentence));
        }
        QCOMPARE(sentences.removeDuplicates(), 0);
    }

    void namesWhatIsOpen()
    {
        Diagnosis none;
        none.identification.outcome = Outcome::Insufficient;
        none.identification.lack = Lack::OpenParameters;
        none.identification.openParameters = {false, true, true, false, true};
        QVERIFY2(summaryOf(none).startsWith("These data do not determine b, c and θ₂₀: "), qPrintable(summaryOf(none)));
    }

    void saysThatTheCrankSpeedIsNotConstant()
    {
        const QString sentence = "The crank speed is not constant: θ₂ turns at 6.283 rad/s at the start and 9.5 rad/s "
                                 "at the end.";
        Diagnosis none;
        none.unevenCrank = {2.0 * std::numbers::pi, 9.5};
        QCOMPARE(summaryOf(none), sentence + " No mechanism was found that explains this file.");
        Diagnosis found = authorsFile();
        found.unevenCrank = none.unevenCrank;
        QCOMPARE(caveatsOf(found), sentence);
    }

    void itsSentencesAgreeWithEachOther()
    {
        const Convention radians{Convention::Kind::AngleUnit, {kTheta3}, kDegreesPerRadian};

        Diagnosis atHand; // as it reads, too little to tell the mechanism by
        atHand.identification.outcome = Outcome::Insufficient;
        atHand.conventions = {{radians, 98.0, 1e-3}};
        atHand.isOfMechanismAtHand = true;
        const QStringList read = explanationLines(atHand, {}, Mechanism());
        QCOMPARE(read.size(), qsizetype(2));
        QVERIFY(read.first().startsWith("theta3: in radians, but read as degrees. Multiplies theta3"));
        QCOMPARE(read.last(), QString("Read this way, it does not differ from this mechanism."));

        Diagnosis none; // without another reading there is no "read so"
        none.identification.outcome = Outcome::None;
        QCOMPARE(explanationLines(none, {}, Mechanism()), QStringList(summaryOf(none)));

        Diagnosis other = authorsFile();
        other.change = {Parameter::B, 60.0, 0.9999999};
        QCOMPARE(explanationLines(other, {}, Mechanism()),
                 QStringList({"This error looks like b = 60 instead of 65 mm, which explains 99.9999 % of it.",
                              "The file's own mechanism: " + summaryOf(other)}));
    }

    void namesTheChangeThatExplainsTable1()
    {
        QCOMPARE(textOfChange(Parameter::B, 59.9999987, 1.0 - 3e-9),
                 QString("This error looks like b = 60 instead of 65 mm, which explains 99.9999 % of it."));
    }

    void neverSaysThatAllIsExplained_data()
    {
        QTest::addColumn<double>("explained");
        QTest::addColumn<QString>("percent");
        QTest::newRow("all") << 1.0 << "99.9999 %";
        QTest::newRow("all but rounding") << 1.0 - 1e-15 << "99.9999 %";
        QTest::newRow("five nines") << 0.999995 << "99.9995 %";
        QTest::newRow("three nines") << 0.9992 << "99.92 %";
        QTest::newRow("half a percent missing") << 0.995 << "99.5 %";
        QTest::newRow("the least that is said") << 0.99 << "99 %";
    }

    void neverSaysThatAllIsExplained()
    {
        QFETCH(double, explained);
        QFETCH(QString, percent);
        const QString text = textOfChange(Parameter::B, 60.0, explained);
        QVERIFY2(text.contains(" explains " + percent + " of it."), qPrintable(text));
    }

    void saysNothingWhereNoParameterExplainsIt() { QCOMPARE(changeText(Diagnosis(), Mechanism()), QString()); }

    void namesAnglesInDegreesAndSmallChangesWithMoreDigits()
    {
        const QString start = textOfChange(Parameter::Theta20, std::numbers::pi / 36.0, 0.9999);
        QVERIFY2(start.contains("θ₂₀ = 5 instead of 0°, which explains 99.99 %"), qPrintable(start));
        const QString b = textOfChange(Parameter::B, 65.00002, 0.9999);
        QVERIFY2(b.contains("b = 65.00002 instead of 65 mm"), qPrintable(b));
    }

    void speaksInTheUsersNumbers()
    {
        QLocale::setDefault(QLocale(QLocale::Spanish, QLocale::Spain));
        const QString text = textOfChange(Parameter::B, 60.5, 1.0 - 3e-9);
        QLocale::setDefault(QLocale::c());
        QVERIFY2(text.contains("60,5 instead of 65 mm, which explains 99,9999 %"), qPrintable(text));
    }
};

QTEST_GUILESS_MAIN(TestDiagnosisText)
#include "tst_diagnosis_text.moc"
