// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The time steps at which the motion could not be computed, or only in part: the exit status, and the message about
// them.

#include "app/command_line.h"
#include "core/mechanism/mechanism.h"
#include "core/newton/newton_options.h"

#include <array>
#include <cstddef>
#include <span>

namespace slidercrank
{

class TimeStepReport
{
public:
    void add(std::span<const double> time, std::span<const Status> status);

    /// Success; or NotAssemblable or NotSolved after a message that begins with `prefix` and says how many steps are
    /// affected, where the first of them is, and what to do.
    ExitStatus finish(const Streams &streams, const Mechanism &mechanism, const NewtonOptions &newton,
                      const QString &prefix = {}) const;

private:
    struct Steps {
        std::size_t count = 0;
        double first = 0.0; ///< s
    };

    QString message(Status status, const Mechanism &mechanism, const NewtonOptions &newton) const;

    std::array<Steps, kStatusCount> m_steps; ///< by Status
    std::size_t m_total = 0;
};

} // namespace slidercrank
