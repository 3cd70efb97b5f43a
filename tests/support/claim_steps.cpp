// SPDX-License-Identifier: GPL-3.0-or-later
// The vocabulary of claim_kinds.txt. A step has up to four numbers x; those that the table omits are 0.
#include "core/mechanism/turn.h"
#include "tests/support/claim_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <map>
#include <sstream>

namespace slidercrank
{

namespace
{

using Content = ClaimColumn::Content;
using Numbers = std::array<double, 4>;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

void enlarge(Parameters &p, double factor)
{
    p.a *= factor;
    p.b *= factor;
    p.c *= factor;
}

/// Multiplies a column. If it is a time or a length, another mechanism makes the file in the stated unit.
void multiply(ClaimFile &f, ClaimColumn &column, const Numbers &x)
{
    column.values *= x[0];
    column.factor *= x[0];
    column.noise *= std::abs(x[0]);
    Parameters p = *f.truth;
    p.omega2 /= &column == &f.time ? x[0] : 1.0;
    enlarge(p, &column == &f.time || isAngle(column.shown.coordinate) ? 1.0 : std::abs(x[0]));
    f.others.push_back(p);
}

/// Measures a column from another origin.
void setOrigin(ClaimFile &, ClaimColumn &column, double origin)
{
    column.values += origin;
    column.hasOrigin = true;
}

/// Adds noise of a size relative to the swing, whose neighbouring values are correlated by x[1], and which grows with
/// the reading by x[2].
void addNoise(ClaimFile &f, ClaimColumn &column, const Numbers &x)
{
    Values noise = f.normal(f.times.size());
    for (Index row = 1; row < noise.size(); ++row) {
        noise[row] = x[1] * noise[row - 1] + std::sqrt(1.0 - x[1] * x[1]) * noise[row];
    }
    column.noise = x[0] * f.swing(column.shown) * std::abs(column.factor);
    column.values += column.noise * noise * (1.0 + x[2] * column.values.abs() / column.values.abs().maxCoeff());
}

/// Replaces a velocity or acceleration by the slope or the curvature of a parabola through x[0] positions on either
/// side (Savitzky-Golay; 1: central differences). Both ends are empty.
void differentiate(ClaimFile &f, ClaimColumn &column, const Numbers &x)
{
    const Values &positions = f.find(std::string(nameOf({column.shown.coordinate, Order::Position})))->values;
    const auto margin = static_cast<Index>(x[0]);
    const Values rows = Values::LinSpaced(2 * margin + 1, -x[0], x[0]);
    const Values squares = rows.square() - rows.square().mean();
    const double step = f.timeBetweenRows();
    const Values weights = column.shown.order == Order::Velocity
                               ? Values(rows / rows.square().sum() / step)
                               : Values(2.0 * squares / squares.square().sum() / step / step);
    column.values.setConstant(kNone);
    column.noise = 0.0;
    for (Index row = margin; row + margin < positions.size(); ++row) {
        column.values[row] = (weights * positions.segment(row - margin, rows.size())).sum();
    }
}

/// A change of one column, whose content is then at least `content`.
struct ColumnStep {
    Content content;
    void (*apply)(ClaimFile &f, ClaimColumn &column, const Numbers &x);
};

const std::map<std::string, ColumnStep> kColumnSteps{
    // Conventions.
    {"reprint", {Content::Motion, [](auto &, auto &column, auto &) { column.reprint = "%.18e"; }}},
    {"multiply", {Content::Motion, multiply}},
    {"add", {Content::Motion, [](auto &f, auto &column, auto &x) { setOrigin(f, column, x[0]); }}},
    {"from-start", {Content::Motion, [](auto &f, auto &column, auto &) { setOrigin(f, column, -column.values[0]); }}},
    {"within-a-turn",
     {Content::Motion, [](auto &, auto &column, auto &) { column.values -= 360.0 * (column.values / 360.0).floor(); }}},

    // Errors of sensors.
    {"noise", {Content::Motion, addNoise}},
    {"uneven-noise", {Content::Systematic, addNoise}},
    {"quantize", // by steps of x[0], to the nearest value or (1) downwards
     {Content::Motion,
      [](auto &, auto &column, auto &x) {
          column.quantum = x[0];
          column.values = x[0] * (column.values / x[0] + (x[1] > 0.0 ? 0.0 : 0.5)).floor();
      }}},
    {"tone", // an oscillation: amplitude relative to the swing, oscillations per turn
     {Content::Systematic,
      [](auto &f, auto &column, auto &x) {
          column.values +=
              x[0] * f.swing(column.shown) * (x[1] * f.truth->omega2 * f.times + f.random(0.0, kTurn)).sin();
      }}},
    {"backlash", // relative to the swing
     {Content::Systematic,
      [](auto &f, auto &column, auto &x) {
          column.values += x[0] * f.swing(column.shown) * f.exact({R4x, Order::Velocity}, f.times).sign();
      }}},
    {"misread", // at most 3 % of the rows: x[0] times the reading plus x[1]
     {Content::Motion,
      [](auto &f, auto &column, auto &x) {
          const auto rows = static_cast<double>(f.times.size());
          for (int count = static_cast<int>(f.random(1.0, 0.03 * rows)); count > 0; --count) {
              const auto row = static_cast<Index>(f.random(1.0, rows - 1.0));
              const double wrong = x[0] * column.values[row] + x[1];
              if (std::abs(wrong - column.values[row]) > 0.05 * f.swing(column.shown)) {
                  column.values[row] = wrong;
                  f.badRows.insert(row);
              }
          }
      }}},
    {"fail", // in so much of the rows, readings that are too small by at most x[1] of the swing
     {Content::Systematic,
      [](auto &f, auto &column, auto &x) {
          for (double &value : column.values) {
              value -= f.random(0.0, 1.0) < x[0] ? f.random(0.0, x[1]) * f.swing(column.shown) : 0.0;
          }
      }}},
    {"freeze", // repeats one reading in at most 2.5 % of the rows
     {Content::Motion,
      [](auto &f, auto &column, auto &) {
          const auto rows = static_cast<double>(f.times.size());
          const auto first = static_cast<Index>(f.random(0.1 * rows, 0.8 * rows));
          for (Index row = first + static_cast<Index>(f.random(1.0, 0.025 * rows)); row > first; --row) {
              column.values[row] = column.values[first];
              f.badRows.insert(row);
          }
      }}},
    {"saturate", // at so much of the range from its upper end
     {Content::Motion,
      [](auto &f, auto &column, auto &x) {
          const double limit = column.values.maxCoeff() - 2.0 * x[0] * f.swing(column.shown);
          f.hasSaturation = true;
          for (Index row = 0; row < f.times.size(); ++row) {
              if (column.values[row] > limit - 1e-6 * f.swing(column.shown)) { // printed like the limit
                  column.values[row] = limit;
                  f.badRows.insert(row);
              }
          }
      }}},
    {"lose", // so much of the cells
     {Content::Motion,
      [](auto &f, auto &column, auto &x) {
          for (Index row = 1; row < f.times.size(); ++row) {
              column.values[row] = f.random(0.0, 1.0) < x[0] ? kNone : column.values[row];
          }
      }}},
    {"lose-block", // a fifth of the rows
     {Content::Motion,
      [](auto &f, auto &column, auto &) {
          const Index rows = f.times.size();
          column.values.segment(rows / 4, rows / 5).setConstant(kNone);
      }}},

    // Filters and clocks.
    {"smooth", // weighted mean over x[0] rows before and x[1] after, whose weights decrease by exp(-x[2]) from row to
               // row
     {Content::Systematic,
      [](auto &f, auto &column, auto &x) {
          const Values lags = Values::LinSpaced(static_cast<Index>(x[0] + x[1]) + 1, -x[1], x[0]);
          const Values weights = (-x[2] * lags.abs()).exp();
          column.values.setZero();
          for (Index k = 0; k < lags.size(); ++k) {
              column.values += weights[k] * f.exact(column.shown, f.times - lags[k] * f.timeBetweenRows());
          }
          column.values /= weights.sum();
          f.delay = (weights * lags).sum() / weights.sum() * f.timeBetweenRows();
      }}},
    {"interpolate", // between samples x[0] rows apart, linearly, or (1) repeats the last sample
     {Content::Systematic,
      [](auto &f, auto &column, auto &x) {
          const double coarse = x[0] * f.timeBetweenRows();
          const Values before = f.times[0] + coarse * ((f.times - f.times[0]) / coarse).floor();
          const Values part = (1.0 - x[1]) * (f.times - before) / coarse;
          column.values = (1.0 - part) * f.exact(column.shown, before) + part * f.exact(column.shown, before + coarse);
      }}},
    {"jitter", // of the clock, relative to the time step
     {Content::Systematic,
      [](auto &f, auto &column, auto &x) {
          column.values = f.exact(column.shown, f.times + x[0] * f.timeBetweenRows() * f.normal(f.times.size()));
      }}},

    // Values that do not belong to the motion.
    {"delay", // by so many rows
     {Content::Foreign, [](auto &f, auto &column,
                           auto &x) { column.values = f.exact(column.shown, f.times - x[0] * f.timeBetweenRows()); }}},
    {"amplify", {Content::Foreign, [](auto &, auto &column, auto &x) { column.values *= x[0]; }}},
    {"longer-coupler", // so many times
     {Content::Foreign,
      [](auto &f, auto &column, auto &x) {
          Parameters p = *f.truth;
          p.b *= x[0];
          column.values = valuesOf(p, column.shown, f.times);
      }}},
    {"differentiate", {Content::Foreign, differentiate}},
    {"random", // between two numbers
     {Content::Foreign,
      [](auto &f, auto &column, auto &x) {
          column.values = column.values.unaryExpr([&](double) { return f.random(x[0], x[1]); });
      }}},
};

/// Replaces the motion by one whose positions are a function of time. Its derivatives are computed numerically.
template <class Positions>
void setPositions(ClaimFile &f, const Positions &positions)
{
    f.motion = [=, step = 1e-3 / std::abs(f.truth->omega2)](Channel channel, double t) {
        const Channel position{channel.coordinate, Order::Position};
        const double before = positions(position, t - step);
        const double after = positions(position, t + step);
        return channel.order == Order::Position   ? positions(position, t)
               : channel.order == Order::Velocity ? (after - before) / (2.0 * step)
                                                  : (after - 2.0 * positions(position, t) + before) / (step * step);
    };
}

/// Lets the crank turn by law(angle) where a crank with constant speed turns by `angle`, both without their signs.
template <class Law>
void turn(ClaimFile &f, const Law &law)
{
    f.isCrankUneven = f.find("theta2") != nullptr;
    setPositions(f, [=, p = *f.truth](Channel channel, double t) {
        return valueAt(p, channel, p.theta20 + std::copysign(1.0, p.omega2) * law(std::abs(p.omega2) * t));
    });
}

using FileStep = void (*)(ClaimFile &f, const Numbers &x);

const std::map<std::string, FileStep> kFileSteps{
    // The mechanism.
    {"lengths",
     [](auto &f, auto &x) {
         f.truth->a = x[0];
         f.truth->b = x[1];
         f.truth->c = x[2];
     }},
    {"enlarge", [](auto &f, auto &x) { enlarge(*f.truth, x[0]); }},
    {"offset", [](auto &f, auto &x) { f.truth->c = f.truth->a * x[0]; }},
    {"coupler", [](auto &f, auto &x) { f.truth->b = f.truth->a * x[0]; }},
    {"margin", // b / (a + |c|) - 1; negative for a rocker
     [](auto &f, auto &x) { f.truth->b = (f.truth->a + std::abs(f.truth->c)) * (1.0 + x[0]); }},
    {"crossed", [](auto &f, auto &) { f.truth->branch = Branch::Crossed; }},
    {"speed", [](auto &f, auto &x) { f.truth->omega2 = x[0]; }},
    {"start", [](auto &f, auto &x) { f.truth->theta20 = x[0]; }},

    // The mechanism that is given to the program.
    {"given", [](auto &f, auto &) { f.given = *f.truth; }},
    {"start-later",
     [](auto &f, auto &x) {
         f.others.push_back(f.given);
         f.truth->theta20 += x[0];
     }},
    {"other-assembly", [](auto &f, auto &) { f.given.branch = oppositeBranch(f.given.branch); }},
    {"spoil-given", // in one parameter
     [](auto &f, auto &) {
         f.wrongGiven = static_cast<Parameter>(f.random(0.0, 5.0));
         valueOf(f.given, *f.wrongGiven) *= f.random(1.02, 1.05);
         if (f.wrongGiven == Parameter::Theta20) {
             f.given.theta20 = f.truth->theta20 + 0.1;
             f.others.push_back(f.given); // with another start of the clock
         }
     }},

    // The rows.
    {"sample", [](auto &f, auto &x) { f.sample(x[0], x[1], x[2]); }}, // turns, rows, first time
    {"slow-down",                                                     // larger time steps in the second half
     [](auto &f, auto &x) {
         f.compute();
         const Index half = f.times.size() / 2;
         const double last = f.times.reverse()[half];
         f.times.tail(half) = last + x[0] * (f.times.tail(half) - last);
         f.time.values.resize(0);
         f.time.format = "%.9g";
         for (ClaimColumn &column : f.columns) {
             column.values.resize(0);
         }
     }},
    {"repeat", // so many rows
     [](auto &f, auto &x) {
         f.compute();
         for (double count = x[0]; count > 0.0; --count) {
             f.repeatedRows.insert(static_cast<Index>(f.random(1.0, static_cast<double>(f.times.size()))));
         }
     }},
    {"keep-empty-rows", [](auto &f, auto &) { f.keepsEmptyRows = true; }},
    {"by-angle", // so many turns in steps of so many degrees
     [](auto &f, auto &x) {
         f.isByAngle = true;
         f.truth->omega2 = f.given.omega2 = kTurn;
         f.truth->theta20 = f.given.theta20 = 0.0;
         const double last = std::floor(360.0 * x[0] / x[1]);
         f.times = x[1] * Values::LinSpaced(static_cast<Index>(last) + 1, 0.0, last) / 360.0;
     }},

    // Other motions.
    {"ramp", // the speed grows by x[0] per turn
     [](auto &f, auto &x) {
         turn(f, [part = x[0]](double angle) { return angle * (1.0 + 0.5 * part / kTurn * angle); });
     }},
    {"ripple", // the speed swings by x[0], x[1] times per turn
     [](auto &f, auto &x) {
         turn(f, [=](double angle) { return angle + x[0] / x[1] * (1.0 - std::cos(x[1] * angle)); });
     }},
    {"jump", // by x[0] at x[1]: two recordings that are joined
     [](auto &f, auto &x) { turn(f, [=](double angle) { return angle < x[1] ? angle : angle + x[0]; }); }},
    {"stop", [](auto &f, auto &x) { turn(f, [=](double angle) { return std::min(angle, x[0]); }); }},
    {"yoke", // a Scotch yoke with a damping and a third harmonic
     [](auto &f, auto &x) {
         setPositions(f, [=, size = f.truth->a, p = *f.truth](Channel channel, double t) {
             const double angle = p.omega2 * t + p.theta20;
             return channel.coordinate == Theta2 ? toFileUnit(channel, angle)
                                                 : 3.0 * size + size * std::exp(-x[0] * std::abs(p.omega2) * t) *
                                                                    (std::cos(angle) + x[1] * std::cos(3.0 * angle));
         });
     }},
    {"no-mechanism", // makes this motion
     [](auto &f, auto &) {
         f.compute();
         f.truth = std::nullopt;
     }},

    // Expectations.
    {"conventions", // number, or smallest and largest number
     [](auto &f, auto &x) {
         f.fewestConventions = static_cast<std::size_t>(x[0]);
         f.mostConventions = static_cast<std::size_t>(std::max(x[0], x[1]));
     }},
    {"tolerance", [](auto &f, auto &x) { f.tolerance = x[0]; }},
    {"may-be-missed", [](auto &f, auto &) { f.mayBeMissed = true; }},
    {"too-few-values", [](auto &f, auto &) { f.hasTooFewValues = true; }},
    {"approximate", // the motion of the mechanism with systematic deviations
     [](auto &f, auto &) {
         f.compute();
         f.mayBeApproximate = true;
         for (ClaimColumn &column : f.columns) {
             column.content = std::max(column.content, Content::Systematic);
         }
     }},
};

std::vector<std::string> split(const std::string &text, char separator)
{
    std::vector<std::string> parts;
    std::istringstream stream(text);
    for (std::string part; std::getline(stream, part, separator);) {
        parts.push_back(part);
    }
    return parts;
}

/// Returns one of the parts of a text at random.
std::string choose(ClaimFile &f, const std::string &text, char separator)
{
    const std::vector<std::string> parts = split(text, separator);
    return parts[static_cast<std::size_t>(f.random(0.0, static_cast<double>(parts.size())))];
}

/// Returns the headings of a list; "slider" and "coupler" are R4_x and theta3 with their derivatives, "six" both, and
/// "all" the columns of the file.
std::vector<std::string> headingsIn(ClaimFile &f, const std::string &list)
{
    std::vector<std::string> headings;
    for (const std::string &name : split(choose(f, list, '|'), ',')) {
        const std::size_t known = headings.size();
        for (const Channel channel : kPlottedChannels) {
            if (name == "six" || name == (channel.coordinate == R4x ? "slider" : "coupler")) {
                headings.emplace_back(nameOf(channel));
            }
        }
        if (name == "all") {
            std::ranges::transform(f.columns, std::back_inserter(headings), &ClaimColumn::heading);
        } else if (headings.size() == known) {
            headings.push_back(name);
        }
    }
    return headings;
}

/// Adds columns, or changes the format of those that the file contains.
void addColumns(ClaimFile &f, const std::vector<std::string> &headings, const std::string &format)
{
    for (const std::string &heading : headings) {
        if (ClaimColumn *column = f.find(heading)) {
            column->format = format;
        } else {
            const std::vector<std::string> names = split(heading, '='); // of the heading and of the values
            f.columns.push_back({names.front(), *channelNamed(names.back()), format});
        }
    }
}

void run(ClaimFile &f, const std::string &step)
{
    std::istringstream stream(step);
    std::vector<std::string> words{std::istream_iterator<std::string>(stream), {}};
    if (words.empty()) {
        return;
    }
    const std::string name = words.front();
    const bool isForColumns = name == "columns" || kColumnSteps.contains(name);
    const std::vector<std::string> headings = isForColumns ? headingsIn(f, words[1]) : std::vector<std::string>();
    if (name == "columns") {
        addColumns(f, headings, words.size() > 2 ? words[2] : "%.6g");
        return;
    }
    Numbers x{};
    for (std::size_t first = isForColumns ? 2 : 1, i = first; i < words.size(); ++i) {
        const std::vector<std::string> bounds = split(choose(f, words[i], '|'), ':');
        x[i - first] = f.random(std::stod(bounds.front()), std::stod(bounds.back()));
    }
    if (!isForColumns) {
        kFileSteps.at(name)(f, x);
        return;
    }
    f.compute();
    for (const std::string &heading : headings) {
        if (ClaimColumn *column = f.find(heading)) {
            kColumnSteps.at(name).apply(f, *column, x);
            column->content = std::max(column->content, kColumnSteps.at(name).content);
        }
    }
}

} // namespace

std::vector<ClaimKind> claimKinds()
{
    std::vector<ClaimKind> kinds;
    std::ifstream stream(SLIDERCRANK_SOURCE_DIR "/tests/support/claim_kinds.txt");
    for (std::string line; std::getline(stream, line);) {
        if (line.starts_with('[')) {
            const std::size_t end = line.rfind(']');
            kinds.push_back({line.substr(1, end - 1), line.find("fault", end) != std::string::npos});
        } else if (!line.empty() && line[0] != '#') {
            kinds.back().lines.push_back(line);
        }
    }
    return kinds;
}

ClaimFile claimFile(const ClaimKind &kind, std::uint64_t seed, int number)
{
    ClaimFile file(kind.name + std::to_string(seed) + '/' + std::to_string(number));
    file.isLong = kind.isFault;
    file.tolerance = kind.isFault ? 1e-5 : 2e-3; // faults: accurate within their standard errors
    for (const std::string &line : kind.lines) {
        for (const std::string &step : split(choose(file, line + ' ', '/'), ';')) {
            run(file, step);
        }
    }
    file.print();
    return file;
}

} // namespace slidercrank
