// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/subcommands.h"

#include "app/comparison_text.h"
#include "app/shortfall.h"
#include "ui/document/session.h"
#include "ui/export/animation_export.h"
#include "ui/export/figure_export.h"
#include "ui/export/report.h"
#include "ui/mechanism/mechanism_view.h"
#include "ui/plots/plot_grid.h"
#include "ui/text/theme.h"

#include <QEventLoop>
#include <QPalette>

#include <atomic>
#include <csignal>
#include <memory>
#include <optional>
#include <span>
#include <variant>

namespace slidercrank
{

namespace
{

/// Figure and report belong to the run, so their cursor does too; the mechanism alone has a pose at any instant, and a
/// run is put around that.
Sampling runAround(const RenderOptions &options)
{
    Sampling run = options.sampling;
    if (options.subject == RenderOptions::Subject::Mechanism) {
        run.start = options.poseInstant;
    }
    return run;
}

/// Returns when everything is computed. A sentence when that failed.
std::optional<QString> settle(Session &session, const RenderOptions &options,
                              const std::shared_ptr<const Reference> &reference)
{
    bool busy = false;
    std::optional<QString> problem;
    QEventLoop loop;
    QObject::connect(&session, &Session::problemFound, &loop, [&](const QString &sentence) { problem = sentence; });
    QObject::connect(&session, &Session::busyChanged, &loop, [&](bool now) {
        busy = now;
        if (!busy) {
            loop.quit();
        }
    });
    session.open({options.mechanism.parameters(), runAround(options), options.solver, reference, options.kept},
                 options.poseInstant, {});
    if (busy) {
        loop.exec();
        session.setTime(options.poseInstant);
    }
    return problem;
}

/// The lengths of the linkage as the file has it, where that is another than the model's; none where the file reads
/// otherwise.
std::optional<Mechanism> ghostOf(const Diagnosis &diagnosis, const RenderOptions &options)
{
    if (!diagnosis.conventions.empty() || diagnosis.isOfMechanismAtHand) {
        return std::nullopt;
    }
    return diagnosis.identification.stands() ? Mechanism(diagnosis.identification.parameters) : options.mechanism;
}

Animation filmOf(const RenderOptions &options)
{
    Animation film;
    film.start = options.sampling.start;
    film.duration = options.sampling.duration;
    film.speed = options.speed;
    film.size = {options.size, options.scale};
    return film;
}

std::atomic<int> interruption = 0; // the signal that asks to end, e.g. of Control C
static_assert(std::atomic<int>::is_always_lock_free, "what a signal's handler may write");

/// Of all that ask to end but those that were ignored from the start, as under nohup.
void handleEndings(void (*handler)(int))
{
    constexpr int kEndings[] = {
        SIGINT, SIGTERM,
#ifdef SIGHUP
        SIGHUP, // the terminal was closed
#endif
    };
    for (const int signal : kEndings) {
        if (std::signal(signal, SIG_IGN) != SIG_IGN) {
            std::signal(signal, handler);
        }
    }
}

/// Writes frames or a video. Interrupted, it leaves nothing behind and ends as the signal asks for.
std::optional<QString> exportFilm(const RenderOptions &options, const FrameDrawing &draw)
{
    handleEndings([](int which) { interruption = which; });
    const std::optional<QString> problem =
        exportAnimation(options.output, filmOf(options), draw, [](int) { return interruption == 0; });
    handleEndings(SIG_DFL);
    if (const int signal = interruption; signal != 0) {
        std::raise(signal); // so that who started the program sees how it ended
    }
    return problem;
}

Shortfall shortfallOf(const RenderOptions &options, const Session &session)
{
    Shortfall shortfall;
    if (options.subject == RenderOptions::Subject::Frames) {
        const Animation film = filmOf(options);
        for (int frame = 0; frame < film.frameCount(); ++frame) {
            const Pose pose = poseAt(options.mechanism.parameters(), film.timeOfFrame(frame));
            shortfall.add(std::span(&pose.time, 1), std::span(&pose.status, 1));
        }
    } else if (options.subject == RenderOptions::Subject::Mechanism) {
        const Pose pose = session.pose();
        shortfall.add(std::span(&pose.time, 1), std::span(&pose.status, 1));
    } else {
        const Result &result = *session.result();
        if (result.isKept()) {
            shortfall.add(result.trajectory.time, result.trajectory.status);
        } else {
            const auto add = [&shortfall](const Trajectory &piece) {
                shortfall.add(piece.time, piece.status);
                return true;
            };
            sampleInPieces(result.mechanism, result.sampling, {}, result.solver, add);
        }
        shortfall.add(result.atReference.time, result.atReference.status);
    }
    return shortfall;
}

} // namespace

ExitStatus render(const RenderOptions &options)
{
    std::shared_ptr<const Reference> reference;
    if (options.reference) {
        const std::variant<std::shared_ptr<const Reference>, QString> outcome =
            readTimed(*options.reference, options.columns, options.mechanism);
        if (const QString *sentence = std::get_if<QString>(&outcome)) {
            say(*sentence);
            return ExitStatus::FileFailed;
        }
        reference = std::get<std::shared_ptr<const Reference>>(outcome);
        warnOf(joinedName(reference->paths), reference->data);
    }
    Session session;
    if (const std::optional<QString> problem = settle(session, options, reference)) {
        say(*problem);
        return ExitStatus::FileFailed;
    }

    PlotGrid plots;
    MechanismView mechanism;
    plots.setSettings(options.plots);
    plots.setResult(session.result());
    plots.setZoom(options.zoom);
    if (options.poseInstant != options.sampling.start) {
        plots.markTime(options.poseInstant);
    }
    mechanism.setResult(session.result());
    mechanism.setSettings(options.mechanismSettings);
    mechanism.setZoom(options.mechanismFrame);
    mechanism.setPose(session.pose());
    ReportContent content{session.result(), {}, false};
    std::optional<Mechanism> ghost;
    const auto showGhost = [&](double instant) {
        mechanism.setGhost(!ghost      ? ReferencePose()
                           : reference ? referencePoseAt(reference->data, *ghost, instant)
                                       : referencePoseAt(*ghost, instant));
    };
    if (reference && options.subject != RenderOptions::Subject::Figure &&
        options.subject != RenderOptions::Subject::Plot) {
        content.diagnosis = diagnose(reference->data, options.mechanism);
        ghost = ghostOf(content.diagnosis, options);
        if (ghost) {
            mechanism.setGhostBounds(motionBounds(*ghost, motionLimits(*ghost)));
        }
    } else if (session.result()->difference && options.kept.back() != options.mechanism.parameters()) {
        ghost = Mechanism(options.kept.back());
        mechanism.setGhostBounds(motionBounds(*ghost, motionLimits(*ghost)));
    }
    showGhost(options.poseInstant);
    content.hasGhost = mechanism.hasGhost();

    const QPalette palette = paletteFor(options.theme);
    const FigureDrawing drawFigure = [&](QPainter &painter, const QSize &size) {
        plots.paintFigure(painter, size, palette);
    };
    const FigureDrawing drawMechanism = [&](QPainter &painter, const QSize &size) {
        mechanism.paintMechanism(painter, size, palette);
    };
    const FigureDrawing drawPlot = [&](QPainter &painter, const QSize &size) {
        plots.paintPlot(painter, QStringLiteral("plot_") + options.plot, size, palette);
    };
    const FrameDrawing drawFrame = [&](QPainter &painter, const QSize &size, double instant) {
        mechanism.setPose(poseAt(options.mechanism.parameters(), instant));
        showGhost(instant);
        mechanism.paintMechanism(painter, size, palette);
    };
    const auto exported = [&](const FigureDrawing &draw) {
        return exportFigure(options.output, {options.size, options.scale},
                            CommandLine::tr("Motion of an offset slider-crank"),
                            withParameters(draw, options.mechanism, palette));
    };
    std::optional<QString> failure;
    switch (options.subject) {
    case RenderOptions::Subject::Figure: failure = exported(drawFigure); break;
    case RenderOptions::Subject::Plot: failure = exported(drawPlot); break;
    case RenderOptions::Subject::Mechanism: failure = exported(drawMechanism); break;
    case RenderOptions::Subject::Frames: failure = exportFilm(options, drawFrame); break;
    case RenderOptions::Subject::Report:
        content.checksums = reference ? checksumsOf(*reference) : QByteArrayList();
        failure = exportReport(options.output, content, {drawMechanism, drawFigure});
        break;
    }
    if (failure) {
        say(*failure);
        return ExitStatus::FileFailed;
    }
    const Shortfall shortfall = shortfallOf(options, session);
    return shortfall.report(options.mechanism, options.solver.newton.maxIterations);
}

} // namespace slidercrank
