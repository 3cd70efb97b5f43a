// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The figure of the reference report as a widget: three rows (position, velocity, acceleration) and three columns (θ³,
// Rₓ⁴, error), with one legend, one time range and one time cursor for all nine plots. Where nothing is compared, and
// in presentation mode, the six plots without errors fill the figure.
//
// A left drag zooms into the box that it draws. A flat box zooms only the time, a narrow one only the values. Dragging
// with Shift or with the middle button pans. The wheel zooms the time, or over a value axis the values.

#include "ui/plots/plot_figure.h"
#include "ui/plots/plot_pane.h"

#include <QPixmap>
#include <QWidget>

#include <array>
#include <cstddef>
#include <memory>
#include <optional>

class QAction;
class QLabel;
class QRubberBand;

namespace slidercrank
{

class PlotGrid : public PlotFigure
{
    Q_OBJECT

public:
    PlotGrid();

    /// Returns the names of the nine plots, row by row: "plot_theta3", "plot_R4_x", "plot_error_position", … The panes
    /// have these object names.
    static QStringList plotNames();

    /// Returns the numbers of the plots with these names, in the same order.
    static std::vector<std::size_t> plotsNamed(const QStringList &names);

    /// Paints plots with the legend, at that logical size and in the font of the painter, zoomed as on the screen. The
    /// widget need not be visible.
    void paintFigure(QPainter &painter, const FigureContent &content, const QSize &size, const QPalette &palette);

    /// Returns the plots that can be shown.
    std::vector<NamedPlot> choosablePlots() const;

    /// Returns the height (px) at which the plots have good proportions.
    int figureHeight(const FigureContent &content, int width, const QFont &font);

    /// Returns checkable actions for the settings of the plots, to be shown in menus.
    const QList<QAction *> &choices() const { return m_choices; }

    QSize sizeHint() const override { return {900, 600}; }
    QSize minimumSizeHint() const override { return {420, 230}; } ///< fits a screen of 800×600

public slots:
    void setPose(const slidercrank::Pose &pose); ///< moves only the time cursor
    void showAll();                              ///< resets the zoom of all plots
    void showTime(double seconds);               ///< pans a zoomed time axis so that it shows that time
    void setSettings(const slidercrank::PlotSettings &settings);

signals:
    void timeRequested(double seconds);
    void openReferenceRequested();
    void exportPlotRequested(const QString &plotName);
    void copyPlotRequested(const QString &plotName);
    void settingsChanged(const slidercrank::PlotSettings &settings);

protected:
    void requestRefresh() override;
    bool event(QEvent *event) override;
    void paintEvent(QPaintEvent *event) override;
    void hideEvent(QHideEvent *event) override;
    void leaveEvent(QEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void mouseDoubleClickEvent(QMouseEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void contextMenuEvent(QContextMenuEvent *event) override;

private:
    void makeChoices();

    /// Returns the maximized plot, all nine plots, or without errors the six of the motion.
    std::vector<std::size_t> plotsToShow(const std::optional<std::size_t> &maximized) const;

    void refreshIfStale();
    void refresh();
    void moveCursors(); ///< over m_picture, which it makes if necessary
    void placeCursors();
    std::vector<PlotCursor> cursors(std::size_t plot);

    QRect axes(std::size_t plot) const; ///< px
    std::optional<std::size_t> plotAt(const QPointF &place) const;
    QPointF coordinates(std::size_t plot, const QPointF &place) const; ///< px → time (s) and value
    void drag(const QPoint &to);
    void endDrag();
    void zoomAbout(double time, double factor);
    void toggleMaximized(std::size_t plot); ///< fills the figure with that plot, or shows all plots again

    QPixmap m_picture; ///< of the figure, under the moving cursors; null until a cursor moves
    std::array<PlotPane *, kPlotCount> m_panes{};
    QList<QAction *> m_choices;
    QList<QAction *> m_errorChoices; ///< the actions about errors, which are hidden where no errors are shown
    QLabel *m_hint;                  ///< says how to compare with a file; to the right of the legend
    std::optional<std::size_t> m_maximized;
    std::optional<std::size_t> m_hovered;    ///< the plot under the pointer
    double m_hoverTime = 0.0;                ///< s
    std::optional<double> m_time;            ///< s, the current time
    std::optional<double> m_timeBeforeClick; ///< s
    QRubberBand *m_rubberBand;               ///< the box that a drag zooms into

    /// A mouse button that is held down over a plot.
    struct Drag {
        std::size_t plot = 0;
        bool isPan = false; ///< otherwise the drag zooms into a box
        QPoint start;
        QPoint last;
        PlotZoom before; ///< restored by Escape
        bool hasMoved = false;
    };
    std::optional<Drag> m_drag;
};

} // namespace slidercrank
