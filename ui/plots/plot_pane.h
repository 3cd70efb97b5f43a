// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A widget that shows one plot. It paints its part of the figure's picture and, over it, what moves: the lines at the
// current time and at the pointer, and the dots on the curves with their values. Moving the lines and dots repaints
// only the one rectangle that contains them.

#include "ui/plots/plot_cursor.h"

#include <QPixmap>
#include <QWidget>

#include <vector>

namespace slidercrank
{

class PlotPane : public QWidget
{
    Q_OBJECT

public:
    /// `picture` shows the whole figure and must outlive the pane. While it is null, the figure paints below the pane.
    PlotPane(const QPixmap &picture, QWidget *figure);

    void setCursors(std::vector<PlotCursor> cursors, const QRect &axes); ///< px, in the pane

    const std::vector<PlotCursor> &cursors() const { return m_cursors; }
    const QRect &axes() const { return m_axes; } ///< px, in the pane

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    const QPixmap &m_picture;
    std::vector<PlotCursor> m_cursors;
    QRect m_paintedArea; ///< contains all cursors and labels; px, in the pane
    QRect m_axes;
};

} // namespace slidercrank
