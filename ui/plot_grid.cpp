// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot_grid.h"

#include "ui/axis_scale.h"
#include "ui/theme.h"

#include <QApplication>
#include <QContextMenuEvent>
#include <QFontInfo>
#include <QFontMetricsF>
#include <QHelpEvent>
#include <QLabel>
#include <QMenu>
#include <QMouseEvent>
#include <QPainter>
#include <QPicture>
#include <QToolTip>
#include <QWheelEvent>
#include <qcustomplot.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <span>
#include <utility>

namespace slidercrank
{

namespace
{

constexpr std::size_t kColumns = 3;
constexpr std::size_t kErrorColumn = 2;
constexpr std::size_t kChannels = kPlottedChannels.size();
constexpr std::size_t kChannelsPerRow = 2;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

constexpr int kTickLength = 3;
constexpr int kLabelGap = 4;     // px between tick and label
constexpr int kRightMargin = 13; // room for half a label of the time axis
constexpr int kLineWidth = 2;
constexpr int kMarkSize = 7; // of the triangle where a percentage does not exist
constexpr qreal kDotSize = 3.0;

constexpr bool isError(std::size_t plot)
{
    return plot % kColumns == kErrorColumn;
}

/// The plotted channel of a model plot.
constexpr std::size_t channelOf(std::size_t plot)
{
    return plot / kColumns * kChannelsPerRow + plot % kColumns;
}

QString quantity(std::size_t channel)
{
    static const std::array<QString, kChannels> kNames{QStringLiteral("θ³"), QStringLiteral("Rₓ⁴"),
                                                       QStringLiteral("θ̇³"), QStringLiteral("Ṙₓ⁴"),
                                                       QStringLiteral("θ̈³"), QStringLiteral("R̈ₓ⁴")};
    return kNames[channel];
}

QString unitOf(std::size_t channel)
{
    const std::string_view unit = authorUnitOf(kPlottedChannels[channel]);
    return QString::fromUtf8(unit.data(), static_cast<qsizetype>(unit.size()));
}

/// "24.6°", "74.5 mm".
QString withUnit(const QString &number, const QString &unit)
{
    return unit.startsWith(u'°') ? number + unit : QStringLiteral("%1 %2").arg(number, unit);
}

Interval sampledRange(const Sampling &sampling)
{
    const double end = sampling.start + sampling.duration;
    const Interval range{std::min(sampling.start, end), std::max(sampling.start, end)};
    return range.length() > 0.0 ? range : Interval{range.lower - 0.5, range.upper + 0.5};
}

Interval united(const Interval &a, const Interval &b)
{
    return {std::min(a.lower, b.lower), std::max(a.upper, b.upper)};
}

std::optional<Interval> united(const std::optional<Interval> &a, const std::optional<Interval> &b)
{
    return a && b ? united(*a, *b) : a ? a : b;
}

/// Shrunk or widened about one of its points.
Interval scaled(const Interval &range, double about, double factor)
{
    return {about - (about - range.lower) * factor, about + (range.upper - about) * factor};
}

/// Shifted into the bounds, cut where it is longer than they are.
Interval broughtInto(const Interval &bounds, Interval range)
{
    const double length = std::min(range.length(), bounds.length());
    range.lower = std::clamp(range.lower, bounds.lower, bounds.upper - length);
    return {range.lower, range.lower + length};
}

struct ColouredText {
    QString text;
    QColor colour;
};

/// Which colour of seriesColours() a part of a picture takes: pictures know no palette.
enum class Ink { Text, Model, Reference, Error, ErrorOther };

QColor colourOf(Ink ink, const SeriesColours &colours)
{
    switch (ink) {
    case Ink::Text: return colours.text;
    case Ink::Model: return colours.model;
    case Ink::Reference: return colours.reference;
    case Ink::Error: return colours.error;
    case Ink::ErrorOther: return colours.errorOther;
    }
    return {};
}

struct InkedText {
    QString text;
    Ink ink = Ink::Text;
};

/// All that one plot shows, for one size of its axes.
struct Picture {
    QString title;
    std::vector<InkedText> remarks;      ///< right of the title
    std::vector<InkedText> shortRemarks; ///< where those do not fit
    QString note;                        ///< in the middle, where there is no curve

    struct Curve {
        std::vector<CurvePoint> points;
        std::vector<double> marks; ///< instants where the curve has no value because it is infinite
        Ink ink = Ink::Model;
        bool isDashed = false;
        bool hasDots = false; ///< few enough points to show each
    };
    std::array<Curve, 2> curves;

    Interval time;
    Interval values;
    AxisScale timeScale;
    AxisScale valueScale;
    bool hasValues = false;
    bool hasTimeLabels = true;
};

struct LegendEntry {
    enum class Sample { Solid, Dashed, Mark };
    Sample sample = Sample::Solid;
    Ink ink = Ink::Model;
    QString text;
    bool mayBeElided = false;
};

void drawMark(QPainter &painter, const QPointF &tip, const QColor &colour)
{
    const QPolygonF triangle{tip, tip + QPointF(-0.5 * kMarkSize, kMarkSize),
                             tip + QPointF(0.5 * kMarkSize, kMarkSize)};
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    painter.drawPolygon(triangle);
    painter.setBrush(Qt::NoBrush);
}

QPen penOf(Ink ink, bool isDashed, const SeriesColours &colours)
{
    if (!isDashed) {
        return QPen(colourOf(ink, colours), kLineWidth, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin);
    }
    QPen pen(colourOf(ink, colours), 1);
    pen.setDashPattern({5, 4});
    return pen;
}

} // namespace

/// Everything is sized in pixels, not points, so that it comes out right on every device.
struct PlotGrid::Typography {
    explicit Typography(const QFont &base)
        : title(base)
        , tick(base)
    {
        const int pixels = QFontInfo(base).pixelSize();
        constexpr int kSmallest = 9;
        constexpr double kTickPart = 0.87;
        title.setPixelSize(pixels);
        tick.setPixelSize(std::max(kSmallest, static_cast<int>(std::lround(kTickPart * pixels))));
        const QFontMetricsF titleMetrics(title);
        const QFontMetricsF tickMetrics(tick);
        // The dots above R and the superscripts reach beyond the font's own height.
        constexpr int kRoomForDots = 4;
        titleHeight = static_cast<int>(std::ceil(titleMetrics.height())) + kRoomForDots;
        tickHeight = static_cast<int>(std::ceil(tickMetrics.height()));
        digitWidth = tickMetrics.horizontalAdvance(u'0');
    }

