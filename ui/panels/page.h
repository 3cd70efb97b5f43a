// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What a tab shows, as plain data: a sentence, what can be done about it, tables and perhaps a chart. Pure functions
// make pages (error_page.h, limits_page.h, …), TablePanel shows them, tests read them.

#include "core/identification/convention.h"
#include "ui/plots/chart.h"
#include "ui/widgets/number_table.h"

#include <optional>
#include <vector>

namespace slidercrank
{

/// A sentence about the reference file, with at most one thing to do about it.
struct Finding {
    enum class Remedy {
        None,
        UseFoundMechanism, ///< the mechanism that was found becomes the model
        Apply,         ///< the file is read with the convention
        ReadAsPrinted, ///< the file is read without the conventions applied
        ChooseColumns, ///< a person says what the columns are
        ReadByAngle,   ///< the first column is the crank angle
        ReadByTime     ///< the first column is the time
    };
    Remedy remedy = Remedy::None;
    Convention convention; ///< for Remedy::Apply
    QString sentence;
    QString remedyText;
    QString details; ///< what the remedy would change, rich text; may be empty

    friend bool operator==(const Finding &, const Finding &) = default;
};

struct PageTable {
    QString name;  ///< object name of its widget
    QString title; ///< what a screen reader announces
    std::vector<TableColumn> columns;
    std::vector<TableRow> rows;
};

struct PageChart {
    QString name;  ///< object name of its widget
    QString title; ///< what a screen reader announces
    ChartContent content;
};

struct Page {
    QString sentence;
    Tone tone = Tone::Normal; ///< of the sentence
    std::vector<Finding> findings{};
    bool keepsFindings = false; ///< newer ones are being computed: those shown before stay, dimmed
    std::vector<PageTable> tables{};
    std::optional<PageChart> chart{};
    QString note{};        ///< below the tables
    QString noteDetails{}; ///< its tool tip, rich text
    QString fileName{};    ///< proposed when the page is exported, without a suffix
};

} // namespace slidercrank
