// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/unnamed_bodies.h"

#include "core/import/column_values.h"
#include "core/import/crank_angles.h"
#include "core/import/vocabulary.h"
#include "core/mechanism/find_element.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

namespace slidercrank
{

namespace
{

using Kind = NameMeaning::Kind;
using Doubt = NameMeaning::Doubt;
using Values = std::vector<double>;

bool isOfUnnamedBody(const RawColumn *column)
{
    return column->meaning.kind == Kind::Quantity;
}

/// Removes columns of unnamed bodies that contain a parameter, such as the radius of the crank, if other columns of
/// their file change: a single value, or equal values other than 0. Equal values are no parameter in columns of y, of
/// velocities, and of accelerations, except that of the slider in at least ten rows.
void removeConstants(std::vector<RawColumn *> &candidates)
{
    std::vector<std::size_t> filesOfMotion;
    for (const RawColumn *const column : candidates) {
        if (!isConstant(*column) && !isSingleValue(*column)) {
            filesOfMotion.push_back(column->use.file);
        }
    }
    removeColumns(candidates, ColumnReason::Constant, [&](const RawColumn &column) {
        const Channel channel = column.use.channel;
        const bool isAcceleration =
            channel == Channel{R4x, Order::Acceleration} && column.values.size() >= kMinConclusiveRows;
        const bool mayBeConstant = channel.coordinate == R4y || (channel.order != Order::Position && !isAcceleration);
        const bool isParameter =
            isSingleValue(column) || (!mayBeConstant && isConstant(column) && column.finiteValues().front() != 0.0);
        return isOfUnnamedBody(&column) && isParameter && std::ranges::count(filesOfMotion, column.use.file) > 0;
    });
}

/// Returns whether only the crank can have this angle: it spans more than half a turn, or rises evenly over the
/// abscissa.
bool isAngleOfCrank(const RawColumn &angle, const RawColumn *abscissa)
{
    constexpr double kEvenness = 1e-3; // of the range: the coupler never turns that evenly
    constexpr double kEvenRange = 6.0; // in the unit of the file, which may be rad though the heading does not say so
    const double width = angularWidth(angle.finiteValues());
    return width > kLargestSwing ||
           (abscissa && angle.values.size() >= kMinConclusiveRows && width > kEvenRange * angle.factor &&
            isStraight(angle.values, abscissa->values, kEvenness * width));
}

/// Returns the angles whose derivative a column may be: those with the same owner. If some of these have the symbol of
/// the derivative, as ψ for ψ̇, only those are returned.
std::vector<RawColumn *> anglesOfDerivative(const RawColumn &derivative, std::vector<RawColumn *> angles)
{
    std::erase_if(angles, [&](const RawColumn *angle) { return angle->meaning.owner != derivative.meaning.owner; });
    const auto hasOtherSymbol = [&](const RawColumn *angle) {
        return angle->meaning.symbol.empty() || angle->meaning.symbol != derivative.meaning.symbol;
    };
    if (!std::ranges::all_of(angles, hasOtherSymbol)) {
        std::erase_if(angles, hasOtherSymbol);
    }
    return angles;
}

/// Assigns the derivative of an angle to the crank if it can be that of no other angle, or if it is nearly constant.
/// Returns false if it may be that of the crank or of a different angle.
bool assignDerivative(RawColumn &derivative, const std::vector<RawColumn *> &angles)
{
    const std::vector<RawColumn *> ownAngles = anglesOfDerivative(derivative, angles);
    const auto crankAngles =
        std::ranges::count(ownAngles, kCrankAngle, [](const RawColumn *angle) { return angle->use.channel; });
    const bool isOfCrank = crankAngles > 0 && crankAngles == std::ssize(ownAngles);
    const bool isSteady = isNearlyConstant(derivative); // only the crank turns evenly, or accelerates evenly
    if (isSteady || isOfCrank) {
        derivative.use.channel.coordinate = Theta2;
        derivative.meaning.reason = ColumnReason::WideAngle;
        return true;
    }
    return crankAngles == 0;
}

/// Assigns angles of unnamed bodies, and their derivatives, to the crank if no other body can have them. Removes the
/// derivatives that may be those of the crank or of a different angle.
void findCrank(RawTable &table, std::vector<RawColumn *> &candidates)
{
    std::vector<RawColumn *> angles;
    std::vector<RawColumn *> derivatives;
    for (RawColumn *const column : candidates) {
        if (isOfUnnamedBody(column) && isAngle(column->use.channel.coordinate)) {
            (column->use.channel.order == Order::Position ? angles : derivatives).push_back(column);
        }
    }
    for (RawColumn *const angle : angles) {
        if (isAngleOfCrank(*angle, table.abscissa())) {
            angle->use.channel = kCrankAngle;
            angle->meaning.reason = ColumnReason::WideAngle;
        }
    }
    for (RawColumn *const derivative : derivatives) {
        if (!assignDerivative(*derivative, angles)) {
            derivative->use.reason = ColumnReason::LikeOther;
            std::erase(candidates, derivative);
        }
    }
}

/// Returns the candidate of an unnamed body with that channel and owner, or null.
RawColumn *findUnnamed(const std::vector<RawColumn *> &candidates, Channel channel, const std::string &owner)
{
    const auto *const found = findElement(candidates, [&](const RawColumn *column) {
        return isOfUnnamedBody(column) && column->use.channel == channel && column->meaning.owner == owner;
    });
    return found ? *found : nullptr;
}

/// Returns the body whose x, y and angle are three columns of the same owner: the slider if the angle is constant;
/// nullopt if x or y is constant although the angle changes (they do not belong together); the crank if the angle is
/// that of the crank; otherwise the coupler.
std::optional<Body> bodyOfPose(const RawColumn &x, const RawColumn &y, const RawColumn &angle)
{
    constexpr double kMaxSliderRotation = 1e-6; // degrees
    if (rangeOf(angle.values).width() <= kMaxSliderRotation) {
        return Body::Slider;
    }
    if (isConstant(x) || isConstant(y)) {
        return std::nullopt;
    }
    return angle.use.channel == kCrankAngle ? Body::Crank : Body::Coupler;
}

/// Sets the channels of the columns of an owner to those of a body. Removes x and y of the crank: nothing distinguishes
/// its pin from its centre of mass.
void assignToBody(std::vector<RawColumn *> &candidates, const std::string &owner, Body body)
{
    const auto isOfOwner = [&owner](const RawColumn &column) {
        return isOfUnnamedBody(&column) && column.meaning.owner == owner;
    };
    if (body == Body::Crank) {
        removeColumns(candidates, ColumnReason::UnknownBody, [&](const RawColumn &column) {
            return isOfOwner(column) && !isAngle(column.use.channel.coordinate);
        });
        return;
    }
    for (RawColumn *const column : candidates) {
        Coordinate &coordinate = column->use.channel.coordinate;
        if (!isOfOwner(*column)) {
            continue;
        }
        if (!isAngle(coordinate) && body == Body::Coupler) {
            coordinate = coordinate == R4y ? R3y : R3x;
        } else if (isAngle(coordinate) && body == Body::Slider) {
            coordinate = Theta4;
        }
    }
}

/// Finds the bodies of columns for x, y and an angle of the same owner, which programs write for each body.
void findBodiesOfPoses(std::vector<RawColumn *> &candidates)
{
    for (const std::vector<RawColumn *> columns = candidates; RawColumn *const angle : columns) {
        const Channel channel = angle->use.channel;
        const std::string owner = angle->meaning.owner;
        if (!isOfUnnamedBody(angle) || channel.order != Order::Position || !isAngle(channel.coordinate)) {
            continue;
        }
        const RawColumn *const x = findUnnamed(candidates, {R4x, Order::Position}, owner);
        const RawColumn *const y = findUnnamed(candidates, {R4y, Order::Position}, owner);
        if (const std::optional<Body> body = x && y ? bodyOfPose(*x, *y, *angle) : std::nullopt) {
            assignToBody(candidates, owner, *body);
        }
    }
}

/// Returns whether an angle of an unnamed body, or its derivative, does not change, apart from whole turns. As the
/// angle of the coupler it would change, so it may be that of the slider, or the number of the turn.
bool isRestingAngle(const RawColumn &column)
{
    const bool isPosition = column.use.channel.order == Order::Position;
    return isOfUnnamedBody(&column) && column.use.channel.coordinate == Theta3 &&
           column.values.size() >= kMinConclusiveRows &&
           (isConstant(column) || (isPosition && angularWidth(column.finiteValues()) == 0.0));
}

/// Returns whether the column is an angle of an unknown body that the crank does not have, such as Tracker's θ_{r}, the
/// direction in which a point lies from the origin.
bool isAngleOfUnknownBody(const RawColumn *column)
{
    return column->meaning.doubt == Doubt::IsAngleOfUnknown && column->use.channel.coordinate != Theta2;
}

/// Removes the angles of unknown bodies. If no other angle is of an unnamed body, also removes the derivatives of
/// unnamed bodies: they are those of these angles.
void removeAnglesOfUnknownBodies(std::vector<RawColumn *> &candidates)
{
    const auto isOtherAngle = [](const RawColumn *column) {
        return isOfUnnamedBody(column) && isAngle(column->use.channel.coordinate) &&
               column->use.channel.order == Order::Position && !isAngleOfUnknownBody(column);
    };
    const bool areAllUnknown =
        std::ranges::any_of(candidates, isAngleOfUnknownBody) && std::ranges::none_of(candidates, isOtherAngle);
    removeColumns(candidates, ColumnReason::UnknownBody, [areAllUnknown](const RawColumn &column) {
        const Channel channel = column.use.channel;
        const bool isDerivative = isOfUnnamedBody(&column) && column.meaning.owner.empty() &&
                                  channel.coordinate == Theta3 && channel.order != Order::Position;
        return isAngleOfUnknownBody(&column) || (areAllUnknown && isDerivative);
    });
}

/// Returns whether the column is x or y, or a derivative, of a point that is named only by a letter, a number or an
/// unknown word.
bool isOfPoint(const RawColumn *column)
{
    return isOfUnnamedBody(column) && !column->meaning.owner.empty() && !isAngle(column->use.channel.coordinate);
}

/// Returns whether the values rise and also fall by clearly more than their noise may.
bool moveBackAndForth(const Values &values)
{
    constexpr double kMinFraction = 0.2; // of the range, for both the largest rise and the largest fall
    double rise = 0.0;
    double fall = 0.0;
    ValueRange before;
    for (const double value : values) {
        before.include(value);
        rise = std::max(rise, value - before.low);
        fall = std::max(fall, before.high - value);
    }
    return std::min(rise, fall) > kMinFraction * before.width();
}

/// Returns whether the velocity or acceleration of the slider must be negative at times: another column of the channel
/// of `rate` has negative values or, for a velocity, the position of the slider rises and falls.
bool isNegativeAtTimes(const std::vector<RawColumn *> &candidates, const RawColumn &rate)
{
    return std::ranges::any_of(candidates, [&rate](const RawColumn *other) {
        const bool isSameRate = other != &rate && other->use.channel == rate.use.channel;
        const bool returns = rate.use.channel.order == Order::Velocity &&
                             other->use.channel == Channel{R4x, Order::Position} &&
                             other->values.size() >= kMinConclusiveRows && moveBackAndForth(other->finiteValues());
        return returns || (isSameRate && rangeOf(other->values).low < 0.0);
    });
}

/// Removes velocities and accelerations of the slider that are never negative although those of the slider must be at
/// times: they are magnitudes, such as "v" beside "v_x". Columns with the exact name of the channel stay.
void removeMagnitudes(std::vector<RawColumn *> &candidates)
{
    const std::vector<RawColumn *> others = candidates;
    removeColumns(candidates, ColumnReason::Magnitude, [&others](const RawColumn &column) {
        const Channel channel = column.use.channel;
        return column.meaning.kind < Kind::ChannelName && channel.coordinate == R4x &&
               channel.order != Order::Position && rangeOf(column.values).low >= 0.0 &&
               isNegativeAtTimes(others, column);
    });
}

/// Returns the owner of the columns of numbered parts, if there is only one such owner, and no other column is the x of
/// the slider or its derivative. Otherwise returns an empty text.
std::string onlyPart(const std::vector<RawColumn *> &candidates)
{
    std::string part;
    for (const RawColumn *const column : candidates) {
        const Coordinate coordinate = column->use.channel.coordinate;
        const bool isPart = column->meaning.doubt == Doubt::IsOfPart;
        const bool isOther = isPart ? !part.empty() && part != column->meaning.owner
                                    : column->meaning.doubt != Doubt::IsOfPoint && coordinate == R4x;
        if (isOther) {
            return {};
        }
        part = isPart ? column->meaning.owner : part;
    }
    return part;
}

/// The path of a point, as far as its x and y, or their derivatives, show it.
enum class Path { Unknown, Straight, Curved };

/// Returns the path of a point whose x and y are in two columns of the same order.
Path pathOf(const RawColumn *x, const RawColumn *y)
{
    constexpr double kMaxStraightRatio = 0.02; // height / width; points that were followed in a video are off by less
    constexpr double kMinCurvedRatio = 0.3;    // smaller / larger extent; an inclined camera may show a line with less
    if (!x || !y || isConstant(*x)) {
        return Path::Unknown;
    }
    const double width = rangeOf(x->values).width();
    const double height = rangeOf(y->values).width();
    const bool isCurved = height > kMinCurvedRatio * width && width > kMinCurvedRatio * height;
    if (height <= kMaxStraightRatio * width) {
        return Path::Straight;
    }
    return isCurved ? Path::Curved : Path::Unknown;
}

/// Returns the path of the point that is the owner of some candidates.
Path pathOf(const std::vector<RawColumn *> &candidates, const std::string &owner)
{
    Path path = Path::Unknown;
    for (const Order order : {Order::Acceleration, Order::Velocity, Order::Position}) { // positions tell most
        const Path found =
            pathOf(findUnnamed(candidates, {R4x, order}, owner), findUnnamed(candidates, {R4y, order}, owner));
        path = found == Path::Unknown ? path : found;
    }
    return path;
}

/// Removes velocities and accelerations without an owner whose x and y describe a curve: they are not those of the
/// slider. If the positions x and y are also columns, keeps them: the slider may move along an inclined line, which the
/// identification finds out.
void removeUnnamedCurvedPath(std::vector<RawColumn *> &candidates)
{
    const auto find = [&](Coordinate coordinate, Order order) {
        return findUnnamed(candidates, {coordinate, order}, {});
    };
    if (find(R4x, Order::Position) && find(R4y, Order::Position)) {
        return;
    }
    for (const Order order : {Order::Velocity, Order::Acceleration}) {
        if (pathOf(find(R4x, order), find(R4y, order)) != Path::Curved) {
            continue;
        }
        removeColumns(candidates, ColumnReason::UnknownBody, [order](const RawColumn &column) {
            return isOfUnnamedBody(&column) && column.meaning.owner.empty() && column.use.channel.order == order &&
                   !isAngle(column.use.channel.coordinate);
        });
    }
}

/// Returns whether the owner of a column is A, the crank pin.
bool isOfCrankPin(const RawColumn &column)
{
    return lowered(column.meaning.owner) == "a";
}

/// Returns the owners of the points with that path.
std::set<std::string> pointsWithPath(const std::vector<RawColumn *> &candidates, Path path)
{
    std::set<std::string> owners;
    for (const RawColumn *const column : candidates) {
        if (isOfPoint(column) && pathOf(candidates, column->meaning.owner) == path) {
            owners.insert(column->meaning.owner);
        }
    }
    return owners;
}

/// Finds the slider among points with x and y: it is the only one whose y does not change. Sets the reason of its
/// columns to StraightPath, and removes the other points. If not exactly one point has such a y, removes the points
/// whose paths are curved, and those whose names leave open whether they are the slider.
void findSliderAmongPoints(std::vector<RawColumn *> &candidates)
{
    const std::string part = onlyPart(candidates);
    const std::set<std::string> straight = pointsWithPath(candidates, Path::Straight);
    const std::set<std::string> curved = pointsWithPath(candidates, Path::Curved);
    const bool isFound = straight.size() == 1;
    const auto isOfSlider = [&](const RawColumn &column) {
        return isFound && isOfPoint(&column) && straight.contains(column.meaning.owner);
    };
    const auto isOfOther = [&](const RawColumn &column) {
        if (!isOfPoint(&column) || isOfSlider(column)) {
            return false;
        }
        const Doubt doubt = column.meaning.doubt;
        const bool isDoubtful = doubt == Doubt::IsOfPoint || (doubt == Doubt::IsOfPart && part.empty());
        return isFound || isDoubtful || curved.contains(column.meaning.owner);
    };
    for (RawColumn *const column : candidates) {
        column->meaning.reason = isOfSlider(*column) ? ColumnReason::StraightPath : column->meaning.reason;
    }
    removeColumns(candidates, ColumnReason::CrankPin,
                  [&](const RawColumn &column) { return isOfCrankPin(column) && isOfOther(column); });
    removeColumns(candidates, ColumnReason::UnknownBody, isOfOther);
}

} // namespace

void assignBodies(RawTable &table, std::vector<RawColumn *> &candidates)
{
    removeUnnamedCurvedPath(candidates);
    findSliderAmongPoints(candidates);
    removeConstants(candidates);
    removeMagnitudes(candidates);
    findCrank(table, candidates);
    findBodiesOfPoses(candidates);
    removeColumns(candidates, ColumnReason::Constant, isRestingAngle);
    removeAnglesOfUnknownBodies(candidates);
}

} // namespace slidercrank
