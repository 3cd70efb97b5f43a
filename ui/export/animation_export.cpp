// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/animation_export.h"

#include "ui/document/whole_file.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#if QT_CONFIG(process)
#include <QProcess>
#endif
#include <QStandardPaths>
#include <QTemporaryDir>

#include <algorithm>
#include <cmath>

namespace slidercrank
{

namespace
{

struct AnimationExport {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::AnimationExport)
};

using Problem = std::optional<QString>;

/// Returns a message if the animation certainly cannot be written to `path`; checks it before anything is drawn.
Problem findFault(const QString &path)
{
    const QFileInfo target(path);
    if (isVideo(path)) {
        return !hasVideoEncoder()
                   ? Problem(AnimationExport::tr(
                                 "%1: a video needs the program ffmpeg, which is not installed. Install it (Debian, "
                                 "Ubuntu: sudo apt install ffmpeg; Windows: winget install ffmpeg; macOS: brew install "
                                 "ffmpeg), or export the frames to a folder.")
                                 .arg(QDir::toNativeSeparators(path)))
                   : std::nullopt;
    }
    const bool isOccupied = target.isDir() ? !QDir(path).isEmpty() : target.exists();
    if (isOccupied) {
        return cannotWrite(path, AnimationExport::tr("it exists already"));
    }
    return std::nullopt;
}

/// Draws the frames into a temporary folder, which messages call `path`. Returns nullopt on success, a message on
/// failure, or an empty text if it was cancelled.
Problem drawFrames(const QTemporaryDir &folder, const QString &path, const Animation &animation,
                   const FrameDrawing &draw, const AnimationProgress &progress)
{
    for (int frame = 0; frame < animation.frameCount(); ++frame) {
        const QString name = QStringLiteral("frame_%1.png").arg(frame + 1, 4, 10, QLatin1Char('0'));
        const auto drawFrame = [&](QPainter &painter, const QSize &size) {
            draw(painter, size, animation.timeOfFrame(frame));
        };
        const QString file = folder.filePath(name);
        if (Problem problem = exportFigure(file, animation.size, {}, drawFrame)) {
            return problem->replace(QDir::toNativeSeparators(file), QDir::toNativeSeparators(path));
        }
        if (!progress(frame + 1)) {
            return QString();
        }
    }
    return std::nullopt;
}

#if QT_CONFIG(process)
Problem makeVideo(const QTemporaryDir &folder, const QString &path, const Animation &animation,
                  const AnimationProgress &progress)
{
    constexpr int kProgressInterval = 50; // ms
    const QString video = "video." + QFileInfo(path).suffix().toLower();
    QStringList arguments{"-loglevel", "error", "-framerate", QString::number(animation.framesPerSecond), "-i",
                          "frame_%04d.png",
                          // Most players support only colours at half the resolution, which requires even sides.
                          "-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2:color=white"};
    if (!video.endsWith(QLatin1String("gif"))) {
        arguments << "-pix_fmt"
                  << "yuv420p"
                  << "-sws_flags"
                  << "accurate_rnd+full_chroma_int"; // otherwise white becomes grey
    }
    QProcess ffmpeg;
    ffmpeg.setProcessChannelMode(QProcess::MergedChannels);
    ffmpeg.setWorkingDirectory(folder.path()); // ffmpeg would take a "%" in a path for the number of a frame
    ffmpeg.start("ffmpeg", arguments << video);
    while (!ffmpeg.waitForFinished(kProgressInterval) && ffmpeg.state() != QProcess::NotRunning) {
        if (!progress(animation.frameCount())) {
            ffmpeg.kill();
            ffmpeg.waitForFinished();
            return QString();
        }
    }
    QFile file(folder.filePath(video));
    if (ffmpeg.exitStatus() != QProcess::NormalExit || ffmpeg.exitCode() != 0 || !file.open(QIODevice::ReadOnly) ||
        file.size() == 0) {
        const QString reason = QString::fromLocal8Bit(ffmpeg.readAll()).simplified();
        return AnimationExport::tr("ffmpeg could not make the video: %1")
            .arg(reason.isEmpty() ? AnimationExport::tr("it ended without a reason.") : reason);
    }
    return writeWhole(path, file.readAll());
}
#else
/// Never called: where no other program can be run, as in a browser, hasVideoEncoder() is false.
Problem makeVideo(const QTemporaryDir &, const QString &, const Animation &, const AnimationProgress &)
{
    return QString();
}
#endif

} // namespace

int Animation::frameCount() const
{
    const double frames = std::abs(duration) / speed * framesPerSecond;
    return static_cast<int>(std::lround(std::clamp(frames, 1.0, kMaxFrames + 1.0)));
}

double Animation::timeOfFrame(int frame) const
{
    return start + duration * frame / frameCount();
}

FigureSize videoSize(const QSize &pixels)
{
    constexpr int kUsualSide = 360;      // px, of a small window, in which links and letters have their usual size
    constexpr int kLettersOnSide = 30;   // heights of letters that are legible from the back of a lecture room
    constexpr int kSmallestLetters = 12; // px
    const int shorterSide = std::min(pixels.width(), pixels.height());
    int scale = std::max(1, shorterSide / kUsualSide);
    while (pixels.width() % scale != 0 || pixels.height() % scale != 0) {
        --scale; // so that the frames have exactly the size `pixels`
    }
    FigureSize size{.size = pixels / scale, .scale = static_cast<double>(scale)};
    size.fontPixels = std::max(kSmallestLetters, shorterSide / scale / kLettersOnSide);
    return size;
}

bool hasVideoEncoder()
{
    return !QStandardPaths::findExecutable("ffmpeg").isEmpty();
}

bool isVideo(const QString &path)
{
    return QStringList{"mp4", "webm", "gif"}.contains(QFileInfo(path).suffix().toLower());
}

std::optional<QString> exportAnimation(const QString &path, const Animation &animation, const FrameDrawing &draw,
                                       const AnimationProgress &progress)
{
    if (const Problem fault = findFault(path)) {
        return fault;
    }
    const QFileInfo target(QDir::cleanPath(path));
    QTemporaryDir folder(target.absoluteDir().filePath("frames-XXXXXX")); // on the same disk
    if (!folder.isValid()) {
        return cannotWrite(path, withoutFullStop(folder.errorString()));
    }
    Problem problem = drawFrames(folder, path, animation, draw, progress);
    if (!problem && isVideo(path)) {
        problem = makeVideo(folder, path, animation, progress);
    } else if (!problem) {
        QFile::setPermissions(folder.path(), QFile::permissions(target.absolutePath()));
        target.absoluteDir().rmdir(target.fileName()); // findFault() allows only an empty one
        if (QDir().rename(folder.path(), target.absoluteFilePath())) {
            folder.setAutoRemove(false);
        } else {
            problem = cannotWrite(path, AnimationExport::tr("the folder cannot be created"));
        }
    }
    return problem;
}

} // namespace slidercrank
