// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/conventions.h"

#include "core/comparison.h"
#include "core/identification.h"
#include "core/trajectory.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <span>
#include <utility>

namespace slidercrank
{

namespace
{

using Kind = Convention::Kind;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// So many instants decide; of a longer file no more are looked at,
constexpr std::size_t kMostRows = 400;
/// ... and fewer could agree by chance.
constexpr std::size_t kFewestValues = 8;
/// Instants that one swing of a column must keep, or what lies between them is lost.
constexpr std::size_t kRowsPerSwing = 20;
/// Instants on which phases are compared before all of them are.
constexpr std::size_t kScanRows = 64;
/// Instants of one column from which a mechanism is found that all of them then judge.
constexpr std::size_t kWitnessRows = 100;
/// Phases of a turn that are tried for a late start: no motion has more than a few extremes a turn.
constexpr int kPhases = 128;

/// A factor between a column and the model is a unit's when it is this near to it: units lie further apart.
constexpr double kUnitTolerance = 0.05;
/// A column reads as a channel when no value is farther off, as part of how much the channel varies. The mechanism may
/// be known from one column only, and not well; that it is the one is then for kNearlyNothing to say.
constexpr double kLooselyEqual = 0.05;
/// What may be left of the error, as part of how much the channel varies, where the file's own rounding is not reached:
/// a derivative may have been computed with few digits, the data may have been measured. A derivative that is farther
/// off is none.
constexpr double kNearlyNothing = 0.01;
/// Values next to zero have finer steps than a shift that was found from the data can meet: so many steps of the
/// largest values are agreement too.
constexpr double kStepsOfAgreement = 5.0;
/// How many times smaller a finding makes the error, at least.
constexpr double kImprovement = 20.0;

constexpr std::array<double, 3> kAngleUnits{1.0, kDegreesPerRadian, 1.0 / kDegreesPerRadian};
/// Ratios of mm, cm, m, in.
constexpr std::array<double, 13> kLengthUnits{
    1.0, 10.0, 1e3, 25.4, 1e2, 1e3 / 25.4, 2.54, 1.0 / 10.0, 1.0 / 1e3, 1.0 / 25.4, 1.0 / 1e2, 25.4 / 1e3, 1.0 / 2.54};
constexpr std::array<double, 2> kTimeUnits{1e-3, 1e3}; ///< ms read as s, s read as ms

bool isPlotted(Channel channel)
{
    return std::find(kPlottedChannels.begin(), kPlottedChannels.end(), channel) != kPlottedChannels.end();
}

int orderOf(Channel channel)
{
    return static_cast<int>(channel.order);
}

double powerOf(double base, int exponent)
{
    double power = 1.0;
    for (int i = 0; i < exponent; ++i) {
        power *= base;
    }
    return power;
}

// ---- applying ------------------------------------------------------------------------------------------------------

void multiply(ReferenceSeries &series, double factor)
{
    for (double &value : series.values) {
        value *= factor;
    }
    series.rounding.unitFactor *= std::abs(factor);
}

/// Takes out jumps of whole turns: between two rows no angle of the mechanism turns by half of one.
void makeContinuous(std::span<double> degrees)
{
    double last = std::numeric_limits<double>::quiet_NaN();
    for (double &value : degrees) {
        if (std::isfinite(value)) {
            if (std::isfinite(last)) {
                value -= 360.0 * std::round((value - last) / 360.0);
            }
            last = value;
        }
    }
}

void turn(ReferenceSeries &series, double degrees)
{
    // A turned column keeps its decimals, but not its significant digits.
    Rounding &rounding = series.rounding;
    if (rounding.rule == Rounding::Rule::SignificantDigits) {
        double largest = 0.0;
        for (const double value : series.values) {
            largest = std::isfinite(value) ? std::max(largest, std::abs(value)) : largest;
        }
        const double step = rounding.stepAt(largest) / rounding.unitFactor;
        rounding.rule = Rounding::Rule::Decimals;
        rounding.digits = -static_cast<int>(std::lround(std::log10(step)));
    }
    makeContinuous(series.values);
    for (double &value : series.values) {
        value += degrees;
    }
}

bool concerns(const Convention &convention, Channel channel)
{
    return std::find(convention.channels.begin(), convention.channels.end(), channel) != convention.channels.end();
}

ReferenceData allApplied(std::span<const Convention> conventions, ReferenceData data)
{
    for (const Convention &convention : conventions) {
        data = applied(convention, std::move(data));
    }
    return data;
}

/// How much a channel varies; where it does not, how large it is.
double sizeOf(std::span<const double> values)
{
    constexpr double kVaries = 1e-3; // of the largest magnitude
    double lowest = kInfinity;
    double highest = -kInfinity;
    for (const double value : values) {
        if (std::isfinite(value)) {
            lowest = std::min(lowest, value);
            highest = std::max(highest, value);
        }
    }
    const double peak = std::max(std::abs(lowest), std::abs(highest));
    const double range = highest - lowest;
    return range > kVaries * peak ? range : peak;
}

// ---- the rows that decide ------------------------------------------------------------------------------------------

/// How often a column goes all the way up, from the lowest to the highest quarter of its range.
std::size_t swingsOf(std::span<const double> values)
{
    double lowest = kInfinity;
    double highest = -kInfinity;
    for (const double value : values) {
        if (std::isfinite(value)) {
            lowest = std::min(lowest, value);
            highest = std::max(highest, value);
        }
    }
    const double low = lowest + 0.25 * (highest - lowest);
    const double high = highest - 0.25 * (highest - lowest);
    std::size_t swings = 0;
    bool down = false;
    for (const double value : values) {
        if (down && value > high) {
            down = false;
            ++swings;
        } else if (value < low) {
            down = true;
        }
    }
    return swings;
}

/// The file, or so many instants from its start on that the motion is still to be seen between them.
ReferenceData decisiveRows(const ReferenceData &data, const std::stop_token &stop)
{
    const std::size_t rows = data.time.size();
    std::size_t stride = 1;
    if (rows > kMostRows) {
        std::size_t swings = 1;
        for (const ReferenceSeries &series : data.series) {
            if (stop.stop_requested()) {
                return {};
            }
            swings = std::max(swings, swingsOf(series.values));
        }
        stride = std::clamp<std::size_t>(rows / (swings * kRowsPerSwing), 1, rows / kMostRows);
    }

    ReferenceData some;
    for (const ReferenceSeries &series : data.series) {
        some.series.push_back({series.channel, {}, series.rounding});
    }
    for (std::size_t i = 0; i < kMostRows && i * stride < rows; ++i) {
        // Not exactly every so manieth: a column may have a value in every tenth row only.
        const std::size_t row = std::min(i * stride + i % std::min<std::size_t>(stride, 13), rows - 1);
        some.time.push_back(data.time[row]);
        for (std::size_t k = 0; k < data.series.size(); ++k) {
            some.series[k].values.push_back(data.series[k].values[row]);
        }
    }
    std::erase_if(some.series, [](const ReferenceSeries &series) {
        const auto isNumber = [](double value) { return std::isfinite(value); };
        return std::count_if(series.values.begin(), series.values.end(), isNumber) <
               static_cast<std::ptrdiff_t>(kFewestValues);
    });
    return some;
}

/// So many rows at least, spread evenly.
ReferenceData everySoManyth(const ReferenceData &data, std::size_t rows)
{
    const std::size_t stride = std::max<std::size_t>(1, data.time.size() / rows);
    ReferenceData some;
    for (const ReferenceSeries &series : data.series) {
        some.series.push_back({series.channel, {}, series.rounding});
    }
    for (std::size_t row = 0; row < data.time.size(); row += stride) {
        some.time.push_back(data.time[row]);
        for (std::size_t k = 0; k < data.series.size(); ++k) {
            some.series[k].values.push_back(data.series[k].values[row]);
        }
    }
    return some;
}

// ---- one column against one channel --------------------------------------------------------------------------------

/// How a column's numbers become a channel's: multiplied, then made continuous, then turned.
struct Reading {
    double unit = 1.0;     ///< of angle or length
    double timeUnit = 1.0; ///< of a derivative's time, with its power
    double sign = 1.0;
    bool turned = false;
    double turn = 0.0; ///< degrees

