// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/study_methods.h"

#include "core/closed_form/closed_form.h"
#include "core/closed_form/state_at.h"
#include "core/limits/mobility.h"
#include "core/newton/newton.h"
#include "core/study/harmonic_series.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace slidercrank
{

namespace
{

/// One value for each of kPlottedChannels, in that order.
using Values = std::array<double, kPlottedChannels.size()>;

/// Writes the values and the status of the time stamp with the index i.
void writeTo(StudyOutput &output, std::size_t i, const Values &values, Status status)
{
    for (std::size_t k = 0; k < values.size(); ++k) {
        output.values[k][i] = values[k];
    }
    output.statuses[i] = status;
}

void writeTo(StudyOutput &output, std::size_t i, const State &state)
{
    writeTo(output, i,
            {state.q[Theta3], state.q[R4x], state.qDot[Theta3], state.qDot[R4x], state.qDDot[Theta3], state.qDDot[R4x]},
            state.status);
}

StudyRun newton(const NewtonOptions &options, const Mechanism &mechanism, std::span<const double> timeStamps)
{
    return [=](StudyOutput &output) {
        NewtonTimeStep last;
        output.iterations = 0;
        for (std::size_t i = 0; i < timeStamps.size(); ++i) {
            advance(mechanism, timeStamps[i], last, options);
            output.iterations += last.iterations;
            writeTo(output, i, last.state);
        }
    };
}

StudyRun closedForm(const Mechanism &mechanism, std::span<const double> timeStamps)
{
    return [closedForm = ClosedForm(mechanism), timeStamps](StudyOutput &output) {
        for (std::size_t i = 0; i < timeStamps.size(); ++i) {
            writeTo(output, i, closedForm.stateAt(timeStamps[i]));
        }
    };
}

StudyRun closedFormBatch(const Mechanism &mechanism, std::span<const double> timeStamps)
{
    return [batch = ClosedForm(mechanism), timeStamps](StudyOutput &output) {
        PlottedColumns columns{};
        std::ranges::transform(output.values, columns.begin(), [](auto &values) { return values.data(); });
        batch.evaluate(timeStamps, columns, output.statuses);
    };
}

/// Computes positions in closed form at equal steps and one step beyond either end, and derivatives as central
/// differences, as is usual for films, sensors and tables. Their error decreases with the square of the step, until
/// rounding dominates:
///
///     ẋ ≈ (x₊ - x₋) / 2Δ            error: Δ²/6 times the third derivative, and ε|x|/Δ
///     ẍ ≈ (x₊ - 2x + x₋) / Δ²       error: Δ²/12 times the fourth derivative, and 4ε|x|/Δ²
///
/// Source: M. Abramowitz, I. Stegun, "Handbook of Mathematical Functions", 25.3.21 and 25.3.23.
StudyRun finiteDifference(const Mechanism &mechanism, std::span<const double> timeStamps)
{
    const double step = (timeStamps.back() - timeStamps.front()) / static_cast<double>(timeStamps.size() - 1);
    std::vector<double> sampled{timeStamps.front() - step};
    sampled.insert(sampled.end(), timeStamps.begin(), timeStamps.end());
    sampled.push_back(timeStamps.back() + step);
    std::vector<Motion> motions(sampled.size());
    return [closedForm = ClosedForm(mechanism), step, sampled, motions](StudyOutput &output) mutable {
        for (std::size_t i = 0; i < sampled.size(); ++i) {
            motions[i] = closedForm.motionAt(sampled[i]);
        }
        for (std::size_t i = 0; i < output.statuses.size(); ++i) {
            const Motion &here = motions[i + 1];
            const auto differences = [&](double Motion::*position) {
                const double rise = motions[i + 2].*position - here.*position;
                const double riseBefore = here.*position - motions[i].*position;
                return std::pair((rise + riseBefore) / (2.0 * step), (rise - riseBefore) / (step * step));
            };
            const auto [theta3Dot, theta3DDot] = differences(&Motion::theta3);
            const auto [R4xDot, R4xDDot] = differences(&Motion::R4x);
            Status status = Status::Solved;
            if (std::isnan(here.R4x)) {
                status = Status::NotAssemblable;
            } else if (std::isnan(R4xDDot)) {
                status = Status::Singular;
            }
            writeTo(output, i, {here.theta3, here.R4x, theta3Dot, R4xDot, theta3DDot, R4xDDot}, status);
        }
    };
}

StudyRun harmonics(int count, const Mechanism &mechanism, std::span<const double> timeStamps)
{
    if (motionLimits(mechanism).mobility != Mobility::FullTurn) {
        return {};
    }
    return [series = HarmonicSeries(mechanism, count), timeStamps](StudyOutput &output) {
        for (std::size_t i = 0; i < timeStamps.size(); ++i) {
            const auto [theta3, R4x] = series.at(timeStamps[i]);
            writeTo(
                output, i,
                {theta3.position, R4x.position, theta3.velocity, R4x.velocity, theta3.acceleration, R4x.acceleration},
                Status::Solved);
        }
    };
}

std::vector<StudyMethod> makeMethods()
{
    constexpr int kAllChannels = kChannelCount;
    constexpr std::array kTolerances{1e-4, kReferenceReportTolerance, 1e-12, 0.0};
    constexpr std::array kHarmonics{2, 4, 8, 16, 32};

    // NewtonDense has the residual and the iteration limit of the reference report. The other variants have a residual
    // that is independent of scale, and an iteration limit that suffices at a toggle.
    constexpr int kMaxIterations = kColdStartIterations;
    constexpr ToleranceKind kRelative = ToleranceKind::Relative;
    constexpr std::pair<MethodName::Kind, NewtonOptions> kVariants[]{
        {MethodName::Kind::NewtonDense, {}},
        {MethodName::Kind::NewtonDenseTaylor,
         {.maxIterations = kMaxIterations, .toleranceKind = kRelative, .warmStart = WarmStart::Taylor}},
        {MethodName::Kind::NewtonStructured,
         {.maxIterations = kMaxIterations, .toleranceKind = kRelative, .elimination = Elimination::Structured}},
        {MethodName::Kind::NewtonStructuredTaylor,
         {.maxIterations = kMaxIterations,
          .toleranceKind = kRelative,
          .warmStart = WarmStart::Taylor,
          .elimination = Elimination::Structured}}};
    std::vector<StudyMethod> methods;
    for (auto [kind, options] : kVariants) {
        for (const double tolerance : kTolerances) {
            options.tolerance = tolerance;
            methods.push_back({.name = {kind},
                               .tolerance = tolerance,
                               .channels = kAllChannels,
                               .prepare = std::bind_front(newton, options)});
        }
    }
    methods.push_back({.name = {MethodName::Kind::ClosedForm},
                       .channels = kAllChannels,
                       .dependsOnStep = false,
                       .prepare = closedForm});
    methods.push_back(
        {.name = {MethodName::Kind::ClosedFormBatch}, .dependsOnStep = false, .prepare = closedFormBatch});
    methods.push_back(
        {.name = {MethodName::Kind::FiniteDifference}, .needsEqualSteps = true, .prepare = finiteDifference});
    for (const int count : kHarmonics) {
        methods.push_back({.name = {MethodName::Kind::Harmonics, count},
                           .dependsOnStep = false,
                           .prepare = std::bind_front(harmonics, count)});
    }
    return methods;
}

} // namespace

std::string nameOf(const MethodName &method)
{
    using enum MethodName::Kind;
    switch (method.kind) {
    case NewtonDense: return "newton-dense";
    case NewtonDenseTaylor: return "newton-dense-taylor";
    case NewtonStructured: return "newton-structured";
    case NewtonStructuredTaylor: return "newton-structured-taylor";
    case ClosedForm: return "closed-form";
    case ClosedFormBatch: return "closed-form-batch";
    case FiniteDifference: return "finite-difference";
    case Harmonics: break;
    }
    return "harmonic-" + std::to_string(method.harmonics);
}

const std::vector<StudyMethod> &studyMethods()
{
    static const std::vector<StudyMethod> kMethods = makeMethods();
    return kMethods;
}

} // namespace slidercrank
