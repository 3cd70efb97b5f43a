// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Where a command writes its result: a file, whole or not at all; a device or a pipe; or standard output.

#include "app/command_line.h"
#include "ui/document/whole_file.h"

#include <QFile>

namespace slidercrank
{

class Output
{
public:
    /// An empty path stands for standard output.
    Output(const Streams &streams, const QString &path);

    /// False if it cannot be written to; the reason is reported, here and below.
    bool open();

    /// False after a failure; then nothing more is written, so that long work can stop.
    bool write(const QByteArray &bytes);

    /// FileError if anything failed; then a file of that name is as it was before.
    ExitStatus finish();

private:
    bool fail(const QString &reason);

    const Streams &m_streams;
    QString m_path;
    bool m_isPlainFile;
    QFile m_device; ///< a device or a pipe, which cannot be replaced as a whole
    WholeFile m_file;
    bool m_failed = false;
};

/// Writes everything at once.
ExitStatus writeOutput(const Streams &streams, const QString &path, const QByteArray &bytes);

} // namespace slidercrank
