// SPDX-License-Identifier: GPL-3.0-or-later

// `slidercrank limits`: dead centres, stroke, time ratio, transmission angle and peak values; how they depend on one parameter; and
// which mechanism has a wanted stroke and time ratio.

#include "app/commands.h"
#include "app/option_groups.h"
#include "app/output.h"
#include "app/records.h"
#include "core/import/quantity.h"
#include "core/limits/design.h"
#include "core/limits/extremes.h"
#include "core/limits/mobility.h"
#include "core/sampling/crank_instant.h"
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

/// One parameter over a range.
struct Variation {
    Parameter parameter = Parameter::B;
    double from = 0.0;
    double to = 0.0;
    int count = 100;
};

struct LimitsRequest {
    Mechanism mechanism;
    Format format = Format::Text;
    QString output;
    std::optional<Variation> variation = {};
    bool isDesigned = false; ///< the lengths are part of the answer
};

/// A limit of the contract, whether it exists or not.
struct Limit {
    const char *name;
    const char *unit;
    std::optional<double> value = {};
    std::optional<double> theta2 = {}; ///< degrees in [0, 360)
    std::optional<double> time = {};   ///< s, the first from 0 on
};

/// By Mobility.
constexpr std::array kMobilityNames{"full-turn", "rocker", "locked", "impossible"};

double degreesFromZero(double theta2)
{
    constexpr double kRounding = 1e-9; // 0 may have been computed as slightly less
    const double degrees = kDegreesPerRadian * theta2;
    return degrees < -kRounding ? degrees + 360.0 : std::max(degrees, 0.0);
}

/// All limits of one mechanism, in the order of the contract.
class LimitList
{
public:
    explicit LimitList(const Mechanism &mechanism)
        : m_mechanism(mechanism)
        , m_limits(motionLimits(mechanism))
    {
        const double speed = std::abs(mechanism.omega2());
        addDeadCentre("outer-dead-centre", m_limits.outer);
        addDeadCentre("inner-dead-centre", m_limits.inner);
        add({"stroke", "mm", m_limits.stroke});
        add({"forward-angle", "°", degrees(m_limits.angleOutwards)});
        add({"return-angle", "°", degrees(m_limits.angleInwards)});
        add({"forward-time", "s", quotient(m_limits.angleOutwards, speed)});
        add({"return-time", "s", quotient(m_limits.angleInwards, speed)});
        add({"time-ratio", "", m_limits.timeRatio});
        addTransmissionAngle();
        add({"mean-forward-speed", "mm/s", meanSpeed(m_limits.angleOutwards, speed)});
        add({"mean-return-speed", "mm/s", meanSpeed(m_limits.angleInwards, speed)});
        const std::vector<Peak> peaks = motionPeaks(mechanism);
        addPeaks("peak-slider-speed", "mm/s", peaks, {R4x, Order::Velocity});
        addPeaks("peak-slider-acceleration", "mm/s²", peaks, {R4x, Order::Acceleration});
        addPeaks("peak-coupler-speed", "°/s", peaks, {Theta3, Order::Velocity});
        addPeaks("peak-coupler-acceleration", "°/s²", peaks, {Theta3, Order::Acceleration});
    }

    const std::vector<Limit> &list() const { return m_list; }
    const MotionLimits &motion() const { return m_limits; }

private:
    static std::optional<double> degrees(std::optional<double> angle)
    {
        return angle ? std::optional(kDegreesPerRadian * *angle) : std::nullopt;
    }

    static std::optional<double> quotient(std::optional<double> angle, double speed)
    {
        return angle && speed > 0.0 ? std::optional(*angle / speed) : std::nullopt;
    }

    std::optional<double> meanSpeed(std::optional<double> angle, double speed) const
    {
        const std::optional<double> time = quotient(angle, speed);
        return time && m_limits.stroke ? std::optional(*m_limits.stroke / *time) : std::nullopt;
    }

    void add(Limit limit, std::optional<double> theta2 = {})
    {
        if (theta2) {
            limit.theta2 = degreesFromZero(*theta2);
            limit.time = instantAtCrankAngle(m_mechanism, *theta2, 0.0);
        }
        m_list.push_back(limit);
    }

    void addDeadCentre(const char *name, const std::optional<DeadCentre> &deadCentre)
    {
        if (deadCentre) {
            add({name, "mm", deadCentre->R4x}, deadCentre->theta2);
        } else {
            add({name, "mm"});
        }
    }

    void addTransmissionAngle()
    {
        const char *const name = "least-transmission-angle";
        if (m_limits.mobility == Mobility::Impossible) {
            add({name, "°"});
        } else {
            add({name, "°", 90.0 - kDegreesPerRadian * m_limits.largestPressureAngle}, m_limits.largestPressureAngleAt);
        }
    }

