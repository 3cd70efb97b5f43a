// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/animation_export.h"

#include "tests/support/waiting.h"

#include <QDir>
#include <QFile>
#include <QImage>
#include <QPainter>
#include <QProcess>
#include <QScopeGuard>
#include <QSemaphore>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <QThreadPool>

#include <memory>

using namespace slidercrank;

namespace
{

/// Grey that says the instant: 0 s is black, 1 s white.
void drawGrey(QPainter &painter, const QSize &size, double time)
{
    const int grey = static_cast<int>(255.0 * time + 0.5);
    painter.fillRect(QRect(QPoint(), size), QColor(grey, grey, grey));
}

Animation shortAnimation()
{
    Animation animation;
    animation.framesPerSecond = 10;
    animation.size.size = QSize(61, 41);
    return animation;
}

void putOlder(const QString &path)
{
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write("older") == 5);
}

QByteArray contentOf(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// Until it is finished: the problem told.
QString run(AnimationExport &animation, const QString &path)
{
    QSignalSpy finished(&animation, &AnimationExport::finished);
    animation.start(path);
    if (finished.isEmpty() && !finished.wait(kPatience)) {
        return QStringLiteral("not finished");
    }
    return finished[0][0].toString();
}

} // namespace

class TstAnimationExport : public QObject
{
    Q_OBJECT

private slots:
    void hasAFrameAtBothEnds();
    void writesNumberedFrames();
    void takesThePlaceOfOlderFrames_data();
    void takesThePlaceOfOlderFrames();
    void bringsOlderFramesBackWhenItFails();
    void leavesAFolderWhereItIs();
    void leavesNothingBehindWhenCancelled_data();
    void leavesNothingBehindWhenCancelled();
    void aSlowDiskKeepsNobodyWaiting();
    void saysWhyItCannotWrite_data();
    void saysWhyItCannotWrite();
    void filmsWithFfmpeg();
    void keepsTheOlderVideoUntilTheNewOneIsThere_data();
    void keepsTheOlderVideoUntilTheNewOneIsThere();
};

void TstAnimationExport::hasAFrameAtBothEnds()
{
    Animation animation;
    animation.start = 2.0;
    animation.duration = -4.0;
    animation.speed = 0.5;
    animation.framesPerSecond = 25;
    QCOMPARE(animation.frameCount(), 201);
    QCOMPARE(animation.instant(0), 2.0);
    QCOMPARE(animation.instant(100), 0.0);
    QCOMPARE(animation.instant(200), -2.0);
    animation.duration = 0.0;
    QCOMPARE(animation.frameCount(), 1);
    QCOMPARE(animation.instant(0), 2.0);
}

void TstAnimationExport::writesNumberedFrames()
{
    const QTemporaryDir folder;
    AnimationExport animation(shortAnimation(), drawGrey);
    QSignalSpy progressed(&animation, &AnimationExport::progressed);
    QCOMPARE(run(animation, folder.filePath(QStringLiteral("motion.png"))), QString());
    QCOMPARE(progressed.count(), 11);
    QCOMPARE(progressed.last()[0].toInt(), 11);
    QCOMPARE(QDir(folder.path()).entryList(QDir::AllEntries | QDir::NoDotAndDotDot).size(), 11);
    const QImage sixth(folder.filePath(QStringLiteral("motion_006.png")));
    QCOMPARE(sixth.size(), QSize(61, 41));
    QCOMPARE(sixth.pixelColor(30, 20).red(), 128); // half a second
}

void TstAnimationExport::takesThePlaceOfOlderFrames_data()
{
    QTest::addColumn<QStringList>("there");
    QTest::addColumn<QStringList>("left"); // of these
    const auto frames = [](int from, int to, int digits) {
        QStringList names;
        for (int frame = from; frame <= to; ++frame) {
            names += QStringLiteral("motion_%1.png").arg(frame, digits, 10, QLatin1Char('0'));
        }
        return names;
    };
    QTest::newRow("as many") << frames(1, 11, 3) << QStringList();
    QTest::newRow("more") << frames(1, 40, 3) << QStringList();
    QTest::newRow("fewer") << frames(1, 2, 3) << QStringList();
    QTest::newRow("so many that they have more digits") << frames(1, 1001, 4) << QStringList();
    QTest::newRow("without the first") << frames(8, 11, 3) << QStringList();
    const QStringList others{"motion.png", "motion_012.png", "motion_2024.png", "motion_a.png", "other_001.png"};
    QTest::newRow("other things") << others << others;
}

