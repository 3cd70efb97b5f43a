// SPDX-License-Identifier: GPL-3.0-or-later

// How the plots are laid out and drawn.

#include "ui/plots/plot_figure.h"

#include "ui/text/finding_text.h"

#include <QFontMetricsF>

#include <algorithm>
#include <cmath>

namespace slidercrank
{

namespace
{

constexpr double kNoStretch = 1e-3;
constexpr int kTickLength = 3;       // px
constexpr int kLabelGap = 4;         // px between a tick and its label
constexpr double kLegendLine = 28.0; // px
constexpr double kLegendGap = 7.0;   // px between a line and its name

int lineHeight(const QFont &font)
{
    return static_cast<int>(std::ceil(QFontMetricsF(font).height()));
}

/// Clips the curve to the axes and removes the points that make no visible difference.
void fit(PlotCurve &curve, const Interval &time, const Interval &values, int height)
{
    constexpr double kInvisible = 0.2; // px
    constexpr double kBelowEdge = 3.0; // px
    const double pixel = values.length() / std::max(height, 1);
    for (CurvePoint &dot : curve.dots) {
        dot.value = dot.value == PlotCurve::kUpperEdge ? values.upper - kBelowEdge * pixel : dot.value;
    }
    std::erase_if(curve.dots,
                  [&](const CurvePoint &dot) { return !time.contains(dot.t) || !values.contains(dot.value); });
    curve.points = clip(curve.points, time, values);
    if (curve.dots.empty()) {
        curve.dots = isolatedPoints(curve.points);
    }
    curve.points = withoutNeedlessPoints(curve.points, kInvisible * pixel);
}

} // namespace

PlotFigure::PlotFigure()
    : m_fonts(QFont())
    , m_grid(new QCPLayoutGrid)
    , m_footer(new QCPTextElement(this))
    , m_margins(new QCPMarginGroup(this))
    , m_timeTicker(new NumberTicker)
{
    axisRect()->insetLayout()->take(legend); // not used: this class draws its own
    plotLayout()->clear();
    plotLayout()->setRowSpacing(0);
    plotLayout()->addElement(0, 0, m_grid);
    plotLayout()->addElement(1, 0, m_footer);
    plotLayout()->setRowStretchFactors({1.0, kNoStretch});
    m_footer->setTextFlags(Qt::AlignLeft);
    m_footer->setMargins(QMargins(12, 0, 12, 4));
    m_grid->setRowSpacing(0);
    m_grid->setColumnSpacing(0);
}

void PlotFigure::applyStyle(const PlotStyle &style)
{
    m_style = style;
    m_fonts = PlotFonts(style.font);
    m_colours = seriesColours(style.palette);
    clearGraphs();
    m_grid->clear();
    m_plots = {};
    const int line = lineHeight(m_fonts.tick);
    for (const std::size_t index : style.plots) {
        Plot &plot = m_plots[index];
        plot.axes = new QCPAxisRect(this, false);
        plot.axes->addAxis(QCPAxis::atBottom);
        plot.axes->addAxis(QCPAxis::atLeft);
        plot.axes->setMinimumSize(50, 20); // low enough for the legend to keep its height in a small window
        plot.axes->setMarginGroup(QCP::msLeft | QCP::msRight, m_margins);
        plot.axes->setMargins(QMargins(0, lineHeight(m_fonts.title) + kLabelGap, 0, line));
        plot.axes->setAutoMargins(QCP::msLeft | QCP::msRight);
        const std::size_t place = style.plots.size() == 1 ? 0 : index;
        m_grid->addElement(static_cast<int>(place / kPlotColumns), static_cast<int>(place % kPlotColumns), plot.axes);
        plot.ticker.reset(new NumberTicker);
        for (const QString &title : titles(index)) {
            plot.titles.emplace_back(title).prepare({}, m_fonts.title);
        }
        axis(index, QCPAxis::atBottom).setTicker(m_timeTicker);
        axis(index, QCPAxis::atLeft).setTicker(plot.ticker);
        for (QCPAxis *axis : plot.axes->axes()) {
            axis->grid()->setVisible(true);
            axis->setTickLength(0, kTickLength);
            axis->setTickLabelPadding(kLabelGap);
        }
    }
    setStyle(m_fonts, m_colours);
    m_footer->setFont(m_fonts.tick);
    m_footer->setTextColor(m_colours.text);
}

void PlotFigure::compose(PlotStyle style, const QSize &size, const std::optional<double> &markedTime,
                         const QString &footer)
{
    m_isStale = false;
    style.isOfFile = m_result->reference != nullptr;
    style.error = m_settings.error;
    if (style != m_style) {
        applyStyle(style);
    }
    m_footer->setText(footer);
    m_footer->setVisible(!footer.isEmpty());
    const QCPAxisRect &axes = *m_plots[style.plots.front()].axes; // all have the same size
    QSize before;
    if (axes.size().isEmpty() || size != viewport().size()) {
        layOut(size);
        m_legend.clear();
    }
    constexpr int kPasses = 4; // the labels and the legend change the size of the axes
    for (int pass = 0; pass < kPasses && axes.size() != before; ++pass) {
        before = axes.size();
        fill(markedTime);
        layOut(size);
    }
    chooseTitles();
}

/// Chooses the longest titles that fit, of the same length for both motions of a row.
void PlotFigure::chooseTitles()
{
    for (const std::size_t index : plots()) {
        std::size_t &title = m_plots[index].title = 0;
        const auto fits = [&](std::size_t other) {
            const bool isAlike =
                other / kPlotColumns == index / kPlotColumns && isErrorPlot(other) == isErrorPlot(index);
            const QCPAxisRect &axes = *m_plots[other].axes;
            return !isAlike || m_plots[other].titles[title].size().width() <= axes.outerRect().right() - axes.left();
        };
        while (title + 1 < m_plots[index].titles.size() && !std::ranges::all_of(plots(), fits)) {
            ++title;
        }
    }
}

void PlotFigure::fill(const std::optional<double> &markedTime)
{
    clearGraphs();
    m_columns = static_cast<std::size_t>(std::max(1, m_plots[plots().front()].axes->width()));
    const Interval time = timeRange();
    m_curves.clear();
    for (const MotionCurves &motion : m_motions) {
        m_curves.push_back(motion.curves(time, m_columns));
    }
    m_errors.reset();
    if (m_result->isCompared() && std::ranges::any_of(plots(), &isErrorPlot)) {
        m_errors.emplace(*m_result, m_settings, time, m_columns);
    }
    setTimeScale();
    std::vector<LegendEntry> entries;
    for (const std::size_t index : plots()) {
        Plot &plot = m_plots[index];
        plot.curves.clear();
        plot.note.clear();
        plot.values.reset();
        if (!isErrorPlot(index)) {
            computeMotions(plot, channelOf(index));
        } else if (m_errors) {
            computeErrors(plot, index / kPlotColumns);
        } else {
            plot.note = tr("nothing to compare");
        }
        plot.values = plot.values && m_zoom.values[index] ? m_zoom.values[index] : plot.values;
        setValueScale(index);
        for (PlotCurve &curve : plot.curves) {
            fit(curve, time, plot.values.value_or(Interval()), plot.axes->height());
            const QPen pen = addCurve(plot, curve);
            if (std::ranges::find(entries, curve.name, &LegendEntry::name) == entries.end()) {
                entries.push_back({curve.name, pen});
            }
        }
        if (markedTime && time.contains(*markedTime) && plot.values) {
            const std::array line{CurvePoint{*markedTime, plot.values->lower},
                                  CurvePoint{*markedTime, plot.values->upper}};
            PlotDrawing::addCurve(plot.axes, line)->setPen(QPen(m_colours.cursor, 1.0));
        }
    }
    if (entries != m_legend) {
        m_legend = entries;
        placeLegend();
    }
}

/// Places as many entries side by side as fit above the plots.
void PlotFigure::placeLegend()
{
    constexpr double kApart = 12.0;       // px
    constexpr double kLongestLess = 80.0; // px
    const QFontMetricsF metrics(m_fonts.title);
    const int line = lineHeight(m_fonts.title) + kLabelGap;
    QPointF place(kApart, 6.0);
    for (LegendEntry &entry : m_legend) {
        entry.text = QStaticText(metrics.elidedText(entry.name, Qt::ElideMiddle, viewport().width() - kLongestLess));
        entry.text.prepare({}, m_fonts.title);
        const double length = kLegendLine + kLegendGap + entry.text.size().width();
        if (place.x() > kApart && place.x() + length > viewport().width()) {
            place = {kApart, place.y() + line};
        }
        entry.place = place;
        place.rx() += length + kApart;
    }
    m_legendSize = {static_cast<int>(place.x()), static_cast<int>(place.y()) + line};
    m_grid->setMargins(QMargins(0, m_legendSize.height(), 0,
                                lineHeight(m_fonts.tick) + 2 * kLabelGap)); // for the title of the time axis
}

/// Chooses as many ticks as there is space for labels. Only the bottom row has labels.
void PlotFigure::setTimeScale()
{
    constexpr double kLeast = 44.0; // px from tick to tick
    constexpr double kSpace = 14.0;
    constexpr double kUsualDigits = 6.0; // of a value; the axes do not move until a label has more
    const QFontMetricsF metrics(m_fonts.tick);
    const Interval time = timeRange();
    m_timeTicker->perUnit = 1.0 / perSecond();
    m_timeTicker->isAngle = isOverAngle();
    m_timeTicker->setTickOrigin(zeroTime());
    double labelWidth = 0.0;
    const auto setDistance = [this](double pixels) {
        m_timeTicker->setTickCount(std::max(1, static_cast<int>(static_cast<double>(m_columns) / pixels)));
    };
    setDistance(kLeast);
    QVector<double> ticks;
    QVector<QString> labels;
    m_timeTicker->generate({time.lower, time.upper}, QLocale(), u'g', 6, ticks, nullptr, &labels);
    for (const QString &label : labels) {
        labelWidth = std::max(labelWidth, metrics.horizontalAdvance(label));
    }
    setDistance(std::max(kLeast, labelWidth + kSpace));
    const QString title = isOverAngle() ? "θ₂ [°]" : "t [s]";
    const double valueWidth = kUsualDigits * metrics.horizontalAdvance(u'0');
    const QMargins least(static_cast<int>(valueWidth) + kTickLength + kLabelGap, 0, static_cast<int>(0.5 * labelWidth),
                         0);
    for (const std::size_t index : plots()) {
        const bool isBottom = static_cast<int>(index / kPlotColumns) + 1 >= m_grid->rowCount();
        QCPAxis &axis = this->axis(index, QCPAxis::atBottom);
        axis.setRange(time.lower, time.upper);
        axis.setTickLabels(isBottom);
        axis.setLabel(isBottom ? title : QString());
        m_plots[index].axes->setMinimumMargins(least);
    }
}

void PlotFigure::setValueScale(std::size_t index)
{
    constexpr int kPixelsPerTick = 30;
    Plot &plot = m_plots[index];
    const Interval values = plot.values.value_or(Interval());
    plot.ticker->isLogarithmic = isLogarithmic(index);
    plot.ticker->setTickCount(std::max(2, plot.axes->height() / kPixelsPerTick));
    axis(index, QCPAxis::atLeft).setRange(values.lower, values.upper);
    axis(index, QCPAxis::atLeft).setTickLabels(plot.values.has_value());
}

/// Returns "coupler angular velocity ω³ = dθ³/dt [°/s]" or "error [% of peak]", and shorter variants.
QStringList PlotFigure::titles(std::size_t index) const
{
    const bool isError = isErrorPlot(index);
    const Channel channel = kPlottedChannels[isError ? index / kPlotColumns * kErrorColumn : channelOf(index)];
    QString unit = unitText(channel);
    QStringList titles;
    if (isError) {
        const std::array units{QString("%"),
                               QStringLiteral("%1; %2").arg(unit, unitText({Coordinate::R4x, channel.order})),
                               tr("% of peak")};
        unit = units[static_cast<std::size_t>(m_style.error)];
        titles << (m_style.isOfFile ? tr("error") : tr("difference")) << QString();
    } else {
        const auto order = static_cast<std::size_t>(channel.order);
        const std::array shortNames{isAngle(channel.coordinate) ? tr("angle") : tr("position"), tr("velocity"),
                                    tr("acceleration")};
        const QString symbol = symbolText(channel);
        if (order > 0) {
            const QString integral = symbolText(Channel{channel.coordinate, static_cast<Order>(order - 1)});
            titles << QStringLiteral("%1 %2 = d%3/dt").arg(quantityName(channel), symbol, integral);
        }
        titles << QStringLiteral("%1 %2").arg(quantityName(channel), symbol) << quantityName(channel)
               << shortNames[order];
    }
    for (QString &title : titles) {
        title = QStringLiteral("%1 [%2]").arg(title, unit).trimmed();
    }
    return titles;
}

/// Returns the pen for the legend.
QPen PlotFigure::addCurve(const Plot &plot, const PlotCurve &curve)
{
    const QColor colour = m_colours.*curve.ink;
    QPen pen(colour, curve.width * m_fonts.lineFactor, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin); // these draw fastest
    if (!curve.dashes.empty()) {
        pen.setDashPattern(curve.dashes);
    }
    PlotDrawing::addCurve(plot.axes, curve.points)->setPen(pen);
    if (!curve.dots.empty()) {
        const double size = 4.0 * m_fonts.lineFactor;
        QCPGraph *dots = PlotDrawing::addCurve(plot.axes, curve.dots);
        dots->setLineStyle(QCPGraph::lsNone);
        dots->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, colour, size));
        if (curve.points.empty()) {
            pen = QPen(colour, size, Qt::DotLine, Qt::RoundCap);
        }
    }
    return pen;
}

