// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/channels.h"
#include "tests/support/suite.h"
#include "ui/text/comparison_text.h"

#include <QLocale>
#include <QTest>

#include <utility>
#include <vector>

using namespace slidercrank;

namespace tst_comparison_text
{

ChannelComparison comparisonWith(Verdict verdict, double largestErrorInBounds)
{
    ChannelComparison channel;
    channel.channel = kTheta3;
    channel.count = 201;
    channel.largestErrorInBounds = largestErrorInBounds;
    channel.percentOfPeak = 9.83;
    channel.verdict = verdict;
    return channel;
}

class TestComparisonText : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void writesVerdictsWithTheirNumbers()
    {
        QCOMPARE(verdictText(comparisonWith(Verdict::Agrees, 5.4)), QString("agrees within the rounding of the file"));
        QCOMPARE(verdictText(comparisonWith(Verdict::Close, 3.214)),
                 QString("close: at most 3.21 times the rounding of the file"));
        QCOMPARE(verdictText(comparisonWith(Verdict::Differs, 4e5)), QString("differs"));
        ChannelComparison rounded = comparisonWith(Verdict::Close, 0.8);
        rounded.clockIsRounded = true;
        QCOMPARE(verdictText(rounded), QString("close, if the time stamps of the file are rounded"));

        ChannelComparison missing = comparisonWith(Verdict::Differs, 1.0);
        missing.count = 0;
        QCOMPARE(verdictText(missing), QString("differs: nothing to compare with"));
    }

    void judgesAWholeFile()
    {
        const ChannelComparison agrees = comparisonWith(Verdict::Agrees, 1.0);
        const ChannelComparison close = comparisonWith(Verdict::Close, 20.0);
        const ChannelComparison differs = comparisonWith(Verdict::Differs, 1e4);
        ChannelComparison coarse = agrees; // whole millimetres: far off, and yet within its rounding
        coarse.channel = {R4x, Order::Position};
        coarse.percentOfPeak = 50.0;
        ChannelComparison unknown = differs; // the file contains only zeros
        unknown.percentOfPeak.reset();
        ChannelComparison missing;
        missing.channel = differs.channel;
        missing.missingModelCount = 201;
        ChannelComparison timed = differs; // to 0.01 s
        timed.isWithinRoundedTime = true;
        QCOMPARE(verdictText(timed), QString("differs; the rounded time stamps may explain it"));
        const QString most = ", most of all the coupler angle, by 9.83 % of its peak.";
        const std::pair<std::vector<ChannelComparison>, QString> rows[] = {
            {{agrees, agrees}, "Match. Quantities that agree within the rounding of the file: 2 of 2."},
            {{agrees, close},
             "Close match. Quantities that agree within the rounding of the file: 1 of 2; the others are close."},
            {{agrees, close, differs}, "No match. Quantities that differ: 1 of 3" + most},
            {{coarse, differs}, "No match. Quantities that differ: 1 of 2" + most},
            {{agrees, unknown}, "No match. Quantities that differ: 1 of 2."},
            {{agrees, timed},
             "No match. Quantities that differ: 1 of 2" + most +
                 " The rounding of the time stamps is sufficient to explain this: write the file with more digits of "
                 "the time."},
            {{timed, differs}, "No match. Quantities that differ: 2 of 2" + most},
            {{missing, missing}, "No match: the mechanism cannot be assembled at any time step of the file."},
            {{}, "The file has no column that this program knows."},
        };
        for (const auto &[channels, text] : rows) {
            QCOMPARE(summaryText(channels), text);
        }
    }
};

const Suite<TestComparisonText> suite("tst_comparison_text");

} // namespace tst_comparison_text

#include "tst_comparison_text.moc"
