// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Writes files completely or not at all, and names files in messages.

#include <QByteArray>
#include <QSaveFile>
#include <QString>

#include <optional>
#include <stop_token>

class QFileInfo;

namespace slidercrank
{

/// A file that is written completely or not at all. Until commit() succeeds, an older file of that name is unchanged.
class WholeFile
{
public:
    explicit WholeFile(const QString &path);

    /// Open the file and write to it. Return false after a failure: then reason() gives the reason, and nothing more is
    /// written.
    bool open();
    bool write(const QByteArray &bytes);
    bool commit(const std::stop_token &stop = {}); ///< also returns false if stopped

    /// Returns why writing failed, as part of a sentence, without a full stop.
    QString reason() const { return m_reason; }

private:
    bool fail(const QString &reason); ///< stores the reason, and returns false

    QSaveFile m_file;
    QString m_reason;
};

/// Returns a sentence that says why a file or a folder cannot be written, and what to do.
QString cannotWrite(const QString &path, const QString &reason);

/// Writes a file completely or not at all. Returns a sentence if that fails.
std::optional<QString> writeWhole(const QString &path, const QByteArray &bytes);

/// Removes the full stop that Windows adds to the error texts of the system.
QString withoutFullStop(QString reason);

/// Returns whether the path is "-", which stands for standard input.
bool isStandardInput(const QString &path);

/// Returns whether the path exists, and is neither a file nor a folder.
bool isPipeOrDevice(const QFileInfo &file);

/// Returns the name of a file in messages, without control characters.
QString displayName(const QString &path);

/// Sets a folder that messages do not name: where the program keeps its files if the user has no folders.
void setUnnamedFolder(const QString &folder);

} // namespace slidercrank
