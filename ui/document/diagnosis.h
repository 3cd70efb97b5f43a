// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Whose motion a file is: the mechanism it belongs to, the one parameter that explains the difference, the conventions
// by which it would read better. Takes longer than a moment, so it is made off the GUI thread.

#include "core/diagnosis/interpretation.h"
#include "ui/document/reference_file.h"

#include <memory>
#include <stop_token>

namespace slidercrank
{

/// Immutable once published.
struct Diagnosis {
    std::shared_ptr<const Reference> reference;
    Parameters parameters; ///< the model that the file was held against
    Interpretation found;
};

/// Null when stopped. May run in any thread.
std::shared_ptr<const Diagnosis> diagnose(const std::shared_ptr<const Reference> &reference, const Mechanism &mechanism,
                                          std::stop_token stop);

} // namespace slidercrank