/// Draws the legend, the titles and the notes over the rest.
void PlotFigure::draw(QCPPainter *painter)
{
    constexpr double kAboveAxes = 2.0; // px
    PlotDrawing::draw(painter);
    const double titleHeight = QFontMetricsF(m_fonts.title).height();
    painter->setFont(m_fonts.title);
    for (const LegendEntry &entry : m_legend) {
        painter->setAntialiasing(true);
        painter->setPen(entry.pen);
        const QPointF from = entry.place + QPointF(0.0, std::round(0.5 * titleHeight));
        painter->drawLine(QLineF(from, from + QPointF(kLegendLine, 0.0)));
        painter->setPen(m_colours.text);
        painter->drawStaticText(entry.place + QPointF(kLegendLine + kLegendGap, 0.0), entry.text);
    }
    painter->setPen(m_colours.text);
    for (const std::size_t index : plots()) {
        const Plot &plot = m_plots[index];
        const QRect axes = plot.axes->rect();
        painter->setFont(m_fonts.title);
        painter->drawStaticText(QPointF(axes.left(), axes.top() - kAboveAxes - titleHeight), plot.titles[plot.title]);
        painter->setFont(m_fonts.tick);
        QRect note = painter->fontMetrics().boundingRect(plot.note);
        note.moveCenter({axes.center().x(), plot.values ? axes.top() + axes.height() / 10 : axes.center().y()});
        painter->fillRect(note, m_colours.background);
        painter->drawText(note, Qt::AlignCenter, plot.note);
    }
}

} // namespace slidercrank
