// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/mirror_images.h"

#include "core/mechanism/turn.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

namespace slidercrank
{

namespace
{

constexpr double kHalfTurn = std::numbers::pi;

/// The angle of the crank becomes `from` - θ2.
Model withReversedCrank(Model model, double from)
{
    model.angleFactor = -model.angleFactor;
    model.mechanism.omega2 = -model.mechanism.omega2;
    model.mechanism.theta20 = from - model.mechanism.theta20;
    model.alpha2 = -model.alpha2;
    return model;
}

/// All y and all angles are negated.
Model mirroredInX(const Model &model, const Observations &observations)
{
    Model image = withReversedCrank(model, 0.0);
    image.mechanism.c = -model.mechanism.c;
    for (Index k = 0; k < std::ssize(observations.columns); ++k) {
        const Coordinate coordinate = observations.columns[k].channel.coordinate;
        const bool isY = coordinate == R2y || coordinate == R3y || coordinate == R4y;
        image.readings[k].factor *= isAngle(coordinate) || isY ? -1.0 : 1.0;
        if (observations.columns[k].channel == Channel{Theta3, Order::Position} &&
            image.mechanism.branch == Branch::Crossed) {
            // The model has θ3 of the crossed assembly between 90° and 270°, and not between -270° and -90°.
            image.readings[k].origin += kTurn * model.readings[k].factor;
        }
    }
    return image;
}

/// All x are negated, all angles are subtracted from half a turn.
Model mirroredInY(const Model &model, const Observations &observations)
{
    Model image = withReversedCrank(model, kHalfTurn);
    image.mechanism.branch = oppositeBranch(model.mechanism.branch);
    for (Index k = 0; k < std::ssize(observations.columns); ++k) {
        const Channel channel = observations.columns[k].channel;
        const bool isX = channel.coordinate == R2x || channel.coordinate == R3x || channel.coordinate == R4x;
        if (isAngle(channel.coordinate) && channel.order == Order::Position) {
            image.readings[k].origin += model.readings[k].factor * kHalfTurn;
        }
        image.readings[k].factor *= isAngle(channel.coordinate) || isX ? -1.0 : 1.0;
    }
    return image;
}

/// Whether a multiple of half a turn, with some error, is an odd one: half a turn and any number of whole turns.
bool isOddHalfTurn(double angle)
{
    return std::abs(wrapToPi(angle)) > 0.5 * kHalfTurn;
}

/// The key by which images are sorted. First, the number of readings, where another assembly than the given one counts
/// as one more. Among equal ones, the number of readings without that, and then the distance from the given mechanism.
std::tuple<int, int, double> sortingKey(const Observations &observations, const Fit &fit, const Model &model,
                                        const Parameters &given)
{
    constexpr double kReversedCrank = 1.5; // worse than the opposite c, for which the other term is 1
    const Parameters &m = model.mechanism;
    const int readings = readingCount(observations, fit, model);
    const double distance = std::abs(m.c - given.c) / (std::abs(m.c) + std::abs(given.c) + kEpsilon * m.a) +
                            (m.omega2 * given.omega2 < 0.0 ? kReversedCrank : 0.0);
    return {readings + (m.branch != given.branch ? 1 : 0), readings, distance};
}

/// Whether two models read the file in the same way: each column that the fit uses, and the angle of the crank if they
/// follow it.
bool haveSameReading(const Fit &fit, const Model &first, const Model &second)
{
    constexpr double kSameOrigin = 1e-6; // rad or mm: rounding errors
    if (first.followsAngle) {            // then θ20 is the origin of the angle in the file
        const double originDifference = wrapToPi(first.mechanism.theta20 - second.mechanism.theta20);
        const bool isSameOrigin = std::abs(originDifference) < kSameOrigin;
        if (first.angleFactor != second.angleFactor || !isSameOrigin) {
            return false;
        }
    }
    return std::ranges::all_of(fit.columns, [&](Index k) {
        return first.readings[k].factor == second.readings[k].factor &&
               std::abs(first.readings[k].origin - second.readings[k].origin) < kSameOrigin;
    });
}

/// How many columns there are of one kind (lengths or angles), and how many of them have the opposite sign.
struct SignCount {
    int columns = 0;
    int negated = 0;

    /// If all have it, they are counted along the opposite axis, which is one reading.
    int readings() const { return negated == columns ? std::min(negated, 1) : negated; }
};

/// The readings of the angle in the file, if the model follows it: clockwise, and half a turn off.
int crankReadingCount(const Fit &fit, const Model &model)
{
    if (!model.followsAngle) {
        return 0;
    }
    const bool hasUsualOrigin = !fit.changes({Unknown::Kind::CrankAngle});
    const int clockwise = model.angleFactor < 0.0 ? 1 : 0;
    return clockwise + (hasUsualOrigin && isOddHalfTurn(model.mechanism.theta20) ? 1 : 0);
}

/// The readings of R4_y: a column that is not c.
int sliderLineReadingCount(const Observations &observations, const Model &model)
{
    constexpr double kTolerance = 0.02; // of a: rounding and noise
    const auto isOtherLine = [&](const ObservedColumn &column) {
        return column.channel == kSliderLine &&
               std::abs(column.values[0] - model.mechanism.c) > kTolerance * model.mechanism.a;
    };
    return std::ranges::any_of(observations.columns, isOtherLine) ? 1 : 0;
}

} // namespace

int readingCount(const Observations &observations, const Fit &fit, const Model &model)
{
    int count = crankReadingCount(fit, model) + sliderLineReadingCount(observations, model);
    SignCount lengths, angles;
    bool hasNegatedDisplacement = false;
    for (const Index k : fit.columns) {
        const ObservedColumn &column = observations.columns[k];
        const ColumnReading &reading = model.readings[k];
        const bool hasOrigin = fit.changes({Unknown::Kind::Origin, k});
        const bool isNegated = reading.factor < 0.0;
        if (column.channel == kSliderLine) {
            continue; // counted above
        }
        if (hasOrigin && !column.containsAngles()) { // a displacement, which has a direction of its own
            hasNegatedDisplacement = hasNegatedDisplacement || isNegated;
            continue;
        }
        SignCount &signs = column.containsAngles() ? angles : lengths;
        ++signs.columns;
        signs.negated += isNegated ? 1 : 0;
        const bool isHalfTurnOff =
            column.containsAngles() && !hasOrigin && isOddHalfTurn(reading.origin / reading.factor);
        count += isHalfTurnOff ? 1 : 0;
    }
    count += lengths.readings() + angles.readings();
    // The direction of a displacement costs nothing unless other readings are necessary besides it.
    return count + (hasNegatedDisplacement && count > 0 ? 1 : 0);
}

std::vector<Model> mirrorImagesOf(const Observations &observations, const Fit &fit, const Parameters &given)
{
    std::vector<Model> images{fit.model, mirroredInX(fit.model, observations)};
    images.push_back(mirroredInY(images[0], observations));
    images.push_back(mirroredInY(images[1], observations));
    if (observations.containOnlyAngles(fit.columns)) { // θ3 is the same at θ2 and at half a turn minus θ2
        for (std::size_t i = 0; i < 4; ++i) {
            images.push_back(withReversedCrank(images[i], kHalfTurn));
        }
    }
    std::ranges::stable_sort(images, {},
                             [&](const Model &model) { return sortingKey(observations, fit, model, given); });
    std::erase_if(images,
                  [&, best = images.front()](const Model &model) { return !haveSameReading(fit, model, best); });
    return images;
}

} // namespace slidercrank
