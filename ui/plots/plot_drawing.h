// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The QCustomPlot that draws the figure and the charts. It lays itself out for a size in pixels and draws with any
// painter, so that screen, image, SVG and PDF look alike. QCustomPlot's own painting and interactions are not used.
//
// The reason is speed. For nine plots with three curves of 440 points, QCustomPlot with QCPLegend and QCPTextElement
// needs 3.8 to 4.2 ms of CPU time (median of 260 frames), and this class 3.1 to 3.4 ms; at a pixel ratio of 2, they
// need 9.9 and 7.5 ms. Moreover, QCPLegend does not wrap, and QCustomPlot has no interaction in which one box zooms the
// time of nine plots and the values of one.

#include "ui/plots/curve_sampling.h"
#include "ui/plots/plot_fonts.h"
#include "ui/text/theme.h"
#include "ui/text/units.h"

#include <qcustomplot.h>

#include <optional>

namespace slidercrank
{

/// Chooses round ticks and labels them in the language of the user. The label of the number x is at the coordinate x ·
/// perUnit + tickOrigin(). There are at most tickCount() intervals.
class NumberTicker : public QCPAxisTicker
{
public:
    double perUnit = 1.0;
    bool isLogarithmic = false; ///< the numbers are decimal logarithms; labels are powers of ten

    /// The unit of numbers that are angles. Ticks that are not close together are parts or multiples of a turn; labels
    /// in radians are then multiples of π.
    std::optional<AngleUnit> angle = {};

    /// Where ticks are closer together, in coordinates of the axis, every second one has no label.
    double minLabelDistance = 0.0;

protected:
    double getTickStep(const QCPRange &range) override;
    QVector<QString> createLabelVector(const QVector<double> &ticks, const QLocale &locale, QChar format,
                                       int precision) override;
    QString getTickLabel(double tick, const QLocale &locale, QChar format, int precision) override;

private:
    double m_step = 1.0;              ///< from tick to tick, in units of the labels
    int m_digits = 6;                 ///< significant digits of the labels
    std::optional<int> m_commonPower; ///< exponent of the power of ten that all labels have
    bool m_isPartOfTurn = false;      ///< whether the step is a part or a multiple of a turn
};

/// Returns the size, in units of the painter, of the smallest detail that its device shows: a pixel, or 0.06 mm on
/// paper.
double smallestDetail(const QPainter &painter);

class PlotDrawing : public QCustomPlot
{
public:
    PlotDrawing();

    /// Lays out all elements for that size; axis rectangles and their coordinates are valid afterwards.
    void layOut(const QSize &size);

    /// Draws everything on a pixmap or, in its paint event, a widget, and caches the labels. Requires the device to
    /// have the size of the layout.
    void drawInto(QPaintDevice &device);

    /// Draws everything with its background, laid out for that size.
    void paint(QPainter &painter, const QSize &size);

    /// Sets the colours and fonts of the axes and the grid.
    void setStyle(const PlotFonts &fonts, const SeriesColours &colours);

    QCPGraph *addCurve(QCPAxisRect *axes, std::span<const CurvePoint> points);

private:
    void updateLayout() override {} ///< QCustomPlot calls it whenever it draws, but layOut() is enough
};

} // namespace slidercrank
