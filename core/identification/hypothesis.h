// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A hypothesis about a file: how each column is interpreted, which parameters of the mechanism are free, and where the
// fit starts. forEachResidual() is the only loop that evaluates the model.

#include "core/identification/motion_template.h"
#include "core/identification/observations.h"
#include "core/mechanism/mechanism.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace slidercrank
{

/// The interpretation of a column:
///
///     residual = scale · model + turn + offset − factor · value
struct ColumnUse {
    Channel channel; ///< that the values are taken for
    double base =
        1.0; ///< undoes the unit conversion of the heading if an angle has the heading of a length, or the reverse
    double unit = 1.0; ///< unit conversion
    double sign = 1.0;
    double perTime = 1.0; ///< for derivatives with respect to time in another unit
    double turn = 0.0;    ///< half turns, rad
    bool isUsed = true;
    bool hasOffset = false; ///< a free origin offset
    bool hasScale = false;  ///< a free scale

    double factor() const { return base * unit * sign * perTime; }
    bool isHalfTurned() const;
    bool isPlain() const { return factor() == 1.0 && !isHalfTurned() && !hasOffset && isUsed; }

    friend bool operator==(const ColumnUse &, const ColumnUse &) = default;
};

struct Hypothesis {
    std::vector<ColumnUse> columns;
    double timeUnit = 1.0;
    double abscissaFactor = 1.0; ///< of a file by crank angle: its sign and unit
    Eigen::VectorXd unknowns;    ///< a, b, c, ω2, θ2 in the middle of the file; then the offsets and scales
    double side = 1.0;           ///< 1 open, -1 crossed
    std::array<bool, kParameterCount> isFree{true, true, true, true, true};
    double abscissaStep = 0.0; ///< the rounding step of the abscissa that the fit takes into account
    bool isBalanced = false;   ///< weighs all columns by their spreads, for systematic deviations

    std::size_t freeParameterCount() const; ///< including offsets and scales
};

/// The indices of the offsets and scales among the unknowns; -1 for a column that has none.
struct UnknownLayout {
    std::vector<Eigen::Index> offset;
    std::vector<Eigen::Index> scale;
    Eigen::Index size = static_cast<Eigen::Index>(kParameterCount);

    explicit UnknownLayout(const std::vector<ColumnUse> &columns);

    double offsetOf(std::size_t column, const Eigen::VectorXd &unknowns) const
    {
        return at(offset[column], unknowns, 0.0);
    }
    double scaleOf(std::size_t column, const Eigen::VectorXd &unknowns) const
    {
        return at(scale[column], unknowns, 1.0);
    }

private:
    static double at(Eigen::Index index, const Eigen::VectorXd &unknowns, double otherwise)
    {
        return index >= 0 && index < unknowns.size() ? unknowns[index] : otherwise;
    }
};

/// The fitted mechanism, with the crank angle in the middle of the file as θ20.
Parameters middleParameters(const Hypothesis &hypothesis);

/// Sets the five parameters and the assembly to those of `middle`, without offsets and scales.
void setMiddleParameters(const Parameters &middle, Hypothesis &hypothesis);

/// The fitted mechanism, with the crank angle at t = 0 as θ20, in (-π, π]. Not for files by crank angle.
Parameters parametersOf(const Observations &data, const Hypothesis &hypothesis);

/// Parameters that differ by less than a thousandth of their size; the crank angle by less than 1e-3 rad.
bool areNear(const Parameters &x, const Parameters &y);

/// Interprets every column as its heading says, without free offsets.
std::vector<ColumnUse> plainColumns(const Observations &data);

/// The derivative of the crank angle with respect to the abscissa: ω2, or the factor of a crank angle in the file.
inline double phaseRate(const Observations &data, const Hypothesis &hypothesis, const Eigen::VectorXd &unknowns)
{
    return data.isByCrankAngle ? hypothesis.abscissaFactor : unknowns[3];
}

/// Calls use(row, column, model value, residual) for every value of the used columns. T is double, or Dual for the
/// derivatives of the model with respect to the five parameters. Returns false if the mechanism cannot be assembled in
/// some row.
template <class T, class F>
bool forEachResidual(const Observations &data, const Hypothesis &hypothesis, const Eigen::VectorXd &unknowns, F use)
{
    std::array<T, kParameterCount> parameters;
    for (int i = 0; i < static_cast<int>(kParameterCount); ++i) {
        if constexpr (std::is_same_v<T, Dual>) {
            parameters[static_cast<std::size_t>(i)] = Dual(unknowns[i], static_cast<int>(kParameterCount), i);
        } else {
            parameters[static_cast<std::size_t>(i)] = unknowns[i];
        }
    }
    const UnknownLayout layout(hypothesis.columns);
    MotionTemplate<T> motion;
    for (std::size_t row = 0; row < data.abscissa.size(); ++row) {
        const double at = data.abscissa[row];
        const T crankAngle = data.isByCrankAngle ? T(parameters[4] + hypothesis.abscissaFactor * at)
                                                 : T(parameters[3] * at + parameters[4]);
        if (!motion.compute(parameters, crankAngle, hypothesis.side)) {
            return false;
        }
        for (std::size_t j = 0; j < data.columns.size(); ++j) {
            const double value = data.columns[j].values[row];
            const ColumnUse &column = hypothesis.columns[j];
            if (column.isUsed && !std::isnan(value)) {
                const T model = motion.valueAt(column.channel);
                use(row, j, model,
                    layout.scaleOf(j, unknowns) * plainValue(model) + column.turn + layout.offsetOf(j, unknowns) -
                        column.factor() * value);
            }
        }
    }
    return true;
}

/// Sums for the linear regression of a column on a channel of the model. `center` is subtracted from the values, so
/// that a small motion far from zero keeps its digits.
struct ColumnRegression {
    double center = 0.0;
    double n = 0.0, sumModel = 0.0, sumValue = 0.0, sumModel2 = 0.0, sumValue2 = 0.0, sumProduct = 0.0;

    void add(double model, double value);

    // Sums of squares and products about the means.
    double modelSquares() const;
    double valueSquares() const;
    double products() const;

    /// 1 − ρ²: the part of the variance that the model does not explain with any unit, sign and origin.
    double unexplained() const;
    /// The slope of the best line: value per model.
    double slope() const;

    /// Variance and mean of factor · value − size · model.
    double meanSquare(double factor, double size) const;
    double offset(double factor, double size) const;
};

/// One regression for each column, without values if the column is not used; empty if the mechanism cannot be assembled
/// in some row.
std::vector<ColumnRegression> columnRegressions(const Observations &data, const Hypothesis &hypothesis);

} // namespace slidercrank
