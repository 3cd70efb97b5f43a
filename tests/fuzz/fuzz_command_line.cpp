// SPDX-License-Identifier: GPL-3.0-or-later

// Any words as a command line, one a line of the input: refused in a sentence, or something that can be done.

#include "app/options.h"
#include "tests/fuzz/promise.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <variant>

using namespace slidercrank;

namespace
{

void check(const QString &sentence)
{
    require(sentence.size() > 1 && !sentence.startsWith(u' '), "a sentence");
}

void check(const Sampling &sampling)
{
    require(sampling.steps > 0 && sampling.duration > 0.0 && std::isfinite(sampling.start), "there are instants");
}

void check(const WindowOptions &) {}

void check(const SolveOptions &options)
{
    check(options.sampling);
    require(options.channels.any(), "something is asked for");
    require(!options.atInstant || std::isfinite(*options.atInstant), "the instant is one");
    require(options.solver.newton.maxIterations > 0 && options.solver.newton.tolerance >= 0.0, "it can be solved");
}

void check(const LimitsOptions &options)
{
    require(!findFault(options.mechanism.parameters()), "there is a mechanism");
}

void check(const CompareOptions &options)
{
    require(!options.references.isEmpty(), "there are files");
}

void check(const IdentifyOptions &options)
{
    require(!options.references.isEmpty() && options.format != Format::Csv, "there are files");
}

void check(const StudyOptions &options)
{
    require(!options.cases.empty(), "there are cases");
}

void check(const RenderOptions &options)
{
    check(options.sampling);
    require(!options.output.isEmpty() && !options.size.isEmpty(), "there is a picture");
    require(options.scale > 0.0 && options.speed > 0.0 && std::isfinite(options.poseInstant), "of something");
}

void check(const ResetSettings &) {}

void check(const Answer &answer)
{
    check(answer.text);
}

void check(const WrongCommandLine &wrong)
{
    check(wrong.sentence);
}

void check(const UnreadableFile &unreadable)
{
    check(unreadable.sentence);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *bytes, std::size_t size)
{
    QString text = QString::fromUtf8(reinterpret_cast<const char *>(bytes), static_cast<qsizetype>(size));
    text.remove(QChar::Null); // no system hands that over
    const Command command = parseCommandLine(QStringList(QStringLiteral("slidercrank")) + text.split(u'\n'));
    std::visit([](const auto &each) { check(each); }, command);
    return 0;
}
