// SPDX-License-Identifier: GPL-3.0-or-later
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

struct MechanismLabels {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::MechanismLabels)
};

constexpr double kTextGap = 4.0; ///< px between a link or a line and its text

/// Beside the link, on the side that `away` points to; nearer to its end, where there is neither O₂'s name nor G₃.
void paintBeside(QPainter &painter, const MechanismCanvas &on, QPointF from, QPointF to, QPointF away, double width,
                 const QString &letter)
{
    const QPointF along = unitVector(to - from);
    QPointF across(-along.y(), along.x());
    if (QPointF::dotProduct(across, away) < 0.0) {
        across = -across;
    }
    const QFontMetricsF metrics(on.font);
    const double reach =
        0.5 * (std::abs(across.x()) * metrics.horizontalAdvance(letter) + std::abs(across.y()) * metrics.xHeight());
    paintNote(painter, on, placeOfLetter(from, to) + (0.5 * width + kTextGap + reach) * across, letter);
}

} // namespace

void paintPivotName(QPainter &painter, const MechanismCanvas &on)
{
    const QString name = MechanismLabels::tr("O₂");
    painter.setFont(on.font);
    painter.setPen(on.colours.text);
    painter.drawText(on.toPixels({0.0, 0.0}) + QPointF(-16.0 - QFontMetricsF(on.font).horizontalAdvance(name), 16.0),
                     name);
}

void paintNames(QPainter &painter, const MechanismCanvas &on, const MechanismDrawing &drawing, const QColor &ink)
{
    const QPointF pivot = on.toPixels({0.0, 0.0});
    const QPointF crank = on.toPixels(drawing.pins->A);
    const QPointF slider = on.toPixels(drawing.pins->B);
    painter.setFont(on.font);
    painter.setPen(ink);
    const QRectF box(-12.0, -9.0, 24.0, 18.0);

    // A away from both links.
    const QPointF apart = unitVector(crank - pivot) + unitVector(crank - slider);
    const QPointF across(-(slider - crank).y(), (slider - crank).x()); // where crank and coupler are in one line
    const QPointF away = std::hypot(apart.x(), apart.y()) > 0.3 ? unitVector(apart) : unitVector(across);
    painter.drawText(box.translated(crank + 17.0 * away), Qt::AlignCenter, MechanismLabels::tr("A"));

    // B over the marks of the dead centres, or under the rail where the drawing ends.
    const double above = slider.y() - kBlockHalfHeight - 18.0;
    const double below = slider.y() + kRailBelowLine + kHatchLength + 11.0;
    const bool fits = above + box.top() >= 0.0 || slider.y() < 0.0;
    painter.drawText(box.translated(QPointF(slider.x(), fits ? above : below)), Qt::AlignCenter,
                     MechanismLabels::tr("B"));
    if (drawing.hasCentre()) { // above; b is below
        const QPointF normal = unitVector(across);
        painter.drawText(box.translated(0.5 * (crank + slider) + (normal.y() < 0.0 ? 17.0 : -17.0) * normal),
                         Qt::AlignCenter, MechanismLabels::tr("G₃"));
    }
}

void paintOffset(QPainter &painter, const MechanismCanvas &on, const Mechanism &mechanism)
{
    constexpr double kBesideCircle = 14.0;
    constexpr double kHead = 8.0;
    const QPointF pivot = on.toPixels({0.0, 0.0});
    const double x = on.toPixels({-mechanism.a(), 0.0}).x() - kBesideCircle;
    const double line = on.toPixels({0.0, mechanism.c()}).y();
    painter.setPen(QPen(on.muted, 1.0));
    painter.drawLine(QPointF(x - kTextGap, pivot.y()), QPointF(pivot.x() - kJointRadius, pivot.y()));
    if (std::abs(line - pivot.y()) > 1.0) {
        painter.drawLine(QPointF(x, pivot.y()), QPointF(x, line));
        const double head = std::min(kHead, 0.4 * std::abs(line - pivot.y()));
        const QPointF up(0.0, line < pivot.y() ? -1.0 : 1.0);
        paintArrowHead(painter, QPointF(x, line), up, head, on.muted);
        paintArrowHead(painter, QPointF(x, pivot.y()), -up, head, on.muted);
    }
    paintNote(painter, on, QPointF(x, 0.5 * (line + pivot.y())), QStringLiteral("c"));
}

void paintLengths(QPainter &painter, const MechanismCanvas &on, const MechanismDrawing &drawing)
{
    const QPointF pivot = on.toPixels({0.0, 0.0});
    const QPointF crank = on.toPixels(drawing.pins->A);
    const QPointF slider = on.toPixels(drawing.pins->B);
    paintBeside(painter, on, pivot, crank, pivot - slider, kCrankWidth, QStringLiteral("a"));
    paintBeside(painter, on, crank, slider, QPointF(0.0, 1.0), kCouplerWidth, QStringLiteral("b"));
}

QPointF placeOfLetter(QPointF from, QPointF to)
{
    return from + 0.6 * (to - from);
}

double letterReach(const MechanismCanvas &on)
{
    return kCrankWidth + kTextGap + 1.5 * QFontMetricsF(on.font).height();
}

QStringList valueLines(const MechanismCanvas &on, const Mechanism &mechanism)
{
    const QStringList lines{lengthText(QStringLiteral("a"), mechanism.a()),
                            lengthText(QStringLiteral("b"), mechanism.b()),
                            lengthText(QStringLiteral("c"), mechanism.c())};
    const QString together = lines.join(QStringLiteral("   "));
    const double width = QFontMetricsF(on.smallFont).horizontalAdvance(together) + 2.0 * kTextGap;
    return cornerLine(on, 0, width).right() <= on.size.width() ? QStringList{together} : lines;
}

void paintValues(QPainter &painter, const MechanismCanvas &on, const Mechanism &mechanism)
{
    const QStringList lines = valueLines(on, mechanism);
    painter.setFont(on.smallFont);
    painter.setPen(on.colours.text);
    for (int i = 0; i < static_cast<int>(lines.size()); ++i) {
        const double width = QFontMetricsF(on.smallFont).horizontalAdvance(lines[i]);
        const QRectF box = cornerLine(on, i, width + 2.0 * kTextGap);
        painter.fillRect(box, on.colours.background);
        painter.drawText(box.adjusted(kTextGap, 0.0, 0.0, 0.0), Qt::AlignVCenter | Qt::AlignLeft, lines[i]);
    }
}

} // namespace slidercrank
