// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// How a search goes through a file of any length: over a window of some hundred rows from its start, in which the
// motion is still to be seen between them; then what was found there, over ever more of the file.

#include "core/identification/candidate.h"

#include <cstddef>
#include <optional>
#include <stop_token>
#include <vector>

namespace slidercrank
{

struct FileSearch {
    std::vector<std::size_t> rows; ///< those that have values
    Clock clock;
    SearchRows window;
    bool isWhole = true; ///< the window is all there is
};

/// None where there are fewer than two rows.
std::optional<FileSearch> searchIn(const ReferenceData &data, const Parameters &given);

/// The whole file, at most so many rows of it, evenly spread: more would make the parameters no more exact than the
/// file's digits, only slower to find.
inline constexpr std::size_t kMostFitRows = 1000;
SearchRows wholeOf(const ReferenceData &data, const FileSearch &search, const Parameters &given);

/// What fits the window, fitted to the whole file, the speed ever better known.
Candidate grown(const ReferenceData &data, const FileSearch &search, const SearchRows &whole,
                const Candidate &candidate, const std::stop_token &stop);

} // namespace slidercrank
