// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What the nine plots show of a Result, as plain data for a given size in pixels: rows position, velocity,
// acceleration; columns θ³, Rₓ⁴, error. Values are in the units of the reference files (mm, °, s), errors in these or
// in percent.

#include "ui/document/result.h"
#include "ui/document/view_settings.h"
#include "ui/plots/compared_motion.h"
#include "ui/plots/curve_sampling.h"
#include "ui/plots/model_curves.h"
#include "ui/text/axis_scale.h"
#include "ui/text/theme.h"

#include <QCoreApplication>
#include <QLocale>
#include <QSize>
#include <QString>
#include <QStringList>

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace slidercrank
{

inline constexpr std::size_t kChannelsPerRow = 2;

/// A colour of the palette in use; what is drawn knows no palette.
using Ink = QColor SeriesColours::*;

/// The horizontal axis is one of time (s). Its labels are seconds, or the crank's angle, which is linear in time.
struct TimeAxis {
    Interval range;
    double zero = 0.0;    ///< s, where the label is 0
    double perUnit = 1.0; ///< s
    AxisScale scale = {}; ///< of the labels
    QString title = {};   ///< "t [s]", "θ₂ [°]"
};

/// A curve of a plot, cut off at the axes.
struct PlotCurve {
    QString name; ///< in the legend
    Ink ink = &SeriesColours::model;
    std::vector<CurvePoint> points = {};
    std::vector<CurvePoint> dots = {}; ///< samples that are to be seen one by one
    std::vector<double> marks = {};    ///< time stamps at which the value is undefined
    std::vector<CurvePoint> band = {}; ///< upper edge of what the file's rounding alone may make
    std::vector<double> dashes = {};   ///< px, lengths of dashes and gaps; empty: solid
    double width = 2.0;                ///< px
};

struct PlotPicture {
    QStringList titles; ///< the same, the longest first
    QString note;       ///< why something is missing
    std::vector<PlotCurve> curves;
    Interval values;
    AxisScale valueScale;
    bool hasValues = false;
};

/// A time at which values are read: with a reference file, within its time, one of its own time stamps.
struct ReadTime {
    double t = 0.0;
    std::optional<std::size_t> row; ///< of the file
};

/// A value read off a curve.
struct PlotReading {
    double t = 0.0;     ///< s
    double value = 0.0; ///< as the axis has it
    double number = 0.0;
    Ink ink = &SeriesColours::text;
};

/// What a Result looks like, and what part of it is in view. The value axes fit what is seen of the time, except those
/// whose range a person chose.
class PlotFigure
{
    Q_DECLARE_TR_FUNCTIONS(slidercrank::PlotFigure)

public:
    void setResult(const std::shared_ptr<const Result> &result); ///< may be null
    const std::shared_ptr<const Result> &result() const { return m_result; }

    void setSettings(const PlotSettings &settings);
    const PlotSettings &settings() const { return m_settings; }

    /// In presentation mode pinned curves are as thick as the model's, every motion is named by what differs, and
    /// errors are shown of a file only.
    void setPresentation(bool isPresentation) { m_isPresentation = isPresentation; }
    bool isPresentation() const { return m_isPresentation; }

    /// Whether there are errors to show.
    bool hasErrors() const;

    PlotZoom zoom; ///< the time of all nine plots, the values of each

    /// Limits the range to where there is something to see.
    void zoomTime(const Interval &range);
    void zoomValues(std::size_t plot, const Interval &range);
    Interval timeRange() const { return zoom.time.value_or(wholeRange()); }

    TimeAxis timeAxis(double pixels, double digitWidth) const;
    PlotPicture picture(std::size_t plot, const QSize &axes);

    /// A time rounded to what a pointer can tell apart, so that what is read is true of the time written beside it.
    double roundedTime(double t) const;

    /// The time at which values are read next to t.
    ReadTime readTime(double t);
    std::vector<PlotReading> readings(std::size_t plot, const ReadTime &time);

    /// "t = 0.25 s", over the crank's angle "θ₂ = 90°".
    QString timeText(double t) const;

    /// The same of a difference of times, without its name: "0.25 s", "90°".
    QString durationText(double seconds) const;

private:
    Interval wholeRange() const; ///< the sampled one
    bool isOverAngle() const;
    ModelCurves &model();
    std::vector<ModelCurves> &pinned();
    const ComparedMotion *compared(std::size_t columns);
    void addMotions(PlotPicture &picture, std::size_t channel, std::size_t columns);
    void addErrors(PlotPicture &picture, std::size_t row, std::size_t columns);
    QString missingErrors(std::size_t row, const PlotPicture &picture);
    QString modelName() const;
    QString errorUnit(std::size_t channel) const;

    std::shared_ptr<const Result> m_result;
    PlotSettings m_settings;
    bool m_isPresentation = false;

    // Computed when somebody looks.
    std::optional<ModelCurves> m_model;
    std::vector<ModelCurves> m_pinned;
    std::optional<ComparedMotion> m_compared;
    std::optional<Interval> m_comparedRange; ///< of a comparison with a pinned motion, and its pixel columns
    std::size_t m_comparedColumns = 0;
};

} // namespace slidercrank
