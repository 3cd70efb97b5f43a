// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Files of known origin, which test what the program claims about a file. Each kind of file is a function of a seed and
// gives the same file on every machine. Lengths are in mm, angles in rad and times in s. Columns are in the units of
// the files (mm, °, s) unless their factor states another unit.

#include "core/mechanism/channel.h"
#include "core/mechanism/mechanism.h"

#include <array>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <optional>
#include <random>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace slidercrank
{

inline constexpr Channel kX{R4x, Order::Position};
inline constexpr Channel kV{R4x, Order::Velocity};
inline constexpr Channel kA{R4x, Order::Acceleration};
inline constexpr Channel kTheta{Theta3, Order::Position};
inline constexpr Channel kOmega{Theta3, Order::Velocity};
inline constexpr Channel kAlpha{Theta3, Order::Acceleration};
inline constexpr Channel kCrank{Theta2, Order::Position};
inline constexpr Channel kCrankSpeed{Theta2, Order::Velocity};
inline constexpr Channel kY{R4y, Order::Position};

using Channels = std::vector<Channel>;
inline const Channels kSix(kPlottedChannels.begin(), kPlottedChannels.end());
inline const Channels kSlider{kX, kV, kA};
inline const Channels kCoupler{kTheta, kOmega, kAlpha};

/// The values of the 36 channels at one time, indexed by indexOf(), in the units of the files; NaN where the mechanism
/// cannot be assembled.
using Pose = std::array<long double, kChannelCount>;

/// Evaluates the textbook's formulas for the given crank angle, speed and acceleration (rad, rad/s, rad/s²).
Pose poseAt(const Parameters &parameters, long double theta2, long double speed, long double acceleration = 0.0L);

/// Evaluates the textbook's formulas at time t for a crank that turns at constant speed.
Pose motionAt(const Parameters &parameters, long double t);

/// The format in which a program prints a number.
struct NumberForm {
    enum class Rule {
        Digits,          ///< significant digits, "%.6g"
        Decimals,        ///< "%.2f"
        DigitsInDecimals ///< six significant digits, then printed with six decimals, as Inventor does
    };
    Rule rule = Rule::Digits;
    int count = 6;
    bool everyDigit = false;  ///< the rounded number is then printed with "%.18e"
    double quantum = 0.0;     ///< step of an encoder or converter, applied before printing; 0: none
    bool isTruncated = false; ///< rounds down to the quantum or decimal instead of to the nearest

    double stepAt(double value) const; ///< distance between neighbouring printable values
    std::string print(double value) const;
};

inline NumberForm digits(int count)
{
    return {NumberForm::Rule::Digits, count};
}
inline NumberForm decimals(int count)
{
    return {NumberForm::Rule::Decimals, count};
}

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
    std::vector<double> values{}; ///< before rounding; NaN for an empty cell
};

/// A finding about columns that the program may report, by its name in `identify`: "zero-point", "angle-unit", …
struct Finding {
    std::string_view name;
    Channels channels{};
    double amount = 0.0;     ///< 0: any
    bool isOptional = false; ///< true in whole or in part, but the program need not report it
};

/// One true interpretation of a file.
struct ExpectedInterpretation {
    Parameters mechanism;
    std::vector<Finding> findings{};
};

/// Generates random numbers that are the same with every standard library.
class Random
{
public:
    explicit Random(std::uint64_t seed)
        : m_engine(seed)
    {
    }
    double uniform(double from, double to);
    double logUniform(double from, double to); ///< requires both > 0
    int whole(int from, int to);               ///< from `from` to `to` inclusive
    double normal();
    bool chance(double probability) { return uniform(0.0, 1.0) < probability; }
    double sign() { return chance(0.5) ? 1.0 : -1.0; }
    template <class T>
    T pick(std::initializer_list<T> values)
    {
        return values.begin()[whole(0, static_cast<int>(values.size()) - 1)];
    }

private:
    std::mt19937_64 m_engine;
};

