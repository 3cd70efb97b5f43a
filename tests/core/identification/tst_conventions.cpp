// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/diagnosis.h"

#include "core/comparison/comparison.h"

#include "tests/support/long_tests.h"
#include "tests/support/printed_motion.h"
#include "tests/support/random_mechanisms.h"
#include "tests/support/suite.h"

#include <QFile>
#include <QTest>

#include <algorithm>
#include <array>
#include <atomic>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <new>
#include <numbers>
#include <string>
#include <vector>

using namespace slidercrank;
using Kind = Convention::Kind;

namespace
{

std::atomic<std::size_t> largestAllocation =
    0; // bytes, since the last reset to 0; atomic, because QtTest's watchdog thread allocates, too

void count(std::size_t size)
{
    if (size > largestAllocation) {
        largestAllocation = size;
    }
}

} // namespace

void *operator new(std::size_t size)
{
    count(size);
    if (void *memory = std::malloc(std::max<std::size_t>(size, 1))) {
        return memory;
    }
    throw std::bad_alloc();
}

void *operator new(std::size_t size, const std::nothrow_t &) noexcept
{
    count(size);
    return std::malloc(std::max<std::size_t>(size, 1));
}

// Not inlined, because g++ 14 would otherwise warn of a mismatch of new and free.
[[gnu::noinline]] void operator delete(void *memory) noexcept
{
    std::free(memory);
}

[[gnu::noinline]] void operator delete(void *memory, std::size_t) noexcept
{
    std::free(memory);
}

namespace
{

std::vector<ConventionFinding> findConventions(const ReferenceData &data, const Mechanism &mechanism,
                                               std::stop_token stop = {})
{
    return diagnose(data, mechanism, std::move(stop)).conventions;
}

constexpr double kPi = std::numbers::pi;

/// Returns the number of random files to test. Sanitizer builds are thirty times slower and check memory, not numbers,
/// so they test only a few.
int filesOf(int all)
{
    const int some = (all + 9) / 10;
#ifdef __SANITIZE_ADDRESS__
    return runs((all + 49) / 50, some);
#else
    return runs(some, all);
#endif
}

constexpr Channel kTheta{Theta3, Order::Position};
constexpr Channel kThetaDot{Theta3, Order::Velocity};
constexpr Channel kThetaDDot{Theta3, Order::Acceleration};
constexpr Channel kX{R4x, Order::Position};
constexpr Channel kXDot{R4x, Order::Velocity};
constexpr Channel kXDDot{R4x, Order::Acceleration};
const std::vector<Channel> kAngles{kTheta, kThetaDot, kThetaDDot};
const std::vector<Channel> kLengths{kX, kXDot, kXDDot};

/// The content of a file: the time column and one column for each channel.
struct Table {
    std::vector<double> time;
    std::vector<std::pair<Channel, std::vector<double>>> columns;

    std::vector<double> &operator[](Channel channel)
    {
        return std::find_if(columns.begin(), columns.end(), [&](const auto &one) { return one.first == channel; })
            ->second;
    }

    void keepOnly(const std::vector<Channel> &channels)
    {
        std::erase_if(columns, [&](const auto &one) {
            return std::find(channels.begin(), channels.end(), one.first) == channels.end();
        });
    }
};

/// Appends a row with the textbook's motion (Norton, "Design of Machinery", eq. 4.16, 6.22, 7.15, with θ³ = θ_3 -
/// 180°), in mm and °.
void appendMotion(Table &table, const Parameters &p, double t)
{
    const double theta2 = p.omega2 * t + p.theta20;
    const double steepness = std::asin((p.c - p.a * std::sin(theta2)) / p.b);
    const double theta3 = p.branch == Branch::Open ? steepness : kPi - steepness;
    const double omega3 = -p.a * p.omega2 * std::cos(theta2) / (p.b * std::cos(theta3));
    const double alpha3 = (p.a * p.omega2 * p.omega2 * std::sin(theta2) + p.b * omega3 * omega3 * std::sin(theta3)) /
                          (p.b * std::cos(theta3));
    table[kX].push_back(p.a * std::cos(theta2) + p.b * std::cos(theta3));
    table[kXDot].push_back(-p.a * p.omega2 * std::sin(theta2) - p.b * omega3 * std::sin(theta3));
    table[kXDDot].push_back(-p.a * p.omega2 * p.omega2 * std::cos(theta2) - p.b * alpha3 * std::sin(theta3) -
                            p.b * omega3 * omega3 * std::cos(theta3));
    table[kTheta].push_back(180.0 / kPi * theta3);
    table[kThetaDot].push_back(180.0 / kPi * omega3);
    table[kThetaDDot].push_back(180.0 / kPi * alpha3);
}

Table motionAt(const Parameters &parameters, const std::vector<double> &instants)
{
    Table table;
    table.time = instants;
    for (const Channel channel : {kX, kXDot, kXDDot, kTheta, kThetaDot, kThetaDDot}) {
        table.columns.push_back({channel, {}});
    }
    for (const double t : instants) {
        appendMotion(table, parameters, t);
    }
    return table;
}

void append(std::string &text, double value, int digits)
{
    std::array<char, 40> buffer;
    const auto end =
        std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::general, digits);
    text.append(buffer.data(), end.ptr);
}

