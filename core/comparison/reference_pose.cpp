// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/comparison/reference_pose.h"

#include "core/closed_form/closed_form.h"

#include <algorithm>
#include <cmath>

namespace slidercrank
{

namespace
{

/// Interpolates a column of positions between the rows i and i + 1, by the polynomial through both rows and the
/// neighbouring rows i - 1 and i + 2 if they have a value. Returns NaN if row i or row i + 1 has no value. Differences
/// of angles are reduced to half a turn, because some programs print angles within one turn.
double interpolated(const ReferenceData &data, const ReferenceSeries &series, double time, std::size_t i)
{
    constexpr double kDegreesPerTurn = 360.0;
    const std::vector<double> &values = series.values;
    std::vector<std::size_t> rows{i, i + 1};
    if (i > 0 && std::isfinite(values[i - 1])) {
        rows.push_back(i - 1);
    }
    if (i + 2 < values.size() && std::isfinite(values[i + 2])) {
        rows.push_back(i + 2);
    }
    double change = 0.0; // from row i, by Lagrange's form of the polynomial
    for (const std::size_t row : rows) {
        const double difference = values[row] - values[i];
        double term = isAngle(series.channel.coordinate) ? std::remainder(difference, kDegreesPerTurn) : difference;
        for (const std::size_t otherRow : rows) {
            if (otherRow != row) {
                term *= (time - data.time[otherRow]) / (data.time[row] - data.time[otherRow]);
            }
        }
        change += term;
    }
    return values[i] + change;
}

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

    const double theta3 = angle ? interpolated(data, *angle, time, before) / kDegreesPerRadian : 0.0;
    const double couplerX = mechanism.b() * std::cos(theta3);
    const double couplerY = mechanism.b() * std::sin(theta3);
    ReferencePose pose;
    if (!angle || !slider) {
        // The time stamps of an angle-indexed file belong to the drive of the file.
        pose = referencePoseAt(data.crank ? withDrive(mechanism, data.crank->omega2, data.crank->theta20) : mechanism,
                               time);
    }
    pose.sliderX = slider ? interpolated(data, *slider, time, before) : pose.pinX + couplerX;
    pose.sliderY = slider ? mechanism.c() : pose.pinY + couplerY;
    if (angle && slider) {
        pose.pinX = pose.sliderX - couplerX;
        pose.pinY = pose.sliderY - couplerY;
    }
    pose.exists = std::isfinite(theta3) && std::isfinite(pose.sliderX);
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
