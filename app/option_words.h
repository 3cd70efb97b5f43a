// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The words of those enumerators that only the command line reads or writes, listed as in ui/text/enum_words.h.

#include "core/limits/mobility.h"
#include "ui/export/report.h"
#include "ui/text/enum_words.h"
#include "ui/text/theme.h"

namespace slidercrank
{

/// The format of the output of a command. Each command offers some of the formats.
enum class OutputFormat { Text, Csv, Json };

template <>
struct EnumWords<OutputFormat> {
    static constexpr EnumWord<OutputFormat> rows[] = {
        {OutputFormat::Text, "text"}, {OutputFormat::Csv, "csv"}, {OutputFormat::Json, "json"}};
    static_assert(isCompleteTable(rows, OutputFormat::Json));
};

/// The meaning of the first column of a reference file.
enum class FirstColumn { TimeStamps, CrankAngles };

template <>
struct EnumWords<FirstColumn> {
    static constexpr EnumWord<FirstColumn> rows[] = {{FirstColumn::TimeStamps, "time"},
                                                     {FirstColumn::CrankAngles, "angle"}};
    static_assert(isCompleteTable(rows, FirstColumn::CrankAngles));
};

template <>
struct EnumWords<Theme> {
    static constexpr EnumWord<Theme> rows[] = {
        {Theme::System, "system"}, {Theme::Light, "light"}, {Theme::Dark, "dark"}};
    static_assert(isCompleteTable(rows, Theme::Dark));
};

template <>
struct EnumWords<Mobility> {
    static constexpr EnumWord<Mobility> rows[] = {{Mobility::FullTurn, "full-turn"},
                                                  {Mobility::Rocker, "rocker"},
                                                  {Mobility::Locked, "locked"},
                                                  {Mobility::Impossible, "impossible"}};
    static_assert(isCompleteTable(rows, Mobility::Impossible));
};

/// The cases of the study.
enum class CaseChoice {
    Nominal, ///< the mechanism of the options only
    Hard,    ///< hardCases(), after the mechanism of the options unless that is the default one
    All      ///< nominalCases() and hardCases(), after the mechanism of the options unless that is the default one
};

template <>
struct EnumWords<CaseChoice> {
    static constexpr EnumWord<CaseChoice> rows[] = {
        {CaseChoice::Nominal, "nominal"}, {CaseChoice::Hard, "hard"}, {CaseChoice::All, "all"}};
    static_assert(isCompleteTable(rows, CaseChoice::All));
};

template <>
struct EnumWords<PaperSize> {
    static constexpr EnumWord<PaperSize> rows[] = {{PaperSize::A4, "a4"}, {PaperSize::Letter, "letter"}};
    static_assert(isCompleteTable(rows, PaperSize::Letter));
};

} // namespace slidercrank
