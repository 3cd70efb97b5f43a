// SPDX-License-Identifier: GPL-3.0-or-later

// What is written while things go wrong: each call by which a file is changed fails once, the disk is too small, the
// program is killed. Then what was there before is there, or all that is new is; whoever wrote it knows which; and
// nothing else lies about.

#include "tests/support/failing_calls.h"
#include "tests/support/long_tests.h"
#include "tests/support/place_of_a_save.h"
#include "tests/support/suite.h"
#include "tests/support/study_of_a_turn.h"
#include "tests/support/waiting.h"
#include "ui/document/scene.h"
#include "ui/document/whole_file.h"
#include "ui/export/animation_export.h"
#include "ui/panels/study_panel.h"
#include "ui/text/language.h"
#include "ui/text/remember.h"
#include "ui/widgets/message_bar.h"
#include "ui/window/exports.h"
#include "ui/window/main_window.h"
#include "ui/window/scene_file.h"
#include "ui/window/window_settings.h"

#include <QAbstractButton>
#include <QApplication>
#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QMessageBox>
#include <QProcess>
#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <QThread>

#include <cerrno>
#include <csignal>
#include <functional>
#include <memory>
#include <optional>
#include <random>
#include <set>
#include <stop_token>

#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

using namespace slidercrank;

namespace
{

const QString kSample = QStringLiteral(SLIDERCRANK_SOURCE_DIR "/data/inventor_sample.csv");

/// Ignoring the signal, as a disk that is full sends none.
class SmallDisk
{
public:
    explicit SmallDisk(rlim_t bytes)
    {
        std::signal(SIGXFSZ, SIG_IGN);
        getrlimit(RLIMIT_FSIZE, &m_before);
        const rlimit small{bytes, m_before.rlim_max};
        setrlimit(RLIMIT_FSIZE, &small);
    }
    ~SmallDisk() { setrlimit(RLIMIT_FSIZE, &m_before); }
    Q_DISABLE_COPY_MOVE(SmallDisk)

private:
    rlimit m_before{};
};

QProcessEnvironment environment(const QString &folder = {}, int call = 0, const QString &end = {})
{
    QProcessEnvironment all = QProcessEnvironment::systemEnvironment();
    if (call > 0) {
        all.insert(QStringLiteral("LD_PRELOAD"), QStringLiteral(SLIDERCRANK_FAILING_CALLS));
        all.insert(QLatin1String(kFailingFolder), folder);
        all.insert(QLatin1String(kFailingCall), QString::number(call));
        all.insert(QLatin1String(kFailingEnd), end);
        const QString options = all.value(QStringLiteral("ASAN_OPTIONS"));
        all.insert(QStringLiteral("ASAN_OPTIONS"), options + QStringLiteral(":verify_asan_link_order=0"));
    }
    return all;
}

/// `disk`: bytes that a file may have.
Outcome run(const QStringList &arguments, const QProcessEnvironment &environment, std::optional<rlim_t> disk = {})
{
    QProcess program;
    program.setProcessEnvironment(environment);
    if (disk) {
        program.setChildProcessModifier([bytes = *disk] {
            const rlimit small{bytes, bytes};
            setrlimit(RLIMIT_FSIZE, &small);
#ifdef __SANITIZE_THREAD__ // writes a file of its own before the program begins
            std::signal(SIGXFSZ, SIG_IGN);
#endif
        });
    }
    program.start(QStringLiteral(SLIDERCRANK_PROGRAM), arguments);
    program.waitForFinished(kPatience);
    const QByteArray said = program.readAllStandardError();
    const bool isNormal = program.exitStatus() == QProcess::NormalExit;
    if (isNormal && program.exitCode() == 0 && said.isEmpty()) {
        return {true, {}};
    }
    const bool isReason = said.count('\n') == 1 && said.endsWith('\n') && !said.contains("Unknown error");
    if (isNormal && program.exitCode() == 3 && isReason) {
        return {false, {}};
    }
    return {false, QStringLiteral("exit %1, %2").arg(program.exitCode()).arg(QString::fromLocal8Bit(said))};
}

/// Full after nothing, at the ends of buffers, almost at the end.
std::set<rlim_t> disksFor(qint64 size)
{
    std::set<rlim_t> disks;
    for (const qint64 bytes : {qint64(0), qint64(1), qint64(4096), qint64(16384), size / 2, size - 1}) {
        if (bytes < size) {
            disks.insert(static_cast<rlim_t>(bytes));
        }
    }
    return disks;
}

QList<Save> commands()
{
    return {{"solve to CSV", "x.csv", 0, {"solve"}},
            {"solve to JSON", "x.json", 0, {"solve", "--format", "json"}},
            {"compare", "x.csv", 0, {"compare", kSample, "--format", "csv"}},
            {"identify", "x.json", 0, {"identify", kSample, "--format", "json"}},
            {"study", "x.json", 0, {"study", "--format", "json"}},
            {"limits", "x.csv", 0, {"limits", "--format", "csv"}},
            {"render PNG", "x.png", 0, {"render"}},
            {"render SVG", "x.svg", 0, {"render", "--what", "mechanism"}},
            {"render PDF", "x.pdf", 0, {"render"}},
            {"render a report", "x.pdf", 0, {"render", "--what", "report"}}};
}

/// Until it is killed.
int saveScenes(const QString &path)
{
    for (int i = 0;; ++i) {
        Scene scene;
        scene.parameters.b = i % 2 == 0 ? 50.0 : 60.0;
        writeScene(scene, path);
    }
}

} // namespace

