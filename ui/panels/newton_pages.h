// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What Newton-Raphson works with at one time: equations, Jacobian, iterations, and the coordinates that result. Numbers
// of the equations in the core's units (mm, rad, s), coordinates in those of the reference report (mm, °, s).

#include "ui/document/result.h"
#include "ui/panels/page.h"

namespace slidercrank
{

Page equationPage(const Result &result, double time);
Page jacobianPage(const Result &result, double time);

/// From a rough start, and from the position one time step before.
Page iterationPage(const Result &result, double time);

Page coordinatePage(const Result &result, double time);

} // namespace slidercrank
