// SPDX-License-Identifier: GPL-3.0-or-later
// The steps that change the motion or the values of columns, and these changes.
#include "core/mechanism/turn.h"
#include "core/study/exact_motion.h"
#include "tests/support/claim_steps.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>

namespace slidercrank
{

namespace
{

using Content = ClaimColumn::Content;

/// Calls change(column) for those of the channels that the file contains, after computing their values.
template <class Function>
void forEach(ClaimFile &f, const Channels &channels, Content content, const Function &change)
{
    f.compute();
    for (ClaimColumn &column : f.columns) {
        if (std::ranges::count(channels, column.named) > 0) {
            change(column);
            column.content = content;
        }
    }
}

Channels allChannels(const ClaimFile &f)
{
    Channels channels;
    std::ranges::transform(f.columns, std::back_inserter(channels), &ClaimColumn::named);
    return channels;
}

/// Reads channels and the name of a change, and applies it. Returns the channels.
Channels change(ClaimBuilder &f, Content content)
{
    const Channels channels = f.channels();
    const Change rule = kChanges.at(f.word());
    const std::deque<std::string> arguments = f.arguments;
    forEach(f, channels, content, [&](ClaimColumn &column) {
        f.arguments = arguments;
        rule(f, column);
    });
    return channels;
}

/// Adds the interpretation that all values are `late` (s).
void addDelayed(ClaimFile &f, double late)
{
    f.interpretations = {{*f.truth}};
    f.interpretations[0].mechanism.theta20 -= f.truth->omega2 * late;
}

/// Accepts an approximate mechanism. None need be found if the deviations exceed half a percent of the range. `late` is
/// the delay of the values in s.
void expectApproximate(ClaimFile &f, double late)
{
    constexpr double kSmall = 0.005;
    f.compute();
    f.mayBeApproximate = true;
    const Poses exact = motionOf(*f.truth, f.instants - late);
    for (ClaimColumn &column : f.columns) {
        column.content = Content::Systematic;
        const Values deviation = column.values - exact.col(columnOf(column.shown)).cast<double>();
        const double most = 2.0 * kSmall * f.swing(column.shown) + 4.0 * column.noise;
        f.mayBeMissed = f.mayBeMissed || deviation.abs().maxCoeff() > most;
    }
    if (late != 0.0) {
        addDelayed(f, late);
    }
}

/// Replaces each value by the weighted mean of those so many rows earlier. `lags` are consecutive.
void smooth(ClaimFile &f, const Values &lags, Values weights)
{
    weights /= weights.sum();
    const Index rows = f.instants.size();
    const Index count = lags.size();
    const double last = lags[count - 1];
    const Values numbers = Values::LinSpaced(rows + count - 1, -last, static_cast<double>(rows + count) - 2.0 - last);
    forEach(f, allChannels(f), Content::Systematic, [&](ClaimColumn &column) {
        Values values = f.exactValues(column.shown, f.instants[0] + f.timeBetweenRows() * numbers);
        values.segment(static_cast<Index>(last), rows) = column.values;
        column.values.setZero();
        for (Index k = 0; k < count; ++k) {
            column.values += weights[k] * values.segment(count - 1 - k, rows);
        }
    });
    expectApproximate(f, (weights * lags).sum() * f.timeBetweenRows());
}

/// Replaces the motion by one whose positions are a function of time. Its derivatives are computed numerically.
void setPositions(ClaimFile &f, const std::function<Pose(long double)> &positions)
{
    f.sampleOnce();
    f.pose = [=, step = 1e-3L / std::abs(f.truth->omega2)](long double t) {
        Pose pose = positions(t);
        const Pose before = positions(t - step);
        const Pose after = positions(t + step);
        const Pose slope = (after - before) / (2.0L * step);
        const Pose curvature = (after - 2.0L * pose + before) / (step * step);
        pose.tail(2 * kCoordinateCount) << slope.head(kCoordinateCount), curvature.head(kCoordinateCount);
        return pose;
    };
}

/// Changes a mechanism while it moves, and returns the angle that the crank has turned since t = 0 when a crank with
/// constant speed has turned by `even` (rad; without their signs).
using Law = long double (*)(Parameters &p, long double even, double first, double second);

const std::map<std::string, Law> kLaws{
    {"elastic", // coupler
     [](Parameters &p, long double even, double part, double phase) {
         p.b *= 1.0 + part * std::cos(2.0 * static_cast<double>(even) + phase);
         return even;
     }},
    {"eccentric", // bearing of the crank
     [](Parameters &p, long double even, double part, double phase) {
         p.a *= 1.0 + part * std::cos((phase < 3.0 ? 1.0 : 2.0) * static_cast<double>(even) + phase);
         return even;
     }},
    {"ramp", // the speed grows by `part` per turn
     [](Parameters &, long double even, double part, double) { return even * (1.0L + 0.5L * part / kTurn * even); }},
    {"ripple", // the speed swings
     [](Parameters &, long double even, double part, double times) {
         return even + part / times * (1.0L - std::cos(times * even));
     }},
    {"joined", // recordings
     [](Parameters &, long double even, double jump, double place) { return even < place ? even : even + jump; }},
    {"standstill", // before or after the motion
     [](Parameters &, long double even, double side, double place) {
         return side < 0.0 ? std::max<long double>(even, place) : std::min<long double>(even, place);
     }},
};

} // namespace

const std::map<std::string, Step> kMotionSteps{
    // Changes of columns.
    {"change", [](ClaimBuilder &f) { change(f, Content::Motion); }},
    {"unused", [](ClaimBuilder &f) { change(f, Content::Foreign); }}, // the program may use it or not
    {"foreign",                                                       // has to be named
     [](ClaimBuilder &f) {
         f.findings.push_back({Convention::Kind::NotDerivative, change(f, Content::Foreign), 0.0, true});
     }},
    {"distort", // slightly
     [](ClaimBuilder &f) {
         change(f, Content::Systematic);
         f.mayBeApproximate = true;
     }},
    {"approximate", [](ClaimBuilder &f) { expectApproximate(f, 0.0); }},
    {"smooth", // moving average over so many rows before and, times the second number, after
     [](ClaimBuilder &f) {
         f.sampleOnce();
         const int before = f.whole();
         const int after = before * f.whole();
         smooth(f, Values::LinSpaced(before + after + 1, -after, before), Values::Ones(before + after + 1));
     }},
    {"low-pass", // order, or 0 for zero phase; time constant as crank angle (rad)
     [](ClaimBuilder &f) {
         constexpr int kMostRows = 100;
         f.sampleOnce();
         const int order = f.whole();
         const double decay = std::abs(f.truth->omega2) * f.timeBetweenRows() / f.number();
         const int first = order == 0 ? -kMostRows : 0;
         const Values lags = Values::LinSpaced(kMostRows + 1 - first, first, kMostRows);
         smooth(f, lags, (-decay * lags.abs()).exp() * (order == 2 ? Values(lags + 1.0) : Values::Ones(lags.size())));
     }},
    {"interpolate", // by polynomials through so many coarse samples, so many rows apart; 1: repeats the last sample
     [](ClaimBuilder &f) {
         f.sampleOnce();
         const int points = f.whole();
         const double coarse = f.number() * f.timeBetweenRows();
         const Values at = (f.instants - f.instants[0]) / coarse;
         const Values first = at.floor() - (points > 2 ? points / 2 - 1 : 0);
         forEach(f, allChannels(f), Content::Systematic, [&](ClaimColumn &column) {
             column.values.setZero();
             for (int i = 0; i < points; ++i) {
                 Values value = f.exactValues(column.shown, f.instants[0] + (first + i) * coarse);
                 for (int j = 0; j < points; ++j) {
                     value *= i == j ? Values::Ones(at.size()) : Values((at - first - j) / (i - j));
                 }
                 column.values += value;
             }
         });
         expectApproximate(f, points == 1 ? 0.5 * coarse : 0.0);
     }},
    {"jitter", // delays the values of each row by a random part of the time step
     [](ClaimBuilder &f) {
         f.sampleOnce();
         const Values late = f.number() * f.timeBetweenRows() * f.random.normal(f.instants.size());
         forEach(f, allChannels(f), Content::Systematic,
                 [&](ClaimColumn &column) { column.values = f.exactValues(column.shown, f.instants + late); });
     }},
    {"lag", // of columns by so many rows; the mechanism of the others is true but need not be found
     [](ClaimBuilder &f) {
         f.sampleOnce();
         const Channels channels = f.channels();
         const double late = f.whole() * f.timeBetweenRows();
         forEach(f, channels, Content::Foreign,
                 [&](ClaimColumn &column) { column.values = f.exactValues(column.shown, f.instants - late); });
         f.mayBeMissed = true;
         addDelayed(f, late);
     }},
    {"take-from-another", // columns from a mechanism with another a or b
     [](ClaimBuilder &f) {
         const Channels channels = f.channels();
         Parameters p = *f.truth;
         (f.random.chance(0.5) ? p.a : p.b) *= f.number();
         p.b = std::max(p.b, 1.01 * (p.a + std::abs(p.c)));
         forEach(f, channels, Content::Motion, [&](ClaimColumn &column) {
             column.values = motionOf(p, f.instants).col(columnOf(column.shown)).cast<double>();
         });
     }},
    {"lose-cells", // 15 % of them, and a tenth of the rows
     [](ClaimBuilder &f) {
         f.compute();
         for (Index row = 1; row < f.instants.size(); ++row) {
             const double part = f.random.chance(0.1) ? 1.0 : 0.15;
             for (ClaimColumn &column : f.columns) {
                 column.values[row] = f.random.chance(part) ? kNone : column.values[row];
             }
         }
     }},

    // Wrong readings of R4_x.
    {"misread", // at most 3 %: a spike, swapped digits, or a number
     [](ClaimBuilder &f) {
         f.compute();
         const std::string kind = f.word();
         const double swing = f.swing(kX);
         const auto rows = static_cast<int>(f.instants.size());
         for (int count = f.random.whole(1, std::max(1, 3 * rows / 100)); count > 0; --count) {
             const Index row = f.random.whole(1, rows - 2);
             double &value = f.at(kX).values[row];
             std::string text = f.at(kX).form.print(value);
             const auto at = static_cast<std::size_t>(f.random.whole(0, static_cast<int>(text.size()) - 2));
             if (std::isdigit(text[at]) != 0 && std::isdigit(text[at + 1]) != 0) {
                 std::swap(text[at], text[at + 1]);
             }
             const double wrong = kind == "spike" ? value + swing * f.random.in(0.1, 5.0) * f.random.sign()
                                                  : std::stod(kind == "swapped" ? text : kind);
             if (std::abs(wrong - value) > 0.05 * swing) {
                 value = wrong;
                 f.badRows.insert(row);
             }
         }
     }},
    {"freeze", // repeats one reading for some rows
     [](ClaimBuilder &f) {
         f.compute();
         const auto rows = static_cast<int>(f.instants.size());
         const Index first = f.random.whole(rows / 10, 8 * rows / 10);
         for (Index row = first + f.random.whole(1, rows / 40); row > first; --row) {
             f.at(kX).values[row] = f.at(kX).values[first];
             f.badRows.insert(row);
         }
     }},
    {"saturate", // at so much of the range from its ends
     [](ClaimBuilder &f) {
         f.compute();
         f.hasSaturation = true;
         Values &values = f.at(kX).values;
         const double margin = f.number() * (values.maxCoeff() - values.minCoeff());
         const double low = values.minCoeff() + (f.random.chance(0.5) ? margin : 0.0);
         const double high = values.maxCoeff() - margin;
         for (Index row = 0; row < values.size(); ++row) {
             if (values[row] < low || values[row] > high) {
                 values[row] = std::clamp(values[row], low, high);
                 f.badRows.insert(row);
             }
         }
     }},

    // Other motions.
    {"exact", // with many digits, because the textbook's formulas cancel near a toggle; a few rows dominate the fit
     [](ClaimBuilder &f) {
         f.mayBeMissed = true;
         f.pose = [p = *f.truth](long double t) {
             const auto state = exactState<Digits100>(p, static_cast<double>(t));
             Pose pose = Pose::Constant(kNone);
             for (std::size_t k = 0; k < kChannelCount; ++k) {
                 const Channel channel = channelAt(k);
                 const auto value = static_cast<double>(state.values[k]);
                 const bool isZero = std::abs(value) <= kExactZero * naturalSize(p, channel);
                 if (state.status == Status::Solved ||
                     (state.status == Status::Singular && channel.order == Order::Position)) {
                     pose[columnOf(channel)] = isZero ? 0.0 : toFileUnit(channel, value);
                 }
             }
             return pose;
         };
     }},
    {"vary", // by a law with two numbers; if the file contains θ2, that the crank turns unevenly has to be found
     [](ClaimBuilder &f) {
         const Law law = kLaws.at(f.word());
         const double first = f.number();
         setPositions(f, [=, truth = *f.truth, second = f.number()](long double t) {
             Parameters p = truth;
             const long double angle = law(p, std::abs(p.omega2) * t, first, second);
             return poseAt(p, p.theta20 + (p.omega2 < 0.0 ? -angle : angle));
         });
         if (f.has(kCrank)) {
             const Values speeds = f.exactValues({Theta2, Order::Velocity}) / kDegreesPerRadian;
             f.crankSpeeds = {speeds[0], speeds[speeds.size() - 1]};
         }
     }},
    {"yoke", // a Scotch yoke with a damping and a third harmonic
     [](ClaimBuilder &f) {
         const double damping = f.number();
         const double third = f.number();
         const double size = f.random.in(5.0, 100.0);
         const double middle = size * f.random.in(0.0, 6.0);
         const double start = f.random.in(0.0, kTurn);
         setPositions(f, [=, speed = std::abs(f.truth->omega2)](long double t) {
             const long double angle = speed * t + start;
             Pose pose = Pose::Zero();
             pose[columnOf(kCrank)] = angle * kDegreesPerRadian;
             pose[columnOf(kX)] =
                 middle + size * std::exp(-damping * angle) * (std::cos(angle) + third * std::cos(3.0L * angle));
             return pose;
         });
     }},
    {"turn-axes", // by an angle (rad)
     [](ClaimBuilder &f) {
         setPositions(f, [p = *f.truth, angle = f.number()](long double t) {
             Pose pose = poseAt(p, p.omega2 * t + p.theta20);
             const long double x = pose[columnOf(kX)];
             const long double y = pose[columnOf(kY)];
             pose[columnOf(kX)] = x * std::cos(angle) - y * std::sin(angle);
             pose[columnOf(kY)] = x * std::sin(angle) + y * std::cos(angle);
             pose[columnOf(kTheta)] += angle * kDegreesPerRadian;
             return pose;
         });
     }},
    {"no-mechanism", // makes this motion
     [](ClaimBuilder &f) {
         f.compute();
         f.truth = std::nullopt;
     }},
};

const std::map<std::string, Change> kChanges{
    {"keep-every-tenth",
     [](ClaimBuilder &, ClaimColumn &column) {
         for (Index row = 0; row < column.values.size(); ++row) {
             column.values[row] = row % 10 == 0 ? column.values[row] : kNone;
         }
     }},
    {"lose-block",
     [](ClaimBuilder &f, ClaimColumn &column) {
         const Index rows = column.values.size();
         column.values.segment(f.random.whole(0, static_cast<int>(rows) / 2), rows / 5).setConstant(kNone);
     }},
    {"wrap", // to 0 … 360°
     [](ClaimBuilder &, ClaimColumn &column) { column.values -= 360.0 * (column.values / 360.0).floor(); }},
    {"average", // so many rows on either side, in the file only
     [](ClaimBuilder &f, ClaimColumn &column) {
         const Values before = column.values;
         const Index rows = f.whole();
         for (Index row = rows; row + rows < before.size(); ++row) {
             column.values[row] = before.segment(row - rows, 2 * rows + 1).mean();
         }
     }},
    {"hold", [](ClaimBuilder &f, ClaimColumn &column) { column.values.setConstant(f.number()); }},
    {"random",
     [](ClaimBuilder &f, ClaimColumn &column) {
         const std::deque<std::string> arguments = f.arguments;
         for (double &value : column.values) {
             f.arguments = arguments;
             value = f.number();
         }
     }},
    {"amplify", // by a factor or its inverse
     [](ClaimBuilder &f, ClaimColumn &column) { column.values *= std::pow(f.number(), f.random.sign()); }},
    {"delay", // by a part of a turn
     [](ClaimBuilder &f, ClaimColumn &column) {
         column.values = f.exactValues(column.shown, f.instants - f.number() * kTurn / f.truth->omega2);
     }},
    {"tones", // number of oscillations, their amplitude as a part of the swing, their number per turn
     [](ClaimBuilder &f, ClaimColumn &column) {
         const double swing = f.swing(column.shown);
         const int count = f.whole();
         const std::deque<std::string> arguments = f.arguments;
         for (int k = 0; k < count; ++k) {
             f.arguments = arguments;
             const double size = f.number() * swing;
             const Values angles = f.number() * f.truth->omega2 * f.instants + f.random.in(0.0, kTurn);
             column.values += size * angles.sin();
         }
     }},
    {"backlash", // relative to the swing
     [](ClaimBuilder &f, ClaimColumn &column) {
         column.values += f.number() * f.swing(column.shown) * f.exactValues({R4x, Order::Velocity}).sign();
     }},
    {"proportional-noise", // grows with the reading of R4_x
     [](ClaimBuilder &f, ClaimColumn &column) {
         const Values size = 0.2 + f.exactValues(kX).abs() / characteristicLength(*f.truth);
         column.values += f.number() * f.swing(column.shown) * size * f.random.normal(size.size());
     }},
    {"drift", // noise that is correlated over about twenty rows, so that standard errors would be wrong
     [](ClaimBuilder &f, ClaimColumn &column) {
         constexpr double kMemory = 0.95;
         Values drift = f.random.normal(column.values.size());
         for (Index row = 1; row < drift.size(); ++row) {
             drift[row] = kMemory * drift[row - 1] + std::sqrt(1.0 - kMemory * kMemory) * drift[row];
         }
         column.values += f.number() * f.swing(column.shown) * drift;
     }},
    {"longer-coupler", // takes the values of such a mechanism, which differ by at least 0.7 % of the peak
     [](ClaimBuilder &f, ClaimColumn &column) {
         const Values exact = column.values;
         for (Parameters p = *f.truth; (column.values - exact).abs().maxCoeff() < 0.007 * exact.abs().maxCoeff();) {
             p.b *= 1.02;
             column.values = motionOf(p, f.instants).col(columnOf(column.shown)).cast<double>();
         }
     }},
    {"forward-difference", // of the positions in the file, for a velocity; the last one is empty
     [](ClaimBuilder &f, ClaimColumn &column) {
         const Values &positions = f.at({column.shown.coordinate, Order::Position}).values;
         const Index last = positions.size() - 1;
         column.values.head(last) = (positions.tail(last) - positions.head(last)) / f.timeBetweenRows();
         column.values[last] = kNone;
     }},
    {"differentiate", // a quadratic through so many positions in the file on either side (Savitzky-Golay; 1: central
                      // differences); empty at both ends
     [](ClaimBuilder &f, ClaimColumn &column) {
         const Values &positions = f.at({column.shown.coordinate, Order::Position}).values;
         const Index margin = f.whole();
         const auto width = static_cast<double>(margin) * f.timeBetweenRows();
         const Values near = Values::LinSpaced(2 * margin + 1, -width, width);
         Eigen::MatrixX3d powers(near.size(), 3);
         powers << Values::Ones(near.size()), near, near.square();
         const auto fit = powers.householderQr();
         column.values.setConstant(kNone);
         column.noise = 0.0;
         for (Index row = margin; row + margin < positions.size(); ++row) {
             const Eigen::Vector3d quadratic = fit.solve(positions.segment(row - margin, near.size()).matrix());
             column.values[row] = column.shown.order == Order::Velocity ? quadratic[1] : 2.0 * quadratic[2];
         }
     }},
};

} // namespace slidercrank
