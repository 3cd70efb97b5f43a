// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The one place that writes QSettings.

#include <QVariantMap>

namespace slidercrank
{

/// From one run to the next, where there is room for it; otherwise all that was chosen before stays as it is. A value
/// that is not valid is forgotten.
void remember(const QVariantMap &choices);

} // namespace slidercrank
