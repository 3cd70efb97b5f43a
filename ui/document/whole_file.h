// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Files that are written completely or not at all, and what else can be read from: pipes and standard input.

#include <QByteArray>
#include <QSaveFile>
#include <QString>

#include <optional>
#include <stop_token>

class QFile;
class QFileInfo;

namespace slidercrank
{

/// Everything that the program writes goes through this class. Until commit() succeeds, an older file of that name
/// stays as it is.
class WholeFile
{
public:
    explicit WholeFile(const QString &path);

    /// These return false after a failure; reason() then says why, and nothing more is written.
    bool open();
    bool write(const QByteArray &bytes);
    bool commit(const std::stop_token &stop = {}); ///< also false if stopped

    /// Part of a sentence, without its full stop.
    QString reason() const { return m_reason; }

private:
    bool fail(const QString &reason);

    QSaveFile m_file;
    QString m_reason;
};

/// Writes the whole file; returns the reason if that fails.
std::optional<QString> writeWhole(const QString &path, const QByteArray &bytes);

/// The error text of the system as part of a sentence: Windows ends it with a full stop.
QString withoutFullStop(QString reason);

/// Whether the path "-" is given, which stands for standard input.
bool isStandardInput(const QString &path);

/// Whether it exists, and is neither a file nor a folder.
bool isPipeOrDevice(const QFileInfo &file);

/// Opens a file, a pipe, or standard input for reading, without a buffer.
bool openForReading(QFile &file, const QString &path);

} // namespace slidercrank
