// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/sampling/trajectory.h"

namespace slidercrank
{

/// Samples positions of a crank: like sample(), but for time stamps that were computed from crank angles and are
/// therefore rounded. If the crank of a rocker is at the end of its arc except for rounding, the row has the limit
/// position and no derivatives (crankLimitStateAt()). The status of such a row is Solved if no derivative is among the
/// channels.
Trajectory samplePositions(const Mechanism &mechanism, const std::vector<double> &times,
                           const SampledChannels &channels, const SolverSettings &settings);

} // namespace slidercrank
