// SPDX-License-Identifier: GPL-3.0-or-later

// How the plots are laid out and drawn.

#include "ui/plots/plot_figure.h"

#include "ui/plots/plot_drawing.h"
#include "ui/text/channel_text.h"
#include "ui/text/parameter_text.h"
#include "ui/text/subscripts.h"
#include "ui/widgets/paragraph.h"

#include <QFontMetricsF>

#include <algorithm>
#include <array>
#include <cmath>

namespace slidercrank
{

namespace
{

constexpr int kTickLength = 3; // px
constexpr int kLabelGap = 4;   // px between a tick and its label

constexpr QSize kMinSizeOfAxes{50, 20}; // px: low enough for the legend to keep its height in a small window
constexpr int kAboveLegend = 6;         // px
constexpr int kLegendSpacing = 12;      // px between two entries of the legend, and between them and the edges
constexpr int kLinesOfTimeLabels = 2;   // lines of text below a plot: the numbers and the title of the time axis

constexpr int kNoteFlags = Qt::AlignHCenter | Qt::AlignVCenter | Qt::TextWordWrap;
constexpr double kAroundNote = 2.0; // px

int lineHeight(const QFont &font)
{
    return QFontMetrics(font).height();
}

/// Clips the curve to the axes, inserts the points that are missing on a device whose smallest detail is `detail` (px),
/// and removes the points that make no visible difference. The curve is then off by less than a third of the detail.
void fitToAxes(PlotCurve &curve, const Interval &time, const Interval &values, const QSize &axes, double detail)
{
    constexpr double kScreenDetail = 1.0; // px: a curve has points for details of this size, but not for smaller ones
    constexpr double kInsertTolerance = 0.1; // details
    constexpr double kRemoveTolerance = 0.2; // details
    constexpr double kBelowEdge = 3.0;       // px
    const double pixel = values.length() / std::max(axes.height(), 1);
    if (curve.valueAt && detail < kScreenDetail) {
        const CurveScale scale{axes.width() / time.length(), 1.0 / pixel};
        curve.points = refine(curve.points, curve.valueAt, scale, kInsertTolerance * detail, values);
    }
    for (CurvePoint &dot : curve.dots) {
        dot.value = dot.value == PlotCurve::kUpperEdge ? values.upper - kBelowEdge * pixel : dot.value;
    }
    std::erase_if(curve.dots,
                  [&](const CurvePoint &dot) { return !time.contains(dot.t) || !values.contains(dot.value); });
    curve.points = clip(curve.points, time, values);
    if (curve.dots.empty()) {
        curve.dots = isolatedPoints(curve.points);
    }
    curve.points = withoutNeedlessPoints(curve.points, kRemoveTolerance * detail * pixel);
}

/// Returns the number of plots side by side. It is two for the six plots of the motion and for any four plots, so that
/// their rows are complete, and otherwise at most three. If it exceeds `maxColumns`, up to three plots are placed one
/// below the other, and more plots in `maxColumns` columns.
std::size_t columnsFor(const std::vector<std::size_t> &plots, std::size_t maxColumns)
{
    constexpr std::size_t kPair = 2;
    const std::size_t count = plots.size();
    const bool isGridWithoutErrors = count == kPair * kPlotRows && std::ranges::none_of(plots, &isErrorPlot);
    const bool isSquare = count == kPair * kPair;
    const std::size_t columns = isSquare || isGridWithoutErrors ? kPair : std::min(count, kPlotColumns);
    if (columns <= maxColumns) {
        return columns;
    }
    return count <= kPlotColumns ? 1 : maxColumns;
}

/// Returns whether the last row of the figure has fewer plots than the other rows. Then every plot has numbers on its
/// time axis, and space for them below it.
bool isLastRowShort(const PlotStyle &style)
{
    return style.plots.size() % columnsFor(style.plots, style.maxColumns) != 0;
}

/// Returns a name of the legend for lines of that width (px): a long name has several lines, and a word that is too
/// long for one, such as the name of a file, is elided.
QStaticText legendName(const QString &name, const QFont &font, int width)
{
    const QFontMetrics metrics(font);
    const QStringList words = withUnbrokenUnits(name).split(u' ');
    const auto isTooLong = [&](const QString &word) { return metrics.horizontalAdvance(word) > width; };
    const bool fits = !isTooLong(name) || std::ranges::none_of(words, isTooLong);
    QStaticText text;
    text.setTextFormat(Qt::PlainText); // a file's name may look like HTML
    text.setText(fits ? words.join(u' ') : metrics.elidedText(name, Qt::ElideMiddle, width));
    if (fits && isTooLong(name)) {
        text.setTextWidth(width);
    }
    text.prepare({}, font);
    return text;
}

} // namespace

PlotFigure::PlotFigure()
    : m_drawing(new PlotDrawing)
    , m_margins(new QCPMarginGroup(m_drawing.get()))
    , m_timeTicker(new NumberTicker)
{
    m_drawing->plotLayout()->setRowSpacing(0);
    m_drawing->plotLayout()->setColumnSpacing(0);
}

PlotFigure::~PlotFigure() = default;

void PlotFigure::applyStyle(const PlotStyle &style)
{
    m_style = style;
    m_fonts = PlotFonts(style.font);
    m_colours = seriesColours(style.palette);
    m_drawing->clearGraphs();
    m_drawing->plotLayout()->clear();
    m_plots = {};
    const std::size_t count = style.plots.size();
    const std::size_t columns = columnsFor(style.plots, style.maxColumns);
    const bool hasLabelsEverywhere = isLastRowShort(style);
    for (std::size_t place = 0; place < count; ++place) {
        const std::size_t index = style.plots[place];
        Plot &plot = m_plots[index];
        const std::size_t row = place / columns;
        plot.hasTimeLabels = hasLabelsEverywhere || row + 1 == count / columns;
        constexpr bool kHasFourAxes = false; // only the two that are added below
        plot.axes = new QCPAxisRect(m_drawing.get(), kHasFourAxes);
        plot.timeAxis = plot.axes->addAxis(QCPAxis::atBottom);
        plot.valueAxis = plot.axes->addAxis(QCPAxis::atLeft);
        plot.axes->setMinimumSize(kMinSizeOfAxes);
        plot.axes->setMarginGroup(QCP::msLeft | QCP::msRight, m_margins);
        const int linesBelow = hasLabelsEverywhere ? kLinesOfTimeLabels + 1 : 1;
        const int below = linesBelow * lineHeight(m_fonts.tick);
        plot.axes->setMargins(QMargins(0, lineHeight(m_fonts.title) + kLabelGap, 0, below));
        plot.axes->setAutoMargins(QCP::msLeft | QCP::msRight);
        m_drawing->plotLayout()->addElement(static_cast<int>(row), static_cast<int>(place % columns), plot.axes);
        plot.ticker.reset(new NumberTicker);
        for (const QString &title : titles(index)) {
            plot.titles.push_back(withSubscripts(title, m_fonts.title));
        }
        plot.timeAxis->setTicker(m_timeTicker);
        plot.valueAxis->setTicker(plot.ticker);
        for (QCPAxis *axis : plot.axes->axes()) {
            axis->grid()->setVisible(true);
            axis->setTickLength(0, kTickLength);
            axis->setTickLabelPadding(kLabelGap);
        }
    }
    m_drawing->setStyle(m_fonts, m_colours);
}

void PlotFigure::compose(PlotStyle style, const QSize &size)
{
    m_isStale = false;
    style.isOfFile = m_result->reference != nullptr;
    style.error = m_settings.error;
    if (style.maxColumns < kPlotColumns && std::ranges::is_sorted(style.plots)) { // the order of the window
        std::stable_partition(style.plots.begin(), style.plots.end(),
                              [](std::size_t plot) { return !isErrorPlot(plot); });
    }
    if (!m_result->pinned.empty()) {
        style.comparedWith = pinnedText(m_result->pinned.back(), m_result->mechanism.parameters());
    }
    if (style != m_style) {
        applyStyle(style);
    }
    const QCPAxisRect &axes = *m_plots[style.plots.front()].axes; // all have the same size
    QSize previousSize;
    if (axes.size().isEmpty() || size != m_drawing->viewport().size()) {
        m_drawing->layOut(size);
        m_names.clear();
    }
    constexpr int kPasses = 4; // the labels and the legend change the size of the axes
    for (int pass = 0; pass < kPasses && axes.size() != previousSize; ++pass) {
        previousSize = axes.size();
        fill();
        m_drawing->layOut(size);
    }
    chooseTitles();
}

/// Chooses the longest variant of the titles that fits. All motions have the same variant, and so do all errors.
void PlotFigure::chooseTitles()
{
    const QCPAxisRect &axes = *m_plots[plots().front()].axes;
    const int space = axes.outerRect().right() - axes.left();
    for (const std::size_t index : plots()) {
        Plot &plot = m_plots[index];
        const auto isTooLong = [&](std::size_t variant) {
            return std::ranges::any_of(plots(), [&](std::size_t other) {
                const bool isAlike = isErrorPlot(other) == isErrorPlot(index);
                return isAlike && m_plots[other].titles[variant].size().width() > space;
            });
        };
        plot.title = 0;
        while (plot.title + 1 < plot.titles.size() && isTooLong(plot.title)) {
            ++plot.title;
        }
    }
}

/// Computes the curves, the note and the range of values of a plot.
void PlotFigure::computePlot(std::size_t index)
{
    Plot &plot = m_plots[index];
    plot.curves.clear();
    plot.note.clear();
    plot.values.reset();
    if (!isErrorPlot(index)) {
        computeMotions(plot, channelIndex(index));
    } else if (m_errors) {
        computeErrors(plot, orderOfPlot(index));
    } else {
        plot.note = tr("nothing to compare");
    }
    if (plot.values && m_zoom.values[index]) {
        plot.values = m_zoom.values[index];
    } else if (plot.values && !plot.note.isEmpty()) {
        plot.values = withSpaceForNote(plot, *plot.values);
    }
}

/// Gives the value axis of a plot its range and its ticks.
void PlotFigure::scaleAxis(std::size_t index)
{
    constexpr int kPixelsPerTick = 30;
    constexpr int kMinTicks = 2;
    Plot &plot = m_plots[index];
    const Interval values = plot.values.value_or(Interval());
    plot.valueAxis->setRange(values.lower, values.upper);
    plot.valueAxis->setTickLabels(plot.values.has_value());
    const ShownScale scale = shownScaleOf(index);
    plot.ticker->perUnit = 1.0 / scale.factor;
    plot.ticker->setTickOrigin(-scale.offset / scale.factor);
    plot.ticker->isLogarithmic = isLogarithmic(index);
    const int height = std::max(1, plot.axes->height());
    plot.ticker->setTickCount(std::max(kMinTicks, height / kPixelsPerTick));
    plot.ticker->minLabelDistance = values.length() * lineHeight(m_fonts.tick) / height;
}

/// Fits the curves of a plot to its axes, adds them to the drawing, and lists them in the legend.
void PlotFigure::drawCurves(Plot &plot)
{
    const Interval values = plot.values.value_or(Interval());
    for (PlotCurve &curve : plot.curves) {
        fitToAxes(curve, timeRange(), values, plot.axes->size(), m_style.detail);
        const QPen pen = addCurve(plot, curve);
        if (std::ranges::none_of(m_legend, [&](const auto &entry) { return entry.first == curve.name; })) {
            m_legend.emplace_back(curve.name, pen);
        }
    }
}

/// Computes all plots for the present size of the axes, and draws their curves.
void PlotFigure::fill()
{
    m_drawing->clearGraphs();
    const int width = std::max(1, m_plots[plots().front()].axes->width());
    m_columns = static_cast<std::size_t>(std::ceil(width / m_style.detail));
    const Interval time = timeRange();
    for (ShownMotion &pinned : m_pinned) {
        pinned.curves = pinned.motion.curves(time, m_columns);
    }
    m_model->curves = m_model->motion.curves(time, m_columns);
    m_errors.reset();
    if (m_result->isCompared() && std::ranges::any_of(plots(), &isErrorPlot)) {
        m_errors.emplace(*m_result, m_settings, time, m_columns);
    }
    setTimeScale();
    m_legend.clear();
    for (const std::size_t index : plots()) {
        computePlot(index);
        scaleAxis(index);
        drawCurves(m_plots[index]);
    }
    m_legendSize = placeLegend();
    const int linesBelow = isLastRowShort(m_style) ? 0 : kLinesOfTimeLabels;
    m_drawing->plotLayout()->setMargins( // for the legend, and the numbers and the title of the time axis
        {0, m_legendSize.height(), 0, linesBelow * lineHeight(m_fonts.tick) + kLabelGap});
}

/// Places as many entries of the legend side by side as fit, and the times of the values at a cursor after them. Draws
/// them if there is a painter, and returns their size.
QSize PlotFigure::placeLegend(QPainter *painter)
{
    constexpr int kLine = 28;            // px, length of the line before a name
    constexpr int kGap = 7;              // px between a line and its name
    constexpr int kSpaceBesideName = 80; // px: the line before a name, and spacing
    const int width = m_drawing->viewport().width();
    const int height = lineHeight(m_fonts.title);
    QPoint place(kLegendSpacing, kAboveLegend);
    for (const auto &[name, pen] : m_legend) {
        QStaticText &text = m_names[name];
        if (text.text().isEmpty()) {
            text = legendName(name, m_fonts.title, width - kSpaceBesideName);
        }
        const int length = kLine + kGap + static_cast<int>(text.size().width());
        if (place.x() + length > width && place.x() > kLegendSpacing) {
            place = {kLegendSpacing, place.y() + height + kLabelGap};
        }
        if (painter) {
            const QPoint from = place + QPoint(0, height / 2);
            painter->setPen(pen);
            painter->drawLine(from, from + QPoint(kLine, 0));
            painter->setPen(m_colours.text);
            painter->drawStaticText(place + QPoint(kLine + kGap, 0), text);
        }
        const int furtherLines = std::max(0, static_cast<int>(std::lround(text.size().height())) - height);
        place += QPoint(length + kLegendSpacing, furtherLines);
    }
    place = placeTimes(place, painter);
    return {place.x(), place.y() + height + kLabelGap};
}

/// Places the times of the values that a cursor shows after the legend, whose next entry would be at `place`: at the
/// right end of its last line or, where there is no space, in lines of their own. Draws them if there is a painter.
/// Returns the place after them.
QPoint PlotFigure::placeTimes(QPoint place, QPainter *painter) const
{
    if (!m_style.cursorTime) {
        return place;
    }
    const QFontMetrics metrics(m_fonts.tick);
    const int right = m_drawing->viewport().width() - kLegendSpacing;
    const QStringList times = cursorTexts(*m_style.cursorTime);
    const QString inOneLine = times.join("; ");
    const bool fitsInOneLine = metrics.horizontalAdvance(inOneLine) <= right - kLegendSpacing;
    for (const QString &text : fitsInOneLine ? QStringList(inOneLine) : times) {
        const int left = right - metrics.horizontalAdvance(text);
        if (left < place.x()) {
            place = {kLegendSpacing, place.y() + lineHeight(m_fonts.title) + kLabelGap};
        }
        if (painter) {
            painter->setFont(m_fonts.tick);
            painter->setPen(m_colours.text);
            painter->drawText(left, place.y() + QFontMetrics(m_fonts.title).ascent(), text);
        }
        place.setX(right + kLegendSpacing);
    }
    return place;
}

/// Chooses as many ticks of the time axes as there is space for labels, and gives the plots that have time labels a
/// title below them.
void PlotFigure::setTimeScale()
{
    constexpr double kMinTickDistance = 44.0; // px from tick to tick
    constexpr double kLabelDistance = 14.0;   // px from label to label
    constexpr int kMarginBesideLabel = 3;     // px, because a label that touches the edge of the figure is not drawn
    const QFontMetrics metrics(m_fonts.tick);
    const Interval time = timeRange();
    m_timeTicker->perUnit = 1.0 / perSecond();
    m_timeTicker->angle = isOverAngle() ? std::optional(notation().units.angle) : std::nullopt;
    m_timeTicker->setTickOrigin(zeroTime());
    int labelWidth = 0;
    const int axesWidth = m_plots[plots().front()].axes->width();
    const auto setDistance = [this, axesWidth](double pixels) {
        m_timeTicker->setTickCount(std::max(1, static_cast<int>(axesWidth / pixels)));
    };
    setDistance(kMinTickDistance);
    QVector<double> ticks;
    QVector<QString> labels;
    m_timeTicker->generate({time.lower, time.upper}, QLocale(), u'g', kUsualDigits, ticks, nullptr, &labels);
    for (const QString &label : labels) {
        labelWidth = std::max(labelWidth, metrics.horizontalAdvance(label));
    }
    const double minTickDistance = labelWidth + kLabelDistance;
    setDistance(axesWidth < 2.0 * kMinTickDistance ? minTickDistance : std::max(kMinTickDistance, minTickDistance));
    const QString title = isOverAngle() ? QStringLiteral("θ₂ [%1]").arg(shownUnit(Measure::Angle)) : "t [s]";
    // While no number of a value axis has more than kUsualDigits digits, the axes stay where they are.
    const int valueWidth = kUsualDigits * metrics.horizontalAdvance(u'0');
    const QMargins minMargins(valueWidth + kTickLength + kLabelGap, 0, labelWidth / 2 + kMarginBesideLabel, 0);
    for (const std::size_t index : plots()) {
        const bool hasLabels = m_plots[index].hasTimeLabels;
        QCPAxis &axis = *m_plots[index].timeAxis;
        axis.setRange(time.lower, time.upper);
        axis.setTickLabels(hasLabels);
        axis.setLabel(hasLabels ? title : QString());
        m_plots[index].axes->setMinimumMargins(minMargins);
    }
}

QString PlotFigure::errorUnit(Order order) const
{
    switch (m_style.error) {
    case ErrorMeasure::Percent: return QStringLiteral("%");
    case ErrorMeasure::Absolute:
        return QStringLiteral("%1; %2").arg(shownUnit(Channel{Theta3, order}), shownUnit(Channel{R4x, order}));
    case ErrorMeasure::OfPeak: break;
    }
    return tr("% of peak");
}

QString PlotFigure::nameOfErrors(Order order)
{
    switch (order) {
    case Order::Position: break;
    case Order::Velocity: return tr("velocity error");
    case Order::Acceleration: return tr("acceleration error");
    }
    return tr("position error");
}

/// Returns "velocity difference from b = 60 mm" and "velocity difference".
static std::pair<QString, QString> differenceTitles(Order order, const QString &comparedWith)
{
    switch (order) {
    case Order::Position: break;
    case Order::Velocity:
        return {PlotFigure::tr("velocity difference from %1").arg(comparedWith), PlotFigure::tr("velocity difference")};
    case Order::Acceleration:
        return {PlotFigure::tr("acceleration difference from %1").arg(comparedWith),
                PlotFigure::tr("acceleration difference")};
    }
    return {PlotFigure::tr("position difference from %1").arg(comparedWith), PlotFigure::tr("position difference")};
}

/// Returns the titles of errors and, after them, shorter variants, the last one with the symbols: "Δω³, Δv⁴".
QStringList PlotFigure::errorTitles(Order order) const
{
    const QString symbols =
        QStringLiteral("Δ%1, Δ%2").arg(symbolText(Channel{Theta3, order}), symbolText(Channel{R4x, order}));
    if (m_style.isOfFile) {
        return {nameOfErrors(order), symbols};
    }
    const auto [differenceFrom, difference] = differenceTitles(order, m_style.comparedWith);
    return {differenceFrom, difference, symbols};
}

/// Returns "coupler angular velocity ω³ = dθ³/dt" and shorter variants. All motions have the same number of variants,
/// because their titles are shortened alike.
QStringList PlotFigure::motionTitles(Channel channel)
{
    const QString name = quantityName(channel);
    const QString symbol = symbolText(channel);
    const QString full = name + u' ' + symbol;
    const auto titles = [&](const QString &withDerivative, const QString &shortName) {
        return QStringList{withDerivative, full, name, shortName + u' ' + symbol, symbol};
    };
    const auto derivativeOf = [&](Order order) {
        return QStringLiteral("%1 = d%2/dt").arg(full, symbolText(Channel{channel.coordinate, order}));
    };
    switch (channel.order) {
    case Order::Position: break;
    case Order::Velocity: return titles(derivativeOf(Order::Position), tr("velocity"));
    case Order::Acceleration: return titles(derivativeOf(Order::Velocity), tr("acceleration"));
    }
    return titles(full, isAngle(channel.coordinate) ? tr("angle") : tr("position"));
}

/// Returns "coupler angular velocity ω³ = dθ³/dt [°/s]" or "velocity error [% of peak]", and shorter variants.
QStringList PlotFigure::titles(std::size_t index) const
{
    const auto withUnits = [](QStringList titles, const QString &unit) {
        for (QString &title : titles) {
            title = QStringLiteral("%1 [%2]").arg(title, unit).trimmed();
        }
        return titles;
    };
    if (!isErrorPlot(index)) {
        const Channel channel = kPlottedChannels[channelIndex(index)];
        return withUnits(motionTitles(channel), shownUnit(channel));
    }
    const Order order = orderOfPlot(index);
    const QStringList names = errorTitles(order);
    QStringList titles = withUnits(names, errorUnit(order));
    if (m_style.error == ErrorMeasure::Absolute) {
        titles << QStringLiteral("[%1]").arg(errorUnit(order)); // tells which order of derivatives the plot shows
    } else {
        titles << QStringLiteral("%1 [%]").arg(names.back()); // "[% of peak]" may be too long
    }
    return titles;
}

/// Adds a curve to the drawing. Returns the pen for the legend.
QPen PlotFigure::addCurve(const Plot &plot, const PlotCurve &curve)
{
    const QColor colour = m_colours.*curve.ink;
    // A flat cap and a round join are drawn fastest.
    QPen pen(colour, curve.width * m_fonts.lineFactor, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin);
    if (!curve.dashes.empty()) {
        pen.setDashPattern(curve.dashes);
    }
    m_drawing->addCurve(plot.axes, curve.points)->setPen(pen);
    if (!curve.dots.empty()) {
        constexpr double kDotDiameter = 4.0; // px
        const double size = kDotDiameter * m_fonts.lineFactor;
        QCPGraph *dots = m_drawing->addCurve(plot.axes, curve.dots);
        dots->setLineStyle(QCPGraph::lsNone);
        dots->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, colour, size));
        if (curve.points.empty()) {
            pen.setStyle(Qt::DotLine);
        }
    }
    return pen;
}

