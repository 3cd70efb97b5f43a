// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Computes the crank angle ω2 t + θ20 with twice the digits of a double, as the sum hi + lo. A single double has an
// error of 1e-6 rad at t = 1e9 s, and near a toggle the last digit of the angle matters even at small
// times.
//
// Sources: D. E. Knuth, "The Art of Computer Programming" 2, 4.2.2 (TwoSum);
//          T. J. Dekker, "A floating-point technique for extending the available precision", 1971 (TwoProduct).

namespace slidercrank
{

/// The exact value hi + lo, where |lo| is at most half a unit in the last place of hi.
struct TwoPart {
    double hi = 0.0;
    double lo = 0.0;
};

/// Returns x + y without error, for any finite x, y whose sum does not overflow.
constexpr TwoPart twoSum(double x, double y)
{
    const double sum = x + y;
    const double yRounded = sum - x;
    const double xRounded = sum - yRounded;
    return {sum, (x - xRounded) + (y - yRounded)};
}

inline constexpr double kSplitter = 0x1p27 + 1.0;

/// Splits x into its upper 26 and lower 27 bits (Veltkamp). Requires |x| < 1e290.
constexpr TwoPart split(double x)
{
    const double scaled = kSplitter * x;
    const double upper = scaled - (scaled - x);
    return {upper, x - upper};
}

/// Returns x y without error, for |x|, |y| < 1e290 and a product that neither overflows nor underflows.
TwoPart twoProduct(double x, double y);

/// Returns ω2 t + θ20 (rad) to about 106 bits.
TwoPart crankAngle(double omega2, double t, double theta20);

struct SinCos {
    double sin = 0.0;
    double cos = 1.0;
};

/// Returns sine and cosine of hi + lo (rad): those of hi, rotated by lo.
SinCos sinCos(TwoPart angle);

/// A sine with about 30 digits, as the sum whole + part. Near 0 and ±1 the part itself has about 30 correct digits.
struct FineSine {
    double whole = 0.0; ///< -1, 0 or 1
    TwoPart part;       ///< at most 0.71 in magnitude
};

/// The largest |hi| (rad) for which fineSine() is accurate.
inline constexpr double kLargestFineAngle = 1e12;

/// Returns the sine of hi + lo (rad). Takes about ten times as long as sinCos().
FineSine fineSine(TwoPart angle);

} // namespace slidercrank
