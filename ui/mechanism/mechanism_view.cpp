// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/mechanism/mechanism_view.h"

#include "core/sampling/crank_instant.h"
#include "ui/document/with.h"
#include "ui/mechanism/drawn_part.h"
#include "ui/mechanism/mechanism_linkage.h"
#include "ui/mechanism/mechanism_note.h"
#include "ui/mechanism/mechanism_scenery.h"
#include "ui/mechanism/mechanism_words.h"
#include "ui/text/written_number.h"

#include <QAction>
#include <QApplication>
#include <QFontInfo>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QTimer>
#include <QWheelEvent>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace slidercrank
{

namespace
{

constexpr double kZoomStep = 1.25;
constexpr double kPanStep = 40.0;    // px
constexpr double kStillAClick = 3.0; // px that a hand shakes
constexpr int kNoteDelay = 250;      // ms: a pointer that only passes by is told nothing
constexpr int kRest = 400;           // ms without a change: then lengths and pose are at rest

} // namespace

MechanismView::MechanismView(QWidget *parent)
    : QWidget(parent)
    , m_note(new MechanismNote(this))
    , m_noteDelay(new QTimer(this))
    , m_refitDelay(new QTimer(this))
{
    setObjectName(QStringLiteral("mechanismView"));
    setAccessibleName(tr("Mechanism"));
    setAttribute(Qt::WA_OpaquePaintEvent);
    setMouseTracking(true); // for what is pointed at
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setContextMenuPolicy(Qt::ActionsContextMenu);
    m_noteDelay->setSingleShot(true);
    m_noteDelay->setInterval(kNoteDelay);
    connect(m_noteDelay, &QTimer::timeout, this, &MechanismView::updateNote);
    m_refitDelay->setObjectName(QStringLiteral("refitDelay"));
    m_refitDelay->setSingleShot(true);
    m_refitDelay->setInterval(kRest);
    connect(m_refitDelay, &QTimer::timeout, this, &MechanismView::refitAtRest);
    makeChoices();
}

void MechanismView::makeChoices()
{
    const auto addSwitch = [this](const QString &text, const QString &name, bool MechanismSettings::*setting) {
        auto *action = new QAction(text, this);
        action->setObjectName(name);
        action->setCheckable(true);
        connect(action, &QAction::triggered, this,
                [this, setting](bool on) { setSettings(with(m_drawing.settings, setting, on)); });
        m_choices << action;
    };
    const auto addZoom = [this](const QString &text, const QList<QKeySequence> &keys, const auto &change) {
        auto *action = new QAction(text, this);
        action->setShortcuts(keys);
        action->setShortcutContext(Qt::WidgetShortcut); // elsewhere they are characters that one types
        connect(action, &QAction::triggered, this, change);
        m_choices << action;
    };
    const auto zoomBy = [this](double factor) {
        changeFrame([this, factor] { m_frame.zoom(factor, QRectF(rect()).center(), size()); });
    };
    addSwitch(tr("&Velocity arrows"), QStringLiteral("showVelocity"), &MechanismSettings::velocity);
    addSwitch(tr("&Acceleration arrows"), QStringLiteral("showAcceleration"), &MechanismSettings::acceleration);
    addSwitch(tr("&Path of the coupler's centre"), QStringLiteral("showPath"), &MechanismSettings::path);
    addSwitch(tr("&Names of the points"), QStringLiteral("showNames"), &MechanismSettings::names);
    addSwitch(tr("&Dimensions"), QStringLiteral("showDimensions"), &MechanismSettings::dimensions);
    addSwitch(tr("An&gles θ₂ and θ³"), QStringLiteral("showAngles"), &MechanismSettings::angles);
    addSwitch(tr("Instant &centre of the coupler"), QStringLiteral("showInstantCentre"),
              &MechanismSettings::instantCentre);
    m_choices << new QAction(this);
    m_choices.back()->setSeparator(true);
    addZoom(tr("Zoom &in"), {Qt::Key_Plus, Qt::Key_Equal}, [zoomBy] { zoomBy(kZoomStep); });
    addZoom(tr("Zoom &out"), {Qt::Key_Minus}, [zoomBy] { zoomBy(1.0 / kZoomStep); });
    addZoom(tr("&Fit"), {Qt::Key_0}, [this] { fit(); });
    addActions(m_choices);
}

QSize MechanismView::sizeHint() const
{
    return {440, 340};
}

QSize MechanismView::minimumSizeHint() const
{
    return {200, 140};
}

void MechanismView::setSettings(const MechanismSettings &settings)
{
    if (settings == m_drawing.settings) {
        return;
    }
    m_drawing.settings = settings;
    const std::array<bool, 7> on{settings.velocity,   settings.acceleration, settings.path,         settings.names,
                                 settings.dimensions, settings.angles,       settings.instantCentre};
    for (std::size_t i = 0; i < on.size(); ++i) {
        m_choices[static_cast<qsizetype>(i)]->setChecked(on[i]);
    }
    m_drawing.refreshCycle(m_frame.fitted());
    refreshScenery();
}

void MechanismView::setLook(const Look &look)
{
    setSettings(look.settings);
    m_drawing.pins = look.pins;
    changeFrame([this, &look] { m_frame = look.frame; });
    update();
}

void MechanismView::setZoom(const std::optional<QRectF> &zoom)
{
    changeFrame([this, &zoom] { m_frame.setZoomed(zoom); });
}

void MechanismView::fit()
{
    if (m_drawing.result) {
        changeFrame([this] { m_frame.fit(reach()); });
    }
}

void MechanismView::setResult(const std::shared_ptr<const Result> &result)
{
    const bool sameScene = m_drawing.result && result && m_drawing.result->mechanism == result->mechanism;
    m_drawing.result = result;
    if (sameScene || !result) {
        return; // only sampling, solver or reference changed: none of it is drawn here
    }
    const bool isPulled = m_hold && m_hold->drag && m_hold->drag->length();
    if (m_hold && m_hold->drag && !isPulled) {
        release(); // it was another mechanism that was taken hold of
    }
    if (!isPulled) { // else what is under the hand would move away from it
        changeFrame([this] { m_frame.follow(reach()); });
    }
    m_refitDelay->start();
    m_drawing.refreshCycle(m_frame.fitted());
    m_scenery = QPixmap();
    update();
    const Mechanism &mechanism = m_drawing.mechanism();
    setAccessibleDescription(
        tr("Slider-crank drawn to scale: crank %1 mm, coupler %2 mm, offset %3 mm. The keys of the Playback menu move "
           "it, the sliders and boxes below change its lengths. Plus, minus and 0 zoom, Control with the arrows moves "
           "the drawing, Page Down and Page Up tell about its parts one after the other.")
            .arg(numberText(mechanism.a()), numberText(mechanism.b()), numberText(mechanism.c())));
}

void MechanismView::setPose(const Pose &pose)
{
    const bool existed = m_drawing.pose.exists();
    const QRectF before = movingArea();
    m_drawing.pose = pose;
    if (m_refitDelay->isActive()) {
        m_refitDelay->start();
    }
    if (pose.exists() && m_drawing.result) {
        m_drawing.pins = MechanismDrawing::Pins{{pose.pinX, pose.pinY}, {pose.sliderX, m_drawing.mechanism().c()}};
    }
    if (existed && pose.exists()) {
        updateArea(before.united(movingArea()));
    } else {
        update();
    }
    if (m_note->isVisible()) {
        updateNote();
    }
}

void MechanismView::setGhost(const ReferencePose &ghost)
{
    if (!ghost.exists && !m_drawing.ghost.exists) {
        return; // without a reference it costs nothing
    }
    const MechanismCanvas on = canvas(size(), palette());
    updateArea(ghostArea(on, m_drawing));
    m_drawing.ghost = ghost;
    updateArea(ghostArea(on, m_drawing));
}

void MechanismView::setGhostReach(const QRectF &reach)
{
    if (reach != m_ghostReach) {
        m_ghostReach = reach;
        changeFrame([this] { m_frame.include(visibleGhostReach()); });
    }
}

void MechanismView::paintMechanism(QPainter &painter, const QSize &size, const QPalette &palette) const
{
    const MechanismCanvas on = canvas(size, palette);
    painter.save();
    painter.setClipRect(QRect(QPoint(0, 0), size), Qt::IntersectClip);
    painter.scale(magnification(), magnification());
    paintGrid(painter, on, m_drawing);
    paintScenery(painter, on, m_drawing);
    paintLinkage(painter, on, m_drawing);
    painter.restore();
}

QPointF MechanismView::toPixels(QPointF model) const
{
    return projection().toPixels(model);
}

/// How many pixels one of the canvas is: links, joints and arrows grow with letters that are larger than usual, as they
/// are in front of a class.
double MechanismView::magnification() const
{
    const int usual = QFontInfo(QApplication::font(this)).pixelSize();
    return std::max(1.0, static_cast<double>(QFontInfo(font()).pixelSize()) / usual);
}

MechanismCanvas MechanismView::canvas(const QSizeF &size, const QPalette &palette) const
{
    const double magnified = magnification();
    QFont letters = font();
    letters.setPixelSize(static_cast<int>(std::lround(QFontInfo(letters).pixelSize() / magnified)));
    MechanismCanvas canvas = canvasOf(m_frame.projection(size / magnified), palette, letters);
    canvas.hairline = 1.0 / magnified;
    return canvas;
}

DrawnPart MechanismView::partUnder(QPointF pixel) const
{
    const double magnified = magnification();
    return partAt(m_drawing, m_frame.projection(QSizeF(size()) / magnified), pixel / magnified);
}

/// Of the mechanism and of what is compared with it.
QRectF MechanismView::reach() const
{
    return characteristicLength(m_drawing.mechanism(), m_drawing.result->limits).united(visibleGhostReach());
}

/// As far as the drawing follows it; null where that would leave too little of the model to be seen.
QRectF MechanismView::visibleGhostReach() const
{
    if (!m_drawing.result) {
        return {};
    }
    constexpr double kMost = 3.0; // times the model's
    const QRectF own = characteristicLength(m_drawing.mechanism(), m_drawing.result->limits);
    const QRectF both = own.united(m_ghostReach);
    const double extent = std::max(own.width(), own.height());
    const bool fits = std::max(both.width(), both.height()) <= kMost * extent; // not so, too, where it is not finite
    return fits ? m_ghostReach : QRectF();
}

void MechanismView::changeFrame(const std::function<void()> &change)
{
    const MechanismProjection before = projection();
    const QRectF fitted = m_frame.fitted();
    change();
    if (m_frame.fitted() != fitted) {
        m_drawing.refreshCycle(m_frame.fitted());
        refreshScenery();
    }
    if (projection() != before) {
        refreshScenery();
    }
}

void MechanismView::refitAtRest()
{
    if (m_hold || QApplication::mouseButtons() != Qt::NoButton) { // maybe on a slider, between two pulls
        m_refitDelay->start();
    } else if (m_drawing.result) {
        changeFrame([this] { m_frame.refit(reach()); });
    }
}

void MechanismView::refreshScenery()
{
    m_grid = QPixmap();
    m_scenery = QPixmap();
    update();
}

void MechanismView::updateArea(const QRectF &area)
{
    const double magnified = magnification();
    update(QRectF(magnified * area.topLeft(), magnified * area.size()).toAlignedRect().intersected(rect()));
}

QRectF MechanismView::movingArea() const
{
    return linkageArea(canvas(size(), palette()), m_drawing);
}

void MechanismView::paintEvent(QPaintEvent *event)
{
    const MechanismCanvas on = canvas(size(), palette());
    const double magnified = magnification();
    const double ratio = devicePixelRatioF();
    if (m_grid.isNull() || m_grid.devicePixelRatio() != ratio) {
        // Rounded up: at a ratio of 1.5 the last half pixel has to be painted too.
        m_grid = QPixmap(static_cast<int>(std::ceil(width() * ratio)), static_cast<int>(std::ceil(height() * ratio)));
        m_grid.setDevicePixelRatio(ratio);
        QPainter painter(&m_grid);
        painter.scale(magnified, magnified);
        paintGrid(painter, on, m_drawing);
        m_scenery = QPixmap();
    }
    if (m_scenery.isNull()) {
        m_scenery = m_grid;
        QPainter painter(&m_scenery);
        painter.scale(magnified, magnified);
        paintScenery(painter, on, m_drawing);
    }
    QPainter painter(this);
    painter.setClipRegion(event->region());
    painter.drawPixmap(0, 0, m_scenery);
    painter.scale(magnified, magnified);
    paintLinkage(painter, on, m_drawing);
    if (m_drawing.result && m_pointed != DrawnPart::Background) {
        paintSceneryHighlight(painter, on, m_drawing, m_pointed);
        paintLinkageHighlight(painter, on, m_drawing, m_pointed);
    }
    if (m_showsFocus) {
        painter.resetTransform();
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(on.highlight, 2.0));
        painter.drawRect(rect().adjusted(1, 1, -1, -1));
    }
}

