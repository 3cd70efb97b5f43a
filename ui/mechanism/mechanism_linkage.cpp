// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/mechanism/mechanism_linkage.h"

#include "ui/mechanism/mechanism_instant_centre.h"
#include "ui/mechanism/mechanism_labels.h"
#include "ui/mechanism/mechanism_words.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace slidercrank
{

namespace
{

struct MechanismLinkage {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::MechanismLinkage)
};

constexpr double kGhostWidth = 2.0;
constexpr double kGhostJointRadius = 2.5;
constexpr double kAroundFile = 42.0; ///< px that the ghost's word reaches around its slider
constexpr double kAroundPins = 27.0; ///< px that slider, joint and highlight reach around a pin

QRectF blockAt(QPointF slider)
{
    return QRectF(slider.x() - kBlockHalfWidth, slider.y() - kBlockHalfHeight, 2.0 * kBlockHalfWidth,
                  2.0 * kBlockHalfHeight);
}

void paintLink(QPainter &painter, QPointF from, QPointF to, double width, const QColor &edge, const QColor &fill)
{
    // Flat ends, which the joints cover: round ones would double the time of a frame.
    painter.setPen(QPen(edge, width, Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(from, to);
    painter.setPen(QPen(fill, width - 3.0, Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(from, to);
}

/// The sign of a centre of mass: a circle with two quarters filled.
void paintCentre(QPainter &painter, QPointF at, const QColor &ink, const QColor &paper)
{
    constexpr double kRadius = 4.5;
    const QRectF circle(at.x() - kRadius, at.y() - kRadius, 2.0 * kRadius, 2.0 * kRadius);
    constexpr int kQuarter = 90 * 16; // as QPainter counts
    painter.setPen(QPen(ink, 1.2));
    painter.setBrush(paper);
    painter.drawEllipse(circle);
    painter.setPen(Qt::NoPen);
    painter.setBrush(ink);
    painter.drawPie(circle, 0, kQuarter);
    painter.drawPie(circle, 2 * kQuarter, kQuarter);
}

/// Arrows that are on show, with their kinds.
struct KindOfArrow {
    MotionArrow arrow;
    MotionKind kind;
};
bool hasLabels(const MechanismSettings &settings)
{
    return settings.names || settings.dimensions || settings.angles || settings.instantCentre;
}

std::vector<KindOfArrow> arrowsOf(const MechanismDrawing &drawing)
{
    std::vector<KindOfArrow> arrows;
    const MechanismSettings &settings = drawing.settings;
    if (!drawing.pose.exists() || !(settings.showsVelocity() || settings.acceleration)) {
        return arrows;
    }
    const LinkageMotion motion = drawing.motion();
    const auto add = [&](MotionKind kind, const ArrowScale &scale) {
        for (const LinkagePoint which : kLinkagePoints) {
            if (which == LinkagePoint::G3 && kind == MotionKind::Velocity && !settings.velocity) {
                continue; // the instant centre is told by A and B
            }
            const PointMotion &point = motion[static_cast<std::size_t>(which)];
            if (const std::optional<MotionArrow> arrow = arrowOf(point, kind, scale)) {
                arrows.push_back({*arrow, kind});
            }
        }
    };
    if (settings.acceleration) {
        add(MotionKind::Acceleration, drawing.acceleration);
    }
    if (settings.showsVelocity()) {
        add(MotionKind::Velocity, drawing.velocity);
    }
    return arrows;
}

void paintModel(QPainter &painter, const MechanismCanvas &on, const MechanismDrawing &drawing)
{
    const bool exists = drawing.pose.exists();
    const QColor &ink = on.colours.text;
    const QColor &paper = on.colours.background;
    const QColor edge = exists ? ink : mixed(ink, paper, 0.35);
    const QColor link = exists ? on.colours.model : mixed(ink, paper, 0.3);
    const QColor fill = exists ? mixed(link, paper, 0.3) : mixed(ink, paper, 0.1);
    const QPointF pivot = on.toPixels({0.0, 0.0});
    const QPointF crank = on.toPixels(drawing.pins->A);
    const QPointF slider = on.toPixels(drawing.pins->B);

    painter.setPen(QPen(edge, 1.5));
    painter.setBrush(mixed(ink, paper, exists ? 0.15 : 0.06));
    painter.drawRect(blockAt(slider));
    paintLink(painter, crank, slider, kCouplerWidth, link, fill);
    paintLink(painter, pivot, crank, kCrankWidth, link, fill);
    for (const QPointF &joint : {pivot, crank, slider}) {
        paintJoint(painter, joint, edge, paper);
    }
    if (drawing.hasCentre()) {
        paintCentre(painter, 0.5 * (crank + slider), ink, paper);
    }
}

/// What is written beside the linkage, and what tells how it moves.
void paintExplanations(QPainter &painter, const MechanismCanvas &on, const MechanismDrawing &drawing)
{
    const std::vector<KindOfArrow> arrows = arrowsOf(drawing);
    for (const KindOfArrow &shown : arrows) {
        paintArrow(painter, on, shown.arrow, shown.kind);
    }
    if (!hasLabels(drawing.settings)) {
        return;
    }
    LabelRoom room = labelRoomOf(on, drawing);
    for (const KindOfArrow &shown : arrows) {
        room.ratherKeepOff({on.toPixels(shown.arrow.tail), on.toPixels(shown.arrow.tip)});
    }
    const bool exists = drawing.pose.exists();
    if (drawing.settings.instantCentre && exists && drawing.pins) {
        paintInstantCentre(painter, on, drawing, room);
    }
    const QColor &ink = on.colours.text;
    paintLabels(painter, on, drawing, exists ? ink : mixed(ink, on.colours.background, 0.35), room);
}

void paintGhost(QPainter &painter, const MechanismCanvas &on, const MechanismDrawing &drawing)
{
    const ReferencePose &ghost = drawing.ghost;
    const bool isOfFile = !drawing.result->difference;
    const QColor colour = isOfFile ? on.colours.reference : on.colours.kept;
    const QPointF crank = on.toPixels({ghost.pinX, ghost.pinY});
    const QPointF slider = on.toPixels({ghost.sliderX, ghost.sliderY});
    painter.setPen(QPen(colour, kGhostWidth, Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(on.toPixels({0.0, 0.0}), crank);
    painter.drawLine(crank, slider);
    painter.setBrush(Qt::NoBrush);
    painter.setRenderHint(QPainter::Antialiasing, false); // upright edges need none, and cost less without
    painter.setPen(colour);
    painter.drawRect(blockAt(slider));
    const double side = 2.0 * kGhostJointRadius;
    for (const QPointF &joint : {crank, slider}) {
        painter.fillRect(QRectF(joint.x() - kGhostJointRadius, joint.y() - kGhostJointRadius, side, side), colour);
    }
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(on.smallFont);
    painter.drawText(ghostWordPlace(on, ghost), Qt::AlignCenter,
                     isOfFile ? MechanismLinkage::tr("file") : MechanismLinkage::tr("kept"));
}

/// Where the crank should be, and why it cannot be there.
void paintMissingPose(QPainter &painter, const MechanismCanvas &on, const MechanismDrawing &drawing)
{
    const QPointF wanted = drawing.crankPin();
    if (std::isfinite(wanted.x()) && std::isfinite(wanted.y())) {
        painter.setPen(QPen(on.colours.warning, 2.0, Qt::DashLine));
        painter.drawLine(on.toPixels({0.0, 0.0}), on.toPixels(wanted));
        paintJoint(painter, on.toPixels(wanted), on.colours.warning, on.colours.background);
    }
    const QString text = explanationOf(drawing);
    constexpr double kWidest = 440.0;
    constexpr double kNarrowest = 190.0;
    constexpr double kPadding = 9.0;
    constexpr double kApart = 8.0;
    // Beside the crank circle and away from the slider's line there is nothing to hide, if there is room.
    const Mechanism &mechanism = drawing.mechanism();
    const double a = mechanism.a();
    const bool open = mechanism.branch() == Branch::Open;
    const double beside =
        (open ? on.size.width() - on.toPixels({a, 0.0}).x() : on.toPixels({-a, 0.0}).x()) - 2.0 * kApart;
    const double whole = on.size.width() - 2.0 * kApart;
    const bool fits = beside >= kNarrowest;
    painter.setFont(on.font);
    const QRectF room(0.0, 0.0, std::min({kWidest, fits ? beside : whole, whole}) - 2.0 * kPadding, 1e4);
    QRectF box = painter.boundingRect(room, Qt::TextWordWrap, text).adjusted(-kPadding, -kPadding, kPadding, kPadding);
    const double scaleHeight = QFontMetricsF(on.font).height() + 2.0;
    const bool below = mechanism.c() >= 0.0;
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

QRectF around(const QPolygonF &points, double margin)
{
    return points.boundingRect().adjusted(-margin, -margin, margin, margin);
}

} // namespace

void paintLinkage(QPainter &painter, const MechanismCanvas &on, const MechanismDrawing &drawing)
{
    if (!drawing.result) {
        return;
    }
    painter.setRenderHint(QPainter::Antialiasing);
    if (drawing.pins) {
        paintModel(painter, on, drawing);
    }
    paintExplanations(painter, on, drawing);
    if (drawing.ghost.exists) {
        paintGhost(painter, on, drawing);
    }
    if (!drawing.pose.exists()) {
        paintMissingPose(painter, on, drawing);
    }
}

void paintLinkageHighlight(QPainter &painter, const MechanismCanvas &on, const MechanismDrawing &drawing,
                           DrawnPart part)
{
    constexpr double kAround = 4.5;
    const auto ring = [&](QPointF at) {
        painter.drawEllipse(on.toPixels(at), kJointRadius + kAround, kJointRadius + kAround);
    };
    const auto band = [&](QPointF from, QPointF to, double width) {
        QColor colour = on.highlight;
        colour.setAlphaF(0.45F);
        painter.setPen(QPen(colour, width + kAround, Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(on.toPixels(from), on.toPixels(to));
    };
    painter.setPen(QPen(on.highlight, 2.5));
    painter.setBrush(Qt::NoBrush);
    switch (part) {
    case DrawnPart::O2: ring({0.0, 0.0}); break;
    case DrawnPart::A: ring(drawing.crankPin()); break;
    case DrawnPart::B:
        if (drawing.pins) {
            painter.drawRect(blockAt(on.toPixels(drawing.pins->B)).adjusted(-3.0, -3.0, 3.0, 3.0));
        }
        break;
    case DrawnPart::G3:
        if (drawing.pins) {
            ring(0.5 * (drawing.pins->A + drawing.pins->B));
        }
        break;
    case DrawnPart::Crank: band({0.0, 0.0}, drawing.crankPin(), kCrankWidth); break;
    case DrawnPart::Coupler:
        if (drawing.pins) {
            band(drawing.pins->A, drawing.pins->B, kCouplerWidth);
        }
        break;
    case DrawnPart::Background:
    case DrawnPart::Guide:
    case DrawnPart::OuterDeadCentre:
    case DrawnPart::InnerDeadCentre:
    case DrawnPart::ForbiddenArc: break;
    }
}

QRectF linkageArea(const MechanismCanvas &on, const MechanismDrawing &drawing)
{
    if (!drawing.result || !drawing.pins) {
        return {};
    }
    const QPolygonF joints{on.toPixels({0.0, 0.0}), on.toPixels(drawing.pins->A), on.toPixels(drawing.pins->B)};
    if (hasLabels(drawing.settings)) {
        return QRectF(QPointF(), on.size); // labels give way to each other, wherever that is
    }
    QRectF area = around(joints, kAroundPins);
    QPolygonF tips;
    for (const KindOfArrow &shown : arrowsOf(drawing)) {
        tips << on.toPixels(shown.arrow.tip);
    }
    if (!tips.isEmpty()) {
        constexpr double kAroundHead = 5.0;
        area = area.united(around(tips, kAroundHead));
    }
    return area;
}

QRectF ghostArea(const MechanismCanvas &on, const MechanismDrawing &drawing)
{
    const ReferencePose &ghost = drawing.ghost;
    if (!ghost.exists) {
        return {};
    }
    return around({on.toPixels({0.0, 0.0}), on.toPixels({ghost.pinX, ghost.pinY}),
                   on.toPixels({ghost.sliderX, ghost.sliderY})},
                  kAroundFile)
        .united(ghostWordPlace(on, ghost));
}

} // namespace slidercrank
