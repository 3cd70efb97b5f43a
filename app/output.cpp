// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/output.h"

#include <QDir>
#include <QFileInfo>

#include <cstdio>

namespace slidercrank
{

namespace
{

bool isDeviceOrPipe(const QString &path)
{
    const QFileInfo file(path);
    return file.exists() && !file.isFile() && !file.isDir();
}

} // namespace

Output::Output(const QString &path)
    : m_path(path)
    , m_isStream(path.isEmpty() || isDeviceOrPipe(path))
    , m_stream(path)
    , m_file(path)
{
}

QFileDevice &Output::device()
{
    return m_isStream ? static_cast<QFileDevice &>(m_stream) : m_file;
}

bool Output::fail()
{
    m_failed = true;
    say(m_path.isEmpty() ? CommandLine::tr("Standard output cannot be written: %1.").arg(device().errorString())
                         : CommandLine::tr("%1 cannot be written: %2. Choose another file or folder with --output.")
                               .arg(QDir::toNativeSeparators(m_path), device().errorString()));
    return false;
}

bool Output::open()
{
    const bool open =
        m_path.isEmpty() ? m_stream.open(stdout, QIODevice::WriteOnly) : device().open(QIODevice::WriteOnly);
    return open || fail();
}

bool Output::write(const QByteArray &bytes)
{
    if (!m_failed && device().write(bytes) != bytes.size()) {
        m_failed = true;
    }
    return !m_failed;
}

ExitStatus Output::finish()
{
    const bool written = !m_failed && (m_isStream ? m_stream.flush() : m_file.commit());
    return written || fail() ? ExitStatus::Done : ExitStatus::FileFailed;
}

ExitStatus writeAll(const QString &path, const QByteArray &bytes)
{
    Output output(path);
    if (!output.open()) {
        return ExitStatus::FileFailed;
    }
    output.write(bytes);
    return output.finish();
}

} // namespace slidercrank
