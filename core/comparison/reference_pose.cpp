// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/comparison/reference_pose.h"

#include "core/closed_form/closed_form.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace slidercrank
{

namespace
{

/// Interpolates a column of positions.
class Curve
{
public:
    Curve(const ReferenceData &data, const ReferenceSeries &series)
        : m_time(data.time)
        , m_values(series.values)
        , m_angle(isAngle(series.channel.coordinate))
    {
    }

    /// The value at a time between the rows i and i + 1; NaN where either is empty.
    double operator()(double time, std::size_t i) const
    {
        const double length = m_time[i + 1] - m_time[i];
        const double part = (time - m_time[i]) / length;
        const double chord = chordAfter(i);
        double first = slopeAt(i);
        double last = slopeAt(i + 1);
        if (std::isnan(first)) {
            first = std::isnan(last) ? chord : 2.0 * chord - last; // a parabola
        }
        if (std::isnan(last)) {
            last = 2.0 * chord - first;
        }
        const double rest = 1.0 - part;
        const double bend = part * rest * (rest * (first - chord) - part * (last - chord));
        return m_values[i] + length * (chord * part + bend);
    }

private:
    /// The mean slope from row i to the next one, per second.
    double chordAfter(std::size_t i) const
    {
        double rise = m_values[i + 1] - m_values[i];
        if (m_angle) {
            rise = std::remainder(rise, 360.0); // some programs print angles within one turn
        }
        return rise / (m_time[i + 1] - m_time[i]);
    }

    /// The slope of the parabola through row i and its neighbours; NaN if one of them is missing.
    double slopeAt(std::size_t i) const
    {
        if (i == 0 || i + 1 == m_time.size()) {
            return std::numeric_limits<double>::quiet_NaN();
        }
        const double before = m_time[i] - m_time[i - 1];
        const double after = m_time[i + 1] - m_time[i];
        return (chordAfter(i - 1) * after + chordAfter(i) * before) / (before + after);
    }

    const std::vector<double> &m_time;
    const std::vector<double> &m_values;
    bool m_angle;
};

} // namespace

ReferencePose referencePoseAt(const ReferenceData &data, const Mechanism &mechanism, double time)
{
    const ReferenceSeries *angle = data.find({Theta3, Order::Position});
    const ReferenceSeries *slider = data.find({R4x, Order::Position});
    const std::vector<double> &rows = data.time;
    if ((!angle && !slider) || rows.size() < 2 || !(time >= rows.front() && time <= rows.back())) {
        return {};
    }
    const auto after = std::upper_bound(rows.begin() + 1, rows.end() - 1, time);
    const auto before = static_cast<std::size_t>(after - rows.begin()) - 1;

    double theta3 = 0.0;
    double sliderX = 0.0;
    if (!angle || !slider) {
        Parameters parameters = mechanism.parameters();
        if (data.crank) { // the time stamps belong to the drive of the file
            parameters.omega2 = data.crank->omega2;
            parameters.theta20 = data.crank->theta20;
        }
        const Motion motion = ClosedForm(Mechanism(parameters)).motionAt(time);
        theta3 = motion.theta3;
        sliderX = motion.R4x;
    }
    if (angle) {
        theta3 = Curve(data, *angle)(time, before) / kDegreesPerRadian;
    }
    if (slider) {
        sliderX = Curve(data, *slider)(time, before);
    }
    ReferencePose pose;
    pose.exists = std::isfinite(theta3) && std::isfinite(sliderX);
    pose.sliderX = sliderX;
    pose.sliderY = mechanism.c();
    pose.pinX = sliderX - mechanism.b() * std::cos(theta3);
    pose.pinY = mechanism.c() - mechanism.b() * std::sin(theta3);
    return pose;
}

ReferencePose referencePoseAt(const Mechanism &mechanism, double time)
{
    const Motion motion = ClosedForm(mechanism).motionAt(time);
    return {.exists = motion.status == Status::Solved || motion.status == Status::Singular,
            .pinX = mechanism.a() * motion.crank.cos,
            .pinY = mechanism.a() * motion.crank.sin,
            .sliderX = motion.R4x,
            .sliderY = mechanism.c()};
}

} // namespace slidercrank
