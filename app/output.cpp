// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/output.h"

#include "ui/document/whole_file.h"

#include <QDir>
#include <QFileInfo>

namespace slidercrank
{

Output::Output(const Streams &streams, const QString &path)
    : m_streams(streams)
    , m_path(path)
    , m_isPlainFile(!path.isEmpty() && !isPipeOrDevice(QFileInfo(path)))
    , m_file(path)
    , m_device(path)
{
}

bool Output::fail(const QString &reason)
{
    m_failed = true;
    const QString withoutStop = withoutFullStop(reason);
    m_streams.report(m_path.isEmpty()
                         ? CommandLine::tr("Cannot write to standard output: %1.").arg(withoutStop)
                         : CommandLine::tr("Cannot write %1: %2. Choose another file or folder with --output.")
                               .arg(QDir::toNativeSeparators(m_path), withoutStop));
    return false;
}

bool Output::open()
{
    if (m_isPlainFile) {
        return m_file.open() || fail(m_file.reason());
    }
    return m_path.isEmpty() || m_device.open(QIODevice::WriteOnly) || fail(m_device.errorString());
}

bool Output::write(const QByteArray &bytes)
{
    if (!m_failed && m_isPlainFile) {
        m_failed = !m_file.write(bytes);
    } else if (!m_failed) {
        m_failed = device().write(bytes) != bytes.size();
    }
    return !m_failed;
}

ExitStatus Output::finish()
{
    if (m_isPlainFile) {
        return (!m_failed && m_file.commit()) || fail(m_file.reason()) ? ExitStatus::Success : ExitStatus::FileError;
    }
    QFileDevice *const file = qobject_cast<QFileDevice *>(&device());
    const bool isWritten = !m_failed && (!file || file->flush());
    return isWritten || fail(device().errorString()) ? ExitStatus::Success : ExitStatus::FileError;
}

ExitStatus writeOutput(const Streams &streams, const QString &path, const QByteArray &bytes)
{
    Output output(streams, path);
    if (!output.open()) {
        return ExitStatus::FileError;
    }
    output.write(bytes);
    return output.finish();
}

} // namespace slidercrank
