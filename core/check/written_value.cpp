// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/check/written_value.h"

#include "core/import/cells.h"

#include <cmath>
#include <string>
#include <vector>

namespace slidercrank
{

namespace
{

constexpr std::size_t kAssumedDigits = 3; // zeros at the end of a whole number are significant up to this digit

struct Mantissa {
    std::vector<std::size_t> digits; ///< positions of the digits in the text, from the first one that is not zero
    std::size_t last = 0;            ///< position of the last digit that counts
};

/// Finds the digits before a power of ten or a unit.
Mantissa findMantissa(std::string_view text)
{
    Mantissa mantissa;
    bool hasPoint = false;
    for (std::size_t i = std::min(text.find_first_of("0123456789."), text.size()); i < text.size(); ++i) {
        if (isDigit(text[i])) {
            mantissa.last = i;
            if (text[i] != '0' || !mantissa.digits.empty()) {
                mantissa.digits.push_back(i);
            }
        } else if (text[i] == '.') {
            hasPoint = true;
        } else if (!isBlank(text[i])) {
            break;
        }
    }
    while (!hasPoint && mantissa.digits.size() > kAssumedDigits && text[mantissa.digits.back()] == '0') {
        mantissa.digits.pop_back();
        mantissa.last = mantissa.digits.back();
    }
    return mantissa;
}

} // namespace

WrittenValue readWrittenValue(std::string_view text, const Unit &expected)
{
    const Quantity quantity = readQuantity(text, expected);
    if (quantity.fault) {
        return {.fault = quantity.fault};
    }
    const Mantissa mantissa = findMantissa(text);
    std::string neighbour(text); // becomes a number that differs by one unit of the last digit
    char &lastDigit = neighbour[mantissa.last];
    lastDigit = static_cast<char>(lastDigit == '9' ? '8' : lastDigit + 1);
    const double step = std::abs(readQuantity(neighbour, expected).value - quantity.value);
    return {.value = quantity.value,
            .halfStep = 0.5 * step,
            .digits = static_cast<int>(mantissa.digits.size()),
            .fault = std::nullopt};
}

} // namespace slidercrank
