// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/response_view.h"

#include "ui/document/session.h"
#include "ui/document/whole_file.h"
#include "ui/panels/response_chart.h"
#include "ui/panels/table_panel.h"
#include "ui/text/axis_scale.h"
#include "ui/text/finding_text.h"
#include "ui/text/record.h"
#include "ui/widgets/named.h"
#include "ui/widgets/paragraph.h"
#include "ui/widgets/save_dialog.h"

#include <QComboBox>
#include <QGridLayout>
#include <QPainter>
#include <QToolButton>

#include <algorithm>

namespace slidercrank
{

namespace
{

constexpr QSize kFigureSize(1500, 330);  // px, of the exported charts
constexpr QSize kSmallestChart(100, 90); // px; below this the page scrolls

std::vector<Record> recordsOf(const Response &response)
{
    constexpr std::array kKeys{"stroke", "time-ratio", "least-transmission-angle", "peak-slider-speed",
                               "peak-slider-acceleration"}; // in the order of LimitValues
    std::vector<Record> records;
    for (std::size_t i = 0; i < response.values.size(); ++i) {
        Record &record = records.emplace_back();
        record.emplace_back(QLatin1String(optionName(response.parameter)), response.values[i]);
        for (std::size_t k = 0; k < kLimitCount; ++k) {
            record.emplace_back(kKeys[k], jsonNumber(response.limits[i][k]));
        }
    }
    return records;
}

} // namespace

ResponseView::ResponseView(Session *session, QWidget *parent)
    : QWidget(parent)
    , m_session(session)
    , m_parameter(named("responseParameter", new QComboBox, tr("Parameter that is varied")))
    , m_sentence(named("responseSentence", plainText()))
{
    named("responseView", this, tr("How the limits depend on a parameter"));
    for (const Parameter parameter : kVariedParameters) {
        m_parameter->addItem(tr("Response to %1").arg(symbolText(parameter)));
    }
    m_parameter->setCurrentIndex(static_cast<int>(indexOf(Parameter::B)));
    connect(m_parameter, &QComboBox::currentIndexChanged, this, &ResponseView::refresh);
    auto *head = new QHBoxLayout;
    head->addWidget(m_parameter, 0, Qt::AlignTop);
    head->addWidget(m_sentence, 1);
    const QToolButton *copyButton = addButton(head, "responseCopy", tr("Copy"), tr("Copies the charts as an image"));
    connect(copyButton, &QToolButton::clicked, this, &ResponseView::copy);
    const QToolButton *exportButton =
        addButton(head, "responseExport", tr("Export…"),
                  tr("Writes the charts to an image file, or the numbers of the curves to a CSV file"));
    connect(exportButton, &QToolButton::clicked, this, [this] {
        chooseExport(this, figureFilters() + QStringList(tr("Tables (*.csv)")), tr("response.png"),
                     &ResponseView::exportTo);
    });
    auto *grid = new QGridLayout;
    grid->setSpacing(2);
    grid->setRowStretch(1, 1);
    for (std::size_t i = 0; i < kLimitCount; ++i) {
        auto *chart = m_charts[i] = named(QStringLiteral("responseChart%1").arg(i), new ResponseChart(i));
        chart->setMinimumSize(kSmallestChart);
        grid->setColumnStretch(static_cast<int>(i), 1);
        const QString title = chart->title().replace(u'/', "/\u2060"); // no line break within a unit
        grid->addWidget(new Paragraph(title), 0, static_cast<int>(i));
        grid->addWidget(chart, 1, static_cast<int>(i));
        connect(chart, &ResponseChart::requested, this,
                [this](double value) { m_session->setParameter(m_response.parameter, value); });
        connect(chart, &ResponseChart::dragBegan, session, &Session::beginDrag);
        connect(chart, &ResponseChart::dragEnded, session, &Session::endDrag);
    }
    auto *rows = new QVBoxLayout(this);
    rows->setContentsMargins(2, 0, 0, 0);
    rows->setSpacing(3);
    rows->addLayout(head);
    rows->addLayout(grid, 1);
    connect(session, &Session::resultChanged, this, &ResponseView::refresh);
}

void ResponseView::setParameter(Parameter parameter)
{
    m_parameter->setCurrentIndex(static_cast<int>(indexOf(parameter)));
}

/// Computes new curves if anything except the value of the varied parameter has changed; otherwise moves only the dots.
void ResponseView::refresh()
{
    if (!isVisible()) {
        return;
    }
    const Parameters &parameters = m_session->result()->mechanism.parameters();
    const Parameter parameter = kVariedParameters[static_cast<std::size_t>(m_parameter->currentIndex())];
    const double value = valueOf(parameters, parameter);
    const int pixels = std::max(2, m_charts[0]->width());
    if (m_response.parameter == parameter) {
        valueOf(m_response.parameters, parameter) = value; // the curves do not depend on this value
    }
    if (m_response.parameter == parameter && m_response.parameters == parameters &&
        m_response.range.assembled.contains(value) && static_cast<int>(m_response.values.size()) >= pixels) {
        showResponse(false);
        return;
    }
    m_task.start(
        [parameters, parameter, pixels](const std::stop_token &stop, const BackgroundTask::Progress &) {
            return computeResponse(parameters, parameter, pixels, stop);
        },
        [this](const Response &response) {
            m_response = response;
            showResponse(true);
        },
        [this](const QString &sentence) { emit problemFound(sentence); });
}

void ResponseView::showResponse(bool isNew)
{
    const auto &[parameters, parameter, range, values, limits] = m_response;
    const QString symbol = symbolText(parameter);
    const QString title = tr("%1 [%2]").arg(symbol, parameter == Parameter::Omega2 ? tr("rad/s") : tr("mm"));
    m_sentence->setText(fullTurnText(parameter, range) + u' ' + tr("Drag a dot to change %1.").arg(symbol));
    ResponseChart::Dots dots{{valueOf(parameters, parameter), limitValues(Mechanism(parameters))}};
    for (const Parameters &pinned : m_session->result()->pinned) {
        dots.push_back({valueOf(pinned, parameter), limitValues(Mechanism(pinned))});
    }
    for (ResponseChart *chart : m_charts) {
        if (isNew) {
            chart->setCurve(m_response, title);
        }
        chart->setDots(dots);
    }
}

FigureDrawing ResponseView::drawing() const
{
    return [this](QPainter &painter, const QSize &size) {
        const QPalette light = paletteFor(Theme::Light);
        const int line = 2 * QFontMetrics(font()).height();
        const QSize part(size.width() / static_cast<int>(kLimitCount), size.height() - line);
        painter.fillRect(QRect(QPoint(), size), light.base());
        int left = 0;
        for (const ResponseChart *chart : m_charts) {
            painter.save();
            painter.translate(left, 0);
            painter.drawText(QRect(0, 0, part.width(), line), Qt::AlignCenter, chart->title());
            painter.translate(0, line);
            chart->paintAll(painter, part, light);
            painter.restore();
            left += part.width();
        }
    };
}

std::optional<QString> ResponseView::exportTo(const QString &path) const
{
    if (path.endsWith(QStringLiteral(".csv"), Qt::CaseInsensitive)) {
        return writeWhole(path, csvText(recordsOf(m_response)));
    }
    return exportFigure(path, {kFigureSize, 2.0}, accessibleName(),
                        withParameters(drawing(), Mechanism(m_response.parameters), paletteFor(Theme::Light)));
}

void ResponseView::copy()
{
    if (const std::optional<QString> problem = copyFigureToClipboard({kFigureSize, 2.0}, drawing())) {
        emit problemFound(*problem);
    } else {
        emit copied(tr("The charts are in the clipboard."));
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
