// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/comparison/comparison.h"
#include "core/comparison/motion_difference.h"

#include <QFile>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

using namespace slidercrank;

namespace
{

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr Channel kTheta3{Theta3, Order::Position};
constexpr ChannelSize kSize{1.0, 100.0}; // errors are small beside its motion
constexpr std::size_t kRows = 100;

/// A column printed with three decimals: half a step is 0.0005.
const Rounding kThreeDecimals{Rounding::Rule::Decimals, 3};
constexpr double kHalfStep = 0.0005;

ReferenceSeries seriesOf(std::vector<double> values, const Rounding &rounding = kThreeDecimals)
{
    return {kTheta3, std::move(values), rounding};
}

std::vector<double> instants(std::size_t count)
{
    std::vector<double> time(count);
    for (std::size_t i = 0; i < count; ++i) {
        time[i] = 0.005 * static_cast<double>(i);
    }
    return time;
}

/// The verdict on a hundred values near 10 of which some are off by so many half steps.
Verdict verdictWith(std::size_t offCount, double halfSteps)
{
    const std::vector<double> time = instants(kRows);
    const std::vector<double> values(kRows, 10.0);
    std::vector<double> model = values;
    for (std::size_t i = 0; i < offCount; ++i) {
        model[i] += (i % 2 == 0 ? 1.0 : -1.0) * halfSteps * kHalfStep;
    }
    return compareChannel(time, model, seriesOf(values), kSize).verdict;
}

QByteArray bytesOf(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

std::vector<ChannelComparison> compareFile(const QByteArray &bytes, double b, Method method)
{
    const auto outcome = readReferenceData({bytes.constData(), static_cast<std::size_t>(bytes.size())});
    const ReferenceData *data = std::get_if<ReferenceData>(&outcome);
    if (!data) {
        return {};
    }
    Parameters parameters;
    parameters.b = b;
    const Mechanism mechanism(parameters);
    SolverSettings settings;
    settings.method = method;
    return compare(mechanism, sample(mechanism, data->time, plottedChannels(), settings), *data);
}

const QString kAuthorsFile = QStringLiteral(SLIDERCRANK_SOURCE_DIR "/../shared/reference/InventorData.csv");
const QString kSample = QStringLiteral(SLIDERCRANK_SOURCE_DIR "/data/inventor_sample.csv");

/// Measured values are quoted with three digits: that near.
bool isNear(double value, double quoted)
{
    return std::abs(value - quoted) <= 5e-3 * quoted;
}

} // namespace

class TestComparison : public QObject
{
    Q_OBJECT

private slots:
    void measuresTheErrors()
    {
        const std::vector<double> time{0.0, 0.5, 1.0, 1.5, 2.0};
        const std::vector<double> model{1.0, 2.5, -3.0, 0.25, 7.0};
        const ChannelComparison result = compareChannel(time, model, seriesOf({1.0, 2.0, -4.0, 0.0, kNaN}), kSize);
        QCOMPARE(result.channel, kTheta3);
        QCOMPARE(result.count, std::size_t(4));
        QCOMPARE(result.missingModel, std::size_t(0));
        QCOMPARE(result.maxAbs.value(), 1.0);
        QCOMPARE(result.timeOfMaxAbs, 1.0);
        QCOMPARE(result.rms.value(), std::sqrt((0.0 + 0.25 + 1.0 + 0.0625) / 4.0));
        QCOMPARE(result.maxPercent.value(), 25.0);
        QCOMPARE(result.timeOfMaxPercent, 0.5);
        QCOMPARE(result.zeroReference, std::size_t(1));
        QCOMPARE(result.percentOfPeak.value(), 25.0);
        QCOMPARE(result.roundingStep.value(), 0.001);
        QCOMPARE(result.verdict, Verdict::Differs);
    }

