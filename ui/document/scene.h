// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A scene: all that a person chose, as a JSON file. What is computed is not in it, but follows from it: a scene that is
// opened gives to the last bit what was on show when it was saved.
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
// Columns count from 1. The reference's file is relative to the scene's folder where it lies in or below it; where
// several are joined, "file" is the list of them, and the columns count on from one to the next. What decides the
// motion has to be there; the reference, what is kept and anything in the view may be missing. Keys that are not known
// are kept, and written back.

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
    std::vector<Parameters> kept; ///< motions to stay under the model's
    double time = 0.0;            ///< s, the instant on show
    PlotSettings plots;
    PlotZoom zoom;
    MechanismSettings mechanism;
    std::optional<QRectF> mechanismFrame; ///< mm, where somebody zoomed to it
    QJsonObject asRead;                   ///< the file that it came from, for the keys that are not known here
};

/// `path`: where the text is, or is to be; the reference's is relative to it.
QByteArray jsonOf(const Scene &scene, const QString &path);

/// The scene, or one sentence that says what is wrong, where, and what to do.
std::variant<Scene, QString> sceneOf(const QByteArray &json, const QString &path);
std::variant<Scene, QString> readScene(const QString &path);

/// Whether a file of that name is taken for a scene: .slidercrank, or .json as all were called once.
bool isNamedAsScene(const QString &path);

/// Writes the file whole or not at all; a sentence where it cannot be written.
std::optional<QString> writeScene(const Scene &scene, const QString &path);

} // namespace slidercrank
