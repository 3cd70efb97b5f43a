// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Why a file, or a row of it, cannot be read, in the language in use.

#include "core/import/reference_data.h"

#include <QString>

namespace slidercrank
{

/// A sentence that says what to do.
QString sentenceOf(const ReadFault &fault);

/// A clause: "not a number".
QString reasonOf(const SkippedRow &row);

} // namespace slidercrank