    void countsHalfSteps()
    {
        // Off by 0, 0.6, 2, 7.5 halves; the fifth has no model.
        const std::vector<double> values(5, 10.0);
        const std::vector<double> model{10.0, 10.0 + 0.6 * kHalfStep, 10.0 - 2.0 * kHalfStep, 10.0 + 7.5 * kHalfStep,
                                        kNaN};
        const ChannelComparison result = compareChannel(instants(5), model, seriesOf(values), kSize);
        QCOMPARE(result.withinBound, std::size_t(2));
        QVERIFY2(std::abs(result.worstOver - 7.5) < 1e-9, qPrintable(QString::number(result.worstOver, 'g', 17)));
        QCOMPARE(compareChannel(instants(5), values, seriesOf(values), kSize).worstOver, 0.0);
    }

    void keepsTheFirstOfEqualErrors()
    {
        const ChannelComparison result =
            compareChannel(std::vector{0.0, 1.0, 2.0}, std::vector{1.0, 3.0, 1.0}, seriesOf({2.0, 2.0, 2.0}), kSize);
        QCOMPARE(result.timeOfMaxAbs, 0.0);
        QCOMPARE(result.timeOfMaxPercent, 0.0);
    }

    void quotesTheStepWhereItIsLargest()
    {
        const Rounding six{Rounding::Rule::SignificantDigits, 6};
        const std::vector<double> values{12.3456, -1139.91, 123.456, kNaN};
        const ChannelComparison result = compareChannel(instants(4), values, seriesOf(values, six), kSize);
        QVERIFY(std::abs(result.roundingStep.value() - 0.01) < 1e-12);
    }

    void judges_data()
    {
        QTest::addColumn<std::size_t>("off");
        QTest::addColumn<double>("halfSteps");
        QTest::addColumn<Verdict>("verdict");
        QTest::newRow("all the same") << std::size_t(0) << 0.0 << Verdict::Agrees;
        QTest::newRow("all off by one half step") << kRows << 1.0 << Verdict::Agrees;
        QTest::newRow("5 % beyond a half step") << std::size_t(5) << 1.1 << Verdict::Agrees;
        QTest::newRow("6 % beyond a half step") << std::size_t(6) << 1.1 << Verdict::Close;
        QTest::newRow("5 % at ten") << std::size_t(5) << 10.0 << Verdict::Agrees;
        QTest::newRow("one beyond ten") << std::size_t(1) << 10.1 << Verdict::Close;
        QTest::newRow("all beyond ten") << kRows << 10.1 << Verdict::Close;
        QTest::newRow("all at a hundred") << kRows << 100.0 << Verdict::Close;
        QTest::newRow("one beyond a hundred") << std::size_t(1) << 100.1 << Verdict::Differs;
        QTest::newRow("all beyond a hundred") << kRows << 1000.0 << Verdict::Differs;
    }

    void judges()
    {
        QFETCH(const std::size_t, off);
        QFETCH(const double, halfSteps);
        QTEST(verdictWith(off, halfSteps), "verdict");
    }

    void whatLiesBeyondIsSmallBesideTheMotion_data()
    {
        QTest::addColumn<double>("beyond");
        QTest::addColumn<Verdict>("verdict");
        QTest::newRow("within") << -0.1 << Verdict::Agrees;
        QTest::newRow("0.4 %") << 0.4 << Verdict::Agrees;
        QTest::newRow("0.6 %") << 0.6 << Verdict::Close;
        QTest::newRow("0.9 %") << 0.9 << Verdict::Close;
        QTest::newRow("1.1 %") << 1.1 << Verdict::Differs;
        QTest::newRow("65 %") << 65.0 << Verdict::Differs;
    }

    void whatLiesBeyondIsSmallBesideTheMotion()
    {
        // Whole numbers, of a motion with a range of 200: half of it is 100.
        QFETCH(const double, beyond);
        const Rounding whole{Rounding::Rule::Decimals, 0};
        std::vector<double> values;
        for (std::size_t i = 0; i < kRows; ++i) {
            values.push_back(i % 2 == 0 ? 100.0 : -100.0);
        }
        std::vector<double> model = values;
        model[50] -= 0.5 + beyond;
        const ChannelComparison result = compareChannel(instants(kRows), model, seriesOf(values, whole), {});
        QTEST(result.verdict, "verdict");
        QVERIFY2(std::abs(result.excess - 0.01 * std::max(beyond, 0.0)) < 1e-9,
                 qPrintable(QString::number(result.excess)));
    }

