// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Writes the result of a command to standard output, or to a file, which is written completely or not at all.

#include "app/command_line.h"
#include "ui/document/whole_file.h"

namespace slidercrank
{

class Output
{
public:
    /// `path`: a file, or empty for standard output.
    Output(const Streams &streams, const QString &path);

    /// Opens the file. If that fails, reports the reason and returns false.
    bool open();

    /// Returns false after a failure. Then nothing more is written, so that a long computation can stop.
    bool write(const QByteArray &bytes);

    /// Completes the output. If this or an earlier write() failed, reports the reason and returns FileError; an
    /// existing file at the path is then unchanged.
    ExitStatus finish();

private:
    void reportFailure() const;

    const Streams &m_streams;
    QString m_path;
    WholeFile m_file;
    bool m_failed = false;
};

/// Writes all bytes at once.
ExitStatus writeOutput(const Streams &streams, const QString &path, const QByteArray &bytes);

} // namespace slidercrank
