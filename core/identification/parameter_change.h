// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Which one parameter of a mechanism, changed, would explain a file that differs from it: a number mistyped, a length
// changed in one program and not in the other.

#include "core/mechanism/mechanism.h"
#include "core/import/reference_data.h"

#include <stop_token>
#include <vector>

namespace slidercrank
{

/// One parameter of the mechanism fitted alone, all others held: how much of the squared error that explains. Here
/// every channel weighs alike, by how much it varies: what is to be explained is far larger than rounding.
struct ParameterChange {
    Parameter parameter = Parameter::A;
    double value = 0.0;     ///< fitted
    double explained = 0.0; ///< 0 … 1: the part of the weighted sum of squares that is gone
};

/// Each of the five parameters, the one that explains most first, on the way from a mechanism to the one that the file
/// was found to be of. Empty when stopped, or where there is nothing to compare.
std::vector<ParameterChange> parameterChanges(const ReferenceData &data, const Mechanism &mechanism,
                                              const Parameters &found, std::stop_token stop = {});

} // namespace slidercrank
