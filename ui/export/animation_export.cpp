// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/animation_export.h"

#include "ui/document/whole_file.h"

#include <QBuffer>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QImage>
#include <QPainter>
#include <QProcess>
#include <QStandardPaths>
#include <QTimer>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <set>
#include <system_error>
#include <vector>

namespace slidercrank
{

namespace
{

constexpr qint64 kMostWaiting = 16 * 1024 * 1024; // bytes that ffmpeg has not taken yet

QString ffmpeg()
{
    return QStandardPaths::findExecutable(QStringLiteral("ffmpeg"));
}

bool isVideo(const QString &path)
{
    return QFileInfo(path).suffix().toLower() != QLatin1String("png");
}

/// motion.png → motion_007.png, with as many digits as the last frame needs.
QString frameName(const QString &path, int frame, int count)
{
    constexpr int kFewestDigits = 3;
    const int digits = std::max(kFewestDigits, static_cast<int>(QString::number(count).size()));
    const QFileInfo info(path);
    return QStringLiteral("%1_%2.%3")
        .arg(info.completeBaseName(), QString::number(frame + 1).rightJustified(digits, u'0'), info.suffix());
}

QString notWritten(const QString &path, const QString &reason)
{
    return AnimationExport::tr("%1 cannot be written: %2.")
        .arg(QDir::toNativeSeparators(path), withoutFullStop(reason));
}

struct Move {
    QString from;
    QString to; ///< at once in the place of a file that is there
};

/// The reason where it is not.
QString made(const Move &move)
{
    std::error_code error;
    std::filesystem::rename(QFileInfo(move.from).filesystemFilePath(), QFileInfo(move.to).filesystemFilePath(), error);
    return error ? QString::fromLocal8Bit(error.message().c_str()) : QString();
}

QImage frameImage(const FigureSize &size, const FrameDrawing &draw, double instant)
{
    QImage image(size.size * size.scale, QImage::Format_RGB32);
    if (!image.isNull()) {
        image.setDevicePixelRatio(size.scale);
        QPainter painter(&image);
        painter.setRenderHint(QPainter::Antialiasing);
        draw(painter, size.size, instant);
    }
    return image;
}

} // namespace

int Animation::frameCount() const
{
    const double frames = std::abs(duration) / speed * framesPerSecond;
    return 1 + static_cast<int>(std::lround(std::clamp(frames, 0.0, static_cast<double>(kMostFrames))));
}

double Animation::instant(int frame) const
{
    const int last = frameCount() - 1;
    return last == 0 ? start : start + duration * static_cast<double>(frame) / static_cast<double>(last);
}

AnimationExport::AnimationExport(const Animation &animation, const FrameDrawing &draw, QObject *parent)
    : QObject(parent)
    , m_animation(animation)
    , m_draw(draw)
{
}

AnimationExport::~AnimationExport()
{
    if (m_film) {
        m_film->disconnect(this);
        m_film->kill();
        m_film->waitForFinished();
    }
}

QStringList AnimationExport::suffixes()
{
    QStringList suffixes{QStringLiteral("png")};
    if (!ffmpeg().isEmpty()) {
        suffixes << QStringLiteral("mp4") << QStringLiteral("webm") << QStringLiteral("gif");
    }
    return suffixes;
}

QStringList AnimationExport::frameNames(const QString &path, int count)
{
    QStringList names;
    for (int frame = 0; frame < count && !isVideo(path); ++frame) {
        names += frameName(path, frame, count);
    }
    return names;
}

QStringList AnimationExport::olderFrames(const QString &path, int count)
{
    if (isVideo(path)) {
        return {};
    }
    const QDir folder = QFileInfo(path).absoluteDir();
    const auto isFrame = [&folder](const QString &name) { return QFileInfo(folder.filePath(name)).isFile(); };
    std::set<QString> names;
    for (const QString &name : frameNames(path, count)) {
        if (isFrame(name)) {
            names.insert(name);
        }
    }
    for (const int most : {999, 9'999, 99'999, Animation::kMostFrames}) { // each number of digits
        for (int frame = 0; isFrame(frameName(path, frame, most)); ++frame) {
            names.insert(frameName(path, frame, most));
        }
    }
    return {names.begin(), names.end()};
}

void AnimationExport::start(const QString &path)
{
    m_path = path;
    m_frame = 0;
    m_running = true;
    const QString suffix = QFileInfo(path).suffix().toLower();
    const QString shown = QDir::toNativeSeparators(path);
    if (!suffixes().contains(suffix)) {
        const bool wantsVideo = suffix == QLatin1String("mp4") || suffix == QLatin1String("webm");
        end(wantsVideo
                ? tr("%1: a video needs the program ffmpeg, which is not installed; choose .png for frames.").arg(shown)
                : tr("%1: an animation's name must end in .%2.")
                      .arg(shown, suffixes().join(tr(" or .", "between the endings of file names"))));
        return;
    }
    if (m_animation.frameCount() > Animation::kMostFrames) {
        end(tr("More than %1 frames: choose a shorter run or fewer frames a second.").arg(Animation::kMostFrames));
        return;
    }
    m_folder = std::make_shared<QTemporaryDir>(QFileInfo(path).absoluteDir().filePath(QStringLiteral("frames-XXXXXX")));
    if (!m_folder->isValid()) {
        end(notWritten(path, m_folder->errorString()));
        return;
    }
    if (isVideo(path)) {
        startFilming();
    }
    QTimer::singleShot(0, this, &AnimationExport::drawNext);
}

QString AnimationExport::filmPath() const
{
    return m_folder->filePath(QFileInfo(m_path).fileName());
}

void AnimationExport::startFilming()
{
    m_film = new QProcess(this);
    m_film->setProcessChannelMode(QProcess::MergedChannels);
    const QStringList input{QStringLiteral("-loglevel"),  QStringLiteral("error"),
                            QStringLiteral("-xerror"), // also when only the end of the file finds no room
                            QStringLiteral("-f"),         QStringLiteral("image2pipe"),
                            QStringLiteral("-framerate"), QString::number(m_animation.framesPerSecond),
                            QStringLiteral("-c:v"),       QStringLiteral("bmp"),
                            QStringLiteral("-i"),         QStringLiteral("-")};
    // Most players know colours at half the resolution only, and that needs even sides.
    const QStringList output{QStringLiteral("-vf"), QStringLiteral("pad=ceil(iw/2)*2:ceil(ih/2)*2:color=white")};
    const QStringList colours =
        QFileInfo(m_path).suffix().toLower() == QLatin1String("gif")
            ? QStringList()
            : QStringList{QStringLiteral("-pix_fmt"), QStringLiteral("yuv420p"),
                          // White stays white.
                          QStringLiteral("-sws_flags"), QStringLiteral("accurate_rnd+full_chroma_int")};
    connect(m_film, &QProcess::bytesWritten, this, &AnimationExport::drawNext);
    connect(m_film, &QProcess::finished, this, &AnimationExport::finishFilm);
    connect(m_film, &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
        if (error == QProcess::FailedToStart) { // then it does not finish either
            end(tr("ffmpeg could not be started: %1.").arg(withoutFullStop(m_film->errorString())));
        }
    });
    m_film->start(ffmpeg(), input + output + colours + QStringList{filmPath()});
}

