// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What was read and what was found out about a file as JSON: what `compare` and `identify` share.

#include "core/identification/diagnosis.h"

#include <QByteArray>

#include <cstddef>
#include <vector>

namespace slidercrank
{

/// As the contract names it in JSON: "identified".
const char *wordOf(Identification::Outcome outcome);

/// Of a file that is joined with others its name, as a member that others follow; else empty.
QByteArray jsonFile(const FileLayout &layout, std::size_t file);

/// An array, an object a column of the file: what it was taken for, and why.
QByteArray jsonColumns(const FileLayout &layout);

/// An array, an object a convention. `data`: the file as it was printed.
QByteArray jsonOf(const std::vector<ConventionFinding> &findings, const ReferenceData &data);

/// An array, an object a mechanism.
QByteArray jsonOf(const std::vector<Identification::Alternative> &alternatives);

/// An object, a member a channel: what noise is left, in the author's unit.
QByteArray jsonOf(const std::vector<Identification::Noise> &noise);

/// An array, an object a column that takes no part in the fit.
QByteArray jsonOf(const std::vector<Identification::LeftOut> &columns);

} // namespace slidercrank
