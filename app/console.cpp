// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console.h"

#include <QtGlobal>

#ifdef Q_OS_WIN
#include <cstdio>
#include <cstdlib>
#include <utility>

#include <fcntl.h>
#include <io.h>
#include <windows.h>
#else
#include <csignal>

#include <fcntl.h>
#include <unistd.h>
#endif

namespace slidercrank
{

#ifdef Q_OS_WIN

namespace
{

bool isAttached = false; // slidercrank.exe has no console of its own, slidercrank.com has (app/package/windows.cmake)
UINT codePageBefore = 0;

} // namespace

void prepareStreams() {}

void useConsole()
{
    isAttached = AttachConsole(ATTACH_PARENT_PROCESS) != FALSE;
    codePageBefore = GetConsoleOutputCP();
    SetConsoleOutputCP(CP_UTF8);
    std::atexit(leaveConsole);
    for (FILE *stream : {stdout, stderr}) {
        if (isAttached && _fileno(stream) < 0) { // neither a file nor a pipe
            std::freopen("CONOUT$", "w", stream);
        }
    }
    for (FILE *stream : {stdin, stdout, stderr}) {
        if (_fileno(stream) >= 0) {
            _setmode(_fileno(stream), _O_BINARY); // text mode changes line ends, and ends the input at byte 0x1a
        }
    }
}

void leaveConsole()
{
    std::fflush(nullptr);
    if (codePageBefore != 0) {
        SetConsoleOutputCP(std::exchange(codePageBefore, 0));
    }
    if (std::exchange(isAttached, false)) {
        FreeConsole();
    }
}

#else

void prepareStreams()
{
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (::fcntl(stream, F_GETFD) < 0) {
            // Takes the lowest free descriptor, which is this one; reading or writing the stream still fails.
            ::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
        }
    }
    std::signal(SIGXFSZ, SIG_IGN);
}

void useConsole() {}

void leaveConsole() {}

#endif

} // namespace slidercrank
