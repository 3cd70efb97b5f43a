// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Calculations by hand with the usual slips, computed by complex numbers, independently of the program.

#include "core/check/slips.h"
#include "core/mechanism/turn.h"

#include <array>
#include <complex>
#include <functional>
#include <map>
#include <string_view>
#include <vector>

#include <QByteArray>

namespace slidercrank
{

inline constexpr double kPi = std::numbers::pi;

/// The motion at one position as a student writes it, in mm, rad and s. A student solves the vector loop
///     a e^(iθ2) + b e^(iθ3) = x + ic
/// and its derivatives.
struct HandCalculation {
    double a, b, c, theta2, omega2, alpha2;
    double side;                      ///< 1 in the open assembly, -1 in the crossed one
    double crankNormal;               ///< factor of a in the normal acceleration of A; ω2² without a slip
    double couplerNormalFactor = 1.0; ///< factor of b ω3² in the normal acceleration of B relative to A
    double x = 0.0, v = 0.0, acceleration = 0.0, theta3 = 0.0, omega3 = 0.0, alpha3 = 0.0, mu = 0.0;

    HandCalculation(const Parameters &p, double crankAcceleration)
        : a(p.a)
        , b(p.b)
        , c(p.c)
        , theta2(p.theta20)
        , omega2(p.omega2)
        , alpha2(crankAcceleration)
        , side(p.branch == Branch::Open ? 1.0 : -1.0)
        , crankNormal(p.omega2 * p.omega2)
    {
    }

    std::complex<double> crank() const { return std::polar(a, theta2); }

    void solvePosition()
    {
        const double height = c - crank().imag();
        theta3 = std::arg(std::complex(side * std::sqrt(b * b - height * height), height));
        mu = std::acos(std::abs(height) / b);
    }

    void solveSlider(double couplerAngle)
    {
        constexpr std::complex<double> i(0.0, 1.0);
        const std::complex<double> coupler = std::polar(b, couplerAngle);
        x = (crank() + coupler).real();
        v = (i * omega2 * crank() + i * omega3 * coupler).real();
        acceleration =
            ((i * alpha2 - crankNormal) * crank() + (i * alpha3 - couplerNormalFactor * omega3 * omega3) * coupler)
                .real();
    }

    /// Computes ω3 and α3, at which the imaginary parts of the derivatives vanish.
    void solveCoupler(double couplerAngle)
    {
        constexpr std::complex<double> i(0.0, 1.0);
        const std::complex<double> coupler = std::polar(b, couplerAngle);
        omega3 = -(i * omega2 * crank()).imag() / coupler.real();
        alpha3 = -((i * alpha2 - crankNormal) * crank() - couplerNormalFactor * omega3 * omega3 * coupler).imag() /
                 coupler.real();
    }

    HandCalculation &solve()
    {
        solvePosition();
        solveCoupler(theta3);
        solveSlider(theta3);
        return *this;
    }