/// Writes the table with six significant digits and reads it back.
ReferenceData writtenAndRead(const Table &table)
{
    std::string csv = "time";
    for (const auto &[channel, values] : table.columns) {
        csv += ',';
        csv += nameOf(channel);
    }
    csv += '\n';
    for (std::size_t i = 0; i < table.time.size(); ++i) {
        append(csv, table.time[i], 17);
        for (const auto &[channel, values] : table.columns) {
            csv += ',';
            append(csv, values[i], 6);
        }
        csv += '\n';
    }
    const auto outcome = readReferenceData(csv);
    const ReferenceData *data = std::get_if<ReferenceData>(&outcome);
    return data ? *data : ReferenceData();
}

/// Random mechanisms whose crank makes full turns, and their time stamps.
class RandomFiles
{
public:
    explicit RandomFiles(std::uint64_t seed)
        : m_random(seed)
    {
    }

    double uniform(double from, double to) { return m_random.uniform(from, to); }

    Parameters mechanism()
    {
        Parameters p;
        p.a = uniform(5.0, 80.0);
        p.c = p.a * uniform(-1.5, 1.5);
        p.b = (p.a + std::abs(p.c)) * uniform(1.05, 3.0);
        p.omega2 = uniform(0.5, 20.0) * (uniform(-1.0, 1.0) < 0.0 ? -1.0 : 1.0);
        p.theta20 = uniform(-kPi, kPi);
        p.branch = m_count++ % 2 == 0 ? Branch::Open : Branch::Crossed;
        return p;
    }

    /// Returns 80 to 500 time stamps over 0.6 to 3 turns.
    std::vector<double> instants(const Parameters &p)
    {
        const int rows = static_cast<int>(uniform(80.0, 500.0));
        const double duration = uniform(0.6, 3.0) * 2.0 * kPi / std::abs(p.omega2);
        std::vector<double> time;
        for (int i = 0; i < rows; ++i) {
            time.push_back(duration * i / (rows - 1));
        }
        return time;
    }

private:
    RandomMechanisms m_random;
    int m_count = 0;
};

void multiply(Table &table, const std::vector<Channel> &channels, double factor)
{
    for (const Channel channel : channels) {
        for (double &value : table[channel]) {
            value *= factor;
        }
    }
}

/// A change of a file and the conventions that must be found. `parameters` are passed as the given mechanism.
struct Fault {
    const char *name;
    std::function<std::vector<Convention>(Table &, Parameters &, RandomFiles &)> inject;
};

/// Returns a fault that writes columns in another unit or with the other sign. Multiplying them by `amount` corrects
/// them.
Fault multiplied(const char *name, Kind kind, const std::vector<Channel> &channels, double amount)
{
    return {name, [=](Table &table, Parameters &, RandomFiles &) {
                multiply(table, channels, 1.0 / amount);
                return std::vector<Convention>{{kind, channels, amount}};
            }};
}

Fault turned(const char *name, Kind kind, double amount)
{
    return {name, [=](Table &table, Parameters &, RandomFiles &) {
                std::ranges::for_each(table[kTheta], [=](double &value) { value -= amount; });
                return std::vector<Convention>{{kind, {kTheta}, amount}};
            }};
}

Fault timed(const char *name, double amount)
{
    return {name, [=](Table &table, Parameters &, RandomFiles &) {
                std::ranges::for_each(table.time, [=](double &t) { t /= amount; });
                return std::vector<Convention>{{Kind::TimeUnit, {}, amount}};
            }};
}

Fault swapped(const char *name, Channel one, Channel other)
{
    return {name, [=](Table &table, Parameters &, RandomFiles &) {
                std::swap(table[one], table[other]);
                return std::vector<Convention>{{Kind::SwappedColumns, {one, other}, 1.0}};
            }};
}

Fault spoilt(const char *name, Channel channel, const std::function<void(std::vector<double> &, RandomFiles &)> &spoil)
{
    return {name, [=](Table &table, Parameters &, RandomFiles &random) {
                spoil(table[channel], random);
                return std::vector<Convention>{{Kind::NotDerivative, {channel}, 1.0}};
            }};
}