    void knowsHowLargeAMotionIs()
    {
        const Mechanism mechanism;
        const double omega = mechanism.omega2();
        QCOMPARE(sizeOf(mechanism, {R4y, Order::Position}).still, 20.0);
        QCOMPARE(sizeOf(mechanism, {R4y, Order::Acceleration}).still, 20.0 * omega * omega);
        QCOMPARE(sizeOf(mechanism, {Theta2, Order::Velocity}).still, omega * kDegreesPerRadian);
        QCOMPARE(sizeOf(mechanism, {Theta2, Order::Position}).most, 180.0);
        QCOMPARE(sizeOf(mechanism, {R4x, Order::Position}).still, 0.0); // the range of the model
    }

    void takesAResidueForZero()
    {
        // Six digits of what is nothing but arithmetic: the other program's zero.
        const Rounding six{Rounding::Rule::SignificantDigits, 6, 1.0, -15, -20};
        const std::vector<double> values{132.005, -7.4e-15, -131.257};
        const ChannelComparison result =
            compareChannel(instants(3), std::vector{132.005, 1.3e-6, -131.257}, seriesOf(values, six), kSize);
        QCOMPARE(result.verdict, Verdict::Agrees);
    }

    void anEvenClockMayBeARoundedOne_data()
    {
        QTest::addColumn<double>("spacing");
        QTest::addColumn<bool>("isRounded");
        QTest::addColumn<Verdict>("verdict");
        QTest::newRow("it is not") << 0.0133 << false << Verdict::Agrees;
        QTest::newRow("it is") << 0.0133005 << true << Verdict::Close;
        QTest::newRow("it is no such clock") << 0.0135 << false << Verdict::Differs;
    }

    void anEvenClockMayBeARoundedOne()
    {
        QFETCH(const double, spacing);
        QFETCH(const bool, isRounded);
        QFETCH(const Verdict, verdict);
        const Mechanism mechanism;
        SolverSettings settings;
        settings.method = Method::ClosedForm;
        std::vector<double> meant;
        std::vector<double> printed;
        for (int i = 0; i < 61; ++i) {
            meant.push_back(spacing * i);
            printed.push_back(std::round(133.0 * i) / 1e4);
        }
        const Channel speed{R4x, Order::Velocity};
        ReferenceData data;
        data.time = printed;
        data.timeRounding = {Rounding::Rule::Decimals, 4, 1.0, -2, -4};
        data.series.push_back({speed,
                               sample(mechanism, meant, plottedChannels(), settings)[speed],
                               {Rounding::Rule::SignificantDigits, 6}});
        const ChannelComparison exactly = compareExactly(mechanism, data).channels.front();
        QCOMPARE(exactly.verdict, verdict);
        QCOMPARE(exactly.clockIsRounded, isRounded);
        // And of a model that somebody else solved.
        settings.method = Method::Newton;
        const Trajectory solved = sample(mechanism, printed, plottedChannels(), settings);
        const ChannelComparison byNewton = compare(mechanism, solved, data).front();
        QCOMPARE(byNewton.verdict, verdict);
        QCOMPARE(byNewton.clockIsRounded, isRounded);
    }

    void takesTheStepOfEachValue()
    {
        // Six significant digits: an error of 0.004 is within half a step at 1139.91 and 80 halves out at 12.3456.
        const Rounding six{Rounding::Rule::SignificantDigits, 6};
        const std::vector<double> values{12.3456, 1139.91};
        QCOMPARE(compareChannel(instants(2), std::vector{12.3456, 1139.914}, seriesOf(values, six), kSize).verdict,
                 Verdict::Agrees);
        QCOMPARE(compareChannel(instants(2), std::vector{12.3496, 1139.91}, seriesOf(values, six), kSize).verdict,
                 Verdict::Close);
    }

    void differsWhereTheModelIsMissing()
    {
        const ChannelComparison result =
            compareChannel(std::vector{0.0, 1.0, 2.0}, std::vector{1.0, kNaN, kNaN}, seriesOf({1.0, 1.0, kNaN}), kSize);
        QCOMPARE(result.count, std::size_t(1));
        QCOMPARE(result.missingModel, std::size_t(1));
        QCOMPARE(result.maxAbs.value(), 0.0);
        QCOMPARE(result.verdict, Verdict::Differs);
    }

