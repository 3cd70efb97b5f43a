// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The fields of each struct of settings, described once: their names in files and their limits. Scenes, recovery files
// and remembered choices are read and written by these functions.

#include "core/sampling/trajectory.h"
#include "ui/document/json_fields.h"
#include "ui/document/reference_file.h"
#include "ui/document/view_settings.h"

namespace slidercrank
{

void describe(Parameters &parameters, JsonFields &fields);
void describe(Sampling &sampling, JsonFields &fields);
void describe(SolverSettings &solver, JsonFields &fields);
void describe(ColumnChoice &choice, JsonFields &fields);
void describe(Convention &convention, JsonFields &fields);
void describe(ReferenceSource &source, JsonFields &fields); ///< its paths as they are
void describe(PlotSettings &plots, JsonFields &fields);
void describe(PlotZoom &zoom, JsonFields &fields);
void describe(MechanismSettings &settings, JsonFields &fields);

/// What settings of that type would be written as.
template <typename Settings>
QJsonObject toJson(Settings settings)
{
    JsonFields fields;
    describe(settings, fields);
    return fields.written();
}

/// The settings that a remembered object holds; the usual ones where a field is missing, or if any is wrong.
template <typename Settings>
Settings fromJson(const QJsonObject &object)
{
    QString fault;
    JsonFields fields(fault, object, {}, true);
    Settings settings;
    describe(settings, fields);
    return fault.isEmpty() ? settings : Settings();
}

} // namespace slidercrank
