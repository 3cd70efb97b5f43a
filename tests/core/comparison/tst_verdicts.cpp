// SPDX-License-Identifier: GPL-3.0-or-later

// Tests the verdict about files of known origin, for random mechanisms. A file of the mechanism itself never gets the
// verdict `differs`. A file whose error exceeds half a rounding step plus 2 % of its peak never gets a better verdict.

#include "core/comparison/comparison.h"
#include "core/import/reference_data.h"
#include "tests/support/channels.h"
#include "tests/support/claim_table.h"
#include "tests/support/long_tests.h"
#include "tests/support/random_mechanisms.h"
#include "tests/support/reading.h"
#include "tests/support/suite.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

using namespace slidercrank;

namespace tst_verdicts
{

constexpr double kMustDiffer = 0.02; // error beyond half a rounding step, relative to the peak

/// The mechanism that produced a file: the model, a different one, or the model with a crank that is 3 % too short.
enum class Origin { Model, OtherMechanism, ShortCrank };

struct Kind {
    const char *name = "";
    std::vector<Channel> channels{};
    std::string format = "%.6g";
    std::string timeFormat = "%.9g";
    double rate = 30.0; ///< rows per second
    int rows = 61;
    std::string reprint{};             ///< as ClaimColumn::reprint
    bool isRocker = false;             ///< the file has gaps
    bool hasWholeAngles = false;       ///< the crank of the model advances by whole degrees from row to row
    double clockError = 0.0;           ///< error of the last time stamp, in units of its fourth decimal
    Verdict atLeast = Verdict::Agrees; ///< required verdict in 95 % of the true files
};

const std::vector<Channel> kSix(kPlottedChannels.begin(), kPlottedChannels.end());
constexpr Channel kCrank{Theta2, Order::Position};

std::vector<Kind> kinds()
{
    const std::vector<Channel> constants{
        kSlider, {R4y, Order::Position}, {R4y, Order::Velocity}, {Theta2, Order::Velocity}};
    return {
        {"six columns of six digits", kSix, "%.6g", "%.9g", 100.0, 201},
        {"time stamps of 4 decimals", kSix, "%.6g", "%.4f"},
        {"time stamps of 2 decimals", kSix, "%.6g", "%.2f"},
        {"time stamps of 9 digits, values of 9", kSix, "%.9g"},
        {.name = "time stamps of 4 decimals, evenly spaced all the same",
         .channels = kSix,
         .timeFormat = "%.4f",
         .rate = 1.0 / 0.0133,
         .clockError = 0.45,
         .atLeast = Verdict::Close},
        {"a double's own digits", kSix, "%.17g", "%.17g"},
        {"six digits printed with 19", kSix, "%.6g", "%.17g", 30.0, 61, "%.18e"},
        {"constants", constants},
        {"constants of six digits printed with six decimals", constants, "%.6g", "%.9g", 30.0, 61, "%.6f"},
        {"whole millimetres", {kSlider, {R4x, Order::Velocity}}, "%.0f", "%.9g", 100.0, 201},
        {"whole millimetres and 4 decimals of time", {kSlider}, "%.0f", "%.4f"},
        {.name = "rockers", .channels = kSix, .rate = 100.0, .rows = 201, .isRocker = true},
        {.name = "rockers, time stamps of 2 decimals", .channels = kSix, .timeFormat = "%.2f", .isRocker = true},
        {.name = "whole angles",
         .channels = {kCrank, kSlider},
         .format = "%.0f",
         .rate = 100.0,
         .hasWholeAngles = true},
        {"two rows", kSix, "%.6g", "%.1f", 10.0, 2},
        {"three rows, a tenth of a second apart", kSix, "%.6g", "%.1f", 10.0, 3},
    };
}

/// Returns the mechanism with a speed that makes at most three turns in two seconds.
Parameters withSlowCrank(Parameters p, RandomMechanisms &random)
{
    p.omega2 = std::copysign(random.uniform(0.5, 3.0) * std::numbers::pi, p.omega2);
    return p;
}

/// Returns a random mechanism with which a file of this kind is compared.
Parameters randomModel(const Kind &kind, RandomMechanisms &random)
{
    Parameters model = withSlowCrank(random.next(), random);
    if (kind.isRocker) {
        model.b = random.uniform(0.6, 0.95) * model.a + std::abs(model.c);
    }
    if (kind.hasWholeAngles) {
        model.omega2 = std::numbers::pi / 180.0 * 300.0;
        model.theta20 = std::numbers::pi / 6.0;
    }
    return model;
}

Parameters producerOf(const Parameters &model, Origin origin, RandomMechanisms &random)
{
    Parameters producer = model;
    if (origin == Origin::OtherMechanism) {
        producer = random.next();
        producer.omega2 = model.omega2;
    } else if (origin == Origin::ShortCrank) {
        producer.a *= 0.97;
    }
    return producer;
}

/// Returns a file of this kind with the motion of the mechanism.
ClaimTable printedFile(const Kind &kind, const Parameters &mechanism)
{
    ClaimRandom random("verdicts");
    ClaimTable file(random, mechanism);
    const double spacing = 1.0 / kind.rate + kind.clockError * 0.5e-4 / kind.rows;
    file.atTimes(spacing * Values::LinSpaced(kind.rows, 0.0, kind.rows - 1), kind.timeFormat).withEmptyRows();
    for (const Channel channel : kind.channels) {
        file.columns.push_back({std::string(nameOf(channel)), channel, kind.format, kind.reprint});
    }
    file.print();
    return file;
}

/// Returns the largest error of the values with respect to the model at the exact time stamps, beyond half a rounding
/// step and relative to the peak.
double errorOf(const ClaimColumn &column, const Values &model)
{
    double peak = 0.0;
    double largestError = 0.0;
    for (Index row = 0; row < model.size(); ++row) {
        const double value = column.values[row];
        const double printed = std::stod(column.print(value));
        const double halfStep = column.format == "%.0f" ? 0.5 : std::abs(printed - value);
        if (!std::isnan(value)) {
            peak = std::max(peak, std::abs(value));
            largestError = std::max(largestError, std::abs(model[row] - value) - halfStep);
        }
    }
    return largestError / peak;
}

class TestVerdicts : public QObject
{
    Q_OBJECT

private slots:
    void areTrue()
    {
        RandomMechanisms random(20261122);
        const int files = caseCount(25, 2000);
        int filesOfOtherMechanisms = 0;
        int tooFar = 0;
        for (const Kind &kind : kinds()) {
            int right = 0;
            for (int i = 0; i < 3 * files; ++i) {
                // Near a toggle position of a rocker, the rounding of time stamps may explain any error.
                const Origin origin = kind.isRocker ? Origin::Model : static_cast<Origin>(i % 3);
                const Parameters model = randomModel(kind, random);
                const ClaimTable file = printedFile(kind, producerOf(model, origin, random));
                const QByteArray title = QByteArray(kind.name) + ' ' + QByteArray::number(i) + '\n' + file.text.c_str();
                const auto outcome = readReferenceData(file.text);
                QVERIFY2(std::holds_alternative<ReferenceData>(outcome), title);
                const std::vector<ChannelComparison> found =
                    compareExactly(Mechanism(model), std::get<ReferenceData>(outcome)).channels;
                QCOMPARE(found.size(), kind.channels.size());
                Verdict worst = Verdict::Agrees;
                bool isTooFar = false;
                for (std::size_t k = 0; k < found.size(); ++k) {
                    worst = std::max(worst, found[k].verdict);
                    Values exact = valuesOf(model, kind.channels[k], file.times);
                    if (kind.channels[k] == kCrank) {
                        exact += 360.0 * ((file.columns[k].values - exact) / 360.0).round();
                    }
                    const bool isColumnTooFar = errorOf(file.columns[k], exact) > kMustDiffer;
                    isTooFar = isTooFar || isColumnTooFar;
                    QVERIFY2(!isColumnTooFar || found[k].verdict == Verdict::Differs, title);
                    QVERIFY2(origin != Origin::Model || found[k].verdict != Verdict::Differs, title);
                }
                right += origin == Origin::Model && worst <= kind.atLeast ? 1 : 0;
                filesOfOtherMechanisms += origin == Origin::Model ? 0 : 1;
                tooFar += isTooFar ? 1 : 0;
            }
            QVERIFY2(100 * right >= 95 * files, kind.name);
        }
        QVERIFY2(4 * tooFar >= 3 * filesOfOtherMechanisms, QByteArray::number(tooFar));
    }
};

const Suite<TestVerdicts> suite("tst_verdicts");

} // namespace tst_verdicts

#include "tst_verdicts.moc"
