// SPDX-License-Identifier: GPL-3.0-or-later

// Writes files while system calls fail, while the disk is full, and while the program is killed. Afterwards, either the
// older file or the complete new file must exist, the message or the exit status must say which, and no other file may
// remain.

#include "tests/program/run_program.h"
#include "tests/support/failing_calls.h"
#include "tests/support/long_tests.h"
#include "tests/support/place_of_a_save.h"
#include "tests/support/suite.h"
#include "tests/support/waiting.h"
#include "tests/support/widget_parts.h"
#include "ui/document/whole_file.h"
#include "ui/export/animation_export.h"
#include "ui/widgets/message_bar.h"
#include "ui/window/exports.h"
#include "ui/window/main_window.h"
#include "ui/window/scene_file.h"

#include <QAbstractButton>
#include <QApplication>
#include <QDir>
#include <QFile>
#include <QMessageBox>
#include <QProcess>
#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

#include <cerrno>
#include <csignal>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <stop_token>

#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

using namespace slidercrank;

namespace tst_faults
{

/// Limits the size of files during its lifetime, as if the disk were full.
class FileSizeLimit
{
public:
    explicit FileSizeLimit(rlim_t bytes)
    {
        std::signal(SIGXFSZ, SIG_IGN);
        getrlimit(RLIMIT_FSIZE, &m_before);
        const rlimit small{bytes, m_before.rlim_max};
        setrlimit(RLIMIT_FSIZE, &small);
    }
    ~FileSizeLimit()
    {
        setrlimit(RLIMIT_FSIZE, &m_before);
        std::signal(SIGXFSZ, SIG_DFL); // programs that are started later would otherwise inherit SIG_IGN
    }
    Q_DISABLE_COPY_MOVE(FileSizeLimit)

private:
    rlimit m_before{};
};

/// Returns an environment in which the program is killed at its system call number `call` (from 1) in the folder. For
/// 0, the program is not killed.
QProcessEnvironment environmentKillingAt(int call, const QString &folder)
{
    QProcessEnvironment variables = QProcessEnvironment::systemEnvironment();
    if (call > 0) {
        variables.insert(QStringLiteral("LD_PRELOAD"), QStringLiteral(SLIDERCRANK_FAILING_CALLS));
        variables.insert(QLatin1String(kFailingFolder), folder);
        variables.insert(QLatin1String(kFailingCall), QString::number(call));
        const QString options = variables.value(QStringLiteral("ASAN_OPTIONS"));
        variables.insert(QStringLiteral("ASAN_OPTIONS"), options + QStringLiteral(":verify_asan_link_order=0"));
    }
    return variables;
}

Outcome outcomeOf(const RunResult &result)
{
    if (result.status == 0 && result.error.isEmpty()) {
        return {true, {}};
    }
    if (result.status == 3 && result.hasOneLineError() && !result.error.contains("Unknown error")) {
        return {false, {}};
    }
    return {false, QStringLiteral("exit %1, %2").arg(result.status).arg(QString::fromUtf8(result.error))};
}

QStringList argumentsFor(const Save &save, const Place &place)
{
    return save.arguments + QStringList{"--output", place.path()};
}

/// Starts the program to save the file at the place. `sizeLimit`: largest size of a file, in bytes.
Outcome saveByProgram(const Place &place, const Save &save, const QProcessEnvironment &environment,
                      std::optional<rlim_t> sizeLimit = {})
{
    QProcess program;
    program.setProcessEnvironment(environment);
    if (sizeLimit) {
        program.setChildProcessModifier([bytes = *sizeLimit] {
            const rlimit small{bytes, bytes};
            setrlimit(RLIMIT_FSIZE, &small);
#ifdef __SANITIZE_THREAD__ // the sanitizer writes a file before the program starts
            std::signal(SIGXFSZ, SIG_IGN);
#endif
        });
    }
    program.start(QStringLiteral(SLIDERCRANK_PROGRAM), argumentsFor(save, place));
    return outcomeOf(waitForResult(program));
}

/// Returns size limits at which writing a file of that size fails: at its start, after full buffers, and near its end.
std::set<rlim_t> sizeLimitsFor(qint64 size)
{
    std::set<rlim_t> limits;
    for (const qint64 bytes : {qint64(0), qint64(1), qint64(4096), qint64(16384), size / 2, size - 1}) {
        if (bytes < size) {
            limits.insert(static_cast<rlim_t>(bytes));
        }
    }
    return limits;
}

QList<Save> commands()
{
    return {{"solve to CSV", "x.csv", {"solve"}},
            {"solve to JSON", "x.json", {"solve", "--format", "json"}},
            {"compare", "x.csv", {"compare", kSample, "--b", "60", "--format", "csv"}},
            {"limits", "x.json", {"limits", "--format", "json"}},
            {"render PNG", "x.png", {"render", "--size", "400x400"}},
            {"render SVG", "x.svg", {"render", "--what", "mechanism"}},
            {"render PDF", "x.pdf", {"render"}},
            {"render a report", "x.pdf", {"render", "--what", "report"}}};
}

class TestFaults : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QStandardPaths::setTestModeEnabled(true);
        QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_settings.path());
        m_window = std::make_unique<MainWindow>();
        m_window->resize(600, 500); // pictures of that size are written quickly
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
    }

    void cleanupTestCase()
    {
        m_window.reset();
        qInfo("%d faults tried, %d handled wrongly", m_trials, m_failures);
    }

    void cleanup() { m_faults.clear(); }

    void aSystemCallOfACommandFails_data() { addCommands(); }
    void aSystemCallOfACommandFails()
    {
        QFETCH(const int, index);
        const Save save = commands()[index];
        tryEveryCall(save, failingAt([&](const Place &place) { return outcomeOf(run(argumentsFor(save, place))); }),
                     &Place::fault);
    }

    void aCommandIsKilledAtASystemCall_data() { addCommands({"solve to CSV", "render SVG"}); }
    void aCommandIsKilledAtASystemCall()
    {
        QFETCH(const int, index);
        const Save save = commands()[index];
        const auto attempt = [&](const Place &place, int call) {
            Outcome outcome = saveByProgram(place, save, environmentKillingAt(call, place.folder()));
            outcome.isDisturbed = !outcome.isWritten;
            return outcome;
        };
        tryEveryCall(save, attempt,
                     [](const Place &place, const Outcome &, qsizetype lines) { return place.faultAfterKill(lines); });
    }

    void aSystemCallOfTheWindowFails_data() { addSaves(); }
    void aSystemCallOfTheWindowFails()
    {
        QFETCH(const int, index);
        const Save save = savesOfTheWindow()[index];
        tryEveryCall(save, failingAt([&](const Place &place) { return saveInWindow(save, place.path()); }),
                     &Place::fault);
    }

    void aCommandKeepsTheOldFileOnAFullDisk_data() { addCommands(); }
    void aCommandKeepsTheOldFileOnAFullDisk()
    {
        QFETCH(const int, index);
        const Save save = commands()[index];
        tryEverySizeLimit(save, [&](const Place &place, std::optional<rlim_t> limit) {
            const FileSizeLimit sizeLimit(limit.value_or(RLIM_INFINITY));
            return outcomeOf(run(argumentsFor(save, place)));
        });
    }

    /// The program itself must ignore SIGXFSZ, which exceeding the size limit raises.
    void theProgramKeepsTheOldFileOnAFullDisk_data() { addCommands({"solve to CSV", "render PDF"}); }
    void theProgramKeepsTheOldFileOnAFullDisk()
    {
        QFETCH(const int, index);
        const Save save = commands()[index];
        tryEverySizeLimit(save, [&](const Place &place, std::optional<rlim_t> limit) {
            return saveByProgram(place, save, QProcessEnvironment::systemEnvironment(), limit);
        });
    }

    void theWindowKeepsTheOldFileOnAFullDisk_data() { addSaves(); }
    void theWindowKeepsTheOldFileOnAFullDisk()
    {
        QFETCH(const int, index);
        const Save save = savesOfTheWindow()[index];
        tryEverySizeLimit(save, [&](const Place &place, std::optional<rlim_t> limit) {
            const FileSizeLimit sizeLimit(limit.value_or(RLIM_INFINITY));
            return saveInWindow(save, place.path());
        });
    }

    void aFullStandardOutputIsReported()
    {
        for (const char *line : {"solve", "solve --format json", "limits", "--help", "--version"}) {
            QProcess program;
            program.setStandardOutputFile(QStringLiteral("/dev/full"));
            program.start(QStringLiteral(SLIDERCRANK_PROGRAM), QProcess::splitCommand(QString::fromLatin1(line)));
            QVERIFY(program.waitForFinished(kPatience));
            const QByteArray error = program.readAllStandardError();
            const bool isReported =
                program.exitCode() == 3 && error.count('\n') == 1 && error.contains("No space left");
            recordTrial(QLatin1String(line), isReported ? QString() : QString::fromLocal8Bit(error));
        }
        QVERIFY2(m_faults.isEmpty(), qPrintable(m_faults.join(u'\n')));
    }

    /// The program must not reuse the descriptor of the closed stream for the next file that it opens.
    void aStandardStreamIsClosed()
    {
        const auto runWithout = [](const QList<int> &streams, const QStringList &arguments) {
            QProcess program;
            program.setChildProcessModifier([&streams] {
                for (const int stream : streams) {
                    ::close(stream);
                }
            });
            program.start(QStringLiteral(SLIDERCRANK_PROGRAM), arguments);
            program.waitForFinished(kPatience);
            return QString::number(program.exitCode()) + u' ' + QString::fromLocal8Bit(program.readAllStandardError());
        };
        QCOMPARE(runWithout({STDIN_FILENO}, {"compare", "-"}),
                 "3 Standard input cannot be read: Bad file descriptor.\n");
        QCOMPARE(runWithout({STDOUT_FILENO}, {"limits"}), "3 Cannot write to standard output: Bad file descriptor.\n");
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("x.csv"));
        const QStringList arguments{"compare", kSample, "nowhere.csv", "--format", "csv", "--output", path};
        runWithout({}, arguments);
        const QByteArray complete = contentOf(path);
        QVERIFY(QFile::remove(path));
        QCOMPARE(runWithout({STDOUT_FILENO, STDERR_FILENO}, arguments), "3 ");
        QCOMPARE(contentOf(path), complete);
    }

    /// A symbolic link to a pipe is not replaced either.
    void aPipeIsNotReplaced()
    {
        const QTemporaryDir folder;
        const QString pipe = folder.filePath(QStringLiteral("pipe"));
        const QString link = folder.filePath(QStringLiteral("link"));
        QCOMPARE(mkfifo(qPrintable(pipe), 0600), 0);
        QVERIFY(QFile::link(pipe, link));
        QVERIFY(writeWhole(pipe, kOlder)->contains("it is a pipe or a device"));
        QVERIFY(writeWhole(link, kOlder)->contains("it is a pipe or a device"));
        QVERIFY(QFileInfo(link).isSymLink() && QFileInfo(pipe).exists() && !QFileInfo(pipe).isFile());
    }

    /// The third system call, after opening and writing, synchronizes the file. QSaveFile alone would ignore the
    /// failure.
    void theDiskFailsAfterWriting()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("x.txt"));
        failCall(qPrintable(folder.path()), 3);
        const std::optional<QString> reason = writeWhole(path, kOlder);
        QVERIFY(hasFailed());
        failCall("", 0);
        QVERIFY(reason && reason->contains(qt_error_string(EIO)));
        QCOMPARE(namesIn(folder.path()), QStringList());
    }

    void aStoppedExportReplacesNothing()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("x.csv"));
        QVERIFY(!writeWhole(path, "older"));
        {
            WholeFile file(path);
            QVERIFY(file.open() && file.write("newer"));
            std::stop_source stop;
            stop.request_stop(); // as if the user cancelled while a slow disk writes
            QVERIFY(!file.commit(stop.get_token()));
        }
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        QCOMPARE(file.readAll(), QByteArray("older"));
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files).size(), 1);
    }

