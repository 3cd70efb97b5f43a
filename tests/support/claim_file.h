// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Files of known origin, to test what the program claims about them. Each kind of file is a function of a seed and
// gives the same file on every machine. Lengths in mm, angles in rad, time in s; columns in the units of the files (mm,
// °, s) unless their factor says otherwise.

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

/// The 36 channels at one time, by indexOf(), in the units of the files; NaN where the mechanism cannot be assembled.
using Pose = std::array<long double, kChannelCount>;

/// The textbook's formulas for a crank at this angle with this speed and acceleration (rad, s).
Pose poseAt(const Parameters &parameters, long double theta2, long double speed, long double acceleration = 0.0L);

/// For a crank that turns at constant speed.
Pose motionAt(const Parameters &parameters, long double t);

/// How a program writes a number.
struct NumberForm {
    enum class Rule {
        Digits,          ///< significant digits, "%.6g"
        Decimals,        ///< "%.2f"
        DigitsInDecimals ///< six significant digits, then printed with six decimals, as Inventor does
    };
    Rule rule = Rule::Digits;
    int count = 6;
    bool everyDigit = false;  ///< the rounded number is printed once more with "%.18e"
    double quantum = 0.0;     ///< of an encoder or converter, before the number is printed; 0: none
    bool isTruncated = false; ///< the next lower value of the quantum or decimal instead of the nearest one

    double stepAt(double value) const; ///< distance of neighbouring printable values
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

/// One column, and what is true of it: values = numbers of `shown` · factor + origin + noise.
struct ClaimColumn {
    enum class Content {
        Motion,     ///< nothing but what is named here
        Systematic, ///< and a small deviation that is not white: filtered, interpolated, integrated
        Foreign     ///< another motion, or errors that hide it
    };
    Channel named; ///< by the heading
    Channel shown; ///< whose numbers it holds
    NumberForm form{};
    double factor = 1.0;
    double origin = 0.0;
    double noise = 0.0; ///< rms of white noise, in the unit of the column
    Content content = Content::Motion;
    std::vector<double> values{}; ///< before rounding; NaN is an empty cell
};

/// What the program may say about columns, in the words of `identify`: "zero-point", "angle-unit", …
struct Finding {
    std::string_view name;
    Channels channels{};
    double amount = 0.0;     ///< 0: any
    bool isOptional = false; ///< true, in whole or in part, but it need not be said
};

/// One true way to read a file.
struct ExpectedInterpretation {
    Parameters mechanism;
    std::vector<Finding> findings{};
};

/// Random numbers that are the same with every standard library.
class Random
{
public:
    explicit Random(std::uint64_t seed)
        : m_engine(seed)
    {
    }
    double uniform(double from, double to);
    double logUniform(double from, double to); ///< both > 0
    int whole(int from, int to);               ///< both included
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

/// a 5 … 100, b 1.05 … 6 times a + |c|, c up to 1.2 a of either sign, speed 0.5 … 100 rad/s of either sign, a quarter
/// of them crossed; every second one has round lengths.
Parameters anyMechanism(Random &random);

struct ClaimFile {
    ClaimFile(std::uint64_t seed, int fileNumber);

    Random random;
    int number = 0; ///< of the file in its kind, for kinds that go through a list

    std::optional<Parameters> truth; ///< none: no slider-crank made it
    std::vector<ExpectedInterpretation>
        interpretations{}; ///< the true ones; if empty when finished, the truth without findings
    Parameters given{};    ///< the mechanism that the program is asked with

    // What may be expected.
    bool hasTooFewValues = false;  ///< whatever is identified from it is luck
    bool mayBeMissed = false;      ///< the linearized fit says that the mechanism is determined, but it may be refused
    bool mayBeApproximate = false; ///< systematic deviations: `approximate` is as good as `identified`
    bool hasSaturation = false;    ///< its bad rows need not be named
    double tolerance = 2e-3;       ///< of the claimed parameters, relative, where it is more than 5 standard errors
    std::set<std::size_t> badRows{};                    ///< with wrong readings; nothing else may be excluded
    std::optional<std::array<double, 2>> crankSpeeds{}; ///< θ2 advances unevenly: its first and last speed (rad/s)
    std::optional<Parameter> wrongGiven{};              ///< the one parameter in which `given` differs from the truth

    // The rows.
    std::vector<double> instants{}; ///< s
    double timeFactor = 1.0;        ///< the file holds instants · timeFactor + timeOffset
    double timeOffset = 0.0;
    NumberForm timeForm = digits(15);
    double timeStep = 0.0; ///< s, to which the file rounds the instants; 0: printed exactly
    bool keepsEmptyRows = false;
    std::vector<std::size_t> repeatedRows{}; ///< printed twice
    struct ByAngle {                         ///< the first column holds θ2 · factor + origin (°) instead of the time
        double factor = 1.0;
        double origin = 0.0;
        bool isWithinATurn = false;
    };
    std::optional<ByAngle> byAngle{};
    std::vector<ClaimColumn> columns{};
    std::function<Pose(double)> motion{}; ///< of time; the truth's if empty

    // Filled when it is printed.
    std::string text;
    std::vector<std::size_t> lines{}; ///< of each row, counted from 1; 0: not printed

    /// Instants of so many turns, with steps of three digits, printed exactly, or as they come, with nine digits.
    void sample(double turns, int rows, double start = 0.0);
    void sample(); ///< 0.6 … 3 turns, 60 … 400 rows

    ClaimColumn &add(Channel channel, NumberForm form = {});
    void add(const Channels &channels, NumberForm form = {});
    ClaimColumn &at(Channel named);

    double exactValue(Channel channel, double t) const;
    void setContent(ClaimColumn::Content content, const Channels &channels);
    double swing(Channel channel); ///< half of largest less smallest value
    void setNoise(double part);    ///< of each column, as part of its swing

    void compute(); ///< the values of the columns that have none
    void print();   ///< all that has not been done yet
};

struct ClaimKind {
    std::string_view name;
    void (*make)(ClaimFile &);
};

ClaimFile claimFile(const ClaimKind &kind, std::uint64_t suiteSeed, int number);

std::span<const ClaimKind> plainKinds();       ///< their headings say what they are
std::span<const ClaimKind> limitKinds();       ///< toggles, rockers, crossed, …
std::span<const ClaimKind> conventionKinds();  ///< other units, origins, signs, …
std::span<const ClaimKind> otherMotionKinds(); ///< no slider-crank
std::span<const ClaimKind> faultKinds();       ///< sensors, filters, loggers and spreadsheets with their faults

} // namespace slidercrank
