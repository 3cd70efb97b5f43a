// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Files of known origin, which test what the program claims about a file. A file is a table of columns with the motion
// of a mechanism, which the steps of its kind change one after the other (claim_kinds.txt). It depends only on the
// kind, a seed and a number. Lengths are in mm, angles in rad and times in s. Columns are in the units of the files
// (mm, °, s).

#include "core/mechanism/channel.h"
#include "core/mechanism/mechanism.h"

#include <Eigen/Core>

#include <functional>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace slidercrank
{

using Eigen::Index;
using Values = Eigen::ArrayXd;

/// Computes a channel by the textbook's formulas. Returns NaN where the mechanism cannot be assembled.
double valueAt(const Parameters &p, Channel channel, long double crankAngle);
Values valuesOf(const Parameters &p, Channel channel, const Values &times);

struct ClaimColumn {
    enum class Content {
        Motion,     ///< the motion, perhaps in another unit, from another origin, or with white noise
        Systematic, ///< with a small deviation that is not white: filtered, interpolated, integrated
        Foreign     ///< another motion, or errors that hide the motion
    };
    std::string heading;
    Channel shown{}; ///< the channel whose values the column contains; not used for the time
    std::string format{};
    std::string reprint{}; ///< format in which another program printed the rounded numbers again; empty: none did
    double quantum = 0.0;  ///< distance between neighbouring values; 0: that of the format
    double factor = 1.0;   ///< of the values, in addition to the unit of the heading
    double noise = 0.0;    ///< rms of white noise
    bool hasOrigin = false;
    Content content = Content::Motion;
    Values values{}; ///< before they are printed; NaN for an empty cell

    double stepAt(double value) const; ///< distance between neighbouring printable values
    Values stepsAt(const Values &numbers) const;
    std::string print(double value) const;
};

struct ClaimFile {
    explicit ClaimFile(const std::string &seed);

    /// Returns a random number, on a logarithmic scale if `high` is more than 5 times a positive `low`.
    double random(double low, double high);
    Values normal(Index count);

    /// The mechanism: a is 5 … 100 mm, b is 1.05 … 6 times a + |c|, |c| is at most 1.2 a, and |ω2| is 0.5 … 100 rad/s.
    /// It makes full turns. A quarter of the mechanisms are crossed; half of them have round lengths. nullopt if no
    /// slider-crank produces the motion.
    std::optional<Parameters> truth;
    Parameters given{};               ///< the mechanism that is passed to the program
    std::vector<Parameters> others{}; ///< other mechanisms that explain the file equally well

    // What may be claimed.
    std::size_t fewestConventions = 0; ///< with a mechanism
    std::size_t mostConventions = 0;
    double tolerance = 2e-3;       ///< relative tolerance of the claimed parameters, or 5 standard errors if larger
    bool hasTooFewValues = false;  ///< too few values to identify a mechanism reliably
    bool mayBeMissed = false;      ///< may be refused although the linearized fit determines the mechanism
    bool mayBeApproximate = false; ///< has systematic deviations: `approximate` is as good as `identified`
    bool hasSaturation = false;    ///< the program need not name the bad rows
    bool isCrankUneven = false;    ///< θ2 shows that the speed is not constant
    std::optional<Parameter> wrongGiven{}; ///< the only parameter in which `given` differs from the truth

    // The rows.
    bool isLong = false; ///< the default sampling has 100 … 400 rows in 1 … 3 turns, not 60 … 400 in 0.6 … 3
    bool keepsEmptyRows = false;
    bool isByAngle = false; ///< there is no time; the first column is θ2
    Values times{};
    double delay = 0.0;       ///< s, of all values, by a filter
    ClaimColumn time{"time"}; ///< its values are those of `times`, perhaps in another unit
    std::vector<ClaimColumn> columns{};
    std::set<Index> badRows{};           ///< rows with wrong readings; no other row may be excluded
    std::multiset<Index> repeatedRows{}; ///< rows that are printed again

    /// The motion as a function of time; if empty, that of the truth.
    std::function<double(Channel channel, double time)> motion{};

    // Filled in by print().
    std::string text;
    std::set<std::size_t> badLines{};
    std::size_t lineCount = 1;

    /// Samples the motion. The time step either has three digits and is printed exactly, or is arbitrary and its time
    /// stamps are printed with nine digits.
    void sample(double turns, double rows, double start = 0.0);
    void compute(); ///< samples the motion if necessary, and computes the values of the columns that have none
    void print();

    double timeBetweenRows() const { return times[1] - times[0]; }
    double timeStep() const; ///< rounding step of the time stamps, s
    ClaimColumn *find(const std::string &heading);
    Values exact(Channel channel, const Values &at) const;
    double swing(Channel channel) const; ///< half the difference between the largest and the smallest value

private:
    std::mt19937_64 m_engine;
};

/// A kind of files, as claim_kinds.txt describes it.
struct ClaimKind {
    std::string name{};
    bool isFault = false;             ///< of a sensor, filter, logger or spreadsheet
    std::vector<std::string> lines{}; ///< of steps
};

std::vector<ClaimKind> claimKinds();

ClaimFile claimFile(const ClaimKind &kind, std::uint64_t seed, int number);

} // namespace slidercrank
