// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/words/finding_text.h"

#include <QLocale>
#include <QTest>

#include <limits>
#include <numbers>

using namespace slidercrank;

namespace
{

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr Channel kTheta3{Theta3, Order::Position};
constexpr Channel kSlider{R4x, Order::Position};
constexpr Channel kSliderSpeed{R4x, Order::Velocity};

/// As the author's own file gives it, measured: formulation and standard errors in mm, rad/s, rad.
Identification authorsFile()
{
    Identification found;
    found.outcome = Identification::Outcome::Identified;
    found.parameters.a = 20.0000012;
    found.parameters.b = 59.9999987;
    found.parameters.c = 24.9999744;
    found.parameters.omega2 = 6.2831856;
    found.parameters.theta20 = -3.8e-7;
    found.standardError = {3.4e-6, 9.8e-6, 7.6e-6, 3e-7, 2.3e-7};
    found.identifiable = {true, true, true, true, true};
    found.rms = 0.4;
    return found;
}

using Why = Identification::Alternative::Why;

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

ChannelComparison compared(Verdict verdict, double worstOver)
{
    ChannelComparison channel;
    channel.channel = kTheta3;
    channel.count = 201;
    channel.withinBound = 150;
    channel.worstOver = worstOver;
    channel.excess = 0.00123;
    channel.percentOfPeak = 9.83;
    channel.verdict = verdict;
    return channel;
}

} // namespace

