// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The nine plots of a Result in one QCustomPlot: rows position, velocity, acceleration; columns θ³, Rₓ⁴, error; with
// one legend and one time axis. Values are in the units of files (mm, °, s), errors in these or in percent. The axes of
// the values fit what is seen of the time, except those whose range a person chose.

#include "ui/document/result.h"
#include "ui/document/view_settings.h"
#include "ui/plots/motion_curves.h"
#include "ui/plots/motion_errors.h"
#include "ui/plots/plot_drawing.h"

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace slidercrank
{

/// A colour of the palette in use.
using Ink = QColor SeriesColours::*;

/// A curve of a plot, cut off at the axes.
struct PlotCurve {
    QString name; ///< in the legend
    Ink ink = &SeriesColours::model;
    std::vector<CurvePoint> points = {};
    double width = 2.0;                ///< px
    QVector<double> dashes = {};       ///< px, lengths of dashes and gaps; empty: solid
    std::vector<CurvePoint> dots = {}; ///< samples that are to be seen one by one

    /// The value of dots that mark a time stamp at the upper edge of the axes.
    static constexpr double kUpperEdge = std::numeric_limits<double>::infinity();
};

class ScaleTicker;

struct Plot {
    QCPAxisRect *axes = nullptr; ///< null: not shown
    QSharedPointer<ScaleTicker> ticker;
    std::vector<PlotCurve> curves;
    std::optional<Interval> values; ///< on the axis; nothing when there are none
    QString note;                   ///< why something is missing
    QStringList titles;             ///< the same, the longest first
};

/// A time at which values are read: with a reference file, within its time, one of its own time stamps.
struct ReadTime {
    double t = 0.0;
    std::optional<std::size_t> row; ///< of the file
};

/// A value read off a curve.
struct PlotReading {
    double value = 0.0;  ///< as the axis has it
    double number = 0.0; ///< as it is written
    Ink ink = &SeriesColours::text;
};

class PlotFigure : public PlotDrawing
{
    Q_DECLARE_TR_FUNCTIONS(slidercrank::PlotFigure)

public:
    PlotFigure();

    void setResult(const std::shared_ptr<const Result> &result); ///< may be null
    const std::shared_ptr<const Result> &result() const { return m_result; }

    void setSettings(const PlotSettings &settings);
    const PlotSettings &settings() const { return m_settings; }

    /// In presentation mode pinned curves are as thick as the model's, every motion is named by what differs, and
    /// errors are shown of a file only.
    void setPresentation(bool isPresentation) { m_isPresentation = isPresentation; }
    bool isPresentation() const { return m_isPresentation; }

    bool hasErrors() const; ///< whether there are errors to show

    PlotZoom zoom; ///< the time of all plots, the values of each

    /// Limits the range to where there is something to see.
    void zoomTime(const Interval &range);
    void zoomValues(std::size_t plot, const Interval &range);
    Interval timeRange() const { return zoom.time.value_or(sampledRange()); }

    /// Chooses which plots are shown and how. show() has to follow.
    void setPlots(const std::vector<std::size_t> &plots, const PlotFonts &fonts, const SeriesColours &colours);
    const std::vector<std::size_t> &plots() const { return m_shown; }

    /// Text below the plots; may be empty.
    void setFooter(const QString &text);

    /// Lays out and fills all plots. A marked time (s) is a line in each of them.
    void show(const QSize &size, const std::optional<double> &markedTime = {});

    const Plot &plot(std::size_t index) const { return m_plots[index]; }
    QCPAxis &axis(std::size_t plot, QCPAxis::AxisType type) const { return *m_plots[plot].axes->axis(type); }
    QString description(std::size_t plot) const; ///< what it shows, in words
    QRect legendPlace() const;

    /// The time nearest to t at which values are read.
    ReadTime readTime(double t);
    std::vector<PlotReading> readings(std::size_t plot, const ReadTime &time);

    /// "t = 0.25 s", over the crank angle "θ₂ = 90°".
    QString timeText(double t) const;

    /// A difference of times: "0.25 s", "90°".
    QString durationText(double seconds) const;

private:
    Interval sampledRange() const;
    bool isOverAngle() const;
    MotionCurves &model(); ///< prepares the pinned curves as well
    const MotionErrors &errors();
    void computeMotions(Plot &plot, std::size_t channel);
    void computeErrors(Plot &plot, std::size_t row);
    PlotCurve errorCurve(std::size_t channel);
    PlotCurve roundingCurve(std::size_t channel);
    QString missingErrors(std::size_t row);
    QString modelName() const;
    QString errorUnit(std::size_t channel) const;

    void fill(const std::optional<double> &markedTime);
    void setTimeScale();
    void setValueScale(std::size_t index);
    void addCurve(const Plot &plot, const PlotCurve &curve);
    void addTexts(const Plot &plot);
    void addToLegend(QCPGraph *graph, const QString &name);

    std::shared_ptr<const Result> m_result;
    PlotSettings m_settings;
    bool m_isPresentation = false;

    // Computed when they are needed.
    std::optional<MotionCurves> m_model;
    std::vector<MotionCurves> m_pinned;
    std::optional<MotionErrors> m_errors;
    std::size_t m_columns = 1; ///< of pixels in a plot

    std::array<Plot, kPlotCount> m_plots;
    std::vector<std::size_t> m_shown;
    PlotFonts m_fonts;
    SeriesColours m_colours;
    QCPLayoutGrid *m_top;  ///< the legend, and free space
    QCPLayoutGrid *m_grid; ///< the plots
    QCPTextElement *m_footer;
    std::array<QCPMarginGroup *, kPlotColumns> m_columnMargins{};
    QSharedPointer<ScaleTicker> m_timeTicker;
};

} // namespace slidercrank
