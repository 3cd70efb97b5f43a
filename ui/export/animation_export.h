// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The motion to numbered PNG frames, or to a video by ffmpeg where it is installed. One frame is drawn in each pass of
// the event loop, so that nothing waits for it; everything is written or nothing.

#include "ui/document/work_aside.h"
#include "ui/export/figure_export.h"

#include <QObject>
#include <QString>
#include <QStringList>
#include <QTemporaryDir>

#include <functional>
#include <memory>

class QPainter;
class QProcess;

namespace slidercrank
{

struct Animation {
    static constexpr int kMostFrames = 100'000;

    double start = 0.0;    ///< s of the motion
    double duration = 1.0; ///< s of the motion; negative: backwards
    double speed = 1.0;    ///< seconds of the motion in a second of the film
    int framesPerSecond = 30;
    FigureSize size;

    /// Both ends included.
    int frameCount() const;
    double instant(int frame) const;
};

/// Draws the frame of that instant (s) at that logical size, from the origin, background included.
using FrameDrawing = std::function<void(QPainter &, const QSize &, double)>;

class AnimationExport : public QObject
{
    Q_OBJECT

public:
    AnimationExport(const Animation &animation, const FrameDrawing &draw, QObject *parent = nullptr);
    ~AnimationExport() override; ///< cancels it: nothing is left behind once the frame under way is written

    /// What a file's name may end in: "png", and where ffmpeg is found "mp4", "webm", "gif".
    static QStringList suffixes();

    /// What so many frames are called, in order; none of a video.
    static QStringList frameNames(const QString &path, int count);

    /// What so many new frames take the place of: all of the same names, and older series in the same folder from their
    /// first frame to the last before a gap, so that one animation is there and not two.
    static QStringList olderFrames(const QString &path, int count);

    /// "motion.png" makes motion_001.png, motion_002.png, …; another suffix one video.
    void start(const QString &path);

signals:
    void progressed(int done, int all);

    /// `problem`: one sentence; empty when everything is written.
    void finished(const QString &problem);

private:
    void drawNext();
    void writeAside(const QImage &image); ///< a disk may be slow
    void goOn();                          ///< after a frame
    QString putInPlace();
    QString filmPath() const; ///< until it is complete
    void startFilming();
    void finishFilm(int exitCode);
    QString putFilmInPlace();
    void end(const QString &problem);

    Animation m_animation;
    FrameDrawing m_draw;
    QString m_path;
    std::shared_ptr<QTemporaryDir> m_folder; ///< beside the path, until everything is there
    WorkAside m_writing;
    QProcess *m_film = nullptr;
    int m_frame = 0;
    bool m_running = false;
};

} // namespace slidercrank
