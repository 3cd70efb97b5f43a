// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Draws the nine plots of a Result in one QCustomPlot. The rows are position, velocity and acceleration; the columns
// are θ³, Rₓ⁴ and error. All share one legend and one time axis. Values are in the units of files (mm, °, s), errors in
// these units or in percent. The value axes fit the curves within the time shown, unless the user chose their range.

#include "ui/document/result.h"
#include "ui/document/view_settings.h"
#include "ui/plots/motion_curves.h"
#include "ui/plots/motion_errors.h"
#include "ui/plots/plot_drawing.h"

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace slidercrank
{

/// A colour in the current palette.
using Ink = QColor SeriesColours::*;

/// A time at which values are read. Within the time of a reference file, it is one of the time stamps of the file.
struct ReadTime {
    double t = 0.0;
    std::optional<std::size_t> row; ///< of the file
};

/// A curve of a plot, clipped to the axes.
struct PlotCurve {
    QString name; ///< in the legend
    Ink ink = &SeriesColours::model;
    std::vector<CurvePoint> points = {};
    std::function<double(const ReadTime &)> read = {}; ///< returns the value on the axis; empty if none is read

    double width = 2.0;                ///< px
    QVector<double> dashes = {};       ///< lengths of dashes and gaps in line widths; empty for a solid line
    std::vector<CurvePoint> dots = {}; ///< samples that are drawn as single dots

    /// A dot with this value is drawn at the upper edge of the axes.
    static constexpr double kUpperEdge = std::numeric_limits<double>::infinity();
};

class ScaleTicker;

struct Plot {
    QCPAxisRect *axes = nullptr; ///< null if the plot is not shown
    QSharedPointer<ScaleTicker> ticker;
    std::vector<PlotCurve> curves;
    std::optional<Interval> values; ///< the range of the axis; nullopt if there are no values
    QString note;                   ///< why something is missing
    QStringList titles;             ///< variants of the title, the longest first
};

/// A value read off a curve.
struct PlotReading {
    double value = 0.0;  ///< position on the axis; a logarithm if the axis is logarithmic
    double number = 0.0; ///< the number to show
    Ink ink = &SeriesColours::text;
};

class PlotFigure : public PlotDrawing
{
    Q_DECLARE_TR_FUNCTIONS(slidercrank::PlotFigure)

public:
    PlotFigure();

    void setResult(const std::shared_ptr<const Result> &result); ///< required before compose()
    const std::shared_ptr<const Result> &result() const { return m_result; }

    void setSettings(const PlotSettings &settings);
    const PlotSettings &settings() const { return m_settings; }

    /// In presentation mode pinned curves are as thick as the model's, every motion is named by the parameters that
    /// differ, and errors are shown only relative to a file.
    void setPresentation(bool isPresentation) { m_isPresentation = isPresentation; }
    bool isPresentation() const { return m_isPresentation; }

    bool hasErrors() const; ///< whether there are errors to show

    /// The time range of all plots and the value range of each.
    const PlotZoom &zoom() const { return m_zoom; }
    void setZoom(const PlotZoom &zoom) { m_zoom = zoom; }

    /// Zooms to that time range, limited to the time range of the motion.
    void zoomTime(const Interval &range);
    void zoomValues(std::size_t plot, const Interval &range);
    Interval timeRange() const { return m_zoom.time.value_or(sampledRange()); }

    /// Chooses which plots are shown, and their style. Call compose() afterwards.
    void setPlots(const std::vector<std::size_t> &plots, const PlotFonts &fonts, const SeriesColours &colours);
    const std::vector<std::size_t> &plots() const { return m_shown; }

    /// Lays out all plots for that size (px) and fills them. A marked time (s) is drawn as a line in each plot; the
    /// footer is text below the plots.
    void compose(const QSize &size, const std::optional<double> &markedTime = {}, const QString &footer = {});

    const Plot &shownPlot(std::size_t plot) const { return m_plots[plot]; }
    QCPAxis &axis(std::size_t plot, QCPAxis::AxisType type) const { return *m_plots[plot].axes->axis(type); }

    /// Returns the time nearest to t at which values can be read.
    ReadTime readTime(double t);

    /// Returns the value of the model, or NaN if there is none.
    double modelValue(std::size_t channel, const ReadTime &time);

    /// Returns the values of a plot that is shown, in the order of the legend.
    std::vector<PlotReading> readings(std::size_t plot, const ReadTime &time) const;

    /// Returns "t = 0.25 s", or over the crank angle "θ₂ = 90°".
    QString timeText(double t) const;

    /// Returns a time difference as "0.25 s" or "90°".
    QString durationText(double seconds) const;

protected:
    PlotZoom m_zoom;

private:
    Interval sampledRange() const;
    bool isOverAngle() const;
    bool isLogarithmic(std::size_t plot) const;
    double perSecond() const; ///< numbers on the time axis per second: 1, or degrees over the crank angle
    double zeroTime() const;  ///< the time at which the number on the time axis is 0, s
    MotionCurves &model();    ///< computes the pinned curves, too
    const MotionErrors &errors();
    void computeMotions(Plot &plot, std::size_t channel);
    void computeErrors(Plot &plot, std::size_t row);
    PlotCurve errorCurve(std::size_t channel);
    PlotCurve roundingCurve(std::size_t channel);
    QString missingErrors(std::size_t row);

    void fill(const std::optional<double> &markedTime);
    void setTimeScale();
    void setValueScale(std::size_t index);
    QStringList titles(std::size_t index) const;
    QCPGraph *addCurve(const Plot &plot, const PlotCurve &curve);
    void addTexts(const Plot &plot);

    std::shared_ptr<const Result> m_result;
    PlotSettings m_settings;
    bool m_isPresentation = false;

    // These are computed on demand.
    std::optional<MotionCurves> m_model;
    std::vector<MotionCurves> m_pinned;
    std::optional<MotionErrors> m_errors;
    std::size_t m_columns = 1; ///< pixel columns of a plot

    std::array<Plot, kPlotCount> m_plots;
    std::vector<std::size_t> m_shown;
    PlotFonts m_fonts;
    SeriesColours m_colours;
    QCPLayoutGrid *m_top;  ///< the legend and the free space beside it
    QCPLayoutGrid *m_grid; ///< the plots
    QCPTextElement *m_footer;
    QCPMarginGroup *m_margins;
    QSharedPointer<ScaleTicker> m_timeTicker;
};

} // namespace slidercrank
