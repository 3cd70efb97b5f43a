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
enum Value : std::size_t { Theta3Value, R4xValue, Theta3Rate, R4xRate, Theta3Acceleration, R4xAcceleration };

void put(StudyAnswers &answers, std::size_t i, const State &state)
{
    answers.values[Theta3Value][i] = state.q[Theta3];
    answers.values[R4xValue][i] = state.q[R4x];
    answers.values[Theta3Rate][i] = state.qDot[Theta3];
    answers.values[R4xRate][i] = state.qDot[R4x];
    answers.values[Theta3Acceleration][i] = state.qDDot[Theta3];
    answers.values[R4xAcceleration][i] = state.qDDot[R4x];
    answers.status[i] = state.status;
}

StudyMethod newton(MethodName::Kind kind, NewtonOptions options)
{
    StudyMethod method;
    method.name = {kind};
    method.tolerance = options.tolerance;
    method.toleranceKind = options.toleranceKind;
    method.channels = static_cast<int>(kChannelCount);
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
    StudyMethod method;
    method.name = {MethodName::Kind::ClosedForm};
    method.dependsOnStep = false;
    method.channels = static_cast<int>(kChannelCount);
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
    StudyMethod method;
    method.name = {MethodName::Kind::ClosedFormBatch};
    method.dependsOnStep = false;
    method.prepare = [](const Case &which, std::span<const double> instants) -> StudyRun {
        return [batch = ClosedForm(Mechanism(which.parameters)), instants](StudyAnswers &answers) {
            const auto column = [&answers](Value value) { return answers.values[value].data(); };
            const PlottedColumns columns{column(Theta3Value), column(R4xValue),           column(Theta3Rate),
                                         column(R4xRate),     column(Theta3Acceleration), column(R4xAcceleration)};
            batch.evaluate(instants, columns, answers.status);
        };
    };
    return method;
}

/// Positions in closed form at the steps of the sampling and one beyond either end, derivatives from their differences.
StudyMethod finiteDifference()
{
    StudyMethod method;
    method.name = {MethodName::Kind::FiniteDifference};
    method.instants = StudyMethod::Instants::Sampling;
    method.prepare = [](const Case &which, std::span<const double> instants) -> StudyRun {
        const double step = which.sampling.duration / which.sampling.steps;
        std::vector<double> sampled{which.sampling.instant(-1)};
        sampled.insert(sampled.end(), instants.begin(), instants.end());
        sampled.push_back(which.sampling.instant(which.sampling.steps + 1));
        std::vector<double> theta3(sampled.size());
        std::vector<double> slider(sampled.size());
        return [closedForm = ClosedForm(Mechanism(which.parameters)), step, sampled = std::move(sampled),
                theta3 = std::move(theta3), slider = std::move(slider)](StudyAnswers &answers) mutable {
            for (std::size_t i = 0; i < sampled.size(); ++i) {
                const Motion motion = closedForm.motionAt(sampled[i]);
                theta3[i] = motion.theta3;
                slider[i] = motion.R4x;
            }
            centralDifferences(theta3, step, answers.values[Theta3Rate], answers.values[Theta3Acceleration]);
            centralDifferences(slider, step, answers.values[R4xRate], answers.values[R4xAcceleration]);
            for (std::size_t i = 0; i < answers.status.size(); ++i) {
                answers.values[Theta3Value][i] = theta3[i + 1];
                answers.values[R4xValue][i] = slider[i + 1];
                const bool hasDerivatives = !std::isnan(answers.values[R4xAcceleration][i]);
                answers.status[i] = hasDerivatives               ? Status::Solved
                                    : !std::isnan(slider[i + 1]) ? Status::Singular
                                                                 : Status::NotAssemblable;
            }
        };
    };
    return method;
}

StudyMethod harmonics(int count)
{
    StudyMethod method;
    method.name = {MethodName::Kind::Harmonics, count};
    method.dependsOnStep = false;
    method.prepare = [count](const Case &which, std::span<const double> instants) -> StudyRun {
        const Mechanism mechanism(which.parameters);
        if (!HarmonicSeries::existsFor(mechanism)) {
            return {};
        }
        return [series = HarmonicSeries(mechanism, count), instants](StudyAnswers &answers) {
            for (std::size_t i = 0; i < instants.size(); ++i) {
                const HarmonicSeries::Sums sums = series.at(instants[i]);
                answers.values[Theta3Value][i] = sums.theta3.value;
                answers.values[R4xValue][i] = sums.R4x.value;
                answers.values[Theta3Rate][i] = sums.theta3.first;
                answers.values[R4xRate][i] = sums.R4x.first;
                answers.values[Theta3Acceleration][i] = sums.theta3.second;
                answers.values[R4xAcceleration][i] = sums.R4x.second;
                answers.status[i] = Status::Solved;
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
