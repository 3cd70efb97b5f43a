// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Least squares of a slider-crank's motion on observations: residuals, their derivatives, and the Levenberg-Marquardt
// method.
//
// Source: J. J. Moré, "The Levenberg-Marquardt algorithm: implementation and theory", 1978 (MINPACK, as Eigen has it).

#include "core/identification/observations.h"

#include <array>
#include <stop_token>

namespace slidercrank
{

/// Weights that know how exact each value is: 1 / its rounding step, or less where residuals of the channel, at the
/// mechanism given, say that something else than rounding is at work.
void weighByStep(Observations &observations, const Parameters &parameters);

/// Root mean square of the weighted residuals; a row where the mechanism has no motion counts as if it were 0 there.
double misfit(const Observations &observations, const Parameters &parameters);

/// A coupler just long enough for the motion to exist at all rows.
void lengthenCoupler(const Observations &observations, Parameters &parameters);

/// The same with all lengths scaled so that the channels that are lengths fit best; where there are none, the size
/// stays.
double misfitAtBestSize(const Observations &observations, Parameters &parameters);

struct Fit {
    Parameters parameters;
    double rms = 0.0; ///< of the weighted residuals
    int iterations = 0;
    bool stopped = false;
};

/// By enum Parameter.
using FreeParameters = std::array<bool, kParameterCount>;

/// The branch is held, as is what is not free. Where b is free, the coupler is first made long enough; otherwise there
/// is nothing to be fitted from a start that cannot move as long as the data do, and the rms is infinite.
Fit fit(const Observations &observations, const Parameters &start, const FreeParameters &isFree, int mostIterations,
        std::stop_token stop);

/// From a start that fits the rows up to `end`: again and again with more of them, the speed ever better known, until
/// it fits all; by the lowest orders only. At most kMostFitRows at a time, spread evenly: more would make the
/// parameters no more exact than the file's digits, only slower to find.
inline constexpr std::size_t kMostFitRows = 4000;
Fit fitGrowing(const ReferenceData &data, const FitUnits &units, const Supply &supply, std::size_t end,
               const Parameters &start, const FreeParameters &isFree, std::stop_token stop);

/// The residuals weighted, and their derivatives, a column a parameter; values that are missing give rows of zeros.
/// False where the mechanism has no motion at some row.
bool linearize(const Observations &observations, const Parameters &parameters, Eigen::VectorXd &residuals,
               Eigen::Matrix<double, Eigen::Dynamic, kParameterCount> *derivatives);

} // namespace slidercrank
