// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The test suites of a module share one executable (see tests/README.md). A suite is one file with one class of tests,
// which ends with a line such as
//     const Suite newtonSuite("tst_newton", runWithoutApplication<TestNewton>);

#include <QApplication>
#include <QTest>

namespace slidercrank
{

struct Suite {
    using Run = int (*)(int argc, char *argv[]);

    /// Adds the suite to the executable, whose first argument selects it. The remaining arguments are those of Qt Test.
    Suite(const char *name, Run run);
};

template <typename Test>
int runWithoutApplication(int argc, char *argv[])
{
    Test test;
    return QTest::qExec(&test, argc, argv);
}

template <typename Test>
int runWithEventLoop(int argc, char *argv[])
{
    const QCoreApplication application(argc, argv);
    return runWithoutApplication<Test>(argc, argv);
}

template <typename Test>
int runWithWidgets(int argc, char *argv[])
{
    const QApplication application(argc, argv);
    QCoreApplication::setAttribute(Qt::AA_Use96Dpi); // lengths in pixels are the same on every screen
    return runWithoutApplication<Test>(argc, argv);
}

} // namespace slidercrank
