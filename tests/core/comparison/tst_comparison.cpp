// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/comparison/comparison.h"
#include "tests/support/files.h"
#include "tests/support/reading.h"
#include "tests/support/suite.h"

#include <QFile>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <vector>

using namespace slidercrank;

namespace tst_comparison
{

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr Channel kOffset{R4y, Order::Position};
const Mechanism kMechanism({.a = 100.0, .b = 300.0, .c = 0.0, .omega2 = 2.0});
constexpr std::size_t kRows = 100;

/// The rounding of a column with three decimals; half its step is kHalfStep.
const Rounding kThreeDecimals{Rounding::Rule::Decimals, 3};
const Rounding kSixDigits{Rounding::Rule::SignificantDigits, 6};
constexpr double kHalfStep = 0.0005;

/// Compares two columns of a channel. R4y is constant, so its errors are measured relative to a = 100 mm.
ChannelComparison compareValues(const std::vector<double> &model, const std::vector<double> &values,
                                const Rounding &rounding = kThreeDecimals, Channel channel = kOffset)
{
    ReferenceData data;
    Trajectory motion;
    for (std::size_t i = 0; i < values.size(); ++i) {
        data.time.push_back(0.5 * static_cast<double>(i));
    }
    data.series.push_back({channel, values, rounding});
    motion.values[indexOf(channel)] = model;
    return compare(kMechanism, motion, data).front();
}

SolverSettings byMethod(Method method)
{
    SolverSettings settings;
    settings.method = method;
    return settings;
}

std::vector<ChannelComparison> compareFile(const QString &path, double b, Method method)
{
    const auto outcome = readReferenceData(contentOf(path).toStdString());
    const ReferenceData *data = std::get_if<ReferenceData>(&outcome);
    const Mechanism mechanism({.b = b});
    return data ? compare(mechanism, sample(mechanism, data->time, plottedChannels(), byMethod(method)), *data)
                : std::vector<ChannelComparison>();
}

const QString kInventorFile = qEnvironmentVariable("SLIDERCRANK_REFERENCE_FILE");

/// Returns whether the value agrees with the quoted one, which has three digits.
bool isNear(double value, double quoted)
{
    return std::abs(value - quoted) <= 5e-3 * quoted;
}

class TestComparison : public QObject
{
    Q_OBJECT

private slots:
    void measuresTheErrors()
    {
        const ChannelComparison result = compareValues({1.0, 2.5, -3.0, 0.25, 7.0}, {1.0, 2.0, -4.0, 0.0, kNaN});
        QCOMPARE(result.channel, kOffset);
        QCOMPARE(result.count, std::size_t(4));
        QCOMPARE(result.missingModelCount, std::size_t(0));
        QCOMPARE(result.largestError.value(), 1.0);
        QCOMPARE(result.timeOfLargestError, 1.0);
        QCOMPARE(compareValues({1.0, 1.0}, {0.0, 0.0}).timeOfLargestError, 0.0); // the first of equal errors
        QCOMPARE(result.rms.value(), std::sqrt((0.0 + 0.25 + 1.0 + 0.0625) / 4.0));
        QCOMPARE(result.maxPercent.value(), 25.0);
        QCOMPARE(result.timeOfMaxPercent, 0.5); // the first of two equal maxima
        QCOMPARE(result.zeroReferenceCount, std::size_t(1));
        QCOMPARE(result.percentOfPeak.value(), 25.0);
        QCOMPARE(result.roundingStep.value(), 0.001);
        QCOMPARE(result.verdict, Verdict::Differs);
    }

    void judgesByHalfSteps()
    {
        struct Row {
            std::size_t count; ///< number of deviating values among a hundred values near 10
            double halfSteps;
            Verdict verdict;
        };
        for (const auto &[count, halfSteps, verdict] :
             {Row{0, 0.0, Verdict::Agrees}, Row{kRows, 1.0, Verdict::Agrees}, Row{5, 1.1, Verdict::Agrees},
              Row{6, 1.1, Verdict::Close}, Row{5, 10.0, Verdict::Agrees}, Row{1, 10.1, Verdict::Close},
              Row{kRows, 100.0, Verdict::Close}, Row{1, 100.1, Verdict::Differs}}) {
            const std::vector<double> values(kRows, 10.0);
            std::vector<double> model = values;
            for (std::size_t i = 0; i < count; ++i) {
                model[i] += (i % 2 == 0 ? 1.0 : -1.0) * halfSteps * kHalfStep;
            }
            const ChannelComparison result = compareValues(model, values);
            QCOMPARE(result.verdict, verdict);
            QVERIFY(std::abs(result.largestErrorInBounds - (count > 0 ? halfSteps : 0.0)) < 1e-9 * (1.0 + halfSteps));
            QCOMPARE(result.countWithinBound, halfSteps <= 1.0 ? kRows : kRows - count);
        }
    }

