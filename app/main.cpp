// SPDX-License-Identifier: GPL-3.0-or-later

// Runs a command or opens the window. Only the window needs a display.

#include "app/command_line.h"
#include "app/console.h"
#include "ui/text/language.h"
#include "ui/window/main_window.h"
#include "ui/window/messages.h"
#include "ui/window/scene_file.h"

#include <QApplication>
#include <QCoreApplication>
#include <QFile>
#include <QLocale>
#include <QRegularExpression>

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

/// Whether a window can open. On X11 and Wayland, Qt would abort without one of these options and variables.
bool hasDisplay(const QStringList &arguments)
{
#if defined(Q_OS_UNIX) && !defined(Q_OS_DARWIN)
    const auto isSet = [](const char *variable) { return !qEnvironmentVariableIsEmpty(variable); };
    return isSet("DISPLAY") || isSet("WAYLAND_DISPLAY") || isSet("QT_QPA_PLATFORM") ||
           arguments.contains(QRegularExpression("^--?(platform|display)$"));
#else
    Q_UNUSED(arguments)
    return true;
#endif
}

/// Of Qt's own messages, only fatal ones are written to standard error.
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
    } else {
        window.messages().greetOnce();
    }
    return QApplication::exec();
}

} // namespace

int main(int argc, char *argv[])
{
    prepareStreams();
    Command command;
    command.platform = Platform::Window;
    QStringList arguments;
    if (argc > 1) {
        useConsole();
        hideMessagesOfQt();
        const QCoreApplication application(argc, argv);
        setApplicationNames();
        setLanguage(Language::System);
        arguments = QCoreApplication::arguments();
        command = parseCommandLine(arguments);
        if (command.platform == Platform::None) {
            QLocale::setDefault(QLocale::c()); // numbers in the output are the same everywhere
            return run(command);
        }
    }
    const bool isOffscreen = command.platform == Platform::Offscreen;
    if (isOffscreen) {
#ifndef Q_OS_WIN // on Windows drawing needs no display, and only the native platform finds fonts
        if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) {
            qputenv("QT_QPA_PLATFORM", "offscreen");
        }
#endif
    } else if (!hasDisplay(arguments)) {
        std::fprintf(stderr, "%s\n",
                     qPrintable(CommandLine::tr("There is no display for the window: set DISPLAY, or use a "
                                                "command, such as solve, which needs none.")));
        return static_cast<int>(ExitStatus::UsageError);
    } else {
        qInstallMessageHandler(nullptr);
        leaveConsole();
    }
    const QApplication application(argc, argv);
    QApplication::setStyle("Fusion"); // its colours can be chosen on every platform
    setApplicationNames();
    setLanguage(isOffscreen ? Language::System : chosenLanguage());
    return isOffscreen ? run(command) : openWindow(command);
}
