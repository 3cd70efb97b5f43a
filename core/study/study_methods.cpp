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

/// One value for each of kPlottedChannels.
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
    method.prepare = [options](const Case &which, std::span<const double> timeStamps) -> StudyRun {
        return [options, mechanism = Mechanism(which.parameters), timeStamps](StudyAnswers &answers) {
            NewtonTimeStep last;
            answers.iterations = 0;
            for (std::size_t i = 0; i < timeStamps.size(); ++i) {
                advance(mechanism, timeStamps[i], last, options);
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
    method.prepare = [](const Case &which, std::span<const double> timeStamps) -> StudyRun {
        return [closedForm = ClosedForm(Mechanism(which.parameters)), timeStamps](StudyAnswers &answers) {
            for (std::size_t i = 0; i < timeStamps.size(); ++i) {
                put(answers, i, closedForm.stateAt(timeStamps[i]));
            }
        };
    };
    return method;
}

StudyMethod closedFormBatch()
{
    StudyMethod method{.name = {MethodName::Kind::ClosedFormBatch}, .dependsOnStep = false};
    method.prepare = [](const Case &which, std::span<const double> timeStamps) -> StudyRun {
        return [batch = ClosedForm(Mechanism(which.parameters)), timeStamps](StudyAnswers &answers) {
            auto &values = answers.values;
            batch.evaluate(timeStamps,
                           {values[0].data(), values[1].data(), values[2].data(), values[3].data(), values[4].data(),
                            values[5].data()},
                           answers.status);
        };
    };
    return method;
}

/// Computes positions in closed form at the steps of the sampling and one step beyond either end, and derivatives from
/// their differences.
StudyMethod finiteDifference()
{
    StudyMethod method{.name = {MethodName::Kind::FiniteDifference}, .timeStamps = StudyMethod::TimeStamps::Sampling};
    method.prepare = [](const Case &which, std::span<const double> timeStamps) -> StudyRun {
        const double step = which.sampling.duration / which.sampling.steps;
        std::vector<double> sampled{which.sampling.timeStamp(-1)};
        sampled.insert(sampled.end(), timeStamps.begin(), timeStamps.end());
        sampled.push_back(which.sampling.timeStamp(which.sampling.steps + 1));
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
    method.prepare = [count](const Case &which, std::span<const double> timeStamps) -> StudyRun {
        const Mechanism mechanism(which.parameters);
        if (!HarmonicSeries::existsFor(mechanism)) {
            return {};
        }
        return [series = HarmonicSeries(mechanism, count), timeStamps](StudyAnswers &answers) {
            for (std::size_t i = 0; i < timeStamps.size(); ++i) {
                const auto [theta3, slider] = series.at(timeStamps[i]);
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

    // NewtonDense has the residual and the iteration limit of the reference report. The others have a residual that is
    // independent of scale, and an iteration limit that suffices at a toggle.
    struct Variant {
        MethodName::Kind kind;
        WarmStart warmStart;
        Elimination elimination;
    };
    constexpr std::array kVariants{
        Variant{MethodName::Kind::NewtonDenseTaylor, WarmStart::Taylor, Elimination::Dense},
        Variant{MethodName::Kind::NewtonStructured, WarmStart::Previous, Elimination::Structured},
        Variant{MethodName::Kind::NewtonStructuredTaylor, WarmStart::Taylor, Elimination::Structured},
    };
    std::vector<StudyMethod> methods;
    for (const double tolerance : kTolerances) {
        NewtonOptions report;
        report.tolerance = tolerance;
        methods.push_back(newton(MethodName::Kind::NewtonDense, report));
    }
    for (const Variant &variant : kVariants) {
        for (const double tolerance : kTolerances) {
            methods.push_back(newton(variant.kind, {kColdStartIterations, tolerance, ToleranceKind::Relative,
                                                    variant.warmStart, variant.elimination}));
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