    double misfit = kInfinity; ///< largest error as part of the channel's size

    double factor() const { return sign * unit * timeUnit; }
    /// The time unit is a fault of the file, and none of the column.
    int steps() const { return (unit != 1.0) + (sign < 0.0) + turned; }
    bool isPlain() const { return steps() == 0 && timeUnit == 1.0; }
};

/// A column and what a channel would have in its place. Rows where either has no number do not count.
class ColumnPair
{
public:
    ColumnPair(std::span<const double> values, std::span<const double> model)
        : m_values(values)
        , m_model(model)
        , m_size(sizeOf(model))
    {
        std::size_t count = 0;
        std::size_t missing = 0;
        for (std::size_t i = 0; i < values.size(); ++i) {
            if (std::isfinite(values[i]) && std::isfinite(model[i])) {
                ++count;
                m_valueSquares += values[i] * values[i];
                m_products += values[i] * model[i];
            } else if (std::isfinite(values[i])) {
                ++missing;
            }
        }
        // A derivative does not exist at a toggle; a position that does not exist is another mechanism's.
        constexpr std::size_t kPresentForOneMissing = 20;
        m_comparable = count >= kFewestValues && count >= kPresentForOneMissing * missing;
    }

    bool comparable() const { return m_comparable; }

    /// The factor that brings the values nearest to the model.
    double bestFactor() const { return m_valueSquares > 0.0 ? m_products / m_valueSquares : 0.0; }