class TestFindingText : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void writesChannelsAsTheAuthorDoes()
    {
        QCOMPARE(symbolOf(kTheta3), QString("θ³"));
        QCOMPARE(symbolOf(kSliderSpeed), QString("dRₓ⁴/dt"));
        QCOMPARE(symbolOf(Channel{R4y, Order::Acceleration}), QString("d²R_y⁴/dt²"));
        QCOMPARE(columnNameOf(kSliderSpeed), QString("R4_x_diff"));
        QCOMPARE(unitOf(Channel{Theta3, Order::Acceleration}), QString("°/s²"));
    }

    void writesAMechanismWithUnits()
    {
        Parameters parameters;
        parameters.theta20 = -std::numbers::pi / 6.0;
        parameters.branch = Branch::Crossed;
        QCOMPARE(mechanismText(Mechanism(parameters)),
                 QString("a = 20 mm, b = 65 mm, c = 25 mm, ω₂ = 6.28319 rad/s, θ₂₀ = -30°, crossed assembly"));
    }

    void writesAsManyDigitsAsTheErrorLeaves_data()
    {
        QTest::addColumn<double>("value");
        QTest::addColumn<double>("error");
        QTest::addColumn<double>("scale");
        QTest::addColumn<QString>("text");
        QTest::newRow("the issue's example") << 20.0000012 << 1.2e-5 << 100.0 << "20.00000 ± 0.00001";
        QTest::newRow("an error of 0.96 is 1") << 60.04 << 0.96 << 100.0 << "60 ± 1";
        QTest::newRow("trailing zeros count") << 60.0 << 0.002 << 100.0 << "60.000 ± 0.002";
        QTest::newRow("rounding up adds a digit") << 9.99996 << 1e-4 << 100.0 << "10.0000 ± 0.0001";
        QTest::newRow("a value below its error") << -2e-6 << 1.3e-5 << 1.0 << "0.00000 ± 0.00001";
        QTest::newRow("an error above the value") << 312.0 << 4012.0 << 1.0 << "0 ± 4000";
        QTest::newRow("very small") << 2.0000004e-8 << 1.1e-14 << 1e-7 << "2.000000·10⁻⁸ ± 1·10⁻¹⁴";
        QTest::newRow("no error known") << 20.0 << kNaN << 100.0 << "20";
        QTest::newRow("nothing but arithmetic") << 20.000000000000004 << 1e-15 << 100.0 << "20";
    }

    void writesAsManyDigitsAsTheErrorLeaves()
    {
        QFETCH(double, value);
        QFETCH(double, error);
        QFETCH(double, scale);
        QFETCH(QString, text);
        QCOMPARE(measuredText(value, error, scale), text);
    }

    void saysWhichMechanismWasFound()
    {
        QCOMPARE(summaryOf(authorsFile()),
                 QString("a = 20.000001 ± 0.000003 mm, b = 60.00000 ± 0.00001 mm, c = 24.999974 ± 0.000008 mm, "
                         "ω₂ = 6.2831856 ± 0.0000003 rad/s, θ₂₀ = -0.00002 ± 0.00001°, open assembly."));
    }

    void saysWhatAnAngleAloneCannotFix()
    {
        Identification found = authorsFile();
        found.onlyRatios = true;
        found.parameters.a = 10.0;
        found.parameters.b = 30.0;
        found.parameters.c = 12.5;
        found.identifiable = {false, false, false, true, true};
        found.standardError = {kNaN, kNaN, kNaN, 3e-7, 2.3e-7};
        const QString text = summaryOf(found);
        QVERIFY2(text.startsWith("b/a = 3, c/a = 1.25, ω₂ = "), qPrintable(text));
        QVERIFY2(text.endsWith("open assembly. θ³ alone fixes only b/a and c/a; a = 10 mm is taken as given."),
                 qPrintable(text));
        QVERIFY(!text.contains("do not fix"));
        found.standardError[indexOf(Parameter::B)] = 2e-5; // with a held
        QVERIFY2(summaryOf(found).startsWith("b/a = 3.000000 ± 0.000002, c/a = 1.25"), qPrintable(summaryOf(found)));
        QCOMPARE(measuredText(Parameter::A, found), QString("–"));
        QCOMPARE(measuredText(Parameter::B, found), QString("3.000000 ± 0.000002 a"));
    }

    void keepsCaveatsApart()
    {
        QCOMPARE(caveatsOf(authorsFile()), QString());
        Identification found = authorsFile();
        found.alternatives = {alternative(Why::MirrorImage)};
        QCOMPARE(summaryOf(found), summaryOf(authorsFile()) + u' ' + caveatsOf(found));
        QCOMPARE(measuredText(Parameter::B, found), QString("60.00000 ± 0.00001 mm"));
    }

    void saysThatASliderHasAMirrorImage()
    {
        Identification found = authorsFile();
        QVERIFY(!summaryOf(found).contains("mirror"));
        found.alternatives = {alternative(Why::MirrorImage)};
        QVERIFY(summaryOf(found).endsWith(
            " Rₓ⁴ alone cannot tell this mechanism from its mirror image (c, ω₂ and θ₂₀ negated)."));
    }

    void saysWhatElseMovesAlike()
    {
        Identification found = authorsFile();
        found.alternatives = {alternative(Why::Reversed)};
        QVERIFY(caveatsOf(found).contains("turns the other way, from 180° − θ₂₀"));
        found.alternatives = {alternative(Why::OtherAssembly)};
        QVERIFY(caveatsOf(found).contains("the other assembly with c negated and θ₂₀ half a turn on"));
    }

    void saysWhatElseTheDataDoNotFix()
    {
        Identification found = authorsFile();
        found.identifiable[indexOf(Parameter::Omega2)] = false;
        found.identifiable[indexOf(Parameter::Theta20)] = false;
        found.parameters.omega2 = 2.0;
        found.parameters.theta20 = 0.0;
        const QString text = summaryOf(found);
        QVERIFY2(text.endsWith(" The data do not fix ω₂ = 2 rad/s and θ₂₀ = 0°: kept as given."), qPrintable(text));
        QVERIFY(!text.contains("ω₂ = 2 ±"));
    }

    void saysWhenWhatIsLeftIsMoreThanRounding()
    {
        Identification found = authorsFile();
        found.rms = 1234.5;
        QVERIFY2(summaryOf(found).endsWith("still off by 1235 × the file's rounding step (rms)."),
                 qPrintable(summaryOf(found)));
    }

    void saysWhyThereIsNoMechanism()
    {
        Identification none;
        none.outcome = Identification::Outcome::Insufficient;
        QStringList sentences;
        for (const auto lack : {Identification::Lack::FewValues, Identification::Lack::NothingMoves}) {
            none.lack = lack;
            sentences << summaryOf(none);
            QVERIFY(sentences.last().endsWith(u'.'));
            QVERIFY(!sentences.last().contains("a ="));
        }
        QCOMPARE(sentences.removeDuplicates(), 0);
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

    void explainsConventions_data()
    {
        QTest::addColumn<Convention>("convention");
        QTest::addColumn<QString>("explanation");
        QTest::addColumn<QString>("action");
        using Kind = Convention::Kind;
        QTest::newRow("radians") << Convention{Kind::AngleUnit, {kTheta3}, kDegreesPerRadian}
                                 << "theta3: in radians, but read as degrees."
                                 << "Multiplies theta3 by 57.2958";
        QTest::newRow("degrees") << Convention{Kind::AngleUnit, {kTheta3}, 1.0 / kDegreesPerRadian}
                                 << "theta3: in degrees, but read as radians."
                                 << "Multiplies theta3 by 0.0174533";
        QTest::newRow("metres") << Convention{Kind::LengthUnit, {kSlider, kSliderSpeed}, 1000.0}
                                << "R4_x and R4_x_diff: in metres, but read as millimetres."
                                << "Multiplies R4_x and R4_x_diff by 1000";
        QTest::newRow("feet") << Convention{Kind::LengthUnit, {kSlider}, 304.8}
                              << "R4_x: in a unit of length 304.8 times as large as the one read."
                              << "Multiplies R4_x by 304.8";
        QTest::newRow("milliseconds") << Convention{Kind::TimeUnit, {kSliderSpeed}, 0.001}
                                      << "The time is in milliseconds, but was read as seconds; so are the derivatives "
                                         "R4_x_diff."
                                      << "Multiplies the instants by 0.001, and brings R4_x_diff to the same unit";
        QTest::newRow("sense of rotation")
            << Convention{Kind::Sign, {kTheta3}, -1.0} << "theta3: counted clockwise, against the sense of the model."
            << "Changes the sign of theta3";
        QTest::newRow("axis") << Convention{Kind::Sign, {kSlider}, -1.0}
                              << "R4_x: along an axis that points the other way."
                              << "Changes the sign of R4_x";
        QTest::newRow("textbook's angle") << Convention{Kind::HalfTurn, {kTheta3}, -180.0}
                                          << "theta3: the coupler's angle seen from B, as textbooks draw θ₃; θ³ is "
                                             "theta3 − 180°."
                                          << "Adds -180° to theta3, made continuous";
        QTest::newRow("whole turns") << Convention{Kind::WholeTurns, {kTheta3}, 360.0}
                                     << "theta3: off by whole turns; θ³ is theta3 + 360°."
                                     << "Adds 360° to theta3, made continuous";
        QTest::newRow("jumps") << Convention{Kind::WholeTurns, {kTheta3}, 0.0} << "theta3: jumps by whole turns."
                               << "Makes theta3 continuous";
        QTest::newRow("origin") << Convention{Kind::ZeroPoint, {kSlider}, -5.0}
                                << "R4_x: counted from another origin, at -5 mm."
                                << "Adds -5 mm to R4_x";
        QTest::newRow("swapped") << Convention{Kind::SwappedColumns, {kTheta3, kSlider}, 1.0}
                                 << "theta3 and R4_x: each stands under the other's name."
                                 << "Exchanges theta3 and R4_x";
        QTest::newRow("assembly") << Convention{Kind::Branch, {}, 1.0}
                                  << "The file moves as the other assembly: the slider on the other side of A."
                                  << "Takes the other assembly for the model";
        QTest::newRow("late") << Convention{Kind::TimeShift, {}, -0.25}
                              << "The file's clock is 0.25 s ahead: what it has at t happens that much earlier."
                              << "Adds -0.25 s to the instants";
    }

    void explainsConventions()
    {
        QFETCH(Convention, convention);
        QFETCH(QString, explanation);
        QFETCH(QString, action);
        QVERIFY(!nameOf(convention).isEmpty());
        QCOMPARE(explanationOf(convention), explanation);
        QCOMPARE(effectOf({convention, 98.25, 0.00076543}),
                 action + ": largest error 0.000765 % of peak instead of 98.3 %.");
    }

    void leavesOutWhatIsNoDerivative()
    {
        const Convention none{Convention::Kind::NotDerivative, {kSliderSpeed}, 1.0};
        QCOMPARE(explanationOf(none), QString("R4_x_diff: not the time derivative of its position column."));
        QCOMPARE(effectOf({none, 98.25, 0.0}), QString("Leaves R4_x_diff out: its largest error is 98.3 % of peak."));
    }

    void putsVerdictsIntoWords()
    {
        QCOMPARE(verdictText(compared(Verdict::Agrees, 5.4)), QString("agrees within the file's rounding"));
        QCOMPARE(verdictText(compared(Verdict::Close, 3.21)), QString("close: within 3.3 × the file's rounding"));
        QCOMPARE(verdictText(compared(Verdict::Close, 41.01)), QString("close: within 42 × the file's rounding"));
        QCOMPARE(verdictText(compared(Verdict::Differs, 4e5)), QString("differs"));
        ChannelComparison rounded = compared(Verdict::Close, 0.8);
        rounded.clockIsRounded = true;
        QCOMPARE(verdictText(rounded), QString("close, if the file's instants are rounded"));
    }

    void tellsHowAVerdictComesAbout()
    {
        const QString agrees = verdictFormula(compared(Verdict::Agrees, 5.4));
        QVERIFY2(agrees.contains("95 %") && agrees.contains("≤ 10 · bound") && agrees.contains("0.5 % of half"),
                 qPrintable(agrees));
        QVERIFY2(agrees.contains("evenly spaced instants count as exact"), qPrintable(agrees));
        QVERIFY2(agrees.endsWith("\nHere: 150 of 201 within the bound, the worst 5.40 · bound, beyond it by 0.123 %."),
                 qPrintable(agrees));
        const QString differs = verdictFormula(compared(Verdict::Differs, std::numeric_limits<double>::infinity()));
        QVERIFY2(differs.contains("> 100 · bound") && differs.contains("∞"), qPrintable(differs));
        ChannelComparison missing = compared(Verdict::Differs, 1.0);
        missing.missingModel = 7;
        QVERIFY(verdictFormula(missing).contains("At 7 instants the model has no value"));
        missing.count = 0;
        QVERIFY(!verdictFormula(missing).contains("Here"));
    }

    void judgesAWholeFile()
    {
        const ChannelComparison agrees = compared(Verdict::Agrees, 1.0);
        const ChannelComparison close = compared(Verdict::Close, 20.0);
        const ChannelComparison differs = compared(Verdict::Differs, 1e4);
        QCOMPARE(summaryOf(std::vector{agrees, agrees}),
                 QString("Agrees with this mechanism in 2 of 2 channels, within the rounding of the file."));
        QCOMPARE(summaryOf(std::vector{agrees, close}),
                 QString("Agrees with this mechanism in 1 of 2 channels, within the rounding of the file; close in the "
                         "others."));
        QCOMPARE(summaryOf(std::vector{agrees, close, differs}),
                 QString("Differs from this mechanism in 1 of 3 channels, most in θ³: by up to 9.83 % of its peak."));
        QCOMPARE(summaryOf(std::vector{agrees}),
                 QString("Agrees with this mechanism in its one channel, within the rounding of the file."));
        QVERIFY(summaryOf(std::vector{close, close}).startsWith("Comes close to this mechanism in every channel"));
        ChannelComparison rounded = close;
        rounded.clockIsRounded = true;
        QVERIFY(summaryOf(std::vector{rounded, rounded}).contains("if the file's instants, evenly spaced"));
        ChannelComparison coarse = agrees; // whole millimetres: far off, and yet within its rounding
        coarse.channel = kSlider;
        coarse.percentOfPeak = 50.0;
        QCOMPARE(summaryOf(std::vector{coarse, differs}),
                 QString("Differs from this mechanism in 1 of 2 channels, most in θ³: by up to 9.83 % of its peak."));
        ChannelComparison missing = differs;
        missing.missingModel = 47;
        QVERIFY(summaryOf(std::vector{agrees, missing})
                    .endsWith("9.83 % of its peak. At 47 of the file's instants the mechanism cannot be assembled, or "
                              "has no derivatives."));
        QVERIFY(!summaryOf(std::vector<ChannelComparison>()).isEmpty());
    }

    void speaksInTheUsersNumbers()
    {
        QLocale::setDefault(QLocale(QLocale::Spanish, QLocale::Spain));
        const QString text = textOfChange(Parameter::B, 60.5, 1.0 - 3e-9);
        QLocale::setDefault(QLocale::c());
        QVERIFY2(text.contains("60,5 instead of 65 mm, which explains 99,9999 %"), qPrintable(text));
    }
};

QTEST_GUILESS_MAIN(TestFindingText)
#include "tst_finding_text.moc"