void TstAnimationExport::takesThePlaceOfOlderFrames()
{
    QFETCH(const QStringList, there);
    QFETCH(const QStringList, left);
    const QTemporaryDir folder;
    for (const QString &name : there) {
        putOlder(folder.filePath(name));
    }
    const QString path = folder.filePath(QStringLiteral("motion.png"));
    const QStringList older = AnimationExport::olderFrames(path, 11);
    QCOMPARE(older.size() + left.size(), there.size());
    AnimationExport animation(shortAnimation(), drawGrey);
    QCOMPARE(run(animation, path), QString());
    const QStringList names = AnimationExport::frameNames(path, 11);
    QCOMPARE(names.last(), QStringLiteral("motion_011.png"));
    QStringList expected = names + left;
    expected.sort();
    QCOMPARE(QDir(folder.path()).entryList(QDir::AllEntries | QDir::NoDotAndDotDot, QDir::Name), expected);
    for (const QString &name : names) {
        QCOMPARE(QImage(folder.filePath(name)).size(), QSize(61, 41));
    }
    for (const QString &name : left) {
        QCOMPARE(contentOf(folder.filePath(name)), QByteArray("older"));
    }
}

void TstAnimationExport::bringsOlderFramesBackWhenItFails()
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("motion.png"));
    AnimationExport animation(shortAnimation(), drawGrey);
    for (const QString &name : AnimationExport::frameNames(path, 14)) {
        putOlder(folder.filePath(name));
    }
    const QStringList before = QDir(folder.path()).entryList(QDir::AllEntries | QDir::NoDotAndDotDot, QDir::Name);
    connect(&animation, &AnimationExport::progressed, this, [&folder](int done) {
        const QStringList aside = QDir(folder.path()).entryList({QStringLiteral("frames-*")}, QDir::Dirs);
        if (done == 11) { // where the last of the older ones would go, something is in the way
            QVERIFY(QDir(folder.filePath(aside.value(0))).mkpath(QStringLiteral("older_motion_014.png/x")));
        }
    });
    const QString problem = run(animation, path);
    QVERIFY2(problem.contains(QStringLiteral("motion_014.png cannot be written")), qPrintable(problem));
    QCOMPARE(QDir(folder.path()).entryList(QDir::AllEntries | QDir::NoDotAndDotDot, QDir::Name), before);
    for (const QString &name : before) {
        QCOMPARE(contentOf(folder.filePath(name)), QByteArray("older"));
    }
}

/// One that is called as a frame, with whatever is in it.
void TstAnimationExport::leavesAFolderWhereItIs()
{
    const QTemporaryDir folder;
    putOlder(folder.filePath(QStringLiteral("motion_001.png")));
    QVERIFY(QDir(folder.path()).mkdir(QStringLiteral("motion_002.png")));
    putOlder(folder.filePath(QStringLiteral("motion_002.png/notes.txt")));
    AnimationExport animation(shortAnimation(), drawGrey);
    const QString problem = run(animation, folder.filePath(QStringLiteral("motion.png")));
    QVERIFY2(problem.contains(QStringLiteral("motion_002.png cannot be written")), qPrintable(problem));
    QCOMPARE(QDir(folder.path()).entryList(QDir::AllEntries | QDir::NoDotAndDotDot, QDir::Name),
             QStringList({"motion_001.png", "motion_002.png"}));
    QCOMPARE(contentOf(folder.filePath(QStringLiteral("motion_001.png"))), QByteArray("older"));
    QCOMPARE(contentOf(folder.filePath(QStringLiteral("motion_002.png/notes.txt"))), QByteArray("older"));
}

void TstAnimationExport::leavesNothingBehindWhenCancelled_data()
{
    QTest::addColumn<QString>("name");
    for (const QString &suffix : AnimationExport::suffixes()) {
        QTest::newRow(qPrintable(suffix)) << QStringLiteral("motion.") + suffix;
    }
}

void TstAnimationExport::leavesNothingBehindWhenCancelled()
{
    QFETCH(const QString, name);
    const QTemporaryDir folder;
    auto animation = std::make_unique<AnimationExport>(shortAnimation(), drawGrey);
    QSignalSpy progressed(animation.get(), &AnimationExport::progressed);
    QSignalSpy finished(animation.get(), &AnimationExport::finished);
    animation->start(folder.filePath(name));
    while (progressed.count() < 3) {
        QVERIFY(progressed.wait(kPatience));
    }
    QVERIFY(!QDir(folder.path()).isEmpty());
    animation.reset();
    finishAside(); // nothing more comes
    QVERIFY(QDir(folder.path()).isEmpty());
    QCOMPARE(finished.count(), 0);
}

void TstAnimationExport::aSlowDiskKeepsNobodyWaiting()
{
    QThreadPool *pool = QThreadPool::globalInstance();
    pool->setMaxThreadCount(1);
    const auto disk = std::make_shared<QSemaphore>();
    pool->start([disk] { disk->acquire(); });
    const auto end = qScopeGuard([pool, disk] {
        disk->release();
        pool->setMaxThreadCount(QThread::idealThreadCount());
    });
    const QTemporaryDir folder;
    auto animation = std::make_unique<AnimationExport>(shortAnimation(), drawGrey);
    QSignalSpy progressed(animation.get(), &AnimationExport::progressed);
    animation->start(folder.filePath(QStringLiteral("motion.png")));
    settle();
    QCOMPARE(progressed.count(), 0);
    animation.reset();
    disk->release();
    finishAside();
    QVERIFY(QDir(folder.path()).isEmpty());
}