void MechanismView::resizeEvent(QResizeEvent *event)
{
    refreshScenery();
    QWidget::resizeEvent(event);
}

void MechanismView::changeEvent(QEvent *event)
{
    switch (event->type()) {
    case QEvent::PaletteChange:
    case QEvent::FontChange:
    case QEvent::StyleChange:
    case QEvent::LocaleChange: refreshScenery(); break;
    default: break;
    }
    QWidget::changeEvent(event);
}

void MechanismView::hideEvent(QHideEvent *event)
{
    release();
    QWidget::hideEvent(event);
}

void MechanismView::leaveEvent(QEvent *event)
{
    if (!m_hold) {
        pointAt(DrawnPart::Background, false);
    }
    QWidget::leaveEvent(event);
}

void MechanismView::focusInEvent(QFocusEvent *event)
{
    m_showsFocus = event->reason() == Qt::TabFocusReason || event->reason() == Qt::BacktabFocusReason ||
                   event->reason() == Qt::ShortcutFocusReason;
    update();
    QWidget::focusInEvent(event);
}

void MechanismView::focusOutEvent(QFocusEvent *event)
{
    m_showsFocus = false;
    update();
    QWidget::focusOutEvent(event);
}

void MechanismView::keyPressEvent(QKeyEvent *event)
{
    const bool withControl = event->modifiers().testFlag(Qt::ControlModifier);
    const auto pan = [&](double x, double y) {
        if (withControl) {
            changeFrame([&] { m_frame.pan(kPanStep * QPointF(x, y), size()); });
        } else {
            QWidget::keyPressEvent(event);
        }
    };
    // The keys move what one looks through, so the drawing goes the other way.
    switch (event->key()) {
    case Qt::Key_Left: pan(1.0, 0.0); break;
    case Qt::Key_Right: pan(-1.0, 0.0); break;
    case Qt::Key_Up: pan(0.0, 1.0); break;
    case Qt::Key_Down: pan(0.0, -1.0); break;
    case Qt::Key_PageDown: pointAtNext(1); break;
    case Qt::Key_PageUp: pointAtNext(-1); break;
    case Qt::Key_Return:
    case Qt::Key_Enter: emit enlarged(); break;
    case Qt::Key_Escape:
        if (!m_hold && m_pointed == DrawnPart::Background) {
            QWidget::keyPressEvent(event); // the window may have a use for it
            break;
        }
        cancelDrag();
        pointAt(DrawnPart::Background, false);
        break;
    default: QWidget::keyPressEvent(event); break;
    }
}

