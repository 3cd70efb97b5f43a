// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Files of known origin, to hold against what the program claims of them: exports of CAD programs, sensors and
// spreadsheets with their faults, motions that no slider-crank makes, and numbers that mean nothing. Each kind is a
// function of a seed, the same on every machine. Lengths in mm, angles in rad, time in s; columns in the author's units
// (mm, °, s) unless their factor says otherwise.

#include "core/mechanism/channel.h"
#include "core/mechanism/mechanism.h"

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <random>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace slidercrank
{

/// The 36 channels at one instant, by indexOf(), in the author's units; NaN where there is no pose.
using AllChannels = std::array<long double, kChannelCount>;

/// The textbook's formulas (printed_motion.h) for a crank that need not turn evenly: its angle, speed and acceleration
/// (rad, s).
AllChannels linkageAt(const Parameters &parameters, long double theta2, long double speed, long double acceleration);

/// Of a crank that does.
AllChannels motionAt(const Parameters &parameters, long double t);

/// How a program writes a number.
struct NumberForm {
    enum class Rule {
        Digits,          ///< so many significant digits, "%.6g"
        Decimals,        ///< so many decimals, "%.2f"
        DigitsInDecimals ///< six significant digits, then printed with six decimals, as Inventor does
    };
    Rule rule = Rule::Digits;
    int count = 6;
    bool everyDigit = false; ///< what was rounded so is written once more with "%.18e"

    /// Distance of neighbouring printable values there.
    double stepAt(double value) const;
};

/// One column, and what is true of it.
struct ClaimColumn {
    Channel named; ///< as the heading says
    Channel shown; ///< whose numbers it has: numbers · factor + zero + noise
    double factor = 1.0;
    double zero = 0.0;
    double noise = 0.0;   ///< rms, in the unit of the column
    bool isMotion = true; ///< false: it has numbers of another origin, or noise that is not white
    NumberForm form{};
    std::vector<double> values{}; ///< unrounded; NaN is an empty cell. Filled by finish(), unless the kind has done so
};

/// What the program may say of a file's columns, in the words of `identify`: "zero-point", "angle-unit", …
struct ExpectedFinding {
    std::string_view name;
    std::vector<Channel> channels;
    double amount = 0.0; ///< 0: any
};

/// One way to read a file that is true: the mechanism and all findings.
struct TrueReading {
    Parameters truth;
    std::vector<ExpectedFinding> findings{};
};

struct ClaimFile {
    std::string text;

    std::optional<Parameters> truth;     ///< none: no slider-crank made it
    std::vector<TrueReading> readings{}; ///< the true ones; of truth alone where nothing is to be found
    Parameters atHand{};                 ///< what the program is asked with

    bool tooFew = false;      ///< whatever is identified from it is luck
    bool mayBeMissed = false; ///< what fixes the mechanism on paper, and may still be refused
    /// θ2 is in the file and does not advance evenly: its speed (rad/s) at the first and at the last instant.
    std::optional<std::array<double, 2>> crankSpeeds{};
    std::optional<Parameter> offBy{}; ///< the one parameter in which atHand differs from the truth

    std::vector<double> instants{}; ///< s, as the motion had them
    double clock = 1.0;             ///< the file has instants times this
    bool keepsEmptyRows = false;
    NumberForm timeForm{NumberForm::Rule::Digits, 15};
    double timeStep = 0.0; ///< s, to which the file rounds them; 0: printed exactly
    std::vector<ClaimColumn> columns{};
};

/// Random numbers that are the same with every standard library.
class Dice
{
public:
    /// `number`: of the file in its kind, for kinds that go through a list.
    explicit Dice(std::uint64_t seed, int number = 0)
        : m_engine(seed)
        , m_number(number)
    {
    }

    int number() const { return m_number; }

    double uniform(double from, double to);
    double logUniform(double from, double to); ///< both > 0
    int whole(int from, int to);               ///< both included
    double sign() { return chance(0.5) ? 1.0 : -1.0; }
    bool chance(double probability) { return uniform(0.0, 1.0) < probability; }
    double normal();

private:
    std::mt19937_64 m_engine;
    int m_number;
};

struct ClaimKind {
    std::string_view name;
    ClaimFile (*make)(Dice &);
    int fewest = 0; ///< files that go through all of its list
};

/// All of them: those of a slider-crank, then those of none.
std::vector<ClaimKind> claimKinds();
std::span<const ClaimKind> plainKinds();       ///< read as they stand
std::span<const ClaimKind> conventionKinds();  ///< that need another reading
std::span<const ClaimKind> hardKinds();        ///< toggles, rockers, crossed, …
std::span<const ClaimKind> otherMotionKinds(); ///< no slider-crank

/// The n-th file of a kind in the suite of that seed.
ClaimFile claimFile(const ClaimKind &kind, std::uint64_t suiteSeed, int n);

// What the kinds are made of.

/// a 5 … 100, b 1.05 … 6 times a + |c|, c up to 1.2 a of either sign, speed 0.5 … 100 rad/s of either sign, a quarter
/// of them crossed; lengths of every second one in round numbers.
Parameters anyMechanism(Dice &dice);

/// A column under its own name.
ClaimColumn column(Channel channel, NumberForm form = {});

/// θ3, R4_x and their derivatives whose bit is set, in the order of kPlottedChannels.
std::vector<ClaimColumn> plottedColumns(NumberForm form = {}, unsigned mask = 0x3F);

/// `rows` instants of so many turns from `start` on: with steps of three digits, printed exactly, or as they come and
/// printed with nine digits.
void setInstants(ClaimFile &file, Dice &dice, double turns, int rows, double start = 0.0);
void setInstants(ClaimFile &file, Dice &dice); ///< 0.6 … 3 turns, 60 … 400 rows

/// The size of a column: the largest less the smallest value, halved, in the file's instants.
double swingOf(const ClaimFile &file, Channel channel);

using MotionLaw = std::function<AllChannels(double)>;

/// Works out the values and prints them. Rows without a single value are left out, or have empty cells.
void finish(ClaimFile &file, Dice &dice, const MotionLaw &motion);
void finish(ClaimFile &file, Dice &dice); ///< the motion of the truth

} // namespace slidercrank
