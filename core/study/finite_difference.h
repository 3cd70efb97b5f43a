// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What is at hand when only positions are known, from a film, a sensor or a table: velocity and acceleration as central
// differences of neighbouring samples. Their error falls with the square of the step, until rounding takes over:
//
//     ẋ ≈ (x₊ - x₋) / 2Δ            off by Δ²/6 times the third derivative, and ε|x|/Δ
//     ẍ ≈ (x₊ - 2x + x₋) / Δ²       off by Δ²/12 times the fourth, and 4ε|x|/Δ²
//
// Source: M. Abramowitz, I. Stegun, "Handbook of Mathematical Functions", 25.3.21 and 25.3.23.

#include <span>

namespace slidercrank
{

/// The derivatives of samples that lie `step` (s) apart, at all but the first and the last of them: `first` and
/// `second` are two shorter than `samples`. NaN beside a sample that is NaN.
void centralDifferences(std::span<const double> samples, double step, std::span<double> first,
                        std::span<double> second);

} // namespace slidercrank
