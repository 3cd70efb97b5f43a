// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/document/result.h"
#include "ui/panels/page.h"

namespace slidercrank
{

/// Whether the crank makes full turns and why, where the slider reverses, the peak velocities and accelerations. A row
/// whose crank angle is reached in the simulated time leads there.
Page limitsPage(const Result &result);

} // namespace slidercrank
