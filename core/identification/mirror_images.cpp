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
std::tuple<int, int, double> effortOf(const Observations &observations, const Fit &fit, const Model &model,
                                      const Parameters &given)
{
    constexpr double kOtherDirection = 1.5; // compared with another sign of c, which counts 1
    const Parameters &m = model.mechanism;
    const int readings = readingCount(observations, fit, model);
    const double distance = std::abs(m.c - given.c) / (std::abs(m.c) + std::abs(given.c) + kEpsilon * m.a) +
                            (m.omega2 * given.omega2 < 0.0 ? kOtherDirection : 0.0);
    return {readings + (m.branch != given.branch ? 1 : 0), readings, distance};
}

/// Whether two models read the file in the same way.
bool haveSameReading(const Fit &fit, const Model &first, const Model &second)
{
    constexpr double kSameOrigin = 1e-6; // rad or mm: rounding errors
    bool isSame =
        !first.followsAngle || (first.angleFactor == second.angleFactor &&
                                std::abs(wrapToPi(first.mechanism.theta20 - second.mechanism.theta20)) < kSameOrigin);
    for (const Index k : fit.columns) {
        isSame = isSame && first.readings[k].factor == second.readings[k].factor &&
                 std::abs(first.readings[k].origin - second.readings[k].origin) < kSameOrigin;
    }
    return isSame;
}

/// The columns of lengths or of angles that are counted with the other sign.
struct Reversed {
    int columns = 0;
    int reversed = 0;

    /// All together are one reading.
    int readings() const { return reversed == columns ? std::min(reversed, 1) : reversed; }
};

} // namespace

int readingCount(const Observations &observations, const Fit &fit, const Model &model)
{
    constexpr double kSameOffset = 0.02; // of a: then R4_y is c
    int count = 0;
    Reversed lengths, angles;
    bool hasReversedDisplacement = false;
    if (model.followsAngle) {
        const bool hasOrigin = fit.changes({Unknown::Kind::CrankAngle});
        count += model.angleFactor < 0.0 ? 1 : 0;
        count += !hasOrigin && isOddHalfTurn(model.mechanism.theta20) ? 1 : 0;
    }
    for (Index k = 0; k < std::ssize(observations.columns); ++k) {
        const ObservedColumn &column = observations.columns[k];
        const ColumnReading &reading = model.readings[k];
        if (column.channel == kSliderLine) {
            count += std::abs(column.values[0] - model.mechanism.c) > kSameOffset * model.mechanism.a ? 1 : 0;
        } else if (fit.uses(k)) {
            const bool hasOrigin = fit.changes({Unknown::Kind::Origin, k});
            const bool isLength = !column.containsAngles();
            const bool isReversed = reading.factor < 0.0;
            if (isLength && hasOrigin) { // a displacement has a direction of its own
                hasReversedDisplacement = hasReversedDisplacement || isReversed;
            } else {
                Reversed &kind = isLength ? lengths : angles;
                ++kind.columns;
                kind.reversed += isReversed ? 1 : 0;
            }
            count += !isLength && !hasOrigin && isOddHalfTurn(reading.origin / reading.factor) ? 1 : 0;
        }
    }
    count += lengths.readings() + angles.readings();
    // The direction of a displacement costs nothing unless other readings are necessary besides it.
    return count + (hasReversedDisplacement && count > 0 ? 1 : 0);
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
    std::ranges::stable_sort(images, {}, [&](const Model &model) { return effortOf(observations, fit, model, given); });
    std::erase_if(images,
                  [&, best = images.front()](const Model &model) { return !haveSameReading(fit, model, best); });
    return images;
}

} // namespace slidercrank
