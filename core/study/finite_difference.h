// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What is at hand when only positions are known, from a film, a sensor or a table: velocity and acceleration as central
// differences of neighbouring samples. Their error falls with the square of the step, until rounding takes over:
//
//     ẋ ≈ (x₊ - x₋) / 2Δ            off by Δ²/6 times the third derivative, and ε|x|/Δ
//     ẍ ≈ (x₊ - 2x + x₋) / Δ²       off by Δ²/12 times the fourth, and 4ε|x|/Δ²
//
// Source: M. Abramowitz, I. Stegun, "Handbook of Mathematical Functions", 25.3.21 and 25.3.23.

namespace slidercrank
{

struct Derivatives {
    double first = 0.0;
    double second = 0.0;
};

/// The derivatives at the second of three samples that lie `step` (s) apart. NaN where one of them is NaN.
constexpr Derivatives centralDifferences(double before, double here, double after, double step)
{
    const double rise = after - here;
    const double riseBefore = here - before;
    return {(rise + riseBefore) / (2.0 * step), (rise - riseBefore) / (step * step)};
}

} // namespace slidercrank
