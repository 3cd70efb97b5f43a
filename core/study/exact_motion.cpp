// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/exact_motion.h"

namespace slidercrank
{

template ExactState<Digits50> exactState(const ExactInput<Digits50> &);
template ExactState<Digits100> exactState(const ExactInput<Digits100> &);
template std::array<double, kChannelCount> conditioning<Digits50>(const Parameters &, double);
template std::array<double, kChannelCount> conditioning<Digits100>(const Parameters &, double);
template std::array<double, kChannelCount> channelSizes(const Parameters &, std::span<const ExactState<Digits50>>);
template std::array<double, kChannelCount> channelSizes(const Parameters &, std::span<const ExactState<Digits100>>);
template Deviation worstDeviation(const State &, const ExactState<Digits50> &, double,
                                  const std::array<double, kChannelCount> &, Order);
template Deviation worstDeviation(const State &, const ExactState<Digits100> &, double,
                                  const std::array<double, kChannelCount> &, Order);

} // namespace slidercrank
