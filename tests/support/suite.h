// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTest>

#include <functional>
#include <map>
#include <string>

namespace slidercrank
{

/// The suites of the program of tests: for each name, a function that runs the suite with arguments of Qt Test and
/// returns the number of failed tests.
inline std::map<std::string, std::function<int(int argc, char **argv)>> &suites()
{
    static std::map<std::string, std::function<int(int argc, char **argv)>> all;
    return all;
}

/// Adds a class of test slots to the suites of the program: `const Suite<TestLimit> suite("tst_limit");`
template <typename Tests>
struct Suite {
    explicit Suite(const char *name)
    {
        suites()[name] = [](int argc, char **argv) {
            Tests tests;
            return QTest::qExec(&tests, argc, argv);
        };
    }
};

} // namespace slidercrank