    int legendHeight() const { return titleHeight + 6; }

    /// Around the axes; the same for every plot of a column, whatever the numbers are.
    QMargins margins(int labelLength, bool hasTimeLabels) const
    {
        constexpr int kUsualLength = 6; // "-0.005": nothing moves while the labels have this length
        const int left = static_cast<int>(std::ceil(digitWidth * std::max(labelLength, kUsualLength)));
        const int halfLabel = tickHeight / 2;
        return {left + kLabelGap + kTickLength + 2, titleHeight + 2, kRightMargin,
                hasTimeLabels ? tickHeight + kLabelGap + kTickLength + 1 : halfLabel};
    }

    QFont title;
    QFont tick;
    int titleHeight = 0;
    int tickHeight = 0;
    double digitWidth = 0.0;
};

/// One plot: a QCustomPlot that shows a Picture and otherwise does nothing of its own.
class PlotGrid::Plot : public QCustomPlot
{
public:
    explicit Plot(QWidget *parent);

    void setStyle(const Typography &typography, const SeriesColours &colours);
    void display(const Picture &picture, const QMargins &margins);

    const Interval &timeRange() const { return m_picture.time; }
    const Interval &valueRange() const { return m_picture.values; }

private:
    /// Title, unit of the time axis, marks and dots: what QCustomPlot has no cheap element for.
    class Lettering : public QCPLayerable
    {
    public:
        explicit Lettering(Plot *plot)
            : QCPLayerable(plot, QStringLiteral("axes"))
            , m_plot(plot)
        {
        }

    protected:
        void applyDefaultAntialiasingHint(QCPPainter *painter) const override { painter->setAntialiasing(true); }
        void draw(QCPPainter *painter) override;

    private:
        void drawTitle(QCPPainter &painter, const QRect &axes) const;
        Plot *m_plot;
    };

    class Ticker : public QCPAxisTicker
    {
    public:
        AxisScale scale;

    protected:
        double getTickStep(const QCPRange &) override { return scale.step; }
        int getSubTickCount(double) override { return 0; }
        QString getTickLabel(double tick, const QLocale &locale, QChar, int) override
        {
            return scale.label(tick, locale);
        }
    };

