// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/finite_difference.h"

#include <cassert>
#include <cstddef>

namespace slidercrank
{

void centralDifferences(std::span<const double> samples, double step, std::span<double> first, std::span<double> second)
{
    assert(samples.size() >= 2 && first.size() == samples.size() - 2 && second.size() == first.size());
    for (std::size_t i = 0; i < first.size(); ++i) {
        const double rise = samples[i + 2] - samples[i + 1];
        const double riseBefore = samples[i + 1] - samples[i];
        first[i] = (rise + riseBefore) / (2.0 * step);
        second[i] = (rise - riseBefore) / (step * step);
    }
}

} // namespace slidercrank
