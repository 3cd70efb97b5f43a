// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/option_groups.h"

#include "app/option_words.h"
#include "core/import/heading.h"
#include "core/import/quantity.h"
#include "core/mechanism/channel.h"
#include "core/sampling/crank_time.h"
#include "ui/document/settings_fields.h"
#include "ui/text/channel_text.h"
#include "ui/text/expression.h"
#include "ui/text/parameter_text.h"
#include "ui/text/quantity_text.h"
#include "ui/text/written_number.h"

#include <QDir>
#include <QFileInfo>

#include <algorithm>
#include <array>
#include <cmath>

namespace slidercrank
{

namespace
{

constexpr int kLargestStepCount = 100'000'000;
constexpr double kShortestTime = 1e-12; // s

Unit unitOf(Parameter parameter)
{
    switch (parameter) {
    case Parameter::A:
    case Parameter::B:
    case Parameter::C: break;
    case Parameter::Omega2: return kRadianPerSecond;
    case Parameter::Theta20: return kRadian;
    }
    return kMillimetre;
}

/// Parses the meaning that --column gives a column: "R4_x [m]", "time", "crank-angle" or "ignored". Throws if the name
/// or the unit is unknown.
ColumnChoice parseMeaning(const QString &text)
{
    const Heading heading = parseHeading(text.toStdString());
    const QString name = QString::fromStdString(heading.name);
    requireOneOf(QStringList{"time", "crank-angle", "ignored"} + channelNames(), name, "column");
    ColumnChoice choice;
    choice.unit = heading.use.unit;
    setMeaning(choice, name);
    if (!choice.unit.empty() && !parseColumnUnit(choice.unit, choice.role, choice.channel)) {
        throw UsageError{
            CommandLine::tr("--column: \"%1\" is not a unit of %2.").arg(QString::fromStdString(choice.unit), name)};
    }
    return choice;
}

} // namespace

double parseParameter(const char *option, const QString &text, Parameter parameter)
{
    const bool isLink = parameter == Parameter::A || parameter == Parameter::B;
    const Quantity withoutUnit = readExpression(text, {}, QLocale::c());
    const bool lacksUnit = !withoutUnit.fault && withoutUnit.value != 0.0; // 0 needs none
    if (parameter == Parameter::Theta20 && lacksUnit) {
        throw UsageError{CommandLine::tr("--%1 %2: add a unit, %2deg or %2rad.").arg(option, text)};
    }
    return parseNumber(option, text, unitOf(parameter), isLink ? kShortestLink : -kLargestParameter);
}

QStringList channelNames()
{
    QStringList names;
    for (std::size_t index = 0; index < kChannelCount; ++index) {
        names += columnName(channelAt(index));
    }
    return names;
}

Mechanism readMechanism(const OptionReader &options)
{
    Parameters parameters = options.scene().parameters;
    for (const Parameter parameter : kAllParameters) {
        const char *name = optionName(parameter);
        if (options.has(name)) {
            valueOf(parameters, parameter) = parseParameter(name, options.text(name), parameter);
        }
    }
    parameters.branch = options.choice("branch", parameters.branch);
    return Mechanism(parameters);
}

double readStart(const OptionReader &options)
{
    return options.number("start", options.scene().sampling.start, kSecond);
}

Sampling readSampling(const OptionReader &options)
{
    Sampling sampling = options.scene().sampling;
    sampling.start = readStart(options);
    sampling.duration = options.number("duration", sampling.duration, kSecond, kShortestTime);
    sampling.steps = options.integer("steps", sampling.steps, 1, kLargestStepCount);
    checkTimeSteps(sampling,
                   CommandLine::tr("The time steps are too short to be distinguished: choose fewer --steps, a "
                                   "longer --duration or a --start nearer to 0."));
    return sampling;
}

void checkTimeSteps(const Sampling &sampling, const QString &message)
{
    constexpr double kSpacing = 4.5e-16; // twice the relative distance of neighbouring doubles
    if (sampling.duration / sampling.steps < kSpacing * (std::abs(sampling.start) + sampling.duration)) {
        throw UsageError{message};
    }
}

SolverSettings readSolver(const OptionReader &options)
{
    SolverSettings solver = options.scene().solver;
    solver.method = options.choice("method", solver.method);
    solver.newton.maxIterations = options.integer("max-iterations", solver.newton.maxIterations, 1, 1'000'000);
    solver.newton.tolerance = options.number("tolerance", solver.newton.tolerance, {}, 0.0);
    solver.newton.toleranceKind = options.choice("tolerance-kind", solver.newton.toleranceKind);
    return solver;
}

double firstTimeAtAngle(const OptionReader &options, const Mechanism &mechanism, double theta2)
{
    const std::optional<double> time = timeAtCrankAngle(mechanism, theta2, readStart(options));
    if (!time || std::abs(*time) > kLargestParameter) {
        throw UsageError{
            CommandLine::tr("The crank does not reach %1° within 1e12 s: choose a different --omega2 or --theta20.")
                .arg(numberText(theta2 * kDegreesPerRadian))};
    }
    return *time;
}

std::optional<double> readTimeStamp(const OptionReader &options, const Mechanism &mechanism)
{
    if (options.has("at")) {
        options.refuseIfGiven({"at-angle"}, CommandLine::tr("--at already sets the time: remove %1."));
        return options.number("at", 0.0, kSecond);
    }
    if (!options.has("at-angle")) {
        return std::nullopt;
    }
    return firstTimeAtAngle(options, mechanism, options.number("at-angle", 0.0, kDegree) / kDegreesPerRadian);
}

std::vector<ColumnChoice> readColumns(const OptionReader &options)
{
    std::vector<ColumnChoice> choices;
    if (options.has("abscissa")) {
        const bool isTime = options.choice("abscissa", FirstColumn::TimeStamps) == FirstColumn::TimeStamps;
        choices.push_back({.role = isTime ? ColumnRole::Time : ColumnRole::CrankAngle, .heading = "#1"});
    }
    for (const QString &text : options.texts("column")) {
        const qsizetype equals = text.lastIndexOf('='); // a heading may contain one, a meaning does not
        if (equals < 1) {
            throw UsageError{CommandLine::tr("--column must be a heading, = and a meaning, such as \"slider.s=R4_x "
                                             "[m]\", \"#1=time\" or \"id=ignored\", not \"%1\".")
                                 .arg(text)};
        }
        ColumnChoice choice = parseMeaning(text.sliced(equals + 1).trimmed());
        choice.heading = text.first(equals).trimmed().toStdString();
        if (std::ranges::count(choices, choice.heading, &ColumnChoice::heading) > 0) {
            throw UsageError{CommandLine::tr("--column gives \"%1\" two meanings: keep one of them.")
                                 .arg(QString::fromStdString(choice.heading))};
        }
        choices.push_back(std::move(choice));
    }
    return choices;
}

QString readOutput(const OptionReader &options)
{
    const QString output = options.text("output");
    if (output == u"-") {
        return {};
    }
    for (const QString &file : options.inputFiles()) {
        if (!output.isEmpty() && QFileInfo::exists(output) && QFileInfo(output) == QFileInfo(file)) {
            throw UsageError{CommandLine::tr("--output would overwrite the input file %1: choose another name.")
                                 .arg(QDir::toNativeSeparators(file))};
        }
    }
    return output;
}

} // namespace slidercrank