    Picture m_picture;
    QFont m_titleFont;
    QFont m_tickFont;
    SeriesColours m_colours;
    QSharedPointer<Ticker> m_timeTicker;
    QSharedPointer<Ticker> m_valueTicker;
};

PlotGrid::Plot::Plot(QWidget *parent)
    : QCustomPlot(parent)
    , m_timeTicker(new Ticker)
    , m_valueTicker(new Ticker)
{
    setInteractions(QCP::Interactions());
    setAutoAddPlottableToLegend(false);
    setPlottingHint(QCP::phFastPolylines, true); // a line of width 2 costs four times as much without
    layer(QStringLiteral("overlay"))->setMode(QCPLayer::lmLogical); // no second pixmap: nothing is drawn there
    axisRect()->setAutoMargins(QCP::msNone);
    xAxis->setTicker(m_timeTicker);
    yAxis->setTicker(m_valueTicker);
    for (QCPAxis *axis : {xAxis, yAxis}) {
        axis->setSubTicks(false);
        axis->setTickLength(0, kTickLength);
        axis->setTickLabelPadding(kLabelGap);
    }
    for (std::size_t curve = 0; curve < m_picture.curves.size(); ++curve) {
        QCPGraph *graph = addGraph();
        graph->setAdaptiveSampling(false);
        graph->setSelectable(QCP::stNone);
    }
    new Lettering(this);
}

void PlotGrid::Plot::setStyle(const Typography &typography, const SeriesColours &colours)
{
    m_titleFont = typography.title;
    m_tickFont = typography.tick;
    m_colours = colours;
    setBackground(QBrush(colours.background));
    QColor frame = colours.text;
    constexpr double kFrameStrength = 0.55;
    const auto mix = [&](int text, int background) {
        return static_cast<int>(std::lround(kFrameStrength * text + (1.0 - kFrameStrength) * background));
    };
    frame =
        QColor(mix(colours.text.red(), colours.background.red()), mix(colours.text.green(), colours.background.green()),
               mix(colours.text.blue(), colours.background.blue()));
    for (QCPAxis *axis : {xAxis, yAxis}) {
        axis->setBasePen(QPen(frame, 1));
        axis->setTickPen(QPen(frame, 1));
        axis->setTickLabelColor(colours.text);
        axis->setTickLabelFont(typography.tick);
        axis->grid()->setPen(QPen(colours.grid, 1));
        axis->grid()->setZeroLinePen(QPen(frame, 1));
    }
    xAxis->grid()->setZeroLinePen(Qt::NoPen); // t = 0 is the axis itself
}

void PlotGrid::Plot::display(const Picture &picture, const QMargins &margins)
{
    m_picture = picture;
    axisRect()->setMargins(margins);
    m_timeTicker->scale = picture.timeScale;
    m_valueTicker->scale = picture.valueScale;
    xAxis->setRange(picture.time.lower, picture.time.upper);
    yAxis->setRange(picture.values.lower, picture.values.upper);
    xAxis->setTickLabels(picture.hasTimeLabels);
    yAxis->setTickLabels(picture.hasValues);
    for (std::size_t i = 0; i < picture.curves.size(); ++i) {
        const Picture::Curve &curve = picture.curves[i];
        QVector<QCPGraphData> points;
        points.reserve(static_cast<qsizetype>(curve.points.size()));
        for (const CurvePoint &point : curve.points) {
            points.append(QCPGraphData(point.t, point.value));
        }
        QCPGraph *line = graph(static_cast<int>(i));
        line->data()->set(points, true);
        line->setPen(penOf(curve.ink, curve.isDashed, m_colours));
        line->setScatterStyle(curve.hasDots ? QCPScatterStyle(QCPScatterStyle::ssDisc, kDotSize)
                                            : QCPScatterStyle(QCPScatterStyle::ssNone));
    }
}

void PlotGrid::Plot::Lettering::draw(QCPPainter *painter)
{
    const Picture &picture = m_plot->m_picture;
    const SeriesColours &colours = m_plot->m_colours;
    const QRect axes = m_plot->axisRect()->rect();
    drawTitle(*painter, axes);

    painter->setFont(m_plot->m_tickFont);
    painter->setPen(QPen(colours.text));
    if (picture.hasTimeLabels) {
        // In the corner that both axes leave free.
        const QRect corner(0, axes.bottom() + 1 + kTickLength, axes.left() - 2 * kLabelGap, m_plot->height());
        painter->drawText(corner, Qt::AlignRight | Qt::AlignTop | Qt::TextDontClip,
                          QStringLiteral("t [%1]").arg(picture.timeScale.unit(QStringLiteral("s"))));
    }
    if (!picture.note.isEmpty()) {
        painter->drawText(axes.adjusted(kLabelGap, 0, -kLabelGap, 0), Qt::AlignCenter | Qt::TextWordWrap, picture.note);
    }
    for (const Picture::Curve &curve : picture.curves) {
        const QColor colour = colourOf(curve.ink, colours);
        int lastPixel = std::numeric_limits<int>::min();
        for (const double t : curve.marks) {
            const double x = m_plot->xAxis->coordToPixel(t);
            if (picture.time.contains(t) && static_cast<int>(x) != lastPixel) {
                drawMark(*painter, QPointF(x, axes.top()), colour);
                lastPixel = static_cast<int>(x);
            }
        }
        painter->setPen(Qt::NoPen);
        painter->setBrush(colour);
        for (const CurvePoint &point : isolatedPoints(curve.points)) {
            const QPointF centre(m_plot->xAxis->coordToPixel(point.t), m_plot->yAxis->coordToPixel(point.value));
            painter->drawEllipse(centre, 0.5 * kDotSize, 0.5 * kDotSize);
        }
        painter->setBrush(Qt::NoBrush);
    }
}

void PlotGrid::Plot::Lettering::drawTitle(QCPPainter &painter, const QRect &axes) const
{
    const Picture &picture = m_plot->m_picture;
    const QFontMetricsF titleMetrics(m_plot->m_titleFont);
    const QFontMetricsF tickMetrics(m_plot->m_tickFont);
    const double baseline = axes.top() - 2.0 - titleMetrics.descent();
    painter.setFont(m_plot->m_titleFont);
    painter.setPen(QPen(m_plot->m_colours.text));
    painter.drawText(QPointF(axes.left(), baseline), picture.title);
    if (picture.remarks.empty()) {
        return;
    }
    const auto widthOf = [&tickMetrics](const std::vector<InkedText> &texts) {
        double width = 0.0;
        for (const InkedText &part : texts) {
            width += tickMetrics.horizontalAdvance(part.text);
        }
        return width;
    };
    const double right = axes.right();
    const double room = right - axes.left() - titleMetrics.horizontalAdvance(picture.title) - 2.0 * kLabelGap;
    const std::vector<InkedText> &texts = widthOf(picture.remarks) <= room ? picture.remarks : picture.shortRemarks;
    const double width = widthOf(texts);
    if (width > room) {
        return;
    }
    double x = right - width;
    painter.setFont(m_plot->m_tickFont);
    for (const InkedText &part : texts) {
        painter.setPen(QPen(colourOf(part.ink, m_plot->m_colours)));
        painter.drawText(QPointF(x, baseline), part.text);
        x += tickMetrics.horizontalAdvance(part.text);
    }
}

/// What a Result looks like, and what of it is to be seen. Converted once a Result, and only when somebody looks.
struct PlotGrid::Figure {
    std::shared_ptr<const Result> result; ///< may be null
    std::optional<Interval> timeZoom;
    std::array<std::optional<Interval>, kPlotCount> valueZoom;

    void setResult(const std::shared_ptr<const Result> &newResult);
    void convert();

    /// precondition: convert() was called.
    Picture picture(std::size_t plot, const QSize &axes) const;
    std::vector<LegendEntry> legend(bool hasModel, bool hasErrors) const;
    QString readout(std::size_t plot, double t) const;

    Interval wholeRange() const { return result ? sampledRange(result->sampling) : Interval{}; }
    Interval timeRange() const { return timeZoom.value_or(wholeRange()); }
    Interval outerRange() const; ///< with the reference's instants: as far as one can zoom out

private:
    struct Channel {
        std::span<const double> model;
        std::span<const double> reference; ///< empty where the file has no such column
        std::span<const double> modelAtReference;
        std::vector<double> percent;       ///< at the file's instants; NaN where it does not exist
        std::vector<double> zeroReference; ///< instants where the reference is zero
        std::optional<double> largestPercent;
    };

    void fillModelPicture(Picture &picture, std::size_t channel, std::size_t columns) const;
    void fillErrorPicture(Picture &picture, std::size_t row, std::size_t columns) const;
    std::optional<Interval> extremesWithin(const Interval &range, std::span<const double> instants,
                                           std::span<const double> values) const;

