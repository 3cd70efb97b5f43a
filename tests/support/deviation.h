// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Measures and describes the deviation of a computed motion from the exact one (exact_motion.h). Lengths in mm, angles
// in rad, time in s.

#include "core/closed_form/textbook_motion.h"
#include "core/mechanism/state.h"
#include "core/study/exact_motion.h"

#include <algorithm>
#include <cstdio>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace slidercrank
{

inline double valueOf(const State &state, Channel channel)
{
    switch (channel.order) {
    case Order::Position: return state.q[channel.coordinate];
    case Order::Velocity: return state.qDot[channel.coordinate];
    case Order::Acceleration: return state.qDDot[channel.coordinate];
    }
    return std::numeric_limits<double>::quiet_NaN();
}

/// A state with fewer digits than ExactState, which takes less time to compute.
template <class Real>
struct RoughState {
    Status status = Status::Solved;
    std::array<Real, kChannelCount> values{}; ///< indexed by indexOf(channel)
};

/// Returns the peak of each channel over the states of a motion, or the naturalSize() of a channel that is always zero.
template <class AnyState>
std::array<double, kChannelCount> channelSizes(const Parameters &parameters, const std::vector<AnyState> &run)
{
    using std::abs;
    std::array<double, kChannelCount> sizes{};
    for (const AnyState &state : run) {
        for (std::size_t index = 0; index < kChannelCount; ++index) {
            sizes[index] = std::max(sizes[index], static_cast<double>(abs(state.values[index])));
        }
    }
    for (std::size_t index = 0; index < kChannelCount; ++index) {
        const double natural = naturalSize(parameters, channelAt(index));
        if (sizes[index] <= kExactZero * natural) {
            sizes[index] = natural;
        }
    }
    return sizes;
}

inline ExactState exactState(const Parameters &parameters, double t)
{
    return exactState(ExactInput(parameters, t));
}

inline std::vector<ExactState> exactRun(const Parameters &parameters, std::span<const double> instants)
{
    std::vector<ExactState> run;
    for (const double t : instants) {
        run.push_back(exactState(parameters, t));
    }
    return run;
}

/// Returns channelSizes() of a motion that is computed by the formulas of the textbook in extended precision.
/// Precondition: the mechanism can be assembled everywhere.
inline std::array<double, kChannelCount> roughSizes(const Parameters &p, std::span<const double> instants)
{
    using Real = long double;
    std::vector<RoughState<Real>> run(instants.size());
    TextbookMotion<Real> motion;
    for (std::size_t i = 0; i < run.size(); ++i) {
        motion.compute({p.a, p.b, p.c, p.omega2}, Real(p.omega2) * instants[i] + p.theta20,
                       p.branch == Branch::Open ? 1.0 : -1.0, std::numbers::pi_v<Real>);
        for (std::size_t index = 0; index < kChannelCount; ++index) {
            run[i].values[index] = motion.valueAt(channelAt(index));
        }
    }
    return channelSizes(p, run);
}

/// Returns the motion by the formulas of the textbook, or nullopt if the mechanism cannot be assembled.
inline std::optional<TextbookMotion<double>> motionAt(const Parameters &p, double theta2)
{
    TextbookMotion<double> motion;
    motion.compute({p.a, p.b, p.c}, theta2, p.branch == Branch::Open ? 1.0 : -1.0);
    return std::abs(motion.height) <= p.b ? std::optional(motion) : std::nullopt;
}

/// A computed value with the exact value and its tolerance.
struct Deviation {
    Channel channel;
    double t = 0.0;
    double got = 0.0;
    double exact = 0.0;
    double error = 0.0;     ///< |got - exact| in multiple precision; infinite if `got` is not a number
    double tolerance = 0.0; ///< absolute

    bool accepted() const { return error <= tolerance; }
    /// Returns the error in units of the tolerance.
    double ratio() const { return error == 0.0 ? 0.0 : error / tolerance; }
};

/// Returns the deviation of the channel with the largest error in units of its tolerance. Considers the orders up to
/// `last`, or only positions if the status of the exact state is not Solved.
template <class AnyState>
Deviation worstDeviation(const State &got, const AnyState &exact, double t,
                         const std::array<double, kChannelCount> &tolerances, Order last = Order::Acceleration)
{
    using std::abs;
    Deviation worst;
    double worstRatio = -1.0;
    for (std::size_t index = 0; index < kChannelCount; ++index) {
        const Channel channel = channelAt(index);
        if (channel.order > last || (channel.order != Order::Position && exact.status != Status::Solved)) {
            continue;
        }
        Deviation deviation{channel,          t, valueOf(got, channel), static_cast<double>(exact.values[index]), 0.0,
                            tolerances[index]};
        deviation.error =
            std::isfinite(deviation.got) ? static_cast<double>(abs(deviation.got - exact.values[index])) : kInfinity;
        if (deviation.ratio() > worstRatio) {
            worstRatio = deviation.ratio();
            worst = deviation;
        }
    }
    return worst;
}

inline std::string describe(const Parameters &p)
{
    char text[256];
    std::snprintf(text, sizeof text, "a=%.17g b=%.17g c=%.17g omega2=%.17g theta20=%.17g %s", p.a, p.b, p.c, p.omega2,
                  p.theta20, p.branch == Branch::Open ? "open" : "crossed");
    return text;
}

inline std::string describe(const Deviation &deviation)
{
    char text[320];
    std::snprintf(text, sizeof text, "%s at t=%.17g: got %.17g, exact %.17g, difference %.3g, tolerance %.3g",
                  std::string(nameOf(deviation.channel)).c_str(), deviation.t, deviation.got, deviation.exact,
                  deviation.error, deviation.tolerance);
    return text;
}

inline std::array<double, kChannelCount> scaled(std::array<double, kChannelCount> sizes, double factor)
{
    for (double &size : sizes) {
        size *= factor;
    }
    return sizes;
}

} // namespace slidercrank