    /// The same reading with its misfit (infinite where it is too much), and, where it may turn, by how much.
    Reading measured(Reading reading) const
    {
        bool first = true;
        double largest = 0.0;
        for (std::size_t i = 0; i < m_values.size(); ++i) {
            double error = reading.factor() * m_values[i] + reading.turn - m_model[i];
            if (!std::isfinite(error)) {
                continue;
            }
            if (reading.turned) {
                if (first) {
                    reading.turn = -180.0 * std::round(error / 180.0);
                    error += reading.turn;
                    first = false;
                }
                error -= 360.0 * std::round(error / 360.0); // a jump that makeContinuous() takes out
            }
            largest = std::max(largest, std::abs(error));
            if (largest > kLooselyEqual * m_size) {
                reading.misfit = kInfinity;
                return reading;
            }
        }
        reading.misfit = largest == 0.0 ? 0.0 : largest / m_size; // of a channel of zeros, nothing else
        return reading;
    }

private:
    std::span<const double> m_values;
    std::span<const double> m_model;
    double m_size;
    double m_valueSquares = 0.0;
    double m_products = 0.0;
    bool m_comparable = false;
};

/// The reading of fewest steps that makes a column the channel, or none. `timeUnit`: of the instants.
std::optional<Reading> readAs(Channel channel, std::span<const double> values, std::span<const double> model,
                              double timeUnit)
{
    const ColumnPair pair(values, model);
    if (!pair.comparable()) {
        return std::nullopt;
    }
    std::optional<Reading> best;
    const auto consider = [&](const Reading &candidate) {
        const Reading reading = pair.measured(candidate);
        if (reading.misfit <= kLooselyEqual && (!best || reading.steps() < best->steps() ||
                                                (reading.steps() == best->steps() && reading.misfit < best->misfit))) {
            best = reading;
        }
    };
    consider({});
    if (best) {
        return best;
    }
    if (isAngle(channel.coordinate) && channel.order == Order::Position) {
        for (const double unit : kAngleUnits) {
            for (const double sign : {1.0, -1.0}) {
                for (const bool turned : {false, true}) {
                    consider({unit, 1.0, sign, turned});
                }
            }
        }
        return best;
    }
    const double factor = pair.bestFactor();
    const double perTimeUnit = powerOf(1.0 / timeUnit, orderOf(channel));
    const auto considerUnits = [&](std::span<const double> units) {
        for (const double unit : units) {
            for (const double derivative : {1.0, perTimeUnit}) {
                if (std::abs(std::abs(factor) / (unit * derivative) - 1.0) <= kUnitTolerance) {
                    consider({unit, derivative, factor < 0.0 ? -1.0 : 1.0});
                }
            }
        }
    };
    isAngle(channel.coordinate) ? considerUnits(kAngleUnits) : considerUnits(kLengthUnits);
    return best;
}

// ---- a file against a mechanism ------------------------------------------------------------------------------------

/// A mechanism, and how the file is to be read to be its motion.
struct Explanation {
    Parameters parameters;
    std::vector<Convention> conventions; ///< in the order of application
    double timeUnit = 1.0;               ///< that of the TimeUnit among them
};

Convention &add(std::vector<Convention> &conventions, Kind kind, double amount)
{
    for (Convention &convention : conventions) {
        if (convention.kind == kind && convention.amount == amount) {
            return convention;
        }
    }
    return conventions.emplace_back(Convention{kind, {}, amount});
}

/// Swaps that bring each column under the name of what it holds.
void addSwaps(std::vector<Convention> &conventions, std::vector<Channel> names, const std::vector<Channel> &contents)
{
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (names[i] == contents[i]) {
            continue;
        }
        const auto other = std::find(names.begin(), names.end(), contents[i]);
        std::vector<Channel> two{names[i], *other};
        std::sort(two.begin(), two.end(), [](Channel x, Channel y) { return indexOf(x) < indexOf(y); });
        conventions.push_back({Kind::SwappedColumns, two, 1.0});
        std::swap(names[i], *other);
    }
}

/// Whether the file has the coordinate, or a lower derivative of it, in a column that is understood.
bool hasLowerOrder(const ReferenceData &data, const std::vector<bool> &understood, Channel channel)
{
    for (std::size_t i = 0; i < data.series.size(); ++i) {
        const Channel other = data.series[i].channel;
        if (understood[i] && other.coordinate == channel.coordinate && other.order < channel.order) {
            return true;
        }
    }
    return false;
}

/// What is wrong with the columns if the model is right; nothing where a column cannot be understood. Expects the
/// conventions that `explanation` already has to be applied to the data.
bool explainColumns(const ReferenceData &data, const Trajectory &model, Explanation &explanation)
{
    const std::size_t count = data.series.size();
    std::vector<std::optional<Reading>> readings(count);
    std::vector<Channel> names;
    std::vector<bool> understood(count, false);
    for (std::size_t i = 0; i < count; ++i) {
        const ReferenceSeries &series = data.series[i];
        names.push_back(series.channel);
        readings[i] = readAs(series.channel, series.values, model[series.channel], explanation.timeUnit);
        understood[i] = readings[i].has_value();
    }

    // Columns under each other's names: the best pairs first, as long as there are any. Only the plotted channels take
    // part, and only whole cycles count.
    std::vector<Channel> contents = names;
    struct Pair {
        std::size_t column;
        std::size_t name;
        Reading reading;
    };
    std::vector<Pair> pairs;
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t k = 0; k < count; ++k) {
            if (i == k || understood[i] || understood[k] || !isPlotted(names[i]) || !isPlotted(names[k])) {
                continue;
            }
            const ReferenceSeries &series = data.series[i];
            if (const auto reading = readAs(names[k], series.values, model[names[k]], explanation.timeUnit)) {
                pairs.push_back({i, k, *reading});
            }
        }
    }
    std::stable_sort(pairs.begin(), pairs.end(), [](const Pair &x, const Pair &y) {
        return std::pair(x.reading.steps(), x.reading.misfit) < std::pair(y.reading.steps(), y.reading.misfit);
    });
    std::vector<bool> nameTaken(count, false);
    for (const Pair &pair : pairs) {
        if (!readings[pair.column] && !nameTaken[pair.name]) {
            readings[pair.column] = pair.reading;
            contents[pair.column] = names[pair.name];
            nameTaken[pair.name] = true;
        }
    }
    for (std::size_t i = 0; i < count; ++i) {
        const bool moved = contents[i] != names[i];
        if (moved != nameTaken[i]) {
            return false; // no cycle
        }
        understood[i] = understood[i] || moved;
    }
    addSwaps(explanation.conventions, names, contents);

    std::array<std::vector<Channel>, 2> signs; // an axis and a sense of rotation are not the same fault
    std::vector<Channel> notDerivatives;
    for (std::size_t i = 0; i < count; ++i) {
        const Channel channel = contents[i];
        if (!understood[i]) {
            if (!isPlotted(channel)) {
                continue;
            }
            if (!hasLowerOrder(data, understood, channel)) {
                return false;
            }
            notDerivatives.push_back(channel);
            continue;
        }
        const Reading &reading = *readings[i];
        if (reading.timeUnit != 1.0) {
            add(explanation.conventions, Kind::TimeUnit, explanation.timeUnit).channels.push_back(channel);
        }
        if (reading.unit != 1.0) {
            const Kind kind = isAngle(channel.coordinate) ? Kind::AngleUnit : Kind::LengthUnit;
            add(explanation.conventions, kind, reading.unit).channels.push_back(channel);
        }
        if (reading.sign < 0.0) {
            signs[isAngle(channel.coordinate) ? 1 : 0].push_back(channel);
        }
        if (reading.turned) {
            const Kind kind = std::fmod(reading.turn, 360.0) == 0.0 ? Kind::WholeTurns : Kind::HalfTurn;
            add(explanation.conventions, kind, reading.turn).channels.push_back(channel);
        }
    }
    for (const std::vector<Channel> &channels : signs) {
        if (!channels.empty()) {
            explanation.conventions.push_back({Kind::Sign, channels, -1.0});
        }
    }
    if (!notDerivatives.empty()) {
        explanation.conventions.push_back({Kind::NotDerivative, notDerivatives, 1.0});
    }
    return true;
}