class TstFaults : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase();
    void cleanupTestCase();
    void cleanup();

    void aCallOfACommandFails_data() { nameCommands(); }
    void aCallOfACommandFails();
    void aCommandHasLittleRoom_data() { nameCommands(); }
    void aCommandHasLittleRoom();
    void aCommandIsKilledAtACall_data() { nameCommands({"solve to CSV"}); }
    void aCommandIsKilledAtACall();
    void standardOutputHasNoRoom();
    void aStreamIsClosed();
    void aPipeStaysOne();
    void aCallOfTheWindowFails_data() { nameSaves(); }
    void aCallOfTheWindowFails();
    void theWindowHasLittleRoom_data() { nameSaves(); }
    void theWindowHasLittleRoom();
    void theDiskLosesWhatItTook();
    void isNotReplacedWhenStopped();
    void theSettingsHaveNoRoom();
    void isKilledAtAnyInstant();

private:
    void nameCommands(const QByteArrayList &usually = {}) const;
    void nameSaves();
    QList<Save> savesOfTheWindow();
    Outcome saveInWindow(const Save &save, const QString &path);
    void judge(const QString &what, const QString &fault);

    QTemporaryDir m_settings;
    QTemporaryDir m_marks;
    std::unique_ptr<MainWindow> m_window;
    StudyPanel *m_study = nullptr;
    int m_tried = 0;
    int m_wrong = 0;
    QStringList m_faults; ///< of this test
};

void TstFaults::initTestCase()
{
    QStandardPaths::setTestModeEnabled(true);
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_settings.path());
    m_window = std::make_unique<MainWindow>();
    m_window->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
}

void TstFaults::cleanupTestCase()
{
    m_window.reset();
    qInfo("%d faults tried, %d gone wrong", m_tried, m_wrong);
}

void TstFaults::cleanup()
{
    m_faults.clear();
}

void TstFaults::judge(const QString &what, const QString &fault)
{
    ++m_tried;
    if (!fault.isEmpty()) {
        ++m_wrong;
        m_faults += what + QStringLiteral(": ") + fault;
    }
}

/// `usually`: without the others, which do the same.
void TstFaults::nameCommands(const QByteArrayList &usually) const
{
    QTest::addColumn<int>("index");
    int index = 0;
    for (const Save &save : commands()) {
        if (usually.isEmpty() || usually.contains(save.name) || runs(0, 1) == 1) {
            QTest::newRow(save.name) << index;
        }
        ++index;
    }
}

void TstFaults::aCallOfACommandFails()
{
    QFETCH(const int, index);
    const Save save = commands()[index];
    const QString mark = m_marks.filePath(QStringLiteral("failed"));
    qsizetype lines = 0;
    for (int call = 0;; ++call) {
        const Place place(save);
        QFile::remove(mark);
        const Outcome outcome = run(save.arguments + QStringList{QStringLiteral("--output"), place.path()},
                                    environment(place.folder(), call, mark));
        if (call == 0) { // none fails
            lines = place.lines();
        } else if (!QFile::exists(mark)) { // there are fewer
            QVERIFY2(call > 3, "Nothing fails: the library with the calls that do is not loaded");
            QCOMPARE(place.fault(outcome, lines), QString());
            QVERIFY(outcome.isWritten);
            break;
        } else {
            judge(QStringLiteral("call %1").arg(call), place.fault(outcome, lines));
        }
    }
    QVERIFY2(m_faults.isEmpty(), qPrintable(m_faults.join(u'\n')));
}

