// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/mechanism/mechanism_sketch.h"

#include "ui/mechanism/mechanism_text.h"
#include "ui/text/written_number.h"

#include <algorithm>
#include <cmath>

namespace slidercrank
{

namespace
{

constexpr double kBelowLine = 13.0; // from the slider's line to the rail

} // namespace

MechanismSketch::MechanismSketch(const MechanismScene &scene, const MechanismProjection &projection,
                                 const QPalette &palette, const QFont &font)
    : MechanismDrawing(projection, palette, font)
    , m_scene(&scene)
    , m_O2(toPixels({0.0, 0.0}))
{
    if (scene.result) {
        m_A = toPixels(scene.crankPin());
        m_B = toPixels(scene.wristPin());
        m_exists = scene.pose.exists();
    }
}

void MechanismSketch::addScenery()
{
    if (m_scene->result) {
        addGrid();
        addCrankCircle();
        addGuide();
        addPath();
        addPivot();
        addDimensionsAndScales();
    }
}

/// Adds the grid, with numbers along the lower and the left edge.
void MechanismSketch::addGrid()
{
    constexpr double kLeastSpacing = 50.0; // px
    const double step = nextRoundNumber(kLeastSpacing / scale);
    const QRectF shown = visible();
    const auto addNumber = [this](QPointF lowerLeft, const QString &text) {
        const QSizeF extent = textSize(text, true);
        const QRectF box(lowerLeft - QPointF(-1.0, extent.height()), extent);
        m_labels.push_back({text, box, m_muted, Qt::transparent, true});
        return box;
    };
    const QRectF corner = addNumber({1.0, size.height()}, tr("mm"));
    for (double i = std::ceil(shown.left() / step); i <= std::floor(shown.right() / step); i += 1.0) {
        const double x = std::floor(toPixels({i * step, 0.0}).x());
        m_grid << QRectF(x, 0.0, 1.0, size.height());
        const QString text = numberText(i * step);
        if (x > corner.right() && x + textSize(text, true).width() < size.width()) {
            addNumber({x, size.height()}, text);
        }
    }
    // The offset's dimension, with its letter on the left, may lie over the left edge.
    const MechanismSettings &settings = m_scene->settings;
    const bool isCovered = settings.dimensions && offsetDimension().x1() < 2.0 * corner.right();
    const double top = isCovered ? corner.top() : cornerLineTop(cornerLineCount() + 2 * int(settings.instantCentre));
    for (double i = std::ceil(shown.top() / step); i <= std::floor(shown.bottom() / step); i += 1.0) {
        const double y = std::floor(toPixels({0.0, i * step}).y());
        m_grid << QRectF(0.0, y, size.width(), 1.0);
        if (y - corner.height() > top && y < corner.top()) {
            addNumber({1.0, y}, numberText(i * step));
        }
    }
}

/// Adds a line of ground, with hatching below it.
void MechanismSketch::addGround(QPointF from, double to, DrawnPart part)
{
    constexpr double kSpacing = 7.0;
    QPainterPath path(from);
    path.lineTo(to, from.y());
    for (double x = from.x() + kSpacing; x <= to; x += kSpacing) {
        path.moveTo(x, from.y());
        path.lineTo(x - kSpacing, from.y() + kSpacing);
    }
    add(path, QPen(m_muted, 1.2), Qt::NoBrush, part);
}

/// Adds the circle of the crank pin, with marks where the mechanism cannot be assembled.
void MechanismSketch::addCrankCircle()
{
    const double radius = scale * mechanism().a();
    addCircle(m_O2, radius, QPen(faded(m_ink, 0.35), 1.0, Qt::DashLine));
    const QRectF circle = m_shapes.back().path.boundingRect();
    for (const CrankRange &range : forbiddenRanges(limits())) {
        QPainterPath arc;
        arc.arcMoveTo(circle, range.from * kDegreesPerRadian);
        arc.arcTo(circle, range.from * kDegreesPerRadian, (range.to - range.from) * kDegreesPerRadian);
        add(arc, QPen(m_colours.warning, 3.0, Qt::SolidLine, Qt::FlatCap), Qt::NoBrush, ForbiddenArc);
    }
}

/// Adds the slider's line, the rail along the slider's travel, and the dead centres.
void MechanismSketch::addGuide()
{
    constexpr double kOverhang = 23.0;   // px that the rail is longer than the stroke, at either end
    constexpr double kOutOfSight = 20.0; // px
    constexpr double kMark = 20.0;       // px that a dead centre's mark rises above the line
    const double y = toPixels({0.0, mechanism().c()}).y();
    addLine({0.0, y}, {size.width(), y}, QPen(m_muted, 1.0, Qt::DashDotLine), Guide);
    const QRectF bounds = motionBounds(mechanism(), limits());
    double left = bounds.left();
    double right = bounds.right();
    if (limits().mobility == Mobility::FullTurn && limits().inner && limits().outer) {
        std::tie(left, right) = std::minmax(limits().inner->R4x, limits().outer->R4x);
    }
    addGround({std::max(toPixels({left, 0.0}).x() - kOverhang, -kOutOfSight), y + kBelowLine},
              std::min(toPixels({right, 0.0}).x() + kOverhang, size.width() + kOutOfSight), Guide);
    for (const auto &[centre, part] : {std::pair(limits().outer, OuterDeadCentre), {limits().inner, InnerDeadCentre}}) {
        if (centre) {
            const double x = toPixels({centre->R4x, 0.0}).x();
            addLine({x, y - kMark}, {x, y + kBelowLine}, QPen(m_muted, 1.2), part);
        }
    }
}

/// Adds the path of G3.
void MechanismSketch::addPath()
{
    if (!m_scene->settings.path) {
        return;
    }
    constexpr int kSteps = 180;
    QPainterPath path;
    for (const CrankRange &range : limits().ranges) {
        QPolygonF points;
        for (const double theta2 : anglesAcross(range, kSteps)) {
            const LinkageMotion motion = linkageMotion(withCrankAt(mechanism(), theta2), 0.0);
            const PlaneVector &centre = motion[static_cast<std::size_t>(LinkagePoint::G3)].position;
            if (!std::isnan(centre.x)) {
                points << toPixels({centre.x, centre.y});
            }
        }
        path.addPolygon(points);
    }
    add(path, QPen(faded(m_colours.model, 0.75), 1.4));
}

/// Adds the support of O2.
void MechanismSketch::addPivot()
{
    const QPointF foot = m_O2 + QPointF(0.0, 17.0);
    addGround(foot - QPointF(17.0, 0.0), foot.x() + 17.0, Ground);
    QPainterPath bracket;
    bracket.addPolygon(QPolygonF{m_O2, foot - QPointF(11.0, 0.0), foot + QPointF(11.0, 0.0), m_O2});
    add(bracket, QPen(m_ink, 1.4), faded(m_ink, 0.15), Ground);
}

void MechanismSketch::addDimensionsAndScales()
{
    const MechanismSettings &settings = m_scene->settings;
    int line = 0;
    if (settings.dimensions) {
        const QLineF offset = offsetDimension();
        addLine(offset.p1(), m_O2, QPen(m_muted, 1.0));
        addDimension(offset.p1(), offset.p2(), m_muted);
        addLabelBeside(offset.center(), {m_O2.x() < offset.x1() ? 1.0 : -1.0, 0.0}, 3.0, "c", m_ink);
        QStringList lengths;
        for (const Parameter length : {Parameter::A, Parameter::B, Parameter::C}) {
            lengths << lengthText(mechanism(), length);
        }
        addCornerLabel(line++, 0.0, lengths.join("   "));
    }
    const auto addScale = [&](bool isShown, const ArrowScale &arrows) {
        constexpr double kSample = 26.0;
        if (isShown) {
            const QPointF left(7.0, cornerLineTop(line) + 0.5 * textSize({}, true).height());
            addArrow(left, left + QPointF(kSample, 0.0), arrows, false);
            addCornerLabel(line++, kSample + 8.0, arrowScaleText(arrows));
        }
    };
    addScale(settings.showsVelocity(), m_scene->arrows(&PointMotion::velocity));
    addScale(settings.acceleration, m_scene->arrows(&PointMotion::acceleration));
}

/// Returns the vertical line from the height of O2 to the slider's line, beside the crank's circle on the side away
/// from the coupler.
QLineF MechanismSketch::offsetDimension() const
{
    constexpr double kBesideCircle = 14.0;
    const double side = mechanism().branch() == Branch::Open ? -1.0 : 1.0;
    const double x = toPixels({side * mechanism().a(), 0.0}).x() + side * kBesideCircle;
    return {x, m_O2.y(), x, toPixels({0.0, mechanism().c()}).y()};
}

/// Returns the number of text lines in the upper left corner.
int MechanismSketch::cornerLineCount() const
{
    const MechanismSettings &settings = m_scene->settings;
    return int(settings.dimensions) + int(settings.showsVelocity()) + int(settings.acceleration);
}

} // namespace slidercrank
