// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/whole_file.h"

#include "ui/document/byte_stream.h"

#include <QCoreApplication>
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

} // namespace

WholeFile::WholeFile(const QString &path)
    : m_file(path)
{
}

bool WholeFile::fail(const QString &reason)
{
    m_failed = true;
    m_reason = withoutFullStop(reason);
    m_file.cancelWriting();
    return false;
}

/// Without a buffer, because QSaveFile::commit() of Qt 6.4 does not see that the last of one finds no room.
bool WholeFile::open()
{
    if (isPipeOrDevice(QFileInfo(m_file.fileName()))) { // in whose place a file would come
        return fail(WholeFileText::tr("it is a pipe or a device"));
    }
    return m_file.open(QIODevice::WriteOnly | QIODevice::Unbuffered) || fail(m_file.errorString());
}

bool WholeFile::write(const QByteArray &bytes)
{
    for (qint64 done = 0; !m_failed && done < bytes.size();) { // what still had room is no error, the next one is
        const qint64 count = m_file.write(bytes.constData() + done, bytes.size() - done);
        if (count <= 0) {
            return fail(m_file.errorString());
        }
        done += count;
    }
    return !m_failed;
}

/// commit() would do the same, and not look whether it could.
bool WholeFile::synchronize()
{
#ifdef Q_OS_UNIX
    if (::fsync(m_file.handle()) != 0 && errno != EINVAL && errno != ENOTSUP) { // not every file system can
        return fail(qt_error_string(errno));
    }
#endif
    return true;
}

bool WholeFile::commit(const std::stop_token &stop)
{
    return !m_failed && synchronize() && !stop.stop_requested() && (m_file.commit() || fail(m_file.errorString()));
}

QString withoutFullStop(QString reason)
{
    if (reason.endsWith(u'.')) {
        reason.chop(1);
    }
    return reason;
}

std::optional<QString> writeWhole(const QString &path, const QByteArray &bytes)
{
    WholeFile file(path);
    return file.open() && file.write(bytes) && file.commit() ? std::nullopt : std::optional(file.reason());
}

} // namespace slidercrank
