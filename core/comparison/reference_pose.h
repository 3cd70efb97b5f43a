// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The pose of the linkage in the reference data at a given time: B from R4x, and the direction of the coupler from θ3.
// Between two rows, R4x and θ3 are interpolated by the polynomial through these rows and their neighbours. The
// derivative columns are not used, because they may be wrong. Lengths come from a mechanism, preferably the one
// identified from the same data, and also the crank angle if θ3 or R4x is missing. Without R4x, B may lie beside the
// slider's line.

#include "core/import/reference_data.h"
#include "core/mechanism/mechanism.h"

namespace slidercrank
{

/// The positions of both ends of the coupler, mm.
struct ReferencePose {
    bool exists = false;
    double pinX = 0.0, pinY = 0.0;       ///< the crank pin A
    double sliderX = 0.0, sliderY = 0.0; ///< the wrist pin B
};

/// Returns the pose in the data at a time (s). It does not exist before the first and after the last row, next to an
/// empty cell, and if the data have neither θ3 nor R4x.
ReferencePose referencePoseAt(const ReferenceData &data, const Mechanism &mechanism, double time);

/// Returns the pose of a mechanism that is the reference, at a time (s). It does not exist if the mechanism cannot be
/// assembled.
ReferencePose referencePoseAt(const Mechanism &mechanism, double time);

} // namespace slidercrank