    /// The error is relative to half the range of the motion, at most 180° for the crank. A constant channel has no
    /// range: its size follows from a and ω2.
    void verdictDependsOnTheErrorRelativeToTheMotion()
    {
        struct Row {
            double percentBeyond; ///< half a rounding step
            Verdict verdict;
        };
        for (const auto &[channel, halfRange, size] :
             {std::tuple(Channel{R4x, Order::Position}, 100.0, 100.0),
              std::tuple(Channel{Theta2, Order::Position}, 1000.0, 180.0), std::tuple(kOffset, 0.0, 100.0),
              std::tuple(Channel{R4y, Order::Acceleration}, 0.0, 400.0),
              std::tuple(Channel{Theta2, Order::Velocity}, 0.0, 2.0 * kDegreesPerRadian)}) {
            for (const auto &[percentBeyond, verdict] :
                 {Row{-0.1, Verdict::Agrees}, Row{0.4, Verdict::Agrees}, Row{0.6, Verdict::Close},
                  Row{0.9, Verdict::Close}, Row{1.1, Verdict::Differs}, Row{65.0, Verdict::Differs}}) {
                std::vector<double> values;
                for (std::size_t i = 0; i < kRows; ++i) {
                    values.push_back(i % 2 == 0 ? halfRange : -halfRange);
                }
                std::vector<double> model = values;
                model[50] -= 0.5 + 0.01 * percentBeyond * size;
                const ChannelComparison result = compareValues(model, values, {Rounding::Rule::Decimals, 0}, channel);
                QCOMPARE(result.verdict, verdict);
                QVERIFY(std::abs(result.excess - 0.01 * std::max(percentBeyond, 0.0)) < 1e-9);
            }
        }
    }

    /// An error of 0.004 is below half a rounding step of 1139.91, but 80 half steps of 12.3456.
    void usesTheRoundingStepOfEachValue()
    {
        QCOMPARE(compareValues({12.3456, 1139.914}, {12.3456, 1139.91}, kSixDigits).verdict, Verdict::Agrees);
        QCOMPARE(compareValues({12.3496, 1139.91}, {12.3456, 1139.91}, kSixDigits).verdict, Verdict::Close);
        const std::vector<double> values{12.3456, -1139.91, 123.456, kNaN};
        QVERIFY(std::abs(compareValues(values, values, kSixDigits).roundingStep.value() - 0.01) < 1e-12);
    }

    /// Values below the rounding step of the largest values, or below double precision, count as zero.
    void countsValuesThatAreZeroWithinRounding()
    {
        struct Row {
            std::vector<double> model;
            std::vector<double> values;
            Rounding rounding;
            Verdict verdict;
            std::size_t zeros;
        };
        const Rounding residue{
            .rule = Rounding::Rule::SignificantDigits, .digits = 6, .smallestExponent = -15, .finestPlace = -20};
        const Rounding seventeen{Rounding::Rule::SignificantDigits, 17};
        for (const auto &[model, values, rounding, verdict, zeros] :
             {Row{{132.005, 1.3e-6, -131.257}, {132.005, -7.4e-15, -131.257}, residue, Verdict::Agrees, 1},
              Row{{40.0, 3e-15}, {40.0, 1e-15}, seventeen, Verdict::Agrees, 1},
              Row{{40.0, 0.011}, {40.0, 0.01}, kThreeDecimals, Verdict::Close, 0},
              Row{{40.0, 0.0007}, {40.0, 0.0004}, kThreeDecimals, Verdict::Agrees, 1},
              Row{{75.0 + 1e-13, 30.0, 1e-9}, {75.0, 30.0 - 1e-13, 1e-9}, seventeen, Verdict::Agrees, 0},
              Row{{1e10, -1e-200}, {1e-300, 1e300}, kThreeDecimals, Verdict::Differs, 1}}) {
            const ChannelComparison result = compareValues(model, values, rounding);
            QCOMPARE(result.verdict, verdict);
            QCOMPARE(result.zeroReferenceCount, zeros);
            QVERIFY(std::isfinite(*result.rms) && std::isfinite(result.maxPercent.value()));
        }
    }

    /// The size of a channel that is always zero is the natural size of the mechanism.
    void judgesZerosByTheNaturalSize()
    {
        for (const auto &[noise, verdict] :
             {std::pair(0.0, Verdict::Agrees), std::pair(1e-14, Verdict::Agrees), std::pair(1e-7, Verdict::Differs)}) {
            const ChannelComparison result =
                compareValues(std::vector(kRows, noise), std::vector(kRows, 0.0), Rounding());
            QCOMPARE(result.verdict, verdict);
            QCOMPARE(result.zeroReferenceCount, kRows);
            QVERIFY(!result.maxPercent && !result.percentOfPeak && !result.roundingStep);
            QCOMPARE(result.largestError.value(), noise);
        }
    }