    double valueOf(const char *name) const
    {
        const std::map<std::string_view, double> values{{"x", x},           {"v", v},           {"a", acceleration},
                                                        {"theta3", theta3}, {"omega3", omega3}, {"alpha3", alpha3},
                                                        {"mu", mu}};
        return values.at(name);
    }
};

using Calculate = std::function<void(HandCalculation &)>;

/// A slip, and how a student arrives at the wrong numbers.
struct SlipCase {
    const char *title;
    Slip slip;
    Calculate calculate;
};

/// Returns a calculation with changed inputs.
inline Calculate withInput(const std::function<void(HandCalculation &)> &change)
{
    return [change](HandCalculation &hand) {
        change(hand);
        hand.crankNormal = hand.omega2 * hand.omega2;
        hand.solve();
    };
}

/// The formulas in which a slip is made.
enum class Formulas { All, OfSlider };

/// Returns a calculation whose position is right, and whose further formulas use changed values.
inline Calculate withTerm(const std::function<void(HandCalculation &)> &change, Formulas formulas)
{
    return [change, formulas](HandCalculation &hand) {
        hand.solve();
        change(hand);
        if (formulas == Formulas::All) {
            hand.solveCoupler(hand.theta3);
        }
        hand.solveSlider(hand.theta3);
    };
}

/// Replaces the slider by a function of θ2, given with its derivatives.
inline void setSlider(HandCalculation &hand, double x, double slope, double curvature)
{
    hand.x = x;
    hand.v = slope * hand.omega2;
    hand.acceleration = curvature * hand.omega2 * hand.omega2 + slope * hand.alpha2;
}

inline void scaleLengths(HandCalculation &hand, double factor)
{
    hand.solve();
    hand.x *= factor;
    hand.v *= factor;
    hand.acceleration *= factor;
}

inline void scaleAngles(HandCalculation &hand, double factor)
{
    hand.solve();
    hand.theta3 *= factor;
    hand.omega3 *= factor;
    hand.alpha3 *= factor;
}

/// Computes with sin θ3 and cos θ3 exchanged.
inline void exchangeCoupler(HandCalculation &hand, Formulas formulas)
{
    hand.solve();
    const double exchanged = kQuarterTurn - hand.theta3;
    if (formulas == Formulas::All) {
        hand.solveCoupler(exchanged);
    }
    hand.solveSlider(exchanged);
}

/// Computes with θ3 + 180°, the angle of the coupler at B.
inline void turnCoupler(HandCalculation &hand, Formulas formulas)
{
    hand.solve();
    if (formulas == Formulas::All) {
        hand.solveCoupler(hand.theta3 + kPi);
    }
    hand.solveSlider(hand.theta3 + kPi);
}

inline double roundedTo3Digits(double degrees)
{
    return QByteArray::number(degrees, 'e', 2).toDouble();
}

inline const std::vector<SlipCase> kSlipCases{
    {"the other assembly", Slip::OtherAssembly, withInput([](auto &hand) { hand.side *= -1.0; })},
    {"c with the other sign", Slip::OffsetSign, withInput([](auto &hand) { hand.c *= -1.0; })},
    {"no c", Slip::OffsetOmitted, withInput([](auto &hand) { hand.c = 0.0; })},
    {"ω2 with the other sign", Slip::CrankSpeedSign, withInput([](auto &hand) { hand.omega2 *= -1.0; })},
    {"α2 with the other sign", Slip::CrankAccelerationSign, withInput([](auto &hand) { hand.alpha2 *= -1.0; })},
    {"no α2", Slip::CrankAccelerationOmitted, withInput([](auto &hand) { hand.alpha2 = 0.0; })},
    {"θ2 with the other sign", Slip::CrankAngleSign, withInput([](auto &hand) { hand.theta2 *= -1.0; })},
    {"calculator in radians", Slip::CrankAngleUnit, withInput([](auto &hand) { hand.theta2 *= 180.0 / kPi; })},
    {"calculator in degrees", Slip::CrankAngleUnit, withInput([](auto &hand) { hand.theta2 *= kPi / 180.0; })},
    {"rpm as rad/s", Slip::CrankSpeedInRpm, withInput([](auto &hand) { hand.omega2 *= 60.0 / (2.0 * kPi); })},
    {"rad/s as rpm", Slip::CrankSpeedInRpm, withInput([](auto &hand) { hand.omega2 *= 2.0 * kPi / 60.0; })},
    {"°/s as rad/s", Slip::CrankSpeedInDegrees, withInput([](auto &hand) { hand.omega2 *= 180.0 / kPi; })},
    {"rad/s as °/s", Slip::CrankSpeedInDegrees, withInput([](auto &hand) { hand.omega2 *= kPi / 180.0; })},
    {"a and b exchanged", Slip::LinksExchanged, withInput([](auto &hand) { std::swap(hand.a, hand.b); })},
    {"a doubled", Slip::DiameterForRadius, withInput([](auto &hand) { hand.a *= 2.0; })},
    {"a halved", Slip::DiameterForRadius, withInput([](auto &hand) { hand.a *= 0.5; })},
    {"θ3 = 360° - θ3", Slip::CouplerAngleSign,
     [](auto &hand) {
         hand.solve();
         hand.theta3 = 2.0 * kPi - hand.theta3;
     }},
    {"coupler clockwise", Slip::CouplerAngleSign, [](auto &hand) { scaleAngles(hand, -1.0); }},
    {"sin θ2 for cos θ2", Slip::CrankSineForCosine,
     withInput([](auto &hand) { hand.theta2 = kQuarterTurn - hand.theta2; })},
    {"sin θ2 for cos θ2 after θ3", Slip::CrankSineForCosine,
     withTerm([](auto &hand) { hand.theta2 = kQuarterTurn - hand.theta2; }, Formulas::All)},
    {"sin θ2 for cos θ2 of the slider", Slip::CrankSineForCosine,
     withTerm([](auto &hand) { hand.theta2 = kQuarterTurn - hand.theta2; }, Formulas::OfSlider)},
    {"sin θ3 for cos θ3", Slip::CouplerSineForCosine, [](auto &hand) { exchangeCoupler(hand, Formulas::All); }},
    {"sin θ3 for cos θ3 of the slider", Slip::CouplerSineForCosine,
     [](auto &hand) { exchangeCoupler(hand, Formulas::OfSlider); }},
    {"θ3 at the other end", Slip::CouplerAngleEnd, [](auto &hand) { turnCoupler(hand, Formulas::All); }},
    {"θ3 at the other end of the slider", Slip::CouplerAngleEnd,
     [](auto &hand) { turnCoupler(hand, Formulas::OfSlider); }},
    {"ω2 not squared", Slip::CrankSpeedNotSquared,
     withTerm([](auto &hand) { hand.crankNormal = hand.omega2; }, Formulas::All)},
    {"ω2 not squared in ẍ", Slip::CrankSpeedNotSquared,
     withTerm([](auto &hand) { hand.crankNormal = hand.omega2; }, Formulas::OfSlider)},
    {"no a ω2²", Slip::CrankNormalOmitted, withTerm([](auto &hand) { hand.crankNormal = 0.0; }, Formulas::All)},
    {"no a ω2² in ẍ", Slip::CrankNormalOmitted,
     withTerm([](auto &hand) { hand.crankNormal = 0.0; }, Formulas::OfSlider)},
    {"no b ω3²", Slip::CouplerNormalOmitted,
     withTerm([](auto &hand) { hand.couplerNormalFactor = 0.0; }, Formulas::All)},
    {"no b ω3² in ẍ", Slip::CouplerNormalOmitted,
     withTerm([](auto &hand) { hand.couplerNormalFactor = 0.0; }, Formulas::OfSlider)},
    {"no centripetal terms", Slip::NormalsOmitted,
     withTerm([](auto &hand) { hand.crankNormal = hand.couplerNormalFactor = 0.0; }, Formulas::All)},
    {"no centripetal terms in ẍ", Slip::NormalsOmitted,
     withTerm([](auto &hand) { hand.crankNormal = hand.couplerNormalFactor = 0.0; }, Formulas::OfSlider)},
    {"A for B", Slip::HarmonicMotion,
     [](auto &hand) {
         hand.solve();
         setSlider(hand, hand.a * std::cos(hand.theta2), -hand.a * std::sin(hand.theta2),
                   -hand.a * std::cos(hand.theta2));
     }},
    {"simple harmonic motion", Slip::HarmonicMotion,
     [](auto &hand) {
         hand.solve();
         setSlider(hand, hand.a * std::cos(hand.theta2) + hand.side * hand.b, -hand.a * std::sin(hand.theta2),
                   -hand.a * std::cos(hand.theta2));
     }},
    {"two harmonics", Slip::TwoHarmonics,
     [](auto &hand) {
         hand.solve();
         const double n = hand.side * hand.b / hand.a; // b / a, which textbooks call n
         const double t = hand.theta2;
         setSlider(hand, hand.a * (std::cos(t) + n - (1.0 - std::cos(2.0 * t)) / (4.0 * n)),
                   -hand.a * (std::sin(t) + std::sin(2.0 * t) / (2.0 * n)),
                   -hand.a * (std::cos(t) + std::cos(2.0 * t) / n));
         hand.omega3 = -hand.omega2 * std::cos(t) / n;
         hand.alpha3 = (hand.omega2 * hand.omega2 * std::sin(t) - hand.alpha2 * std::cos(t)) / n;
     }},
    {"two harmonics from the outer dead centre", Slip::TwoHarmonics,
     [](auto &hand) {
         hand.solve();
         const double n = hand.b / hand.a;
         const double t = hand.side > 0.0 ? hand.theta2 : kPi - hand.theta2; // the crossed assembly is the mirror image
         const double sense = hand.side;
         setSlider(hand, hand.a * (1.0 - std::cos(t) + (1.0 - std::cos(2.0 * t)) / (4.0 * n)),
                   sense * hand.a * (std::sin(t) + std::sin(2.0 * t) / (2.0 * n)),
                   hand.a * (std::cos(t) + std::cos(2.0 * t) / n));
         hand.theta3 *= -1.0;
         hand.omega3 = hand.omega2 * std::cos(hand.theta2) / (hand.side * n);
         hand.alpha3 = (hand.alpha2 * std::cos(hand.theta2) - hand.omega2 * hand.omega2 * std::sin(hand.theta2)) /
                       (hand.side * n);
     }},
    {"sin 2θ/n", Slip::SecondHarmonicDouble,
     [](auto &hand) {
         hand.solve();
         const double n = hand.side * hand.b / hand.a;
         hand.v = -hand.a * hand.omega2 * (std::sin(hand.theta2) + std::sin(2.0 * hand.theta2) / n);
     }},
    {"G3 for B", Slip::CouplerCentre,
     [](auto &hand) {
         hand.solve();
         const double cosine = std::cos(hand.theta2);
         const double sine = std::sin(hand.theta2);
         hand.x = 0.5 * (hand.x + hand.a * cosine);
         hand.v = 0.5 * (hand.v - hand.a * hand.omega2 * sine);
         hand.acceleration = 0.5 * (hand.acceleration - hand.a * (hand.alpha2 * sine + hand.crankNormal * cosine));
     }},
    {"from the outer dead centre", Slip::FromOuterDeadCentre,
     [](auto &hand) {
         hand.solve();
         hand.x = std::sqrt(std::pow(hand.a + hand.b, 2) - hand.c * hand.c) - hand.side * hand.x;
         hand.v *= -hand.side;
         hand.acceleration *= -hand.side;
     }},
    {"from the inner dead centre", Slip::FromInnerDeadCentre,
     [](auto &hand) {
         hand.solve();
         hand.x = hand.side * hand.x - std::sqrt(std::pow(hand.b - hand.a, 2) - hand.c * hand.c);
         hand.v *= hand.side;
         hand.acceleration *= hand.side;
     }},
    {"mm as inches", Slip::InchesAsMetricUnits, [](auto &hand) { scaleLengths(hand, 25.4); }},
    {"inches as mm", Slip::InchesAsMetricUnits, [](auto &hand) { scaleLengths(hand, 1.0 / 25.4); }},
    {"cm as inches", Slip::InchesAsMetricUnits, [](auto &hand) { scaleLengths(hand, 2.54); }},
    {"inches as cm", Slip::InchesAsMetricUnits, [](auto &hand) { scaleLengths(hand, 1.0 / 2.54); }},
    {"m as mm", Slip::MetresAsMillimetres, [](auto &hand) { scaleLengths(hand, 1e-3); }},
    {"mm as m", Slip::MetresAsMillimetres, [](auto &hand) { scaleLengths(hand, 1e3); }},
    {"cm as mm", Slip::CentimetresAsMillimetres, [](auto &hand) { scaleLengths(hand, 0.1); }},
    {"mm as cm", Slip::CentimetresAsMillimetres, [](auto &hand) { scaleLengths(hand, 10.0); }},
    {"radians as degrees", Slip::ValueInRadians, [](auto &hand) { scaleAngles(hand, kPi / 180.0); }},
    {"degrees as radians", Slip::ValueInRadians, [](auto &hand) { scaleAngles(hand, 180.0 / kPi); }},
    {"θ3 rounded", Slip::CouplerAngleRounded,
     [](auto &hand) {
         hand.solve();
         const double rounded = roundedTo3Digits(hand.theta3 * 180.0 / kPi) * kPi / 180.0;
         hand.solveCoupler(rounded);
         hand.solveSlider(rounded);
     }},
};

} // namespace slidercrank
