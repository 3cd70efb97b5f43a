// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// std::from_chars() for doubles. Where the standard library has it for integers only, as libc++ before version 20,
// fast_float reads the same numbers.

#include <charconv>
#include <version>

#ifndef __cpp_lib_to_chars
#include <fast_float/fast_float.h>
#endif

namespace slidercrank
{

#ifdef __cpp_lib_to_chars

/// Reads a number with an optional exponent.
inline std::from_chars_result readDouble(const char *first, const char *last, double &value)
{
    return std::from_chars(first, last, value);
}

/// Reads a number up to its exponent.
inline std::from_chars_result readFixed(const char *first, const char *last, double &value)
{
    return std::from_chars(first, last, value, std::chars_format::fixed);
}

#else

inline fast_float::from_chars_result readDouble(const char *first, const char *last, double &value)
{
    return fast_float::from_chars(first, last, value);
}

inline fast_float::from_chars_result readFixed(const char *first, const char *last, double &value)
{
    return fast_float::from_chars(first, last, value, fast_float::chars_format::fixed);
}

#endif

} // namespace slidercrank
