// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What lies over a plot while one reads it: lines at instants, dots on the curves there, a box with values beside them,
// the frame that a drag draws, the mark of the keyboard's focus. The plot beneath is not replotted for it.

#include "ui/plots/plot_figure.h"
#include "ui/text/theme.h"

#include <QFont>
#include <QWidget>

#include <vector>

namespace slidercrank
{

/// A row of a box: parts one after the other, each in its ink.
using InkedRow = std::vector<InkedText>;

struct OverlayContent {
    struct Line {
        int x = 0;    ///< px, in the plot
        QString name; ///< beside it; may be empty
        bool isSolid = true;
    };
    struct Dot {
        QPointF at; ///< px, in the plot
        Ink ink = Ink::Model;
    };
    std::vector<Line> lines;
    std::vector<Dot> dots;
    std::vector<InkedRow> box;
    QPointF boxPlace; ///< its upper left corner, px in the plot
    QRect axes;       ///< where lines belong, px in the plot
    QRect frame;      ///< that is being drawn, px in the plot; null: none
    bool hasFocus = false;

    bool isEmpty() const { return lines.empty() && box.empty() && frame.isNull() && !hasFocus; }
};

class PlotOverlay : public QWidget
{
    Q_OBJECT

public:
    explicit PlotOverlay(QWidget *plot);

    void setStyle(const QFont &font, const SeriesColours &colours);

    /// Hidden while there is nothing to show.
    void setContent(const OverlayContent &content);

    /// The rows of the box, a line each.
    QString text() const;

    /// What a box of these rows takes, px.
    QSizeF sizeOf(const std::vector<InkedRow> &box) const;

    /// What is on show.
    const OverlayContent &content() const { return m_content; }

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    void paintBox(QPainter &painter) const;

    OverlayContent m_content;
    QFont m_font;
    SeriesColours m_colours;
};

} // namespace slidercrank