void AnimationExport::drawNext()
{
    const int count = m_animation.frameCount();
    const bool waits = m_film && m_film->bytesToWrite() > kMostWaiting;
    if (!m_running || m_frame >= count || waits) {
        return;
    }
    const QImage image = frameImage(m_animation.size, m_draw, m_animation.instant(m_frame));
    if (image.isNull()) {
        end(tr("There is not enough memory for a frame of that size."));
        return;
    }
    if (m_film) {
        QBuffer bytes;
        image.save(&bytes, "BMP");
        m_film->write(bytes.data());
        goOn();
    } else {
        writeAside(image);
    }
}

void AnimationExport::writeAside(const QImage &image)
{
    const QString path = m_folder->filePath(frameName(m_path, m_frame, m_animation.frameCount()));
    const auto write = [folder = m_folder, path, image](const std::stop_token &, const auto &) mutable {
        const auto held = std::move(folder); // until it is written, and no longer
        return writeWhole(path, pngOf(image));
    };
    const auto done = [this](const std::optional<QString> &reason) {
        if (reason) {
            end(notWritten(m_path, *reason));
        } else {
            goOn();
        }
    };
    m_writing.start(write, done, [this](const QString &problem) { end(problem); });
}

void AnimationExport::goOn()
{
    const int count = m_animation.frameCount();
    ++m_frame;
    emit progressed(m_frame, count);
    if (m_frame < count) {
        QTimer::singleShot(0, this, &AnimationExport::drawNext);
    } else if (m_film) {
        m_film->closeWriteChannel();
    } else {
        end(putInPlace());
    }
}

