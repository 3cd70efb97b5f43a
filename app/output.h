// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Where a subcommand writes: a file, whole or not at all; standard output; or what is no plain file (a device, a pipe).

#include <QByteArray>
#include <QFile>
#include <QSaveFile>
#include <QString>

#include <optional>

namespace slidercrank
{

class Output
{
public:
    /// An empty path stands for standard output.
    explicit Output(const QString &path);

    /// One sentence when it cannot be written to.
    std::optional<QString> open();

    /// After a failure nothing more is written; false then, so that a long run can end early.
    bool write(const QByteArray &bytes);

    /// One sentence when anything failed; then a file of that name is as it was before.
    std::optional<QString> finish();

private:
    QFileDevice &device();
    QString failure();

    QString m_path;
    bool m_isStream; ///< written as it comes: a QSaveFile would put a plain file in the place of a pipe
    QFile m_stream;
    QSaveFile m_file;
    bool m_failed = false;
};

} // namespace slidercrank
