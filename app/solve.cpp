// SPDX-License-Identifier: GPL-3.0-or-later

// `slidercrank solve`: writes the motion as CSV or JSON.

#include "app/command_output.h"
#include "app/commands.h"
#include "app/output.h"
#include "app/positions.h"
#include "app/time_step_report.h"
#include "core/sampling/positions.h"
#include "ui/document/settings_fields.h"
#include "ui/export/motion_csv.h"

#include <functional>
#include <span>

namespace slidercrank
{

namespace
{

/// Returns the channels that --channels names, in the order of allOutputChannels(); by default, the 36 of the
/// coordinates.
std::vector<OutputChannel> readChannels(const OptionReader &options)
{
    std::vector<OutputChannel> all = allOutputChannels();
    if (!options.has("channels") || options.text("channels") == u"all") {
        std::erase_if(all,
                      [](const OutputChannel &channel) { return std::holds_alternative<DerivedChannel>(channel); });
        return all;
    }
    std::vector<OutputChannel> wanted;
    for (const QString &part : options.text("channels").split(',')) {
        wanted.push_back(parseOutputChannel("channels", part.trimmed()));
    }
    std::erase_if(all, [&wanted](const OutputChannel &channel) { return !std::ranges::count(wanted, channel); });
    return all;
}

/// The channels that are written as columns, and their units.
struct Table {
    std::vector<OutputChannel> channels;
    Units units;

    double value(const Trajectory &motion, const OutputChannel &channel, std::size_t row) const
    {
        return fromFileUnit(measureOf(channel), motion[channel][row], units);
    }
};

/// Returns the line of names. A name without unit means mm, ° and s; any other unit follows the name.
QByteArray headerOf(const Table &table)
{
    QByteArray header("time");
    for (const OutputChannel &channel : table.channels) {
        header += ',' + columnName(channel, table.units).toUtf8();
    }
    return header + '\n';
}

/// Writes a row for each time step. Returns false if nothing more can be written.
bool writeRows(Output &output, const Table &table, const Trajectory &motion)
{
    constexpr qsizetype kFullBuffer = 1 << 20; // bytes
    QByteArray text;
    for (std::size_t row = 0; row < motion.time.size(); ++row) {
        appendNumber(text, motion.time[row]);
        for (const OutputChannel &channel : table.channels) {
            text += ',';
            appendNumber(text, table.value(motion, channel, row));
        }
        text += '\n';
        if (text.size() >= kFullBuffer) {
            if (!output.write(text)) {
                return false;
            }
            text.resize(0); // unlike clear(), this does not free the memory
        }
    }
    return output.write(text);
}

QByteArray motionJson(const Mechanism &mechanism, Method method, const Table &table, const Trajectory &motion)
{
    QJsonObject values;
    for (const OutputChannel &channel : table.channels) {
        QJsonArray column;
        for (std::size_t row = 0; row < motion.time.size(); ++row) {
            column += jsonNumber(table.value(motion, channel, row));
        }
        values.insert(columnName(channel), column);
    }
    return jsonDocument(
        {{"mechanism", toJson(mechanism.parameters())},
         {"method", wordFor(method)},
         {"units",
          QJsonObject{{"length", wordFor(table.units.length)}, {"angle", wordFor(table.units.angle)}, {"time", "s"}}},
         {"time", jsonList(motion.time, jsonNumber)},
         {"channels", values}});
}

/// Samples the positions, of which there is at least one.
Trajectory sampleAll(const std::vector<Positions> &positions, const SampledChannels &channels,
                     const SolverSettings &solver)
{
    const auto sampleOne = [&](const Positions &each) {
        return samplePositions(each.mechanism, each.timeStamps, channels, solver);
    };
    Trajectory motion = sampleOne(positions.front());
    for (const Positions &next : std::span(positions).subspan(1)) {
        motion.append(sampleOne(next));
    }
    return motion;
}

std::size_t countTimeStamps(const std::vector<Positions> &positions)
{
    std::size_t count = 0;
    for (const Positions &each : positions) {
        count += each.timeStamps.size();
    }
    return count;
}

/// Throws if there are too many values for JSON. JSON holds all values of a channel together, so that all values are in
/// memory: about 50 bytes each, and their text.
void refuseLargeJson(const Table &table, std::size_t timeStamps)
{
    constexpr std::size_t kMaxValues = 10'000'000;
    const std::size_t maxTimeStamps = kMaxValues / (table.channels.size() + 1);
    if (timeStamps > maxTimeStamps) {
        throw UsageError{CommandLine::tr("--format json writes at most %1 time stamps of these channels: choose fewer "
                                         "--channels, or --format csv.")
                             .arg(QString::number(maxTimeStamps))};
    }
}

/// What the options ask for.
struct SolveRequest {
    Table table;
    OutputFormat format;
    SolverSettings solver;
    Mechanism mechanism;
    std::vector<Positions> positions; ///< empty if time steps are asked for
    Sampling sampling;                ///< the time steps; not used if there are positions
    double alpha2 = 0.0;              ///< rad/s², crank acceleration at the positions

