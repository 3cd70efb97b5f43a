// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/claim_file.h"

#include "core/mechanism/turn.h"
#include "tests/support/printed_motion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace slidercrank
{

namespace
{

std::string printed(const std::string &format, double value)
{
    std::array<char, 400> text{};
    std::snprintf(text.data(), text.size(), format.c_str(), value);
    return text.data();
}

} // namespace

double valueAt(const Parameters &p, Channel channel, long double crankAngle)
{
    return static_cast<double>(textbookValue(p, channel, crankAngle));
}

Values valuesOf(const Parameters &p, Channel channel, const Values &times)
{
    return times.unaryExpr(
        [&](double t) { return valueAt(p, channel, static_cast<long double>(p.omega2) * t + p.theta20); });
}

double ClaimColumn::stepAt(double value) const
{
    const int precision = std::stoi(format.substr(2));
    const int exponent = std::isnormal(value) ? static_cast<int>(std::floor(std::log10(std::abs(value)))) : 0;
    return quantum > 0.0 ? quantum : std::pow(10.0, (format.back() == 'f' ? 0 : exponent + 1) - precision);
}

Values ClaimColumn::stepsAt(const Values &numbers) const
{
    return numbers.unaryExpr([this](double value) { return stepAt(value); });
}

std::string ClaimColumn::print(double value) const
{
    const std::string number = printed(format, value);
    return reprint.empty() ? number : printed(reprint, std::stod(number));
}

ClaimFile::ClaimFile(const std::string &seed)
    : truth(Parameters())
{
    std::seed_seq sequence(seed.begin(), seed.end());
    m_engine.seed(sequence);
    const auto round = [](double length) { return 0.5 * std::round(2.0 * length); };
    Parameters &p = *truth;
    p.a = random(5.0, 100.0);
    p.c = p.a * random(-1.2, 1.2);
    const double ratio = random(1.05, 6.0);
    p.b = (p.a + std::abs(p.c)) * ratio;
    if (random(0.0, 1.0) < 0.5) {
        p.a = std::max(round(p.a), 5.0);
        p.c = round(p.c);
        p.b = round((p.a + std::abs(p.c)) * ratio) + 0.5;
    }
    p.omega2 = std::copysign(random(0.5, 100.0), random(-1.0, 1.0));
    p.theta20 = random(-std::numbers::pi, std::numbers::pi);
    p.branch = random(0.0, 1.0) < 0.25 ? Branch::Crossed : Branch::Open;
}

double ClaimFile::random(double low, double high)
{
    const double part = std::uniform_real_distribution<double>()(m_engine);
    return low > 0.0 && high > 5.0 * low ? low * std::pow(high / low, part) : low + (high - low) * part;
}

Values ClaimFile::normal(Index count)
{
    std::normal_distribution<double> distribution;
    return Values::NullaryExpr(count, [&] { return distribution(m_engine); });
}

void ClaimFile::sample(double turns, double rows, double start)
{
    rows = std::round(rows);
    const bool isRound = random(0.0, 1.0) < 0.5;
    double step = turns * kTurn / std::abs(truth->omega2) / std::max(rows - 1.0, 1.0);
    step = isRound ? std::stod(printed("%.3g", step)) : step;
    times = start + step * Values::LinSpaced(static_cast<Index>(rows), 0.0, rows - 1.0);
    time.format = !time.format.empty() ? time.format : isRound ? "%.12g" : "%.9g";
}

void ClaimFile::compute()
{
    if (times.size() == 0) {
        sample(random(isLong ? 1.0 : 0.6, 3.0), random(isLong ? 100.0 : 60.0, 300.0));
    }
    time.values = time.values.size() == 0 ? times : time.values;
    for (ClaimColumn &column : columns) {
        column.values = column.values.size() == 0 ? exact(column.shown, times) : column.values;
    }
}

void ClaimFile::print()
{
    compute();
    std::vector<const ClaimColumn *> cells;
    std::ranges::transform(columns, std::back_inserter(cells), [](const ClaimColumn &column) { return &column; });
    if (!isByAngle) {
        cells.insert(cells.begin(), &time);
    }
    for (const ClaimColumn *column : cells) {
        text += (text.empty() ? "" : ",") + column->heading;
    }
    for (Index row = 0; row < times.size(); ++row) {
        const auto hasValue = [row](const ClaimColumn &column) { return std::isfinite(column.values[row]); };
        const std::size_t copies =
            !keepsEmptyRows && std::ranges::none_of(columns, hasValue) ? 0 : 1 + repeatedRows.count(row);
        for (std::size_t copy = 0; copy < copies; ++copy) {
            for (const ClaimColumn *column : cells) {
                text += column == cells.front() ? '\n' : ',';
                text += hasValue(*column) ? column->print(column->values[row]) : "";
            }
            ++lineCount;
            if (badRows.contains(row)) {
                badLines.insert(lineCount);
            }
        }
    }
    text += '\n';
}

double ClaimFile::timeStep() const
{
    return isByAngle ? 0.0 : time.stepAt(time.values.maxCoeff()) / time.factor;
}

ClaimColumn *ClaimFile::find(const std::string &heading)
{
    const auto column = std::ranges::find(columns, heading, &ClaimColumn::heading);
    return heading == time.heading ? &time : column == columns.end() ? nullptr : &*column;
}

Values ClaimFile::exact(Channel channel, const Values &at) const
{
    return motion ? Values(at.unaryExpr([&](double t) { return motion(channel, t); })) : valuesOf(*truth, channel, at);
}

double ClaimFile::swing(Channel channel) const
{
    const Values values = exact(channel, times);
    return 0.5 * (values.maxCoeff<Eigen::PropagateNumbers>() - values.minCoeff<Eigen::PropagateNumbers>());
}

} // namespace slidercrank
