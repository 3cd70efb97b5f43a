// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// One plot on the screen: its part of the figure's picture, and over it what moves: lines at the current time and under
// the pointer, dots on the curves with their values, the frame that a drag draws. Nothing is replotted for these; only
// the strips that changed are painted.

#include "ui/text/theme.h"

#include <QPixmap>
#include <QWidget>

#include <vector>

namespace slidercrank
{

class PlotPane : public QWidget
{
    Q_OBJECT

public:
    struct Dot {
        QPointF place; ///< px, in the pane
        QColor colour;
        QString text;
    };

    /// A time at which the curves are read.
    struct Cursor {
        double x = 0.0;       ///< px, in the pane
        bool isLight = false; ///< follows the pointer
        QStringList heading;  ///< at the top of the line
        std::vector<Dot> dots;
    };

    /// Text beside a cursor.
    struct Label {
        QRectF place; ///< px, in the pane
        QColor colour;
        QString text;
    };

    /// `picture` is that of the whole figure and outlives the pane.
    PlotPane(const QPixmap &picture, QWidget *figure);

    void setStyle(const QFont &font, const SeriesColours &colours);
    void setCursors(const std::vector<Cursor> &cursors, const QRect &axes);
    void setFrame(const QRect &frame); ///< null: none

    const std::vector<Cursor> &cursors() const { return m_cursors; }
    const std::vector<Label> &labels() const { return m_labels; }
    const QRect &frame() const { return m_frame; }
    const QRect &axes() const { return m_axes; } ///< px, in the pane
    QString text() const;                        ///< of all labels, a line each

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    void addLabels(const Cursor &cursor);

    const QPixmap &m_picture;
    std::vector<Cursor> m_cursors;
    std::vector<Label> m_labels;
    QRegion m_painted; ///< by cursors and labels
    QRect m_axes;
    QRect m_frame;
    SeriesColours m_colours;
};

} // namespace slidercrank
