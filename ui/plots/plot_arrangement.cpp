// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/plot_arrangement.h"

#include <QFontInfo>
#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace slidercrank
{

namespace
{

constexpr double kMarkSize = 7.0;

double lineWidth(Ink ink)
{
    switch (ink) {
    case Ink::Text:
    case Ink::Model:
    case Ink::Reference: return 2.0;
    case Ink::Kept: return 1.0;
    case Ink::Error:
    case Ink::ErrorOther: return 1.6; // they are noise where all is well, yet to be seen from the last row
    }
    return 1.0;
}

} // namespace

PlotTypography::PlotTypography(const QFont &base)
    : title(base)
    , tick(base)
{
    constexpr int kSmallest = 9;
    constexpr double kTickPart = 0.87;
    const int pixels = QFontInfo(base).pixelSize();
    title.setPixelSize(pixels);
    tick.setPixelSize(std::max(kSmallest, static_cast<int>(std::lround(kTickPart * pixels))));
    constexpr int kRoomForSuperscripts = 2;
    titleHeight = static_cast<int>(std::ceil(QFontMetricsF(title).height())) + kRoomForSuperscripts;
    const QFontMetricsF tickMetrics(tick);
    tickHeight = static_cast<int>(std::ceil(tickMetrics.height()));
    digitWidth = tickMetrics.horizontalAdvance(u'0');
    constexpr double kUsual = 15.0; // px, at most
    lineFactor = std::max(1.0, pixels / kUsual);
}

int PlotTypography::legendHeight() const
{
    constexpr int kSpace = 8;
    return titleHeight + kSpace;
}

QMargins PlotTypography::margins(int labelLength, bool hasTimeLabels, std::optional<int> rightLabelLength) const
{
    constexpr int kUsualLength = 6;                                     // "-0.005"
    const int right = std::max(13, static_cast<int>(1.9 * digitWidth)); // half a label of the time axis
    const auto beside = [&](int length) {
        const int labels = static_cast<int>(std::ceil(digitWidth * std::max(length, kUsualLength)));
        return labels + kLabelGap + kTickLength + 1;
    };
    const int bottom = hasTimeLabels ? tickHeight + kLabelGap + kTickLength + 1 : tickHeight / 2;
    return {beside(labelLength), titleHeight + 2, rightLabelLength ? beside(*rightLabelLength) : right, bottom};
}

PlotArrangement::PlotArrangement(const QSize &figure, const PlotTypography &typography, bool hasErrors,
                                 std::optional<std::size_t> onlyPlot)
    : size(figure)
    , only(onlyPlot)
    , legend(0, 0, size.width(), typography.legendHeight())
{
    constexpr QSize kSmallestLabelledCell(230, 165); // px: below this the labels of the upper rows take too much
    constexpr int kRows = static_cast<int>(kPlotRows);
    const int height = std::max(0, size.height() - legend.height());
    if (only) {
        cells[*only] = QRect(0, legend.height(), size.width(), height);
        return;
    }
    const int cellWidth = size.width() / static_cast<int>(hasErrors ? kPlotColumns : kErrorColumn);
    hasTimeLabelsEverywhere =
        cellWidth >= kSmallestLabelledCell.width() && height / kRows >= kSmallestLabelledCell.height();
    const QMargins bare = typography.margins(0, false);
    const QMargins labelled = typography.margins(0, true);
    const int extra = hasTimeLabelsEverywhere ? 0 : labelled.bottom() - bare.bottom();
    const int cellHeight = std::max(0, height - extra) / kRows;
    for (std::size_t i = 0; i < kPlotCount; ++i) {
        if (isErrorPlot(i) && !hasErrors) {
            continue;
        }
        const int row = static_cast<int>(i / kPlotColumns);
        const int column = static_cast<int>(i % kPlotColumns);
        cells[i] = QRect(column * cellWidth, legend.height() + row * cellHeight, cellWidth,
                         cellHeight + (row == kRows - 1 ? extra : 0));
    }
}

bool PlotArrangement::hasTimeLabels(std::size_t plot) const
{
    return hasTimeLabelsEverywhere || plot / kPlotColumns == kPlotRows - 1;
}

QColor colourOf(Ink ink, const SeriesColours &colours)
{
    switch (ink) {
    case Ink::Text: return colours.text;
    case Ink::Model: return colours.model;
    case Ink::Reference: return colours.reference;
    case Ink::Kept: return colours.kept;
    case Ink::Error: return colours.error;
    case Ink::ErrorOther: return colours.errorOther;
    }
    return {};
}

QPen penOf(Ink ink, const SeriesColours &colours, double lineFactor)
{
    // Flat ends: round ones would cost five times as much and close the gaps between dashes.
    return QPen(colourOf(ink, colours), lineFactor * lineWidth(ink), Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin);
}

QColor bandColourOf(Ink ink, const SeriesColours &colours)
{
    constexpr int kOpacity = 50; // of 255: two bands over each other are still to be told apart
    QColor colour = colourOf(ink, colours);
    colour.setAlpha(kOpacity);
    return colour;
}

void drawMark(QPainter &painter, const QPointF &tip, const QColor &colour)
{
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    painter.drawPolygon(
        QPolygonF{tip, tip + QPointF(-0.5 * kMarkSize, kMarkSize), tip + QPointF(0.5 * kMarkSize, kMarkSize)});
    painter.setBrush(Qt::NoBrush);
}

void drawLegend(QPainter &painter, const QRect &rect, const std::vector<LegendEntry> &entries,
                const PlotTypography &typography, const SeriesColours &colours)
{
    int lineSample = 33;             // px: three dashes and their gaps
    constexpr int kShortSample = 20; // two
    constexpr int kMark = 9;
    constexpr int kBand = 14;
    constexpr int kGap = 5;
    constexpr int kBetween = 14;
    const QFontMetricsF metrics(typography.title);
    const auto sampleWidth = [&lineSample](const LegendEntry &entry) {
        switch (entry.sample) {
        case LegendEntry::Sample::Mark: return kMark;
        case LegendEntry::Sample::Band: return kBand;
        case LegendEntry::Sample::Solid:
        case LegendEntry::Sample::Dashed:
        case LegendEntry::Sample::Dots: return lineSample;
        }
        return lineSample;
    };
    constexpr double kShortest = 60.0; // of an elided name
    const auto excessOf = [&](const std::vector<LegendEntry> &shown) {
        double excess = kBetween - rect.width();
        for (const LegendEntry &entry : shown) {
            excess += sampleWidth(entry) + kGap + metrics.horizontalAdvance(entry.text) + kBetween;
        }
        return excess;
    };
    std::vector<LegendEntry> shown = entries;
    double excess = excessOf(shown);
    double spare = 0.0; // what eliding can give
    for (const LegendEntry &entry : shown) {
        spare += entry.mayBeElided ? std::max(0.0, metrics.horizontalAdvance(entry.text) - kShortest) : 0.0;
    }
    if (excess > spare) {
        lineSample = kShortSample;
        excess = excessOf(shown);
    }
    while (excess > spare) {
        const auto last = std::find_if(shown.rbegin(), shown.rend(), std::mem_fn(&LegendEntry::mayBeLeftOut));
        if (last == shown.rend()) {
            break;
        }
        shown.erase(std::prev(last.base()));
        excess = excessOf(shown);
    }
    for (auto entry = shown.rbegin(); entry != shown.rend(); ++entry) {
        const double length = metrics.horizontalAdvance(entry->text);
        if (entry->mayBeElided && excess > 0.0 && length > kShortest) {
            const Qt::TextElideMode elide = entry->ink == Ink::Kept ? Qt::ElideRight : Qt::ElideMiddle; // "b = 65 …"
            entry->text = metrics.elidedText(entry->text, elide, std::max(kShortest, length - excess));
            excess -= length - metrics.horizontalAdvance(entry->text);
        }
    }
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(typography.title);
    double x = rect.left() + kBetween;
    const double middle = rect.center().y() + 0.5;
    const double baseline = middle + 0.5 * (metrics.ascent() - metrics.descent());
    for (const LegendEntry &entry : shown) {
        switch (entry.sample) {
        case LegendEntry::Sample::Mark:
            drawMark(painter, QPointF(x + 0.5 * kMark, middle - 0.5 * kMarkSize), colourOf(entry.ink, colours));
            break;
        case LegendEntry::Sample::Band:
            painter.fillRect(QRectF(x, middle - 0.5 * kMarkSize, kBand, kMarkSize), bandColourOf(entry.ink, colours));
            break;
        case LegendEntry::Sample::Dots:
            painter.setPen(Qt::NoPen);
            painter.setBrush(colourOf(entry.ink, colours));
            for (const double part : {0.1, 0.5, 0.9}) {
                painter.drawEllipse(QPointF(x + part * lineSample, middle), 0.5 * kDotSize, 0.5 * kDotSize);
            }
            break;
        case LegendEntry::Sample::Solid:
            painter.setPen(penOf(entry.ink, colours, typography.lineFactor));
            painter.drawLine(QPointF(x, middle), QPointF(x + lineSample, middle));
            break;
        case LegendEntry::Sample::Dashed:
            painter.setPen(penOf(entry.ink, colours, typography.lineFactor));
            for (double start = 0.0; start < lineSample; start += entry.dashes.length + entry.dashes.gap) {
                const double end = std::min<double>(start + entry.dashes.length, lineSample);
                painter.drawLine(QPointF(x + start, middle), QPointF(x + end, middle));
            }
            break;
        }
        x += sampleWidth(entry) + kGap;
        painter.setPen(colours.text);
        painter.drawText(QPointF(x, baseline), entry.text);
        x += metrics.horizontalAdvance(entry.text) + kBetween;
    }
    painter.restore();
}

} // namespace slidercrank
