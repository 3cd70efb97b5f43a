// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The linkage as the reference data have it at one instant: B from R4x, the coupler's direction from θ3. Between two
// rows they follow the cubic that passes through both with the slopes of the parabolas through each and its neighbours
// (the derivative columns have no say: they may be anything). What the data cannot tell, lengths and a column that is
// not there, comes from a mechanism, best the one identified from the same data.

#include "core/import/reference_data.h"
#include "core/mechanism/mechanism.h"

namespace slidercrank
{

/// mm.
struct ReferencePose {
    bool exists = false;
    double pinX = 0.0, pinY = 0.0;       ///< A, at the coupler's far end
    double sliderX = 0.0, sliderY = 0.0; ///< B
};

/// It does not exist before the first and after the last row, beside an empty cell, and where the data have neither θ3
/// nor R4x.
ReferencePose referencePoseAt(const ReferenceData &data, const Mechanism &mechanism, double time);

/// Where the reference is another mechanism; it does not exist where that cannot be assembled.
ReferencePose referencePoseAt(const Mechanism &mechanism, double time);

} // namespace slidercrank
