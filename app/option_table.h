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

/// Each is a bit, so that an option can name the commands that take it.
enum class Subcommand { Window = 1, Solve = 2, Limits = 4, Compare = 8, Identify = 16, Study = 32, Render = 64 };

/// "solve", "limits" …; the window has no name.
QStringList subcommandNames();
QString nameOf(Subcommand subcommand);
std::optional<Subcommand> subcommandNamed(const QString &name);

struct OptionDescription {
    int commands = 0;            ///< the bits of the subcommands that take it
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
