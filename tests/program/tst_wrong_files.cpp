// SPDX-License-Identifier: GPL-3.0-or-later

// Files as big as they should not be, files that are none, and no memory for them: the program says so in one line,
// soon, and in little memory. What is sparse takes no room on the disk.

#include "tests/support/suite.h"
#include "tests/support/waiting.h"

#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <memory>

#ifdef Q_OS_UNIX
#include <sys/resource.h>
#include <sys/stat.h>
#endif

namespace
{

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kIsWatched = true; // by who needs much memory himself
#else
constexpr bool kIsWatched = false;
#endif

struct Outcome {
    int status = -1;
    QByteArray out;
    QByteArray err;
};

Outcome outcomeOf(QProcess &process)
{
    Outcome outcome;
    if (process.waitForFinished(slidercrank::kPatience) && process.exitStatus() == QProcess::NormalExit) {
        outcome.status = process.exitCode();
    }
    outcome.out = process.readAllStandardOutput();
    outcome.err = process.readAllStandardError();
    return outcome;
}

Outcome compared(const QString &file)
{
    QProcess process;
    process.start(QStringLiteral(SLIDERCRANK_PROGRAM), {QStringLiteral("compare"), file});
    return outcomeOf(process);
}

bool isOneLine(const QByteArray &text)
{
    return text.endsWith('\n') && text.count('\n') == 1;
}

bool write(const QString &path, const QByteArray &bytes, qint64 size)
{
    QFile file(path);
    return file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size() && file.flush() && file.resize(size);
}

QByteArray rows(int count)
{
    QByteArray bytes = "time,R4_x\n";
    for (int i = 0; i < count; ++i) {
        bytes += QByteArray::number(i) + ",1\n";
    }
    return bytes;
}

} // namespace

class TestWrongFiles : public QObject
{
    Q_OBJECT

private slots:
    void init()
    {
#ifndef Q_OS_UNIX
        QSKIP("Files of this kind are those of Unix.");
#endif
        m_folder = std::make_unique<QTemporaryDir>();
        m_file = m_folder->filePath(QStringLiteral("reference.csv"));
    }

