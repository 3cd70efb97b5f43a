// SPDX-License-Identifier: GPL-3.0-or-later

// Tests the verdict about files of known origin, for random mechanisms. A file of the mechanism itself never gets the
// verdict `differs`. A file whose error exceeds half a rounding step plus 2 % of its peak never gets a better verdict.

#include "core/comparison/comparison.h"
#include "core/import/reference_data.h"
#include "tests/support/claim_file.h"
#include "tests/support/long_tests.h"
#include "tests/support/random_mechanisms.h"
#include "tests/support/suite.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

using namespace slidercrank;

namespace
{

constexpr double kTooFar = 0.02; // of the peak, beyond half a rounding step

enum class File { True, OtherMechanism, ShortCrank };

struct Kind {
    const char *name = "";
    File file = File::True;
    std::vector<Channel> channels{};
    std::string format = "%.6g";
    std::string timeFormat = "%.9g";
    std::string reprint{}; ///< as ClaimColumn::reprint
    double rate = 30.0;    ///< rows per second
    int rows = 61;
    bool rocks = false;                ///< rocker: the file has gaps
    bool chosenAngles = false;         ///< the crank advances by whole degrees
    double clockError = 0.0;           ///< error of the last time stamp, in units of its fourth decimal
    Verdict atLeast = Verdict::Agrees; ///< required verdict in 95 % of the true files
};

const std::vector<Channel> kSix(kPlottedChannels.begin(), kPlottedChannels.end());
constexpr Channel kX{R4x, Order::Position};
constexpr Channel kCrank{Theta2, Order::Position};
constexpr Channel kSliderSpeed{R4x, Order::Velocity};

std::vector<Kind> kinds()
{
    const std::vector<Channel> constants{kX, {R4y, Order::Position}, {R4y, Order::Velocity}, {Theta2, Order::Velocity}};
    return {
        {.name = "six columns of six digits", .channels = kSix, .rate = 100.0, .rows = 201},
        {.name = "time stamps of 4 decimals", .channels = kSix, .timeFormat = "%.4f"},
        {.name = "time stamps of 2 decimals", .channels = kSix, .timeFormat = "%.2f"},
        {.name = "time stamps of 9 digits, values of 9", .channels = kSix, .format = "%.9g"},
        {.name = "time stamps of 4 decimals, evenly spaced all the same",
         .channels = kSix,
         .timeFormat = "%.4f",
         .rate = 1.0 / 0.0133,
         .clockError = 0.45,
         .atLeast = Verdict::Close},
        {.name = "a double's own digits", .channels = kSix, .format = "%.17g", .timeFormat = "%.17g"},
        {.name = "six digits printed with 19", .channels = kSix, .timeFormat = "%.17g", .reprint = "%.18e"},
        {.name = "six digits printed with six decimals", .channels = kSix, .reprint = "%.6f"},
        {.name = "constants", .channels = constants},
        {.name = "constants of six digits printed with six decimals", .channels = constants, .reprint = "%.6f"},
        {.name = "whole millimetres", .channels = {kX}, .format = "%.0f", .rate = 100.0, .rows = 201},
        {.name = "rockers", .channels = kSix, .rate = 100.0, .rows = 201, .rocks = true},
        {.name = "rockers, time stamps of 4 decimals", .channels = kSix, .timeFormat = "%.4f", .rocks = true},
        {.name = "rockers, time stamps of 2 decimals", .channels = kSix, .timeFormat = "%.2f", .rocks = true},
        {.name = "chosen angles", .channels = {kCrank, kX}, .format = "%.0f", .rate = 100.0, .chosenAngles = true},
        {.name = "two rows", .channels = kSix, .timeFormat = "%.1f", .rate = 10.0, .rows = 2},
        {.name = "whole millimetres of another mechanism",
         .file = File::OtherMechanism,
         .channels = {kX},
         .format = "%.0f",
         .rate = 100.0,
         .rows = 201},
        {.name = "whole millimetres and 4 decimals of time, of another mechanism",
         .file = File::OtherMechanism,
         .channels = {kX},
         .format = "%.0f",
         .timeFormat = "%.4f"},
        {.name = "six columns of another mechanism",
         .file = File::OtherMechanism,
         .channels = kSix,
         .timeFormat = "%.4f"},
        {.name = "constants of another mechanism",
         .file = File::OtherMechanism,
         .channels = constants,
         .reprint = "%.6f"},
        {.name = "two rows of another mechanism",
         .file = File::OtherMechanism,
         .channels = {kX},
         .format = "%.0f",
         .timeFormat = "%.1f",
         .rate = 2.0,
         .rows = 2},
        {.name = "three rows of another mechanism, a tenth of a second apart",
         .file = File::OtherMechanism,
         .channels = kSix,
         .timeFormat = "%.1f",
         .rate = 10.0,
         .rows = 3},
        {.name = "few time stamps of another mechanism, unevenly chosen",
         .file = File::OtherMechanism,
         .channels = kSix,
         .timeFormat = "%.1f",
         .rate = 7.0,
         .rows = 8},
        {.name = "chosen angles of another mechanism",
         .file = File::OtherMechanism,
         .channels = {kCrank, kX},
         .format = "%.0f",
         .rate = 100.0,
         .rows = 101},
        {.name = "a 3 % short, whole millimetres",
         .file = File::ShortCrank,
         .channels = {kX, kSliderSpeed},
         .format = "%.0f",
         .rate = 100.0,
         .rows = 201},
        {.name = "a 3 % short, six digits", .file = File::ShortCrank, .channels = kSix, .rate = 100.0, .rows = 201},
        {.name = "a 3 % short, time stamps of 4 decimals",
         .file = File::ShortCrank,
         .channels = kSix,
         .timeFormat = "%.4f"},
    };
}

/// Returns the mechanism with a speed that makes at most three turns in two seconds.
Parameters slow(Parameters p, RandomMechanisms &random)
{
    p.omega2 = std::copysign(random.uniform(0.5, 3.0) * std::numbers::pi, p.omega2);
    return p;
}

/// Prints the file of the mechanism `of`.
ClaimFile printed(const Kind &kind, const Parameters &of)
{
    ClaimFile file("verdicts");
    file.truth = of;
    const double spacing = 1.0 / kind.rate + kind.clockError * 0.5e-4 / kind.rows;
    file.times = spacing * Values::LinSpaced(kind.rows, 0.0, kind.rows - 1);
    file.time.format = kind.timeFormat;
    file.keepsEmptyRows = true;
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
    double farthest = 0.0;
    for (Index row = 0; row < model.size(); ++row) {
        const double value = column.values[row];
        const double printed = std::stod(column.print(value));
        const double half = column.format == "%.0f" ? 0.5 : std::abs(printed - value);
        if (!std::isnan(value)) {
            peak = std::max(peak, std::abs(value));
            farthest = std::max(farthest, std::abs(model[row] - value) - half);
        }
    }
    return farthest / peak;
}

} // namespace

