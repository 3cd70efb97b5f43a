// SPDX-License-Identifier: GPL-3.0-or-later

// How the plots are laid out and drawn.

#include "ui/plots/plot_figure.h"

#include "ui/text/axis_scale.h"
#include "ui/text/finding_text.h"

#include <QFontMetricsF>

#include <algorithm>
#include <cmath>

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

QVector<QCPGraphData> graphData(const std::vector<CurvePoint> &points)
{
    QVector<QCPGraphData> data;
    data.reserve(static_cast<qsizetype>(points.size()));
    for (const CurvePoint &point : points) {
        data << QCPGraphData(point.t, point.value);
    }
    return data;
}

/// Returns "coupler angular velocity ω³ = dθ³/dt [°/s]" and shorter variants.
QStringList motionTitles(Channel channel, const QString &unit)
{
    const QString name = quantityOf(channel);
    const QString symbol = symbolOf(channel);
    const auto order = static_cast<std::size_t>(channel.order);
    const std::array shortNames{isAngle(channel.coordinate) ? PlotFigure::tr("angle") : PlotFigure::tr("position"),
                                PlotFigure::tr("velocity"), PlotFigure::tr("acceleration")};
    QStringList titles{QStringLiteral("%1 %2").arg(name, symbol), name, shortNames[order]};
    if (order > 0) {
        const QString integral = symbolOf(Channel{channel.coordinate, static_cast<Order>(order - 1)});
        titles.prepend(QStringLiteral("%1 %2 = d%3/dt").arg(name, symbol, integral));
    }
    for (QString &title : titles) {
        title += QStringLiteral(" [%1]").arg(unit);
    }
    return titles;
}

/// Clips the curve to the axes and removes the points that make no visible difference.
void fit(PlotCurve &curve, const Interval &time, const Interval &values, const QSize &axes)
{
    constexpr double kInvisible = 0.1; // px
    constexpr double kBelowEdge = 3.0; // px
    const double pixel = values.length() / std::max(axes.height(), 1);
    for (CurvePoint &dot : curve.dots) {
        dot.value = dot.value == PlotCurve::kUpperEdge ? values.upper - kBelowEdge * pixel : dot.value;
    }
    std::erase_if(curve.dots,
                  [&](const CurvePoint &dot) { return !time.contains(dot.t) || !values.contains(dot.value); });
    const auto areTooClose = [&](const CurvePoint &a, const CurvePoint &b) {
        return b.value == a.value && b.t - a.t < time.length() / axes.width();
    };
    curve.dots.erase(std::unique(curve.dots.begin(), curve.dots.end(), areTooClose), curve.dots.end());
    curve.points = clip(curve.points, time, values);
    if (curve.dots.empty()) {
        curve.dots = isolatedPoints(curve.points);
    }
    curve.points = withoutNeedlessPoints(curve.points, kInvisible * pixel);
}

} // namespace

/// Draws the ticks and labels of an AxisScale. The label of the number x is at the coordinate x · perUnit +
/// tickOrigin().
class ScaleTicker : public QCPAxisTicker
{
public:
    AxisScale scale;
    double perUnit = 1.0;

protected:
    double getTickStep(const QCPRange &) override { return scale.step * std::abs(perUnit); }
    QString getTickLabel(double tick, const QLocale &locale, QChar, int) override
    {
        return scale.label((tick - mTickOrigin) / perUnit, locale);
    }
};

