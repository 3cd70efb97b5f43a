// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The figure of the reference report on the screen: three rows (position, velocity, acceleration) by three columns (θ³,
// Rₓ⁴, error), with one legend, one time range and one time cursor for all nine plots. Without a reference there are no
// errors, and the other six fill the figure.
//
// A left drag zooms into the box that it draws: into the time alone where the box is flat, into the values alone where
// it is narrow. Shift or the middle button pans. The wheel zooms the time, or over the axis of the values these.

#include "ui/plots/plot_figure.h"
#include "ui/plots/plot_pane.h"

#include <QPixmap>
#include <QWidget>

#include <array>
#include <memory>
#include <optional>

class QAction;
class QLabel;

namespace slidercrank
{

class PlotGrid : public QWidget
{
    Q_OBJECT

public:
    explicit PlotGrid(QWidget *parent = nullptr);

    /// The nine, row by row: "plot_theta3", "plot_R4_x", "plot_error_position", … The panes have these names.
    static QStringList plotNames();

    /// Paints the whole figure with its legend, or one plot of it, at that logical size, zoomed as on the screen, with
    /// the mechanism's parameters below. The widget need not be visible.
    void paintFigure(QPainter &painter, const QSize &size, const QPalette &palette);
    void paintPlot(QPainter &painter, const QString &plotName, const QSize &size, const QPalette &palette);

    const PlotSettings &settings() const { return m_figure.settings(); }

    const PlotZoom &zoom() const { return m_figure.zoom; }
    void setZoom(const PlotZoom &zoom);

    /// The plot that fills the figure, by name; empty: none.
    QString maximized() const { return m_maximized ? plotName(*m_maximized) : QString(); }

    /// The times (s) of the measuring cursors, where there are any.
    const std::optional<std::array<double, 2>> &measured() const { return m_measured; }
    void setMeasured(const std::optional<std::array<double, 2>> &times);
    QString measuredText() const;

    /// Marks a time (s) by a line in what is painted from now on.
    void markTime(double seconds) { m_markedTime = seconds; }

    /// See PlotFigure::setPresentation.
    void setPresentation(bool isPresentation);

    /// Checkable actions for the settings of the plots, for menus.
    const QList<QAction *> &choices() const { return m_choices; }

    QSize sizeHint() const override { return {900, 600}; }
    QSize minimumSizeHint() const override { return {420, 230}; } ///< fits a screen of 800×600

public slots:
    void setResult(const std::shared_ptr<const slidercrank::Result> &result);
    void setPose(const slidercrank::Pose &pose); ///< moves the time cursor, nothing else
    void showAll();                              ///< undoes every zoom
    void showTime(double seconds);               ///< pans a zoomed time axis that does not show that time
    void setSettings(const slidercrank::PlotSettings &settings);

    /// Fills the figure with one plot, by name; empty: all nine again.
    void maximize(const QString &plotName);

    /// Shows two cursors to measure between, or none.
    void setMeasuring(bool isMeasuring);

signals:
    void timeRequested(double seconds);
    void openReferenceRequested();
    void exportPlotRequested(const QString &plotName);
    void copyPlotRequested(const QString &plotName);
    void pinRequested(); ///< of the motion on show
    void settingsChanged(const slidercrank::PlotSettings &settings);

protected:
    void changeEvent(QEvent *event) override;
    void paintEvent(QPaintEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    void showEvent(QShowEvent *event) override;
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
    std::vector<std::size_t> plotsToShow() const;
    void rebuild();        ///< for other plots, fonts or colours
    void requestRefresh(); ///< for other data, ranges or sizes
    void refresh();
    void refreshIfStale();
    void placePanes();
    void moveCursors();
    void updateCaption();
    std::vector<PlotPane::Cursor> cursors(std::size_t plot);
    PlotPane::Cursor cursorAt(std::size_t plot, double time);
    void paint(QPainter &painter, const std::vector<std::size_t> &plots, const QSize &size, const QPalette &palette);

    QRect axes(std::size_t plot) const { return m_figure.plot(plot).axes->rect(); } ///< px
    std::optional<std::size_t> plotAt(const QPointF &place) const;
    QPointF coordinates(std::size_t plot, const QPointF &place) const; ///< px → time (s) and value
    std::optional<std::size_t> measuringCursorAt(const QPoint &place) const;
    void endDrag();
    void pan(const QPoint &to);
    QRect draggedBox() const;
    void zoomInto(std::size_t plot, const QRect &box);
    void zoomTime(double about, double factor);
    void toggleMaximized(std::size_t plot);
    void copyValues(std::size_t plot, const ReadTime &time);

    PlotFigure m_figure;
    QPixmap m_picture;
    std::array<PlotPane *, kPlotCount> m_panes{};
    QList<QAction *> m_choices;
    QAction *m_measuring = nullptr;
    QLabel *m_caption; ///< right of the legend
    std::optional<std::size_t> m_maximized;
    std::optional<std::size_t> m_hovered; ///< the plot under the pointer
    double m_hoverTime = 0.0;             ///< s
    std::optional<double> m_time;         ///< s, on show
    std::optional<double> m_markedTime;
    std::optional<std::array<double, 2>> m_measured;
    bool m_isStale = true; ///< the picture does not show m_figure yet
    bool m_isRefreshQueued = false;

    /// A button held down over a plot.
    struct Drag {
        enum class Kind { Box, Pan, MeasuringCursor };
        Kind kind = Kind::Box;
        std::size_t plot = 0;
        std::size_t measuringCursor = 0;
        QPoint start;
        QPoint last;
        PlotZoom before; ///< to return to
        bool hasMoved = false;
    };
    std::optional<Drag> m_drag;
};

} // namespace slidercrank
