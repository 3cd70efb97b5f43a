// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/solve.h"

#include "app/json_text.h"
#include "app/output.h"
#include "app/shortfall.h"

#include <algorithm>
#include <string_view>
#include <vector>

namespace slidercrank
{

namespace
{

/// Handed to the device when full, so that a long run's text is never in memory as a whole.
constexpr qsizetype kFullBuffer = 1 << 20; // bytes

std::vector<Channel> listed(const ChannelSet &channels)
{
    std::vector<Channel> list;
    for (std::size_t index = 0; index < kChannelCount; ++index) {
        if (channels.test(index)) {
            list.push_back(channelAt(index));
        }
    }
    return list;
}

QByteArray toBytes(std::string_view text)
{
    return QByteArray(text.data(), static_cast<qsizetype>(text.size()));
}

/// From the trajectory's degrees to what was asked for.
double unitFactor(Channel channel, AngleUnit unit)
{
    return isAngle(channel.coordinate) && unit == AngleUnit::Radian ? 1.0 / kDegreesPerRadian : 1.0;
}

/// The name alone in the author's units, any other unit behind it, so that what is written is read back right.
QByteArray headerOf(Channel channel, AngleUnit unit)
{
    const QByteArray name = toBytes(nameOf(channel));
    if (unit == AngleUnit::Degree || !isAngle(channel.coordinate)) {
        return name;
    }
    switch (channel.order) {
    case Order::Position: return name + " [rad]";
    case Order::Velocity: return name + " [rad/s]";
    case Order::Acceleration: return name + " [rad/s^2]";
    }
    return name;
}

void writeHeader(const std::vector<Channel> &channels, AngleUnit unit, Output &output)
{
    QByteArray header("time");
    for (const Channel channel : channels) {
        header += ',' + headerOf(channel, unit);
    }
    output.write(header + '\n');
}

/// False when the output failed.
bool writeRows(const Trajectory &trajectory, const std::vector<Channel> &channels, AngleUnit unit, Output &output)
{
    struct Column {
        const double *values;
        double factor;
    };
    std::vector<Column> columns;
    for (const Channel channel : channels) {
        columns.push_back({trajectory[channel].data(), unitFactor(channel, unit)});
    }
    QByteArray text;
    text.reserve(kFullBuffer + kFullBuffer / 8);
    for (std::size_t row = 0; row < trajectory.time.size(); ++row) {
        appendNumber(text, trajectory.time[row]);
        for (const Column &column : columns) {
            text += ',';
            appendNumber(text, column.values[row] * column.factor);
        }
        text += '\n';
        if (text.size() >= kFullBuffer) {
            if (!output.write(text)) {
                return false;
            }
            text.resize(0); // clear() would give the memory back
        }
    }
    return output.write(text);
}

void writeJsonArray(const std::vector<double> &values, double factor, QByteArray &text, Output &output)
{
    text += '[';
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (i > 0) {
            text += ',';
        }
        appendJsonNumber(text, values[i] * factor);
        if (text.size() >= kFullBuffer) {
            if (!output.write(text)) {
                return;
            }
            text.resize(0);
        }
    }
    text += ']';
}

void writeJson(const Trajectory &trajectory, const std::vector<Channel> &channels, const SolveOptions &options,
               Output &output)
{
    QByteArray text = "{\"mechanism\":" + jsonMechanism(options.mechanism);
    text += options.solver.method == Method::Newton ? ",\"method\":\"newton\"" : ",\"method\":\"closed-form\"";
    text += ",\"units\":{\"length\":\"mm\",\"angle\":";
    text += options.angleUnit == AngleUnit::Radian ? "\"rad\"" : "\"deg\"";
    text += ",\"time\":\"s\"},\"time\":";
    writeJsonArray(trajectory.time, 1.0, text, output);
    text += ",\"channels\":{";
    for (const Channel channel : channels) {
        if (channel != channels.front()) {
            text += ',';
        }
        text += '"' + toBytes(nameOf(channel)) + "\":";
        writeJsonArray(trajectory[channel], unitFactor(channel, options.angleUnit), text, output);
    }
    output.write(text + "}}\n");
}

/// How many instants are computed and written at a time. Newton-Raphson starts each instant from the one before, and
/// JSON has a channel's values in a row: both need the run in one piece.
int blockLength(const SolveOptions &options)
{
    constexpr int kBlock = 1 << 15; // all 36 channels in some 10 MB
    const bool whole = options.solver.method == Method::Newton || options.format == Format::Json;
    return whole ? options.sampling.steps + 1 : std::min(options.sampling.steps + 1, kBlock);
}

} // namespace

ExitStatus solve(const SolveOptions &options)
{
    Output output(options.output);
    if (const std::optional<QString> sentence = output.open()) {
        say(*sentence);
        return ExitStatus::FileFailed;
    }
    const std::vector<Channel> channels = listed(options.channels);
    if (options.format != Format::Json) {
        writeHeader(channels, options.angleUnit, output);
    }
    const int count = options.atInstant ? 1 : options.sampling.steps + 1;
    const int block = blockLength(options);
    Shortfall shortfall;
    for (int first = 0; first < count; first += block) {
        std::vector<double> instants;
        instants.reserve(static_cast<std::size_t>(block));
        for (int i = first; i < std::min(first + block, count); ++i) {
            instants.push_back(options.atInstant.value_or(options.sampling.instant(i)));
        }
        const Trajectory trajectory = sample(options.mechanism, instants, options.channels, options.solver);
        shortfall.add(trajectory.time, trajectory.status);
        if (options.format == Format::Json) {
            writeJson(trajectory, channels, options, output);
        } else if (!writeRows(trajectory, channels, options.angleUnit, output)) {
            break;
        }
    }
    if (const std::optional<QString> sentence = output.finish()) {
        say(*sentence);
        return ExitStatus::FileFailed;
    }
    if (shortfall.exitStatus() != ExitStatus::Done) {
        say(shortfall.sentence(options.mechanism, options.solver.newton.maxIterations));
    }
    return shortfall.exitStatus();
}

} // namespace slidercrank
