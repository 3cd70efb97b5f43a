// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What is on show, to files and to the clipboard; what takes long is written aside.

#include "core/mechanism/channel.h"
#include "ui/document/work_aside.h"
#include "ui/export/figure_export.h"
#include "ui/window/rooms.h"

#include <QObject>
#include <QString>
#include <QStringList>

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
    /// `window`: whose rooms these are, and in front of which is asked.
    Exports(Session *session, const Rooms &rooms, QWidget *window);

    /// What is being written; false where nothing is.
    bool cancel();

    bool isWriting() const;

    /// Goes on at once where nothing is being written; otherwise says so, and goes on when it is written, or once the
    /// person stops it, but not where it fails or the person wants neither.
    void finishThen(const std::function<void()> &goOn);

    /// What can be drawn.
    struct Picture {
        QString name; ///< of the file that is proposed
        QSize size;
        FigureDrawing draw;
        QString inClipboard; ///< what is said then
    };
    Picture figure() const;
    Picture plot(const QString &name) const;
    Picture mechanism() const;

    void choose(const Picture &picture);
    void copy(const Picture &picture);

    /// To a file, PNG, SVG or PDF by its suffix.
    void write(const Picture &picture, const QString &path);

    /// The run on show as CSV, off the GUI thread.
    void chooseData();
    void writeData(const QString &path, const ChannelSet &channels, double crankStep = 0.0); ///< °; 0: the time steps

    /// On A4, as PDF; whose motion the reference is, is worked out off the GUI thread first where it is not known yet.
    void chooseReport();
    void writeReport(const QString &path);

    /// The mechanism in motion: asks for frame rate, size and length, then for a folder for frames or the file of a
    /// video. A modal dialog shows the progress.
    void chooseAnimation();
    void writeAnimation(const QString &path, const Animation &animation);

    /// Of the time range at the playback speed.
    Animation animationOnShow() const;

signals:
    void done(const QString &sentence); ///< what was written or copied
    void problemFound(const QString &sentence);
    void busyChanged(bool busy); ///< with each of what is written aside
    void progressed(double part);

private:
    void chooseCrankStep(const QString &path);
    void chooseAnimationFile(const Animation &animation);
    bool refusesAnother(); ///< and says so: one file, or all of an animation, at a time

    /// Runs work() in another thread, then, unless it failed or was cancelled, finish() in this one; either returns a
    /// sentence where nothing was written.
    using Work = std::function<std::optional<QString>(const std::stop_token &, const WorkAside::Progress &)>;
    using Finish = std::function<std::optional<QString>()>;
    void writeAside(const QString &path, const Work &work, const Finish &finish = {});
    void tellWritten(const QString &path, const std::optional<QString> &problem);

    Session *m_session;
    const Rooms &m_rooms;
    QWidget *m_window;
    WorkAside *m_aside;
};

} // namespace slidercrank