PlotFigure::PlotFigure()
    : m_fonts(QFont())
    , m_top(new QCPLayoutGrid)
    , m_grid(new QCPLayoutGrid)
    , m_footer(new QCPTextElement(this))
    , m_timeTicker(new ScaleTicker)
{
    axisRect()->insetLayout()->take(legend);
    plotLayout()->clear();
    plotLayout()->setRowSpacing(0);
    plotLayout()->addElement(0, 0, m_top);
    plotLayout()->addElement(1, 0, m_grid);
    plotLayout()->addElement(2, 0, m_footer);
    plotLayout()->setRowStretchFactor(0, kNoStretch);
    plotLayout()->setRowStretchFactor(2, kNoStretch);
    m_footer->setTextFlags(Qt::AlignLeft);
    m_footer->setMargins(QMargins(12, 0, 12, 4));
    m_top->addElement(0, 0, legend);
    m_top->expandTo(1, 2);
    m_top->setColumnStretchFactor(0, kNoStretch);
    legend->setVisible(true);
    legend->setMargins(QMargins(12, 4, 0, 4));
    legend->setIconSize(28, 12);
    legend->setColumnSpacing(12);
    m_grid->setRowSpacing(0);
    m_grid->setColumnSpacing(0);
    for (QCPMarginGroup *&group : m_columnMargins) {
        group = new QCPMarginGroup(this);
    }
}

void PlotFigure::setPlots(const std::vector<std::size_t> &plots, const PlotFonts &fonts, const SeriesColours &colours)
{
    m_shown = plots;
    m_fonts = fonts;
    m_colours = colours;
    clearGraphs();
    clearItems();
    legend->clearItems();
    m_grid->clear();
    m_plots = {};
    for (const std::size_t index : plots) {
        Plot &plot = m_plots[index];
        const int row = plots.size() == 1 ? 0 : static_cast<int>(index / kPlotColumns);
        const int column = plots.size() == 1 ? 0 : static_cast<int>(index % kPlotColumns);
        plot.axes = new QCPAxisRect(this);
        plot.axes->setMarginGroup(QCP::msLeft | QCP::msRight, m_columnMargins[index % kPlotColumns]);
        plot.axes->setMargins(QMargins(0, lineHeight(fonts.title) + kLabelGap, 0, 0));
        plot.axes->setAutoMargins(QCP::msLeft | QCP::msRight | QCP::msBottom);
        m_grid->addElement(row, column, plot.axes);
        plot.ticker.reset(new ScaleTicker);
        axis(index, QCPAxis::atBottom).setTicker(m_timeTicker);
        axis(index, QCPAxis::atLeft).setTicker(plot.ticker);
        for (QCPAxis *axis : plot.axes->axes()) {
            axis->setTickLength(0, kTickLength);
            axis->setTickLabelPadding(kLabelGap);
        }
    }
    setStyle(fonts, colours);
    legend->setFont(fonts.title);
    m_footer->setFont(fonts.tick);
    m_footer->setTextColor(colours.text);
}

QString PlotFigure::description(std::size_t plot) const
{
    return QStringList{m_plots[plot].titles.first(), m_plots[plot].note}.join(QStringLiteral(". "));
}

QRect PlotFigure::legendPlace() const
{
    return legend->outerRect();
}

void PlotFigure::setFooter(const QString &text)
{
    m_footer->setText(text);
    m_footer->setVisible(!text.isEmpty());
}

void PlotFigure::show(const QSize &size, const std::optional<double> &markedTime)
{
    const auto axisSizes = [this] {
        std::vector<QSize> sizes;
        for (const std::size_t plot : m_shown) {
            sizes.push_back(m_plots[plot].axes->size());
        }
        return sizes;
    };
    layOut(size);
    constexpr int kPasses = 4;
    for (int pass = 0; pass < kPasses; ++pass) { // the labels and the legend change the size of the axes
        const std::vector<QSize> before = axisSizes();
        fill(markedTime);
        for (int entries = legend->itemCount(); entries > 0; --entries) { // place as many entries side by side as fit
            legend->setWrap(entries);
            legend->setFillOrder(QCPLegend::foColumnsFirst, true);
            if (legend->minimumOuterSizeHint().width() <= size.width()) {
                break;
            }
        }
        layOut(size);
        if (axisSizes() == before) {
            break;
        }
    }
}

