// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What the nine plots of Figure 2 show of a Result, as plain data for a given size in pixels: rows position, velocity,
// acceleration; columns θ³, R_x⁴, error. Values are in the units of the author's files (mm, °, s) and in per cent.

#include "ui/axis_scale.h"
#include "ui/curve_sampling.h"
#include "ui/session.h"

#include <QCoreApplication>
#include <QSize>
#include <QString>

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace slidercrank
{

inline constexpr std::size_t kPlotRows = 3;
inline constexpr std::size_t kPlotColumns = 3;
inline constexpr std::size_t kPlotCount = kPlotRows * kPlotColumns; ///< numbered row by row
inline constexpr std::size_t kErrorColumn = 2;

constexpr bool isErrorPlot(std::size_t plot)
{
    return plot % kPlotColumns == kErrorColumn;
}

/// "plot_theta3", "plot_error_velocity", …
QString plotName(std::size_t plot);

inline constexpr double kDash = 7.0;    // px, of the reference
inline constexpr double kDashGap = 6.0; // px

/// Which of seriesColours() a part of a picture takes: pictures know no palette.
enum class Ink { Text, Model, Reference, Error, ErrorOther };

struct InkedText {
    QString text;
    Ink ink = Ink::Text;
};

/// All that one plot shows, for one size of its axes.
struct PlotPicture {
    QString title;
    std::vector<InkedText> remarks;      ///< right of the title
    std::vector<InkedText> shortRemarks; ///< where those do not fit
    QString note;                        ///< in the middle, where there is no curve

    struct Curve {
        std::vector<CurvePoint> points; ///< within the axes; the reference cut into dashes
        std::vector<double> marks;      ///< instants where the curve has no value because it is infinite
        Ink ink = Ink::Model;
        std::vector<CurvePoint> dots; ///< points to be seen each: no line reaches them, or there are few
    };
    std::array<Curve, 2> curves;

    Interval time;
    Interval values;
    AxisScale timeScale;
    AxisScale valueScale;
    bool hasValues = false;
    bool hasTimeLabels = true;
    std::optional<double> markedTime; ///< a line across the axes
};

struct LegendEntry {
    enum class Sample { Solid, Dashed, Mark };
    Sample sample = Sample::Solid;
    Ink ink = Ink::Model;
    QString text;
    bool mayBeElided = false;
};

/// What a Result looks like, and what of it is to be seen. Converted once a Result, and only when somebody looks.
class PlotFigure
{
    Q_DECLARE_TR_FUNCTIONS(slidercrank::PlotFigure)

public:
    std::shared_ptr<const Result> result; ///< may be null; set by setResult()
    std::optional<Interval> timeZoom;     ///< of all nine; set by zoomTime()
    std::array<std::optional<Interval>, kPlotCount> valueZoom;

    void setResult(const std::shared_ptr<const Result> &newResult);

    /// As far as there is something to see.
    void zoomTime(const Interval &range);

    /// One plot whose axes have that size in pixels and whose time axis has characters of that width.
    PlotPicture picture(std::size_t plot, const QSize &axes, double digitWidth);
    std::vector<LegendEntry> legend(bool hasModel, bool hasErrors) const;
    /// What the plot shows near time t (s), for reading; empty where it shows nothing.
    QString readout(std::size_t plot, double t);

    Interval wholeRange() const; ///< the sampled one
    Interval timeRange() const { return timeZoom.value_or(wholeRange()); }
    Interval outerRange() const; ///< with the reference's instants: as far as one can zoom out

private:
    struct ShownChannel {
        std::span<const double> model;
        std::span<const double> reference; ///< empty where the file has no such column
        std::span<const double> modelAtReference;
        std::vector<double> percent;       ///< at the file's instants; NaN where it does not exist
        std::vector<double> zeroReference; ///< instants where the reference is zero
        std::optional<double> largestPercent;
    };

    void convert();
    void fillModelPicture(PlotPicture &picture, std::size_t channel, std::size_t columns) const;
    void fillErrorPicture(PlotPicture &picture, std::size_t row, std::size_t columns) const;
    std::optional<Interval> extremesWithin(const Interval &range, std::span<const double> instants,
                                           std::span<const double> values) const;

    bool m_isConverted = false;
    std::span<const double> m_time;
    std::span<const double> m_referenceTime;
    std::array<ShownChannel, kPlottedChannels.size()> m_channels;
    std::vector<double> m_reversed; ///< time and channels in ascending order, where the run goes backwards in time
};

} // namespace slidercrank