const std::vector<Fault> &faults()
{
    static const std::vector<Fault> all{
        multiplied("angles in radians", Kind::AngleUnit, kAngles, 180.0 / kPi),
        multiplied("only the angle in radians", Kind::AngleUnit, {kTheta}, 180.0 / kPi),
        multiplied("the angle's derivatives in radians", Kind::AngleUnit, {kThetaDot, kThetaDDot}, 180.0 / kPi),
        multiplied("degrees under a heading of radians", Kind::AngleUnit, kAngles, kPi / 180.0),
        multiplied("velocity in m/s", Kind::LengthUnit, {kXDot}, 1e3),
        multiplied("position in cm", Kind::LengthUnit, {kX}, 10.0),
        multiplied("acceleration in in/s²", Kind::LengthUnit, {kXDDot}, 25.4),
        timed("instants in ms", 1e-3),
        timed("instants in s under a heading of ms", 1e3),
        multiplied("velocity with the other sign", Kind::Sign, {kXDot}, -1.0),
        multiplied("angular acceleration with the other sign", Kind::Sign, {kThetaDDot}, -1.0),
        turned("the textbook's θ_3", Kind::HalfTurn, -180.0),
        turned("a whole turn less", Kind::WholeTurns, 360.0),
        swapped("position and acceleration swapped", kX, kXDDot),
        swapped("velocity and acceleration swapped", kXDot, kXDDot),
        swapped("angle and position swapped", kTheta, kX),
        swapped("the two velocities swapped", kThetaDot, kXDot),
        spoilt("an acceleration delayed by some rows", kXDDot,
               [](std::vector<double> &values, RandomFiles &) {
                   std::rotate(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 20),
                               values.end());
               }),
        spoilt("an angular velocity that is another gear's", kThetaDot,
               [](std::vector<double> &values, RandomFiles &) {
                   std::ranges::for_each(values, [](double &value) { value *= 1.7; });
               }),
        spoilt("a velocity of noise", kXDot,
               [](std::vector<double> &values, RandomFiles &random) {
                   std::ranges::for_each(values, [&](double &value) { value *= random.uniform(-1.0, 1.0); });
               }),
    };
    return all;
}

/// Returns faults that another mechanism explains equally well.
const std::vector<Fault> &faultsOfTheWhole()
{
    static const std::vector<Fault> all{
        multiplied("all lengths in metres", Kind::LengthUnit, kLengths, 1e3),
        multiplied("all lengths in inches", Kind::LengthUnit, kLengths, 25.4),
        {"everything per millisecond",
         [](Table &table, Parameters &p, RandomFiles &random) {
             timed("", 1e-3).inject(table, p, random);
             multiply(table, {kXDot, kThetaDot}, 1e-3);
             multiply(table, {kXDDot, kThetaDDot}, 1e-6);
             return std::vector<Convention>{{Kind::TimeUnit, {kXDot, kXDDot, kThetaDot, kThetaDDot}, 1e-3}};
         }},
        multiplied("the other sense of rotation", Kind::Sign, kAngles, -1.0),
        {"the other assembly",
         [](Table &, Parameters &p, RandomFiles &) {
             p.branch = oppositeBranch(p.branch);
             return std::vector<Convention>{{Kind::Branch, {}, 1.0}};
         }},
        {"a late start",
         [](Table &table, Parameters &p, RandomFiles &random) {
             const double late = random.uniform(0.02, 0.45) * 2.0 * kPi / std::abs(p.omega2);
             std::ranges::for_each(table.time, [=](double &t) { t += late; });
             return std::vector<Convention>{{Kind::TimeShift, {}, -late}};
         }},
    };
    return all;
}

const Fault kAxisReversed = multiplied("the x axis reversed", Kind::Sign, kLengths, -1.0);

Fault faultNamed(const std::string &name)
{
    for (const auto &list : {faults(), faultsOfTheWhole()}) {
        for (const Fault &fault : list) {
            if (fault.name == name) {
                return fault;
            }
        }
    }
    return {};
}

std::string inWords(const std::vector<ConventionFinding> &findings)
{
    std::string words;
    for (const ConventionFinding &finding : findings) {
        words += "kind " + std::to_string(static_cast<int>(finding.convention.kind));
        for (const Channel channel : finding.convention.channels) {
            words += ' ';
            words += nameOf(channel);
        }
        words += " by " + std::to_string(finding.convention.amount);
        words += ": " + std::to_string(finding.before) + " % to " + std::to_string(finding.after) + " %; ";
    }
    return words.empty() ? "nothing" : words;
}