void PlotFigure::drawInto(QPaintDevice &device)
{
    m_drawing->drawInto(device);
    QPainter painter(&device);
    drawTexts(painter);
}

void PlotFigure::paint(QPainter &painter)
{
    m_drawing->paint(painter, m_drawing->viewport().size());
    drawTexts(painter);
    if (!m_style.cursorTime) {
        return;
    }
    for (const std::size_t index : plots()) {
        const QRectF axes = m_plots[index].axes->rect();
        std::vector<PlotCursor> cursors;
        if (const std::optional<PlotCursor> cursor = cursorAt(index, *m_style.cursorTime, {})) {
            cursors.push_back(*cursor);
        }
        placeLabels(cursors, axes, m_fonts.tick, CrowdedLabelPolicy::LeaveOut);
        paintCursors(painter, cursors, axes, m_fonts.tick, m_colours);
    }
}

std::size_t PlotFigure::columnsThatFit(int width, const QFont &font)
{
    constexpr int kMinPlotWidth = 10; // in line heights, of which the numbers of the axis take half
    const int line = std::max(lineHeight(font), lineHeight(PlotFonts(font).tick));
    const auto columns = static_cast<std::size_t>(std::max(1, width / (kMinPlotWidth * line)));
    return std::min(columns, kPlotColumns);
}

