// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The limits of a motion as one list: dead centres, stroke, times, transmission angle, swing of the coupler, peaks. The
// tables of the window, the command line, the report and the response curves show parts of this list. Lengths in mm,
// angles in rad, time in s.

#include "core/limits/mobility.h"
#include "core/mechanism/enum_table.h"
#include "core/mechanism/measure.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <vector>

namespace slidercrank
{

/// The kinds of limits, in the order in which tables list them.
enum class LimitKind {
    OuterDeadCentre, ///< R4x at the outer dead centre
    InnerDeadCentre, ///< R4x at the inner dead centre
    CrankLimit,      ///< R4x where the crank of a rocker can go no further
    Stroke,          ///< distance between the two ends of the slider's path
    ForwardAngle,    ///< crank rotation from the inner to the outer dead centre
    ForwardTime,
    MeanForwardSpeed,
    ReturnAngle, ///< crank rotation from the outer to the inner dead centre
    ReturnTime,
    MeanReturnSpeed,
    TimeRatio, ///< time of the slower stroke over that of the faster one
    MinimumTransmissionAngle,
    MaximumTransmissionAngle,
    MinimumCouplerAngle, ///< θ3
    MaximumCouplerAngle,
    CouplerSwing, ///< largest minus smallest θ3
    PeakSliderSpeed,
    PeakSliderAcceleration,
    PeakCouplerSpeed,
    PeakCouplerAcceleration
};

struct LimitDescription {
    LimitKind kind;
    std::string_view key; ///< name in JSON and CSV; empty if only tables show the limit
    Measure measure;
};

/// Describes every kind once, in the order of LimitKind.
inline constexpr std::array kLimitDescriptions{
    LimitDescription{LimitKind::OuterDeadCentre, "outer-dead-centre", Measure::Length},
    LimitDescription{LimitKind::InnerDeadCentre, "inner-dead-centre", Measure::Length},
    LimitDescription{LimitKind::CrankLimit, "", Measure::Length},
    LimitDescription{LimitKind::Stroke, "stroke", Measure::Length},
    LimitDescription{LimitKind::ForwardAngle, "forward-angle", Measure::Angle},
    LimitDescription{LimitKind::ForwardTime, "forward-time", Measure::Time},
    LimitDescription{LimitKind::MeanForwardSpeed, "mean-forward-speed", Measure::Speed},
    LimitDescription{LimitKind::ReturnAngle, "return-angle", Measure::Angle},
    LimitDescription{LimitKind::ReturnTime, "return-time", Measure::Time},
    LimitDescription{LimitKind::MeanReturnSpeed, "mean-return-speed", Measure::Speed},
    LimitDescription{LimitKind::TimeRatio, "time-ratio", Measure::Ratio},
    LimitDescription{LimitKind::MinimumTransmissionAngle, "minimum-transmission-angle", Measure::Angle},
    LimitDescription{LimitKind::MaximumTransmissionAngle, "maximum-transmission-angle", Measure::Angle},
    LimitDescription{LimitKind::MinimumCouplerAngle, "minimum-coupler-angle", Measure::Angle},
    LimitDescription{LimitKind::MaximumCouplerAngle, "maximum-coupler-angle", Measure::Angle},
    LimitDescription{LimitKind::CouplerSwing, "coupler-swing", Measure::Angle},
    LimitDescription{LimitKind::PeakSliderSpeed, "peak-slider-speed", Measure::Speed},
    LimitDescription{LimitKind::PeakSliderAcceleration, "peak-slider-acceleration", Measure::Acceleration},
    LimitDescription{LimitKind::PeakCouplerSpeed, "peak-coupler-speed", Measure::AngularSpeed},
    LimitDescription{LimitKind::PeakCouplerAcceleration, "peak-coupler-acceleration", Measure::AngularAcceleration}};

inline constexpr std::size_t kLimitKindCount = kLimitDescriptions.size();

constexpr const LimitDescription &describe(LimitKind kind)
{
    return kLimitDescriptions[static_cast<std::size_t>(kind)];
}

constexpr bool limitsAreDescribedInOrder()
{
    for (std::size_t i = 0; i < kLimitKindCount; ++i) {
        if (static_cast<std::size_t>(kLimitDescriptions[i].kind) != i) {
            return false;
        }
    }
    return enumeratorCount<LimitKind::PeakCouplerAcceleration>() == kLimitKindCount;
}
static_assert(limitsAreDescribedInOrder());

/// A limit that is a peak, and the channel whose peak it is.
struct PeakKind {
    LimitKind kind;
    Channel channel;
};
inline constexpr std::array kPeakKinds{PeakKind{LimitKind::PeakSliderSpeed, {R4x, Order::Velocity}},
                                       PeakKind{LimitKind::PeakSliderAcceleration, {R4x, Order::Acceleration}},
                                       PeakKind{LimitKind::PeakCouplerSpeed, {Theta3, Order::Velocity}},
                                       PeakKind{LimitKind::PeakCouplerAcceleration, {Theta3, Order::Acceleration}}};

/// Returns the channel of a peak, or nullopt if the limit is not a peak.
constexpr std::optional<Channel> peakChannel(LimitKind kind)
{
    const auto *const peak = std::ranges::find(kPeakKinds, kind, &PeakKind::kind);
    return peak == kPeakKinds.end() ? std::nullopt : std::optional(peak->channel);
}

/// A limit that the motion has, at one of the crank angles at which it occurs.
struct Limit {
    LimitKind kind = LimitKind::Stroke;
    double value = 0.0;                ///< mm, rad, s; a peak has its sign, and is infinite if it is unbounded
    std::optional<double> theta2 = {}; ///< rad, where it occurs; nullopt if it belongs to no crank angle
};

/// Returns the limits that exist, in the order of LimitKind: one element for each crank angle of a limit,
/// ascending from 0 to 2π. `motion`: motionLimits(mechanism).
std::vector<Limit> findLimits(const Mechanism &mechanism, const MotionLimits &motion);

/// Returns the value of the first limit of that kind, or NaN if the motion has none.
double valueOf(const std::vector<Limit> &limits, LimitKind kind);

} // namespace slidercrank
