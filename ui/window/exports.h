// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Exports plots, drawing, data, report and animation to files, and copies pictures to the clipboard.

#include "core/mechanism/channel.h"
#include "ui/document/background_task.h"
#include "ui/export/figure_form.h"
#include "ui/export/report.h"
#include "ui/plots/plot_figure.h"
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

    FigureSubject plot(const QString &name = {}) const; ///< one plot, or those that the options choose
    FigureSubject mechanism() const;
    FigureSubject polygons() const; ///< the velocity and acceleration polygons at the current time

    /// Asks for the options and the name of the file, then writes the figure.
    void choose(const FigureSubject &subject);

    /// Copies a picture with the options that were chosen last.
    void copy(const FigureSubject &subject);

    /// Draws the figure, and writes a PNG, SVG or PDF file in the background, according to the suffix.
    void write(const FigureSubject &subject, const FigureOptions &options, const QString &path);

    /// Write the motion at the time steps as CSV in the background. chooseData() first asks for the file and the
    /// channels.
    void chooseData();
    void writeData(const QString &path, const ChannelSet &channels);

    /// Write the report of the current motion as PDF in the background. chooseReport() first asks for the file and the
    /// paper. While the mechanism of the reference is still being identified, no report is written, and the user is
    /// told why.
    void chooseReport();
    void writeReport(const QString &path, PaperSize paper = PaperSize::A4);

    /// Write the moving mechanism as frames in a folder or as a video. A modal dialog shows the progress.
    /// chooseAnimation() first asks for the options and the file.
    void chooseAnimation();
    void writeAnimation(const QString &path, const Animation &animation);

    /// Returns the animation of the current time range at the playback speed.
    Animation animationShown() const;

private:
    bool mayWrite(); ///< returns false, and says why, while another file is being written
    FigureDrawing mechanismDrawing() const;
    FigureDrawing plotsDrawing(const FigureContent &content) const;
    FigureContent contentOf(const FigureOptions &options) const;

    Session *m_session;
    const Views &m_views;
    QWidget *m_window;
    BackgroundTask *m_task;
};

} // namespace slidercrank
