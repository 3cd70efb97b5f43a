// SPDX-License-Identifier: GPL-3.0-or-later

// `slidercrank limits`: prints dead centres, stroke, time ratio, transmission angle and peak values. --vary prints how
// they depend on one parameter; --design finds the mechanism with a given stroke and time ratio.

#include "app/commands.h"
#include "app/option_groups.h"
#include "app/output.h"
#include "app/records.h"
#include "core/import/quantity.h"
#include "core/limits/design.h"
#include "core/limits/extremes.h"
#include "core/limits/mobility.h"
#include "core/sampling/crank_time.h"
#include "ui/document/settings_fields.h"
#include "ui/text/design_text.h"
#include "ui/text/finding_text.h"
#include "ui/text/motion_facts.h"
#include "ui/text/quantity_text.h"

#include <QJsonArray>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace slidercrank
{

namespace
{

/// The values of one parameter, from `from` to `to`.
struct Variation {
    Parameter parameter = Parameter::B;
    double from = 0.0;
    double to = 0.0;
    int count = 100;
};

/// Names in JSON, by Mobility.
constexpr std::array kMobilityNames{"full-turn", "rocker", "locked", "impossible"};

/// Returns the crank angle in degrees, within [0, 360).
double degreesFromZero(double theta2)
{
    constexpr double kRounding = 1e-9; // 0 may have been computed as slightly less
    const double angle = kDegreesPerRadian * theta2;
    return angle < -kRounding ? angle + 360.0 : std::max(angle, 0.0);
}

std::optional<double> degrees(std::optional<double> radians)
{
    return radians ? std::optional(kDegreesPerRadian * *radians) : std::nullopt;
}

std::optional<double> quotient(std::optional<double> dividend, std::optional<double> divisor)
{
    return dividend && divisor && *divisor > 0.0 ? std::optional(*dividend / *divisor) : std::nullopt;
}

/// Returns all limits in the order of the contract. A limit that does not exist has no value.
std::vector<Record> listLimits(const Mechanism &mechanism, const MotionLimits &limits)
{
    std::vector<Record> list;
    const auto add = [&](const char *name, const char *unit, std::optional<double> value,
                         std::optional<double> theta2 = {}) {
        const std::optional<double> time = theta2 ? timeAtCrankAngle(mechanism, *theta2, 0.0) : std::nullopt;
        list.push_back({{"name", name},
                        {"value", jsonNumber(value)},
                        {"unit", unit},
                        {"theta2", theta2 ? jsonNumber(degreesFromZero(*theta2)) : QJsonValue()},
                        {"time", jsonNumber(time)}});
    };
    const auto addDeadCentre = [&add](const char *name, const std::optional<DeadCentre> &deadCentre) {
        add(name, "mm", deadCentre ? std::optional(deadCentre->R4x) : std::nullopt,
            deadCentre ? std::optional(deadCentre->theta2) : std::nullopt);
    };
    // Adds a row for each crank angle at which the peak is reached. The value has the sign of the motion there.
    const std::vector<Peak> peaks = motionPeaks(mechanism);
    const auto addPeaks = [&](const char *name, const char *unit, Channel channel) {
        const auto peak = std::ranges::find(peaks, channel, &Peak::channel);
        if (peak == peaks.end() || peak->places.empty()) {
            add(name, unit, peak == peaks.end() ? std::nullopt : std::optional(toFileUnit(channel, peak->magnitude)));
            return;
        }
        std::vector<PeakPlace> places = peak->places;
        std::ranges::sort(places, {}, [](const PeakPlace &place) { return degreesFromZero(place.theta2); });
        for (const PeakPlace &place : places) {
            add(name, unit, toFileUnit(channel, place.value), place.theta2);
        }
    };
    const double speed = std::abs(mechanism.omega2());
    const std::optional<double> forwardTime = quotient(limits.angleOutwards, speed);
    const std::optional<double> returnTime = quotient(limits.angleInwards, speed);
    addDeadCentre("outer-dead-centre", limits.outer);
    addDeadCentre("inner-dead-centre", limits.inner);
    add("stroke", "mm", limits.stroke);
    add("forward-angle", "°", degrees(limits.angleOutwards));
    add("return-angle", "°", degrees(limits.angleInwards));
    add("forward-time", "s", forwardTime);
    add("return-time", "s", returnTime);
    add("time-ratio", "", limits.timeRatio);
    if (limits.mobility == Mobility::Impossible) {
        add("least-transmission-angle", "°", {});
    } else {
        add("least-transmission-angle", "°", 90.0 - kDegreesPerRadian * limits.largestPressureAngle,
            limits.largestPressureAngleAt);
    }
    add("mean-forward-speed", "mm/s", quotient(limits.stroke, forwardTime));
    add("mean-return-speed", "mm/s", quotient(limits.stroke, returnTime));
    addPeaks("peak-slider-speed", "mm/s", {R4x, Order::Velocity});
    addPeaks("peak-slider-acceleration", "mm/s²", {R4x, Order::Acceleration});
    addPeaks("peak-coupler-speed", "°/s", {Theta3, Order::Velocity});
    addPeaks("peak-coupler-acceleration", "°/s²", {Theta3, Order::Acceleration});
    return list;
}

/// Returns the content of the tab "Motion limits" for one revolution.
QString textLimits(const Mechanism &mechanism, const MotionLimits &limits)
{
    Sampling revolution;
    if (mechanism.omega2() != 0.0) {
        revolution.duration = 2.0 * std::numbers::pi / std::abs(mechanism.omega2());
    }
    std::vector<MotionFact> facts = positionFacts(mechanism, limits, revolution);
    std::ranges::move(peakFacts(mechanism, limits, motionPeaks(mechanism), revolution), std::back_inserter(facts));
    std::vector<QStringList> rows;
    for (const MotionFact &fact : facts) {
        QString place;
        if (fact.theta2) {
            place = CommandLine::tr("at θ₂ = %1°").arg(QString::number(degreesFromZero(*fact.theta2), 'f', 2));
        }
        if (fact.time) {
            place += CommandLine::tr(", t = %1 s").arg(secondsText(*fact.time, revolution.duration));
        }
        rows.push_back({fact.name, fact.value, place + (fact.remark.isEmpty() ? "" : ' ' + fact.remark)});
    }
    return mobilitySentence(mechanism, limits) + '\n' + alignedTable(rows, {false, true, false});
}

/// Returns a row for each value of the parameter: the value, then the limits by their names. Of several equal peaks the
/// row has the first.
std::vector<Record> varyLimits(const Mechanism &mechanism, const Variation &variation)
{
    std::vector<Record> rows;
    for (int i = 0; i < variation.count; ++i) {
        const double part = variation.count > 1 ? static_cast<double>(i) / (variation.count - 1) : 0.0;
        Parameters parameters = mechanism.parameters();
        double &value = valueOf(parameters, variation.parameter);
        value = variation.from + part * (variation.to - variation.from);
        Record row{{wordOf(variation.parameter), value}};
        const Mechanism varied(parameters);
        for (const Record &limit : listLimits(varied, motionLimits(varied))) {
            const QString name = limit[0].second.toString();
            if (row.back().first != name) {
                row.emplace_back(name, limit[1].second);
            }
        }
        rows.push_back(row);
    }
    return rows;
}

/// Reads --vary, such as "b=50..120".
Variation readVariation(const OptionReader &options, const Mechanism &mechanism)
{
    const QString text = options.text("vary");
    const QString name = text.section('=', 0, 0);
    const QStringList ends = text.section('=', 1).split("..");
    Variation variation;
    const auto parameter =
        std::ranges::find_if(kParameters, [&](Parameter each) { return name == QLatin1String(wordOf(each)); });
    if (parameter == kParameters.end() || ends.size() != 2) {
        throw UsageError{
            CommandLine::tr("--vary must name a parameter and its range, such as b=50..120, not \"%1\".").arg(text)};
    }
    variation.parameter = *parameter;
    const Quantity from = readQuantity(ends[0], defaultUnit(*parameter), QLocale::c());
    const Quantity to = readQuantity(ends[1], defaultUnit(*parameter), QLocale::c());
    for (const Quantity &end : {from, to}) {
        Parameters parameters = mechanism.parameters();
        valueOf(parameters, *parameter) = end.value;
        if (end.fault || findFault(parameters)) {
            throw UsageError{CommandLine::tr("--vary: \"%1\" is not a range of valid values of %2.")
                                 .arg(text.section('=', 1), name)};
        }
    }
    variation.from = from.value;
    variation.to = to.value;
    variation.count = options.integer("count", variation.count, 1, 1'000'000);
    return variation;
}

/// Reads --design, such as "stroke=80,time-ratio=1.2,transmission-angle=40".
DesignRequest readDesign(const OptionReader &options)
{
    DesignRequest request;
    bool isValid = true;
    for (const QString &part : options.text("design").split(',')) {
        const QString key = part.section('=', 0, 0).trimmed();
        const QString text = part.section('=', 1);
        Quantity quantity;
        if (key == u"stroke") {
            quantity = readQuantity(text, kMillimetre, QLocale::c());
            request.stroke = quantity.value;
        } else if (key == u"time-ratio") {
            quantity = readQuantity(text, {}, QLocale::c());
            request.timeRatio = quantity.value;
        } else if (key == u"transmission-angle") {
            quantity = readQuantity(text, kDegree, QLocale::c());
            request.transmissionAngle = quantity.value / kDegreesPerRadian;
        }
        isValid = isValid && !quantity.fault && quantity.value > 0.0;
    }
    if (!isValid || !(request.stroke > 0.0)) {
        throw UsageError{
            CommandLine::tr("--design must be such as stroke=80,time-ratio=1.2,transmission-angle=40, not \"%1\".")
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
    Mechanism mechanism = readMechanism(options);
    const Format format = readFormat(options, Format::Text);
    const QString output = readOutput(options);
    options.refuseFiles();
    if (options.has("design")) {
        options.refuse({"a", "b", "c", "vary"}, CommandLine::tr("--design computes a, b and c: remove %1."));
        mechanism = designMechanism(readDesign(options), mechanism.parameters());
    }
    std::optional<Variation> variation;
    if (options.has("vary")) {
        variation = readVariation(options, mechanism);
        if (format == Format::Text) {
            throw UsageError{CommandLine::tr("--vary writes a table: add --format csv or --format json.")};
        }
    } else if (options.has("count")) {
        throw UsageError{CommandLine::tr("--count belongs to --vary: remove it.")};
    }
    const EnglishTexts english(format != Format::Text);
    if (variation) {
        const std::vector<Record> rows = varyLimits(mechanism, *variation);
        return writeOutput(streams, output,
                           format == Format::Csv ? csvText(rows)
                                                 : jsonDocument({{"rows", jsonList(rows, jsonObject)}}));
    }
    const MotionLimits limits = motionLimits(mechanism);
    const std::vector<Record> list = listLimits(mechanism, limits);
    QByteArray bytes;
    if (format == Format::Csv) {
        bytes = csvText(list);
    } else if (format == Format::Json) {
        bytes = jsonDocument({{"mechanism", toJson(mechanism.parameters())},
                              {"mobility", kMobilityNames[static_cast<std::size_t>(limits.mobility)]},
                              {"reason", mobilitySentence(mechanism, limits)},
                              {"limits", jsonList(list, jsonObject)}});
    } else {
        const QString design = options.has("design") ? mechanismText(mechanism, 9) + '\n' : QString();
        bytes = (design + textLimits(mechanism, limits)).toUtf8();
    }
    const bool isImpossible = limits.mobility == Mobility::Impossible;
    return moreSevere(writeOutput(streams, output, bytes),
                      isImpossible ? ExitStatus::NotAssemblable : ExitStatus::Success);
}

} // namespace slidercrank
