// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A drawing as a list of shapes and labels, in pixels. Painting is a loop over the list. The hit test finds the
// topmost shape near the pointer. A highlight is the widened outline of a part.

#include "ui/mechanism/mechanism_frame.h"
#include "ui/text/theme.h"

#include <QBrush>
#include <QFont>
#include <QLineF>
#include <QPainterPath>
#include <QPen>
#include <QString>

#include <vector>

class QPainter;

namespace slidercrank
{

/// Widths of lines, px.
inline constexpr double kHairline = 1.0;      // dimensions, guides, frames
inline constexpr double kGroundLine = 1.2;    // the ground, marks on the slider's line
inline constexpr double kPathLine = 1.4;      // paths of points, outlines beside the linkage
inline constexpr double kBodyOutline = 1.6;   // bodies, joints
inline constexpr double kArrowLine = 2.0;     // velocities, accelerations
inline constexpr double kForbiddenLine = 3.0; // the angles that the crank does not reach

/// Share of the outline's colour in the colour that fills a body.
inline constexpr double kBodyFill = 0.15;

/// Half the width of the support of O2, and its height, px.
inline constexpr double kSupportSize = 17.0;

/// The parts at which the user can point.
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
    G3,    ///< the coupler's centre of mass
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

/// A drawing of shapes and labels, with the colours of a palette and the letters of a font.
class MechanismDrawing
{
public:
    using enum DrawnPart;

    MechanismDrawing(const MechanismProjection &projection, const QPalette &palette, const QFont &font);

    const MechanismProjection &projection() const { return m_projection; }
    QPointF toPixels(QPointF model) const { return m_projection.toPixels(model); }

    void paint(QPainter &painter) const;
    void paintHighlight(QPainter &painter, DrawnPart part, const QColor &colour) const;

    /// Returns the part of the topmost shape within a few pixels of this point, or Background if there is none.
    DrawnPart partAt(QPointF pixel) const;

    /// Returns whether a shape belongs to the part.
    bool has(DrawnPart part) const;

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

    enum class TextSize { Normal, Small };
    QSizeF textSize(const QString &text, TextSize letters = TextSize::Normal) const;

    /// Adds text beside the point, at the first free place: in `direction`, then in the directions to either side,
    /// then farther away. `gap` is the distance (px) from the point. The place depends only on the current pose, so
    /// that a motion looks the same forwards and backwards. In extreme poses labels may overlap.
    void addLabelBeside(QPointF point, QPointF direction, double gap, const QString &text, const QColor &ink,
                        TextSize letters = TextSize::Normal);

    /// Adds small text in the upper left corner. `line`: counted from 0; `indent`: px.
    void addCornerLabel(int line, double indent, const QString &text);
    double cornerLineTop(int line) const; ///< px, of a line in that corner

    /// Labels added later avoid the rectangle, the line of that width (px) or the surroundings of the point.
    void avoid(const QRectF &box) { m_occupied.push_back(box); }
    void avoid(const QLineF &line, double width);
    void avoidAround(QPointF centre, double radius); ///< px

    /// Returns the colour mixed with the background. `share`: of the colour, 0 … 1.
    QColor faded(const QColor &colour, double share) const { return mixed(colour, m_paper, share); }

    SeriesColours m_colours;
    QColor m_ink;
    QColor m_paper;
    QColor m_muted; ///< text and lines of less importance
    QFont m_font;   ///< in pixels, so that text has the same size relative to the drawing on every device
    QFont m_smallFont;
    QList<QRectF> m_grid; ///< lines as thin rectangles, which Qt paints ten times as fast as smooth lines or a path
    std::vector<DrawnShape> m_shapes;
    std::vector<Label> m_labels;

private:
    MechanismProjection m_projection;
    std::vector<QRectF> m_occupied;
};

QColor withAlpha(QColor colour, double alpha);

/// Returns the vector scaled to length 1. A vector of length 0 gives the upward direction on the screen.
QPointF unitVector(QPointF vector);

} // namespace slidercrank
