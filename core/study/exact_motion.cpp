// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/exact_motion.h"

namespace slidercrank
{

namespace
{

template <class Real>
Judged judgedFrom(const Parameters &parameters, double t, const ExactState<Real> &exact)
{
    Judged judged{exact.status, static_cast<double>(exact.clearance), {}, {}};
    std::array<double, kChannelCount> kappa{};
    if (exact.status == Status::Solved) {
        kappa = conditioning<Real>(parameters, t);
    }
    for (std::size_t k = 0; k < kPlottedChannels.size(); ++k) {
        const std::size_t index = indexOf(kPlottedChannels[k]);
        const auto hi = static_cast<double>(exact.values[index]);
        judged.values[k] = {hi, static_cast<double>(Real(exact.values[index] - hi))};
        judged.kappa[k] = kappa[index];
    }
    return judged;
}

} // namespace

Judged judge(const Parameters &parameters, double t)
{
    // The formulas cancel as the clearance falls, to its third power; the difference quotient in κ takes 25 digits.
    constexpr double kEnoughClearance = 1e-4;
    const ExactState<Digits50> exact = exactState<Digits50>(parameters, t);
    return exact.clearance > kEnoughClearance ? judgedFrom(parameters, t, exact)
                                              : judgedFrom(parameters, t, exactState<Digits100>(parameters, t));
}

template ExactState<Digits50> exactState(const ExactInput<Digits50> &);
template ExactState<Digits100> exactState(const ExactInput<Digits100> &);
template std::array<double, kChannelCount> conditioning<Digits100>(const Parameters &, double);

} // namespace slidercrank
