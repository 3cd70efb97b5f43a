// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mechanism/mechanism.h"

#include <cassert>
#include <cmath>

namespace slidercrank
{

namespace
{

/// Indexed by Parameter.
constexpr std::array kMembers{&Parameters::a, &Parameters::b, &Parameters::c, &Parameters::omega2,
                              &Parameters::theta20};

} // namespace

std::array<Parameters, 8> mirrorImages(const Parameters &p)
{
    constexpr double kHalfTurn = std::numbers::pi;
    std::array<Parameters, 8> images;
    auto image = images.begin();
    for (const Branch branch : {p.branch, oppositeBranch(p.branch)}) {
        *image++ = {p.a, p.b, p.c, p.omega2, p.theta20, branch};
        *image++ = {p.a, p.b, p.c, -p.omega2, kHalfTurn - p.theta20, branch};
        *image++ = {p.a, p.b, -p.c, -p.omega2, -p.theta20, branch};
        *image++ = {p.a, p.b, -p.c, p.omega2, p.theta20 + kHalfTurn, branch};
    }
    return images;
}

double &valueOf(Parameters &parameters, Parameter parameter)
{
    return parameters.*kMembers[indexOf(parameter)];
}

double valueOf(const Parameters &parameters, Parameter parameter)
{
    return parameters.*kMembers[indexOf(parameter)];
}

std::optional<ParameterFault> findFault(const Parameters &parameters)
{
    using Reason = ParameterFault::Reason;
    for (const Parameter parameter : kAllParameters) {
        const double value = valueOf(parameters, parameter);
        if (!std::isfinite(value)) {
            return ParameterFault{parameter, Reason::NotFinite};
        }
        if (std::abs(value) > kLargestParameter) {
            return ParameterFault{parameter, Reason::TooLarge};
        }
        if ((parameter == Parameter::A || parameter == Parameter::B) && value < kShortestLink) {
            return ParameterFault{parameter, value > 0.0 ? Reason::TooShort : Reason::NotPositive};
        }
    }
    return std::nullopt;
}

Mechanism::Mechanism(const Parameters &parameters)
    : m_parameters(parameters)
{
    assert(!findFault(parameters));
}

Mechanism withDrive(const Mechanism &mechanism, double omega2, double theta20)
{
    return Mechanism({mechanism.a(), mechanism.b(), mechanism.c(), omega2, theta20, mechanism.branch()});
}

std::string_view wordOf(Status status)
{
    constexpr std::array<std::string_view, kStatusCount> kWords{"solved", "singular", "iteration-limit",
                                                                "not-assemblable", "not-finite"};
    return kWords[static_cast<std::size_t>(status)];
}

} // namespace slidercrank
