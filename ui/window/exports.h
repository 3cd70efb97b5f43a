// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What the window shows, to files and to the clipboard.

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
    /// `window`: the parent of dialogs.
    Exports(Session *session, const Views &views, QWidget *window);

    bool isWriting() const { return m_task->isRunning(); }
    bool cancel(); ///< false if nothing is being written

    /// What can be drawn.
    struct Picture {
        QString name; ///< proposed for the file
        QSize size;
        FigureDrawing draw;
    };
    Picture figure() const;
    Picture plot(const QString &name) const;
    Picture mechanism() const;

    void choose(const Picture &picture);
    void copy(const Picture &picture);

    /// To a PNG, SVG or PDF file by its suffix.
    void write(const Picture &picture, const QString &path);

    /// The motion as CSV, off the GUI thread.
    void chooseData();
    void writeData(const QString &path, const ChannelSet &channels, double crankStep = 0.0); ///< °; 0: the time steps

    /// On A4, as PDF. If the mechanism in the reference is not known yet, it is identified off the GUI thread first.
    void chooseReport();
    void writeReport(const QString &path);

    /// The mechanism in motion, as frames in a folder or a video. A modal dialog shows the progress.
    void chooseAnimation();
    void writeAnimation(const QString &path, const Animation &animation);

    /// Of the time range at the playback speed.
    Animation animationShown() const;

signals:
    void exported(const QString &sentence);
    void problemFound(const QString &sentence);
    void busyChanged(bool busy);
    void progressed(double part);

private:
    FigureDrawing drawMechanism() const;
    FigureDrawing drawFigure() const;

    /// Runs work() in another thread, then finish() in this one; each returns a sentence if it fails.
    using Problem = std::optional<QString>;
    using Work = std::function<Problem(const std::stop_token &, const BackgroundTask::Progress &)>;
    void writeInBackground(const QString &path, const Work &work, const std::function<Problem()> &finish = {});
    void tellOutcome(const QString &path, const Problem &problem);

    Session *m_session;
    const Views &m_views;
    QWidget *m_window;
    BackgroundTask *m_task;
};

} // namespace slidercrank
