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

bool isBorrowed = false; // slidercrank.exe has no console of its own, slidercrank.com has (app/package/windows.cmake)
UINT codePageBefore = 0;

} // namespace

void prepareStreams() {}

void useConsole()
{
    isBorrowed = AttachConsole(ATTACH_PARENT_PROCESS) != FALSE;
    codePageBefore = GetConsoleOutputCP();
    SetConsoleOutputCP(CP_UTF8);
    std::atexit(leaveConsole);
    for (FILE *stream : {stdout, stderr}) {
        if (isBorrowed && _fileno(stream) < 0) { // neither a file nor a pipe
            std::freopen("CONOUT$", "w", stream);
        }
    }
    for (FILE *stream : {stdin, stdout, stderr}) {
        if (_fileno(stream) >= 0) {
            _setmode(_fileno(stream), _O_BINARY); // or an end of line becomes two bytes, and 0x1a the end of all
        }
    }
}

void leaveConsole()
{
    std::fflush(nullptr);
    if (codePageBefore != 0) {
        SetConsoleOutputCP(std::exchange(codePageBefore, 0));
    }
    if (std::exchange(isBorrowed, false)) {
        FreeConsole();
    }
}

#else

/// Closed ones are filled with what can be used no more than they can.
void prepareStreams()
{
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (::fcntl(stream, F_GETFD) < 0) {
            ::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY); // as the first that is free
        }
    }
    std::signal(SIGXFSZ, SIG_IGN); // then writing fails
}

void useConsole() {}

void leaveConsole() {}

#endif

} // namespace slidercrank
