// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/finding_text.h"

#include <QLocale>
#include <QSet>
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
        QCOMPARE(symbolOf(kSliderSpeed), QString("v⁴"));
        QCOMPARE(symbolOf(Channel{R4y, Order::Acceleration}), QString("a_y⁴"));
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

    void namesAKeptMechanismByWhatDiffers()
    {
        const Parameters present;
        Parameters kept;
        QCOMPARE(keptText(kept, present), QString("pinned"));
        kept.b = 80.0;
        QCOMPARE(keptText(kept, present), QString("b = 80 mm"));
        kept.theta20 = 1.0;
        kept.branch = Branch::Crossed;
        QCOMPARE(keptText(kept, present), QString("b = 80 mm, θ₂₀ = 57.2958°, crossed assembly"));
        QCOMPARE(keptText(present, kept), QString("b = 65 mm, θ₂₀ = 0°, open assembly"));
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
        QTest::newRow("very small") << 2.0000004e-8 << 1.1e-14 << 1e-7 << "2.000000·10⁻⁸ ± 10⁻¹⁴";
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

    void namesChannelsInWords()
    {
        QCOMPARE(quantityOf({Theta3, Order::Position}), QString("coupler angle"));
        QCOMPARE(quantityOf({Theta2, Order::Velocity}), QString("crank angular velocity"));
        QCOMPARE(quantityOf({R4x, Order::Position}), QString("slider position"));
        QCOMPARE(quantityOf({R4x, Order::Acceleration}), QString("slider acceleration"));
        QCOMPARE(quantityOf({R3x, Order::Position}), QString("coupler centre in x"));
        QCOMPARE(quantityOf({R4y, Order::Velocity}), QString("slider centre's velocity in y"));
        // Each its own, in words and as a symbol; the crank's angle as on the controls.
        QSet<QString> words;
        QSet<QString> symbols;
        for (std::size_t i = 0; i < kChannelCount; ++i) {
            words.insert(quantityOf(channelAt(i)));
            symbols.insert(symbolOf(channelAt(i)));
        }
        QCOMPARE(words.size(), qsizetype(kChannelCount));
        QCOMPARE(symbols.size(), qsizetype(kChannelCount));
        QCOMPARE(symbolOf({Theta2, Order::Position}), QString("θ₂"));
        QCOMPARE(symbolOf({Theta2, Order::Velocity}), QString("ω₂"));
        QCOMPARE(symbolOf({Theta3, Order::Position}), QString("θ³"));
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
        QVERIFY(summaryOf(std::vector{rounded, rounded})
                    .contains("provided that the file's instants, though evenly spaced"));
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
};

QTEST_GUILESS_MAIN(TestFindingText)
#include "tst_finding_text.moc"
