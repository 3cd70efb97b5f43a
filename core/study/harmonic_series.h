// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Approximates the motion by a few harmonics of the crank angle, as textbooks do for the acceleration of a piston:
//
//     R4x(θ2) ≈ A₀ + Σ (Aₙ cos nθ2 + Bₙ sin nθ2),   n = 1 … N,   and the same for θ3
//
// differentiated term by term, with θ2 = ω2 t + θ20. The truncation error decreases with N: fast if the
// coupler is long, hardly at all near a toggle.
//
// Textbooks (Norton, "Design of Machinery", section 13.2, "Slider-crank kinematics") expand the root by the binomial
// theorem for c = 0 and keep two harmonics. The coefficients here are the limit of that expansion: the Fourier
// coefficients of the exact motion for any offset, computed from its values at equally spaced angles. The crank has to
// make full turns.

#include "core/mechanism/mechanism.h"

#include <complex>
#include <vector>

namespace slidercrank
{

class HarmonicSeries
{
public:
    /// Preconditions: the crank makes full turns, harmonics >= 1.
    HarmonicSeries(const Mechanism &mechanism, int harmonics);

    /// A position with its time derivatives (mm or rad, s).
    struct Sums {
        double position = 0.0;
        double velocity = 0.0;
        double acceleration = 0.0;
    };

    struct Approximation {
        Sums theta3;
        Sums R4x;
    };

    /// Returns the sums of the series at time t (s).
    Approximation at(double t) const;

private:
    using Complex = std::complex<double>;

    /// Aₙ - i Bₙ of both series.
    struct Term {
        Complex theta3;
        Complex R4x;
    };

    double m_omega2;
    double m_theta20;
    std::vector<Term> m_terms; ///< indexed by the number of the harmonic, from 0
};

} // namespace slidercrank
