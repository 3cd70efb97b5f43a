// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/study_methods.h"

#include "core/closed_form/closed_form.h"
#include "core/closed_form/state_at.h"
#include "core/newton/newton.h"
#include "core/study/finite_difference.h"
#include "core/study/harmonic_series.h"

#include <cmath>
#include <utility>

namespace slidercrank
{

namespace
{

/// By kPlottedChannels.
using Values = std::array<double, kPlottedChannels.size()>;

void put(StudyAnswers &answers, std::size_t i, const Values &values, Status status)
{
    for (std::size_t k = 0; k < values.size(); ++k) {
        answers.values[k][i] = values[k];
    }
    answers.status[i] = status;
}

void put(StudyAnswers &answers, std::size_t i, const State &state)
{
    put(answers, i,
        {state.q[Theta3], state.q[R4x], state.qDot[Theta3], state.qDot[R4x], state.qDDot[Theta3], state.qDDot[R4x]},
        state.status);
}

StudyMethod newton(MethodName::Kind kind, const NewtonOptions &options)
{
    StudyMethod method{.name = {kind}, .tolerance = options.tolerance, .channels = static_cast<int>(kChannelCount)};
    method.prepare = [options](const Case &which, std::span<const double> instants) -> StudyRun {
        return [options, mechanism = Mechanism(which.parameters), instants](StudyAnswers &answers) {
            NewtonInstant last;
            answers.iterations = 0;
            for (std::size_t i = 0; i < instants.size(); ++i) {
                advance(mechanism, instants[i], last, options);
                answers.iterations += last.iterations;
                put(answers, i, last.state);
            }
        };
    };
    return method;
}

StudyMethod closedForm()
{
    StudyMethod method{.name = {MethodName::Kind::ClosedForm}, .channels = static_cast<int>(kChannelCount)};
    method.dependsOnStep = false;
    method.prepare = [](const Case &which, std::span<const double> instants) -> StudyRun {
        return [closedForm = ClosedForm(Mechanism(which.parameters)), instants](StudyAnswers &answers) {
            for (std::size_t i = 0; i < instants.size(); ++i) {
                put(answers, i, closedForm.stateAt(instants[i]));
            }
        };
    };
    return method;
}

StudyMethod closedFormBatch()
{
    StudyMethod method{.name = {MethodName::Kind::ClosedFormBatch}, .dependsOnStep = false};
    method.prepare = [](const Case &which, std::span<const double> instants) -> StudyRun {
        return [batch = ClosedForm(Mechanism(which.parameters)), instants](StudyAnswers &answers) {
            auto &values = answers.values;
            batch.evaluate(instants,
                           {values[0].data(), values[1].data(), values[2].data(), values[3].data(), values[4].data(),
                            values[5].data()},
                           answers.status);
        };
    };
    return method;
}

/// Positions in closed form at the steps of the sampling and one beyond either end, derivatives from their differences.
StudyMethod finiteDifference()
{
    StudyMethod method{.name = {MethodName::Kind::FiniteDifference}, .instants = StudyMethod::Instants::Sampling};
    method.prepare = [](const Case &which, std::span<const double> instants) -> StudyRun {
        const double step = which.sampling.duration / which.sampling.steps;
        std::vector<double> sampled{which.sampling.instant(-1)};
        sampled.insert(sampled.end(), instants.begin(), instants.end());
        sampled.push_back(which.sampling.instant(which.sampling.steps + 1));
        std::vector<Motion> motions(sampled.size());
        return [closedForm = ClosedForm(Mechanism(which.parameters)), step, sampled,
                motions](StudyAnswers &answers) mutable {
            for (std::size_t i = 0; i < sampled.size(); ++i) {
                motions[i] = closedForm.motionAt(sampled[i]);
            }
            for (std::size_t i = 0; i < answers.status.size(); ++i) {
                const std::span<const Motion, 3> three(&motions[i], 3);
                const Derivatives theta3 = centralDifferences(three[0].theta3, three[1].theta3, three[2].theta3, step);
                const Derivatives slider = centralDifferences(three[0].R4x, three[1].R4x, three[2].R4x, step);
                const Status status = !std::isnan(slider.second)  ? Status::Solved
                                      : !std::isnan(three[1].R4x) ? Status::Singular
                                                                  : Status::NotAssemblable;
                put(answers, i,
                    {three[1].theta3, three[1].R4x, theta3.first, slider.first, theta3.second, slider.second}, status);
            }
        };
    };
    return method;
}

StudyMethod harmonics(int count)
{
    StudyMethod method{.name = {MethodName::Kind::Harmonics, count}, .dependsOnStep = false};
    method.prepare = [count](const Case &which, std::span<const double> instants) -> StudyRun {
        const Mechanism mechanism(which.parameters);
        if (!HarmonicSeries::existsFor(mechanism)) {
            return {};
        }
        return [series = HarmonicSeries(mechanism, count), instants](StudyAnswers &answers) {
            for (std::size_t i = 0; i < instants.size(); ++i) {
                const auto [theta3, slider] = series.at(instants[i]);
                put(answers, i, {theta3.value, slider.value, theta3.first, slider.first, theta3.second, slider.second},
                    Status::Solved);
            }
        };
    };
    return method;
}

std::vector<StudyMethod> makeMethods()
{
    constexpr std::array kTolerances{1e-4, kReportsTolerance, 1e-12, 0.0};
    constexpr std::array kHarmonics{2, 4, 8, 16, 32};

    // The report's way has the report's residual and cap; the others a residual that is the same at every scale, and a
    // cap that a toggle does not reach.
    struct Way {
        MethodName::Kind kind;
        WarmStart warmStart;
        Elimination elimination;
    };
    constexpr std::array kWays{
        Way{MethodName::Kind::NewtonDenseTaylor, WarmStart::Taylor, Elimination::Dense},
        Way{MethodName::Kind::NewtonStructured, WarmStart::Previous, Elimination::Structured},
        Way{MethodName::Kind::NewtonStructuredTaylor, WarmStart::Taylor, Elimination::Structured},
    };
    std::vector<StudyMethod> methods;
    for (const double tolerance : kTolerances) {
        NewtonOptions report;
        report.tolerance = tolerance;
        methods.push_back(newton(MethodName::Kind::NewtonDense, report));
    }
    for (const Way &way : kWays) {
        for (const double tolerance : kTolerances) {
            methods.push_back(newton(
                way.kind, {kColdStartIterations, tolerance, ToleranceKind::Relative, way.warmStart, way.elimination}));
        }
    }
    methods.push_back(closedForm());
    methods.push_back(closedFormBatch());
    methods.push_back(finiteDifference());
    for (const int count : kHarmonics) {
        methods.push_back(harmonics(count));
    }
    return methods;
}

} // namespace

std::string nameOf(const MethodName &method)
{
    constexpr std::array kNames{"newton-dense", "newton-dense-taylor", "newton-structured", "newton-structured-taylor",
                                "closed-form",  "closed-form-batch",   "finite-difference"};
    return method.kind == MethodName::Kind::Harmonics ? "harmonic-" + std::to_string(method.harmonics)
                                                      : kNames[static_cast<std::size_t>(method.kind)];
}

const std::vector<StudyMethod> &studyMethods()
{
    static const std::vector<StudyMethod> kMethods = makeMethods();
    return kMethods;
}

} // namespace slidercrank
