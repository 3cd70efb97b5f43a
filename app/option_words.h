// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The words of enumerators that only the command line has (ui/text/enum_words.h).

#include "ui/export/report.h"
#include "ui/text/enum_words.h"

namespace slidercrank
{

/// The cases of the study.
enum class CaseChoice {
    Nominal, ///< the mechanism of the options, and ordinary ones
    Hard,
    All
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
