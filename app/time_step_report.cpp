// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/time_step_report.h"

#include "app/answer.h"
#include "core/limits/mobility.h"
#include "core/mechanism/channel.h"
#include "core/mechanism/two_part_angle.h"

#include <QLocale>

namespace slidercrank
{

void TimeStepReport::add(const Trajectory &motion)
{
    m_total += motion.status.size();
    for (std::size_t i = 0; i < motion.status.size(); ++i) {
        Steps &steps = m_steps[static_cast<std::size_t>(motion.status[i])];
        if (steps.count++ == 0) {
            steps.first = motion.time[i];
        }
    }
}

ExitStatus TimeStepReport::finish(const Streams &streams, const Mechanism &mechanism, const NewtonOptions &newton,
                                  const QString &prefix) const
{
    ExitStatus exitStatus = ExitStatus::Success;
    QStringList messages;
    for (const Status status : {Status::NotAssemblable, Status::IterationLimit, Status::Singular, Status::NotFinite}) {
        if (m_steps[static_cast<std::size_t>(status)].count > 0) {
            messages += message(status, mechanism, newton);
            exitStatus = moreSevere(exitStatus, status == Status::NotAssemblable ? ExitStatus::NotAssemblable
                                                                                 : ExitStatus::NotSolved);
        }
    }
    if (!messages.isEmpty()) {
        streams.report(prefix + messages.join(u' '));
    }
    return exitStatus;
}

QString TimeStepReport::message(Status status, const Mechanism &mechanism, const NewtonOptions &newton) const
{
    const Steps &steps = m_steps[static_cast<std::size_t>(status)];
    const double theta2 = crankAngle(mechanism.omega2(), steps.first, mechanism.theta20()).hi;
    const QString where = CommandLine::tr("%1 of %2 time steps, first at t = %3 s (θ₂ = %4°)")
                              .arg(QString::number(steps.count), QString::number(m_total), roundedText(steps.first, 6),
                                   roundedText(theta2 * kDegreesPerRadian, 6));
    switch (status) {
    case Status::Solved: return {};
    case Status::NotAssemblable:
        return CommandLine::tr("The mechanism cannot be assembled at %1: the coupler must be at least %2 mm long for "
                               "the crank to make full turns (--b).")
            .arg(where, QString::number(shortestCouplerForFullTurn(mechanism), 'g', QLocale::FloatingPointShortest));
    case Status::IterationLimit: {
        const double size = characteristicLength(mechanism.parameters());
        constexpr double kHugeLength = 1e6; // mm; rounding errors of such lengths exceed the default tolerance
        const QString advice =
            newton.toleranceKind == ToleranceKind::Absolute && size > kHugeLength
                ? CommandLine::tr("use --tolerance-kind relative, because an absolute tolerance cannot be met with "
                                  "lengths of %1 mm")
                      .arg(roundedText(size))
                : CommandLine::tr("allow more than %1 iterations (--max-iterations) or a larger residual (--tolerance)")
                      .arg(newton.maxIterations);
        return CommandLine::tr("Newton-Raphson did not converge at %1: %2.").arg(where, advice);
    }
    case Status::Singular:
        return CommandLine::tr("Velocity and acceleration do not exist at %1: the coupler is perpendicular to the "
                               "slider's line there; a longer coupler (--b) avoids it.")
            .arg(where);
    case Status::NotFinite:
        return CommandLine::tr(
                   "The motion is too large to be computed at %1: choose a smaller --omega2, or times nearer to 0.")
            .arg(where);
    }
    return {};
}

} // namespace slidercrank
