// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A motion as a table of text: a line of names, then a row an instant with the time (s) and the channels asked for. The
// one form that `slidercrank solve` and the window write and that both read again as a reference, to the last bit.

#include "core/sampling/trajectory.h"
#include "ui/document/result.h"

#include <QByteArray>
#include <QString>

#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

namespace slidercrank
{

enum class AngleUnit { Degree, Radian };

/// From the degrees of a Trajectory.
double factorTo(AngleUnit unit, Channel channel);

/// 17 significant digits, enough to read the same double back; 0 without a sign; "nan" where there is none.
void appendNumber(QByteArray &text, double value);

/// In the order of indexOf().
std::vector<Channel> listed(const ChannelSet &channels);

/// Takes the text piece by piece, and how many instants are in it so far; false when no more is to come.
using TextSink = std::function<bool(const QByteArray &text, std::size_t instants)>;

/// A name stands alone in the author's units, any other unit behind it, so that what is written is read back right.
QByteArray csvHeader(const std::vector<Channel> &channels, AngleUnit unit);

/// False when the sink took no more.
bool writeCsvRows(const Trajectory &trajectory, const std::vector<Channel> &channels, AngleUnit unit,
                  const TextSink &sink);

/// Writes time, crank angle and these channels in mm, ° and s: at the time steps or, with a `crankStep` (°), every so
/// many degrees over one revolution. Returns a sentence if it cannot; then an older file of that name is still there.
/// `progress` is told 0 … 1. Can run in any thread.
std::optional<QString> exportMotion(const QString &path, const Result &result, const ChannelSet &channels,
                                    double crankStep = 0.0, std::stop_token stop = {},
                                    const std::function<void(double)> &progress = {});

} // namespace slidercrank
