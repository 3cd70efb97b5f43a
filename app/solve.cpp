// SPDX-License-Identifier: GPL-3.0-or-later

// `slidercrank solve`: the motion as CSV or JSON.

#include "app/commands.h"
#include "app/option_groups.h"
#include "app/output.h"
#include "app/records.h"
#include "app/time_step_report.h"
#include "core/import/quantity.h"
#include "ui/document/settings_fields.h"
#include "ui/export/motion_csv.h"
#include "ui/text/finding_text.h"

#include <QJsonDocument>

#include <cmath>
#include <numbers>

namespace slidercrank
{

namespace
{

struct SolveRequest {
    Mechanism mechanism;
    Sampling sampling;
    std::optional<double> timeStamp; ///< s; this one instead of the sampling
    SolverSettings solver;
    ChannelSet channels;
    AngleUnit angleUnit = AngleUnit::Degree;
    Format format = Format::Csv;
    QString output;
};

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

/// One revolution of the crank from --start on, in steps of about that angle (rad) that divide it evenly.
Sampling oneRevolution(const OptionReader &options, const Mechanism &mechanism)
{
    constexpr double kRevolution = 360.0;
    constexpr double kSmallestStep = 1e-4;
    const double degrees = options.positiveNumber("step-angle", 0.0, kDegree);
    const double steps = kRevolution / degrees;
    if (degrees < kSmallestStep || std::abs(steps - std::round(steps)) > 1e-9 * steps) {
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

/// Written piece by piece: a long motion as a document in memory would take ten times its size.
void writeJson(const Trajectory &trajectory, const SolveRequest &request, Output &output)
{
    const QByteArray mechanism = jsonDocument(toJson(request.mechanism.parameters())).trimmed();
    const bool isNewton = request.solver.method == Method::Newton;
    output.write("{\"mechanism\":" + mechanism + ",\"method\":" + (isNewton ? "\"newton\"" : "\"closed-form\"") +
                 ",\"units\":{\"length\":\"mm\",\"angle\":" +
                 (request.angleUnit == AngleUnit::Radian ? "\"rad\"" : "\"deg\"") + ",\"time\":\"s\"},\"time\":");
    output.write(jsonArray(trajectory.time, 1.0) + ",\"channels\":{");
    const char *separator = "\"";
    for (const Channel channel : listed(request.channels)) {
        output.write(separator + columnNameOf(channel).toUtf8() +
                     "\":" + jsonArray(trajectory[channel], factorTo(request.angleUnit, channel)));
        separator = ",\"";
    }
    output.write("}}\n");
}

ExitStatus solve(const Streams &streams, const SolveRequest &request)
{
    Output output(streams, request.output);
    if (!output.open()) {
        return ExitStatus::FileError;
    }
    const std::vector<Channel> channels = listed(request.channels);
    TimeStepReport steps;
    const auto write = [&](const Trajectory &piece) {
        steps.add(piece.time, piece.status);
        if (request.format == Format::Json) {
            writeJson(piece, request, output);
            return true;
        }
        return writeCsvRows(piece, channels, request.angleUnit,
                            [&](const QByteArray &text, std::size_t) { return output.write(text); });
    };
    if (request.format == Format::Csv) {
        output.write(csvHeader(channels, request.angleUnit));
    }
    if (request.timeStamp) {
        write(sample(request.mechanism, {*request.timeStamp}, request.channels, request.solver));
    } else if (request.format == Format::Json) { // all values of a channel stand together there
        write(sample(request.mechanism, request.sampling.instants(), request.channels, request.solver));
    } else {
        sampleInPieces(request.mechanism, request.sampling, request.channels, request.solver, write);
    }
    if (output.finish() != ExitStatus::Success) {
        return ExitStatus::FileError;
    }
    return steps.finish(streams, request.mechanism, request.solver.newton);
}

} // namespace

Command prepareSolve(OptionReader &options)
{
    SolveRequest request;
    request.mechanism = readMechanism(options);
    if (options.has("at") || options.has("at-angle")) {
        options.refuse({"steps", "duration", "step-angle"},
                       CommandLine::tr("--at and --at-angle ask for one time and %1 for several: remove one of them."));
        const double start = options.number("start", options.scene().sampling.start, kSecond);
        request.timeStamp = readTimeStamp(options, request.mechanism, start);
    } else if (options.has("step-angle")) {
        options.refuse({"steps", "duration"}, CommandLine::tr("--step-angle covers one revolution: remove %1."));
        request.sampling = oneRevolution(options, request.mechanism);
    } else {
        request.sampling = readSampling(options);
    }
    request.solver = readSolver(options);
    request.channels = readChannels(options);
    request.angleUnit = options.choice("angle-unit", request.angleUnit);
    request.format = readFormat(options, Format::Csv);
    request.output = readOutput(options);
    options.refuseFiles();
    return {[request](const Streams &streams) { return solve(streams, request); }};
}

} // namespace slidercrank
