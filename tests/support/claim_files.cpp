// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/claim_files.h"

#include "core/mechanism/turn.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <numbers>

namespace slidercrank
{

AllChannels linkageAt(const Parameters &p, long double theta2, long double w, long double alpha)
{
    AllChannels all{};
    const auto at = [&all](Coordinate coordinate, Order order) -> long double & {
        return all[indexOf({coordinate, order})];
    };
    const long double degree = std::acos(-1.0L) / 180.0L;
    const long double a = p.a;
    const long double b = p.b;
    const long double sine = std::sin(theta2);
    const long double cosine = std::cos(theta2);
    const long double h = p.c - a * sine;
    if (std::abs(h) > b) {
        all.fill(std::numeric_limits<long double>::quiet_NaN());
        return all;
    }
    const bool open = p.branch == Branch::Open;
    const long double s = (open ? 1.0L : -1.0L) * std::sqrt((b - h) * (b + h));
    const long double steepness = std::asin(h / b);
    const long double hDot = -a * cosine * w;
    const long double hDDot = a * sine * w * w - a * cosine * alpha;
    const long double w3 = hDot / s;
    const long double sDot = -h * w3;
    const long double alpha3 = (hDDot - sDot * w3) / s;
    const long double sDDot = -hDot * w3 - h * alpha3;

    at(Theta2, Order::Position) = theta2 / degree;
    at(Theta2, Order::Velocity) = w / degree;
    at(Theta2, Order::Acceleration) = alpha / degree;
    at(Theta3, Order::Position) = (open ? steepness : std::acos(-1.0L) - steepness) / degree;
    at(Theta3, Order::Velocity) = w3 / degree;
    at(Theta3, Order::Acceleration) = alpha3 / degree;
    at(R4y, Order::Position) = p.c;
    struct Along {
        Coordinate coordinate;
        long double crank, coupler; ///< parts of a (cos θ2, sin θ2) and of s in it
    };
    for (const auto &[coordinate, crank, coupler] :
         {Along{R2x, 0.5L, 0.0L}, Along{R3x, 1.0L, 0.5L}, Along{R4x, 1.0L, 1.0L}}) {
        at(coordinate, Order::Position) = crank * a * cosine + coupler * s;
        at(coordinate, Order::Velocity) = -crank * a * sine * w + coupler * sDot;
        at(coordinate, Order::Acceleration) = -crank * a * (cosine * w * w + sine * alpha) + coupler * sDDot;
    }
    for (const Coordinate coordinate : {R2y, R3y}) {
        at(coordinate, Order::Position) = 0.5L * (a * sine + (coordinate == R3y ? p.c : 0.0));
        at(coordinate, Order::Velocity) = 0.5L * a * cosine * w;
        at(coordinate, Order::Acceleration) = 0.5L * a * (cosine * alpha - sine * w * w);
    }
    return all;
}

AllChannels motionAt(const Parameters &p, long double t)
{
    return linkageAt(p, p.omega2 * t + static_cast<long double>(p.theta20), p.omega2, 0.0L);
}

namespace
{

int exponentOf(double value)
{
    return value == 0.0 ? 0 : static_cast<int>(std::floor(std::log10(std::abs(value))));
}

std::string printed(double value, const char *format, int precision)
{
    std::array<char, 512> text{};
    std::snprintf(text.data(), text.size(), format, precision, value);
    return text.data();
}

std::string written(double value, const NumberForm &form)
{
    std::string text;
    switch (form.rule) {
    case NumberForm::Rule::Digits: text = printed(value, "%.*g", form.count); break;
    case NumberForm::Rule::Decimals: text = printed(value, "%.*f", form.count); break;
    case NumberForm::Rule::DigitsInDecimals:
        text = printed(std::strtod(printed(value, "%.*e", form.count - 1).c_str(), nullptr), "%.*f", form.count);
        break;
    }
    return form.everyDigit ? printed(std::strtod(text.c_str(), nullptr), "%.*e", 18) : text;
}

/// "kind", a number of the suite and one of the file, into 64 bits that look like no others (FNV-1a, then splitmix64).
std::uint64_t mixed(std::string_view kind, std::uint64_t suiteSeed, int n)
{
    std::uint64_t bits = 0xcbf29ce484222325ULL;
    for (const char c : kind) {
        bits = (bits ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
    }
    bits ^= suiteSeed * 0x9e3779b97f4a7c15ULL + static_cast<std::uint64_t>(n) * 0xd1342543de82ef95ULL;
    bits = (bits ^ (bits >> 30U)) * 0xbf58476d1ce4e5b9ULL;
    bits = (bits ^ (bits >> 27U)) * 0x94d049bb133111ebULL;
    return bits ^ (bits >> 31U);
}

double roundedTo(double value, double step)
{
    return std::round(value / step) * step;
}

} // namespace

double NumberForm::stepAt(double value) const
{
    const double decimals = std::pow(10.0, -count);
    switch (rule) {
    case Rule::Decimals: return decimals;
    case Rule::Digits: return std::pow(10.0, exponentOf(value) - count + 1);
    case Rule::DigitsInDecimals: return std::max(decimals, std::pow(10.0, exponentOf(value) - count + 1));
    }
    return decimals;
}

double Dice::uniform(double from, double to)
{
    return from + (to - from) * std::ldexp(static_cast<double>(m_engine() >> 11U), -53);
}

double Dice::logUniform(double from, double to)
{
    return std::exp(uniform(std::log(from), std::log(to)));
}

int Dice::whole(int from, int to)
{
    return from + static_cast<int>(m_engine() % static_cast<std::uint64_t>(to - from + 1));
}

double Dice::normal()
{
    const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform(0.0, 1.0)));
    return radius * std::cos(kTurn * uniform(0.0, 1.0));
}

