// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/time_step_report.h"

#include "core/limits/mobility.h"
#include "ui/text/enum_table.h"
#include "ui/text/motion_facts.h"
#include "ui/text/written_number.h"

#include <cmath>

namespace slidercrank
{

namespace
{

/// With more iterations the residual becomes no smaller, because each iteration doubles the number of correct digits.
constexpr int kSufficientIterations = 100;

/// The messages by status. %1 stands for the time steps, %2 for the shortest coupler with which the crank makes full
/// turns, %3 for the iteration limit, %4 for the tolerance.
constexpr EnumText<Status> kMessages[] = {
    {Status::Solved, ""},
    {Status::Singular,
     QT_TRANSLATE_NOOP(
         "slidercrank::CommandLine",
         "Velocity and acceleration do not exist at %1: the coupler is perpendicular to the slider's line "
         "there; a longer coupler (--b) avoids it.")},
    {Status::IterationLimit,
     QT_TRANSLATE_NOOP(
         "slidercrank::CommandLine",
         "Newton-Raphson did not converge at %1: choose a greater --max-iterations (now %3) or --tolerance.")},
    {Status::NotAssemblable,
     QT_TRANSLATE_NOOP("slidercrank::CommandLine",
                       "The mechanism cannot be assembled at %1: the coupler must be at least %2 long for the crank "
                       "to make full turns (--b).")},
    {Status::NotFinite,
     QT_TRANSLATE_NOOP(
         "slidercrank::CommandLine",
         "The crank angle is not a finite number at %1: choose a smaller --omega2, or times nearer to 0.")}};
static_assert(isCompleteTable(kMessages, Status::NotFinite));

/// Returns the message about time steps with the status, with %1 to %4.
QString messageFor(Status status, const SamplingSummary &summary, const NewtonOptions &newton)
{
    if (status == Status::IterationLimit && newton.maxIterations >= kSufficientIterations) {
        return CommandLine::tr("Newton-Raphson did not converge at %1: rounding errors are larger than the "
                               "--tolerance (now %4); choose a greater one.");
    }
    const double crankAngle = summary.withStatus(status).firstTheta2;
    if (status == Status::NotFinite && std::isfinite(crankAngle)) { // kLargestDrive; the closed form has no such limit
        return CommandLine::tr("The crank angle is too large for Newton-Raphson at %1, which stores θ₂ with 16 digits: "
                               "choose --method closed-form, a smaller --omega2, or times nearer to 0.");
    }
    return CommandLine::tr(rowOf(kMessages, status).text);
}

/// Returns the first time step that has the status: "t = 0.5 s (θ₂ = 180.00°)". If the motion has several time steps,
/// the text begins with the number of those that have the status: "3 of 100 time steps, first at t = …".
QString timeStepsText(Status status, const SamplingSummary &summary)
{
    const StatusSummary &steps = summary.withStatus(status);
    const QString place =
        QString("t = %1 s (θ₂ = %2°)").arg(numberText(steps.firstTime), crankAngleText(steps.firstTheta2));
    if (summary.timeSteps == 1) {
        return place;
    }
    const QString count = CommandLine::tr("%1 of %2 time steps, first at ")
                              .arg(QString::number(steps.count), QString::number(summary.timeSteps));
    return count + place;
}

ExitStatus exitStatusOf(Status status)
{
    return status == Status::NotAssemblable ? ExitStatus::NotAssemblable : ExitStatus::NotSolved;
}

} // namespace

ExitStatus reportPosition(const Streams &streams, Status status, const Mechanism &mechanism, double theta2)
{
    if (status == Status::Solved) {
        return ExitStatus::Success;
    }
    streams.report(CommandLine::tr(rowOf(kMessages, status).text)
                       .replace("%2", atLeastText(shortestCouplerForFullTurn(mechanism)))
                       .replace("%1", QString("θ₂ = %1°").arg(crankAngleText(theta2))));
    return exitStatusOf(status);
}

ExitStatus reportTimeSteps(const Streams &streams, const SamplingSummary &summary, const Mechanism &mechanism,
                           const NewtonOptions &newton, const QString &prefix)
{
    ExitStatus exitStatus = ExitStatus::Success;
    QStringList messages;
    for (const Status status : {Status::NotAssemblable, Status::IterationLimit, Status::Singular, Status::NotFinite}) {
        if (summary.count(status) == 0) {
            continue;
        }
        messages += messageFor(status, summary, newton)
                        .replace("%4", numberText(newton.tolerance))
                        .replace("%3", QString::number(newton.maxIterations))
                        .replace("%2", atLeastText(shortestCouplerForFullTurn(mechanism)))
                        .replace("%1", timeStepsText(status, summary));
        if (status == Status::IterationLimit && newton.toleranceKind == ToleranceKind::Absolute) {
            messages += CommandLine::tr("Very long links need --tolerance-kind relative.");
        }
        exitStatus = moreSevere(exitStatus, exitStatusOf(status));
    }
    if (!messages.isEmpty()) {
        streams.report(prefix + messages.join(u' '));
    }
    return exitStatus;
}

void JumpingRows::add(const Mechanism &mechanism, std::span<const double> timeStamps, double alpha2)
{
    if (mechanism.omega2() == 0.0 && alpha2 == 0.0) {
        return;
    }
    for (const double t : timeStamps) {
        const double theta2 = mechanism.theta20() + mechanism.omega2() * t;
        if (velocitiesJumpAt(mechanism, theta2) && m_count++ == 0) {
            m_firstTime = t;
            m_firstAngle = theta2;
        }
    }
}

void JumpingRows::report(const Streams &streams) const
{
    if (m_count > 0) {
        streams.report(
            CommandLine::tr("The velocities jump at %1 (rows: %2), where the coupler is perpendicular to the "
                            "slider's line: velocities and accelerations there are those of one side only.")
                .arg(QString("t = %1 s (θ₂ = %2°)").arg(numberText(m_firstTime), crankAngleText(m_firstAngle)),
                     QString::number(m_count)));
    }
}

} // namespace slidercrank