bool isSame(const Convention &found, const Convention &expected)
{
    const auto sorted = [](std::vector<Channel> channels) {
        std::sort(channels.begin(), channels.end(), [](Channel x, Channel y) { return indexOf(x) < indexOf(y); });
        return channels;
    };
    const double slack = expected.kind == Kind::TimeShift ? 1e-4 : 1e-9;
    return found.kind == expected.kind && sorted(found.channels) == sorted(expected.channels) &&
           std::abs(found.amount - expected.amount) <= slack * std::abs(expected.amount);
}

/// Returns whether exactly these conventions were found, in any order, and each reduces the error to nearly zero.
bool areFound(const std::vector<ConventionFinding> &findings, const std::vector<Convention> &expected)
{
    const auto isFound = [&](const Convention &one) {
        return std::any_of(findings.begin(), findings.end(),
                           [&](const ConventionFinding &finding) { return isSame(finding.convention, one); });
    };
    const auto helps = [](const ConventionFinding &finding) { return finding.before > 1.0 && finding.after < 0.1; };
    return findings.size() == expected.size() && std::all_of(expected.begin(), expected.end(), isFound) &&
           std::all_of(findings.begin(), findings.end(), helps);
}

ReferenceData reportsFile()
{
    QFile file(qEnvironmentVariable("SLIDERCRANK_REFERENCE_FILE"));
    const QByteArray bytes = file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    const auto outcome = readReferenceData({bytes.constData(), static_cast<std::size_t>(bytes.size())});
    const ReferenceData *data = std::get_if<ReferenceData>(&outcome);
    return data ? *data : ReferenceData();
}

} // namespace

class TestConventions : public QObject
{
    Q_OBJECT

private slots:
    void findsAFaultAgainstTheGivenMechanism_data()
    {
        QTest::addColumn<Fault>("fault");
        for (const auto &list : {faults(), faultsOfTheWhole(), {kAxisReversed}}) {
            for (const Fault &fault : list) {
                QTest::newRow(fault.name) << fault;
            }
        }
    }

    void findsAFaultAgainstTheGivenMechanism()
    {
        QFETCH(const Fault, fault);
        RandomFiles files(1);
        for (int i = 0; i < filesOf(50); ++i) {
            Parameters p = files.mechanism();
            Table table = motionAt(p, files.instants(p));
            const std::vector<Convention> expected = fault.inject(table, p, files);
            const std::vector<ConventionFinding> found = findConventions(writtenAndRead(table), Mechanism(p));
            QVERIFY2(areFound(found, expected), (std::to_string(i) + ": " + inWords(found)).c_str());
        }
    }

    void findsTwoFaultsInOneFile_data()
    {
        QTest::addColumn<Fault>("first");
        QTest::addColumn<Fault>("second");
        QTest::addColumn<bool>("isGiven");
        const auto add = [](const char *first, const char *second, bool isGiven) {
            const std::string name = std::string(first) + ", " + second + (isGiven ? ", given mechanism" : "");
            QTest::newRow(name.c_str()) << faultNamed(first) << faultNamed(second) << isGiven;
        };
        for (const bool isGiven : {true, false}) {
            add("angles in radians", "velocity in m/s", isGiven);
            add("angles in radians", "the textbook's θ_3", isGiven);
            add("angles in radians", "velocity and acceleration swapped", isGiven);
            add("instants in ms", "angles in radians", isGiven);
            add("instants in ms", "angle and position swapped", isGiven);
            add("position in cm", "the textbook's θ_3", isGiven);
            add("velocity with the other sign", "the angle's derivatives in radians", isGiven);
            add("velocity with the other sign", "a whole turn less", isGiven);
            add("a velocity of noise", "angles in radians", isGiven);
            add("an acceleration delayed by some rows", "the textbook's θ_3", isGiven);
        }
        add("all lengths in metres", "angles in radians", true);
        add("all lengths in inches", "a late start", true);
        add("the other assembly", "a late start", true);
        add("a late start", "the textbook's θ_3", true);
        add("a late start", "the other sense of rotation", true);
        add("a late start", "velocity and acceleration swapped", true);
    }

    void findsTwoFaultsInOneFile()
    {
        QFETCH(const Fault, first);
        QFETCH(const Fault, second);
        QFETCH(const bool, isGiven);
        RandomFiles files(3);
        for (int i = 0; i < filesOf(10); ++i) {
            Parameters p = files.mechanism();
            Table table = motionAt(p, files.instants(p));
            std::vector<Convention> expected = second.inject(table, p, files);
            for (const Convention &one : first.inject(table, p, files)) {
                expected.push_back(one);
            }
            const std::vector<ConventionFinding> found =
                findConventions(writtenAndRead(table), isGiven ? Mechanism(p) : Mechanism());
            QVERIFY2(areFound(found, expected), (std::to_string(i) + ": " + inWords(found)).c_str());
        }
    }

