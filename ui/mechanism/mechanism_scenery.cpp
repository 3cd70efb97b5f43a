// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/mechanism/mechanism_sketch.h"

#include "ui/mechanism/mechanism_text.h"
#include "ui/text/notation.h"
#include "ui/text/written_number.h"

#include <algorithm>
#include <cmath>

namespace slidercrank
{

namespace
{

constexpr double kBelowLine = 13.0; // px, from the slider's line to the rail
constexpr double kHatch = 7.0;      // px, height of the hatching below a line of ground

} // namespace

MechanismSketch::MechanismSketch(const MechanismScene &scene, const MechanismProjection &projection,
                                 const QPalette &palette, const QFont &font, Legend legend)
    : MechanismDrawing(projection, palette, font)
    , m_scene(&scene)
    , m_legend(legend)
    , m_O2(toPixels({0.0, 0.0}))
{
    if (scene.result) {
        m_A = toPixels(scene.crankPin());
        m_B = toPixels(scene.wristPin());
        m_poseExists = scene.pose.exists();
    }
}

void MechanismSketch::addScenery()
{
    if (m_scene->result) {
        addGrid();
        addCrankCircle();
        addGuideAndDeadCentres();
        addPathOfG3();
        addSupportOfO2();
        addDimensionsAndScales();
    }
}

/// Adds the grid, with numbers along the lower and the left edge.
void MechanismSketch::addGrid()
{
    constexpr double kMinSpacing = 50.0; // px
    const double perMm = shownValue(Measure::Length, 1.0, notation().units);
    const double shownStep = nextRoundNumber(kMinSpacing / projection().scale * perMm); // in the chosen unit
    const double step = shownStep / perMm;
    const QRectF visibleArea = projection().visible();
    const auto captions = deadCentreCaptions(); // a number that one of them would cover is left out
    const auto addNumber = [&](QPointF lowerLeft, const QString &text) {
        const QSizeF extent = textSize(text, TextSize::Small);
        const QRectF box(lowerLeft - QPointF(-1.0, extent.height()), extent);
        if (std::ranges::none_of(captions, [&](const Caption &caption) { return caption.box.intersects(box); })) {
            m_labels.push_back({.text = text, .box = box, .ink = m_muted, .paper = Qt::transparent, .isSmall = true});
        }
        return box;
    };
    const QRectF corner = addNumber({1.0, projection().size.height()}, shownUnit(Measure::Length));
    for (double i = std::ceil(visibleArea.left() / step); i <= std::floor(visibleArea.right() / step); i += 1.0) {
        const double x = std::floor(toPixels({i * step, 0.0}).x());
        m_grid << QRectF(x, 0.0, 1.0, projection().size.height());
        const QString text = numberText(i * shownStep);
        if (x > corner.right() && x + textSize(text, TextSize::Small).width() < projection().size.width()) {
            addNumber({x, projection().size.height()}, text);
        }
    }
    // The offset's dimension, with its letter on the left, may lie over the left edge.
    const MechanismSettings &settings = m_scene->settings;
    const bool isCovered = settings.dimensions && offsetDimension().x1() < 2.0 * corner.right();
    const int legendLines =
        cornerLineCount() + (m_legend == Legend::InCorner ? kLinesOfInstantCentre * int(settings.instantCentre) : 0);
    const double top = isCovered ? corner.top() : cornerLineTop(legendLines);
    for (double i = std::ceil(visibleArea.top() / step); i <= std::floor(visibleArea.bottom() / step); i += 1.0) {
        const double y = std::floor(toPixels({0.0, i * step}).y());
        m_grid << QRectF(0.0, y, projection().size.width(), 1.0);
        if (y - corner.height() > top && y < corner.top()) {
            addNumber({1.0, y}, numberText(i * shownStep));
        }
    }
}

/// Adds a line of ground, with hatching below it.
void MechanismSketch::addGround(QPointF from, double to, DrawnPart part)
{
    QPainterPath path(from);
    path.lineTo(to, from.y());
    for (double x = from.x() + kHatch; x <= to; x += kHatch) {
        path.moveTo(x, from.y());
        path.lineTo(x - kHatch, from.y() + kHatch);
    }
    add(path, QPen(m_muted, kGroundLine), Qt::NoBrush, part);
}

/// Adds the circle of the crank pin, with marks where the mechanism cannot be assembled.
void MechanismSketch::addCrankCircle()
{
    constexpr double kCircleInk = 0.35; // share of the ink in its colour
    const double radius = projection().scale * mechanism().a();
    addCircle(m_O2, radius, QPen(faded(m_ink, kCircleInk), kHairline, Qt::DashLine));
    const QRectF circle = m_shapes.back().path.boundingRect();
    for (const CrankRange &range : forbiddenRanges(limits())) {
        QPainterPath arc;
        arc.arcMoveTo(circle, range.from * kDegreesPerRadian);
        arc.arcTo(circle, range.from * kDegreesPerRadian, (range.to - range.from) * kDegreesPerRadian);
        add(arc, QPen(m_colours.warning, kForbiddenLine, Qt::SolidLine, Qt::FlatCap), Qt::NoBrush, ForbiddenArc);
    }
}

/// Returns the rail along the slider's travel, with its hatching.
QRectF MechanismSketch::rail() const
{
    constexpr double kOverhang = 23.0;   // px that the rail is longer than the stroke, at either end
    constexpr double kBeyondEdge = 20.0; // px: a longer rail is cut off at this distance outside the drawing
    const auto [left, right] = sliderTravel(mechanism(), limits());
    const QPointF from(std::max(toPixels({left, 0.0}).x() - kOverhang, -kBeyondEdge),
                       toPixels({0.0, mechanism().c()}).y() + kBelowLine);
    const double to = std::min(toPixels({right, 0.0}).x() + kOverhang, projection().size.width() + kBeyondEdge);
    return {from, QSizeF(to - from.x(), kHatch)};
}

/// Returns the marks of the dead centres, across the slider's line.
std::vector<MechanismSketch::DeadCentreMark> MechanismSketch::deadCentreMarks() const
{
    constexpr double kAboveLine = 20.0; // px
    std::vector<DeadCentreMark> marks;
    for (const auto &[centre, part] :
         {std::pair(limits().outerDeadCentre, OuterDeadCentre), {limits().innerDeadCentre, InnerDeadCentre}}) {
        if (centre) {
            const QPointF place = toPixels({centre->R4x, mechanism().c()});
            marks.push_back({part, QLineF(place - QPointF(0.0, kAboveLine), place + QPointF(0.0, kBelowLine))});
        }
    }
    return marks;
}

void MechanismSketch::addGuideAndDeadCentres()
{
    const double y = toPixels({0.0, mechanism().c()}).y();
    addLine({0.0, y}, {projection().size.width(), y}, QPen(m_muted, kHairline, Qt::DashDotLine), Guide);
    addGround(rail().topLeft(), rail().right(), Guide);
    for (const DeadCentreMark &mark : deadCentreMarks()) {
        addLine(mark.line.p1(), mark.line.p2(), QPen(m_muted, kGroundLine), mark.part);
    }
}

/// Returns the names of the dead centres and their places, each below its own mark. Where two full names do not fit,
/// they are shortened. A short name moves away from the edge of the drawing, and is left out if it does not fit.
std::vector<MechanismSketch::Caption> MechanismSketch::deadCentreCaptions() const
{
    if (!m_scene->settings.names) {
        return {};
    }
    const auto makeCaptions = [this](const QString &outer, const QString &inner) {
        std::vector<Caption> made;
        for (const auto &[centre, name] :
             {std::pair(limits().outerDeadCentre, outer), {limits().innerDeadCentre, inner}}) {
            if (centre) {
                const QPointF mark = toPixels({centre->R4x, mechanism().c()});
                QRectF box(QPointF(), textSize(name, TextSize::Small));
                box.moveCenter(mark + QPointF(0.0, kBelowLine + kHatch + 2.0 + 0.5 * box.height()));
                made.push_back({name, box});
            }
        }
        return made;
    };
    const double numbers = textSize({}, TextSize::Small).height(); // of the grid, along the lower edge
    const QRectF inside = QRectF(QPointF(), projection().size).adjusted(0.0, 0.0, 0.0, -numbers);
    const QRectF pivot(m_O2 - QPointF(kSupportSize, 0.0), QSizeF(2.0 * kSupportSize, kSupportSize + kHatch));
    const auto fits = [&](const QRectF &box) { return inside.contains(box) && !box.intersects(pivot); };
    const auto allFit = [&](const std::vector<Caption> &captions) {
        const bool areApart = captions.size() < 2 || !captions.front().box.intersects(captions.back().box);
        return areApart && std::ranges::all_of(captions, fits, &Caption::box);
    };
    std::vector<Caption> captions = makeCaptions(tr("outer dead centre"), tr("inner dead centre"));
    if (!allFit(captions)) {
        captions = makeCaptions(tr("outer", "dead centre"), tr("inner", "dead centre"));
        for (auto &[text, box] : captions) {
            if (box.center().x() >= 0.0 && box.center().x() <= projection().size.width()) {
                box.moveLeft(std::max(0.0, std::min(box.left(), projection().size.width() - box.width())));
            }
        }
        std::erase_if(captions, [&](const Caption &caption) { return !fits(caption.box); });
        if (!allFit(captions)) {
            captions.clear(); // the dead centres are too close together
        }
    }
    return captions;
}

void MechanismSketch::addPathOfG3()
{
    if (!m_scene->settings.path) {
        return;
    }
    constexpr int kSteps = 180;
    constexpr double kPathInk = 0.75; // share of the model's colour
    QPainterPath path;
    for (const CrankRange &range : limits().ranges) {
        QPolygonF points;
        for (const double theta2 : anglesAcross(range, kSteps)) {
            const LinkageMotion motion = linkageMotion(withCrankAt(mechanism(), theta2), 0.0);
            const PlaneVector &centre = motionOf(motion, LinkagePoint::G3).position;
            if (!std::isnan(centre.x)) {
                points << toPixels({centre.x, centre.y});
            }
        }
        path.addPolygon(points);
    }
    add(path, QPen(faded(m_colours.model, kPathInk), kPathLine));
}

void MechanismSketch::addSupportOfO2()
{
    constexpr double kHalfFoot = 11.0; // px, of the bracket
    const QPointF foot = m_O2 + QPointF(0.0, kSupportSize);
    addGround(foot - QPointF(kSupportSize, 0.0), foot.x() + kSupportSize, Ground);
    QPainterPath bracket;
    bracket.addPolygon(QPolygonF{m_O2, foot - QPointF(kHalfFoot, 0.0), foot + QPointF(kHalfFoot, 0.0), m_O2});
    add(bracket, QPen(m_ink, kPathLine), faded(m_ink, kBodyFill), Ground);
}

void MechanismSketch::addDimensionsAndScales()
{
    const MechanismSettings &settings = m_scene->settings;
    if (settings.dimensions) {
        const QLineF offset = offsetDimension();
        addLine(offset.p1(), m_O2, QPen(m_muted, kHairline));
        constexpr double kOccupiedWidth = 2.0; // px
        constexpr double kLabelGap = 3.0;      // px
        addDimension(offset.p1(), offset.p2(), m_muted);
        avoid(offset, kOccupiedWidth);
        addLabelBeside(offset.center(), {m_O2.x() < offset.x1() ? 1.0 : -1.0, 0.0}, kLabelGap, "c", m_ink);
    }
    if (m_legend == Legend::InCorner) {
        const QStringList lengths = lengthLines();
        for (qsizetype line = 0; line < lengths.size(); ++line) {
            addCornerLabel(static_cast<int>(line), 0.0, lengths[line]);
        }
        if (hasScalesInCorner()) {
            addScales(static_cast<int>(lengths.size()));
        }
    }
}

/// Adds the scales of the arrows to the legend, beginning in that line.
void MechanismSketch::addScales(int line)
{
    constexpr double kLeft = 7.0;    // px
    constexpr double kSample = 26.0; // px, length of the arrow
    constexpr double kGap = 8.0;     // px
    const MechanismSettings &settings = m_scene->settings;
    const auto addScale = [&](const ArrowScale &arrows) {
        const QPointF left(kLeft, cornerLineTop(line) + 0.5 * textSize({}, TextSize::Small).height());
        addArrow(left, left + QPointF(kSample, 0.0), arrows, Qt::SolidLine);
        const double alpha2 = m_scene->alpha2();
        const bool hasCrankAcceleration = !arrows.isOfVelocity() && alpha2 != 0.0;
        const QString condition =
            hasCrankAcceleration ? QStringLiteral(", α₂ = %1 rad/s²").arg(numberText(alpha2)) : QString();
        addCornerLabel(line++, kSample + kGap, arrowScaleText(arrows) + condition);
    };
    if (settings.showsVelocity()) {
        addScale(m_scene->arrows(&PointMotion::velocity));
    }
    if (settings.acceleration) {
        addScale(m_scene->arrows(&PointMotion::acceleration));
    }
}

int MechanismSketch::scaleCount() const
{
    return int(m_scene->settings.showsVelocity()) + int(m_scene->settings.acceleration);
}

/// Returns the vertical line from the height of O2 to the slider's line, beside the crank's circle on the side away
/// from the coupler.
QLineF MechanismSketch::offsetDimension() const
{
    constexpr double kBesideCircle = 14.0; // px
    const double side = mechanism().branch() == Branch::Open ? -1.0 : 1.0;
    const double x = toPixels({side * mechanism().a(), 0.0}).x() + side * kBesideCircle;
    return {x, m_O2.y(), x, toPixels({0.0, mechanism().c()}).y()};
}

/// Returns whether a legend of `lines` in the upper left corner covers neither the slider's line nor the crank's
/// circle. In a very low drawing it would.
bool MechanismSketch::isSpaceInCorner(qsizetype lines) const
{
    const double top = toPixels({0.0, std::max(mechanism().a(), mechanism().c())}).y(); // of both, px
    return cornerLineTop(static_cast<int>(lines)) < top;
}

bool MechanismSketch::hasScalesInCorner() const
{
    return m_legend == Legend::InCorner && isSpaceInCorner(lengthLines().size() + scaleCount());
}

/// Returns the lengths as they are written in the upper left corner: in one line if the button for the assembly leaves
/// space for it, otherwise below each other; empty where there is no space.
QStringList MechanismSketch::lengthLines() const
{
    constexpr double kMaxButtonFraction = 0.45; // fraction of the width that the button takes
    if (!m_scene->settings.dimensions) {
        return {};
    }
    QStringList lengths;
    for (const Parameter length : {Parameter::A, Parameter::B, Parameter::C}) {
        lengths << lengthText(mechanism(), length);
    }
    const QString line = lengths.join("   ");
    if (textSize(line, TextSize::Small).width() < (1.0 - kMaxButtonFraction) * projection().size.width()) {
        lengths = QStringList(line);
    }
    return isSpaceInCorner(lengths.size()) ? lengths : QStringList();
}

int MechanismSketch::cornerLineCount() const
{
    const int scales = hasScalesInCorner() ? scaleCount() : 0;
    return m_legend == Legend::InCorner ? static_cast<int>(lengthLines().size()) + scales : 0;
}

} // namespace slidercrank
