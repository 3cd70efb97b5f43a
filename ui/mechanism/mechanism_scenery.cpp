// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/mechanism/mechanism_scenery.h"

#include "ui/mechanism/mechanism_labels.h"
#include "ui/text/written_number.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace slidercrank
{

namespace
{

struct MechanismScenery {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::MechanismScenery)
};

constexpr double kHatchSpacing = 7.0; ///< px

/// In the upper left corner.
int valueLineCount(const MechanismCanvas &on, const MechanismDrawing &drawing)
{
    return drawing.settings.dimensions ? static_cast<int>(valueLines(on, drawing.mechanism()).size()) : 0;
}

/// A line of ground with short strokes below it.
void paintGround(QPainter &painter, QPointF from, QPointF to)
{
    painter.drawLine(from, to);
    const double length = to.x() - from.x();
    const int strokes = static_cast<int>(std::floor(length / kHatchSpacing));
    for (int i = 0; i < strokes; ++i) {
        const QPointF top(from.x() + (i + 1) * kHatchSpacing, from.y());
        painter.drawLine(top, top + QPointF(-kHatchLength, kHatchLength));
    }
}

QRectF circleOf(const MechanismCanvas &on, double radius)
{
    const QPointF pivot = on.toPixels({0.0, 0.0});
    const double pixels = on.scale * radius;
    return QRectF(pivot.x() - pixels, pivot.y() - pixels, 2.0 * pixels, 2.0 * pixels);
}

void paintForbidden(QPainter &painter, const MechanismCanvas &on, const MechanismDrawing &drawing, double width)
{
    const QRectF circle = circleOf(on, drawing.mechanism().a());
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(on.colours.warning, width, Qt::SolidLine, Qt::FlatCap));
    for (const CrankRange &range : forbiddenRanges(drawing.result->limits)) {
        QPainterPath arc;
        arc.arcMoveTo(circle, range.from * kDegreesPerRadian);
        arc.arcTo(circle, range.from * kDegreesPerRadian, (range.to - range.from) * kDegreesPerRadian);
        painter.drawPath(arc);
    }
}

void paintCircle(QPainter &painter, const MechanismCanvas &on, const MechanismDrawing &drawing)
{
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(mixed(on.colours.text, on.colours.background, 0.35), 1.0, Qt::DashLine));
    painter.drawEllipse(circleOf(on, drawing.mechanism().a()));
    paintForbidden(painter, on, drawing, 3.0);
}

void paintDeadCentre(QPainter &painter, const MechanismCanvas &on, const MechanismDrawing &drawing,
                     const std::optional<DeadCentre> &centre)
{
    if (centre) {
        const QPointF at = on.toPixels({centre->R4x, drawing.mechanism().c()});
        painter.drawLine(at + QPointF(0.0, -kDeadCentreMark), at + QPointF(0.0, kRailBelowLine));
    }
}

/// The slider's line, its rail as far as the slider goes, and the dead centres.
void paintGuide(QPainter &painter, const MechanismCanvas &on, const MechanismDrawing &drawing)
{
    const double line = on.toPixels({0.0, drawing.mechanism().c()}).y();
    painter.setPen(QPen(on.muted, 1.0, Qt::DashDotLine));
    painter.drawLine(QPointF(0.0, line), QPointF(on.size.width(), line));
    painter.setPen(QPen(on.muted, 1.2));
    const Rail rail = railOf(drawing);
    double left = on.toPixels({rail.left, 0.0}).x() - kRailOverhang;
    const double right = std::min(on.toPixels({rail.right, 0.0}).x() + kRailOverhang, on.size.width() + kHatchSpacing);
    if (left < -kHatchSpacing) { // out of sight: not to be hatched, and the strokes in sight stay where they are
        left += kHatchSpacing * std::floor(-left / kHatchSpacing - 1.0);
    }
    if (left < right) {
        paintGround(painter, {left, line + kRailBelowLine}, {right, line + kRailBelowLine});
    }
    paintDeadCentre(painter, on, drawing, drawing.result->limits.outer);
    paintDeadCentre(painter, on, drawing, drawing.result->limits.inner);
}

/// O₂: a pivot on the ground.
void paintPivot(QPainter &painter, const MechanismCanvas &on)
{
    const QPointF pivot = on.toPixels({0.0, 0.0});
    const QPointF foot = pivot + QPointF(0.0, kGroundDepth - kHatchLength);
    painter.setPen(QPen(on.muted, 1.2));
    paintGround(painter, foot + QPointF(-kGroundHalfWidth, 0.0), foot + QPointF(kGroundHalfWidth, 0.0));
    painter.setPen(QPen(on.colours.text, 1.4));
    painter.setBrush(mixed(on.colours.text, on.colours.background, 0.15));
    painter.drawPolygon(QPolygonF{pivot, foot + QPointF(-11.0, 0.0), foot + QPointF(11.0, 0.0)});
    paintJoint(painter, pivot, on.colours.text, on.colours.background);
}

void paintPath(QPainter &painter, const MechanismCanvas &on, const Cycle &cycle)
{
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(mixed(on.colours.model, on.colours.background, 0.75), 1.4));
    for (const std::vector<LinkageMotion> &arc : cycle) {
        QPolygonF path;
        for (const LinkageMotion &instant : arc) {
            const PlaneVector &centre = instant[static_cast<std::size_t>(LinkagePoint::G3)].position;
            path << on.toPixels({centre.x, centre.y});
        }
        painter.drawPolyline(path);
    }
}

} // namespace

