// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The mechanisms on which the properties of the core are tested: the named cases, rockers that are difficult to
// compute, and random mechanisms.

#include "core/closed_form/motion_constants.h"
#include "tests/support/all_cases.h"
#include "tests/support/random_mechanisms.h"

#include <cmath>
#include <string>
#include <vector>

namespace slidercrank
{

struct NamedMechanism {
    std::string name;
    Parameters parameters;
};

inline bool isRocker(const Parameters &p)
{
    return MotionConstants(Mechanism(p)).epsilon < 0.0;
}

/// Returns rockers that are difficult to compute: with almost full turns, almost locked, with two arcs that almost
/// meet, or with extreme ratios of lengths.
inline std::vector<NamedMechanism> difficultRockers()
{
    return {
        {"almost full turns, gap -1e-12", {20.0, 45.0 * (1.0 - 1e-12), 25.0, 3.0, 1.0, Branch::Crossed}},
        {"almost full turns, by a unit in the last place",
         {20.0, std::nextafter(45.0, 0.0), 25.0, 3.0, 1.0, Branch::Open}},
        {"almost locked, 1e-10", {20.0, 5.0 * (1.0 + 1e-10), 25.0, 3.0, 1.0, Branch::Open}},
        {"almost locked, a unit in the last place", {20.0, std::nextafter(5.0, 6.0), -25.0, 3.0, 1.0, Branch::Crossed}},
        {"two arcs that almost meet", {20.0, 14.999999, 5.0, 3.0, 1.0, Branch::Open}},
        {"b = |c|", {20.0, 25.0, 25.0, 3.0, 1.0, Branch::Open}},
        {"b/a = 1e-6", {1e3, 1e-3, 0.5, 3.0, 1.0, Branch::Open}},
        {"b/a = 1e4", {1e-3, 25.0001, 25.0003, 3.0, 1.0, Branch::Open}}};
}

/// Returns all mechanisms. Of the `random` ones, a third make full turns, a third have a coupler of 20 … 95 % of that
/// length, so that many are rockers, and a third are close to a toggle on either side.
inline std::vector<NamedMechanism> mechanismList(int random, std::uint64_t seed = 1)
{
    std::vector<NamedMechanism> list;
    for (const Case &namedCase : allCases()) {
        list.push_back({std::string(namedCase.name), namedCase.parameters});
    }
    for (const NamedMechanism &rocker : difficultRockers()) {
        list.push_back(rocker);
    }
    RandomMechanisms source(seed);
    for (int i = 0; i < random; ++i) {
        Parameters p = source.next();
        if (i % 3 == 1) {
            p.b *= source.uniform(0.2, 0.95);
        } else if (i % 3 == 2) {
            p.b = (p.a + std::abs(p.c)) * (1.0 + source.uniform(-1.0, 1.0) * std::pow(10.0, -source.uniform(1, 9)));
        }
        list.push_back({"random " + std::to_string(i), p});
    }
    return list;
}

} // namespace slidercrank