int PlotFigure::heightFor(const std::vector<std::size_t> &plots, int width, const QFont &font)
{
    // Height of a row in widths of a plot, indexed by the number of plots in a row; the first entry is not used.
    constexpr std::array kRowHeight{0.0, 0.55, 0.66, 0.76};
    static_assert(kRowHeight.size() == kPlotColumns + 1);
    constexpr int kMinRowHeight = 8; // in line heights, of which the title and the numbers take half
    const std::size_t columns = columnsFor(plots, columnsThatFit(width, font));
    const std::size_t rows = (plots.size() + columns - 1) / columns;
    const double row =
        std::max<double>(kRowHeight[columns] * width / static_cast<double>(columns), kMinRowHeight * lineHeight(font));
    const int legendAndTimeLabels = 3 * lineHeight(font);
    return static_cast<int>(std::lround(static_cast<double>(rows) * row)) + legendAndTimeLabels;
}

int PlotFigure::excessOfLegend() const
{
    return m_legendSize.height() - (kAboveLegend + lineHeight(m_fonts.title) + kLabelGap);
}

/// Returns the place of a plot's note: above the curves, which leave space for it, or in the middle if there are none.
QRectF PlotFigure::notePlace(const Plot &plot) const
{
    const QRectF axes = plot.axes->rect();
    QRectF box = QFontMetricsF(m_fonts.tick).boundingRect(axes, kNoteFlags, plot.note);
    box.moveCenter(axes.center());
    if (plot.values) {
        box.moveTop(axes.top() + kAroundNote);
    }
    return box;
}

