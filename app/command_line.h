// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The command line as a library: finds the command that the arguments name, and runs it. Text and error messages go to
// the two devices of `Streams` instead of stdout and stderr, so that a test can run a command in its own process.

#include <QCoreApplication>
#include <QIODevice>
#include <QString>
#include <QStringList>

namespace slidercrank
{

/// The exit status of the program.
enum class ExitStatus {
    Success = 0,
    Differs = 1,        ///< --fail-on-difference was given and a channel differs, or a value of `check` is wrong
    UsageError = 2,     ///< the arguments are wrong
    FileError = 3,      ///< a file cannot be read or written, or its content is not valid
    NotAssemblable = 4, ///< no assembly at some time step, or no answer to --design, --when or --omega2-for
    NotSolved = 5       ///< not converged or singular at some time step, or no mechanism was identified
};

/// Returns the exit status to report when both apply: 2 before 3 before 4 before 5 before 1.
ExitStatus moreSevere(ExitStatus x, ExitStatus y);

/// The translation context of the command line.
struct CommandLine {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::CommandLine)
};

/// Thrown while the options are read. The message is written to standard error as one line.
struct UsageError {
    QString message;
    ExitStatus status = ExitStatus::UsageError;
};

/// The devices that a command writes to.
struct Streams {
    QIODevice &output;
    QIODevice &error;

    /// Writes one line to `error`.
    void report(const QString &message) const;
};

/// What has to exist before a command runs.
enum class Platform {
    Console,   ///< a QCoreApplication, no GUI
    Offscreen, ///< a QApplication, but no display
    Window     ///< a QApplication and a display
};

/// Returns what a command line with this first argument needs.
Platform platformFor(const QString &firstArgument);

/// Runs the command. The first of the arguments is the name of the program. Reports wrong arguments.
ExitStatus runCommandLine(const QStringList &arguments, const Streams &streams);

} // namespace slidercrank