void TstFaults::aCommandHasLittleRoom()
{
    QFETCH(const int, index);
    const Save save = commands()[index];
    const Place whole(save);
    QVERIFY(run(save.arguments + QStringList{QStringLiteral("--output"), whole.path()}, environment()).isWritten);
    for (const rlim_t disk : disksFor(whole.size())) {
        const Place place(save);
        const Outcome outcome =
            run(save.arguments + QStringList{QStringLiteral("--output"), place.path()}, environment(), disk);
        judge(QStringLiteral("%1 bytes").arg(disk), place.fault(outcome, whole.lines()));
    }
    QVERIFY2(m_faults.isEmpty(), qPrintable(m_faults.join(u'\n')));
}

void TstFaults::aCommandIsKilledAtACall()
{
    QFETCH(const int, index);
    const Save save = commands()[index];
    qsizetype lines = 0;
    for (int call = 0;; ++call) {
        const Place place(save);
        const Outcome outcome = run(save.arguments + QStringList{QStringLiteral("--output"), place.path()},
                                    environment(place.folder(), call, QStringLiteral("kill")));
        if (call == 0) {
            lines = place.lines();
        } else if (outcome.isWritten) {
            QVERIFY(call > 3);
            break;
        } else {
            judge(QStringLiteral("call %1").arg(call), place.faultAfterKill(lines));
        }
    }
    QVERIFY2(m_faults.isEmpty(), qPrintable(m_faults.join(u'\n')));
}

void TstFaults::standardOutputHasNoRoom()
{
    for (const char *line : {"solve", "solve --format json", "limits", "study", "--help", "--version"}) {
        QProcess program;
        program.setStandardOutputFile(QStringLiteral("/dev/full"));
        program.start(QStringLiteral(SLIDERCRANK_PROGRAM), QProcess::splitCommand(QString::fromLatin1(line)));
        QVERIFY(program.waitForFinished(kPatience));
        const QByteArray said = program.readAllStandardError();
        const bool isTold = program.exitCode() == 3 && said.count('\n') == 1 && said.contains("No space left");
        judge(QLatin1String(line), isTold ? QString() : QString::fromLocal8Bit(said));
    }
    QVERIFY2(m_faults.isEmpty(), qPrintable(m_faults.join(u'\n')));
}

/// Then the next file that is opened has its number.
void TstFaults::aStreamIsClosed()
{
    const auto without = [](const QList<int> &streams, const QStringList &arguments) {
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
    QCOMPARE(without({STDIN_FILENO}, {"compare", "-"}), "3 Standard input cannot be read: Bad file descriptor.\n");
    QCOMPARE(without({STDOUT_FILENO}, {"limits"}), "3 Cannot write to standard output: Bad file descriptor.\n");
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("x.csv"));
    const QStringList asked{"compare", kSample, "nowhere.csv", "--format", "csv", "--output", path};
    without({}, asked);
    const QByteArray whole = contentOf(path);
    QVERIFY(QFile::remove(path));
    QCOMPARE(without({STDOUT_FILENO, STDERR_FILENO}, asked), "3 ");
    QCOMPARE(contentOf(path), whole);
}

/// And a device what it is: no file comes in its place.
void TstFaults::aPipeStaysOne()
{
    const QTemporaryDir folder;
    const QString pipe = folder.filePath(QStringLiteral("pipe"));
    const QString link = folder.filePath(QStringLiteral("link"));
    QCOMPARE(mkfifo(qPrintable(pipe), 0600), 0);
    QVERIFY(QFile::link(pipe, link));
    QCOMPARE(writeWhole(pipe, kOlder), QStringLiteral("it is a pipe or a device"));
    QCOMPARE(writeWhole(link, kOlder), QStringLiteral("it is a pipe or a device"));
    QVERIFY(QFileInfo(link).isSymLink() && QFileInfo(pipe).exists() && !QFileInfo(pipe).isFile());
}

