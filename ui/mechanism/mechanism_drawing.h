// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A drawing as a list of shapes and labels, in pixels. Painting is a loop over the list, the hit test finds the last
// shape under the pointer, and highlighting strokes the outlines of a part.

#include "ui/mechanism/mechanism_frame.h"
#include "ui/text/theme.h"

#include <QBrush>
#include <QFont>
#include <QLineF>
#include <QPainterPath>
#include <QPen>
#include <QString>

#include <set>
#include <vector>

class QPainter;

namespace slidercrank
{

/// What can be pointed at. It begins with the values of MechanismPart.
enum class DrawnPart {
    Background,
    Ground,
    Crank,
    Coupler,
    Slider,
    O2,
    A,
    B,
    Guide, ///< the slider's line
    Drive, ///< not drawn
    G3,
    OuterDeadCentre,
    InnerDeadCentre,
    ForbiddenArc
};

struct DrawnShape {
    DrawnPart part = DrawnPart::Background;
    QPainterPath path;
    QPen pen;
    QBrush brush;
};

struct Label {
    QString text;
    QRectF box;
    QColor ink;
    QColor paper; ///< behind the text
    bool isSmall = false;
    int alignment = Qt::AlignCenter;
};

/// Colours and fonts follow a palette and a font.
class MechanismDrawing : public MechanismProjection
{
public:
    using enum DrawnPart;

    MechanismDrawing(const MechanismProjection &projection, const QPalette &palette, const QFont &font);

    void paint(QPainter &painter) const;
    void paintHighlight(QPainter &painter, DrawnPart part, const QColor &colour) const;

    /// The part of the last shape under the pointer, with a few pixels to spare.
    DrawnPart partAt(QPointF pixel) const;

    std::set<DrawnPart> parts() const;

    /// Returns a rectangle that contains all shapes and labels.
    QRectF bounds() const;

    const std::vector<DrawnShape> &shapes() const { return m_shapes; }
    const std::vector<Label> &labels() const { return m_labels; }
    const SeriesColours &colours() const { return m_colours; }

protected:
    void add(const QPainterPath &path, const QPen &pen, const QBrush &brush = Qt::NoBrush, DrawnPart part = Background);
    void addLine(QPointF from, QPointF to, const QPen &pen, DrawnPart part = Background);
    void addCircle(QPointF centre, double radius, const QPen &pen, const QBrush &brush = Qt::NoBrush,
                   DrawnPart part = Background);
    void addArrowHead(QPointF tip, QPointF direction, double length, const QColor &colour);
    void addDimension(QPointF from, QPointF to, const QColor &colour); ///< a line with an arrow head at both ends

    QSizeF textSize(const QString &text, bool isSmall = false) const;

    /// Text beside the point, at the first free place: in that direction, then to either side of it, then farther away.
    /// `gap` is its distance. The place depends on the current pose alone, so that a motion looks the same forwards and
    /// backwards. In extreme poses labels may overlap.
    void addLabelBeside(QPointF point, QPointF direction, double gap, const QString &text, const QColor &ink,
                        bool isSmall = false);

    /// Small text in that line of the upper left corner.
    void addCornerLabel(int line, double indent, const QString &text);
    double cornerLineTop(int line) const;

    /// Labels that are added beside points keep clear of it.
    void avoid(const QRectF &box) { m_occupied.push_back(box); }
    void avoid(const QLineF &line, double width);

    QColor faded(const QColor &colour, double share) const; ///< mixed with the paper

    SeriesColours m_colours;
    QColor m_ink;
    QColor m_paper;
    QColor m_muted; ///< text and lines of less importance
    QFont m_font;   ///< in pixels, so that text has the same size relative to the drawing on every device
    QFont m_smallFont;
    std::vector<DrawnShape> m_shapes;
    std::vector<Label> m_labels;

private:
    std::vector<QRectF> m_occupied;
};

QColor withAlpha(QColor colour, double alpha);

/// The vector with length 1; upwards on the screen for a vector of length 0.
QPointF unitVector(QPointF vector);

} // namespace slidercrank
