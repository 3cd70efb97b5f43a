// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Tables of known origin, which test what the program claims about a file. A table is described in plain words:
//
//     ClaimTable(random, mechanism)
//         .overCrankAngle(10.0).with({kSlider, kSliderSpeed}).decimals(2).shifted({kSlider}, 40.0).conventions(1)
//
// Its columns contain the motion of the mechanism until a function changes them; each function changes the columns that
// exist when it is called. The last functions state what may be claimed. Lengths are in mm, angles in rad and times
// in s. Columns are in the units of files (mm, °, s).

#include "core/mechanism/channel.h"
#include "core/mechanism/mechanism.h"
#include "tests/support/channels.h"

#include <Eigen/Core>

#include <cstdint>
#include <functional>
#include <initializer_list>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace slidercrank
{

using Eigen::Index;
using Values = Eigen::ArrayXd;
using Channels = std::vector<Channel>;

inline constexpr Channel kR4y{R4y, Order::Position};
inline constexpr Channel kTheta2Diff{Theta2, Order::Velocity};
inline const Channels kSliderColumns{kSlider, kSliderSpeed, kSliderAcceleration};
inline const Channels kCouplerColumns{kTheta3, kTheta3Speed, kTheta3Acceleration};
inline const Channels kSixColumns{kPlottedChannels.begin(), kPlottedChannels.end()};
inline const Channels kDerivatives{kTheta3Speed, kSliderSpeed, kTheta3Acceleration, kSliderAcceleration};
inline const Channels kAllColumns{}; ///< all columns of the table

/// Computes a channel by the textbook's formulas. Returns NaN where the mechanism cannot be assembled.
double valueAt(const Parameters &p, Channel channel, long double crankAngle);
Values valuesOf(const Parameters &p, Channel channel, const Values &times);

/// The random numbers of a table, which depend on its seed only.
class ClaimRandom
{
public:
    explicit ClaimRandom(const std::string &seed);

    double between(double low, double high);
    double onLogScale(double low, double high); ///< between two positive numbers
    double eitherSign(double low, double high) { return oneOf({-1.0, 1.0}) * between(low, high); }
    bool isTrue(double probability) { return between(0.0, 1.0) < probability; }
    Index index(Index count) { return static_cast<Index>(between(0.0, static_cast<double>(count))); }
    Values normal(Index count);
    std::uint64_t next() { return m_engine(); }

    template <class T>
    T oneOf(std::initializer_list<T> values)
    {
        return *(values.begin() + index(static_cast<Index>(values.size())));
    }

    /// Returns a mechanism that makes full turns: a is 5 … 100 mm, b is 1.05 … 6 times a + |c|, |c| is at most 1.2 a,
    /// and |ω2| is 0.5 … 100 rad/s. A quarter of the mechanisms are crossed; half of them have round lengths.
    Parameters mechanism();

private:
    std::mt19937_64 m_engine;
};

// These return the mechanism with one change.
Parameters withOffset(Parameters p, double ratio);  ///< c / a
Parameters withCoupler(Parameters p, double ratio); ///< b / a
Parameters withMargin(Parameters p, double margin); ///< b / (a + |c|) - 1; negative for a rocker
Parameters withSpeed(Parameters p, double omega2);
Parameters withStart(Parameters p, double theta20);
Parameters enlarged(Parameters p, double factor);
Parameters crossed(Parameters p);

struct ClaimColumn {
    enum class Content {
        Motion,     ///< the motion, perhaps in a different unit, from a different origin, or with white noise
        Systematic, ///< with a small deviation that is not white: filtered, interpolated, integrated
        Foreign     ///< a different motion, or errors that hide the motion
    };
    std::string heading;
    Channel shown{}; ///< the channel whose values the column contains; not used for the time
    std::string format = "%.6g";
    std::string reprint{};  ///< format in which a second program printed the rounded numbers again; empty: none did
    double quantum = 0.0;   ///< distance between neighbouring values; 0: that of the format
    double factor = 1.0;    ///< of the values, beside the unit of the heading
    double noise = 0.0;     ///< rms of white noise
    bool hasOrigin = false; ///< the values may be measured from a different origin
    Content content = Content::Motion;
    Values values{}; ///< before they are printed; NaN for an empty cell

    double stepAt(double value) const; ///< distance between neighbouring printable values
    Values stepsAt(const Values &numbers) const;
    std::string print(double value) const;
};

/// Noise whose neighbouring values are correlated, and which grows with the reading.
struct UnevenNoise {
    double fraction = 0.0;    ///< rms for a small reading, as a fraction of half the range of the motion
    double correlation = 0.0; ///< of neighbouring values
    double growth = 0.0;      ///< the largest reading has 1 + growth times as much noise as a small one
};

/// A sine that is added to the motion.
struct Tone {
    double perTurn = 0.0;  ///< number of its periods in a turn of the crank
    double fraction = 0.0; ///< its amplitude as a fraction of half the range of the motion
};

/// Wrong readings are factor · reading + offset.
struct Misreading {
    double factor = 1.0;
    double offset = 0.0;
};

/// A weighted mean over a row and rows before and after it, whose weights decrease by exp(-decay) from row to row.
struct WeightedMean {
    int before = 0; ///< number of rows
    int after = 0;  ///< number of rows
    double decay = 0.0;
};

class ClaimTable
{
public:
    ClaimTable(ClaimRandom &random, const Parameters &mechanism);
    explicit ClaimTable(ClaimRandom &random)
        : ClaimTable(random, random.mechanism())
    {
    }

    // The rows. Without one of these functions, 60 … 300 rows in 0.6 … 3 turns.
    /// The time step either has three digits and is printed exactly, or is arbitrary and its time stamps are printed
    /// with nine digits.
    ClaimTable &overTime(double turns, double rows, double start = 0.0);
    ClaimTable &atTimes(const Values &stamps, const std::string &format);
    /// The first column is θ2 in equal steps (°), and there is no time. The crank turns once a second.
    ClaimTable &overCrankAngle(double step, double turns = 1.0);
    ClaimTable &timeDecimals(int count);
    ClaimTable &slowedDown(double factor);   ///< larger time steps in the second half
    ClaimTable &withRepeatedRows(int count); ///< `count` rows are printed twice
    ClaimTable &withEmptyRows();             ///< prints rows without any value

    // The motion. These must be called before the first column is changed.
    /// The crank turns by law(angle) where a crank with constant speed turns by `angle`, both without their signs.
    ClaimTable &turnedBy(const std::function<double(double angle)> &law);
    ClaimTable &speedingUp(double fraction);               ///< each turn adds this fraction of the first speed
    ClaimTable &rippling(double fraction, double perTurn); ///< the speed swings by ± this fraction
    ClaimTable &ofYoke(double damping, double third);      ///< a Scotch yoke with a third harmonic: no slider-crank

    // The columns. The functions about the format concern the columns that the last with() has added.
    ClaimTable &with(const Channels &channels);
    ClaimTable &with(Channel heading, Channel shown); ///< a column under the heading of a different channel
    ClaimTable &digits(int count);                    ///< significant ones; the default is 6
    ClaimTable &decimals(int count);
    ClaimTable &reprinted(); ///< by a program that prints 19 digits

    // Conventions.
    ClaimTable &multiplied(const Channels &channels, double factor);
    ClaimTable &shifted(const Channels &channels, double amount); ///< measured from a different origin
    ClaimTable &withinATurn(Channel channel);                     ///< 0 … 360°
    ClaimTable &timeMultiplied(double factor);

    // Errors of sensors. A fraction is that of half the range of the motion unless stated.
    ClaimTable &withNoise(const Channels &channels, double fraction);
    ClaimTable &withUnevenNoise(const Channels &channels, const UnevenNoise &uneven);
    ClaimTable &inSteps(const Channels &channels, double step);
    ClaimTable &truncated(const Channels &channels, double step);
    ClaimTable &withTone(const Channels &channels, const Tone &tone);
    ClaimTable &withBacklash(Channel channel, double fraction);
    ClaimTable &misread(Channel channel, const Misreading &misreading); ///< in at most 3 % of the rows
    /// One value has the opposite sign, a decimal point moved by one digit, or an error of 1 … 5 % of half the range.
    ClaimTable &mistyped(Channel channel);
    /// Each value is too small with this probability, by at most `fraction`.
    ClaimTable &failing(Channel channel, double probability, double fraction);
    ClaimTable &frozen(Channel channel);                     ///< one reading is repeated in at most 2.5 % of the rows
    ClaimTable &saturated(Channel channel, double fraction); ///< the top `fraction` of the whole range is cut off
    ClaimTable &withGaps(const Channels &channels, double probability);
    ClaimTable &withoutABlock(const Channels &channels); ///< a fifth of the rows has no values

    // Filters and clocks.
    ClaimTable &smoothed(const Channels &channels, const WeightedMean &mean);
    ClaimTable &interpolated(const Channels &channels, double rows); ///< linearly, between samples `rows` rows apart
    ClaimTable &held(const Channels &channels, double rows);         ///< repeats the last of samples `rows` rows apart
    ClaimTable &jittered(const Channels &channels, double fraction); ///< at random times; rms: `fraction` time steps

    // Values that do not belong to the motion.
    ClaimTable &delayed(const Channels &channels, double rows);
    ClaimTable &amplified(const Channels &channels, double factor);
    ClaimTable &ofLongerCoupler(const Channels &channels, double factor);
    /// The slope or curvature of the parabola that fits the printed positions of a row and `rows` rows on either side
    /// best (1: central differences). The ends are empty.
    ClaimTable &differentiated(const Channels &channels, int rows);
    ClaimTable &replacedByRandom(const Channels &channels);

    // What the program is given, and what it may claim.
    ClaimTable &given(const Parameters &parameters);
    ClaimTable &orMechanism(const Parameters &parameters); ///< this mechanism explains the file equally well
    ClaimTable &conventions(std::size_t count) { return conventionsBetween(count, count); }
    ClaimTable &conventionsBetween(std::size_t fewest, std::size_t most);
    ClaimTable &accurateTo(double relativeTolerance);
    ClaimTable &tooFewValues();   ///< to identify a mechanism reliably
    ClaimTable &mayBeMissed();    ///< although the linearized fit determines the mechanism
    ClaimTable &approximate();    ///< its systematic deviations may look like a different mechanism
    ClaimTable &contradictory();  ///< several mechanisms produced its columns, and any of them may be found
    ClaimTable &mayExcludeRows(); ///< even right ones, where the last digit of a length changes the motion noticeably
    ClaimTable &noMechanism();    ///< no slider-crank makes this motion

    /// Computes the values and prints the table.
    void print();

    ClaimColumn *find(const std::string &heading);
    const ClaimColumn *find(const std::string &heading) const { return const_cast<ClaimTable *>(this)->find(heading); }
    Values exact(Channel channel, const Values &at) const;
    double swing(Channel channel) const; ///< half the difference between the largest and the smallest value
    double timeBetweenRows() const { return times[1] - times[0]; }
    double timeStep() const; ///< rounding step of the time stamps, s

    std::optional<Parameters> truth;
    Parameters givenMechanism{};           ///< Table 1 of the reference report unless stated
    std::vector<Parameters> others{};      ///< other mechanisms that explain the file equally well
    std::optional<Parameter> wrongGiven{}; ///< the only parameter in which the given mechanism differs from the truth
    std::size_t minConventions = 0;
    std::size_t maxConventions = 0;
    double tolerance = 2e-3; ///< relative tolerance of the parameters of an exact fit, or 5 standard errors if larger
    bool hasTooFewValues = false;
    bool isMissable = false;
    bool isSystematic = false;
    bool hasSaturation = false; ///< the program need not name the bad rows
    bool hasSteepRows = false;  ///< rows that are right may be excluded
    bool isCrankUneven = false; ///< θ2 shows that the speed is not constant
    bool isOverAngle = false;   ///< there is no time

    Values times{};
    double delay = 0.0; ///< s: a filter delays all values by this
    ClaimColumn time{"time"};
    std::vector<ClaimColumn> columns{};
    std::set<Index> badRows{};           ///< rows with wrong readings; no other row may be excluded
    std::multiset<Index> repeatedRows{}; ///< rows that are printed again

    // Filled in by print().
    std::string text;
    std::set<std::size_t> badLines{};
    std::size_t lineCount = 1;

private:
    using Change = std::function<void(ClaimColumn &)>;
    ClaimTable &change(const Channels &channels, ClaimColumn::Content content, const Change &change);
    ClaimTable &setFormat(const std::string &format);
    ClaimTable &setPositions(const std::function<double(Channel, double)> &positions);
    void compute();

    ClaimRandom m_random;
    std::size_t m_firstOfLast = 0; ///< index of the first column that the last with() has added
    bool m_keepsEmptyRows = false;
    std::function<double(Channel, double)> m_motion{}; ///< as a function of time; if empty, that of the truth
};

/// A kind of tables.
struct ClaimKind {
    std::string name;
    std::function<ClaimTable(ClaimRandom &random)> make;
    bool isFault = false; ///< with the faults of a sensor, filter, logger or spreadsheet
};

/// Returns all kinds of the files claim_kinds*.cpp.
std::vector<ClaimKind> claimKinds();

/// Makes and prints a table, which depends on the kind, the seed and the number.
ClaimTable claimTable(const ClaimKind &kind, std::uint64_t seed, int number);

} // namespace slidercrank
