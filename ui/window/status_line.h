// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The run on show in one line: how the parts are put together, how it was computed, at what cost.

#include <QString>

namespace slidercrank
{

struct Result;

QString statusLine(const Result &result);

} // namespace slidercrank