    void saysNothingWhereThereIsNothing()
    {
        const ChannelComparison result =
            compareChannel(instants(2), std::vector{1.0, 2.0}, seriesOf({kNaN, kNaN}), kSize);
        QCOMPARE(result.count, std::size_t(0));
        QVERIFY(!result.maxAbs && !result.rms && !result.maxPercent && !result.percentOfPeak && !result.roundingStep);
        QCOMPARE(result.verdict, Verdict::Differs);
    }

    void judgesAChannelOfZerosByItsNaturalScale_data()
    {
        QTest::addColumn<double>("noise");
        QTest::addColumn<Verdict>("verdict");
        QTest::newRow("none") << 0.0 << Verdict::Agrees;
        QTest::newRow("rounding errors") << 1e-14 << Verdict::Agrees;
        QTest::newRow("more than rounding errors") << 1e-8 << Verdict::Differs;
    }

    void judgesAChannelOfZerosByItsNaturalScale()
    {
        QFETCH(const double, noise);
        const ChannelComparison result = compareChannel(instants(kRows), std::vector<double>(kRows, noise),
                                                        seriesOf(std::vector<double>(kRows, 0.0), Rounding()), {100.0});
        QTEST(result.verdict, "verdict");
        QCOMPARE(result.zeroReference, kRows);
        QVERIFY(!result.maxPercent && !result.percentOfPeak && !result.roundingStep);
        QCOMPARE(result.maxAbs.value(), noise);
    }

    void takesTheNaturalScaleFromTheMechanism()
    {
        // The ground does not move; a solver may leave a rounding error of the lengths (about 1e-16 of 110 mm) all the
        // same.
        const Channel ground{R1x, Order::Position};
        const std::vector<double> time = instants(kRows);
        Trajectory model;
        model.time = time;
        model.values[indexOf(ground)] = std::vector<double>(kRows, 1e-14);
        ReferenceData data;
        data.time = time;
        data.series.push_back({ground, std::vector<double>(kRows, 0.0), Rounding()});
        const std::vector<ChannelComparison> comparisons = compare(Mechanism(), model, data);
        QCOMPARE(comparisons.size(), std::size_t(1));
        QCOMPARE(comparisons[0].channel, ground);
        QCOMPARE(comparisons[0].verdict, Verdict::Agrees);
    }

    void promisesNoMoreDigitsThanArithmeticHas()
    {
        const Rounding seventeen{Rounding::Rule::SignificantDigits, 17};
        const std::vector<double> values{75.0, 30.0, 1e-9};
        const std::vector<double> model{75.0 + 1e-13, 30.0 - 1e-13, 1e-9 + 1e-14};
        QCOMPARE(compareChannel(instants(3), model, seriesOf(values, seventeen), kSize).verdict, Verdict::Agrees);
    }

    void survivesExtremeNumbers()
    {
        const ChannelComparison result =
            compareChannel(std::vector{0.0, 1.0}, std::vector{1e10, -1e-200}, seriesOf({1e-300, 1e300}), kSize);
        QCOMPARE(result.zeroReference, std::size_t(1)); // a percentage that no double holds
        QCOMPARE(result.maxPercent.value(), 100.0);
        QVERIFY(std::isfinite(result.rms.value()));
        QCOMPARE(result.maxAbs.value(), 1e300);
    }

