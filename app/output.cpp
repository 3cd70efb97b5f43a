// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/output.h"

#include <QFileDevice>

namespace slidercrank
{

Output::Output(const Streams &streams, const QString &path)
    : m_streams(streams)
    , m_path(path)
    , m_file(path)
{
}

bool Output::fail()
{
    m_streams.report(m_path.isEmpty() ? CommandLine::tr("Cannot write to standard output: %1.")
                                            .arg(withoutFullStop(m_streams.output.errorString()))
                                      : cannotWrite(m_path, m_file.reason()));
    return false;
}

bool Output::open()
{
    return m_path.isEmpty() || m_file.open() || fail();
}

bool Output::write(const QByteArray &bytes)
{
    m_failed = m_failed || (m_path.isEmpty() ? m_streams.output.write(bytes) != bytes.size() : !m_file.write(bytes));
    return !m_failed;
}

ExitStatus Output::finish()
{
    auto *const buffered = qobject_cast<QFileDevice *>(&m_streams.output);
    const bool isWritten = !m_failed && (m_path.isEmpty() ? !buffered || buffered->flush() : m_file.commit());
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
