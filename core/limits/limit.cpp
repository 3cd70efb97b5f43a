// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/limits/limit.h"

#include "core/limits/extremes.h"
#include "core/mechanism/find_element.h"
#include "core/mechanism/turn.h"

#include <algorithm>
#include <cmath>

namespace slidercrank
{

namespace
{

/// The kinds of limits that one of the two strokes has.
struct StrokeKinds {
    LimitKind angle;
    LimitKind time;
    LimitKind meanSpeed;
};

class LimitList
{
public:
    void add(LimitKind kind, double value, std::optional<double> theta2 = {})
    {
        m_limits.push_back({.kind = kind, .value = value, .theta2 = theta2});
    }

    void add(LimitKind kind, const AngleExtreme &extreme)
    {
        for (const double theta2 : extreme.crankAngles) {
            add(kind, extreme.angle, theta2);
        }
    }

    /// Adds the limits of one of the two strokes, during which the crank turns by `angle`.
    void addStroke(const StrokeKinds &kinds, double angle, double stroke, double omega2)
    {
        add(kinds.angle, angle);
        if (omega2 != 0.0) {
            const double time = angle / std::abs(omega2);
            add(kinds.time, time);
            add(kinds.meanSpeed, stroke / time);
        }
    }

    std::vector<Limit> sorted()
    {
        constexpr double kRounding = 1e-11; // rad: an angle that is 0 except for rounding comes first
        std::ranges::stable_sort(m_limits, {}, [](const Limit &limit) {
            return std::pair(limit.kind, limit.theta2 ? wrapToTwoPi(*limit.theta2 + kRounding) : 0.0);
        });
        return m_limits;
    }

private:
    std::vector<Limit> m_limits;
};

static_assert(std::ranges::equal(kPeakKinds, kPeakChannels, {}, &PeakKind::channel));

void addPeaks(LimitList &limits, const Mechanism &mechanism)
{
    for (const Peak &peak : motionPeaks(mechanism)) {
        const LimitKind kind = std::ranges::find(kPeakKinds, peak.channel, &PeakKind::channel)->kind;
        if (peak.points.empty()) {
            limits.add(kind, peak.magnitude);
        }
        for (const PeakPoint &point : peak.points) {
            limits.add(kind, point.value, point.theta2);
        }
    }
}

} // namespace

std::vector<Limit> findLimits(const Mechanism &mechanism, const MotionLimits &motion)
{
    using enum LimitKind;
    LimitList limits;
    for (const auto &[kind, centre] :
         {std::pair(OuterDeadCentre, motion.outerDeadCentre), std::pair(InnerDeadCentre, motion.innerDeadCentre)}) {
        if (centre) {
            limits.add(kind, centre->R4x, centre->theta2);
        }
    }
    for (const SliderPosition &end : motion.crankLimits) {
        limits.add(CrankLimit, end.R4x, end.theta2);
    }
    if (motion.stroke) {
        limits.add(Stroke, *motion.stroke);
    }
    if (motion.timeRatio) {
        limits.addStroke({.angle = ForwardAngle, .time = ForwardTime, .meanSpeed = MeanForwardSpeed},
                         *motion.angleOutwards, *motion.stroke, mechanism.omega2());
        limits.addStroke({.angle = ReturnAngle, .time = ReturnTime, .meanSpeed = MeanReturnSpeed}, *motion.angleInwards,
                         *motion.stroke, mechanism.omega2());
        limits.add(TimeRatio, *motion.timeRatio);
    }
    if (motion.mobility != Mobility::Impossible) {
        limits.add(MinimumTransmissionAngle, motion.coupler.minimumTransmissionAngle);
        limits.add(MaximumTransmissionAngle, motion.coupler.maximumTransmissionAngle);
        limits.add(MinimumCouplerAngle, motion.coupler.minimumTheta3);
        limits.add(MaximumCouplerAngle, motion.coupler.maximumTheta3);
        limits.add(CouplerSwing, motion.coupler.swing);
    }
    addPeaks(limits, mechanism);
    return limits.sorted();
}

double valueOf(const std::vector<Limit> &limits, LimitKind kind)
{
    const Limit *limit = findElement(limits, [kind](const Limit &each) { return each.kind == kind; });
    return limit ? limit->value : kNone;
}

} // namespace slidercrank
