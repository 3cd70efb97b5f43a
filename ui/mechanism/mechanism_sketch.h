// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The drawing of a mechanism by the conventions of textbooks: a hatched line is the ground, a circle is a revolute
// joint. Parts have fixed sizes in pixels, so that they are visible and easy to grasp at every scale.

#include "core/limits/instant_centre.h"
#include "ui/mechanism/mechanism_drawing.h"
#include "ui/mechanism/mechanism_scene.h"

#include <QCoreApplication>

#include <span>
#include <utility>
#include <vector>

namespace slidercrank
{

class MechanismSketch : public MechanismDrawing
{
    Q_DECLARE_TR_FUNCTIONS(slidercrank::MechanismSketch)

public:
    /// Where the scales of the arrows and the text about the instant centre are written: below the lengths in the upper
    /// left corner, as on the screen, or by addLegend(), and then the lengths are not written.
    enum class Legend { InCorner, Separate };

    /// Radii (px) of the arcs of θ2 and θ3, if the links are long enough.
    static constexpr double kLargestCrankArc = 30.0;
    static constexpr double kLargestCouplerArc = 36.0;

    static constexpr QSizeF kSliderSize{38.0, 24.0}; ///< px

    MechanismSketch(const MechanismScene &scene, const MechanismProjection &projection, const QPalette &palette,
                    const QFont &font, Legend legend = Legend::InCorner);

    /// Adds the parts that do not move: the grid, the ground, the crank's circle, the rail, the dead centres and the
    /// crank angles at which the mechanism cannot be assembled; depending on the settings the path of G3, the offset's
    /// dimension, the lengths and the scale of the arrows.
    void addScenery();

    /// Adds the parts that move: crank, coupler and slider; depending on the settings names, angles, arrows and the
    /// instant centre; and with thin lines the ghost, which is the linkage of the reference or of the pinned motion.
    /// Where the mechanism cannot be assembled, it adds the crank at its angle, the circle of radius b about A, the gap
    /// between this circle and the slider's line, and the reason.
    void addLinkage();

    /// Adds the legend, in a sketch of its own: the scales of the arrows, the text about the instant centre, and the
    /// reason why the mechanism cannot be assembled at any angle.
    void addLegend();
    double legendHeight() const; ///< px; 0 if the settings need no legend

private:
    const Mechanism &mechanism() const { return m_scene->mechanism(); }
    const MotionLimits &limits() const { return m_scene->result->limits; }

    void addGrid();
    void addGround(QPointF from, double to, DrawnPart part);
    void addCrankCircle();
    QRectF rail() const;
    void addGuideAndDeadCentres();
    void addPathOfG3();
    void addSupportOfO2();
    void addDimensionsAndScales();
    QLineF offsetDimension() const;
    int cornerLineCount() const;
    bool isSpaceInCorner(qsizetype lines) const;
    bool hasScalesInCorner() const; ///< whether the scales of the arrows, if any, are in the corner
    QStringList lengthLines() const;
    void addScales(int line);
    int scaleCount() const; ///< number of arrow scales in the legend

    struct DeadCentreMark {
        DrawnPart part;
        QLineF line;
    };
    std::vector<DeadCentreMark> deadCentreMarks() const;
    struct Caption {
        QString text;
        QRectF box;
    };
    std::vector<Caption> deadCentreCaptions() const;

    void addLink(QPointF from, QPointF to, double width, const QColor &colour, DrawnPart part);
    void addJoint(QPointF centre, const QColor &edge, DrawnPart part);
    void avoidScenery();
    void addDeadCentreCaptions();
    void addModel();
    void addAnnotations();
    void addMissingCoupler();
    QString problemText() const;
    void addAssemblyProblem();
    bool hasProblemInLegend() const;
    QRectF problemBoxInLegend() const; ///< px, where the legend states the reason
    void addGhost();
    void addCouplerAngle();
    void addMarkedPose();
    QLineF addOutline(const ReferencePose &pose, const QPen &pen);

    void addArrow(QPointF tail, QPointF tip, const ArrowScale &arrows, Qt::PenStyle line);
    void addArrowName(const QLineF &arrow, LinkagePoint point, const ArrowScale &arrows);
    void addMotionArrows(const ArrowScale &arrows, std::span<const LinkagePoint> points);
    void addInstantCentre();
    void addInstantCentreText(const InstantCentre &centre, int line);
    void addRay(LinkagePoint point, QPointF centre);

    void addNames();
    void addLengthLetters();
    void addAngle(const QString &name, const QLineF &link, double angle, double largestRadius);

    const MechanismScene *m_scene;
    Legend m_legend;
    QPointF m_O2;
    QPointF m_A;
    QPointF m_B; ///< undefined where the mechanism cannot be assembled
    bool m_poseExists = false;

    static constexpr int kLinesOfInstantCentre = 2; ///< lines of the text about the instant centre
};

} // namespace slidercrank