    /// A row for each crank angle at which the peak is reached, with the sign that the motion has there.
    void addPeaks(const char *name, const char *unit, const std::vector<Peak> &peaks, Channel channel)
    {
        const auto peak = std::ranges::find(peaks, channel, &Peak::channel);
        if (peak == peaks.end() || peak->places.empty()) {
            add({name, unit, peak == peaks.end() ? std::nullopt : std::optional(toFileUnit(channel, peak->magnitude))});
            return;
        }
        std::vector<PeakPlace> places = peak->places;
        std::ranges::sort(places, {}, [](const PeakPlace &place) { return degreesFromZero(place.theta2); });
        for (const PeakPlace &place : places) {
            add({name, unit, toFileUnit(channel, place.value)}, place.theta2);
        }
    }

    Mechanism m_mechanism;
    MotionLimits m_limits;
    std::vector<Limit> m_list;
};

const Fields<Limit> &limitFields()
{
    static const Fields<Limit> fields{
        {"name", [](const Limit &limit) { return QLatin1String(limit.name); }},
        {"value", [](const Limit &limit) { return jsonNumber(limit.value); }},
        {"unit", [](const Limit &limit) { return QString::fromUtf8(limit.unit); }},
        {"theta2", [](const Limit &limit) { return jsonNumber(limit.theta2); }},
        {"time", [](const Limit &limit) { return jsonNumber(limit.time); }},
    };
    return fields;
}

QByteArray jsonLimits(const Mechanism &mechanism, const LimitList &limits)
{
    QJsonArray array;
    for (const Limit &limit : limits.list()) {
        array += jsonRecord(limitFields(), limit);
    }
    return jsonText({{"mechanism", jsonMechanism(mechanism.parameters())},
                     {"mobility", kMobilityNames[static_cast<std::size_t>(limits.motion().mobility)]},
                     {"reason", mobilitySentence(mechanism, limits.motion())},
                     {"limits", array}});
}

QByteArray csvLimits(const LimitList &limits)
{
    QByteArray csv = csvHeading(limitFields()) + '\n';
    for (const Limit &limit : limits.list()) {
        csv += csvRecord(limitFields(), limit) + '\n';
    }
    return csv;
}

/// The content of the tab "Motion limits" for one revolution.
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
        if (fact.instant) {
            place += CommandLine::tr(", t = %1 s").arg(secondsText(*fact.instant, revolution.duration));
        }
        rows.push_back({fact.name, fact.value, place + (fact.remark.isEmpty() ? QString() : u' ' + fact.remark)});
    }
    return mobilitySentence(mechanism, limits) + u'\n' + alignedTable(rows, {false, true, false});
}

/// A row per value of the parameter: the value, then the limits by their names. Of two equal peaks the first.
QByteArray variedLimits(const LimitsRequest &request)
{
    const Variation &variation = *request.variation;
    const QString name = QLatin1String(wordOf(variation.parameter));
    QJsonArray rows;
    QByteArray csv;
    for (int i = 0; i < variation.count; ++i) {
        const double part = variation.count > 1 ? static_cast<double>(i) / (variation.count - 1) : 0.0;
        Parameters parameters = request.mechanism.parameters();
        valueOf(parameters, variation.parameter) = variation.from + part * (variation.to - variation.from);
        QByteArrayList names{name.toUtf8()};
        QByteArrayList cells{csvCell(valueOf(parameters, variation.parameter))};
        QJsonObject row{{name, valueOf(parameters, variation.parameter)}};
        const LimitList limits{Mechanism(parameters)};
        for (const Limit &limit : limits.list()) {
            if (names.last() != limit.name) {
                const QJsonValue value = jsonNumber(limit.value);
                names += limit.name;
                cells += csvCell(value);
                row.insert(QLatin1String(limit.name), value);
            }
        }
        csv += (i == 0 ? names.join(',') + '\n' : QByteArray()) + cells.join(',') + '\n';
        rows += row;
    }
    return request.format == Format::Csv ? csv : jsonText({{"rows", rows}});
}

