// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The data of Newton-Raphson at one time: equations, Jacobian, iterations, and the coordinates that result. Lengths are
// in the chosen unit. Angles are in rad in the equations, and in the chosen unit in the coordinates.

#include "ui/document/result.h"
#include "ui/panels/page.h"

#include <QCoreApplication>

namespace slidercrank
{

struct NewtonPages {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::NewtonPages)

public:
    static Page equations(const Result &result, double time);
    static Page jacobian(const Result &result, double time);

    /// Returns the iterations from a rough start, and those from the position one time step earlier.
    static Page iterations(const Result &result, double time);

    static Page coordinates(const Result &result, double time);
};

} // namespace slidercrank
