// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Writes the motion as numbered PNG frames into a new folder, or as a video with the program ffmpeg.

#include "ui/export/figure_export.h"

#include <QString>

#include <functional>
#include <optional>

class QPainter;

namespace slidercrank
{

struct Animation {
    static constexpr int kMaxFrames = 100'000;

    double start = 0.0;    ///< time in the motion, s
    double duration = 1.0; ///< s of the motion; negative if it runs backwards
    double speed = 1.0;    ///< seconds of the motion per second of the video
    int framesPerSecond = 30;
    FigureSize size;

    QSize pixels() const { return (QSizeF(size.size) * size.scale).toSize(); } ///< of a frame

    /// Returns the number of frames, at most kMaxFrames + 1. Each represents the time until the next one, so that the
    /// last frame of a whole turn differs from the first one.
    int frameCount() const;
    double timeOfFrame(int frame) const; ///< s
};

/// Returns the size of frames with that many pixels. In larger frames, links and letters are larger, so that they can
/// be read from the back of a lecture room: letters have 1/30 of the shorter side, but at least 12 pixels.
FigureSize videoSize(const QSize &pixels);

/// Draws the frame at a time (s), with its background, in a rectangle of a logical size that begins at the origin.
using FrameDrawing = std::function<void(QPainter &, const QSize &, double)>;

/// Receives the number of frames that are done; returns false to cancel.
using AnimationProgress = std::function<bool(int done)>;

/// Returns whether the program ffmpeg, which makes videos, is installed.
bool hasVideoEncoder();

/// Returns whether the path names a video: .mp4, .webm or .gif.
bool isVideo(const QString &path);

/// Writes a video, or frame_0001.png … into a new folder of that name, which appears when it is complete. Returns
/// nullopt on success, a message on failure, or an empty text if it was cancelled. A failed or cancelled export leaves
/// no files.
std::optional<QString> exportAnimation(const QString &path, const Animation &animation, const FrameDrawing &draw,
                                       const AnimationProgress &progress);

} // namespace slidercrank
