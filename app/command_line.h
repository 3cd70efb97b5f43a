// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The command line of the program, as a library: from the arguments to what has to be done, and from there to an exit
// status. Everything is written to two devices, so that a test can call it in its own process.

#include <QCoreApplication>
#include <QIODevice>
#include <QString>
#include <QStringList>

#include <functional>
#include <optional>

namespace slidercrank
{

/// The exit status of the program.
enum class ExitStatus {
    Success = 0,
    Differs = 1,        ///< --fail-on-difference was given and a channel differs
    UsageError = 2,     ///< the arguments are wrong
    FileError = 3,      ///< a file cannot be read or written, or its content is not what it should be
    NotAssemblable = 4, ///< the mechanism cannot be assembled at some time step
    NotSolved = 5       ///< not converged or singular at some time step, or no mechanism was identified
};

/// The status to report when both apply: 3 before 4 before 5 before 1.
ExitStatus moreSevere(ExitStatus x, ExitStatus y);

/// The translation context of the command line.
struct CommandLine {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::CommandLine)
};

/// Thrown while the arguments are read; becomes one line on standard error and the exit status.
struct UsageError {
    QString message;
    ExitStatus status = ExitStatus::UsageError;
};

/// Where a command writes.
struct Streams {
    QIODevice &output;
    QIODevice &error;

    /// Writes one line to `error`.
    void report(const QString &message) const;
};

/// A command whose arguments are valid.
struct Command {
    enum class Platform {
        None,      ///< runs with a QCoreApplication
        Offscreen, ///< draws: needs a QApplication, but no display
        Window ///< opens the window: `run` must be called with a display, and its status means that the window may open
    };
    std::function<ExitStatus(const Streams &)> run;
    Platform platform = Platform::None;

    // Platform::Window only.
    QString scene = {};              ///< empty: none
    QStringList referenceFiles = {}; ///< of one motion; empty: none, or the scene's own
    bool choosesPlatform = false;    ///< an option such as -platform selects the display
};

/// Reads the arguments, the first of which is the name of the program. The returned command reports wrong arguments
/// when it runs.
Command parseCommandLine(const QStringList &arguments);

} // namespace slidercrank
