// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The drawing of a mechanism, after the conventions of mechanism textbooks: a hatched line is ground, a circle is a
// revolute joint. Parts have fixed sizes in pixels, so that they stay visible and easy to grasp whatever the scale.

#include "ui/mechanism/mechanism_drawing.h"
#include "ui/mechanism/mechanism_scene.h"

namespace slidercrank
{

class MechanismSketch : public MechanismDrawing
{
public:
    MechanismSketch(const MechanismScene &scene, const MechanismProjection &projection, const QPalette &palette,
                    const QFont &font);

    /// Adds what stands still while the mechanism moves: the grid, the ground, the crank's circle, the rail, the dead
    /// centres and the crank angles at which the mechanism cannot be assembled; on demand the path of G3, the offset's
    /// dimension, the lengths and the scale of the arrows.
    void addScenery();

    /// Adds what moves: crank, coupler and slider, on demand with names, angles, arrows and the instant centre; and
    /// thinly over them the ghost, the linkage of the reference or of the pinned motion. Where the mechanism cannot be
    /// assembled the crank is drawn at its angle, with the circle of radius b about A, the gap between this circle and
    /// the slider's line, and the reason.
    void addLinkage();

private:
    const Mechanism &mechanism() const { return m_scene->mechanism(); }
    const MotionLimits &limits() const { return m_scene->result->limits; }

    void addGrid();
    void addGround(QPointF from, double to, DrawnPart part);
    void addCrankCircle();
    void addGuide();
    void addPath();
    void addPivot();
    void addDimensionsAndScales();
    QLineF offsetDimension() const;
    int cornerLineCount() const;

    void addLink(QPointF from, QPointF to, double width, const QColor &colour, DrawnPart part);
    void addJoint(QPointF centre, const QColor &edge, DrawnPart part);
    void addModel();
    void addMissingCoupler();
    void addAssemblyProblem();
    void addGhost();
    void avoidLinkage();

    void addArrow(QPointF tail, QPointF tip, MotionKind kind, bool isCut);
    void addMotionArrows(MotionKind kind, const ArrowScale &scale, bool withCentreOfMass);
    void addInstantCentre();
    void addRay(LinkagePoint point, QPointF centre);

    void addNames();
    void addLengths();
    void addAngle(const QString &name, const QLineF &link, double angle, double largestRadius);

    const MechanismScene *m_scene;
    QPointF m_O2;
    QPointF m_A;
    QPointF m_B; ///< of no meaning where the mechanism cannot be assembled
    bool m_exists = false;
};

} // namespace slidercrank
