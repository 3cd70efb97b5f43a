// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/animation_export.h"

#include "tests/support/waiting.h"

#include <QDir>
#include <QImage>
#include <QPainter>
#include <QProcess>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

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
    void leavesNothingBehindWhenCancelled();
    void saysWhyItCannotWrite_data();
    void saysWhyItCannotWrite();
    void filmsWithFfmpeg();
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

void TstAnimationExport::leavesNothingBehindWhenCancelled()
{
    const QTemporaryDir folder;
    auto animation = std::make_unique<AnimationExport>(shortAnimation(), drawGrey);
    QSignalSpy progressed(animation.get(), &AnimationExport::progressed);
    QSignalSpy finished(animation.get(), &AnimationExport::finished);
    animation->start(folder.filePath(QStringLiteral("motion.png")));
    while (progressed.count() < 3) {
        QVERIFY(progressed.wait(kPatience));
    }
    QVERIFY(!QDir(folder.path()).isEmpty());
    animation.reset();
    QVERIFY(QDir(folder.path()).isEmpty());
    settle(); // nothing more comes
    QCOMPARE(finished.count(), 0);
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
}

QTEST_MAIN(TstAnimationExport)
#include "tst_animation_export.moc"
