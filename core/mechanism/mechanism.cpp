// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mechanism/mechanism.h"

#include "core/mechanism/turn.h"

#include <cassert>
#include <cmath>

namespace slidercrank
{

namespace
{

constexpr double Parameters::*memberFor(Parameter parameter)
{
    switch (parameter) {
    case Parameter::A: return &Parameters::a;
    case Parameter::B: return &Parameters::b;
    case Parameter::C: return &Parameters::c;
    case Parameter::Omega2: return &Parameters::omega2;
    case Parameter::Theta20: break;
    }
    return &Parameters::theta20;
}

// A reflection in the y axis, or in both axes, also exchanges the branches. The following functions do not set the
// branch: mirrorImages() calls each of them for both branches.

/// Returns the mechanism whose points have the opposite x, apart from its branch, which is the opposite one.
Parameters mirroredInY(Parameters parameters)
{
    parameters.omega2 = -parameters.omega2;
    parameters.theta20 = std::numbers::pi - parameters.theta20;
    return parameters;
}

/// Returns the mechanism whose points have the opposite y.
Parameters mirroredInX(Parameters parameters)
{
    parameters.c = -parameters.c;
    parameters.omega2 = -parameters.omega2;
    parameters.theta20 = -parameters.theta20;
    return parameters;
}

/// Returns the mechanism that is turned by half a revolution about the crank pivot, apart from its branch, which is the
/// opposite one.
Parameters mirroredInBoth(Parameters parameters)
{
    parameters.c = -parameters.c;
    parameters.theta20 = parameters.theta20 + std::numbers::pi;
    return parameters;
}

} // namespace

std::array<Parameters, 8> mirrorImages(const Parameters &parameters)
{
    std::array<Parameters, 8> images;
    auto image = images.begin();
    for (const Branch branch : {parameters.branch, oppositeBranch(parameters.branch)}) {
        Parameters onBranch = parameters;
        onBranch.branch = branch;
        *image++ = onBranch;
        *image++ = mirroredInY(onBranch);
        *image++ = mirroredInX(onBranch);
        *image++ = mirroredInBoth(onBranch);
    }
    return images;
}

double &valueOf(Parameters &parameters, Parameter parameter)
{
    return parameters.*memberFor(parameter);
}

double valueOf(const Parameters &parameters, Parameter parameter)
{
    return parameters.*memberFor(parameter);
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
    Parameters parameters = mechanism.parameters();
    parameters.omega2 = omega2;
    // After very many turns, the crank angle of a motion is larger than a parameter may be.
    parameters.theta20 = std::abs(theta20) <= kLargestParameter ? theta20 : wrapToPi(theta20);
    return Mechanism(parameters);
}

std::string_view nameOf(Status status)
{
    switch (status) {
    case Status::Solved: break;
    case Status::Singular: return "singular";
    case Status::IterationLimit: return "iteration-limit";
    case Status::NotAssemblable: return "not-assemblable";
    case Status::NotFinite: return "not-finite";
    }
    return "solved";
}

} // namespace slidercrank
