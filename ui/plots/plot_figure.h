// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Draws the nine plots of a Result in one QCustomPlot. The rows are position, velocity and acceleration; the columns
// are θ³, Rₓ⁴ and error. All share one legend and one time axis. Values are in the units of files (mm, °, s), which the
// labels convert to those that are shown; errors are in the units that are shown or in percent. The value axes fit the
// curves within the time shown, unless the user chose their range.

#include "ui/document/result.h"
#include "ui/document/view_settings.h"
#include "ui/plots/motion_curves.h"
#include "ui/plots/motion_errors.h"
#include "ui/plots/plot_cursor.h"
#include "ui/plots/plot_fonts.h"
#include "ui/text/notation.h"
#include "ui/text/theme.h"

#include <QCoreApplication>
#include <QMap>
#include <QPen>
#include <QSharedPointer>
#include <QStaticText>
#include <QWidget>

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

class QCPAxis;
class QCPAxisRect;
class QCPMarginGroup;

namespace slidercrank
{

class NumberTicker;
class PlotDrawing;

/// A colour by its member of SeriesColours, so that it follows the palette.
using Ink = QColor SeriesColours::*;

/// A time at which values are read. The model and pinned motions are read at `t`. A reference file has values at its
/// time stamps only: its nearest row is read.
struct ReadTime {
    double t = 0.0;
    std::optional<std::size_t> row; ///< of the file; nullopt outside its time
};

/// A curve of a plot, clipped to the axes.
struct PlotCurve {
    QString name; ///< in the legend
    Ink ink = &SeriesColours::model;
    std::vector<CurvePoint> points = {};

    /// Returns the value that a cursor shows, in axis units, and the time of the value: that of the nearest row of the
    /// file or time step if the curve has no value in between. Empty if a cursor shows no value of the curve.
    std::function<CurvePoint(const ReadTime &)> readout = {};

    /// Returns the exact value at a time, for drawing. Empty if the curve consists of samples.
    std::function<double(double)> valueAt = {};

    double width = kCurveWidth;        ///< px
    QVector<double> dashes = {};       ///< lengths of dashes and gaps in line widths; empty for a solid line
    std::vector<CurvePoint> dots = {}; ///< samples that are drawn as single dots

    PlotCursor::Rank rank = PlotCursor::Rank::Model; ///< importance of the value that a cursor shows

    /// A dot with this value is drawn at the upper edge of the axes.
    static constexpr double kUpperEdge = kInfinity;
};

struct Plot {
    QCPAxisRect *axes = nullptr; ///< null if the plot is not shown
    QCPAxis *timeAxis = nullptr;
    QCPAxis *valueAxis = nullptr;
    QSharedPointer<NumberTicker> ticker;
    std::vector<PlotCurve> curves;
    std::optional<Interval> values;  ///< the range of the axis; nullopt if there are no values
    QString note;                    ///< says which values are missing, and why
    std::vector<QStaticText> titles; ///< variants of the title, the longest first
    std::size_t title = 0;           ///< index of the variant that is drawn
    bool hasTimeLabels = true;       ///< whether the time axis has numbers and a title
};

/// A value read off a curve.
struct PlotReading {
    double t = 0.0;      ///< the time of the value, s
    double value = 0.0;  ///< position on the axis; a logarithm if the axis is logarithmic
    double number = 0.0; ///< the number to show
    Ink ink = &SeriesColours::text;
    PlotCursor::Rank rank = PlotCursor::Rank::Model;
    std::size_t curve = 0; ///< its index in the plot
};

/// What an exported figure contains.
struct FigureContent {
    std::vector<std::size_t> plots = {};   ///< numbers of the plots, in order; empty for all that can be shown
    std::optional<double> cursorTime = {}; ///< s; the values at this time are written beside a line
    std::optional<Interval> time = {};     ///< s, the time range; nullopt for that of the screen
};

/// The plots that are shown, and their look.
struct PlotStyle {
    std::vector<std::size_t> plots;
    QFont font = {};
    QPalette palette = {};
    std::size_t maxColumns = kPlotColumns; ///< of plots; if it is below kPlotColumns, the errors follow the motions
    double detail = 1.0;                   ///< size (px) of the smallest detail that the device shows
    QString comparedWith{};                ///< name of the pinned motion that is compared; may be empty
    bool isOfFile = false;                 ///< whether the errors are those of a file
    ErrorMeasure error = ErrorMeasure::OfPeak;
    Notation notation = slidercrank::notation(); ///< of the titles and axes
    std::optional<double> cursorTime = {};       ///< s; the values at this time are written beside a line

