// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/limits/instant_centre.h"

#include "core/closed_form/closed_form.h"

namespace slidercrank
{

std::optional<InstantCentre> instantCentre(const Mechanism &mechanism, double t)
{
    const Motion motion = ClosedForm(mechanism).motionAt(t);
    InstantCentre centre;
    const double along = motion.s / motion.crank.cos; // from A, in the crank's direction
    centre.position = {motion.R4x, (mechanism.a() + along) * motion.crank.sin};
    centre.omega3 = motion.theta3Dot;
    centre.toA = std::abs(along);
    centre.toB = std::abs(centre.position.y - mechanism.c());
    return std::isnan(along) ? std::nullopt : std::optional(centre);
}

} // namespace slidercrank
