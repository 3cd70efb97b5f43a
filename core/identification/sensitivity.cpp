// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/sensitivity.h"

#include <array>
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

bool InstantMotion::compute(const Parameters &parameters, double t)
{
    m_parameters = parameters;
    m_time = t;
    return plottedMotion(parameters, t, m_plotted, m_derivatives);
}

bool InstantMotion::computeValues(const Parameters &parameters, double t)
{
    m_parameters = parameters;
    m_time = t;
    return plottedMotion(parameters, t, m_plotted);
}

double InstantMotion::pin(bool alongX, int order) const
{
    return pinGradient(alongX, order)[0] * m_parameters.a;
}

Gradient InstantMotion::pinGradient(bool alongX, int order) const
{
    const double w = m_parameters.omega2;
    const double theta2 = w * m_time + m_parameters.theta20;
    const double cosine = std::cos(theta2);
    const double sine = std::sin(theta2);
    const std::array<double, 4> quarters{cosine, -sine, -cosine, sine}; // of cos(θ2 + k π/2); the sine is one behind
    const auto first = static_cast<std::size_t>(order + (alongX ? 0 : 3));
    const double power = std::pow(w, order);
    const double slope = quarters[first % quarters.size()];
    Gradient gradient = Gradient::Zero();
    gradient[0] = power * slope;
    gradient[4] = m_parameters.a * power * quarters[(first + 1) % quarters.size()];
    gradient[3] = m_time * gradient[4] + (order > 0 ? order * m_parameters.a * std::pow(w, order - 1) * slope : 0.0);
    return gradient;
}

double InstantMotion::valueOf(Channel channel) const
{
    const int order = static_cast<int>(channel.order);
    const auto slider = [&] { return m_plotted[2 * order + 1]; };
    switch (channel.coordinate) {
    case Theta2:
        return order == 0   ? m_parameters.omega2 * m_time + m_parameters.theta20
               : order == 1 ? m_parameters.omega2
                            : 0.0;
    case Theta3: return m_plotted[2 * order];
    case R4x: return slider();
    case R4y: return order == 0 ? m_parameters.c : 0.0;
    case R2x: return 0.5 * pin(true, order);
    case R2y: return 0.5 * pin(false, order);
    case R3x: return 0.5 * (pin(true, order) + slider());
    case R3y: return 0.5 * (pin(false, order) + (order == 0 ? m_parameters.c : 0.0));
    case R1x:
    case R1y:
    case Theta1:
    case Theta4: break;
    }
    return 0.0;
}

Gradient InstantMotion::gradientOf(Channel channel) const
{
    const int order = static_cast<int>(channel.order);
    const auto plotted = [&](int row) -> Gradient { return m_derivatives.row(row).transpose(); };
    Gradient gradient = Gradient::Zero();
    switch (channel.coordinate) {
    case Theta2:
        if (order == 0) {
            gradient[3] = m_time;
            gradient[4] = 1.0;
        } else if (order == 1) {
            gradient[3] = 1.0;
        }
        break;
    case Theta3: return plotted(2 * order);
    case R4x: return plotted(2 * order + 1);
    case R4y: gradient[2] = order == 0 ? 1.0 : 0.0; break;
    case R2x: return 0.5 * pinGradient(true, order);
    case R2y: return 0.5 * pinGradient(false, order);
    case R3x: return 0.5 * (pinGradient(true, order) + plotted(2 * order + 1));
    case R3y:
        gradient = 0.5 * pinGradient(false, order);
        gradient[2] = order == 0 ? 0.5 : 0.0;
        break;
    case R1x:
    case R1y:
    case Theta1:
    case Theta4: break;
    }
    return gradient;
}

} // namespace slidercrank