    void theExactMotionBlockByBlockIsThatAsAWhole()
    {
        constexpr std::size_t kMany = 100001; // several blocks, the last one not full; several threads
        ReferenceData data;
        std::mt19937 random(20240919); // fixed: a failure can be repeated
        for (std::size_t i = 0; i < kMany; ++i) {
            data.time.push_back(1e-5 * static_cast<double>(i));
        }
        Parameters parameters;
        parameters.b = 44.0; // cannot be assembled everywhere
        const Mechanism mechanism(parameters);
        SolverSettings exact;
        exact.method = Method::ClosedForm;
        const Channel channels[] = {kTheta3, {R4x, Order::Velocity}, {Theta2, Order::Position}};
        ChannelSet asked;
        for (const Channel channel : channels) {
            asked.set(indexOf(channel));
        }
        const Trajectory model = sample(mechanism, data.time, asked, exact);
        for (const Channel channel : channels) {
            ReferenceSeries series{channel, {}, {Rounding::Rule::SignificantDigits, 5}};
            for (std::size_t i = 0; i < kMany; ++i) {
                const double off = 1e-3 * (static_cast<double>(random()) / 4294967296.0 - 0.5);
                series.values.push_back(random() % 100 == 0   ? kNaN
                                        : random() % 100 == 0 ? 0.0
                                                              : model[channel][i] + off);
            }
            data.series.push_back(series);
        }
        const ExactComparison blockwise = compareExactly(mechanism, data);
        QVERIFY(blockwise.status == model.status);
        const std::vector<ChannelComparison> whole = compare(mechanism, model, data);
        for (std::size_t k = 0; k < whole.size(); ++k) {
            const ChannelComparison &x = blockwise.channels[k];
            const ChannelComparison &y = whole[k];
            QVERIFY(y.count > kMany / 2 && y.zeroReference > 0);
            QVERIFY(x.channel == y.channel && x.count == y.count && x.missingModel == y.missingModel);
            QVERIFY(x.maxAbs == y.maxAbs && x.timeOfMaxAbs == y.timeOfMaxAbs && x.rms == y.rms);
            QVERIFY(x.maxPercent == y.maxPercent && x.timeOfMaxPercent == y.timeOfMaxPercent);
            QVERIFY(x.zeroReference == y.zeroReference && x.withinBound == y.withinBound);
            QVERIFY(x.worstOver == y.worstOver && x.verdict == y.verdict && x.roundingStep == y.roundingStep);

            long double squares = 0.0L;
            long double percent = 0.0L;
            for (std::size_t i = 0; i < kMany; ++i) {
                const long double value = data.series[k].values[i];
                const long double error = model[data.series[k].channel][i] - value;
                squares += std::isfinite(error) ? error * error : 0.0L;
                percent = std::isfinite(error) && value != 0.0L ? std::max(percent, std::abs(error / value) * 100.0L)
                                                                : percent;
            }
            const double rms = static_cast<double>(std::sqrt(squares / static_cast<long double>(y.count)));
            QVERIFY(std::abs(*y.rms - rms) <= 1e-12 * rms);
            QVERIFY(std::abs(*y.maxPercent - static_cast<double>(percent)) <= 1e-12 * *y.maxPercent);
        }
    }

    void confirmsTheReportWithTheLengthOfItsData_data()
    {
        QTest::addColumn<Method>("method");
        QTest::newRow("Newton-Raphson") << Method::Newton;
        QTest::newRow("closed form") << Method::ClosedForm;
    }

    void confirmsTheReportWithTheLengthOfItsData()
    {
        QFETCH(const Method, method);
        const QByteArray bytes = bytesOf(kAuthorsFile);
        if (bytes.isEmpty()) {
            QSKIP("the author's InventorData.csv is not at hand");
        }
        struct Expected {
            Channel channel;
            double maxAbs;
            double maxPercent;
            std::size_t zeroReference;
        };
        const Expected table[] = {
            {{R4x, Order::Position}, 4.98e-5, 1.54e-4, 0},     {{R4x, Order::Velocity}, 4.93e-4, 4.45e-4, 0},
            {{R4x, Order::Acceleration}, 4.55e-3, 3.96e-4, 0}, {{Theta3, Order::Position}, 4.92e-4, 8.03e-3, 0},
            {{Theta3, Order::Velocity}, 5.05e-4, 1.322e-2, 2}, {{Theta3, Order::Acceleration}, 4.00e-3, 3.56e-4, 0}};
        const std::vector<ChannelComparison> comparisons = compareFile(bytes, 60.0, method);
        QCOMPARE(comparisons.size(), std::size(table));
        for (std::size_t i = 0; i < comparisons.size(); ++i) {
            const ChannelComparison &found = comparisons[i];
            const std::string name(nameOf(table[i].channel));
            QVERIFY2(found.channel == table[i].channel, name.c_str());
            QVERIFY2(isNear(found.maxAbs.value(), table[i].maxAbs), name.c_str());
            QVERIFY2(isNear(found.maxPercent.value(), table[i].maxPercent), name.c_str());
            QVERIFY2(found.zeroReference == table[i].zeroReference, name.c_str());
            QVERIFY2(found.verdict == Verdict::Agrees, name.c_str());
        }
    }

