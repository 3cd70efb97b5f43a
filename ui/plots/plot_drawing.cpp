// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/plot_drawing.h"

#include <QFontInfo>
#include <QPicture>

#include <algorithm>
#include <cmath>

namespace slidercrank
{

PlotFonts::PlotFonts(const QFont &base)
    : title(base)
    , tick(base)
{
    constexpr int kSmallest = 9;
    constexpr double kTickPart = 0.87;
    constexpr double kUsual = 15.0; // px, at most
    const int pixels = QFontInfo(base).pixelSize();
    title.setPixelSize(pixels);
    tick.setPixelSize(std::max(kSmallest, static_cast<int>(std::lround(kTickPart * pixels))));
    lineFactor = std::max(1.0, pixels / kUsual);
}

PlotDrawing::PlotDrawing()
{
    mReplotting = true; // QCustomPlot would replot into buffers that nobody looks at
    setInteractions(QCP::Interactions());
    setPlottingHint(QCP::phFastPolylines, true); // a line of width 2 costs four times as much without
    setAutoAddPlottableToLegend(false);
}

QCPGraph *PlotDrawing::addCurve(QCPAxis *keyAxis, QCPAxis *valueAxis)
{
    QCPGraph *curve = addGraph(keyAxis, valueAxis);
    curve->setAdaptiveSampling(false); // it draws falling curves thicker than rising ones
    curve->setSelectable(QCP::stNone);
    return curve;
}

void PlotDrawing::layOut(const QSize &size)
{
    setViewport(QRect(QPoint(), size));
    updateLayout();
}

void PlotDrawing::drawInto(QPixmap &pixmap)
{
    setBufferDevicePixelRatio(pixmap.devicePixelRatio());
    QCPPainter painter(&pixmap);
    painter.fillRect(viewport(), mBackgroundBrush);
    draw(&painter);
}

void PlotDrawing::paint(QPainter &painter, const QRect &area)
{
    // QCustomPlot draws with a painter of its own class only; what it draws is recorded and played to any painter.
    const QPaintEngine *engine = painter.paintEngine();
    const bool isVector = engine && (engine->type() == QPaintEngine::SVG || engine->type() == QPaintEngine::Pdf);
    QPicture recording;
    QCPPainter recorder(&recording);
    recorder.setMode(QCPPainter::pmVectorized, isVector);
    toPainter(&recorder, area.width(), area.height());
    recorder.end();
    painter.save();
    painter.translate(area.topLeft());
    painter.drawPicture(0, 0, recording);
    painter.restore();
}

void PlotDrawing::setStyle(const PlotFonts &fonts, const SeriesColours &colours)
{
    setBackground(QBrush(colours.background));
    constexpr float kFrameStrength = 0.55F;
    const auto mixed = [](float text, float background) { return background + kFrameStrength * (text - background); };
    const QColor frame = QColor::fromRgbF(mixed(colours.text.redF(), colours.background.redF()),
                                          mixed(colours.text.greenF(), colours.background.greenF()),
                                          mixed(colours.text.blueF(), colours.background.blueF()));
    for (QCPAxisRect *rect : axisRects()) {
        for (QCPAxis *axis : rect->axes()) {
            axis->setBasePen(QPen(frame, 1));
            axis->setTickPen(QPen(frame, 1));
            axis->setSubTickPen(QPen(frame, 1));
            axis->setTickLabelColor(colours.text);
            axis->setTickLabelFont(fonts.tick);
            axis->setLabelColor(colours.text);
            axis->setLabelFont(fonts.tick);
            axis->grid()->setPen(QPen(colours.grid, 1));
            axis->grid()->setZeroLinePen(axis->orientation() == Qt::Vertical ? QPen(frame, 1) : QPen(colours.grid, 1));
        }
    }
    legend->setFont(fonts.tick);
    legend->setTextColor(colours.text);
    legend->setBrush(Qt::NoBrush);
    legend->setBorderPen(Qt::NoPen);
}

} // namespace slidercrank
