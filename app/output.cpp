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

void Output::reportFailure() const
{
    m_streams.report(m_path.isEmpty() ? CommandLine::tr("Cannot write to standard output: %1.")
                                            .arg(withoutFullStop(m_streams.output.errorString()))
                                      : cannotWrite(m_path, m_file.reason()));
}

bool Output::open()
{
    if (m_path.isEmpty() || m_file.open()) {
        return true;
    }
    reportFailure();
    return false;
}

bool Output::write(const QByteArray &bytes)
{
    if (!m_failed) {
        const bool isWritten = m_path.isEmpty() ? m_streams.output.write(bytes) == bytes.size() : m_file.write(bytes);
        m_failed = !isWritten;
    }
    return !m_failed;
}

/// Writes the buffer of a device, if it has one. Returns false on failure.
static bool flush(QIODevice &device)
{
    auto *const buffered = qobject_cast<QFileDevice *>(&device);
    return !buffered || buffered->flush();
}

ExitStatus Output::finish()
{
    if (!m_failed) {
        const bool isWritten = m_path.isEmpty() ? flush(m_streams.output) : m_file.commit();
        m_failed = !isWritten;
    }
    if (m_failed) {
        reportFailure();
        return ExitStatus::FileError;
    }
    return ExitStatus::Success;
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
