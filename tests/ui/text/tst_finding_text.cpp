// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/channels.h"
#include "tests/support/suite.h"
#include "ui/text/finding_text.h"
#include "ui/text/subscripts.h"

#include <QLocale>
#include <QSet>
#include <QTest>

#include <limits>
#include <numbers>

using namespace slidercrank;

namespace tst_finding_text
{

ChannelComparison compared(Verdict verdict, double worstOver)
{
    ChannelComparison channel;
    channel.channel = kTheta3;
    channel.count = 201;
    channel.worstOver = worstOver;
    channel.percentOfPeak = 9.83;
    channel.verdict = verdict;
    return channel;
}

class TestFindingText : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void writesSubscriptsAndNoOtherTags()
    {
        QCOMPARE(subscriptHtml("v_BA [mm/s]"), QString("v<sub>BA</sub> [mm/s]"));
        QCOMPARE(subscriptHtml("−R_y³ + a_Aⁿ"), QString("−R<sub>y</sub>³ + a<sub>A</sub>ⁿ"));
        QCOMPARE(subscriptHtml("a < b & c"), QString("a &lt; b &amp; c"));
    }

    void sentencesShowTheSymbolsOfTextbooksWithSubscripts()
    {
        QCOMPARE(symbolHtml("Left out: v_B and v_Ax (a < b)."),
                 QString("Left out: v<sub>B</sub> and v<sub>Ax</sub> (a &lt; b)."));
        QCOMPARE(symbolHtml("R_y⁴\nx_B"), QString("R<sub>y</sub>⁴<br>x<sub>B</sub>"));
        for (const char *plain : {"R4_x: with the opposite sign.", "slider_speed, max_Bx", "a < b\nand a_1"}) {
            QCOMPARE(symbolHtml(plain), QString(plain));
        }
    }

    void namesEachChannelInWordsAndBySymbol()
    {
        struct Row {
            Channel channel;
            const char *symbol;
            const char *quantity;
            const char *unit;
        };
        const Row rows[] = {
            {kTheta3, "θ³", "coupler angle", "°"},
            {{Theta3, Order::Acceleration}, "α³", "coupler angular acceleration", "°/s²"},
            {{Theta2, Order::Position}, "θ₂", "crank angle", "°"}, // as in the controls
            {{Theta2, Order::Velocity}, "ω₂", "crank angular velocity", "°/s"},
            {{R4x, Order::Position}, "Rₓ⁴", "slider position", "mm"},
            {{R4x, Order::Velocity}, "v⁴", "slider velocity", "mm/s"},
            {{R4x, Order::Acceleration}, "a⁴", "slider acceleration", "mm/s²"},
            {{R3x, Order::Position}, "Rₓ³", "coupler centre in x", "mm"},
            {{R4y, Order::Velocity}, "v_y⁴", "slider centre's velocity in y", "mm/s"},
        };
        for (const auto &[channel, symbol, quantity, unit] : rows) {
            QCOMPARE(symbolText(channel), QString::fromUtf8(symbol));
            QCOMPARE(quantityName(channel), QString::fromUtf8(quantity));
            QCOMPARE(unitText(channel), QString::fromUtf8(unit));
        }
        QCOMPARE(columnName({R4x, Order::Velocity}), QString("R4_x_diff"));
        QSet<QString> quantities;
        QSet<QString> symbols;
        for (std::size_t i = 0; i < kChannelCount; ++i) {
            quantities.insert(quantityName(channelAt(i)));
            symbols.insert(symbolText(channelAt(i)));
        }
        QCOMPARE(quantities.size(), qsizetype(kChannelCount));
        QCOMPARE(symbols.size(), qsizetype(kChannelCount));
    }

    void writesAMechanismWithUnits()
    {
        Parameters parameters;
        parameters.theta20 = -std::numbers::pi / 6.0;
        parameters.branch = Branch::Crossed;
        QCOMPARE(mechanismText(Mechanism(parameters)),
                 QString("a = 20 mm, b = 65 mm, c = 25 mm, ω₂ = 6.28319 rad/s, θ₂₀ = −30°, crossed assembly"));
    }