void PlotFigure::fill(const std::optional<double> &markedTime)
{
    clearGraphs();
    clearItems();
    legend->clearItems();
    m_columns = 1;
    for (const std::size_t index : m_shown) {
        m_columns = std::max(m_columns, static_cast<std::size_t>(m_plots[index].axes->width()));
    }
    if (m_result && !m_result->reference) {
        m_errors.reset(); // they were computed for the pixels of another layout
    }
    const Interval time = timeRange();
    setTimeScale();
    for (const std::size_t index : m_shown) {
        Plot &plot = m_plots[index];
        plot.curves.clear();
        plot.note.clear();
        plot.values.reset();
        if (m_result && isErrorPlot(index)) {
            computeErrors(plot, index / kPlotColumns);
        } else if (m_result) {
            computeMotions(plot, channelOf(index));
        }
        if (plot.values && zoom.values[index]) {
            plot.values = zoom.values[index];
        }
        setValueScale(index);
        for (PlotCurve &curve : plot.curves) {
            fit(curve, time, plot.values.value_or(Interval()), plot.axes->size());
            addCurve(plot, curve);
        }
        addTexts(plot);
        if (markedTime && time.contains(*markedTime) && plot.values) {
            PlotDrawing::addCurve(plot.axes, {{*markedTime, plot.values->lower}, {*markedTime, plot.values->upper}})
                ->setPen(QPen(m_colours.cursor, 1.0));
        }
    }
}

/// Chooses as many ticks as there is space for labels. Only the bottom row has labels.
void PlotFigure::setTimeScale()
{
    constexpr double kLeast = 44.0; // px from tick to tick
    constexpr double kSpace = 14.0;
    constexpr double kUsualDigits = 6.0; // of a value; the axes do not move until a label has more
    const double digitWidth = QFontMetricsF(m_fonts.tick).horizontalAdvance(u'0');
    const Interval time = timeRange();
    const double perSecond = isOverAngle() ? m_result->mechanism.omega2() * kDegreesPerRadian : 1.0;
    const double zero = isOverAngle() ? -m_result->mechanism.theta20() / m_result->mechanism.omega2() : 0.0;
    const auto [first, last] = std::minmax({(time.lower - zero) * perSecond, (time.upper - zero) * perSecond});
    const Interval labels{first, last};
    const auto scaleFor = [&](double pixels) {
        const double ticks = static_cast<double>(m_columns) / pixels;
        return isOverAngle() ? degreeScale(labels, ticks) : axisScale(labels, ticks);
    };
    const double labelWidth = digitWidth * scaleFor(kLeast).labelLength(labels);
    m_timeTicker->scale = scaleFor(std::max(kLeast, labelWidth + kSpace));
    m_timeTicker->perUnit = 1.0 / perSecond;
    m_timeTicker->setTickOrigin(zero);
    const QString title = isOverAngle() ? QStringLiteral("θ₂ [%1]").arg(m_timeTicker->scale.unit(QStringLiteral("°")))
                                        : QStringLiteral("t [%1]").arg(m_timeTicker->scale.unit(QStringLiteral("s")));
    const QMargins least(static_cast<int>(kUsualDigits * digitWidth) + kTickLength + kLabelGap, 0,
                         static_cast<int>(0.5 * labelWidth), lineHeight(m_fonts.tick));
    const int rows = m_grid->rowCount();
    for (const std::size_t index : m_shown) {
        const bool isBottom = static_cast<int>(index / kPlotColumns) + 1 >= rows;
        axis(index, QCPAxis::atBottom).setRange(time.lower, time.upper);
        axis(index, QCPAxis::atBottom).setTickLabels(isBottom);
        axis(index, QCPAxis::atBottom).setLabel(isBottom ? title : QString());
        m_plots[index].axes->setMinimumMargins(least);
    }
    const int below =
        m_plots[m_shown.back()].axes->margins().bottom() - m_plots[m_shown.front()].axes->margins().bottom();
    const double height = std::max(1, m_grid->outerRect().height() - below);
    m_grid->setRowStretchFactor(rows - 1, 1.0 + rows * below / height);
}

