// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// How far the coupler is from standing square to the slider's line, without cancellation.
//
// With h = c - a sin θ2 (the height of B above A) the coupler has sin θ3 = h/b. Everything hard about the slider-crank
// happens where b - |h| is tiny. Subtracting a rounded h from b loses it; these sums do not:
//
//     C = |c|,  g = sign of c,  x = g sin θ2,  ε = b - a - C,  β = b + C - a      (ε, β exact to the last bit)
//     p = b - g h = ε + a (1 + x)        m = b + g h = β + a (1 - x)               b cos θ3 = ±√(p m)
//
// While ε >= 0 (the crank can turn round) every term of p and m is non-negative, so nothing cancels. While ε < 0 (a
// rocker) one of them does near a limit of the motion; there it is the difference taken in two parts, of a sine to some
// 30 digits, so that it is right to the last digit however near the limit is.

#include "core/mechanism/mechanism.h"
#include "core/mechanism/two_part_angle.h"

namespace slidercrank
{

class Clearance
{
public:
    explicit Clearance(const Mechanism &mechanism);

    /// The clearance at one crank angle. Lengths in units of scale(): multiply by it for mm.
    struct At {
        double x;             ///< g sin θ2
        double cosine;        ///< cos θ2
        double sigma;         ///< 1 + x, without cancellation
        double sigmaMirrored; ///< 1 - x, without cancellation
        double p;             ///< b - g h
        double m;             ///< b + g h
        double h;             ///< g h = C - a x
        bool assemblable() const { return p >= 0.0 && m >= 0.0; }
    };
    At at(TwoPart theta2) const;

    // The mechanism in units of scale(), a power of two near a + b + |c|, so that no power of a length over- or
    // underflows whatever the size of the mechanism.
    double scale() const { return m_scale; }
    double a() const { return m_a; }
    double b() const { return m_b; }
    double offset() const { return m_offset; }   ///< C = |c|
    double side() const { return m_side; }       ///< g: +1 for c >= 0, -1 for c < 0
    double epsilon() const { return m_epsilon; } ///< b - a - C
    double beta() const { return m_beta; }       ///< b + C - a
    double gamma() const { return m_gamma; }     ///< a + b - C
    double reach() const { return m_reach; }     ///< L = a + b + C

    /// Where p or m is less than this, it takes more digits than those of a double sine; 0 while ε >= 0.
    double nearLimit() const { return m_nearLimit; }

private:
    double fineGap(double sideOfGap, TwoPart theta2) const;

    double m_scale;
    double m_a;
    double m_b;
    double m_offset;
    double m_side;
    double m_epsilon;
    double m_beta;
    double m_gamma;
    double m_reach;
    double m_nearLimit;
};

} // namespace slidercrank
