// SPDX-License-Identifier: GPL-3.0-or-later

// `slidercrank solve`: writes the motion as CSV or JSON.

#include "app/commands.h"
#include "app/option_groups.h"
#include "app/output.h"
#include "app/records.h"
#include "app/time_step_report.h"
#include "core/import/quantity.h"
#include "ui/document/settings_fields.h"
#include "ui/export/motion_csv.h"
#include "ui/text/finding_text.h"

#include <cmath>
#include <numbers>

namespace slidercrank
{

namespace
{

ChannelSet readChannels(const OptionReader &options)
{
    if (!options.has("channels") || options.text("channels") == u"all") {
        return allChannels();
    }
    ChannelSet channels;
    for (const QString &part : options.text("channels").split(',')) {
        const QString name = part.trimmed();
        const std::optional<Channel> channel = channelNamed(name.toStdString());
        if (!channel) {
            throwUnknownName(CommandLine::tr("--channels: there is no channel \"%1\"").arg(name), name, channelNames());
        }
        channels.set(indexOf(*channel));
    }
    return channels;
}

/// Reads --step-angle: one revolution of the crank from --start on, in equal steps of that angle.
Sampling oneRevolution(const OptionReader &options, const Mechanism &mechanism)
{
    const double steps = 360.0 / options.number("step-angle", 0.0, kDegree, 1e-4, 360.0);
    if (std::abs(steps - std::round(steps)) > 1e-9 * steps) {
        throw UsageError{CommandLine::tr("--step-angle must divide 360° into equal steps, such as 15 or 0.5, not %1.")
                             .arg(options.text("step-angle"))};
    }
    if (mechanism.omega2() == 0.0) {
        throw UsageError{CommandLine::tr("The crank stands still: --step-angle needs an --omega2 that is not 0.")};
    }
    Sampling sampling = options.scene().sampling;
    sampling.start = options.number("start", sampling.start, kSecond);
    sampling.duration = 2.0 * std::numbers::pi / std::abs(mechanism.omega2());
    sampling.steps = static_cast<int>(std::lround(steps));
    return sampling;
}

QByteArray jsonArray(const std::vector<double> &values, double factor)
{
    QByteArray text("[");
    for (const double value : values) {
        text += text.size() > 1 ? "," : "";
        if (std::isfinite(value)) {
            appendNumber(text, value * factor); // 17 digits, as in CSV
        } else {
            text += "null";
        }
    }
    return text + ']';
}

/// Writes the channels one after the other: a JSON document in memory would take ten times the size of the motion.
void writeJson(const Mechanism &mechanism, Method method, AngleUnit angleUnit, const std::vector<Channel> &channels,
               const Trajectory &motion, Output &output)
{
    output.write("{\"mechanism\":" + jsonDocument(toJson(mechanism.parameters())).trimmed() +
                 ",\"method\":" + (method == Method::Newton ? "\"newton\"" : "\"closed-form\"") +
                 ",\"units\":{\"length\":\"mm\",\"angle\":" + (angleUnit == AngleUnit::Radian ? "\"rad\"" : "\"deg\"") +
                 ",\"time\":\"s\"},\"time\":" + jsonArray(motion.time, 1.0) + ",\"channels\":{");
    const char *separator = "\"";
    for (const Channel channel : channels) {
        output.write(separator + columnNameOf(channel).toUtf8() +
                     "\":" + jsonArray(motion[channel], factorTo(angleUnit, channel)));
        separator = ",\"";
    }
    output.write("}}\n");
}

} // namespace

ExitStatus solveCommand(const OptionReader &options, const Streams &streams)
{
    const Mechanism mechanism = readMechanism(options);
    std::optional<double> timeStamp; // s; instead of the sampling
    Sampling sampling;
    if (options.has("at") || options.has("at-angle")) {
        options.refuse({"steps", "duration", "step-angle"},
                       CommandLine::tr("--at and --at-angle ask for one time and %1 for several: remove one of them."));
        const double start = options.number("start", options.scene().sampling.start, kSecond);
        timeStamp = readTimeStamp(options, mechanism, start);
    } else if (options.has("step-angle")) {
        options.refuse({"steps", "duration"}, CommandLine::tr("--step-angle covers one revolution: remove %1."));
        sampling = oneRevolution(options, mechanism);
    } else {
        sampling = readSampling(options);
    }
    const SolverSettings solver = readSolver(options);
    const ChannelSet channelSet = readChannels(options);
    const std::vector<Channel> channels = listed(channelSet);
    const AngleUnit angleUnit = options.choice("angle-unit", AngleUnit::Degree);
    const bool isJson = readFormat(options, Format::Csv) == Format::Json;
    Output output(streams, readOutput(options));
    options.refuseFiles();
    if (!output.open()) {
        return ExitStatus::FileError;
    }
    TimeStepReport steps;
    const auto write = [&](const Trajectory &motion) {
        steps.add(motion.time, motion.status);
        if (isJson) {
            writeJson(mechanism, solver.method, angleUnit, channels, motion, output);
            return true;
        }
        return writeCsvRows(motion, channels, angleUnit,
                            [&](const QByteArray &text) { return output.write(text); });
    };
    if (!isJson) {
        output.write(csvHeader(channels, angleUnit));
    }
    if (timeStamp) {
        write(sample(mechanism, {*timeStamp}, channelSet, solver));
    } else if (isJson) { // holds all values of a channel together
        write(sample(mechanism, sampling.timeStamps(), channelSet, solver));
    } else {
        sampleInPieces(mechanism, sampling, channelSet, solver, write);
    }
    if (output.finish() != ExitStatus::Success) {
        return ExitStatus::FileError;
    }
    return steps.finish(streams, mechanism, solver.newton);
}

} // namespace slidercrank
