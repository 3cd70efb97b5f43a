// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/figure_plot.h"

#include <QFontMetricsF>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace slidercrank
{

namespace
{

constexpr double kNoStretch = 1e-3;
constexpr int kTickLength = 3; // px
constexpr int kLabelGap = 4;   // px between a tick and its label

int lineHeight(const QFont &font)
{
    return static_cast<int>(std::ceil(QFontMetricsF(font).height()));
}

} // namespace

/// Ticks and labels of an AxisScale; the axis' coordinates are zero + perUnit · label.
class FigurePlot::Ticker : public QCPAxisTicker
{
public:
    AxisScale scale;
    double perUnit = 1.0;

protected:
    double getTickStep(const QCPRange &) override { return scale.step * std::abs(perUnit); }
    int getSubTickCount(double) override { return 0; }
    QString getTickLabel(double tick, const QLocale &locale, QChar, int) override
    {
        return scale.label((tick - tickOrigin()) / perUnit, locale);
    }
};

FigurePlot::FigurePlot(const std::vector<std::size_t> &plots, const PlotFonts &fonts, const SeriesColours &colours)
    : m_plots(plots)
    , m_fonts(fonts)
    , m_colours(colours)
    , m_top(new QCPLayoutGrid)
    , m_grid(new QCPLayoutGrid)
    , m_timeTicker(new Ticker)
{
    axisRect()->insetLayout()->take(legend);
    plotLayout()->clear();
    plotLayout()->setRowSpacing(0);
    plotLayout()->addElement(0, 0, m_top);
    plotLayout()->addElement(1, 0, m_grid);
    plotLayout()->setRowStretchFactor(0, kNoStretch);
    m_top->addElement(0, 0, legend);
    m_top->expandTo(1, 2);
    m_top->setColumnStretchFactor(0, kNoStretch);
    legend->setVisible(true);
    legend->setFillOrder(QCPLegend::foColumnsFirst);
    legend->setMargins(QMargins(12, 4, 0, 4));
    legend->setIconSize(28, 12);
    legend->setColumnSpacing(12);
    m_grid->setRowSpacing(0);
    m_grid->setColumnSpacing(0);
    std::array<QCPMarginGroup *, kPlotColumns> columns{};
    for (const std::size_t plot : m_plots) {
        const bool isAlone = m_plots.size() == 1;
        Pane &pane = m_panes[plot];
        pane.axes = new QCPAxisRect(this);
        const std::size_t column = plot % kPlotColumns;
        m_grid->addElement(isAlone ? 0 : static_cast<int>(plot / kPlotColumns), isAlone ? 0 : static_cast<int>(column),
                           pane.axes);
        if (!columns[column]) {
            columns[column] = new QCPMarginGroup(this);
        }
        pane.axes->setMarginGroup(QCP::msLeft | QCP::msRight, columns[column]);
        pane.axes->setAutoMargins(QCP::msLeft | QCP::msRight | QCP::msBottom);
        pane.valueTicker.reset(new Ticker);
        pane.axes->axis(QCPAxis::atBottom)->setTicker(m_timeTicker);
        pane.axes->axis(QCPAxis::atLeft)->setTicker(pane.valueTicker);
        for (QCPAxis *axis : pane.axes->axes()) {
            axis->setSubTicks(false);
            axis->setTickLength(0, kTickLength);
            axis->setTickLabelPadding(kLabelGap);
        }
    }
    setStyle(fonts, colours);
    legend->setFont(fonts.title);
}

void FigurePlot::show(PlotFigure &figure, const QSize &size, const std::optional<double> &markedTime)
{
    constexpr int kLowRow = 140; // px: below this the labels of the upper rows' time axes take too much
    layOut(size);
    const int rows = m_grid->rowCount();
    const int below = lineHeight(m_fonts.tick) + kTickLength + kLabelGap;
    m_isLow = m_grid->outerRect().height() < rows * kLowRow;
    m_grid->setRowStretchFactor(rows - 1, m_isLow && rows > 1 ? 1.0 + 3.0 * below / std::max(size.height(), 1) : 1.0);
    const auto sizes = [this] {
        std::vector<QSize> all;
        std::ranges::transform(m_plots, std::back_inserter(all),
                               [this](std::size_t plot) { return axes(plot).size(); });
        return all;
    };
    for (int pass = 0; pass < 4; ++pass) { // labels and legend change the size of the axes
        const std::vector<QSize> before = sizes();
        fill(figure, markedTime);
        wrapLegend(size.width());
        layOut(size);
        if (sizes() == before) {
            return;
        }
    }
}

void FigurePlot::fill(PlotFigure &figure, const std::optional<double> &markedTime)
{
    constexpr int kUsualDigits = 6;
    const QFontMetricsF metrics(m_fonts.tick);
    const double digitWidth = metrics.horizontalAdvance(u'0');
    const int labels = static_cast<int>(std::ceil(kUsualDigits * digitWidth)) + kTickLength + kLabelGap;
    const int beside = std::max(13, static_cast<int>(1.9 * digitWidth)); // half a label of the time axis
    const TimeAxis time = figure.timeAxis(axes(m_plots.front()).width(), digitWidth);
    m_timeTicker->scale = time.scale;
    m_timeTicker->perUnit = time.perUnit;
    m_timeTicker->setTickOrigin(time.zero);
    const QString first = time.scale.label((time.range.lower - time.zero) / time.perUnit, locale());
    const int afterTitle = static_cast<int>(0.5 * metrics.horizontalAdvance(first)) + kLabelGap;
    const int title = static_cast<int>(metrics.horizontalAdvance(time.title)) + afterTitle + kLabelGap;
    clearGraphs();
    clearItems();
    legend->clearItems();
    m_listed.clear();
    for (const std::size_t plot : m_plots) {
        const PlotPicture picture = figure.picture(plot, axes(plot).size());
        setAxes(plot, picture, time.range);
        axes(plot).setMinimumMargins(QMargins(std::max(labels, title), 0, beside, lineHeight(m_fonts.tick) / 2));
        axes(plot).setMargins(QMargins(0, lineHeight(m_fonts.title) + kLabelGap, 0, 0));
        QCPAxis *timeAxis = axes(plot).axis(QCPAxis::atBottom);
        timeAxis->setTickLabels(!m_isLow || plot / kPlotColumns == kPlotRows - 1);
        for (const PlotCurve &curve : picture.curves) {
            addCurve(m_panes[plot], curve);
        }
        addTitleAndNote(m_panes[plot], picture);
        if (timeAxis->tickLabels()) { // in the corner that both axes leave free
            addText(m_panes[plot], time.title, {0.0, 1.0}, Qt::AlignRight | Qt::AlignTop)
                ->setPadding(QMargins(0, kTickLength + kLabelGap, afterTitle, 0));
        }
        if (markedTime && time.range.contains(*markedTime) && picture.hasValues) {
            QCPGraph *mark = PlotDrawing::addCurve(timeAxis, axes(plot).axis(QCPAxis::atLeft));
            mark->setData({*markedTime, *markedTime}, {picture.values.lower, picture.values.upper}, true);
            mark->setPen(QPen(m_colours.cursor, 1.0));
        }
    }
}

void FigurePlot::setAxes(std::size_t plot, const PlotPicture &picture, const Interval &time)
{
    Pane &pane = m_panes[plot];
    pane.hasValues = picture.hasValues;
    pane.axes->axis(QCPAxis::atBottom)->setRange(time.lower, time.upper);
    QCPAxis *left = pane.axes->axis(QCPAxis::atLeft);
    left->setRange(picture.values.lower, picture.values.upper);
    left->setTickLabels(picture.hasValues);
    pane.valueTicker->scale = picture.valueScale;
    pane.description = QStringList{picture.titles.first(), picture.note}.join(QStringLiteral(". "));
}

void FigurePlot::list(QCPGraph *graph, const QString &name)
{
    if (!m_listed.contains(name)) {
        m_listed.insert(name);
        constexpr int kLongest = 300; // px
        graph->setName(QFontMetrics(legend->font()).elidedText(name, Qt::ElideMiddle, kLongest));
        auto *entry = new QCPPlottableLegendItem(legend, graph);
        entry->setMargins(QMargins(0, 2, 0, 2)); // else descenders are cut off
        legend->addItem(entry);
    }
}

void FigurePlot::addCurve(const Pane &pane, const PlotCurve &curve)
{
    QCPAxis *timeAxis = pane.axes->axis(QCPAxis::atBottom);
    QCPAxis *valueAxis = pane.axes->axis(QCPAxis::atLeft);
    const QColor colour = m_colours.*curve.ink;
    const auto add = [&](const std::vector<CurvePoint> &points) {
        QVector<QCPGraphData> samples;
        samples.reserve(static_cast<qsizetype>(points.size()));
        for (const CurvePoint &point : points) {
            samples << QCPGraphData(point.t, point.value);
        }
        QCPGraph *graph = PlotDrawing::addCurve(timeAxis, valueAxis);
        graph->data()->set(samples, true);
        return graph;
    };
    QCPGraph *line = add(curve.points);
    const double width = curve.width * m_fonts.lineFactor;
    QPen pen(colour, width, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin); // round caps would cost five times as much
    if (!curve.dashes.empty()) {
        QVector<double> pattern;
        for (const double length : curve.dashes) {
            pattern << length / curve.width;
        }
        pen.setDashPattern(pattern);
    }
    line->setPen(pen);
    QCPGraph *listed = line;
    if (!curve.dots.empty()) {
        constexpr double kDotSize = 4.0;
        QCPGraph *dots = add(curve.dots);
        dots->setLineStyle(QCPGraph::lsNone);
        dots->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, colour, kDotSize));
        listed = curve.points.empty() ? dots : line;
    }
    list(listed, curve.name);
    if (!curve.band.empty()) {
        addBand(pane, curve, valueAxis);
    }
    if (!curve.marks.empty()) {
        constexpr double kMarkSize = 7.0;
        const double top = valueAxis->pixelToCoord(pane.axes->top() + kMarkSize);
        std::vector<CurvePoint> marks;
        for (const double t : curve.marks) {
            if (marks.empty() || timeAxis->coordToPixel(t) - timeAxis->coordToPixel(marks.back().t) >= 1.0) {
                marks.push_back({t, top});
            }
        }
        QCPGraph *graph = add(marks);
        graph->setLineStyle(QCPGraph::lsNone);
        graph->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssTriangle, colour, colour, kMarkSize));
        list(graph, PlotFigure::tr("undefined: the reference is 0"));
    }
}

