// SPDX-License-Identifier: GPL-3.0-or-later

// Chooses: the window, or a command line. Only the window needs a display.

#include "app/command_line.h"
#include "app/console.h"
#include "app/output.h"
#include "app/subcommands.h"
#include "ui/window/application.h"
#include "ui/window/main_window.h"
#include "ui/window/scene_file.h"
#include "ui/text/language.h"

#include <QApplication>
#include <QCoreApplication>
#include <QLocale>
#include <QSettings>

#include <new>

using namespace slidercrank;

namespace
{

void introduceApplication()
{
    QCoreApplication::setOrganizationName(QStringLiteral("slidercrank")); // where the settings are kept
    QCoreApplication::setApplicationName(QStringLiteral("slidercrank"));
    QCoreApplication::setApplicationVersion(QStringLiteral(SLIDERCRANK_VERSION));
}

ExitStatus resetSettings()
{
    QSettings settings;
    settings.clear();
    settings.sync();
    if (settings.status() != QSettings::NoError) {
        say(CommandLine::tr("The settings in %1 cannot be written: remove them there.").arg(settings.fileName()));
        return ExitStatus::FileFailed;
    }
    return writeAll(
        {}, CommandLine::tr("Forgotten: layout, recent files, language, theme, choices of columns.").toUtf8() + '\n');
}

/// None for what needs more than a QCoreApplication.
std::optional<ExitStatus> runWithoutPlatform(const Command &command)
{
    if (std::holds_alternative<WindowOptions>(command) || std::holds_alternative<RenderOptions>(command)) {
        return std::nullopt;
    }
    QLocale::setDefault(QLocale::c()); // what goes to a stream is the same everywhere
    if (const WrongCommandLine *wrong = std::get_if<WrongCommandLine>(&command)) {
        say(wrong->sentence);
        return ExitStatus::WrongCommandLine;
    }
    if (const UnreadableFile *unreadable = std::get_if<UnreadableFile>(&command)) {
        say(unreadable->sentence);
        return ExitStatus::FileFailed;
    }
    if (std::holds_alternative<ResetSettings>(command)) {
        return resetSettings();
    }
    if (const Answer *answer = std::get_if<Answer>(&command)) {
        return writeAll({}, answer->text.toUtf8());
    }
    if (const SolveOptions *options = std::get_if<SolveOptions>(&command)) {
        return solve(*options);
    }
    if (const LimitsOptions *options = std::get_if<LimitsOptions>(&command)) {
        return limits(*options);
    }
    if (const CompareOptions *options = std::get_if<CompareOptions>(&command)) {
        return compareFiles(*options);
    }
    if (const IdentifyOptions *options = std::get_if<IdentifyOptions>(&command)) {
        return identifyFiles(*options);
    }
    if (const StudyOptions *options = std::get_if<StudyOptions>(&command)) {
        return study(*options);
    }
    return std::nullopt;
}

/// What there is no memory for ends with a sentence as well.
template <typename Work>
auto orWithoutMemory(const Work &work) -> decltype(work())
{
    try {
        return work();
    } catch (const std::bad_alloc &) {
        say(CommandLine::tr("There is not enough memory for that: try fewer steps, or a smaller file."));
        return ExitStatus::FileFailed;
    }
}

/// On X11 and Wayland a window needs one of these variables; Qt would abort without.
bool hasDisplay()
{
#if defined(Q_OS_UNIX) && !defined(Q_OS_DARWIN)
    return !qEnvironmentVariableIsEmpty("DISPLAY") || !qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY") ||
           !qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM");
#else
    return true;
#endif
}

} // namespace

int main(int argc, char *argv[])
{
    prepareStreams();
    Command command = WindowOptions();
    if (argc > 1) {
        useConsole();
        // Standard error is for our own sentences; what Qt misses in a session without a desktop, or in the locale C,
        // is not among them, unless it is the end.
        qInstallMessageHandler([](QtMsgType type, const QMessageLogContext &, const QString &text) {
            if (type == QtFatalMsg) {
                say(text);
            }
        });
        const QCoreApplication application(argc, argv);
        introduceApplication();
        setLanguage(Language::System);
        command = parseCommandLine(QCoreApplication::arguments());
        const auto answer = [&command] { return runWithoutPlatform(command); };
        if (const std::optional<ExitStatus> status = orWithoutMemory(answer)) {
            return static_cast<int>(*status);
        }
    }
    const RenderOptions *picture = std::get_if<RenderOptions>(&command);
    if (picture) {
#ifndef Q_OS_WIN // which can draw in any session, and knows its fonts only so
        if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) {
            qputenv("QT_QPA_PLATFORM", "offscreen");
        }
#endif
    } else if (!hasDisplay() && !std::get<WindowOptions>(command).choosesDisplay) {
        say(QCoreApplication::translate(
            "slidercrank::CommandLine",
            "There is no display to open the window on: set DISPLAY, or use solve, limits, compare, identify, "
            "study or render, which need none."));
        return static_cast<int>(ExitStatus::WrongCommandLine);
    }
    if (!picture) {
        qInstallMessageHandler(nullptr);
        leaveConsole();
    }
    const Application application(argc, argv);
    QApplication::setStyle(QStringLiteral("Fusion")); // the one whose palettes are ours to choose, on every platform
    introduceApplication();
    setLanguage(picture ? Language::System : chosenLanguage());
    if (picture) {
        return static_cast<int>(orWithoutMemory([picture] { return render(*picture); }));
    }
    MainWindow window;
    window.showWithinScreen();
    const WindowOptions &options = std::get<WindowOptions>(command);
    if (!options.scene.isEmpty()) {
        window.scene().open(options.scene, options.reference);
    } else if (!options.reference.isEmpty()) {
        window.openReference(options.reference);
    }
    return QApplication::exec();
}
