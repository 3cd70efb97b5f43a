// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Describes the result of a comparison. The window, the command line and the report use the same texts. Numbers are
// written in the default locale, with units.

#include "core/comparison/comparison.h"

#include <QString>
#include <QStringList>

#include <optional>
#include <span>
#include <vector>

namespace slidercrank
{

/// Returns an error with three significant digits, "∞", or a dash for nullopt.
QString errorText(std::optional<double> value);

/// Describes a verdict: "agrees within the rounding of the file", "close: at most 12.3 times the rounding of the file".
QString verdictText(const ChannelComparison &channel);

/// Returns the time (s) of the largest error of a channel, or its crank angle if the file is angle-indexed, without
/// the unit. Returns a dash if there is no error.
QString abscissaOfLargestError(const ChannelComparison &channel, const ReferenceData &file);

/// Returns a table of the errors of each channel against a file, in the units that are shown. The first row contains
/// the headings.
std::vector<QStringList> comparisonTable(std::span<const ChannelComparison> channels, const ReferenceData &file);

/// Summarizes a comparison: "Match. Quantities that agree within the rounding of the file: 6 of 6."
QString summaryText(std::span<const ChannelComparison> channels);

} // namespace slidercrank
