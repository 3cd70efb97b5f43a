// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A scene: all choices of a person as a JSON file. Results are not in it: a scene that is opened gives the results that
// it was saved with, to the last bit.
//
//     { "version": 1,
//       "mechanism": {"a", "b", "c", "omega2", "theta20", "branch": "open"|"crossed"},                   mm, rad, s
//       "sampling":  {"start", "duration", "steps"},
//       "solver":    {"method": "newton"|"closed-form", "maxIterations", "tolerance",
//                     "toleranceKind": "absolute"|"relative", "warmStart": "previous"|"taylor",
//                     "elimination": "dense"|"structured"},
//       "reference": null or {"file", "columns": [{"column", "use": "time"|"crank-angle"|"ignored"|"theta3"|…,
//       "unit"}],
//                             "conventions": [{"kind", "channels": […], "amount"}]},
//       "kept":      [{as "mechanism"}, …],                                                             at most 4
//       "view":      {"time", "error": "percent"|"absolute"|"of-peak", "logarithmicError", "roundingBand",
//                     "abscissa": "time"|"crank-angle",
//                     "zoom": {"time": null or [from, to], "plot_theta3": null or [from, to], …},
//                     "mechanism": {"velocity", "acceleration", "path", "names", "dimensions": whether on show,
//                                   "frame": null or [left, lower, right, upper]}} }                   mm
//
// Columns count from 1. The path of the reference file is relative to the scene's folder if the file lies in or below
// it. For joined files "file" is a list, and their columns are counted through. The reference, the pinned motions
// ("kept") and everything in the view may be missing; what determines the motion may not. Unknown keys are kept and
// written back.

#include "core/mechanism/mechanism.h"
#include "core/sampling/trajectory.h"
#include "ui/document/reference_file.h"
#include "ui/document/view_settings.h"

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
    std::vector<Parameters> pinned; ///< pinned motions
    double time = 0.0;            ///< s
    PlotSettings plots;
    PlotZoom zoom;
    MechanismSettings mechanism;
    std::optional<QRectF> mechanismFrame; ///< mm; none: the whole motion
    QJsonObject asRead;                   ///< the file it was read from, with its unknown keys
};

/// The scene as JSON text for a file at `path`; the path of its reference is relative to that.
QByteArray sceneToJson(Scene scene, const QString &path);

/// The scene, or one sentence that says what is wrong, where, and what to do.
std::variant<Scene, QString> parseScene(const QByteArray &json, const QString &path);
std::variant<Scene, QString> readScene(const QString &path);

/// Whether the name of a file is that of a scene: .slidercrank or .json.
bool isNamedAsScene(const QString &path);

/// Writes the file completely or not at all; returns a sentence if it cannot be written.
std::optional<QString> writeScene(const Scene &scene, const QString &path);

} // namespace slidercrank
