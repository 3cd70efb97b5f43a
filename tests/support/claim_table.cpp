// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/claim_table.h"

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

ClaimRandom::ClaimRandom(const std::string &seed)
{
    std::seed_seq sequence(seed.begin(), seed.end());
    m_engine.seed(sequence);
}

double ClaimRandom::between(double low, double high)
{
    return low + (high - low) * std::uniform_real_distribution<double>()(m_engine);
}

double ClaimRandom::onLogScale(double low, double high)
{
    return low * std::pow(high / low, between(0.0, 1.0));
}

Values ClaimRandom::normal(Index count)
{
    std::normal_distribution<double> distribution;
    return Values::NullaryExpr(count, [&] { return distribution(m_engine); });
}

Parameters ClaimRandom::mechanism()
{
    const auto round = [](double length) { return 0.5 * std::round(2.0 * length); };
    Parameters p;
    p.a = onLogScale(5.0, 100.0);
    p.c = p.a * between(-1.2, 1.2);
    const double ratio = onLogScale(1.05, 6.0);
    p.b = (p.a + std::abs(p.c)) * ratio;
    if (isTrue(0.5)) {
        p.a = std::max(round(p.a), 5.0);
        p.c = round(p.c);
        p.b = round((p.a + std::abs(p.c)) * ratio) + 0.5;
    }
    p.omega2 = oneOf({-1.0, 1.0}) * onLogScale(0.5, 100.0);
    p.theta20 = between(-std::numbers::pi, std::numbers::pi);
    p.branch = isTrue(0.25) ? Branch::Crossed : Branch::Open;
    return p;
}

Parameters withOffset(Parameters p, double ratio)
{
    p.c = p.a * ratio;
    return p;
}

Parameters withCoupler(Parameters p, double ratio)
{
    p.b = p.a * ratio;
    return p;
}

Parameters withMargin(Parameters p, double margin)
{
    p.b = (p.a + std::abs(p.c)) * (1.0 + margin);
    return p;
}

Parameters withSpeed(Parameters p, double omega2)
{
    p.omega2 = omega2;
    return p;
}

Parameters withStart(Parameters p, double theta20)
{
    p.theta20 = theta20;
    return p;
}

Parameters enlarged(Parameters p, double factor)
{
    p.a *= factor;
    p.b *= factor;
    p.c *= factor;
    return p;
}

