// SPDX-License-Identifier: GPL-3.0-or-later

// `slidercrank identify`: identifies the mechanism that produced each reference file.

#include "app/commands.h"
#include "app/reference_files.h"
#include "core/identification/identification.h"
#include "core/import/crank_angles.h"
#include "ui/document/result.h"
#include "ui/document/settings_fields.h"
#include "ui/text/channel_text.h"
#include "ui/text/comparison_text.h"
#include "ui/text/convention_text.h"
#include "ui/text/identification_text.h"
#include "ui/text/parameter_text.h"

#include <QLocale>

#include <array>
#include <cmath>

namespace slidercrank
{

namespace
{

QJsonValue jsonValue(bool value)
{
    return value;
}

QJsonValue jsonValue(double value)
{
    return jsonNumber(value);
}

/// Returns a value for each parameter, by the names of the options.
template <typename Value>
QJsonObject jsonByParameter(const std::array<Value, kParameterCount> &values)
{
    QJsonObject object;
    for (const Parameter parameter : kAllParameters) {
        object.insert(QLatin1String(optionName(parameter)), jsonValue(values[indexOf(parameter)]));
    }
    return object;
}

/// Returns the values that an insufficient file determines; empty for other outcomes.
QJsonObject jsonDetermined(const Identification &found)
{
    QJsonObject values;
    for (const Parameter parameter : kAllParameters) {
        if (found.outcome == Identification::Outcome::Insufficient &&
            std::isfinite(found.standardErrors[indexOf(parameter)])) {
            values.insert(QLatin1String(optionName(parameter)), valueOf(found.parameters, parameter));
        }
    }
    return values;
}

QJsonValue jsonDrive(const std::optional<UnevenDrive> &drive)
{
    return drive ? QJsonObject{{"omega2", jsonNumber(drive->omega2)},
                               {"standardError", jsonNumber(drive->standardError)},
                               {"least", jsonNumber(drive->least)},
                               {"greatest", jsonNumber(drive->greatest)},
                               {"alpha2", jsonNumber(drive->alpha2)}}
                 : QJsonValue();
}

QJsonArray jsonResiduals(const std::vector<ColumnResidual> &residuals)
{
    return jsonList(residuals, [](const ColumnResidual &residual) {
        return QJsonObject{{"channel", columnName(residual.channel)},
                           {"rms", jsonNumber(residual.rms)},
                           {"max", jsonNumber(residual.max)},
                           {"percentOfRange", jsonNumber(residual.percentOfRange)}};
    });
}

QJsonArray jsonLeftOut(const std::vector<LeftOutColumn> &columns)
{
    return jsonList(columns, [](const LeftOutColumn &column) {
        return QJsonObject{{"channel", columnName(column.channel)},
                           {"percentOfPeak", jsonNumber(column.percentOfPeak)},
                           {"reason", reasonName(column.reason)}};
    });
}

QJsonArray jsonAlternatives(const std::vector<AlternativeMechanism> &alternatives)
{
    return jsonList(alternatives, [](const AlternativeMechanism &alternative) {
        return QJsonObject{{"mechanism", toJson(alternative.parameters)}, {"why", symmetryName(alternative.symmetry)}};
    });
}

QJsonObject jsonIdentification(const Identification &found)
{
    const auto jsonComparison = [](const ChannelComparison &channel) { return jsonObject(comparisonRecord(channel)); };
    return {{"outcome", outcomeName(found.outcome)},
            {"mechanism", jsonMechanism(found.hasMechanism(), found.parameters)},
            {"standardError", jsonByParameter(found.standardErrors)},
            {"identifiable", jsonByParameter(found.identifiable)},
            {"determined", jsonDetermined(found)},
            {"alternatives", jsonAlternatives(found.alternatives)},
            {"rounded", jsonMechanism(found.hasMechanism(), found.rounded)},
            {"drive", jsonDrive(found.drive)},
            {"followsApproximateFormula", found.followsApproximateFormula},
            {"possibleSpeeds", jsonList(found.possibleSpeeds, jsonNumber)},
            {"residuals", jsonResiduals(found.residuals)},
            {"iterations", found.iterations},
            {"conditionNumber", found.hasMechanism() ? jsonNumber(found.conditionNumber) : QJsonValue()},
            {"channels", jsonList(found.channels, jsonComparison)},
            {"conventions", jsonConventions(found.conventions)},
            {"leftOut", jsonLeftOut(found.leftOut)},
            {"excludedRows", jsonList(found.excludedRows, jsonNumber)},
            {"summary", summaryText(found)}};
}

/// Returns the options of the mechanism for another command: "--a 20 --b …".
QString optionsFor(const Parameters &parameters)
{
    QString text;
    for (const Parameter parameter : kAllParameters) {
        text += QString("--%1 %2%3 ")
                    .arg(optionName(parameter),
                         QString::number(valueOf(parameters, parameter), 'g', QLocale::FloatingPointShortest),
                         parameter == Parameter::Theta20 ? "rad" : "");
    }
    return text + (parameters.branch == Branch::Open ? "--branch open" : "--branch crossed");
}

/// Describes an identification that found a mechanism.
QString identificationText(const Reference &reference, const Identification &found)
{
    const ReferenceData &data = reference.data;
    QStringList lines{headline(reference).trimmed()};
    for (const ConventionFinding &finding : found.conventions) {
        lines += findingText(finding);
    }
    lines += summaryText(found);
    lines += roundNumbersText(found);
    if (found.outcome == Identification::Outcome::Identified && !found.drive) {
        const auto timed = data.crank ? timedBy(Mechanism(found.parameters), data) : std::nullopt;
        lines += '\n' + alignedTable(comparisonTable(found.channels, timed ? *timed : data));
        lines += summaryText(found.channels);
    } else { // the columns deviate by more than rounding, or are compared over the crank angle
        lines += '\n' + alignedTable(residualTable(found.residuals));
    }
    lines += CommandLine::tr("As options: %1").arg(optionsFor(mechanismToUse(found)));
    lines.removeAll(QString());
    return lines.join('\n') + '\n';
}

CommandOutput identifyOne(const Mechanism &mechanism, const Reference &reference, const Streams &streams)
{
    const Identification found = identify(reference.data, mechanism);
    CommandOutput output;
    output.json = jsonIdentification(found);
    if (found.hasMechanism()) {
        output.text = identificationText(reference, found);
    } else {
        output.status = ExitStatus::NotSolved;
        streams.report(displayName(reference.source.paths) + ": " + summaryText(found));
    }
    return output;
}

} // namespace

ExitStatus identifyCommand(const OptionReader &options, const Streams &streams)
{
    const ReferenceRequest references(options);
    return references.reportEach(streams, [&](const Reference &reference) {
        return identifyOne(references.request.mechanism, reference, streams);
    });
}

} // namespace slidercrank