/// "b=50..120"
Variation readVariation(const OptionReader &options, const Mechanism &mechanism)
{
    const QString text = options.text("vary");
    const QString name = text.section(u'=', 0, 0);
    const QStringList ends = text.section(u'=', 1).split(QStringLiteral(".."));
    Variation variation;
    const auto parameter = std::ranges::find_if(kParameters, [&](Parameter each) { return name == QLatin1String(wordOf(each)); });
    if (parameter == kParameters.end() || ends.size() != 2) {
        throw UsageError{CommandLine::tr("--vary must name a parameter and its range, such as b=50..120, not \"%1\".").arg(text)};
    }
    variation.parameter = *parameter;
    const Quantity from = readQuantity(ends[0], unitOf(*parameter), QLocale::c());
    const Quantity to = readQuantity(ends[1], unitOf(*parameter), QLocale::c());
    for (const Quantity &end : {from, to}) {
        Parameters parameters = mechanism.parameters();
        valueOf(parameters, *parameter) = end.value;
        if (end.fault || findFault(parameters)) {
            throw UsageError{CommandLine::tr("--vary: \"%1\" is not a range of valid values of %2.")
                                 .arg(text.section(u'=', 1), name)};
        }
    }
    variation.from = from.value;
    variation.to = to.value;
    variation.count = options.integer("count", variation.count, 1, 1'000'000);
    return variation;
}

/// "stroke=80,time-ratio=1.2,transmission-angle=40"
DesignRequest readDesign(const OptionReader &options)
{
    DesignRequest request;
    const QString usage = CommandLine::tr("--design must be such as stroke=80,time-ratio=1.2,transmission-angle=40, not \"%1\".")
                              .arg(options.text("design"));
    for (const QString &part : options.text("design").split(u',')) {
        const QString key = part.section(u'=', 0, 0).trimmed();
        const bool isStroke = key == u"stroke";
        const bool isAngle = key == u"transmission-angle";
        const std::optional<Unit> unit = isStroke ? std::optional(kMillimetre) : isAngle ? std::optional(kDegree) : std::nullopt;
        const Quantity quantity = readQuantity(part.section(u'=', 1), unit, QLocale::c());
        if (quantity.fault || !(quantity.value > 0.0) || !(isStroke || isAngle || key == u"time-ratio")) {
            throw UsageError{usage};
        }
        if (isStroke) {
            request.stroke = quantity.value;
        } else if (isAngle) {
            request.transmissionAngle = quantity.value / kDegreesPerRadian;
        } else {
            request.timeRatio = quantity.value;
        }
    }
    if (!(request.stroke > 0.0)) {
        throw UsageError{usage};
    }
    return request;
}

ExitStatus limits(const Streams &streams, const LimitsRequest &request)
{
    if (request.variation) {
        return writeOutput(streams, request.output, variedLimits(request));
    }
    const EnglishTexts english(request.format != Format::Text);
    const LimitList found(request.mechanism);
    QByteArray bytes;
    switch (request.format) {
    case Format::Text:
        bytes = (request.isDesigned ? mechanismText(request.mechanism, 9) + u'\n' : QString()).toUtf8() +
                textLimits(request.mechanism, found.motion()).toUtf8();
        break;
    case Format::Csv: bytes = csvLimits(found); break;
    case Format::Json: bytes = jsonLimits(request.mechanism, found); break;
    }
    const bool isImpossible = found.motion().mobility == Mobility::Impossible;
    return moreSevere(writeOutput(streams, request.output, bytes),
                      isImpossible ? ExitStatus::NotAssemblable : ExitStatus::Success);
}

} // namespace

Command prepareLimits(OptionReader &options)
{
    LimitsRequest request{readMechanism(options), readFormat(options, Format::Text), readOutput(options)};
    refuseFiles(options);
    Command command;
    if (options.has("design")) {
        options.refuse({"a", "b", "c", "vary"}, CommandLine::tr("--design computes a, b and c: remove %1."));
        const DesignRequest wanted = readDesign(options);
        const std::variant<Lengths, DesignFault> designed = design(wanted);
        if (const DesignFault *fault = std::get_if<DesignFault>(&designed)) {
            throw UsageError{designFaultText(*fault, wanted), ExitStatus::NotAssemblable};
        }
        const Lengths &lengths = std::get<Lengths>(designed);
        Parameters parameters = request.mechanism.parameters();
        parameters.a = lengths.a;
        parameters.b = lengths.b;
        parameters.c = lengths.c;
        request.mechanism = Mechanism(parameters);
        request.isDesigned = true;
    }
    if (options.has("vary")) {
        request.variation = readVariation(options, request.mechanism);
        if (request.format == Format::Text) {
            throw UsageError{CommandLine::tr("--vary writes a table: add --format csv or --format json.")};
        }
    } else if (options.has("count")) {
        throw UsageError{CommandLine::tr("--count belongs to --vary: remove it.")};
    }
    command.run = [request](const Streams &streams) { return limits(streams, request); };
    return command;
}

} // namespace slidercrank