void TstAnimationExport::saysWhyItCannotWrite_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("words");
    QTest::newRow("a folder that is not there") << "nowhere/motion.png"
                                                << "cannot be written";
    QTest::newRow("an ending without meaning") << "motion.txt"
                                               << "must end in .png";
}

void TstAnimationExport::saysWhyItCannotWrite()
{
    QFETCH(QString, name);
    QFETCH(QString, words);
    const QTemporaryDir folder;
    AnimationExport animation(shortAnimation(), drawGrey);
    const QString problem = run(animation, folder.filePath(name));
    QVERIFY2(problem.contains(words), qPrintable(problem));
    QVERIFY(QDir(folder.path()).isEmpty());
}

void TstAnimationExport::filmsWithFfmpeg()
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("motion.mp4"));
    AnimationExport animation(shortAnimation(), drawGrey);
    const QString problem = run(animation, path);
    const QString probe = QStandardPaths::findExecutable(QStringLiteral("ffprobe"));
    if (!AnimationExport::suffixes().contains(QStringLiteral("mp4"))) {
        QVERIFY2(problem.contains(QStringLiteral("ffmpeg")), qPrintable(problem));
        QSKIP("ffmpeg is not installed");
    }
    QCOMPARE(problem, QString());
    QCOMPARE(QDir(folder.path()).entryList(QDir::AllEntries | QDir::NoDotAndDotDot).size(), 1);
    if (probe.isEmpty()) {
        QSKIP("ffprobe is not installed");
    }
    QProcess process;
    process.start(probe, {QStringLiteral("-v"), QStringLiteral("error"), QStringLiteral("-count_frames"),
                          QStringLiteral("-show_entries"), QStringLiteral("stream=width,height,nb_read_frames"),
                          QStringLiteral("-of"), QStringLiteral("csv=p=0"), path});
    QVERIFY(process.waitForFinished(kPatience));
    QCOMPARE(QString::fromLatin1(process.readAll()).trimmed(), QStringLiteral("62,42,11"));
    const QString last = folder.filePath(QStringLiteral("last.png"));
    QCOMPARE(QProcess::execute(QStringLiteral("ffmpeg"),
                               {QStringLiteral("-v"), QStringLiteral("error"), QStringLiteral("-i"), path,
                                QStringLiteral("-vf"), QStringLiteral("select=eq(n\\,10)"), QStringLiteral("-frames:v"),
                                QStringLiteral("1"), last}),
             0);
    QCOMPARE(QImage(last).pixelColor(30, 20), QColor(Qt::white));
}

void TstAnimationExport::keepsTheOlderVideoUntilTheNewOneIsThere_data()
{
    QTest::addColumn<QByteArray>("lastLine"); // of a program that takes ffmpeg's place
    QTest::addColumn<QByteArray>("content");
    QTest::addColumn<QString>("words");
    QTest::newRow("written") << QByteArray("printf newer > $film") << QByteArray("newer") << QString();
    QTest::newRow("cut short") << QByteArray("printf ne > $film; echo full >&2; exit 1") << QByteArray("older")
                               << QStringLiteral("could not make the video: full");
    QTest::newRow("empty") << QByteArray(": > $film") << QByteArray("older") << QStringLiteral("ended early");
    QTest::newRow("nothing written") << QByteArray("true") << QByteArray("older") << QStringLiteral("ended early");
}

void TstAnimationExport::keepsTheOlderVideoUntilTheNewOneIsThere()
{
#ifdef Q_OS_WIN
    QSKIP("There is no shell to write a program in.");
#endif
    QFETCH(const QByteArray, lastLine);
    QFETCH(const QByteArray, content);
    QFETCH(const QString, words);
    const QTemporaryDir programs;
    QFile program(programs.filePath(QStringLiteral("ffmpeg")));
    QVERIFY(program.open(QIODevice::WriteOnly));
    program.write("#!/bin/sh\nfor film; do :; done\ncat > /dev/null\n" + lastLine + '\n');
    QVERIFY(program.setPermissions(QFile::ReadOwner | QFile::ExeOwner));
    program.close();
    const QByteArray path = qgetenv("PATH");
    qputenv("PATH", QFile::encodeName(programs.path()) + ':' + path);
    const auto restore = qScopeGuard([&path] { qputenv("PATH", path); });

    const QTemporaryDir folder;
    const QString older = folder.filePath(QStringLiteral("older.mp4"));
    putOlder(older);
    QVERIFY(QFile::link(older, folder.filePath(QStringLiteral("motion.mp4"))));
    AnimationExport animation(shortAnimation(), drawGrey);
    const QString problem = run(animation, folder.filePath(QStringLiteral("motion.mp4")));
    QVERIFY2(problem.contains(words) && problem.isEmpty() == words.isEmpty(), qPrintable(problem));
    QCOMPARE(contentOf(older), content);
    QCOMPARE(contentOf(folder.filePath(QStringLiteral("motion.mp4"))), content); // by way of the link
    QCOMPARE(QDir(folder.path()).entryList(QDir::AllEntries | QDir::NoDotAndDotDot).size(), 2);
}

QTEST_MAIN(TstAnimationExport)
#include "tst_animation_export.moc"
