// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/response_view.h"

#include "ui/document/session.h"
#include "ui/document/whole_file.h"
#include "ui/panels/table_panel.h"
#include "ui/text/axis_scale.h"
#include "ui/text/motion_facts.h"
#include "ui/text/notation.h"
#include "ui/text/parameter_text.h"
#include "ui/text/record.h"
#include "ui/text/written_number.h"
#include "ui/widgets/enum_box.h"
#include "ui/widgets/named.h"
#include "ui/widgets/paragraph.h"
#include "ui/widgets/save_dialog.h"
#include "ui/widgets/spacing.h"

#include <QComboBox>
#include <QGridLayout>
#include <QMenu>
#include <QMouseEvent>
#include <QPainter>
#include <QToolButton>

#include <algorithm>
#include <cmath>

namespace slidercrank
{

namespace
{

constexpr QSize kSmallestChart(100, 90); // px; below this the page scrolls

/// Returns a name with its unit, unless that is the unit of files.
QString nameWithUnit(const QString &name, const QString &unit, const QString &fileUnit)
{
    return unit == fileUnit ? name : QStringLiteral("%1 [%2]").arg(name, unit);
}

/// Returns the curves in the units that are shown.
std::vector<Record> curveRecords(const Response &response)
{
    const Parameter parameter = response.parameter;
    const QString name = nameWithUnit(optionName(parameter), unitSuffix(parameter).trimmed(),
                                      parameter == Parameter::Omega2 ? "rad/s" : "mm");
    std::vector<Record> records;
    for (std::size_t i = 0; i < response.values.size(); ++i) {
        Record &record = records.emplace_back();
        record.emplace_back(name, shownFactor(parameter) * response.values[i]);
        for (std::size_t k = 0; k < kResponseLimits.size(); ++k) {
            const auto &[kind, key, measure] = describe(kResponseLimits[k]);
            record.emplace_back(nameWithUnit(QString::fromUtf8(key.data(), static_cast<qsizetype>(key.size())),
                                             shownUnit(measure), unitText(measure)),
                                jsonNumber(response.limits[i][k]));
        }
    }
    return records;
}

/// The names of the limits with their units, short enough for the titles of small charts.
struct ChartName {
    LimitKind kind;
    const char *text; ///< %1: the unit; nullptr for the usual name of the limit
};
constexpr std::array kChartNames{
    ChartName{LimitKind::Stroke, QT_TRANSLATE_NOOP("slidercrank::ResponseView", "stroke [%1]")},
    ChartName{LimitKind::TimeRatio, nullptr},
    ChartName{LimitKind::MinimumTransmissionAngle,
              QT_TRANSLATE_NOOP("slidercrank::ResponseView", "min. transmission angle [%1]")},
    ChartName{LimitKind::PeakSliderSpeed, QT_TRANSLATE_NOOP("slidercrank::ResponseView", "peak slider speed [%1]")},
    ChartName{LimitKind::PeakSliderAcceleration,
              QT_TRANSLATE_NOOP("slidercrank::ResponseView", "peak slider acc. [%1]")}};
static_assert(std::ranges::equal(kChartNames, kResponseLimits, {}, &ChartName::kind));

QString chartName(std::size_t limit)
{
    const LimitKind kind = kResponseLimits[limit];
    const char *text = kChartNames[limit].text;
    return text ? ResponseView::tr(text).arg(shownUnit(describe(kind).measure)) : limitName(kind);
}

/// Returns the title without a line break behind the slash of a unit such as mm/s.
QString withUnbrokenSlashes(QString title)
{
    const QChar wordJoiner(u'\u2060');
    return title.replace(u'/', QString(u'/') + wordJoiner);
}

/// Returns the range of the finite values of a limit, without the steep rise of a peak towards infinity.
Interval valueRange(const Response &response, std::size_t limit)
{
    constexpr double kSteepRise = 3.0; // times the median of the values
    std::vector<double> values;
    for (const LimitValues &limits : response.limits) {
        if (const double value = limits[limit]; std::isfinite(value)) {
            values.push_back(value);
        }
    }
    if (values.empty()) {
        return {};
    }
    std::ranges::sort(values);
    const double startOfRise = std::max(kSteepRise * values[values.size() / 2], values.front());
    return {values.front(), peakChannel(kResponseLimits[limit]) ? std::min(values.back(), startOfRise) : values.back()};
}

/// How the charts are arranged in a figure of a given width (px).
struct ChartGrid {
    int columns = 1;
    int rows = 1;
    int aboveTitle = 0;  ///< space above a title, px
    int titleHeight = 0; ///< height of a title of two lines, with the space above it, px
    int chartHeight = 0; ///< px

