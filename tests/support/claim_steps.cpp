// SPDX-License-Identifier: GPL-3.0-or-later
// The steps that choose mechanism, sampling, columns, conventions and expectations.
#include "tests/support/claim_steps.h"

#include "core/mechanism/turn.h"
#include "core/study/cases.h"
#include "tests/support/claim_precision.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <sstream>

namespace slidercrank
{

namespace
{

using enum Convention::Kind;

std::vector<std::string> split(const std::string &text, char separator)
{
    std::vector<std::string> parts;
    std::istringstream stream(text);
    for (std::string part; std::getline(stream, part, separator);) {
        parts.push_back(part);
    }
    return parts;
}

/// Measures a column from another origin. A small one need not be found.
void setOrigin(ClaimFile &f, Channel channel, double origin)
{
    const double part = std::abs(origin) / (channel == kY ? f.truth->a : f.swing(channel));
    f.at(channel).origin = origin;
    if (part > 5e-4) {
        f.findings.push_back({ZeroPoint, {channel}, -origin, part < 5e-3});
    }
}

/// Multiplies columns by a factor.
void scale(ClaimFile &f, Convention::Kind kind, const Channels &channels, double factor)
{
    for (const Channel channel : channels) {
        f.at(channel).factor = factor;
        f.at(channel).noise *= std::abs(factor);
    }
    f.findings.push_back({kind, channels, 1.0 / factor});
}

void enlarge(Parameters &p, double factor)
{
    p.a *= factor;
    p.b *= factor;
    p.c *= factor;
}

} // namespace

const std::map<std::string, Step> kSteps{
    // Columns: channels and the format of their numbers.
    {"columns",
     [](ClaimBuilder &f) {
         const Channels channels = f.channels();
         int count = 6;
         char type = 'g';
         std::sscanf(f.word().c_str(), "%%.%d%c", &count, &type);
         f.add(channels, type == 'f' ? NumberForm{17, count} : NumberForm{count});
     }},
    {"decimals", [](ClaimBuilder &f) { f.setForms(&NumberForm::decimals, f.whole()); }},
    {"scientific", [](ClaimBuilder &f) { f.setForms(&NumberForm::isScientific, true); }},
    {"truncated", [](ClaimBuilder &f) { f.setForms(&NumberForm::isTruncated, true); }},
    {"converter", // of so many bits
     [](ClaimBuilder &f) {
         const Channel channel = f.channels().front();
         f.at(channel).form.quantum = 2.0 * f.swing(channel) / (1 << f.whole());
     }},
    {"encoder", // of so many bits; if it truncates, its angles are half a step too small, which the file does not show
     [](ClaimBuilder &f) {
         NumberForm &form = f.at(kCrank).form;
         form.quantum = 360.0 / (1 << f.whole());
         form.isTruncated = f.random.chance(0.5);
         f.tolerance = std::max(2e-3, form.isTruncated ? form.quantum / kDegreesPerRadian : 0.0);
     }},
    {"noise", // relative to the swing of each column
     [](ClaimBuilder &f) {
         const double part = f.number();
         for (ClaimColumn &column : f.columns) {
             column.noise = part * f.swing(column.shown);
         }
     }},
    {"noise-of-crank", [](ClaimBuilder &f) { f.at(kCrank).noise = f.number(); }},

    // Mechanism.
    {"margin", // b / (a + |c|) - 1; negative for a rocker
     [](ClaimBuilder &f) { f.truth->b = (f.truth->a + std::abs(f.truth->c)) * (1.0 + f.number()); }},
    {"offset", [](ClaimBuilder &f) { f.truth->c = f.truth->a * f.number() * f.random.sign(); }}, // |c| / a
    {"coupler", [](ClaimBuilder &f) { f.truth->b = f.truth->a * f.number(); }},                  // b / a
    {"lengths",
     [](ClaimBuilder &f) {
         f.truth->a = f.number();
         f.truth->b = f.number();
         f.truth->c = f.number();
     }},
    {"crossed", [](ClaimBuilder &f) { f.truth->branch = Branch::Crossed; }},
    {"enlarge", [](ClaimBuilder &f) { enlarge(*f.truth, f.number()); }},
    {"speed", [](ClaimBuilder &f) { f.truth->omega2 = f.number() * f.random.sign(); }},
    {"start-degrees", [](ClaimBuilder &f) { f.truth->theta20 = f.whole() / kDegreesPerRadian; }},
    {"start-at-toggle", [](ClaimBuilder &f) { f.truth->theta20 = -std::copysign(kQuarterTurn, f.truth->c); }},
    {"start-between-limits",
     [](ClaimBuilder &f) {
         f.truth->theta20 = std::copysign(kQuarterTurn, f.truth->c) - std::copysign(0.9, f.truth->omega2);
     }},
    {"hard-case", // of the study; some do not move or cannot be assembled
     [](ClaimBuilder &f) {
         const Case &hardCase = hardCases()[static_cast<std::size_t>(f.index) * 11 % hardCases().size()];
         const std::vector<double> times = hardCase.sampling.timeStamps();
         f.truth = hardCase.parameters;
         f.instants = Values::Map(times.data(), static_cast<Index>(times.size()));
         f.timeForm.digits = 17;
     }},

    // Rows.
    {"sample", // turns, rows, first time
     [](ClaimBuilder &f) {
         const double turns = f.number();
         const int rows = f.whole();
         f.sample(turns, rows, f.number());
     }},
    {"time-decimals",
     [](ClaimBuilder &f) {
         f.timeForm = {17, f.whole()};
         f.timeStep = f.timeForm.stepAt(0.0);
     }},
    {"start-late", // at 1e9 s
     [](ClaimBuilder &f) {
         f.sampleOnce();
         f.instants = 1e9 + (f.instants * 1e4).round() / 1e4;
         f.timeForm = {17, 4};
         f.timeStep = 0.0;
     }},
    {"slow-down", // larger time steps in the second half
     [](ClaimBuilder &f) {
         f.sampleOnce();
         const Index half = f.instants.size() / 2;
         const double coarse = f.number() * f.timeBetweenRows();
         f.instants.tail(half) =
             f.instants.reverse()[half] + coarse * Values::LinSpaced(half, 1.0, static_cast<double>(half));
         f.timeForm.digits = 9;
         f.timeStep = f.timeForm.stepAt(f.instants.maxCoeff());
     }},
    {"repeat", // prints so many rows again
     [](ClaimBuilder &f) {
         f.sampleOnce();
         for (int count = f.whole(); count > 0; --count) {
             f.repeatedRows.insert(f.random.whole(1, static_cast<int>(f.instants.size()) - 1));
         }
     }},
    {"keep-empty-rows", [](ClaimBuilder &f) { f.keepsEmptyRows = true; }},
    {"by-angle", // so many turns
     [](ClaimBuilder &f) {
         f.isByAngle = true;
         f.truth->omega2 = f.given.omega2 = kTurn;
         f.truth->theta20 = f.given.theta20 = 0.0;
         const int step = std::array{1, 2, 3, 5}[static_cast<std::size_t>(f.random.whole(0, 3))]; // degrees
         const double last = std::floor(360.0 * f.number() / step);
         f.instants = step * Values::LinSpaced(static_cast<Index>(last) + 1, 0.0, last) / 360.0;
         f.timeForm.digits = 9;
     }},
    {"within-a-turn", [](ClaimBuilder &f) { f.isWithinTurn = true; }},
    {"crank-origin",
     [](ClaimBuilder &f) {
         f.timeOrigin = f.number() * f.random.sign();
         f.findings = {{ZeroPoint, {kCrank}, -f.timeOrigin}};
     }},
    {"crank-in-radians", // the reader may recognize the unit itself
     [](ClaimBuilder &f) {
         f.timeFactor = 1.0 / kDegreesPerRadian;
         f.findings = {{AngleUnit, {kCrank}, kDegreesPerRadian, true}};
     }},
    {"count-clockwise", // the positions are also those of the mirror image
     [](ClaimBuilder &f) {
         f.timeFactor = -1.0;
         f.findings = {{Sign, {kCrank}, -1.0}};
         f.interpretations = {{*f.truth}};
         f.interpretations[0].mechanism.c *= -1.0;
         if (f.has(kTheta)) {
             f.interpretations[0].findings = {{Sign, {kTheta}, -1.0}};
         }
     }},

    // Conventions, which have to be reported.
    {"origin", // angles are never close to half a turn
     [](ClaimBuilder &f) {
         for (const Channel channel : f.channels()) {
             const double size =
                 isAngle(channel.coordinate) ? f.random.in(5.0, 170.0) : f.truth->a * f.random.in(0.2, 9.0);
             setOrigin(f, channel, size * f.random.sign());
         }
     }},
    {"from-start", // measures from the first row
     [](ClaimBuilder &f) {
         f.sampleOnce();
         for (const Channel channel : f.channels()) {
             setOrigin(f, channel, -f.exactValues(channel)[0]);
         }
     }},
    {"turn-coupler", [](ClaimBuilder &f) { setOrigin(f, kTheta, f.number()); }},
    {"radians", [](ClaimBuilder &f) { scale(f, AngleUnit, f.channels(), 1.0 / kDegreesPerRadian); }},
    {"opposite", [](ClaimBuilder &f) { scale(f, Sign, f.channels(), -1.0); }},
    {"length-unit", // so many mm
     [](ClaimBuilder &f) {
         const Channels channels = f.channels();
         scale(f, LengthUnit, channels, 1.0 / f.number());
     }},
    {"one-length-unit", // equally true: the other two columns have another unit, with another mechanism
     [](ClaimBuilder &f) {
         const Channels channels = f.channels();
         const double unit = f.number();
         Channels others{kPlottedChannels[1], kPlottedChannels[3], kPlottedChannels[5]};
         std::erase(others, channels.front());
         f.interpretations = {{*f.truth, f.findings}};
         f.interpretations[0].findings.push_back({LengthUnit, others, 1.0 / unit});
         enlarge(f.interpretations[0].mechanism, 1.0 / unit);
         scale(f, LengthUnit, channels, 1.0 / unit);
     }},
    {"milliseconds",
     [](ClaimBuilder &f) {
         f.timeFactor = 1e3;
         f.findings.push_back({TimeUnit, {}, 1e-3});
     }},
    {"half-turn", // of θ3, at its other end
     [](ClaimBuilder &f) {
         f.at(kTheta).origin = 180.0 * f.random.sign();
         f.findings.push_back({HalfTurn, {kTheta}});
     }},
    {"swap",
     [](ClaimBuilder &f) {
         const int first = f.random.whole(0, 5);
         ClaimColumn &one = f.columns[static_cast<std::size_t>(first)];
         ClaimColumn &other = f.columns[static_cast<std::size_t>(first + f.random.whole(1, 5)) % 6];
         std::swap(one.shown, other.shown);
         f.findings = {{SwappedColumns, {one.named, other.named}}};
     }},
    {"along-y", // after turning the axes
     [](ClaimBuilder &f) {
         f.mayBeMissed = true;
         f.findings = {{Axis}};
         for (ClaimColumn &column : f.columns) {
             column.content = ClaimColumn::Content::Foreign;
         }
     }},

    // Other true interpretations.
    {"or-half-turn", // x → -x and θ → θ + 180° correspond to -c, θ20 + 180° and the other branch
     [](ClaimBuilder &f) {
         f.interpretations = {{mirrorImages(*f.truth)[7], {{HalfTurn, {kTheta}}}}};
     }},
    {"or-opposite-height", // the sign of a small height cannot be found
     [](ClaimBuilder &f) {
         f.interpretations = {{mirrorImages(*f.truth)[2], {{Sign, {kY}, -1.0, std::abs(f.truth->c) < 4.0}}}};
     }},
    {"or-slower",
     [](ClaimBuilder &f) {
         f.interpretations = {{*f.truth}};
         f.interpretations[0].mechanism.omega2 *= 1e-3;
     }},

    // The mechanism that is given to the program.
    {"given", [](ClaimBuilder &f) { f.given = *f.truth; }},
    {"other-assembly",
     [](ClaimBuilder &f) {
         f.given.branch = oppositeBranch(f.given.branch);
         f.findings = {{Convention::Kind::Branch, {}, 0.0, true}};
     }},
    {"late-start", // of the truth, after the given mechanism
     [](ClaimBuilder &f) {
         f.truth->theta20 += f.number();
         f.interpretations = {{f.given, {{TimeShift}}}};
     }},
    {"spoil-given", // in one parameter
     [](ClaimBuilder &f) {
         f.wrongGiven = static_cast<Parameter>(f.random.whole(0, 4));
         valueOf(f.given, *f.wrongGiven) *= f.random.in(1.02, 1.05);
         if (f.wrongGiven == Parameter::Theta20) {
             f.given.theta20 = f.truth->theta20 + 0.1;
             f.interpretations = {{f.given, {{TimeShift}}}}; // the same deviation under another name
         }
     }},
    {"give-another",
     [](ClaimBuilder &f) {
         f.given.a *= std::pow(f.random.in(1.03, 1.3), f.random.sign());
         f.given.b *= f.random.in(1.1, 1.3);
     }},

    // Expectations.
    {"tolerance", [](ClaimBuilder &f) { f.tolerance = f.number(); }},
    {"may-be-missed", [](ClaimBuilder &f) { f.mayBeMissed = true; }},
    {"too-few-values", [](ClaimBuilder &f) { f.hasTooFewValues = true; }},
};

std::string ClaimBuilder::word()
{
    arguments.push_back({});
    const std::string first = arguments.front();
    arguments.pop_front();
    return first;
}

std::string ClaimBuilder::choice()
{
    const std::vector<std::string> choices = split(word(), '|');
    return choices.empty() ? "0"
                           : choices[static_cast<std::size_t>(random.whole(0, static_cast<int>(choices.size()) - 1))];
}

double ClaimBuilder::number()
{
    const std::vector<std::string> bounds = split(choice(), ':');
    return random.in(std::stod(bounds.front()), std::stod(bounds.back()));
}

int ClaimBuilder::whole()
{
    return static_cast<int>(std::lround(number()));
}

Channels ClaimBuilder::channels()
{
    Channels channels;
    for (const std::string &name : split(choice(), ',')) {
        if (const auto channel = channelNamed(name)) {
            channels.push_back(*channel);
        }
        std::ranges::copy_if(kPlottedChannels, std::back_inserter(channels), [&](Channel channel) {
            return name == "six" || name == (channel.coordinate == R4x ? "slider" : "coupler");
        });
    }
    return channels;
}

namespace
{

/// Hashes the name of a kind, the seed of the suite and the number of the file to 64 bits (FNV-1a, then splitmix64).
std::uint64_t seedFor(std::string_view kind, std::uint64_t suiteSeed, int number)
{
    std::uint64_t bits = 0xcbf29ce484222325ULL;
    for (const char c : kind) {
        bits = (bits ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
    }
    bits ^= suiteSeed * 0x9e3779b97f4a7c15ULL + static_cast<std::uint64_t>(number) * 0xd1342543de82ef95ULL;
    bits = (bits ^ (bits >> 30U)) * 0xbf58476d1ce4e5b9ULL;
    bits = (bits ^ (bits >> 27U)) * 0x94d049bb133111ebULL;
    return bits ^ (bits >> 31U);
}

/// Runs one of the alternatives of a line of steps.
void run(const std::string &line, ClaimBuilder &f)
{
    const std::vector<std::string> alternatives = split(line + ' ', '/');
    const auto chosen = static_cast<std::size_t>(f.random.whole(0, static_cast<int>(alternatives.size()) - 1));
    for (const std::string &step : split(alternatives[chosen], ';')) {
        std::istringstream words(step);
        std::string name;
        words >> name;
        f.arguments.assign(std::istream_iterator<std::string>(words), {});
        if (!name.empty()) {
            (kSteps.contains(name) ? kSteps : kMotionSteps).at(name)(f);
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

ClaimFile claimFile(const ClaimKind &kind, std::uint64_t suiteSeed, int number)
{
    constexpr std::uint64_t kMostDraws = 20;
    for (std::uint64_t draw = 0;; ++draw) {
        ClaimBuilder file(seedFor(kind.name, suiteSeed, number) + draw, number);
        file.isLong = kind.isFault;
        file.tolerance = kind.isFault ? 1e-5 : 2e-3; // faults: accurate within their standard errors
        for (const std::string &line : kind.lines) {
            run(line, file);
        }
        file.print();
        if (draw == kMostDraws || areDeviationsVisible(file)) {
            return file;
        }
    }
}

} // namespace slidercrank
