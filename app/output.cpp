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
    , m_file(path)
    , m_direct(path)
    , m_device(path.isEmpty()                    ? &streams.output
               : isPipeOrDevice(QFileInfo(path)) ? &m_direct
                                                 : nullptr)
{
}

bool Output::fail()
{
    const QString reason = withoutFullStop(m_device ? m_device->errorString() : m_file.reason());
    m_streams.report(m_path.isEmpty()
                         ? CommandLine::tr("Cannot write to standard output: %1.").arg(reason)
                         : CommandLine::tr("Cannot write %1: %2. Choose another file or folder with --output.")
                               .arg(QDir::toNativeSeparators(m_path), reason));
    return false;
}

bool Output::open()
{
    const bool isOpen = m_device ? m_device->isOpen() || m_device->open(QIODevice::WriteOnly) : m_file.open();
    return isOpen || fail();
}

bool Output::write(const QByteArray &bytes)
{
    m_failed = m_failed || (m_device ? m_device->write(bytes) != bytes.size() : !m_file.write(bytes));
    return !m_failed;
}

ExitStatus Output::finish()
{
    auto *const buffered = qobject_cast<QFileDevice *>(m_device);
    const bool isWritten = !m_failed && (m_device ? !buffered || buffered->flush() : m_file.commit());
    return isWritten || fail() ? ExitStatus::Success : ExitStatus::FileError;
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
