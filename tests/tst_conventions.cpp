// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/conventions.h"

#include "random_mechanisms.h"

#include <QFile>
#include <QTest>

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

using namespace slidercrank;
using Kind = Convention::Kind;

namespace
{

constexpr double kPi = std::numbers::pi;
constexpr Channel kTheta{Theta3, Order::Position};
constexpr Channel kThetaDot{Theta3, Order::Velocity};
constexpr Channel kThetaDDot{Theta3, Order::Acceleration};
constexpr Channel kX{R4x, Order::Position};
constexpr Channel kXDot{R4x, Order::Velocity};
constexpr Channel kXDDot{R4x, Order::Acceleration};
const std::vector<Channel> kAngles{kTheta, kThetaDot, kThetaDDot};
const std::vector<Channel> kLengths{kX, kXDot, kXDDot};

/// A file before it is written: a column of the time and one of each channel.
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

/// The textbook's motion (Norton, "Design of Machinery", eq. 4.16, 6.22, 7.15, with θ³ = θ_3 - 180°), in mm and °.
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

/// The file as it is read back from six significant digits.
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

/// Mechanisms whose crank turns round, and their instants.
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

    /// 80 to 500 instants over 0.6 to 3 turns.
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

/// What is done to a file, and what is to be found. `parameters` are those that the file is then compared with.
struct Fault {
    const char *name;
    std::function<std::vector<Convention>(Table &, Parameters &, RandomFiles &)> inject;
};

const std::vector<Fault> &faults()
{
    static const std::vector<Fault> all{
        {"angles in radians",
         [](Table &table, Parameters &, RandomFiles &) {
             multiply(table, kAngles, kPi / 180.0);
             return std::vector<Convention>{{Kind::AngleUnit, kAngles, 180.0 / kPi}};
         }},
        {"only the angle in radians",
         [](Table &table, Parameters &, RandomFiles &) {
             multiply(table, {kTheta}, kPi / 180.0);
             return std::vector<Convention>{{Kind::AngleUnit, {kTheta}, 180.0 / kPi}};
         }},
        {"the angle's derivatives in radians",
         [](Table &table, Parameters &, RandomFiles &) {
             multiply(table, {kThetaDot, kThetaDDot}, kPi / 180.0);
             return std::vector<Convention>{{Kind::AngleUnit, {kThetaDot, kThetaDDot}, 180.0 / kPi}};
         }},
        {"degrees under a heading of radians",
         [](Table &table, Parameters &, RandomFiles &) {
             multiply(table, kAngles, 180.0 / kPi);
             return std::vector<Convention>{{Kind::AngleUnit, kAngles, kPi / 180.0}};
         }},
        {"velocity in m/s",
         [](Table &table, Parameters &, RandomFiles &) {
             multiply(table, {kXDot}, 1e-3);
             return std::vector<Convention>{{Kind::LengthUnit, {kXDot}, 1e3}};
         }},
        {"position in cm",
         [](Table &table, Parameters &, RandomFiles &) {
             multiply(table, {kX}, 0.1);
             return std::vector<Convention>{{Kind::LengthUnit, {kX}, 10.0}};
         }},
        {"acceleration in in/s²",
         [](Table &table, Parameters &, RandomFiles &) {
             multiply(table, {kXDDot}, 1.0 / 25.4);
             return std::vector<Convention>{{Kind::LengthUnit, {kXDDot}, 25.4}};
         }},
        {"instants in ms",
         [](Table &table, Parameters &, RandomFiles &) {
             for (double &t : table.time) {
                 t *= 1e3;
             }
             return std::vector<Convention>{{Kind::TimeUnit, {}, 1e-3}};
         }},
        {"instants in s under a heading of ms",
         [](Table &table, Parameters &, RandomFiles &) {
             for (double &t : table.time) {
                 t *= 1e-3;
             }
             return std::vector<Convention>{{Kind::TimeUnit, {}, 1e3}};
         }},
        {"velocity with the other sign",
         [](Table &table, Parameters &, RandomFiles &) {
             multiply(table, {kXDot}, -1.0);
             return std::vector<Convention>{{Kind::Sign, {kXDot}, -1.0}};
         }},
        {"angular acceleration with the other sign",
         [](Table &table, Parameters &, RandomFiles &) {
             multiply(table, {kThetaDDot}, -1.0);
             return std::vector<Convention>{{Kind::Sign, {kThetaDDot}, -1.0}};
         }},
        {"the textbook's θ_3",
         [](Table &table, Parameters &, RandomFiles &) {
             for (double &value : table[kTheta]) {
                 value += 180.0;
             }
             return std::vector<Convention>{{Kind::HalfTurn, {kTheta}, -180.0}};
         }},
        {"a whole turn less",
         [](Table &table, Parameters &, RandomFiles &) {
             for (double &value : table[kTheta]) {
                 value -= 360.0;
             }
             return std::vector<Convention>{{Kind::WholeTurns, {kTheta}, 360.0}};
         }},
        {"position and acceleration swapped",
         [](Table &table, Parameters &, RandomFiles &) {
             std::swap(table[kX], table[kXDDot]);
             return std::vector<Convention>{{Kind::SwappedColumns, {kX, kXDDot}, 1.0}};
         }},
        {"velocity and acceleration swapped",
         [](Table &table, Parameters &, RandomFiles &) {
             std::swap(table[kXDot], table[kXDDot]);
             return std::vector<Convention>{{Kind::SwappedColumns, {kXDot, kXDDot}, 1.0}};
         }},
        {"angle and position swapped",
         [](Table &table, Parameters &, RandomFiles &) {
             std::swap(table[kTheta], table[kX]);
             return std::vector<Convention>{{Kind::SwappedColumns, {kTheta, kX}, 1.0}};
         }},
        {"the two velocities swapped",
         [](Table &table, Parameters &, RandomFiles &) {
             std::swap(table[kThetaDot], table[kXDot]);
             return std::vector<Convention>{{Kind::SwappedColumns, {kThetaDot, kXDot}, 1.0}};
         }},
        {"an acceleration delayed by some rows",
         [](Table &table, Parameters &, RandomFiles &) {
             std::vector<double> &values = table[kXDDot];
             std::rotate(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 20),
                         values.end());
             return std::vector<Convention>{{Kind::NotDerivative, {kXDDot}, 1.0}};
         }},
        {"an angular velocity that is another gear's",
         [](Table &table, Parameters &, RandomFiles &) {
             multiply(table, {kThetaDot}, 1.7);
             return std::vector<Convention>{{Kind::NotDerivative, {kThetaDot}, 1.0}};
         }},
        {"a velocity of noise",
         [](Table &table, Parameters &, RandomFiles &random) {
             for (double &value : table[kXDot]) {
                 value *= random.uniform(-1.0, 1.0);
             }
             return std::vector<Convention>{{Kind::NotDerivative, {kXDot}, 1.0}};
         }},
    };
    return all;
}

