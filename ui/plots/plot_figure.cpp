// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/plot_figure.h"

#include "ui/text/finding_text.h"
#include "ui/text/motion_facts.h"
#include "ui/text/written_number.h"

#include <algorithm>
#include <cmath>

namespace slidercrank
{

namespace
{

constexpr double kSmallestPart = 1e-10; // of the largest number on an axis: the closest zoom

/// Dashes and gaps, px. Pinned motions are told apart by them, the first pinned first.
const std::vector<double> kReferenceDashes{7.0, 6.0};
const std::array<std::vector<double>, kMostKept> kPinnedDashes{{{}, {13.0, 4.0}, {5.0, 4.0}, {2.0, 3.0}}};

Interval unite(const Interval &a, const Interval &b)
{
    return {std::min(a.lower, b.lower), std::max(a.upper, b.upper)};
}

std::optional<Interval> unite(const std::optional<Interval> &a, const std::optional<Interval> &b)
{
    return a && b ? unite(*a, *b) : a ? a : b;
}

/// The values of a curve within a time range.
std::optional<Interval> extentWithin(const std::vector<CurvePoint> &points, const Interval &time)
{
    return extremes(clip(points, time, {-1e300, 1e300}));
}

/// As many ticks as labels fit side by side.
AxisScale timeScale(const Interval &range, bool isAngle, double width, double digitWidth)
{
    constexpr double kLeast = 44.0; // px from tick to tick
    constexpr double kSpace = 14.0;
    const auto scaleFor = [&](double pixels) {
        return isAngle ? degreeScale(range, width / pixels) : axisScale(range, width / pixels);
    };
    return scaleFor(std::max(kLeast, digitWidth * scaleFor(kLeast).labelLength(range) + kSpace));
}

/// The axis of errors: from zero, or a few decades. Where errors grow beyond all bounds, nine tenths of them.
Interval errorRange(const std::vector<CurvePoint> &points, const Interval &extent, bool isUnbounded, bool isLogarithmic)
{
    double largest = extent.upper;
    if (isUnbounded) {
        std::vector<double> values;
        for (const CurvePoint &point : points) {
            if (std::isfinite(point.value)) {
                values.push_back(point.value);
            }
        }
        const auto last = values.begin() + static_cast<std::ptrdiff_t>(values.size() * 9 / 10);
        std::ranges::nth_element(values, last);
        largest = *last;
    }
    if (!isLogarithmic) {
        return {0.0, roundedOutwards({0.0, largest}).upper};
    }
    constexpr double kMostDecades = 8.0;
    const double upper = std::ceil(largest);
    return {std::min(std::max(std::floor(extent.lower), upper - kMostDecades), upper - 1.0), upper};
}

/// Cuts the curve off at the axes and drops the points that nobody would see.
void fit(PlotCurve &curve, const Interval &time, const Interval &values, const QSize &axes)
{
    constexpr double kInvisible = 0.1; // px
    std::erase_if(curve.dots,
                  [&](const CurvePoint &dot) { return !time.contains(dot.t) || !values.contains(dot.value); });
    std::erase_if(curve.marks, [&](double t) { return !time.contains(t); });
    curve.points = clip(curve.points, time, values);
    if (curve.dots.empty()) {
        curve.dots = isolatedPoints(curve.points);
    }
    curve.points = withoutNeedlessPoints(curve.points, kInvisible * values.length() / std::max(axes.height(), 1));
    for (CurvePoint &point : curve.band) {
        point.value = std::clamp(point.value, values.lower, values.upper);
    }
}

/// "coupler angular velocity ω³ = dθ³/dt [°/s]", and what to write where that is too long.
QStringList titlesOf(Channel channel, const QString &unit)
{
    const QString name = quantityOf(channel);
    const QString symbol = symbolOf(channel);
    QStringList titles;
    if (channel.order != Order::Position) {
        const auto before = static_cast<Order>(static_cast<int>(channel.order) - 1);
        titles << QStringLiteral("%1 %2 = d%3/dt").arg(name, symbol, symbolOf(Channel{channel.coordinate, before}));
    }
    titles << QStringLiteral("%1 %2").arg(name, symbol) << name;
    switch (channel.order) {
    case Order::Position:
        titles << (isAngle(channel.coordinate) ? PlotFigure::tr("angle") : PlotFigure::tr("position"));
        break;
    case Order::Velocity: titles << PlotFigure::tr("velocity"); break;
    case Order::Acceleration: titles << PlotFigure::tr("acceleration"); break;
    }
    for (QString &title : titles) {
        title += QStringLiteral(" [%1]").arg(unit);
    }
    return titles;
}

} // namespace

void PlotFigure::setResult(const std::shared_ptr<const Result> &result)
{
    const Interval before = wholeRange();
    const bool isFirst = !m_result;
    m_result = result;
    m_model.reset();
    m_pinned.clear();
    m_compared.reset();
    if (isFirst || wholeRange() != before) {
        zoom.time.reset();
    }
}

void PlotFigure::setSettings(const PlotSettings &settings)
{
    for (std::size_t plot = kErrorColumn; plot < kPlotCount; plot += kPlotColumns) {
        zoom.values[plot].reset(); // another measure has other numbers
    }
    m_settings = settings;
    m_compared.reset();
}

bool PlotFigure::hasErrors() const
{
    return m_result && (m_result->reference || (m_result->difference && !m_isPresentation));
}

Interval PlotFigure::wholeRange() const
{
    if (!m_result) {
        return {};
    }
    const double start = m_result->sampling.start;
    const double end = start + m_result->sampling.duration;
    const Interval range{std::min(start, end), std::max(start, end)};
    return range.length() > 0.0 ? range : Interval{range.lower - 0.5, range.upper + 0.5};
}

void PlotFigure::zoomTime(const Interval &range)
{
    Interval outer = wholeRange();
    if (m_result && m_result->reference && !m_result->reference->data.time.empty()) {
        const std::vector<double> &time = m_result->reference->data.time;
        outer = unite(outer, Interval{time.front(), time.back()});
    }
    // Closer, neighbouring labels could not be told apart.
    const double largest = std::max({std::abs(outer.lower), std::abs(outer.upper), outer.length()});
    if (range.length() < std::min(timeRange().length(), kSmallestPart * largest)) {
        return;
    }
    const double length = std::min(range.length(), outer.length());
    const double lower = std::clamp(range.lower, outer.lower, outer.upper - length);
    zoom.time = Interval{lower, lower + length};
    if (length == outer.length()) {
        zoom.time = outer;
    }
    if (*zoom.time == wholeRange()) {
        zoom.time.reset();
    }
}

void PlotFigure::zoomValues(std::size_t plot, const Interval &range)
{
    constexpr double kLargestValue = 1e60;
    const double largest = std::max(std::abs(range.lower), std::abs(range.upper));
    if (range.length() >= kSmallestPart * largest && largest <= kLargestValue) {
        zoom.values[plot] = range;
    }
}

bool PlotFigure::isOverAngle() const
{
    return m_settings.abscissa == Abscissa::CrankAngle && m_result && m_result->mechanism.omega2() != 0.0;
}

TimeAxis PlotFigure::timeAxis(double pixels, double digitWidth) const
{
    TimeAxis axis{timeRange()};
    if (isOverAngle()) {
        axis.perUnit = 1.0 / (m_result->mechanism.omega2() * kDegreesPerRadian);
        axis.zero = -m_result->mechanism.theta20() / m_result->mechanism.omega2();
    }
    const double first = (axis.range.lower - axis.zero) / axis.perUnit;
    const double last = (axis.range.upper - axis.zero) / axis.perUnit;
    axis.scale = timeScale({std::min(first, last), std::max(first, last)}, isOverAngle(), pixels, digitWidth);
    axis.title = isOverAngle() ? QStringLiteral("θ₂ [%1]").arg(axis.scale.unit(QStringLiteral("°")))
                               : QStringLiteral("t [%1]").arg(axis.scale.unit(QStringLiteral("s")));
    return axis;
}

ModelCurves &PlotFigure::model()
{
    if (!m_model) {
        m_model = m_result ? ModelCurves(*m_result) : ModelCurves();
    }
    return *m_model;
}

std::vector<ModelCurves> &PlotFigure::pinned()
{
    if (m_result && m_pinned.size() != m_result->kept.size()) {
        m_pinned.clear();
        for (const Parameters &parameters : m_result->kept) {
            m_pinned.emplace_back(Mechanism(parameters), wholeRange());
        }
    }
    return m_pinned;
}

/// Null where there is nothing to compare with. Comparisons with a pinned motion are made for the pixels on show.
const ComparedMotion *PlotFigure::compared(std::size_t columns)
{
    if (!hasErrors()) {
        return nullptr;
    }
    const bool isOfFile = m_result->reference != nullptr;
    if (!m_compared && isOfFile) {
        m_compared.emplace(*m_result, m_settings);
    }
    if (!isOfFile && (!m_compared || m_comparedRange != timeRange() || m_comparedColumns != columns)) {
        m_comparedRange = timeRange();
        m_comparedColumns = columns;
        m_compared.emplace(*m_result, m_settings, timeRange(), columns);
    }
    return &*m_compared;
}

PlotPicture PlotFigure::picture(std::size_t plot, const QSize &axes)
{
    constexpr double kPixelsPerTick = 30.0;
    PlotPicture picture;
    const std::size_t columns = static_cast<std::size_t>(std::max(axes.width(), 1));
    const bool isError = isErrorPlot(plot);
    const std::size_t channel = isError ? plot / kPlotColumns * kChannelsPerRow : channelOf(plot);
    if (isError) {
        addErrors(picture, plot / kPlotColumns, columns);
    } else {
        addMotions(picture, channel, columns);
    }
    if (zoom.values[plot] && picture.hasValues) {
        picture.values = *zoom.values[plot];
    }
    const bool isLogarithmic = isError && m_settings.logarithmicError;
    const double ticks = axes.height() / kPixelsPerTick;
    picture.valueScale = isLogarithmic ? logarithmicScale(picture.values, ticks) : axisScale(picture.values, ticks);
    QString unit = isError ? errorUnit(channel) : unitOf(kPlottedChannels[channel]);
    unit = picture.hasValues ? picture.valueScale.unit(unit) : unit;
    const QString error = m_result && m_result->reference ? tr("error [%1]") : tr("difference [%1]");
    picture.titles = isError ? QStringList{error.arg(unit)} : titlesOf(kPlottedChannels[channel], unit);
    for (PlotCurve &curve : picture.curves) {
        fit(curve, timeRange(), picture.values, axes);
    }
    return picture;
}

void PlotFigure::addMotions(PlotPicture &picture, std::size_t channel, std::size_t columns)
{
    if (!m_result) {
        return;
    }
    const Interval time = timeRange();
    const auto isDense = [columns](const PlotCurve &curve) { return 2 * curve.points.size() >= 3 * columns; };
    std::optional<Interval> extent;
    for (std::size_t i = 0; i < pinned().size(); ++i) {
        PlotCurve curve{keptText(m_result->kept[i], m_result->mechanism.parameters()), &SeriesColours::kept};
        curve.points = m_pinned[i].points(channel, time, columns);
        curve.dashes = isDense(curve) ? std::vector<double>() : kPinnedDashes[i];
        curve.width = m_isPresentation ? curve.width : 1.0;
        extent = unite(extent, m_pinned[i].extremes(channel, time));
        picture.curves.push_back(curve);
    }
    PlotCurve curve{modelName()};
    curve.points = model().points(channel, time, columns);
    const std::optional<Interval> ofModel = model().extremes(channel, time);
    if (!model().isMotion()) {
        constexpr std::size_t kPixelsPerDot = 12;
        const QString tooFew = fewSamplesSentence(m_result->mechanism, m_result->sampling);
        if (!tooFew.isEmpty() || curve.points.size() * kPixelsPerDot < columns) {
            curve.dots = curve.points;
        }
        if (!tooFew.isEmpty() && !isDense(curve)) { // dense ones are as good as a band
            curve.points.clear();
        }
    }
    picture.curves.push_back(curve);
    extent = unite(extent, ofModel);
    if (!ofModel) {
        picture.note = tr("the mechanism cannot be assembled");
    }
    if (m_result->reference) {
        const ReferenceSeries *series = m_result->reference->data.find(kPlottedChannels[channel]);
        PlotCurve reference{m_result->reference->name, &SeriesColours::reference};
        if (series) {
            reference.points = decimate(m_result->reference->data.time, series->values, time, columns);
            reference.dashes = kReferenceDashes;
            extent = unite(extent, extentWithin(reference.points, time));
        } else if (picture.note.isEmpty()) {
            picture.note = tr("not in the file");
        }
        picture.curves.push_back(reference);
    }
    picture.hasValues = extent.has_value();
    if (extent) {
        picture.values = roundedOutwards(*extent);
    }
}

void PlotFigure::addErrors(PlotPicture &picture, std::size_t row, std::size_t columns)
{
    const ComparedMotion *compared = this->compared(columns);
    if (!compared) {
        return;
    }
    std::array<std::optional<Interval>, kChannelsPerRow> ranges;
    for (std::size_t i = 0; i < kChannelsPerRow; ++i) {
        const std::size_t index = row * kChannelsPerRow + i;
        const ComparedChannel &channel = compared->channel(index);
        PlotCurve curve{i == 0 ? tr("error of the coupler") : tr("error of the slider"),
                        i == 0 ? &SeriesColours::error : &SeriesColours::errorOther};
        if (!m_result->reference) {
            curve.name = i == 0 ? tr("difference of the coupler") : tr("difference of the slider");
        }
        curve.width = 1.6; // errors are noise where all is well
        const bool isAllZero = std::ranges::none_of(channel.errors, [this](double error) {
            return m_settings.logarithmicError ? std::isfinite(error) : error > 0.0;
        });
        if (!channel.reference.empty() && !(isAllZero && !m_result->reference)) {
            curve.points = decimate(compared->time(), channel.errors, timeRange(), columns);
            for (std::size_t k = 0; m_settings.error == ErrorMeasure::Percent && k < channel.errors.size(); ++k) {
                if (std::isfinite(channel.model[k]) && compared->isZero(index, channel.reference[k])) {
                    curve.marks.push_back(compared->time()[k]);
                }
            }
            if (channel.series && m_settings.roundingBand) {
                constexpr double kHalf = 0.5;
                curve.band = decimate(compared->time(), channel.reference, timeRange(), columns);
                for (CurvePoint &point : curve.band) {
                    const double half = kHalf * channel.series->rounding.stepAt(point.value);
                    point.value = compared->error(index, point.value + half, point.value);
                }
            }
            if (const std::optional<Interval> extent = extentWithin(curve.points, timeRange())) {
                ranges[i] = errorRange(curve.points, *extent, channel.isUnbounded, m_settings.logarithmicError);
            }
        }
        picture.curves.push_back(curve);
    }
    const std::optional<Interval> both = unite(ranges[0], ranges[1]);
    picture.hasValues = both.has_value();
    if (!both) {
        picture.note = missingErrors(row, picture);
        return;
    }
    picture.values = *both;
}

/// Why a plot shows no errors at all.
QString PlotFigure::missingErrors(std::size_t row, const PlotPicture &picture)
{
    const std::size_t first = row * kChannelsPerRow;
    const auto isInFile = [this](std::size_t channel) {
        return !m_result->reference || m_result->reference->data.find(kPlottedChannels[channel]);
    };
    if (!isInFile(first) && !isInFile(first + 1)) {
        return tr("not in the file");
    }
    if (!model().extremes(first, timeRange())) {
        return tr("the mechanism cannot be assembled");
    }
    if (std::ranges::any_of(picture.curves, [](const PlotCurve &curve) { return !curve.marks.empty(); })) {
        return tr("undefined: the reference is 0");
    }
    return m_result->difference && m_result->difference->channels[first].maxAbs == 0.0 ? tr("no difference")
                                                                                       : tr("nothing to compare");
}

/// In presentation mode what the model has that the motion pinned last has not, else "model".
QString PlotFigure::modelName() const
{
    const Parameters &model = m_result->mechanism.parameters();
    const QString few = model.omega2 != 0.0 && m_result->solver.method == Method::Newton
                            ? fewSamplesSentence(m_result->mechanism, m_result->sampling)
                            : QString();
    if (!few.isEmpty()) {
        return few;
    }
    const bool isNamed = m_isPresentation && !m_result->kept.empty() && m_result->kept.back() != model;
    return isNamed ? keptText(model, m_result->kept.back()) : tr("model");
}

QString PlotFigure::errorUnit(std::size_t channel) const
{
    switch (m_settings.error) {
    case ErrorMeasure::Percent: return QStringLiteral("%");
    case ErrorMeasure::Absolute:
        return QStringLiteral("%1; %2").arg(unitOf(kPlottedChannels[channel]), unitOf(kPlottedChannels[channel + 1]));
    case ErrorMeasure::OfPeak: return tr("% of peak");
    }
    return {};
}

double PlotFigure::roundedTime(double t) const
{
    constexpr double kPart = 1e-4; // of the range: less than a pixel
    const double place = std::pow(10.0, std::floor(std::log10(kPart * timeRange().length())));
    const double rounded = std::round(t / place) * place;
    return std::isfinite(rounded) ? rounded : t;
}

ReadTime PlotFigure::readTime(double t)
{
    if (m_result && m_result->reference) {
        const std::vector<double> &time = m_result->reference->data.time;
        if (!time.empty() && t >= time.front() && t <= time.back()) {
            const std::size_t row = nearestIndex(time, t);
            return {time[row], row};
        }
    }
    return {model().empty() ? t : model().instantNear(t), std::nullopt};
}

std::vector<PlotReading> PlotFigure::readings(std::size_t plot, const ReadTime &time)
{
    std::vector<PlotReading> readings;
    if (model().empty()) {
        return readings;
    }
    const auto add = [&](double value, Ink ink, bool isLogarithm = false) {
        if (std::isfinite(value)) {
            readings.push_back({time.t, value, isLogarithm ? std::pow(10.0, value) : value, ink});
        }
    };
    const auto modelAt = [&](std::size_t channel) { // the file's time stamps are sampled for its own channels only
        const std::span<const double> sampled = m_result->atReference[kPlottedChannels[channel]];
        return time.row && *time.row < sampled.size() ? sampled[*time.row] : model().value(channel, time.t);
    };
    if (!isErrorPlot(plot)) {
        const std::size_t channel = channelOf(plot);
        add(modelAt(channel), &SeriesColours::model);
        for (ModelCurves &motion : pinned()) {
            add(motion.value(channel, time.t), &SeriesColours::kept);
        }
        if (time.row) {
            const ReferenceSeries *series = m_result->reference->data.find(kPlottedChannels[channel]);
            add(series ? series->values[*time.row] : kNoValue, &SeriesColours::reference);
        }
        return readings;
    }
    const ComparedMotion *compared = this->compared(std::max<std::size_t>(m_comparedColumns, 1));
    for (std::size_t i = 0; compared && i < kChannelsPerRow; ++i) {
        const std::size_t channel = plot / kPlotColumns * kChannelsPerRow + i;
        const ComparedChannel &errors = compared->channel(channel);
        double error = kNoValue;
        if (time.row && !errors.errors.empty()) {
            error = errors.errors[*time.row];
        } else if (!m_result->reference) {
            error = compared->error(channel, modelAt(channel), pinned().back().value(channel, time.t));
        }
        add(error, i == 0 ? &SeriesColours::error : &SeriesColours::errorOther, m_settings.logarithmicError);
    }
    return readings;
}

QString PlotFigure::timeText(double t) const
{
    if (!isOverAngle()) {
        return QStringLiteral("t = %1").arg(durationText(t));
    }
    const double theta20 = m_result->mechanism.theta20() / m_result->mechanism.omega2();
    return QStringLiteral("θ₂ = %1").arg(durationText(t + theta20));
}

QString PlotFigure::durationText(double seconds) const
{
    return isOverAngle() ? numberText(seconds * m_result->mechanism.omega2() * kDegreesPerRadian) + u'°'
                         : tr("%1 s").arg(numberText(seconds));
}

} // namespace slidercrank
