// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A folder with an older file at the path to be saved. Checks that after saving it contains either the complete older
// file or the complete new file, and nothing else.

#include "tests/support/files.h"

#include <QByteArray>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QImage>
#include <QJsonDocument>
#include <QString>
#include <QStringList>
#include <QTemporaryDir>

#include <functional>

namespace slidercrank
{

inline const QByteArray kOlder = "what was there before\n";

/// One way of saving a file, by the command line or by the window.
struct Save {
    const char *name;
    QString file;
    QStringList arguments = {};                             ///< arguments of the program, without --output
    std::function<void(const QString &path)> inWindow = {}; ///< saves by the window
};

/// Returns whether the file is complete according to its format. `lines` is the expected number of lines of a table.
inline bool isWhole(const QString &path, qsizetype lines)
{
    const QByteArray bytes = contentOf(path);
    const QString suffix = QFileInfo(path).suffix();
    if (suffix == QLatin1String("png")) {
        return bytes.endsWith(QByteArray::fromHex("49454e44ae426082")) && !QImage::fromData(bytes).isNull();
    }
    if (suffix == QLatin1String("svg")) {
        return bytes.trimmed().endsWith("</svg>");
    }
    if (suffix == QLatin1String("pdf")) {
        const qsizetype reference = bytes.lastIndexOf("startxref\n");
        const qsizetype table = bytes.mid(reference + 10).split('\n').first().toLongLong();
        return bytes.startsWith("%PDF") && reference > 0 && bytes.mid(table, 4) == "xref" &&
               bytes.trimmed().endsWith("%%EOF");
    }
    if (suffix == QLatin1String("json")) {
        return QJsonDocument::fromJson(bytes).isObject();
    }
    return bytes.endsWith('\n') && bytes.count('\n') == lines;
}

struct Outcome {
    bool isWritten = false;   ///< the program reports success; otherwise it reports an error
    QString fault;            ///< set if the program reports neither
    bool isDisturbed = false; ///< the system call that was to fail has failed
};

inline QStringList namesIn(const QString &folder)
{
    return QDir(folder).entryList(QDir::AllEntries | QDir::NoDotAndDotDot | QDir::Hidden | QDir::System, QDir::Name);
}

/// A temporary folder that contains the older file.
class Place
{
public:
    explicit Place(const Save &save)
        : m_path(m_folder.filePath(save.file))
    {
        QFile file(m_path);
        if (!file.open(QIODevice::WriteOnly) || file.write(kOlder) != kOlder.size()) {
            qFatal("cannot write the older file of a test");
        }
    }

    QString folder() const { return m_folder.path(); }
    QString path() const { return m_path; }
    qint64 size() const { return QFileInfo(m_path).size(); }
    qsizetype lines() const { return contentOf(m_path).count('\n'); }

    /// Describes how the folder contradicts the reported outcome. Empty if it does not.
    QString fault(const Outcome &outcome, qsizetype lines) const
    {
        if (!outcome.fault.isEmpty()) {
            return outcome.fault;
        }
        const QStringList names = namesIn(folder());
        const bool isRight = outcome.isWritten ? isWhole(m_path, lines) : contentOf(m_path) == kOlder;
        return isRight && names.size() == 1 ? QString()
                                            : QStringLiteral("%1; there are %2, and %3 bytes")
                                                  .arg(outcome.isWritten ? "done" : "an error", names.join(u' '))
                                                  .arg(size());
    }

    /// Checks the file after the program was killed, so that it reported no outcome. Temporary files may remain.
    QString faultAfterKill(qsizetype lines) const
    {
        return contentOf(m_path) == kOlder || isWhole(m_path, lines)
                   ? QString()
                   : QStringLiteral("neither the older nor the new file");
    }

private:
    QTemporaryDir m_folder;
    QString m_path;
};

} // namespace slidercrank
