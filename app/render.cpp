// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render.h"

#include "app/shortfall.h"
#include "ui/figure_export.h"
#include "ui/mechanism_view.h"
#include "ui/plot_grid.h"
#include "ui/session.h"
#include "ui/theme.h"

#include <QEventLoop>
#include <QPalette>

#include <functional>
#include <span>
#include <variant>

namespace slidercrank
{

namespace
{

/// The figure belongs to the run, so its cursor does too; the mechanism alone has a pose at any instant, and a run is
/// put around that.
Sampling runAround(const RenderOptions &options)
{
    Sampling run = options.sampling;
    if (options.subject == RenderOptions::Subject::Mechanism) {
        run.start = options.poseInstant;
    }
    return run;
}

/// The choices, one after the other; returns when everything is computed.
void settle(Session &session, const RenderOptions &options, const std::shared_ptr<const Reference> &reference)
{
    bool busy = false;
    QEventLoop loop;
    QObject::connect(&session, &Session::busyChanged, &loop, [&](bool now) {
        busy = now;
        if (!busy) {
            loop.quit();
        }
    });
    session.setSolver(options.solver);
    session.setParameters(options.mechanism.parameters());
    session.setSampling(runAround(options));
    session.setReference(reference);
    if (busy) {
        loop.exec();
    }
    session.setTime(options.poseInstant);
}

Shortfall shortfallOf(const RenderOptions &options, const Session &session)
{
    Shortfall shortfall;
    if (options.subject == RenderOptions::Subject::Mechanism) {
        const Pose pose = session.pose();
        shortfall.add(std::span(&pose.time, 1), std::span(&pose.status, 1));
    } else {
        const Result &result = *session.result();
        shortfall.add(result.trajectory.time, result.trajectory.status);
        shortfall.add(result.atReference.time, result.atReference.status);
    }
    return shortfall;
}

} // namespace

ExitStatus render(const RenderOptions &options)
{
    std::shared_ptr<const Reference> reference;
    if (!options.reference.isEmpty()) {
        const std::variant<std::shared_ptr<const Reference>, QString> outcome = readReference(options.reference);
        if (const QString *sentence = std::get_if<QString>(&outcome)) {
            say(*sentence);
            return ExitStatus::FileFailed;
        }
        reference = std::get<std::shared_ptr<const Reference>>(outcome);
    }
    Session session;
    settle(session, options, reference);

    const QPalette palette = paletteFor(options.theme);
    PlotGrid plots;
    MechanismView mechanism;
    FigureDrawing draw;
    switch (options.subject) {
    case RenderOptions::Subject::Figure:
        draw = [&](QPainter &painter, const QSize &size) { plots.paintFigure(painter, size, palette); };
        break;
    case RenderOptions::Subject::Plot:
        draw = [&](QPainter &painter, const QSize &size) {
            plots.paintPlot(painter, QStringLiteral("plot_") + options.plot, size, palette);
        };
        break;
    case RenderOptions::Subject::Mechanism:
        draw = [&](QPainter &painter, const QSize &size) { mechanism.paintMechanism(painter, size, palette); };
        break;
    }
    plots.setResult(session.result());
    if (options.poseInstant != options.sampling.start) {
        plots.markTime(options.poseInstant);
    }
    mechanism.setResult(session.result());
    mechanism.setPose(session.pose());

    const QString title = CommandLine::tr("Motion of an offset slider-crank");
    if (const std::optional<QString> sentence =
            exportFigure(options.output, {options.size, options.scale}, title, draw)) {
        say(*sentence);
        return ExitStatus::FileFailed;
    }
    const Shortfall shortfall = shortfallOf(options, session);
    if (shortfall.exitStatus() != ExitStatus::Done) {
        say(shortfall.sentence(options.mechanism, options.solver.newton.maxIterations));
    }
    return shortfall.exitStatus();
}

} // namespace slidercrank
