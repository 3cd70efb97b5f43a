// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The QCustomPlot behind the figure and the charts. It is never shown as a widget: it lays itself out for a size in
// pixels and draws to any painter, so that screen, image, SVG and PDF look alike.

#include "ui/text/theme.h"

#include <QFont>

#include <qcustomplot.h>

namespace slidercrank
{

/// Sizes are in pixels, not points, so that text has the right size on every device.
struct PlotFonts {
    explicit PlotFonts(const QFont &base);

    QFont title;
    QFont tick;
    double lineFactor = 1.0; ///< large letters go with wider lines
};

class PlotDrawing : public QCustomPlot
{
public:
    PlotDrawing();

    /// Lays out all elements for that size; axis rectangles and their coordinates are valid afterwards.
    void layOut(const QSize &size);

    /// Draws everything into the pixmap, with cached labels. Its size must be that of the layout.
    void drawInto(QPixmap &pixmap);

    /// Draws everything, laid out for that size, with the background.
    void paint(QPainter &painter, const QSize &size);

    /// Colours and fonts of the axes, the grid and the legend.
    void setStyle(const PlotFonts &fonts, const SeriesColours &colours);

    QCPGraph *addCurve(QCPAxisRect *axes, const QVector<QCPGraphData> &points);

    /// At a place in the coordinates of the axes, or of that type.
    QCPItemText *addText(QCPAxisRect *axes, const QString &text, const QPointF &place, Qt::Alignment alignment,
                         QCPItemPosition::PositionType type = QCPItemPosition::ptPlotCoords);
};

} // namespace slidercrank
