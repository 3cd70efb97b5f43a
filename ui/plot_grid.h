// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Figure 2 of the report: three rows (position, velocity, acceleration) by three columns (θ³, R_x⁴, error in per cent),
// the model solid and the reference dashed, with one legend, one time range and one time cursor for all nine plots.

#include "ui/plot_arrangement.h"
#include "ui/plot_figure.h"
#include "ui/session.h"

#include <QPalette>
#include <QPoint>
#include <QStringList>
#include <QWidget>

#include <array>
#include <memory>
#include <optional>

class QLabel;

namespace slidercrank
{

class PlotGrid : public QWidget
{
    Q_OBJECT

public:
    explicit PlotGrid(QWidget *parent = nullptr);
    ~PlotGrid() override;

    /// The nine, row by row: "plot_theta3", "plot_R4_x", "plot_error_position", …
    static QStringList plotNames();

    /// The whole figure with its legend, or one plot of it, at that logical size, zoomed as on the screen, in the
    /// colours of that palette. The widget need not be visible. Every curve ends at its axes, also on devices that do
    /// not clip.
    void paintFigure(QPainter &painter, const QSize &size, const QPalette &palette);
    void paintPlot(QPainter &painter, const QString &plotName, const QSize &size, const QPalette &palette);

    /// An instant (s) to be marked by a line in what is painted from now on. The cursor on the screen is not.
    void markTime(double seconds) { m_markedTime = seconds; }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

public slots:
    void setResult(const std::shared_ptr<const slidercrank::Result> &result);
    void setPose(const slidercrank::Pose &pose); ///< moves the time cursor, nothing else
    void showAll();                              ///< undoes every zoom

signals:
    void timeRequested(double seconds);
    void openReferenceRequested();
    void exportPlotRequested(const QString &plotName);

protected:
    bool event(QEvent *event) override;
    bool eventFilter(QObject *watched, QEvent *event) override;
    void changeEvent(QEvent *event) override;
    void paintEvent(QPaintEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    void showEvent(QShowEvent *event) override;

private:
    class Plot; // one of the nine widgets

    /// A plot within a figure of some size.
    struct PlacedPlot {
        QRect cell;
        QMargins margins;
        PlotPicture picture;
    };
    std::array<PlacedPlot, kPlotCount> placedPlots(const QSize &size);

    void requestRefresh();
    void refresh();
    void placePlots();
    void moveCursors();
    void updateHint();
    void zoomTime(double about, double factor);
    void zoomValues(std::size_t plot, double about, double factor);
    void pan(std::size_t plot, const QPoint &to);
    void showMenu(std::size_t plot, const QPoint &globalPosition);

    PlotFigure m_figure;
    PlotTypography m_typography;
    std::array<Plot *, kPlotCount> m_plots{};
    std::array<QWidget *, kPlotCount> m_cursors{};
    QLabel *m_hint = nullptr;
    std::optional<double> m_cursorTime;
    std::optional<double> m_markedTime; ///< s
    bool m_isStale = true;              ///< the plots do not show m_figure yet
    bool m_isRefreshQueued = false;

    /// A left button held down over a plot.
    struct Drag {
        std::size_t plot = 0;
        QPoint start;
        QPoint last;
        bool hasMoved = false;
    };
    std::optional<Drag> m_drag;
};

} // namespace slidercrank
