// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/closed_form/crank_acceleration.h"

#include "core/closed_form/state_at.h"

namespace slidercrank
{

Vector12 kinematicCoefficients(const Mechanism &mechanism, double t)
{
    // At the speed of 1 rad/s, the time derivatives equal the derivatives by the crank angle. The two parts of the
    // angle become the initial angle and the time, so that no digit is lost.
    const TwoPart angle = crankAngle(mechanism.omega2(), t, mechanism.theta20());
    if (!(std::abs(angle.hi) <= kLargestParameter)) {
        return Vector12::Constant(kNone);
    }
    return ClosedForm(withDrive(mechanism, 1.0, angle.hi)).stateAt(angle.lo).qDot;
}

void addCrankAcceleration(const Mechanism &mechanism, double t, double alpha2, State &state)
{
    if (alpha2 != 0.0) {
        state.qDDot += alpha2 * kinematicCoefficients(mechanism, t);
    }
}

} // namespace slidercrank