private:
    /// Adds a data row for each command of the selection, or for every command if the selection is empty or tests are
    /// long.
    void addCommands(const QByteArrayList &selection = {}) const
    {
        QTest::addColumn<int>("index");
        int index = 0;
        for (const Save &save : commands()) {
            if (selection.isEmpty() || selection.contains(save.name) || areTestsLong()) {
                QTest::newRow(save.name) << index;
            }
            ++index;
        }
    }

    /// Adds a data row for each way of saving by the window, and shortens the motion so that its table is small.
    void addSaves()
    {
        Sampling sampling;
        sampling.duration = 0.03;
        m_window->session().setSampling(sampling);
        QTest::addColumn<int>("index");
        int index = 0;
        for (const Save &save : savesOfTheWindow()) {
            QTest::newRow(save.name) << index++;
        }
    }

    QList<Save> savesOfTheWindow()
    {
        Exports &exports = m_window->exports();
        const auto plot = [&exports](const QString &name) {
            return [&exports, name](const QString &path) { exports.write(exports.plot(name), {}, path); };
        };
        return {{"scene", "x.json", {}, [this](const QString &path) { m_window->scene().saveTo(path); }},
                {"figure as PNG", "x.png", {}, plot({})},
                {"figure as SVG", "x.svg", {}, plot({})},
                {"figure as PDF", "x.pdf", {}, plot({})},
                {"mechanism",
                 "x.pdf",
                 {},
                 [&exports](const QString &path) { exports.write(exports.mechanism(), {}, path); }},
                {"plot", "x.svg", {}, plot("plot_theta3")},
                {"report", "x.pdf", {}, [&exports](const QString &path) { exports.writeReport(path); }},
                {"data", "x.csv", {}, [&exports](const QString &path) { exports.writeData(path, plottedChannels()); }}};
    }

    Outcome saveInWindow(const Save &save, const QString &path)
    {
        auto *bar = m_window->findChild<MessageBar *>();
        bar->removeMessage("confirmation");
        bar->removeMessage("problem");
        save.inWindow(path);
        settle(); // lets answered questions close
        const bool hasMessage = QTest::qWaitFor([bar] { return !messageText(*bar).isEmpty(); }, kPatience);
        const QString text = messageText(*bar);
        const bool isWritten =
            text.startsWith(QLatin1String("Exported to ")) || text.startsWith(QLatin1String("Saved: "));
        const bool isReason =
            text.contains(QLatin1String("cannot be written")) && !text.contains(QLatin1String("Unknown"));
        return {isWritten, hasMessage && (isWritten || isReason) ? QString() : QStringLiteral("message: ") + text};
    }

    /// Returns an attempt that saves while that system call fails.
    static std::function<Outcome(const Place &, int call)> failingAt(const std::function<Outcome(const Place &)> &save)
    {
        return [save](const Place &place, int call) {
            failCall(qPrintable(place.folder()), call);
            Outcome outcome = save(place);
            outcome.isDisturbed = call > 0 && hasFailed();
            failCall("", 0);
            return outcome;
        };
    }

    /// Saves while no system call fails, then while the first one fails, the second one …, until none fails any more.
    /// `findFault` checks the folder after each attempt.
    void tryEveryCall(const Save &save, const std::function<Outcome(const Place &, int call)> &attempt,
                      const std::function<QString(const Place &, const Outcome &, qsizetype lines)> &findFault)
    {
        qsizetype lines = 0;
        for (int call = 0;; ++call) {
            const Place place(save);
            const Outcome outcome = attempt(place, call);
            if (call == 0) {
                lines = place.lines();
            } else if (outcome.isDisturbed) {
                recordTrial(QStringLiteral("call %1").arg(call), findFault(place, outcome, lines));
            } else {
                QVERIFY2(call > 3, "No call fails: the library of failing calls is not loaded");
                QCOMPARE(place.fault(outcome, lines), QString());
                QVERIFY(outcome.isWritten);
                break;
            }
        }
        QVERIFY2(m_faults.isEmpty(), qPrintable(m_faults.join(u'\n')));
    }

    void tryEverySizeLimit(const Save &save,
                           const std::function<Outcome(const Place &, std::optional<rlim_t>)> &attempt)
    {
        const Place undisturbed(save);
        QVERIFY(attempt(undisturbed, {}).isWritten);
        for (const rlim_t limit : sizeLimitsFor(undisturbed.size())) {
            const Place place(save);
            const Outcome outcome = attempt(place, limit);
            recordTrial(QStringLiteral("%1 bytes").arg(limit), place.fault(outcome, undisturbed.lines()));
        }
        QVERIFY2(m_faults.isEmpty(), qPrintable(m_faults.join(u'\n')));
    }

    void recordTrial(const QString &name, const QString &fault)
    {
        ++m_trials;
        if (!fault.isEmpty()) {
            ++m_failures;
            m_faults += name + QStringLiteral(": ") + fault;
        }
    }

    QTemporaryDir m_settings;
    std::unique_ptr<MainWindow> m_window;
    int m_trials = 0;
    int m_failures = 0;
    QStringList m_faults; ///< of the current test
};

const Suite<TestFaults> suite("tst_faults");

} // namespace tst_faults

#include "tst_faults.moc"
