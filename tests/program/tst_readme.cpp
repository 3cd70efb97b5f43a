// SPDX-License-Identifier: GPL-3.0-or-later

// Runs every command of the README, and checks that it prints the lines that the README shows.

#include "tests/support/suite.h"

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

namespace tst_readme
{

class TestReadme : public QObject
{
    Q_OBJECT

private slots:
    void commandsRunAndPrintWhatIsShown_data();
    void commandsRunAndPrintWhatIsShown();
};

void TestReadme::commandsRunAndPrintWhatIsShown_data()
{
    QTest::addColumn<QStringList>("shownLines");
    QFile file(QStringLiteral(SLIDERCRANK_SOURCE_DIR "/README.md"));
    QVERIFY(file.open(QIODevice::ReadOnly));
    // Commands are indented by four spaces. A command that begins with "$" is followed by lines of its output.
    QList<QPair<QString, QStringList>> commands;
    bool showsOutput = false;
    for (const QString &line : QString::fromUtf8(file.readAll()).split('\n')) {
        QString text = line.startsWith(QStringLiteral("    ")) ? line.trimmed() : QString();
        const bool hasPrompt = text.startsWith(QStringLiteral("$ "));
        if (hasPrompt) {
            text.remove(0, 2);
        }
        const bool isSummary = text.contains(QStringLiteral("   ")); // a command and its description in one line
        if (text.startsWith(QStringLiteral("slidercrank ")) && !isSummary) {
            commands.append({text, {}});
            showsOutput = hasPrompt;
        } else if (text.isEmpty()) {
            showsOutput = false;
        } else if (showsOutput) {
            commands.last().second.append(text);
        }
    }
    QVERIFY(commands.size() >= 10);
    for (const auto &[command, shownLines] : commands) {
        QTest::newRow(qPrintable(command)) << shownLines;
    }
}

void TestReadme::commandsRunAndPrintWhatIsShown()
{
    QFETCH(QStringList, shownLines);
    const QTemporaryDir folder;
    const QString sample = QStringLiteral("data/inventor_sample.csv");
    QVERIFY(QDir(folder.path()).mkdir("data"));
    QVERIFY(QFile::copy(QStringLiteral(SLIDERCRANK_SOURCE_DIR "/") + sample, folder.filePath(sample)));
    QProcess process;
    process.setWorkingDirectory(folder.path());
    QStringList arguments = QProcess::splitCommand(QString::fromUtf8(QTest::currentDataTag()));
    arguments.removeFirst();
    process.start(QStringLiteral(SLIDERCRANK_PROGRAM), arguments);
    constexpr int kTimeout = 120'000; // ms
    QVERIFY(process.waitForFinished(kTimeout));
    QCOMPARE(process.exitStatus(), QProcess::NormalExit);
    const int status = arguments.first() == QLatin1String("check") ? 1 : 0; // the values that it checks are wrong
    QVERIFY2(process.exitCode() == status, process.readAllStandardError().constData());
    const QString output = QString::fromUtf8(process.readAllStandardOutput()).simplified();
    for (const QString &line : shownLines) {
        QVERIFY2(output.contains(line.simplified()), qPrintable(line + QStringLiteral("\n\nis not in\n\n") + output));
    }
}

const slidercrank::Suite<TestReadme> suite("tst_readme");

} // namespace tst_readme

#include "tst_readme.moc"
