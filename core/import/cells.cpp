// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/cells.h"

#include "core/import/read_double.h"
#include "core/import/spellings.h"
#include "core/import/unit_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace slidercrank
{

namespace
{

constexpr std::string_view kTextsOfGaps =
    "nan -nan na n/a n.a. null none - -- --- – — | #n/a #nv #div/0! #num! #value! #wert! "
    "#ref! #bezug! 1.#qnan -1.#ind 1.#ind 1.#ind00 -1.#ind00";

constexpr char kApostrophe = '\'';

/// Minus signs, the powers of ten, the characters that only separate thousands, and the mark of formulas in LaTeX, with
/// their plain spelling.
const Spellings kNumberSpellings{{"\u2212", "-"}, {"\u2010", "-"}, {"\u2011", "-"}, {"\u2013", "-"}, {"\u2019", "'"},
                                 {" ", "'"},      {"\u00A0", "'"}, {"\u2009", "'"}, {"\u202F", "'"}, {"D", "e"},
                                 {"d", "e"},      {"×10", "e"},    {"·10", "e"},    {"⋅10", "e"},    {"*10^", "e"},
                                 {"*^", "e"},     {"$", ""}};

/// Returns a number with "-" as the minus sign, the letter e before its exponent, and apostrophes for blanks.
std::string withPlainSpelling(std::string_view number)
{
    std::string plain = kNumberSpellings.replacedIn(number);
    if (const std::size_t exponent = plain.find('e'); exponent != plain.npos) {
        std::string power = withCarets(plain.substr(exponent));
        std::erase(power, '^');
        plain.replace(exponent, plain.npos, power);
    }
    return plain;
}

/// Returns the places of the digits of a number that is printed as `digits`, possibly with a sign and a point, times
/// 10^exponent.
PrintedPlaces placesOf(std::string_view digits, double exponent)
{
    constexpr double kLargestExponent = 1e5; // beyond any double, so that no sum overflows
    const auto isNonZeroDigit = [](char c) { return c >= '1' && c <= '9'; };
    const auto first = std::ranges::find_if(digits, isNonZeroDigit);
    const auto last = std::find_if(digits.rbegin(), digits.rend(), isNonZeroDigit);
    const auto point = static_cast<std::ptrdiff_t>(std::min(digits.find('.'), digits.size()));
    const int placeAbove = // one more than the place of the first character
        static_cast<int>(std::clamp(exponent, -kLargestExponent, kLargestExponent) + static_cast<double>(point));
    const auto placeAt = [&](std::ptrdiff_t at) { // the point itself has no place
        return placeAbove - static_cast<int>(at) - (at < point ? 1 : 0);
    };
    return {.isZero = first == digits.end(),
            .firstNonZero = placeAt(first - digits.begin()),
            .lastNonZero = placeAt(digits.rend() - last - 1),
            .lastPrinted = placeAt(std::ssize(digits) - 1)};
}

/// Parses an optional minus sign, digits with at most one point, and an optional exponent. Other texts have the fault
/// NotANumber.
CellNumber parsePlain(std::string_view text)
{
    CellNumber number;
    const char *const end = text.data() + text.size();
    double value = 0.0;
    double exponent = 0.0;
    auto parsed = readFixed(text.data(), end, value);
    const std::string_view digits(text.data(), parsed.ptr); // with sign and point
    if (!digits.empty() && parsed.ptr != end) {
        const std::string_view power = text.substr(digits.size() + 1);
        readDouble(power.data() + (power.starts_with('+') ? 1 : 0), end, exponent);
        value = 0.0; // not changed by a number that is too small
        parsed = readDouble(text.data(), end, value);
    }
    if (parsed.ptr != end || parsed.ec == std::errc::invalid_argument || !std::isfinite(value)) {
        number.fault = RowFault::NotANumber;
        return number;
    }
    number.places = placesOf(digits, exponent);
    if (parsed.ec == std::errc::result_out_of_range && number.places.firstNonZero > 0) {
        number.fault = RowFault::TooLarge;
    } else {
        number.value = value;
    }
    return number;
}

bool beginsWithSign(std::string_view text)
{
    return text.starts_with('-') || text.starts_with('+');
}

/// A number, split. The magnitude is in plain spelling, and empty if the text is no number.
struct SignAndMagnitude {
    bool isNegative = false;
    std::string magnitude{};
};

/// Splits a number with a decimal point into its sign and its magnitude, without the blanks around them (apostrophes in
/// plain spelling). Accountants write a negative number in brackets. Two signs, and a sign in brackets, are no number.
SignAndMagnitude splitSign(std::string_view text)
{
    const bool isBracketed = text.starts_with('(') && text.ends_with(')');
    std::string plain = withPlainSpelling(isBracketed ? text.substr(1, text.size() - 2) : text);
    plain.erase(plain.find_last_not_of(kApostrophe) + 1);
    plain.erase(0, plain.find_first_not_of(kApostrophe));
    const bool isSigned = beginsWithSign(plain);
    const bool isNegative = plain.starts_with('-') || isBracketed;
    plain.erase(0, isSigned ? plain.find_first_not_of(kApostrophe, 1) : 0);
    return beginsWithSign(plain) || (isSigned && isBracketed) ? SignAndMagnitude()
                                                              : SignAndMagnitude{isNegative, plain};
}

/// Returns a magnitude in plain spelling without the apostrophes or commas between its thousands. Returns an empty text
/// if they are at other places, or if a single comma without a point behind it may also be the decimal sign.
std::string withoutThousands(const std::string &magnitude)
{
    const std::string whole = magnitude.substr(0, magnitude.find('.'));
    const char separator = whole.find(kApostrophe) != whole.npos ? kApostrophe : ',';
    std::string digits = whole;
    const std::size_t separators = std::erase(digits, separator);
    std::string grouped = digits;
    for (std::size_t end = digits.size(); end > 3; end -= 3) {
        grouped.insert(end - 3, 1, separator);
    }
    const bool hasDecimals = whole.size() < magnitude.size();
    const bool isClear = separators > 1 || separator == kApostrophe || hasDecimals;
    const bool isGrouped = grouped == whole && isClear && !digits.starts_with('0');
    return separators == 0 || isGrouped ? digits + magnitude.substr(whole.size()) : std::string();
}

/// Parses a number with a decimal point that may have a plus sign, blanks behind its sign, thousands separators, or
/// brackets instead of a minus sign.
CellNumber parseSeparated(std::string_view text)
{
    const SignAndMagnitude split = splitSign(text);
    return parsePlain((split.isNegative ? "-" : "") + withoutThousands(split.magnitude));
}

/// Returns the text with points for commas and commas for points, so that the decimal sign is a point.
std::string withPointsAndCommasExchanged(std::string_view text)
{
    std::string exchanged(text);
    for (char &c : exchanged) {
        if (c == ',' || c == '.') {
            c = c == ',' ? '.' : ',';
        }
    }
    return exchanged;
}

/// Returns the text without what a program wrote around the number in it: ="0.5" of spreadsheets, \num{0.5} of LaTeX,
/// np.float64(0.5) of NumPy.
std::string_view withoutMarkup(std::string_view text)
{
    using Marks = std::pair<std::string_view, std::string_view>;
    for (const auto &[before, after] : {Marks{"=\"", "\""}, Marks{"\\num{", "}"}, Marks{"np.float64(", ")"}}) {
        if (text.size() > before.size() && text.starts_with(before) && text.ends_with(after)) {
            return text.substr(before.size(), text.size() - before.size() - after.size());
        }
    }
    return text;
}

/// Returns the value of a multiple of π, "π", "-π/6", "3π/4", "0.5*pi" or "2 π / 3"; nullopt for another text.
std::optional<double> multipleOfPi(std::string_view text)
{
    static const Spellings kPlainSpellings{{"\\pi", "π"}, {"pi", "π"}, {"\u2212", "-"},
                                           {"*", ""},     {"·", ""},   {" ", ""}};
    const std::string plain = kPlainSpellings.replacedIn(text);
    const std::size_t at = plain.find("π");
    if (at == plain.npos) {
        return std::nullopt;
    }
    const auto numberIn = [](const std::string &part) { // 1 where none is printed
        return part.empty() ? CellNumber{.value = 1.0} : parsePlain(part);
    };
    const bool isNegative = plain.starts_with('-');
    const std::string after = plain.substr(at + std::string_view("π").size());
    const CellNumber factor = numberIn(plain.substr(isNegative ? 1 : 0, at - (isNegative ? 1 : 0)));
    const CellNumber divisor = numberIn(after.substr(after.starts_with('/') ? 1 : 0));
    const bool isQuotient = after.empty() || (after.starts_with('/') && after.size() > 1);
    if (!isQuotient || factor.fault || divisor.fault || !(divisor.value > 0.0)) {
        return std::nullopt;
    }
    return (isNegative ? -1.0 : 1.0) * factor.value * std::numbers::pi / divisor.value;
}

/// Returns the place of the first digit of a number; 0 for zero.
int firstPlaceOf(double value)
{
    return value == 0.0 ? 0 : static_cast<int>(std::floor(std::log10(std::abs(value))));
}

/// Returns the places of the digits of a computed number: as many as a double has.
PrintedPlaces placesOfDouble(double value)
{
    constexpr int kDigits = 17;
    const int last = firstPlaceOf(value) - kDigits + 1;
    return {.isZero = value == 0.0, .firstNonZero = firstPlaceOf(value), .lastNonZero = last, .lastPrinted = last};
}

/// Parses an angle in degrees, minutes and seconds: 45°30'15", 45° 30.25', -3°07′. The minutes may be missing, as in
/// the "45°" of a column in which other angles have them. Its last place is the power of ten of a degree next above the
/// last digit of the minutes or seconds, because a rounding step is a power of ten.
CellNumber parseDegreesAndMinutes(std::string_view text)
{
    static const Spellings kMarks{{"°", ":"}, {"º", ":"}, {"''", ""}, {"\"", ""}, {"″", ""},  {"”", ""},
                                  {"'", ":"}, {"′", ":"}, {"’", ":"}, {" ", ""},  {"–", "-"}, {"\u2212", "-"}};
    constexpr double kPerUnit = 60.0; // minutes per degree, seconds per minute
    constexpr int kMaxParts = 3;
    const CellNumber refused{.fault = RowFault::NotANumber};
    if (text.find("°") == text.npos && text.find("º") == text.npos) {
        return refused;
    }
    const std::string plain = kMarks.replacedIn(text);
    const bool isNegative = plain.starts_with('-');
    std::string_view rest = std::string_view(plain).substr(isNegative ? 1 : 0);
    double degrees = 0.0;
    double unit = 1.0;         // °: the size of the unit of the next part
    double roundingStep = 1.0; // °: of the last part
    for (int part = 0; !rest.empty(); ++part) {
        const CellNumber number = parsePlain(takeUntil(':', rest));
        const bool isTooLarge = part > 0 && number.value > kPerUnit;
        if (part == kMaxParts || number.fault || number.value < 0.0 || isTooLarge) {
            return refused;
        }
        degrees += unit * number.value;
        roundingStep = unit * powerOfTen(number.places.lastPrinted);
        unit /= kPerUnit;
    }
    const int place = static_cast<int>(std::ceil(std::log10(roundingStep)));
    return {.value = isNegative ? -degrees : degrees,
            .places = {.isZero = degrees == 0.0,
                       .firstNonZero = firstPlaceOf(degrees),
                       .lastNonZero = place,
                       .lastPrinted = place},
            .unit = "deg"};
}

/// Returns where the quotation mark at `opening` is closed, or the size of the text if it is not. A doubled mark is a
/// part of the quotation.
std::size_t findClosingMark(std::string_view text, std::size_t opening)
{
    std::size_t at = text.find('"', opening + 1);
    while (at != text.npos && text.substr(at + 1).starts_with('"')) {
        at = text.find('"', at + 2);
    }
    return std::min(at, text.size());
}

} // namespace

std::string_view trimmed(std::string_view text)
{
    while (!text.empty() && isBlank(text.front())) {
        text.remove_prefix(1);
    }
    while (!text.empty() && isBlank(text.back())) {
        text.remove_suffix(1);
    }
    return text;
}

std::string_view takeCell(std::string_view &rest, char delimiter)
{
    const bool bySpaces = delimiter == ' ';
    const char otherDelimiter = bySpaces ? '\t' : delimiter; // any blank ends a cell between spaces
    const std::size_t size = rest.size();
    std::size_t begin = 0;
    while (begin < size && isBlank(rest[begin]) && (bySpaces || rest[begin] != delimiter)) {
        ++begin;
    }
    const bool isQuoted = begin < size && rest[begin] == '"';
    const std::size_t closing = isQuoted ? findClosingMark(rest, begin) : begin;
    std::size_t end = closing;
    while (end < size && rest[end] != delimiter && rest[end] != otherDelimiter) {
        ++end;
    }
    std::string_view text = trimmed(rest.substr(begin, end - begin));
    if (isQuoted && text.size() == closing + 1 - begin) {
        text = trimmed(text.substr(1, text.size() - 2));
    }
    const bool isLast = end == size || (bySpaces && trimmed(rest.substr(end)).empty());
    rest = isLast ? std::string_view() : rest.substr(end + 1);
    return text;
}

Cells splitCells(std::string_view line, char delimiter)
{
    Cells cells;
    std::string_view rest = line;
    do {
        cells.push_back(takeCell(rest, delimiter));
    } while (rest.data() != nullptr);
    while (!cells.empty() && cells.back().empty()) {
        cells.pop_back();
    }
    return cells;
}

Cells splitBehindBrackets(std::string_view line)
{
    Cells cells;
    std::string_view rest = trimmed(line);
    while (!rest.empty()) {
        std::size_t end = rest.find_first_of(")]");
        while (end < rest.size() && end + 1 < rest.size() && !isBlank(rest[end + 1])) { // "x(t) (mm)", "(m/(s))"
            end = rest.find_first_of(")]", end + 1);
        }
        end = std::min(end, rest.size() - 1);
        cells.push_back(rest.substr(0, end + 1));
        rest = trimmed(rest.substr(end + 1));
    }
    return cells;
}

Cells splitAtBlanks(std::string_view line, std::size_t minBlanks)
{
    Cells cells;
    std::size_t blanks = 0;
    int depth = 0;
    for (const char &c : trimmed(line)) {
        if (isBlank(c)) {
            ++blanks;
            continue;
        }
        const bool opens = c == '(' || c == '[';
        if (cells.empty() || (blanks >= minBlanks && depth == 0 && !opens)) {
            cells.push_back({&c, 1});
        }
        cells.back() = {cells.back().data(), &c + 1}; // extended up to this character
        const bool closes = c == ')' || c == ']';
        depth += (opens ? 1 : 0) - (closes ? 1 : 0);
        blanks = 0;
    }
    return cells;
}

std::string_view textInBrackets(std::string_view cell)
{
    const bool isBracketed =
        cell.size() > 2 && (cell[0] == '[' || cell[0] == '(') && (cell.back() == ']' || cell.back() == ')');
    return isBracketed ? trimmed(cell.substr(1, cell.size() - 2)) : std::string_view();
}

CellNumber parseNumber(std::string_view text, DecimalSign decimalSign)
{
    std::string exchanged;
    if (decimalSign == DecimalSign::Comma) {
        text = exchanged = withPointsAndCommasExchanged(text);
    }
    CellNumber number = parsePlain(text);
    if (number.fault != RowFault::NotANumber) {
        return number;
    }
    if (text.empty() || isAmong(lowered(text), kTextsOfGaps)) {
        number.fault.reset();
        return number;
    }
    if (const std::string_view inner = withoutMarkup(text); inner.size() < text.size()) {
        return parseNumber(inner, DecimalSign::Point); // a decimal comma has become a point above
    }
    if (const std::optional<double> multiple = multipleOfPi(text)) {
        return {.value = *multiple, .places = placesOfDouble(*multiple), .unit = "rad"};
    }
    if (const CellNumber angle = parseDegreesAndMinutes(text); !angle.fault) {
        return angle;
    }
    if (const std::size_t end = text.find("±"); end != 0 && end != text.npos) {
        return parseNumber(trimmed(text.substr(0, end)), DecimalSign::Point);
    }
    number = parseSeparated(text);
    if (number.fault == RowFault::NotANumber && looksNumeric(text) && text.find(',') != text.npos) {
        number.fault = decimalSign == DecimalSign::Comma ? RowFault::PointForComma : RowFault::CommaForPoint;
    }
    return number;
}

CellNumber parseClock(std::string_view text)
{
    constexpr double kPerUnit = 60.0; // seconds a minute, minutes an hour
    text.remove_prefix(text.substr(0, text.find(':')).find_last_not_of("0123456789") + 1); // the date
    std::string time(text.substr(0, text.find_first_not_of("0123456789:.,")));             // without the time zone
    std::ranges::replace(time, ',', '.');
    std::string_view rest = time;
    const auto colons = std::ranges::count(rest, ':');
    CellNumber number{.fault = RowFault::NotANumber};
    if (colons == 2 || (colons == 1 && rest.find('.') != rest.npos)) {
        double sum = 0.0;
        while (!rest.empty()) {
            number = parseNumber(takeUntil(':', rest), DecimalSign::Point);
            sum = kPerUnit * sum + number.value;
        }
        number.value = sum;
        number.fault = std::isfinite(sum) ? number.fault : RowFault::NotANumber;
    }
    return number;
}

bool looksNumeric(std::string_view text)
{
    const std::string plain = withPlainSpelling(withoutMarkup(text));
    const bool areDigits = std::ranges::any_of(plain, isDigit) && !plain.starts_with('e') &&
                           plain.find_first_not_of("0123456789+-.,eE'") == plain.npos;
    return areDigits || multipleOfPi(text) || !parseDegreesAndMinutes(text).fault;
}

NumberWithUnit splitUnit(std::string_view text)
{
    constexpr std::string_view kBlanks = " \t";
    constexpr std::string_view kLetters = // the last two are the first bytes of ° and µ, and of μ
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ\xC2\xCE";
    for (const std::string_view beginnings : {kBlanks, kLetters}) {
        const std::size_t at = text.find_first_of(beginnings);
        const std::string_view unit = at == text.npos ? std::string_view() : trimmed(text.substr(at));
        if (!unit.empty() && looksNumeric(text.substr(0, at)) && parseUnit(unit)) {
            return {text.substr(0, at), unit};
        }
    }
    return {text};
}

std::string excerpt(std::string_view text)
{
    constexpr std::size_t kMaxSize = 40; // bytes
    if (text.size() <= kMaxSize) {
        return std::string(text);
    }
    std::size_t length = kMaxSize;
    while (length > 0 && (byteOf(text[length]) & 0xC0U) == 0x80U) { // within a character
        --length;
    }
    return std::string(text.substr(0, length)) + "…";
}

} // namespace slidercrank
