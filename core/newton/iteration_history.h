// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Newton-Raphson at one instant, step by step: the coordinates on the way of assemble() and track() (newton.h).
// Lengths in mm, angles in rad, time in s.

#include "core/newton/newton.h"

#include <vector>

namespace slidercrank
{

struct Iteration {
    Vector12 q;
    double residual = 0.0; ///< ‖C(q, t)‖, in the measure of the options
};

struct IterationHistory {
    /// The start, then what each iteration made of it; at most NewtonResult::kHistory. Empty where there is no position
    /// to look for.
    std::vector<Iteration> iterations;

    Status status = Status::NotFinite;
    bool startedAfar = false; ///< the way from the start that was given left the branch: this is the one from afar
};

/// The way of assemble().
IterationHistory iterationsFromAfar(const Mechanism &mechanism, double t, const NewtonOptions &options = {});

/// The way of track().
IterationHistory iterationsFrom(const Mechanism &mechanism, double t, const Vector12 &start,
                                const NewtonOptions &options = {});

} // namespace slidercrank
