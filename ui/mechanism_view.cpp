// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/mechanism_view.h"

#include "core/mobility.h"
#include "ui/number_box.h"
#include "ui/theme.h"

#include <QFontInfo>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace slidercrank
{

namespace
{

constexpr double kTurn = 2.0 * std::numbers::pi;

// Sizes in pixels: parts must stay visible and graspable whatever the mechanism's size.
constexpr double kCrankWidth = 10.5;
constexpr double kCouplerWidth = 8.0;
constexpr double kJointRadius = 6.0; ///< covers the ends of the links
constexpr double kBlockHalfWidth = 19.0;
constexpr double kBlockHalfHeight = 12.0;
constexpr double kGhostWidth = 2.0;
constexpr double kGhostJointRadius = 2.5;
constexpr double kHatchLength = 7.0;
constexpr double kHatchSpacing = 7.0;
constexpr double kGrasp = 18.0;      ///< how far from A a press still takes hold of it
constexpr double kAroundPins = 42.0; ///< what is drawn around a pin reaches no farther: slider, name

QColor mixed(const QColor &colour, const QColor &background, double share)
{
    const auto blend = [share](int x, int y) { return static_cast<int>(std::lround(share * x + (1.0 - share) * y)); };
    return QColor(blend(colour.red(), background.red()), blend(colour.green(), background.green()),
                  blend(colour.blue(), background.blue()));
}

/// Everywhere that the pins A and B can be, mm; y upwards. Empty rectangles do not occur: the crank has a length.
QRectF reachOf(const Result &result)
{
    const double a = result.mechanism.a();
    const double c = result.mechanism.c();
    double left = -a;
    double right = a;
    // At the ends of a rocker's arc the slider is at a cos θ2, so within the crank circle's width.
    for (const std::optional<DeadCentre> &centre : {result.limits.outer, result.limits.inner}) {
        if (centre) {
            left = std::min(left, centre->R4x);
            right = std::max(right, centre->R4x);
        }
    }
    return QRectF(QPointF(left, std::min(-a, c)), QPointF(right, std::max(a, c)));
}

/// The reach with room around it, its edges on round numbers.
QRectF frameAround(const QRectF &reach, double room)
{
    const double extent = std::max(reach.width(), reach.height());
    const double step = nextRoundNumber(extent / 20.0);
    const double margin = room * extent;
    const auto down = [step](double x) { return std::floor(x / step) * step; };
    const auto up = [step](double x) { return std::ceil(x / step) * step; };
    return QRectF(QPointF(down(reach.left() - margin), down(reach.top() - margin)),
                  QPointF(up(reach.right() + margin), up(reach.bottom() + margin)));
}

/// Short strokes below a line of ground that ends at both points.
void paintGround(QPainter &painter, QPointF from, QPointF to)
{
    painter.drawLine(from, to);
    const double length = to.x() - from.x();
    const int strokes = static_cast<int>(std::min(2000.0, std::floor(length / kHatchSpacing)));
    for (int i = 0; i < strokes; ++i) {
        const QPointF top(from.x() + (i + 1) * kHatchSpacing, from.y());
        painter.drawLine(top, top + QPointF(-kHatchLength, kHatchLength));
    }
}

void paintLink(QPainter &painter, QPointF from, QPointF to, double width, const QColor &edge, const QColor &fill)
{
    // Flat ends, which the joints cover: round ones would double the time of a frame.
    painter.setPen(QPen(edge, width, Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(from, to);
    painter.setPen(QPen(fill, width - 3.0, Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(from, to);
}

QPointF unitVector(QPointF vector)
{
    const double length = std::hypot(vector.x(), vector.y());
    return length > 0.0 ? vector / length : QPointF(0.0, -1.0);
}

void paintJoint(QPainter &painter, QPointF at, const QColor &edge, const QColor &fill)
{
    painter.setPen(QPen(edge, 1.6));
    painter.setBrush(fill);
    painter.drawEllipse(at, kJointRadius, kJointRadius);
}

} // namespace

/// Where model points go, and in which colours and font.
struct MechanismView::Canvas {
    QSizeF size;
    double scale = 1.0; ///< pixels a mm
    QPointF origin;     ///< pixels
    SeriesColours colours;
    QColor muted;
    QFont font;

    QPointF operator()(QPointF model) const { return {origin.x() + scale * model.x(), origin.y() - scale * model.y()}; }
    QPointF toModel(QPointF pixel) const
    {
        return {(pixel.x() - origin.x()) / scale, (origin.y() - pixel.y()) / scale};
    }
};

MechanismView::MechanismView(QWidget *parent)
    : QWidget(parent)
{
    setObjectName(QStringLiteral("mechanismView"));
    setAccessibleName(tr("Mechanism"));
    setAttribute(Qt::WA_OpaquePaintEvent);
    setMouseTracking(true); // for the hand over A
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

QSize MechanismView::sizeHint() const
{
    return {440, 340};
}

QSize MechanismView::minimumSizeHint() const
{
    return {200, 140};
}

void MechanismView::setResult(const std::shared_ptr<const Result> &result)
{
    const bool sameScene = m_result && result && m_result->mechanism == result->mechanism;
    m_result = result;
    if (sameScene) {
        return; // only sampling, solver or reference changed: none of it is drawn here
    }
    const QRectF frame = m_frame;
    fitFrame();
    if (m_frame != frame || m_grid.isNull()) {
        refreshScenery();
    } else {
        m_scenery = QPixmap();
        update();
    }
    if (m_result) {
        setAccessibleDescription(
            tr("Slider-crank drawn to scale: crank %1 mm, coupler %2 mm, offset %3 mm. Drag the crank "
               "pin A to move through time.")
                .arg(numberText(m_result->mechanism.a()), numberText(m_result->mechanism.b()),
                     numberText(m_result->mechanism.c())));
    }
}

void MechanismView::setPose(const Pose &pose)
{
    const bool existed = m_pose.exists();
    const QRect before = poseArea();
    m_pose = pose;
    if (pose.exists() && m_result) {
        m_pins = Pins{{pose.pinX, pose.pinY}, {pose.sliderX, m_result->mechanism.c()}};
    }
    if (existed && pose.exists()) {
        update(before.united(poseArea()));
    } else {
        update();
    }
}

void MechanismView::setGhost(const ReferencePose &ghost)
{
    if (!ghost.exists && !m_ghost.exists) {
        return; // without a reference it costs nothing
    }
    update(ghostArea());
    m_ghost = ghost;
    update(ghostArea());
}

void MechanismView::paintMechanism(QPainter &painter, const QSize &size, const QPalette &palette) const
{
    const Canvas on = canvas(size, palette);
    painter.save();
    painter.setClipRect(QRect(QPoint(0, 0), size), Qt::IntersectClip);
    paintGrid(painter, on);
    paintScenery(painter, on);
    paintPose(painter, on);
    painter.restore();
}

QPointF MechanismView::toPixels(QPointF model) const
{
    return canvas(size(), palette())(model);
}

MechanismView::Canvas MechanismView::canvas(const QSizeF &size, const QPalette &palette) const
{
    const QRectF frame = m_frame.isNull() ? QRectF(-1.0, -1.0, 2.0, 2.0) : m_frame;
    Canvas canvas;
    canvas.size = size;
    canvas.scale = std::min(std::max(1.0, size.width()) / frame.width(), std::max(1.0, size.height()) / frame.height());
    canvas.origin = QPointF(0.5 * size.width() - canvas.scale * frame.center().x(),
                            0.5 * size.height() + canvas.scale * frame.center().y());
    canvas.colours = seriesColours(palette);
    canvas.muted = mixed(canvas.colours.text, canvas.colours.background, 0.6);
    canvas.font = font();
    // In pixels, so that text has the same size beside the drawing on every device.
    canvas.font.setPixelSize(QFontInfo(font()).pixelSize());
    return canvas;
}

void MechanismView::fitFrame()
{
    if (!m_result) {
        return;
    }
    constexpr double kRoom = 0.08;       // beside what moves, for slider and names
    constexpr double kRoomToGrow = 0.22; // ... when it has just outgrown the frame: it will grow on
    constexpr double kLeastRoom = 0.03;
    constexpr double kMuchTooLarge = 0.65;
    const QRectF reach = reachOf(*m_result);
    const double least = kLeastRoom * std::max(reach.width(), reach.height());
    const QRectF needed = reach.adjusted(-least, -least, least, least);
    const QRectF wanted = frameAround(reach, kRoom);
    if (m_frame.isNull() || wanted.width() < kMuchTooLarge * m_frame.width() ||
        wanted.height() < kMuchTooLarge * m_frame.height()) {
        m_frame = wanted;
    } else if (!m_frame.contains(needed)) {
        const QRectF grown = frameAround(reach, kRoomToGrow);
        m_frame = QRectF(QPointF(needed.left() < m_frame.left() ? grown.left() : m_frame.left(),
                                 needed.top() < m_frame.top() ? grown.top() : m_frame.top()),
                         QPointF(needed.right() > m_frame.right() ? grown.right() : m_frame.right(),
                                 needed.bottom() > m_frame.bottom() ? grown.bottom() : m_frame.bottom()));
    }
}

/// The background with the grid, labelled along the lower and the left edge.
void MechanismView::paintGrid(QPainter &painter, const Canvas &on) const
{
    painter.fillRect(QRectF(QPointF(0.0, 0.0), on.size), on.colours.background);
    if (!m_result) {
        return;
    }
    constexpr double kLeastSpacing = 50.0; // px
    const double step = nextRoundNumber(kLeastSpacing / on.scale);
    const QPointF low = on.toModel({0.0, on.size.height()});
    const QPointF high = on.toModel({on.size.width(), 0.0});
    QFont small = on.font;
    small.setPixelSize(std::max(9, on.font.pixelSize() - 2));
    painter.setFont(small);
    const double textHeight = QFontMetricsF(small).height();
    const double cornerWidth = QFontMetricsF(small).horizontalAdvance(tr("mm")) + 10.0;
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.setPen(QPen(on.colours.grid, 1.0));
    const auto forEachLine = [step](double from, double to, const auto &paint) {
        for (double i = std::ceil(from / step); i <= std::floor(to / step); i += 1.0) {
            paint(i * step);
        }
    };
    forEachLine(low.x(), high.x(), [&](double x) {
        const double pixel = on({x, 0.0}).x();
        painter.drawLine(QPointF(pixel, 0.0), QPointF(pixel, on.size.height()));
    });
    forEachLine(low.y(), high.y(), [&](double y) {
        const double pixel = on({0.0, y}).y();
        painter.drawLine(QPointF(0.0, pixel), QPointF(on.size.width(), pixel));
    });
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(on.muted);
    painter.drawText(QPointF(4.0, on.size.height() - 4.0), tr("mm"));
    forEachLine(low.x(), high.x(), [&](double x) {
        const QString text = numberText(x);
        const double left = on({x, 0.0}).x() + 3.0;
        if (left > cornerWidth && left + painter.fontMetrics().horizontalAdvance(text) < on.size.width()) {
            painter.drawText(QPointF(left, on.size.height() - 4.0), text);
        }
    });
    forEachLine(low.y(), high.y(), [&](double y) {
        const double baseline = on({0.0, y}).y() - 3.0;
        if (baseline > textHeight && baseline < on.size.height() - 1.5 * textHeight) {
            painter.drawText(QPointF(4.0, baseline), numberText(y));
        }
    });
}

/// What stands still while the mechanism moves, but not while its lengths change.
void MechanismView::paintScenery(QPainter &painter, const Canvas &on) const
{
    if (!m_result) {
        return;
    }
    const Mechanism &mechanism = m_result->mechanism;
    const MotionLimits &limits = m_result->limits;
    painter.setRenderHint(QPainter::Antialiasing);

    // The crank's circle, and the arcs of it where there is no pose.
    const QPointF pivot = on({0.0, 0.0});
    const double radius = on.scale * mechanism.a();
    const QRectF circle(pivot.x() - radius, pivot.y() - radius, 2.0 * radius, 2.0 * radius);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(mixed(on.colours.text, on.colours.background, 0.35), 1.0, Qt::DashLine));
    painter.drawEllipse(circle);
    if (limits.mobility != Mobility::FullTurn) {
        painter.setPen(QPen(on.colours.warning, 3.0, Qt::SolidLine, Qt::FlatCap));
        const auto paintForbidden = [&](double from, double to) {
            QPainterPath arc;
            arc.arcMoveTo(circle, from * kDegreesPerRadian);
            arc.arcTo(circle, from * kDegreesPerRadian, (to - from) * kDegreesPerRadian);
            painter.drawPath(arc);
        };
        if (limits.ranges.empty()) {
            painter.drawEllipse(circle);
        }
        for (std::size_t i = 0; i < limits.ranges.size(); ++i) {
            const bool last = i + 1 == limits.ranges.size();
            paintForbidden(limits.ranges[i].to, last ? limits.ranges[0].from + kTurn : limits.ranges[i + 1].from);
        }
    }

    // The slider's line, its rail as far as the slider goes, and the dead centres.
    const QRectF reach = reachOf(*m_result);
    double railLeft = reach.left();
    double railRight = reach.right();
    if (limits.mobility == Mobility::FullTurn && limits.inner && limits.outer) {
        railLeft = std::min(limits.inner->R4x, limits.outer->R4x);
        railRight = std::max(limits.inner->R4x, limits.outer->R4x);
    }
    const double line = on({0.0, mechanism.c()}).y();
    painter.setPen(QPen(on.muted, 1.0, Qt::DashDotLine));
    painter.drawLine(QPointF(0.0, line), QPointF(on.size.width(), line));
    painter.setPen(QPen(on.muted, 1.2));
    const double rail = line + kBlockHalfHeight + 1.0;
    paintGround(painter, {on({railLeft, 0.0}).x() - kBlockHalfWidth - 4.0, rail},
                {on({railRight, 0.0}).x() + kBlockHalfWidth + 4.0, rail});
    for (const std::optional<DeadCentre> &centre : {limits.outer, limits.inner}) {
        if (centre) {
            const double x = on({centre->R4x, 0.0}).x();
            painter.drawLine(QPointF(x, line - kBlockHalfHeight - 8.0), QPointF(x, rail));
        }
    }

    // O₂: a pivot on the ground.
    const QPointF foot = pivot + QPointF(0.0, 17.0);
    painter.setPen(QPen(on.muted, 1.2));
    paintGround(painter, foot + QPointF(-17.0, 0.0), foot + QPointF(17.0, 0.0));
    painter.setPen(QPen(on.colours.text, 1.4));
    painter.setBrush(mixed(on.colours.text, on.colours.background, 0.15));
    painter.drawPolygon(QPolygonF{pivot, foot + QPointF(-11.0, 0.0), foot + QPointF(11.0, 0.0)});
    paintJoint(painter, pivot, on.colours.text, on.colours.background);
    painter.setFont(on.font);
    painter.setPen(on.colours.text);
    painter.drawText(pivot + QPointF(-16.0 - QFontMetricsF(on.font).horizontalAdvance(tr("O₂")), 16.0), tr("O₂"));
}

void MechanismView::paintPose(QPainter &painter, const Canvas &on) const
{
    if (!m_result) {
        return;
    }
    painter.setRenderHint(QPainter::Antialiasing);
    const bool exists = m_pose.exists();
    if (m_pins) {
        const QColor &ink = on.colours.text;
        const QColor &paper = on.colours.background;
        const QColor edge = exists ? ink : mixed(ink, paper, 0.35);
        const QColor link = exists ? on.colours.model : mixed(ink, paper, 0.3);
        const QColor fill = exists ? mixed(link, paper, 0.3) : mixed(ink, paper, 0.1);
        const QPointF pivot = on({0.0, 0.0});
        const QPointF crank = on(m_pins->crank);
        const QPointF slider = on(m_pins->slider);

        painter.setPen(QPen(edge, 1.5));
        painter.setBrush(mixed(ink, paper, exists ? 0.15 : 0.06));
        painter.drawRect(QRectF(slider.x() - kBlockHalfWidth, slider.y() - kBlockHalfHeight, 2.0 * kBlockHalfWidth,
                                2.0 * kBlockHalfHeight));
        paintLink(painter, crank, slider, kCouplerWidth, link, fill);
        paintLink(painter, pivot, crank, kCrankWidth, link, fill);
        for (const QPointF &joint : {pivot, crank, slider}) {
            paintJoint(painter, joint, edge, paper);
        }

        // The name of A away from both links, that of B beside the slider's dead centre marks.
        painter.setFont(on.font);
        painter.setPen(edge);
        const QPointF apart = unitVector(crank - pivot) + unitVector(crank - slider);
        const QPointF across(-(slider - crank).y(), (slider - crank).x()); // where crank and coupler are in one line
        const QPointF away = std::hypot(apart.x(), apart.y()) > 0.3 ? unitVector(apart) : unitVector(across);
        const QRectF box(-10.0, -9.0, 20.0, 18.0);
        painter.drawText(box.translated(crank + 17.0 * away), Qt::AlignCenter, tr("A"));
        painter.drawText(box.translated(slider + QPointF(0.0, -kBlockHalfHeight - 18.0)), Qt::AlignCenter, tr("B"));
    }
    paintGhost(painter, on);
    if (!exists) {
        const QPointF wanted = crankPin();
        if (std::isfinite(wanted.x()) && std::isfinite(wanted.y())) {
            painter.setPen(QPen(on.colours.warning, 2.0, Qt::DashLine));
            painter.drawLine(on({0.0, 0.0}), on(wanted));
            paintJoint(painter, on(wanted), on.colours.warning, on.colours.background);
        }
        paintExplanation(painter, on);
    }
}

void MechanismView::paintGhost(QPainter &painter, const Canvas &on) const
{
    if (!m_ghost.exists) {
        return;
    }
    const QPointF crank = on({m_ghost.pinX, m_ghost.pinY});
    const QPointF slider = on({m_ghost.sliderX, m_ghost.sliderY});
    painter.setPen(QPen(on.colours.reference, kGhostWidth, Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(on({0.0, 0.0}), crank);
    painter.drawLine(crank, slider);
    painter.setBrush(Qt::NoBrush);
    painter.setRenderHint(QPainter::Antialiasing, false); // upright edges need none, and cost less without
    painter.setPen(on.colours.reference);
    painter.drawRect(QRectF(slider.x() - kBlockHalfWidth, slider.y() - kBlockHalfHeight, 2.0 * kBlockHalfWidth,
                            2.0 * kBlockHalfHeight));
    const double side = 2.0 * kGhostJointRadius;
    for (const QPointF &joint : {crank, slider}) {
        painter.fillRect(QRectF(joint.x() - kGhostJointRadius, joint.y() - kGhostJointRadius, side, side),
                         on.colours.reference);
    }
    painter.setRenderHint(QPainter::Antialiasing);
}

void MechanismView::paintExplanation(QPainter &painter, const Canvas &on) const
{
    const QString text = explanation();
    constexpr double kWidest = 440.0;
    constexpr double kNarrowest = 190.0;
    constexpr double kPadding = 9.0;
    constexpr double kApart = 8.0;
    // Beside the crank circle and away from the slider's line there is nothing to hide, if there is room.
    const double a = m_result->mechanism.a();
    const bool open = m_result->mechanism.branch() == Branch::Open;
    const double beside = (open ? on.size.width() - on({a, 0.0}).x() : on({-a, 0.0}).x()) - 2.0 * kApart;
    const double whole = on.size.width() - 2.0 * kApart;
    const bool fits = beside >= kNarrowest;
    painter.setFont(on.font);
    const QRectF room(0.0, 0.0, std::min(kWidest, fits ? beside : whole) - 2.0 * kPadding, 1e4);
    QRectF box = painter.boundingRect(room, Qt::TextWordWrap, text).adjusted(-kPadding, -kPadding, kPadding, kPadding);
    const double scaleHeight = QFontMetricsF(on.font).height() + 2.0;
    const bool below = m_result->mechanism.c() >= 0.0;
    box.moveTop(below ? on.size.height() - box.height() - kApart - scaleHeight : kApart);
    const double middle = 0.5 * (on.size.width() - box.width());
    box.moveLeft(!fits ? middle : open ? on.size.width() - box.width() - kApart : kApart);
    box = QRectF(box.toAlignedRect()).adjusted(0.5, 0.5, -0.5, -0.5); // a crisp border
    painter.setPen(QPen(on.colours.warning, 1.0));
    QColor paper = on.colours.background;
    paper.setAlphaF(0.93F);
    painter.setBrush(paper);
    painter.drawRoundedRect(box, 4.0, 4.0);
    painter.setPen(on.colours.text);
    painter.drawText(box.adjusted(kPadding, kPadding, -kPadding + 1.0, -kPadding + 1.0), Qt::TextWordWrap, text);
}

QString MechanismView::explanation() const
{
    if (m_pose.exists() || !m_result) {
        return {};
    }
    if (m_pose.status == Status::NotFinite) {
        return tr("There is no pose at this instant: the crank angle is not a finite number.");
    }
    const Mechanism &mechanism = m_result->mechanism;
    const QString turning = numberText(shortestCouplerForFullTurn(mechanism));
    if (m_result->limits.mobility == Mobility::Impossible) {
        return tr("Cannot be assembled at any crank angle: the coupler does not reach the slider's line. b must be "
                  "more than "
                  "%1 mm for any pose; the crank turns round when b is at least %2 mm.")
            .arg(numberText(shortestCouplerForAnyPose(mechanism)), turning);
    }
    const double angle = m_pose.theta2 - kTurn * std::floor(m_pose.theta2 / kTurn);
    return tr("Cannot be assembled at θ₂ = %1°: the coupler is too short. The crank turns round when b is at least %2 "
              "mm.")
        .arg(QLocale().toString(angle * kDegreesPerRadian, 'f', 1), turning);
}

QPointF MechanismView::crankPin() const
{
    if (!m_result) {
        return {};
    }
    const double a = m_result->mechanism.a();
    return {a * std::cos(m_pose.theta2), a * std::sin(m_pose.theta2)};
}

QRect MechanismView::poseArea() const
{
    return m_pins ? areaOf(m_pins->crank, m_pins->slider) : QRect();
}

QRect MechanismView::ghostArea() const
{
    return m_ghost.exists ? areaOf({m_ghost.pinX, m_ghost.pinY}, {m_ghost.sliderX, m_ghost.sliderY}) : QRect();
}

QRect MechanismView::areaOf(QPointF crank, QPointF slider) const
{
    const Canvas on = canvas(size(), palette());
    const QPolygonF pins{on({0.0, 0.0}), on(crank), on(slider)};
    return pins.boundingRect()
        .adjusted(-kAroundPins, -kAroundPins, kAroundPins, kAroundPins)
        .toAlignedRect()
        .intersected(rect());
}

void MechanismView::refreshScenery()
{
    m_grid = QPixmap();
    m_scenery = QPixmap();
    update();
}

void MechanismView::paintEvent(QPaintEvent *event)
{
    const Canvas on = canvas(size(), palette());
    const double ratio = devicePixelRatioF();
    if (m_grid.isNull() || m_grid.devicePixelRatio() != ratio) {
        // Rounded up: at a ratio of 1.5 the last half pixel has to be painted too.
        m_grid = QPixmap(static_cast<int>(std::ceil(width() * ratio)), static_cast<int>(std::ceil(height() * ratio)));
        m_grid.setDevicePixelRatio(ratio);
        QPainter painter(&m_grid);
        paintGrid(painter, on);
        m_scenery = QPixmap();
    }
    if (m_scenery.isNull()) {
        m_scenery = m_grid;
        QPainter painter(&m_scenery);
        paintScenery(painter, on);
    }
    QPainter painter(this);
    painter.setClipRegion(event->region());
    painter.drawPixmap(0, 0, m_scenery);
    paintPose(painter, on);
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

void MechanismView::mousePressEvent(QMouseEvent *event)
{
    m_dragging = event->button() == Qt::LeftButton && nearCrankPin(event->position());
    if (m_dragging) {
        setCursor(Qt::ClosedHandCursor);
    } else {
        QWidget::mousePressEvent(event);
    }
}

void MechanismView::mouseMoveEvent(QMouseEvent *event)
{
    if (m_dragging) {
        scrubTo(event->position());
    } else if (nearCrankPin(event->position())) {
        setCursor(Qt::OpenHandCursor);
    } else {
        unsetCursor();
    }
}

void MechanismView::mouseReleaseEvent(QMouseEvent *event)
{
    if (m_dragging && event->button() == Qt::LeftButton) {
        m_dragging = false;
        setCursor(Qt::OpenHandCursor);
    }
    QWidget::mouseReleaseEvent(event);
}

bool MechanismView::nearCrankPin(QPointF pixel) const
{
    if (!m_result || m_result->mechanism.omega2() == 0.0) {
        return false;
    }
    const QPointF away = pixel - toPixels(crankPin());
    return std::hypot(away.x(), away.y()) <= kGrasp;
}

void MechanismView::scrubTo(QPointF pixel)
{
    const double omega2 = m_result->mechanism.omega2();
    const Sampling &sampling = m_result->sampling;
    const double first = std::min(sampling.start, sampling.start + sampling.duration);
    const double last = std::max(sampling.start, sampling.start + sampling.duration);
    const QPointF model = canvas(size(), palette()).toModel(pixel);
    if (omega2 == 0.0 || (model.x() == 0.0 && model.y() == 0.0)) {
        return;
    }
    const double wanted = std::atan2(model.y(), model.x());
    const double period = kTurn / std::abs(omega2);
    double time = m_pose.time + std::remainder(wanted - m_pose.theta2, kTurn) / omega2;
    if (time < first || time > last) {
        // The same crank angle, whole turns away, where the run has it; else the end of the run nearest to it.
        const double turns = time < first ? std::ceil((first - time) / period) : -std::ceil((time - last) / period);
        const double turned = time + turns * period;
        const auto farness = [&](double end) {
            return std::abs(std::remainder(m_pose.theta2 + omega2 * (end - m_pose.time) - wanted, kTurn));
        };
        time = turned >= first && turned <= last ? turned : (farness(first) < farness(last) ? first : last);
    }
    emit timeRequested(time);
}

} // namespace slidercrank
