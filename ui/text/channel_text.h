// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Names the 36 channels: coordinates, velocities and accelerations.

#include "core/mechanism/channel.h"

#include <QString>

namespace slidercrank
{

/// Returns the symbol of a channel: "θ³", "ω³", "Rₓ⁴", "v⁴". The crank angle is "θ₂", as in the controls. Derivatives
/// have their own letters because fonts misplace the dot of θ̇, and the superscript of d²θ³/dt² looks like a cube.
QString symbolText(Channel channel);

/// Returns the symbol of a channel in absolute coordinates, which the equations are written in: "θ³", "Rₓ⁴".
QString absoluteSymbolText(Channel channel);

/// Returns the name of a channel: "coupler angle", "slider velocity".
QString quantityName(Channel channel);

/// Returns the name of a channel in files: "theta3", "R4_x_diff".
QString columnName(Channel channel);

/// Returns the unit of a channel in files: "mm/s²", "°".
QString unitText(Channel channel);

} // namespace slidercrank
