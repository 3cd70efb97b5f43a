// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Writes the motion as numbered PNG frames into a new folder, or as a video by ffmpeg.

#include "ui/export/figure_export.h"

#include <QString>

#include <functional>
#include <optional>

class QPainter;

namespace slidercrank
{

struct Animation {
    static constexpr int kMostFrames = 100'000;

    double start = 0.0;    ///< time in the motion, s
    double duration = 1.0; ///< s of the motion; negative: backwards
    double speed = 1.0;    ///< seconds of the motion per second of the film
    int framesPerSecond = 30;
    FigureSize size;

    /// Each frame stands for the time until the next one, so that a film of whole turns does not end with its first
    /// frame again.
    int frameCount() const;
    double timeOfFrame(int frame) const; ///< s
};

/// Draws the frame at that time (s) in that logical size, from the origin, background included.
using FrameDrawing = std::function<void(QPainter &, const QSize &, double)>;

/// Is told how many frames are done; returns false to cancel.
using AnimationProgress = std::function<bool(int done)>;

/// Whether that path names a video: .mp4, .webm or .gif.
bool isVideo(const QString &path);

/// Writes a video, or frame_0001.png … into a new folder of that name, which appears when it is complete. Returns a
/// sentence if it cannot; then, and when it is cancelled, nothing is left behind.
std::optional<QString> exportAnimation(const QString &path, const Animation &animation, const FrameDrawing &draw,
                                       const AnimationProgress &progress);

} // namespace slidercrank
