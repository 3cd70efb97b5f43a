// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The motion as a few harmonics of the crank angle, as textbooks give the piston's acceleration:
//
//     R4x(θ2) ≈ A₀ + Σ (Aₙ cos nθ2 + Bₙ sin nθ2),   n = 1 … N,   and the same for θ3
//
// differentiated term by term, with θ2 = ω2 t + θ20. It is an approximation whatever the arithmetic: what is left out
// after N harmonics falls with N, fast where the coupler is long, hardly at all near a toggle.
//
// Textbooks (Norton, "Design of Machinery", section 13.2, "Slider-crank kinematics") expand the root by the binomial
// theorem for c = 0 and keep two harmonics. The coefficients here are those that this tends to: the Fourier
// coefficients of the exact motion, from its values at equally spaced angles, for any offset. The crank has to turn
// round.

#include "core/mechanism/mechanism.h"

#include <vector>

namespace slidercrank
{

class HarmonicSeries
{
public:
    /// Whether the motion has a period in θ2 at all: b >= a + |c|.
    static bool existsFor(const Mechanism &mechanism);

    /// Preconditions: existsFor(mechanism), harmonics >= 1.
    HarmonicSeries(const Mechanism &mechanism, int harmonics);

    /// A position with its derivatives, in mm or rad, and s.
    struct Sum {
        double value = 0.0;
        double first = 0.0;
        double second = 0.0;
    };
    struct Sums {
        Sum theta3;
        Sum R4x;
    };
    Sums at(double t) const;

private:
    struct Harmonic {
        double cosine = 0.0;
        double sine = 0.0;
    };
    struct Term {
        Harmonic theta3;
        Harmonic R4x;
    };

    double m_omega2;
    double m_theta20;
    std::vector<Term> m_terms; ///< by n, from 0
};

} // namespace slidercrank
