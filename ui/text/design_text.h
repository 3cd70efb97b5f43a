// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/limits/design.h"

#include <QString>

namespace slidercrank
{

/// Explains why no mechanism meets the request, and states the bound that the request violates.
QString designFaultText(const DesignFault &fault, const DesignRequest &request);

} // namespace slidercrank
