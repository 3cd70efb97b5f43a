// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mechanism/two_part_angle.h"
#include "core/study/exact_motion.h"
#include "tests/support/random_mechanisms.h"
#include "tests/support/suite.h"

#include <QTest>

using namespace slidercrank;

namespace tst_two_part_angle
{

/// Returns a random number of either sign with an exponent from -span to span.
double anyDouble(RandomMechanisms &random, double span)
{
    return std::ldexp(random.uniform(-1.0, 1.0), static_cast<int>(random.uniform(-span, span)));
}

/// Returns whether |lo| is at most half a unit in the last place of hi.
bool isNormalized(TwoPart value)
{
    return value.hi + value.lo == value.hi;
}

class TestTwoPartAngle : public QObject
{
    Q_OBJECT

private slots:
    /// The error is at most 1e-31 (103 bits) of the size of the terms, even if ω2 t and θ20 cancel.
    void crankAngleHasTwiceTheDigits()
    {
        constexpr double kRelative = 1e-31;
        RandomMechanisms random(3);
        for (int i = 0; i < 5000; ++i) {
            const double omega2 = anyDouble(random, 30.0);
            const double t = anyDouble(random, 30.0);
            const double theta20 =
                i % 3 == 0 ? -omega2 * t * random.uniform(1.0, 1.0 + 1e-12) : anyDouble(random, 30.0);
            const TwoPart angle = crankAngle(omega2, t, theta20);
            const ManyDigits exact = ManyDigits(omega2) * ManyDigits(t) + ManyDigits(theta20);
            const double error = static_cast<double>(abs(ManyDigits(angle.hi) + ManyDigits(angle.lo) - exact));
            const double tolerance = kRelative * (std::abs(omega2 * t) + std::abs(theta20));
            QVERIFY2(error <= tolerance && isNormalized(angle), std::to_string(i).c_str());
        }
    }

    /// The error is at most 2u at angles of any size. Without the second part it would be the rounding error
    /// of the angle: 1e-7 rad at 1e9 rad.
    void sineAndCosineKeepTheSecondPart()
    {
        RandomMechanisms random(4);
        double worst = 0.0;
        for (int i = 0; i < 3000; ++i) {
            const double size = std::pow(10.0, random.uniform(-2.0, 14.0));
            const double omega2 = random.uniform(-10.0, 10.0);
            const double t = size * random.uniform(0.5, 1.0);
            const double theta20 = random.uniform(-10.0, 10.0);
            const TwoPart parts = crankAngle(omega2, t, theta20);
            const SinCos got = sinCos(parts);
            const double tolerance = 2.0 * kUnitRoundoff;
            const ManyDigits angle = ManyDigits(omega2) * ManyDigits(t) + ManyDigits(theta20);
            const double sinError = static_cast<double>(abs(ManyDigits(got.sin) - sin(angle)));
            const double cosError = static_cast<double>(abs(ManyDigits(got.cos) - cos(angle)));
            worst = std::max({worst, sinError / tolerance, cosError / tolerance});
            QVERIFY2(sinError <= tolerance && cosError <= tolerance, std::to_string(i).c_str());
        }
        qInfo("worst: %.3g of the tolerance", worst);
    }

    /// Close to every multiple of 90° the result has about 30 significant digits, except for the effect of the angle's
    /// own rounding.
    void fineSineHasTwiceTheDigits()
    {
        constexpr double kRelative = 1e-30;
        constexpr double kLastDigits = 1e-31;
        RandomMechanisms random(5);
        double worst = 0.0;
        for (int i = 0; i < 4000; ++i) {
            const double size = std::pow(10.0, random.uniform(-3.0, std::log10(kLargestFineAngle)));
            double hi = random.uniform(-size, size);
            if (i % 2 == 0) {
                hi = 0.5 * std::numbers::pi * std::round(hi) + std::pow(10.0, random.uniform(-20.0, -1.0));
                hi = std::clamp(hi, -kLargestFineAngle, kLargestFineAngle);
            }
            const TwoPart angle = twoSum(hi, hi * random.uniform(-1e-16, 1e-16));
            const FineSine got = fineSine(angle);
            const ManyDigits exact = sin(ManyDigits(angle.hi) + ManyDigits(angle.lo)) - ManyDigits(got.whole);
            const double partSize = static_cast<double>(abs(exact));
            const double error = static_cast<double>(abs(ManyDigits(got.part.hi) + ManyDigits(got.part.lo) - exact));
            const double slope = got.whole == 0.0 ? 1.0 : std::sqrt(2.0 * partSize);
            const double spacing = std::nextafter(std::abs(hi), 1e300) - std::abs(hi);
            const double tolerance = kRelative * partSize + kLastDigits * slope * spacing;
            worst = std::max(worst, error / tolerance);
            QVERIFY2(partSize < 0.71 && error <= tolerance && isNormalized(got.part), std::to_string(i).c_str());
        }
        qInfo("worst: %.3g of the tolerance", worst);
    }
};

const Suite<TestTwoPartAngle> suite("tst_two_part_angle");

} // namespace tst_two_part_angle

#include "tst_two_part_angle.moc"
