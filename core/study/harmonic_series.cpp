// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/harmonic_series.h"

#include "core/closed_form/closed_form.h"
#include "core/mechanism/turn.h"
#include "core/mechanism/two_part_angle.h"

#include <cassert>

namespace slidercrank
{

// The trapezoidal rule with M angles, which converges fastest for periodic functions: Aₙ = 2/M Σ f(θ) cos nθ, and half
// of that for n = 0.
HarmonicSeries::HarmonicSeries(const Mechanism &mechanism, int harmonics)
    : m_omega2(mechanism.omega2())
    , m_theta20(mechanism.theta20())
    , m_terms(static_cast<std::size_t>(harmonics) + 1)
{
    // M, the number of equally spaced crank angles. They cannot distinguish the harmonics n and kAngles - n, of which
    // the latter are negligible in a motion without a toggle.
    constexpr std::size_t kAngles = 2048;

    // The rounding error of a double 2π would shift all waves in the same direction, and the n² of the second
    // derivative would amplify it to 1e-12 at 32 harmonics.
    constexpr double kTurnLo = 2.4492935982947064e-16; // 2π is the sum of kTurn and this
    assert(harmonics >= 1 && 2 * m_terms.size() < kAngles);
    const ClosedForm closedForm(withDrive(mechanism, 1.0, 0.0));
    std::vector<Complex> waves; // e^-iθ
    std::vector<double> theta3;
    std::vector<double> R4x;
    for (std::size_t i = 0; i < kAngles; ++i) {
        const double turn = static_cast<double>(i) / kAngles; // fraction of a revolution
        const TwoPart theta2 = crankAngle(kTurn, turn, kTurnLo * turn);
        const Motion motion = closedForm.motionAt(theta2.hi); // ω2 = 1: the time is θ2
        const SinCos wave = sinCos(theta2);
        waves.emplace_back(wave.cos, -wave.sin);
        theta3.push_back(motion.theta3);
        R4x.push_back(motion.R4x);
    }
    const auto coefficient = [&waves](const std::vector<double> &positions, std::size_t n) {
        Complex sum;
        Complex lost; // what `sum` loses by rounding: the n² of the second derivative would amplify it
        for (std::size_t i = 0; i < kAngles; ++i) {
            const Complex next = positions[i] * waves[n * i % kAngles];
            const TwoPart real = twoSum(sum.real(), next.real());
            const TwoPart imaginary = twoSum(sum.imag(), next.imag());
            sum = {real.hi, imaginary.hi};
            lost += Complex(real.lo, imaginary.lo);
        }
        return (n == 0 ? 1.0 : 2.0) / kAngles * (sum + lost);
    };
    for (std::size_t n = 0; n < m_terms.size(); ++n) {
        m_terms[n] = {coefficient(theta3, n), coefficient(R4x, n)};
    }
}

HarmonicSeries::Approximation HarmonicSeries::at(double t) const
{
    const SinCos crank = sinCos(crankAngle(m_omega2, t, m_theta20));
    const Complex once(crank.cos, crank.sin);
    Complex nth = 1.0;
    Approximation motion;
    for (std::size_t n = 0; n < m_terms.size(); ++n) {
        const double speed = static_cast<double>(n) * m_omega2;
        const auto add = [speed](Sums &sums, const Complex &value) {
            sums.position += value.real();
            sums.velocity -= speed * value.imag();
            sums.acceleration -= speed * speed * value.real();
        };
        add(motion.theta3, m_terms[n].theta3 * nth);
        add(motion.R4x, m_terms[n].R4x * nth);
        nth *= once;
    }
    return motion;
}

} // namespace slidercrank
