// SPDX-License-Identifier: GPL-3.0-or-later
// <program> <suite> [arguments of Qt Test]: runs one of the suites of the program.
#include "tests/support/suite.h"

#include <QApplication>

#include <cstdio>

int main(int argc, char **argv)
{
    const auto &suites = slidercrank::suites();
    const auto suite = argc < 2 ? suites.end() : suites.find(argv[1]);
    if (suite == suites.end()) {
        std::fputs("Give the suite to be run:\n", stderr);
        for (const auto &[name, run] : suites) {
            std::fprintf(stderr, "%s\n", name.c_str());
        }
        return 2;
    }
    if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM")) {
        qputenv("QT_QPA_PLATFORM", "offscreen"); // no suite needs a display
    }
    const QApplication application(argc, argv);
    argv[1] = argv[0];
    return suite->second(argc - 1, argv + 1);
}
