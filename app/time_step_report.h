// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Reports time steps whose motion was not computed, on standard error.

#include "app/command_line.h"
#include "core/mechanism/mechanism.h"
#include "core/sampling/trajectory.h"

namespace slidercrank
{

/// Returns Success if all time steps are solved. Otherwise reports how many are not, where the first of them is, and
/// what to do, and returns NotAssemblable or NotSolved. The message begins with `prefix`.
ExitStatus reportTimeSteps(const Streams &streams, const SamplingSummary &summary, const Mechanism &mechanism,
                           const NewtonOptions &newton, const QString &prefix = {});

} // namespace slidercrank
