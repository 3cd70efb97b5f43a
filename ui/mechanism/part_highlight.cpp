// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/mechanism/part_highlight.h"

#include "ui/mechanism/mechanism_view.h"
#include "ui/text/theme.h"

#include <QEvent>
#include <QPainter>

namespace slidercrank
{

namespace
{

// px
constexpr double kRing = 13.0;
constexpr double kDriveRing = 21.0;
constexpr double kBand = 22.0; // the width of what lies over a link
constexpr QSizeF kBlock(54.0, 36.0);
constexpr QRectF kFoot(-24.0, -8.0, 48.0, 36.0); // about O2 and what holds it

} // namespace

PartHighlight::PartHighlight(MechanismView *view)
    : QWidget(view)
    , m_view(view)
{
    setObjectName(QStringLiteral("partHighlight"));
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setGeometry(view->rect());
    view->installEventFilter(this);
    hide();
}

void PartHighlight::setPart(MechanismPart part)
{
    m_part = part;
    showOrHide();
}

void PartHighlight::setPose(const Pose &pose)
{
    m_pose = pose;
    showOrHide();
}

void PartHighlight::setResult(const std::shared_ptr<const Result> &result)
{
    m_mechanism = result->mechanism;
    update();
}

void PartHighlight::showOrHide()
{
    setVisible(m_part != MechanismPart::None && m_pose.exists());
    update();
}

bool PartHighlight::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::Resize) {
        setGeometry(m_view->rect());
    }
    return QWidget::eventFilter(watched, event);
}

void PartHighlight::paintEvent(QPaintEvent *)
{
    const QPointF pivot = m_view->toPixels({0.0, 0.0});
    const QPointF pinA = m_view->toPixels({m_pose.pinX, m_pose.pinY});
    const QPointF pinB = m_view->toPixels({m_pose.sliderX, m_mechanism.c()});
    QRectF block(QPointF(), kBlock);
    block.moveCenter(pinB);

    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QColor colour = seriesColours(palette()).error;
    QColor light = colour;
    light.setAlphaF(0.25F);
    painter.setPen(QPen(colour, 2.5));
    painter.setBrush(light);
    const auto paintBand = [&](const QPointF &from, const QPointF &to) {
        painter.setPen(QPen(light, kBand, Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(from, to);
    };
    switch (m_part) {
    case MechanismPart::None: break;
    case MechanismPart::Ground: painter.drawRoundedRect(kFoot.translated(pivot), 6.0, 6.0); break;
    case MechanismPart::Crank: paintBand(pivot, pinA); break;
    case MechanismPart::Coupler: paintBand(pinA, pinB); break;
    case MechanismPart::Slider: painter.drawRoundedRect(block, 6.0, 6.0); break;
    case MechanismPart::Pivot: painter.drawEllipse(pivot, kRing, kRing); break;
    case MechanismPart::PinA: painter.drawEllipse(pinA, kRing, kRing); break;
    case MechanismPart::PinB: painter.drawEllipse(pinB, kRing, kRing); break;
    case MechanismPart::Guide:
        painter.drawLine(QPointF(0.0, pinB.y()), QPointF(width(), pinB.y()));
        painter.drawRoundedRect(block, 6.0, 6.0);
        break;
    case MechanismPart::Drive: {
        // Three quarters of a turn about O2, with a head: the way that the crank turns.
        painter.translate(pivot);
        painter.scale(1.0, m_mechanism.omega2() < 0.0 ? -1.0 : 1.0);
        painter.setBrush(Qt::NoBrush);
        painter.drawArc(QRectF(-kDriveRing, -kDriveRing, 2.0 * kDriveRing, 2.0 * kDriveRing), 0, 270 * 16);
        const QPointF head(0.0, kDriveRing);
        painter.drawPolyline(QPolygonF{head + QPointF(-7.0, -5.0), head, head + QPointF(-6.0, 6.0)});
        break;
    }
    }
}

} // namespace slidercrank
