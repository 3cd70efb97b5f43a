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
#endif

namespace slidercrank
{

#ifdef Q_OS_WIN

namespace
{

bool isBorrowed = false; // slidercrank.exe has no console of its own, slidercrank.com has (app/package/windows.cmake)
UINT codePageBefore = 0;

} // namespace

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

void useConsole() {}

void leaveConsole() {}

#endif

} // namespace slidercrank
