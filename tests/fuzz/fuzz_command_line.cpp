// SPDX-License-Identifier: GPL-3.0-or-later

// Reads the options that the commands share from arbitrary arguments, one in each line of the input. The arguments
// are refused, or give valid settings.

#include "app/option_groups.h"
#include "tests/fuzz/promise.h"

#include <cstddef>
#include <cstdint>

using namespace slidercrank;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *bytes, std::size_t size)
{
    QString text = QString::fromUtf8(reinterpret_cast<const char *>(bytes), static_cast<qsizetype>(size));
    text.remove(QChar::Null); // no operating system passes it
    const QStringList arguments = text.split(u'\n');
    for (const char *name : {"solve", "compare", "render"}) {
        try {
            const OptionReader options(*findCommand(QLatin1String(name)), arguments.mid(1));
            const Mechanism mechanism = readMechanism(options);
            require(!findFault(mechanism.parameters()), "the mechanism is valid");
            require(readSampling(options).steps > 0, "there are time steps");
            readSolver(options);
            readColumns(options);
            readTimeStamp(options, mechanism);
        } catch (const UsageError &error) {
            require(!error.message.isEmpty(), "a wrong option is explained");
        }
    }
    return 0;
}