/// From the folder beside to where it belongs. Older frames go there first, so that none of them is ever among the new
/// ones, and come back when something fails.
QString AnimationExport::putInPlace()
{
    const QDir target = QFileInfo(m_path).absoluteDir();
    const QDir source(m_folder->path());
    std::vector<Move> moves;
    for (const QString &name : olderFrames(m_path, m_animation.frameCount())) {
        moves.push_back({target.filePath(name), source.filePath(QStringLiteral("older_") + name)});
    }
    const std::size_t older = moves.size();
    for (const QString &name : source.entryList(QDir::Files, QDir::Name)) {
        moves.push_back({source.filePath(name), target.filePath(name)});
    }
    for (auto move = moves.begin(); move != moves.end(); ++move) {
        const QString reason = made(*move);
        if (reason.isEmpty()) {
            continue;
        }
        const auto fails = [](const Move &before) { return !made({before.to, before.from}).isEmpty(); };
        const bool isUndone = std::count_if(std::make_reverse_iterator(move), moves.rend(), fails) == 0;
        m_folder->setAutoRemove(isUndone);
        const QString &frame = static_cast<std::size_t>(move - moves.begin()) < older ? move->from : move->to;
        return isUndone ? notWritten(frame, reason)
                        : tr("%1 cannot be written: %2. The older frames are in %3.")
                              .arg(QDir::toNativeSeparators(frame), reason, QDir::toNativeSeparators(m_folder->path()));
    }
    return {};
}

QString AnimationExport::putFilmInPlace()
{
    constexpr qint64 kAtATime = 1 << 20; // bytes
    QFile film(filmPath());
    WholeFile file(m_path);
    if (film.open(QIODevice::ReadOnly) && file.open()) {
        for (QByteArray bytes = film.read(kAtATime); !bytes.isEmpty() && file.write(bytes);) {
            bytes = film.read(kAtATime);
        }
    }
    if (film.error() != QFileDevice::NoError) {
        return notWritten(m_path, film.errorString());
    }
    return file.commit() ? QString() : notWritten(m_path, file.reason());
}

void AnimationExport::finishFilm(int exitCode)
{
    const QString words = QString::fromLocal8Bit(m_film->readAll()).simplified();
    const bool complete = m_frame == m_animation.frameCount() && QFileInfo(filmPath()).size() > 0;
    if (exitCode != 0 || m_film->exitStatus() != QProcess::NormalExit || !complete) {
        end(tr("ffmpeg could not make the video: %1").arg(words.isEmpty() ? tr("it ended early.") : words));
        return;
    }
    end(putFilmInPlace());
}

void AnimationExport::end(const QString &problem)
{
    m_running = false;
    if (m_film) {
        m_film->disconnect(this);
        m_film->kill();
        m_film->waitForFinished();
        m_film->deleteLater();
        m_film = nullptr;
    }
    m_folder.reset();
    emit finished(problem);
}

} // namespace slidercrank
