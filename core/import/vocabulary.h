// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The words and symbols of headings, and what each of them says about the quantity in a column. Add a new word to the
// row of its kind in the table, and a new row for a new kind of word.

#include "core/import/unit_text.h"
#include "core/mechanism/channel.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace slidercrank
{

enum class Body { Crank, Coupler, Slider };

/// Where an entry of the vocabulary may occur.
enum class WordUse {
    Word,            ///< anywhere: "velocity", "slider"
    Symbol,          ///< once in a name: "v", "theta"
    Index,           ///< after a symbol: the B of "x_B"
    Derivative,      ///< anywhere: the dot of "x_dot"; `order` is the number of derivatives
    AmbiguousLetter, ///< after a symbol, where it may stand for a derivative: the p of "x_p" may also be the piston
    Filler,          ///< anywhere, says nothing: "of"
    OtherQuantity,   ///< anywhere, makes the name that of another quantity: "error", "force"
    Label            ///< before a letter that names a joint: "joint B"
};

struct WordMeaning {
    WordUse use = WordUse::Word;

    /// Separated by spaces, without accents and in lower case. Two or three words of a name are joined: "double_dot".
    std::string_view words{};

    std::optional<Dimension> dimension{};
    std::optional<Order> order{};
    std::optional<Body> body{};
    char axis = ' ';
    bool isCentre = false; ///< it denotes the centre of mass of a body
};

/// Returns the entry for `use` that contains the word; null if there is none.
const WordMeaning *findWord(std::string_view word, WordUse use);

/// Splits a name into runs of letters, runs of digits, and primes, in lower case and without accents. A capital letter
/// after a small one begins a word: "SliderPosition". Dots above a letter become primes: "ẍ" is x, ', '.
std::vector<std::string> wordsOf(std::string_view name);

/// Returns the `size` words from `at` on, joined as in the vocabulary: "double_dot", "pie_de_biela". Returns an empty
/// text if there are fewer words.
std::string phraseAt(const std::vector<std::string> &words, std::size_t at, std::size_t size);

/// Returns whether a word consists of digits, and is not empty.
bool isDigits(std::string_view word);

/// Returns whether the words name the time, as in "Elapsed time" or "sim_time".
bool isTime(const std::vector<std::string> &words);

/// Returns whether the words name the time of day, as a clock shows it.
bool isTimeOfDay(const std::vector<std::string> &words);

/// Returns the unit that a name for the speed of rotation implies: "rpm" for "Drehzahl", "rps" for "crank frequency".
/// Returns an empty text if the words contain no such name.
std::string_view unitOfRotation(const std::vector<std::string> &words);

/// Returns whether the words abbreviate how a quantity was found: "num.", "exp", "sim".
bool abbreviatesMethod(const std::vector<std::string> &words);

/// Returns whether the words say that finite differences were computed: "num. diff.", "finite differences", "FD".
bool namesDifferences(const std::vector<std::string> &words);

/// Returns whether the words name a statistic of the rows, such as a mean or maximum.
bool namesStatistic(const std::vector<std::string> &words);

/// Returns whether the words name the number of a row.
bool namesRowNumber(const std::vector<std::string> &words);

/// Returns whether a word says that the name is of a quantity that is no channel: "error", "force", "Messabweichung".
bool namesOtherQuantity(std::string_view word);

/// Returns whether the words name the time, a quantity or an axis, and not only a body.
bool namesQuantity(const std::vector<std::string> &words);

} // namespace slidercrank