    void differsWhereTheModelIsMissing()
    {
        const ChannelComparison missing = compareValues({1.0, kNaN, kNaN}, {1.0, 1.0, kNaN});
        QCOMPARE(missing.count, std::size_t(1));
        QCOMPARE(missing.missingModelCount, std::size_t(1));
        QCOMPARE(missing.largestError.value(), 0.0);
        QCOMPARE(missing.verdict, Verdict::Differs);
        const ChannelComparison empty = compareValues({1.0, 2.0}, {kNaN, kNaN});
        QCOMPARE(empty.count, std::size_t(0));
        QVERIFY(!empty.largestError && !empty.rms && !empty.maxPercent && !empty.percentOfPeak && !empty.roundingStep);
        QCOMPARE(empty.verdict, Verdict::Differs);
    }

    /// With both methods: rounded time stamps of an even sampling explain small differences, and the verdict is Close.
    void evenTimeStampsMayBeRounded()
    {
        struct Row {
            double spacing;
            Verdict verdict;
        };
        for (const auto &[spacing, verdict] :
             {Row{0.0133, Verdict::Agrees}, Row{0.0133005, Verdict::Close}, Row{0.0135, Verdict::Differs}}) {
            const Mechanism mechanism;
            const Channel speed{R4x, Order::Velocity};
            ReferenceData data;
            data.timeRounding = {
                .rule = Rounding::Rule::Decimals, .digits = 4, .smallestExponent = -2, .finestPlace = -4};
            std::vector<double> meant;
            for (int i = 0; i < 61; ++i) {
                meant.push_back(spacing * i);
                data.time.push_back(std::round(133.0 * i) / 1e4); // four decimals
            }
            const Trajectory motion = sample(mechanism, meant, plottedChannels(), byMethod(Method::ClosedForm));
            data.series.push_back({speed, motion[speed], kSixDigits});
            const Trajectory solved = sample(mechanism, data.time, plottedChannels(), byMethod(Method::Newton));
            for (const ChannelComparison &found :
                 {compareExactly(mechanism, data).channels.front(), compare(mechanism, solved, data).front()}) {
                QCOMPARE(found.verdict, verdict);
                QCOMPARE(found.clockIsRounded, verdict == Verdict::Close);
            }
        }
    }

    /// Time stamps with two decimals are too coarse for a verdict, so that the file differs. They explain the errors of
    /// the mechanism that produced the file, but not those of b = 66 mm.
    void saysThatRoundedTimeStampsExplainTheErrors()
    {
        const Mechanism produced{Parameters()};
        std::vector<double> exactTimes;
        ReferenceData data;
        for (int i = 0; i < 40; ++i) {
            exactTimes.push_back(0.05 * i + 0.02 * std::sin(3.0 * i)); // as of a solver with steps of different lengths
            data.time.push_back(std::round(100.0 * exactTimes.back()) / 100.0);
        }
        data.timeRounding = {Rounding::Rule::Decimals, 2};
        const ChannelSet channels = plottedChannels();
        const Trajectory motion = sample(produced, exactTimes, channels, {});
        for (const Channel channel : kPlottedChannels) {
            data.series.push_back({channel, motion[channel], {Rounding::Rule::Decimals, 6}});
        }
        for (const double b : {65.0, 66.0}) {
            const Mechanism mechanism({.b = b});
            const Trajectory model = sample(mechanism, data.time, channels, {});
            std::vector<ChannelComparison> compared = compare(mechanism, model, data);
            findRoundedTime(compared, mechanism, model, data);
            for (const ChannelComparison &channel : compared) {
                QVERIFY(channel.verdict == Verdict::Differs);
                QCOMPARE(channel.isWithinRoundedTime, b == 65.0);
            }
        }
    }

    /// The comparison of 100 001 rows with several threads equals that of each channel alone.
    void comparesLongFiles()
    {
        const Mechanism mechanism({.b = 44.0}); // cannot be assembled everywhere
        ReferenceData data;
        for (int i = 0; i < 100'001; ++i) {
            data.time.push_back(1e-5 * i);
        }
        const Trajectory model = sample(mechanism, data.time, plottedChannels(), byMethod(Method::ClosedForm));
        for (const Channel channel : kPlottedChannels) {
            data.series.push_back({channel, model[channel], kSixDigits});
            data.series.back().values[7] += 1.0;
        }
        const ExactComparison found = compareExactly(mechanism, data);
        QVERIFY(found.status == model.status && model.summary.count(Status::NotAssemblable) > 0);
        for (std::size_t k = 0; k < data.series.size(); ++k) {
            ReferenceData one;
            one.time = data.time;
            one.series.push_back(data.series[k]);
            const ChannelComparison alone = compare(mechanism, model, one).front();
            QVERIFY(std::abs(*alone.largestError - 1.0) < 1e-9);
            QCOMPARE(found.channels[k].largestError, alone.largestError);
            QCOMPARE(found.channels[k].rms, alone.rms);
            QCOMPARE(found.channels[k].count, alone.count);
        }
    }

