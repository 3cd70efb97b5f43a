// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Writes a motion as CSV: a line of names, then one row per time step with the time (s) and the requested channels. The
// command line and the window write the same format, and both read it back as a reference without loss.

#include "core/sampling/trajectory.h"
#include "ui/document/result.h"
#include "ui/text/units.h"

#include <QByteArray>
#include <QString>

#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

namespace slidercrank
{

/// Returns the factor that converts the degrees of a Trajectory to the unit; 1 for channels that are not angles.
double factorTo(AngleUnit unit, Channel channel);

/// Appends the number with 17 significant digits, which identify a double. Writes 0 without a sign, and "nan" for NaN.
void appendNumber(QByteArray &text, double value);

/// Returns the channels in the order of indexOf().
std::vector<Channel> listed(const ChannelSet &channels);

/// Receives the text piece by piece. Returns false to stop.
using TextSink = std::function<bool(const QByteArray &text)>;

/// Returns the line of names. A name without unit means mm, ° and s; any other unit follows the name.
QByteArray csvHeader(const std::vector<Channel> &channels, AngleUnit unit);

/// Writes one row per time step. Returns false if the sink stopped it.
bool writeCsvRows(const Trajectory &trajectory, const std::vector<Channel> &channels, AngleUnit unit,
                  const TextSink &sink);

/// Writes time, crank angle and these channels in mm, ° and s to a file: at the time steps or, with a `crankStep` (°),
/// at equal steps of the crank angle over one turn. Returns nullopt on success, else a message; an older file of that name is then
/// unchanged. `progress` receives 0 … 1. Can run in any thread.
std::optional<QString> exportMotion(const QString &path, const Result &result, const ChannelSet &channels,
                                    double crankStep = 0.0, std::stop_token stop = {},
                                    const std::function<void(double)> &progress = {});

} // namespace slidercrank
