// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/name_reading.h"

#include <algorithm>

namespace slidercrank
{

namespace
{

using Words = std::vector<std::string>;
using Doubt = NameMeaning::Doubt;

/// Sets `known` to `value` if that is known. Returns false if a different value was known before.
template <typename Value>
bool merge(std::optional<Value> &known, const std::optional<Value> &value)
{
    const bool agrees = !known || !value || *known == *value;
    known = value ? value : known;
    return agrees;
}

/// Includes what an entry of the vocabulary says. Returns false if it contradicts the words before.
bool merge(NameReading &reading, const WordMeaning &entry)
{
    reading.order = std::max(reading.order, entry.order);
    reading.axis = entry.axis != ' ' ? entry.axis : reading.axis;
    reading.isCentre = reading.isCentre || entry.isCentre;
    return merge(reading.dimension, entry.dimension) && merge(reading.body, entry.body);
}

// The functions below include one more word, or a part of it, in what the words before it say, and return whether they
// could. A word that cannot be included is unknown or contradicts the words before; includeUnknown() tells which.

/// Which entries of the vocabulary a word may be.
enum class Entries {
    WithoutSymbols, ///< in the part of a path that only names the body: "x" is no position there
    All
};

/// Includes a number of a name. Returns false if it cannot belong to the quantity:
///
/// 1. Behind a word instead of a symbol, it only counts columns ("Linear Velocity1") and is skipped.
/// 2. Behind q, a generalized coordinate, it is the number of a point, whose body is unknown unless q is an angle.
/// 3. Behind another angle, it is the number of a link: 1 to 3, or any if the name also has a body.
/// 4. Behind a length, 4 is the slider, unless the name has another body.
/// 5. Behind a length, another number is that of an unknown point: 1 to 3.
bool includeNumber(NameReading &reading, std::string_view digits, Entries entries)
{
    if (!reading.hasSymbol || entries == Entries::WithoutSymbols) {
        return true;
    }
    reading.isBodyNamed = true;
    if (reading.symbol == "q") { // a generalized coordinate, which may be numbered from 0
        reading.isUnknownBody = reading.dimension != Dimension::Angle;
        reading.pointLetters = digits;
        return true;
    }
    if (reading.dimension == Dimension::Angle) {
        reading.link = digits;
        return isAmong(digits, "1 2 3") || reading.body;
    }
    if (digits == "4") {
        reading.pointLetters.clear(); // "x14", of link 4 to the frame 1
        return merge(reading.body, std::optional(Body::Slider));
    }
    reading.isUnknownBody = true;
    if (reading.axis != ' ' && !reading.body && isAmong(digits, "1 2 3")) {
        reading.pointLetters = digits; // "y3"
    }
    return isAmong(digits, "1 2 3");
}

/// Returns whether a symbol can stand for the quantity in the words before it, as in "velocity v", "velocity ṙ₁" or
/// "crank angle α".
bool suitsQuantityBefore(const WordMeaning &symbol, const NameReading &before)
{
    const std::optional<Order> order = before.order;
    const bool isAlpha = symbol.dimension == Dimension::Angle && symbol.order == Order::Acceleration;
    const bool isDerivative =
        order && symbol.order == Order::Position && before.derivatives == static_cast<int>(*order);
    return !order || !symbol.order || symbol.order == order || (isAlpha && order == Order::Position) || isDerivative;
}

/// Includes the letters of a point or of the ends of a link: the index of "x_s" and "ω_BC", the joint of "joint B" and
/// "velocity of B". Returns false if an index was included before, or if the letters contradict the words before.
bool includePoint(NameReading &reading, std::string_view letters)
{
    const WordMeaning *const index = findWord(letters, WordUse::Index);
    const bool isOfSlider = index && index->body == Body::Slider;
    const bool isPinOfAngle = isOfSlider && reading.dimension == Dimension::Angle; // θ_c, θ_b
    const bool isOtherPoint = !index || (letters.size() == 1 && !index->body);     // x_A, "joint D"
    const bool isBodyKnown = reading.body.has_value();                             // by words: "connecting rod ω_c"
    reading.isUnknownBody = reading.isUnknownBody || ((isPinOfAngle || isOtherPoint) && !isBodyKnown);
    if (reading.hasIndex) {
        return false;
    }
    reading.hasIndex = true;
    reading.pointLetters = letters;
    return !index || isPinOfAngle || merge(reading, *index);
}

/// Includes the joint after "at": "velocity at B" is that of the point B, but an angle, "θ3 at B", that of the coupler.
bool includeJointAfterAt(NameReading &reading, std::string_view joint)
{
    if (reading.dimension != Dimension::Angle) {
        return includePoint(reading, joint);
    }
    reading.isAtB = joint == "b";
    reading.isBodyNamed = true;
    return merge(reading.body, std::optional(Body::Coupler));
}

/// Returns whether the two words at `at` are "at A" or "at B".
bool isAtJoint(const Words &words, std::size_t at)
{
    return isAmong(words[at], "at en bei in an") && at + 1 < words.size() && isAmong(words[at + 1], "a b");
}

/// Returns whether the letter of a joint may follow a label: after "joint" and "velocity of", and after "x of" and "x
/// of point". Directly behind a symbol, as in "x punto B", a label that is no preposition marks a derivative, but not
/// in "position x punto B".
bool mayPrecedeJoint(const NameReading &before, std::string_view label)
{
    const bool isPreposition = isAmong(label, "of de del von du di do");
    return findWord(label, WordUse::Label) &&
           (!before.hasSymbol || before.expectsJoint || before.isOrderNamed || isPreposition);
}

/// Returns whether an index may belong to the symbol or quantity before it, as in "x_s", "velocity B" and "ω_BC", but
/// not in "xBp".
bool mayBeIndex(const NameReading &before, std::string_view index)
{
    const bool isOfLink = index.size() > 1 && before.dimension == Dimension::Angle;
    const bool mayFollow = before.hasSymbol || isOfLink || (before.order && isAmong(index, "b c"));
    return mayFollow && (index.size() == 1 || isOfLink);
}

/// Includes a symbol. A word before it, such as "velocity", decides the order.
bool includeSymbol(NameReading &reading, std::string_view word, WordMeaning symbol)
{
    reading.hasSymbol = true;
    reading.symbol = reading.order ? std::string_view() : word;
    symbol.order = reading.order ? reading.order : symbol.order;
    return merge(reading, symbol);
}

/// Includes an entry of the vocabulary. The first that applies: a number, a word, a joint behind a label, an index, a
/// filler, a label, an ambiguous letter, a symbol, a derivative. Returns false if the word is none of these after the
/// words before it, or contradicts them.
bool includeEntry(NameReading &reading, std::string_view word, Entries entries)
{
    if (isDigits(word)) {
        return includeNumber(reading, word, entries);
    }
    if (const WordMeaning *const entry = findWord(word, WordUse::Word)) {
        reading.expectsJoint = false;
        reading.isBodyNamed = reading.isBodyNamed || entry->body;
        reading.isOrderNamed = reading.isOrderNamed || entry->order;
        return merge(reading, *entry);
    }
    const bool isLabel = findWord(word, WordUse::Label);
    const bool followsLabel = reading.expectsJoint;
    reading.expectsJoint = mayPrecedeJoint(reading, word);
    if (followsLabel && word.size() == 1 && !isAmong(word, "x y")) {
        return includePoint(reading, word);
    }
    const bool isOfBody = entries == Entries::WithoutSymbols; // a part of a path that names the body
    const WordMeaning *const index = findWord(word, WordUse::Index);
    const bool isFrame = isOfBody && word == "a";                             // the frame_a of Modelica
    if (index && (followsLabel || (!isFrame && mayBeIndex(reading, word)))) { // "link BC angle", "ω_BC"
        return includePoint(reading, word);
    }
    if (const WordMeaning *const filler = findWord(word, WordUse::Filler)) {
        return merge(reading, *filler);
    }
    if (reading.expectsJoint || (isOfBody && (isLabel || isAmong(word, "px py pz")))) {
        return true; // "Crank_Joint.Rz.q", and the prismatic joint of "Slider Joint.Px.v"
    }
    if (!isOfBody && reading.hasSymbol && findWord(word, WordUse::AmbiguousLetter)) {
        reading.doubt = word == "p" ? Doubt::IsPistonsIndex : Doubt::IsDerivative;
        reading.pointLetters = word == "p" ? word : std::string_view(reading.pointLetters);
        return true;
    }
    const WordMeaning *const symbol = isOfBody ? nullptr : findWord(word, WordUse::Symbol);
    if (symbol && (symbol->axis != ' ' || (!reading.hasSymbol && suitsQuantityBefore(*symbol, reading)))) {
        return includeSymbol(reading, word, *symbol);
    }
    const WordMeaning *const derivative = findWord(word, WordUse::Derivative);
    reading.derivatives += derivative ? static_cast<int>(*derivative->order) : 0;
    return derivative;
}

/// Includes a known word with an ending, such as a plural or genitive: "pistonun". Returns false if no beginning of the
/// word is known, or if it contradicts the words before.
bool includeStem(NameReading &reading, std::string_view word)
{
    constexpr std::size_t kShortestStem = 5; // bytes
    constexpr std::size_t kLongestEnding = 3;
    const std::size_t shortest = std::max(kShortestStem, word.size() - std::min(word.size(), kLongestEnding));
    for (std::size_t size = word.size(); size-- > shortest;) {
        if (findWord(word.substr(0, size), WordUse::Word)) {
            return includeEntry(reading, word.substr(0, size), Entries::WithoutSymbols);
        }
    }
    return false;
}

/// Includes an entry that is a part of a longer word. Short fillers and labels cannot be parts: "end" is not "en" and
/// "d", and "joints" is not "joint S".
bool includePart(NameReading &reading, std::string_view part, Entries entries)
{
    constexpr std::size_t kShortestFiller = 4; // bytes
    const bool isShortFiller = part.size() < kShortestFiller && findWord(part, WordUse::Filler);
    reading.expectsJoint = false; // "piston pin VX" has no joint V
    return !isShortFiller && !findWord(part, WordUse::Label) && includeEntry(reading, part, entries);
}

bool includeCompound(NameReading &reading, std::string_view word, Entries entries);

/// Includes the rest of a compound, which is one part or a compound itself.
bool includeRest(NameReading &reading, std::string_view rest, Entries entries)
{
    NameReading extended = reading;
    if (includePart(extended, rest, entries)) {
        reading = extended;
        return true;
    }
    return includeCompound(reading, rest, entries);
}

/// Includes a compound of entries such as "kolbenweg", "crankangle" or "xdot"; the longest first part is tried first.
/// German puts an s or n between two words: "Kurbelwellenwinkel". Returns false if no division is known, or if all
/// contradict the words before.
bool includeCompound(NameReading &reading, std::string_view word, Entries entries)
{
    for (std::size_t end = word.size() - 1; end > 0; --end) {
        const std::string_view first = word.substr(0, end);
        const std::string_view rest = word.substr(end);
        const bool isDifferential = first == "d" && !reading.order && findWord(rest, WordUse::Symbol); // "dx"
        NameReading before = reading;
        if (!isDifferential && !includePart(before, first, entries)) {
            continue;
        }
        NameReading extended = before;
        if (includeRest(extended, rest, entries)) {
            reading = extended;
            reading.doubt = isDifferential ? Doubt::IsDerivative : reading.doubt;
            return true;
        }
        const bool mayBeJoined = rest.size() > 2 && (rest[0] == 's' || rest[0] == 'n');
        extended = before;
        if (mayBeJoined && findWord(first, WordUse::Word) && includeRest(extended, rest.substr(1), entries)) {
            reading = extended;
            return true;
        }
    }
    return false;
}

/// Includes one word: an entry of the vocabulary, a compound of several, or one with an ending. Returns false if it is
/// unknown or contradicts the words before.
bool includeWord(NameReading &reading, std::string_view word, Entries entries)
{
    NameReading extended = reading;
    if (includeEntry(extended, word, entries)) {
        reading = extended;
        return true;
    }
    return includeCompound(reading, word, entries) || includeStem(reading, word);
}

/// Includes a word that could not be included otherwise. Returns false if the vocabulary contains it (then it
/// contradicts the words before) or it names another quantity. Words of fewer than three bytes, and components such as
/// the BAn of "a_BAn" (index BA, normal), count as indices.
bool includeUnknown(NameReading &reading, std::string_view word)
{
    constexpr std::size_t kShortestWord = 3; // bytes: shorter ones are indices
    const bool isComponent = word.size() == kShortestWord && findWord(word.substr(0, 2), WordUse::Index) &&
                             (word.ends_with('n') || word.ends_with('t'));
    NameReading alone;
    const bool isKnown = word.size() >= kShortestWord && includeWord(alone, word, Entries::All);
    if (isKnown || namesOtherQuantity(word)) {
        return false;
    }
    reading.unknown.text += word;
    reading.unknown.hasWord = reading.unknown.hasWord || (word.size() >= kShortestWord && !isComponent);
    return true;
}

/// Returns whether the word at `at` is the number of a point after "joint" or an unknown word, as in "P1X", or the
/// letter of a point between an unknown word and the quantity, as in "mass_A x".
bool isNumberOfPoint(const NameReading &before, const Words &words, std::size_t at)
{
    if (at == 0) {
        return false;
    }
    const std::string &name = words[at - 1];
    const bool isAfterUnknown = before.unknown.text.ends_with(name);
    if (isDigits(words[at])) {
        const bool isAfterLabel = findWord(name, WordUse::Label) && !findWord(name, WordUse::Filler);
        return isAfterLabel || isAfterUnknown;
    }
    const bool mayBeLetter = words[at].size() == 1 && (words[at] == "a" || !findWord(words[at], WordUse::Symbol));
    const bool isLast = at + 1 == words.size(); // it is the symbol: "επιτάχυνση a"
    return mayBeLetter && !isLast && isAfterUnknown && before.unknown.hasWord;
}

/// Returns whether the two words at `at` only label a signal: "Channel A", or a letter with a number other than 1 to 4
/// (those are links) before words for the quantity, such as the S001 of "S001_Displacement_X".
bool isNameOfElement(const Words &words, std::size_t at)
{
    if (isAmong(words[at], "channel ch canal kanal") && at + 1 < words.size() && words[at + 1].size() == 1) {
        return true;
    }
    const bool isNumbered = words[at].size() == 1 && at + 2 < words.size() && isDigits(words[at + 1]);
    return isNumbered && !isAmong(words[at + 1], "1 2 3 4") &&
           namesQuantity(Words(words.begin() + static_cast<std::ptrdiff_t>(at) + 2, words.end()));
}

/// Returns whether the digits at `at` only count columns, as in "Linear Velocity1" and "X Component1": they are behind
/// a word, and not behind a symbol.
bool countsColumns(const Words &words, std::size_t at)
{
    return at > 0 && isDigits(words[at]) &&
           (findWord(words[at - 1], WordUse::Word) || findWord(words[at - 1], WordUse::Filler));
}

/// Returns whether the word at `at` is "by" between other words, as in "distance moved by the slider" and "x by ruler",
/// or the French "par". At the end of a name, as in "v_By", it is the y of point B; at the beginning, "par" is the
/// Spanish word for torque.
bool isBy(const Words &words, std::size_t at)
{
    return at > 0 && at + 1 < words.size() && isAmong(words[at], "by par");
}

/// Returns how many words from `at` on are one entry of the vocabulary, as "link 3", "O2", "r1" and "pie de biela" are;
/// 1 if only the first one may be.
std::size_t sizeOfPhrase(const Words &words, std::size_t at, Entries entries)
{
    constexpr std::size_t kMaxWords = 3;
    for (std::size_t size = kMaxWords; size > 1; --size) {
        const std::string phrase = phraseAt(words, at, size);
        if (findWord(phrase, WordUse::Word) || findWord(phrase, WordUse::Filler) ||
            (entries == Entries::All && findWord(phrase, WordUse::Symbol))) {
            return size;
        }
    }
    return 1;
}

/// Includes the words of one part of a path. Returns false if they contradict each other or the parts behind.
bool includeWords(NameReading &reading, const Words &words, Entries entries)
{
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (countsColumns(words, i) || isBy(words, i)) {
            continue;
        }
        const std::size_t size = sizeOfPhrase(words, i, entries);
        bool isIncluded = true;
        if (isNameOfElement(words, i)) {
            reading.unknown.point = words[i] + words[i + 1];
            ++i;
        } else if (isAtJoint(words, i)) {
            isIncluded = includeJointAfterAt(reading, words[++i]);
        } else if (isNumberOfPoint(reading, words, i)) {
            reading.unknown.point = reading.unknown.point.empty() ? words[i - 1] + words[i] : reading.unknown.point;
        } else if (includeWord(reading, phraseAt(words, i, size), entries)) {
            i += size - 1;
        } else {
            isIncluded = includeUnknown(reading, words[i]);
        }
        if (!isIncluded) {
            return false;
        }
    }
    return true;
}

/// Sets the body whose angle the number of a link denotes: 1 is the frame, 2 the crank and 3 the coupler. A word for
/// the body has priority over the number: in "coupler angle φ2", the links are numbered from the crank.
void setBodyOfLink(NameReading &reading)
{
    if (reading.body || reading.link.empty()) {
        return;
    }
    reading.isBodyNumbered = true;
    reading.isFrame = reading.link == "1";
    if (reading.link == "2") {
        reading.body = Body::Crank;
    } else if (reading.link == "3") {
        reading.body = Body::Coupler;
    }
}

/// Sets the dimension, if it is unknown, to that of the body: the crank has an angle and the slider a length, but the
/// coupler and a centre of mass have both.
void setDimensionOfBody(NameReading &reading)
{
    if (!reading.dimension && reading.body && reading.body != Body::Coupler && !reading.isCentre) {
        reading.dimension = reading.body == Body::Crank ? Dimension::Angle : Dimension::Length;
    }
}

} // namespace

std::optional<NameReading> readName(const NamePath &path, int derivatives, const Words &lastWords)
{
    NameReading reading{.derivatives = derivatives};
    for (std::size_t i = path.parts.size(); i-- > 0;) {
        const bool isLast = i + 1 == path.parts.size();
        const Words words = isLast ? lastWords : wordsOf(path.parts[i]);
        NameReading extended = reading;
        if (includeWords(extended, words, isLast ? Entries::All : Entries::WithoutSymbols)) {
            const bool mayNameModel = !isLast && (path.isOfModelica || reading.body); // "Model1.slider.x"
            if (mayNameModel) { // then its unknown words say nothing
                extended.unknown = reading.unknown;
            }
            reading = extended;
        } else if (isLast) {
            return std::nullopt;
        }
    }
    setBodyOfLink(reading);
    setDimensionOfBody(reading);
    return reading;
}

} // namespace slidercrank