void MechanismView::mousePressEvent(QMouseEvent *event)
{
    const bool isLeft = event->button() == Qt::LeftButton;
    if (m_hold || !m_drawing.result || !(isLeft || event->button() == Qt::MiddleButton)) {
        QWidget::mousePressEvent(event);
        return;
    }
    const QPointF pixel = event->position();
    const bool withShift = event->modifiers().testFlag(Qt::ShiftModifier);
    m_hold = Hold{std::nullopt, event->button(), pixel, pixel, false, m_drawing.pose.time};
    if (isLeft) {
        pointAt(partUnder(pixel), withShift);
        m_hold->drag = MechanismDrag::begin(m_drawing, m_pointed, withShift, projection().toModel(pixel));
    }
    if (m_hold->drag && m_hold->drag->length()) {
        emit dragBegan();
    } else if (m_hold->drag) {
        setCursor(Qt::ClosedHandCursor);
    }
}

void MechanismView::mouseMoveEvent(QMouseEvent *event)
{
    const QPointF pixel = event->position();
    if (!m_hold) {
        pointAt(partUnder(pixel), event->modifiers().testFlag(Qt::ShiftModifier));
        return;
    }
    if (!m_hold->moves && (pixel - m_hold->pressed).manhattanLength() < kStillAClick) {
        return;
    }
    m_hold->moves = true;
    const QPointF last = std::exchange(m_hold->last, pixel);
    if (!m_hold->drag) {
        setCursor(Qt::ClosedHandCursor);
        changeFrame([&] { m_frame.pan(pixel - last, size()); });
        return;
    }
    const bool isFree = event->modifiers().testFlag(Qt::ControlModifier);
    const MechanismProjection on = projection();
    constexpr double kGrid = 1.0;      // px: what a hand can hit
    constexpr double kFineGrid = 0.02; // px: so that a length does not end in a dozen digits
    obey(m_hold->drag->moveTo(on.toModel(pixel), nextRoundNumber((isFree ? kFineGrid : kGrid) / on.scale)));
    m_noteDelay->stop();
    updateNote();
}

