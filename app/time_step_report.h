// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Reports the time steps at which the motion could not be computed completely.

#include "app/command_line.h"
#include "core/mechanism/mechanism.h"
#include "core/sampling/trajectory.h"

#include <array>
#include <cstddef>

namespace slidercrank
{

class TimeStepReport
{
public:
    void add(const Trajectory &motion);

    /// Returns Success if all time steps are solved. Otherwise reports how many are affected, where the first of them
    /// is, and what to do, and returns NotAssemblable or NotSolved. The message begins with `prefix`.
    ExitStatus finish(const Streams &streams, const Mechanism &mechanism, const NewtonOptions &newton,
                      const QString &prefix = {}) const;

private:
    struct Steps {
        std::size_t count = 0;
        double first = 0.0; ///< s
    };

    std::array<Steps, kStatusCount> m_steps; ///< by Status
    std::size_t m_total = 0;
};

} // namespace slidercrank
