// SPDX-License-Identifier: GPL-3.0-or-later

// `slidercrank solve`: writes the motion as CSV or JSON.

#include "app/answer.h"
#include "app/commands.h"
#include "app/output.h"
#include "app/time_step_report.h"
#include "core/import/quantity.h"
#include "core/mechanism/turn.h"
#include "ui/document/settings_fields.h"
#include "ui/export/motion_csv.h"
#include "ui/text/finding_text.h"

#include <cmath>

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
        channels.set(static_cast<std::size_t>(indexAmong(channelNames(), part.trimmed(), "channels")));
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
    Sampling sampling;
    sampling.start = readStart(options);
    sampling.duration = kTurn / std::abs(mechanism.omega2());
    sampling.steps = static_cast<int>(std::lround(steps));
    return sampling;
}

QByteArray motionJson(const Mechanism &mechanism, Method method, AngleUnit angleUnit,
                      const std::vector<Channel> &channels, const Trajectory &motion)
{
    QJsonObject values;
    for (const Channel channel : channels) {
        const double factor = factorTo(angleUnit, channel);
        values.insert(columnName(channel),
                      jsonList(motion[channel], [factor](double value) { return jsonNumber(factor * value); }));
    }
    return jsonDocument(
        {{"mechanism", toJson(mechanism.parameters())},
         {"method", method == Method::Newton ? "newton" : "closed-form"},
         {"units",
          QJsonObject{{"length", "mm"}, {"angle", angleUnit == AngleUnit::Radian ? "rad" : "deg"}, {"time", "s"}}},
         {"time", jsonList(motion.time, jsonNumber)},
         {"channels", values}});
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
        if (options.has("at")) {
            options.refuse({"start"}, CommandLine::tr("--at already sets the time: remove %1."));
        }
        timeStamp = readTimeStamp(options, mechanism);
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
    const bool isJson = options.word("format", "csv") == u"json";
    Output output(streams, readOutput(options));
    options.refuseFiles();
    if (!output.open()) {
        return ExitStatus::FileError;
    }
    SamplingSummary summary;
    const auto write = [&](const Trajectory &motion) {
        summary.add(motion.summary);
        if (isJson) {
            return output.write(motionJson(mechanism, solver.method, angleUnit, channels, motion));
        }
        return writeCsvRows(motion, channels, angleUnit, [&](const QByteArray &text) { return output.write(text); });
    };
    if (!isJson) {
        output.write(csvHeader(channels, angleUnit));
    }
    if (timeStamp || isJson) { // JSON holds all values of a channel together
        const std::vector<double> times = timeStamp ? std::vector{*timeStamp} : sampling.timeStamps();
        write(sample(mechanism, times, channelSet, solver));
    } else {
        sampleInPieces(mechanism, sampling, channelSet, solver, write);
    }
    if (output.finish() != ExitStatus::Success) {
        return ExitStatus::FileError;
    }
    return reportTimeSteps(streams, summary, mechanism, solver.newton);
}

} // namespace slidercrank