void FigurePlot::addBand(const Pane &pane, const PlotCurve &curve, QCPAxis *valueAxis)
{
    constexpr int kOpacity = 50; // of 255: two bands over each other can still be told apart
    QCPAxis *timeAxis = pane.axes->axis(QCPAxis::atBottom);
    QCPGraph *floor = PlotDrawing::addCurve(timeAxis, valueAxis);
    QCPGraph *band = PlotDrawing::addCurve(timeAxis, valueAxis);
    const Interval time{timeAxis->range().lower, timeAxis->range().upper};
    for (const CurvePoint &point : clip(curve.band, time, {valueAxis->range().lower, valueAxis->range().upper})) {
        band->addData(point.t, point.value);
        floor->addData(point.t, std::isnan(point.value) ? point.value : valueAxis->range().lower);
    }
    QColor colour = m_colours.*curve.ink;
    colour.setAlpha(kOpacity);
    for (QCPGraph *edge : {floor, band}) {
        edge->setPen(Qt::NoPen);
        edge->setLayer(QStringLiteral("grid"));
    }
    band->setBrush(colour);
    band->setChannelFillGraph(floor);
    list(band, PlotFigure::tr("file's rounding"));
}

/// At a place given in parts of the axes, (0, 0) being the upper left corner.
QCPItemText *FigurePlot::addText(const Pane &pane, const QString &text, const QPointF &at, Qt::Alignment alignment)
{
    auto *item = new QCPItemText(this);
    item->position->setType(QCPItemPosition::ptAxisRectRatio);
    item->position->setAxisRect(pane.axes);
    item->position->setCoords(at);
    item->setClipToAxisRect(false);
    item->setPositionAlignment(alignment);
    item->setText(text);
    item->setFont(m_fonts.tick);
    item->setColor(m_colours.text);
    return item;
}

