// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/mechanism/mechanism_sketch.h"

#include "core/limits/instant_centre.h"
#include "core/mechanism/turn.h"
#include "ui/text/channel_text.h"
#include "ui/text/notation.h"
#include "ui/text/written_number.h"

#include <QFontMetricsF>

#include <algorithm>
#include <cmath>

namespace slidercrank
{

namespace
{

constexpr double kBesideJoint = 9.0; // px from a joint to its label

/// Returns the radius (px) of the arc of a link's angle.
double arcRadius(const QLineF &link, double largest)
{
    constexpr double kShareOfLink = 0.5; // so that the arc ends before the other joint
    constexpr double kSmallest = 14.0;   // px, larger than a joint
    return std::clamp(kShareOfLink * link.length(), kSmallest, largest);
}

/// Returns a value (mm, rad, s) with its unit, as it is shown.
QString shownText(Measure measure, double value)
{
    return withUnit(shortNumber(shownValue(measure, value, notation().units)), shownUnit(measure));
}

QString pointName(LinkagePoint point)
{
    switch (point) {
    case LinkagePoint::A: return "A";
    case LinkagePoint::B: return "B";
    case LinkagePoint::G3: break;
    }
    return "G₃";
}

/// Returns an angle (rad) with as many decimals as can be read while it changes.
QString angleText(double angle)
{
    const bool isRadian = notation().units.angle == AngleUnit::Radian;
    constexpr int kDecimalsOfRadians = 3;
    constexpr int kDecimalsOfDegrees = 1;
    return isRadian ? fixedText(angle, kDecimalsOfRadians) + " rad"
                    : fixedText(kDegreesPerRadian * angle, kDecimalsOfDegrees) + "°";
}

/// Returns whether P is too far away to be drawn, so that the coupler practically translates.
bool isAtInfinity(const InstantCentre &centre, const Mechanism &mechanism)
{
    constexpr double kFarInSizes = 1e4; // times the size of the mechanism
    return !(centre.distanceToA <= kFarInSizes * (mechanism.a() + mechanism.b() + std::abs(mechanism.c())));
}

/// Returns the text of the legend about the instant centre, in two lines, since one would be too long for a narrow
/// drawing.
QString instantCentreText(const InstantCentre &centre, const Mechanism &mechanism)
{
    if (!std::isfinite(centre.omega3)) {
        return MechanismSketch::tr("no velocity: the coupler is perpendicular to the slider's line");
    }
    return isAtInfinity(centre, mechanism)
               ? MechanismSketch::tr("Instant centre P at infinity:\nthe coupler translates at %1")
                     .arg(shownText(Measure::Speed, mechanism.a() * std::abs(mechanism.omega2())))
               : MechanismSketch::tr("Instant centre P: %1 = %2 rad/s = %3 °/s\nPA = %4, PB = %5")
                     .arg(symbolText(Channel{Theta3, Order::Velocity}), shortNumber(centre.omega3),
                          shortNumber(kDegreesPerRadian * centre.omega3),
                          shownText(Measure::Length, centre.distanceToA),
                          shownText(Measure::Length, centre.distanceToB));
}

} // namespace

/// Adds an arrow with a filled head for a velocity and with a hollow head for an acceleration, so that they differ not
/// only in colour.
void MechanismSketch::addArrow(QPointF tail, QPointF tip, const ArrowScale &arrows, Qt::PenStyle line)
{
    constexpr double kMinLength = 1.0;     // px
    constexpr double kMaxHead = 10.0;      // px
    constexpr double kHeadFraction = 0.6;  // of the length of a short arrow
    constexpr double kBeyondLine = 0.9;    // part of the head beyond the end of the line
    constexpr double kHollowStart = 0.3;   // of the head, from its tip to that of the hollow
    constexpr double kHollowLength = 0.5;  // of the head
    constexpr double kOccupiedWidth = 4.0; // px
    const double length = QLineF(tail, tip).length();
    if (length < kMinLength) {
        return;
    }
    const QPointF direction = (tip - tail) / length;
    const double head = std::min(kMaxHead, kHeadFraction * length);
    const QColor &colour = arrows.isOfVelocity() ? m_colours.velocity : m_colours.acceleration;
    addLine(tail, tip - kBeyondLine * head * direction, QPen(colour, kArrowLine, line, Qt::FlatCap));
    addArrowHead(tip, direction, head, colour);
    if (!arrows.isOfVelocity()) {
        addArrowHead(tip - kHollowStart * head * direction, direction, kHollowLength * head, m_paper);
    }
    avoid({tail, tip}, kOccupiedWidth);
}

void MechanismSketch::addMotionArrows(const ArrowScale &arrows, std::span<const LinkagePoint> points)
{
    for (const LinkagePoint point : points) {
        const PointMotion motion = m_scene->motion(point);
        const PlaneVector &vector = motion.*arrows.vector;
        const double amount = vector.length();
        if (amount > 0.0 && std::isfinite(amount) && arrows.amount > 0.0) {
            constexpr double kRounding = 1e-9; // relative error of an amount
            const bool isShortened = amount > arrows.largest * (1.0 + kRounding);
            const double shownAmount = std::min(amount, arrows.largest);
            const double mmPerUnit = (shownAmount / amount) * arrows.length / arrows.amount;
            const QPointF tail(motion.position.x, motion.position.y);
            const QPointF tip = toPixels(tail + mmPerUnit * QPointF(vector.x, vector.y));
            addArrow(toPixels(tail), tip, arrows, isShortened ? Qt::DashLine : Qt::SolidLine);
            addArrowName({toPixels(tail), tip}, point, arrows);
        }
    }
}

/// Adds the name of an arrow at its tip, unless the arrow is too short to be distinguished.
void MechanismSketch::addArrowName(const QLineF &arrow, LinkagePoint point, const ArrowScale &arrows)
{
    constexpr double kMinNamedLength = 12.0; // px
    constexpr double kGap = 3.0;             // px
    if (arrow.length() < kMinNamedLength || !QRectF(QPointF(), projection().size).contains(arrow.p2())) {
        return;
    }
    const QString name = QLatin1String(arrows.isOfVelocity() ? "v_" : "a_") + pointName(point);
    addLabelBeside(arrow.p2(), unitVector(arrow.p2() - arrow.p1()), kGap, name, m_ink, TextSize::Small);
}

/// Adds the coupler's instant centre P with rays to A and B.
void MechanismSketch::addInstantCentre()
{
    const std::optional<InstantCentre> centre = instantCentre(mechanism(), m_scene->pose.time);
    if (!centre) {
        return;
    }
    if (m_legend == Legend::InCorner) {
        addInstantCentreText(*centre, cornerLineCount());
    }
    if (isAtInfinity(*centre, mechanism())) {
        return;
    }
    const QPointF P = toPixels({centre->position.x, centre->position.y});
    addRay(LinkagePoint::A, P);
    addRay(LinkagePoint::B, P);
    if (QRectF(QPointF(), projection().size).contains(P)) {
        constexpr double kRadius = 5.0;
        constexpr double kHalfCross = 8.0;
        constexpr double kLabelGap = 11.0;
        const QPen pen(m_colours.velocity, kPathLine); // as the arrows of velocities
        addCircle(P, kRadius, pen);
        addLine(P - QPointF(kHalfCross, 0.0), P + QPointF(kHalfCross, 0.0), pen);
        addLine(P - QPointF(0.0, kHalfCross), P + QPointF(0.0, kHalfCross), pen);
        addLabelBeside(P, {1.0, -0.3}, kLabelGap, "P", m_ink);
    }
}

/// Adds the text about the instant centre to the legend, beginning in that line.
void MechanismSketch::addInstantCentreText(const InstantCentre &centre, int line)
{
    for (const QString &lineText : instantCentreText(centre, mechanism()).split(u'\n')) {
        addCornerLabel(line++, 0.0, lineText);
        avoid(m_labels.back().box);
    }
}

void MechanismSketch::addLegend()
{
    addScales(0);
    const std::optional<InstantCentre> centre =
        m_scene->settings.instantCentre && m_poseExists ? instantCentre(mechanism(), m_scene->pose.time) : std::nullopt;
    if (centre) {
        addInstantCentreText(*centre, scaleCount());
    }
    if (hasProblemInLegend()) {
        m_labels.push_back({.text = problemText(),
                            .box = problemBoxInLegend(),
                            .ink = m_ink,
                            .paper = Qt::transparent,
                            .alignment = Qt::TextWordWrap});
    }
}

/// Returns whether the reason why the mechanism cannot be assembled is in the legend, because it would cover the
/// drawing. A mechanism that can be assembled at other angles has the reason in a corner of the drawing, which would
/// otherwise jump while the crank turns.
bool MechanismSketch::hasProblemInLegend() const
{
    return m_legend == Legend::Separate && m_scene->result && !m_poseExists &&
           limits().mobility == Mobility::Impossible;
}

QRectF MechanismSketch::problemBoxInLegend() const
{
    constexpr double kMargin = 6.0;          // px, at either side
    constexpr double kUnlimitedHeight = 1e4; // px
    const QRectF available(kMargin, cornerLineTop(scaleCount()),
                           std::max(1.0, projection().size.width() - 2.0 * kMargin), kUnlimitedHeight);
    return QFontMetricsF(m_font).boundingRect(available, Qt::TextWordWrap, problemText());
}

double MechanismSketch::legendHeight() const
{
    if (hasProblemInLegend()) {
        return problemBoxInLegend().bottom();
    }
    const int lines = scaleCount() + (m_scene->settings.instantCentre ? kLinesOfInstantCentre : 0);
    return lines == 0 ? 0.0 : cornerLineTop(lines);
}

/// Adds a line from the point towards P and the mark of the right angle between this line and the velocity.
void MechanismSketch::addRay(LinkagePoint point, QPointF centre)
{
    constexpr double kMark = 15.0; // px, side of the mark
    const PlaneVector velocity = m_scene->motion(point).velocity;
    const QPointF pin = point == LinkagePoint::A ? m_A : m_B;
    const QPointF ray = unitVector(centre - pin);
    const double visibleLength =
        std::min(QLineF(pin, centre).length(), projection().size.width() + projection().size.height());
    addLine(pin, pin + visibleLength * ray, QPen(m_muted, kHairline, Qt::DashLine));
    if (visibleLength > kMark && velocity.length() > 0.0) {
        const QPointF along = kMark * unitVector({velocity.x, -velocity.y});
        addLine(pin + kMark * ray, pin + kMark * ray + along, QPen(m_muted, kHairline));
        addLine(pin + kMark * ray + along, pin + along, QPen(m_muted, kHairline));
    }
}

void MechanismSketch::addNames()
{
    constexpr double kBesideSupport = kBesideJoint + 8.0; // px, from O2
    constexpr double kBesideArc = 3.0;                    // px
    constexpr double kBesideSlider = 20.0;                // px, from B
    const QPointF coupler = m_poseExists ? unitVector(m_B - m_A) : QPointF();
    const double arc = m_scene->settings.angles ? arcRadius({m_O2, m_A}, kLargestCrankArc) : 0.0;
    addLabelBeside(m_O2, {-1.0, 0.4}, std::max(kBesideSupport, arc + kBesideArc), "O₂", m_ink);
    addLabelBeside(m_A, unitVector(m_A - m_O2) - coupler, kBesideJoint, "A", m_ink);
    if (m_poseExists) {
        const QPointF across(coupler.y(), -coupler.x());
        addLabelBeside(m_B, {0.0, -1.0}, kBesideSlider, "B", m_ink);
        addLabelBeside(0.5 * (m_A + m_B), across.y() < 0.0 ? across : -across, kBesideJoint, "G₃", m_ink);
    }
}

/// Adds the letters a and b below their links.
void MechanismSketch::addLengthLetters()
{
    for (const auto &[letter, link] : {std::pair("a", QLineF(m_O2, m_A)), {"b", QLineF(m_A, m_B)}}) {
        const QPointF across(-link.dy(), link.dx());
        constexpr double kFractionOfLink = 0.6; // away from the joints and the centre of mass
        constexpr double kGap = 7.0;            // px
        addLabelBeside(link.pointAt(kFractionOfLink), across.y() > 0.0 ? across : -across, kGap, letter, m_ink);
    }
}

/// Adds an angle of a link, measured from the x direction. Its number is the same as in the plots and the timeline. If
/// the angle is larger than a whole turn, the arc shows the part beyond whole turns.
void MechanismSketch::addAngle(const QString &name, const QLineF &link, double angle, double largestRadius)
{
    constexpr double kBeyondArc = 8.0;     // px, by which the base line is longer than the radius
    constexpr double kInk = 0.7;           // share of the ink in the colour of the arc
    constexpr double kOccupiedWidth = 2.0; // px
    constexpr double kLabelGap = 20.0;     // px
    constexpr double kLabelSlope = 0.5;    // slope of the direction from the joint to the label
    constexpr double kDegreesPerTurn = 360.0;
    const double radius = arcRadius(link, largestRadius);
    const QLineF base(link.p1(), link.p1() + QPointF(radius + kBeyondArc, 0.0));
    QRectF circle(0.0, 0.0, 2.0 * radius, 2.0 * radius);
    circle.moveCenter(link.p1());
    QPainterPath path(base.p1());
    path.lineTo(base.p2());
    path.arcMoveTo(circle, 0.0);
    path.arcTo(circle, 0.0, std::fmod(kDegreesPerRadian * angle, kDegreesPerTurn));
    add(path, QPen(faded(m_ink, kInk), kHairline));
    avoid(base, kOccupiedWidth);
    constexpr double kStep = 0.1; // rad; smaller than a letter
    for (double along = 0.0; along < std::abs(std::fmod(angle, kTurn)); along += kStep) {
        const double direction = std::copysign(along, angle);
        avoid(QRectF(link.p1() + radius * QPointF(std::cos(direction), -std::sin(direction)), QSizeF(1.0, 1.0)));
    }
    // The label is on the side of the base line away from the arc, so that it need not move while the angle changes.
    addLabelBeside(link.p1(), {1.0, angle < 0.0 ? -kLabelSlope : kLabelSlope}, kLabelGap,
                   QStringLiteral("%1 = %2").arg(name, angleText(angle)), m_ink);
}

} // namespace slidercrank
