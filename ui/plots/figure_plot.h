// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The figure of the nine plots, of the six of the motion alone, or of one plot: a QCustomPlot with an axis rectangle
// each and one legend, for the screen and for any other device.

#include "ui/plots/plot_drawing.h"
#include "ui/plots/plot_figure.h"

#include <array>
#include <optional>
#include <vector>

namespace slidercrank
{

class FigurePlot : public PlotDrawing
{
public:
    FigurePlot(const std::vector<std::size_t> &plots, const PlotFonts &fonts, const SeriesColours &colours);

    /// Lays out what the figure shows. A marked time (s) is a line in every plot.
    void show(PlotFigure &figure, const QSize &size, const std::optional<double> &markedTime = {});

    /// The plots that are shown.
    const std::vector<std::size_t> &plots() const { return m_plots; }

    QCPAxisRect &axes(std::size_t plot) const { return *m_panes[plot].axes; }

    /// A plot with its title and labels, px.
    QRect cell(std::size_t plot) const { return m_panes[plot].axes->outerRect(); }

    bool hasValues(std::size_t plot) const { return m_panes[plot].hasValues; }

    /// What a plot shows, in words.
    QString description(std::size_t plot) const { return m_panes[plot].description; }

    /// Right of the legend.
    int legendHeight() const { return m_top->outerRect().height(); }
    int legendEnd() const { return legend->outerRect().right(); }

private:
    class Ticker;
    struct Pane {
        QCPAxisRect *axes = nullptr;
        QSharedPointer<Ticker> valueTicker;
        bool hasValues = false;
        QString description;
    };

    void fill(PlotFigure &figure, const std::optional<double> &markedTime);
    void setAxes(std::size_t plot, const PlotPicture &picture, const Interval &time);
    void addCurve(const Pane &pane, const PlotCurve &curve);
    void addBand(const Pane &pane, const PlotCurve &curve, QCPAxis *valueAxis);
    void addTitleAndNote(const Pane &pane, const PlotPicture &picture);
    QCPItemText *addText(const Pane &pane, const QString &text, const QPointF &at, Qt::Alignment alignment);
    void list(QCPGraph *graph, const QString &name);
    void wrapLegend(int width);

    std::vector<std::size_t> m_plots;
    PlotFonts m_fonts;
    SeriesColours m_colours;
    std::array<Pane, kPlotCount> m_panes;
    QCPLayoutGrid *m_top = nullptr;  ///< the legend, and free space
    QCPLayoutGrid *m_grid = nullptr; ///< the plots
    QSharedPointer<Ticker> m_timeTicker;
    QSet<QString> m_listed; ///< in the legend
    bool m_isLow = false;   ///< too low for labels at every time axis
};

} // namespace slidercrank
