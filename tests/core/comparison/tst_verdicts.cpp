// SPDX-License-Identifier: GPL-3.0-or-later

// Tests the verdict about files of known origin, for random mechanisms. A file of the mechanism itself never gets the
// verdict `differs`. A file whose error exceeds half a rounding step plus 2 % of its peak never gets a better verdict.

#include "core/comparison/comparison.h"
#include "tests/support/long_tests.h"
#include "tests/support/printed_motion.h"
#include "tests/support/random_mechanisms.h"
#include "tests/support/suite.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

using namespace slidercrank;

namespace
{

constexpr double kTooFar = 0.02; // of the peak, beyond half a rounding step

/// Returns the value of a channel by the textbook's formulas, in the default units (mm, °, s).
double exactValue(const Parameters &p, Channel channel, double t)
{
    const double degree = std::numbers::pi / 180.0;
    if (channel.coordinate == Theta2) {
        return channel.order == Order::Position ? (p.omega2 * t + p.theta20) / degree : p.omega2 / degree;
    }
    if (channel.coordinate == R4y) {
        return channel.order == Order::Position ? p.c : 0.0;
    }
    const auto place = std::ranges::find(kPlottedChannels, channel) - kPlottedChannels.begin();
    return static_cast<double>(textbookMotion(p, t)[static_cast<std::size_t>(place)]);
}

std::string text(const char *format, double value)
{
    std::array<char, 64> cell{};
    std::snprintf(cell.data(), cell.size(), format, value);
    return cell.data();
}

/// Returns the value rounded to six significant digits.
double toSixDigits(double value)
{
    return std::strtod(text("%.6g", value).c_str(), nullptr);
}

enum class File { True, OtherMechanism, ShortCrank };

struct Kind {
    File file = File::True;
    std::vector<Channel> channels;
    const char *format = "%.6g";
    const char *timeFormat = "%.9g";
    double rate = 30.0; ///< rows per second
    int rows = 61;
    bool rocks = false;                ///< rocker: the file has gaps
    bool chosenAngles = false;         ///< the crank advances by whole degrees
    bool sixDigits = false;            ///< values are rounded to six digits before they are printed
    double clockError = 0.0;           ///< error of the last time stamp, in units of its fourth decimal
    Verdict atLeast = Verdict::Agrees; ///< required verdict in 95 % of the true files
};

const std::vector<Channel> kSix(kPlottedChannels.begin(), kPlottedChannels.end());
constexpr Channel kSlider{R4x, Order::Position};
constexpr Channel kSliderSpeed{R4x, Order::Velocity};
constexpr Channel kCrank{Theta2, Order::Position};

std::vector<std::pair<const char *, Kind>> kinds()
{
    const std::vector<Channel> constants{
        kSlider, {R4y, Order::Position}, {R4y, Order::Velocity}, {Theta2, Order::Velocity}};
    return {
        {"six columns of six digits", {.channels = kSix, .rate = 100.0, .rows = 201}},
        {"time stamps of 4 decimals", {.channels = kSix, .timeFormat = "%.4f"}},
        {"time stamps of 2 decimals", {.channels = kSix, .timeFormat = "%.2f"}},
        {"time stamps of 9 digits, values of 9", {.channels = kSix, .format = "%.9g"}},
        {"time stamps of 4 decimals, evenly spaced all the same",
         {.channels = kSix, .timeFormat = "%.4f", .rate = 1.0 / 0.0133, .clockError = 0.45, .atLeast = Verdict::Close}},
        {"a double's own digits", {.channels = kSix, .format = "%.17g", .timeFormat = "%.17g"}},
        {"six digits printed with 19", {.channels = kSix, .format = "%.18e", .timeFormat = "%.18e", .sixDigits = true}},
        {"six digits printed with six decimals", {.channels = kSix, .format = "%.6f", .sixDigits = true}},
        {"constants", {.channels = constants}},
        {"constants of six digits printed with six decimals",
         {.channels = constants, .format = "%.6f", .sixDigits = true}},
        {"whole millimetres", {.channels = {kSlider}, .format = "%.0f", .rate = 100.0, .rows = 201}},
        {"rockers", {.channels = kSix, .rate = 100.0, .rows = 201, .rocks = true}},
        {"rockers, time stamps of 4 decimals", {.channels = kSix, .timeFormat = "%.4f", .rocks = true}},
        {"rockers, time stamps of 2 decimals", {.channels = kSix, .timeFormat = "%.2f", .rocks = true}},
        {"chosen angles", {.channels = {kCrank, kSlider}, .format = "%.0f", .rate = 100.0, .chosenAngles = true}},
        {"two rows", {.channels = kSix, .timeFormat = "%.1f", .rate = 10.0, .rows = 2}},
        {"whole millimetres of another mechanism",
         {.file = File::OtherMechanism, .channels = {kSlider}, .format = "%.0f", .rate = 100.0, .rows = 201}},
        {"whole millimetres and 4 decimals of time, of another mechanism",
         {.file = File::OtherMechanism, .channels = {kSlider}, .format = "%.0f", .timeFormat = "%.4f"}},
        {"six columns of another mechanism", {.file = File::OtherMechanism, .channels = kSix, .timeFormat = "%.4f"}},
        {"constants of another mechanism",
         {.file = File::OtherMechanism, .channels = constants, .format = "%.6f", .sixDigits = true}},
        {"two rows of another mechanism",
         {.file = File::OtherMechanism,
          .channels = {kSlider},
          .format = "%.0f",
          .timeFormat = "%.1f",
          .rate = 2.0,
          .rows = 2}},
        {"three rows of another mechanism, a tenth of a second apart",
         {.file = File::OtherMechanism, .channels = kSix, .timeFormat = "%.1f", .rate = 10.0, .rows = 3}},
        {"few time stamps of another mechanism, unevenly chosen",
         {.file = File::OtherMechanism, .channels = kSix, .timeFormat = "%.1f", .rate = 7.0, .rows = 8}},
        {"chosen angles of another mechanism",
         {.file = File::OtherMechanism, .channels = {kCrank, kSlider}, .format = "%.0f", .rate = 100.0, .rows = 101}},
        {"a 3 % short, whole millimetres",
         {.file = File::ShortCrank, .channels = {kSlider, kSliderSpeed}, .format = "%.0f", .rate = 100.0, .rows = 201}},
        {"a 3 % short, six digits", {.file = File::ShortCrank, .channels = kSix, .rate = 100.0, .rows = 201}},
        {"a 3 % short, time stamps of 4 decimals", {.file = File::ShortCrank, .channels = kSix, .timeFormat = "%.4f"}},
    };
}

/// A file and the error of its values with respect to the model at the exact time stamps.
struct Written {
    std::string bytes;
    std::vector<double>
        tooFar; ///< for each channel, the largest error minus half a rounding step, relative to the peak
};

Written written(const Kind &kind, const Parameters &of, const Parameters &model)
{
    Written file{"time", std::vector<double>(kind.channels.size(), -std::numeric_limits<double>::infinity())};
    for (const Channel channel : kind.channels) {
        file.bytes += ',' + std::string(nameOf(channel));
    }
    const double spacing = 1.0 / kind.rate + kind.clockError * 0.5e-4 / kind.rows;
    std::vector<double> peaks(kind.channels.size(), 0.0);
    std::vector<double> farthest(kind.channels.size(), 0.0);
    for (int row = 0; row < kind.rows; ++row) {
        const double t = row * spacing;
        file.bytes += '\n' + text(kind.timeFormat, t);
        for (std::size_t k = 0; k < kind.channels.size(); ++k) {
            const double value = exactValue(of, kind.channels[k], t);
            const std::string cell = text(kind.format, kind.sixDigits ? toSixDigits(value) : value);
            file.bytes += ',' + cell;
            if (std::isnan(value)) {
                continue;
            }
            const bool isWhole = std::string(kind.format) == "%.0f";
            const double half = isWhole ? 0.5 : std::abs(std::strtod(cell.c_str(), nullptr) - value);
            peaks[k] = std::max(peaks[k], std::abs(value));
            farthest[k] = std::max(farthest[k], std::abs(exactValue(model, kind.channels[k], t) - value) - half);
        }
    }
    file.bytes += '\n';
    for (std::size_t k = 0; k < kind.channels.size(); ++k) {
        file.tooFar[k] = farthest[k] / peaks[k];
    }
    return file;
}

/// Returns the mechanism with a speed that makes at most three turns in two seconds.
Parameters slow(Parameters p, RandomMechanisms &random)
{
    p.omega2 = std::copysign(random.uniform(0.5, 3.0) * std::numbers::pi, p.omega2);
    return p;
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
            QTest::newRow(all[i].first) << static_cast<int>(i);
        }
    }

    void areTrue()
    {
        QFETCH(const int, place);
        const Kind kind = kinds()[static_cast<std::size_t>(place)].second;
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
            const Written file = written(kind, of, model);
            auto outcome = readReferenceData(file.bytes);
            QVERIFY2(std::holds_alternative<ReferenceData>(outcome), file.bytes.c_str());
            const ReferenceData &data = std::get<ReferenceData>(outcome);
            const std::vector<ChannelComparison> found = compareExactly(Mechanism(model), data).channels;
            QCOMPARE(found.size(), kind.channels.size());
            Verdict worst = Verdict::Agrees;
            for (std::size_t k = 0; k < found.size(); ++k) {
                worst = std::max(worst, found[k].verdict);
                const QString what = QStringLiteral("file %1, %2: %3 of the peak too far, %4 of %5 within, worst %6, "
                                                    "excess %7\n%8")
                                         .arg(i)
                                         .arg(nameOf(found[k].channel).data())
                                         .arg(file.tooFar[k])
                                         .arg(found[k].withinBound)
                                         .arg(found[k].count)
                                         .arg(found[k].worstOver)
                                         .arg(found[k].excess)
                                         .arg(file.bytes.c_str());
                const bool isTooFar = file.tooFar[k] > kTooFar;
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
