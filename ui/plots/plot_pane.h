// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A widget that shows one plot. It paints its part of the figure's picture and, over it, what moves: the lines at the
// current time and at the pointer, and the dots on the curves with their values. Moving these replots nothing: the
// widget repaints the one rectangle that contains them.

#include <QColor>
#include <QPixmap>
#include <QStaticText>
#include <QWidget>

#include <optional>
#include <vector>

namespace slidercrank
{

class PlotPane : public QWidget
{
    Q_OBJECT

public:
    /// Text beside a cursor: a heading, or a value with a dot on its curve. Positions are in px, in the pane.
    struct Label {
        QStaticText text;
        QColor colour;
        std::optional<QPointF> dot = {}; ///< a heading has none
        QRectF place = {};               ///< of the text; setCursors() chooses it
    };

    /// A time at which the curves are read.
    struct Cursor {
        double x = 0.0;       ///< px, in the pane
        bool isLight = false; ///< follows the pointer
        std::vector<Label> labels = {};
    };

    /// `picture` shows the whole figure and must outlive the pane. While it is null, the figure paints below the pane.
    PlotPane(const QPixmap &picture, QWidget *figure);

    void setCursors(std::vector<Cursor> cursors, const QRect &axes);

    const std::vector<Cursor> &cursors() const { return m_cursors; }
    const QRect &axes() const { return m_axes; } ///< px, in the pane

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    void placeLabels(Cursor &cursor) const;

    const QPixmap &m_picture;
    std::vector<Cursor> m_cursors;
    QRect m_painted; ///< contains all cursors and labels; px, in the pane
    QRect m_axes;
};

} // namespace slidercrank
