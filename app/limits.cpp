// SPDX-License-Identifier: GPL-3.0-or-later

// `slidercrank limits`: prints dead centres, stroke, time ratio, transmission angle and peak values. --vary prints how
// they depend on one parameter; --design finds the mechanism with a given stroke and time ratio.

#include "app/command_output.h"
#include "app/commands.h"
#include "app/positions.h"
#include "core/import/quantity.h"
#include "core/limits/design.h"
#include "core/limits/tolerance.h"
#include "core/mechanism/turn.h"
#include "ui/document/settings_fields.h"
#include "ui/text/channel_text.h"
#include "ui/text/design_text.h"
#include "ui/text/motion_facts.h"
#include "ui/text/notation.h"
#include "ui/text/parameter_text.h"
#include "ui/text/written_number.h"

#include <QJsonArray>
#include <QRegularExpression>

#include <algorithm>
#include <array>
#include <cmath>

namespace slidercrank
{

namespace
{

/// Returns a time range of one revolution, so that the crank reaches every limit in it. Returns the default range if
/// the crank stands still.
Sampling oneRevolution(const Mechanism &mechanism)
{
    Sampling revolution;
    if (mechanism.omega2() != 0.0) {
        revolution.duration = kTurn / std::abs(mechanism.omega2());
    }
    return revolution;
}

QString keyText(LimitKind kind)
{
    const std::string_view key = describe(kind).key;
    return QString::fromUtf8(key.data(), static_cast<qsizetype>(key.size()));
}

/// By how much a limit may decrease and increase, in the unit that is shown.
struct Change {
    std::optional<double> minus = {};
    std::optional<double> plus = {};
};

/// The limits of a mechanism as the command prints them.
struct PrintedLimits {
    const Mechanism &mechanism;
    MotionLimits motion;
    std::vector<Limit> limits;
    Units units;
    std::optional<LimitRanges> ranges = {}; ///< the ranges of the limits within the tolerances of --tolerance

    PrintedLimits(const Mechanism &theMechanism, const Units &theUnits)
        : mechanism(theMechanism)
        , motion(motionLimits(theMechanism))
        , limits(findLimits(theMechanism, motion))
        , units(theUnits)
    {
    }

    double shown(const Limit &limit) const { return shownValue(describe(limit.kind).measure, limit.value, units); }

    /// Returns by how much the tolerances may change the limit. The ranges are ranges of magnitudes, so that a negative
    /// peak decreases where its magnitude grows.
    Change changeOf(const Limit &limit) const
    {
        const std::optional<LimitRange> &range = (*ranges)[static_cast<std::size_t>(limit.kind)];
        if (!range) {
            return {};
        }
        const bool isNegativePeak = peakChannel(limit.kind) && limit.value < 0.0;
        const double magnitude = isNegativePeak ? -limit.value : limit.value;
        const Measure measure = describe(limit.kind).measure;
        const double less = shownValue(measure, magnitude - range->least, units);
        const double more = shownValue(measure, range->greatest - magnitude, units);
        return isNegativePeak ? Change{.minus = more, .plus = less} : Change{.minus = less, .plus = more};
    }

    /// Returns a record for each limit and each crank angle at which it occurs. A limit that does not exist has one
    /// record without a value.
    std::vector<Record> records() const
    {
        std::vector<Record> all;
        for (const LimitDescription &description : kLimitDescriptions) {
            if (description.key.empty()) {
                continue;
            }
            const std::size_t before = all.size();
            for (const Limit &limit : limits) {
                if (limit.kind == description.kind) {
                    all.push_back(record(limit));
                }
            }
            if (all.size() == before) {
                all.push_back(record({.kind = description.kind, .value = kNone}));
            }
        }
        return all;
    }