    ChartGrid(int width, const QFont &font)
    {
        constexpr int kMinWidth = 13;         // heights of a line of text, for the words of a title
        constexpr int kMinHeight = 8;         // heights of a line
        constexpr double kHeightRatio = 0.75; // height of a chart over its width
        constexpr double kAboveTitle = 0.4;   // heights of a line
        constexpr int kCharts = static_cast<int>(kResponseLimits.size());
        const int line = QFontMetrics(font).height();
        columns = std::clamp(width / (kMinWidth * line), 1, kCharts);
        rows = (kCharts + columns - 1) / columns;
        aboveTitle = static_cast<int>(kAboveTitle * line);
        titleHeight = aboveTitle + 2 * line;
        chartHeight = std::max(kMinHeight * line, static_cast<int>(kHeightRatio * width / columns));
    }

    int height() const { return rows * (titleHeight + chartHeight); }
};

/// Returns a dot for each mechanism in which this limit exists and is finite.
ChartSeries dotsOf(const std::vector<Parameters> &mechanisms, Parameter parameter, std::size_t limit)
{
    constexpr double kRadius = 4.5; // px
    ChartSeries dots;
    dots.mark.addEllipse(QPointF(), kRadius, kRadius);
    for (const Parameters &parameters : mechanisms) {
        dots.points.emplace_back(valueOf(parameters, parameter), limitValues(Mechanism(parameters))[limit]);
    }
    std::erase_if(dots.points, [](const QPointF &dot) { return !std::isfinite(dot.y()); });
    std::ranges::sort(dots.points, {}, &QPointF::x);
    for (const QPointF &dot : dots.points) {
        dots.tips << shortNumber(dot.y());
    }
    return dots;
}

} // namespace

ResponseView::ResponseView(Session *session, QWidget *parent)
    : QWidget(parent)
    , m_session(session)
    , m_parameter(named("responseParameter", new QComboBox, tr("Parameter that is varied")))
    , m_sentence(named("responseSentence", plainText()))
{
    named("responseView", this, tr("How the limits depend on a parameter"));
    m_sentence->setTextInteractionFlags(Qt::TextSelectableByMouse); // without a caret
    for (const Parameter parameter : kVariedParameters) {
        addChoice(m_parameter, parameter, tr("Response to %1").arg(symbolText(parameter)));
    }
    choose(m_parameter, Parameter::B);
    connect(m_parameter, &QComboBox::currentIndexChanged, this, &ResponseView::refresh);
    auto *head = new QHBoxLayout;
    head->addWidget(m_parameter, 0, Qt::AlignTop);
    head->addWidget(m_sentence, 1);
    connect(addButton(head, "responseCopy", tr("Copy"), tr("Copies the charts as an image")), &QToolButton::clicked,
            this, &ResponseView::copy);
    QToolButton *exports =
        makeMenuButton("responseExport", tr("Export"),
                       tr("Writes the charts to an image file, or the numbers of the curves to a CSV file"));
    fillExportMenu(exports->menu());
    head->addWidget(exports, 0, Qt::AlignTop);
    auto *grid = new QGridLayout;
    grid->setSpacing(kDenseSpacing);
    grid->setRowStretch(1, 1);
    for (std::size_t i = 0; i < kResponseLimits.size(); ++i) {
        auto *chart = m_charts[i] = named(QStringLiteral("responseChart%1").arg(i), new Chart);
        chart->setMinimumSize(kSmallestChart);
        chart->setCursor(Qt::SizeHorCursor);
        chart->installEventFilter(this);
        m_titles[i] = plainText();
        m_titles[i]->setTextInteractionFlags(Qt::NoTextInteraction); // a click would leave a caret
        grid->setColumnStretch(static_cast<int>(i), 1);
        grid->addWidget(m_titles[i], 0, static_cast<int>(i));
        grid->addWidget(chart, 1, static_cast<int>(i));
    }
    auto *rows = new QVBoxLayout(this);
    rows->setContentsMargins(kPageMargins);
    rows->setSpacing(kRowSpacing);
    rows->addLayout(head);
    rows->addLayout(grid, 1);
    connect(session, &Session::resultChanged, this, &ResponseView::refresh);
}

void ResponseView::setParameter(Parameter parameter)
{
    choose(m_parameter, parameter);
}

/// Computes new curves if anything except the value of the varied parameter has changed, or if their range or number
/// of values is no longer suitable; otherwise moves only the dots.
void ResponseView::refresh()
{
    if (!isVisible()) {
        return;
    }
    const Parameters &parameters = m_session->result()->mechanism.parameters();
    const auto parameter = chosen<Parameter>(m_parameter);
    const double value = valueOf(parameters, parameter);
    const int pixels = std::max(2, m_charts[0]->width());
    if (m_response.parameter == parameter) {
        valueOf(m_response.parameters, parameter) = value; // the curves do not depend on this value
    }
    const Interval &range = m_response.range.assembled;
    const bool areCurvesSuitable = m_response.parameter == parameter && m_response.parameters == parameters &&
                                   range.contains(value) &&
                                   range.length() <= 2.0 * responseRange(parameters, parameter).assembled.length() &&
                                   static_cast<int>(m_response.values.size()) >= pixels;
    if (areCurvesSuitable) {
        showResponse();
        return;
    }
    m_task.start(
        [parameters, parameter, pixels](const std::stop_token &stop, const BackgroundTask::Progress &) {
            return computeResponse(parameters, parameter, pixels, stop);
        },
        [this](const Response &response) {
            m_response = response;
            showResponse();
        },
        [this](const QString &sentence) { m_session->reportFailure(sentence); });
}

void ResponseView::showResponse()
{
    const LimitValues currentLimits = limitValues(Mechanism(m_response.parameters));
    m_sentence->setText(withUnbrokenUnits(fullTurnText(m_response.parameter, m_response.range) + u' ' +
                                          tr("Drag a dot to change %1.").arg(symbolText(m_response.parameter))));
    for (std::size_t i = 0; i < kResponseLimits.size(); ++i) {
        const QString title = tr("%1: %2").arg(chartName(i), shortNumber(currentLimits[i]));
        m_titles[i]->setText(withUnbrokenSlashes(title));
        m_charts[i]->setAccessibleName(title);
        m_charts[i]->setContent(chartOf(i));
    }
}

ChartContent ResponseView::chartOf(std::size_t limit) const
{
    const auto &[parameters, parameter, range, values, limits] = m_response;
    ChartSeries curve{.line = ChartSeries::Line::Solid};
    for (std::size_t i = 0; i < values.size(); ++i) {
        curve.points.emplace_back(values[i], limits[i][limit]);
    }
    ChartSeries pinned = dotsOf(m_session->result()->pinned, parameter, limit);
    pinned.colour = &SeriesColours::pinnedFirst;
    pinned.isHollow = true;
    ChartSeries currentDot = dotsOf({parameters}, parameter, limit);
    currentDot.colour = &SeriesColours::cursor;
    Interval valuesShown = valueRange(m_response, limit);
    for (const ChartSeries *dots : {&pinned, &currentDot}) {
        for (const QPointF &dot : dots->points) {
            valuesShown.include(dot.y());
        }
    }
    const double factor = shownFactor(parameter);
    for (ChartSeries *series : {&curve, &pinned, &currentDot}) {
        for (QPointF &point : series->points) {
            point.rx() *= factor;
        }
    }
    const auto inShownUnit = [factor](const Interval &interval) {
        return Interval{factor * interval.lower, factor * interval.upper};
    };
    return {.x = {.title = tr("%1 [%2]").arg(symbolText(parameter), unitSuffix(parameter).trimmed()),
                  .range = inShownUnit(range.assembled)},
            .y = {.title = {}, .range = roundedOutwards(valuesShown)},
            .series = {curve, pinned, currentDot},
            .unshaded = inShownUnit(range.fullTurn)};
}

/// Changes the parameter to the value at a position (px) of a chart, rounded to a round step of about a pixel and
/// limited to the range.
void ResponseView::setParameterAt(Chart &chart, double pixel)
{
    const auto &[lower, upper] = m_response.range.assembled;
    const double left = chart.positionOf({Curve, 0}).x();
    const double right = chart.positionOf({Curve, m_response.values.size() - 1}).x();
    const double value = std::lerp(lower, upper, (pixel - left) / (right - left));
    constexpr double kStepsInRange = 400.0; // about as many as a chart has pixels
    constexpr int kDigits = 12;             // so that 0.1 + 0.2 becomes 0.3
    const double step = nextRoundNumber((upper - lower) / kStepsInRange);
    const double rounded = QString::number(std::round(value / step) * step, 'g', kDigits).toDouble();
    m_session->setParameter(m_response.parameter, std::clamp(rounded, lower, upper));
}

bool ResponseView::eventFilter(QObject *watched, QEvent *event)
{
    const bool isPress = event->type() == QEvent::MouseButtonPress;
    const bool isMouse = isPress || event->type() == QEvent::MouseMove || event->type() == QEvent::MouseButtonRelease;
    if (!isMouse || m_response.values.empty()) {
        return false;
    }
    const auto &mouse = *static_cast<QMouseEvent *>(event);
    if (isPress) {
        m_session->beginDrag();
    }
    if (mouse.buttons() & Qt::LeftButton) {
        setParameterAt(*static_cast<Chart *>(watched), mouse.position().x());
        return true;
    }
    m_session->endDrag();
    return false;
}

/// Returns the explanation of the hollow dots in a figure; empty if no motion is pinned.
QString ResponseView::pinnedNote() const
{
    QStringList motions;
    for (const Parameters &pinned : m_session->result()->pinned) {
        motions << pinnedText(pinned, m_response.parameters);
    }
    return motions.isEmpty() ? QString() : tr("Hollow dots: pinned motions, %1.").arg(motions.join(u", "));
}

/// Returns the height (px) of a text that is broken into lines of that width.
static int textHeight(const QString &text, int width, const QFont &font)
{
    constexpr int kLargestHeight = 10'000;
    return QFontMetrics(font).boundingRect(QRect(0, 0, width, kLargestHeight), Qt::TextWordWrap, text).height();
}

/// Draws the charts with their titles, as many in a row as the letters permit, and the explanation of the dots.
void ResponseView::draw(QPainter &painter, const QSize &size) const
{
    const QPalette light = paletteFor(Theme::Light);
    const ChartGrid grid(size.width(), painter.font());
    const QString note = pinnedNote();
    const int noteHeight = note.isEmpty() ? 0 : textHeight(note, size.width(), painter.font());
    const QSize cell(size.width() / grid.columns, (size.height() - noteHeight) / grid.rows);
    painter.fillRect(QRect(QPoint(), size), light.base());
    painter.setPen(light.color(QPalette::Text));
    painter.drawText(QRect(0, size.height() - noteHeight, size.width(), noteHeight), Qt::AlignCenter | Qt::TextWordWrap,
                     note);
    for (std::size_t i = 0; i < m_charts.size(); ++i) {
        const int index = static_cast<int>(i);
        painter.save();
        const int row = index / grid.columns;
        painter.translate(index % grid.columns * cell.width(), row * cell.height());
        painter.drawText(QRect(0, grid.aboveTitle, cell.width(), grid.titleHeight - grid.aboveTitle),
                         Qt::AlignCenter | Qt::TextWordWrap, withUnbrokenSlashes(m_charts[i]->accessibleName()));
        painter.translate(0, grid.titleHeight);
        m_charts[i]->paint(painter, cell - QSize(0, grid.titleHeight), light);
        painter.restore();
    }
}

FigureSubject ResponseView::figure() const
{
    const Mechanism mechanism(m_response.parameters);
    const FigureDrawing drawing = [this](QPainter &painter, const QSize &size) { draw(painter, size); };
    const FigureHeight height = [note = pinnedNote()](int width, const QFont &font) {
        return ChartGrid(width, font).height() + (note.isEmpty() ? 0 : textHeight(note, width, font));
    };
    FigureSubject subject;
    subject.name = tr("response");
    subject.height = [=](const FigureOptions &) { return withParameters(height, mechanism); };
    subject.draw = [=](const FigureOptions &) { return withParameters(drawing, mechanism, paletteFor(Theme::Light)); };
    return subject;
}

void ResponseView::fillExportMenu(QMenu *menu)
{
    menu->addAction(tr("Figure…"), this, [this] {
        chooseFigure(this, figure(), [this](const FigureOptions &options, const QString &path) {
            m_session->reportWritten(path, exportFigure(path, figure(), options));
        });
    });
    menu->addAction(tr("Table…"), this, [this] {
        chooseExport(m_session, this, QStringList(tr("Tables (*.csv)")), tr("response"),
                     [this](const QString &path) { return exportTo(path); });
    });
}

std::optional<QString> ResponseView::exportTo(const QString &path) const
{
    return writeWhole(path, csvText(curveRecords(m_response), csvSeparators()));
}

void ResponseView::copy()
{
    const FigureOptions options = storedFigureOptions();
    const FigureSubject subject = figure();
    const FigureSize size = figureSize(options, subject.height(options));
    if (const std::optional<QString> problem = copyFigureToClipboard(size, subject.draw(options))) {
        m_session->reportFailure(*problem);
    } else {
        m_session->confirm(tr("The charts are in the clipboard."));
    }
}

void ResponseView::showEvent(QShowEvent *event)
{
    QWidget::showEvent(event);
    refresh();
}

void ResponseView::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    refresh();
}

} // namespace slidercrank

#include "moc_response_view.cpp"
