// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Writes a motion as CSV: a line of names, then one row per time step with the time (s), the crank angle and the
// requested channels. In the units of files it is read back as a reference without loss.

#include "core/sampling/trajectory.h"
#include "ui/document/result.h"
#include "ui/text/notation.h"

#include <QByteArray>
#include <QString>

#include <functional>
#include <optional>
#include <stop_token>

namespace slidercrank
{

/// Appends the number with 17 significant digits, which identify a double. Writes 0 without a sign, and "nan" for NaN.
void appendNumber(QByteArray &text, double value);

/// The column of θ3 in the notation of textbooks, which measure it at B. The import recognizes the name.
inline constexpr const char *kCouplerAngleAtB = "theta3 at B";

struct MotionCsvOptions {
    ChannelSet channels;
    /// Decides where θ3 is measured, and the units. A unit that differs from that of files follows the name of its
    /// column.
    Notation notation = {};
};

/// Writes time, crank angle and the channels to a file, with every digit. Returns nullopt on success
/// and if stopped, else a message; unless it succeeds, an older file of that name is unchanged. `progress` receives
/// 0 … 1. Can run in any thread.
std::optional<QString> exportMotion(const QString &path, const Result &result, const MotionCsvOptions &options,
                                    std::stop_token stop = {}, const std::function<void(double)> &progress = {});

} // namespace slidercrank
