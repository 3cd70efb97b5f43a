// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Makes the table of the motion: a row for each crank angle or time step, with chosen columns, as numbers and as CSV.

#include "core/limits/output_channel.h"
#include "core/sampling/trajectory.h"
#include "ui/document/view_settings.h"
#include "ui/widgets/number_table.h"

#include <optional>
#include <vector>

namespace slidercrank
{

inline constexpr int kMaxTableRows = 5000;

/// Return the channels that the table can show, and the channels that it shows at first.
std::vector<OutputChannel> tableChannels();
std::vector<OutputChannel> usualTableChannels();

/// A position of the crank at which a row is computed.
struct TablePosition {
    double theta2 = 0.0;             ///< rad
    std::optional<double> time = {}; ///< s; nullopt if the crank is not there within the time range
};

/// Returns the positions of the rows: at equal steps of θ2 from 0° to 360°, or the time steps. Each angle has the first
/// time at which the crank reaches it. The exception is 360° if the crank turns counter-clockwise: it has the time at
/// which the revolution ends that begins at 0°.
std::vector<TablePosition> tablePositions(const MotionTableSettings &settings, const Mechanism &mechanism,
                                          const Sampling &sampling);

/// The first column of motionTableColumns() that shows a channel of the settings; t and θ₂ are before it.
inline constexpr int kFirstChannelColumn = 2;

/// Returns the columns: t, θ₂, and the channels of the settings, in the chosen notation and units. In CSV files, θ3 at
/// B and θ3 at A have different names, and the time of an angle is named "first time" and not "time", since the angles
/// need not be reached in the order of the rows.
std::vector<TableColumn> motionTableColumns(const MotionTableSettings &settings);

/// Returns the row of a position, at which the crank has the acceleration alpha2 (rad/s²). A value that is only a
/// rounding error is 0.
TableRow motionTableRow(const MotionTableSettings &settings, const Mechanism &mechanism, double alpha2,
                        const TablePosition &position);

/// How numbers are written to a file.
struct CsvStyle {
    bool hasEveryDigit = false; ///< otherwise six significant digits
    bool isLocal = false;       ///< decimal sign of the language, and semicolons between cells if it is a comma

    friend bool operator==(const CsvStyle &, const CsvStyle &) = default;
};

QByteArray csvText(const std::vector<TableColumn> &columns, const std::vector<TableRow> &rows, const CsvStyle &style);

/// Returns the time at which the crank, which is at time t, next reaches one of the angles (rad) in its direction of
/// rotation. After the end of the time range the search continues at its start. Returns nullopt if it reaches none
/// within the time range.
std::optional<double> nextTime(const std::vector<double> &angles, const Mechanism &mechanism, const Sampling &sampling,
                               double t);

} // namespace slidercrank
