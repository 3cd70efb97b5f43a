// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The sample file, and functions that write and read whole files.

#include <QByteArray>
#include <QFile>
#include <QString>
#include <QTemporaryDir>

namespace slidercrank
{

inline const QString kSample = QStringLiteral(SLIDERCRANK_SOURCE_DIR "/data/inventor_sample.csv"); // b = 60 mm

/// Writes a file in the folder, and returns its path.
inline QString writeFile(const QTemporaryDir &folder, const QString &name, const QByteArray &content)
{
    QFile file(folder.filePath(name));
    if (!file.open(QIODevice::WriteOnly) || file.write(content) != content.size()) {
        qFatal("cannot write %s", qPrintable(name));
    }
    return file.fileName();
}

/// Returns the content of a file; empty if it does not exist.
inline QByteArray contentOf(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

} // namespace slidercrank
