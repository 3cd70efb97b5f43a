// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/mirror_images.h"

#include "core/identification/residual_test.h"

#include "core/mechanism/turn.h"

#include <algorithm>
#include <cmath>
#include <compare>

namespace slidercrank
{

namespace
{

/// The model whose crank is at `sum` - θ2 (rad) where that of the given model is at θ2.
Model withReversedCrank(Model model, double sum)
{
    model.angleFactor = -model.angleFactor;
    model.mechanism.omega2 = -model.mechanism.omega2;
    model.mechanism.theta20 = sum - model.mechanism.theta20;
    model.alpha2 = -model.alpha2;
    return model;
}

/// Changes a reading so that its values remain the same when the motion of the column becomes `sum` minus the motion.
void subtractMotionFrom(double sum, ColumnReading &reading)
{
    reading = {-reading.factor, reading.origin + reading.factor * sum};
}

/// The image in the x axis: all y and all angles are negated.
Model mirroredInX(const Model &model, const Observations &observations)
{
    Model image = withReversedCrank(model, 0.0);
    image.mechanism.c = -model.mechanism.c;
    for (Index k = 0; k < std::ssize(observations.columns); ++k) {
        const Channel channel = observations.columns[k].channel;
        if (channel == Channel{Theta3, Order::Position} && model.mechanism.branch == Branch::Crossed) {
            // The model has θ3 of the crossed assembly between 90° and 270°, and not between -270° and -90°.
            subtractMotionFrom(kTurn, image.readings[k]);
        } else if (isAngle(channel.coordinate) || isAlongY(channel.coordinate)) {
            subtractMotionFrom(0.0, image.readings[k]);
        }
    }
    return image;
}

/// The image in the y axis: all x are negated, and all angles are subtracted from half a turn.
Model mirroredInY(const Model &model, const Observations &observations)
{
    Model image = withReversedCrank(model, kHalfTurn);
    image.mechanism.branch = oppositeBranch(model.mechanism.branch);
    for (Index k = 0; k < std::ssize(observations.columns); ++k) {
        const Channel channel = observations.columns[k].channel;
        if (isAngle(channel.coordinate) && channel.order == Order::Position) {
            subtractMotionFrom(kHalfTurn, image.readings[k]);
        } else if (isAngle(channel.coordinate) || isAlongX(channel.coordinate)) {
            subtractMotionFrom(0.0, image.readings[k]);
        }
    }
    return image;
}

/// Whether an angle that is a multiple of half a turn, apart from rounding errors, is an odd multiple.
bool isOddHalfTurn(double angle)
{
    return std::abs(wrapToPi(angle)) > kQuarterTurn;
}

/// How many columns of one kind (lengths or angles) are negated. A displacement, which is a position with a free
/// origin, is not counted, because its direction may be chosen freely.
struct SignCount {
    int columns = 0;
    int negated = 0;
    bool isDisplacementNegated = false;

    int countUnusualReadings() const
    {
        const bool areAllNegated = columns > 0 && negated == columns;
        if (!areAllNegated) {
            return negated;
        }
        // They are counted along the opposite axis, which is one unusual reading. Derivatives share the direction of a
        // displacement, so that beside a negated displacement they have their usual direction.
        return isDisplacementNegated ? 0 : 1;
    }
};

/// The number of unusual readings of θ2 in the file: one if it is counted clockwise, and one if it is half a turn off.
/// 0 if the model does not follow it.
int countUnusualCrankReadings(const Fit &fit, const Model &model)
{
    if (!model.followsAngle) {
        return 0;
    }
    const bool isClockwise = model.angleFactor < 0.0;
    // An origin that is not free is a multiple of half a turn (see withoutFreedoms()).
    const bool isOriginFixed = !fit.isFree(Parameter::Theta20);
    const bool isHalfTurnOff = isOriginFixed && isOddHalfTurn(model.mechanism.theta20);
    return (isClockwise ? 1 : 0) + (isHalfTurnOff ? 1 : 0);
}

/// Whether the file has a column R4_y that is not c, apart from noise.
bool isSliderLineShifted(const Observations &observations, const Model &model)
{
    const auto isOtherLine = [&](const ObservedColumn &column) {
        return column.channel == kSliderLine &&
               std::abs(median(column.values) - model.mechanism.c) > kLargestNoise * model.mechanism.a;
    };
    return std::ranges::any_of(observations.columns, isOtherLine);
}

/// The signs of lengths and of angles in the columns of a fit.
struct SignCounts {
    SignCount lengths{};
    SignCount angles{};
    bool isFrameShifted = false; ///< the file measures lengths from a point other than O2
};

/// Counts the negated columns of a fit, apart from R4_y. In a shifted frame, a position with an origin of its own is no
/// displacement, and its sign counts.
SignCounts countSigns(const Observations &observations, const Fit &fit, const Model &model)
{
    SignCounts signs{.isFrameShifted = isSliderLineShifted(observations, model)};
    for (const Index k : fit.columns) {
        const ObservedColumn &column = observations.columns[k];
        if (column.channel == kSliderLine) {
            continue;
        }
        const bool isNegated = model.readings[k].factor < 0.0;
        const bool hasOrigin = fit.isFree(originOf(k));
        const bool isDisplacement = hasOrigin && !column.containsAngles() && !signs.isFrameShifted;
        if (isDisplacement) {
            signs.lengths.isDisplacementNegated = signs.lengths.isDisplacementNegated || isNegated;
            continue;
        }
        SignCount &count = column.containsAngles() ? signs.angles : signs.lengths;
        ++count.columns;
        count.negated += isNegated ? 1 : 0;
    }
    return signs;
}

/// The number of angles in the columns of a fit that are half a turn off.
int countHalfTurns(const Observations &observations, const Fit &fit, const Model &model)
{
    const auto isHalfTurnOff = [&](Index k) {
        const ColumnReading &reading = model.readings[k];
        const bool hasOrigin = fit.isFree(originOf(k));
        return observations.columns[k].containsAngles() && !hasOrigin && isOddHalfTurn(reading.origin / reading.factor);
    };
    return static_cast<int>(std::ranges::count_if(fit.columns, isHalfTurnOff));
}

/// The number of unusual readings that a model with the columns and unknowns of a fit needs: θ2 clockwise or half a
/// turn off, R4_y that is not c, each negated column (all columns of lengths, or all of angles, count once), and each
/// angle that is half a turn off. The sign of a displacement does not count. `signs`: those of the model.
int countUnusualReadings(const Observations &observations, const Fit &fit, const Model &model, const SignCounts &signs)
{
    return countUnusualCrankReadings(fit, model) + (signs.isFrameShifted ? 1 : 0) +
           countHalfTurns(observations, fit, model) + signs.lengths.countUnusualReadings() +
           signs.angles.countUnusualReadings();
}

/// Orders the images: that with the lowest rank, compared member by member, is preferred.
struct ImageRank {
    int unusualReadingsAndAssembly; ///< unusualReadings, and one more for an assembly other than the given one
    bool isOtherThanGiven;          ///< the assembly or c is not that of the given mechanism
    bool isDisplacementNegated;     ///< a displacement may have any direction, but that of x is likelier
    int unusualReadings; ///< countUnusualReadings(): the other assembly without any is preferred to the given one with
                         ///< one
    bool isReversed;     ///< the crank turns in the direction opposite to the given one
    double distanceOfC;  ///< between c and the given c, 0 … 1

