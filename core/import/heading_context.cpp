// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/heading_context.h"

#include "core/import/cells.h"
#include "core/import/column_values.h"
#include "core/import/name_path.h"
#include "core/import/vocabulary.h"
#include "core/mechanism/find_element.h"

#include <algorithm>
#include <array>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

namespace slidercrank
{

namespace
{

using Words = std::vector<std::string>;
using Kind = NameMeaning::Kind;
using Doubt = NameMeaning::Doubt;

/// Returns the last part of the path that is the name of a column: "DX" of "Body_4/DX".
std::string lastPartOf(const RawColumn &column)
{
    const NamePath path = splitPath(column.name);
    return path.parts.empty() ? std::string() : std::string(path.parts.back());
}

/// Returns whether the name is a symbol with the mark of a second derivative, such as "xpp" or "d2x". The symbols and
/// words "a", "α" and "acceleration" have no mark: beside them, "xp" may still be anything.
bool isSecondDerivative(const RawColumn &column)
{
    const NameMeaning &meaning = column.meaning;
    const Words words = wordsOf(lastPartOf(column));
    const bool isAcceleration = meaning.channel.order == Order::Acceleration && meaning.kind >= Kind::Quantity;
    const WordMeaning *const symbol = words.empty() ? nullptr : findWord(words[0], WordUse::Symbol);
    const bool isItself = symbol && symbol->order == Order::Acceleration;
    const bool isMarked = !words.empty() && !findWord(words[0], WordUse::Word) && !isItself;
    return isAcceleration && isMarked && meaning.doubt == Doubt::None;
}

/// Returns whether the name is that of a displacement and not of a differential: "DX" of Adams, or "dx" beside "vx".
bool isDisplacement(const RawColumn &column, std::span<const RawColumn> columns)
{
    const auto lastWordOf = [](const RawColumn &named) {
        const std::string part = lastPartOf(named);
        return part.substr(part.rfind(' ') + 1); // "DX" of "Slider DX"
    };
    const std::string symbol = lastWordOf(column);
    const auto isVelocity = [&](const RawColumn &other) {
        return lowered(lastWordOf(other)) == 'v' + lowered(symbol).substr(1);
    };
    return isAmong(symbol, "DX DY") || (symbol.starts_with('d') && std::ranges::any_of(columns, isVelocity));
}

/// Returns whether the name begins with A and, apart from an x or y at the end, another column with the same unit has
/// the same name with B: "a" beside "b", "Ax" beside "By".
bool isOfPointA(const RawColumn &column, std::span<const RawColumn> columns)
{
    const auto withoutAxis = [](const RawColumn &ofPoint) {
        const std::string name = lowered(ofPoint.name);
        return name.substr(0, name.find_last_not_of("xy") + 1);
    };
    const std::string point = withoutAxis(column);
    return point.starts_with('a') && std::ranges::any_of(columns, [&](const RawColumn &other) {
               return withoutAxis(other) == 'b' + point.substr(1) && other.use.unit == column.use.unit;
           });
}

/// Returns whether the heading is that of the crank pin, A_x or A_y, in a table that the command `solve` has written:
/// it has no unit, and another column has the exact name of a channel or one of kOwnNames. (`solve` writes no unit for
/// lengths in mm.)
bool isCrankPinOfSolve(const RawColumn &column, std::span<const RawColumn> columns)
{
    static constexpr std::string_view kOwnNames =
        "transmission_angle displacement_diff displacement_diff2 A_x_diff A_y_diff A_x_diff2 A_y_diff2";
    const auto isOfSolve = [](const RawColumn &other) {
        return other.meaning.kind == Kind::ChannelName || isAmong(other.name, kOwnNames);
    };
    return isAmong(column.name, "A_x A_y") && column.use.unit.empty() && std::ranges::any_of(columns, isOfSolve);
}

/// Decides between the meanings of "xp", "dx" and the like by the other columns:
///
/// 1. "DX", and "dx" beside "vx", are displacements,
/// 2. else, beside "xpp" or "d2x", they are derivatives,
/// 3. else "x_p", or "xp" beside another such name ("yp"), belongs to the piston, unless a column "x" exists.
///
/// A name that meets none of these conditions loses its meaning: only a person can tell.
void resolveDerivatives(std::span<RawColumn> columns)
{
    const auto isNamed = [&](const std::string &name) {
        return std::ranges::any_of(columns,
                                   [&](const RawColumn &column) { return lowered(lastPartOf(column)) == name; });
    };
    const auto mayBeOfPiston = [](const RawColumn &column) {
        return column.meaning.doubt == Doubt::IsPistonsIndex && !isAngle(column.meaning.channel.coordinate);
    };
    const bool areSeveral = std::ranges::count_if(columns, mayBeOfPiston) > 1;
    const bool hasSecond = std::ranges::any_of(columns, isSecondDerivative);
    for (RawColumn &column : columns) {
        NameMeaning &meaning = column.meaning;
        if (meaning.doubt != Doubt::IsDerivative && meaning.doubt != Doubt::IsPistonsIndex) {
            continue;
        }
        const Words words = wordsOf(lastPartOf(column));
        const bool isApart = std::ranges::count(words, "p") > 0; // "x_p", but not "xp" and "xp_dot"
        const std::string symbol = isApart ? words[0] : words[0].substr(0, words[0].rfind('p'));
        const bool isOfPiston = mayBeOfPiston(column) && (isApart || areSeveral) && !isNamed(symbol);
        if (isDisplacement(column, columns)) {
            meaning.doubt = Doubt::None;
        } else if (hasSecond && meaning.channel.order < Order::Acceleration) {
            const bool isOfPosition = meaning.channel.order == Order::Position;
            meaning.channel.order = isOfPosition ? Order::Velocity : Order::Acceleration;
        } else if (!isOfPiston) {
            meaning = {.reason = ColumnReason::UnknownBody};
        }
    }
}

/// Decides whether α is an angle or the angular acceleration: the acceleration if ω is before it, otherwise an angle if
/// it turns by more than half a turn in one direction. If neither is so, its meaning stays in doubt.
void resolveAlphas(std::span<RawColumn> columns)
{
    bool isBehindOmega = false;
    for (RawColumn &column : columns) {
        NameMeaning &meaning = column.meaning;
        const WordMeaning *const symbol = findWord(meaning.symbol, WordUse::Symbol);
        isBehindOmega =
            isBehindOmega || (symbol && symbol->dimension == Dimension::Angle && symbol->order == Order::Velocity);
        if (meaning.doubt == Doubt::IsAngle && isBehindOmega) {
            meaning.doubt = Doubt::None;
        } else if (meaning.doubt == Doubt::IsAngle && isTurningAngle(column) && makesHalfTurn(column)) {
            meaning.channel.order = Order::Position;
        }
    }
}

/// Numbers the points, as the owners of their columns, if several points have columns with the same headings, as
/// Tracker writes "x", "y", "x", "y": the first x and the first y belong to the same point.
void separatePoints(std::span<RawColumn> columns)
{
    const auto isOfPoint = [](const RawColumn &column) {
        const NameMeaning &meaning = column.meaning;
        return meaning.kind == Kind::Quantity && meaning.namesAxis && meaning.owner.empty() &&
               !isAngle(meaning.channel.coordinate);
    };
    const auto countIn = [&](std::span<const RawColumn> part, const RawColumn &column) {
        return std::ranges::count_if(part, [&](const RawColumn &other) {
            return other.meaning.channel == column.meaning.channel && other.use.heading == column.use.heading;
        });
    };
    const auto isRepeatedY = [&](const RawColumn &column) {
        return isOfPoint(column) && column.meaning.channel.coordinate == R4y && countIn(columns, column) > 1;
    };
    if (std::ranges::none_of(columns, isRepeatedY)) {
        return;
    }
    for (std::size_t i = 0; i < columns.size(); ++i) {
        if (isOfPoint(columns[i]) && countIn(columns, columns[i]) > 1) {
            columns[i].meaning.owner = std::to_string(countIn(columns.first(i), columns[i]));
            columns[i].meaning.doubt = Doubt::IsOfPart;
        }
    }
}

/// Removes the meaning of headings of the crank pin, which has no channel.
void excludeCrankPin(std::span<RawColumn> columns)
{
    for (RawColumn &column : columns) {
        if (isOfPointA(column, columns) || isCrankPinOfSolve(column, columns)) {
            column.meaning = {.reason = ColumnReason::CrankPin};
        }
    }
}

/// Returns whether a word is the symbol of an angle or of its derivative, or begins like "angular" in some language.
bool isAngular(const std::string &word)
{
    constexpr std::array<std::string_view, 8> kBeginnings{"ang", "winkel", "hoek",   "kat",
                                                          "uhl", "unghi",  "vinkel", "угл"};
    const WordMeaning *const symbol = findWord(word, WordUse::Symbol);
    const auto isBeginning = [&word](std::string_view beginning) { return word.starts_with(beginning); };
    return (symbol && symbol->dimension == Dimension::Angle) || std::ranges::any_of(kBeginnings, isBeginning);
}

/// Decides whether a speed of rotation in 1/s or Hz is in rad/s or in turns per second, by its name:
///
///     n, Drehzahl               1/s, Hz   turns per second
///     ω, angular velocity       1/s       rad/s
///     crank speed               Hz        turns per second
///     ω, angular velocity       Hz        only a person can tell
///     crank speed               1/s       only a person can tell
///     fs, another unknown name  Hz        not used: the frequency of anything
void resolveReciprocalSeconds(RawColumn &column)
{
    NameMeaning &meaning = column.meaning;
    const std::string unit = lowered(column.use.unit);
    const std::optional<Unit> parsed = parseUnit(unit);
    const bool isHertz = unit == "hz" || unit == "hertz";
    const bool isReciprocal = isHertz || (parsed == parseUnit("1/s") && unit.find("rad") == unit.npos);
    if (!isReciprocal || meaning.kind < Kind::Quantity || meaning.kind >= Kind::ChannelName) {
        return;
    }
    const Words words = wordsOf(column.name);
    const bool isInTurns = !unitOfRotation(words).empty() || std::ranges::count(words, "n") > 0;
    const bool isInRadians = !isInTurns && std::ranges::any_of(words, isAngular);
    if (isInTurns) {
        column.use.unit = "rev/s";
    } else if (isHertz && meaning.hasUnknownWords) {
        meaning = {.channel = meaning.channel, .reason = ColumnReason::UnknownBody};
    } else if (isHertz == isInRadians) { // "ω [Hz]" contradicts itself, and "crank speed [1/s]" leaves it open
        meaning = {.channel = meaning.channel, .reason = ColumnReason::TurnsOrRadians};
    } else if (isHertz) {
        column.use.unit = "rev/s";
    }
}

/// Completes the names and units of components that PMKS+ writes behind the magnitude of their vector: "Velocity
/// (cm/s)", "X-comp", "Y-comp". The magnitude is ignored.
void completeComponents(std::span<RawColumn> columns)
{
    RawColumn *vector = nullptr;
    for (RawColumn &column : columns) {
        const bool isComponent = isAmong(column.name, "X-comp Y-comp");
        if (isComponent && vector) {
            vector->use.reason = ColumnReason::Magnitude;
            column.name = vector->name + (column.name[0] == 'X' ? " x" : " y");
            column.use.unit = column.use.unit.empty() ? vector->use.unit : column.use.unit;
            column.meaning = meaningOf(column.name, column.use.unit);
        } else if (!isComponent) {
            const bool isQuantity = meaningOf(column.name, column.use.unit).kind == Kind::Quantity;
            vector = isQuantity ? &column : nullptr;
        }
    }
}

/// Returns whether the values of a position contradict the implied unit m or rad: a length that travels more than 10 m;
/// an angle that spans more than a turn and reverses (a coupler does not), or advances by more than half a turn per
/// row.
bool contradictsSi(const RawColumn &column)
{
    constexpr double kMaxTravel = 10.0;                  // m
    constexpr double kMaxSwing = 2.0 * std::numbers::pi; // rad
    constexpr double kMaxStep = std::numbers::pi;        // rad from row to row, on average
    const double width = rangeOf(column.values).width();
    if (column.meaning.channel.order != Order::Position) {
        return false;
    }
    if (!isAngle(column.meaning.channel.coordinate)) {
        return width > kMaxTravel;
    }
    const std::vector<double> angles = column.finiteValues();
    return width > kMaxSwing && (findReversal(angles) || width > kMaxStep * static_cast<double>(angles.size()));
}

/// If the path of any name implies m, rad and s, these are also the units of the other paths without a unit:
/// "slider.frame_a.x" beside "slider.v". But if the values of one of these columns contradict the units, no path
/// implies them.
void implySiUnits(std::span<RawColumn> columns)
{
    const auto isInSi = [](const RawColumn &column) { return column.meaning.reason == ColumnReason::PathInSi; };
    if (std::ranges::none_of(columns, isInSi)) {
        return;
    }
    for (RawColumn &column : columns) {
        NameMeaning &meaning = column.meaning;
        if (column.use.unit.empty() && meaning.kind >= Kind::Quantity && !meaning.owner.empty()) {
            meaning.reason = ColumnReason::PathInSi;
        }
    }
    const auto isContradicted = [&](const RawColumn &column) { return isInSi(column) && contradictsSi(column); };
    if (std::ranges::any_of(columns, isContradicted)) {
        for (RawColumn &column : columns) {
            const bool isCertain = column.meaning.kind >= Kind::Words;
            const ColumnReason named = isCertain ? ColumnReason::KnownName : ColumnReason::QuantityInName;
            column.meaning.reason = isInSi(column) ? named : column.meaning.reason;
        }
    }
}

/// Symbols such as "x_B" or "d" beside θ₂ or θ₃ are those of a textbook, where they denote the slider. So their columns
/// need no confirmation by a person.
void recognizeTextbook(std::span<RawColumn> columns)
{
    const auto isAngleOfLink = [](const RawColumn &column) {
        const Coordinate coordinate = column.meaning.channel.coordinate;
        return column.meaning.kind >= Kind::Words && (coordinate == Theta2 || coordinate == Theta3) &&
               beginsWithSymbol(column.name);
    };
    if (std::ranges::none_of(columns, isAngleOfLink)) {
        return;
    }
    for (RawColumn &column : columns) {
        NameMeaning &meaning = column.meaning;
        const bool isGuess = meaning.kind == Kind::Quantity && meaning.reason == ColumnReason::QuantityInName;
        if (isGuess && meaning.channel.coordinate == R4x && beginsWithSymbol(column.name)) {
            meaning.reason = ColumnReason::KnownName;
        }
    }
}

/// Returns the unit of a quantity without a stated unit; empty if it is the default unit:
///
/// 1. m, rad and s for the paths of some programs,
/// 2. else the unit that the name contains, such as "rpm",
/// 3. else rad/s and rad/s² for ω and α,
/// 4. else, for other derivatives, that of the position of the same coordinate, per s or s².
std::string impliedUnit(const RawColumn &column, std::span<const RawColumn> columns)
{
    const NameMeaning &meaning = column.meaning;
    const std::string perTime(derivativeSuffix(meaning.channel.order));
    if (meaning.reason == ColumnReason::PathInSi) {
        return (isAngle(meaning.channel.coordinate) ? "rad" : "m") + perTime;
    }
    if (const std::string_view unit = unitOfRotation(wordsOf(column.name)); !unit.empty()) {
        return std::string(unit);
    }
    const auto isAngularRate = [](const std::string &word) { // ω or α
        const WordMeaning *const symbol = findWord(word, WordUse::Symbol);
        return symbol && symbol->dimension == Dimension::Angle && symbol->order > Order::Position;
    };
    if (meaning.channel.order != Order::Position && isAngle(meaning.channel.coordinate) &&
        meaning.doubt != Doubt::IsAngle &&
        (isAngularRate(meaning.symbol) || std::ranges::any_of(wordsOf(column.name), isAngularRate))) {
        return "rad" + perTime;
    }
    const auto isPosition = [&](const RawColumn &other) {
        return other.meaning.kind >= Kind::Quantity &&
               other.meaning.channel == Channel{meaning.channel.coordinate, Order::Position} &&
               (meaning.hasUnknownWords || !other.meaning.hasUnknownWords);
    };
    const RawColumn *const position = findElement(columns, isPosition);
    const std::optional<Unit> unit = position ? parseUnit(position->use.unit) : std::nullopt;
    const bool differs = unit && unit->factor != 1.0;
    return differs && meaning.channel.order != Order::Position ? position->use.unit + perTime : std::string();
}

} // namespace

void interpretHeadings(std::span<RawColumn> columns)
{
    completeComponents(columns);
    resolveDerivatives(columns);
    resolveAlphas(columns);
    separatePoints(columns);
    excludeCrankPin(columns);
    std::ranges::for_each(columns, resolveReciprocalSeconds);
    implySiUnits(columns);
    for (RawColumn &column : columns) {
        if (column.meaning.kind == Kind::Nothing) {
            column.use.reason = column.use.heading.empty() ? ColumnReason::NoName : column.meaning.reason;
        }
        if (column.meaning.kind >= Kind::Quantity && column.use.unit.empty()) {
            column.use.unit = impliedUnit(column, columns);
        }
    }
    recognizeTextbook(columns);
}

} // namespace slidercrank
