// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Where a subcommand writes: a file, whole or not at all; standard output; or what is no plain file (a device, a pipe).

#include "app/command_line.h"
#include "ui/document/whole_file.h"

#include <QByteArray>
#include <QFile>
#include <QString>

#include <optional>

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
    bool m_isStream; ///< written as it comes: a WholeFile would not be
    QFile m_stream;
    WholeFile m_file;
    bool m_failed = false;
};

/// What several files are answered with, a part a file. Opened with the first of them: where no file can be read, none
/// is written.
class PartedOutput
{
public:
    /// `head` goes before the first part, `between` between two.
    PartedOutput(const QString &path, const QByteArray &head, const QByteArray &between);

    /// False when it cannot be written to.
    bool add(const QByteArray &part);

    /// `tail`: goes behind the last part.
    ExitStatus finish(const QByteArray &tail);

private:
    Output m_output;
    QByteArray m_head;
    QByteArray m_between;
    std::optional<bool> m_isOpen; ///< none: nobody tried
};

/// All of it at once.
ExitStatus writeAll(const QString &path, const QByteArray &bytes);

} // namespace slidercrank
