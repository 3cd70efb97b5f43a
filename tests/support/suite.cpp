// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/suite.h"

#include <cstdio>
#include <map>
#include <string>

namespace slidercrank
{

namespace
{

std::map<std::string, Suite::Run> &suites()
{
    static std::map<std::string, Suite::Run> byName;
    return byName;
}

} // namespace

Suite::Suite(const char *name, Run run)
{
    suites().emplace(name, run);
}

} // namespace slidercrank

/// Runs the suite named by the first argument or by the symbolic link through which the executable was started.
int main(int argc, char *argv[])
{
    const std::string program = argv[0];
    const auto linked = slidercrank::suites().find(program.substr(program.find_last_of('/') + 1));
    if (linked != slidercrank::suites().end()) {
        return linked->second(argc, argv);
    }
    const auto named = slidercrank::suites().find(argc > 1 ? argv[1] : "");
    if (named != slidercrank::suites().end()) {
        return named->second(argc - 1, argv + 1);
    }
    std::fprintf(stderr, "Usage: %s SUITE [arguments of Qt Test]\nSuites:\n", argv[0]);
    for (const auto &[name, run] : slidercrank::suites()) {
        std::fprintf(stderr, "  %s\n", name.c_str());
    }
    return 2;
}
