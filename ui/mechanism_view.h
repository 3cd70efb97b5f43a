// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The linkage, drawn to scale, in a view that stands still while the mechanism moves. Drag the crank pin A to scrub.
//
// Model coordinates: mm, x to the right, y upwards, O2 in the origin. Conventions of the drawing are those of mechanism
// textbooks: a hatched line is ground, a circle is a revolute joint. Over the model's linkage the reference's is drawn
// thin, in its colour, where the two differ: the ghost.

#include "core/reference_pose.h"
#include "ui/session.h"

#include <QPixmap>
#include <QPointF>
#include <QRectF>
#include <QWidget>

#include <memory>
#include <optional>

namespace slidercrank
{

class MechanismView : public QWidget
{
    Q_OBJECT

public:
    explicit MechanismView(QWidget *parent = nullptr);

    /// Everything as vectors, for any device; background included.
    void paintMechanism(QPainter &painter, const QSize &size, const QPalette &palette) const;

    /// Where a point of the model (mm) is in this widget.
    QPointF toPixels(QPointF model) const;

    bool hasGhost() const { return m_ghost.exists; }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

public slots:
    void setResult(const std::shared_ptr<const slidercrank::Result> &result);
    void setPose(const slidercrank::Pose &pose);

    /// The reference's linkage at the instant of the pose; one that does not exist is not drawn.
    void setGhost(const slidercrank::ReferencePose &ghost);

signals:
    void timeRequested(double seconds); ///< A was dragged to where the crank is at that instant

protected:
    void paintEvent(QPaintEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    void changeEvent(QEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;

private:
    /// The two pins, mm: what is left to draw when there is no pose any more.
    struct Pins {
        QPointF crank;
        QPointF slider;
    };
    struct Canvas;

    Canvas canvas(const QSizeF &size, const QPalette &palette) const;
    void paintGrid(QPainter &painter, const Canvas &on) const;
    void paintScenery(QPainter &painter, const Canvas &on) const;
    void paintPose(QPainter &painter, const Canvas &on) const;
    void paintGhost(QPainter &painter, const Canvas &on) const;
    void paintExplanation(QPainter &painter, const Canvas &on) const;
    void refreshScenery();
    void fitFrame();
    QPointF crankPin() const; ///< where A is, or would be
    QRect poseArea() const;   ///< pixels that drawing the pose touches
    QRect ghostArea() const;
    QRect areaOf(QPointF crank, QPointF slider) const;
    QString explanation() const; ///< why there is no pose, and what would help; empty while there is one
    bool nearCrankPin(QPointF pixel) const;
    void scrubTo(QPointF pixel);

    std::shared_ptr<const Result> m_result;
    Pose m_pose;
    std::optional<Pins> m_pins; ///< of the last pose that existed
    ReferencePose m_ghost;
    QRectF m_frame;    ///< what is in view, mm; null before the first result
    QPixmap m_grid;    ///< of this view; null when out of date
    QPixmap m_scenery; ///< the grid and the parts that stand still; null when out of date
    bool m_dragging = false;
};

} // namespace slidercrank
