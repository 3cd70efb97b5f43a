// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Searches a file of any length: first a few hundred rows of its beginning, close enough to show the motion; then
// extends the fits to ever larger parts of the file; and excludes rows with bad readings.

#include "core/identification/candidate_search.h"

#include <cstddef>
#include <set>
#include <stop_token>
#include <vector>

namespace slidercrank
{

struct FileSearch {
    Observations data;                 ///< at most a thousand rows, without the excluded ones
    std::vector<Candidate> candidates; ///< fitted to `data`, from best to worst
    std::set<std::size_t> excluded;    ///< the rows of the file that are outliers
};

/// Searches all rows. `given` supplies parameters that the file does not determine.
FileSearch searchFile(const Observations &all, const Parameters &given, const std::stop_token &stop);

} // namespace slidercrank
