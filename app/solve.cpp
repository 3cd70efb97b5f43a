// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/subcommands.h"

#include "app/json_text.h"
#include "app/output.h"
#include "app/shortfall.h"
#include "ui/export/motion_csv.h"

#include <string>
#include <vector>

namespace slidercrank
{

namespace
{

constexpr qsizetype kFullBuffer = 1 << 20; // bytes: then it is handed to the device

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
        text += '"' + QByteArray::fromStdString(std::string(nameOf(channel))) + "\":";
        writeJsonArray(trajectory[channel], factorTo(options.angleUnit, channel), text, output);
    }
    output.write(text + "}}\n");
}

} // namespace

ExitStatus solve(const SolveOptions &options)
{
    Output output(options.output);
    if (!output.open()) {
        return ExitStatus::FileFailed;
    }
    const std::vector<Channel> channels = listed(options.channels);
    Shortfall shortfall;
    const auto take = [&](const Trajectory &piece) {
        shortfall.add(piece.time, piece.status);
        if (options.format == Format::Json) {
            writeJson(piece, channels, options, output);
            return true;
        }
        return writeCsvRows(piece, channels, options.angleUnit,
                            [&](const QByteArray &text, std::size_t) { return output.write(text); });
    };
    if (options.format != Format::Json) {
        output.write(csvHeader(channels, options.angleUnit));
    }
    if (options.atInstant) {
        take(sample(options.mechanism, {*options.atInstant}, options.channels, options.solver));
    } else if (options.format == Format::Json) { // which has a channel's values in a row
        take(sample(options.mechanism, options.sampling.instants(), options.channels, options.solver));
    } else {
        sampleInPieces(options.mechanism, options.sampling, options.channels, options.solver, take);
    }
    if (output.finish() != ExitStatus::Done) {
        return ExitStatus::FileFailed;
    }
    return shortfall.report(options.mechanism, options.solver.newton.maxIterations);
}

} // namespace slidercrank