    void refutesTable1()
    {
        const QByteArray bytes = bytesOf(kAuthorsFile);
        if (bytes.isEmpty()) {
            QSKIP("the author's InventorData.csv is not at hand");
        }
        const std::vector<ChannelComparison> comparisons = compareFile(bytes, 65.0, Method::ClosedForm);
        QCOMPARE(comparisons.size(), std::size_t(6));
        for (const ChannelComparison &found : comparisons) {
            QVERIFY2(found.verdict == Verdict::Differs, nameOf(found.channel).data());
        }
        QVERIFY(isNear(comparisons[0].maxPercent.value(), 20.9));
        QVERIFY(isNear(comparisons[0].maxAbs.value(), 7.22));
        QVERIFY(isNear(comparisons[3].maxPercent.value(), 9.83));
    }

    void infersTheAuthorsRounding()
    {
        const QByteArray bytes = bytesOf(kAuthorsFile);
        if (bytes.isEmpty()) {
            QSKIP("the author's InventorData.csv is not at hand");
        }
        const auto outcome = readReferenceData({bytes.constData(), static_cast<std::size_t>(bytes.size())});
        const ReferenceData &data = std::get<ReferenceData>(outcome);
        struct Expected {
            Channel channel;
            Rounding::Rule rule;
            int digits;
        };
        for (const Expected &expected :
             {Expected{{R4x, Order::Position}, Rounding::Rule::SignificantDigits, 6},
              Expected{{R4x, Order::Velocity}, Rounding::Rule::SignificantDigits, 6},
              Expected{{R4x, Order::Acceleration}, Rounding::Rule::SignificantDigits, 6},
              Expected{{Theta3, Order::Position}, Rounding::Rule::Decimals, 3},
              Expected{{Theta3, Order::Velocity}, Rounding::Rule::Decimals, 3},
              Expected{{Theta3, Order::Acceleration}, Rounding::Rule::SignificantDigits, 6}}) {
            const ReferenceSeries *series = data.find(expected.channel);
            QVERIFY2(series, nameOf(expected.channel).data());
            QVERIFY2(series->rounding.rule == expected.rule && series->rounding.digits == expected.digits,
                     nameOf(expected.channel).data());
        }
    }

    void agreesWithTheSample()
    {
        const QByteArray bytes = bytesOf(kSample);
        QVERIFY(!bytes.isEmpty());
        const std::vector<ChannelComparison> comparisons = compareFile(bytes, 60.0, Method::ClosedForm);
        QCOMPARE(comparisons.size(), std::size_t(6));
        for (const ChannelComparison &found : comparisons) {
            QVERIFY2(found.verdict == Verdict::Agrees, nameOf(found.channel).data());
            QVERIFY2(found.count == 201, nameOf(found.channel).data());
        }
    }

    void tellsHowFarTwoMotionsAreApart_data()
    {
        QTest::addColumn<double>("b");
        QTest::addColumn<double>("omega2"); // as a part of the other's
        QTest::addColumn<double>("from");
        QTest::addColumn<double>("to");
        QTest::newRow("another coupler, one turn") << 75.0 << 1.0 << 0.0 << 1.0;
        QTest::newRow("from the end") << 75.0 << 1.0 << 1.0 << 0.0;
        QTest::newRow("a part of a turn, largest at its end") << 75.0 << 1.0 << 0.1 << 0.35;
        QTest::newRow("another speed") << 65.0 << 1.3 << -0.4 << 2.1;
        QTest::newRow("many turns alike") << 66.0 << 1.0 << 0.0 << 1000.0;
    }

