// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The content of a tab as plain data: a sentence, findings with their remedies, tables and an optional chart. Pure
// functions make pages (error_page.h, limits_page.h, …), and TablePanel shows them.

#include "core/identification/convention.h"
#include "ui/plots/chart.h"
#include "ui/widgets/number_table.h"

#include <optional>
#include <vector>

namespace slidercrank
{

/// What the button of a finding does.
enum class Remedy {
    None,
    UseFoundMechanism, ///< use the mechanism that was found as the model
    ApplyConvention,   ///< read the file with the convention
    ReadAsPrinted,     ///< read the file without the conventions that were applied
    ChooseColumns,     ///< open the dialog for the meaning of the columns
    OpenFile,          ///< choose a file to compare with
    RunStudy           ///< measure speed and accuracy
};

/// A sentence with at most one remedy.
struct Finding {
    QString sentence = {};
    Remedy remedy = Remedy::None;
    QString remedyText = {};
    QString details = {};       ///< the changes that the remedy makes, as rich text; may be empty
    Convention convention = {}; ///< for Remedy::ApplyConvention

    friend bool operator==(const Finding &, const Finding &) = default;
};

struct PageTable {
    QString name;  ///< object name of its widget
    QString title; ///< what a screen reader announces
    std::vector<TableColumn> columns;
    std::vector<TableRow> rows = {};
};

struct PageChart {
    QString name;  ///< object name of its widget
    QString title; ///< what a screen reader announces
    ChartContent content;
};

struct Page {
    QString sentence;
    Tone tone = Tone::Normal; ///< colour of the sentence
    std::vector<Finding> findings{};
    bool isSearching = false; ///< new findings are being computed: the remedies of `findings` are disabled
    std::vector<PageTable> tables{};
    std::optional<PageChart> chart{};
    QString note{}; ///< below the tables
};

} // namespace slidercrank
