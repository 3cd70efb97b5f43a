// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What the core says, which knows neither Qt nor languages, in the language in use: why a file cannot be read, what the
// study's cases and machine are called. What is not known here stays as it is.

#include <QString>

#include <string_view>

namespace slidercrank
{

/// A sentence or a clause.
QString coreText(std::string_view english);

/// Names in a row: "toggle gap 1e-4, crossed".
QString coreNames(std::string_view english);

} // namespace slidercrank
