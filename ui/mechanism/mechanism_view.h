// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The linkage, drawn to scale, in a view that stands still while the mechanism moves; and the hands on it: drag A or B
// to scrub, the links and the slider's line to change lengths, point at a part to read what it is and how it moves.

#include "ui/mechanism/mechanism_canvas.h"
#include "ui/mechanism/mechanism_drag.h"
#include "ui/mechanism/mechanism_drawing.h"

#include <QList>
#include <QPixmap>
#include <QWidget>

#include <functional>
#include <memory>
#include <optional>

class QAction;
class QTimer;

namespace slidercrank
{

class MechanismNote;

class MechanismView : public QWidget
{
    Q_OBJECT

public:
    explicit MechanismView(QWidget *parent = nullptr);

    /// What is on the screen, as vectors, for any device; background included.
    void paintMechanism(QPainter &painter, const QSize &size, const QPalette &palette) const;

    /// Where a point of the model (mm) is in this widget.
    QPointF toPixels(QPointF model) const;

    bool hasGhost() const { return m_drawing.ghost.exists; }

    const MechanismSettings &settings() const { return m_drawing.settings; }
    void setSettings(const MechanismSettings &settings);

    /// What it shows beside the result, for another view in its place.
    struct Look {
        MechanismSettings settings;
        MechanismFrame frame;
        std::optional<MechanismDrawing::Pins> pins; ///< of the last pose that existed
    };
    Look look() const { return {m_drawing.settings, m_frame, m_drawing.pins}; }
    void setLook(const Look &look);

    /// The part of the plane that somebody zoomed to, mm; none: all of the mechanism.
    const std::optional<QRectF> &zoom() const { return m_frame.zoomed(); }
    void setZoom(const std::optional<QRectF> &zoom);

    /// What one can choose about the drawing, for menus.
    const QList<QAction *> &choices() const { return m_choices; }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

public slots:
    void setResult(const std::shared_ptr<const slidercrank::Result> &result);
    void setPose(const slidercrank::Pose &pose);

    /// The reference's linkage at the instant of the pose; one that does not exist is not drawn.
    void setGhost(const slidercrank::ReferencePose &ghost);

    /// Everywhere that the reference's linkage goes, mm: it, too, is to be in view. Null where none is drawn.
    void setGhostReach(const QRectF &reach);

    void fit(); ///< all of the mechanism into view

signals:
    void timeRequested(double seconds); ///< the mechanism was moved to where it is at that instant
    void lengthRequested(slidercrank::Parameter parameter, double length); ///< mm

    /// A length is taken hold of, is let go: what is asked for between belongs together.
    void dragBegan();
    void dragEnded();
    void enlarged(); ///< somebody wants it as large as can be, or no longer

protected:
    void paintEvent(QPaintEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    void changeEvent(QEvent *event) override;
    void hideEvent(QHideEvent *event) override;
    void leaveEvent(QEvent *event) override;
    void focusInEvent(QFocusEvent *event) override;
    void focusOutEvent(QFocusEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void mouseDoubleClickEvent(QMouseEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;

private:
    /// A button held down over the drawing.
    struct Hold {
        std::optional<MechanismDrag> drag; ///< none: the drawing itself is moved
        Qt::MouseButton button;
        QPointF pressed;    ///< px
        QPointF last;       ///< px
        bool moves = false; ///< no longer a click
        double time = 0.0;  ///< s, to go back to
    };

    double magnification() const;
    MechanismCanvas canvas(const QSizeF &size, const QPalette &palette) const;
    MechanismProjection projection() const { return m_frame.projection(size()); }
    DrawnPart partUnder(QPointF pixel) const;
    QRectF reach() const;
    QRectF visibleGhostReach() const;
    void makeChoices();
    void changeFrame(const std::function<void()> &change);
    void refitAtRest();
    void refreshScenery();
    void updateArea(const QRectF &area);
    QRectF movingArea() const;
    void goToCrankAngle(double theta2);
    void obey(const DragRequest &request);
    void release();
    void cancelDrag();
    void pointAt(DrawnPart part, bool withShift);
    void pointAtNext(int step);
    void updateNote();
    void updateCursor(bool withShift);

    MechanismDrawing m_drawing;
    MechanismFrame m_frame;
    QRectF m_ghostReach; ///< mm; may be null
    QPixmap m_grid;      ///< of this view; null when out of date
    QPixmap m_scenery;   ///< the grid and the parts that stand still; null when out of date
    std::optional<Hold> m_hold;
    DrawnPart m_pointed = DrawnPart::Background; ///< at
    MechanismNote *m_note;
    QTimer *m_noteDelay;
    QTimer *m_refitDelay; ///< runs while another mechanism has not come to rest
    QList<QAction *> m_choices;
    bool m_showsFocus = false; ///< it came by the keyboard
};

} // namespace slidercrank
