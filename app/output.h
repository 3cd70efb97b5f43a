// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Where a subcommand writes: a file, whole or not at all; standard output; or what is no plain file (a device, a pipe).

#include "app/command_line.h"
#include "ui/document/whole_file.h"

#include <QByteArray>
#include <QFile>
#include <QString>

namespace slidercrank
{

class Output
{
public:
    /// An empty path stands for standard output.
    explicit Output(const QString &path);

    /// False when it cannot be written to; why is said on standard error, here and below.
    bool open();

    /// After a failure nothing more is written; false then, so that a long run can end early.
    bool write(const QByteArray &bytes);

    /// When anything failed a file of that name is as it was before.
    ExitStatus finish();

private:
    bool fail(const QString &reason);

    QString m_path;
    bool m_isStream; ///< written as it comes: a WholeFile would put a plain file in the place of a pipe
    QFile m_stream;
    WholeFile m_file;
    bool m_failed = false;
};

/// All of it at once.
ExitStatus writeAll(const QString &path, const QByteArray &bytes);

} // namespace slidercrank