/// Faults that another mechanism explains as well.
const std::vector<Fault> &faultsOfTheWhole()
{
    static const std::vector<Fault> all{
        {"all lengths in metres",
         [](Table &table, Parameters &, RandomFiles &) {
             multiply(table, kLengths, 1e-3);
             return std::vector<Convention>{{Kind::LengthUnit, kLengths, 1e3}};
         }},
        {"all lengths in inches",
         [](Table &table, Parameters &, RandomFiles &) {
             multiply(table, kLengths, 1.0 / 25.4);
             return std::vector<Convention>{{Kind::LengthUnit, kLengths, 25.4}};
         }},
        {"everything per millisecond",
         [](Table &table, Parameters &, RandomFiles &) {
             for (double &t : table.time) {
                 t *= 1e3;
             }
             multiply(table, {kXDot, kThetaDot}, 1e-3);
             multiply(table, {kXDDot, kThetaDDot}, 1e-6);
             return std::vector<Convention>{{Kind::TimeUnit, {kXDot, kXDDot, kThetaDot, kThetaDDot}, 1e-3}};
         }},
        {"the other sense of rotation",
         [](Table &table, Parameters &, RandomFiles &) {
             multiply(table, kAngles, -1.0);
             return std::vector<Convention>{{Kind::Sign, kAngles, -1.0}};
         }},
        {"the other assembly",
         [](Table &, Parameters &p, RandomFiles &) {
             p.branch = p.branch == Branch::Open ? Branch::Crossed : Branch::Open;
             return std::vector<Convention>{{Kind::Branch, {}, 1.0}};
         }},
        {"a late start",
         [](Table &table, Parameters &p, RandomFiles &random) {
             const double late = random.uniform(0.02, 0.45) * 2.0 * kPi / std::abs(p.omega2);
             for (double &t : table.time) {
                 t += late;
             }
             return std::vector<Convention>{{Kind::TimeShift, {}, -late}};
         }},
    };
    return all;
}

