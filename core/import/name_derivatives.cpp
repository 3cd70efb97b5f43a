// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/name_derivatives.h"

#include "core/import/vocabulary.h"

#include <algorithm>

namespace slidercrank
{

namespace
{

using Words = std::vector<std::string>;

/// Returns whether the vocabulary contains a word as a word, filler or derivative, so that it has to stay whole.
bool isKnown(const std::string &word)
{
    return findWord(word, WordUse::Word) || findWord(word, WordUse::Filler) || findWord(word, WordUse::Derivative);
}

/// Splits the marks of derivatives from the words that end with them: "xddot", "dxdt".
void splitMarks(Words &words)
{
    for (const std::string_view mark : {"ddot", "dot", "dt"}) {
        for (std::size_t i = words.size(); i-- > 0;) {
            while (words[i].ends_with(mark) && words[i] != mark && !isKnown(words[i])) {
                words.insert(words.begin() + static_cast<std::ptrdiff_t>(i) + 1, std::string(mark));
                words[i].resize(words[i].size() - mark.size());
            }
        }
    }
}

/// Removes the differential of "dx/dt", "d^2x/dt^2" and "d2x", whose words are "dx", "dt" and "d", "2", "x". Returns
/// how often it differentiates the quantity: 2 for "d2x"; 0 if a "dt" remains, which counts instead.
int takeDifferential(Words &words)
{
    const auto mayBeDifferential = [](const std::string &word) { return word.starts_with('d') && !isKnown(word); };
    const auto first = std::ranges::find_if(words, mayBeDifferential);
    const bool isQuotient = words.size() > 1 && std::ranges::count(words, "dt") > 0;
    const bool isSecond = words.end() - first > 2 && *first == "d" && *(first + 1) == "2";
    if (isSecond && (isQuotient || first == words.begin())) {
        words.erase(first, first + 2);
        return isQuotient ? 0 : 2;
    }
    if (isQuotient && first != words.end()) {
        first->erase(0, 1);
        std::erase(words, std::string());
    }
    return 0;
}

} // namespace

int takeDerivatives(Words &words)
{
    splitMarks(words);
    int count = takeDifferential(words);
    if (words == Words{"ddot"}) { // of the distance d
        words = {"d", "dot"};
    }
    for (std::size_t i = 0; i < words.size();) {
        const WordMeaning *const phrase = findWord(phraseAt(words, i, 2), WordUse::Derivative); // of two words
        const bool isOfSymbol = i == 1 && findWord(words[0], WordUse::Symbol);
        const bool isLabel = !isOfSymbol && i + 1 < words.size() && findWord(words[i], WordUse::Label); // but "x punto"
        const WordMeaning *const entry = phrase ? phrase : findWord(words[i], WordUse::Derivative);
        if (entry && !isLabel) {
            count += static_cast<int>(*entry->order);
            words.erase(words.begin() + static_cast<std::ptrdiff_t>(i),
                        words.begin() + static_cast<std::ptrdiff_t>(i + (phrase ? 2 : 1)));
        } else {
            ++i;
        }
    }
    return count;
}

} // namespace slidercrank
