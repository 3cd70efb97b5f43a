// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/document/result.h"
#include "ui/panels/page.h"

namespace slidercrank
{

/// Returns a page of the motion limits: whether the crank makes full turns, where the slider reverses, and the peak
/// velocities and accelerations. A click on a row goes to its time if the crank angle is reached in the simulated time
/// range.
Page limitsPage(const Result &result);

} // namespace slidercrank