QList<Save> TstFaults::savesOfTheWindow()
{
    Exports &exports = m_window->exports();
    MessageBar *bar = m_window->findChild<MessageBar *>();
    const auto picture = [&exports](Exports::Picture (Exports::*which)() const) {
        return [&exports, which](const QString &path) { exports.write((exports.*which)(), path); };
    };
    const auto plot = [&exports](const QString &path) {
        exports.write(exports.plot(QStringLiteral("plot_theta3")), path);
    };
    const auto study = [this, bar](std::optional<QString> (StudyPanel::*write)(const QString &) const) {
        return [this, bar, write](const QString &path) {
            const std::optional<QString> problem = (m_study->*write)(path);
            bar->showMessage({"study", Message::Kind::Hint, problem.value_or(QStringLiteral("Exported to "))});
        };
    };
    return {{"scene", "x.json", 0, {}, [this](const QString &path) { m_window->scene().saveTo(path); }},
            {"figure as PNG", "x.png", 0, {}, picture(&Exports::figure)},
            {"figure as SVG", "x.svg", 0, {}, picture(&Exports::figure)},
            {"figure as PDF", "x.pdf", 0, {}, picture(&Exports::figure)},
            {"mechanism", "x.pdf", 0, {}, picture(&Exports::mechanism)},
            {"plot", "x.png", 0, {}, plot},
            {"report", "x.pdf", 0, {}, [&exports](const QString &path) { exports.writeReport(path); }},
            {"data", "x.csv", 0, {}, [&exports](const QString &path) { exports.writeData(path, plottedChannels()); }},
            {"study as CSV", "x.csv", 0, {}, study(&StudyPanel::exportNumbers)},
            {"study as JSON", "x.json", 0, {}, study(&StudyPanel::exportNumbers)},
            {"study as PNG", "x.png", 0, {}, study(&StudyPanel::exportPicture)}};
}

void TstFaults::nameSaves()
{
    Sampling sampling;
    sampling.duration = 0.03;
    m_window->session().setSampling(sampling);
    if (!m_study) {
        m_study = new StudyPanel(m_window.get());
        m_study->setResult(studyOfATurn());
    }
    QTest::addColumn<int>("index");
    int index = 0;
    for (const Save &save : savesOfTheWindow()) {
        QTest::newRow(save.name) << index++;
    }
}

Outcome TstFaults::saveInWindow(const Save &save, const QString &path)
{
    auto *bar = m_window->findChild<MessageBar *>();
    bar->clear();
    save.inWindow(path);
    settle(); // questions that are answered go
    const bool isTold = QTest::qWaitFor([bar] { return !bar->text().isEmpty(); }, kPatience);
    const QString text = bar->text();
    const bool isWritten = text.startsWith(QLatin1String("Exported to ")) || text.startsWith(QLatin1String("Saved: "));
    const bool isReason = text.contains(QLatin1String("cannot be written")) && !text.contains(QLatin1String("Unknown"));
    return {isWritten, isTold && (isWritten || isReason) ? QString() : QStringLiteral("said: ") + text};
}

void TstFaults::aCallOfTheWindowFails()
{
    QFETCH(const int, index);
    const Save save = savesOfTheWindow()[index];
    qsizetype lines = 0;
    for (int call = 0;; ++call) {
        const Place place(save);
        failCall(qPrintable(place.folder()), call);
        const Outcome outcome = saveInWindow(save, place.path());
        const bool isLast = call > 0 && !hasFailed();
        failCall("", 0);
        if (call == 0) {
            lines = place.lines();
        } else if (isLast) {
            QVERIFY2(call > 3, "Nothing fails: the calls of the C library are not ours");
            QCOMPARE(place.fault(outcome, lines), QString());
            QVERIFY(outcome.isWritten);
            break;
        } else {
            judge(QStringLiteral("call %1").arg(call), place.fault(outcome, lines));
        }
    }
    QVERIFY2(m_faults.isEmpty(), qPrintable(m_faults.join(u'\n')));
}

void TstFaults::theWindowHasLittleRoom()
{
    QFETCH(const int, index);
    const Save save = savesOfTheWindow()[index];
    const Place whole(save);
    const Outcome all = saveInWindow(save, whole.path());
    QCOMPARE(whole.fault(all, whole.lines()), QString());
    for (const rlim_t disk : disksFor(whole.size())) {
        const Place place(save);
        Outcome outcome;
        {
            const SmallDisk small(disk);
            outcome = saveInWindow(save, place.path());
        }
        judge(QStringLiteral("%1 bytes").arg(disk), place.fault(outcome, whole.lines()));
    }
    QVERIFY2(m_faults.isEmpty(), qPrintable(m_faults.join(u'\n')));
}