    void findsNothingInCleanFiles()
    {
        RandomFiles files(2);
        for (int i = 0; i < filesOf(200); ++i) {
            const Parameters p = files.mechanism();
            const ReferenceData data = writtenAndRead(motionAt(p, files.instants(p)));
            for (const Parameters &compared : {p, files.mechanism(), Parameters()}) {
                const std::vector<ConventionFinding> found = findConventions(data, Mechanism(compared));
                QVERIFY2(found.empty(), (std::to_string(i) + ": " + inWords(found)).c_str());
            }
        }
    }

    void findsNothingInTheCranksAngleWhereverTheTurnBegins()
    {
        for (const double theta20 : {0.0, 0.5, 1.5, 3.0, -0.5, -3.0}) {
            for (const int rows : {100, 101}) {
                Parameters p;
                p.theta20 = theta20;
                QByteArray text = "time,theta2,R4_x,R4_x_diff,R4_x_diff2\n";
                for (int i = 0; i < rows; ++i) {
                    const double t = 0.01 * i;
                    const PrintedRow row = textbookMotion(p, static_cast<long double>(t));
                    text += QByteArray::number(t) + ',' +
                            QByteArray::number((theta20 + p.omega2 * t) * kDegreesPerRadian, 'g', 8);
                    for (const std::size_t value : {1U, 3U, 5U}) { // x and its derivatives
                        text += ',' + QByteArray::number(static_cast<double>(row[value]), 'g', 8);
                    }
                    text += '\n';
                }
                Parameters other = p;
                other.b = 60.0;
                const auto outcome = readReferenceData(text.toStdString());
                QVERIFY(std::holds_alternative<ReferenceData>(outcome));
                for (const Parameters &compared : {p, other}) {
                    const std::vector<ConventionFinding> found =
                        findConventions(std::get<ReferenceData>(outcome), Mechanism(compared));
                    QVERIFY2(found.empty(), inWords(found).c_str());
                }
            }
        }
    }

    void findsAFaultInFewColumns_data()
    {
        QTest::addColumn<std::vector<Channel>>("channels");
        QTest::addColumn<Fault>("fault");
        QTest::addColumn<bool>("isGiven");
        for (const bool isGiven : {true, false}) {
            const char *where = isGiven ? ", given mechanism" : "";
            const auto add = [&](const char *columns, const std::vector<Channel> &channels, const char *fault) {
                const std::string name = std::string(columns) + ": " + fault + where;
                QTest::newRow(name.c_str()) << channels << faultNamed(fault) << isGiven;
            };
            add("positions only", {kTheta, kX}, "only the angle in radians");
            add("positions only", {kTheta, kX}, "the textbook's θ_3");
            add("positions only", {kTheta, kX}, "a whole turn less");
            add("positions only", {kTheta, kX}, "angle and position swapped");
            add("angles only", kAngles, "angles in radians");
            add("angles only", kAngles, "instants in ms");
            add("angles only", kAngles, "angular acceleration with the other sign");
            add("lengths only", kLengths, "instants in ms");
            add("lengths only", kLengths, "velocity in m/s");
            add("lengths only", kLengths, "velocity with the other sign");
            add("lengths only", kLengths, "position and acceleration swapped");
            add("lengths only", kLengths, "an acceleration delayed by some rows");
        }
    }

    void findsAFaultInFewColumns()
    {
        QFETCH(const std::vector<Channel>, channels);
        QFETCH(const Fault, fault);
        QFETCH(const bool, isGiven);
        RandomFiles files(6);
        for (int i = 0; i < filesOf(10); ++i) {
            Parameters p = files.mechanism();
            Table table = motionAt(p, files.instants(p));
            const std::vector<Convention> expected = fault.inject(table, p, files);
            table.keepOnly(channels);
            const std::vector<ConventionFinding> found =
                findConventions(writtenAndRead(table), isGiven ? Mechanism(p) : Mechanism());
            QVERIFY2(areFound(found, expected), (std::to_string(i) + ": " + inWords(found)).c_str());
        }
    }

    void findsNothingThatAnotherMechanismExplains_data()
    {
        QTest::addColumn<Fault>("fault");
        for (const Fault &fault : faultsOfTheWhole()) {
            QTest::newRow(fault.name) << fault;
        }
    }

    void findsNothingThatAnotherMechanismExplains()
    {
        QFETCH(const Fault, fault);
        RandomFiles files(7);
        for (int i = 0; i < filesOf(50); ++i) {
            Parameters p = files.mechanism();
            Table table = motionAt(p, files.instants(p));
            fault.inject(table, p, files);
            // The negated angles of a crossed mechanism differ by a whole turn from those of its mirror image.
            const std::vector<double> &angles = table[kTheta];
            const bool turned = std::all_of(angles.begin(), angles.end(), [](double angle) { return angle < -90.0; });
            const std::vector<Convention> expected =
                turned ? std::vector<Convention>{{Kind::WholeTurns, {kTheta}, 360.0}} : std::vector<Convention>();
            const std::vector<ConventionFinding> found =
                findConventions(writtenAndRead(table), Mechanism(files.mechanism()));
            QVERIFY2(areFound(found, expected), (std::to_string(i) + ": " + inWords(found)).c_str());
        }
    }