    friend auto operator<=>(const ImageRank &, const ImageRank &) = default;
};

ImageRank rankImage(const Observations &observations, const Fit &fit, const Model &model, const Parameters &given)
{
    constexpr double kLengthTolerance = 1e-3; // fraction of a: the c of a fit is never exactly the given one
    const Parameters &m = model.mechanism;
    const SignCounts signs = countSigns(observations, fit, model);
    const int unusualReadings = countUnusualReadings(observations, fit, model, signs);
    const bool isGivenAssembly = m.branch == given.branch;
    const bool isGivenC = std::abs(m.c - given.c) <= kLengthTolerance * m.a;
    const double sumOfOffsets = std::abs(m.c) + std::abs(given.c) + kEpsilon * m.a; // not 0, even if both offsets are
    return {.unusualReadingsAndAssembly = unusualReadings + (isGivenAssembly ? 0 : 1),
            .isOtherThanGiven = !(isGivenAssembly && isGivenC),
            .isDisplacementNegated = signs.lengths.isDisplacementNegated,
            .unusualReadings = unusualReadings,
            .isReversed = m.omega2 * given.omega2 < 0.0,
            .distanceOfC = std::abs(m.c - given.c) / sumOfOffsets};
}

/// The model whose crank is at half a turn minus θ2 where that of the given model is at θ2: θ3 is the same there.
Model withReflectedCrank(const Model &model, const Observations &observations)
{
    Model image = withReversedCrank(model, kHalfTurn);
    for (Index k = 0; k < std::ssize(observations.columns); ++k) {
        const Channel channel = observations.columns[k].channel;
        if (channel.coordinate == Theta2) {
            subtractMotionFrom(channel.order == Order::Position ? kHalfTurn : 0.0, image.readings[k]);
        }
    }
    return image;
}

/// Whether two models read the file in the same way: each column that the fit uses, and the angle of the crank if they
/// follow it.
bool haveSameReading(const Fit &fit, const Model &first, const Model &second)
{
    if (first.followsAngle) { // then θ20 is the origin of the angle in the file
        const double originDifference = wrapToPi(first.mechanism.theta20 - second.mechanism.theta20);
        const bool isSameOrigin = std::abs(originDifference) < kOriginTolerance;
        if (first.angleFactor != second.angleFactor || !isSameOrigin) {
            return false;
        }
    }
    return std::ranges::all_of(fit.columns, [&](Index k) {
        return first.readings[k].factor == second.readings[k].factor &&
               std::abs(first.readings[k].origin - second.readings[k].origin) < kOriginTolerance;
    });
}

} // namespace

std::vector<Model> rankMirrorImages(const Observations &observations, const Fit &fit, const Parameters &given)
{
    const Model inX = mirroredInX(fit.model, observations);
    std::vector<Model> images{fit.model, inX, mirroredInY(fit.model, observations), mirroredInY(inX, observations)};
    if (observations.containOnlyAngles(fit.columns)) {
        const std::vector<Model> imagesOfBothAxes = images;
        for (const Model &image : imagesOfBothAxes) {
            images.push_back(withReflectedCrank(image, observations));
        }
    }
    std::ranges::stable_sort(images, {},
                             [&](const Model &model) { return rankImage(observations, fit, model, given); });
    return images;
}

std::vector<Model> findSimplestMirrorImages(const Observations &observations, const Fit &fit, const Parameters &given)
{
    std::vector<Model> images = rankMirrorImages(observations, fit, given);
    std::erase_if(images,
                  [&, best = images.front()](const Model &model) { return !haveSameReading(fit, model, best); });
    return images;
}

} // namespace slidercrank