    SolveRequest(const OptionReader &options, const Streams &streams)
        : table{.channels = readChannels(options), .units = readUnits(options)}
        , format(options.choice("format", OutputFormat::Csv))
        , solver(readSolver(options))
        , mechanism(readMechanism(options))
        , positions(readPositions(options, mechanism, table.units, streams))
    {
        if (positions.empty()) {
            sampling = readSampling(options);
        } else {
            alpha2 = readCrankAcceleration(options);
        }
        if (positions.size() == 1) { // several elements have a mechanism each, with different initial angles
            mechanism = positions.front().mechanism;
        }
        if (format == OutputFormat::Json) {
            refuseLargeJson(table, positions.empty() ? static_cast<std::size_t>(sampling.steps) + 1
                                                     : countTimeStamps(positions));
        }
    }
};

/// Computes the motion and passes it to take(), in pieces if it is written as CSV. Ends early if take() returns false.
void computeMotion(const SolveRequest &request, const std::function<bool(const Trajectory &)> &take)
{
    const SampledChannels channels(request.table.channels, request.alpha2);
    if (!request.positions.empty()) {
        take(sampleAll(request.positions, channels, request.solver));
    } else if (request.format == OutputFormat::Json) { // JSON holds all values of a channel together
        take(sample(request.mechanism, request.sampling.timeStamps(), channels, request.solver));
    } else {
        sampleInPieces(request.mechanism, request.sampling, channels, request.solver, take);
    }
}

} // namespace

ExitStatus solveCommand(const OptionReader &options, const Streams &streams)
{
    const SolveRequest request(options, streams);
    const bool isJson = request.format == OutputFormat::Json;
    Output output(streams, readOutput(options));
    options.refuseFiles();
    if (!output.open()) {
        return ExitStatus::FileError;
    }
    if (!isJson) {
        output.write(headerOf(request.table));
    }
    SamplingSummary summary;
    JumpingRows jumps;
    for (const Positions &each : request.positions) {
        jumps.add(each.mechanism, each.timeStamps, request.alpha2);
    }
    computeMotion(request, [&](const Trajectory &motion) {
        summary.add(motion.summary);
        if (request.positions.empty()) {
            jumps.add(request.mechanism, motion.time);
        }
        return isJson ? output.write(motionJson(request.mechanism, request.solver.method, request.table, motion))
                      : writeRows(output, request.table, motion);
    });
    if (output.finish() != ExitStatus::Success) {
        return ExitStatus::FileError;
    }
    if (request.solver.method == Method::ClosedForm) {
        jumps.report(streams);
    }
    return reportTimeSteps(streams, summary, request.mechanism, request.solver.newton);
}

} // namespace slidercrank