    bool m_isConverted = false;
    std::span<const double> m_time;
    std::span<const double> m_referenceTime;
    std::array<Channel, kChannels> m_channels;
    std::vector<double> m_reversed; ///< time and channels in ascending order, where the run goes backwards in time
};

void PlotGrid::Figure::setResult(const std::shared_ptr<const Result> &newResult)
{
    if (!newResult || !result || sampledRange(newResult->sampling) != sampledRange(result->sampling)) {
        timeZoom.reset();
    }
    result = newResult;
    m_isConverted = false;
}

void PlotGrid::Figure::convert()
{
    if (m_isConverted) {
        return;
    }
    m_isConverted = true;
    m_time = {};
    m_referenceTime = {};
    m_channels = {};
    if (!result) {
        return;
    }
    const Trajectory &trajectory = result->trajectory;
    m_time = trajectory.time;
    for (std::size_t i = 0; i < kChannels; ++i) {
        m_channels[i].model = trajectory[kPlottedChannels[i]];
    }
    if (m_time.size() > 1 && m_time.back() < m_time.front()) {
        m_reversed.clear();
        m_reversed.reserve((1 + kChannels) * m_time.size()); // spans into it must stay valid
        const auto reversed = [this](std::span<const double> values) {
            const auto begin = m_reversed.insert(m_reversed.end(), values.rbegin(), values.rend());
            return std::span<const double>(begin, m_reversed.end());
        };
        m_time = reversed(m_time);
        for (Channel &channel : m_channels) {
            channel.model = reversed(channel.model);
        }
    }
    if (!result->reference) {
        return;
    }
    const ReferenceData &data = result->reference->data;
    m_referenceTime = data.time;
    for (std::size_t i = 0; i < kChannels; ++i) {
        Channel &channel = m_channels[i];
        const ReferenceSeries *series = data.find(kPlottedChannels[i]);
        if (!series) {
            continue;
        }
        channel.reference = series->values;
        channel.modelAtReference = result->atReference[kPlottedChannels[i]];
        channel.percent.reserve(data.time.size());
        for (std::size_t k = 0; k < data.time.size(); ++k) {
            const double reference = channel.reference[k];
            if (reference == 0.0) {
                channel.zeroReference.push_back(data.time[k]);
            }
            constexpr double kPercent = 100.0;
            channel.percent.push_back(
                reference == 0.0 ? kNaN : std::abs((channel.modelAtReference[k] - reference) / reference) * kPercent);
        }
        for (const ChannelComparison &comparison : result->comparison) {
            if (comparison.channel == kPlottedChannels[i]) {
                channel.largestPercent = comparison.maxPercent;
            }
        }
    }
}

Interval PlotGrid::Figure::outerRange() const
{
    const Interval whole = wholeRange();
    if (!result || !result->reference || result->reference->data.time.empty()) {
        return whole;
    }
    const std::vector<double> &instants = result->reference->data.time;
    return united(whole, Interval{instants.front(), instants.back()});
}

std::optional<Interval> PlotGrid::Figure::extremesWithin(const Interval &range, std::span<const double> instants,
                                                         std::span<const double> values) const
{
    const auto begin = std::lower_bound(instants.begin(), instants.end(), range.lower);
    const auto end = std::upper_bound(begin, instants.end(), range.upper);
    return extremes(
        values.subspan(static_cast<std::size_t>(begin - instants.begin()), static_cast<std::size_t>(end - begin)));
}

Picture PlotGrid::Figure::picture(std::size_t plot, const QSize &axes) const
{
    constexpr double kPixelsPerTimeTick = 62.0;
    constexpr double kPixelsPerValueTick = 34.0;
    Picture picture;
    picture.time = timeRange();
    picture.timeScale = axisScale(picture.time, axes.width() / kPixelsPerTimeTick);
    const std::size_t columns = static_cast<std::size_t>(std::max(axes.width(), 1));
    if (isError(plot)) {
        fillErrorPicture(picture, plot / kColumns, columns);
    } else {
        fillModelPicture(picture, channelOf(plot), columns);
    }
    if (valueZoom[plot] && picture.hasValues) {
        picture.values = *valueZoom[plot];
    }
    picture.valueScale = axisScale(picture.values, axes.height() / kPixelsPerValueTick);
    const QString unit = isError(plot) ? QStringLiteral("%") : unitOf(channelOf(plot));
    picture.title =
        QStringLiteral("%1 [%2]").arg(picture.title, picture.hasValues ? picture.valueScale.unit(unit) : unit);
    constexpr double kPixelsPerDot = 12.0;
    for (Picture::Curve &curve : picture.curves) {
        curve.points = clip(curve.points, picture.time, picture.values);
        curve.hasDots = curve.isDashed && static_cast<double>(curve.points.size()) * kPixelsPerDot < axes.width();
    }
    return picture;
}

void PlotGrid::Figure::fillModelPicture(Picture &picture, std::size_t index, std::size_t columns) const
{
    const Channel &channel = m_channels[index];
    picture.title = quantity(index);
    picture.curves[0].ink = Ink::Model;
    picture.curves[1].ink = Ink::Reference;
    picture.curves[1].isDashed = true;
    if (!result) {
        return;
    }
    picture.curves[0].points = decimate(m_time, channel.model, pixelColumns(m_time, picture.time, columns));
    if (!channel.reference.empty()) {
        picture.curves[1].points =
            decimate(m_referenceTime, channel.reference, pixelColumns(m_referenceTime, picture.time, columns));
    } else if (result->reference) {
        picture.remarks = picture.shortRemarks = {{tr("not in the file"), Ink::Reference}};
    }
    // The axis of values stays that of the whole run while one looks at a part of it.
    const bool isWhole = picture.time == wholeRange();
    const std::optional<Interval> values =
        isWhole ? united(extremes(picture.curves[0].points),
                         extremesWithin(wholeRange(), m_referenceTime, channel.reference))
                : united(extremes(channel.model), extremesWithin(wholeRange(), m_referenceTime, channel.reference));
    picture.hasValues = values.has_value();
    if (values) {
        picture.values = roundedOutwards(*values);
    } else {
        picture.note = tr("does not exist");
    }
}

void PlotGrid::Figure::fillErrorPicture(Picture &picture, std::size_t row, std::size_t columns) const
{
    picture.title = tr("error");
    picture.curves[0].ink = Ink::Error;
    picture.curves[1].ink = Ink::ErrorOther;
    if (!result || !result->reference) {
        constexpr std::size_t kMiddleRow = 1;
        if (row == kMiddleRow) {
            picture.note = tr("no reference data");
        }
        return;
    }
    const PixelColumns pixels = pixelColumns(m_referenceTime, picture.time, columns);
    std::optional<Interval> values;
    bool isCompared = false;
    for (std::size_t i = 0; i < kChannelsPerRow; ++i) {
        const Channel &channel = m_channels[row * kChannelsPerRow + i];
        if (channel.reference.empty()) {
            continue;
        }
        isCompared = true;
        Picture::Curve &curve = picture.curves[i];
        curve.points = decimate(m_referenceTime, channel.percent, pixels);
        curve.marks = channel.zeroReference;
        values = united(values, extremesWithin(wholeRange(), m_referenceTime, channel.percent));
        if (channel.largestPercent) {
            constexpr int kDigits = 3;
            const QString number = shortNumber(*channel.largestPercent, kDigits, QLocale());
            if (!picture.remarks.empty()) {
                picture.remarks.push_back({QStringLiteral(" · ")});
                picture.shortRemarks.push_back({QStringLiteral(" · ")});
            }
            picture.remarks.push_back(
                {tr("%1 % %2", "largest error: number, quantity").arg(number, quantity(row * kChannelsPerRow + i)),
                 curve.ink});
            picture.shortRemarks.push_back({number, curve.ink});
        }
    }
    if (!picture.remarks.empty()) {
        const InkedText largest{tr("max ", "largest error, before the numbers")};
        picture.remarks.insert(picture.remarks.begin(), largest);
        picture.shortRemarks.insert(picture.shortRemarks.begin(), largest);
    }
    picture.hasValues = values.has_value();
    if (values) {
        picture.values = roundedOutwards(united(*values, Interval{0.0, 0.0}));
    } else {
        picture.note = isCompared ? tr("nothing to compare") : tr("not in the file");
    }
}

std::vector<LegendEntry> PlotGrid::Figure::legend(bool hasModel, bool hasErrors) const
{
    using Sample = LegendEntry::Sample;
    std::vector<LegendEntry> entries;
    if (hasModel) {
        entries.push_back({Sample::Solid, Ink::Model, tr("model")});
    }
    if (!result || !result->reference) {
        return entries;
    }
    if (hasModel) {
        entries.push_back({Sample::Dashed, Ink::Reference, result->reference->name, true});
    }
    if (hasErrors) {
        entries.push_back({Sample::Solid, Ink::Error, tr("error of %1").arg(quantity(0))});
        entries.push_back({Sample::Solid, Ink::ErrorOther, tr("error of %1").arg(quantity(1))});
        entries.push_back({Sample::Mark, Ink::Text, tr("reference is 0")});
    }
    return entries;
}

QString PlotGrid::Figure::readout(std::size_t plot, double t) const
{
    if (!result || m_time.empty()) {
        return {};
    }
    const QLocale locale;
    constexpr int kDigits = 6;
    const auto nearest = [t](std::span<const double> instants) {
        const auto after = std::lower_bound(instants.begin(), instants.end(), t);
        const auto index = static_cast<std::size_t>(after - instants.begin());
        if (index == instants.size() || (index > 0 && t - instants[index - 1] < instants[index] - t)) {
            return index - 1;
        }
        return index;
    };
    const auto number = [&](double value, const QString &unit) {
        return std::isfinite(value) ? withUnit(shortNumber(value, kDigits, locale), unit) : tr("does not exist");
    };
    const auto instant = [&](double seconds) {
        return QStringLiteral("t = %1").arg(number(seconds, QStringLiteral("s")));
    };
    QStringList lines;
    if (isError(plot)) {
        if (m_referenceTime.empty()) {
            return {};
        }
        const std::size_t k = nearest(m_referenceTime);
        lines << instant(m_referenceTime[k]);
        for (std::size_t i = 0; i < kChannelsPerRow; ++i) {
            const std::size_t index = plot / kColumns * kChannelsPerRow + i;
            const Channel &channel = m_channels[index];
            if (channel.reference.empty()) {
                continue;
            }
            lines << tr("error of %1: %2")
                         .arg(quantity(index), channel.reference[k] == 0.0
                                                   ? tr("no percentage, the reference is 0")
                                                   : number(channel.percent[k], QStringLiteral("%")));
        }
        return lines.join(u'\n');
    }
    const std::size_t index = channelOf(plot);
    const Channel &channel = m_channels[index];
    const QString unit = unitOf(index);
    const std::size_t k = nearest(m_time);
    lines << instant(m_time[k]);
    lines << tr("%1 = %2").arg(quantity(index), number(channel.model[k], unit));
    if (kPlottedChannels[index] == slidercrank::Channel{Theta3, Order::Position} && std::isfinite(channel.model[k])) {
        constexpr double kHalfTurn = 180.0;
        lines << tr("textbook's θ₃ = θ³ + 180° = %1").arg(number(channel.model[k] + kHalfTurn, unit));
    }
    if (!channel.reference.empty()) {
        const std::size_t r = nearest(m_referenceTime);
        const QString value = number(channel.reference[r], unit);
        lines << (m_referenceTime[r] == m_time[k] ? tr("reference: %1").arg(value)
                                                  : tr("reference: %1 at %2").arg(value, instant(m_referenceTime[r])));
    }
    return lines.join(u'\n');
}

namespace
{

/// Where legend and plots are in a figure of that size.
struct Arrangement {
    QRect legend;
    std::array<QRect, kColumns * kColumns> cells;
    bool hasTimeLabelsEverywhere = true; ///< else in the bottom row only
};

Arrangement arrange(const QSize &size, int legendHeight, int timeLabelHeight)
{
    constexpr int kRows = 3;
    constexpr int kSmallestLabelledCell = 165; // px: below this the labels of the upper rows take too much
    Arrangement arrangement;
    arrangement.legend = QRect(0, 0, size.width(), legendHeight);
    const int height = std::max(0, size.height() - legendHeight);
    const int cellWidth = size.width() / static_cast<int>(kColumns);
    arrangement.hasTimeLabelsEverywhere = height / kRows >= kSmallestLabelledCell;
    const int extra = arrangement.hasTimeLabelsEverywhere ? 0 : timeLabelHeight;
    const int cellHeight = std::max(0, height - extra) / kRows;
    for (std::size_t i = 0; i < arrangement.cells.size(); ++i) {
        const int row = static_cast<int>(i / kColumns);
        const int column = static_cast<int>(i % kColumns);
        const bool isBottom = row == kRows - 1;
        arrangement.cells[i] =
            QRect(column * cellWidth, legendHeight + row * cellHeight, cellWidth, cellHeight + (isBottom ? extra : 0));
    }
    return arrangement;
}

/// The samples are as long as the dashes need.
void drawLegend(QPainter &painter, const QRect &rect, std::vector<LegendEntry> entries, const QFont &font,
                const SeriesColours &colours)
{
    constexpr int kSample = 28;
    constexpr int kMark = 10;
    constexpr int kGap = 5;
    constexpr int kBetween = 16;
    const QFontMetricsF metrics(font);
    const auto sampleWidth = [](const LegendEntry &entry) {
        return entry.sample == LegendEntry::Sample::Mark ? kMark : kSample;
    };
    double width = 0.0;
    for (const LegendEntry &entry : entries) {
        width += sampleWidth(entry) + kGap + metrics.horizontalAdvance(entry.text) + kBetween;
    }
    constexpr double kShortestName = 60.0;
    const double excess = width - rect.width();
    for (LegendEntry &entry : entries) {
        if (excess > 0.0 && entry.mayBeElided) {
            const double room = std::max(kShortestName, metrics.horizontalAdvance(entry.text) - excess);
            entry.text = metrics.elidedText(entry.text, Qt::ElideMiddle, room);
        }
    }
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(font);
    double x = rect.left() + kBetween;
    const double middle = rect.center().y() + 0.5;
    const double baseline = middle + 0.5 * (metrics.ascent() - metrics.descent());
    for (const LegendEntry &entry : entries) {
        if (entry.sample == LegendEntry::Sample::Mark) {
            drawMark(painter, QPointF(x + 0.5 * kMark, middle - 0.5 * kMarkSize), colourOf(entry.ink, colours));
        } else {
            painter.setPen(penOf(entry.ink, entry.sample == LegendEntry::Sample::Dashed, colours));
            painter.drawLine(QPointF(x, middle), QPointF(x + kSample, middle));
        }
        x += sampleWidth(entry) + kGap;
        painter.setPen(colours.text);
        painter.drawText(QPointF(x, baseline), entry.text);
        x += metrics.horizontalAdvance(entry.text) + kBetween;
    }
    painter.restore();
}

QString plotName(std::size_t plot)
{
    static const std::array<QString, 3> kErrors{QStringLiteral("plot_error_position"),
                                                QStringLiteral("plot_error_velocity"),
                                                QStringLiteral("plot_error_acceleration")};
    if (isError(plot)) {
        return kErrors[plot / kColumns];
    }
    const std::string_view name = nameOf(kPlottedChannels[channelOf(plot)]);
    return QStringLiteral("plot_") + QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size()));
}

} // namespace

