// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Random mechanisms that are the same on every machine and with every standard library.

#include "core/mechanism/mechanism.h"

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

namespace slidercrank
{

class RandomMechanisms
{
public:
    explicit RandomMechanisms(std::uint64_t seed)
        : m_engine(seed)
    {
    }

    double uniform(double from, double to)
    {
        return from + (to - from) * std::ldexp(static_cast<double>(m_engine() >> 11), -53);
    }

    /// Returns a mechanism whose crank makes full turns with a margin of at least 2 %: b is 1.02 … 7.5 times a + |c|.
    /// Offset and speed have either sign, and the branches alternate.
    Parameters next()
    {
        Parameters p;
        p.a = std::exp(uniform(0.0, std::log(100.0)));
        p.c = p.a * uniform(-3.0, 3.0);
        p.b = (p.a + std::abs(p.c)) * (1.02 * std::exp(uniform(0.0, 2.0)));
        p.omega2 = std::exp(uniform(std::log(0.1), std::log(100.0))) * (uniform(-1.0, 1.0) < 0.0 ? -1.0 : 1.0);
        p.theta20 = uniform(-10.0, 10.0);
        p.branch = m_count++ % 2 == 0 ? Branch::Open : Branch::Crossed;
        return p;
    }

    /// Returns a mechanism with typical proportions. Its coupler is 1.03 to 3 times as long as a full turn requires.
    Parameters ordinary()
    {
        Parameters p;
        p.a = uniform(5.0, 100.0);
        p.c = p.a * uniform(-1.5, 1.5);
        p.b = (p.a + std::abs(p.c)) * uniform(1.03, 3.0);
        p.omega2 = std::exp(uniform(std::log(0.1), std::log(100.0))) * (uniform(-1.0, 1.0) < 0.0 ? -1.0 : 1.0);
        p.theta20 = uniform(-std::numbers::pi, std::numbers::pi);
        p.branch = uniform(-1.0, 1.0) < 0.0 ? Branch::Open : Branch::Crossed;
        return p;
    }

private:
    std::mt19937_64 m_engine;
    int m_count = 0;
};

} // namespace slidercrank
