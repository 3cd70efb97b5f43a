// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/reading_conventions.h"

#include "core/import/crank_angles.h"
#include "core/mechanism/turn.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

namespace slidercrank
{

namespace
{

using Kind = Convention::Kind;

/// Adds a column to the convention of this kind and amount; appends a new convention if there is none. Origins are
/// never combined, because each has its own standard error.
void appendForColumn(std::vector<ConventionFinding> &conventions, Kind kind, Channel channel, double amount)
{
    for (ConventionFinding &finding : conventions) {
        Convention &convention = finding.convention;
        if (convention.kind == kind && convention.amount == amount && kind != Kind::ZeroPoint) {
            convention.channels.push_back(channel);
            return;
        }
    }
    conventions.push_back({{kind, {channel}, amount}});
}

/// Appends the convention that adds `amount` (° or mm) to a column:
///   - ZeroPoint with `errorOfAmount` if the amount is not usual: farther than kOriginTolerance from a multiple of 180°
///     (from 0 for lengths). If `hadJumps`, WholeTurns 0 comes before it.
///   - HalfTurn if it is usual, and the multiple is odd.
///   - WholeTurns if it is usual, and the multiple is even; but nothing if it is 0 and not `hadJumps`, and nothing for
///     θ2, which is compared up to whole turns.
/// `hadJumps`: jumps by whole turns have to be removed from the column, which HalfTurn and WholeTurns do.
void appendShift(std::vector<ConventionFinding> &conventions, Channel channel, double amount, double errorOfAmount,
                 bool hadJumps)
{
    constexpr double kHalfTurnInDegrees = 0.5 * kTurnInDegrees;
    const double usual =
        isAngle(channel.coordinate) ? kHalfTurnInDegrees * std::rint(amount / kHalfTurnInDegrees) : 0.0;
    const bool areWholeTurns = std::fmod(usual, kTurnInDegrees) == 0.0;
    if (std::abs(amount - usual) > kOriginTolerance) {
        if (hadJumps) {
            appendForColumn(conventions, Kind::WholeTurns, channel, 0.0);
        }
        appendForColumn(conventions, Kind::ZeroPoint, channel, amount);
        conventions.back().standardError = errorOfAmount;
    } else if (!areWholeTurns) {
        appendForColumn(conventions, Kind::HalfTurn, channel, usual);
    } else if (channel != kCrankAngle && (usual != 0.0 || hadJumps)) {
        appendForColumn(conventions, Kind::WholeTurns, channel, usual);
    }
}

/// Appends the conventions that turn the column `channel` into the motion, which is value / factor - origin / factor,
/// because value = factor · motion + origin. `errorOfOrigin`: standard error of the origin (mm, rad). `hadJumps`: see
/// appendShift().
void appendReading(std::vector<ConventionFinding> &conventions, Channel channel, const ColumnReading &reading,
                   double errorOfOrigin, bool hadJumps)
{
    const double unit = std::abs(reading.factor);
    if (unit != 1.0) {
        appendForColumn(conventions, isAngle(channel.coordinate) ? Kind::AngleUnit : Kind::LengthUnit, channel,
                        1.0 / unit);
    }
    if (reading.factor < 0.0) {
        appendForColumn(conventions, Kind::Sign, channel, -1.0);
    }
    appendShift(conventions, channel, toFileUnit(channel, -reading.origin / reading.factor),
                toFileUnit(channel, errorOfOrigin / unit), hadJumps);
}

} // namespace

std::vector<ConventionFinding> listConventions(const LastFit &lastFit)
{
    const Observations &observations = lastFit.observations;
    const Fit &fit = lastFit.fit;
    const Model &model = fit.model;
    std::vector<ConventionFinding> conventions;
    if (model.followsAngle) {
        // The model contains θ2 = angleFactor · angle + θ20, and not the angle in the file as a reading of θ2.
        const ColumnReading reading{1.0 / model.angleFactor, -wrapToPi(model.mechanism.theta20) / model.angleFactor};
        const double errorOfOrigin = lastFit.standardErrorOf(Parameter::Theta20) / std::abs(model.angleFactor);
        constexpr bool kHadJumps = false; // θ2 is compared up to whole turns, with or without jumps
        appendReading(conventions, kCrankAngle, reading, errorOfOrigin, kHadJumps);
    }
    Indices columns = fit.columns; // in the order of the file
    std::ranges::sort(columns);
    for (const Index k : columns) {
        const ObservedColumn &column = observations.columns[k];
        const double errorOfOrigin = lastFit.standardErrorOf(originOf(k));
        appendReading(conventions, column.channel, model.readings[k], errorOfOrigin, column.hadJumps);
    }
    return conventions;
}

} // namespace slidercrank