/// Returns a random mechanism that makes full turns: a is 5 … 100 mm, b is 1.05 … 6 times a + |c|, |c| is at most 1.2
/// a, and |ω2| is 0.5 … 100 rad/s. A quarter of the mechanisms are crossed; half of them have round lengths.
Parameters anyMechanism(Random &random);

struct ClaimFile {
    ClaimFile(std::uint64_t seed, int fileNumber);

    Random random;
    int number = 0; ///< number of the file within its kind, for kinds that iterate over a list

    std::optional<Parameters> truth; ///< nullopt if no slider-crank produces this motion
    std::vector<ExpectedInterpretation>
        interpretations{}; ///< all true interpretations; if empty, the truth without findings
    Parameters given{};    ///< the mechanism that is passed to the program

    // What the test expects.
    bool hasTooFewValues = false;    ///< too few values to identify a mechanism reliably
    bool mayBeMissed = false;        ///< may be refused although the linearized fit determines the mechanism
    bool mayBeApproximate = false;   ///< has systematic deviations: `approximate` is as good as `identified`
    bool hasSaturation = false;      ///< the program need not name the bad rows
    double tolerance = 2e-3;         ///< relative tolerance of the claimed parameters, or 5 standard errors if larger
    std::set<std::size_t> badRows{}; ///< rows with wrong readings; no other row may be excluded
    std::optional<std::array<double, 2>> crankSpeeds{}; ///< first and last speed (rad/s) of a crank that turns unevenly
    std::optional<Parameter> wrongGiven{};              ///< the only parameter in which `given` differs from the truth

    // The rows.
    std::vector<double> instants{}; ///< s
    double timeFactor = 1.0;        ///< the file contains instants · timeFactor + timeOffset
    double timeOffset = 0.0;
    NumberForm timeForm = digits(15);
    double timeStep = 0.0; ///< rounding step of the time stamps, s; 0: printed exactly
    bool keepsEmptyRows = false;
    std::vector<std::size_t> repeatedRows{}; ///< rows that are printed twice
    struct ByAngle { ///< the first column contains θ2 · factor + origin (°) instead of the time
        double factor = 1.0;
        double origin = 0.0;
        bool isWithinATurn = false;
    };
    std::optional<ByAngle> byAngle{};
    std::vector<ClaimColumn> columns{};
    std::function<Pose(double)> motion{}; ///< the motion as a function of time; if empty, that of the truth

    // Filled in by print().
    std::string text;
    std::vector<std::size_t> lines{}; ///< line of each row, counted from 1; 0: not printed

    /// Samples the given number of turns. The time step either has three digits and is printed exactly, or is arbitrary
    /// and its time stamps are printed with nine digits.
    void sample(double turns, int rows, double start = 0.0);
    void sample(); ///< samples 0.6 … 3 turns with 60 … 400 rows

    ClaimColumn &add(Channel channel, NumberForm form = {});
    void add(const Channels &channels, NumberForm form = {});
    ClaimColumn &at(Channel named);

    double exactValue(Channel channel, double t) const;
    void setContent(ClaimColumn::Content content, const Channels &channels);
    double swing(Channel channel); ///< half the difference between the largest and the smallest value
    void setNoise(double part);    ///< sets the noise of each column as a fraction of its swing

    void compute(); ///< computes the values of the columns that have none
    void print();   ///< computes what is missing and writes `text` and `lines`
};

struct ClaimKind {
    std::string_view name;
    void (*make)(ClaimFile &);
};

ClaimFile claimFile(const ClaimKind &kind, std::uint64_t suiteSeed, int number);

std::span<const ClaimKind> plainKinds();       ///< files whose headings name quantity and unit
std::span<const ClaimKind> limitKinds();       ///< toggles, rockers, crossed mechanisms, …
std::span<const ClaimKind> conventionKinds();  ///< other units, origins, signs, …
std::span<const ClaimKind> otherMotionKinds(); ///< motions of other mechanisms
std::span<const ClaimKind> faultKinds();       ///< sensors, filters, loggers and spreadsheets with their faults

} // namespace slidercrank
