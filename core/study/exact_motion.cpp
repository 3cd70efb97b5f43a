// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/exact_motion.h"

namespace slidercrank
{

template ExactState<Digits50> exactState(const ExactInput<Digits50> &);
template ExactState<Digits100> exactState(const ExactInput<Digits100> &);
template std::array<double, kChannelCount> conditioning<Digits50>(const Parameters &, double);
template std::array<double, kChannelCount> conditioning<Digits100>(const Parameters &, double);

} // namespace slidercrank
