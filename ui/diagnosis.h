// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Whose motion a file is: the mechanism it belongs to, the one parameter that explains the difference, the conventions
// by which it would read better. Takes longer than a moment, so it is made off the GUI thread.

#include "core/comparison.h"
#include "core/conventions.h"
#include "core/identification.h"
#include "ui/reference_file.h"

#include <memory>
#include <stop_token>
#include <vector>

namespace slidercrank
{

/// Immutable once published.
struct Diagnosis {
    std::shared_ptr<const Reference> reference;
    Parameters parameters; ///< the model that the file was held against

    Identification identification;
    std::vector<ChannelComparison> identified; ///< the file against the identified mechanism; empty: none was found

    // Empty where every channel agrees with the model.
    std::vector<Attribution> attribution; ///< the one that explains most first
    std::vector<ConventionFinding> conventions;
};

/// `agrees`: every channel does, with this mechanism. `known`: an earlier diagnosis, whose identification is taken over
/// where it is of the same reference; may be null. Null when stopped. May run in any thread.
std::shared_ptr<const Diagnosis> diagnose(const std::shared_ptr<const Reference> &reference, const Mechanism &mechanism,
                                          bool agrees, const std::shared_ptr<const Diagnosis> &known,
                                          std::stop_token stop);

} // namespace slidercrank
