// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/mechanism/mechanism_sketch.h"

#include "ui/mechanism/mechanism_text.h"
#include "ui/text/channel_text.h"
#include "ui/text/motion_facts.h"
#include "ui/text/notation.h"
#include "ui/text/written_number.h"

#include <QFontMetricsF>
#include <QRegularExpression>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

namespace slidercrank
{

namespace
{

// Sizes, px.
constexpr double kCrankWidth = 10.5;
constexpr double kCouplerWidth = 8.0;
constexpr double kJointRadius = 6.0;  // covers the ends of the links
constexpr double kCentreRadius = 3.5; // the mark of G3

QPainterPath sliderPath(QPointF centre)
{
    QPainterPath path;
    QRectF slider(QPointF(), MechanismSketch::kSliderSize);
    slider.moveCenter(centre);
    path.addRect(slider);
    return path;
}

} // namespace

void MechanismSketch::addLinkage()
{
    if (!m_scene->result || std::isnan(m_scene->pose.motion.theta2)) {
        return; // no pose has been set
    }
    avoidScenery();
    addDeadCentreCaptions();
    addModel();
    if (m_poseExists) {
        addAnnotations();
    }
    if (m_scene->settings.names) {
        addNames();
    }
    addGhost();
    addMarkedPose();
    if (!m_poseExists) {
        addMissingCoupler();
        if (!hasProblemInLegend()) {
            addAssemblyProblem();
        }
    }
}

/// Keeps labels away from the ground, the rail, the marks of the dead centres, the legend and the dimension of the
/// offset.
void MechanismSketch::avoidScenery()
{
    constexpr double kHeightOfGround = 24.0;    // px, with the hatching
    constexpr double kUsualLegendWidth = 240.0; // px
    constexpr double kBesideOffset = 24.0;      // px, for the letter c beside the dimension of the offset
    avoid(QRectF(m_O2 - QPointF(kSupportSize, 0.0), QSizeF(2.0 * kSupportSize, kHeightOfGround)));
    avoid(rail());
    // The marks are rectangles of their own: where there is no free place, a label crosses a mark, which is thin,
    // rather than a text.
    for (const DeadCentreMark &mark : deadCentreMarks()) {
        avoid(QRectF(mark.line.p1(), mark.line.p2()).adjusted(-1.0, 0.0, 1.0, 0.0));
    }
    if (cornerLineCount() > 0) {
        avoid(QRectF(0.0, 0.0, kUsualLegendWidth, cornerLineTop(cornerLineCount())));
    }
    if (m_scene->settings.dimensions) {
        avoid(offsetDimension(), kBesideOffset);
    }
}

/// Adds the captions over the coupler, which may pass them and stays visible.
void MechanismSketch::addDeadCentreCaptions()
{
    for (const auto &[name, box] : deadCentreCaptions()) {
        m_labels.push_back({.text = name, .box = box, .ink = m_muted, .paper = Qt::transparent, .isSmall = true});
        avoid(box);
    }
}

/// Adds what moves with the linkage: arrows, the instant centre, lengths and angles.
void MechanismSketch::addAnnotations()
{
    const MechanismSettings &settings = m_scene->settings;
    if (settings.acceleration) {
        addMotionArrows(m_scene->arrows(&PointMotion::acceleration), kLinkagePoints);
    }
    if (settings.showsVelocity()) { // the instant centre is shown with the velocities of A and B
        static constexpr std::array kPins{LinkagePoint::A, LinkagePoint::B};
        const std::span<const LinkagePoint> allPoints(kLinkagePoints);
        addMotionArrows(m_scene->arrows(&PointMotion::velocity), settings.velocity ? allPoints : kPins);
    }
    if (settings.instantCentre) {
        addInstantCentre();
    }
    if (settings.dimensions) {
        addLengthLetters();
    }
    if (settings.angles) {
        addAngle("θ₂", {m_O2, m_A}, degreesFromZero(m_scene->pose.motion.theta2) / kDegreesPerRadian, kLargestCrankArc);
        addCouplerAngle();
    }
}

/// Adds θ³ at A or, in the textbook's notation, θ₃ at B.
void MechanismSketch::addCouplerAngle()
{
    const double theta3 = m_scene->pose.motion.theta3;
    if (notation().symbols == Symbols::Textbook) {
        const double halfTurn = mechanism().branch() == Branch::Open ? std::numbers::pi : -std::numbers::pi;
        addAngle(symbolText(Channel{Theta3, Order::Position}), {m_B, m_A}, theta3 + halfTurn, kLargestCouplerArc);
    } else {
        addAngle(symbolText(Channel{Theta3, Order::Position}), {m_A, m_B}, theta3, kLargestCouplerArc);
    }
}

void MechanismSketch::addLink(QPointF from, QPointF to, double width, const QColor &colour, DrawnPart part)
{
    addLine(from, to, QPen(colour, width, Qt::SolidLine, Qt::FlatCap), part);
    constexpr double kLinkFill = 0.3; // share of the outline's colour
    addLine(from, to, QPen(faded(colour, kLinkFill), width - 2.0 * kBodyOutline, Qt::SolidLine, Qt::FlatCap));
}

void MechanismSketch::addJoint(QPointF centre, const QColor &edge, DrawnPart part)
{
    addCircle(centre, kJointRadius, QPen(edge, kBodyOutline), m_paper, part);
}

void MechanismSketch::addModel()
{
    constexpr double kAroundPin = 14.0; // px: A is dragged most often, so the empty area around it reacts, too
    const QColor &link = m_poseExists ? m_colours.model : m_colours.warning;
    addCircle(m_A, kAroundPin, Qt::NoPen, Qt::transparent, A);
    if (m_poseExists) {
        const QPainterPath slider = sliderPath(m_B);
        add(slider, QPen(m_ink, kBodyOutline), faded(m_ink, kBodyFill), Slider);
        avoid(slider.boundingRect());
        avoid({m_O2, m_A}, kCrankWidth);
        avoid({m_A, m_B}, kCouplerWidth);
        avoidAround(m_O2, kJointRadius + kBodyOutline);
        avoidAround(m_A, kJointRadius + kBodyOutline);
        avoidAround(0.5 * (m_A + m_B), kCentreRadius);
        addLink(m_A, m_B, kCouplerWidth, link, Coupler);
    }
    addLink(m_O2, m_A, kCrankWidth, link, Crank);
    addJoint(m_O2, m_ink, O2);
    if (m_poseExists) {
        addCircle(0.5 * (m_A + m_B), kCentreRadius, QPen(m_ink, kHairline), m_ink, G3);
        addJoint(m_B, m_ink, B);
    }
    addJoint(m_A, m_poseExists ? m_ink : link, A);
}

/// Adds the circle of radius b about A, which B can reach, and the gap between the circle and the slider's line.
void MechanismSketch::addMissingCoupler()
{
    constexpr double kLabelGap = 8.0; // px
    constexpr int kGapDigits = 4;     // significant digits
    const QPointF pin = m_scene->crankPin();
    if (!std::isfinite(pin.x())) {
        return;
    }
    addCircle(m_A, projection().scale * mechanism().b(), QPen(m_colours.warning, kGroundLine, Qt::DashLine));
    const double nearest = pin.y() + std::copysign(mechanism().b(), mechanism().c() - pin.y());
    const QLineF gap(toPixels({pin.x(), nearest}), toPixels({pin.x(), mechanism().c()}));
    addDimension(gap.p1(), gap.p2(), m_colours.warning);
    addLabelBeside(gap.center(), {1.0, 0.0}, kLabelGap,
                   tr("gap = %1").arg(lengthText(std::abs(mechanism().c() - nearest), kGapDigits)), m_ink);
}

/// Returns the reason why the mechanism cannot be assembled and what would help. A line does not end within an
/// equation.
QString MechanismSketch::problemText() const
{
    static const QRegularExpression kWithin(
        "(?<=[=≥]) | (?=[=≥])|(?<=[0-9]) (?=[a-z])"); // around a sign, before a unit
    return missingPoseText(*m_scene).replace(kWithin, QChar(QChar::Nbsp));
}

/// Adds the reason why the mechanism cannot be assembled, in a box that hides what is below it.
void MechanismSketch::addAssemblyProblem()
{
    constexpr double kMargin = 17.0;       // px, from the edges of the drawing
    constexpr double kPadding = 9.0;       // px, around the text
    constexpr double kRoundedCorner = 4.0; // px
    constexpr double kBoxOpacity = 0.93;
    constexpr double kMinWidth = 160.0;      // px
    constexpr double kWidthFraction = 0.45;  // width of the text over that of the drawing
    constexpr double kUnlimitedHeight = 1e4; // px
    const QString text = problemText();
    const double width = std::max(kMinWidth, kWidthFraction * projection().size.width());
    const QRectF available(0.0, 0.0, width, kUnlimitedHeight);
    const QSizeF extent = QFontMetricsF(m_font).boundingRect(available, Qt::TextWordWrap, text).size();
    const double heightOfGridNumbers = textSize({}).height(); // along the lower edge
    const QRectF inside =
        QRectF(QPointF(), projection().size).adjusted(kMargin, kMargin, -kMargin, -kMargin - heightOfGridNumbers);
    constexpr double kAroundButton = kPadding + 4.0; // px
    const QRectF button = m_scene->button.isEmpty()
                              ? QRectF()
                              : m_scene->button.adjusted(-kAroundButton, -kAroundButton, kAroundButton, kAroundButton);
    const QRectF box = m_scene->inFreeCorner(inside, extent, button);
    QPainterPath frame;
    frame.addRoundedRect(box.marginsAdded({kPadding, kPadding, kPadding, kPadding}), kRoundedCorner, kRoundedCorner);
    std::erase_if(m_labels, [&frame](const Label &label) { return frame.intersects(label.box); });
    add(frame, QPen(m_colours.warning, kHairline), withAlpha(m_paper, kBoxOpacity));
    m_labels.push_back({.text = text,
                        .box = box.adjusted(0.0, 0.0, 1.0, 1.0),
                        .ink = m_ink,
                        .paper = Qt::transparent,
                        .alignment = Qt::TextWordWrap});
}

/// Adds thin lines along crank, coupler and slider. Returns the line of the coupler.
QLineF MechanismSketch::addOutline(const ReferencePose &pose, const QPen &pen)
{
    const QLineF coupler(toPixels({pose.pinX, pose.pinY}), toPixels({pose.sliderX, pose.sliderY}));
    QPainterPath path = sliderPath(coupler.p2());
    path.moveTo(m_O2);
    path.lineTo(coupler.p1());
    path.lineTo(coupler.p2());
    add(path, pen);
    return coupler;
}

/// Adds the linkage in the position that a row of a table refers to.
void MechanismSketch::addMarkedPose()
{
    if (m_scene->markedPose.exists) {
        addOutline(m_scene->markedPose, QPen(m_colours.cursor, kPathLine, Qt::DashLine));
    }
}

void MechanismSketch::addGhost()
{
    const ReferencePose &ghost = m_scene->ghost;
    if (!ghost.exists) {
        return;
    }
    constexpr double kOccupiedWidth = 2.0; // px
    constexpr double kLabelGap = 22.0;     // px from the slider
    const bool isFile = !m_scene->result->difference;
    const std::size_t pinnedCount = m_scene->result->pinned.size();
    const std::size_t lastPinned = std::max<std::size_t>(pinnedCount, 1) - 1; // the pinned motion that is drawn
    const QColor &colour = isFile ? m_colours.reference : m_colours.*kPinnedColours[lastPinned];
    const QLineF coupler = addOutline(ghost, QPen(colour, kBodyOutline));
    avoid(coupler, kOccupiedWidth);
    const QPointF awayFromCoupler(0.0, coupler.dy() > 0.0 ? 1.0 : -1.0);
    addLabelBeside(coupler.p2(), awayFromCoupler, kLabelGap, isFile ? tr("file") : tr("pinned"), colour,
                   TextSize::Small);
}

} // namespace slidercrank