    void confirmsTheReportWithTheLengthOfItsData()
    {
        if (!QFile::exists(kInventorFile)) {
            QSKIP("SLIDERCRANK_REFERENCE_FILE does not name the reference report's CSV file.");
        }
        struct Row {
            Channel channel;
            double largestError;
            double maxPercent;
            std::size_t zeroReferenceCount;
        };
        const std::vector<Row> rows{
            {{R4x, Order::Position}, 4.98e-5, 1.54e-4, 0},     {{R4x, Order::Velocity}, 4.93e-4, 4.45e-4, 0},
            {{R4x, Order::Acceleration}, 4.55e-3, 3.96e-4, 0}, {{Theta3, Order::Position}, 4.92e-4, 8.03e-3, 0},
            {{Theta3, Order::Velocity}, 5.05e-4, 1.322e-2, 2}, {{Theta3, Order::Acceleration}, 4.00e-3, 3.56e-4, 0}};
        for (const Method method : {Method::Newton, Method::ClosedForm}) {
            const std::vector<ChannelComparison> comparisons = compareFile(kInventorFile, 60.0, method);
            QCOMPARE(comparisons.size(), rows.size());
            for (std::size_t i = 0; i < rows.size(); ++i) {
                QCOMPARE(comparisons[i].channel, rows[i].channel);
                QVERIFY(isNear(comparisons[i].largestError.value(), rows[i].largestError));
                QVERIFY(isNear(comparisons[i].maxPercent.value(), rows[i].maxPercent));
                QCOMPARE(comparisons[i].zeroReferenceCount, rows[i].zeroReferenceCount);
                QCOMPARE(comparisons[i].verdict, Verdict::Agrees);
            }
        }
        const std::vector<ChannelComparison> table1 = compareFile(kInventorFile, 65.0, Method::ClosedForm);
        QVERIFY(std::ranges::all_of(table1, [](const auto &found) { return found.verdict == Verdict::Differs; }));
        const auto comparisonOf = [&table1](Channel channel) {
            return *std::ranges::find(table1, channel, &ChannelComparison::channel);
        };
        const ChannelComparison slider = comparisonOf({R4x, Order::Position});
        QVERIFY(isNear(slider.maxPercent.value(), 20.9) && isNear(slider.largestError.value(), 7.22));
        QVERIFY(isNear(comparisonOf({Theta3, Order::Position}).maxPercent.value(), 9.83));
    }

    void comparesTwoMotionsLikeAFile()
    {
        struct Row {
            Parameters parameters;
            double from;
            double to;
        };
        const Mechanism other;
        for (const auto &[parameters, from, to] :
             {Row{{.b = 75.0}, 0.0, 1.0}, Row{{.b = 75.0}, 1.0, 0.0}, Row{{.b = 75.0}, 0.1, 0.35},
              Row{{.omega2 = 8.0}, -0.4, 2.1}, Row{{.b = 66.0}, 0.0, 1000.0}}) {
            const MotionDifference found = differenceOf(Mechanism(parameters), other, from, to);
            QVERIFY(!found.hasGaps);
            const Sampling sampling{std::min(from, to), std::min(std::abs(to - from), 2.5), 3000};
            const SolverSettings newton = byMethod(Method::Newton);
            const Trajectory first = sample(Mechanism(parameters), sampling.timeStamps(), plottedChannels(), newton);
            const Trajectory second = sample(other, sampling.timeStamps(), plottedChannels(), newton);
            for (const ChannelComparison &channel : found.channels) {
                double largest = 0.0;
                for (std::size_t i = 0; i < first.time.size(); ++i) {
                    largest = std::max(largest, std::abs(first[channel.channel][i] - second[channel.channel][i]));
                }
                QVERIFY(isNear(channel.largestError.value(), largest));
                QVERIFY(channel.timeOfLargestError >= std::min(from, to) &&
                        channel.timeOfLargestError <= std::max(from, to));
            }
        }
        QCOMPARE(differenceOf(other, other, 0.0, 1.0).channels[5].largestError.value(), 0.0);
        QVERIFY(differenceOf(Mechanism({.b = 40.0}), other, 0.0, 1.0).hasGaps); // a + |c| = 45
        QVERIFY(!differenceOf(Mechanism({.b = 40.0}), other, 0.1, 0.4).hasGaps);
    }
};

const Suite<TestComparison> suite("tst_comparison");

} // namespace tst_comparison

#include "tst_comparison.moc"
