// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The six plotted channels and how they change with the five parameters: what a least-squares fit steps along.
//
// With h = c - a sin θ2 and s = b cos θ3 = ±√((b - h)(b + h)), a dash for d/dθ2 and an index p for ∂/∂p, p = a, b or c:
//
//     θ3'   = h' / s                          s'   = -h θ3'                  h'   = -a cos θ2
//     θ3''  = (h'' + h θ3'²) / s              s''  = -h' θ3' - h θ3''        h''  =  a sin θ2
//     θ3''' = (h''' + h' θ3'² + 3 h θ3' θ3'') / s
//     s'''  = -h'' θ3' - 2 h' θ3'' - h θ3'''                                 h''' =  a cos θ2
//
//     s_p    = (b b_p - h h_p) / s
//     θ3_p   = (h_p - h b_p / b) / s
//     θ3'_p  = (h'_p - θ3' s_p) / s
//     θ3''_p = (h''_p + h_p θ3'² + 2 h θ3' θ3'_p - θ3'' s_p) / s
//     s'_p   = -h_p θ3' - h θ3'_p
//     s''_p  = -h'_p θ3' - h' θ3'_p - h_p θ3'' - h θ3''_p
//
// The k-th time derivative of a channel f is ω^k f^(k), and θ2 = ω t + θ20, so that its derivatives are
//
//     by θ20  ω^k f^(k+1)              by ω  k ω^(k-1) f^(k) + t ω^k f^(k+1)
//
// The pin is A = a (cos θ2, sin θ2); the crank's centre is at A/2, the coupler's halfway between A and (R4x, c).
//
// Derived from the equations of closed_form.h. Plain sums: a fit knows its parameters to the digits of a file, and
// needs no form that is exact at a toggle. Any consistent units; angles in rad.

#include "core/mechanism/channel.h"

#include <Eigen/Core>

namespace slidercrank
{

inline constexpr Eigen::Index kPlottedCount = static_cast<Eigen::Index>(kPlottedChannels.size());

/// In the order of kPlottedChannels; θ3 as closed_form.h has it.
using PlottedValues = Eigen::Matrix<double, kPlottedCount, 1>;

/// A row a channel, a column a parameter in the order of enum Parameter.
using PlottedDerivatives = Eigen::Matrix<double, kPlottedCount, kParameterCount>;

/// False, and nothing computed, where the mechanism cannot be assembled or has no derivative (|h| >= b). The sign of a
/// length is not looked at: -a is a crank that is half a turn ahead, -b the same as b.
bool plottedMotion(const Parameters &parameters, double t, PlottedValues &values);
bool plottedMotion(const Parameters &parameters, double t, PlottedValues &values, PlottedDerivatives &derivatives);

/// By enum Parameter.
using Gradient = Eigen::Matrix<double, kParameterCount, 1>;

/// All 36 channels at one instant: those of the coupler's and the crank's centres follow from the pin A and from the
/// plotted ones.
class InstantMotion
{
public:
    /// False where the mechanism has no motion; then nothing may be asked.
    bool compute(const Parameters &parameters, double t);

    /// Without gradients.
    bool computeValues(const Parameters &parameters, double t);

    double valueOf(Channel channel) const;
    Gradient gradientOf(Channel channel) const; ///< by the parameters that compute() was given
    double rateOf(Channel channel) const { return m_parameters.omega2 * gradientOf(channel)[4]; }

private:
    double pin(bool alongX, int order) const; ///< of A: a ω^k cos(θ2 + k π/2), or the sine
    Gradient pinGradient(bool alongX, int order) const;

    Parameters m_parameters;
    double m_time = 0.0;
    PlottedValues m_plotted;
    PlottedDerivatives m_derivatives;
};

} // namespace slidercrank
