// SPDX-License-Identifier: GPL-3.0-or-later

// Runs a command or opens the window. Only the window needs a display.

#include "app/command_line.h"
#include "app/console.h"
#include "ui/text/language.h"

#include <QApplication>
#include <QByteArray>
#include <QFile>
#include <QList>
#include <QLocale>
#include <QLoggingCategory>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <new>

using namespace slidercrank;

namespace
{

/// Returns whether a window can open. On X11 and Wayland, Qt would abort without one of these variables.
bool hasDisplay()
{
#if defined(Q_OS_UNIX) && !defined(Q_OS_DARWIN)
    const auto isSet = [](const char *variable) { return !qEnvironmentVariableIsEmpty(variable); };
    return isSet("DISPLAY") || isSet("WAYLAND_DISPLAY") || isSet("QT_QPA_PLATFORM");
#else
    return true;
#endif
}

/// Returns whether the argument is text in the encoding of the system. Qt replaces bytes that are not, so that the
/// names of two files could become equal.
bool isText([[maybe_unused]] const QByteArray &argument)
{
#ifdef Q_OS_WIN // Qt reads the command line in UTF-16 instead of these bytes
    return true;
#else
    return QString::fromLocal8Bit(argument).toLocal8Bit() == argument;
#endif
}

ExitStatus run(const QList<QByteArray> &arguments)
{
    QFile output;
    QFile error;
    if (!error.open(stderr, QIODevice::WriteOnly | QIODevice::Unbuffered) ||
        !output.open(stdout, QIODevice::WriteOnly)) {
        return ExitStatus::FileError;
    }
    const Streams streams{output, error};
    const auto undecodable = std::ranges::find_if_not(arguments, isText);
    if (undecodable != arguments.end()) {
        streams.report(CommandLine::tr("\"%1\" contains bytes that are not UTF-8: rename the file.")
                           .arg(QString::fromLocal8Bit(*undecodable)));
        return ExitStatus::UsageError;
    }
    try {
        return runCommandLine(QCoreApplication::arguments(), streams);
    } catch (const std::bad_alloc &) {
        streams.report(CommandLine::tr("There is not enough memory: choose fewer steps or a smaller file."));
        return ExitStatus::FileError;
    }
}

} // namespace

int main(int argc, char *argv[])
{
    prepareStreams();
    if (argc > 1) {
        useConsole();
    }
    Platform platform = platformFor(argc > 1 ? QString::fromLocal8Bit(argv[1]) : QString());
    if (platform == Platform::Window && !hasDisplay()) {
        platform = Platform::Console; // reports wrong arguments, or that there is no display
    }
    if (platform != Platform::Window) {
        QLoggingCategory::setFilterRules("*=false"); // hides messages of Qt, except fatal ones
    }
#ifndef Q_OS_WIN // on Windows drawing needs no display, and only the native platform finds fonts
    if (platform == Platform::Offscreen && qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) {
        qputenv("QT_QPA_PLATFORM", "offscreen");
    }
#endif
    const std::unique_ptr<QCoreApplication> application(platform == Platform::Console ? new QCoreApplication(argc, argv)
                                                                                      : new QApplication(argc, argv));
    QCoreApplication::setOrganizationName("slidercrank"); // names the folder of the settings
    QCoreApplication::setApplicationName("slidercrank");
    QCoreApplication::setApplicationVersion(SLIDERCRANK_VERSION);
    setLanguage(platform == Platform::Window ? chosenLanguage() : Language::System);
    if (platform == Platform::Console) {
        QLocale::setDefault(QLocale::c()); // numbers in the output are the same everywhere
    } else {
        QApplication::setStyle("Fusion"); // its colours can be chosen on every platform
    }
    return static_cast<int>(run(QList<QByteArray>(argv, argv + argc)));
}
