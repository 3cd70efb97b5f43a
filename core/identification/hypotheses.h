// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Ways to read a file, each with its price: what a way must gain in score to be believed. One cause has one price,
// however many columns it concerns; each of them costs a little more.

#include "core/identification/column_hypothesis.h"
#include "core/identification/convention.h"
#include "core/identification/candidate.h"

#include <cstddef>
#include <span>
#include <stop_token>
#include <vector>

namespace slidercrank
{

struct Hypothesis {
    std::vector<ColumnHypothesis> columns; ///< by column of the Observations
    double timeUnit = 1.0;                 ///< seconds that a unit of the file's time is
    Parameters start;                      ///< in FitUnits, of the file's time

    FileReading reading() const;
    double price(const Observations &observations) const;
};

/// The file as it says.
Hypothesis plainHypothesis(const Observations &observations);

/// What the columns would have to be if one of these mechanisms, or an image of it, were right; the likeliest first,
/// each way of reading once or twice.
std::vector<Hypothesis> hypothesesFrom(const Observations &few, std::span<const Parameters> starts,
                                       const std::stop_token &stop);

/// Starts from every family and every column alone, angles in radians, too, and columns under each other's names: for
/// files in which some column misleads all others.
std::vector<Parameters> startsFromParts(const Observations &observations, double size, const std::stop_token &stop);

/// What a fitted hypothesis says of the file, in the order of application. Derivatives that were left out because they
/// are a little off, as differences are, are no finding.
std::vector<Convention> conventionsOf(const Observations &observations, const Hypothesis &hypothesis,
                                      const Candidate &candidate);

} // namespace slidercrank
