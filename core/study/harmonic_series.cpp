// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/harmonic_series.h"

#include "core/closed_form/closed_form.h"
#include "core/mechanism/turn.h"
#include "core/mechanism/two_part_angle.h"

#include <cassert>

namespace slidercrank
{

// The trapezoidal rule, which converges fastest for periodic functions: Aₙ = 2/M Σ f(θ) cos nθ, A₀ half of that.
HarmonicSeries::HarmonicSeries(const Mechanism &mechanism, int harmonics)
    : m_omega2(mechanism.omega2())
    , m_theta20(mechanism.theta20())
    , m_terms(static_cast<std::size_t>(harmonics) + 1)
{
    // The number of equally spaced crank angles. They cannot distinguish the harmonics n and kAngles - n, of which the
    // latter are negligible in a motion without a toggle.
    constexpr std::size_t kAngles = 2048;

    // The rounding error of a double 2π would shift all waves in the same direction, and the n² of the second
    // derivative would amplify it to 1e-12 at 32 harmonics.
    constexpr double kTurnLo = 2.4492935982947064e-16; // 2π is the sum of kTurn and this
    assert(harmonics >= 1 && 2 * m_terms.size() < kAngles);
    const ClosedForm closedForm(withDrive(mechanism, 1.0, 0.0));
    std::vector<SinCos> waves;
    std::vector<std::array<double, 2>> positions;
    for (std::size_t i = 0; i < kAngles; ++i) {
        const double part = static_cast<double>(i) / kAngles;
        const TwoPart theta2 = crankAngle(kTurn, part, kTurnLo * part);
        const Motion motion = closedForm.motionAt(theta2.hi); // ω2 = 1: the time is θ2
        waves.push_back(sinCos(theta2));
        positions.push_back({motion.theta3, motion.R4x});
    }
    for (std::size_t n = 0; n < m_terms.size(); ++n) {
        const auto coefficient = [&](std::size_t channel, double SinCos::*wave) {
            TwoPart sum; // keeps the digits that the second derivative needs
            for (std::size_t i = 0; i < kAngles; ++i) {
                const TwoPart next = twoSum(sum.hi, positions[i][channel] * waves[n * i % kAngles].*wave);
                sum = {next.hi, sum.lo + next.lo};
            }
            return (n == 0 ? 1.0 : 2.0) * (sum.hi + sum.lo) / kAngles;
        };
        for (const std::size_t channel : {0U, 1U}) {
            m_terms[n][channel] = {coefficient(channel, &SinCos::cos), coefficient(channel, &SinCos::sin)};
        }
    }
}

std::array<HarmonicSeries::Sums, 2> HarmonicSeries::at(double t) const
{
    const SinCos once = sinCos(crankAngle(m_omega2, t, m_theta20));
    SinCos nth{0.0, 1.0};
    std::array<Sums, 2> sums{};
    for (std::size_t n = 0; n < m_terms.size(); ++n) {
        const double speed = static_cast<double>(n) * m_omega2;
        for (std::size_t channel = 0; channel < sums.size(); ++channel) {
            const auto [cosine, sine] = m_terms[n][channel];
            const double value = cosine * nth.cos + sine * nth.sin;
            sums[channel][0] += value;
            sums[channel][1] += speed * (sine * nth.cos - cosine * nth.sin);
            sums[channel][2] -= speed * speed * value;
        }
        nth = {nth.sin * once.cos + nth.cos * once.sin, nth.cos * once.cos - nth.sin * once.sin};
    }
    return sums;
}

} // namespace slidercrank
