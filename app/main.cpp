// SPDX-License-Identifier: GPL-3.0-or-later

// Starts the window or runs a command. Only the window needs a display.

#include "app/command_line.h"
#include "app/console.h"
#include "ui/text/language.h"
#include "ui/window/main_window.h"
#include "ui/window/scene_file.h"

#include <QApplication>
#include <QCoreApplication>
#include <QFile>
#include <QLocale>

#include <cstdio>
#include <new>

using namespace slidercrank;

namespace
{

void setApplicationNames()
{
    QCoreApplication::setOrganizationName("slidercrank"); // names the folder of the settings
    QCoreApplication::setApplicationName("slidercrank");
    QCoreApplication::setApplicationVersion(SLIDERCRANK_VERSION);
}

int run(const Command &command)
{
    QFile output;
    QFile error;
    if (!error.open(stderr, QIODevice::WriteOnly | QIODevice::Unbuffered) ||
        !output.open(stdout, QIODevice::WriteOnly)) {
        return static_cast<int>(ExitStatus::FileError);
    }
    const Streams streams{output, error};
    try {
        return static_cast<int>(command.run(streams));
    } catch (const std::bad_alloc &) {
        streams.report(CommandLine::tr("There is not enough memory: choose fewer steps or a smaller file."));
        return static_cast<int>(ExitStatus::FileError);
    }
}

/// On X11 and Wayland a window needs one of these variables; without them Qt would abort.
bool hasDisplay()
{
#if defined(Q_OS_UNIX) && !defined(Q_OS_DARWIN)
    return !qEnvironmentVariableIsEmpty("DISPLAY") || !qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY") ||
           !qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM");
#else
    return true;
#endif
}

/// Standard error is for messages of this program; of Qt's only the fatal ones are shown.
void hideMessagesOfQt()
{
    qInstallMessageHandler([](QtMsgType type, const QMessageLogContext &, const QString &text) {
        if (type == QtFatalMsg) {
            std::fprintf(stderr, "%s\n", qPrintable(text));
        }
    });
}

int openWindow(const Command &command)
{
    MainWindow window;
    window.showWithinScreen();
    if (!command.scene.isEmpty()) {
        window.scene().open(command.scene, command.referenceFiles);
    } else if (!command.referenceFiles.isEmpty()) {
        window.openReference(command.referenceFiles);
    }
    return QApplication::exec();
}

} // namespace

int main(int argc, char *argv[])
{
    prepareStreams();
    Command command;
    command.platform = Command::Platform::Window;
    if (argc > 1) {
        useConsole();
        hideMessagesOfQt();
        const QCoreApplication application(argc, argv);
        setApplicationNames();
        setLanguage(Language::System);
        command = parseCommandLine(QCoreApplication::arguments());
        if (command.platform == Command::Platform::None) {
            QLocale::setDefault(QLocale::c()); // numbers in a stream are the same everywhere
            return run(command);
        }
    }
    const bool draws = command.platform == Command::Platform::Offscreen;
    if (draws) {
#ifndef Q_OS_WIN // where drawing needs no display, and fonts are found only with the native platform
        if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) {
            qputenv("QT_QPA_PLATFORM", "offscreen");
        }
#endif
    } else if (!hasDisplay() && !command.choosesPlatform) {
        std::fprintf(stderr, "%s\n",
                     qPrintable(CommandLine::tr("There is no display for the window: set DISPLAY, or use a "
                                                "command, such as solve, which needs none.")));
        return static_cast<int>(ExitStatus::UsageError);
    } else {
        qInstallMessageHandler(nullptr);
        leaveConsole();
    }
    const QApplication application(argc, argv);
    QApplication::setStyle("Fusion"); // its palette can be chosen on every platform
    setApplicationNames();
    setLanguage(draws ? Language::System : chosenLanguage());
    return draws ? run(command) : openWindow(command);
}
