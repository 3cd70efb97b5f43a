// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/claim_file.h"

#include "core/mechanism/turn.h"
#include "tests/support/expected_precision.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>

namespace slidercrank
{

Pose poseAt(const Parameters &p, long double theta2, long double w, long double alpha)
{
    Pose pose{};
    const auto set = [&pose](Coordinate coordinate, std::array<long double, 3> values) {
        for (std::size_t order = 0; order < values.size(); ++order) {
            pose[indexOf({coordinate, static_cast<Order>(order)})] = values[order];
        }
    };
    const long double a = p.a;
    const long double b = p.b;
    const long double sine = std::sin(theta2);
    const long double cosine = std::cos(theta2);
    const long double h = p.c - a * sine;
    if (std::abs(h) > b) {
        pose.fill(kNone);
        return pose;
    }
    const long double pi = std::acos(-1.0L);
    const long double degree = pi / 180.0L;
    const bool isOpen = p.branch == Branch::Open;
    const long double s = (isOpen ? 1.0L : -1.0L) * std::sqrt((b - h) * (b + h)); // projection of the coupler on x
    const long double theta3 = isOpen ? std::asin(h / b) : pi - std::asin(h / b);
    const long double hDDot = a * sine * w * w - a * cosine * alpha;
    const long double w3 = -a * cosine * w / s;
    const long double alpha3 = (hDDot + h * w3 * w3) / s;
    const long double sDot = -h * w3;
    const long double sDDot = a * cosine * w * w3 - h * alpha3;

    set(Theta2, {theta2 / degree, w / degree, alpha / degree});
    set(Theta3, {theta3 / degree, w3 / degree, alpha3 / degree});
    set(R4y, {static_cast<long double>(p.c), 0.0L, 0.0L});
    const auto setAlong = [&](Coordinate coordinate, long double crank, long double coupler) {
        set(coordinate, {crank * a * cosine + coupler * s, -crank * a * sine * w + coupler * sDot,
                         -crank * a * (cosine * w * w + sine * alpha) + coupler * sDDot});
    };
    setAlong(R2x, 0.5L, 0.0L);
    setAlong(R3x, 1.0L, 0.5L);
    setAlong(R4x, 1.0L, 1.0L);
    for (const Coordinate coordinate : {R2y, R3y}) {
        set(coordinate, {0.5L * (a * sine + (coordinate == R3y ? p.c : 0.0)), 0.5L * a * cosine * w,
                         0.5L * a * (cosine * alpha - sine * w * w)});
    }
    return pose;
}

Pose motionAt(const Parameters &p, long double t)
{
    return poseAt(p, p.omega2 * t + static_cast<long double>(p.theta20), p.omega2);
}

namespace
{

std::string format(double value, const char *pattern, int precision)
{
    std::array<char, 512> text{};
    std::snprintf(text.data(), text.size(), pattern, precision, value);
    return text.data();
}

double numberIn(const std::string &text)
{
    return std::strtod(text.c_str(), nullptr);
}

double roundTo(double value, double step)
{
    return std::round(value / step) * step;
}

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

} // namespace

double NumberForm::stepAt(double value) const
{
    if (quantum > 0.0) {
        return quantum;
    }
    const double place = std::pow(10.0, -count);
    if (rule == Rule::Decimals) {
        return place;
    }
    const int exponent = value == 0.0 ? 0 : static_cast<int>(std::floor(std::log10(std::abs(value))));
    const double digit = std::pow(10.0, exponent - count + 1);
    return rule == Rule::Digits ? digit : std::max(place, digit);
}

std::string NumberForm::print(double value) const
{
    if (quantum > 0.0 || isTruncated) {
        const double step = stepAt(value);
        value = isTruncated ? std::floor(value / step) * step : roundTo(value, step);
    }
    std::string text;
    switch (rule) {
    case Rule::Digits: text = format(value, "%.*g", count); break;
    case Rule::Decimals: text = format(value, "%.*f", count); break;
    case Rule::DigitsInDecimals: text = format(numberIn(format(value, "%.*e", count - 1)), "%.*f", count); break;
    }
    return everyDigit ? format(numberIn(text), "%.*e", 18) : text;
}

double Random::uniform(double from, double to)
{
    return from + (to - from) * std::ldexp(static_cast<double>(m_engine() >> 11U), -53);
}

double Random::logUniform(double from, double to)
{
    return std::exp(uniform(std::log(from), std::log(to)));
}

int Random::whole(int from, int to)
{
    return from + static_cast<int>(m_engine() % static_cast<std::uint64_t>(to - from + 1));
}

double Random::normal()
{
    const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform(0.0, 1.0)));
    return radius * std::cos(kTurn * uniform(0.0, 1.0));
}

Parameters anyMechanism(Random &random)
{
    Parameters p;
    p.a = random.logUniform(5.0, 100.0);
    p.c = p.a * random.uniform(-1.2, 1.2);
    const double ratio = random.logUniform(1.05, 6.0);
    p.b = (p.a + std::abs(p.c)) * ratio;
    if (random.chance(0.5)) {
        p.a = std::max(roundTo(p.a, 0.5), 5.0);
        p.c = roundTo(p.c, 0.5);
        p.b = roundTo((p.a + std::abs(p.c)) * ratio, 0.5) + 0.5;
    }
    p.omega2 = random.logUniform(0.5, 100.0) * random.sign();
    p.theta20 = random.uniform(-std::numbers::pi, std::numbers::pi);
    p.branch = random.chance(0.25) ? Branch::Crossed : Branch::Open;
    return p;
}

