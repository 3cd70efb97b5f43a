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

    /// Sets the status, and the vectors that do not exist with it to NaN.
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
