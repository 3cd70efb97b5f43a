// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The widget that draws the mechanism to scale and lets the user edit it with the mouse. The view does not move while
// the mechanism moves. Dragging A or B moves the mechanism; dragging a link or the slider's line changes a length.
// Pointing at a part shows a note with its name and its motion.

#include "core/mechanism/mechanism_part.h"
#include "ui/mechanism/mechanism_drag.h"
#include "ui/mechanism/mechanism_sketch.h"

#include <QList>
#include <QPixmap>
#include <QWidget>

#include <functional>
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

    /// Paints the drawing as vectors, with its background, on any paint device, in the font of the painter. The scales
    /// of the arrows are below it. The lengths are not written, since every picture names the parameters once.
    void paintMechanism(QPainter &painter, const QSize &size, const QPalette &palette) const;

    /// Returns a function that paints the drawing as it is now, even if the view changes before the call.
    std::function<void(QPainter &, const QSize &)> picture(const QPalette &palette) const;

    /// Returns the height of a picture of that width in landscape format, with the aspect ratio of the part in view.
    int pictureHeight(int width) const;

    /// Converts a point of the model (mm) to a position in this widget.
    QPointF toPixels(QPointF model) const { return projection().toPixels(model); }

    const MechanismSettings &settings() const { return m_scene.settings; }
    void setSettings(const MechanismSettings &settings);

    /// Return and set the frame, for a second view that has to show the same part of the plane.
    const MechanismFrame &frame() const { return m_frame; }
    void setFrame(const MechanismFrame &frame);

    /// Return and set the rectangle that the user zoomed to, in mm; nullopt if the whole mechanism is shown.
    const std::optional<QRectF> &zoom() const { return m_frame.zoomed(); }
    void setZoom(const std::optional<QRectF> &zoom);

    /// Actions for the settings of the drawing and for its zoom, to be shown in menus.
    const QList<QAction *> &choices() const { return m_choices; }

    QSize sizeHint() const override { return {440, 340}; }
    QSize minimumSizeHint() const override { return {200, 140}; }

public slots:
    void setResult(const std::shared_ptr<const slidercrank::Result> &result);
    void setPose(const slidercrank::Pose &pose);

    /// Sets the linkage of the reference or of the pinned motion at the time of the pose.
    void setGhost(const slidercrank::ReferencePose &ghost);

    /// Sets the rectangle (mm) in which the ghost moves, so that it stays in view. A null rectangle means no ghost.
    void setGhostBounds(const QRectF &bounds);

    /// Marks a position of the linkage. Removes the mark if `pose.exists` is false.
    void setMarkedPose(const slidercrank::ReferencePose &pose);

    /// Highlights the part that an equation or a coordinate refers to.
    void highlight(slidercrank::MechanismPart part);

    /// Shows everything in the notation and units that are chosen now.
    void refreshNotation();

    /// Shows the whole mechanism.
    void fit();

signals:
    /// Emitted when the user moves the mechanism to its pose at a time (s).
    void timeRequested(double seconds);
    void lengthRequested(slidercrank::Parameter parameter, double length); ///< in mm
    void branchRequested(slidercrank::Branch branch);

    /// Emitted when a drag that changes a length begins or ends. All lengths requested in between are one edit.
    void dragBegan();
    void dragEnded();

    void settingsChanged(const slidercrank::MechanismSettings &settings);

    /// Emitted when the user wants the drawing to fill the window, or to have its usual size again.
    void fullWindowToggleRequested();

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
    struct PressedButton {
        std::optional<MechanismDrag> drag; ///< nullopt if the drag moves the whole drawing
        Qt::MouseButton button;
        QPointF start;         ///< px
        QPointF last;          ///< px
        bool hasMoved = false; ///< if false, a release is a click
        double time = 0.0;     ///< s, before the drag
    };

    // mechanism_view.cpp: what is shown
    void makeChoices();
    double magnification() const;
    MechanismSketch newSketch(const QSizeF &size, const QPalette &palette) const;
    MechanismProjection projection() const { return m_frame.projection(size()); }
    QRectF bounds() const;
    void refresh();
    int flipButtonTop() const;
    MechanismSketch linkage() const;
    void paintScenery(QPainter &painter) const;
    void updateTexts();
    void fitFrame();
    void zoomBy(double steps, QPointF pixel);
    void showNote();

    // mechanism_mouse.cpp: what the mouse and the keyboard do
    DrawnPart partUnder(QPointF pixel) const;
    void pointAt(DrawnPart part, Qt::KeyboardModifiers modifiers = {});
    void pointAtNext(int step);
    void goToCrankAngle(double theta2);
    void endDrag();
    void cancelDrag();

    MechanismScene m_scene;
    MechanismFrame m_frame;
    QRectF m_ghostBounds;       ///< mm; may be null
    MechanismSketch m_scenery;  ///< the parts that do not move
    bool m_isSceneryNew = true; ///< not painted yet
    QPixmap m_sceneryPicture;   ///< null if it is out of date
    std::optional<PressedButton> m_pressed;
    DrawnPart m_pointedPart = DrawnPart::Background;     ///< under the pointer
    DrawnPart m_highlightedPart = DrawnPart::Background; ///< by highlight()
    QToolButton *m_flipButton;
    QLabel *m_note;
    QTimer *m_noteDelay;
    QTimer *m_refitDelay; ///< restarts at every change, so that the frame is fitted when the changes have ended
    QList<QAction *> m_choices;
};

} // namespace slidercrank
