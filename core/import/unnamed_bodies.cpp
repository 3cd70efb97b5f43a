// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/unnamed_bodies.h"

#include "core/import/crank_angles.h"
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

constexpr double kHalfTurn = 180.0; // the coupler swings less in every mechanism that makes full turns
constexpr std::size_t kFewestRows = 10;

/// Returns the range of angles in degrees, without the jumps after one turn.
double widthOf(Values degrees)
{
    return rangeOf(unwrapped(std::move(degrees))).width();
}

/// Returns the values in degrees of a column that has not been converted; empty if its unit is not that of an angle.
Values degreesOf(const RawColumn &column)
{
    const std::optional<Unit> unit = column.unitAs(ColumnRole::CrankAngle);
    Values degrees = unit ? column.finiteValues() : Values();
    std::ranges::for_each(degrees, [&](double &value) { value = unit->toDefault(value); });
    return degrees;
}

bool isOfUnnamedBody(const RawColumn *column)
{
    return column->meaning.kind == Kind::Quantity;
}

/// Removes columns that do not change, beside others of the file that do: a table may contain parameters, such as the
/// radius of the crank. Only y, speeds, and the acceleration of the crank may be constant.
void removeConstants(std::vector<RawColumn *> &candidates)
{
    std::vector<std::size_t> filesOfMotion;
    for (const RawColumn *const column : candidates) {
        if (!isConstant(*column)) {
            filesOfMotion.push_back(column->use.file);
        }
    }
    removeColumns(candidates, ColumnReason::Constant, [&](const RawColumn &column) {
        const Channel channel = column.use.channel;
        const bool isAcceleration = channel == Channel{R4x, Order::Acceleration} && column.values.size() >= kFewestRows;
        const bool mayBeConstant = channel.coordinate == R4y || (channel.order != Order::Position && !isAcceleration);
        return isOfUnnamedBody(&column) && !mayBeConstant && isConstant(column) &&
               column.finiteValues().front() != 0.0 && std::ranges::count(filesOfMotion, column.use.file) > 0;
    });
}

/// Returns whether only the crank can have this angle: it spans more than half a turn, or rises evenly over the
/// abscissa.
bool isAngleOfCrank(const RawColumn &angle, const RawColumn *abscissa)
{
    constexpr double kEvenness = 1e-3; // of the range: the coupler never turns that evenly
    constexpr double kEvenRange = 6.0; // in the unit of the file, which may be rad though the heading does not say so
    const double width = widthOf(angle.finiteValues());
    return width > kHalfTurn || (abscissa && angle.values.size() >= kFewestRows && width > kEvenRange * angle.factor &&
                                 isStraight(angle.values, abscissa->values, kEvenness * width));
}

/// Returns whether a column is a speed that does not change, apart from noise.
bool isConstantSpeed(const RawColumn &column)
{
    constexpr double kVariation = 0.01; // of the speed
    const ValueRange range = rangeOf(column.values);
    return range.count >= kFewestRows && range.size() > 0.0 && range.width() <= kVariation * range.size();
}

/// Returns the angles whose derivative a column may be: those with the same owner, and of these only those with the
/// same symbol, if there are any: ψ for ψ̇.
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