Parameters anyMechanism(Dice &dice)
{
    Parameters p;
    p.a = dice.logUniform(5.0, 100.0);
    p.c = p.a * dice.uniform(-1.2, 1.2);
    const double spare = dice.logUniform(1.05, 6.0);
    p.b = (p.a + std::abs(p.c)) * spare;
    if (dice.chance(0.5)) {
        p.a = std::max(roundedTo(p.a, 0.5), 5.0);
        p.c = roundedTo(p.c, 0.5);
        p.b = roundedTo((p.a + std::abs(p.c)) * spare, 0.5) + 0.5;
    }
    p.omega2 = dice.logUniform(0.5, 100.0) * dice.sign();
    p.theta20 = dice.uniform(-std::numbers::pi, std::numbers::pi);
    p.branch = dice.chance(0.25) ? Branch::Crossed : Branch::Open;
    return p;
}

ClaimColumn column(Channel channel, NumberForm form)
{
    ClaimColumn result;
    result.named = channel;
    result.shown = channel;
    result.form = form;
    return result;
}

std::vector<ClaimColumn> plottedColumns(NumberForm form, unsigned mask)
{
    std::vector<ClaimColumn> columns;
    for (std::size_t k = 0; k < kPlottedChannels.size(); ++k) {
        if ((mask >> k & 1U) != 0) {
            columns.push_back(column(kPlottedChannels[k], form));
        }
    }
    return columns;
}

void setInstants(ClaimFile &file, Dice &dice, double turns, int rows, double start)
{
    const double span = turns * kTurn / std::abs(file.truth.value_or(file.atHand).omega2);
    double step = span / std::max(rows - 1, 1);
    const bool round = dice.chance(0.5);
    if (round) {
        step = std::strtod(printed(step, "%.*e", 2).c_str(), nullptr);
    }
    file.instants.clear();
    for (int i = 0; i < rows; ++i) {
        const double instant = start + step * i;
        file.instants.push_back(round ? std::strtod(printed(instant, "%.*g", 12).c_str(), nullptr) : instant);
    }
    file.timeForm = {NumberForm::Rule::Digits, round ? 15 : 9};
    file.timeStep = round ? 0.0 : file.timeForm.stepAt(file.instants.back());
}

void setInstants(ClaimFile &file, Dice &dice)
{
    const double turns = dice.uniform(0.6, 3.0);
    setInstants(file, dice, turns, dice.whole(60, 400));
}

double swingOf(const ClaimFile &file, Channel channel)
{
    long double low = std::numeric_limits<long double>::infinity();
    long double high = -low;
    for (const double t : file.instants) {
        const long double value = motionAt(*file.truth, t)[indexOf(channel)];
        low = std::min(low, value);
        high = std::max(high, value);
    }
    return static_cast<double>(0.5L * (high - low));
}

void finish(ClaimFile &file, Dice &dice, const MotionLaw &motion)
{
    std::vector<AllChannels> all;
    for (const double t : file.instants) {
        all.push_back(motion(t));
    }
    for (ClaimColumn &each : file.columns) {
        if (!each.values.empty()) {
            continue;
        }
        for (const AllChannels &row : all) {
            const auto value = static_cast<double>(row[indexOf(each.shown)]);
            each.values.push_back(value * each.factor + each.zero +
                                  (each.noise > 0.0 ? each.noise * dice.normal() : 0.0));
        }
    }
    if (file.truth && file.readings.empty()) {
        file.readings = {{*file.truth, {}}};
    }

    file.text = "time";
    for (const ClaimColumn &each : file.columns) {
        file.text += ',' + std::string(nameOf(each.named));
    }
    for (std::size_t row = 0; row < file.instants.size(); ++row) {
        const auto hasValue = [row](const ClaimColumn &each) { return std::isfinite(each.values[row]); };
        if (!file.keepsEmptyRows && std::ranges::none_of(file.columns, hasValue)) {
            continue;
        }
        file.text += '\n' + written(file.instants[row] * file.clock, file.timeForm);
        for (const ClaimColumn &each : file.columns) {
            file.text += ',' + (hasValue(each) ? written(each.values[row], each.form) : std::string());
        }
    }
    file.text += '\n';
}

void finish(ClaimFile &file, Dice &dice)
{
    finish(file, dice, [truth = *file.truth](double t) { return motionAt(truth, t); });
}

ClaimFile claimFile(const ClaimKind &kind, std::uint64_t suiteSeed, int n)
{
    Dice dice(mixed(kind.name, suiteSeed, n), n);
    return kind.make(dice);
}

std::vector<ClaimKind> claimKinds()
{
    std::vector<ClaimKind> all;
    for (const std::span<const ClaimKind> some : {plainKinds(), conventionKinds(), hardKinds(), otherMotionKinds()}) {
        all.insert(all.end(), some.begin(), some.end());
    }
    return all;
}

} // namespace slidercrank