const Fault kAxisReversed{"the x axis reversed", [](Table &table, Parameters &, RandomFiles &) {
                              multiply(table, kLengths, -1.0);
                              return std::vector<Convention>{{Kind::Sign, kLengths, -1.0}};
                          }};

const char *nameOfKind(Kind kind)
{
    switch (kind) {
    case Kind::AngleUnit: return "angle unit";
    case Kind::LengthUnit: return "length unit";
    case Kind::TimeUnit: return "time unit";
    case Kind::Sign: return "sign";
    case Kind::HalfTurn: return "half turn";
    case Kind::WholeTurns: return "whole turns";
    case Kind::SwappedColumns: return "swapped";
    case Kind::Branch: return "branch";
    case Kind::TimeShift: return "time shift";
    case Kind::NotDerivative: return "not a derivative";
    }
    return "";
}

std::string inWords(const std::vector<ConventionFinding> &findings)
{
    std::string words;
    for (const ConventionFinding &finding : findings) {
        words += nameOfKind(finding.convention.kind);
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

/// Whether just these were found, in any order, each of which matters and leaves next to nothing.
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

} // namespace

class TestConventions : public QObject
{
    Q_OBJECT

private slots:
    void findsAFaultAgainstTheMechanismAtHand_data()
    {
        QTest::addColumn<Fault>("fault");
        for (const auto &list : {faults(), faultsOfTheWhole(), {kAxisReversed}}) {
            for (const Fault &fault : list) {
                QTest::newRow(fault.name) << fault;
            }
        }
    }

    void findsAFaultAgainstTheMechanismAtHand()
    {
        QFETCH(const Fault, fault);
        RandomFiles files(1);
        for (int i = 0; i < 50; ++i) {
            Parameters p = files.mechanism();
            Table table = motionAt(p, files.instants(p));
            const std::vector<Convention> expected = fault.inject(table, p, files);
            const std::vector<ConventionFinding> found = findConventions(writtenAndRead(table), Mechanism(p));
            QVERIFY2(areFound(found, expected), (std::to_string(i) + ": " + inWords(found)).c_str());
        }
    }

    void findsAFaultWhateverTheMechanism_data()
    {
        QTest::addColumn<Fault>("fault");
        for (const Fault &fault : faults()) {
            QTest::newRow(fault.name) << fault;
        }
    }

    void findsAFaultWhateverTheMechanism()
    {
        QFETCH(const Fault, fault);
        RandomFiles files(1);
        for (int i = 0; i < 50; ++i) {
            Parameters p = files.mechanism();
            Table table = motionAt(p, files.instants(p));
            const std::vector<Convention> expected = fault.inject(table, p, files);
            const std::vector<ConventionFinding> found = findConventions(writtenAndRead(table), Mechanism());
            QVERIFY2(areFound(found, expected), (std::to_string(i) + ": " + inWords(found)).c_str());
        }
    }

    void findsNothingInCleanFiles()
    {
        RandomFiles files(2);
        for (int i = 0; i < 200; ++i) {
            const Parameters p = files.mechanism();
            const ReferenceData data = writtenAndRead(motionAt(p, files.instants(p)));
            for (const Parameters &compared : {p, files.mechanism(), Parameters()}) {
                const std::vector<ConventionFinding> found = findConventions(data, Mechanism(compared));
                QVERIFY2(found.empty(), (std::to_string(i) + ": " + inWords(found)).c_str());
            }
        }
    }
};

QTEST_APPLESS_MAIN(TestConventions)
#include "tst_conventions.moc"
