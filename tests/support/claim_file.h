// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Files of known origin, which test what the program claims about a file. A file is built from a mechanism, a sampling
// and a list of steps, each of which distorts the motion and states what may then be claimed. It depends only on a seed
// and is the same on every machine. Lengths are in mm, angles in rad and times in s. Columns are in the units of the
// files (mm, °, s).

#include "core/identification/convention.h"
#include "core/mechanism/channel.h"
#include "core/mechanism/mechanism.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace slidercrank
{

inline constexpr Channel kX{R4x, Order::Position};
inline constexpr Channel kY{R4y, Order::Position};
inline constexpr Channel kTheta{Theta3, Order::Position};
inline constexpr Channel kCrank{Theta2, Order::Position};

using Channels = std::vector<Channel>;

using Eigen::Index;
using Values = Eigen::ArrayXd;

/// The values of the 36 channels at one time, indexed by indexOf(), in the units of the files; NaN where the mechanism
/// cannot be assembled.
using Pose = Eigen::Array<long double, 1, kChannelCount>;

/// The poses at several times, a row for each time.
using Poses = Eigen::Array<long double, Eigen::Dynamic, kChannelCount>;

/// The index of a channel in a pose or motion.
inline Index columnOf(Channel channel)
{
    return static_cast<Index>(indexOf(channel));
}

/// Evaluates the textbook's formulas for a crank that turns at constant speed and has the given angle (rad).
Pose poseAt(const Parameters &parameters, long double theta2);

/// Evaluates the textbook's formulas at the given times.
Poses motionOf(const Parameters &parameters, const Values &times);

/// The format in which a program prints a number.
struct NumberForm {
    int digits = 6;            ///< significant digits
    int decimals = -1;         ///< number of decimals that are printed; -1: as many as the digits need
    bool isScientific = false; ///< prints the rounded number with 19 digits and an exponent
    double quantum = 0.0;      ///< step of an encoder or converter, applied before printing; 0: none
    bool isTruncated = false;  ///< rounds down to the next printable value instead of to the nearest

    double stepAt(double value) const; ///< distance between neighbouring printable values
    Values stepsAt(const Values &values) const;
    std::string print(double value) const;
};

inline NumberForm decimals(int count)
{
    return {17, count};
}

/// Generates random numbers that are the same with every standard library.
class Random
{
public:
    explicit Random(std::uint64_t seed)
        : m_engine(seed)
    {
    }
    double in(double low, double high); ///< on a logarithmic scale if `high` is more than 5 times a positive `low`
    int whole(int from, int to);        ///< from `from` to `to` inclusive
    Values normal(Index count);
    bool chance(double probability) { return in(0.0, 1.0) < probability; }
    double sign() { return chance(0.5) ? 1.0 : -1.0; }

private:
    std::mt19937_64 m_engine;
};

/// One column and how its values were made: values = `shown` channel · factor + origin + noise.
struct ClaimColumn {
    enum class Content {
        Motion,     ///< the motion with the factor, origin and noise below
        Systematic, ///< with a small deviation that is not white: filtered, interpolated, integrated
        Foreign     ///< another motion, or errors that hide the motion
    };
    Channel named; ///< channel that the heading names
    Channel shown; ///< channel whose values the column contains
    NumberForm form{};
    double factor = 1.0;
    double origin = 0.0;
    double noise = 0.0; ///< rms of white noise, in the unit of the column
    Content content = Content::Motion;
    Values values{}; ///< before rounding; NaN for an empty cell
};

/// A convention that the program has to report. The amount 0 stands for any.
struct Finding {
    Convention::Kind kind;
    Channels channels{};
    double amount = 0.0;
    bool isOptional = false; ///< true in whole or in part, but need not be reported
};

/// One true interpretation of a file.
struct TrueInterpretation {
    Parameters mechanism;
    std::vector<Finding> findings{};
};

struct ClaimFile {
    ClaimFile(std::uint64_t seed, int fileIndex);

    Random random;
    int index = 0; ///< of the file within its kind, for kinds that iterate over a list

    /// The mechanism: a is 5 … 100 mm, b is 1.05 … 6 times a + |c|, |c| is at most 1.2 a, and |ω2| is 0.5 … 100 rad/s.
    /// It makes full turns. A quarter of the mechanisms are crossed; half of them have round lengths. nullopt if no
    /// slider-crank produces the motion.
    std::optional<Parameters> truth;
    Parameters given{}; ///< the mechanism that is passed to the program

    // What may be claimed.
    std::vector<Finding> findings{}; ///< of the truth
    std::vector<TrueInterpretation>
        interpretations{};         ///< other true ones; print() inserts that of the truth as the first
    bool hasTooFewValues = false;  ///< too few values to identify a mechanism reliably
    bool mayBeMissed = false;      ///< may be refused although the linearized fit determines the mechanism
    bool mayBeApproximate = false; ///< has systematic deviations: `approximate` is as good as `identified`
    bool hasSaturation = false;    ///< the program need not name the bad rows
    double tolerance = 2e-3;       ///< relative tolerance of the claimed parameters, or 5 standard errors if larger
    std::set<Index> badRows{};     ///< rows with wrong readings; no other row may be excluded
    std::optional<std::array<double, 2>> crankSpeeds{}; ///< first and last speed (rad/s) of a crank that turns unevenly
    std::optional<Parameter> wrongGiven{};              ///< the only parameter in which `given` differs from the truth

    // The rows.
    bool isLong = false; ///< the default sampling has 100 … 400 rows in 1 … 3 turns, not 60 … 400 in 0.6 … 3
    Values instants{};   ///< s
    NumberForm timeForm{15};
    double timeStep = 0.0;     ///< rounding step of the time stamps, s; 0: printed exactly
    bool isByAngle = false;    ///< the first column contains θ2 (°) instead of the time
    bool isWithinTurn = false; ///< θ2 is printed in the range 0 … 360°
    double timeFactor = 1.0;   ///< the first column contains its value · timeFactor + timeOrigin
    double timeOrigin = 0.0;
    bool keepsEmptyRows = false;
    std::multiset<Index> repeatedRows{}; ///< rows that are printed again
    std::vector<ClaimColumn> columns{};
    std::function<Pose(long double)> pose{}; ///< the motion as a function of time; if empty, that of the truth

    // Filled in by print().
    std::string text;
    std::vector<std::size_t> lines{}; ///< line of each row, counted from 1; 0: not printed

    /// Samples the motion. The time step either has three digits and is printed exactly, or is arbitrary and its time
    /// stamps are printed with nine digits.
    void sample(double turnCount, int rowCount, double start = 0.0);
    void sampleOnce(); ///< samples at random, unless the motion has been sampled
    double timeBetweenRows() const { return instants[1] - instants[0]; }

    void add(const Channels &channels, const NumberForm &form = {});
    template <class Value>
    void setForms(Value NumberForm::*property, Value value)
    {
        for (ClaimColumn &column : columns) {
            column.form.*property = value;
        }
    }
    ClaimColumn &at(Channel named);
    bool has(Channel named) const;

    Poses motionAt(const Values &times) const;
    Values exactValues(Channel channel, const Values &times) const;
    Values exactValues(Channel channel) const { return exactValues(channel, instants); }
    double swing(Channel channel); ///< half the difference between the largest and the smallest value

    void compute(); ///< samples the motion if necessary, and computes the values of the columns that have none
    void print();   ///< computes what is missing and writes `text` and `lines`
};

/// A kind of files, as claim_kinds.txt describes it.
struct ClaimKind {
    std::string name{};
    bool isFault = false;             ///< of a sensor, filter, logger or spreadsheet
    std::vector<std::string> lines{}; ///< of steps
};

std::vector<ClaimKind> claimKinds();

/// Generates a file. Repeats this while its systematic deviation is too small to be visible.
ClaimFile claimFile(const ClaimKind &kind, std::uint64_t suiteSeed, int number);

} // namespace slidercrank