void MechanismView::mouseReleaseEvent(QMouseEvent *event)
{
    if (!m_hold || event->button() != m_hold->button) {
        QWidget::mouseReleaseEvent(event);
        return;
    }
    const bool isClick = !m_hold->moves && event->button() == Qt::LeftButton;
    release();
    const MotionLimits &limits = m_drawing.result->limits;
    if (isClick && m_pointed == DrawnPart::OuterDeadCentre) {
        goToCrankAngle(limits.outer->theta2);
    } else if (isClick && m_pointed == DrawnPart::InnerDeadCentre) {
        goToCrankAngle(limits.inner->theta2);
    }
    const bool isInside = rect().contains(event->position().toPoint());
    pointAt(isInside ? partUnder(event->position()) : DrawnPart::Background,
            event->modifiers().testFlag(Qt::ShiftModifier));
}

void MechanismView::mouseDoubleClickEvent(QMouseEvent *event)
{
    if (event->button() == Qt::LeftButton && partUnder(event->position()) == DrawnPart::Background) {
        fit();
    } else if (event->button() == Qt::LeftButton) {
        emit enlarged();
    } else {
        mousePressEvent(event);
    }
}

void MechanismView::wheelEvent(QWheelEvent *event)
{
    constexpr double kNotch = 120.0; // as Qt counts
    const double turned = event->angleDelta().y() / kNotch;
    if (turned == 0.0 || m_hold) {
        QWidget::wheelEvent(event);
        return;
    }
    changeFrame([&] { m_frame.zoom(std::pow(kZoomStep, turned), event->position(), size()); });
    event->accept();
}

