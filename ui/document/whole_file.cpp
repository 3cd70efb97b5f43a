// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/whole_file.h"

#include "ui/text/printable_text.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>

#ifdef Q_OS_UNIX
#include <cerrno>

#include <unistd.h>
#endif

namespace slidercrank
{

namespace
{

struct WholeFileText {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::WholeFileText)
};

/// Writes the buffers of the system to the disk. QSaveFile::commit() does that as well, but ignores failures.
bool synchronize(const QSaveFile &file)
{
#ifdef Q_OS_UNIX
    return ::fsync(file.handle()) == 0 || errno == EINVAL || errno == ENOTSUP; // some file systems do not support it
#else
    return true;
#endif
}

QString &unnamedFolder()
{
    static QString folder;
    return folder;
}

} // namespace

WholeFile::WholeFile(const QString &path)
    : m_file(path)
{
}

bool WholeFile::fail(const QString &reason)
{
    m_reason = withoutFullStop(reason);
    m_file.cancelWriting();
    return false;
}

/// Opens without a buffer, because QSaveFile::commit() of Qt 6.4 ignores a failure to write the rest of a buffer.
bool WholeFile::open()
{
    if (isPipeOrDevice(QFileInfo(m_file.fileName()))) { // QSaveFile would replace it by a file
        return fail(WholeFileText::tr("it is a pipe or a device"));
    }
    return m_file.open(QIODevice::WriteOnly | QIODevice::Unbuffered) || fail(m_file.errorString());
}

bool WholeFile::write(const QByteArray &bytes)
{
    if (!m_reason.isEmpty()) {
        return false;
    }
    // If a full disk accepts only a part of the bytes, QFile reports no error, so the reason is taken from the last
    // error of the operating system.
    return m_file.write(bytes) == bytes.size() || fail(qt_error_string());
}

bool WholeFile::commit(const std::stop_token &stop)
{
    if (!m_reason.isEmpty() || stop.stop_requested()) {
        return false;
    }
    if (!synchronize(m_file)) {
        return fail(qt_error_string());
    }
    return m_file.commit() || fail(m_file.errorString());
}

QString cannotWrite(const QString &path, const QString &reason)
{
    return WholeFileText::tr("%1 cannot be written: %2. Choose another name or folder.").arg(displayName(path), reason);
}

std::optional<QString> writeWhole(const QString &path, const QByteArray &bytes)
{
    WholeFile file(path);
    return file.open() && file.write(bytes) && file.commit() ? std::nullopt
                                                             : std::optional(cannotWrite(path, file.reason()));
}

QString withoutFullStop(QString reason)
{
    if (reason.endsWith(u'.')) {
        reason.chop(1);
    }
    return reason;
}

bool isStandardInput(const QString &path)
{
    return path == u"-";
}

bool isPipeOrDevice(const QFileInfo &file)
{
    return file.exists() && !file.isFile() && !file.isDir();
}

QString displayName(const QString &path)
{
    if (isStandardInput(path)) {
        return WholeFileText::tr("Standard input");
    }
    if (path.startsWith(u':')) { // a file in the program
        return QFileInfo(path).fileName();
    }
    const QString &folder = unnamedFolder();
    const bool isInFolder = !folder.isEmpty() && path.startsWith(folder + u'/');
    return printableLine(QDir::toNativeSeparators(isInFolder ? path.mid(folder.size() + 1) : path));
}

void setUnnamedFolder(const QString &folder)
{
    unnamedFolder() = folder;
}

} // namespace slidercrank
