// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/settings_fields.h"

#include <limits>

namespace slidercrank
{

namespace
{

constexpr double kLeastPositive = std::numeric_limits<double>::denorm_min();

constexpr int kMostSteps = 1'000'000;
constexpr int kMostIterations = 1000;
constexpr int kMostColumns = 1'000'000;

/// Names of the roles other than ColumnRole::Channel, in the order of ColumnRole.
constexpr std::array kRoles{"ignored", "time", "crank-angle"};

} // namespace

QString meaningName(ColumnRole role, Channel channel)
{
    return role == ColumnRole::Channel ? QString::fromUtf8(nameOf(channel))
                                       : QLatin1String(kRoles[static_cast<std::size_t>(role)]);
}

bool readMeaning(const QString &name, ColumnRole &role, Channel &channel)
{
    const std::optional<Channel> named = channelNamed(name.toStdString());
    const auto found = std::ranges::find(kRoles, name.toStdString());
    role = static_cast<ColumnRole>(found - kRoles.begin()); // ColumnRole::Channel follows the roles that have names
    channel = named.value_or(Channel());
    return named || found != kRoles.end();
}

void describe(Parameters &parameters, JsonFields &fields)
{
    fields("a", parameters.a, kShortestLink);
    fields("b", parameters.b, kShortestLink);
    fields("c", parameters.c);
    fields("omega2", parameters.omega2);
    fields("theta20", parameters.theta20);
    fields("branch", parameters.branch, {"open", "crossed"});
}

void describe(Sampling &sampling, JsonFields &fields)
{
    fields("start", sampling.start);
    fields("duration", sampling.duration, kLeastPositive);
    fields("steps", sampling.steps, kMostSteps);
}

void describe(SolverSettings &solver, JsonFields &fields)
{
    NewtonOptions &newton = solver.newton;
    fields("method", solver.method, {"newton", "closed-form"});
    fields("maxIterations", newton.maxIterations, kMostIterations);
    fields("tolerance", newton.tolerance, 0.0, std::numeric_limits<double>::max());
    fields("toleranceKind", newton.toleranceKind, {"absolute", "relative"});
    fields("warmStart", newton.warmStart, {"previous", "taylor"});
    fields("elimination", newton.elimination, {"dense", "structured"});
}

void describe(ColumnChoice &choice, JsonFields &fields)
{
    int number = static_cast<int>(choice.column) + 1;
    fields("column", number, kMostColumns);
    choice.column = static_cast<std::size_t>(number) - 1;

    QString use = meaningName(choice.role, choice.channel);
    fields("use", use);
    fields.check(readMeaning(use, choice.role, choice.channel), "use");

    QString unit = QString::fromStdString(choice.unit);
    fields("unit", unit);
    choice.unit = unit.toStdString();
}

void describe(Convention &convention, JsonFields &fields)
{
    using Kind = Convention::Kind;
    fields("kind", convention.kind,
           {"angle-unit", "length-unit", "time-unit", "sign", "half-turn", "whole-turns", "zero-point",
            "swapped-columns", "branch", "time-shift", "not-derivative", "axis"});
    fields("channels", convention.channels);
    fields.check(convention.kind != Kind::SwappedColumns || convention.channels.size() == 2, "channels");
    fields("amount", convention.amount, convention.kind <= Kind::TimeUnit ? kLeastPositive : -kLargestParameter);
}

void describe(ReferenceSource &source, JsonFields &fields)
{
    fields("file", source.paths);
    fields.check(!source.paths.isEmpty() && !source.paths.contains(QString()), "file");
    fields("columns", source.columns);
    fields("conventions", source.conventions);
}

void describe(PlotSettings &plots, JsonFields &fields)
{
    fields("error", plots.error, {"percent", "absolute", "of-peak"});
    fields("logarithmicError", plots.logarithmicError);
    fields("roundingBand", plots.roundingBand);
    fields("abscissa", plots.abscissa, {"time", "crank-angle"});
}

void describe(PlotZoom &zoom, JsonFields &fields)
{
    fields("time", zoom.time);
    for (std::size_t plot = 0; plot < kPlotCount; ++plot) {
        fields(plotName(plot).toLatin1().constData(), zoom.values[plot]);
    }
}

void describe(MechanismSettings &settings, JsonFields &fields)
{
    fields("velocity", settings.velocity);
    fields("acceleration", settings.acceleration);
    fields("path", settings.path);
    fields("names", settings.names);
    fields("dimensions", settings.dimensions);
    fields("angles", settings.angles);
    fields("instantCentre", settings.instantCentre);
}

} // namespace slidercrank
