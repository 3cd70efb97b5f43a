// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// One hypothesis about a file: how each column is to be interpreted, which parameters of the mechanism are free, and
// where the fit starts. Every fit and every comparison of the engine goes through forEachResidual().

#include "core/identification/motion_template.h"
#include "core/identification/observations.h"
#include "core/mechanism/mechanism.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace slidercrank
{

/// residual = scale · model + turn + offset − factor · value
struct ColumnUse {
    Channel channel;   ///< what the values are taken for
    double base = 1.0; ///< an angle under the heading of a length, or the reverse: undoes the conversion of the heading
    double unit = 1.0; ///< unit conversion
    double sign = 1.0;
    double perTime = 1.0; ///< for derivatives per another unit of time
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
    double abscissaFactor = 1.0; ///< by crank angle: its sign and unit
    Eigen::VectorXd unknowns;    ///< a, b, c, ω2, θ2 in the middle of the file; then the offsets and scales
    double side = 1.0;           ///< 1 open, -1 crossed
    std::array<bool, kParameterCount> isFree{true, true, true, true, true};
    double abscissaStep = 0.0; ///< rounding of the abscissa that is taken into account
    bool isBalanced = false;   ///< all columns weigh alike, as their spreads: for systematic deviations

    std::size_t freeParameterCount() const; ///< with offsets and scales
};

/// Where the offsets and scales stand among the unknowns; -1 where a column has none.
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

/// The mechanism with the crank angle of the middle of the file as θ20.
Parameters middleParameters(const Hypothesis &hypothesis);

/// The unknowns of such a mechanism, and its assembly.
void setMiddleParameters(const Parameters &middle, Hypothesis &hypothesis);

/// The mechanism with the crank angle at t = 0, in (-π, π]. Not for files by crank angle.
Parameters parametersOf(const Observations &data, const Hypothesis &hypothesis);

/// Parameters that differ by less than a thousandth of their size; the crank angle by less than 1e-3 rad.
bool areNear(const Parameters &x, const Parameters &y);

/// Every column as its heading says, without free offsets.
std::vector<ColumnUse> plainColumns(const Observations &data);

/// How often the crank angle counts the abscissa: ω2, or what the angle of the file has to be multiplied by.
inline double phaseRate(const Observations &data, const Hypothesis &hypothesis, const Eigen::VectorXd &unknowns)
{
    return data.isByCrankAngle ? hypothesis.abscissaFactor : unknowns[3];
}

/// Calls use(row, column, model value, residual) for every value of the used columns. T is double, or Dual for the
/// derivatives of the model by the five parameters. Returns false if the mechanism cannot be assembled in some row.
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

/// Sums for the regression of a column on a channel of the model. Values are taken about `center`, so that a small
/// motion far from zero keeps its digits.
struct ColumnRegression {
    double center = 0.0;
    double n = 0.0, sumModel = 0.0, sumValue = 0.0, sumModel2 = 0.0, sumValue2 = 0.0, sumProduct = 0.0;

    void add(double model, double value);

    double modelSquares() const; ///< about the mean
    double valueSquares() const;
    double products() const;

    /// 1 − ρ²: the part of the variance that the model does not explain, whatever its unit, sign and origin.
    double unexplained() const;
    double slope() const; ///< value per model

    /// Mean square of factor · value − size · model about its mean, and that mean.
    double meanSquare(double factor, double size) const;
    double offset(double factor, double size) const;
};

/// One regression for each column, used or not considered; empty if the mechanism cannot be assembled in some row.
std::vector<ColumnRegression> columnRegressions(const Observations &data, const Hypothesis &hypothesis);

} // namespace slidercrank