PlotGrid::PlotGrid(QWidget *parent)
    : QWidget(parent)
    , m_figure(std::make_unique<Figure>())
    , m_typography(std::make_unique<Typography>(font()))
{
    setAttribute(Qt::WA_OpaquePaintEvent);
    setAccessibleName(tr("Plots of the motion"));
    const std::array<QString, kPlotCount> accessibleNames{tr("Coupler angle θ³ over time"),
                                                          tr("Slider position R_x⁴ over time"),
                                                          tr("Error of the positions over time"),
                                                          tr("Coupler angular velocity dθ³/dt over time"),
                                                          tr("Slider velocity dR_x⁴/dt over time"),
                                                          tr("Error of the velocities over time"),
                                                          tr("Coupler angular acceleration d²θ³/dt² over time"),
                                                          tr("Slider acceleration d²R_x⁴/dt² over time"),
                                                          tr("Error of the accelerations over time")};
    for (std::size_t i = 0; i < kPlotCount; ++i) {
        m_plots[i] = new Plot(this);
        m_plots[i]->setObjectName(plotName(i));
        m_plots[i]->setAccessibleName(accessibleNames[i]);
        m_plots[i]->installEventFilter(this);
        m_cursors[i] = new QWidget(m_plots[i]);
        m_cursors[i]->setAttribute(Qt::WA_TransparentForMouseEvents);
        m_cursors[i]->setAutoFillBackground(true);
        m_cursors[i]->hide();
    }
    m_hint = new QLabel(this);
    m_hint->setObjectName(QStringLiteral("no_reference_hint"));
    m_hint->setTextFormat(Qt::RichText);
    m_hint->setText(tr("No reference data.<br><a href=\"open\">Open a reference…</a><br>or drop a CSV file here."));
    m_hint->setTextInteractionFlags(Qt::LinksAccessibleByMouse | Qt::LinksAccessibleByKeyboard);
    m_hint->setAlignment(Qt::AlignCenter);
    m_hint->setWordWrap(true);
    m_hint->setBackgroundRole(QPalette::Base);
    m_hint->setAutoFillBackground(true);
    connect(m_hint, &QLabel::linkActivated, this, [this] { emit openReferenceRequested(); });
    QEvent paletteChange(QEvent::PaletteChange);
    changeEvent(&paletteChange);
}