/// The order in which findings are applied: what concerns the file as a whole, names, numbers.
int rankOf(Kind kind)
{
    switch (kind) {
    case Kind::Branch: return 0;
    case Kind::TimeUnit: return 1;
    case Kind::TimeShift: return 2;
    case Kind::SwappedColumns: return 3;
    case Kind::AngleUnit: return 4;
    case Kind::LengthUnit: return 5;
    case Kind::Sign: return 6;
    case Kind::HalfTurn: return 7;
    case Kind::WholeTurns: return 8;
    case Kind::NotDerivative: return 9;
    }
    return 10;
}

ChannelSet channelsOf(const ReferenceData &data)
{
    ChannelSet channels;
    for (const ReferenceSeries &series : data.series) {
        channels.set(indexOf(series.channel));
    }
    return channels;
}

Trajectory motionOf(const Parameters &parameters, std::span<const double> time, const ChannelSet &channels)
{
    SolverSettings settings;
    settings.method = Method::ClosedForm;
    return sample(Mechanism(parameters), time, channels, settings);
}

std::optional<Explanation> explain(const ReferenceData &data, Explanation explanation)
{
    const ReferenceData read = allApplied(explanation.conventions, data);
    const Trajectory model = motionOf(explanation.parameters, read.time, channelsOf(read));
    if (!explainColumns(read, model, explanation)) {
        return std::nullopt;
    }
    std::stable_sort(explanation.conventions.begin(), explanation.conventions.end(),
                     [](const Convention &x, const Convention &y) { return rankOf(x.kind) < rankOf(y.kind); });
    return explanation;
}

/// How much there is to believe: first the number of findings, then of columns that they change.
double costOf(const Explanation &explanation)
{
    constexpr double kOfAColumn = 0.01;
    constexpr double kOfAShift = 1.5;  // any amount of it is possible
    constexpr double kOfALoss = 1.5;   // what is left out can no longer contradict
    constexpr double kOfASign = 1.005; // an angle negated is often one turned
    double cost = 0.0;
    for (const Convention &convention : explanation.conventions) {
        switch (convention.kind) {
        case Kind::TimeShift: cost += kOfAShift; break;
        case Kind::NotDerivative: cost += kOfALoss; break;
        case Kind::Sign: cost += kOfASign; break;
        default: cost += 1.0;
        }
        cost += kOfAColumn * static_cast<double>(convention.channels.size());
    }
    return cost;
}

// ---- what a finding brings -----------------------------------------------------------------------------------------

double peakOf(std::span<const double> values)
{
    double peak = 0.0;
    for (const double value : values) {
        peak = std::isfinite(value) ? std::max(peak, std::abs(value)) : peak;
    }
    return peak;
}

/// Whether two orders of one coordinate stand in the file.
bool hasLowerOrder(const ReferenceData &data, Channel channel)
{
    return hasLowerOrder(data, std::vector<bool>(data.series.size(), true), channel);
}

/// The data read by all these conventions, and the motion that they are then to be.
struct Comparison {
    ReferenceData read;
    Trajectory model;

    Comparison(const ReferenceData &data, const Parameters &parameters, std::span<const Convention> conventions)
        : read(allApplied(conventions, data))
        , model(motionOf(parameters, read.time, channelsOf(read)))
    {
    }

    ChannelComparison of(const ReferenceSeries &series, const Parameters &parameters) const
    {
        return compareChannel(read.time, model[series.channel], series,
                              naturalScale(Mechanism(parameters), series.channel));
    }

