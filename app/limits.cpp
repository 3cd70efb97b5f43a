// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/subcommands.h"

#include "app/json_text.h"
#include "app/output.h"
#include "core/limits/extremes.h"
#include "core/limits/mobility.h"
#include "core/sampling/crank_instant.h"
#include "ui/text/finding_text.h"
#include "ui/text/motion_facts.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string_view>
#include <vector>

namespace slidercrank
{

namespace
{

/// One of the contract's, whether it exists or not.
struct Limit {
    std::string_view name;
    std::string_view unit;
    std::optional<double> value = {};
    std::optional<double> theta2 = {}; ///< rad
};

QByteArray bytesOf(std::string_view text)
{
    return QByteArray(text.data(), static_cast<qsizetype>(text.size()));
}

const char *wordFor(Mobility mobility)
{
    switch (mobility) {
    case Mobility::FullTurn: return "full-turn";
    case Mobility::Rocker: return "rocker";
    case Mobility::Locked: return "locked";
    case Mobility::Impossible: return "impossible";
    }
    return "";
}

Limit limitAt(std::string_view name, const std::optional<DeadCentre> &centre)
{
    return centre ? Limit{name, "mm", centre->R4x, centre->theta2} : Limit{name, "mm"};
}

/// From 0 up to 360°.
double degreesOf(double theta2)
{
    constexpr double kZero = 1e-9; // 0 itself may have come out a little less
    const double degrees = kDegreesPerRadian * theta2;
    return degrees < -kZero ? degrees + 360.0 : std::max(degrees, 0.0);
}

Limit limitOf(std::string_view name, const std::vector<Peak> &peaks, Channel channel)
{
    Limit limit{name, fileUnit(channel)};
    const auto peak = std::ranges::find(peaks, channel, &Peak::channel);
    if (peak != peaks.end()) {
        limit.value = toFileUnit(channel, peak->magnitude);
        const auto first =
            std::ranges::min_element(peak->places, {}, [](const PeakPlace &place) { return degreesOf(place.theta2); });
        limit.theta2 = first == peak->places.end() ? std::nullopt : std::optional(first->theta2);
    }
    return limit;
}

std::vector<Limit> limitsOf(const Mechanism &mechanism, const MotionLimits &limits, const std::vector<Peak> &peaks)
{
    const double speed = std::abs(mechanism.omega2());
    const auto degrees = [](const std::optional<double> &angle) {
        return angle ? std::optional(kDegreesPerRadian * *angle) : std::nullopt;
    };
    const auto seconds = [speed](const std::optional<double> &angle) {
        return angle && speed > 0.0 ? std::optional(*angle / speed) : std::nullopt;
    };
    const auto meanSpeed = [&](const std::optional<double> &angle) {
        return angle && limits.stroke && speed > 0.0 ? std::optional(*limits.stroke * speed / *angle) : std::nullopt;
    };
    Limit transmission{"least-transmission-angle", "°"};
    if (limits.mobility != Mobility::Impossible) {
        transmission.value = 90.0 - kDegreesPerRadian * limits.largestPressureAngle;
        transmission.theta2 = limits.largestPressureAngleAt;
    }
    return {limitAt("outer-dead-centre", limits.outer),
            limitAt("inner-dead-centre", limits.inner),
            {"stroke", "mm", limits.stroke},
            {"forward-angle", "°", degrees(limits.angleOutwards)},
            {"return-angle", "°", degrees(limits.angleInwards)},
            {"forward-time", "s", seconds(limits.angleOutwards)},
            {"return-time", "s", seconds(limits.angleInwards)},
            {"time-ratio", "", limits.timeRatio},
            transmission,
            {"mean-forward-speed", "mm/s", meanSpeed(limits.angleOutwards)},
            {"mean-return-speed", "mm/s", meanSpeed(limits.angleInwards)},
            limitOf("peak-slider-speed", peaks, {R4x, Order::Velocity}),
            limitOf("peak-slider-acceleration", peaks, {R4x, Order::Acceleration}),
            limitOf("peak-coupler-speed", peaks, {Theta3, Order::Velocity}),
            limitOf("peak-coupler-acceleration", peaks, {Theta3, Order::Acceleration})};
}

/// The crank's angle, and when it first comes there.
struct Place {
    QByteArray theta2;
    QByteArray time;
};

Place placeOf(const Limit &limit, const Mechanism &mechanism)
{
    if (!limit.theta2) {
        return {"null", "null"};
    }
    const double theta2 = degreesOf(*limit.theta2);
    return {jsonNumber(theta2), jsonNumber(instantAtCrankAngle(mechanism, *limit.theta2, 0.0))};
}

QByteArray jsonOf(const Mechanism &mechanism, Mobility mobility, const QString &reason, const std::vector<Limit> &list)
{
    QByteArray json = "{\"mechanism\":" + jsonMechanism(mechanism) + ",\"mobility\":\"" + wordFor(mobility) +
                      "\",\"reason\":" + jsonString(reason) + ",\"limits\":[";
    const char *separator = "";
    for (const Limit &limit : list) {
        const Place place = placeOf(limit, mechanism);
        json += QByteArray(separator) + "{\"name\":\"" + bytesOf(limit.name) +
                "\",\"value\":" + jsonNumber(limit.value) + ",\"unit\":\"" + bytesOf(limit.unit) +
                "\",\"theta2\":" + place.theta2 + ",\"time\":" + place.time + '}';
        separator = ",";
    }
    return json + "]}\n";
}

QByteArray csvOf(const Mechanism &mechanism, const std::vector<Limit> &list)
{
    QByteArray csv = "name,value,unit,theta2,time\n";
    for (const Limit &limit : list) {
        const Place place = placeOf(limit, mechanism);
        csv += bytesOf(limit.name) + ',' + jsonNumber(limit.value) + ',' + bytesOf(limit.unit) + ',' + place.theta2 +
               ',' + place.time + '\n';
    }
    return csv.replace("null", "");
}

/// What the Motion limits tab says of one turn.
QString textOf(const Mechanism &mechanism, const MotionLimits &limits, const std::vector<Peak> &peaks)
{
    Sampling turn;
    if (mechanism.omega2() != 0.0) {
        turn.duration = 2.0 * std::numbers::pi / std::abs(mechanism.omega2());
    }
    std::vector<MotionFact> facts = positionFacts(mechanism, limits, turn);
    std::ranges::move(peakFacts(mechanism, limits, peaks, turn), std::back_inserter(facts));
    qsizetype nameWidth = 0;
    qsizetype valueWidth = 0;
    for (const MotionFact &fact : facts) {
        nameWidth = std::max(nameWidth, fact.name.size());
        valueWidth = std::max(valueWidth, fact.value.size());
    }
    QString text = mobilitySentence(mechanism, limits) + u'\n';
    for (const MotionFact &fact : facts) {
        QString line =
            fact.name.leftJustified(nameWidth) + QStringLiteral("  ") + fact.value.rightJustified(valueWidth);
        if (fact.theta2) {
            line += QStringLiteral("  ") +
                    CommandLine::tr("at θ₂ = %1°").arg(QString::number(degreesOf(*fact.theta2), 'f', 2));
        }
        if (fact.instant) {
            line += CommandLine::tr(", t = %1 s").arg(secondsText(*fact.instant, turn.duration));
        }
        text += line + (fact.remark.isEmpty() ? QString() : QStringLiteral("  ") + fact.remark) + u'\n';
    }
    return text;
}

} // namespace

ExitStatus limits(const LimitsOptions &options)
{
    Output output(options.output);
    if (!output.open()) {
        return ExitStatus::FileFailed;
    }
    const Mechanism &mechanism = options.mechanism;
    const MotionLimits found = motionLimits(mechanism);
    const std::vector<Peak> peaks = motionPeaks(mechanism);
    const std::vector<Limit> list = limitsOf(mechanism, found, peaks);
    switch (options.format) {
    case Format::Text: output.write(textOf(mechanism, found, peaks).toUtf8()); break;
    case Format::Csv: output.write(csvOf(mechanism, list)); break;
    case Format::Json: {
        const InEnglish english;
        output.write(jsonOf(mechanism, found.mobility, mobilitySentence(mechanism, found), list));
        break;
    }
    }
    const ExitStatus written = output.finish();
    return written == ExitStatus::Done && found.mobility == Mobility::Impossible ? ExitStatus::NotAssemblable : written;
}

} // namespace slidercrank