/// Which only shows when it is asked, after opening and writing, and once: Qt asks again, and does not listen.
void TstFaults::theDiskLosesWhatItTook()
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("x.txt"));
    failCall(qPrintable(folder.path()), 3);
    const std::optional<QString> reason = writeWhole(path, kOlder);
    QVERIFY(hasFailed());
    failCall("", 0);
    QCOMPARE(reason, qt_error_string(EIO));
    QCOMPARE(namesIn(folder.path()), QStringList());
}

void TstFaults::isNotReplacedWhenStopped()
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("x.csv"));
    QVERIFY(!writeWhole(path, "older"));
    {
        WholeFile file(path);
        QVERIFY(file.open() && file.write("newer"));
        std::stop_source stop;
        stop.request_stop(); // while the disk takes its time
        QVERIFY(!file.commit(stop.get_token()));
    }
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    QCOMPARE(file.readAll(), QByteArray("older"));
    QCOMPARE(QDir(folder.path()).entryList(QDir::Files).size(), 1);
}

void TstFaults::theSettingsHaveNoRoom()
{
    rememberLanguage(Language::Spanish);
    rememberTheme(Theme::Dark);
    remember(layoutOf(*m_window));
    const QString path = QSettings().fileName();
    const QByteArray before = contentOf(path);
    QVERIFY(before.contains("theme") && before.contains("language"));
    for (const rlim_t disk : disksFor(before.size())) {
        const SmallDisk small(disk);
        rememberTheme(Theme::Light);
        rememberFile(kRecentScenes, QStringLiteral("x.json"));
        rememberLanguage(Language::English);
        remember(layoutOf(*m_window));
        judge(QStringLiteral("%1 bytes").arg(disk),
              contentOf(path) == before ? QString() : QString::fromUtf8(contentOf(path)));
    }
    QCOMPARE(namesIn(QFileInfo(path).path()), QStringList(QFileInfo(path).fileName()));
    QVERIFY2(m_faults.isEmpty(), qPrintable(m_faults.join(u'\n')));
    rememberLanguage(Language::System); // there is room again
    QVERIFY(!contentOf(path).contains("language"));
}

void TstFaults::isKilledAtAnyInstant()
{
    const QList<Save> saves{{"a long table", "x.csv", 0, {"solve", "--steps", "20000", "--channels", "all"}},
                            {"a figure", "x.svg", 0, {"render"}},
                            {"a report", "x.pdf", 0, {"render", "--what", "report"}},
                            {"scene after scene", "x.json", 0, {}}};
    std::mt19937 random(12);
    for (const Save &save : saves) {
        const bool isScene = save.arguments.isEmpty();
        const QString program = isScene ? QCoreApplication::applicationFilePath() : QStringLiteral(SLIDERCRANK_PROGRAM);
        const auto argumentsFor = [&](const Place &place) {
            return isScene ? QStringList{QStringLiteral("tst_faults"), QStringLiteral("--save-scenes"), place.path()}
                           : save.arguments + QStringList{QStringLiteral("--output"), place.path()};
        };
        qint64 duration = 200; // ms
        qsizetype lines = 0;
        if (!isScene) {
            const Place place(save);
            QElapsedTimer clock;
            clock.start();
            QVERIFY(run(argumentsFor(place), environment()).isWritten);
            duration = clock.elapsed();
            lines = place.lines();
        }
        for (int i = 0; i < runs(4, 40); ++i) {
            const Place place(save);
            QProcess process;
            process.start(program, argumentsFor(place));
            QVERIFY(process.waitForStarted(kPatience));
            QThread::usleep(
                std::uniform_int_distribution<unsigned long>(0, 1000UL * static_cast<unsigned long>(duration))(random));
            process.kill();
            process.waitForFinished(kPatience);
            judge(QStringLiteral("%1, %2").arg(QLatin1String(save.name)).arg(i), place.faultAfterKill(lines));
        }
    }
    QVERIFY2(m_faults.isEmpty(), qPrintable(m_faults.join(u'\n')));
}

static int runSuite(int argc, char *argv[])
{
    if (argc == 3 && QByteArrayView(argv[1]) == "--save-scenes") {
        return saveScenes(QString::fromLocal8Bit(argv[2]));
    }
    const QApplication application(argc, argv);
    TstFaults test;
    return QTest::qExec(&test, argc, argv);
}

const Suite suite("tst_faults", runSuite);
#include "tst_faults.moc"
