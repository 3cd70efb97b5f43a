// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/round_number.h"

#include "core/identification/identification.h"
#include "core/mechanism/turn.h"
#include "tests/support/channels.h"
#include "tests/support/printed_motion.h"
#include "tests/support/random_mechanisms.h"
#include "tests/support/suite.h"

#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

using namespace slidercrank;

namespace tst_round_values
{

constexpr double kPi = std::numbers::pi;
constexpr std::array kPlainUnit{1.0};
constexpr double kInch = 25.4; // mm

bool allAgree(const Parameters &parameters, const ReferenceData &data)
{
    const Mechanism mechanism(parameters);
    return std::ranges::all_of(compareExactly(mechanism, data).channels,
                               [](const ChannelComparison &channel) { return channel.verdict == Verdict::Agrees; });
}

class TestRoundValues : public QObject
{
    Q_OBJECT

private slots:
    void choosesTheRoundestNumberWithinTheError()
    {
        struct Row {
            const char *name;
            double value;
            double standardError;
            double expected;
        };
        for (const Row &row : {Row{"a whole number", 19.9999997, 4e-7, 20.0},
                               {"three standard errors away", 20.0000029, 1e-6, 20.0},
                               {"four standard errors away", 20.0000040, 1e-6, 20.0000040},
                               {"decimals", 12.7500003, 1e-6, 12.75},
                               {"nothing", -7.7e-9, 5.1e-9, 0.0},
                               {"negative", -24.99999, 1e-5, -25.0},
                               {"not known well enough to be a chosen number", 57.34, 5.0, 57.0},
                               {"near nothing round", 12.345678, 2e-4, 12.3457},
                               {"large", 123456789.4, 200.0, 123456800.0},
                               {"without an error", 12.345678, 0.0, 12.345678},
                               {"not determined", 12.345678, kInfinity, 12.345678}}) {
            const double rounded = findRoundNumber(row.value, row.standardError, kPlainUnit).value;
            QVERIFY2(std::abs(rounded - row.expected) <= 1e-12 * std::abs(row.expected), row.name);
        }
    }

    void usesTheUnitInWhichTheNumberIsRoundest()
    {
        const std::array units{1.0, kPi / 180.0, kPi / 30.0};
        QCOMPARE(findRoundNumber(6.2831853001, 7e-9, units).value, kTurn); // 60 turns a minute
        QCOMPARE(findRoundNumber(6.28, 7e-9, units).value, 6.28);
        QCOMPARE(findRoundNumber(kPi / 4.0 + 1e-9, 7e-9, units).value, kPi / 4.0); // 45 °/s
    }

    void findsTheOriginalRoundNumbers()
    {
        RandomMechanisms random(20240917);
        int exact = 0;
        constexpr int kMechanisms = 50;
        for (int i = 0; i < kMechanisms; ++i) {
            Parameters chosen = random.ordinary();
            chosen.a = std::round(chosen.a);
            chosen.b = std::round(chosen.b) + 2.0;
            chosen.c = 0.5 * std::round(2.0 * chosen.c);
            chosen.omega2 = std::round(random.uniform(-200.0, -20.0)) * kPi / 30.0;
            chosen.theta20 = std::round(random.uniform(-170.0, 170.0)) * kPi / 180.0;
            Printing printing;
            printing.to = kTurn / std::abs(chosen.omega2);
            const ReferenceData data = printedData(chosen, printing);
            const Identification found = identify(data, Mechanism());
            QCOMPARE(found.outcome, Identification::Outcome::Identified);
            QVERIFY(allAgree(found.rounded, data));
            const auto isSame = [](double x, double y) { return std::abs(x - y) <= 1e-15 * std::abs(y); };
            exact += found.rounded.a == chosen.a && found.rounded.b == chosen.b && found.rounded.c == chosen.c &&
                             isSame(found.rounded.omega2, chosen.omega2) &&
                             isSame(found.rounded.theta20, chosen.theta20)
                         ? 1
                         : 0;
        }
        QVERIFY2(exact >= kMechanisms * 9 / 10, QByteArray::number(exact)); // some errors exceed three standard errors
    }