class TestVerdicts : public QObject
{
    Q_OBJECT

private slots:
    void areTrue_data()
    {
        QTest::addColumn<int>("place");
        const auto all = kinds();
        for (std::size_t i = 0; i < all.size(); ++i) {
            QTest::newRow(all[i].name) << static_cast<int>(i);
        }
    }

    void areTrue()
    {
        QFETCH(const int, place);
        const Kind kind = kinds()[static_cast<std::size_t>(place)];
        RandomMechanisms random(20261122 +
                                static_cast<std::uint64_t>(place)); // a fixed seed makes failures reproducible
        const int files = runs(50, 2000);
        int right = 0;
        int tooFar = 0;
        for (int i = 0; i < files; ++i) {
            Parameters model = slow(random.next(), random);
            if (kind.rocks) {
                model.b = random.uniform(0.6, 0.95) * model.a + std::abs(model.c);
            }
            if (kind.chosenAngles) {
                model.omega2 = std::numbers::pi / 180.0 * 300.0;
                model.theta20 = std::numbers::pi / 6.0;
            }
            Parameters of = model;
            if (kind.file == File::OtherMechanism) {
                of = random.next();
                of.omega2 = model.omega2;
            } else if (kind.file == File::ShortCrank) {
                of.a *= 0.97;
            }
            const ClaimFile file = printed(kind, of);
            auto outcome = readReferenceData(file.text);
            QVERIFY2(std::holds_alternative<ReferenceData>(outcome), file.text.c_str());
            const ReferenceData &data = std::get<ReferenceData>(outcome);
            const std::vector<ChannelComparison> found = compareExactly(Mechanism(model), data).channels;
            QCOMPARE(found.size(), kind.channels.size());
            Verdict worst = Verdict::Agrees;
            for (std::size_t k = 0; k < found.size(); ++k) {
                worst = std::max(worst, found[k].verdict);
                const double error = errorOf(file.columns[k], valuesOf(model, kind.channels[k], file.times));
                const QString what = QStringLiteral("file %1, %2: %3 of the peak too far, %4 of %5 within, worst %6, "
                                                    "excess %7\n%8")
                                         .arg(i)
                                         .arg(nameOf(found[k].channel).data())
                                         .arg(error)
                                         .arg(found[k].withinBound)
                                         .arg(found[k].count)
                                         .arg(found[k].worstOver)
                                         .arg(found[k].excess)
                                         .arg(file.text.c_str());
                const bool isTooFar = error > kTooFar;
                tooFar += isTooFar ? 1 : 0;
                QVERIFY2(!isTooFar || found[k].verdict == Verdict::Differs, qPrintable(what));
                QVERIFY2(kind.file != File::True || found[k].verdict != Verdict::Differs, qPrintable(what));
            }
            right += worst <= kind.atLeast ? 1 : 0;
        }
        if (kind.file == File::True) {
            QVERIFY2(100 * right >= 95 * files, qPrintable(QString::number(right)));
        } else {
            QVERIFY2(2 * tooFar >= files, qPrintable(QString::number(tooFar)));
        }
    }
};

const Suite suite("tst_verdicts", runWithoutApplication<TestVerdicts>);
#include "tst_verdicts.moc"
