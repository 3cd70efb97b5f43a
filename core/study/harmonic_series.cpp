// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/harmonic_series.h"

#include "core/closed_form/closed_form.h"
#include "core/limits/mobility.h"
#include "core/mechanism/two_part_angle.h"

#include <cassert>
#include <cmath>
#include <numbers>

namespace slidercrank
{

namespace
{

/// The number of equally spaced crank angles. They cannot distinguish the harmonics n and kAngles - n, of which the
/// latter are negligible in a motion without a toggle.
constexpr std::size_t kAngles = 2048;

/// Returns the mean of values. The compensated sum keeps the digits that the second derivative needs, whose
/// coefficients are multiplied by n².
template <class Values>
double meanOver(std::size_t count, const Values &value)
{
    TwoPart sum;
    for (std::size_t i = 0; i < count; ++i) {
        const TwoPart next = twoSum(sum.hi, value(i));
        sum = {next.hi, sum.lo + next.lo};
    }
    return (sum.hi + sum.lo) / static_cast<double>(count);
}

/// Returns the i-th of kAngles equally spaced angles in two parts. The rounding error of a double 2π, 2.4e-16, would
/// shift all waves in the same direction, and the n² of the second derivative would amplify it to 1e-12 at 32
/// harmonics.
TwoPart equalAngle(std::size_t i)
{
    constexpr double kTurnLo = 2.4492935982947064e-16; // 2π is the sum of the double and this
    const double part = static_cast<double>(i) / kAngles;
    const TwoPart angle = twoProduct(2.0 * std::numbers::pi, part);
    return twoSum(angle.hi, angle.lo + kTurnLo * part);
}

} // namespace

bool HarmonicSeries::existsFor(const Mechanism &mechanism)
{
    return mechanism.b() >= shortestCouplerForFullTurn(mechanism);
}

// The trapezoidal rule, which converges fastest for periodic functions: Aₙ = 2/M Σ f(θ) cos nθ, A₀ half of that.
HarmonicSeries::HarmonicSeries(const Mechanism &mechanism, int harmonics)
    : m_omega2(mechanism.omega2())
    , m_theta20(mechanism.theta20())
    , m_terms(static_cast<std::size_t>(harmonics) + 1)
{
    assert(existsFor(mechanism) && harmonics >= 1 && 2 * m_terms.size() < kAngles);
    // With ω2 = 1 the time is θ2.
    const ClosedForm closedForm{Mechanism({mechanism.a(), mechanism.b(), mechanism.c(), 1.0, 0.0, mechanism.branch()})};
    std::vector<SinCos> waves;
    std::vector<Motion> motions;
    for (std::size_t i = 0; i < kAngles; ++i) {
        const TwoPart theta2 = equalAngle(i);
        waves.push_back(sinCos(theta2));
        motions.push_back(closedForm.motionAt(theta2.hi));
    }
    for (std::size_t n = 0; n < m_terms.size(); ++n) {
        const auto mean = [&](double Motion::*channel, double SinCos::*wave) {
            return meanOver(kAngles, [&](std::size_t i) { return motions[i].*channel * waves[n * i % kAngles].*wave; });
        };
        const double factor = n == 0 ? 1.0 : 2.0;
        m_terms[n].theta3 = {factor * mean(&Motion::theta3, &SinCos::cos),
                             factor * mean(&Motion::theta3, &SinCos::sin)};
        m_terms[n].R4x = {factor * mean(&Motion::R4x, &SinCos::cos), factor * mean(&Motion::R4x, &SinCos::sin)};
    }
}

HarmonicSeries::Sums HarmonicSeries::at(double t) const
{
    const SinCos once = sinCos(crankAngle(m_omega2, t, m_theta20));
    SinCos nth{0.0, 1.0};
    Sums sums;
    double n = 0.0;
    for (const Term &term : m_terms) {
        const auto add = [&nth, n](const Harmonic &harmonic, Sum &sum) {
            const double value = harmonic.cosine * nth.cos + harmonic.sine * nth.sin;
            sum.value += value;
            sum.first += n * (harmonic.sine * nth.cos - harmonic.cosine * nth.sin);
            sum.second -= n * n * value;
        };
        add(term.theta3, sums.theta3);
        add(term.R4x, sums.R4x);
        nth = {nth.sin * once.cos + nth.cos * once.sin, nth.cos * once.cos - nth.sin * once.sin};
        n += 1.0;
    }
    for (Sum *sum : {&sums.theta3, &sums.R4x}) {
        sum->first *= m_omega2;
        sum->second *= m_omega2 * m_omega2;
    }
    return sums;
}

} // namespace slidercrank
