// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The crank angle ω2 t + θ20 to twice the digits of a double, as hi + lo: at t = 1e9 s a single double would already
// have lost 1e-6 rad, and near a toggle even its last digit matters at ordinary times.
//
// Sources: D. E. Knuth, "The Art of Computer Programming" 2, 4.2.2 (TwoSum);
//          T. J. Dekker, "A floating-point technique for extending the available precision", 1971 (TwoProduct).

namespace slidercrank
{

/// The exact value hi + lo, |lo| at most half a unit in the last place of hi.
struct TwoPart {
    double hi = 0.0;
    double lo = 0.0;
};

/// x + y without error, for any finite x, y whose sum does not overflow.
constexpr TwoPart twoSum(double x, double y)
{
    const double sum = x + y;
    const double yRounded = sum - x;
    const double xRounded = sum - yRounded;
    return {sum, (x - xRounded) + (y - yRounded)};
}

inline constexpr double kSplitter = 0x1p27 + 1.0;

/// The upper 26 and the lower 27 bits of x (Veltkamp), |x| < 1e290.
constexpr TwoPart split(double x)
{
    const double scaled = kSplitter * x;
    const double upper = scaled - (scaled - x);
    return {upper, x - upper};
}

/// x y without error, for |x|, |y| < 1e290 and a product that neither overflows nor underflows.
TwoPart twoProduct(double x, double y);

/// ω2 t + θ20, to about 106 bits (rad).
TwoPart crankAngle(double omega2, double t, double theta20);

struct SinCos {
    double sin = 0.0;
    double cos = 1.0;
};

/// Sine and cosine of hi + lo (rad): those of hi, rotated by lo.
SinCos sinCos(TwoPart angle);

/// A sine to some 30 digits: whole + part. The part is right to 30 digits of its own where the sine is near 0 or ±1.
struct FineSine {
    double whole = 0.0; ///< -1, 0 or 1
    TwoPart part;       ///< at most 0.71 in magnitude
};

/// The largest |hi| that fineSine() takes (rad); an angle's two parts hold less than 16 digits of a turn's fraction far
/// beyond it.
inline constexpr double kLargestFineAngle = 1e12;

/// Of hi + lo (rad). Some ten times the cost of sinCos().
FineSine fineSine(TwoPart angle);

} // namespace slidercrank
