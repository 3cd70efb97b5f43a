// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/output.h"

#include "ui/document/byte_stream.h"

#include <QDir>
#include <QFileInfo>

#include <cstdio>

namespace slidercrank
{

Output::Output(const QString &path)
    : m_path(path)
    , m_isStream(path.isEmpty() || isPipeOrDevice(QFileInfo(path)))
    , m_stream(path)
    , m_file(path)
{
}

bool Output::fail(const QString &reason)
{
    m_failed = true;
    const QString why = withoutFullStop(reason);
    say(m_path.isEmpty() ? CommandLine::tr("Standard output cannot be written: %1.").arg(why)
                         : CommandLine::tr("%1 cannot be written: %2. Choose another file or folder with --output.")
                               .arg(QDir::toNativeSeparators(m_path), why));
    return false;
}

bool Output::open()
{
    if (!m_isStream) {
        return m_file.open() || fail(m_file.reason());
    }
    return (m_path.isEmpty() ? m_stream.open(stdout, QIODevice::WriteOnly) : m_stream.open(QIODevice::WriteOnly)) ||
           fail(m_stream.errorString());
}

bool Output::write(const QByteArray &bytes)
{
    m_failed = m_failed || !(m_isStream ? m_stream.write(bytes) == bytes.size() : m_file.write(bytes));
    return !m_failed;
}

ExitStatus Output::finish()
{
    const bool written = !m_failed && (m_isStream ? m_stream.flush() : m_file.commit());
    return written || fail(m_isStream ? m_stream.errorString() : m_file.reason()) ? ExitStatus::Done
                                                                                  : ExitStatus::FileFailed;
}

PartedOutput::PartedOutput(const QString &path, const QByteArray &head, const QByteArray &between)
    : m_output(path)
    , m_head(head)
    , m_between(between)
{
}

bool PartedOutput::add(const QByteArray &part)
{
    const QByteArray &before = m_isOpen ? m_between : m_head;
    m_isOpen = m_isOpen ? *m_isOpen : m_output.open();
    return *m_isOpen && m_output.write(before + part);
}

ExitStatus PartedOutput::finish(const QByteArray &tail)
{
    if (!m_isOpen.value_or(false)) {
        return m_isOpen ? ExitStatus::FileFailed : ExitStatus::Done;
    }
    m_output.write(tail);
    return m_output.finish();
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
