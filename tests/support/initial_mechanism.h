// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The mechanism with which the program starts (Table 1 of the reference report), with changes.

#include "core/mechanism/mechanism.h"

namespace slidercrank
{

inline Parameters withCoupler(double b)
{
    Parameters parameters;
    parameters.b = b;
    return parameters;
}

} // namespace slidercrank
