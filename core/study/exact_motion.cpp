// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/exact_motion.h"

#include "core/closed_form/textbook_motion.h"

#include <cmath>

namespace slidercrank
{

namespace
{

/// Frees the constants that MPFR keeps for each thread when the thread ends.
struct ConstantsOfThread {
    ~ConstantsOfThread() { mpfr_free_cache(); }
};

} // namespace

ExactState exactState(const ExactInput &input)
{
    ExactState state;
    TextbookMotion<ManyDigits> motion;
    const bool isSolved =
        motion.compute({input.a, input.b, input.c, input.omega2}, input.omega2 * input.t + input.theta20,
                       input.branch == Branch::Open ? 1.0 : -1.0, acos(ManyDigits(-1.0)));
    state.clearance = (input.b - abs(input.c - motion.pinY[motion.kPosition])) / input.b;
    if (!isSolved && state.clearance < 0) {
        state.status = Status::NotAssemblable;
        return state;
    }
    state.status = isSolved ? Status::Solved : Status::Singular;
    state.cosTheta3 = (motion.sliderX[motion.kPosition] - motion.pinX[motion.kPosition]) / input.b;
    const std::size_t existingCount = isSolved ? kChannelCount : kCoordinateCount; // the positions come first
    for (std::size_t index = 0; index < existingCount; ++index) {
        state.values[index] = motion.valueAt(channelAt(index));
    }
    return state;
}

std::array<double, kChannelCount> conditioning(const Parameters &parameters, double t)
{
    const ManyDigits step = 1e-25;
    const ExactInput input(parameters, t);
    std::array<double, kChannelCount> kappa{};
    for (ManyDigits ExactInput::*number :
         {&ExactInput::a, &ExactInput::b, &ExactInput::c, &ExactInput::omega2, &ExactInput::theta20, &ExactInput::t}) {
        ExactInput more = input;
        ExactInput less = input;
        more.*number *= 1 + step;
        less.*number *= 1 - step;
        const ExactState above = exactState(more);
        const ExactState below = exactState(less);
        const bool exists = above.status == Status::Solved && below.status == Status::Solved;
        for (std::size_t index = 0; index < kChannelCount; ++index) {
            kappa[index] +=
                exists ? static_cast<double>(abs(above.values[index] - below.values[index]) / (2 * step)) : kInfinity;
        }
    }
    return kappa;
}

ExactValues exactValues(const Parameters &parameters, double t)
{
    thread_local const ConstantsOfThread constants;
    const ExactState exact = exactState(ExactInput(parameters, t));
    ExactValues result{.status = exact.status, .clearance = static_cast<double>(exact.clearance)};
    std::array<double, kChannelCount> kappa{};
    if (exact.status == Status::Solved) {
        kappa = conditioning(parameters, t);
    }
    for (std::size_t k = 0; k < kPlottedChannels.size(); ++k) {
        const std::size_t index = indexOf(kPlottedChannels[k]);
        const auto hi = static_cast<double>(exact.values[index]);
        result.values[k] = {hi, static_cast<double>(exact.values[index] - hi)};
        result.kappa[k] = kappa[index];
    }
    return result;
}

} // namespace slidercrank
