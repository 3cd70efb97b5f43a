// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// All 12 coordinates at one time, as vectors. This header is separate from mechanism.h because most modules that
// include mechanism.h do not need Eigen.

#include "core/mechanism/channel.h"
#include "core/mechanism/mechanism.h"

#include <Eigen/Core>

namespace slidercrank
{

using Vector12 = Eigen::Matrix<double, kCoordinateCount, 1>;
using Matrix12 = Eigen::Matrix<double, kCoordinateCount, kCoordinateCount>;

/// The 12 coordinates, or their derivatives, by name (mm, rad, s). Those that are not set are 0. The compiler keeps
/// them in registers, which it does not do with the elements of a vector.
struct NamedCoordinates {
    double R1x = 0.0, R1y = 0.0, theta1 = 0.0;
    double R2x = 0.0, R2y = 0.0, theta2 = 0.0;
    double R3x = 0.0, R3y = 0.0, theta3 = 0.0;
    double R4x = 0.0, R4y = 0.0, theta4 = 0.0;
};

inline NamedCoordinates namedCoordinates(const Vector12 &q)
{
    return {.R1x = q[R1x],
            .R1y = q[R1y],
            .theta1 = q[Theta1],
            .R2x = q[R2x],
            .R2y = q[R2y],
            .theta2 = q[Theta2],
            .R3x = q[R3x],
            .R3y = q[R3y],
            .theta3 = q[Theta3],
            .R4x = q[R4x],
            .R4y = q[R4y],
            .theta4 = q[Theta4]};
}

/// Sets all elements of a vector in place, which is faster than returning it.
inline void setCoordinates(Vector12 &to, const NamedCoordinates &named)
{
    to[R1x] = named.R1x;
    to[R1y] = named.R1y;
    to[Theta1] = named.theta1;
    to[R2x] = named.R2x;
    to[R2y] = named.R2y;
    to[Theta2] = named.theta2;
    to[R3x] = named.R3x;
    to[R3y] = named.R3y;
    to[Theta3] = named.theta3;
    to[R4x] = named.R4x;
    to[R4y] = named.R4y;
    to[Theta4] = named.theta4;
}

/// The coordinates at one time with their first and second time derivatives (mm, rad, s). Values that do not exist are
/// NaN.
struct State {
    Vector12 q;
    Vector12 qDot;
    Vector12 qDDot;
    Status status = Status::Solved;

    /// Returns the value of a channel (mm, rad, s).
    double valueOf(Channel channel) const
    {
        switch (channel.order) {
        case Order::Position: break;
        case Order::Velocity: return qDot[channel.coordinate];
        case Order::Acceleration: return qDDot[channel.coordinate];
        }
        return q[channel.coordinate];
    }

    /// Sets the status, and sets the vectors that do not exist with that status to NaN.
    void setStatus(Status newStatus)
    {
        status = newStatus;
        if (status != Status::Solved) {
            qDot.setConstant(kNone);
            qDDot.setConstant(kNone);
            if (status != Status::Singular) {
                q.setConstant(kNone);
            }
        }
    }
};

} // namespace slidercrank
