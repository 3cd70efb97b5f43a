// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/mechanism/mechanism_view.h"

#include "core/sampling/crank_instant.h"
#include "ui/document/with.h"
#include "ui/mechanism/mechanism_text.h"
#include "ui/text/written_number.h"

#include <QAction>
#include <QApplication>
#include <QFontInfo>
#include <QKeyEvent>
#include <QLabel>
#include <QMouseEvent>
#include <QPainter>
#include <QTimer>
#include <QToolButton>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <utility>

namespace slidercrank
{

namespace
{

constexpr double kZoomStep = 1.25;
constexpr double kPanStep = 40.0;   // px
constexpr double kClickMoves = 3.0; // px that a hand moves during a click
constexpr int kNoteDelay = 250;     // ms: a pointer that only passes by gets no note
constexpr int kRest = 400;          // ms without a change

QTimer *makeTimer(QObject *parent, int milliseconds)
{
    auto *timer = new QTimer(parent);
    timer->setSingleShot(true);
    timer->setInterval(milliseconds);
    return timer;
}

QLabel *makeNote(QWidget *parent)
{
    auto *note = new QLabel(parent);
    note->setObjectName(QStringLiteral("mechanismNote"));
    note->setAttribute(Qt::WA_TransparentForMouseEvents);
    note->setTextFormat(Qt::PlainText);
    note->setWordWrap(true);
    note->setMargin(5);
    note->setFrameShape(QFrame::Box);
    note->setAutoFillBackground(true);
    note->setBackgroundRole(QPalette::Base);
    note->setForegroundRole(QPalette::Text);
    note->hide();
    return note;
}

} // namespace

MechanismView::MechanismView(QWidget *parent)
    : QWidget(parent)
    , m_flip(new QToolButton(this))
    , m_note(makeNote(this))
    , m_noteDelay(makeTimer(this, kNoteDelay))
    , m_refitDelay(makeTimer(this, kRest))
{
    setObjectName(QStringLiteral("mechanismView"));
    setAccessibleName(tr("Mechanism"));
    setAttribute(Qt::WA_OpaquePaintEvent);
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setContextMenuPolicy(Qt::ActionsContextMenu);
    m_refitDelay->setObjectName(QStringLiteral("refitDelay"));
    connect(m_noteDelay, &QTimer::timeout, this, &MechanismView::showNote);
    connect(m_refitDelay, &QTimer::timeout, this, &MechanismView::fitFrame);
    m_flip->setObjectName(QStringLiteral("flipButton"));
    m_flip->setFocusPolicy(Qt::TabFocus);
    m_flip->hide();
    connect(m_flip, &QToolButton::clicked, this, [this] {
        emit branchRequested(m_scene.mechanism().branch() == Branch::Open ? Branch::Crossed : Branch::Open);
    });
    makeChoices();
}

void MechanismView::makeChoices()
{
    const auto addSwitch = [this](const QString &text, const QString &name, bool MechanismSettings::*setting) {
        auto *action = new QAction(text, this);
        action->setObjectName(name);
        action->setCheckable(true);
        connect(action, &QAction::triggered, this,
                [this, setting](bool on) { setSettings(with(m_scene.settings, setting, on)); });
        connect(this, &MechanismView::settingsChanged, action,
                [action, setting](const MechanismSettings &settings) { action->setChecked(settings.*setting); });
        m_choices << action;
    };
    const auto addZoom = [this](const QString &text, const QList<QKeySequence> &keys, const auto &change) {
        auto *action = new QAction(text, this);
        action->setShortcuts(keys);
        action->setShortcutContext(Qt::WidgetShortcut); // elsewhere they are characters to type
        connect(action, &QAction::triggered, this, change);
        m_choices << action;
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
    addZoom(tr("Zoom &in"), {Qt::Key_Plus, Qt::Key_Equal}, [this] { zoomBy(kZoomStep, QRectF(rect()).center()); });
    addZoom(tr("Zoom &out"), {Qt::Key_Minus}, [this] { zoomBy(1.0 / kZoomStep, QRectF(rect()).center()); });
    addZoom(tr("&Fit"), {Qt::Key_0}, [this] { fit(); });
    addActions(m_choices);
}

void MechanismView::setSettings(const MechanismSettings &settings)
{
    if (settings == m_scene.settings) {
        return;
    }
    m_scene.settings = settings;
    emit settingsChanged(settings);
    refresh();
}

void MechanismView::setZoom(const std::optional<QRectF> &zoom)
{
    m_frame.setZoomed(zoom);
    refresh();
}

void MechanismView::fit()
{
    if (m_scene.result) {
        setZoom({});
        fitFrame();
    }
}

void MechanismView::zoomBy(double factor, QPointF pixel)
{
    m_frame.zoom(factor, pixel, size());
    refresh();
}

void MechanismView::setFrame(const MechanismFrame &frame)
{
    m_frame = frame;
    refresh();
}

/// Fits the frame to the mechanism, once nothing is dragged any more, here or on a slider.
void MechanismView::fitFrame()
{
    if (m_hold || QApplication::mouseButtons() != Qt::NoButton) {
        m_refitDelay->start();
    } else if (m_scene.result) {
        m_frame.fit(bounds());
        refresh();
    }
}

/// Everything that stands still is out of date.
void MechanismView::refresh()
{
    constexpr int kInset = 4;
    m_scene.updateCycle();
    m_scenery = QPixmap();
    m_flip->resize(m_flip->sizeHint());
    m_flip->move(width() - m_flip->width() - kInset, kInset);
    update();
}

void MechanismView::setResult(const std::shared_ptr<const Result> &result)
{
    const bool isSame = m_scene.result && result && m_scene.result->mechanism == result->mechanism;
    m_scene.result = result;
    if (isSame || !result) {
        return; // sampling, solver and reference are not drawn here
    }
    const bool pullsLength = m_hold && m_hold->drag && m_hold->drag->length();
    if (m_hold && m_hold->drag && !pullsLength) {
        release(); // another mechanism was grasped
    }
    if (!pullsLength) { // otherwise the part would move away from the pointer
        m_frame.follow(bounds());
    }
    m_refitDelay->start();
    describe();
    refresh();
}

void MechanismView::describe()
{
    const Mechanism &mechanism = m_scene.mechanism();
    const bool isOpen = mechanism.branch() == Branch::Open;
    m_flip->setText(isOpen ? tr("Assembly: open") : tr("Assembly: crossed"));
    m_flip->setToolTip(isOpen ? tr("Flip to the crossed assembly: the same links, with B to the left of A")
                              : tr("Flip to the open assembly: the same links, with B to the right of A"));
    m_flip->show();
    setAccessibleDescription(
        tr("Slider-crank drawn to scale: crank %1 mm, coupler %2 mm, offset %3 mm. The keys of the Playback menu move "
           "it, the sliders and boxes below change its lengths. Plus, minus and 0 zoom, Control with the arrows moves "
           "the drawing, Page Down and Page Up describe its parts one after the other.")
            .arg(numberText(mechanism.a()), numberText(mechanism.b()), numberText(mechanism.c())));
}

void MechanismView::setPose(const Pose &pose)
{
    m_scene.pose = pose;
    if (m_refitDelay->isActive()) {
        m_refitDelay->start();
    }
    if (m_note->isVisible()) {
        showNote();
    }
    update();
}

void MechanismView::setGhost(const ReferencePose &ghost)
{
    if (ghost.exists || m_scene.ghost.exists) {
        m_scene.ghost = ghost;
        update();
    }
}

void MechanismView::setGhostBounds(const QRectF &ghostBounds)
{
    if (ghostBounds != m_ghostBounds) {
        m_ghostBounds = ghostBounds;
        if (m_scene.result) {
            m_frame.follow(bounds());
            refresh();
        }
    }
}

void MechanismView::highlight(MechanismPart part)
{
    static_assert(static_cast<int>(DrawnPart::Drive) == static_cast<int>(MechanismPart::Drive));
    m_highlighted = part == MechanismPart::Drive ? DrawnPart::Crank : static_cast<DrawnPart>(part);
    update();
}

/// Of the mechanism, and of the ghost unless that would make the mechanism too small.
QRectF MechanismView::bounds() const
{
    constexpr double kLargest = 3.0; // times the mechanism
    const QRectF own = motionBounds(m_scene.mechanism(), m_scene.result->limits);
    const QRectF both = own.united(m_ghostBounds);
    const bool fits = std::max(both.width(), both.height()) <= kLargest * std::max(own.width(), own.height());
    return fits ? both : own; // own, too, if the ghost's bounds are not finite
}

QSize MechanismView::pictureSize() const
{
    constexpr int kWidth = 900;
    const QRectF shown = m_frame.zoomed().value_or(m_frame.fitted());
    const double height = shown.isNull() ? 0.5 : shown.height() / shown.width();
    return {kWidth, static_cast<int>(kWidth * std::clamp(height, 0.4, 0.75))};
}

void MechanismView::paintMechanism(QPainter &painter, const QSize &size, const QPalette &palette) const
{
    painter.save();
    painter.setClipRect(QRect(QPoint(0, 0), size), Qt::IntersectClip);
    painter.scale(magnification(), magnification());
    sketch(size, palette, true, true).paint(painter);
    painter.restore();
}

/// Links, joints and arrows grow with letters that are larger than usual, as in presentation mode.
double MechanismView::magnification() const
{
    const int usual = QFontInfo(QApplication::font(this)).pixelSize();
    return std::max(1.0, static_cast<double>(QFontInfo(font()).pixelSize()) / usual);
}

MechanismSketch MechanismView::sketch(const QSizeF &size, const QPalette &palette, bool withScenery,
                                      bool withLinkage) const
{
    const double magnified = magnification();
    QFont letters = font();
    letters.setPixelSize(static_cast<int>(std::lround(QFontInfo(letters).pixelSize() / magnified)));
    MechanismSketch sketch(m_scene, m_frame.projection(size / magnified), palette, letters);
    if (withScenery) {
        sketch.addScenery();
    }
    if (withLinkage) {
        sketch.addLinkage();
    }
    return sketch;
}

DrawnPart MechanismView::partUnder(QPointF pixel) const
{
    return wholeSketch().partAt(pixel / magnification());
}

void MechanismView::paintEvent(QPaintEvent *)
{
    const double magnified = magnification();
    const double ratio = devicePixelRatioF();
    if (m_scenery.isNull() || m_scenery.devicePixelRatio() != ratio) {
        // Rounded up: at a ratio of 1.5 the last half pixel has to be painted, too.
        m_scenery =
            QPixmap(static_cast<int>(std::ceil(width() * ratio)), static_cast<int>(std::ceil(height() * ratio)));
        m_scenery.setDevicePixelRatio(ratio);
        m_scenery.fill(palette().color(QPalette::Base)); // the last half pixel is only half covered below
        QPainter painter(&m_scenery);
        painter.scale(magnified, magnified);
        sketch(size(), palette(), true, false).paint(painter);
    }
    QPainter painter(this);
    painter.drawPixmap(0, 0, m_scenery);
    painter.scale(magnified, magnified);
    sketch(size(), palette(), false, true).paint(painter);
    const QColor colour = palette().color(QPalette::Highlight);
    if (m_pointed != DrawnPart::Background || m_highlighted != DrawnPart::Background) {
        const MechanismSketch whole = wholeSketch();
        whole.paintHighlight(painter, m_pointed, colour);
        whole.paintHighlight(painter, m_highlighted, whole.colours().error);
    }
    if (hasFocus() && window()->testAttribute(Qt::WA_KeyboardFocusChange)) {
        painter.resetTransform();
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(colour, 2.0));
        painter.drawRect(rect().adjusted(1, 1, -1, -1));
    }
}

bool MechanismView::event(QEvent *event)
{
    switch (event->type()) {
    case QEvent::Resize:
    case QEvent::PaletteChange:
    case QEvent::FontChange:
    case QEvent::StyleChange:
    case QEvent::LocaleChange: refresh(); break;
    case QEvent::Hide: release(); break;
    case QEvent::Leave:
        if (!m_hold) {
            pointAt(DrawnPart::Background, false);
        }
        break;
    default: break;
    }
    return QWidget::event(event);
}

void MechanismView::keyPressEvent(QKeyEvent *event)
{
    const auto pan = [&](double x, double y) { // the keys move the frame, so the drawing goes the other way
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
    case Qt::Key_Enter: emit enlarged(); break;
    case Qt::Key_Escape:
        if (!m_hold && m_pointed == DrawnPart::Background) {
            QWidget::keyPressEvent(event); // for the window
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
    if (m_hold || !m_scene.result || !(isLeft || event->button() == Qt::MiddleButton)) {
        QWidget::mousePressEvent(event);
        return;
    }
    const QPointF pixel = event->position();
    const bool withShift = event->modifiers().testFlag(Qt::ShiftModifier);
    m_hold = Hold{std::nullopt, event->button(), pixel, pixel, false, m_scene.pose.time};
    if (isLeft) {
        pointAt(partUnder(pixel), withShift);
        m_hold->drag = MechanismDrag::begin(m_scene, m_pointed, withShift, projection().toModel(pixel));
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
    if (!m_hold->moves && (pixel - m_hold->pressed).manhattanLength() < kClickMoves) {
        return;
    }
    m_hold->moves = true;
    const QPointF last = std::exchange(m_hold->last, pixel);
    if (!m_hold->drag) {
        setCursor(Qt::ClosedHandCursor);
        m_frame.pan(pixel - last, size());
        refresh();
        return;
    }
    const QPointF pointer = projection().toModel(pixel);
    if (const std::optional<Parameter> length = m_hold->drag->length()) {
        // Lengths are round numbers: one pixel apart, with Control much less.
        const double pixels = event->modifiers().testFlag(Qt::ControlModifier) ? 0.02 : 1.0;
        emit lengthRequested(*length, m_hold->drag->lengthAt(pointer, nextRoundNumber(pixels / projection().scale)));
    } else {
        goToCrankAngle(m_hold->drag->crankAngleAt(pointer));
    }
    m_noteDelay->stop();
    showNote();
}

void MechanismView::mouseReleaseEvent(QMouseEvent *event)
{
    if (!m_hold || event->button() != m_hold->button) {
        QWidget::mouseReleaseEvent(event);
        return;
    }
    const bool isClick = !m_hold->moves && event->button() == Qt::LeftButton;
    release();
    const MotionLimits &limits = m_scene.result->limits;
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
    if (event->button() != Qt::LeftButton) {
        mousePressEvent(event);
    } else if (partUnder(event->position()) == DrawnPart::Background) {
        fit();
    } else {
        emit enlarged();
    }
}

void MechanismView::wheelEvent(QWheelEvent *event)
{
    constexpr double kNotch = 120.0; // Qt's unit
    const double notches = event->angleDelta().y() / kNotch;
    if (notches == 0.0 || m_hold) {
        QWidget::wheelEvent(event);
        return;
    }
    zoomBy(std::pow(kZoomStep, notches), event->position());
    event->accept();
}

void MechanismView::goToCrankAngle(double theta2)
{
    emit timeRequested(
        nearestInstantAtCrankAngle(m_scene.mechanism(), m_scene.result->sampling, theta2, m_scene.pose.time));
}

void MechanismView::release()
{
    if (!m_hold) {
        return;
    }
    const Hold held = *std::exchange(m_hold, std::nullopt);
    if (held.drag && held.drag->length()) {
        emit dragEnded();
        m_frame.follow(bounds());
        refresh();
    }
    unsetCursor();
}

/// Takes the drag back.
void MechanismView::cancelDrag()
{
    if (!m_hold || !m_hold->drag) {
        return;
    }
    const Hold held = *m_hold;
    if (const std::optional<Parameter> length = held.drag->length()) {
        emit lengthRequested(*length, held.drag->lengthBefore());
    }
    release();
    if (!held.drag->length()) {
        emit timeRequested(held.time);
    }
}

void MechanismView::pointAt(DrawnPart part, bool withShift)
{
    if (part != m_pointed) {
        m_pointed = part;
        m_note->hide();
        m_noteDelay->start();
        update();
    }
    setCursor(m_scene.result ? cursorOver(m_scene, part, withShift) : Qt::ArrowCursor);
}

void MechanismView::pointAtNext(std::ptrdiff_t step)
{
    if (!m_scene.result || m_hold) {
        return;
    }
    const std::set<DrawnPart> drawn = wholeSketch().parts();
    std::vector<DrawnPart> parts(drawn.begin(), drawn.end());
    parts.insert(parts.begin(), DrawnPart::Background);
    const auto count = static_cast<std::ptrdiff_t>(parts.size());
    const std::ptrdiff_t now = std::ranges::find(parts, m_pointed) - parts.begin();
    pointAt(parts[static_cast<std::size_t>((now + step + count) % count)], false);
    m_noteDelay->stop();
    showNote();
}

/// In the corner away from the crank and the slider's line. Where the mechanism cannot be assembled, the drawing says
/// there why.
void MechanismView::showNote()
{
    constexpr int kInset = 6;
    constexpr int kWidest = 330;
    const QString text = m_scene.pose.exists() ? partText(m_scene, m_pointed) : QString();
    m_note->setVisible(!text.isEmpty());
    if (text.isEmpty()) {
        return;
    }
    m_note->setText(text);
    const int widest = std::min(kWidest, width() - 2 * kInset);
    QRect box(0, 0, widest, m_note->heightForWidth(widest));
    const Mechanism &mechanism = m_scene.mechanism();
    box.moveLeft(mechanism.branch() == Branch::Open ? width() - kInset - widest : kInset);
    box.moveTop(mechanism.c() < 0.0 ? kInset : height() - kInset - box.height());
    m_note->setGeometry(box);
}

} // namespace slidercrank
