// SPDX-License-Identifier: GPL-3.0-or-later

// `slidercrank limits`: prints dead centres, stroke, time ratio, transmission angle and peak values. --vary prints how
// they depend on one parameter; --design finds the mechanism with a given stroke and time ratio.

#include "app/answer.h"
#include "app/commands.h"
#include "core/import/quantity.h"
#include "core/limits/design.h"
#include "core/limits/mobility.h"
#include "core/mechanism/turn.h"
#include "ui/document/settings_fields.h"
#include "ui/text/design_text.h"
#include "ui/text/finding_text.h"
#include "ui/text/motion_facts.h"

#include <QJsonArray>
#include <QRegularExpression>

#include <algorithm>
#include <array>
#include <cmath>

namespace slidercrank
{

namespace
{

/// Names in JSON, by Mobility.
constexpr std::array kMobilityNames{"full-turn", "rocker", "locked", "impossible"};

/// Returns the facts of the window's tab "Motion limits" over one revolution.
std::vector<MotionFact> findFacts(const Mechanism &mechanism, const MotionLimits &limits)
{
    Sampling revolution;
    if (mechanism.omega2() != 0.0) {
        revolution.duration = kTurn / std::abs(mechanism.omega2());
    }
    return motionFacts(mechanism, limits, revolution);
}

/// Returns a record for each limit and place. A limit that does not exist has one record without a value.
std::vector<Record> listLimits(const std::vector<MotionFact> &facts)
{
    std::vector<Record> records;
    for (const LimitDescription &limit : limitsInFiles()) {
        const auto add = [&](const MotionFact &fact) {
            records.push_back({{"name", limit.key},
                               {"value", jsonNumber(fact.number)},
                               {"unit", limit.unit},
                               {"theta2", fact.theta2 ? degreesFromZero(*fact.theta2) : QJsonValue()},
                               {"time", jsonNumber(fact.time)}});
        };
        const std::size_t before = records.size();
        for (const MotionFact &fact : facts) {
            if (fact.key == limit.key) {
                add(fact);
            }
        }
        if (records.size() == before) {
            add({.number = kNone});
        }
    }
    return records;
}

/// Reads --vary, such as "b=50..120". Returns a row for each value of the parameter: the value, then the limits by
/// their names. Of several equal peaks the row has the first.
std::vector<Record> varyLimits(const OptionReader &options, Parameters parameters)
{
    static const QRegularExpression syntax("^(\\w+)=(.+?)\\.\\.(.+)$");
    const QRegularExpressionMatch match = syntax.match(options.text("vary"));
    const auto parameter =
        std::ranges::find(kAllParameters, match.captured(1), [](Parameter each) { return QString(optionName(each)); });
    if (parameter == kAllParameters.end()) {
        throw UsageError{CommandLine::tr("--vary must be a parameter and a range of its values, such as b=50..120, not "
                                         "\"%1\".")
                             .arg(options.text("vary"))};
    }
    const double first = parseParameter("vary", match.captured(2), *parameter);
    const double last = parseParameter("vary", match.captured(3), *parameter);
    const int count = options.integer("count", 100, 1, 1'000'000);
    std::vector<Record> rows;
    for (int i = 0; i < count; ++i) {
        const double value = first + (count > 1 ? static_cast<double>(i) / (count - 1) : 0.0) * (last - first);
        valueOf(parameters, *parameter) = value;
        const Mechanism varied(parameters);
        Record row{{match.captured(1), value}};
        for (const Record &limit : listLimits(findFacts(varied, motionLimits(varied)))) {
            const QString name = limit[0].second.toString();
            if (row.back().first != name) {
                row.emplace_back(name, limit[1].second);
            }
        }
        rows.push_back(row);
    }
    return rows;
}

/// Reads --design, such as "stroke=80,time-ratio=1.2,transmission-angle=40".
DesignRequest readDesign(const OptionReader &options)
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
    if (!isKnown || !(request.stroke > 0.0)) {
        throw UsageError{
            CommandLine::tr(
                "--design must be a list such as stroke=80,time-ratio=1.2,transmission-angle=40, not \"%1\".")
                .arg(options.text("design"))};
    }
    return request;
}

/// Returns the mechanism with the lengths that the request asks for. All other parameters are those given.
Mechanism designMechanism(const DesignRequest &request, Parameters parameters)
{
    const std::variant<Lengths, DesignFault> designed = design(request);
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
    const Question question(options);
    options.refuseFiles();
    Mechanism mechanism = question.mechanism;
    QString design;
    if (options.has("design")) {
        options.refuse({"a", "b", "c", "vary"}, CommandLine::tr("--design computes a, b and c: remove %1."));
        mechanism = designMechanism(readDesign(options), mechanism.parameters());
        design = mechanismText(mechanism, 9) + '\n';
    }
    if (options.has("vary")) {
        const std::vector<Record> rows = varyLimits(options, mechanism.parameters());
        return question.write(streams,
                              {.text = csvText(rows), .rows = rows, .json = {{"rows", jsonList(rows, jsonObject)}}});
    }
    options.refuse({"count"}, CommandLine::tr("%1 applies to --vary only: remove it."));
    const MotionLimits limits = motionLimits(mechanism);
    const std::vector<MotionFact> facts = findFacts(mechanism, limits);
    const QString sentence = mobilitySentence(mechanism, limits);
    const std::vector<Record> rows = listLimits(facts);
    Answer answer{.rows = rows,
                  .json = {{"mechanism", toJson(mechanism.parameters())},
                           {"mobility", kMobilityNames[static_cast<std::size_t>(limits.mobility)]},
                           {"reason", sentence},
                           {"limits", jsonList(rows, jsonObject)}}};
    if (limits.mobility == Mobility::Impossible) {
        streams.report(sentence);
        answer.status = ExitStatus::NotAssemblable;
    } else {
        answer.text = design + sentence + '\n' + alignedTable(limitTable(facts));
    }
    return question.write(streams, answer);
}

} // namespace slidercrank
