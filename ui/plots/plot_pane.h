// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// One plot on the screen: its part of the figure's picture, and over it what moves: lines at the time on show and under
// the pointer, dots on the curves with their values, the frame that a drag draws. Nothing is replotted for these; only
// the strips that changed are painted.

#include "ui/text/theme.h"

#include <QPixmap>
#include <QWidget>

#include <memory>
#include <vector>

namespace slidercrank
{

class PlotPane : public QWidget
{
    Q_OBJECT

public:
    struct Dot {
        QPointF at; ///< px, in the pane
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

    /// `picture` is that of the whole figure and outlives the pane.
    PlotPane(const QPixmap &picture, QWidget *figure);

    void setStyle(const QFont &font, const SeriesColours &colours);
    void setCursors(const std::vector<Cursor> &cursors, const QRect &axes);
    void setFrame(const QRect &frame); ///< null: none

    const std::vector<Cursor> &cursors() const { return m_cursors; }
    const QRect &frame() const { return m_frame; }
    const QRect &axes() const { return m_axes; } ///< px, in the pane

    /// All that is written beside the cursors, a line each, and where, px in the pane.
    QString text() const;
    std::vector<QRectF> labelPlaces() const;

protected:
    void paintEvent(QPaintEvent *event) override;
    void focusInEvent(QFocusEvent *event) override;
    void focusOutEvent(QFocusEvent *event) override;

private:
    struct Label {
        QRectF place;
        QColor colour;
        QString text;
    };
    std::vector<Label> labels(const Cursor &cursor) const;
    QRegion region() const;

    const QPixmap &m_picture;
    std::vector<Cursor> m_cursors;
    std::vector<std::vector<Label>> m_labels; ///< of each cursor
    QRect m_axes;
    QRect m_frame;
    QFont m_font;
    SeriesColours m_colours;
};

} // namespace slidercrank
