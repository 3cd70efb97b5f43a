// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The words of enumerators in scenes and on the command line. EnumWords<Enum> is the only list of them.

#include "core/mechanism/mechanism.h"
#include "core/newton/newton_options.h"
#include "core/sampling/trajectory.h"
#include "ui/text/enum_table.h"
#include "ui/text/notation.h"

#include <QStringList>

#include <array>
#include <cstddef>
#include <iterator>
#include <string_view>
#include <utility>

namespace slidercrank
{

template <typename Enum>
struct EnumWord {
    Enum key;
    const char *word;
};

/// Specialized for each enumeration whose enumerators have words. `rows` is a complete table (enum_table.h).
template <typename Enum>
struct EnumWords;

template <>
struct EnumWords<Branch> {
    static constexpr EnumWord<Branch> rows[] = {{Branch::Open, "open"}, {Branch::Crossed, "crossed"}};
    static_assert(isCompleteTable(rows, Branch::Crossed));
};

template <>
struct EnumWords<Method> {
    static constexpr EnumWord<Method> rows[] = {{Method::Newton, "newton"}, {Method::ClosedForm, "closed-form"}};
    static_assert(isCompleteTable(rows, Method::ClosedForm));
};

template <>
struct EnumWords<ToleranceKind> {
    static constexpr EnumWord<ToleranceKind> rows[] = {{ToleranceKind::Absolute, "absolute"},
                                                       {ToleranceKind::Relative, "relative"}};
    static_assert(isCompleteTable(rows, ToleranceKind::Relative));
};

template <>
struct EnumWords<WarmStart> {
    static constexpr EnumWord<WarmStart> rows[] = {{WarmStart::Previous, "previous"}, {WarmStart::Taylor, "taylor"}};
    static_assert(isCompleteTable(rows, WarmStart::Taylor));
};

template <>
struct EnumWords<Elimination> {
    static constexpr EnumWord<Elimination> rows[] = {{Elimination::Dense, "dense"},
                                                     {Elimination::Structured, "structured"}};
    static_assert(isCompleteTable(rows, Elimination::Structured));
};

template <>
struct EnumWords<Symbols> {
    static constexpr EnumWord<Symbols> rows[] = {{Symbols::AbsoluteCoordinates, "absolute"},
                                                 {Symbols::Textbook, "textbook"}};
    static_assert(isCompleteTable(rows, Symbols::Textbook));
};

template <>
struct EnumWords<CrankSpeedUnit> {
    static constexpr EnumWord<CrankSpeedUnit> rows[] = {{CrankSpeedUnit::RadianPerSecond, "rad/s"},
                                                        {CrankSpeedUnit::DegreePerSecond, "deg/s"},
                                                        {CrankSpeedUnit::TurnPerMinute, "rpm"}};
    static_assert(isCompleteTable(rows, CrankSpeedUnit::TurnPerMinute));
};

template <>
struct EnumWords<LengthUnit> {
    static constexpr EnumWord<LengthUnit> rows[] = {{LengthUnit::Millimetre, "mm"},
                                                    {LengthUnit::Centimetre, "cm"},
                                                    {LengthUnit::Metre, "m"},
                                                    {LengthUnit::Inch, "in"}};
    static_assert(isCompleteTable(rows, LengthUnit::Inch));
};

template <>
struct EnumWords<AngleUnit> {
    static constexpr EnumWord<AngleUnit> rows[] = {
        {AngleUnit::Degree, "deg"}, {AngleUnit::Radian, "rad"}, {AngleUnit::DegreeAndRadianPerSecond, "deg-rad/s"}};
    static_assert(isCompleteTable(rows, AngleUnit::DegreeAndRadianPerSecond));
};

/// Returns the word of an enumerator.
template <typename Enum>
constexpr const char *wordFor(Enum key)
{
    return rowOf(EnumWords<Enum>::rows, key).word;
}

/// Returns the words of the enumerators, separated by "|", with a null character at the end.
template <auto... keys>
consteval auto joinWords()
{
    constexpr std::size_t length = (... + (std::string_view(wordFor(keys)).size() + 1));
    std::array<char, length> text{};
    std::size_t end = 0;
    for (const std::string_view word : {std::string_view(wordFor(keys))...}) {
        for (const char letter : word) {
            text[end++] = letter;
        }
        text[end++] = '|';
    }
    text[length - 1] = '\0';
    return text;
}

template <typename Enum, std::size_t... rows>
consteval auto joinAllWords(std::index_sequence<rows...>)
{
    return joinWords<EnumWords<Enum>::rows[rows].key...>();
}

/// All words of an enumeration as the help shows them: "open|crossed".
template <typename Enum>
inline constexpr auto kJoinedWords = joinAllWords<Enum>(std::make_index_sequence<std::size(EnumWords<Enum>::rows)>());

/// The words of these enumerators only: "csv|json".
template <auto... keys>
inline constexpr auto kSomeJoinedWords = joinWords<keys...>();

} // namespace slidercrank
