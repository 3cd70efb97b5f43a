// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/settings_fields.h"

#include "ui/text/convention_text.h"

#include <cfloat>
#include <limits>

namespace slidercrank
{

template <>
struct EnumWords<ErrorMeasure> {
    static constexpr EnumWord<ErrorMeasure> rows[] = {
        {ErrorMeasure::Percent, "percent"}, {ErrorMeasure::Absolute, "absolute"}, {ErrorMeasure::OfPeak, "of-peak"}};
    static_assert(isCompleteTable(rows, ErrorMeasure::OfPeak));
};

template <>
struct EnumWords<Abscissa> {
    static constexpr EnumWord<Abscissa> rows[] = {{Abscissa::Time, "time"}, {Abscissa::CrankAngle, "crank-angle"}};
    static_assert(isCompleteTable(rows, Abscissa::CrankAngle));
};

template <>
struct EnumWords<TableStep> {
    static constexpr EnumWord<TableStep> rows[] = {{TableStep::CrankAngle, "crank-angle"}, {TableStep::Time, "time"}};
    static_assert(isCompleteTable(rows, TableStep::Time));
};

namespace
{

constexpr double kMinPositive = std::numeric_limits<double>::denorm_min();

constexpr int kMaxSteps = 1'000'000;
constexpr int kMaxIterations = 1000;
constexpr int kMaxColumns = 1'000'000;

/// The roles of columns that contain no channel.
constexpr EnumWord<ColumnRole> kRoles[] = {
    {ColumnRole::Ignored, "ignored"}, {ColumnRole::Time, "time"}, {ColumnRole::CrankAngle, "crank-angle"}};
static_assert(hasRowForEachUpTo(kRoles, ColumnRole::CrankAngle));

} // namespace

QString meaningName(ColumnRole role, Channel channel)
{
    return role == ColumnRole::Channel ? QString::fromUtf8(nameOf(channel)) : QLatin1String(rowOf(kRoles, role).word);
}

void setMeaning(ColumnChoice &choice, const QString &name)
{
    const auto wordOfRow = [](const EnumWord<ColumnRole> &row) { return QString(row.word); };
    const auto row = std::ranges::find(kRoles, name, wordOfRow);
    choice.role = row == std::end(kRoles) ? ColumnRole::Channel : row->key;
    choice.channel = channelNamed(name.toStdString()).value_or(Channel());
}

void readOrWrite(Parameters &parameters, JsonNode &node)
{
    node("a", parameters.a, kShortestLink);
    node("b", parameters.b, kShortestLink);
    node("c", parameters.c);
    node("omega2", parameters.omega2);
    node("theta20", parameters.theta20);
    node("branch", parameters.branch);
}

void readOrWrite(Sampling &sampling, JsonNode &node)
{
    node("start", sampling.start);
    node("duration", sampling.duration, kMinPositive);
    node("steps", sampling.steps, kMaxSteps);
}

void readOrWrite(SolverSettings &solver, JsonNode &node)
{
    NewtonOptions &newton = solver.newton;
    node("method", solver.method);
    node("maxIterations", newton.maxIterations, kMaxIterations);
    node("tolerance", newton.tolerance, 0.0, DBL_MAX);
    node("toleranceKind", newton.toleranceKind);
    node("warmStart", newton.warmStart);
    node("elimination", newton.elimination);
}

void readOrWrite(ColumnChoice &choice, JsonNode &node)
{
    int number = static_cast<int>(choice.column) + 1;
    node("column", number, kMaxColumns);
    choice.column = static_cast<std::size_t>(number) - 1;

    QString use = meaningName(choice.role, choice.channel);
    node("use", use);
    setMeaning(choice, use);

    QString unit = QString::fromStdString(choice.unit);
    node("unit", unit);
    choice.unit = unit.toStdString();
}

void readOrWrite(Convention &convention, JsonNode &node)
{
    using Kind = Convention::Kind;
    QString kind = conventionName(convention.kind);
    node("kind", kind);
    convention.kind = conventionNamed(kind).value_or(convention.kind);
    node("channels", convention.channels);
    if (convention.kind == Kind::SwappedColumns) {
        convention.channels.resize(2); // it needs two channels, also if a damaged file names fewer
    }
    const bool changesUnit =
        convention.kind == Kind::AngleUnit || convention.kind == Kind::LengthUnit || convention.kind == Kind::TimeUnit;
    node("amount", convention.amount, changesUnit ? kMinPositive : -kLargestParameter);
}

void readOrWrite(ReferenceSource &source, JsonNode &node)
{
    node("file", source.paths);
    source.paths.removeAll(QString());
    node("columns", source.columns);
    node("conventions", source.conventions);
}

bool isValid(const ReferenceSource &source)
{
    return !source.paths.isEmpty();
}

void readOrWrite(PlotSettings &plots, JsonNode &node)
{
    node("error", plots.error);
    node("logarithmicError", plots.logarithmicError);
    node("roundingBand", plots.roundingBand);
    node("abscissa", plots.abscissa);
}

void readOrWrite(PlotZoom &zoom, JsonNode &node)
{
    node("time", zoom.time);
    for (std::size_t plot = 0; plot < kPlotCount; ++plot) {
        node(plotName(plot).toLatin1().constData(), zoom.values[plot]);
    }
}

void readOrWrite(MechanismSettings &settings, JsonNode &node)
{
    node("velocity", settings.velocity);
    node("acceleration", settings.acceleration);
    node("path", settings.path);
    node("names", settings.names);
    node("dimensions", settings.dimensions);
    node("angles", settings.angles);
    node("instantCentre", settings.instantCentre);
}

void readOrWrite(OutputChannel &channel, JsonNode &node)
{
    const QString name = node.exchange(QString::fromUtf8(nameOf(channel))).toString();
    channel = outputChannelNamed(name.toStdString()).value_or(channel);
}

void readOrWrite(Notation &notation, JsonNode &node)
{
    node("symbols", notation.symbols);
    node("length", notation.units.length);
    node("angle", notation.units.angle);
    node("crankSpeed", notation.crankSpeed);
}

void readOrWrite(MotionTableSettings &table, JsonNode &node)
{
    node("step", table.step);
    node("angleStep", table.angleStep, kShortestTableStep, kLongestTableStep);
    node("timeStep", table.timeStep, kShortestTableStep, kLongestTableStep);
    node("columns", table.columns);
}

} // namespace slidercrank
