// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/shortfall.h"

#include "core/limits/mobility.h"
#include "core/mechanism/channel.h"
#include "core/mechanism/two_part_angle.h"

#include <QLocale>
#include <QStringList>

namespace slidercrank
{

void Shortfall::add(std::span<const double> time, std::span<const Status> status)
{
    for (std::size_t i = 0; i < status.size(); ++i) {
        Instants &instants = m_instants[static_cast<std::size_t>(status[i])];
        if (instants.count++ == 0) {
            instants.first = time[i];
        }
    }
    m_total += status.size();
}

ExitStatus Shortfall::report(const Mechanism &mechanism, int maxIterations, const QString &before) const
{
    if (of(Status::Solved).count == m_total) {
        return ExitStatus::Done;
    }
    say(before + sentence(mechanism, maxIterations));
    return of(Status::NotAssemblable).count > 0 ? ExitStatus::NotAssemblable : ExitStatus::NotSolved;
}

QString Shortfall::sentence(const Mechanism &mechanism, int maxIterations) const
{
    const auto where = [&](const Instants &instants) {
        const double degrees =
            crankAngle(mechanism.omega2(), instants.first, mechanism.theta20()).hi * kDegreesPerRadian;
        return CommandLine::tr("%1 of %2 instants, first at t = %3 s (θ₂ = %4°)")
            .arg(instants.count)
            .arg(m_total)
            .arg(rounded(instants.first, 6), rounded(degrees, 6));
    };
    QStringList sentences;
    if (const Instants &instants = of(Status::NotAssemblable); instants.count > 0) {
        sentences += CommandLine::tr("The mechanism cannot be assembled at %1: the coupler must be at least %2 mm long "
                                     "for the crank to turn round (--b).")
                         .arg(where(instants), QString::number(shortestCouplerForFullTurn(mechanism), 'g',
                                                               QLocale::FloatingPointShortest));
    }
    if (const Instants &instants = of(Status::IterationLimit); instants.count > 0) {
        sentences += CommandLine::tr("Newton-Raphson did not converge at %1: allow more iterations than %2 "
                                     "(--max-iterations), or a larger residual (--tolerance).")
                         .arg(where(instants))
                         .arg(maxIterations);
    }
    if (const Instants &instants = of(Status::Singular); instants.count > 0) {
        sentences += CommandLine::tr("Velocity and acceleration do not exist at %1: the coupler is perpendicular to "
                                     "the slider's line there; a longer coupler (--b) avoids it.")
                         .arg(where(instants));
    }
    if (const Instants &instants = of(Status::NotFinite); instants.count > 0) {
        sentences += CommandLine::tr("The motion is too large to be a number at %1: choose a smaller --omega2, or "
                                     "instants nearer to 0.")
                         .arg(where(instants));
    }
    return sentences.join(u' ');
}

} // namespace slidercrank
