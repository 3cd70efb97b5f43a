// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The settings of the plots, of the drawing and of the table of the motion, which are saved with a scene.

#include "core/limits/output_channel.h"
#include "core/mechanism/channel.h"
#include "ui/text/interval.h"

#include <QString>

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace slidercrank
{

inline constexpr std::size_t kPlotRows = 3;
inline constexpr std::size_t kPlotColumns = 3;
inline constexpr std::size_t kPlotCount = kPlotRows * kPlotColumns; ///< plots are numbered row by row
inline constexpr std::size_t kErrorColumn = 2; ///< the columns before it are the plots of θ3 and R4x
inline constexpr std::size_t kChannelsPerRow = kErrorColumn;

constexpr bool isErrorPlot(std::size_t plot)
{
    return plot % kPlotColumns == kErrorColumn;
}

/// Returns what the row of a plot shows: positions, velocities or accelerations.
constexpr Order orderOfPlot(std::size_t plot)
{
    return static_cast<Order>(plot / kPlotColumns);
}

/// Returns the index in kPlottedChannels of the channel that a plot shows. Requires a plot that shows no errors.
constexpr std::size_t channelIndex(std::size_t plot)
{
    return plot / kPlotColumns * kChannelsPerRow + plot % kPlotColumns;
}

/// Returns whether kPlottedChannels has the order of the plots: in each row θ3, then R4x.
consteval bool areChannelsInOrderOfPlots()
{
    for (std::size_t plot = 0; plot < kPlotCount; ++plot) {
        const Coordinate coordinate = plot % kPlotColumns == 0 ? Theta3 : R4x;
        if (!isErrorPlot(plot) && kPlottedChannels[channelIndex(plot)] != Channel{coordinate, orderOfPlot(plot)}) {
            return false;
        }
    }
    return kPlotRows == kOrderCount;
}
static_assert(areChannelsInOrderOfPlots());

/// Returns the name of a plot: "plot_theta3", "plot_error_velocity", …
inline QString plotName(std::size_t plot)
{
    if (!isErrorPlot(plot)) {
        return "plot_" + QString::fromUtf8(nameOf(kPlottedChannels[channelIndex(plot)]));
    }
    switch (orderOfPlot(plot)) {
    case Order::Position: break;
    case Order::Velocity: return "plot_error_velocity";
    case Order::Acceleration: return "plot_error_acceleration";
    }
    return "plot_error_position";
}

/// A plot that the user can choose.
struct NamedPlot {
    QString name; ///< plotName()
    QString text;
};

enum class ErrorMeasure {
    Percent,  ///< |model - reference| / |reference|, as in the reference report; undefined where the reference is zero
    Absolute, ///< |model - reference|, in the units that are shown
    OfPeak    ///< |model - reference| / max |reference|
};

enum class Abscissa { Time, CrankAngle };

struct PlotSettings {
    ErrorMeasure error = ErrorMeasure::OfPeak;
    bool logarithmicError = false;
    bool roundingBand = true; ///< a curve: the error that half a rounding step of the file causes
    Abscissa abscissa = Abscissa::Time;

    friend bool operator==(const PlotSettings &, const PlotSettings &) = default;
};

/// The visible ranges of the plots. Without a value, the whole time range is visible, and all values within it.
struct PlotZoom {
    std::optional<Interval> time;                           ///< s, in all nine plots
    std::array<std::optional<Interval>, kPlotCount> values; ///< decimal logarithms if the axis is logarithmic

    friend bool operator==(const PlotZoom &, const PlotZoom &) = default;
};

/// What the drawing shows beside the linkage.
struct MechanismSettings {
    bool velocity = false;
    bool acceleration = false;
    bool path = false; ///< the path of the coupler's centre of mass
    bool names = false;
    bool dimensions = false;
    bool angles = false;        ///< θ₂ and θ³
    bool instantCentre = false; ///< the instant centre of the coupler, with the velocities of A and B

    bool showsVelocity() const { return velocity || instantCentre; } ///< of at least one point

    friend bool operator==(const MechanismSettings &, const MechanismSettings &) = default;
};

enum class TableStep { CrankAngle, Time };

struct MotionTableSettings {
    TableStep step = TableStep::CrankAngle;
    double angleStep = 15.0; ///< °
    double timeStep = 0.05;  ///< s
    std::vector<OutputChannel> columns;

    friend bool operator==(const MotionTableSettings &, const MotionTableSettings &) = default;
};

/// Limits of angleStep (°) and of timeStep (s).
inline constexpr double kShortestTableStep = 1e-3;
inline constexpr double kLongestTableStep = 1e6;

} // namespace slidercrank
