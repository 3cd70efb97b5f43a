// SPDX-License-Identifier: GPL-3.0-or-later

// `slidercrank check`: compares numbers of a calculation by hand with the exact ones, and names the slip that gives
// them.

#include "core/check/check.h"
#include "app/command_output.h"
#include "app/commands.h"
#include "app/positions.h"
#include "app/time_step_report.h"
#include "ui/document/settings_fields.h"
#include "ui/text/check_text.h"
#include "ui/text/typed_value.h"

#include <QJsonArray>

#include <algorithm>

namespace slidercrank
{

namespace
{

/// A value with its name, such as "omega3=5.42rad/s".
struct NamedValue {
    QString name;
    TypedValue typed;
};

NamedValue readValue(const OptionReader &options, const QString &argument)
{
    const QString name = argument.section('=', 0, 0).trimmed();
    if (!outputChannelNamed(name.toStdString())) {
        options.refuseOptionWithoutDashes(argument);
    }
    if (!argument.contains('=')) {
        throw UsageError{
            CommandLine::tr("A value must be a name, = and a number, such as x=9.74 or theta3=-154deg, not "
                            "\"%1\".")
                .arg(argument)};
    }
    const OutputChannel channel = parseOutputChannel(name);
    const QString number = argument.section('=', 1);
    if (number.trimmed().isEmpty()) {
        throw UsageError{
            CommandLine::tr("%1 has no value: write it after the = without a space, such as %1=9.74.").arg(name)};
    }
    const TypedValue typed = readTypedValue(number, channel, readUnits(options));
    if (typed.parsed.fault) {
        throw UsageError{QString("%1: %2").arg(name, faultText(typed))};
    }
    return {name, typed};
}

std::vector<NamedValue> readValues(const OptionReader &options, const CrankPosition &position)
{
    const Units units = readUnits(options);
    std::vector<NamedValue> values;
    for (const QString &argument : options.files()) {
        values.push_back(readValue(options, argument));
        const auto channelOf = [](const NamedValue &other) { return other.typed.channel; };
        if (std::ranges::count(values, channelOf(values.back()), channelOf) > 1) {
            throw UsageError{CommandLine::tr("%1 is given more than once: keep one of them.").arg(values.back().name)};
        }
    }
    if (values.empty()) {
        throw UsageError{CommandLine::tr("Give the values to be checked, such as x=9.74 v=45.1.")};
    }
    std::vector<TypedValue> typed(values.size());
    std::ranges::transform(values, typed.begin(), &NamedValue::typed);
    typed = inLikelyUnits(std::move(typed), position, units);
    for (std::size_t i = 0; i < values.size(); ++i) {
        values[i].typed = typed[i];
    }
    return values;
}

/// Reads the position of the mechanism, at which --at-angle sets the crank.
CrankPosition readPosition(const OptionReader &options, const Mechanism &mechanism)
{
    const double degrees =
        options.number("at-angle", mechanism.theta20() * kDegreesPerRadian, kDegree, -kLargestParameter);
    return {withCrankAt(mechanism, degrees / kDegreesPerRadian), readCrankAcceleration(options)};
}

/// Returns a line for each value: name, given and exact value, verdict.
QString valueTable(const std::vector<NamedValue> &values, const CheckResult &result)
{
    std::vector<QStringList> rows;
    QStringList verdicts;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const auto &[name, typed] = values[i];
        rows.push_back({name, typed.text, exactText(typed, result.values[i])});
        verdicts += verdictText(typed, result.values[i]);
    }
    const QStringList lines = alignedLines(rows);
    QString table;
    for (qsizetype i = 0; i < verdicts.size(); ++i) {
        table += lines[i] + "  " + verdicts[i] + '\n';
    }
    return table;
}

QJsonObject valueJson(const NamedValue &value, const CheckedValue &checked)
{
    const auto &[name, typed] = value;
    const double deviation = typed.fromCore(checked.deviation);
    return {{"name", name},
            {"given", typed.parsed.value},
            {"exact", jsonNumber(typed.parsed.value - deviation)},
            {"deviation", jsonNumber(deviation)},
            {"unit", typed.unitName},
            {"digits", typed.parsed.digits},
            {"verdict", checked.isRight ? "right" : "wrong"},
            {"convention", checked.isMeasuredAtB ? QJsonValue("measured-at-B") : QJsonValue()}};
}

} // namespace

ExitStatus checkCommand(const OptionReader &options, const Streams &streams)
{
    const Request request(options);
    const CrankPosition position = readPosition(options, request.mechanism);
    const std::vector<NamedValue> values = readValues(options, position);
    std::vector<GivenValue> given(values.size());
    std::ranges::transform(values, given.begin(), [](const NamedValue &value) { return value.typed.given(); });
    const CheckResult result = check(position, given);
    QStringList wrongNames;
    QJsonArray valuesJson;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (!result.values[i].isRight) {
            wrongNames += values[i].name;
        }
        valuesJson += valueJson(values[i], result.values[i]);
    }
    const QJsonArray candidates = jsonList(result.slips, [&](Slip slip) {
        return QJsonObject{{"name", QString::fromUtf8(nameOf(slip))}, {"sentence", slipText(slip, wrongNames)}};
    });
    const QString conclusion = explanationText(result, wrongNames);
    CommandOutput output{
        .text = valueTable(values, result) + (conclusion.isEmpty() ? conclusion : conclusion + '\n'),
        .json = {{"mechanism", toJson(request.mechanism.parameters())},
                 {"values", valuesJson},
                 {"slip", result.explanation == CheckOutcome::SingleSlip ? candidates.first() : QJsonValue()},
                 {"candidates", candidates},
                 {"conclusion", jsonText(conclusion)}}};
    output.status = reportPosition(streams, result.status, position.mechanism, position.mechanism.theta20());
    if (!wrongNames.isEmpty()) {
        output.status = moreSevere(output.status, ExitStatus::Differs);
    }
    return request.write(streams, output);
}

} // namespace slidercrank
