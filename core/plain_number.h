// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The numbers that fill most files, "-1139.910000", in one pass over their digits: the value, and where the digits
// stand. In the header: it is called for every cell of a large file.
//
// Source of the exactness: W. D. Clinger, "How to read floating point numbers accurately", 1990: an integer below 2^53
// divided by a power of ten up to 10^22 is rounded once, as the nearest double is.

#include "core/rounding.h"

#include <array>
#include <bit>
#include <cstdint>
#include <string_view>

namespace slidercrank
{

struct PlainNumber {
    double value = 0.0;
    PrintedPlaces places;
    std::string_view digits; ///< as printed, with its sign
};

/// Behind the number that stands at `begin`, or null where there is none of this kind: an optional "-", digits, and
/// then perhaps a point and digits; below 2^53 without the point.
inline const char *scanPlainNumber(const char *begin, const char *end, PlainNumber &number)
{
    constexpr std::array<double, 20> kPowers{1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,
                                             1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19};
    constexpr std::ptrdiff_t kMostDigits = 19; // any 19 digits fit 64 bits
    const auto digitAt = [](const char *c) { return static_cast<unsigned>(static_cast<unsigned char>(*c)) - '0'; };

    const char *c = begin;
    const bool negative = c != end && *c == '-';
    c += negative ? 1 : 0;
    const char *const first = c;
    std::uint64_t all = 0;
    for (; c != end && digitAt(c) < 10; ++c) {
        all = all * 10 + digitAt(c);
    }
    std::ptrdiff_t count = c - first;
    if (count == 0) {
        return nullptr;
    }
    std::ptrdiff_t decimals = 0;
    if (c != end && *c == '.') {
        const char *const point = c++;
        for (; c != end && digitAt(c) < 10; ++c) {
            all = all * 10 + digitAt(c);
        }
        decimals = c - point - 1;
        count += decimals;
    }
    if (count > kMostDigits || all >= (std::uint64_t{1} << 53U)) {
        return nullptr;
    }
    const double magnitude = static_cast<double>(all) / kPowers[static_cast<std::size_t>(decimals)];
    number.value = negative ? -magnitude : magnitude;
    number.digits = {begin, static_cast<std::size_t>(c - begin)};
    number.places.printed = -static_cast<int>(decimals);
    number.places.zero = all == 0;
    if (all != 0) {
        const char *leading = first;
        while (*leading == '0' || *leading == '.') {
            ++leading;
        }
        const char *trailing = c;
        while (trailing[-1] == '0' || trailing[-1] == '.') {
            --trailing;
        }
        const char *const point = c - decimals - (decimals > 0 || c[-1] == '.' ? 1 : 0);
        const auto placeOf = [point](const char *digit) {
            return static_cast<int>(digit < point ? point - digit - 1 : point - digit);
        };
        number.places.first = placeOf(leading);
        number.places.last = placeOf(trailing - 1);
    }
    return c;
}

} // namespace slidercrank
