// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Writes the settings of the user.

#include <QVariantMap>

namespace slidercrank
{

/// Saves each entry in QSettings. Invalid values remove their key. Leaves the settings unchanged if the disk is full.
void remember(const QVariantMap &choices);

} // namespace slidercrank