void FigurePlot::addTitleAndNote(const Pane &pane, const PlotPicture &picture)
{
    const QFontMetricsF metrics(m_fonts.title);
    const double room = pane.axes->outerRect().right() - pane.axes->left();
    const auto fits = [&](const QString &text) { return metrics.horizontalAdvance(text) <= room; };
    const auto longest = std::ranges::find_if(picture.titles, fits);
    QCPItemText *title = addText(pane, longest == picture.titles.end() ? picture.titles.last() : *longest, {0.0, 0.0},
                                 Qt::AlignLeft | Qt::AlignBottom);
    title->setFont(m_fonts.title);
    title->setPadding(QMargins(0, 0, 0, 3));
    if (!picture.note.isEmpty()) {
        addText(pane, picture.note, {0.5, picture.hasValues ? 0.1 : 0.5}, Qt::AlignCenter)
            ->setBrush(m_colours.background);
    }
}

/// As many entries side by side as fit.
void FigurePlot::wrapLegend(int width)
{
    for (int entries = legend->itemCount(); entries > 0; --entries) {
        legend->setWrap(entries);
        legend->setFillOrder(QCPLegend::foColumnsFirst, true);
        if (legend->minimumOuterSizeHint().width() <= width) {
            break;
        }
    }
}

} // namespace slidercrank