/// Returns the values with space above them for the note of the plot, unless it needs more than half of the height.
Interval PlotFigure::withSpaceForNote(const Plot &plot, const Interval &values) const
{
    constexpr double kMaxFraction = 0.5;
    const double fraction = (notePlace(plot).height() + 2.0 * kAroundNote) / std::max(plot.axes->height(), 1);
    const double space = fraction < kMaxFraction ? fraction / (1.0 - fraction) * values.length() : 0.0;
    return {values.lower, values.upper + space};
}

/// Draws the legend, the titles and the notes over the plots.
void PlotFigure::drawTexts(QPainter &painter)
{
    constexpr double kAboveAxes = 2.0; // px
    const int titleHeight = lineHeight(m_fonts.title);
    painter.setFont(m_fonts.title);
    placeLegend(&painter);
    painter.setPen(m_colours.text);
    for (const std::size_t index : plots()) {
        const Plot &plot = m_plots[index];
        const QRect axes = plot.axes->rect();
        painter.setFont(m_fonts.title);
        painter.drawStaticText(QPointF(axes.left(), axes.top() - kAboveAxes - titleHeight), plot.titles[plot.title]);
        if (!plot.note.isEmpty()) {
            painter.setFont(m_fonts.tick);
            painter.drawText(notePlace(plot), kNoteFlags, plot.note);
        }
    }
}

} // namespace slidercrank