Parameters crossed(Parameters p)
{
    p.branch = Branch::Crossed;
    return p;
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

ClaimTable::ClaimTable(ClaimRandom &random, const Parameters &mechanism)
    : truth(mechanism)
    , m_random(std::to_string(random.next()))
{
    time.format.clear();
}

ClaimTable &ClaimTable::overTime(double turns, double rows, double start)
{
    rows = std::round(rows);
    const bool isRound = m_random.isTrue(0.5);
    double step = turns * kTurn / std::abs(truth->omega2) / std::max(rows - 1.0, 1.0);
    step = isRound ? std::stod(printed("%.3g", step)) : step;
    const std::string defaultFormat = isRound ? "%.12g" : "%.9g";
    return atTimes(start + step * Values::LinSpaced(static_cast<Index>(rows), 0.0, rows - 1.0),
                   time.format.empty() ? defaultFormat : time.format);
}

ClaimTable &ClaimTable::atTimes(const Values &stamps, const std::string &format)
{
    times = stamps;
    time.format = format;
    return *this;
}

ClaimTable &ClaimTable::overCrankAngle(double step, double turns)
{
    isOverAngle = true;
    truth->omega2 = givenMechanism.omega2 = kTurn;
    truth->theta20 = givenMechanism.theta20 = 0.0;
    const double last = std::floor(360.0 * turns / step);
    times = step * Values::LinSpaced(static_cast<Index>(last) + 1, 0.0, last) / 360.0;
    return with({kTheta2}).digits(9);
}

ClaimTable &ClaimTable::timeDecimals(int count)
{
    time.format = "%." + std::to_string(count) + 'f';
    return *this;
}

ClaimTable &ClaimTable::slowedDown(double factor)
{
    compute();
    const Index half = times.size() / 2;
    const double last = times.reverse()[half];
    times.tail(half) = last + factor * (times.tail(half) - last);
    time.values.resize(0);
    time.format = "%.9g";
    for (ClaimColumn &column : columns) {
        column.values.resize(0);
    }
    return *this;
}

ClaimTable &ClaimTable::withRepeatedRows(int count)
{
    compute();
    for (; count > 0; --count) {
        repeatedRows.insert(1 + m_random.index(times.size() - 1));
    }
    return *this;
}

ClaimTable &ClaimTable::withEmptyRows()
{
    m_keepsEmptyRows = true;
    return *this;
}

ClaimTable &ClaimTable::with(const Channels &channels)
{
    m_firstOfLast = columns.size();
    for (const Channel channel : channels) {
        columns.push_back({std::string(nameOf(channel)), channel});
    }
    return *this;
}

ClaimTable &ClaimTable::with(Channel heading, Channel shown)
{
    with({shown});
    columns.back().heading = nameOf(heading);
    return *this;
}

ClaimTable &ClaimTable::setFormat(const std::string &format)
{
    for (std::size_t k = m_firstOfLast; k < columns.size(); ++k) {
        columns[k].format = format;
    }
    return *this;
}

ClaimTable &ClaimTable::digits(int count)
{
    return setFormat("%." + std::to_string(count) + 'g');
}

ClaimTable &ClaimTable::decimals(int count)
{
    return setFormat("%." + std::to_string(count) + 'f');
}

ClaimTable &ClaimTable::given(const Parameters &parameters)
{
    givenMechanism = parameters;
    return *this;
}

ClaimTable &ClaimTable::orMechanism(const Parameters &parameters)
{
    others.push_back(parameters);
    return *this;
}

ClaimTable &ClaimTable::conventionsBetween(std::size_t fewest, std::size_t most)
{
    minConventions = fewest;
    maxConventions = most;
    return *this;
}

ClaimTable &ClaimTable::accurateTo(double relativeTolerance)
{
    tolerance = relativeTolerance;
    return *this;
}

ClaimTable &ClaimTable::tooFewValues()
{
    hasTooFewValues = true;
    return *this;
}

ClaimTable &ClaimTable::mayBeMissed()
{
    isMissable = true;
    return *this;
}

ClaimTable &ClaimTable::approximate()
{
    isSystematic = true;
    return change(kAllColumns, ClaimColumn::Content::Systematic, [](ClaimColumn &) {});
}

ClaimTable &ClaimTable::contradictory()
{
    return change(kAllColumns, ClaimColumn::Content::Foreign, [](ClaimColumn &) {});
}

ClaimTable &ClaimTable::mayExcludeRows()
{
    hasSteepRows = true;
    return *this;
}

ClaimTable &ClaimTable::noMechanism()
{
    compute();
    truth = std::nullopt;
    return *this;
}

void ClaimTable::compute()
{
    if (times.size() == 0) {
        overTime(m_random.between(0.6, 3.0), m_random.between(60.0, 300.0));
    }
    time.values = time.values.size() == 0 ? times : time.values;
    for (ClaimColumn &column : columns) {
        column.values = column.values.size() == 0 ? exact(column.shown, times) : column.values;
    }
}

void ClaimTable::print()
{
    compute();
    std::vector<const ClaimColumn *> cells;
    std::ranges::transform(columns, std::back_inserter(cells), [](const ClaimColumn &column) { return &column; });
    if (!isOverAngle) {
        cells.insert(cells.begin(), &time);
    }
    for (const ClaimColumn *column : cells) {
        text += (text.empty() ? "" : ",") + column->heading;
    }
    for (Index row = 0; row < times.size(); ++row) {
        const auto hasValue = [row](const ClaimColumn &column) { return std::isfinite(column.values[row]); };
        const std::size_t copies =
            !m_keepsEmptyRows && std::ranges::none_of(columns, hasValue) ? 0 : 1 + repeatedRows.count(row);
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

double ClaimTable::timeStep() const
{
    return isOverAngle ? 0.0 : time.stepAt(time.values.maxCoeff()) / time.factor;
}

ClaimColumn *ClaimTable::find(const std::string &heading)
{
    const auto column = std::ranges::find(columns, heading, &ClaimColumn::heading);
    return column == columns.end() ? nullptr : &*column;
}

Values ClaimTable::exact(Channel channel, const Values &at) const
{
    return m_motion ? Values(at.unaryExpr([&](double t) { return m_motion(channel, t); }))
                    : valuesOf(*truth, channel, at);
}

double ClaimTable::swing(Channel channel) const
{
    const Values values = exact(channel, times);
    return 0.5 * (values.maxCoeff<Eigen::PropagateNumbers>() - values.minCoeff<Eigen::PropagateNumbers>());
}

ClaimTable claimTable(const ClaimKind &kind, std::uint64_t seed, int number)
{
    ClaimRandom random(kind.name + std::to_string(seed) + '/' + std::to_string(number));
    ClaimTable table = kind.make(random);
    table.print();
    return table;
}

} // namespace slidercrank