    void distinguishesAReversedAxisFromAHalfTurnByASimilarMechanism()
    {
        RandomFiles files(8);
        for (int i = 0; i < filesOf(20); ++i) {
            Parameters p = files.mechanism();
            Table table = motionAt(p, files.instants(p));
            const std::vector<Convention> expected = kAxisReversed.inject(table, p, files);
            const ReferenceData data = writtenAndRead(table);
            Parameters similar = p;
            similar.b *= 1.02;
            const std::vector<ConventionFinding> found = findConventions(data, Mechanism(similar));
            QVERIFY2(areFound(found, expected), (std::to_string(i) + ": " + inWords(found)).c_str());

            Parameters reversed = p; // similar to the motion of the file with θ3 shifted by half a turn
            reversed.omega2 *= 0.7;
            const std::vector<ConventionFinding> otherwise = findConventions(data, Mechanism(reversed));
            QVERIFY2(areFound(otherwise, {{Kind::HalfTurn, {kTheta}, p.branch == Branch::Open ? 180.0 : -180.0}}),
                     (std::to_string(i) + ": " + inWords(otherwise)).c_str());
        }
    }

    void acceptsAnglesThatJumpTogether()
    {
        RandomFiles files(9);
        for (int i = 0; i < filesOf(50); ++i) {
            Parameters p = files.mechanism();
            p.branch = Branch::Crossed;
            Table table = motionAt(p, files.instants(p));
            for (double &angle : table[kTheta]) {
                angle = angle > 180.0 ? angle - 360.0 : angle;
            }
            const bool jumps =
                std::any_of(table[kTheta].begin(), table[kTheta].end(), [](double angle) { return angle < 0.0; });
            const double turn = table[kTheta][0] < 0.0 ? 360.0 : 0.0;
            const std::vector<Convention> expected =
                jumps ? std::vector<Convention>{{Kind::WholeTurns, {kTheta}, turn}} : std::vector<Convention>();
            const ReferenceData data = writtenAndRead(table);
            for (const Mechanism &compared : {Mechanism(p), Mechanism()}) {
                const std::vector<ConventionFinding> found = findConventions(data, compared);
                QVERIFY2(areFound(found, expected), (std::to_string(i) + ": " + inWords(found)).c_str());
            }
        }
    }

    void findsNoConventionInTheReferenceReportsFile()
    {
        const ReferenceData data = reportsFile();
        if (data.series.empty()) {
            QSKIP("the reference report's file is not available");
        }
        for (const double b : {60.0, 65.0}) {
            Parameters p;
            p.b = b;
            const std::vector<ConventionFinding> found = findConventions(data, Mechanism(p));
            QVERIFY2(found.empty(), inWords(found).c_str());
        }
        const std::vector<ConventionFinding> found =
            findConventions(applied({Kind::HalfTurn, {kTheta}, 180.0}, data), Mechanism());
        QVERIFY2(areFound(found, {{Kind::HalfTurn, {kTheta}, -180.0}}), inWords(found).c_str());
    }

    void acceptsGapsAndOtherColumns()
    {
        RandomFiles files(11);
        const Parameters p = files.mechanism();
        Table table = motionAt(p, files.instants(p));
        multiply(table, {kTheta}, kPi / 180.0);
        ReferenceData data = writtenAndRead(table);
        for (ReferenceSeries &series : data.series) {
            for (std::size_t row = indexOf(series.channel) % 5; row < series.values.size(); row += 5) {
                series.values[row] = std::numeric_limits<double>::quiet_NaN();
            }
        }
        // Adds a column that is not one of the six channels and is not the motion of this mechanism.
        data.series.push_back({{R2x, Order::Position}, std::vector<double>(data.time.size(), 7.0), {}});
        for (const Mechanism &compared : {Mechanism(p), Mechanism()}) {
            const std::vector<ConventionFinding> found = findConventions(data, compared);
            QVERIFY2(areFound(found, {{Kind::AngleUnit, {kTheta}, 180.0 / kPi}}), inWords(found).c_str());
        }
    }