    friend bool operator==(const PlotStyle &, const PlotStyle &) = default;
};

class PlotFigure : public QWidget
{
    Q_DECLARE_TR_FUNCTIONS(slidercrank::PlotFigure)

public:
    PlotFigure();
    ~PlotFigure() override;

    void setResult(const std::shared_ptr<const Result> &result); ///< required before compose()
    const std::shared_ptr<const Result> &result() const { return m_result; }

    void setSettings(const PlotSettings &settings);
    const PlotSettings &settings() const { return m_settings; }

    /// In presentation mode pinned curves are as thick as the model's, every motion is named by the parameters that
    /// differ, and no errors are shown.
    void setPresentation(bool isPresentation);
    bool isPresentation() const { return m_isPresentation; }

    bool hasErrors() const; ///< whether there are errors to show

    /// Return and set the time range of all plots and the value range of each.
    const PlotZoom &zoom() const { return m_zoom; }
    void setZoom(const PlotZoom &zoom);

    /// Zooms to a time range (s), limited to the time range of the motion.
    void zoomTime(const Interval &range);
    void zoomValues(std::size_t plot, const Interval &range);
    Interval timeRange() const { return m_zoom.time.value_or(sampledRange()); }

    /// Lays out the plots for that size (px) and fills them.
    void compose(PlotStyle style, const QSize &size);

    /// Draws the figure on a pixmap or, in its paint event, a widget of the size for which it is composed.
    void drawInto(QPaintDevice &device);

    /// Draws the figure at the size for which it is composed.
    void paint(QPainter &painter);

    /// Returns how many plots can be read side by side in an exported figure of that width (px), at most kPlotColumns.
    static std::size_t columnsThatFit(int width, const QFont &font);

    /// Returns the height (px) at which the plots have good proportions in a figure of that width, with as many columns
    /// as fit.
    static int heightFor(const std::vector<std::size_t> &plots, int width, const QFont &font);

    const std::vector<std::size_t> &plots() const { return m_style.plots; }
    const Plot &shownPlot(std::size_t plot) const { return m_plots[plot]; }

    /// Returns the time nearest to t at which all curves have values: a time stamp of the file or, outside its time or
    /// without a file, a time step of a sampled motion, or any time of an exact one.
    ReadTime readTime(double t) const;

    /// Returns the values of a plot that is shown, in the order of the legend.
    std::vector<PlotReading> readings(std::size_t plot, const ReadTime &time) const;

    /// Returns a cursor of a plot that is shown, in px of the figure, with the headings and the values of the curves at
    /// that time (s). A curve that has no value at that time, such as a file between two rows, is read at the nearest
    /// time at which it has one: its dot is drawn there, and the number begins with "≈". Returns nullopt if the time is
    /// not shown or the plot has no values.
    std::optional<PlotCursor> cursorAt(std::size_t plot, double time, const QStringList &headings) const;

    /// Returns "t = 0.2500 s", or over the crank angle "θ₂ = 90.00°". With the time `since`, returns the difference
    /// from it: "Δt = 0.2500 s".
    QString timeText(double t, const std::optional<double> &since = {}) const;

protected:
    /// Returns "velocity error".
    static QString nameOfErrors(Order order);

    /// Requests a layout after a change of the data, the ranges or the style. Qt combines the requests of one pass of
    /// the event loop into one.
    virtual void requestRefresh();

