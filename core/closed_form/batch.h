// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The six plotted channels of the exact motion at many instants at once: the formulas of closed_form.h in the widest
// vectors that the processor has, chosen when the program runs. The numbers are those of ClosedForm to the last bit,
// whatever the processor and wherever an instant stands in the run. Beyond 1.6e6 rad, near the limits of a rocker, and
// where not everything exists, instants are computed one by one.

#include "core/closed_form/closed_form.h"
#include "core/closed_form/motion_constants.h"

#include <span>

namespace slidercrank
{

/// Where the channels go, in the unit of the author's files (mm, °, s): one array a channel, as long as the run. Null:
/// not asked for, and not computed.
struct PlottedColumns {
    double *theta3 = nullptr;
    double *R4x = nullptr;
    double *theta3Dot = nullptr;
    double *R4xDot = nullptr;
    double *theta3DDot = nullptr;
    double *R4xDDot = nullptr;

    /// The same columns without their first `count` values.
    PlottedColumns behind(std::size_t count) const;
};

class ClosedFormBatch
{
public:
    explicit ClosedFormBatch(const Mechanism &mechanism);

    /// The channels asked for and the status at each instant (s); `statuses` is as long as `instants`.
    void evaluate(std::span<const double> instants, const PlottedColumns &columns, std::span<Status> statuses) const;

private:
    MotionConstants m_constants;
    ClosedForm m_closedForm; ///< for instants that vectors are not for
};

} // namespace slidercrank
