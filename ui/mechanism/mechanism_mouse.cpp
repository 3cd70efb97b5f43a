// SPDX-License-Identifier: GPL-3.0-or-later

// What the mouse and the keyboard do to the mechanism view.

#include "core/mechanism/enum_table.h"
#include "core/sampling/crank_time.h"
#include "ui/mechanism/mechanism_view.h"
#include "ui/text/written_number.h"

#include <QKeyEvent>
#include <QLabel>
#include <QMouseEvent>
#include <QTimer>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <utility>

namespace slidercrank
{

bool MechanismView::event(QEvent *event)
{
    switch (event->type()) {
    case QEvent::Resize:
    case QEvent::PaletteChange:
    case QEvent::FontChange:
    case QEvent::StyleChange:
    case QEvent::LocaleChange: refresh(); break;
    case QEvent::Hide: endDrag(); break;
    case QEvent::Leave:
        if (!m_pressed) {
            pointAt(DrawnPart::Background);
        }
        break;
    default: break;
    }
    return QWidget::event(event);
}

void MechanismView::keyPressEvent(QKeyEvent *event)
{
    constexpr double kPanStep = 40.0;          // px
    const auto pan = [&](double x, double y) { // the keys move the frame, so the drawing moves the other way
        if (!event->modifiers().testFlag(Qt::ControlModifier)) {
            QWidget::keyPressEvent(event);
            return;
        }
        m_frame.pan(kPanStep * QPointF(x, y), size());
        refresh();
    };
    switch (event->key()) {
    case Qt::Key_Left: pan(1.0, 0.0); break;
    case Qt::Key_Right: pan(-1.0, 0.0); break;
    case Qt::Key_Up: pan(0.0, 1.0); break;
    case Qt::Key_Down: pan(0.0, -1.0); break;
    case Qt::Key_PageDown: pointAtNext(1); break;
    case Qt::Key_PageUp: pointAtNext(-1); break;
    case Qt::Key_Return:
    case Qt::Key_Enter: emit fullWindowToggleRequested(); break;
    case Qt::Key_Escape:
        if (!m_pressed && m_pointedPart == DrawnPart::Background) {
            QWidget::keyPressEvent(event); // the window handles it
            break;
        }
        cancelDrag();
        pointAt(DrawnPart::Background);
        break;
    default: QWidget::keyPressEvent(event); break;
    }
}

void MechanismView::mousePressEvent(QMouseEvent *event)
{
    const bool isLeft = event->button() == Qt::LeftButton;
    if (m_pressed || !m_scene.result || !(isLeft || event->button() == Qt::MiddleButton)) {
        QWidget::mousePressEvent(event);
        return;
    }
    const QPointF pixel = event->position();
    const bool withShift = event->modifiers().testFlag(Qt::ShiftModifier);
    m_pressed = PressedButton{
        .drag = std::nullopt, .button = event->button(), .start = pixel, .last = pixel, .time = m_scene.pose.time};
    if (isLeft) {
        pointAt(partUnder(pixel), event->modifiers());
        m_pressed->drag = MechanismDrag::begin(m_scene, m_pointedPart, withShift, projection().toModel(pixel));
    }
    if (m_pressed->drag && m_pressed->drag->length()) {
        emit dragBegan();
    } else if (m_pressed->drag) {
        setCursor(Qt::ClosedHandCursor);
    }
}

void MechanismView::mouseMoveEvent(QMouseEvent *event)
{
    constexpr double kMaxMoveOfClick = 3.0; // px that the pointer may move during a click
    const QPointF pixel = event->position();
    if (!m_pressed) {
        pointAt(partUnder(pixel), event->modifiers());
        return;
    }
    if (!m_pressed->hasMoved && (pixel - m_pressed->start).manhattanLength() < kMaxMoveOfClick) {
        return;
    }
    m_pressed->hasMoved = true;
    const QPointF last = std::exchange(m_pressed->last, pixel);
    if (!m_pressed->drag) {
        setCursor(Qt::ClosedHandCursor);
        m_frame.pan(pixel - last, size());
        refresh();
        return;
    }
    const QPointF pointer = projection().toModel(pixel);
    if (const std::optional<Parameter> length = m_pressed->drag->length()) {
        // Lengths are multiples of a round number, about one pixel or, with Control, much less.
        constexpr double kUsualStep = 1.0; // px
        constexpr double kFineStep = 0.02; // px
        const double pixels = event->modifiers().testFlag(Qt::ControlModifier) ? kFineStep : kUsualStep;
        emit lengthRequested(*length, m_pressed->drag->lengthAt(pointer, nextRoundNumber(pixels / projection().scale)));
    } else {
        goToCrankAngle(m_pressed->drag->crankAngleAt(pointer));
    }
    m_noteDelay->stop();
    showNote();
}

void MechanismView::mouseReleaseEvent(QMouseEvent *event)
{
    if (!m_pressed || event->button() != m_pressed->button) {
        QWidget::mouseReleaseEvent(event);
        return;
    }
    const bool isClick = !m_pressed->hasMoved && event->button() == Qt::LeftButton;
    endDrag();
    if (isClick && (m_pointedPart == DrawnPart::OuterDeadCentre || m_pointedPart == DrawnPart::InnerDeadCentre)) {
        const MotionLimits &limits = m_scene.result->limits;
        goToCrankAngle(
            (m_pointedPart == DrawnPart::OuterDeadCentre ? limits.outerDeadCentre : limits.innerDeadCentre)->theta2);
    }
    const bool isInside = rect().contains(event->position().toPoint());
    pointAt(isInside ? partUnder(event->position()) : DrawnPart::Background, event->modifiers());
}

void MechanismView::mouseDoubleClickEvent(QMouseEvent *event)
{
    if (event->button() != Qt::LeftButton) {
        mousePressEvent(event);
    } else if (partUnder(event->position()) == DrawnPart::Background) {
        fit();
    } else {
        emit fullWindowToggleRequested();
    }
}

void MechanismView::wheelEvent(QWheelEvent *event)
{
    constexpr double kNotch = 120.0; // angleDelta() of one notch of a mouse wheel
    const double notches = event->angleDelta().y() / kNotch;
    if (notches == 0.0 || m_pressed) {
        QWidget::wheelEvent(event);
        return;
    }
    zoomBy(notches, event->position());
}

void MechanismView::goToCrankAngle(double theta2)
{
    emit timeRequested(
        nearestTimeAtCrankAngle(m_scene.mechanism(), m_scene.result->sampling, theta2, m_scene.pose.time));
}

void MechanismView::endDrag()
{
    if (!m_pressed) {
        return;
    }
    const PressedButton released = *std::exchange(m_pressed, std::nullopt);
    if (released.drag && released.drag->length()) {
        emit dragEnded();
        m_frame.follow(bounds());
        refresh();
    }
    unsetCursor();
}

/// Ends the drag and restores the length or the time that was current before the drag.
void MechanismView::cancelDrag()
{
    if (!m_pressed || !m_pressed->drag) {
        return;
    }
    const PressedButton cancelled = *m_pressed;
    if (const std::optional<Parameter> length = cancelled.drag->length()) {
        emit lengthRequested(*length, cancelled.drag->lengthBefore());
    }
    endDrag();
    if (!cancelled.drag->length()) {
        emit timeRequested(cancelled.time);
    }
}

/// Returns the uppermost part at that position: the linkage lies over the scenery.
DrawnPart MechanismView::partUnder(QPointF pixel) const
{
    const QPointF position = pixel / magnification();
    const DrawnPart moving = linkage().partAt(position);
    return moving == DrawnPart::Background ? m_scenery.partAt(position) : moving;
}

void MechanismView::pointAt(DrawnPart part, Qt::KeyboardModifiers modifiers)
{
    if (part != m_pointedPart) {
        m_pointedPart = part;
        m_note->hide();
        m_noteDelay->start();
        update();
    }
    setCursor(m_scene.result ? cursorOver(m_scene, part, modifiers.testFlag(Qt::ShiftModifier)) : Qt::ArrowCursor);
}

/// Points at the next part that is drawn, or with -1 at the previous one, in the order of DrawnPart.
void MechanismView::pointAtNext(int step)
{
    constexpr auto kCount = static_cast<int>(enumeratorCount<DrawnPart::ForbiddenArc>());
    if (!m_scene.result || m_pressed) {
        return;
    }
    DrawnPart part = m_pointedPart;
    do {
        part = static_cast<DrawnPart>((static_cast<int>(part) + step + kCount) % kCount);
    } while (part != DrawnPart::Background && !m_scenery.has(part) && !linkage().has(part));
    pointAt(part);
    m_noteDelay->stop();
    showNote();
}

} // namespace slidercrank
