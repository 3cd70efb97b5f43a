// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The search through a file of any length: over some hundred rows of its beginning, in which the motion can still be
// seen from row to row; then what was found there over ever more of the file; and the rows that are bad readings.

#include "core/identification/candidate_search.h"

#include <cstddef>
#include <stop_token>
#include <vector>

namespace slidercrank
{

struct FileSearch {
    Observations data;                 ///< a thousand rows at most, without the excluded ones
    std::vector<Candidate> candidates; ///< fitted to `data`, the best first
    std::vector<std::size_t> excluded; ///< rows of the file that are outliers, rising
};

FileSearch searchFile(const Observations &all, const Parameters &given, const std::stop_token &stop);

} // namespace slidercrank
