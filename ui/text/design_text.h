// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/limits/design.h"

#include <QString>

namespace slidercrank
{

/// Why no mechanism meets the request, with the bound that it exceeds.
QString designFaultText(const DesignFault &fault, const DesignRequest &request);

} // namespace slidercrank
