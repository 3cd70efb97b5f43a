// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A way to read a file together with the mechanism that fits it so: what competes for being the explanation.

#include "core/identification/standing.h"

#include <span>
#include <stop_token>
#include <vector>

namespace slidercrank
{

struct Candidate {
    FileReading reading;
    double penalty = 0.0;      ///< of the reading, see diagnosis
    bool isClockExact = false; ///< the instants are taken as they are printed
    FreeParameters isFree = kAllFree;
    Fit fit;
    Standing standing;
    double distance = 1.0; ///< of the fit, as distanceOf()

    double score() const { return fit.score + penalty; }
};

/// What stands goes before what does not, then the lower score.
bool isBetter(const Candidate &x, const Candidate &y);

/// What a free constant costs besides its score: e^-10 against the plain reading, and less likely where a constant
/// column is all that there is of it. And the crossed assembly, to break ties.
constexpr double priceOfZero(Channel channel)
{
    return channel.coordinate == R4y ? 34.0 : 20.0;
}
inline constexpr double kPriceOfCrossed = 6.0;

/// Rows of a file, in three densities: a search looks at few of them first.
struct SearchRows {
    Observations all;
    Observations few;
    Observations fewest;
    Parameters given; ///< the mechanism at hand, in FitUnits
    FreeParameters isFree = kAllFree;
};

/// `rows`: at most some hundreds.
SearchRows searchRowsOf(const ReferenceData &data, const Clock &clock, std::span<const std::size_t> rows,
                        const Parameters &given);

/// From that start, with all rows; rounded instants are also taken as exact, and what scores better stays.
Candidate candidateFrom(const SearchRows &rows, const FileReading &reading, double penalty, const Parameters &start,
                        const std::stop_token &stop);

/// The best of many starts, each with all its images: screened, fitted to few rows, the best of those to all. More than
/// one where others come near; the best first.
std::vector<Candidate> bestCandidates(const SearchRows &rows, const FileReading &reading, double penalty,
                                      std::span<const Parameters> starts, const std::stop_token &stop);

/// The reading with every position's origin free.
FileReading withFreeZeros(const Observations &observations, FileReading reading);

/// Without the free constants that do not pay for themselves.
Candidate withoutIdleZeros(const SearchRows &rows, Candidate candidate, const std::stop_token &stop);

/// What all starts lead to, the file read as it says, or with origins elsewhere; the best first.
std::vector<Candidate> plainCandidates(const SearchRows &rows, std::span<const Parameters> starts,
                                       const std::stop_token &stop);

} // namespace slidercrank