    /// A camera takes a picture every 1/30 s, and its times are written with few significant digits, so that rounding
    /// leaves their spacing open by about as much as it leaves ω2.
    void findsTheOriginalRoundNumbersAtRoundedTimes()
    {
        constexpr Parameters kChosen{30.0, 70.0, 10.0, -6.0, 0.3};
        for (const char *format : {"%.4g", "%.5g", "%.6g", "%.3E", "%.4f"}) {
            for (const double start : {0.0, 0.4}) {
                const Printing printing{.from = start,
                                        .to = start + 2.0,
                                        .rows = 61,
                                        .channels = {kSlider, kTheta3},
                                        .format = format,
                                        .timeFormat = format};
                const Identification found = identify(printedData(kChosen, printing), Mechanism());
                QCOMPARE(found.outcome, Identification::Outcome::Identified);
                const std::vector<double> rounded{found.rounded.a, found.rounded.b, found.rounded.c,
                                                  found.rounded.omega2};
                QVERIFY2(rounded == (std::vector<double>{kChosen.a, kChosen.b, kChosen.c, kChosen.omega2}),
                         format + QByteArray(" from ") + QByteArray::number(start) + ": " +
                             QByteArray::number(found.rounded.a, 'g', 17) + ' ' +
                             QByteArray::number(found.rounded.b, 'g', 17) + ' ' +
                             QByteArray::number(found.rounded.c, 'g', 17) + ' ' +
                             QByteArray::number(found.rounded.omega2, 'g', 17));
            }
        }
    }

    void roundsLengthsInTheUnitOfTheFile()
    {
        const Convention inInches{Convention::Kind::LengthUnit, {kSlider, kSliderSpeed, kSliderAcceleration}, kInch};
        const ReferenceData data = applied(inInches, printedData({2.0, 6.25, 0.5, kTurn, 0.0}, Printing()));
        const Identification found = identify(data, Mechanism());
        QCOMPARE(found.outcome, Identification::Outcome::Identified);
        QCOMPARE(found.lengthUnit, kInch);
        QCOMPARE(found.rounded.a, 2.0 * kInch);
        QCOMPARE(found.rounded.b, 6.25 * kInch);
        QCOMPARE(found.rounded.c, 0.5 * kInch);
        QVERIFY(roundLength(152.400001, 1e-6, kInch).value == 152.4); // 6 * 25.4 is 152.39999999999998
        Parameters wrong = found.rounded;
        wrong.b = 6.0 * kInch;
        const Identification beside = identify(data, Mechanism(wrong));
        QVERIFY(beside.change && beside.change->parameter == Parameter::B);
        QCOMPARE(beside.change->value, 6.25 * kInch);
    }

    void doesNotRoundBeyondTheAccuracyOfTheData()
    {
        struct Row {
            double turns;
            const char *format;
        };
        // On a fifth of a turn the parameters depend on each other.
        for (const Row &row : {Row{1.0, "%.6g"}, {1.0, "%.17g"}, {0.2, "%.6g"}}) {
            RandomMechanisms random(20240918);
            int found = 0;
            for (int i = 0; i < 30; ++i) {
                const Parameters p = random.ordinary();
                Printing printing;
                printing.to = row.turns * kTurn / std::abs(p.omega2);
                printing.format = row.format;
                const ReferenceData data = printedData(p, printing);
                const Identification identification = identify(data, Mechanism(p));
                if (identification.outcome != Identification::Outcome::Identified) {
                    continue;
                }
                ++found;
                const Mechanism fitted(identification.parameters);
                const std::vector<ChannelComparison> before = compareExactly(fitted, data).channels;
                const Mechanism rounded(identification.rounded);
                const std::vector<ChannelComparison> after = compareExactly(rounded, data).channels;
                for (std::size_t k = 0; k < before.size(); ++k) {
                    const double floor =
                        1e-12 * toFileUnit(after[k].channel, naturalSize(rounded.parameters(), after[k].channel));
                    QVERIFY2(after[k].verdict <= before[k].verdict && *after[k].rms <= 1.05 * *before[k].rms + floor,
                             row.format + (' ' + QByteArray::number(row.turns) + ' ' + QByteArray::number(i)));
                }
            }
            QVERIFY2(found > 25, row.format);
        }
    }
};

const Suite<TestRoundValues> suite("tst_round_values");

} // namespace tst_round_values

#include "tst_round_values.moc"
