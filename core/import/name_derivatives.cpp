// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/name_derivatives.h"

#include "core/import/vocabulary.h"

#include <algorithm>

namespace slidercrank
{

namespace
{

using Words = std::vector<std::string>;

/// Removes the differentials of "dx/dt" and "Acceleration d^2x/dt^2", whose words are "dxdt" and "acceleration", "d",
/// "2", "xdt", "2". Returns the number of derivatives.
int takeDifferentials(Words &words)
{
    const auto mayBeDifferential = [](const std::string &word) {
        return word.starts_with('d') && !findWord(word, WordUse::Word) && !findWord(word, WordUse::Filler) &&
               !findWord(word, WordUse::Derivative);
    };
    const auto endsWithTime = [](const std::string &word) { return word.ends_with("dt"); };
    const auto first = std::ranges::find_if(words, mayBeDifferential);
    const auto quotient = std::find_if(first, words.end(), endsWithTime);
    const bool isQuotient = quotient != words.end();
    const auto length = words.end() - first;
    if (length == 0 || (length == 1 && first->size() <= 3)) { // "dt" is no quotient
        return 0;
    }
    const bool isSecond = length > 2 && *first == "d" && *(first + 1) == "2" && (isQuotient || first == words.begin());
    if (isQuotient) {
        quotient->resize(quotient->size() - 2);
        if (const auto power = quotient + 1; power != words.end() && *power == "2") {
            words.erase(power);
        }
    }
    if (isSecond) {
        words.erase(first, first + 2);
    } else if (isQuotient) {
        first->erase(0, 1);
    }
    std::erase(words, std::string());
    if (isSecond) {
        return 2;
    }
    return isQuotient ? 1 : 0;
}

} // namespace

int takeDerivatives(Words &words)
{
    int count = takeDifferentials(words);
    if (words == Words{"ddot"} || words == Words{"dddot"}) { // of the distance d
        words = {"d", words[0].substr(1)};
    }
    for (std::size_t i = 0; i < words.size();) {
        const WordMeaning *const two = findWord(pairAt(words, i), WordUse::Derivative);
        const bool isOfSymbol = i == 1 && findWord(words[0], WordUse::Symbol);
        const bool isLabel = !isOfSymbol && i + 1 < words.size() && findWord(words[i], WordUse::Label); // but "x punto"
        const WordMeaning *const entry = two ? two : findWord(words[i], WordUse::Derivative);
        if (entry && !isLabel) {
            count += static_cast<int>(*entry->order);
            words.erase(words.begin() + static_cast<std::ptrdiff_t>(i),
                        words.begin() + static_cast<std::ptrdiff_t>(i + (two ? 2 : 1)));
        } else {
            ++i;
        }
    }
    return count;
}

} // namespace slidercrank