    /// The largest error among these channels (none given: all), as part of the motion's peak.
    double largestError(std::span<const Channel> channels) const
    {
        double largest = 0.0;
        for (const ReferenceSeries &series : read.series) {
            const bool meant = channels.empty()
                                   ? isPlotted(series.channel)
                                   : std::find(channels.begin(), channels.end(), series.channel) != channels.end();
            if (!meant) {
                continue;
            }
            const std::vector<double> &motion = model[series.channel];
            double error = 0.0;
            for (std::size_t i = 0; i < motion.size(); ++i) {
                const double difference = std::abs(series.values[i] - motion[i]);
                error = std::isfinite(difference) ? std::max(error, difference) : error;
            }
            largest = error == 0.0 ? largest : std::max(largest, error / peakOf(motion));
        }
        return largest;
    }
};

Branch otherThan(Branch branch)
{
    return branch == Branch::Open ? Branch::Crossed : Branch::Open;
}

/// Each convention with the errors without and with it.
std::vector<ConventionFinding> measured(const ReferenceData &data, const Explanation &explanation)
{
    const std::vector<Convention> &all = explanation.conventions;
    const Comparison with(data, explanation.parameters, all);
    std::vector<ConventionFinding> findings;
    for (std::size_t i = 0; i < all.size(); ++i) {
        std::vector<Convention> others = all;
        others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
        Parameters parameters = explanation.parameters;
        if (all[i].kind == Kind::Branch) {
            parameters.branch = otherThan(parameters.branch);
        }
        const bool global = all[i].kind == Kind::TimeUnit;
        const std::vector<Channel> concerned = global ? std::vector<Channel>() : all[i].channels;
        const Comparison without(data, parameters, others);
        findings.push_back({all[i], 100.0 * without.largestError(concerned), 100.0 * with.largestError(concerned)});
    }
    return findings;
}

/// What must be left of the errors for an explanation to stand.
enum class Demand {
    Agreement,    ///< the position columns agree with the mechanism as far as the file's digits go
    NearlyNothing ///< nothing beyond kNearlyNothing
};

/// The explanation with every column that is no derivative found out, or none where it does not stand.
std::optional<Explanation> proven(const ReferenceData &data, Explanation explanation, Demand demand)
{
    const Comparison comparison(data, explanation.parameters, explanation.conventions);
    std::vector<Channel> notDerivatives;
    for (const ReferenceSeries &series : comparison.read.series) {
        const ChannelComparison column = comparison.of(series, explanation.parameters);
        const double error = column.maxAbs.value_or(kInfinity);
        const bool small = error <= kNearlyNothing * sizeOf(comparison.model[series.channel]) &&
                           column.missingModel <= column.count / 20;
        const bool derivative = hasLowerOrder(comparison.read, series.channel);
        const bool nearRounding = error <= kStepsOfAgreement * column.roundingStep.value_or(0.0);
        const bool agrees =
            column.verdict == Verdict::Agrees || (small && (column.verdict == Verdict::Close || nearRounding));
        if (demand == Demand::Agreement && !derivative ? agrees : small || agrees) {
            continue;
        }
        const bool changed = std::any_of(explanation.conventions.begin(), explanation.conventions.end(),
                                         [&](const Convention &one) { return concerns(one, series.channel); });
        if (!isPlotted(series.channel) && !changed) {
            continue;
        }
        if (!derivative || changed) {
            return std::nullopt;
        }
        notDerivatives.push_back(series.channel);
    }
    if (!notDerivatives.empty()) {
        std::vector<Channel> &channels = add(explanation.conventions, Kind::NotDerivative, 1.0).channels;
        channels.insert(channels.end(), notDerivatives.begin(), notDerivatives.end());
    }
    for (const ConventionFinding &finding : measured(data, explanation)) {
        if (finding.before < kImprovement * finding.after) {
            return std::nullopt;
        }
    }
    return explanation;
}

// ---- against the mechanism at hand ---------------------------------------------------------------------------------

/// Where f is least between the two, if it has one minimum there. Source: J. Kiefer, "Sequential minimax search for a
/// maximum", 1953 (golden section).
template <class Function>
double minimumBetween(double low, double high, Function f)
{
    constexpr int kSteps = 32; // a millionth of the way: no finer can be seen in f
    const double ratio = 1.0 / std::numbers::phi;
    double left = high - ratio * (high - low);
    double right = low + ratio * (high - low);
    double atLeft = f(left);
    double atRight = f(right);
    for (int i = 0; i < kSteps; ++i) {
        if (atLeft <= atRight) {
            high = right;
            right = left;
            atRight = atLeft;
            left = high - ratio * (high - low);
            atLeft = f(left);
        } else {
            low = left;
            left = right;
            atLeft = atRight;
            right = low + ratio * (high - low);
            atRight = f(right);
        }
    }
    return 0.5 * (low + high);
}

/// Root mean square of the errors, as part of that of the model about its mean.
double rmsMisfit(std::span<const double> values, std::span<const double> model)
{
    double count = 0.0;
    double errors = 0.0;
    double sum = 0.0;
    double squares = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (std::isfinite(values[i]) && std::isfinite(model[i])) {
            count += 1.0;
            errors += (values[i] - model[i]) * (values[i] - model[i]);
            sum += model[i];
            squares += model[i] * model[i];
        } else if (std::isfinite(values[i])) {
            return kInfinity;
        }
    }
    const double variation = squares - sum * sum / count;
    return variation > 0.0 ? std::sqrt(errors / variation) : kInfinity;
}

Parameters started(Parameters parameters, double shift)
{
    parameters.theta20 += parameters.omega2 * shift;
    return parameters;
}

