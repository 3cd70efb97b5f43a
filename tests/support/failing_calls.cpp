// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/failing_calls.h"

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

// Replaces functions of the C library for the whole process. The replacements make the system calls directly, so that
// they need no other function and no initialization before main().

namespace
{

constexpr std::size_t kLongestPath = 4096;

char folder[kLongestPath];
bool kills = false;
std::atomic<int> remaining = 0; ///< calls up to and including the one that fails; 0: none fails
std::atomic<bool> failed = false;

[[gnu::constructor]] void readEnvironment()
{
    const char *where = std::getenv(slidercrank::kFailingFolder);
    const char *number = std::getenv(slidercrank::kFailingCall);
    if (where && number) {
        kills = true;
        failCall(where, std::atoi(number));
    }
}

/// Counts a call that would change the file at this path. Returns whether the call must fail.
bool fails(const char *path)
{
    if (remaining == 0 || std::strncmp(path, folder, std::strlen(folder)) != 0) {
        return false;
    }
    if (--remaining != 0) {
        return false;
    }
    failed = true;
    if (kills) {
        syscall(SYS_kill, getpid(), SIGKILL);
    }
    return true;
}

bool fails(int descriptor)
{
    struct stat status = {};
    if (remaining == 0 || fstat(descriptor, &status) != 0 || !S_ISREG(status.st_mode)) {
        return false;
    }
    char link[64];
    char path[kLongestPath];
    std::snprintf(link, sizeof link, "/proc/self/fd/%d", descriptor);
    const ssize_t length = readlink(link, path, sizeof path - 1);
    path[length > 0 ? length : 0] = '\0';
    return fails(path);
}

template <typename... Arguments>
long failOr(bool isFailing, int error, long number, Arguments... arguments)
{
    if (isFailing) {
        errno = error;
        return -1;
    }
    return syscall(number, arguments...);
}

int opened(int directory, const char *path, int flags, mode_t mode)
{
    const bool writes = (flags & O_ACCMODE) != O_RDONLY;
    return static_cast<int>(failOr(writes && fails(path), ENOSPC, SYS_openat, directory, path, flags, mode));
}

/// Returns the mode argument of an open() call that may create a file, otherwise 0.
mode_t modeOf(int flags, va_list arguments)
{
    return (flags & O_CREAT) != 0 || (flags & O_TMPFILE) == O_TMPFILE ? va_arg(arguments, mode_t) : 0;
}

} // namespace

// NOLINTBEGIN: the C library defines these names and arguments
extern "C" {

void failCall(const char *where, int number)
{
    remaining = 0;
    std::snprintf(folder, sizeof folder, "%s", where);
    failed = false;
    remaining = number;
}

bool hasFailed()
{
    return failed;
}

#define OPEN(name)                                                                                                     \
    int name(const char *path, int flags, ...)                                                                         \
    {                                                                                                                  \
        va_list arguments;                                                                                             \
        va_start(arguments, flags);                                                                                    \
        const mode_t mode = modeOf(flags, arguments);                                                                  \
        va_end(arguments);                                                                                             \
        return opened(AT_FDCWD, path, flags, mode);                                                                    \
    }
OPEN(open)
OPEN(open64)

#define OPENAT(name)                                                                                                   \
    int name(int directory, const char *path, int flags, ...)                                                          \
    {                                                                                                                  \
        va_list arguments;                                                                                             \
        va_start(arguments, flags);                                                                                    \
        const mode_t mode = modeOf(flags, arguments);                                                                  \
        va_end(arguments);                                                                                             \
        return opened(directory, path, flags, mode);                                                                   \
    }
OPENAT(openat)
OPENAT(openat64)

ssize_t write(int descriptor, const void *bytes, size_t count)
{
    return failOr(fails(descriptor), ENOSPC, SYS_write, descriptor, bytes, count);
}

ssize_t pwrite64(int descriptor, const void *bytes, size_t count, off64_t offset)
{
    return failOr(fails(descriptor), ENOSPC, SYS_pwrite64, descriptor, bytes, count, offset);
}

int fsync(int descriptor)
{
    return static_cast<int>(failOr(fails(descriptor), EIO, SYS_fsync, descriptor));
}

int fdatasync(int descriptor)
{
    return static_cast<int>(failOr(fails(descriptor), EIO, SYS_fdatasync, descriptor));
}

int mkdir(const char *path, mode_t mode) noexcept
{
    return static_cast<int>(failOr(fails(path), ENOSPC, SYS_mkdirat, AT_FDCWD, path, mode));
}

int linkat(int from, const char *path, int to, const char *target, int flags) noexcept
{
    return static_cast<int>(failOr(fails(target), ENOSPC, SYS_linkat, from, path, to, target, flags));
}

int renameat2(int from, const char *path, int to, const char *target, unsigned int flags) noexcept
{
    return static_cast<int>(failOr(fails(target), EIO, SYS_renameat2, from, path, to, target, flags));
}

int rename(const char *path, const char *target) noexcept
{
    return renameat2(AT_FDCWD, path, AT_FDCWD, target, 0);
}
}
// NOLINTEND
