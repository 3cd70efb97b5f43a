// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/limits/instant_centre.h"

#include "core/closed_form/closed_form.h"

namespace slidercrank
{

std::optional<InstantCentre> instantCentre(const Mechanism &mechanism, double t)
{
    const Motion motion = ClosedForm(mechanism).motionAt(t);
    InstantCentre centre;
    const double beyondA = motion.s / motion.crank.cos; // mm, signed distance from A in the direction O2-A
    centre.position = {motion.R4x, (mechanism.a() + beyondA) * motion.crank.sin};
    centre.omega3 = motion.theta3Dot;
    centre.distanceToA = std::abs(beyondA);
    centre.distanceToB = std::abs(centre.position.y - mechanism.c());
    return std::isnan(beyondA) ? std::nullopt : std::optional(centre);
}

} // namespace slidercrank