    void findsThatTheSliderMovesAlongY_data()
    {
        QTest::addColumn<std::vector<Channel>>("kept"); // channels of the motion along x
        QTest::addColumn<double>("angleAdded");         // added to θ3
        QTest::addColumn<bool>("hasX");
        QTest::newRow("the position alone") << std::vector{kX} << 0.0 << false;
        QTest::newRow("its derivatives, too") << kLengths << 0.0 << true;
        QTest::newRow("an angle from the slider's axis") << std::vector{kX, kTheta, kThetaDot} << 0.0 << false;
        QTest::newRow("an angle from the file's x") << std::vector{kX, kXDot, kTheta} << 90.0 << true;
        QTest::newRow("an angle from elsewhere") << std::vector{kX, kTheta} << 40.0 << false;
    }

    void findsThatTheSliderMovesAlongY()
    {
        QFETCH(const std::vector<Channel>, kept);
        QFETCH(const double, angleAdded);
        QFETCH(const bool, hasX);
        const bool isTurned = angleAdded == 90.0;
        RandomFiles files(21);
        for (int i = 0; i < filesOf(10); ++i) {
            const Parameters p = files.mechanism();
            Table table = motionAt(p, files.instants(p));
            table.keepOnly(kept);
            std::vector<Convention> expected{{Kind::Axis, {}, 1.0}};
            for (auto &[channel, values] : table.columns) {
                if (channel.coordinate == R4x) {
                    channel.coordinate = R4y;
                    expected[0].channels.push_back(channel);
                } else if (channel == kTheta && angleAdded != 0.0) {
                    std::ranges::for_each(values, [&](double &value) { value += angleAdded; });
                    if (isTurned) {
                        expected[0].channels.push_back(kTheta); // the whole file is turned
                    }
                }
            }
            if (hasX) {
                table.columns.push_back({kX, std::vector<double>(table.time.size(), -p.c)});
                expected[0].channels.push_back(kX);
            }
            const ReferenceData data = writtenAndRead(table);
            const std::vector<ConventionFinding> found = findConventions(data, Mechanism(p));
            QVERIFY2(!found.empty() && isSame(found[0].convention, expected[0]), inWords(found).c_str());
            QVERIFY2(found[0].before > 1.0 && found[0].after < 0.1, inWords(found).c_str());
            const bool hasZero = angleAdded != 0.0 && !isTurned;
            QCOMPARE(found.size(), hasZero ? std::size_t{2} : std::size_t{1});
            if (hasZero) {
                QCOMPARE(found[1].convention.kind, Kind::ZeroPoint);
                QVERIFY2(std::abs(found[1].convention.amount + angleAdded) < 1e-3, inWords(found).c_str());
            }
            // After these conventions are applied, the file agrees with the mechanism. They are also found if another
            // mechanism is given.
            ReferenceData read = data;
            for (const ConventionFinding &finding : found) {
                read = applied(finding.convention, std::move(read));
            }
            const ExactComparison outcome = compareExactly(Mechanism(p), read);
            for (const ChannelComparison &channel : outcome.channels) {
                QVERIFY(channel.verdict != Verdict::Differs);
            }
            const std::vector<ConventionFinding> beside = findConventions(data, Mechanism());
            QVERIFY2(!beside.empty() && isSame(beside[0].convention, expected[0]), inWords(beside).c_str());
        }
    }

    void findsNoAxisIfXMoves()
    {
        RandomFiles files(22);
        for (int i = 0; i < filesOf(10); ++i) {
            const Parameters p = files.mechanism();
            Table table = motionAt(p, files.instants(p));
            // y is constant except for the error of a solver. Every second file has no x.
            std::vector<double> nearly(table.time.size());
            std::ranges::generate(nearly, [&] { return p.c + files.uniform(-1e-9, 1e-9); });
            if (i % 2 == 1) {
                table.keepOnly(kAngles);
            }
            table.columns.push_back({{R4y, Order::Position}, nearly});
            const std::vector<ConventionFinding> found = findConventions(writtenAndRead(table), Mechanism(p));
            QVERIFY2(found.empty(), inWords(found).c_str());
        }
        // A motion along y need not be that of a slider.
        Table table = motionAt(Parameters(), files.instants(Parameters()));
        table.keepOnly({kX});
        table.columns[0].first.coordinate = R4y;
        std::ranges::generate(table.columns[0].second, [&] { return files.uniform(-50.0, 50.0); });
        QVERIFY(findConventions(writtenAndRead(table), Mechanism()).empty());
    }

    void reportsThatLengthsMayBeMetres_data()
    {
        QTest::addColumn<double>("scale");
        QTest::addColumn<QByteArray>("heading");
        QTest::addColumn<bool>("may");
        QTest::newRow("metres, unsaid") << 1e-3 << QByteArray("R4_x") << true;
        QTest::newRow("so small indeed") << 1e-3 << QByteArray("R4_x [mm]") << false;
        QTest::newRow("metres") << 1e-3 << QByteArray("R4_x [m]") << false;
        QTest::newRow("millimetres, unsaid") << 1.0 << QByteArray("R4_x") << false;
    }

