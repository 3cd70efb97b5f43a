// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mechanism.h"

#include <cassert>
#include <cmath>

namespace slidercrank
{

std::optional<ParameterFault> findFault(const Parameters &parameters)
{
    using Reason = ParameterFault::Reason;
    struct Entry {
        Parameter parameter;
        double value;
        bool mustBePositive;
    };
    const Entry entries[] = {{Parameter::A, parameters.a, true},
                             {Parameter::B, parameters.b, true},
                             {Parameter::C, parameters.c, false},
                             {Parameter::Omega2, parameters.omega2, false},
                             {Parameter::Theta20, parameters.theta20, false}};
    for (const Entry &entry : entries) {
        if (!std::isfinite(entry.value)) {
            return ParameterFault{entry.parameter, Reason::NotFinite};
        }
        if (std::abs(entry.value) > kLargestParameter) {
            return ParameterFault{entry.parameter, Reason::TooLarge};
        }
        if (entry.mustBePositive && !(entry.value > 0.0)) {
            return ParameterFault{entry.parameter, Reason::NotPositive};
        }
    }
    return std::nullopt;
}

Mechanism::Mechanism(const Parameters &parameters)
    : m_parameters(parameters)
{
    assert(!findFault(parameters));
}

} // namespace slidercrank
