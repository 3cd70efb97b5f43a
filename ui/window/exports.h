// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Exports plots, drawing, data, report and animation to files, and copies pictures to the clipboard.

#include "core/mechanism/channel.h"
#include "ui/document/background_task.h"
#include "ui/export/figure_export.h"
#include "ui/window/views.h"

#include <QObject>
#include <QString>

#include <functional>
#include <optional>

namespace slidercrank
{

class Session;
struct Animation;

class Exports : public QObject
{
    Q_OBJECT

public:
    /// `window` is the parent of dialogs.
    Exports(Session *session, const Views &views, QWidget *window);

    bool isWriting() const { return m_task->isRunning(); }

    /// A picture that can be exported or copied.
    struct Picture {
        QString name; ///< proposed file name
        QSize size;
        FigureDrawing draw;
    };
    Picture plot(const QString &name = {}) const; ///< the whole figure if there is no name
    Picture mechanism() const;

    void choose(const Picture &picture);
    void copy(const Picture &picture);

    /// Writes a PNG, SVG or PDF file, according to the suffix.
    void write(const Picture &picture, const QString &path);

    /// Write the motion as CSV in the background. `crankStep` (°) is the step of the crank angle; 0 means the time
    /// steps.
    void chooseData();
    void writeData(const QString &path, const ChannelSet &channels, double crankStep = 0.0);

    /// Write the report as PDF on A4. It is not written while the mechanism of the reference is being identified.
    void chooseReport();
    void writeReport(const QString &path);

    /// Write the moving mechanism as frames in a folder or as a video. A modal dialog shows the progress.
    void chooseAnimation();
    void writeAnimation(const QString &path, const Animation &animation);

    /// Returns the animation of the current time range at the playback speed.
    Animation animationShown() const;

private:
    FigureDrawing drawMechanism() const;

    Session *m_session;
    const Views &m_views;
    QWidget *m_window;
    BackgroundTask *m_task;
};

} // namespace slidercrank