    void refusesLargeFilesThatAreNoTable_data()
    {
        QTest::addColumn<QByteArray>("beginning");
        QTest::addColumn<QByteArray>("says");
        QTest::newRow("zeros") << QByteArray() << QByteArray("line 1: the file holds bytes that are not text");
        QTest::newRow("a spreadsheet") << QByteArray("PK\x03\x04") << QByteArray("a spreadsheet or an archive");
        QTest::newRow("names, then zeros") << rows(0) << QByteArray("line 2: the file holds bytes that are not text");
        QTest::newRow("half of it written")
            << rows(200'000) << QByteArray("larger than 2 GB");
    }

    void refusesLargeFilesThatAreNoTable()
    {
        QFETCH(const QByteArray, beginning);
        QFETCH(const QByteArray, says);
        if (!write(m_file, beginning, qint64{4} << 30)) {
            QSKIP("There are no files of 4 GB here.");
        }
        const Outcome outcome = compared(m_file);
        QVERIFY2(isOneLine(outcome.err) && outcome.err.contains(says), outcome.err.constData());
        QCOMPARE(outcome.out, QByteArray());
        QCOMPARE(outcome.status, 3);
#ifdef Q_OS_UNIX
        rusage used{};
        QCOMPARE(getrusage(RUSAGE_CHILDREN, &used), 0);
        QVERIFY2(kIsWatched || used.ru_maxrss < 100'000, qPrintable(QString::number(used.ru_maxrss)));
#endif
    }

    void refusesWhatIsNoFile_data()
    {
        QTest::addColumn<QString>("path");
        QTest::addColumn<QByteArray>("says");
        QTest::newRow("zeros without end") << QStringLiteral("/dev/zero") << QByteArray("bytes that are not text");
        QTest::newRow("nothing") << QStringLiteral("/dev/null") << QByteArray("The file is empty");
        QTest::newRow("a folder") << QStringLiteral("/") << QByteArray("/ is a folder");
        QTest::newRow("what cannot be read") << QStringLiteral("/proc/self/mem") << QByteArray("cannot be read");
        QTest::newRow("text that is no table") << QStringLiteral("/proc/self/status") << QByteArray("no time column");
        QTest::newRow("not there") << QStringLiteral("/nowhere/x.csv") << QByteArray("cannot be opened");
    }

    void refusesWhatIsNoFile()
    {
        QFETCH(const QString, path);
        QFETCH(const QByteArray, says);
        if (path.startsWith(u"/proc") && !QFile::exists(path)) {
            QSKIP("There is no such thing here.");
        }
        const Outcome outcome = compared(path);
        QVERIFY2(isOneLine(outcome.err) && outcome.err.contains(says), outcome.err.constData());
        QCOMPARE(outcome.status, 3);
    }

    void refusesMoreFilesThanCouldBeComparedInPairs()
    {
        QStringList arguments{QStringLiteral("compare"), QStringLiteral("--join")};
        for (int i = 0; i < 50'000; ++i) {
            arguments += QStringLiteral("/%1.csv").arg(i);
        }
        QProcess process;
        process.start(QStringLiteral(SLIDERCRANK_PROGRAM), arguments);
        const Outcome outcome = outcomeOf(process);
        QVERIFY2(isOneLine(outcome.err) && outcome.err.contains("/0.csv cannot be opened"), outcome.err.constData());
        QCOMPARE(outcome.status, 3);
    }

    /// A window waits for nobody.
    void aPipeIsNoScene()
    {
#ifdef Q_OS_UNIX
        const QString pipe = m_folder->filePath(QStringLiteral("x.slidercrank"));
        QCOMPARE(mkfifo(QFile::encodeName(pipe).constData(), 0600), 0);
        QProcess process;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        for (const char *name : {"QT_QPA_PLATFORM", "DISPLAY", "WAYLAND_DISPLAY"}) {
            environment.remove(QLatin1String(name));
        }
        process.setProcessEnvironment(environment);
        process.start(QStringLiteral(SLIDERCRANK_PROGRAM), {pipe});
        const Outcome outcome = outcomeOf(process);
        QVERIFY2(outcome.err.contains("no display"), outcome.err.constData());
#endif
    }

    void readsAPipeToItsEnd()
    {
#ifdef Q_OS_UNIX
        QCOMPARE(mkfifo(QFile::encodeName(m_file).constData(), 0600), 0);
        QProcess program;
        program.start(QStringLiteral(SLIDERCRANK_PROGRAM),
                      {QStringLiteral("compare"), QStringLiteral("--format"), QStringLiteral("csv"), m_file});
        QVERIFY(program.waitForStarted(slidercrank::kPatience));
        QFile pipe(m_file);
        QVERIFY(pipe.open(QIODevice::WriteOnly)); // when it is opened there
        constexpr int kRows = 300'000;            // more than a pipe holds, and than a beginning
        QCOMPARE(pipe.write(rows(kRows)), rows(kRows).size());
        pipe.close();
        const Outcome outcome = outcomeOf(program);
        QCOMPARE(outcome.status, 0);
        QVERIFY2(outcome.out.contains(QByteArray::number(kRows)), outcome.out.constData());
#endif
    }

    /// In whatever thread, and whatever is the first that there is none for.
    void saysWhenThereIsNoMemory()
    {
#ifdef Q_OS_UNIX
        if (kIsWatched) {
            QSKIP("A sanitizer needs all the addresses there are.");
        }
        QVERIFY(write(m_file, rows(1), rows(1).size()));
        const auto within = [this](rlim_t megabytes) {
            QProcess process;
            process.setChildProcessModifier([megabytes] {
                const rlimit limit{megabytes << 20U, megabytes << 20U};
                setrlimit(RLIMIT_AS, &limit);
            });
            process.start(QStringLiteral(SLIDERCRANK_PROGRAM), {QStringLiteral("compare"), m_file});
            return outcomeOf(process);
        };
        rlim_t least = 64; // for the program itself
        while (within(least).status != 0) {
            least += 32;
            QVERIFY(least < 8192);
        }
        QVERIFY(write(m_file, rows(1'000'000), rows(1'000'000).size()));
        int refused = 0;
        for (rlim_t more = 0; more < 512; more += 16) {
            const Outcome outcome = within(least + more);
            if (outcome.status == 0) {
                break;
            }
            ++refused;
            QCOMPARE(outcome.status, 3);
            QVERIFY2(isOneLine(outcome.err) && outcome.err.contains("not enough memory"), outcome.err.constData());
        }
        QVERIFY2(refused > 3, qPrintable(QString::number(refused)));
#endif
    }

private:
    std::unique_ptr<QTemporaryDir> m_folder;
    QString m_file;
};

const slidercrank::Suite suite("tst_wrong_files", slidercrank::runWithEventLoop<TestWrongFiles>);
#include "tst_wrong_files.moc"
