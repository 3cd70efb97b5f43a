// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The columns that the geometry does not use, most of them derivatives. Each is used, or left out with a reason.

#include "core/identification/drive.h"
#include "core/identification/fit.h"
#include "core/identification/identification.h"

#include <vector>

namespace slidercrank
{

/// The result of withFurtherColumns().
struct FurtherColumns {
    Fit fit; ///< of all columns that the mechanism explains
    std::vector<LeftOutColumn> leftOut{};

    /// In a table over the crank angle, the values of ω2 that the derivatives allow, rad/s.
    std::vector<double> speeds{};
};

/// Adds columns to a fit, positions first. A column is added in its usual reading, or else in a different unit, with a
/// different sign or with a free origin, if a mechanism explains it together with the columns of the fit: its residuals
/// are rounding or small, and those columns are explained as well as without it (explainsAsWell()). `drive`: that of
/// the model of the fit. `given`: chooses among the speeds that the units of a table leave open, and is the speed if no
/// derivative of a table is used.
FurtherColumns withFurtherColumns(const Observations &observations, const Fit &fit, const Drive &drive,
                                  const Parameters &given);

} // namespace slidercrank
