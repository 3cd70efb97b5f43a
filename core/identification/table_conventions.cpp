// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/table_conventions.h"

#include <algorithm>
#include <utility>

namespace slidercrank
{

namespace
{

/// Whether the slider moves along y and not along x, by its positions, velocities and accelerations.
bool movesAlongY(const ReferenceData &data)
{
    constexpr double kStationaryFraction = 1e-3; // of the motion along the other axis: rounding or misalignment
    const auto widthOf = [&](Channel channel) {
        const ReferenceSeries *const series = data.find(channel);
        return series ? rangeOf(series->values).width() : 0.0;
    };
    bool moves = false;
    for (const Order order : {Order::Position, Order::Velocity, Order::Acceleration}) {
        const double alongX = widthOf({R4x, order});
        const double alongY = widthOf({R4y, order});
        if (alongX > kStationaryFraction * alongY) {
            return false;
        }
        moves = moves || alongY > 0.0;
    }
    return moves;
}

/// The columns whose headings may be exchanged, because `result` does not explain them. If it explains nothing, θ3 and
/// R4_x.
std::vector<Channel> findDoubtfulHeadings(const Identification &result)
{
    constexpr double kMinPercent = 10.0; // of the peak: a filter leaves less, a wrong heading leaves more
    if (result.outcome == Identification::Outcome::None) {
        return {{Theta3, Order::Position}, {R4x, Order::Position}};
    }
    std::vector<Channel> doubtful;
    for (const LeftOutColumn &column : result.leftOut) {
        const bool isUnexplained =
            column.reason == LeftOutColumn::Reason::Unknown || column.reason == LeftOutColumn::Reason::OtherMotion;
        const bool isSmall = column.percentOfPeak < kMinPercent; // false if the percentage is unknown (NaN)
        if (isUnexplained && !isSmall) {
            doubtful.push_back(column.channel);
        }
    }
    return doubtful;
}

/// If derivatives are left out from a file over the time, the unit of its time stamps may be wrong. Returns the
/// conversion that corrects it then: from seconds to milliseconds, or from a different unit to seconds. Otherwise
/// returns nullopt.
std::optional<Convention> possibleUnitOfClock(const ReferenceData &data, const Identification &result)
{
    const auto isDerivative = [](const LeftOutColumn &column) { return column.channel.order != Order::Position; };
    if (data.crank || std::ranges::none_of(result.leftOut, isDerivative)) {
        return std::nullopt;
    }
    const double unitOfHeading = data.timeRounding.unitFactor;
    return Convention{.kind = Convention::Kind::TimeUnit,
                      .channels = {}, // the headings of the derivatives state their own unit of time
                      .amount = unitOfHeading == 1.0 ? kMillisecond : 1.0 / unitOfHeading};
}

/// The exchanges of two doubtful headings of the file.
std::vector<Convention> possibleExchanges(const ReferenceData &data, const std::vector<Channel> &doubtful)
{
    std::vector<Convention> exchanges;
    for (std::size_t i = 0; i < doubtful.size(); ++i) {
        for (std::size_t j = i + 1; j < doubtful.size(); ++j) {
            if (data.find(doubtful[i]) && data.find(doubtful[j])) {
                exchanges.push_back({.kind = Convention::Kind::SwappedColumns, .channels = {doubtful[i], doubtful[j]}});
            }
        }
    }
    return exchanges;
}

} // namespace

std::optional<Convention> findAxisRotation(const ReferenceData &data, bool rotatesAngles)
{
    if (!movesAlongY(data)) {
        return std::nullopt;
    }
    Convention axis{.kind = Convention::Kind::Axis, .channels = {}};
    for (const ReferenceSeries &series : data.series) {
        const Channel channel = series.channel;
        const bool isOfSlider = channel.coordinate == R4x || channel.coordinate == R4y;
        const bool isDirection = isAngle(channel.coordinate) && channel.order == Order::Position; // rates stay
        if (isOfSlider || (rotatesAngles && isDirection)) {
            axis.channels.push_back(channel);
        }
    }
    return axis;
}

std::vector<Convention> possibleTableConventions(const ReferenceData &data, const Identification &result)
{
    std::vector<Convention> conventions = possibleExchanges(data, findDoubtfulHeadings(result));
    if (std::optional<Convention> clock = possibleUnitOfClock(data, result)) {
        conventions.insert(conventions.begin(), *std::move(clock)); // if two results are equal, the earlier one is kept
    }
    return conventions;
}

} // namespace slidercrank
