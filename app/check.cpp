// SPDX-License-Identifier: GPL-3.0-or-later

// `slidercrank check`: compares numbers of a calculation by hand with the exact ones, and names the slip that gives
// them.

#include "core/check/check.h"
#include "app/answer.h"
#include "app/commands.h"
#include "app/time_step_report.h"
#include "core/check/written_value.h"
#include "core/import/cells.h"
#include "ui/document/settings_fields.h"
#include "ui/text/check_text.h"
#include "ui/text/finding_text.h"
#include "ui/text/quantity_text.h"
#include "ui/text/written_number.h"

#include <QJsonArray>

#include <algorithm>

namespace slidercrank
{

namespace
{

constexpr Unit kRadianPerSecondSquared{Dimension::Angle, 2, kDegreesPerRadian};

/// A value as it was typed: "omega3=5.42rad/s".
struct TypedValue {
    QString name;
    QString text; ///< behind "="
    OutputChannel channel;
    WrittenValue written; ///< in `unit`
    Unit unit;
    QString unitName;

    /// Converts to and from the units of the core (mm, rad, s).
    double toCore(double value) const { return unit.toDefault(value) / toFileUnit(measureOf(channel), 1.0); }
    double fromCore(double value) const { return toFileUnit(measureOf(channel), value) / unit.toDefault(1.0); }

    GivenValue given() const { return {channel, toCore(written.value), toCore(written.halfStep)}; }
    QString unitBehind() const { return unitName == u"°" ? unitName : ' ' + unitName; }
};

TypedValue readValue(const QString &argument)
{
    TypedValue typed;
    typed.name = argument.section('=', 0, 0).trimmed();
    typed.text = argument.section('=', 1).simplified();
    if (!argument.contains('=')) {
        throw UsageError{
            CommandLine::tr("A value must be a name, = and a number, such as x=9.74 or theta3=-154deg, not "
                            "\"%1\".")
                .arg(argument)};
    }
    const std::optional<OutputChannel> channel = quantityNamed(typed.name.toStdString());
    if (!channel) {
        throw UsageError{CommandLine::tr("\"%1\" is no quantity: choose x, v, a, theta3, omega3, alpha3, displacement, "
                                         "mu, or a channel of \"slidercrank solve\".")
                             .arg(typed.name)};
    }
    typed.channel = *channel;
    const bool isAngular = measureOf(*channel) != lengthMeasure(orderOf(*channel));
    typed.unit = {isAngular ? Dimension::Angle : Dimension::Length, static_cast<int>(orderOf(*channel)), 1.0};
    typed.unitName = unitText(Channel{isAngular ? Theta3 : R4x, orderOf(*channel)});
    const std::string text = typed.text.toStdString();
    if (const std::optional<QuantityFault> fault = readWrittenValue(text, typed.unit).fault) {
        throw UsageError{QString("%1: %2").arg(typed.name, quantityFaultText(typed.text, *fault, typed.unit))};
    }
    if (const std::string_view unit = splitUnit(text).unit; !unit.empty()) {
        typed.unit = parseUnit(unit).value_or(typed.unit);
        typed.unitName = QString::fromUtf8(unit.data(), static_cast<qsizetype>(unit.size()));
    }
    typed.written = readWrittenValue(text, typed.unit);
    return typed;
}

std::vector<TypedValue> readValues(const OptionReader &options)
{
    std::vector<TypedValue> values;
    for (const QString &argument : options.files()) {
        values.push_back(readValue(argument));
        if (std::ranges::count(values, values.back().channel, &TypedValue::channel) > 1) {
            throw UsageError{CommandLine::tr("%1 is given more than once: keep one of them.").arg(values.back().name)};
        }
    }
    if (values.empty()) {
        throw UsageError{CommandLine::tr("Give the values to be checked, such as x=9.74 v=45.1.")};
    }
    return values;
}

/// Reads the position of the mechanism, at which --at-angle sets the crank.
CrankPosition readPosition(const OptionReader &options, const Mechanism &mechanism)
{
    const double degrees =
        options.number("at-angle", mechanism.theta20() * kDegreesPerRadian, kDegree, -kLargestParameter);
    return {withCrankAt(mechanism, degrees / kDegreesPerRadian),
            options.number("alpha2", 0.0, kRadianPerSecondSquared)};
}

/// Returns a line for each value: name, given and exact value, verdict.
QString valueTable(const std::vector<TypedValue> &values, const CheckResult &result)
{
    std::vector<QStringList> rows;
    QStringList verdicts;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const TypedValue &typed = values[i];
        const CheckedValue &checked = result.values[i];
        const double deviation = typed.fromCore(checked.deviation);
        const QString exact =
            shortNumber(typed.written.value - deviation, std::clamp(typed.written.digits + 1, 4, 17)) +
            typed.unitBehind();
        rows.push_back({typed.name, typed.text, CommandLine::tr("exact: %1").arg(exact)});
        verdicts += checkedValueText(checked, typed.written.digits, deviation, typed.unitBehind());
    }
    const QStringList lines = alignedTable(rows).split('\n');
    QString table;
    for (qsizetype i = 0; i < verdicts.size(); ++i) {
        table += lines[i] + "  " + verdicts[i] + '\n';
    }
    return table;
}

QJsonObject valueJson(const TypedValue &typed, const CheckedValue &checked)
{
    const double deviation = typed.fromCore(checked.deviation);
    return {{"name", typed.name},
            {"given", typed.written.value},
            {"exact", jsonNumber(typed.written.value - deviation)},
            {"deviation", jsonNumber(deviation)},
            {"unit", typed.unitName},
            {"digits", typed.written.digits},
            {"verdict", checked.isRight ? "right" : "wrong"},
            {"convention", checked.isMeasuredAtB ? QJsonValue("measured-at-B") : QJsonValue()}};
}

} // namespace

ExitStatus checkCommand(const OptionReader &options, const Streams &streams)
{
    const Question question(options);
    const CrankPosition position = readPosition(options, question.mechanism);
    const std::vector<TypedValue> values = readValues(options);
    std::vector<GivenValue> given;
    for (const TypedValue &typed : values) {
        given.push_back(typed.given());
    }
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
    Answer answer{.text = valueTable(values, result) + (conclusion.isEmpty() ? conclusion : conclusion + '\n'),
                  .json = {{"mechanism", toJson(question.mechanism.parameters())},
                           {"values", valuesJson},
                           {"slip", result.explanation == CheckOutcome::Named ? candidates.first() : QJsonValue()},
                           {"candidates", candidates},
                           {"conclusion", jsonText(conclusion)}}};
    const SamplingSummary summary = sample(position.mechanism, {0.0}, ChannelSet(), {}).summary;
    answer.status = reportTimeSteps(streams, summary, position.mechanism, {});
    if (!wrongNames.isEmpty()) {
        answer.status = moreSevere(answer.status, ExitStatus::Differs);
    }
    return question.write(streams, answer);
}

} // namespace slidercrank