PlotGrid::~PlotGrid() = default;

QStringList PlotGrid::plotNames()
{
    QStringList names;
    for (std::size_t i = 0; i < kPlotCount; ++i) {
        names << plotName(i);
    }
    return names;
}

QSize PlotGrid::sizeHint() const
{
    return {900, 600};
}

QSize PlotGrid::minimumSizeHint() const
{
    return {480, 330};
}

void PlotGrid::setResult(const std::shared_ptr<const Result> &result)
{
    m_figure->setResult(result);
    updateHint();
    requestRefresh();
}

void PlotGrid::setPose(const Pose &pose)
{
    m_cursorTime = pose.time;
    moveCursors();
}

void PlotGrid::showAll()
{
    m_figure->timeZoom.reset();
    m_figure->valueZoom = {};
    requestRefresh();
}

/// Any number of requests in one pass of the event loop make one refresh; a hidden widget waits until it is shown.
void PlotGrid::requestRefresh()
{
    m_isStale = true;
    if (!isVisible() || m_isRefreshQueued) {
        return;
    }
    m_isRefreshQueued = true;
    QMetaObject::invokeMethod(
        this,
        [this] {
            m_isRefreshQueued = false;
            if (m_isStale && isVisible()) {
                refresh();
            }
        },
        Qt::QueuedConnection);
}

