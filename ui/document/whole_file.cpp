// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/whole_file.h"

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
    for (qint64 done = 0; m_reason.isEmpty() && done < bytes.size();) { // a nearly full disk accepts only a part
        const qint64 count = m_file.write(bytes.constData() + done, bytes.size() - done);
        if (count <= 0) {
            return fail(m_file.errorString());
        }
        done += count;
    }
    return m_reason.isEmpty();
}

bool WholeFile::commit(const std::stop_token &stop)
{
    if (!m_reason.isEmpty() || stop.stop_requested()) {
        return false;
    }
    return (synchronize(m_file) || fail(qt_error_string())) && (m_file.commit() || fail(m_file.errorString()));
}

QString cannotWrite(const QString &path, const QString &reason)
{
    return WholeFileText::tr("%1 cannot be written: %2. Choose another name or folder.")
        .arg(QDir::toNativeSeparators(path), reason);
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
    return isStandardInput(path) ? WholeFileText::tr("Standard input") : QDir::toNativeSeparators(path);
}

std::optional<QString> openForReading(QFile &file, const QString &path)
{
    constexpr int kStandardInput = 0; // the descriptor; with `stdin`, the end of a pipe would be an error
    const QIODevice::OpenMode mode = QIODevice::ReadOnly | QIODevice::Unbuffered;
    if (QFileInfo(path).isDir()) {
        return WholeFileText::tr("%1 is a folder: choose a file in it.").arg(displayName(path));
    }
    file.setFileName(path);
    if (isStandardInput(path) ? file.open(kStandardInput, mode) : file.open(mode)) {
        return std::nullopt;
    }
    return WholeFileText::tr("%1 cannot be opened: %2.").arg(displayName(path), withoutFullStop(file.errorString()));
}

std::optional<QString> readFailure(const QFile &file, const QString &path)
{
    return file.error() == QFileDevice::NoError
               ? std::nullopt
               : std::optional(WholeFileText::tr("%1 cannot be read: %2.")
                                   .arg(displayName(path), withoutFullStop(file.errorString())));
}

} // namespace slidercrank
