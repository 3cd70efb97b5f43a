// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// States the fields of each struct of settings once, by their names in files and their limits: readOrWrite() reads them
// from a node or writes them into it (json_node.h). Scenes, recovery files, saved column choices and the JSON of the
// command line are read and written by these functions.

#include "core/sampling/trajectory.h"
#include "ui/document/json_node.h"
#include "ui/document/reference_file.h"
#include "ui/document/view_settings.h"
#include "ui/text/notation.h"

namespace slidercrank
{

void readOrWrite(Parameters &parameters, JsonNode &node);
void readOrWrite(Sampling &sampling, JsonNode &node);
void readOrWrite(SolverSettings &solver, JsonNode &node);
void readOrWrite(ColumnChoice &choice, JsonNode &node);
void readOrWrite(Convention &convention, JsonNode &node);
void readOrWrite(ReferenceSource &source, JsonNode &node); ///< reads and writes the paths as they are
void readOrWrite(PlotSettings &plots, JsonNode &node);
void readOrWrite(PlotZoom &zoom, JsonNode &node);
void readOrWrite(MechanismSettings &settings, JsonNode &node);
void readOrWrite(OutputChannel &channel, JsonNode &node);
void readOrWrite(Notation &notation, JsonNode &node);
void readOrWrite(MotionTableSettings &table, JsonNode &node);

/// Returns the name of a column's meaning in files and options: "ignored", "time", "crank-angle", or that of the
/// channel.
QString meaningName(ColumnRole role, Channel channel);

/// Sets the role and the channel of a column by a name that meaningName() returns. With any other name, the column
/// holds the default Channel().
void setMeaning(ColumnChoice &choice, const QString &name);

/// Return whether the value of an optional field is usable: a reference must name a file.
bool isValid(const ReferenceSource &source);
inline bool isValid(const Notation &)
{
    return true;
}
inline bool isValid(const MotionTableSettings &)
{
    return true;
}

template <typename Settings>
QJsonValue toJson(Settings settings)
{
    JsonNode node;
    readOrWrite(settings, node);
    return node.value;
}

/// Reads the settings from JSON. A field that is missing or not valid keeps its default value.
template <typename Settings>
Settings fromJson(const QJsonValue &json)
{
    JsonNode node{.isReading = true, .value = json};
    Settings settings;
    readOrWrite(settings, node);
    return settings;
}

} // namespace slidercrank