void PlotGrid::refresh()
{
    m_isStale = false;
    m_figure->convert();
    const Arrangement arrangement = arrange(size(), m_typography->legendHeight(), m_typography->tickHeight);
    std::array<Picture, kPlotCount> pictures;
    std::array<int, kColumns> labelLengths{};
    for (std::size_t i = 0; i < kPlotCount; ++i) {
        const bool hasTimeLabels = arrangement.hasTimeLabelsEverywhere || i / kColumns == kColumns - 1;
        const QSize axes = m_plots[i]->size().shrunkBy(m_typography->margins(0, hasTimeLabels));
        pictures[i] = m_figure->picture(i, axes);
        pictures[i].hasTimeLabels = hasTimeLabels;
        int &length = labelLengths[i % kColumns];
        length = std::max(length, pictures[i].valueScale.labelLength(pictures[i].values));
    }
    for (std::size_t i = 0; i < kPlotCount; ++i) {
        m_plots[i]->display(pictures[i], m_typography->margins(labelLengths[i % kColumns], pictures[i].hasTimeLabels));
        m_plots[i]->replot(QCustomPlot::rpQueuedRefresh);
    }
    moveCursors();
    update(QRect(0, 0, width(), m_typography->legendHeight()));
}

void PlotGrid::placePlots()
{
    const Arrangement arrangement = arrange(size(), m_typography->legendHeight(), m_typography->tickHeight);
    for (std::size_t i = 0; i < kPlotCount; ++i) {
        m_plots[i]->setGeometry(arrangement.cells[i]);
    }
    updateHint();
}

void PlotGrid::moveCursors()
{
    for (std::size_t i = 0; i < kPlotCount; ++i) {
        const QRect axes = m_plots[i]->axisRect()->rect();
        const bool isInRange = m_cursorTime && m_plots[i]->timeRange().contains(*m_cursorTime) && axes.width() > 1;
        if (isInRange) {
            const int x = static_cast<int>(std::lround(m_plots[i]->xAxis->coordToPixel(*m_cursorTime)));
            m_cursors[i]->setGeometry(x, axes.top(), 1, axes.height());
        }
        m_cursors[i]->setVisible(isInRange);
    }
}

void PlotGrid::updateHint()
{
    m_hint->setVisible(!m_figure->result || !m_figure->result->reference);
    if (m_hint->isHidden()) {
        return;
    }
    const QRect first = m_plots[kErrorColumn]->geometry();
    const QRect last = m_plots[kPlotCount - 1]->geometry();
    const QMargins margins = m_typography->margins(0, true);
    constexpr int kInset = 6;
    const int width = std::max(0, first.width() - margins.left() - margins.right() - 2 * kInset);
    const int height = m_hint->heightForWidth(width);
    m_hint->setGeometry(first.left() + margins.left() + kInset, (first.top() + last.bottom() - height) / 2, width,
                        height);
    m_hint->raise();
}

void PlotGrid::zoomTime(double about, double factor)
{
    const Interval outer = m_figure->outerRange();
    Interval range = broughtInto(outer, scaled(m_figure->timeRange(), about, factor));
    // Closer, neighbouring instants could not be told apart on the axis any more.
    constexpr double kSmallestPart = 1e-10;
    const double largest = std::max({std::abs(outer.lower), std::abs(outer.upper), outer.length()});
    if (factor < 1.0 && range.length() < kSmallestPart * largest) {
        return;
    }
    m_figure->timeZoom = range;
    requestRefresh();
}

void PlotGrid::zoomValues(std::size_t plot, double about, double factor)
{
    const Interval range = scaled(m_plots[plot]->valueRange(), about, factor);
    const double largest = std::max(std::abs(range.lower), std::abs(range.upper));
    constexpr double kSmallestPart = 1e-10;
    constexpr double kLargestValue = 1e60;
    if (range.length() < kSmallestPart * largest || largest > kLargestValue) {
        return;
    }
    m_figure->valueZoom[plot] = range;
    requestRefresh();
}

void PlotGrid::pan(std::size_t plot, const QPoint &to)
{
    const Plot &shown = *m_plots[plot];
    const double dt = shown.xAxis->pixelToCoord(m_drag->last.x()) - shown.xAxis->pixelToCoord(to.x());
    const double dv = shown.yAxis->pixelToCoord(m_drag->last.y()) - shown.yAxis->pixelToCoord(to.y());
    const Interval time = m_figure->timeRange();
    m_figure->timeZoom = broughtInto(m_figure->outerRange(), {time.lower + dt, time.upper + dt});
    if (std::optional<Interval> &values = m_figure->valueZoom[plot]) {
        values = Interval{values->lower + dv, values->upper + dv};
    }
    requestRefresh();
}

void PlotGrid::showMenu(std::size_t plot, const QPoint &globalPosition)
{
    auto *menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    connect(menu->addAction(tr("&Export this plot…")), &QAction::triggered, this,
            [this, plot] { emit exportPlotRequested(plotName(plot)); });
    connect(menu->addAction(tr("Show &all")), &QAction::triggered, this, &PlotGrid::showAll);
    menu->popup(globalPosition);
}

bool PlotGrid::eventFilter(QObject *watched, QEvent *event)
{
    const auto found = std::find(m_plots.begin(), m_plots.end(), watched);
    if (found == m_plots.end()) {
        return QWidget::eventFilter(watched, event);
    }
    const auto index = static_cast<std::size_t>(found - m_plots.begin());
    Plot &plot = **found;
    switch (event->type()) {
    case QEvent::Resize: // QCustomPlot would replot at once, with curves decimated for the old size
        plot.setViewport(plot.rect());
        requestRefresh();
        return true;
    case QEvent::Wheel: {
        const auto *wheel = static_cast<QWheelEvent *>(event);
        constexpr double kNotch = 120.0;
        constexpr double kFactor = 0.85;
        const double factor = std::pow(kFactor, wheel->angleDelta().y() / kNotch);
        const QRect axes = plot.axisRect()->rect();
        if (wheel->position().x() < axes.left()) {
            zoomValues(index, plot.yAxis->pixelToCoord(wheel->position().y()), factor);
        } else {
            zoomTime(plot.xAxis->pixelToCoord(wheel->position().x()), factor);
        }
        event->accept();
        return true;
    }
    case QEvent::MouseButtonPress: {
        const auto *mouse = static_cast<QMouseEvent *>(event);
        if (mouse->button() == Qt::LeftButton) {
            m_drag = Drag{index, mouse->pos(), mouse->pos()};
        }
        return true;
    }
    case QEvent::MouseMove: {
        const auto *mouse = static_cast<QMouseEvent *>(event);
        if (m_drag) {
            const QPoint to = mouse->pos();
            m_drag->hasMoved =
                m_drag->hasMoved || (to - m_drag->start).manhattanLength() >= QApplication::startDragDistance();
            if (m_drag->hasMoved) {
                pan(m_drag->plot, to);
                m_drag->last = to;
            }
        } else if (plot.axisRect()->rect().contains(mouse->pos())) {
            QToolTip::showText(mouse->globalPosition().toPoint(),
                               m_figure->readout(index, plot.xAxis->pixelToCoord(mouse->pos().x())), &plot);
        } else {
            QToolTip::hideText();
        }
        return true;
    }
    case QEvent::MouseButtonRelease: {
        const auto *mouse = static_cast<QMouseEvent *>(event);
        if (mouse->button() == Qt::LeftButton && m_drag) {
            const bool isClick = !m_drag->hasMoved && plot.axisRect()->rect().contains(mouse->pos());
            m_drag.reset();
            if (isClick) {
                emit timeRequested(plot.xAxis->pixelToCoord(mouse->pos().x()));
            }
        }
        return true;
    }
    case QEvent::MouseButtonDblClick: showAll(); return true;
    case QEvent::ContextMenu: showMenu(index, static_cast<QContextMenuEvent *>(event)->globalPos()); return true;
    default: return QWidget::eventFilter(watched, event);
    }
}

