// SPDX-License-Identifier: GPL-3.0-or-later

// What the view shows. mechanism_mouse.cpp contains what the mouse and the keyboard do.

#include "ui/mechanism/mechanism_view.h"

#include "ui/document/setting_action.h"
#include "ui/mechanism/mechanism_text.h"
#include "ui/text/motion_facts.h"
#include "ui/text/notation.h"

#include <QApplication>
#include <QFontInfo>
#include <QFontMetricsF>
#include <QLabel>
#include <QPainter>
#include <QTimer>
#include <QToolButton>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace slidercrank
{

namespace
{

constexpr int kNoteDelay = 250;  // ms, so that no note appears while the pointer only passes over a part
constexpr int kRefitDelay = 400; // ms without a change
constexpr int kInset = 5;        // px, between the edge of the view and what lies over the drawing

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
    note->setObjectName("mechanismNote");
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

DrawnPart drawnPart(MechanismPart part)
{
    switch (part) {
    case MechanismPart::None: return DrawnPart::Background;
    case MechanismPart::Ground: return DrawnPart::Ground;
    case MechanismPart::Crank:
    case MechanismPart::Drive: return DrawnPart::Crank; // the drive is not drawn
    case MechanismPart::Coupler: return DrawnPart::Coupler;
    case MechanismPart::Slider: return DrawnPart::Slider;
    case MechanismPart::Pivot: return DrawnPart::O2;
    case MechanismPart::PinA: return DrawnPart::A;
    case MechanismPart::PinB: return DrawnPart::B;
    case MechanismPart::Guide: return DrawnPart::Guide;
    }
    return DrawnPart::Background;
}

/// Returns the area (mm) in which the vertex of the coupler's angle moves if that angle is drawn and obtuse, otherwise
/// nullopt: θ³ at A is acute on the open branch, θ₃ at B on the crossed one.
std::optional<QRectF> areaOfObtuseAngleVertex(const MechanismScene &scene)
{
    const Mechanism &mechanism = scene.mechanism();
    const bool isAtB = notation().symbols == Symbols::Textbook;
    const bool isObtuse = isAtB == (mechanism.branch() == Branch::Open);
    if (!scene.settings.angles || !isObtuse) {
        return std::nullopt;
    }
    const double a = mechanism.a();
    if (!isAtB) {
        return QRectF(-a, -a, 2.0 * a, 2.0 * a);
    }
    const auto [left, right] = sliderTravel(mechanism, scene.result->limits);
    return QRectF(left, mechanism.c(), right - left, 0.0);
}

/// Returns the projection of a picture. It shows the frame and, unless the user has zoomed, also the slider, below its
/// line the rail, the names of the dead centres and the numbers of the grid, and the arc of an obtuse angle.
MechanismProjection pictureProjection(const MechanismScene &scene, const MechanismFrame &frame, const QSizeF &size,
                                      const QFont &font)
{
    constexpr double kRailHeight = 22.0; // px
    constexpr int kIterations = 3;       // the space in mm depends on the scale, and the scale on the space
    MechanismProjection projection = frame.projection(size);
    if (!scene.result || frame.zoomed() || frame.fitted().isNull()) {
        return projection;
    }
    const double pixelsBelow = kRailHeight + 2.0 * QFontMetricsF(font).height();
    const std::optional<QRectF> vertex = areaOfObtuseAngleVertex(scene);
    const auto [left, right] = sliderTravel(scene.result->mechanism, scene.result->limits);
    const QRectF travel(left, scene.result->mechanism.c(), right - left, 0.0);
    MechanismFrame enlarged = frame;
    for (int i = 0; i < kIterations; ++i) {
        const double lowest = scene.result->mechanism.c() - pixelsBelow / projection.scale;
        QRectF visibleArea = frame.fitted();
        visibleArea.setTop(std::min(visibleArea.top(), lowest)); // y points upwards
        constexpr double kAroundSlider = 2.0;                    // px
        const QSizeF slider =
            (0.5 * MechanismSketch::kSliderSize + QSizeF(kAroundSlider, kAroundSlider)) / projection.scale;
        visibleArea =
            visibleArea.united(travel.adjusted(-slider.width(), -slider.height(), slider.width(), slider.height()));
        if (vertex) {
            constexpr double kAroundArc = 10.0; // px, for the line from which the angle is measured
            const double around = (MechanismSketch::kLargestCouplerArc + kAroundArc) / projection.scale;
            visibleArea = visibleArea.united(vertex->adjusted(-around, -around, around, around));
        }
        enlarged.setZoomed(visibleArea);
        projection = enlarged.projection(size);
    }
    return projection;
}

/// Paints the mechanism with its legend below the drawing.
void paintPicture(QPainter &painter, const QSize &size, const MechanismScene &scene, const MechanismFrame &frame,
                  const QPalette &palette)
{
    const QFont font = painter.font();
    const auto newPicture = [&](const QSizeF &part) {
        return MechanismSketch(scene, pictureProjection(scene, frame, part, font), palette, font,
                               MechanismSketch::Legend::Separate);
    };
    MechanismSketch legend = newPicture(size);
    legend.addLegend();
    const QSizeF drawing(size.width(), size.height() - legend.legendHeight());
    MechanismSketch scenery = newPicture(drawing);
    scenery.addScenery();
    // The linkage is a sketch of its own, whose labels may cover labels of the scenery, as in the window.
    MechanismSketch linkage = newPicture(drawing);
    linkage.addLinkage();
    painter.save();
    painter.setClipRect(QRect(QPoint(), size), Qt::IntersectClip);
    painter.fillRect(QRect(QPoint(), size), scenery.colours().background);
    painter.translate(0.0, drawing.height());
    legend.paint(painter);
    painter.translate(0.0, -drawing.height());
    painter.setClipRect(QRectF(QPointF(), drawing), Qt::IntersectClip);
    scenery.paint(painter);
    linkage.paint(painter);
    if (!scene.settings.angles) {       // otherwise θ₂ is written beside the crank
        constexpr double kMargin = 6.0; // px
        painter.setFont(font);
        painter.setPen(palette.color(QPalette::Text));
        painter.drawText(QPointF(kMargin, kMargin + QFontMetricsF(font).ascent()),
                         QStringLiteral("θ₂ = %1").arg(crankAngleWithUnit(scene.pose.motion.theta2)));
    }
    painter.restore();
}

} // namespace

MechanismView::MechanismView(QWidget *parent)
    : QWidget(parent)
    , m_scenery(newSketch(size(), palette()))
    , m_flipButton(new QToolButton(this))
    , m_note(makeNote(this))
    , m_noteDelay(makeTimer(this, kNoteDelay))
    , m_refitDelay(makeTimer(this, kRefitDelay))
{
    setObjectName("mechanismView");
    setAccessibleName(tr("Mechanism"));
    setAttribute(Qt::WA_OpaquePaintEvent);
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setContextMenuPolicy(Qt::ActionsContextMenu);
    m_refitDelay->setObjectName("refitDelay");
    connect(m_noteDelay, &QTimer::timeout, this, &MechanismView::showNote);
    connect(m_refitDelay, &QTimer::timeout, this, &MechanismView::fitFrame);
    m_flipButton->setObjectName("flipButton");
    m_flipButton->setFocusPolicy(Qt::TabFocus);
    m_flipButton->hide();
    connect(m_flipButton, &QToolButton::clicked, this, [this] {
        emit branchRequested(m_scene.mechanism().branch() == Branch::Open ? Branch::Crossed : Branch::Open);
    });
    makeChoices();
}

void MechanismView::makeChoices()
{
    const auto addSwitch = [this](const QString &text, const QString &name, bool MechanismSettings::*setting) {
        m_choices << makeSwitchAction(this, text, setting);
        m_choices.back()->setObjectName(name);
    };
    const auto addZoom = [this](const QString &text, const QList<QKeySequence> &keys, const auto &change) {
        auto *action = new QAction(text, this);
        action->setShortcuts(keys);
        action->setShortcutContext(Qt::WidgetShortcut); // in other widgets the keys type characters
        connect(action, &QAction::triggered, this, change);
        m_choices << action;
    };
    addSwitch(tr("&Velocity arrows"), "showVelocity", &MechanismSettings::velocity);
    addSwitch(tr("&Acceleration arrows"), "showAcceleration", &MechanismSettings::acceleration);
    addSwitch(tr("&Path of the coupler's centre"), "showPath", &MechanismSettings::path);
    addSwitch(tr("&Names of the points"), "showNames", &MechanismSettings::names);
    addSwitch(tr("&Dimensions"), "showDimensions", &MechanismSettings::dimensions);
    addSwitch(tr("An&gles of crank and coupler"), "showAngles", &MechanismSettings::angles);
    addSwitch(tr("Instant &centre of the coupler"), "showInstantCentre", &MechanismSettings::instantCentre);
    m_choices << new QAction(this);
    m_choices.back()->setSeparator(true);
    constexpr double kOneStep = 1.0;
    addZoom(tr("Zoom &in"), {Qt::Key_Plus, Qt::Key_Equal}, [this] { zoomBy(kOneStep, QRectF(rect()).center()); });
    addZoom(tr("Zoom &out"), {Qt::Key_Minus}, [this] { zoomBy(-kOneStep, QRectF(rect()).center()); });
    addZoom(tr("&Fit"), {Qt::Key_0}, [this] { fit(); });
    addActions(m_choices);
}

void MechanismView::setSettings(const MechanismSettings &settings)
{
    if (settings != m_scene.settings) {
        m_scene.settings = settings;
        emit settingsChanged(settings);
        refresh();
    }
}

void MechanismView::setZoom(const std::optional<QRectF> &zoom)
{
    m_frame.setZoomed(zoom);
    refresh();
}

void MechanismView::fit()
{
    setZoom({});
    fitFrame();
}

void MechanismView::zoomBy(double steps, QPointF pixel)
{
    constexpr double kStep = 1.25;
    m_frame.zoom(std::pow(kStep, steps), pixel, size());
    refresh();
}

void MechanismView::setFrame(const MechanismFrame &frame)
{
    m_frame = frame;
    refresh();
}

/// Fits the frame to the mechanism. Waits while the mouse drags anything, here or on a slider.
void MechanismView::fitFrame()
{
    if (m_pressed || QApplication::mouseButtons() != Qt::NoButton) {
        m_refitDelay->start();
    } else if (m_scene.result) {
        m_frame.fit(bounds());
        refresh();
    }
}

void MechanismView::setResult(const std::shared_ptr<const Result> &result)
{
    const bool isSameDrawing = m_scene.result && result && m_scene.result->mechanism == result->mechanism &&
                               m_scene.result->choices.alpha2 == result->choices.alpha2;
    m_scene.result = result;
    if (isSameDrawing || !result) {
        return; // the drawing does not depend on sampling, solver and reference
    }
    const bool dragsLength = m_pressed && m_pressed->drag && m_pressed->drag->length();
    if (m_pressed && m_pressed->drag && !dragsLength) {
        endDrag(); // the drag began on a different mechanism
    }
    if (!dragsLength) { // otherwise the part would move away from the pointer
        m_frame.follow(bounds());
    }
    m_refitDelay->start();
    updateTexts();
    refresh();
}

void MechanismView::refreshNotation()
{
    updateTexts();
    refresh();
}

void MechanismView::updateTexts()
{
    const Mechanism &mechanism = m_scene.mechanism();
    const bool isOpen = mechanism.branch() == Branch::Open;
    m_flipButton->setText(isOpen ? tr("Assembly: open") : tr("Assembly: crossed"));
    m_flipButton->setToolTip(isOpen ? tr("Flip to the crossed assembly: the same links, with B to the left of A")
                                    : tr("Flip to the open assembly: the same links, with B to the right of A"));
    m_flipButton->show();
    setAccessibleDescription(
        tr("Slider-crank drawn to scale: crank %1, coupler %2, offset %3. The keys of the Playback menu move "
           "it, the sliders and boxes below change its lengths. Plus, minus and 0 zoom, Control with the arrows moves "
           "the drawing, Page Down and Page Up describe its parts one after the other.")
            .arg(lengthText(mechanism.a()), lengthText(mechanism.b()), lengthText(mechanism.c())));
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
    m_scene.ghost = ghost;
    update();
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

void MechanismView::setMarkedPose(const ReferencePose &pose)
{
    m_scene.markedPose = pose;
    update();
}

void MechanismView::highlight(MechanismPart part)
{
    m_highlightedPart = drawnPart(part);
    update();
}

/// Returns the bounds of the mechanism, with those of the ghost unless they would make the mechanism too small.
QRectF MechanismView::bounds() const
{
    constexpr double kMaxGhostRatio = 3.0; // times the mechanism
    const QRectF mechanismBounds = motionBounds(m_scene.mechanism(), m_scene.result->limits);
    const QRectF commonBounds = mechanismBounds.united(m_ghostBounds);
    const bool fits = std::max(commonBounds.width(), commonBounds.height()) <=
                      kMaxGhostRatio * std::max(mechanismBounds.width(), mechanismBounds.height());
    return fits ? commonBounds : mechanismBounds; // also if the ghost's bounds are not finite
}

/// Returns the factor by which letters, links, joints and arrows are larger than usual, as in presentation mode.
double MechanismView::magnification() const
{
    const int usual = QFontInfo(QApplication::font(this)).pixelSize();
    return std::max(1.0, static_cast<double>(QFontInfo(font()).pixelSize()) / usual);
}

/// Returns an empty sketch for a drawing of that size (px), which is to be painted larger by the factor
/// magnification().
MechanismSketch MechanismView::newSketch(const QSizeF &size, const QPalette &palette) const
{
    const double magnified = magnification();
    QFont letters = font();
    letters.setPixelSize(static_cast<int>(std::lround(QFontInfo(letters).pixelSize() / magnified)));
    return {m_scene, m_frame.projection(size / magnified), palette, letters};
}

void MechanismView::refresh()
{
    m_scenery = newSketch(size(), palette());
    m_scenery.addScenery();
    m_isSceneryNew = true;
    m_sceneryPicture = QPixmap();
    m_flipButton->resize(m_flipButton->sizeHint());
    m_flipButton->move(width() - m_flipButton->width() - kInset, m_scene.result ? flipButtonTop() : kInset);
    const QRectF button(m_flipButton->geometry());
    m_scene.button = QRectF(button.topLeft() / magnification(), button.size() / magnification());
    update();
}

/// Returns the top (px) of the button, where it never hides the slider: at the upper edge, or above the numbers of the
/// grid.
int MechanismView::flipButtonTop() const
{
    constexpr int kAroundLine = 40; // px, the slider and its mark
    const double line = toPixels({0.0, m_scene.mechanism().c()}).y();
    const int lowest = height() - m_flipButton->height() - fontMetrics().height() - kInset;
    return line - kAroundLine < kInset + m_flipButton->height() ? std::max(kInset, lowest) : kInset;
}

/// Returns the parts that move, in the current pose.
MechanismSketch MechanismView::linkage() const
{
    MechanismSketch sketch = newSketch(size(), palette());
    sketch.addLinkage();
    return sketch;
}

void MechanismView::paintScenery(QPainter &painter) const
{
    painter.fillRect(rect().adjusted(0, 0, 1, 1),
                     m_scenery.colours().background); // also a last, partly covered device pixel
    painter.scale(magnification(), magnification());
    m_scenery.paint(painter);
}

void MechanismView::paintEvent(QPaintEvent *)
{
    const double ratio = devicePixelRatioF();
    QPainter painter(this);
    if (std::exchange(m_isSceneryNew, false)) { // storing a picture is worth it only from the second time on
        paintScenery(painter);
    } else {
        if (m_sceneryPicture.isNull() || m_sceneryPicture.devicePixelRatio() != ratio) {
            // At a ratio such as 1.5 the view may end in the middle of a device pixel: one more covers it.
            m_sceneryPicture = QPixmap((size() + QSize(1, 1)) * ratio);
            m_sceneryPicture.setDevicePixelRatio(ratio);
            QPainter picturePainter(&m_sceneryPicture);
            paintScenery(picturePainter);
        }
        painter.drawPixmap(0, 0, m_sceneryPicture);
        painter.scale(magnification(), magnification());
    }
    MechanismSketch linkage = this->linkage();
    linkage.paint(painter);
    const QColor colour = palette().color(QPalette::Highlight);
    for (const MechanismSketch *sketch : {&m_scenery, &linkage}) {
        sketch->paintHighlight(painter, m_pointedPart, colour);
        sketch->paintHighlight(painter, m_highlightedPart, sketch->colours().highlight);
    }
    if (hasFocus() && window()->testAttribute(Qt::WA_KeyboardFocusChange)) {
        constexpr double kFocusFrame = 2.0; // px
        painter.resetTransform();
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(colour, kFocusFrame));
        painter.drawRect(rect().adjusted(1, 1, -1, -1));
    }
}

void MechanismView::paintMechanism(QPainter &painter, const QSize &size, const QPalette &palette) const
{
    picture(palette)(painter, size);
}

std::function<void(QPainter &, const QSize &)> MechanismView::picture(const QPalette &palette) const
{
    MechanismScene scene = m_scene;
    scene.button = QRectF();
    return [scene, frame = m_frame, palette](QPainter &painter, const QSize &size) {
        paintPicture(painter, size, scene, frame, palette);
    };
}

int MechanismView::pictureHeight(int width) const
{
    const QRectF visibleArea = m_frame.zoomed().value_or(m_frame.fitted());
    constexpr double kUsualAspect = 0.5; // height over width, if there is no frame yet
    constexpr double kMinAspect = 0.4;
    constexpr double kMaxAspect = 0.75;
    const double aspect = visibleArea.isNull() ? kUsualAspect : visibleArea.height() / visibleArea.width();
    return static_cast<int>(width * std::clamp(aspect, kMinAspect, kMaxAspect));
}

/// Shows the note about the part under the pointer. Where the mechanism cannot be assembled, the drawing shows the
/// reason instead.
void MechanismView::showNote()
{
    constexpr int kMaxWidth = 330; // px
    const QString text = m_scene.pose.exists() ? partText(m_scene, m_pointedPart) : QString();
    m_note->setVisible(!text.isEmpty());
    if (text.isEmpty()) {
        return;
    }
    m_note->setText(text);
    const int noteWidth = std::min(kMaxWidth, width() - 2 * kInset);
    const QRectF inside = QRectF(rect()).adjusted(kInset, kInset, -kInset, -kInset);
    const QSizeF noteSize(noteWidth, m_note->heightForWidth(noteWidth));
    const QRectF button = m_flipButton->geometry().adjusted(-kInset, -kInset, kInset, kInset);
    m_note->setGeometry(m_scene.inFreeCorner(inside, noteSize, button).toRect());
}

} // namespace slidercrank

#include "moc_mechanism_view.cpp"