void PlotFigure::setValueScale(std::size_t index)
{
    constexpr double kPixelsPerTick = 30.0;
    Plot &plot = m_plots[index];
    const Interval values = plot.values.value_or(Interval());
    const double ticks = plot.axes->height() / kPixelsPerTick;
    const bool isLogarithmic = isErrorPlot(index) && m_settings.logarithmicError;
    plot.ticker->scale = isLogarithmic ? logarithmicScale(values, ticks) : axisScale(values, ticks);
    axis(index, QCPAxis::atLeft).setRange(values.lower, values.upper);
    axis(index, QCPAxis::atLeft).setTickLabels(plot.values.has_value());
    const std::size_t channel = isErrorPlot(index) ? index / kPlotColumns * kErrorColumn : channelOf(index);
    QString unit = isErrorPlot(index) ? errorUnit(channel) : unitOf(kPlottedChannels[channel]);
    unit = plot.values ? plot.ticker->scale.unit(unit) : unit;
    const QString error = m_result && m_result->reference ? tr("error [%1]") : tr("difference [%1]");
    plot.titles = isErrorPlot(index) ? QStringList{error.arg(unit)} : motionTitles(kPlottedChannels[channel], unit);
}

void PlotFigure::addToLegend(QCPGraph *graph, const QString &name)
{
    constexpr int kLongest = 300; // px
    graph->setName(QFontMetrics(legend->font()).elidedText(name, Qt::ElideMiddle, kLongest));
    for (int i = 0; i < legend->itemCount(); ++i) {
        auto *entry = qobject_cast<QCPPlottableLegendItem *>(legend->item(i));
        if (entry && entry->plottable()->name() == graph->name()) {
            return; // a curve of another plot has this entry
        }
    }
    auto *entry = new QCPPlottableLegendItem(legend, graph);
    entry->setMargins(QMargins(0, 2, 0, 2)); // else descenders are cut off
    legend->addItem(entry);
}

void PlotFigure::addCurve(const Plot &plot, const PlotCurve &curve)
{
    const QColor colour = m_colours.*curve.ink;
    QCPGraph *line = PlotDrawing::addCurve(plot.axes, graphData(curve.points));
    QPen pen(colour, curve.width * m_fonts.lineFactor, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin); // these draw fastest
    if (!curve.dashes.empty()) {
        QVector<double> pattern = curve.dashes;
        std::ranges::for_each(pattern, [&](double &length) { length /= curve.width; });
        pen.setDashPattern(pattern);
    }
    line->setPen(pen);
    if (!curve.dots.empty()) {
        QCPGraph *dots = PlotDrawing::addCurve(plot.axes, graphData(curve.dots));
        dots->setLineStyle(QCPGraph::lsNone);
        dots->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, colour, 4.0));
        line = curve.points.empty() ? dots : line;
    }
    addToLegend(line, curve.name);
}

void PlotFigure::addTexts(const Plot &plot)
{
    constexpr auto kRatio = QCPItemPosition::ptAxisRectRatio; // (0, 0) is the upper left corner
    const QFontMetricsF metrics(m_fonts.title);
    const auto fits = [&, space = plot.axes->outerRect().right() - plot.axes->left()](const QString &text) {
        return metrics.horizontalAdvance(text) <= space;
    };
    const auto longest = std::ranges::find_if(plot.titles, fits);
    QCPItemText *title = addText(plot.axes, longest == plot.titles.end() ? plot.titles.last() : *longest, {0.0, 0.0},
                                 Qt::AlignLeft | Qt::AlignBottom, kRatio);
    title->setFont(m_fonts.title);
    title->setPadding(QMargins(0, 0, 0, 3));
    if (!plot.note.isEmpty()) {
        addText(plot.axes, plot.note, {0.5, plot.values ? 0.1 : 0.5}, Qt::AlignCenter, kRatio)
            ->setBrush(m_colours.background);
    }
}

} // namespace slidercrank