    /// Returns the height (px) by which the legend exceeds the single line for which heightFor() has space.
    int excessOfLegend() const;

    PlotZoom m_zoom;
    bool m_isStale = true; ///< compose() has to be called
    QSize m_legendSize;    ///< px

private:
    /// A motion with its curves for the time range and the pixels of the plots.
    struct ShownMotion {
        MotionCurves motion;
        MotionCurves::Curves curves = {};
    };

    Interval sampledRange() const;
    bool isOverAngle() const;
    ShownScale shownScaleOf(std::size_t plot) const;
    bool isLogarithmic(std::size_t plot) const;
    double perSecond() const; ///< numbers on the time axis per second: 1, or over the crank angle its shown speed
    double zeroTime() const;  ///< the time at which the number on the time axis is 0, s
    const MotionCurves &model() const { return m_model->motion; }
    std::optional<std::size_t> nearestRow(double t) const;
    CurvePoint modelPoint(std::size_t channel, const ReadTime &time) const;
    CurvePoint filePoint(std::size_t channel, const ReadTime &time) const;
    CurvePoint errorPoint(std::size_t channel, const ReadTime &time) const;
    double lastPinnedValue(std::size_t channel, double t) const; ///< requires a pinned motion
    QStringList cursorTexts(double t) const;
    void computeMotions(Plot &plot, std::size_t channel);
    static QString nameWithGaps(const QString &name, const ShownMotion &shown);
    PlotCurve pinnedCurve(std::size_t pinned, std::size_t channel) const;
    PlotCurve modelCurve(std::size_t channel) const;
    PlotCurve fileCurve(std::size_t channel) const;
    QString noteOfMotions(std::size_t channel) const;
    void computeErrors(Plot &plot, Order order);
    void addCurvesBeside(PlotCursor &cursor, const Plot &plot) const;
    PlotCurve errorCurve(std::size_t channel) const;
    PlotCurve roundingCurve(std::size_t channel) const;
    PlotCurve undefinedMarks(std::size_t channel) const;
    Interval errorRange(const Interval &errors) const;
    QString missingModel() const;
    QString missingErrors(Order order) const;

    void applyStyle(const PlotStyle &style);
    void fill();
    void computePlot(std::size_t index);
    void scaleAxis(std::size_t index);
    void drawCurves(Plot &plot);
    void setTimeScale();
    QString errorUnit(Order order) const;
    QStringList errorTitles(Order order) const;
    static QStringList motionTitles(Channel channel);
    QStringList titles(std::size_t index) const;
    QRectF notePlace(const Plot &plot) const;
    Interval withSpaceForNote(const Plot &plot, const Interval &values) const;
    void chooseTitles();
    QSize placeLegend(QPainter *painter = nullptr);
    QPoint placeTimes(QPoint place, QPainter *painter) const;
    QPen addCurve(const Plot &plot, const PlotCurve &curve);
    void drawTexts(QPainter &painter);

    std::unique_ptr<PlotDrawing> m_drawing;
    std::shared_ptr<const Result> m_result;
    PlotSettings m_settings;
    bool m_isPresentation = false;
    std::vector<ShownMotion> m_pinned;  ///< in the order of Result::pinned
    std::optional<ShownMotion> m_model; ///< nullopt before setResult()

    // Computed for the time range and the pixels of the plots.
    std::size_t m_columns = 1; ///< width of a plot in details (PlotStyle::detail)
    std::optional<MotionErrors> m_errors;
    std::array<Plot, kPlotCount> m_plots;

    PlotStyle m_style;
    PlotFonts m_fonts;
    SeriesColours m_colours;
    std::vector<std::pair<QString, QPen>> m_legend;
    QMap<QString, QStaticText> m_names; ///< names of the curves in the legend, laid out
    QCPMarginGroup *m_margins;
    QSharedPointer<NumberTicker> m_timeTicker;
};

} // namespace slidercrank