    /// Returns the table of the window's tab "Motion limits".
    QString table() const
    {
        std::vector<QStringList> rows =
            limitTable(motionFacts(mechanism, motion, oneRevolution(mechanism), notation()));
        if (ranges) {
            rows.front() += {CommandLine::tr("minus"), CommandLine::tr("plus")};
            for (std::size_t i = 0; i < limits.size(); ++i) { // the first row contains the headings
                const Change change = changeOf(limits[i]);
                rows[i + 1] += {shortNumber(change.minus), shortNumber(change.plus)};
            }
        }
        return alignedTable(rows);
    }

private:
    Record record(const Limit &limit) const
    {
        const LimitDescription &description = describe(limit.kind);
        Record record{{"name", keyText(limit.kind)},
                      {"value", jsonNumber(shown(limit))},
                      {"unit", unitText(description.measure, units)},
                      {"theta2", limit.theta2 ? degreesFromZero(*limit.theta2) : QJsonValue()},
                      {"time", jsonNumber(timeOf(limit, mechanism, oneRevolution(mechanism)))}};
        if (ranges) {
            const Change change = std::isnan(limit.value) ? Change() : changeOf(limit);
            record.emplace_back("minus", jsonNumber(change.minus));
            record.emplace_back("plus", jsonNumber(change.plus));
        }
        return record;
    }
};

/// Reads --tolerance, such as "a=0.05,b=0.1": half the range of each length.
LengthTolerances readTolerances(const OptionReader &options, const Mechanism &mechanism)
{
    struct Length {
        const char *name;
        double LengthTolerances::*tolerance;
        double bound; ///< mm: the tolerance must be smaller, because a crank or a coupler of length 0 is no link
    };
    const Length lengths[] = {{"a", &LengthTolerances::a, mechanism.a()},
                              {"b", &LengthTolerances::b, mechanism.b()},
                              {"c", &LengthTolerances::c, kInfinity}};
    LengthTolerances tolerances;
    QStringList names;
    for (const QString &part : options.text("tolerance").split(',')) {
        const QString name = part.section('=', 0, 0).trimmed();
        if (!part.contains('=')) {
            throw UsageError{CommandLine::tr("--tolerance must be a list such as a=0.05,b=0.1,c=0.05, not \"%1\".")
                                 .arg(options.text("tolerance"))};
        }
        const auto *const length =
            std::ranges::find(lengths, name, [](const Length &each) { return QString(each.name); });
        if (length == std::end(lengths)) {
            throw UsageError{CommandLine::tr("--tolerance: \"%1\" is not one of the lengths a, b and c.").arg(name)};
        }
        if (names.contains(name)) {
            throw UsageError{CommandLine::tr("--tolerance gives %1 twice: keep one of them.").arg(name)};
        }
        names += name;
        const double tolerance = parseNumber("tolerance", part.section('=', 1), kMillimetre, 0.0);
        if (tolerance >= length->bound) {
            throw UsageError{
                CommandLine::tr("--tolerance: the tolerance of %1 must be smaller than %1 = %2 mm, not \"%3\".")
                    .arg(name, typedNumberText(length->bound), part.section('=', 1))};
        }
        tolerances.*length->tolerance = tolerance;
    }
    return tolerances;
}

/// Equally spaced values of a parameter.
struct ParameterValues {
    Parameter parameter;
    double first; ///< mm, rad or rad/s
    double last;
    int count;
};

/// Reads --vary, such as "b=50..120", and --count.
ParameterValues readVariation(const OptionReader &options)
{
    static const QRegularExpression syntax("^(\\w+)=(.*[^.])\\.\\.([^.].*)$"); // not 5...7, which may be 5 to .7
    const QRegularExpressionMatch match = syntax.match(options.text("vary"));
    const auto parameter =
        std::ranges::find(kAllParameters, match.captured(1), [](Parameter each) { return QString(optionName(each)); });
    if (match.hasMatch() && parameter == kAllParameters.end()) {
        throw UsageError{CommandLine::tr("--vary: \"%1\" is no parameter: choose a, b, c, omega2 or theta20.")
                             .arg(match.captured(1))};
    }
    if (!match.hasMatch()) {
        throw UsageError{CommandLine::tr("--vary must be a parameter and a range of its values, such as b=50..120, not "
                                         "\"%1\".")
                             .arg(options.text("vary"))};
    }
    options.refuseIfGiven({optionName(*parameter)},
                          CommandLine::tr("--vary sets the values of this parameter: remove %1."));
    const double first = parseParameter("vary", match.captured(2), *parameter);
    const double last = parseParameter("vary", match.captured(3), *parameter);
    const int count = options.integer("count", 100, 1, 100'000);
    return {.parameter = *parameter, .first = first, .last = last, .count = count};
}

/// Returns a row for each value of the varied parameter: the value, then the limits by their names. If a peak occurs at
/// several crank angles, the row contains the value at the first of them.
std::vector<Record> varyLimits(Parameters parameters, const ParameterValues &variation, const Units &units)
{
    const auto &[parameter, first, last, count] = variation;
    const bool isLength = parameter == Parameter::A || parameter == Parameter::B || parameter == Parameter::C;
    std::vector<Record> rows;
    for (int i = 0; i < count; ++i) {
        const double value = first + (count > 1 ? static_cast<double>(i) / (count - 1) : 0.0) * (last - first);
        valueOf(parameters, parameter) = value;
        const Mechanism varied(parameters);
        const std::vector<Limit> limits = findLimits(varied, motionLimits(varied));
        Record row{{optionName(parameter), isLength ? shownValue(Measure::Length, value, units) : value}};
        for (const LimitDescription &limit : kLimitDescriptions) {
            if (!limit.key.empty()) {
                const double shown = shownValue(limit.measure, valueOf(limits, limit.kind), units);
                row.emplace_back(keyText(limit.kind), jsonNumber(shown));
            }
        }
        rows.push_back(row);
    }
    return rows;
}

/// What --design asks for.
struct DesignOption {
    DesignRequest request;
    bool findsOffset = false; ///< only a time ratio is given: c is to be found for the given a and b
};

/// Reads --design, such as "stroke=80,time-ratio=1.2,transmission-angle=40", or "time-ratio=1.2".
DesignOption readDesign(const OptionReader &options)
{
    DesignRequest request;
    QStringList keys;
    bool isKnown = true;
    for (const QString &part : options.text("design").split(',')) {
        const QString key = part.section('=', 0, 0).trimmed();
        isKnown = isKnown && !keys.contains(key);
        keys += key;
        const QString value = part.section('=', 1);
        if (key == u"stroke") {
            request.stroke = parseNumber("design stroke", value, kMillimetre, kShortestLink);
        } else if (key == u"time-ratio") {
            request.timeRatio = parseNumber("design time-ratio", value, {}, kShortestLink);
        } else if (key == u"transmission-angle") {
            request.transmissionAngle =
                parseNumber("design transmission-angle", value, kDegree, kShortestLink) / kDegreesPerRadian;
        } else {
            isKnown = false;
        }
    }
    const bool findsOffset = keys == QStringList("time-ratio");
    if (!isKnown || !(request.stroke > 0.0 || findsOffset)) {
        throw UsageError{
            CommandLine::tr("--design must be a list such as stroke=80,time-ratio=1.2,transmission-angle=40, or "
                            "time-ratio=1.2 beside --a and --b, not \"%1\".")
                .arg(options.text("design"))};
    }
    return {.request = request, .findsOffset = findsOffset};
}

/// Returns the mechanism with the lengths that --design asks for. The other parameters are those of the options.
Mechanism designMechanism(const OptionReader &options, Parameters parameters)
{
    const auto [request, findsOffset] = readDesign(options);
    if (findsOffset) {
        options.refuseIfGiven({"c", "vary"}, CommandLine::tr("--design time-ratio computes c: remove %1."));
        if (!options.has("a") || !options.has("b")) {
            throw UsageError{
                CommandLine::tr("--design time-ratio needs a stroke, such as stroke=80, or the lengths --a and --b.")};
        }
    } else {
        options.refuseIfGiven({"a", "b", "c", "vary"}, CommandLine::tr("--design computes a, b and c: remove %1."));
    }
    const std::variant<Lengths, DesignFault> designed =
        findsOffset ? designOffset(parameters.a, parameters.b, request.timeRatio) : design(request);
    if (const DesignFault *fault = std::get_if<DesignFault>(&designed)) {
        throw UsageError{designFaultText(*fault, request), ExitStatus::NotAssemblable};
    }
    const Lengths &lengths = std::get<Lengths>(designed);
    parameters.a = lengths.a;
    parameters.b = lengths.b;
    parameters.c = lengths.c;
    return Mechanism(parameters);
}

} // namespace

ExitStatus limitsCommand(const OptionReader &options, const Streams &streams)
{
    const Request request(options);
    const Units units = readUnits(options);
    setNotation(
        {.symbols = options.choice("notation", Symbols::AbsoluteCoordinates), .units = units}); // used by the sentences
    options.refuseFiles();
    Mechanism mechanism = request.mechanism;
    QString design;
    if (options.has("design")) {
        mechanism = designMechanism(options, mechanism.parameters());
        design = mechanismText(mechanism, kMechanismDigits) + '\n';
    }
    if (options.has("vary")) {
        options.refuseIfGiven({"tolerance"},
                              CommandLine::tr("--vary prints values without their tolerances: remove %1."));
        const std::vector<Record> rows = varyLimits(mechanism.parameters(), readVariation(options), units);
        return request.write(streams,
                             {.text = csvText(rows), .rows = rows, .json = {{"rows", jsonList(rows, jsonObject)}}});
    }
    options.refuseIfGiven({"count"}, CommandLine::tr("%1 applies to --vary only: remove it."));
    PrintedLimits list(mechanism, units);
    if (options.has("tolerance")) {
        list.ranges = limitRanges(mechanism, readTolerances(options, mechanism));
    }
    const QString sentence = mobilitySentence(mechanism, list.motion);
    const std::vector<Record> rows = list.records();
    CommandOutput output{.rows = rows,
                         .json = {{"mechanism", toJson(mechanism.parameters())},
                                  {"mobility", wordFor(list.motion.mobility)},
                                  {"reason", sentence},
                                  {"limits", jsonList(rows, jsonObject)}}};
    if (list.motion.mobility == Mobility::Impossible) {
        streams.report(sentence);
        output.status = ExitStatus::NotAssemblable;
    } else {
        output.text = design + sentence + '\n' + list.table();
    }
    return request.write(streams, output);
}

} // namespace slidercrank
