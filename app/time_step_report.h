// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Reports time steps whose motion was not computed, on standard error.

#include "app/command_line.h"
#include "core/mechanism/mechanism.h"
#include "core/sampling/trajectory.h"

#include <span>

namespace slidercrank
{

/// Returns Success if all time steps are solved. Otherwise reports how many are not, where the first of them is, and
/// what to do, and returns NotAssemblable or NotSolved. The message begins with `prefix`.
ExitStatus reportTimeSteps(const Streams &streams, const SamplingSummary &summary, const Mechanism &mechanism,
                           const NewtonOptions &newton, const QString &prefix = {});

/// Reports a single position that is not solved, at a crank angle (rad).
ExitStatus reportPosition(const Streams &streams, Status status, const Mechanism &mechanism, double theta2);

/// Collects the rows of a table in which the velocities jump. The closed form has the values of one side there.
class JumpingRows
{
public:
    /// Adds the rows of a table with these time stamps (s) in which the velocities jump. At each time stamp, the crank
    /// has the acceleration alpha2 (rad/s²).
    void add(const Mechanism &mechanism, std::span<const double> timeStamps, double alpha2 = 0.0);

    /// Reports the number of such rows and the position of the first. Reports nothing if there are none.
    void report(const Streams &streams) const;

private:
    int m_count = 0;
    double m_firstTime = 0.0;  ///< s
    double m_firstAngle = 0.0; ///< rad
};

} // namespace slidercrank