ClaimFile::ClaimFile(std::uint64_t seed, int fileNumber)
    : random(seed)
    , number(fileNumber)
    , truth(anyMechanism(random))
{
}

void ClaimFile::sample(double turns, int rows, double start)
{
    double step = turns * kTurn / std::abs(truth.value_or(given).omega2) / std::max(rows - 1, 1);
    const bool isRound = random.chance(0.5);
    if (isRound) {
        step = numberIn(format(step, "%.*e", 2));
    }
    instants.clear();
    for (int i = 0; i < rows; ++i) {
        const double t = start + step * i;
        instants.push_back(isRound ? numberIn(format(t, "%.*g", 12)) : t);
    }
    timeForm = digits(isRound ? 15 : 9);
    timeStep = isRound ? 0.0 : timeForm.stepAt(instants.back());
}

void ClaimFile::sample()
{
    const double turns = random.uniform(0.6, 3.0);
    sample(turns, random.whole(60, 400));
}

ClaimColumn &ClaimFile::add(Channel channel, NumberForm form)
{
    columns.push_back({channel, channel, form});
    return columns.back();
}

void ClaimFile::add(const Channels &channels, NumberForm form)
{
    for (const Channel channel : channels) {
        add(channel, form);
    }
}

ClaimColumn &ClaimFile::at(Channel named)
{
    return *std::ranges::find(columns, named, &ClaimColumn::named);
}

double ClaimFile::exactValue(Channel channel, double t) const
{
    return static_cast<double>((motion ? motion(t) : motionAt(*truth, t))[indexOf(channel)]);
}

void ClaimFile::setContent(ClaimColumn::Content content, const Channels &channels)
{
    for (const Channel channel : channels) {
        at(channel).content = content;
    }
}

double ClaimFile::swing(Channel channel)
{
    if (instants.empty()) {
        sample();
    }
    std::vector<double> values;
    for (const double t : instants) {
        values.push_back(exactValue(channel, t));
    }
    const auto [low, high] = std::ranges::minmax(values);
    return 0.5 * (high - low);
}

void ClaimFile::setNoise(double part)
{
    for (ClaimColumn &column : columns) {
        column.noise = part * swing(column.shown);
    }
}

void ClaimFile::compute()
{
    if (instants.empty()) {
        sample();
    }
    std::vector<Pose> poses;
    for (const double t : instants) {
        poses.push_back(motion ? motion(t) : motionAt(*truth, t));
    }
    for (ClaimColumn &column : columns) {
        for (std::size_t row = column.values.size(); row < poses.size(); ++row) {
            const double value = static_cast<double>(poses[row][indexOf(column.shown)]) * column.factor + column.origin;
            column.values.push_back(value + (column.noise > 0.0 ? column.noise * random.normal() : 0.0));
        }
    }
}

void ClaimFile::print()
{
    compute();
    if (truth && interpretations.empty()) {
        interpretations = {{*truth, {}}};
    }
    text = byAngle ? "theta2" : "time";
    for (const ClaimColumn &column : columns) {
        text += ',' + std::string(nameOf(column.named));
    }
    std::size_t line = 1;
    lines.assign(instants.size(), 0);
    for (std::size_t row = 0; row < instants.size(); ++row) {
        const auto hasValue = [row](const ClaimColumn &column) { return std::isfinite(column.values[row]); };
        if (!keepsEmptyRows && std::ranges::none_of(columns, hasValue)) {
            continue;
        }
        double abscissa = instants[row] * timeFactor + timeOffset;
        if (byAngle) {
            const double theta2 = truth->omega2 * instants[row] + truth->theta20;
            abscissa = theta2 * kDegreesPerRadian * byAngle->factor + byAngle->origin;
            abscissa = byAngle->isWithinATurn ? abscissa - 360.0 * std::floor(abscissa / 360.0) : abscissa;
        }
        for (auto copies = 1 + std::ranges::count(repeatedRows, row); copies > 0; --copies) {
            text += '\n' + timeForm.print(abscissa);
            for (const ClaimColumn &column : columns) {
                text += ',' + (hasValue(column) ? column.form.print(column.values[row]) : std::string());
            }
            lines[row] = ++line;
        }
    }
    text += '\n';
}

/// Generates the file. Repeats this while the systematic deviation is too small to be visible in the file.
ClaimFile claimFile(const ClaimKind &kind, std::uint64_t suiteSeed, int number)
{
    constexpr std::uint64_t kMostDraws = 20;
    for (std::uint64_t draw = 0;; ++draw) {
        ClaimFile file(seedFor(kind.name, suiteSeed, number) + draw, number);
        kind.make(file);
        file.print();
        if (draw == kMostDraws || areDeviationsVisible(file)) {
            return file;
        }
    }
}

} // namespace slidercrank