int cornerLineCount(const MechanismCanvas &on, const MechanismDrawing &drawing)
{
    const MechanismSettings &settings = drawing.settings;
    return valueLineCount(on, drawing) + (settings.showsVelocity() ? 1 : 0) + (settings.acceleration ? 1 : 0);
}

Rail railOf(const MechanismDrawing &drawing)
{
    const MotionLimits &limits = drawing.result->limits;
    if (limits.mobility == Mobility::FullTurn && limits.inner && limits.outer) {
        return {std::min(limits.inner->R4x, limits.outer->R4x), std::max(limits.inner->R4x, limits.outer->R4x)};
    }
    const QRectF reach = characteristicLength(drawing.mechanism(), limits);
    return {reach.left(), reach.right()};
}

void paintGrid(QPainter &painter, const MechanismCanvas &on, const MechanismDrawing &drawing)
{
    painter.fillRect(QRectF(QPointF(0.0, 0.0), on.size), on.colours.background);
    if (!drawing.result) {
        return;
    }
    constexpr double kLeastSpacing = 50.0; // px
    const double step = nextRoundNumber(kLeastSpacing / on.scale);
    const QRectF visible = on.visible();
    painter.setFont(on.smallFont);
    const QFontMetricsF metrics(on.smallFont);
    const double textHeight = metrics.height();
    const double cornerWidth = metrics.horizontalAdvance(MechanismScenery::tr("mm")) + 10.0;
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.setPen(QPen(on.colours.grid, on.hairline));
    const auto forEachLine = [step](double from, double to, const auto &paint) {
        for (double i = std::ceil(from / step); i <= std::floor(to / step); i += 1.0) {
            paint(i * step);
        }
    };
    forEachLine(visible.left(), visible.right(), [&](double x) {
        const double pixel = on.toPixels({x, 0.0}).x();
        painter.drawLine(QPointF(pixel, 0.0), QPointF(pixel, on.size.height()));
    });
    forEachLine(visible.top(), visible.bottom(), [&](double y) {
        const double pixel = on.toPixels({0.0, y}).y();
        painter.drawLine(QPointF(0.0, pixel), QPointF(on.size.width(), pixel));
    });
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(on.muted);
    painter.drawText(QPointF(4.0, on.size.height() - 4.0), MechanismScenery::tr("mm"));
    forEachLine(visible.left(), visible.right(), [&](double x) {
        const QString text = numberText(x);
        const double left = on.toPixels({x, 0.0}).x() + 3.0;
        if (left > cornerWidth && left + metrics.horizontalAdvance(text) < on.size.width()) {
            painter.drawText(QPointF(left, on.size.height() - 4.0), text);
        }
    });
    const int lines = cornerLineCount(on, drawing);
    const double highest = lines > 0 ? cornerLine(on, lines, 0.0).top() : 0.0;
    forEachLine(visible.top(), visible.bottom(), [&](double y) {
        const double baseline = on.toPixels({0.0, y}).y() - 3.0;
        if (baseline > highest + textHeight && baseline < on.size.height() - 1.5 * textHeight) {
            painter.drawText(QPointF(4.0, baseline), numberText(y));
        }
    });
}

void paintScenery(QPainter &painter, const MechanismCanvas &on, const MechanismDrawing &drawing)
{
    if (!drawing.result) {
        return;
    }
    const MechanismSettings &settings = drawing.settings;
    painter.setRenderHint(QPainter::Antialiasing);
    paintCircle(painter, on, drawing);
    paintGuide(painter, on, drawing);
    if (settings.path) {
        paintPath(painter, on, drawing.cycle);
    }
    paintPivot(painter, on);
    int line = valueLineCount(on, drawing);
    if (settings.dimensions) {
        paintOffset(painter, on, drawing.mechanism());
        paintValues(painter, on, drawing.mechanism());
    }
    if (settings.showsVelocity()) {
        paintScale(painter, on, drawing.velocity, MotionKind::Velocity, line++);
    }
    if (settings.acceleration) {
        paintScale(painter, on, drawing.acceleration, MotionKind::Acceleration, line);
    }
}

void paintSceneryHighlight(QPainter &painter, const MechanismCanvas &on, const MechanismDrawing &drawing,
                           DrawnPart part)
{
    painter.setPen(QPen(on.highlight, 2.5));
    switch (part) {
    case DrawnPart::Guide: {
        const double line = on.toPixels({0.0, drawing.mechanism().c()}).y();
        painter.drawLine(QPointF(0.0, line), QPointF(on.size.width(), line));
        break;
    }
    case DrawnPart::OuterDeadCentre: paintDeadCentre(painter, on, drawing, drawing.result->limits.outer); break;
    case DrawnPart::InnerDeadCentre: paintDeadCentre(painter, on, drawing, drawing.result->limits.inner); break;
    case DrawnPart::ForbiddenArc: paintForbidden(painter, on, drawing, 6.0); break;
    case DrawnPart::Background:
    case DrawnPart::O2:
    case DrawnPart::A:
    case DrawnPart::B:
    case DrawnPart::G3:
    case DrawnPart::Crank:
    case DrawnPart::Coupler: break;
    }
}

} // namespace slidercrank
