// SPDX-License-Identifier: GPL-3.0-or-later
// Kinds of files with the faults of sensors, filters, loggers and spreadsheets. What may be claimed:
//
//   identified    only if the parameters are accurate within their standard errors. Filtered, interpolated or
//                 integrated values change the parameters by more than the residuals show, so they lead to
//                 `approximate`.
//   approximate   if a mechanism explains every used column to 1 % of its range. It has no standard errors and no
//                 origins.
//   nearest       if the printed mechanism is the fitted one, with its own deviation. It is a miss if the deviation
//                 from the truth is below half a percent.
//
// Wrong readings are excluded and named. Columns that do not belong to the motion are omitted and named.
#include "tests/support/claim_file.h"

#include "core/mechanism/turn.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <numeric>
#include <utility>

namespace slidercrank
{

namespace
{

using Values = std::vector<double>;
using Content = ClaimColumn::Content;

Channels anyColumns(ClaimFile &f)
{
    return f.random.pick({Channels{kX}, Channels{kX, kTheta}, Channels{kCrank, kX}, kSix});
}

/// Samples 1 to 3 turns with 100 to 400 rows. Claimed parameters must be accurate within their standard errors.
void add(ClaimFile &f, const Channels &channels, NumberForm form = {})
{
    f.tolerance = 1e-5;
    f.add(channels, form);
    f.sample(f.random.uniform(1.0, 3.0), f.random.whole(100, 400));
}

double step(const ClaimFile &f)
{
    return f.instants[1] - f.instants[0];
}

// Systematic deviations.

/// Accepts an approximate mechanism. None need be found if the deviations exceed half a percent of the range. `late` is
/// the delay of the values in s.
void expectApproximate(ClaimFile &f, double late = 0.0)
{
    constexpr double kSmall = 0.005;
    f.compute();
    f.mayBeApproximate = true;
    for (ClaimColumn &column : f.columns) {
        column.content = column.content == Content::Foreign ? Content::Foreign : Content::Systematic;
        const double range = 2.0 * f.swing(column.shown);
        for (std::size_t row = 0; row < f.instants.size(); ++row) {
            const auto exact = static_cast<double>(motionAt(*f.truth, f.instants[row] - late)[indexOf(column.shown)]);
            f.mayBeMissed = f.mayBeMissed || std::abs(column.values[row] - exact) > kSmall * range + 4.0 * column.noise;
        }
    }
    if (late != 0.0) {
        f.interpretations = {{*f.truth, {}}, {*f.truth, {}}};
        f.interpretations[1].mechanism.theta20 -= f.truth->omega2 * late;
    }
}

/// Filters every column. The filter's input has additional rows at both ends.
void filter(ClaimFile &f, const std::function<Values(const Values &)> &process, double late = 0.0)
{
    constexpr int kMargin = 300;
    for (ClaimColumn &column : f.columns) {
        Values values;
        for (int i = -kMargin; i < static_cast<int>(f.instants.size()) + kMargin; ++i) {
            values.push_back(f.exactValue(column.shown, f.instants.front() + i * step(f)));
        }
        const Values filtered = process(values);
        column.values.assign(filtered.begin() + kMargin, filtered.end() - kMargin);
    }
    expectApproximate(f, late);
}

Values averaged(const Values &values, int before, int after)
{
    Values result = values;
    for (int i = before; i < static_cast<int>(values.size()) - after; ++i) {
        const auto at = values.begin() + i;
        result[static_cast<std::size_t>(i)] = std::accumulate(at - before, at + after + 1, 0.0) / (before + after + 1);
    }
    return result;
}

Values lowPassed(Values values, double weight)
{
    for (std::size_t i = 1; i < values.size(); ++i) {
        values[i] = values[i - 1] + weight * (values[i] - values[i - 1]);
    }
    return values;
}

/// Applies first-order low-pass filters in series. Their time constant is a small part of a turn.
void addLowPass(ClaimFile &f, int filters, bool isZeroPhase)
{
    add(f, anyColumns(f), digits(f.random.whole(6, 8)));
    const double lag = f.random.logUniform(0.01, 0.15) / std::abs(f.truth->omega2);
    const double weight = 1.0 - std::exp(-step(f) / lag);
    const auto process = [=](Values values) {
        for (int i = 0; i < filters; ++i) {
            values = lowPassed(std::move(values), weight);
            if (isZeroPhase) {
                std::ranges::reverse(values);
                values = lowPassed(std::move(values), weight);
                std::ranges::reverse(values);
            }
        }
        return values;
    };
    filter(f, process, isZeroPhase ? 0.0 : filters * (1.0 - weight) / weight * step(f));
}

/// Interpolates coarse samples by Lagrange polynomials through the nearest points; with one point, repeats the last
/// sample.
void addInterpolated(ClaimFile &f, int points)
{
    add(f, anyColumns(f), digits(f.random.whole(6, 8)));
    const double coarse = f.random.uniform(2.2, 8.0) * step(f);
    for (ClaimColumn &column : f.columns) {
        for (const double t : f.instants) {
            const double first = std::floor((t - f.instants.front()) / coarse) - (points > 2 ? points / 2 - 1 : 0);
            double sum = 0.0;
            for (int i = 0; i < points; ++i) {
                double weight = 1.0;
                for (int j = 0; j < points; ++j) {
                    weight *= i == j ? 1.0 : ((t - f.instants.front()) / coarse - first - j) / (i - j);
                }
                sum += weight * f.exactValue(column.shown, f.instants.front() + (first + i) * coarse);
            }
            column.values.push_back(sum);
        }
    }
    expectApproximate(f, points == 1 ? 0.5 * coarse : 0.0);
}

/// Adds part · swing · shape(row, turns since the start) to the given columns.
void disturb(ClaimFile &f, const Channels &channels, double part,
             const std::function<double(std::size_t, double)> &shape)
{
    f.compute();
    for (const Channel channel : channels) {
        const double size = part * f.swing(channel);
        for (std::size_t row = 0; row < f.instants.size(); ++row) {
            const double turns = (f.instants[row] - f.instants.front()) * std::abs(f.truth->omega2) / kTurn;
            f.at(channel).values[row] += size * shape(row, turns);
        }
    }
    expectApproximate(f);
}

/// Adds the error of an integrator: slow, irregular and growing with time.
void addIntegrated(ClaimFile &f)
{
    add(f, anyColumns(f), digits(9));
    const double part = f.random.logUniform(1e-6, 1e-4);
    for (const ClaimColumn &column : f.columns) {
        std::array<double, 8> numbers{};
        std::ranges::generate(numbers, [&] { return f.random.uniform(0.2, 1.0); });
        disturb(f, {column.named}, part, [&](std::size_t, double turns) {
            double sum = 0.3 * turns;
            for (std::size_t k = 0; k < 4; ++k) {
                sum +=
                    numbers[k] * std::sin(kTurn * (numbers[k + 4] * static_cast<double>(k + 1) * turns + numbers[k]));
            }
            return sum;
        });
    }
}

void addDriftingZero(ClaimFile &f)
{
    add(f, f.random.pick({Channels{kX}, Channels{kX, kTheta}, kSix}), digits(7));
    const double turns = (f.instants.back() - f.instants.front()) * std::abs(f.truth->omega2) / kTurn;
    disturb(f, {kX}, f.random.logUniform(1e-3, 2e-2), [=](std::size_t, double at) { return at / turns; });
}

void addHum(ClaimFile &f)
{
    add(f, f.random.pick({Channels{kX}, Channels{kX, kTheta}}), digits(7));
    const double times = f.random.uniform(6.3, 20.0);
    disturb(f, {kX}, f.random.logUniform(1e-3, 5e-3),
            [=](std::size_t, double at) { return std::sin(kTurn * times * at); });
}

void addBacklash(ClaimFile &f)
{
    add(f, f.random.pick({Channels{kX, kTheta}, Channels{kCrank, kX}}), digits(7));
    disturb(f, {kX}, f.random.logUniform(1e-3, 8e-3),
            [&](std::size_t row, double) { return std::copysign(0.5, f.exactValue(kV, f.instants[row])); });
}

/// Adds noise that grows with the reading.
void addProportionalNoise(ClaimFile &f)
{
    add(f, f.random.pick({Channels{kX}, Channels{kX, kTheta}}), digits(7));
    const double part = f.random.logUniform(1e-3, 1e-2);
    const Channels channels = f.columns.size() == 1 ? Channels{kX} : Channels{kX, kTheta};
    disturb(f, channels, part, [&](std::size_t row, double) {
        return f.random.normal() * (0.2 + std::abs(f.exactValue(kX, f.instants[row])) / characteristicLength(*f.truth));
    });
}

/// Writes the positions of a mechanism that changes slightly as it turns: an elastic coupler, a bearing with play, an
/// uneven crank.
void addImperfect(ClaimFile &f, const std::function<void(Parameters &, double theta2)> &change)
{
    f.motion = [truth = *f.truth, change](double t) {
        Parameters p = truth;
        p.theta20 += p.omega2 * t;
        change(p, p.theta20);
        return poseAt(p, p.theta20, p.omega2);
    };
    add(f, f.random.pick({Channels{kX}, Channels{kX, kTheta}}), digits(7));
    expectApproximate(f);
}

void addElasticCoupler(ClaimFile &f)
{
    const double part = f.random.logUniform(1e-4, 5e-3);
    const double phase = f.random.uniform(0.0, kTurn);
    addImperfect(f, [=](Parameters &p, double theta2) { p.b *= 1.0 + part * std::cos(2.0 * theta2 + phase); });
}

void addEccentricBearing(ClaimFile &f)
{
    const double part = f.random.logUniform(1e-4, 5e-3);
    const double phase = f.random.uniform(0.0, kTurn);
    const int times = f.random.whole(1, 2);
    addImperfect(f, [=](Parameters &p, double theta2) { p.a *= 1.0 + part * std::cos(times * theta2 + phase); });
}

void addSpeedRipple(ClaimFile &f)
{
    const double part = f.random.logUniform(1e-4, 5e-3);
    const double times = f.random.uniform(0.5, 4.0);
    addImperfect(f, [=](Parameters &p, double theta2) { p.theta20 += part * std::sin(times * theta2); });
}

// Mechanisms whose speed is not constant.

/// Writes the motion for the crank angle theta2(angle), where `angle` is that of a crank with constant speed (rad).
void addUneven(ClaimFile &f, const Channels &channels, const std::function<double(double)> &theta2)
{
    add(f, channels);
    f.motion = [p = *f.truth, theta2](double t) {
        constexpr double kSmall = 1e-5;
        const double even = std::abs(p.omega2) * t;
        const double sense = std::copysign(1.0, p.omega2);
        const double speed = (theta2(even + kSmall) - theta2(even - kSmall)) / (2.0 * kSmall);
        return poseAt(p, p.theta20 + sense * theta2(even), p.omega2 * speed);
    };
    if (std::ranges::count(channels, kCrank) > 0) {
        f.crankSpeeds = {f.exactValue(kCrankSpeed, f.instants.front()) / kDegreesPerRadian,
                         f.exactValue(kCrankSpeed, f.instants.back()) / kDegreesPerRadian};
    }
    f.compute();
    f.truth = std::nullopt;
}

/// Joins two recordings; the second one starts at another crank angle.
void addJoinedRuns(ClaimFile &f)
{
    const double jump = f.random.uniform(0.1, 3.0) * f.random.sign();
    const double at = f.random.uniform(2.0, 4.0);
    addUneven(f, f.random.pick({Channels{kX}, Channels{kX, kTheta}}),
              [=](double even) { return even < at ? even : even + jump; });
}

/// Starts the recording before the crank turns, or continues it after the crank has stopped.
void addStandstill(ClaimFile &f)
{
    const double at = f.random.uniform(1.5, 4.5);
    const bool isAtStart = f.random.chance(0.5);
    addUneven(f, f.random.pick({Channels{kX}, Channels{kX, kTheta}}),
              [=](double even) { return isAtStart ? std::max(even, at) : std::min(even, at); });
}

// Columns that contradict each other.

/// Writes the slider's columns of one mechanism and the coupler's columns of another.
void addTwoMechanisms(ClaimFile &f)
{
    add(f, f.random.pick({Channels{kX, kTheta}, kSix}));
    Parameters other = *f.truth;
    valueOf(other, f.random.pick({Parameter::A, Parameter::B})) *= 1.0 + f.random.uniform(0.02, 0.2);
    other.b = std::max(other.b, 1.01 * (other.a + std::abs(other.c)));
    for (ClaimColumn &column : f.columns) {
        for (const double t : f.instants) {
            column.values.push_back(static_cast<double>(
                motionAt(column.shown.coordinate == Theta3 ? other : *f.truth, t)[indexOf(column.shown)]));
        }
    }
    f.truth = std::nullopt;
}

/// Expects the motion of all columns except the given ones, which must be named as deviating.
void expectForeign(ClaimFile &f, const Channels &channels)
{
    f.setContent(Content::Foreign, channels);
    f.interpretations = {{*f.truth, {{"not-derivative", channels, 0.0, true}}}};
}

/// Replaces one derivative by that of another mechanism, which differs by at least 0.7 % of the peak.
void addForeignDerivative(ClaimFile &f)
{
    add(f, kSix);
    ClaimColumn &column = f.at(f.random.pick({kV, kOmega, kA, kAlpha}));
    Parameters other = *f.truth;
    double deviation = 0.0;
    double peak = 1.0;
    while (deviation < 0.007 * peak) {
        other.b *= 1.02;
        column.values.clear();
        deviation = peak = 0.0;
        for (const double t : f.instants) {
            column.values.push_back(static_cast<double>(motionAt(other, t)[indexOf(column.shown)]));
            peak = std::max(peak, std::abs(column.values.back()));
            deviation = std::max(deviation, std::abs(column.values.back() - f.exactValue(column.shown, t)));
        }
    }
    expectForeign(f, {column.named});
}

void addGainError(ClaimFile &f)
{
    add(f, kSix);
    const Channel channel = f.random.pick({kV, kOmega, kA, kAlpha});
    const double gain = 1.0 + f.random.uniform(0.005, 0.03) * f.random.sign();
    f.compute();
    std::ranges::for_each(f.at(channel).values, [=](double &value) { value *= gain; });
    expectForeign(f, {channel});
}

void addUnconnected(ClaimFile &f)
{
    add(f, kSix);
    const Channel channel = f.random.pick({kV, kOmega, kA, kAlpha});
    f.at(channel).values.assign(f.instants.size(), f.random.chance(0.5) ? 0.0 : f.random.uniform(0.5, 5.0));
    expectForeign(f, {channel});
}

/// Delays the coupler's columns by some rows. The slider's mechanism is true but need not be found.
void addLaggingChannel(ClaimFile &f)
{
    add(f, f.random.pick({Channels{kX, kTheta}, kSix}));
    const double late = f.random.whole(1, 6) * step(f);
    for (ClaimColumn &column : f.columns) {
        for (const double t : f.instants) {
            column.values.push_back(f.exactValue(column.shown, t - (column.shown.coordinate == Theta3 ? late : 0.0)));
        }
        column.content = column.shown.coordinate == Theta3 ? Content::Foreign : Content::Motion;
    }
    f.mayBeMissed = true;
    f.interpretations = {{*f.truth, {}}, {*f.truth, {}}};
    f.interpretations[1].mechanism.theta20 -= f.truth->omega2 * late;
}

// Derivatives by differentiation of the positions in the file.

/// Returns the derivative of the quadratic fitted to 2 · half + 1 rows (Savitzky-Golay); central differences for half
/// = 1.
double differentiated(const Values &values, std::size_t row, int half, Order order, double step)
{
    double squares = 0.0;
    double fourths = 0.0;
    for (int i = -half; i <= half; ++i) {
        squares += i * i;
        fourths += i * i * i * i;
    }
    const double mean = squares / (2 * half + 1);
    double sum = 0.0;
    for (int i = -half; i <= half; ++i) {
        const double weight = order == Order::Velocity
                                  ? i / (squares * step)
                                  : 2.0 * (i * i - mean) / ((fourths - squares * mean) * step * step);
        sum += weight * values[static_cast<std::size_t>(static_cast<int>(row) + i)];
    }
    return sum;
}

/// Writes noisy or rounded positions and their numerical derivatives, which are empty at both ends.
void addDifferentiated(ClaimFile &f, double noise, int half, bool isForward)
{
    add(f, kSix, digits(7));
    for (const Channel position : {kX, kTheta}) {
        f.at(position).noise = noise * f.swing(position);
    }
    f.compute();
    for (ClaimColumn &column : f.columns) {
        if (column.shown.order == Order::Position) {
            continue;
        }
        const Values &positions = f.at({column.shown.coordinate, Order::Position}).values;
        const auto margin = static_cast<std::size_t>(half);
        for (std::size_t row = 0; row < f.instants.size(); ++row) {
            const bool isInside = row >= margin && row + margin < f.instants.size();
            const bool isDifference = isForward && column.shown.order == Order::Velocity;
            column.values[row] = !isInside      ? kNone
                                 : isDifference ? (positions[row + 1] - positions[row]) / step(f)
                                                : differentiated(positions, row, half, column.shown.order, step(f));
        }
        column.content = Content::Foreign;
    }
    if (noise == 0.0) {
        expectForeign(f, {kV, kOmega, kA, kAlpha});
    }
}

// Encoders, converters, decimals.

/// Writes encoder angles. If the encoder truncates, the file does not show that its angles are half a step too small.
void addEncoders(ClaimFile &f)
{
    add(f, {kCrank, kX}, digits(10));
    f.at(kCrank).form.quantum = 360.0 / (1 << f.random.whole(9, 13));
    f.at(kX).form.quantum = 2.0 * f.swing(kX) / (1 << f.random.whole(10, 14));
    f.at(kCrank).form.isTruncated = f.random.chance(0.5);
    f.tolerance = std::max(2e-3, f.at(kCrank).form.isTruncated ? f.at(kCrank).form.quantum / kDegreesPerRadian : 0.0);
}

void addConverter(ClaimFile &f)
{
    add(f, f.random.pick({Channels{kX}, Channels{kX, kTheta}}), digits(10));
    f.at(kX).form.quantum = 2.0 * f.swing(kX) / (1 << f.random.whole(8, 12));
    f.tolerance = 2e-3;
}

void addTruncated(ClaimFile &f)
{
    NumberForm form = decimals(f.random.whole(3, 4));
    form.isTruncated = true;
    add(f, f.random.pick({Channels{kX}, Channels{kX, kTheta}, Channels{kCrank, kX}}), form);
    f.tolerance = 2e-3; // the file does not show that all values are half a step too small
}

// Wrong readings.

/// Replaces at most 3 % of the readings of one column.
void addBadReadings(ClaimFile &f, const std::function<double(std::size_t row, double swing)> &reading)
{
    add(f, f.random.pick({Channels{kX}, Channels{kX, kTheta}, kSix}), digits(7));
    f.setNoise(f.random.chance(0.5) ? 0.0 : f.random.logUniform(1e-4, 3e-3));
    f.compute();
    const int rows = static_cast<int>(f.instants.size());
    const double swing = f.swing(kX);
    for (int count = f.random.whole(1, std::max(1, 3 * rows / 100)); count > 0; --count) {
        const auto row = static_cast<std::size_t>(f.random.whole(1, rows - 2));
        const double wrong = reading(row, swing);
        if (std::abs(wrong - f.at(kX).values[row]) > 0.05 * swing) {
            f.at(kX).values[row] = wrong;
            f.badRows.insert(row);
        }
    }
}

void addSpikes(ClaimFile &f)
{
    addBadReadings(f, [&](std::size_t row, double swing) {
        return f.at(kX).values[row] + swing * f.random.uniform(0.1, 5.0) * f.random.sign();
    });
}

void addSwappedDigits(ClaimFile &f)
{
    addBadReadings(f, [&](std::size_t row, double) {
        std::string text = f.at(kX).form.print(f.at(kX).values[row]);
        const auto at = static_cast<std::size_t>(f.random.whole(0, static_cast<int>(text.size()) - 2));
        if (std::isdigit(text[at]) != 0 && std::isdigit(text[at + 1]) != 0) {
            std::swap(text[at], text[at + 1]);
        }
        return std::strtod(text.c_str(), nullptr);
    });
}

/// Repeats one reading for some rows.
void addFrozen(ClaimFile &f)
{
    add(f, f.random.pick({Channels{kX}, Channels{kX, kTheta}, kSix}), digits(7));
    f.setNoise(f.random.chance(0.5) ? 0.0 : f.random.logUniform(1e-4, 1e-3));
    f.compute();
    const auto rows = static_cast<int>(f.instants.size());
    const auto first = static_cast<std::size_t>(f.random.whole(rows / 10, 8 * rows / 10));
    const auto last = first + static_cast<std::size_t>(f.random.whole(1, rows / 40));
    for (std::size_t row = first + 1; row <= last; ++row) {
        f.at(kX).values[row] = f.at(kX).values[first];
        f.badRows.insert(row);
    }
}

/// Limits the range of a sensor to less than the motion. The saturated rows are bad rows.
void addSaturated(ClaimFile &f)
{
    add(f, f.random.pick({Channels{kX}, Channels{kX, kTheta}, kSix}), digits(7));
    f.setNoise(f.random.chance(0.5) ? 0.0 : 1e-3);
    f.compute();
    f.hasSaturation = true;
    Values &values = f.at(kX).values;
    const auto [least, most] = std::ranges::minmax(values);
    const double low = f.random.chance(0.5) ? least + f.random.uniform(0.03, 0.15) * (most - least) : least;
    const double high = most - f.random.uniform(0.03, 0.15) * (most - least);
    for (std::size_t row = 0; row < values.size(); ++row) {
        if (values[row] < low || values[row] > high) {
            values[row] = std::clamp(values[row], low, high);
            f.badRows.insert(row);
        }
    }
}

// Time.

void addRepeatedRows(ClaimFile &f, int most)
{
    add(f, anyColumns(f));
    for (int count = f.random.whole(1, most); count > 0; --count) {
        f.repeatedRows.push_back(static_cast<std::size_t>(f.random.whole(1, static_cast<int>(f.instants.size()) - 1)));
    }
}

void addJitter(ClaimFile &f)
{
    add(f, f.random.pick({Channels{kX}, Channels{kX, kTheta}}), digits(8));
    const double size = f.random.logUniform(3e-3, 5e-2) * step(f);
    for (const double t : f.instants) {
        const double late = size * f.random.normal();
        for (ClaimColumn &column : f.columns) {
            column.values.push_back(f.exactValue(column.shown, t + late));
        }
    }
    expectApproximate(f);
    f.tolerance = 2e-3; // the time error correlates the columns, which the program assumes to be independent
}

void addMixedSampling(ClaimFile &f)
{
    add(f, anyColumns(f));
    const double coarse = f.random.uniform(2.0, 5.0) * step(f);
    const auto half = static_cast<std::ptrdiff_t>(f.instants.size() / 2);
    f.instants.resize(static_cast<std::size_t>(half));
    for (std::ptrdiff_t i = 0; i < half / 2; ++i) {
        f.instants.push_back(f.instants.back() + coarse);
    }
    f.timeForm = digits(9);
    f.timeStep = f.timeForm.stepAt(f.instants.back());
}

/// Clears a block of cells in each column, as if the data had not been transmitted.
void addLostBlocks(ClaimFile &f)
{
    add(f, anyColumns(f));
    f.compute();
    for (ClaimColumn &column : f.columns) {
        const int first = f.random.whole(0, static_cast<int>(f.instants.size()) / 2);
        std::fill_n(column.values.begin() + first, f.instants.size() / 5, kNone);
    }
}

// Other units and signs, with noise.

void addNoisyMistake(ClaimFile &f, std::string_view finding, const Channels &channels, double factor)
{
    add(f, kSix, digits(8));
    f.setNoise(f.random.logUniform(5e-4, 1e-2));
    for (const Channel channel : channels) {
        f.at(channel).factor = factor;
        f.at(channel).noise *= std::abs(factor);
    }
    f.interpretations = {{*f.truth, {{finding, channels, 1.0 / factor}}}};
}

// Files by crank angle, which do not determine ω2 and θ20.

void addByAngle(ClaimFile &f, ClaimFile::ByAngle byAngle, double turns, double noise = 0.0)
{
    f.tolerance = 1e-5;
    f.byAngle = byAngle;
    f.truth->omega2 = f.given.omega2 = kTurn;
    f.truth->theta20 = f.given.theta20 = 0.0;
    const int degrees = f.random.pick({1, 2, 3, 5});
    for (int angle = 0; angle <= turns * 360.0; angle += degrees) {
        f.instants.push_back(angle / 360.0);
    }
    f.timeForm = digits(9);
    f.add(f.random.pick({Channels{kX}, Channels{kX, kTheta}}), digits(7));
    f.setNoise(noise);
}

void addOffsetAngle(ClaimFile &f)
{
    const double offset = f.random.uniform(2.0, 60.0) * f.random.sign();
    addByAngle(f, {1.0, offset}, 1.0, f.random.chance(0.5) ? 0.0 : f.random.logUniform(1e-4, 1e-3));
    f.interpretations = {{*f.truth, {{"zero-point", {kCrank}, -offset}}}};
}

/// Counts the crank angle clockwise. The positions are also those of the mirror image.
void addReversedAngle(ClaimFile &f)
{
    addByAngle(f, {-1.0}, 1.0);
    Parameters mirrored = *f.truth;
    mirrored.c = -mirrored.c;
    const bool hasTheta = f.columns.size() > 1;
    f.interpretations = {
        {*f.truth, {{"sign", {kCrank}, -1.0}}},
        {mirrored, hasTheta ? std::vector<Finding>{{"sign", {kTheta}, -1.0}} : std::vector<Finding>{}}};
}

void addAngleInRadians(ClaimFile &f)
{
    addByAngle(f, {1.0 / kDegreesPerRadian}, f.random.uniform(1.0, 3.0));
    // The reader may recognize the unit itself.
    f.interpretations = {{*f.truth, {{"angle-unit", {kCrank}, kDegreesPerRadian}}}, {*f.truth, {}}};
}

const ClaimKind kFaultKinds[] = {
    {"moving average",
     [](ClaimFile &f) {
         add(f, anyColumns(f), digits(f.random.whole(6, 8)));
         const int half = f.random.whole(1, 4);
         filter(f, [=](const Values &values) { return averaged(values, half, half); });
     }},
    {"trailing moving average",
     [](ClaimFile &f) {
         add(f, anyColumns(f), digits(f.random.whole(6, 8)));
         const int before = f.random.whole(2, 8);
         filter(
             f, [=](const Values &values) { return averaged(values, before, 0); }, 0.5 * before * step(f));
     }},
    {"moving average of noisy values",
     [](ClaimFile &f) {
         add(f, f.random.pick({Channels{kX}, Channels{kX, kTheta}}), digits(8));
         f.setNoise(f.random.logUniform(1e-3, 5e-3));
         f.compute();
         const int half = f.random.whole(1, 4);
         for (ClaimColumn &column : f.columns) {
             column.values = averaged(column.values, half, half);
         }
         expectApproximate(f);
         f.mayBeMissed = true;
     }},
    {"first-order low-pass", [](ClaimFile &f) { addLowPass(f, 1, false); }},
    {"second-order low-pass", [](ClaimFile &f) { addLowPass(f, 2, false); }},
    {"zero-phase low-pass", [](ClaimFile &f) { addLowPass(f, 1, true); }},
    {"linear interpolation of a coarse run", [](ClaimFile &f) { addInterpolated(f, 2); }},
    {"cubic interpolation of a coarse run", [](ClaimFile &f) { addInterpolated(f, 4); }},
    {"last value of a coarse run", [](ClaimFile &f) { addInterpolated(f, 1); }},
    {"integration errors", addIntegrated},
    {"drifting zero", addDriftingZero},
    {"hum", addHum},
    {"backlash", addBacklash},
    {"noise that grows with the reading", addProportionalNoise},
    {"elastic coupler", addElasticCoupler},
    {"eccentric crank bearing", addEccentricBearing},
    {"speed ripple", addSpeedRipple},
    {"speed ripple, with theta2",
     [](ClaimFile &f) {
         const double part = f.random.uniform(0.05, 0.3);
         const double times = f.random.uniform(0.3, 2.0);
         addUneven(f, {kCrank, kX}, [=](double even) { return even + part / times * std::sin(times * even); });
     }},
    {"joined runs", addJoinedRuns},
    {"standstill", addStandstill},
    {"two mechanisms", addTwoMechanisms},
    {"a derivative of another mechanism", addForeignDerivative},
    {"gain error of a derivative", addGainError},
    {"unconnected derivative", addUnconnected},
    {"lagging channel", addLaggingChannel},
    {"Savitzky-Golay derivatives of noisy positions",
     [](ClaimFile &f) { addDifferentiated(f, f.random.logUniform(5e-4, 5e-3), f.random.whole(3, 7), false); }},
    {"central differences of noisy positions",
     [](ClaimFile &f) { addDifferentiated(f, f.random.logUniform(5e-4, 5e-3), 1, false); }},
    {"Savitzky-Golay derivatives of exact positions",
     [](ClaimFile &f) { addDifferentiated(f, 0.0, f.random.whole(2, 5), false); }},
    {"forward differences of a spreadsheet", [](ClaimFile &f) { addDifferentiated(f, 0.0, 1, true); }},
    {"encoders", addEncoders},
    {"8 to 12 bits of R4_x", addConverter},
    {"truncated decimals", addTruncated},
    {"spikes", addSpikes},
    {"zeros for lost values", [](ClaimFile &f) { addBadReadings(f, [](std::size_t, double) { return 0.0; }); }},
    {"-9999 for lost values", [](ClaimFile &f) { addBadReadings(f, [](std::size_t, double) { return -9999.0; }); }},
    {"swapped digits", addSwappedDigits},
    {"frozen readings", addFrozen},
    {"saturation", addSaturated},
    {"repeated rows of events", [](ClaimFile &f) { addRepeatedRows(f, 4); }},
    {"many repeated rows", [](ClaimFile &f) { addRepeatedRows(f, 60); }},
    {"jitter of the time", addJitter},
    {"mixed sampling", addMixedSampling},
    {"lost blocks", addLostBlocks},
    {"late trigger",
     [](ClaimFile &f) {
         f.tolerance = 1e-5;
         f.add(anyColumns(f));
         f.sample(f.random.uniform(1.0, 3.0), f.random.whole(100, 400), f.random.logUniform(1.0, 1e3));
         f.timeForm = decimals(9);
         f.timeStep = 1e-9;
     }},
    {"noise and angles in radians",
     [](ClaimFile &f) { addNoisyMistake(f, "angle-unit", kCoupler, 1.0 / kDegreesPerRadian); }},
    {"noise and a sign",
     [](ClaimFile &f) {
         addNoisyMistake(f, "sign", {f.random.pick({kV, kA, kOmega})}, -1.0);
     }},
    {"by angle", [](ClaimFile &f) { addByAngle(f, {}, f.random.uniform(1.0, 3.0)); }},
    {"by angle, within a turn",
     [](ClaimFile &f) {
         addByAngle(f, {1.0, 0.0, true}, f.random.uniform(1.0, 3.0));
     }},
    {"by angle, noisy", [](ClaimFile &f) { addByAngle(f, {}, 1.0, f.random.logUniform(5e-4, 5e-3)); }},
    {"by angle from another origin", addOffsetAngle},
    {"by angle, clockwise", addReversedAngle},
    {"by angle in radians", addAngleInRadians},
};

} // namespace

std::span<const ClaimKind> faultKinds()
{
    return kFaultKinds;
}

} // namespace slidercrank