void MechanismView::goToCrankAngle(double theta2)
{
    emit timeRequested(
        nearestInstantAtCrankAngle(m_drawing.mechanism(), m_drawing.result->sampling, theta2, m_drawing.pose.time));
}

void MechanismView::obey(const DragRequest &request)
{
    if (const auto *crank = std::get_if<CrankAngleRequest>(&request)) {
        goToCrankAngle(crank->theta2);
    } else if (const auto *length = std::get_if<LengthRequest>(&request)) {
        emit lengthRequested(length->parameter, length->length);
    }
}

/// Whatever is held.
void MechanismView::release()
{
    if (!m_hold) {
        return;
    }
    const Hold held = *std::exchange(m_hold, std::nullopt);
    if (held.drag && held.drag->length()) {
        emit dragEnded();
        changeFrame([this] { m_frame.follow(reach()); });
    }
    updateCursor(false);
}

/// As it was before.
void MechanismView::cancelDrag()
{
    if (!m_hold || !m_hold->drag) {
        return;
    }
    const MechanismDrag drag = *m_hold->drag;
    if (drag.length()) {
        emit lengthRequested(*drag.length(), drag.lengthBefore());
    }
    const double time = m_hold->time;
    release();
    if (!drag.length()) {
        emit timeRequested(time);
    }
}

void MechanismView::pointAt(DrawnPart part, bool withShift)
{
    if (part != m_pointed) {
        m_pointed = part;
        m_note->say({});
        if (part == DrawnPart::Background) {
            m_noteDelay->stop();
        } else {
            m_noteDelay->start();
        }
        update();
    }
    updateCursor(withShift);
}

void MechanismView::pointAtNext(int step)
{
    if (!m_drawing.result || m_hold) {
        return;
    }
    pointAt(partAfter(m_drawing, m_pointed, step), false);
    m_noteDelay->stop();
    updateNote();
}

void MechanismView::updateNote()
{
    const bool isNew = m_note->isHidden();
    m_note->say(partText(m_drawing, m_pointed));
    if (isNew && m_drawing.result) {
        const MechanismProjection on = projection();
        QPolygonF points{on.toPixels({0.0, 0.0}), on.toPixels(m_drawing.crankPin())};
        if (m_drawing.pins) {
            points << on.toPixels(m_drawing.pins->B);
        }
        if (underMouse()) {
            points << QPointF(mapFromGlobal(QCursor::pos()));
        }
        m_note->keepAwayFrom(points);
    }
}

void MechanismView::updateCursor(bool withShift)
{
    if (m_hold && m_hold->drag && !m_hold->drag->length()) {
        return; // the closed hand
    }
    if (const std::optional<Qt::CursorShape> cursor = cursorOver(m_drawing, m_pointed, withShift)) {
        setCursor(*cursor);
    } else {
        unsetCursor();
    }
}

} // namespace slidercrank
