// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/speed_and_size.h"

#include "core/identification/column_scale.h"
#include "core/identification/geometry.h"
#include "core/identification/joint_fit.h"
#include "core/identification/residual_test.h"
#include "core/identification/table_speed.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace slidercrank
{

namespace
{

/// Whether some columns over the angle of the crank contain lengths, but these are all velocities, which show only the
/// product a ω2, or all accelerations, which show only a ω2², and no rate of an angle shows ω2.
bool isOnlyProductWithSpeedShown(const Observations &observations, const Indices &columns)
{
    return !areLengthsDetermined(observations, columns) && !observations.containOnlyAngles(columns);
}

/// Multiplies the lengths of a mechanism by a factor.
void scaleLengths(Parameters &mechanism, double factor)
{
    for (const Parameter length : kLengths) {
        valueOf(mechanism, length) *= factor;
    }
}

/// The order (position, velocity or acceleration) that all columns of lengths have in a fit over the angle of the
/// crank; Position if there are none.
Order orderOfLengths(const Observations &observations, const Fit &fit)
{
    const auto isLength = [&](Index k) { return !observations.columns[k].containsAngles(); };
    const auto found = std::ranges::find_if(fit.columns, isLength);
    return found == fit.columns.end() ? Order::Position : observations.columns[*found].channel.order;
}

/// By which factor the speed of a fit over the angle of the crank has to change so that the prediction of a column
/// changes by `factorOfColumn` while the columns of the fit remain the same. `order`: that of the column;
/// `fittedOrder`: that of the lengths in the fit. An even power of the speed does not show its sign.
double ratioOfSpeeds(double factorOfColumn, Order order, Order fittedOrder)
{
    const int power = static_cast<int>(order) - static_cast<int>(fittedOrder);
    const double base = power % 2 == 0 ? std::abs(factorOfColumn) : factorOfColumn;
    return std::copysign(std::pow(std::abs(base), 1.0 / power), base);
}

/// Over the angle of the crank, velocities of lengths show the product a ω2, and accelerations a ω2². If a fit of
/// columns of one of these orders (and of angles) has assumed a wrong speed, it predicts lengths of other orders that
/// are off by a factor, which shows the true speed. Returns the fit together with such a column, in which the speed is
/// free; nullopt if no mechanism explains both, or if the column only contains difference quotients of the other one.
std::optional<Fit> withSpeedOfTwoOrders(const Observations &observations, const Fit &fit)
{
    const Order fittedOrder = orderOfLengths(observations, fit);
    Fit start = fit;
    start.unknowns.push_back(Parameter::Omega2);
    for (Index k = 0; k < std::ssize(observations.columns); ++k) {
        const ObservedColumn &column = observations.columns[k];
        if (column.containsAngles() || column.isConstant() || column.channel.order == fittedOrder) {
            continue;
        }
        const double factor =
            bestFactor(observations, fit.model, k) * signOfCoordinate(observations, fit, column.channel.coordinate);
        const double ratio = ratioOfSpeeds(factor, column.channel.order, fittedOrder);
        start.model = modelAtSpeed(observations, fit, ratio * fit.model.mechanism.omega2);
        if (std::optional<Fit> together = addInSimplestReading(observations, start, k)) {
            return together;
        }
    }
    return std::nullopt;
}

/// Angles show only ratios of lengths. Returns a fit of angles together with the first column of lengths that the same
/// mechanism explains in a different size; the same fit if there is none. If a table over the crank angle leaves ω2
/// open, a derivative shows the size at the assumed speed only. `drive`: the kind of the drive; if it is Uneven,
/// nothing predicts derivatives.
Fit withSizeOfLengths(const Observations &observations, const Fit &fit, Drive::Kind drive)
{
    Fit start = fit;
    start.unknowns.push_back(Parameter::A);
    for (Index k = 0; k < std::ssize(observations.columns); ++k) {
        const ObservedColumn &column = observations.columns[k];
        const bool isPredicted = drive != Drive::Kind::Uneven || !column.isDerivative();
        if (column.containsAngles() || column.isConstant() || !isPredicted) {
            continue;
        }
        start.model = fit.model;
        scaleLengths(start.model.mechanism, std::abs(bestFactor(observations, fit.model, k)));
        if (std::optional<Fit> together = addInSimplestReading(observations, start, k)) {
            return *std::move(together);
        }
    }
    return fit;
}

/// Sets result.speeds to the values of ω2 that the derivatives of a table over the crank angle allow, if the fit
/// predicts the size of derivatives at a known speed. A single value becomes an unknown of result.fit.
void addSpeedOfTable(FitWithSpeeds &result, const Observations &observations, double givenSpeed)
{
    Fit &fit = result.fit;
    if (fit.isFree(Parameter::Omega2) || isOnlyProductWithSpeedShown(observations, fit.columns)) {
        return;
    }
    result.speeds = findTableSpeeds(observations, fit, givenSpeed);
    if (result.speeds.size() == 1) { // the derivatives can be used, and improve it
        fit.unknowns.push_back(Parameter::Omega2);
        fit.model.mechanism.omega2 = result.speeds[0];
    }
}

} // namespace

Model modelAtSpeed(const Observations &observations, const Fit &fit, double omega2)
{
    Model model = fit.model;
    const Order order = orderOfLengths(observations, fit);
    const double factorOfColumns = std::pow(omega2 / model.mechanism.omega2, static_cast<double>(order));
    model.mechanism.omega2 = omega2;
    scaleLengths(model.mechanism, 1.0 / std::abs(factorOfColumns));
    for (const Index k : fit.columns) {
        if (observations.columns[k].channel.order == order) {
            model.readings[k].factor *= std::copysign(1.0, factorOfColumns);
        }
    }
    return model;
}

FitWithSpeeds withSpeedAndSize(const Observations &observations, const Fit &geometry, Drive::Kind drive,
                               double givenSpeed)
{
    FitWithSpeeds result{.fit = geometry};
    Fit &fit = result.fit;
    if (drive == Drive::Kind::OverAngle) {
        addSpeedOfTable(result, observations, givenSpeed);
    }
    if (observations.containOnlyAngles(fit.columns) && result.speeds.size() < 2) {
        fit = withSizeOfLengths(observations, fit, drive);
    }
    const bool isSpeedOpen = drive == Drive::Kind::OverAngle && !fit.isFree(Parameter::Omega2);
    if (isSpeedOpen && isOnlyProductWithSpeedShown(observations, fit.columns)) {
        fit = withSpeedOfTwoOrders(observations, fit).value_or(fit);
    }
    return result;
}

} // namespace slidercrank
