// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/polygon_view.h"

#include "ui/document/session.h"
#include "ui/export/polygon_figure.h"
#include "ui/panels/table_panel.h"
#include "ui/text/subscripts.h"
#include "ui/text/theme.h"
#include "ui/widgets/named.h"
#include "ui/widgets/paragraph.h"
#include "ui/widgets/spacing.h"

#include <QHelpEvent>
#include <QLabel>
#include <QPainter>
#include <QToolButton>
#include <QToolTip>
#include <QVBoxLayout>

namespace slidercrank
{

namespace
{

class PolygonCanvas : public QWidget
{
public:
    explicit PolygonCanvas(std::function<Polygons()> polygons)
        : m_polygons(std::move(polygons))
    {
    }

protected:
    void paintEvent(QPaintEvent *) override
    {
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        drawPolygons(painter, rect(), m_polygons(), palette());
    }

    /// Shows the magnitudes, for which the canvas may be too low, in a tool tip.
    bool event(QEvent *event) override
    {
        if (event->type() == QEvent::ToolTip) {
            const Polygons polygons = m_polygons();
            const QStringList lines{magnitudes(polygons.velocity, Measure::Speed).join(", "),
                                    magnitudes(polygons.acceleration, Measure::Acceleration).join(", ")};
            QToolTip::showText(static_cast<QHelpEvent *>(event)->globalPos(),
                               subscriptHtml(lines.join("\n")).replace('\n', "<br>"), this);
            return true;
        }
        return QWidget::event(event);
    }

private:
    std::function<Polygons()> m_polygons;
};

Polygons currentPolygons(const Session &session)
{
    return polygonsAt(Mechanism(session.parameters()), session.time(), session.alpha2());
}

} // namespace

FigureSubject polygonSubject(const Session &session)
{
    const Mechanism mechanism(session.parameters());
    const QPalette light = paletteFor(Theme::Light);
    const FigureDrawing drawing = polygonFigure(mechanism, session.time(), session.alpha2(), light);
    FigureSubject subject;
    subject.name = PolygonView::tr("polygons");
    subject.height = [=](const FigureOptions &) { return withParameters(polygonHeight, mechanism); };
    subject.draw = [=](const FigureOptions &) { return withParameters(drawing, mechanism, light); };
    return subject;
}

PolygonView::PolygonView(Session *session, QWidget *parent)
    : QWidget(parent)
    , m_session(session)
    , m_canvas(new PolygonCanvas([this] { return currentPolygons(*m_session); }))
{
    named("polygonView", this, tr("Velocity and acceleration polygons"));
    auto *head = new QHBoxLayout;
    head->addWidget(
        plainText(tr("Velocity and acceleration polygons at the present position; α₂ is that of the table.")), 1);
    connect(addButton(head, "polygonCopy", tr("Copy"), tr("Copies the polygons as an image")), &QToolButton::clicked,
            this, &PolygonView::copy);
    connect(addButton(head, "polygonExport", tr("Export…"), tr("Writes the polygons to an image file")),
            &QToolButton::clicked, this, [this] {
                chooseFigure(
                    this, polygonSubject(*m_session), [this](const FigureOptions &options, const QString &path) {
                        m_session->reportWritten(path, exportFigure(path, polygonSubject(*m_session), options));
                    });
            });
    auto *rows = new QVBoxLayout(this);
    rows->setContentsMargins(kPageMargins);
    rows->setSpacing(kRowSpacing);
    rows->addLayout(head);
    rows->addWidget(m_canvas, 1);
    connect(session, &Session::resultChanged, this, &PolygonView::refresh);
    connect(session, &Session::timeChanged, this, &PolygonView::refresh);
}

void PolygonView::refresh()
{
    if (isVisible()) {
        m_canvas->update();
    }
}

void PolygonView::copy()
{
    const FigureOptions options = storedFigureOptions();
    const FigureSubject subject = polygonSubject(*m_session);
    const FigureSize size = figureSize(options, subject.height(options));
    if (const std::optional<QString> problem = copyFigureToClipboard(size, subject.draw(options))) {
        m_session->reportFailure(*problem);
    } else {
        m_session->confirm(tr("The polygons are in the clipboard."));
    }
}

void PolygonView::showEvent(QShowEvent *event)
{
    QWidget::showEvent(event);
    refresh();
}

} // namespace slidercrank

#include "moc_polygon_view.cpp"
