// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A folder with an older file at the path to be saved. Checks that after saving it contains either the complete older
// file or the complete new file, and nothing else.

#include <QByteArray>
#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QFileInfo>
#include <QImage>
#include <QJsonDocument>
#include <QString>
#include <QStringList>
#include <QTemporaryDir>

#include <functional>
#include <set>

namespace slidercrank
{

inline const QByteArray kOlder = "what was there before\n";

/// One way of saving a file, by the command line or by the window.
struct Save {
    const char *name;
    QString file;
    int frames = 0;             ///< number of frames saved instead of one file; the folder has two more older ones
    QStringList arguments = {}; ///< arguments of the program, without --output
    std::function<void(const QString &path)> inWindow = {}; ///< saves by the window, which reports in its message bar

    QStringList files(bool isOlder) const
    {
        QStringList names;
        for (int frame = 1; frame <= frames + (isOlder && frames > 0 ? 2 : 0); ++frame) {
            names += QStringLiteral("%1_%2.png").arg(QFileInfo(file).baseName()).arg(frame, 3, 10, QLatin1Char('0'));
        }
        return frames > 0 ? names : QStringList(file);
    }
};

inline QByteArray contentOf(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

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
    bool isWritten = false; ///< the program reports success; otherwise it reports an error
    QString fault;          ///< set if the program reports neither
};

inline QStringList namesIn(const QString &folder)
{
    return QDir(folder).entryList(QDir::AllEntries | QDir::NoDotAndDotDot | QDir::Hidden | QDir::System, QDir::Name);
}

/// A temporary folder that contains the older files.
class Place
{
public:
    explicit Place(const Save &save)
        : m_save(save)
    {
        for (const QString &name : save.files(true)) {
            QFile file(m_folder.filePath(name));
            if (!file.open(QIODevice::WriteOnly) || file.write(kOlder) != kOlder.size()) {
                qFatal("cannot write the older files of a test");
            }
        }
    }

    QString folder() const { return m_folder.path(); }
    QString path() const { return m_folder.filePath(m_save.file); }
    qint64 size() const { return QFileInfo(m_folder.filePath(m_save.files(false).first())).size(); }
    qsizetype lines() const { return contentOf(path()).count('\n'); }

    /// Describes how the folder contradicts the reported outcome. Empty if it does not.
    QString fault(const Outcome &outcome, qsizetype lines) const
    {
        if (!outcome.fault.isEmpty()) {
            return outcome.fault;
        }
        const QString report = outcome.isWritten ? QStringLiteral("done; ") : QStringLiteral("an error; ");
        const QStringList names = namesIn(folder());
        if (names != m_save.files(!outcome.isWritten)) {
            return report + QStringLiteral("there are ") + names.join(u' ');
        }
        for (const QString &name : names) {
            const QString file = m_folder.filePath(name);
            if (outcome.isWritten ? !isWhole(file, lines) : contentOf(file) != kOlder) {
                return report + QStringLiteral("%1 has %2 bytes").arg(name).arg(QFileInfo(file).size());
            }
        }
        return {};
    }

    /// Checks the folder after the program was killed, so that it reported no outcome. Temporary files may remain, and
    /// so may older frames that were moved aside: they must not be deleted before the new frames exist, nor mixed with
    /// them.
    QString faultAfterKill(qsizetype lines) const
    {
        std::set<bool> isOlder;
        int count = 0;
        for (const QString &name : m_save.files(true)) {
            const QString file = m_folder.filePath(name);
            if (QFile::exists(file)) {
                isOlder.insert(contentOf(file) == kOlder);
                ++count;
                if (contentOf(file) != kOlder && !isWhole(file, lines)) {
                    return QStringLiteral("%1 has %2 bytes").arg(name).arg(QFileInfo(file).size());
                }
            }
        }
        if (isOlder.size() > 1) {
            return QStringLiteral("older frames and new frames");
        }
        const bool isNew = isOlder.contains(false) && count == m_save.files(false).size();
        int older = 0;
        QDirIterator iterator(folder(), QDir::Files, QDirIterator::Subdirectories);
        while (iterator.hasNext()) {
            older += contentOf(iterator.next()) == kOlder ? 1 : 0;
        }
        return isNew || older == m_save.files(true).size() ? QString()
                                                           : QStringLiteral("neither the older nor the new files");
    }

private:
    const Save &m_save;
    QTemporaryDir m_folder;
};

} // namespace slidercrank
