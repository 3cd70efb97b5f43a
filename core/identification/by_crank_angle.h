// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Whose motion a file is that counts by the crank's angle. Its positions say nothing of ω2, and nothing of it says θ20:
// both are taken as given. Where derivatives by the time stand beside what they are the derivatives of, ω2 is what lies
// between the two:
//
//     ∫ v dθ2 = ω2 Δx        v = ω2 dx/dθ2,  a = ω2² d²x/dθ2²
//
// The first is a start, off by what trapezoids miss; the second, with the mechanism that was found by it, the answer.

#include "core/identification/diagnosis.h"

namespace slidercrank
{

/// As diagnose(), for data that count by the crank's angle.
Diagnosis diagnoseByCrankAngle(const ReferenceData &data, const Mechanism &mechanism, const std::stop_token &stop);

} // namespace slidercrank
