// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What lies over a plot while one reads it: lines at instants, a box with values, the mark of the keyboard's focus. The
// plot beneath is not replotted for it.

#include "ui/plots/plot_figure.h"
#include "ui/words/theme.h"

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
    std::vector<Line> lines;
    std::vector<InkedRow> box;
    QRect axes; ///< where both belong, px in the plot
    bool hasFocus = false;

    bool isEmpty() const { return lines.empty() && box.empty() && !hasFocus; }
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

    /// Whether a box of these rows has room in the plot.
    bool fits(const std::vector<InkedRow> &box) const;

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    void paintBox(QPainter &painter) const;

    OverlayContent m_content;
    QFont m_font;
    SeriesColours m_colours;
};

} // namespace slidercrank
