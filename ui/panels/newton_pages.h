// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The data of Newton-Raphson at one time: equations, Jacobian, iterations, and the coordinates that result. The
// equations are in the core's units (mm, rad, s), the coordinates in those of the reference report (mm, °, s).

#include "ui/document/result.h"
#include "ui/panels/page.h"

namespace slidercrank
{

Page equationPage(const Result &result, double time);
Page jacobianPage(const Result &result, double time);

/// The iterations from a rough start, and those from the position one time step earlier.
Page iterationPage(const Result &result, double time);

Page coordinatePage(const Result &result, double time);

} // namespace slidercrank
