// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What all subcommands share: how they end, and where their sentences are translated.

#include <QCoreApplication>
#include <QString>

#include <optional>

namespace slidercrank
{

/// The exit status of the program. Where several hold, a failed file comes first, then NotAssemblable, NotSolved,
/// Differs.
enum class ExitStatus {
    Done = 0,
    Differs = 1, ///< --fail-on-difference, and a channel differs
    WrongCommandLine = 2,
    FileFailed = 3,     ///< a file cannot be read or written, or is not what it should be
    NotAssemblable = 4, ///< at some instant
    NotSolved = 5       ///< at some instant Newton-Raphson did not converge, or velocity and acceleration do not exist;
                        ///< or no mechanism was found for a file
};

/// Of two, which the program ends with.
ExitStatus graver(ExitStatus x, ExitStatus y);

/// The translation context of everything the command line says.
struct CommandLine {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::CommandLine)
};

/// One line on standard error.
void say(const QString &sentence);

/// As it is typed: 5.03e-6. Three digits are what a person compares; a dash for what does not exist.
QString rounded(std::optional<double> value, int digits = 3);

} // namespace slidercrank
