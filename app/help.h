// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The subcommands, the options of each, and the help made from the same table that the parser reads.

#include <QString>

#include <span>
#include <vector>

namespace slidercrank
{

enum class Subcommand { Window, Solve, Limits, Compare, Identify, Study, Render };

/// The word on the command line; empty for the window.
QString wordOf(Subcommand subcommand);

struct OptionEntry {
    const char *name;  ///< without the dashes
    const char *value; ///< what stands for the value in the help; null for a switch
    const char *text;  ///< untranslated
    bool mayRepeat = false;
};

struct OptionGroup {
    const char *title; ///< untranslated
    std::span<const OptionEntry> entries;
};

std::vector<OptionGroup> optionGroupsOf(Subcommand subcommand);

QString helpOf(Subcommand subcommand);

} // namespace slidercrank
