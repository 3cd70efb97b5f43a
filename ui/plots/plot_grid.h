// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Figure 2 of the report: three rows (position, velocity, acceleration) by three columns (θ³, R_x⁴, error in per cent),
// the model solid and the reference dashed, with one legend, one time range and one time cursor for all nine plots.
// Without a reference there are no errors, and the other six have all the room.
//
// A left drag zooms into the box that it draws, one too flat into its time alone and one too narrow into its values
// alone; Shift or the middle button moves what is on show. The values fit what is seen of the time, but in a plot whose
// values a person chose, by a box or by the wheel on their axis: there they stay until all is shown again.

#include "ui/document/result.h"
#include "ui/plots/plot_arrangement.h"
#include "ui/plots/plot_figure.h"
#include "ui/plots/plot_readings.h"

#include <QList>
#include <QPalette>
#include <QPoint>
#include <QStringList>
#include <QWidget>

#include <array>
#include <memory>
#include <optional>

class QAction;
class QLabel;

namespace slidercrank
{

class PlotCanvas;

class PlotGrid : public QWidget
{
    Q_OBJECT

public:
    explicit PlotGrid(QWidget *parent = nullptr);

    /// The nine, row by row: "plot_theta3", "plot_R4_x", "plot_error_position", …
    static QStringList plotNames();

    /// The whole figure with its legend, or one plot of it, at that logical size, zoomed as on the screen, in the
    /// colours of that palette. The widget need not be visible.
    void paintFigure(QPainter &painter, const QSize &size, const QPalette &palette);
    void paintPlot(QPainter &painter, const QString &plotName, const QSize &size, const QPalette &palette);

    const PlotSettings &settings() const { return m_figure.settings(); }

    PlotZoom zoom() const { return {m_figure.timeZoom, m_figure.valueZoom}; }
    void setZoom(const PlotZoom &zoom);

    /// The plot that fills the figure, by name; empty: none.
    QString maximized() const { return m_maximized ? plotName(*m_maximized) : QString(); }

    /// Instants (s) of the measuring cursors, where there are any.
    const std::optional<std::array<double, 2>> &measured() const { return m_read.measured; }
    void setMeasured(const std::optional<std::array<double, 2>> &instants);

    /// An instant (s) to be marked by a line in what is painted from now on. The cursor on the screen is not.
    void markTime(double seconds) { m_markedTime = seconds; }

    /// What one can choose about the plots, for menus.
    const QList<QAction *> &choices() const { return m_choices; }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

public slots:
    void setResult(const std::shared_ptr<const slidercrank::Result> &result);
    void setPose(const slidercrank::Pose &pose); ///< moves the time cursor, nothing else
    void showAll();                              ///< undoes every zoom
    void setSettings(const slidercrank::PlotSettings &settings);

    /// Fills the figure with one plot, by name; empty: all nine again.
    void maximize(const QString &plotName);

    /// Two instants to measure between, or none.
    void setMeasuring(bool measuring);

signals:
    void timeRequested(double seconds);
    void openReferenceRequested();
    void exportPlotRequested(const QString &plotName);
    void copyPlotRequested(const QString &plotName);
    void keepRequested(); ///< the motion on show
    void settingsChanged(const slidercrank::PlotSettings &settings);

protected:
    bool event(QEvent *event) override;
    bool eventFilter(QObject *watched, QEvent *event) override;
    void changeEvent(QEvent *event) override;
    void paintEvent(QPaintEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    void showEvent(QShowEvent *event) override;

private:
    void makeChoices(); ///< which change the plots and follow what is changed elsewhere; in plot_choices.cpp
    PlotArrangement arrangementOnScreen() const;

    void requestRefresh();
    void refresh();
    void placePlots();
    void moveCursors();
    void updateHint();
    void pan(std::size_t plot, const QPoint &to);
    void pressOn(std::size_t plot, const QMouseEvent &mouse);
    void moveOver(std::size_t plot, const QPoint &to);
    void releaseOver(std::size_t plot, const QMouseEvent &mouse);
    void endDrag();
    QRect framedBox() const;
    void zoomInto(std::size_t plot, const QRect &box);
    void showMenu(std::size_t plot, const QPoint &globalPosition);
    void toggleMaximized(std::size_t plot);
    void hoverOver(std::optional<std::size_t> plot, double time);
    void updateOverlays();
    OverlayContent overlayOf(std::size_t plot);
    std::optional<std::size_t> measuringCursorAt(std::size_t plot, const QPoint &position) const;
    bool pressKey(std::size_t plot, int key);

    PlotFigure m_figure;
    PlotTypography m_typography;
    std::array<PlotCanvas *, kPlotCount> m_plots{};
    std::array<QWidget *, kPlotCount> m_cursors{};
    std::array<PlotOverlay *, kPlotCount> m_overlays{};
    QList<QAction *> m_choices;
    std::optional<std::size_t> m_maximized;
    ReadInstants m_read;
    QLabel *m_hint = nullptr;
    std::optional<double> m_cursorTime;
    std::optional<double> m_markedTime; ///< s
    bool m_isStale = true;              ///< the plots do not show m_figure yet
    bool m_isRefreshQueued = false;

    /// A button held down over a plot.
    struct Drag {
        enum class Kind { Box, Move, MeasuringCursor };
        Kind kind = Kind::Box;
        std::size_t plot = 0;
        Qt::MouseButton button = Qt::LeftButton;
        QPoint start;
        QPoint last;
        PlotZoom before; ///< to go back to
        bool hasMoved = false;
        std::size_t measuringCursor = 0; ///< the one held
    };
    std::optional<Drag> m_drag;
};

} // namespace slidercrank
