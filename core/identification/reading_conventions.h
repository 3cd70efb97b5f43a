// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// How a fit reads the columns of a file, as conventions that a person can apply.

#include "core/identification/convention.h"
#include "core/identification/last_fit.h"

#include <vector>

namespace slidercrank
{

/// The conventions that turn the columns of the file into those of the mechanism of the last fit, in the order of their
/// application.
std::vector<ConventionFinding> listConventions(const LastFit &lastFit);

} // namespace slidercrank
