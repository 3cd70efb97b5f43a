// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What the nine plots of Figure 2 show of a Result, as plain data for a given size in pixels: rows position, velocity,
// acceleration; columns θ³, R_x⁴, error. Values are in the units of the author's files (mm, °, s), errors in these or
// in per cent.

#include "ui/document/result.h"
#include "ui/document/view_settings.h"
#include "ui/plots/curve_sampling.h"
#include "ui/plots/difference_curves.h"
#include "ui/plots/model_curves.h"
#include "ui/text/axis_scale.h"

#include <QCoreApplication>
#include <QLocale>
#include <QSize>
#include <QString>

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace slidercrank
{

/// px; without a gap a line is solid.
struct Dashes {
    double length = 0.0;
    double gap = 0.0;
};
inline constexpr Dashes kReferenceDashes{7.0, 6.0};

/// Of motions that were kept, the first kept first.
inline constexpr std::array<Dashes, kMostKept> kKeptDashes{{{}, {13.0, 4.0}, {5.0, 4.0}, {1.5, 3.0}}};

inline constexpr std::size_t kChannelsPerRow = 2;
inline constexpr int kErrorDigits = 3;

/// "θ³", "dRₓ⁴/dt", …, of one of kPlottedChannels, and its unit in the author's files.
QString quantity(std::size_t channel);
QString channelUnit(std::size_t channel);

/// Which of seriesColours() a part of a picture takes: pictures know no palette.
enum class Ink { Text, Model, Reference, Kept, Error, ErrorOther };

struct InkedText {
    QString text;
    Ink ink = Ink::Text;
};

/// All that one plot shows, for one size of its axes.
struct PlotPicture {
    QString title;
    std::array<QString, 2> words;        ///< before the title where there is room, the longer first: "coupler angle "
    std::vector<InkedText> remarks;      ///< right of the title
    std::vector<InkedText> shortRemarks; ///< where those do not fit
    QString note;                        ///< in the middle, where there is no curve

    struct Curve {
        std::vector<CurvePoint> points; ///< within the axes, cut into dashes
        bool isOfSamples = false;       ///< with nothing between them
        bool isJoined = true;           ///< by lines
        std::vector<double> marks;      ///< instants where the curve has no value because it is infinite
        Ink ink = Ink::Model;
        Dashes dashes;
        std::vector<CurvePoint> dots; ///< points to be seen each: no line reaches them, or there are few
        std::vector<CurvePoint> band; ///< upper edge of what the file's rounding alone may make
    };
    std::array<Curve, 2> curves;
    std::vector<Curve> kept; ///< under them

    /// The horizontal axis is one of time (s), labelled in seconds or with the crank angle, which is linear in time.
    struct TimeLabels {
        double zero = 0.0;    ///< s, where the label is 0
        double perUnit = 1.0; ///< s
        AxisScale scale;      ///< of the labels
        QString title;        ///< "t [s]", "θ₂ [°]"
        double at(double seconds) const { return (seconds - zero) / perUnit; }
        QString label(double seconds) const { return scale.label(at(seconds), QLocale()); }
    };

    Interval time;
    TimeLabels timeLabels;
    Interval values;
    AxisScale valueScale;
    std::optional<Interval> rightValues; ///< of the second curve, where it has an axis of its own
    AxisScale rightScale;
    bool hasValues = false;
    bool hasTimeLabels = true;
    std::optional<double> markedTime; ///< a line across the axes
};

struct LegendEntry {
    enum class Sample { Solid, Dashed, Dots, Mark, Band };
    Sample sample = Sample::Solid;
    Ink ink = Ink::Model;
    QString text;
    bool mayBeElided = false;
    bool mayBeLeftOut = false; ///< where there is no room for all; the last such entry first
    Dashes dashes = kReferenceDashes;
};

/// A column of the file, beside the model.
struct ShownChannel {
    std::span<const double> reference; ///< empty where the file has no such column
    std::span<const double> modelAtReference;
    const ReferenceSeries *series = nullptr;
    double perDifference = 1.0; ///< what a difference is multiplied by to be an error; of a percentage, before it is
                                ///< divided by the value
    std::vector<double> errors; ///< in the chosen measure, at the file's instants; NaN where there is none
    std::vector<double> zeroReference; ///< instants where the reference is zero
    std::optional<double> largestError;
};

/// What is shown of a Result, as numbers.
struct ShownData {
    ShownData() = default; ///< nothing
    /// `result` must outlive it.
    ShownData(const Result &result, const PlotSettings &settings);

    /// Half a rounding step of the file as an error, where its curve has the points that are drawn.
    std::vector<CurvePoint> roundingBand(std::size_t channel, const PixelColumns &pixels) const;

    PlotSettings settings;
    ModelCurves model;
    std::span<const double> referenceTime;
    std::array<ShownChannel, ModelCurves::kChannels> channels; ///< as in kPlottedChannels
};

/// What a Result looks like, and what of it is to be seen. Converted once a Result, and only when somebody looks. The
/// values fit what is seen of the time, but for those that a person chose, by a box or by the wheel on their axis.
class PlotFigure
{
    Q_DECLARE_TR_FUNCTIONS(slidercrank::PlotFigure)

public:
    std::shared_ptr<const Result> result; ///< may be null; set by setResult()
    std::optional<Interval> timeZoom;     ///< of all nine; set by zoomTime()
    std::array<std::optional<Interval>, kPlotCount> valueZoom;

    void setResult(const std::shared_ptr<const Result> &newResult);
    void setSettings(const PlotSettings &settings);
    const PlotSettings &settings() const { return m_settings; }

    /// Whether there is something that the model could be in error of.
    bool hasErrors() const { return result && result->isCompared(); }

    /// Whether lengths have an axis of their own there.
    bool hasRightAxis(std::size_t plot) const;

    /// As far as there is something to see.
    void zoomTime(const Interval &range);

    /// Closer or farther, about a point of the axis that stays.
    void zoomTime(double about, double factor);
    void zoomValues(std::size_t plot, const Interval &shown, double about, double factor);
    void zoomValues(std::size_t plot, const Interval &range);

    /// One plot whose axes have that size in pixels and whose time axis has characters of that width.
    PlotPicture picture(std::size_t plot, const QSize &axes, double digitWidth);

    /// Of all nine plots, or of one only.
    std::vector<LegendEntry> legend(std::optional<std::size_t> only) const;

    /// What can be read next to t (s): that instant of the motion, or the nearest sample; t itself where there is none.
    double nearestInstant(double t);

    /// t in as many places as a pointer can tell apart, so that what is read is true of the instant written beside it.
    double pointedInstant(double t) const;

    /// What the figure shows of the result; computed when somebody looks.
    ShownData &data();

    /// A motion that was kept, of the run on show.
    struct KeptMotion {
        Parameters parameters;
        Interval run;
        ModelCurves curves;
    };
    std::vector<KeptMotion> &kept();

    /// From the motion kept last, as the axis has it; there must be a difference.
    double differenceAt(std::size_t channel, double t);

    /// The one chosen; from a motion that was kept, which passes through zero, percentages are of the peak.
    ErrorMeasure measure() const;

    /// Of one of kPlottedChannels, in that measure.
    QString errorUnit(std::size_t channel) const;

    Interval wholeRange() const; ///< the sampled one
    Interval timeRange() const { return timeZoom.value_or(wholeRange()); }
    Interval outerRange() const; ///< with the reference's instants: as far as one can zoom out

private:
    PlotPicture::TimeLabels timeLabels(double width, double digitWidth) const;
    void fillModelPicture(PlotPicture &picture, std::size_t channel, std::size_t columns);
    QString fewSamples() const; ///< empty where no samples are on show, or enough
    void fillErrorPicture(PlotPicture &picture, std::size_t row, std::size_t columns);

    const DifferenceCurves &differences();
    std::vector<CurvePoint> differencePoints(std::size_t channel, const Interval &range, std::size_t columns);
    template <class ExtremesIn>
    std::optional<Interval> valuesSeen(const ExtremesIn &extremesIn) const;

    PlotSettings m_settings;
    std::optional<ShownData> m_data;
    std::vector<KeptMotion> m_kept;
    std::optional<DifferenceCurves> m_differences;

    struct DifferenceView {
        Interval range;
        std::size_t columns = 0;
        DifferenceCurves::Curves curves;
    };
    std::optional<DifferenceView> m_differenceView;
};

} // namespace slidercrank
