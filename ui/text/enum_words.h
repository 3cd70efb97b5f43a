// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The words of enumerators in scenes and on the command line. EnumWords<Enum> lists them; everything else asks it.

#include "core/mechanism/mechanism.h"
#include "core/newton/newton_options.h"
#include "core/sampling/trajectory.h"
#include "ui/text/enum_table.h"
#include "ui/text/units.h"

#include <QStringList>

#include <array>
#include <string_view>

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
struct EnumWords<LengthUnit> {
    static constexpr EnumWord<LengthUnit> rows[] = {{LengthUnit::Millimetre, "mm"},
                                                    {LengthUnit::Centimetre, "cm"},
                                                    {LengthUnit::Metre, "m"},
                                                    {LengthUnit::Inch, "in"}};
    static_assert(isCompleteTable(rows, LengthUnit::Inch));
};

template <>
struct EnumWords<AngleUnit> {
    static constexpr EnumWord<AngleUnit> rows[] = {{AngleUnit::Degree, "deg"}, {AngleUnit::Radian, "rad"}};
    static_assert(isCompleteTable(rows, AngleUnit::Radian));
};

/// Returns the words of the enumeration.
template <typename Enum>
QStringList wordsOf()
{
    QStringList words;
    for (const EnumWord<Enum> &row : EnumWords<Enum>::rows) {
        words += row.word;
    }
    return words;
}

template <typename Enum>
consteval auto joinWords()
{
    constexpr std::size_t length = [] {
        std::size_t sum = 0;
        for (const EnumWord<Enum> &row : EnumWords<Enum>::rows) {
            sum += std::string_view(row.word).size() + 1;
        }
        return sum;
    }();
    std::array<char, length> text{};
    std::size_t end = 0;
    for (const EnumWord<Enum> &row : EnumWords<Enum>::rows) {
        for (const char letter : std::string_view(row.word)) {
            text[end++] = letter;
        }
        text[end++] = '|';
    }
    text[length - 1] = '\0';
    return text;
}

/// The words as the help shows them: "open|crossed".
template <typename Enum>
inline constexpr auto kJoinedWords = joinWords<Enum>();

} // namespace slidercrank
