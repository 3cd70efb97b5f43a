// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Which instants of a run could not be answered, or only in part: the exit status, and the sentence that says so.

#include "app/command_line.h"
#include "core/mechanism/mechanism.h"

#include <QString>

#include <array>
#include <cstddef>
#include <span>

namespace slidercrank
{

class Shortfall
{
public:
    void add(std::span<const double> time, std::span<const Status> status);

    /// Done; or NotAssemblable or NotSolved, and then it is said, behind `before`, of how many instants.
    ExitStatus report(const Mechanism &mechanism, int maxIterations, const QString &before = {}) const;

private:
    struct Instants {
        std::size_t count = 0;
        double first = 0.0; ///< s
    };
    /// How many instants, where the first of them, and what would help.
    QString sentence(const Mechanism &mechanism, int maxIterations) const;

    const Instants &of(Status status) const { return m_instants[static_cast<std::size_t>(status)]; }

    std::array<Instants, kStatusCount> m_instants; ///< by Status
    std::size_t m_total = 0;
};

} // namespace slidercrank
