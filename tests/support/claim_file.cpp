// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/claim_file.h"

#include "core/closed_form/textbook_motion.h"
#include "core/mechanism/turn.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>

namespace slidercrank
{

Pose poseAt(const Parameters &p, long double theta2)
{
    constexpr auto kPi = std::numbers::pi_v<long double>;
    Pose pose = Pose::Constant(kNone);
    TextbookMotion<long double> motion;
    if (motion.compute({p.a, p.b, p.c, p.omega2}, theta2, p.branch == Branch::Open ? 1.0 : -1.0, kPi)) {
        for (std::size_t k = 0; k < kChannelCount; ++k) {
            const Channel channel = channelAt(k);
            pose[columnOf(channel)] = motion.valueAt(channel) * (isAngle(channel.coordinate) ? 180.0L / kPi : 1.0L);
        }
    }
    return pose;
}

Poses motionOf(const Parameters &p, const Values &times)
{
    Poses motion(times.size(), kChannelCount);
    for (Index row = 0; row < times.size(); ++row) {
        motion.row(row) = poseAt(p, p.omega2 * static_cast<long double>(times[row]) + p.theta20);
    }
    return motion;
}

namespace
{

std::string format(double value, const char *pattern, int precision)
{
    std::array<char, 512> text{};
    std::snprintf(text.data(), text.size(), pattern, precision, value);
    return text.data();
}

double rounded(double value, int digits)
{
    return std::strtod(format(value, "%.*e", digits - 1).c_str(), nullptr);
}

} // namespace

double NumberForm::stepAt(double value) const
{
    if (quantum > 0.0) {
        return quantum;
    }
    const int exponent = std::isnormal(value) ? static_cast<int>(std::floor(std::log10(std::abs(value)))) : 0;
    return std::max(decimals < 0 ? 0.0 : std::pow(10.0, -decimals), std::pow(10.0, exponent - digits + 1));
}

Values NumberForm::stepsAt(const Values &values) const
{
    return values.unaryExpr([this](double value) { return stepAt(value); });
}

std::string NumberForm::print(double value) const
{
    if (quantum > 0.0 || isTruncated) {
        const double step = stepAt(value);
        value = (isTruncated ? std::floor(value / step) : std::round(value / step)) * step;
    }
    value = rounded(value, digits);
    return isScientific    ? format(value, "%.*e", 18)
           : decimals >= 0 ? format(value, "%.*f", decimals)
                           : format(value, "%.*g", digits);
}

double Random::in(double low, double high)
{
    const double part = std::ldexp(static_cast<double>(m_engine() >> 11U), -53);
    return low > 0.0 && high > 5.0 * low ? low * std::pow(high / low, part) : low + (high - low) * part;
}

int Random::whole(int from, int to)
{
    return from + static_cast<int>(m_engine() % static_cast<std::uint64_t>(to - from + 1));
}

Values Random::normal(Index count)
{
    return Values::NullaryExpr(
        count, [this] { return std::sqrt(-2.0 * std::log(1.0 - in(0.0, 1.0))) * std::cos(in(0.0, kTurn)); });
}

ClaimFile::ClaimFile(std::uint64_t seed, int fileIndex)
    : random(seed)
    , index(fileIndex)
    , truth(Parameters())
{
    const auto round = [](double length) { return 0.5 * std::round(2.0 * length); };
    Parameters &p = *truth;
    p.a = random.in(5.0, 100.0);
    p.c = p.a * random.in(-1.2, 1.2);
    const double ratio = random.in(1.05, 6.0);
    p.b = (p.a + std::abs(p.c)) * ratio;
    if (random.chance(0.5)) {
        p.a = std::max(round(p.a), 5.0);
        p.c = round(p.c);
        p.b = round((p.a + std::abs(p.c)) * ratio) + 0.5;
    }
    p.omega2 = random.in(0.5, 100.0) * random.sign();
    p.theta20 = random.in(-std::numbers::pi, std::numbers::pi);
    p.branch = random.chance(0.25) ? Branch::Crossed : Branch::Open;
}

void ClaimFile::sample(double turnCount, int rowCount, double start)
{
    double step = turnCount * kTurn / std::abs(truth->omega2) / std::max(rowCount - 1, 1);
    const bool isRound = random.chance(0.5);
    step = isRound ? rounded(step, 3) : step;
    instants = start + step * Values::LinSpaced(rowCount, 0.0, rowCount - 1);
    if (isRound) {
        instants = instants.unaryExpr([](double t) { return rounded(t, 12); });
    }
    timeForm.digits = isRound ? 15 : 9;
    timeStep = isRound ? 0.0 : timeForm.stepAt(instants[rowCount - 1]);
}

void ClaimFile::sampleOnce()
{
    if (instants.size() == 0) {
        sample(random.in(isLong ? 1.0 : 0.6, 3.0), random.whole(isLong ? 100 : 60, 400));
    }
}

void ClaimFile::add(const Channels &channels, const NumberForm &form)
{
    for (const Channel channel : channels) {
        columns.push_back({channel, channel, form});
    }
}

ClaimColumn &ClaimFile::at(Channel named)
{
    return *std::ranges::find(columns, named, &ClaimColumn::named);
}

bool ClaimFile::has(Channel named) const
{
    return std::ranges::count(columns, named, &ClaimColumn::named) > 0;
}

Poses ClaimFile::motionAt(const Values &times) const
{
    Poses motion(times.size(), kChannelCount);
    for (Index row = 0; pose && row < times.size(); ++row) {
        motion.row(row) = pose(times[row]);
    }
    return pose ? motion : motionOf(*truth, times);
}

Values ClaimFile::exactValues(Channel channel, const Values &times) const
{
    return motionAt(times).col(columnOf(channel)).cast<double>();
}

double ClaimFile::swing(Channel channel)
{
    sampleOnce();
    const Values values = exactValues(channel);
    return 0.5 * (values.maxCoeff() - values.minCoeff());
}

void ClaimFile::compute()
{
    sampleOnce();
    for (ClaimColumn &column : columns) {
        if (column.values.size() == 0) {
            column.values = exactValues(column.shown) * column.factor + column.origin;
            column.values += column.noise * random.normal(instants.size());
        }
    }
}

void ClaimFile::print()
{
    compute();
    if (truth) {
        interpretations.insert(interpretations.begin(), {*truth, findings});
    }
    text = isByAngle ? "theta2" : "time";
    for (const ClaimColumn &column : columns) {
        text += ',' + std::string(nameOf(column.named));
    }
    std::size_t line = 1;
    lines.assign(static_cast<std::size_t>(instants.size()), 0);
    for (Index row = 0; row < instants.size(); ++row) {
        const auto hasValue = [row](const ClaimColumn &column) { return std::isfinite(column.values[row]); };
        if (!keepsEmptyRows && std::ranges::none_of(columns, hasValue)) {
            continue;
        }
        const double unit = isByAngle ? 360.0 : 1.0; // the crank turns once a second
        const double abscissa = instants[row] * unit * timeFactor + timeOrigin;
        for (std::size_t copies = 1 + repeatedRows.count(row); copies > 0; --copies) {
            text += '\n' + timeForm.print(isWithinTurn ? abscissa - 360.0 * std::floor(abscissa / 360.0) : abscissa);
            for (const ClaimColumn &column : columns) {
                text += ',' + (hasValue(column) ? column.form.print(column.values[row]) : std::string());
            }
            lines[static_cast<std::size_t>(row)] = ++line;
        }
    }
    text += '\n';
}

} // namespace slidercrank
