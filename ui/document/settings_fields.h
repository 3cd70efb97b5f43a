// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Describes the fields of each struct of settings once, by their names in files and their limits. Scenes, recovery
// files, saved column choices and the JSON of the command line are read and written by these functions.

#include "core/sampling/trajectory.h"
#include "ui/document/json_node.h"
#include "ui/document/reference_file.h"
#include "ui/document/view_settings.h"

namespace slidercrank
{

void describe(Parameters &parameters, JsonNode &node);
void describe(Sampling &sampling, JsonNode &node);
void describe(SolverSettings &solver, JsonNode &node);
void describe(ColumnChoice &choice, JsonNode &node);
void describe(Convention &convention, JsonNode &node);
void describe(ReferenceSource &source, JsonNode &node); ///< reads and writes the paths as they are
void describe(PlotSettings &plots, JsonNode &node);
void describe(PlotZoom &zoom, JsonNode &node);
void describe(MechanismSettings &settings, JsonNode &node);
void describe(OutputChannel &channel, JsonNode &node);
void describe(MotionTableSettings &table, JsonNode &node);

/// The name of a column's meaning in files and options: "ignored", "time", "crank-angle", or that of the channel.
QString meaningName(ColumnRole role, Channel channel);

/// Sets the role and the channel of a column by a name that meaningName() returns. With any other name, the column
/// holds the default Channel().
void setMeaning(ColumnChoice &choice, const QString &name);

bool isValid(const ReferenceSource &source); ///< Whether it names a file.
inline bool isValid(const MotionTableSettings &)
{
    return true;
}

/// Returns the settings as JSON.
template <typename Settings>
QJsonValue toJson(Settings settings)
{
    JsonNode node;
    describe(settings, node);
    return node.value;
}

/// Returns the settings in JSON. A field that is missing or not valid has a valid default.
template <typename Settings>
Settings fromJson(const QJsonValue &json)
{
    JsonNode node{true, json};
    Settings settings;
    describe(settings, node);
    return settings;
}

} // namespace slidercrank