bool PlotGrid::event(QEvent *event)
{
    if (event->type() == QEvent::ToolTip && m_figure->result && m_figure->result->reference) {
        const auto *help = static_cast<QHelpEvent *>(event);
        if (help->pos().y() < m_typography->legendHeight()) { // the name may be elided there
            QToolTip::showText(help->globalPos(), m_figure->result->reference->path, this);
            return true;
        }
    }
    return QWidget::event(event);
}

void PlotGrid::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    const bool isFont = event->type() == QEvent::FontChange;
    if (!isFont && event->type() != QEvent::PaletteChange) {
        return;
    }
    if (isFont) {
        *m_typography = Typography(font());
        placePlots();
    }
    const SeriesColours colours = seriesColours(palette());
    for (std::size_t i = 0; i < kPlotCount; ++i) {
        m_plots[i]->setStyle(*m_typography, colours);
        QPalette cursor;
        cursor.setColor(QPalette::Window, colours.cursor);
        m_cursors[i]->setPalette(cursor);
    }
    requestRefresh();
}

void PlotGrid::paintEvent(QPaintEvent *)
{
    if (m_isStale) { // drawn without being visible, as grab() does
        refresh();
    }
    QPainter painter(this);
    painter.fillRect(rect(), palette().color(QPalette::Base));
    drawLegend(painter, QRect(0, 0, width(), m_typography->legendHeight()), m_figure->legend(true, true),
               m_typography->title, seriesColours(palette()));
}

void PlotGrid::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    placePlots();
}

void PlotGrid::showEvent(QShowEvent *event)
{
    QWidget::showEvent(event);
    if (m_isStale) {
        requestRefresh();
    }
}

namespace
{

/// QCustomPlot draws with a painter of its own class only: recorded, it can be played to any painter.
void replay(QPainter &painter, const QPoint &origin, QCustomPlot &plot, const QSize &size)
{
    const QPaintEngine *engine = painter.paintEngine();
    const bool isVector = engine && (engine->type() == QPaintEngine::SVG || engine->type() == QPaintEngine::Pdf);
    QPicture recording;
    QCPPainter recorder(&recording);
    recorder.setMode(QCPPainter::pmVectorized, isVector);
    plot.toPainter(&recorder, size.width(), size.height());
    recorder.end();
    painter.save();
    painter.translate(origin);
    painter.drawPicture(0, 0, recording);
    painter.restore();
}

} // namespace

void PlotGrid::paintFigure(QPainter &painter, const QSize &size, const QPalette &palette) const
{
    m_figure->convert();
    const SeriesColours colours = seriesColours(palette);
    const Arrangement arrangement = arrange(size, m_typography->legendHeight(), m_typography->tickHeight);
    painter.fillRect(QRect(QPoint(), size), colours.background);
    drawLegend(painter, arrangement.legend, m_figure->legend(true, true), m_typography->title, colours);
    Plot plot(nullptr);
    plot.setStyle(*m_typography, colours);
    for (std::size_t column = 0; column < kColumns; ++column) {
        std::array<Picture, kPlotCount / kColumns> pictures;
        int labelLength = 0;
        for (std::size_t row = 0; row < pictures.size(); ++row) {
            const std::size_t i = row * kColumns + column;
            const bool hasTimeLabels = arrangement.hasTimeLabelsEverywhere || row == pictures.size() - 1;
            const QSize axes = arrangement.cells[i].size().shrunkBy(m_typography->margins(0, hasTimeLabels));
            pictures[row] = m_figure->picture(i, axes);
            pictures[row].hasTimeLabels = hasTimeLabels;
            labelLength = std::max(labelLength, pictures[row].valueScale.labelLength(pictures[row].values));
        }
        for (std::size_t row = 0; row < pictures.size(); ++row) {
            const QRect cell = arrangement.cells[row * kColumns + column];
            plot.display(pictures[row], m_typography->margins(labelLength, pictures[row].hasTimeLabels));
            replay(painter, cell.topLeft(), plot, cell.size());
        }
    }
}

void PlotGrid::paintPlot(QPainter &painter, const QString &name, const QSize &size, const QPalette &palette) const
{
    const auto index = static_cast<std::size_t>(plotNames().indexOf(name));
    Q_ASSERT(index < kPlotCount);
    m_figure->convert();
    const SeriesColours colours = seriesColours(palette);
    const QRect legend(0, 0, size.width(), m_typography->legendHeight());
    const QRect cell(0, legend.height(), size.width(), std::max(0, size.height() - legend.height()));
    painter.fillRect(QRect(QPoint(), size), colours.background);
    drawLegend(painter, legend, m_figure->legend(!isError(index), isError(index)), m_typography->title, colours);
    Picture picture = m_figure->picture(index, cell.size().shrunkBy(m_typography->margins(0, true)));
    Plot plot(nullptr);
    plot.setStyle(*m_typography, colours);
    plot.display(picture, m_typography->margins(picture.valueScale.labelLength(picture.values), true));
    replay(painter, cell.topLeft(), plot, cell.size());
}

} // namespace slidercrank
