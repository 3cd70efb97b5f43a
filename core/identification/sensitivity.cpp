// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/sensitivity.h"

#include <cmath>
#include <numbers>

namespace slidercrank
{

namespace
{

/// One instant; d1, d2, d3 are derivatives by θ2.
struct Pose {
    double sin2, cos2;
    double h, hD1, hD2;
    double s, sD1, sD2;
    double theta3D1, theta3D2;
};

bool poseAt(const Parameters &p, double t, Pose &pose, PlottedValues &values)
{
    const double theta2 = p.omega2 * t + p.theta20;
    pose.sin2 = std::sin(theta2);
    pose.cos2 = std::cos(theta2);
    pose.h = p.c - p.a * pose.sin2;
    const double square = (p.b - pose.h) * (p.b + pose.h);
    if (!(square > 0.0)) {
        return false;
    }
    const double root = std::sqrt(square);
    const bool open = p.branch == Branch::Open;
    pose.s = open ? root : -root;
    pose.hD1 = -p.a * pose.cos2;
    pose.hD2 = p.a * pose.sin2;
    pose.theta3D1 = pose.hD1 / pose.s;
    pose.theta3D2 = (pose.hD2 + pose.h * pose.theta3D1 * pose.theta3D1) / pose.s;
    pose.sD1 = -pose.h * pose.theta3D1;
    pose.sD2 = -pose.hD1 * pose.theta3D1 - pose.h * pose.theta3D2;

    const double steepness = std::atan2(pose.h, root);
    const double w = p.omega2;
    values << (open ? steepness : std::numbers::pi - steepness), p.a * pose.cos2 + pose.s, w * pose.theta3D1,
        w * (pose.sD1 - p.a * pose.sin2), w * w * pose.theta3D2, w * w * (pose.sD2 - p.a * pose.cos2);
    return true;
}

} // namespace

bool plottedMotion(const Parameters &parameters, double t, PlottedValues &values)
{
    Pose pose;
    return poseAt(parameters, t, pose, values);
}

bool plottedMotion(const Parameters &parameters, double t, PlottedValues &values, PlottedDerivatives &derivatives)
{
    Pose at;
    if (!poseAt(parameters, t, at, values)) {
        return false;
    }
    const double w = parameters.omega2;
    const double a = parameters.a;
    const double b = parameters.b;

    // By a length p, of which h_p, h'_p, h''_p, b_p and (a cos θ2)_p and its derivatives are given.
    const auto byLength = [&](double h, double hD1, double hD2, double ofB, double x, double xD1, double xD2) {
        const double s = (b * ofB - at.h * h) / at.s;
        const double theta3 = (h - at.h * ofB / b) / at.s;
        const double theta3D1 = (hD1 - at.theta3D1 * s) / at.s;
        const double theta3D2 =
            (hD2 + h * at.theta3D1 * at.theta3D1 + 2.0 * at.h * at.theta3D1 * theta3D1 - at.theta3D2 * s) / at.s;
        const double sD1 = -h * at.theta3D1 - at.h * theta3D1;
        const double sD2 = -hD1 * at.theta3D1 - at.hD1 * theta3D1 - h * at.theta3D2 - at.h * theta3D2;
        return PlottedValues(theta3, x + s, w * theta3D1, w * (xD1 + sD1), w * w * theta3D2, w * w * (xD2 + sD2));
    };
    derivatives.col(0) = byLength(-at.sin2, -at.cos2, at.sin2, 0.0, at.cos2, -at.sin2, -at.cos2);
    derivatives.col(1) = byLength(0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0);
    derivatives.col(2) = byLength(1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0);

    // By the crank angle.
    const double theta3D3 =
        (-at.hD1 + at.hD1 * at.theta3D1 * at.theta3D1 + 3.0 * at.h * at.theta3D1 * at.theta3D2) / at.s;
    const double sD3 = -at.hD2 * at.theta3D1 - 2.0 * at.hD1 * at.theta3D2 - at.h * theta3D3;
    const double xD1 = -a * at.sin2;
    const double R4xD1 = xD1 + at.sD1;
    const double R4xD2 = at.sD2 - a * at.cos2;
    const double R4xD3 = sD3 - xD1;
    derivatives.col(4) << at.theta3D1, R4xD1, w * at.theta3D2, w * R4xD2, w * w * theta3D3, w * w * R4xD3;
    derivatives.col(3) = t * derivatives.col(4);
    derivatives(2, 3) += at.theta3D1;
    derivatives(3, 3) += R4xD1;
    derivatives(4, 3) += 2.0 * w * at.theta3D2;
    derivatives(5, 3) += 2.0 * w * R4xD2;
    return true;
}

} // namespace slidercrank