    void reportsThatLengthsMayBeMetres()
    {
        QFETCH(const double, scale);
        QFETCH(const QByteArray, heading);
        QFETCH(const bool, may);
        Parameters p;
        p.a = 40.0;
        p.b = 110.0;
        RandomFiles files(23);
        Table table = motionAt(p, files.instants(p));
        QByteArray text = "time," + heading + '\n';
        for (std::size_t i = 0; i < table.time.size(); ++i) {
            text += QByteArray::number(table.time[i], 'g', 17) + ',' +
                    QByteArray::number(scale * table[kX][i], 'g', 7) + '\n';
        }
        const auto outcome = readReferenceData({text.constData(), static_cast<std::size_t>(text.size())});
        const Diagnosis diagnosis = diagnose(std::get<ReferenceData>(outcome), Mechanism());
        QVERIFY(diagnosis.identification.hasMechanism());
        QCOMPARE(diagnosis.mayBeInMetres, may);
    }

    void usesOnlySomeOfAMillionRows_data()
    {
        QTest::addColumn<double>("turns");
        QTest::newRow("one turn") << 1.0;
        QTest::newRow("ten thousand turns") << 1e4;
    }

    void usesOnlySomeOfAMillionRows()
    {
        QFETCH(const double, turns);
        Parameters p;
        std::vector<double> instants(1000000);
        for (std::size_t i = 0; i < instants.size(); ++i) {
            instants[i] = turns * static_cast<double>(i) * 1e-6;
        }
        Table table = motionAt(p, instants);
        multiply(table, kAngles, kPi / 180.0);
        ReferenceData data;
        data.time = table.time;
        for (const auto &[channel, values] : table.columns) {
            data.series.push_back({channel, values, {Rounding::Rule::SignificantDigits, 17}});
        }
        for (const double b : {p.b, 60.0}) {
            Parameters compared = p;
            compared.b = b;
            largestAllocation = 0;
            const std::vector<ConventionFinding> found = findConventions(data, Mechanism(compared));
            const std::size_t largest = largestAllocation;
            QVERIFY2(areFound(found, {{Kind::AngleUnit, kAngles, 180.0 / kPi}}), inWords(found).c_str());
            // Applying a convention copies the file column by column, so no allocation exceeds one column.
            QVERIFY2(largest <= sizeof(double) * instants.size(), std::to_string(largest).c_str());
        }
    }

    void stopsWhenAsked()
    {
        RandomFiles files(13);
        const Parameters p = files.mechanism();
        Table table = motionAt(p, files.instants(p));
        multiply(table, kAngles, kPi / 180.0);
        std::stop_source stop;
        stop.request_stop();
        QVERIFY(findConventions(writtenAndRead(table), Mechanism(), stop.get_token()).empty());
    }

    void findsALateStartAsARoundNumber()
    {
        ReferenceData data = printedData(Parameters());
        for (double &t : data.time) {
            t += 0.137;
        }
        const std::vector<ConventionFinding> findings = findConventions(data, Mechanism());
        QCOMPARE(findings.size(), std::size_t(1));
        QVERIFY(findings[0].convention == (Convention{Kind::TimeShift, {}, -0.137}));
    }

    void keepsTheRoundingStepAfterAHalfTurn()
    {
        // The last digit of 204.624 is 0.001, and it remains so for 24.624, half a turn before.
        ReferenceData data;
        data.time = {0.0, 1.0, 2.0};
        data.series.push_back({kTheta, {204.624, 190.5, 180.25}, {Rounding::Rule::SignificantDigits, 6}});
        const ReferenceData turned = applied({Kind::HalfTurn, {kTheta}, -180.0}, data);
        QVERIFY(std::abs(turned.series[0].values[2] - 0.25) < 1e-9);
        for (const double value : {24.624, 0.25, 180.25}) {
            QVERIFY(std::abs(turned.series[0].rounding.stepAt(value) - 1e-3) < 1e-12);
        }
    }

    void convertsTheRoundingStepToo()
    {
        ReferenceData data;
        data.time = {0.0, 1.0};
        data.series.push_back({kXDot, {1.25, -2.5}, {Rounding::Rule::Decimals, 2}});
        const ReferenceData read = applied({Kind::LengthUnit, {kXDot}, 1e3}, data);
        QCOMPARE(read.series[0].values[1], -2500.0);
        QVERIFY(std::abs(read.series[0].rounding.stepAt(1.0) - 10.0) < 1e-9);
    }
};

const Suite suite("tst_conventions", runWithoutApplication<TestConventions>);
#include "tst_conventions.moc"