/// Shifts of time with which one of the columns at least is the mechanism's motion.
std::vector<double> likelyShifts(const ReferenceData &data, const Parameters &parameters)
{
    ReferenceData few = everySoManyth(data, kScanRows);
    std::erase_if(few.series, [](const ReferenceSeries &series) { return !isPlotted(series.channel); });
    const std::vector<ReferenceSeries> &columns = few.series;
    const ChannelSet channels = channelsOf(few);

    const double period = 2.0 * std::numbers::pi / std::abs(parameters.omega2);
    if (!std::isfinite(period)) {
        return {};
    }
    const auto shiftAt = [period](int phase) { return period * (static_cast<double>(phase) / kPhases - 0.5); };
    std::vector<std::array<double, kPhases>> misfits(columns.size());
    for (int phase = 0; phase < kPhases; ++phase) {
        const Trajectory model = motionOf(started(parameters, shiftAt(phase)), few.time, channels);
        for (std::size_t k = 0; k < columns.size(); ++k) {
            misfits[k][static_cast<std::size_t>(phase)] = rmsMisfit(columns[k].values, model[columns[k].channel]);
        }
    }
    std::vector<double> shifts;
    for (std::size_t k = 0; k < columns.size(); ++k) {
        const Channel channel = columns[k].channel;
        const auto best = static_cast<int>(std::min_element(misfits[k].begin(), misfits[k].end()) - misfits[k].begin());
        const auto misfit = [&](double shift) {
            ChannelSet only;
            only.set(indexOf(channel));
            return rmsMisfit(columns[k].values, motionOf(started(parameters, shift), few.time, only)[channel]);
        };
        const double shift = minimumBetween(shiftAt(best - 1), shiftAt(best + 1), misfit);
        const auto isSame = [&](double other) { return std::abs(shift - other) < period / (100.0 * kPhases); };
        if (misfit(shift) <= kLooselyEqual && std::none_of(shifts.begin(), shifts.end(), isSame)) {
            shifts.push_back(shift);
        }
    }
    return shifts;
}

/// The same explanation with the shift that serves all columns best.
Explanation withBestShift(const ReferenceData &data, Explanation explanation)
{
    const auto shift = std::find_if(explanation.conventions.begin(), explanation.conventions.end(),
                                    [](const Convention &one) { return one.kind == Kind::TimeShift; });
    const Comparison comparison(data, explanation.parameters, explanation.conventions);
    const ChannelSet channels = channelsOf(comparison.read) & plottedChannels();
    const auto misfit = [&](double more) {
        const Trajectory model = motionOf(started(explanation.parameters, more), comparison.read.time, channels);
        double sum = 0.0;
        for (const ReferenceSeries &series : comparison.read.series) {
            if (isPlotted(series.channel)) {
                const double one = rmsMisfit(series.values, model[series.channel]);
                sum += one * one;
            }
        }
        return sum;
    };
    const double near = 2.0 * std::numbers::pi / std::abs(explanation.parameters.omega2) / (100.0 * kPhases);
    shift->amount += minimumBetween(-near, near, misfit);
    return explanation;
}

/// Keeps the cheapest explanation.
void prefer(std::optional<Explanation> &best, std::optional<Explanation> candidate)
{
    if (candidate && (!best || costOf(*candidate) < costOf(*best))) {
        best = std::move(candidate);
    }
}

/// The file as the motion of this very mechanism.
std::optional<Explanation> explainedBy(const ReferenceData &data, const Parameters &parameters,
                                       const std::stop_token &stop)
{
    std::vector<Explanation> assumptions;
    for (const Branch branch : {parameters.branch, otherThan(parameters.branch)}) {
        for (const double timeUnit : {1.0, kTimeUnits[0], kTimeUnits[1]}) {
            Explanation assumption{parameters, {}, timeUnit};
            if (branch != parameters.branch) {
                assumption.parameters.branch = branch;
                assumption.conventions.push_back({Kind::Branch, {}, 1.0});
            }
            if (timeUnit != 1.0) {
                assumption.conventions.push_back({Kind::TimeUnit, {}, timeUnit});
            }
            assumptions.push_back(assumption);
        }
    }

    std::optional<Explanation> best;
    for (const Explanation &assumption : assumptions) {
        if (const auto explanation = explain(data, assumption)) {
            prefer(best, proven(data, *explanation, Demand::Agreement));
        }
    }
    if (best) {
        return best;
    }
    for (const Explanation &assumption : assumptions) {
        if (stop.stop_requested()) {
            return std::nullopt;
        }
        for (const double shift : likelyShifts(allApplied(assumption.conventions, data), assumption.parameters)) {
            Explanation late = assumption;
            late.conventions.push_back({Kind::TimeShift, {}, shift});
            if (const auto explanation = explain(data, late)) {
                prefer(best, proven(data, withBestShift(data, *explanation), Demand::Agreement));
            }
        }
    }
    return best;
}

// ---- against whatever mechanism fits best --------------------------------------------------------------------------

/// The mechanisms that move alike in one column or another: mirrored, turned, the crank reversed.
std::vector<Parameters> imagesOf(const Parameters &p)
{
    const double pi = std::numbers::pi;
    std::vector<Parameters> images;
    for (const Branch branch : {p.branch, otherThan(p.branch)}) {
        images.push_back({p.a, p.b, p.c, p.omega2, p.theta20, branch});
        images.push_back({p.a, p.b, p.c, -p.omega2, pi - p.theta20, branch});
        images.push_back({p.a, p.b, -p.c, -p.omega2, -p.theta20, branch});
        images.push_back({p.a, p.b, -p.c, p.omega2, p.theta20 + pi, branch});
    }
    return images;
}

