// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The numbers that fill most files, "-1139.910000", in one pass over their digits: the value, and where the digits
// stand. In the header: it is called for every cell of a large file. Up to eight digits are read at once, as one word,
// because how many there are varies from number to number, and a processor guesses each end of a loop wrong.
//
// Sources: W. D. Clinger, "How to read floating point numbers accurately", 1990: an integer below 2^53 divided by a
// power of ten up to 10^22 is rounded once, as the nearest double is. L. Lamport, "Multiple byte processing with
// full-word instructions", CACM 18 (1975): arithmetic on the bytes of a word.

#include "core/import/rounding.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace slidercrank
{

struct PlainNumber {
    double value = 0.0;
    PrintedPlaces places;
    std::string_view digits; ///< as printed, with its sign
};

/// A run of digits.
struct DigitRun {
    std::int64_t value = 0;
    int count = 0;
    int leadingZeros = 0;  ///< of a value that is not zero
    int trailingZeros = 0; ///< of a value that is not zero
};

/// The digits at `c`, at most 18 of them: more do not fit, and the count is then 19.
inline DigitRun readDigits(const char *c, const char *end)
{
    constexpr int kMostDigits = 18;
    constexpr std::ptrdiff_t kWord = sizeof(std::uint64_t);
    DigitRun run;
    if (std::endian::native == std::endian::little && end - c >= kWord) {
        std::uint64_t word = 0;
        std::memcpy(&word, c, sizeof word);
        const std::uint64_t digits = word ^ 0x3030303030303030U; // each byte 0 to 9, where it is a digit
        const std::uint64_t others = (digits | (digits + 0x0606060606060606U)) & 0xF0F0F0F0F0F0F0F0U;
        // A carry out of a byte that is no digit can only spoil those behind it.
        if (others != 0) {
            run.count = std::countr_zero(others) / 8;
            if (run.count == 0) {
                return run;
            }
            // Zeros in front of the digits, the last one in the highest byte; then pairs, fours, eights.
            const std::uint64_t aligned = digits << (64 - 8 * run.count);
            run.trailingZeros = std::countl_zero(aligned) / 8;
            run.leadingZeros = std::countr_zero(aligned) / 8 - (8 - run.count);
            const std::uint64_t pairs = (aligned * 10 + (aligned >> 8U)) & 0x00FF00FF00FF00FFU;
            const std::uint64_t fours = (pairs * 100 + (pairs >> 16U)) & 0x0000FFFF0000FFFFU;
            run.value = static_cast<std::int64_t>((fours * 10000 + (fours >> 32U)) & 0xFFFFFFFFU);
            return run;
        }
    }
    for (; c != end && *c >= '0' && *c <= '9'; ++c) {
        if (++run.count > kMostDigits) {
            break;
        }
        run.value = run.value * 10 + (*c - '0');
        run.leadingZeros += run.value == 0 ? 1 : 0;
        run.trailingZeros = *c == '0' ? run.trailingZeros + 1 : 0;
    }
    return run;
}

/// Behind the number that stands at `begin`, or null where there is none of this kind: an optional "-", digits, and
/// then perhaps a point and digits; below 2^53 without the point.
inline const char *scanPlainNumber(const char *begin, const char *end, PlainNumber &number)
{
    constexpr int kMostDigits = 18; // so many fit 64 bits however they are put together
    constexpr auto kPowers = [] {
        std::array<std::int64_t, kMostDigits + 1> powers{1};
        for (std::size_t i = 1; i < powers.size(); ++i) {
            powers[i] = powers[i - 1] * 10;
        }
        return powers;
    }();
    constexpr auto kDivisors = [kPowers] {
        std::array<double, kMostDigits + 1> divisors{};
        for (std::size_t i = 0; i < divisors.size(); ++i) {
            divisors[i] = static_cast<double>(kPowers[i]);
        }
        return divisors;
    }();

    const char *c = begin;
    const bool negative = c != end && *c == '-';
    c += negative ? 1 : 0;
    const DigitRun whole = readDigits(c, end);
    c += whole.count;
    DigitRun decimals;
    if (c != end && *c == '.') {
        decimals = readDigits(++c, end);
        c += decimals.count;
    }
    if (whole.count == 0 || whole.count + decimals.count > kMostDigits) {
        return nullptr;
    }
    const auto places = static_cast<std::size_t>(decimals.count);
    const std::int64_t all = whole.value * kPowers[places] + decimals.value;
    if (all >= std::int64_t{1} << 53) {
        return nullptr;
    }
    const double magnitude = static_cast<double>(all) / kDivisors[places];
    number.value = std::copysign(magnitude, negative ? -1.0 : 1.0);
    number.digits = {begin, static_cast<std::size_t>(c - begin)};
    number.places.zero = all == 0;
    number.places.printed = -decimals.count;
    number.places.first = whole.value != 0 ? whole.count - 1 - whole.leadingZeros : -1 - decimals.leadingZeros;
    number.places.last = decimals.value != 0 ? decimals.trailingZeros - decimals.count : whole.trailingZeros;
    return c;
}

} // namespace slidercrank
