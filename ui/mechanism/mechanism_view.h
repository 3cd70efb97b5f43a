// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The linkage, drawn to scale in a view that stands still while the mechanism moves. Drag A or B to move it, the links
// and the slider's line to change lengths; point at a part to read what it is and how it moves.

#include "core/mechanism/mechanism_part.h"
#include "ui/mechanism/mechanism_drag.h"
#include "ui/mechanism/mechanism_sketch.h"

#include <QList>
#include <QPixmap>
#include <QWidget>

#include <cstddef>
#include <memory>
#include <optional>

class QAction;
class QLabel;
class QTimer;
class QToolButton;

namespace slidercrank
{

class MechanismView : public QWidget
{
    Q_OBJECT

public:
    explicit MechanismView(QWidget *parent = nullptr);

    /// Paints the drawing as vectors, background included, for any device.
    void paintMechanism(QPainter &painter, const QSize &size, const QPalette &palette) const;

    /// A size in landscape format that what is in view fills, for pictures in documents.
    QSize pictureSize() const;

    /// The position of a point of the model (mm) in this widget.
    QPointF toPixels(QPointF model) const { return projection().toPixels(model); }

    bool hasGhost() const { return m_scene.ghost.exists; }

    const MechanismSettings &settings() const { return m_scene.settings; }
    void setSettings(const MechanismSettings &settings);

    /// For another view that shows the same part of the plane.
    const MechanismFrame &frame() const { return m_frame; }
    void setFrame(const MechanismFrame &frame);

    /// The rectangle that the user zoomed to, mm; nullopt: the whole mechanism.
    const std::optional<QRectF> &zoom() const { return m_frame.zoomed(); }
    void setZoom(const std::optional<QRectF> &zoom);

    /// What the user can choose about the drawing, for menus.
    const QList<QAction *> &choices() const { return m_choices; }

    QSize sizeHint() const override { return {440, 340}; }
    QSize minimumSizeHint() const override { return {200, 140}; }

public slots:
    void setResult(const std::shared_ptr<const slidercrank::Result> &result);
    void setPose(const slidercrank::Pose &pose);

    /// The linkage of the reference or of the pinned motion at the time of the pose.
    void setGhost(const slidercrank::ReferencePose &ghost);

    /// The rectangle in which the ghost moves, mm; it is kept in view. Null if there is none.
    void setGhostBounds(const QRectF &bounds);

    /// Highlights the part that an equation or a coordinate is about.
    void highlight(slidercrank::MechanismPart part);

    void fit(); ///< shows the whole mechanism

signals:
    void timeRequested(double seconds); ///< the mechanism was moved to its pose at that time
    void lengthRequested(slidercrank::Parameter parameter, double length); ///< mm
    void branchRequested(slidercrank::Branch branch);

    /// A length is being dragged: what is requested in between belongs together.
    void dragBegan();
    void dragEnded();
    void settingsChanged(const slidercrank::MechanismSettings &settings);
    void enlarged(); ///< the user wants the drawing to fill the window, or no longer

protected:
    bool event(QEvent *event) override;
    void paintEvent(QPaintEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void mouseDoubleClickEvent(QMouseEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;

private:
    /// A mouse button that is held down over the drawing.
    struct Hold {
        std::optional<MechanismDrag> drag; ///< nullopt: the drawing is moved
        Qt::MouseButton button;
        QPointF pressed;    ///< px
        QPointF last;       ///< px
        bool moves = false; ///< no longer a click
        double time = 0.0;  ///< s, before the drag
    };

    double magnification() const;
    MechanismSketch sketch(const QSizeF &size, const QPalette &palette, bool withScenery, bool withLinkage) const;
    MechanismProjection projection() const { return m_frame.projection(size()); }
    MechanismSketch wholeSketch() const { return sketch(size(), palette(), true, true); }
    QRectF bounds() const;
    DrawnPart partUnder(QPointF pixel) const;
    void makeChoices();
    void describe();
    void fitFrame();
    void zoomBy(double factor, QPointF pixel);
    void refresh();
    void goToCrankAngle(double theta2);
    void release();
    void cancelDrag();
    void pointAt(DrawnPart part, bool withShift);
    void pointAtNext(std::ptrdiff_t step);
    void showNote();

    MechanismScene m_scene;
    MechanismFrame m_frame;
    QRectF m_ghostBounds; ///< mm; may be null
    QPixmap m_scenery;    ///< what stands still; null when out of date
    std::optional<Hold> m_hold;
    DrawnPart m_pointed = DrawnPart::Background;
    DrawnPart m_highlighted = DrawnPart::Background; ///< from elsewhere
    QToolButton *m_flip;
    QLabel *m_note;
    QTimer *m_noteDelay;
    QTimer *m_refitDelay; ///< runs until a changed mechanism has come to rest
    QList<QAction *> m_choices;
};

} // namespace slidercrank
