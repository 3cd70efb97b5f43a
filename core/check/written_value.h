// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Reads a number of a calculation by hand with the rounding that its last digit shows: 9.74 is 9.74 ± 0.005, and
// 1.20e3 is 1200 ± 5. The zeros at the end of a whole number may be the result of rounding: they count only up to the
// third digit. So 1200 and 1000 are ± 5, 12000 is ± 50, but 100 and 1024 are ± 0.5, as is "1200." with a decimal point.

#include "core/import/quantity.h"

namespace slidercrank
{

struct WrittenValue {
    double value = kNone;
    double halfStep = 0.0;              ///< half a unit of the last digit
    int digits = 0;                     ///< number of significant digits; 0 for zero
    std::optional<QuantityFault> fault; ///< if there is one, the other members have no meaning
};

/// Returns the value in the unit `expected`, as readQuantity() does.
WrittenValue readWrittenValue(std::string_view text, const Unit &expected);

} // namespace slidercrank
