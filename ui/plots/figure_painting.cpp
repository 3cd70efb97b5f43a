// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/figure_painting.h"

#include "ui/plots/plot_canvas.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QPicture>

#include <algorithm>
#include <cmath>

namespace slidercrank
{

namespace
{

/// QCustomPlot draws with a painter of its own class only: recorded, it can be played to any painter.
void replay(QPainter &painter, const QRect &cell, QCustomPlot &plot)
{
    const QPaintEngine *engine = painter.paintEngine();
    const bool isVector = engine && (engine->type() == QPaintEngine::SVG || engine->type() == QPaintEngine::Pdf);
    QPicture recording;
    QCPPainter recorder(&recording);
    recorder.setMode(QCPPainter::pmVectorized, isVector);
    plot.toPainter(&recorder, cell.width(), cell.height());
    recorder.end();
    painter.save();
    painter.translate(cell.topLeft());
    painter.drawPicture(0, 0, recording);
    painter.restore();
}

} // namespace

std::array<PlacedPlot, kPlotCount> placedPlots(PlotFigure &figure, const PlotArrangement &arrangement,
                                               const PlotTypography &typography)
{
    const auto marginsOf = [&](std::size_t plot, int length, int rightLength) {
        return typography.margins(length, arrangement.hasTimeLabels(plot),
                                  figure.hasRightAxis(plot) ? std::optional(rightLength) : std::nullopt);
    };
    std::array<PlacedPlot, kPlotCount> plots;
    std::array<int, kPlotColumns> lengths{};
    int rightLength = 0;
    for (std::size_t i = 0; i < kPlotCount; ++i) {
        if (arrangement.cells[i].isEmpty()) {
            continue;
        }
        plots[i].cell = arrangement.cells[i];
        PlotPicture &picture = plots[i].picture;
        picture = figure.picture(i, plots[i].cell.size().shrunkBy(marginsOf(i, 0, 0)), typography.digitWidth);
        picture.hasTimeLabels = arrangement.hasTimeLabels(i);
        int &length = lengths[i % kPlotColumns];
        length = std::max(length, picture.valueScale.labelLength(picture.values));
        if (picture.hasTimeLabels) { // their title stands before the first of them
            const QFontMetricsF metrics(typography.tick);
            const double title = metrics.horizontalAdvance(picture.timeLabels.title) +
                                 0.5 * metrics.horizontalAdvance(picture.timeLabels.label(picture.time.lower));
            length = std::max(length, static_cast<int>(std::ceil((title - kTickLength) / typography.digitWidth)));
        }
        if (picture.rightValues) {
            rightLength = std::max(rightLength, picture.rightScale.labelLength(*picture.rightValues));
        }
    }
    for (std::size_t i = 0; i < kPlotCount; ++i) {
        plots[i].margins = marginsOf(i, lengths[i % kPlotColumns], rightLength);
    }
    return plots;
}

void paintPlots(QPainter &painter, PlotFigure &figure, const PlotArrangement &arrangement,
                const PlotTypography &typography, const SeriesColours &colours, std::optional<double> markedTime)
{
    painter.fillRect(QRect(QPoint(), arrangement.size), colours.background);
    drawLegend(painter, arrangement.legend, figure.legend(arrangement.only), typography, colours);
    PlotCanvas plot(nullptr);
    plot.setStyle(typography, colours);
    for (PlacedPlot &placed : placedPlots(figure, arrangement, typography)) {
        if (!placed.cell.isEmpty()) {
            placed.picture.markedTime = markedTime;
            plot.display(placed.picture, placed.margins);
            replay(painter, placed.cell, plot);
        }
    }
}

} // namespace slidercrank
