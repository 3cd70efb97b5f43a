// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Describes the fields of each struct of settings once, by their names in files and their limits. Scenes, recovery
// files, saved column choices and the JSON of the command line are read and written by these functions.

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
void describe(ReferenceSource &source, JsonFields &fields); ///< with its paths unchanged
void describe(PlotSettings &plots, JsonFields &fields);
void describe(PlotZoom &zoom, JsonFields &fields);
void describe(MechanismSettings &settings, JsonFields &fields);

/// The name of a column's meaning in files and options: "ignored", "time", "crank-angle", or that of the channel.
QString meaningName(ColumnRole role, Channel channel);

/// Reads a name that meaningName() returns. Returns false if it is not one.
bool readMeaning(const QString &name, ColumnRole &role, Channel &channel);

/// Returns the settings as a JSON object.
template <typename Settings>
QJsonObject toJson(Settings settings)
{
    JsonFields fields;
    describe(settings, fields);
    return fields.written();
}

/// Returns the settings in a JSON object. Fields that are missing have their default values; if any value is not valid,
/// all have.
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
