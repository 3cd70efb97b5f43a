// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Computes velocity and acceleration as central differences of sampled positions, as is usual for films, sensors and
// tables. Their error decreases with the square of the step, until rounding dominates:
//
//     ẋ ≈ (x₊ - x₋) / 2Δ            error: Δ²/6 times the third derivative, and ε|x|/Δ
//     ẍ ≈ (x₊ - 2x + x₋) / Δ²       error: Δ²/12 times the fourth derivative, and 4ε|x|/Δ²
//
// Source: M. Abramowitz, I. Stegun, "Handbook of Mathematical Functions", 25.3.21 and 25.3.23.

namespace slidercrank
{

struct Derivatives {
    double first = 0.0;
    double second = 0.0;
};

/// Returns the derivatives at the second of three samples that are `step` (s) apart; NaN if one of the samples is NaN.
constexpr Derivatives centralDifferences(double before, double here, double after, double step)
{
    const double rise = after - here;
    const double riseBefore = here - before;
    return {(rise + riseBefore) / (2.0 * step), (rise - riseBefore) / (step * step)};
}

} // namespace slidercrank
