// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/similar_words.h"

#include "app/command_line.h"
#include "ui/text/word_list.h"

#include <algorithm>
#include <iterator>
#include <vector>

namespace slidercrank
{

/// Returns the Damerau-Levenshtein distance of two words, in which no part is changed twice ("optimal string
/// alignment": L. Boytsov, "Indexing methods for approximate dictionary searching", 2011, section 2.1).
static qsizetype editDistance(const QString &from, const QString &to)
{
    // distances[i][j] is the distance between the first i letters of `from` and the first j letters of `to`.
    const auto rows = static_cast<std::size_t>(from.size()) + 1;
    const auto columns = static_cast<std::size_t>(to.size()) + 1;
    std::vector<std::vector<qsizetype>> distances(rows, std::vector<qsizetype>(columns));
    const auto fromLetter = [&from](std::size_t i) { return from[static_cast<qsizetype>(i)]; };
    const auto toLetter = [&to](std::size_t j) { return to[static_cast<qsizetype>(j)]; };
    for (std::size_t i = 0; i < rows; ++i) {
        for (std::size_t j = 0; j < columns; ++j) {
            if (i == 0 || j == 0) {
                distances[i][j] = static_cast<qsizetype>(i + j);
                continue;
            }
            const qsizetype replaced = fromLetter(i - 1) == toLetter(j - 1) ? 0 : 1;
            distances[i][j] =
                std::min({distances[i - 1][j] + 1, distances[i][j - 1] + 1, distances[i - 1][j - 1] + replaced});
            const bool areExchanged =
                i > 1 && j > 1 && fromLetter(i - 1) == toLetter(j - 2) && fromLetter(i - 2) == toLetter(j - 1);
            if (areExchanged) {
                distances[i][j] = std::min(distances[i][j], distances[i - 2][j - 2] + 1);
            }
        }
    }
    return distances.back().back();
}

bool sharesBeginning(const QString &typed, const QString &known)
{
    constexpr qsizetype kShortestBeginning = 2; // "a" begins too many words
    if (typed.isEmpty()) {
        return false;
    }
    const bool isAtMostTwiceAsLong = typed.size() <= 2 * known.size();
    const bool continuesKnown =
        known.size() >= kShortestBeginning && isAtMostTwiceAsLong && typed.startsWith(known, Qt::CaseInsensitive);
    return continuesKnown || known.startsWith(typed, Qt::CaseInsensitive);
}

QStringList similarWords(const QString &typed, const QStringList &words)
{
    constexpr qsizetype kMaxBeginnings = 4;  // more are no help
    constexpr qsizetype kLettersPerEdit = 3; // with more edits, short words resemble any other
    constexpr qsizetype kLongestWord = 100;  // longer text is no misspelt word
    QStringList beginnings;
    std::ranges::copy_if(words, std::back_inserter(beginnings),
                         [&typed](const QString &word) { return sharesBeginning(typed, word); });
    if (!beginnings.isEmpty() && beginnings.size() <= kMaxBeginnings) {
        return beginnings;
    }
    if (typed.size() > kLongestWord) {
        return {};
    }
    QStringList nearest;
    qsizetype fewestEdits = typed.size() / kLettersPerEdit;
    for (const QString &word : words) {
        const qsizetype edits = editDistance(typed.toCaseFolded(), word.toCaseFolded());
        if (edits < fewestEdits) {
            nearest.clear();
        }
        if (edits <= fewestEdits) {
            fewestEdits = edits;
            nearest += word;
        }
    }
    return nearest;
}

QString didYouMean(const QStringList &words)
{
    return words.isEmpty() ? QString() : ' ' + CommandLine::tr("Did you mean %1?").arg(anyOf(words));
}

} // namespace slidercrank
