// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A hypothesis about a file: how each column is interpreted, which parameters of the mechanism are free, and where the
// fit starts. forEachResidual() is the only loop that evaluates the model.

#include "core/closed_form/textbook_motion.h"
#include "core/identification/observations.h"
#include "core/mechanism/mechanism.h"

#include <Eigen/Core>
#include <unsupported/Eigen/AutoDiff>

#include <array>
#include <vector>

namespace slidercrank
{

/// The interpretation of a column:
///
///     residual = scale · model + turn + offset − factor · value
struct ColumnUse {
    Channel channel;         ///< that the values are taken for
    double unit = 1.0;       ///< unit conversion, negative if the axis is opposite
    double conversion = 1.0; ///< for another unit of time, and for a length with the heading of an angle or the reverse
    double turn = 0.0;       ///< half turns, rad
    bool isUsed = true;
    bool hasOffset = false; ///< a free origin offset
    bool hasScale = false;  ///< a free scale

    double factor() const { return unit * conversion; }
    bool isHalfTurned() const;
    bool isPlain() const { return factor() == 1.0 && !isHalfTurned() && !hasOffset && isUsed; }

    friend bool operator==(const ColumnUse &, const ColumnUse &) = default;
};

struct Hypothesis {
    std::vector<ColumnUse> columns;
    double timeUnit = 1.0;
    double abscissaFactor = 1.0; ///< of a file by crank angle: its sign and unit
    Eigen::VectorXd unknowns;    ///< a, b, c, ω2, θ2 in the middle of the file; then offset and scale of each column
    double side = 1.0;           ///< 1 open, -1 crossed
    std::array<bool, kParameterCount> isFree{true, true, true, true, true};
    double abscissaStep = 0.0; ///< the rounding step of the abscissa that the fit takes into account

    /// Index of a column's offset among the unknowns. Its scale is the next unknown.
    static Eigen::Index offsetIndex(std::size_t column)
    {
        return static_cast<Eigen::Index>(kParameterCount + 2 * column);
    }
    double offset(std::size_t column) const { return columns[column].hasOffset ? unknowns[offsetIndex(column)] : 0.0; }
    double scale(std::size_t column) const
    {
        return columns[column].hasScale ? unknowns[offsetIndex(column) + 1] : 1.0;
    }

    bool isFreeUnknown(Eigen::Index index) const;

    /// The derivative of the crank angle with respect to the abscissa: ω2, or the factor of a crank angle in the file.
    double phaseRate(const Observations &data) const { return data.isByCrankAngle ? abscissaFactor : unknowns[3]; }
};

/// The crank angle in a row, rad.
inline double crankAngle(const Observations &data, const Hypothesis &hypothesis, std::size_t row)
{
    return hypothesis.phaseRate(data) * data.abscissa[row] + hypothesis.unknowns[4];
}

/// The fitted mechanism, with the crank angle in the middle of the file as θ20.
Parameters middleParameters(const Hypothesis &hypothesis);

/// Sets the five parameters and the assembly to those of `middle`, without offsets and scales.
void setMiddleParameters(const Parameters &middle, Hypothesis &hypothesis);

/// The fitted mechanism, with ω2 in rad/s, and with the crank angle at t = 0 as θ20, in (-π, π]. θ20 is meaningless for
/// files by crank angle.
Parameters parametersOf(const Observations &data, const Hypothesis &hypothesis);

/// The sizes with which differences of the parameters are compared; of θ20, 1 rad.
std::array<double, kParameterCount> comparisonSizes(const Parameters &parameters);

/// Whether two mechanisms have the same assembly, and their parameters differ by at most `part` of the size of each, or
/// by five standard errors. NaN: no standard error.
bool areNear(const Parameters &x, const Parameters &y, double part = 1e-3,
             const std::array<double, kParameterCount> &standardErrors = {});

/// Interprets every column as its heading says, without free offsets.
std::vector<ColumnUse> plainColumns(const Observations &data);

/// The spread of a column in its interpretation.
double interpretedSpread(const Observations &data, const Hypothesis &hypothesis, std::size_t column);

/// The size with which deviations of a column are compared: its spread in its interpretation, or, if it is constant by
/// nature, the parameter that determines its size: a for R4y, ω2 for the crank speed.
double sizeOf(const Observations &data, const Hypothesis &hypothesis, std::size_t column);

/// A number with its derivatives with respect to a, b, c, ω2 and θ2. The sixth one is not used: processors compute two
/// or more at a time.
using Dual = Eigen::AutoDiffScalar<Eigen::Matrix<double, 6, 1>>;

inline double plainValue(double x)
{
    return x;
}

inline double plainValue(const Dual &x)
{
    return x.value();
}

/// Calls use(row, column, model value, residual) for every value of the used columns. T is double, or Dual for the
/// derivatives of the model with respect to the five parameters. Returns false if the mechanism cannot be assembled in
/// some row.
template <class T, class F>
bool forEachResidual(const Observations &data, const Hypothesis &hypothesis, F use)
{
    std::array<T, kParameterCount> parameters;
    for (std::size_t i = 0; i < kParameterCount; ++i) {
        parameters[i] = T(hypothesis.unknowns[static_cast<Eigen::Index>(i)]);
        if constexpr (std::is_same_v<T, Dual>) {
            parameters[i].derivatives()[static_cast<Eigen::Index>(i)] = 1.0;
        }
    }
    TextbookMotion<T> motion;
    for (std::size_t row = 0; row < data.abscissa.size(); ++row) {
        const double at = data.abscissa[row];
        const T angle = data.isByCrankAngle ? T(parameters[4] + hypothesis.abscissaFactor * at)
                                            : T(parameters[3] * at + parameters[4]);
        if (!motion.compute(parameters, angle, hypothesis.side)) {
            return false;
        }
        for (std::size_t j = 0; j < data.columns.size(); ++j) {
            const double value = data.columns[j].values[row];
            const ColumnUse &column = hypothesis.columns[j];
            if (column.isUsed && !std::isnan(value)) {
                const T model = motion.valueAt(column.channel);
                use(row, j, model,
                    hypothesis.scale(j) * plainValue(model) + column.turn + hypothesis.offset(j) -
                        column.factor() * value);
            }
        }
    }
    return true;
}

/// The linear regression of a column on a channel of the model. `center` is subtracted from the values, so that a small
/// motion far from zero keeps its digits.
struct ColumnRegression {
    double center = 0.0;
    double n = 0.0;
    double meanModel = 0.0, meanValue = 0.0;
    double modelSquares = 0.0, valueSquares = 0.0, products = 0.0; ///< sums about the means

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
