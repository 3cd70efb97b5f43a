// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// One description of each option: the parser, the help, the manual page and the completion are made from it.

#include <QString>
#include <QStringList>

#include <optional>
#include <span>
#include <vector>

namespace slidercrank
{

enum class Subcommand { Window, Solve, Limits, Compare, Identify, Study, Render };

/// By Subcommand.
struct CommandDescription {
    const char *name; ///< "solve", "limits" …; empty for the window
    const char *arguments;
    const char *summary; ///< a few words, untranslated
    const char *text;    ///< a paragraph, untranslated
};
std::span<const CommandDescription> allCommands(); ///< the window first
const CommandDescription &describe(Subcommand subcommand);
std::optional<Subcommand> subcommandNamed(const QString &name);
QStringList subcommandNames(); ///< without the window

struct OptionDescription {
    int commands = 0;            ///< a bit for each subcommand that takes it
    const char *group = nullptr; ///< heading in the help, untranslated
    const char *name = nullptr;  ///< without dashes
    const char *value = nullptr; ///< what stands for the value in the help, "open|crossed" for a choice; null: a switch
    const char *text = nullptr;  ///< what it does, untranslated
    const char *shortName = nullptr;
    bool mayRepeat = false;
};

/// The options of a subcommand, in the order of the help.
std::vector<OptionDescription> optionsOf(Subcommand subcommand);

} // namespace slidercrank