/// The same mechanism in the sizes that the file's columns of length have: angles alone do not tell it.
std::vector<Parameters> sizesOf(const Parameters &parameters, const ReferenceData &data)
{
    const Trajectory model = motionOf(parameters, data.time, channelsOf(data));
    std::vector<Parameters> sizes{parameters};
    for (const ReferenceSeries &series : data.series) {
        if (isPlotted(series.channel) && !isAngle(series.channel.coordinate)) {
            const double scale = std::abs(1.0 / ColumnPair(model[series.channel], series.values).bestFactor());
            Parameters one = parameters;
            one.a /= scale;
            one.b /= scale;
            one.c /= scale;
            if (!findFault(one)) {
                sizes.push_back(one);
            }
        }
    }
    return sizes;
}

/// The mechanism that a derivative alone was taken for, when its instants count in another unit than itself.
Parameters retimed(Parameters parameters, double timeUnit, Channel witness)
{
    const double size = isAngle(witness.coordinate) ? 1.0 : powerOf(timeUnit, orderOf(witness));
    parameters.a *= size;
    parameters.b *= size;
    parameters.c *= size;
    parameters.omega2 /= timeUnit;
    return parameters;
}

/// One column, read as that channel: if nothing is wrong with it, the mechanism follows from it, and what is wrong
/// with the others from the mechanism.
ReferenceData alone(const ReferenceData &data, std::size_t column, Channel channel, double unit)
{
    ReferenceData one;
    one.time = data.time;
    one.series.push_back(data.series[column]);
    one.series.front().channel = channel;
    multiply(one.series.front(), unit);
    return everySoManyth(one, kWitnessRows);
}

/// Columns that may be trusted one by one: first as they stand, ...
std::vector<ReferenceData> plainWitnesses(const ReferenceData &data)
{
    std::vector<ReferenceData> witnesses;
    for (std::size_t i = 0; i < data.series.size(); ++i) {
        if (isPlotted(data.series[i].channel)) {
            witnesses.push_back(alone(data, i, data.series[i].channel, 1.0));
        }
    }
    return witnesses;
}

/// ... and where that leads nowhere, angles in the other unit and under the other name.
std::vector<ReferenceData> doubtfulWitnesses(const ReferenceData &data)
{
    std::vector<ReferenceData> witnesses;
    for (std::size_t i = 0; i < data.series.size(); ++i) {
        const Channel channel = data.series[i].channel;
        if (!isPlotted(channel)) {
            continue;
        }
        if (isAngle(channel.coordinate)) {
            witnesses.push_back(alone(data, i, channel, kDegreesPerRadian));
            witnesses.push_back(alone(data, i, channel, 1.0 / kDegreesPerRadian));
        }
        if (channel.order == Order::Position) {
            witnesses.push_back(alone(data, i, {channel.coordinate == R4x ? Theta3 : R4x, channel.order}, 1.0));
        }
    }
    return witnesses;
}

/// Whether the motion is about that of the mechanism at hand: then the data are rather about it, too.
bool resembles(const ReferenceData &data, const Explanation &explanation, const Mechanism &atHand)
{
    constexpr double kResemblance = 0.25; // b = 65 for 60 is 0.1
    const Comparison comparison(data, explanation.parameters, explanation.conventions);
    const ChannelSet channels = channelsOf(comparison.read);
    const Trajectory other = motionOf(atHand.parameters(), comparison.read.time, channels);
    for (const Channel channel : kPlottedChannels) {
        if (channels.test(indexOf(channel)) &&
            !(rmsMisfit(other[channel], comparison.model[channel]) <= kResemblance)) {
            return false;
        }
    }
    return true;
}

/// The columns of lowest order, which no derivative can spoil.
ReferenceData withoutDerivatives(const ReferenceData &data)
{
    ReferenceData lowest = data;
    std::erase_if(lowest.series, [&](const ReferenceSeries &series) { return hasLowerOrder(data, series.channel); });
    return lowest;
}

/// The explanation with the mechanism fitted to all that it leaves.
std::optional<Explanation> provenByFit(const ReferenceData &data, Explanation explanation, Demand demand,
                                       const std::stop_token &stop)
{
    const auto fitTo = [&](const ReferenceData &some) {
        const Identification fit = identify(some, Mechanism(explanation.parameters), stop);
        if (fit.status == Identification::Status::Found) {
            explanation.parameters = fit.parameters;
        }
    };
    const ReferenceData read = allApplied(explanation.conventions, data);
    fitTo(read);
    if (const auto whole = proven(data, explanation, demand)) {
        return whole;
    }
    // A derivative that is none, but near enough not to have been seen yet, has spoilt the fit.
    fitTo(withoutDerivatives(read));
    const auto suspicious = proven(data, explanation, demand);
    if (!suspicious || suspicious->conventions.size() == explanation.conventions.size()) {
        return suspicious;
    }
    explanation = *suspicious;
    fitTo(allApplied(explanation.conventions, data));
    return proven(data, explanation, demand);
}

