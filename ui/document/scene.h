// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Reads and writes scenes. A scene is a JSON file with all settings of a session. It does not contain results: opening
// it reproduces them to the last bit.
//
//     { "version": 1,
//       "mechanism": {"a", "b", "c", "omega2", "theta20", "branch": "open"|"crossed"},                   mm, rad, s
//       "sampling":  {"start", "duration", "steps"},
//       "solver":    {"method": "newton"|"closed-form", "maxIterations", "tolerance",
//                     "toleranceKind": "absolute"|"relative", "warmStart": "previous"|"taylor",
//                     "elimination": "dense"|"structured"},
//       "reference": null or {"file",
//                             "columns": [{"column", "use": "time"|"crank-angle"|"ignored"|"theta3"|…, "unit"}],
//                             "conventions": [{"kind", "channels": […], "amount"}]},
//       "kept":      [{as "mechanism"}, …],                                                             at most 4
//       "view":      {"time", "alpha2", "error": "percent"|"absolute"|"of-peak", "logarithmicError", "roundingBand",
//                     "abscissa": "time"|"crank-angle",
//                     "zoom": {"time": null or [from, to], "plot_theta3": null or [from, to], …},
//                     "mechanism": {"velocity", "acceleration", "path", "names", "dimensions", "angles",
//                                   "instantCentre": true if shown,
//                                   "frame": null or [left, lower, right, upper]},                     mm
//                     "table": null or {"step": "crank-angle"|"time", "angleStep", "timeStep",         °, s
//                                       "columns": ["theta3", "R4_x_diff", "transmission_angle", …]},
//                     "notation": null or {"symbols": "absolute"|"textbook", "length": "mm"|"cm"|"m"|"in",
//                                          "angle": "deg"|"rad"|"deg-rad/s", "crankSpeed": "rad/s"|"deg/s"|"rpm"}} }
//
// Columns are numbered from 1. The path of the reference file is relative to the scene's folder if the file is in or
// below that folder. For joined files "file" is a list, and their columns are numbered on from file to file. The
// reference, the pinned motions ("kept") and everything in the view may be missing; the mechanism, the sampling and the
// solver must be complete. Unknown keys are ignored, and are not written back.

#include "core/mechanism/mechanism.h"
#include "core/sampling/trajectory.h"
#include "ui/document/reference_file.h"
#include "ui/document/view_settings.h"
#include "ui/text/notation.h"

#include <QByteArray>
#include <QJsonObject>
#include <QRectF>
#include <QString>

#include <optional>
#include <variant>
#include <vector>

namespace slidercrank
{

struct Scene {
    Parameters parameters;
    Sampling sampling;
    SolverSettings solver;
    std::optional<ReferenceSource> reference;
    std::vector<Parameters> pinned; ///< the oldest first
    double time = 0.0;              ///< current time, s
    double alpha2 = 0.0;            ///< acceleration of the crank in table, polygons and drawing, rad/s²
    PlotSettings plots;
    PlotZoom zoom;
    MechanismSettings mechanism;
    std::optional<QRectF> mechanismFrame;     ///< visible part of the drawing, mm; nullopt: the whole motion
    std::optional<MotionTableSettings> table; ///< nullopt if the scene does not say what the table shows
    std::optional<Notation> notation;         ///< symbols and units; nullopt if the scene does not say

    friend bool operator==(const Scene &, const Scene &) = default;
};

/// Returns the scene as JSON text for a file at `path`, which the path of the reference is relative to.
QByteArray sceneToJson(Scene scene, const QString &path);

/// Returns the scene of `json`. Each field that is missing, or not valid, is replaced by a valid value.
Scene acceptedScene(const QJsonObject &json);

/// Return the scene, or a sentence that says what is wrong, where, and what to do.
std::variant<Scene, QString> parseScene(const QByteArray &json, const QString &path);
std::variant<Scene, QString> readScene(const QString &path); ///< of a file, or in a link (scene_link.h)

/// Returns whether the name of the file ends in .slidercrank or .json, as that of a scene does, or is a link with a
/// scene.
bool isNamedAsScene(const QString &path);

/// Writes the file completely or not at all. Returns a sentence if it cannot be written.
std::optional<QString> writeScene(const Scene &scene, const QString &path);

} // namespace slidercrank