    void namesAPinnedMechanismByWhatDiffers()
    {
        const Parameters present;
        Parameters pinned;
        QCOMPARE(pinnedText(pinned, present), QString("pinned"));
        pinned.b = 80.0;
        QCOMPARE(pinnedText(pinned, present), QString("b = 80 mm"));
        pinned.theta20 = 1.0;
        pinned.branch = Branch::Crossed;
        QCOMPARE(pinnedText(pinned, present), QString("b = 80 mm, θ₂₀ = 57.2958°, crossed assembly"));
        QCOMPARE(pinnedText(present, pinned), QString("b = 65 mm, θ₂₀ = 0°, open assembly"));
    }

    void writesAsManyDigitsAsTheErrorLeaves()
    {
        struct Row {
            double value;
            double error;
            double scale;
            const char *text;
        };
        const Row rows[] = {
            {20.0000012, 1.2e-5, 100.0, "20.00000 ± 0.00001"},
            {60.04, 0.96, 100.0, "60 ± 1"},
            {60.0, 0.002, 100.0, "60.000 ± 0.002"},
            {9.99996, 1e-4, 100.0, "10.0000 ± 0.0001"},
            {-2e-6, 1.3e-5, 1.0, "0 ± 0.00001"},
            {312.0, 4012.0, 1.0, "0 ± 4000"},
            {2.0000004e-8, 1.1e-14, 1e-7, "2.000000·10⁻⁸ ± 10⁻¹⁴"},
            {20.0, std::numeric_limits<double>::quiet_NaN(), 100.0, "20"},
            {20.000000000000004, 1e-15, 100.0, "20"}, // only rounding of the computation
            {6.8e-14, 1e-15, 100.0, "0"},
        };
        for (const auto &[value, error, scale, text] : rows) {
            QCOMPARE(measuredText(value, error, scale), QString::fromUtf8(text));
        }
    }

    void writesVerdictsWithTheirNumbers()
    {
        QCOMPARE(verdictText(compared(Verdict::Agrees, 5.4)), QString("agrees within the rounding of the file"));
        QCOMPARE(verdictText(compared(Verdict::Close, 3.214)),
                 QString("close: at most 3.21 times the rounding of the file"));
        QCOMPARE(verdictText(compared(Verdict::Differs, 4e5)), QString("differs"));
        ChannelComparison rounded = compared(Verdict::Close, 0.8);
        rounded.clockIsRounded = true;
        QCOMPARE(verdictText(rounded), QString("close, if the time stamps of the file are rounded"));

        ChannelComparison missing = compared(Verdict::Differs, 1.0);
        missing.count = 0;
        QCOMPARE(verdictText(missing), QString("differs: nothing to compare with"));
    }

    void judgesAWholeFile()
    {
        const ChannelComparison agrees = compared(Verdict::Agrees, 1.0);
        const ChannelComparison close = compared(Verdict::Close, 20.0);
        const ChannelComparison differs = compared(Verdict::Differs, 1e4);
        ChannelComparison coarse = agrees; // whole millimetres: far off, and yet within its rounding
        coarse.channel = {R4x, Order::Position};
        coarse.percentOfPeak = 50.0;
        ChannelComparison unknown = differs; // the file contains only zeros
        unknown.percentOfPeak.reset();
        ChannelComparison missing;
        missing.channel = differs.channel;
        missing.missingModel = 201;
        const QString most = ", most of all the coupler angle, by 9.83 % of its peak.";
        const std::pair<std::vector<ChannelComparison>, QString> rows[] = {
            {{agrees, agrees}, "Match. Quantities that agree within the rounding of the file: 2 of 2."},
            {{agrees, close},
             "Close match. Quantities that agree within the rounding of the file: 1 of 2, the others nearly."},
            {{agrees, close, differs}, "No match: 1 of 3 quantities differ" + most},
            {{coarse, differs}, "No match: 1 of 2 quantities differ" + most},
            {{agrees, unknown}, "No match: 1 of 2 quantities differ."},
            {{missing, missing}, "No match: the mechanism cannot be assembled at any time step of the file."},
            {{}, "The file has no column that this program knows."},
        };
        for (const auto &[channels, text] : rows) {
            QCOMPARE(summaryText(channels), text);
        }
    }
};

const Suite<TestFindingText> suite("tst_finding_text");

} // namespace tst_finding_text

#include "tst_finding_text.moc"
