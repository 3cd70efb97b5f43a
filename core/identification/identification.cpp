// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/identification.h"

#include <algorithm>
#include <limits>

namespace slidercrank
{

void Identification::claimNothing()
{
    standardError.fill(std::numeric_limits<double>::quiet_NaN());
    identifiable.fill(false);
    onlyRatios = false;
    alternatives.clear();
    noise.clear();
    leftOut.clear();
    excludedRows.clear();
}

void Identification::rejectImpossible(const Parameters &given)
{
    const auto isImpossible = [](const Alternative &alternative) {
        return findFault(alternative.parameters).has_value();
    };
    if (findFault(parameters) || std::ranges::any_of(alternatives, isImpossible)) {
        outcome = Outcome::None;
        parameters = given;
        claimNothing();
    }
}

} // namespace slidercrank
