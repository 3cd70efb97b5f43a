// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The figure of the reference report: three rows (position, velocity, acceleration) by three columns (θ³, Rₓ⁴, error),
// the model solid and the reference dashed, with one legend, one time range and one time cursor for all nine plots.
// Without a reference there are no errors, and the other six have all the room.
//
// A left drag zooms into the box that it draws: into the time alone where the box is flat, into the values alone where
// it is narrow. Shift or the middle button moves what is on show. The value axes fit what is seen of the time, except
// those whose range a person chose by a box or by the wheel on the axis.

#include "ui/document/result.h"
#include "ui/plots/plot_figure.h"
#include "ui/plots/plot_pane.h"

#include <QList>
#include <QPixmap>
#include <QStringList>
#include <QWidget>

#include <array>
#include <memory>
#include <optional>

class QAction;
class QLabel;

namespace slidercrank
{

class FigurePlot;

class PlotGrid : public QWidget
{
    Q_OBJECT

public:
    explicit PlotGrid(QWidget *parent = nullptr);
    ~PlotGrid() override;

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
    void keepRequested(); ///< of the motion on show
    void settingsChanged(const slidercrank::PlotSettings &settings);

protected:
    bool event(QEvent *event) override;
    bool eventFilter(QObject *watched, QEvent *event) override;
    void changeEvent(QEvent *event) override;
    void paintEvent(QPaintEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    void showEvent(QShowEvent *event) override;

private:
    void makeChoices();
    std::vector<std::size_t> plotsOnShow() const;
    void rebuild();        ///< other plots, fonts or colours
    void requestRefresh(); ///< other data, ranges or sizes
    void refresh();
    void placePanes();
    void moveCursors();
    PlotPane::Cursor cursorAt(std::size_t plot, double time);
    void paint(QPainter &painter, const std::vector<std::size_t> &plots, const QSize &size, const QPalette &palette);

    double timeAt(std::size_t plot, double x) const; ///< px in the pane → s
    double valueAt(std::size_t plot, double y) const;
    void press(std::size_t plot, const QMouseEvent &mouse);
    void move(std::size_t plot, const QPoint &to);
    void release(std::size_t plot, const QMouseEvent &mouse);
    void turnWheel(std::size_t plot, const QWheelEvent &wheel);
    bool pressKey(std::size_t plot, int key);
    void pan(std::size_t plot, const QPoint &to);
    void endDrag();
    QRect draggedBox() const;
    void zoomInto(std::size_t plot, const QRect &box);
    std::optional<std::size_t> measuringCursorAt(std::size_t plot, const QPoint &position) const;
    void showMenu(std::size_t plot, const QPoint &globalPosition);
    void copyValues(std::size_t plot, const ReadTime &time);
    void toggleMaximized(std::size_t plot);

    PlotFigure m_figure;
    std::unique_ptr<FigurePlot> m_drawing;
    QPixmap m_picture;
    std::array<PlotPane *, kPlotCount> m_panes{};
    QList<QAction *> m_choices;
    QAction *m_measuring = nullptr;
    QLabel *m_hint = nullptr;
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
        Qt::MouseButton button = Qt::LeftButton;
        QPoint start;
        QPoint last;
        PlotZoom before; ///< to return to
        bool hasMoved = false;
        std::size_t measuringCursor = 0; ///< the one held
    };
    std::optional<Drag> m_drag;
};

} // namespace slidercrank
