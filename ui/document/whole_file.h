// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A file that is written whole or not at all: until the last of it is on the disk, an older one of that name is as it
// was. All that this program writes to a name goes through here.

#include <QByteArray>
#include <QSaveFile>
#include <QString>

#include <optional>
#include <stop_token>

namespace slidercrank
{

class WholeFile
{
public:
    explicit WholeFile(const QString &path);

    /// These are false when it cannot be; then nothing more is written, and reason() says why.
    bool open();
    bool write(const QByteArray &bytes);
    bool commit(const std::stop_token &stop = {}); ///< without, all was for nothing; so it is when stopped by then

    /// Part of a sentence, without its full stop.
    QString reason() const { return m_reason; }

private:
    bool fail(const QString &reason);
    bool synchronize();

    QSaveFile m_file;
    QString m_reason;
    bool m_failed = false;
};

/// What the system calls a fault, as part of a sentence: Windows makes it one of its own.
QString withoutFullStop(QString reason);

/// All at once: nothing when it is written, else the reason why not.
std::optional<QString> writeWhole(const QString &path, const QByteArray &bytes);

} // namespace slidercrank
