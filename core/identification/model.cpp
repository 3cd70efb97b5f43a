// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/model.h"

namespace slidercrank
{

Eigen::ArrayXXd computeMotion(const Model &model, const Observations &observations, const Indices &columns)
{
    const Parameters &m = model.mechanism;
    Eigen::ArrayXXd result = Eigen::ArrayXXd::Constant(observations.size(), std::ssize(columns), kNone);
    for (Index row = 0; row < observations.size() && !observations.stop.stop_requested(); ++row) {
        TextbookMotion<double> motion;
        if (!computeUnitSpeedMotion(motion, m.branch, {m.a, m.b, m.c}, model.crankAngle(observations, row),
                                    model.isApproximateFormula)) {
            continue;
        }
        const double speed = model.crankSpeed(observations, row);
        const double acceleration = model.crankAcceleration(observations, row);
        for (Index i = 0; i < result.cols(); ++i) {
            const Channel channel = observations.columns[columns[i]].channel;
            result(row, i) = motionAtSpeed(motion, channel, speed, acceleration);
        }
    }
    return result;
}

Eigen::ArrayXXd predictValues(const Model &model, const Observations &observations, const Indices &columns)
{
    Eigen::ArrayXXd result = computeMotion(model, observations, columns);
    for (Index i = 0; i < result.cols(); ++i) {
        const ColumnReading &reading = model.readings[columns[i]];
        result.col(i) = reading.factor * result.col(i) + reading.origin;
    }
    return result;
}

} // namespace slidercrank
