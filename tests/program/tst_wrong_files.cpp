// SPDX-License-Identifier: GPL-3.0-or-later

// The program refuses files that are too large or not tables, and reports insufficient memory. Each message has one
// line. The program must not use much memory for this. The large files are sparse and take no space on the disk.

#include "tests/program/run_program.h"
#include "tests/support/long_tests.h"
#include "tests/support/suite.h"

#include <QTemporaryDir>
#include <QTest>

#include <memory>

#ifdef Q_OS_UNIX
#include <sys/resource.h>
#include <sys/stat.h>
#endif

using namespace slidercrank;

namespace tst_wrong_files
{

/// Writes the bytes, and extends the file with zeros to `size` bytes. Returns whether this succeeded.
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

class TestWrongFiles : public QObject
{
    Q_OBJECT

private slots:
    void init()
    {
#ifndef Q_OS_UNIX
        QSKIP("These files exist on Unix only.");
#endif
        m_folder = std::make_unique<QTemporaryDir>();
        m_file = m_folder->filePath(QStringLiteral("reference.csv"));
    }

    void refusesLargeFiles_data()
    {
        QTest::addColumn<QByteArray>("beginning");
        QTest::addColumn<QByteArray>("message");
        QTest::newRow("zeros") << QByteArray() << QByteArray("line 1: the file holds bytes that are not text");
        QTest::newRow("a spreadsheet") << QByteArray("PK\x03\x04") << QByteArray("a spreadsheet or an archive");
        QTest::newRow("headings, then zeros")
            << rows(0) << QByteArray("line 2: the file holds bytes that are not text");
        QTest::newRow("rows, then zeros") << rows(200'000) << QByteArray("larger than 2 GB");
    }

    void refusesLargeFiles()
    {
        QFETCH(const QByteArray, beginning);
        QFETCH(const QByteArray, message);
        if (!write(m_file, beginning, qint64{4} << 30)) {
            QSKIP("This file system has no files of 4 GB.");
        }
        const RunResult outcome = runProgram({"compare", m_file});
        QVERIFY2(outcome.hasOneLineError() && outcome.error.contains(message), outcome.error);
        QCOMPARE(outcome.output, QByteArray());
        QCOMPARE(outcome.status, 3);
#ifdef Q_OS_UNIX
        constexpr long kLargestMemory = 100'000; // kB
        rusage used{};
        QCOMPARE(getrusage(RUSAGE_CHILDREN, &used), 0);
        QVERIFY2(kIsSanitized || used.ru_maxrss < kLargestMemory, qPrintable(QString::number(used.ru_maxrss)));
#endif
    }

    void refusesFoldersAndDevices_data()
    {
        QTest::addColumn<QString>("path");
        QTest::addColumn<QByteArray>("message");
        QTest::newRow("endless zeros") << "/dev/zero" << QByteArray("bytes that are not text");
        QTest::newRow("nothing") << "/dev/null" << QByteArray("The file is empty");
        QTest::newRow("a folder") << "/" << QByteArray("/ is a folder");
        QTest::newRow("unreadable") << "/proc/self/mem" << QByteArray("cannot be read");
        QTest::newRow("text that is not a table")
            << "/proc/self/status" << QByteArray("a text without rows of numbers");
        QTest::newRow("missing") << "/nowhere/x.csv" << QByteArray("cannot be opened");
    }

    void refusesFoldersAndDevices()
    {
        QFETCH(const QString, path);
        QFETCH(const QByteArray, message);
        if (path.startsWith(u"/proc") && !QFile::exists(path)) {
            QSKIP("This system has no /proc.");
        }
        const RunResult outcome = runProgram({"compare", path});
        QVERIFY2(outcome.hasOneLineError() && outcome.error.contains(message), outcome.error);
        QCOMPARE(outcome.status, 3);
    }

    void refusesManyMissingFilesQuickly()
    {
        QStringList arguments{"compare", "--join"};
        for (int i = 0; i < 50'000; ++i) {
            arguments += QStringLiteral("/%1.csv").arg(i);
        }
        const RunResult outcome = runProgram(arguments);
        QVERIFY2(outcome.hasOneLineError() && outcome.error.contains("/0.csv cannot be opened"), outcome.error);
        QCOMPARE(outcome.status, 3);
    }

    /// The window does not wait for a pipe that nothing writes to.
    void refusesAPipeAsAScene()
    {
#ifdef Q_OS_UNIX
        const QString pipe = m_folder->filePath(QStringLiteral("x.slidercrank"));
        QCOMPARE(mkfifo(QFile::encodeName(pipe).constData(), 0600), 0);
        const RunResult outcome = runProgram({pipe});
        QVERIFY2(outcome.error.contains("no display"), outcome.error);
#endif
    }

    void readsAPipeToItsEnd()
    {
#ifdef Q_OS_UNIX
        QCOMPARE(mkfifo(QFile::encodeName(m_file).constData(), 0600), 0);
        QProcess program;
        program.start(QStringLiteral(SLIDERCRANK_PROGRAM), {"compare", "--format", "csv", m_file});
        QVERIFY(program.waitForStarted(kPatience));
        QFile pipe(m_file);
        QVERIFY(pipe.open(QIODevice::WriteOnly)); // waits until the program opens the pipe
        constexpr int kRows = 300'000;            // more than the buffer of a pipe holds
        QCOMPARE(pipe.write(rows(kRows)), rows(kRows).size());
        pipe.close();
        const RunResult outcome = waitForResult(program);
        QCOMPARE(outcome.status, 0);
        QVERIFY2(outcome.output.contains(QByteArray::number(kRows)), outcome.output);
#endif
    }

    /// Increases the memory limit in steps, so that different allocations fail, some of them in background threads.
    void reportsInsufficientMemory()
    {
#ifdef Q_OS_UNIX
        if (kIsSanitized) {
            QSKIP("A sanitizer reserves the whole address space.");
        }
        QVERIFY(write(m_file, rows(1), rows(1).size()));
        const auto runWithin = [this](rlim_t megabytes) {
            QProcess process;
            process.setChildProcessModifier([megabytes] {
                const rlimit limit{megabytes << 20U, megabytes << 20U};
                setrlimit(RLIMIT_AS, &limit);
            });
            process.start(QStringLiteral(SLIDERCRANK_PROGRAM), {"compare", m_file});
            return waitForResult(process);
        };
        rlim_t smallest = 64; // MB; raised until the program can compare a small file
        while (runWithin(smallest).status != 0) {
            smallest += 32;
            QVERIFY(smallest < 8192);
        }
        QVERIFY(write(m_file, rows(300'000), rows(300'000).size()));
        int refused = 0;
        for (rlim_t additional = 0; additional < 128; additional += 4) {
            const RunResult outcome = runWithin(smallest + additional);
            if (outcome.status == 0) {
                break;
            }
            ++refused;
            QCOMPARE(outcome.status, 3);
            QVERIFY2(outcome.hasOneLineError() && outcome.error.contains("not enough memory"), outcome.error);
        }
        QVERIFY2(refused > 3, qPrintable(QString::number(refused)));
#endif
    }

private:
    std::unique_ptr<QTemporaryDir> m_folder;
    QString m_file;
};

const Suite<TestWrongFiles> suite("tst_wrong_files");

} // namespace tst_wrong_files

#include "tst_wrong_files.moc"
