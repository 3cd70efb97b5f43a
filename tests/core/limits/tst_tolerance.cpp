// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/limits/tolerance.h"
#include "tests/support/deviation.h"
#include "tests/support/random_mechanisms.h"
#include "tests/support/suite.h"

#include <QTest>

using namespace slidercrank;

namespace tst_tolerance
{

/// Returns the stroke, the time ratio, the minimum transmission angle and the swing of the coupler by the formulas of
/// the textbook in extended precision; the crank makes full turns.
std::array<long double, 4> textbookLimits(long double a, long double b, long double c)
{
    const long double outer = std::sqrt((a + b) * (a + b) - c * c);
    const long double inner = std::sqrt((b - a) * (b - a) - c * c);
    const long double alpha = std::asin(std::abs(c) / (b - a)) - std::asin(std::abs(c) / (b + a));
    constexpr long double kHalfTurn = std::numbers::pi_v<long double>;
    return {outer - inner, (kHalfTurn + alpha) / (kHalfTurn - alpha), std::acos((a + std::abs(c)) / b),
            std::asin((c + a) / b) - std::asin((c - a) / b)};
}

constexpr std::array kJudgedKinds{LimitKind::Stroke, LimitKind::TimeRatio, LimitKind::MinimumTransmissionAngle,
                                  LimitKind::CouplerSwing};

class TestTolerance : public QObject
{
    Q_OBJECT

private slots:
    /// The expected range is that over points of the box of tolerances: the ends and the middle of a and b with 33
    /// values of c.
    void rangesEqualThoseOverTheBox()
    {
        RandomMechanisms random(463);
        for (int i = 0; i < 1000; ++i) {
            Parameters p = random.next();
            p.c = i % 4 == 0 ? 0.01 * p.a * random.uniform(-1.0, 1.0) : p.c; // c = 0 may be within its tolerance
            const LengthTolerances tolerances{i % 5 == 1 ? 0.0 : p.a * random.uniform(0.0, 0.005),
                                              i % 5 == 2 ? 0.0 : p.b * random.uniform(0.0, 0.005),
                                              i % 5 == 3 ? 0.0 : p.a * random.uniform(0.0, 0.02)};
            const LimitRanges ranges = limitRanges(Mechanism(p), tolerances);
            std::array<long double, kJudgedKinds.size()> least;
            std::array<long double, kJudgedKinds.size()> greatest;
            least.fill(std::numeric_limits<long double>::infinity());
            greatest.fill(-std::numeric_limits<long double>::infinity());
            constexpr int kSteps = 16;
            const auto include = [&](long double a, long double b, long double c) {
                const auto limits = textbookLimits(a, b, c);
                for (std::size_t k = 0; k < kJudgedKinds.size(); ++k) {
                    least[k] = std::min(least[k], limits[k]);
                    greatest[k] = std::max(greatest[k], limits[k]);
                }
            };
            for (int u = -kSteps; u <= kSteps; u += kSteps) {
                for (int v = -kSteps; v <= kSteps; v += kSteps) {
                    for (int w = -kSteps; w <= kSteps; ++w) {
                        include(p.a + tolerances.a * u / kSteps, p.b + tolerances.b * v / kSteps,
                                p.c + tolerances.c * w / kSteps);
                    }
                    if (std::abs(p.c) <= tolerances.c) {
                        include(p.a + tolerances.a * u / kSteps, p.b + tolerances.b * v / kSteps, 0.0);
                    }
                }
            }
            for (std::size_t k = 0; k < kJudgedKinds.size(); ++k) {
                const auto &range = ranges[static_cast<std::size_t>(kJudgedKinds[k])];
                QVERIFY2(range.has_value(), describe(p).c_str());
                const auto width = static_cast<double>(greatest[k] - least[k]);
                const double slack =
                    1e-3 * width + 1e-12 * static_cast<double>(std::abs(greatest[k])); // the points may miss an extreme
                QVERIFY2(std::abs(range->least - static_cast<double>(least[k])) <= slack &&
                             std::abs(range->greatest - static_cast<double>(greatest[k])) <= slack,
                         (std::string(describe(kJudgedKinds[k]).key) + " of " + describe(p)).c_str());
            }
        }
    }

    /// To first order the range is the sum of the changes by each length, where no limit is stationary.
    void rangesAreThoseOfFirstOrderForSmallTolerances()
    {
        RandomMechanisms random(464);
        for (int i = 0; i < 100; ++i) {
            const Parameters p = random.next();
            const LengthTolerances tolerances{1e-6 * p.a, 1e-6 * p.a, 1e-6 * p.a};
            if (std::abs(p.c) < 0.1 * p.a) {
                continue;
            }
            const LimitRanges ranges = limitRanges(Mechanism(p), tolerances);
            const auto nominal = textbookLimits(p.a, p.b, p.c);
            const long double step = 1e-6L * p.a;
            for (std::size_t k = 0; k < kJudgedKinds.size(); ++k) {
                const long double change = std::abs(textbookLimits(p.a + step, p.b, p.c)[k] - nominal[k]) +
                                           std::abs(textbookLimits(p.a, p.b + step, p.c)[k] - nominal[k]) +
                                           std::abs(textbookLimits(p.a, p.b, p.c + step)[k] - nominal[k]);
                const auto &range = ranges[static_cast<std::size_t>(kJudgedKinds[k])];
                const double up = range->greatest - static_cast<double>(nominal[k]);
                QVERIFY2(std::abs(up - static_cast<double>(change)) <=
                             1e-3 * static_cast<double>(change) + 1e-14 * static_cast<double>(nominal[k]),
                         (std::string(describe(kJudgedKinds[k]).key) + " of " + describe(p)).c_str());
            }
        }
    }

    void aLimitThatMayNotExistHasNoRange()
    {
        const LimitRanges ranges = limitRanges(Mechanism({20.0, 45.01, 25.0, 1.0}), {.b = 0.1});
        QVERIFY(!ranges[static_cast<std::size_t>(LimitKind::TimeRatio)]);
        QVERIFY(!ranges[static_cast<std::size_t>(LimitKind::PeakSliderSpeed)]); // unbounded
        QVERIFY(ranges[static_cast<std::size_t>(LimitKind::Stroke)]);
        QCOMPARE(ranges[static_cast<std::size_t>(LimitKind::MinimumTransmissionAngle)]->least, 0.0);
    }
};

const Suite<TestTolerance> suite("tst_tolerance");

} // namespace tst_tolerance

#include "tst_tolerance.moc"