    void tellsHowFarTwoMotionsAreApart()
    {
        QFETCH(const double, b);
        QFETCH(const double, omega2);
        QFETCH(const double, from);
        QFETCH(const double, to);
        Parameters one;
        one.b = b;
        one.omega2 *= omega2;
        const MotionDifference found = differenceOf(Mechanism(one), Mechanism(Parameters()), from, to);
        QVERIFY(!found.hasGaps);
        // By the other method, at instants of its own; of a thousand turns the last.
        const bool isLong = to - from > 10.0;
        const Sampling run{isLong ? to - 1.0 : from, isLong ? 1.0 : to - from, 3000};
        const SolverSettings newton{Method::Newton, {20, 1e-12, {}, {}, Elimination::Structured}};
        const Trajectory first = sample(Mechanism(one), run.instants(), plottedChannels(), newton, {});
        const Trajectory second = sample(Mechanism(Parameters()), run.instants(), plottedChannels(), newton, {});
        for (const ChannelDifference &channel : found.channels) {
            double largest = 0.0;
            double squares = 0.0;
            double peak = 0.0;
            for (std::size_t i = 0; i < first.time.size(); ++i) {
                const double error = std::abs(first[channel.channel][i] - second[channel.channel][i]);
                largest = std::max(largest, error);
                squares += error * error;
                peak = std::max(peak, std::abs(second[channel.channel][i]));
            }
            const double rms = std::sqrt(squares / static_cast<double>(first.time.size()));
            const auto isNearly = [&](double value, double wanted) { return std::abs(value - wanted) < 3e-3 * wanted; };
            QVERIFY2(isNearly(channel.maxAbs.value(), largest) && *channel.maxAbs > (1.0 - 1e-9) * largest,
                     nameOf(channel.channel).data());
            QVERIFY2(isNearly(channel.rms.value(), rms), nameOf(channel.channel).data());
            QVERIFY2(isNearly(channel.percentOfPeak.value(), 100.0 * largest / peak), nameOf(channel.channel).data());
            const double t = channel.timeOfMaxAbs;
            const Trajectory there = sample(Mechanism(one), {t}, plottedChannels(), newton, {});
            const Trajectory otherThere = sample(Mechanism(Parameters()), {t}, plottedChannels(), newton, {});
            QVERIFY2(isNearly(std::abs(there[channel.channel][0] - otherThere[channel.channel][0]), *channel.maxAbs),
                     nameOf(channel.channel).data());
        }
    }

    void theSameMotionIsNowhereApart()
    {
        const MotionDifference found = differenceOf(Mechanism(Parameters()), Mechanism(Parameters()), 0.0, 1.0);
        for (const ChannelDifference &channel : found.channels) {
            QCOMPARE(channel.maxAbs.value(), 0.0);
            QCOMPARE(channel.rms.value(), 0.0);
        }
    }

    void whereOneGrowsBeyondAllBoundsThereIsNoLargestDifference()
    {
        Parameters rocker;
        rocker.b = 40.0; // a + |c| = 45
        const MotionDifference found = differenceOf(Mechanism(rocker), Mechanism(Parameters()), 0.0, 1.0);
        QVERIFY(found.hasGaps);
        QVERIFY(std::isfinite(found.channels[0].maxAbs.value()) && found.channels[0].rms.has_value());
        QVERIFY(std::isinf(found.channels[2].maxAbs.value()) && !found.channels[2].rms.has_value());
        QVERIFY(!found.channels[2].percentOfPeak.has_value());
        const double limit = std::asin((25.0 - 40.0) / 20.0); // where c − a sin θ² = b
        QVERIFY(std::abs(found.channels[2].timeOfMaxAbs * Parameters().omega2 - (std::numbers::pi - limit)) < 1e-6);
        const MotionDifference within = differenceOf(Mechanism(rocker), Mechanism(Parameters()), 0.1, 0.4);
        QVERIFY(!within.hasGaps && std::isfinite(within.channels[5].maxAbs.value()));
    }
};

QTEST_APPLESS_MAIN(TestComparison)
#include "tst_comparison.moc"