/// Every explanation that a witness leads to, the cheapest first, each set of conventions once.
std::vector<Explanation> explanationsOf(const ReferenceData &data, const std::vector<ReferenceData> &witnesses,
                                        const Mechanism &atHand, const std::stop_token &stop)
{
    struct Priced {
        double cost;
        Explanation explanation;
    };
    std::vector<Priced> priced;
    for (const ReferenceData &witness : witnesses) {
        const Identification fit = identify(witness, atHand, stop);
        if (fit.status != Identification::Status::Found) {
            continue;
        }
        for (const Parameters &image : imagesOf(fit.parameters)) {
            for (const Parameters &sized : fit.onlyRatios ? sizesOf(image, data) : std::vector{image}) {
                for (const double timeUnit : {1.0, kTimeUnits[0], kTimeUnits[1]}) {
                    Explanation assumption{retimed(sized, timeUnit, witness.series.front().channel), {}, timeUnit};
                    if (timeUnit != 1.0) {
                        assumption.conventions.push_back({Kind::TimeUnit, {}, timeUnit});
                    }
                    if (findFault(assumption.parameters)) {
                        continue;
                    }
                    if (const auto explanation = explain(data, assumption)) {
                        constexpr double kOfAStranger = 0.3; // decides among as many findings only
                        const double strange = resembles(data, *explanation, atHand) ? 0.0 : kOfAStranger;
                        priced.push_back({costOf(*explanation) + strange, *explanation});
                    }
                }
            }
        }
    }
    std::stable_sort(priced.begin(), priced.end(), [](const Priced &x, const Priced &y) { return x.cost < y.cost; });
    std::vector<Explanation> explanations;
    for (const Priced &one : priced) {
        const bool known = std::any_of(explanations.begin(), explanations.end(), [&](const Explanation &other) {
            return other.conventions == one.explanation.conventions;
        });
        if (!known) {
            explanations.push_back(one.explanation);
        }
    }
    return explanations;
}

/// The file as the motion of some mechanism.
std::optional<Explanation> explainedByAny(const ReferenceData &data, const Mechanism &atHand,
                                          const std::stop_token &stop)
{
    constexpr std::size_t kMostProofs = 6;
    const Identification whole = identify(data, atHand, stop);
    if (whole.status == Identification::Status::Found) {
        const auto plain = proven(data, {whole.parameters, {}}, Demand::Agreement);
        if (plain && plain->conventions.empty()) {
            return plain;
        }
    }
    std::vector<Explanation> explanations;
    for (const auto &witnesses : {plainWitnesses(data), doubtfulWitnesses(data)}) {
        std::vector<Explanation> more = explanationsOf(data, witnesses, atHand, stop);
        more.resize(std::min(more.size(), kMostProofs));
        for (const Explanation &explanation : more) {
            if (const auto sure = provenByFit(data, explanation, Demand::Agreement, stop)) {
                return sure;
            }
        }
        explanations.insert(explanations.end(), more.begin(), more.end());
    }
    for (const Explanation &explanation : explanations) {
        if (const auto likely = provenByFit(data, explanation, Demand::NearlyNothing, stop)) {
            return likely;
        }
    }
    return std::nullopt;
}

} // namespace

// --------------------------------------------------------------------------------------------------------------------

ReferenceData applied(const Convention &convention, ReferenceData data)
{
    for (ReferenceSeries &series : data.series) {
        if (!concerns(convention, series.channel)) {
            continue;
        }
        switch (convention.kind) {
        case Kind::AngleUnit:
        case Kind::LengthUnit:
        case Kind::Sign: multiply(series, convention.amount); break;
        case Kind::TimeUnit: multiply(series, powerOf(1.0 / convention.amount, orderOf(series.channel))); break;
        case Kind::HalfTurn:
        case Kind::WholeTurns: turn(series, convention.amount); break;
        case Kind::SwappedColumns:
            series.channel = convention.channels[series.channel == convention.channels[0] ? 1 : 0];
            break;
        case Kind::Branch:
        case Kind::TimeShift:
        case Kind::NotDerivative: break;
        }
    }
    switch (convention.kind) {
    case Kind::TimeUnit:
        for (double &instant : data.time) {
            instant *= convention.amount;
        }
        break;
    case Kind::TimeShift:
        for (double &instant : data.time) {
            instant += convention.amount;
        }
        break;
    case Kind::NotDerivative:
        std::erase_if(data.series, [&](const ReferenceSeries &series) { return concerns(convention, series.channel); });
        break;
    case Kind::AngleUnit:
    case Kind::LengthUnit:
    case Kind::Sign:
    case Kind::HalfTurn:
    case Kind::WholeTurns:
    case Kind::SwappedColumns:
    case Kind::Branch: break;
    }
    return data;
}

std::vector<ConventionFinding> findConventions(const ReferenceData &data, const Mechanism &mechanism,
                                               std::stop_token stop)
{
    const ReferenceData rows = decisiveRows(data, stop);
    const auto isOfTheSix = [](const ReferenceSeries &series) { return isPlotted(series.channel); };
    if (stop.stop_requested() || std::none_of(rows.series.begin(), rows.series.end(), isOfTheSix)) {
        return {};
    }
    if (const auto explanation = explainedBy(rows, mechanism.parameters(), stop)) {
        return measured(rows, *explanation);
    }
    const auto explanation = explainedByAny(rows, mechanism, stop);
    return explanation && !stop.stop_requested() ? measured(rows, *explanation) : std::vector<ConventionFinding>();
}

} // namespace slidercrank
