// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/byte_stream.h"

#include <QFile>
#include <QFileInfo>

#include <optional>

#ifdef Q_OS_UNIX
#include <cerrno>
#include <fcntl.h>
#include <poll.h>
#include <unistd.h>
#else
#include "ui/document/whole_file.h"
#endif

namespace slidercrank
{

namespace
{

constexpr qsizetype kAtATime = 1 << 16;   // bytes
constexpr qsizetype kBeginning = 1 << 20; // bytes

#ifdef Q_OS_UNIX
/// Opened without waiting for who writes, and with an eye on `stop` while nobody does.
class Stream
{
public:
    explicit Stream(const QString &path)
        : m_descriptor(isStandardInput(path)
                           ? ::fcntl(STDIN_FILENO, F_DUPFD_CLOEXEC, 0)
                           : ::open(QFile::encodeName(path).constData(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC))
    {
    }
    ~Stream()
    {
        if (isOpen()) {
            ::close(m_descriptor);
        }
    }
    Q_DISABLE_COPY_MOVE(Stream)

    bool isOpen() const { return m_descriptor >= 0; }
    QString fault() const { return qt_error_string(errno); }

    /// How many there are; 0 at the end, less than 0 after a fault, none when told to stop.
    std::optional<qsizetype> read(char *room, qsizetype size, const std::stop_token &stop)
    {
        constexpr int kPatience = 50; // ms
        while (!stop.stop_requested()) {
            pollfd state{m_descriptor, POLLIN, 0};
            if (::poll(&state, 1, kPatience) == 0) {
                continue;
            }
            const ssize_t read = ::read(m_descriptor, room, static_cast<std::size_t>(size));
            if (read >= 0 || (errno != EAGAIN && errno != EINTR)) {
                return read;
            }
        }
        return std::nullopt;
    }

private:
    int m_descriptor;
};
#else
class Stream
{
public:
    explicit Stream(const QString &path)
        : m_file(path)
    {
        const QIODevice::OpenMode mode = QIODevice::ReadOnly | QIODevice::Unbuffered;
        constexpr int kStandardInput = 0; // stdin itself would take the end of a pipe for a fault
        isStandardInput(path) ? m_file.open(kStandardInput, mode) : m_file.open(mode);
    }

    bool isOpen() const { return m_file.isOpen(); }
    QString fault() const { return withoutFullStop(m_file.errorString()); }

    std::optional<qsizetype> read(char *room, qsizetype size, const std::stop_token &stop)
    {
        return stop.stop_requested() ? std::nullopt : std::optional<qsizetype>(m_file.read(room, size));
    }

private:
    QFile m_file;
};
#endif

} // namespace

bool isStandardInput(const QString &path)
{
    return path == u"-";
}

bool isPipeOrDevice(const QFileInfo &file)
{
    return file.exists() && !file.isFile() && !file.isDir();
}

bool isStream(const QFileInfo &file)
{
    return isPipeOrDevice(file) || (file.isFile() && file.size() == 0);
}

std::variant<QByteArray, QString> readStream(const QString &path, const std::stop_token &stop,
                                             const std::function<bool(const QByteArray &beginning)> &goesOn)
{
    Stream stream(path);
    if (!stream.isOpen()) {
        return stream.fault();
    }
    QByteArray bytes;
    QByteArray room(kAtATime, Qt::Uninitialized);
    while (const std::optional<qsizetype> read = stream.read(room.data(), room.size(), stop)) {
        if (*read < 0) {
            return stream.fault();
        }
        const bool wasBeginning = bytes.size() < kBeginning;
        bytes.append(room.constData(), *read);
        const bool isNoTable = wasBeginning && bytes.size() >= kBeginning && !goesOn(bytes);
        if (*read == 0 || isNoTable) {
            break;
        }
    }
    return bytes;
}

} // namespace slidercrank
