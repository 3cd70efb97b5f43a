// SPDX-License-Identifier: GPL-3.0-or-later

// Parses arbitrary arguments, one in each line of the input. They are refused, or become a command that can run.

#include "app/command_line.h"
#include "tests/fuzz/promise.h"

#include <cstddef>
#include <cstdint>

using namespace slidercrank;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *bytes, std::size_t size)
{
    QString text = QString::fromUtf8(reinterpret_cast<const char *>(bytes), static_cast<qsizetype>(size));
    text.remove(QChar::Null); // no operating system passes it
    const Command command = parseCommandLine(QStringList(QStringLiteral("slidercrank")) + text.split(u'\n'));
    require(command.run != nullptr, "there is something to run");
    require(command.scene.isEmpty() || command.platform == Command::Platform::Window, "only the window opens a scene");
    return 0;
}