/// Gives angles of unnamed bodies to the crank if no other body can have them, and also their derivatives, which have
/// the same owner. If that owner has a further angle, only their symbols tell whose derivatives they are; without them,
/// they are removed.
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
    for (RawColumn *const column : derivatives) {
        const std::vector<RawColumn *> ownAngles = anglesOfDerivative(*column, angles);
        const auto crankAngles =
            std::ranges::count(ownAngles, kCrankAngle, [](const RawColumn *angle) { return angle->use.channel; });
        const bool isOfCrank = crankAngles > 0 && crankAngles == std::ssize(ownAngles);
        if (isConstantSpeed(*column) || isOfCrank) {
            column->use.channel.coordinate = Theta2;
            column->meaning.reason = ColumnReason::WideAngle;
        } else if (crankAngles > 0) {
            column->use.reason = ColumnReason::LikeOther;
            std::erase(candidates, column);
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

/// Finds the body of the columns x, y and an angle, which programs write for each body: the slider does not turn. If
/// both x and y change, it is not the slider, but the coupler, or the crank if it makes turns: then nothing tells its
/// pin from its centre of mass.
void findBodyOfPosition(std::vector<RawColumn *> &candidates)
{
    constexpr double kUnturned = 1e-6; // degrees
    for (RawColumn *const angle : candidates) {
        const Channel channel = angle->use.channel;
        const bool isPosition = channel.order == Order::Position && isAngle(channel.coordinate);
        const std::string &owner = angle->meaning.owner;
        RawColumn *const x = findUnnamed(candidates, {R4x, Order::Position}, owner);
        RawColumn *const y = findUnnamed(candidates, {R4y, Order::Position}, owner);
        if (!isOfUnnamedBody(angle) || !isPosition || !x || !y) {
            continue;
        }
        const bool turns = rangeOf(angle->values).width() > kUnturned;
        if (turns && (isConstant(*x) || isConstant(*y))) {
            continue; // x and y are those of the slider, and the angle is not
        }
        const bool isCrank = channel == kCrankAngle;
        for (RawColumn *const column : candidates) {
            if (!isOfUnnamedBody(column) || column->meaning.owner != owner) {
                continue;
            }
            Coordinate &coordinate = column->use.channel.coordinate;
            if (isAngle(coordinate)) {
                coordinate = turns ? coordinate : Theta4;
            } else if (turns && isCrank) {
                column->meaning.doubt = Doubt::IsOfCrank; // the pin or the centre of mass
            } else if (turns) {
                coordinate = coordinate == R4y ? R3y : R3x;
            }
        }
    }
}

/// Returns whether an angle or a rate without a body does not change. It would be taken for that of the coupler, which
/// does change, but may be that of the slider.
bool isRestingAngle(const RawColumn &column)
{
    return isOfUnnamedBody(&column) && column.use.channel.coordinate == Theta3 && isConstant(column) &&
           column.values.size() >= kFewestRows;
}

/// Returns whether the column is a length of a point that only has a letter, a number or an unknown name.
bool isOfPoint(const RawColumn *column)
{
    return isOfUnnamedBody(column) && !column->meaning.owner.empty() && !isAngle(column->use.channel.coordinate);
}

/// Returns whether the values rise and fall by more than noise.
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

/// Removes speeds that are never negative while the slider moves back and forth: they are magnitudes.
void removeMagnitudes(std::vector<RawColumn *> &candidates)
{
    removeColumns(candidates, ColumnReason::Magnitude, [&](const RawColumn &column) {
        const RawColumn *const x = findUnnamed(candidates, {R4x, Order::Position}, column.meaning.owner);
        const bool isSpeed = isOfUnnamedBody(&column) && column.use.channel == Channel{R4x, Order::Velocity};
        return isSpeed && x && x->values.size() >= kFewestRows && moveBackAndForth(x->finiteValues()) &&
               rangeOf(column.values).low >= 0.0;
    });
}

/// Returns the only owner of columns of numbered parts, if no other column is the slider's; else an empty text.
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

/// The path of a point, as far as its x and y, or their derivatives, tell it.
enum class Path { Unknown, Straight, Curved };

/// Returns the path of a point whose x and y are in two columns of the same order.
Path pathOf(const RawColumn *x, const RawColumn *y)
{
    constexpr double kStraightness = 0.02; // of the travel, for points that were followed in a video
    constexpr double kCurvedness = 0.3;    // of the travel: a camera may be inclined
    if (!x || !y || isConstant(*x)) {
        return Path::Unknown;
    }
    const double width = rangeOf(x->values).width();
    const double height = rangeOf(y->values).width();
    const bool isCurved = height > kCurvedness * width && width > kCurvedness * height;
    if (height <= kStraightness * width) {
        return Path::Straight;
    }
    return isCurved ? Path::Curved : Path::Unknown;
}

/// Returns the path of the point with the name of an owner.
Path pathOf(const std::vector<RawColumn *> &candidates, const std::string &owner)
{
    Path path = Path::Unknown;
    for (const Order order : {Order::Acceleration, Order::Velocity, Order::Position}) { // the last one tells most
        const Path found =
            pathOf(findUnnamed(candidates, {R4x, order}, owner), findUnnamed(candidates, {R4y, order}, owner));
        path = found == Path::Unknown ? path : found;
    }
    return path;
}

/// Removes x, y and their derivatives without the name of a point that describe a curved path: they are not those of the
/// slider. If there is a position x, only the orders whose own path is curved are removed; else a curved path of one
/// order decides for all. Two positions are kept: the slider may also move along an inclined line, which the
/// identification finds out.
void removeUnnamedCurvedPath(std::vector<RawColumn *> &candidates)
{
    const auto find = [&](Coordinate coordinate, Order order) {
        return findUnnamed(candidates, {coordinate, order}, {});
    };
    const bool hasX = find(R4x, Order::Position);
    if (hasX && find(R4y, Order::Position)) {
        return;
    }
    std::set<Order> curvedOrders;
    for (const Order order : {Order::Position, Order::Velocity, Order::Acceleration}) {
        const Path path = hasX ? pathOf(find(R4x, order), find(R4y, order)) : pathOf(candidates, {});
        if (path == Path::Curved) {
            curvedOrders.insert(order);
        }
    }
    removeColumns(candidates, ColumnReason::UnknownBody, [&](const RawColumn &column) {
        return isOfUnnamedBody(&column) && column.meaning.owner.empty() && !isAngle(column.use.channel.coordinate) &&
               curvedOrders.contains(column.use.channel.order);
    });
}

/// Returns whether the owner of a column is A, the crank pin.
bool isOfCrankPin(const RawColumn &column)
{
    return lowered(column.meaning.owner) == "a";
}

/// Finds the slider among points with x and y: it is the only one whose y does not change. Removes the others, those
/// whose paths are curved, and those that only the path could tell.
void findSliderAmongPoints(std::vector<RawColumn *> &candidates)
{
    const std::string part = onlyPart(candidates);
    std::set<std::string> straight;
    std::set<std::string> curved;
    for (const RawColumn *const column : candidates) {
        const std::string &owner = column->meaning.owner;
        const Path path = isOfPoint(column) ? pathOf(candidates, owner) : Path::Unknown;
        if (path != Path::Unknown) {
            (path == Path::Straight ? straight : curved).insert(owner);
        }
    }
    const auto isOfOther = [&](RawColumn &column) {
        NameMeaning &meaning = column.meaning;
        if (!isOfPoint(&column)) {
            return false;
        }
        if (straight.size() == 1 && straight.contains(meaning.owner)) {
            meaning.reason = ColumnReason::StraightPath;
            return false;
        }
        const bool isDoubtful = meaning.doubt == Doubt::IsOfPoint || (meaning.doubt == Doubt::IsOfPart && part.empty());
        return straight.size() == 1 || curved.contains(meaning.owner) || isDoubtful;
    };
    removeColumns(candidates, ColumnReason::CrankPin,
                  [&](RawColumn &column) { return isOfCrankPin(column) && isOfOther(column); });
    removeColumns(candidates, ColumnReason::UnknownBody, isOfOther);
}

/// Returns whether the slider moves along y, as in an upright engine: its y changes, and no column is its x.
bool isUpright(std::span<const RawColumn> columns)
{
    const auto isPosition = [](const RawColumn &column, Coordinate coordinate) {
        return column.meaning.kind >= Kind::Quantity && column.meaning.doubt == Doubt::None &&
               column.meaning.channel == Channel{coordinate, Order::Position};
    };
    const auto isMovingY = [&](const RawColumn &column) {
        return isPosition(column, R4y) && rangeOf(column.values).width() > 0.0;
    };
    const auto isX = [&](const RawColumn &column) { return isPosition(column, R4x); };
    return std::ranges::any_of(columns, isMovingY) && std::ranges::none_of(columns, isX);
}

/// Assigns velocities and accelerations of the slider to y if their names state no axis.
void moveToY(std::span<RawColumn> columns)
{
    for (RawColumn &column : columns) {
        NameMeaning &meaning = column.meaning;
        const bool isGuess = meaning.kind >= Kind::Quantity && meaning.kind < Kind::ChannelName && !meaning.namesAxis;
        if (isGuess && meaning.channel.coordinate == R4x && meaning.channel.order != Order::Position) {
            meaning.channel.coordinate = R4y;
        }
    }
}

/// Returns the angle of the link with the next number.
Coordinate angleOfNextLink(Coordinate angle)
{
    if (angle == Theta1) {
        return Theta2;
    }
    return angle == Theta2 ? Theta3 : Theta4;
}

} // namespace

bool isConstant(const RawColumn &column)
{
    const ValueRange range = rangeOf(column.values);
    constexpr std::size_t kFewestConstants = 3; // "20 20" may be the same by chance
    return range.count >= kFewestConstants && range.width() == 0.0;
}

bool isTurningAngle(const RawColumn &column)
{
    constexpr double kTurn = 360.0;
    const std::optional<Unit> unit = column.unitAs(ColumnRole::CrankAngle);
    return unit && !isConstant(column) && !findReversal(unwrapped(column.finiteValues(), kTurn / unit->factor));
}

void correctMeanings(RawTable &table)
{
    if (isUpright(table.columns)) {
        moveToY(table.columns);
    }
    const auto makesHalfTurn = [](const RawColumn &column) { return widthOf(degreesOf(column)) > kHalfTurn; };
    bool isCrankFirst = false; // whether the crank has the number 1
    for (RawColumn &column : table.columns) {
        NameMeaning &meaning = column.meaning;
        if (meaning.doubt == Doubt::IsAngle && isTurningAngle(column) && makesHalfTurn(column)) {
            meaning.channel.order = Order::Position;
        }
        isCrankFirst = isCrankFirst || (meaning.kind >= Kind::Words && meaning.kind < Kind::Chosen &&
                                        meaning.channel == Channel{Theta1, Order::Position} && makesHalfTurn(column));
    }
    for (RawColumn &column : table.columns) {
        NameMeaning &meaning = column.meaning;
        const Coordinate coordinate = meaning.channel.coordinate;
        const bool isNumbered = meaning.kind >= Kind::Words && meaning.kind < Kind::Chosen &&
                                (coordinate == Theta1 || coordinate == Theta2 || coordinate == Theta3);
        if (isCrankFirst && isNumbered) {
            meaning.channel.coordinate = angleOfNextLink(coordinate);
            meaning.reason = ColumnReason::WideAngle;
        } else if (isNumbered && coordinate == Theta1 && rangeOf(column.values).width() > 0.0) {
            meaning = {.reason = ColumnReason::UnknownBody}; // it is not the frame
        }
    }
}

void assignBodies(RawTable &table, std::vector<RawColumn *> &candidates)
{
    removeUnnamedCurvedPath(candidates);
    findSliderAmongPoints(candidates);
    removeConstants(candidates);
    removeMagnitudes(candidates);
    findCrank(table, candidates);
    findBodyOfPosition(candidates);
    removeColumns(candidates, ColumnReason::Constant, isRestingAngle);
    removeColumns(candidates, ColumnReason::UnknownBody, [](const RawColumn &column) {
        return column.meaning.doubt == Doubt::IsOfCrank && column.use.channel.coordinate != Theta2;
    });
}

} // namespace slidercrank
