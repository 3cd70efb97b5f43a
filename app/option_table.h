// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Describes every command and every option once. The parser, the help, the manual page and the completion are made
// from these descriptions.

#include "app/command_line.h"

#include <span>
#include <vector>

namespace slidercrank
{

class OptionReader;

struct CommandDescription {
    const char *name;      ///< "solve", "limits", …; "window" for the program without a command
    const char *arguments; ///< as they follow the name in the line "Usage:" of the help
    const char *summary;   ///< a few words, untranslated
    const char *text;      ///< a paragraph, untranslated
    ExitStatus (*run)(const OptionReader &, const Streams &);
    Platform platform = Platform::Console;
};

/// Returns the command of the window, which opens if no command is typed.
const CommandDescription &windowDescription();

/// Returns the commands that are typed: all except the window.
std::span<const CommandDescription> typedCommands();

/// Returns the window, followed by typedCommands().
std::span<const CommandDescription> allCommands();

/// Returns the typed command of that name, or null if there is none.
const CommandDescription *findCommand(const QString &name);

/// Returns the names of typedCommands().
QStringList commandNames();

/// The names of some commands, separated by spaces: "solve render". It does not compile with an unknown name.
struct CommandList {
    const char *names;

    consteval CommandList(const char *theNames);
};

struct OptionDescription {
    CommandList commands; ///< the commands that take the option
    const char *name;     ///< without dashes
    const char *value;    ///< placeholder of the value in the help, "open|crossed" for a choice; null for a switch
    const char *text;     ///< what the option does, untranslated
    const char *shortName = nullptr;
    const char *group = nullptr; ///< heading in the help, untranslated
};

/// Returns the options that the command takes, in the order of the help, each with its group.
std::vector<OptionDescription> optionsOf(const CommandDescription &command);

} // namespace slidercrank
