// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/identification.h"

#include "core/comparison/comparison.h"
#include "core/import/crank_angles.h"

#include "tests/support/channels.h"
#include "tests/support/long_tests.h"
#include "tests/support/printed_motion.h"
#include "tests/support/random_mechanisms.h"
#include "tests/support/suite.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

using namespace slidercrank;

namespace tst_conventions
{

using Kind = Convention::Kind;

constexpr Channel kSliderY{R4y, Order::Position}; // constant in every motion

/// Returns the number of random files to test: `all` in long tests, otherwise a twentieth.
int fileCount(int all)
{
    return caseCount((all + 19) / 20, all);
}

/// Returns the motion of a mechanism over 0.6 to 3 turns in 80 to 500 rows.
ReferenceData motionOf(const Parameters &p, RandomMechanisms &random,
                       const std::vector<Channel> &channels = kSixChannels)
{
    Printing printing;
    printing.rows = static_cast<int>(random.uniform(80.0, 500.0));
    printing.to = random.uniform(0.6, 3.0) * 360.0 / kDegreesPerRadian / std::abs(p.omega2);
    printing.channels = channels;
    printing.timeFormat = "%.17g";
    return printedData(p, printing);
}

/// A fault of a file and the convention that must be found.
struct Fault {
    const char *name;
    Convention convention; ///< the amount of a TimeShift is chosen at random
};

const std::vector<Fault> kFaults{
    {"angles in radians", {Kind::AngleUnit, kCouplerChannels, kDegreesPerRadian}},
    {"only the angle in radians", {Kind::AngleUnit, {kTheta3}, kDegreesPerRadian}},
    {"the angle's derivatives in radians", {Kind::AngleUnit, {kTheta3Speed, kTheta3Acceleration}, kDegreesPerRadian}},
    {"degrees under a heading of radians", {Kind::AngleUnit, kCouplerChannels, 1.0 / kDegreesPerRadian}},
    {"velocity in m/s", {Kind::LengthUnit, {kSliderSpeed}, 1e3}},
    {"position in cm", {Kind::LengthUnit, {kSlider}, 10.0}},
    {"acceleration in in/s²", {Kind::LengthUnit, {kSliderAcceleration}, 25.4}},
    {"time stamps in ms", {Kind::TimeUnit, {}, 1e-3}},
    {"time stamps in s under a heading of ms", {Kind::TimeUnit, {}, 1e3}},
    {"velocity with the other sign", {Kind::Sign, {kSliderSpeed}, -1.0}},
    {"angular acceleration with the other sign", {Kind::Sign, {kTheta3Acceleration}, -1.0}},
    {"the x axis reversed", {Kind::Sign, kSliderChannels, -1.0}},
    {"the textbook's θ_3", {Kind::HalfTurn, {kTheta3}, -180.0}},
    {"a whole turn less", {Kind::WholeTurns, {kTheta3}, 360.0}},
    {"position and acceleration swapped", {Kind::SwappedColumns, {kSlider, kSliderAcceleration}}},
    {"velocity and acceleration swapped", {Kind::SwappedColumns, {kSliderSpeed, kSliderAcceleration}}},
    {"angle and position swapped", {Kind::SwappedColumns, kAngleAndPosition}},
    {"the two velocities swapped", {Kind::SwappedColumns, {kTheta3Speed, kSliderSpeed}}},
};

/// Faults that a different mechanism explains equally well.
const std::vector<Fault> kFaultsOfWholeFile{
    {"all lengths in metres", {Kind::LengthUnit, kSliderChannels, 1e3}},
    {"all lengths in inches", {Kind::LengthUnit, kSliderChannels, 25.4}},
    {"everything per millisecond",
     {Kind::TimeUnit, {kSliderSpeed, kSliderAcceleration, kTheta3Speed, kTheta3Acceleration}, 1e-3}},
    {"the other sense of rotation", {Kind::Sign, kCouplerChannels, -1.0}},
    {"the other assembly", {Kind::OtherAssembly, {}}},
    {"a late start", {Kind::TimeShift, {}}},
};

const Fault &faultNamed(const std::string &name)
{
    const auto fault = std::ranges::find(kFaults, name, &Fault::name);
    return fault != kFaults.end() ? *fault : *std::ranges::find(kFaultsOfWholeFile, name, &Fault::name);
}

/// Applies a fault to the data or, if it is the other assembly, to the given mechanism. Returns the convention that
/// must be found.
Convention inject(const Fault &fault, ReferenceData &data, Parameters &given, RandomMechanisms &random)
{
    Convention expected = fault.convention;
    if (expected.kind == Kind::TimeShift) {
        expected.amount = -random.uniform(0.02, 0.45) * 360.0 / kDegreesPerRadian / std::abs(given.omega2);
    }
    if (expected.kind == Kind::OtherAssembly) {
        given.branch = oppositeBranch(given.branch);
    }
    const bool isShift =
        expected.kind == Kind::HalfTurn || expected.kind == Kind::WholeTurns || expected.kind == Kind::TimeShift;
    Convention inverse = expected;
    inverse.amount = isShift ? -expected.amount : 1.0 / expected.amount;
    data = applied(inverse, std::move(data));
    return expected;
}

std::vector<ConventionFinding> findConventions(const ReferenceData &data, const Parameters &given)
{
    return identify(data, Mechanism(given)).conventions;
}

QByteArray described(const std::vector<ConventionFinding> &findings)
{
    QByteArray text;
    for (const ConventionFinding &finding : findings) {
        const Convention &convention = finding.convention;
        text += "kind " + QByteArray::number(static_cast<int>(convention.kind));
        for (const Channel channel : convention.channels) {
            text += ' ' + std::string(nameOf(channel));
        }
        text += " by " + QByteArray::number(convention.amount) + ": " + QByteArray::number(finding.before) + " % to " +
                QByteArray::number(finding.after) + " %; ";
    }
    return text.isEmpty() ? "nothing" : text;
}

bool isSame(const Convention &found, const Convention &expected)
{
    const double slack = expected.kind == Kind::TimeShift ? 1e-4 : 1e-9;
    return found.kind == expected.kind && std::ranges::is_permutation(found.channels, expected.channels) &&
           std::abs(found.amount - expected.amount) <= slack * std::abs(expected.amount);
}

/// Returns whether exactly these conventions were found, in any order, and each reduces the error to nearly zero.
bool areFound(const std::vector<ConventionFinding> &findings, const std::vector<Convention> &expected)
{
    return findings.size() == expected.size() && std::ranges::all_of(findings, [&](const ConventionFinding &finding) {
               return finding.before > 1.0 && finding.after < 0.1 &&
                      std::ranges::any_of(expected,
                                          [&](const Convention &one) { return isSame(finding.convention, one); });
           });
}

class TestConventions : public QObject
{
    Q_OBJECT

private:
    /// Checks that exactly these faults are found in random files.
    static void findFaults(const std::vector<std::string> &names, const std::vector<Channel> &channels, bool isGiven,
                           int files)
    {
        RandomMechanisms random(names.size() + channels.size());
        for (int i = 0; i < fileCount(files); ++i) {
            Parameters p = random.ordinary();
            if (channels != kSixChannels) {
                p.branch = Branch::Open; // with few columns, the other assembly may explain a sign equally well
            }
            ReferenceData data = motionOf(p, random, channels);
            std::vector<Convention> expected;
            QByteArray title = QByteArray::number(i) + ' ' + namesOf(channels).c_str() + (isGiven ? " given" : "");
            for (const std::string &name : names) {
                expected.push_back(inject(faultNamed(name), data, p, random));
                title += " " + name;
            }
            const auto found = findConventions(data, isGiven ? p : Parameters());
            QVERIFY2(areFound(found, expected), title + ": " + described(found));
        }
    }

private slots:
    void findsAFaultAgainstTheGivenMechanism()
    {
        for (const auto &list : {kFaults, kFaultsOfWholeFile}) {
            for (const Fault &fault : list) {
                findFaults({fault.name}, kSixChannels, true, 50);
            }
        }
    }

    void findsTwoFaultsAndFaultsInFewColumns()
    {
        struct Row {
            std::vector<std::string> faults;
            std::vector<Channel> channels = kSixChannels; ///< θ3, x, and their derivatives
            bool needsGiven = false;                      ///< a different mechanism explains the file, too
        };
        for (const Row &row : {Row{{"angles in radians", "velocity in m/s"}},
                               {{"the textbook's θ_3", "angles in radians"}},
                               {{"velocity and acceleration swapped", "angles in radians"}},
                               {{"the textbook's θ_3", "position in cm"}},
                               {{"the angle's derivatives in radians", "velocity with the other sign"}},
                               {{"a whole turn less", "velocity with the other sign"}},
                               {{"angles in radians", "all lengths in metres"}, kSixChannels, true},
                               {{"a late start", "all lengths in inches"}, kSixChannels, true},
                               {{"a late start", "the other assembly"}, kSixChannels, true},
                               {{"the textbook's θ_3", "a late start"}, kSixChannels, true},
                               {{"the other sense of rotation", "a late start"}, kSixChannels, true},
                               {{"velocity and acceleration swapped", "a late start"}, kSixChannels, true},
                               {{"only the angle in radians"}, kAngleAndPosition},
                               {{"the textbook's θ_3"}, kAngleAndPosition},
                               {{"a whole turn less"}, kAngleAndPosition},
                               {{"angle and position swapped"}, kAngleAndPosition},
                               {{"angles in radians"}, kCouplerChannels},
                               {{"time stamps in ms"}, kCouplerChannels},
                               {{"angular acceleration with the other sign"}, kCouplerChannels},
                               {{"time stamps in ms"}, kSliderChannels},
                               {{"velocity in m/s"}, kSliderChannels},
                               {{"velocity with the other sign"}, kSliderChannels},
                               {{"position and acceleration swapped"}, kSliderChannels}}) {
            findFaults(row.faults, row.channels, true, 10);
            if (!row.needsGiven) {
                findFaults(row.faults, row.channels, false, 10);
            }
        }
    }

    void findsNothingInCleanFiles()
    {
        RandomMechanisms random(2);
        for (int i = 0; i < fileCount(200); ++i) {
            const Parameters p = random.ordinary();
            const ReferenceData data = motionOf(p, random);
            ReferenceData withCrank = data; // with crank angles that begin anywhere in a turn
            ReferenceSeries crank{kCrankAngle, {}, {Rounding::Rule::SignificantDigits, 15}};
            for (const double t : data.time) {
                crank.values.push_back((p.theta20 + p.omega2 * t) * kDegreesPerRadian);
            }
            withCrank.series.push_back(std::move(crank));
            // A constant column is not the motion of any mechanism.
            withCrank.series.push_back({{R2x, Order::Position}, std::vector<double>(data.time.size(), 7.0), {}});
            for (const Parameters &given : {p, random.ordinary(), Parameters()}) {
                for (const ReferenceData &file : {data, withCrank}) {
                    const auto found = findConventions(file, given);
                    QVERIFY2(found.empty(), QByteArray::number(i) + ": " + described(found));
                }
            }
        }
    }

    void findsNothingThatAnotherMechanismExplains()
    {
        for (const Fault &fault : kFaultsOfWholeFile) {
            RandomMechanisms random(7);
            for (int i = 0; i < fileCount(50); ++i) {
                Parameters p = random.ordinary();
                ReferenceData data = motionOf(p, random);
                inject(fault, data, p, random);
                // The negated angles of a crossed mechanism differ by a whole turn from those of its mirror image.
                const bool isTurned = rangeOf(valuesOf(data, kTheta3)).high < -90.0;
                const auto found = findConventions(data, random.ordinary());
                const std::vector<Convention> wholeTurn{{Kind::WholeTurns, {kTheta3}, 360.0}};
                QVERIFY2(isTurned ? areFound(found, wholeTurn) : found.empty(),
                         QByteArray(fault.name) + ' ' + QByteArray::number(i) + ": " + described(found));
            }
        }
    }

    void distinguishesAReversedAxisFromAHalfTurnByTheGivenAssembly()
    {
        RandomMechanisms random(8);
        for (int i = 0; i < fileCount(20); ++i) {
            Parameters p = random.ordinary();
            ReferenceData data = motionOf(p, random);
            const Convention expected = inject(faultNamed("the x axis reversed"), data, p, random);
            Parameters similar = p;
            similar.b *= 1.02;
            const auto found = findConventions(data, similar);
            QVERIFY2(areFound(found, {expected}), QByteArray::number(i) + ": " + described(found));

            Parameters other = similar; // the mechanism of the file, if θ3 is shifted by half a turn
            other.c = -p.c;
            other.theta20 = p.theta20 + std::numbers::pi;
            other.branch = oppositeBranch(p.branch);
            const auto otherwise = findConventions(data, other);
            QVERIFY2(areFound(otherwise, {{Kind::HalfTurn, {kTheta3}, p.branch == Branch::Open ? 180.0 : -180.0}}),
                     QByteArray::number(i) + ": " + described(otherwise));
        }
    }

    void acceptsAnglesThatJumpTogether()
    {
        RandomMechanisms random(9);
        for (int i = 0; i < fileCount(50); ++i) {
            Parameters p = random.ordinary();
            p.branch = Branch::Crossed;
            ReferenceData data = motionOf(p, random);
            std::vector<double> &angles = valuesOf(data, kTheta3);
            std::ranges::for_each(angles, [](double &angle) { angle -= angle > 180.0 ? 360.0 : 0.0; });
            std::vector<Convention> expected;
            if (rangeOf(angles).low < 0.0) {
                expected.push_back({Kind::WholeTurns, {kTheta3}, angles[0] < 0.0 ? 360.0 : 0.0});
            }
            for (const Parameters &given : {p, Parameters()}) {
                const auto found = findConventions(data, given);
                QVERIFY2(areFound(found, expected), QByteArray::number(i) + ": " + described(found));
            }
        }
    }

    void findsThatTheSliderMovesAlongY()
    {
        struct Row {
            const char *name;
            std::vector<Channel> channels; ///< of the motion along x
            double angleAdded;             ///< to θ3, °
            bool hasX;
        };
        for (const Row &row : {Row{"the position alone", {kSlider}, 0.0, false},
                               {"its derivatives, too", kSliderChannels, 0.0, true},
                               {"an angle from the slider's axis", {kTheta3, kSlider, kTheta3Speed}, 0.0, false},
                               {"an angle from the file's x", {kTheta3, kSlider, kSliderSpeed}, 90.0, true},
                               {"an angle from elsewhere", kAngleAndPosition, 40.0, false}}) {
            RandomMechanisms random(21);
            for (int i = 0; i < fileCount(10); ++i) {
                const Parameters p = random.ordinary();
                ReferenceData data = motionOf(p, random, row.channels);
                Convention axis{Kind::Axis, {}, 1.0};
                for (ReferenceSeries &series : data.series) {
                    if (series.channel.coordinate == R4x) {
                        series.channel.coordinate = R4y;
                        axis.channels.push_back(series.channel);
                    } else if (series.channel == kTheta3) {
                        std::ranges::for_each(series.values, [&](double &value) { value += row.angleAdded; });
                        if (row.angleAdded == 90.0) { // the whole file is turned
                            axis.channels.push_back(kTheta3);
                        }
                    }
                }
                if (row.hasX) {
                    data.series.push_back({kSlider, std::vector<double>(data.time.size(), -p.c), {}});
                    axis.channels.push_back(kSlider);
                }
                const auto found = findConventions(data, p);
                const QByteArray title = QByteArray(row.name) + ": " + described(found);
                const bool hasOrigin = row.angleAdded == 40.0;
                QVERIFY2(found.size() == (hasOrigin ? 2U : 1U) && isSame(found[0].convention, axis), title);
                QVERIFY2(found[0].before > 1.0 && found[0].after < 0.1, title);
                QVERIFY2(!hasOrigin || (found[1].convention.kind == Kind::ZeroPoint &&
                                        std::abs(found[1].convention.amount + row.angleAdded) < 1e-3),
                         title);
                // After these conventions are applied, the file agrees with the mechanism. They are also found if
                // a different mechanism is given.
                ReferenceData read = data;
                for (const ConventionFinding &finding : found) {
                    read = applied(finding.convention, std::move(read));
                }
                QVERIFY(std::ranges::count(compareExactly(Mechanism(p), read).channels, Verdict::Differs,
                                           &ChannelComparison::verdict) == 0);
                const auto beside = findConventions(data, Parameters());
                QVERIFY2(!beside.empty() && isSame(beside[0].convention, axis), described(beside));
            }
        }
    }

    void findsNoAxisIfXMoves()
    {
        RandomMechanisms random(22);
        for (int i = 0; i < fileCount(10); ++i) {
            const Parameters p = random.ordinary();
            // y is constant except for the error of a solver. Every second file has no x.
            ReferenceData data = motionOf(p, random, i % 2 == 0 ? kSixChannels : kCouplerChannels);
            ReferenceSeries &y = data.series.emplace_back(ReferenceSeries{{R4y, Order::Position}, {}, {}});
            y.values.resize(data.time.size());
            std::ranges::generate(y.values, [&] { return p.c + random.uniform(-1e-9, 1e-9); });
            const auto found = findConventions(data, p);
            QVERIFY2(found.empty(), described(found));
        }
        // A motion along y need not be that of a slider.
        ReferenceData data = motionOf(Parameters(), random, {kSlider});
        data.series[0].channel.coordinate = R4y;
        std::ranges::generate(data.series[0].values, [&] { return random.uniform(-50.0, 50.0); });
        QVERIFY(findConventions(data, Parameters()).empty());
    }

    /// In pictures of a camera, y points downwards, so that all y and all angles have the opposite sign.
    void findsAYAxisThatPointsDownwards()
    {
        const Channel coupler{R3y, Order::Position};
        Printing printing;
        printing.channels = {kTheta3, kSlider, coupler, kSliderY};
        const Convention downwards{Kind::Sign, {kTheta3, coupler, kSliderY}, -1.0};
        const auto found = findConventions(applied(downwards, printedData(Parameters(), printing)), Parameters());
        QVERIFY2(areFound(found, {downwards}), described(found));
    }

    void convertsR4yWithThePositionOfTheSlider()
    {
        Printing printing;
        printing.channels = kSixChannels;
        printing.channels.push_back(kSliderY);
        const std::vector<Channel> positions{kSlider, kSliderY};
        const ReferenceData data =
            applied({Kind::LengthUnit, positions, 0.1}, printedData(Parameters(), printing)); // cm under mm
        const auto found = findConventions(data, Parameters());
        QVERIFY2(areFound(found, {{Kind::LengthUnit, positions, 10.0}}), described(found));
    }

    void findsALateStartAsARoundNumber()
    {
        const ReferenceData data = applied({Kind::TimeShift, {}, 0.137}, printedData(Parameters()));
        const auto found = findConventions(data, Parameters());
        QCOMPARE(found.size(), std::size_t(1));
        QVERIFY(found[0].convention == (Convention{Kind::TimeShift, {}, -0.137}));
    }

    /// An origin of 13.7° has the same error if the angles are printed in radians, with as many digits.
    void statesTheErrorOfAnOriginInTheUnitOfItsAmount()
    {
        Printing printing;
        printing.channels = kAngleAndPosition;
        const ReferenceData inDegrees =
            applied({Kind::ZeroPoint, {kTheta3}, 13.7}, printedData(Parameters(), printing));
        const ReferenceData inRadians = applied({Kind::AngleUnit, {kTheta3}, 1.0 / kDegreesPerRadian}, inDegrees);
        const auto errorOfOrigin = [](const ReferenceData &data) {
            const auto found = findConventions(data, Parameters());
            const auto isOrigin = [](const ConventionFinding &finding) {
                return finding.convention.kind == Kind::ZeroPoint && std::abs(finding.convention.amount + 13.7) < 1e-3;
            };
            const auto origin = std::ranges::find_if(found, isOrigin);
            return origin != found.end() ? origin->standardError.value() : kNone;
        };
        const double ratio = errorOfOrigin(inRadians) / errorOfOrigin(inDegrees);
        QVERIFY2(std::abs(ratio - 1.0) < 0.1, QByteArray::number(ratio));
    }

    void convertsTheRoundingStepToo()
    {
        // The last digit of 204.624 is 0.001, and it remains so for 24.624, half a turn before.
        ReferenceData data;
        data.time = {0.0, 1.0, 2.0};
        data.series = {{kTheta3, {204.624, 54.5, 80.25}, {Rounding::Rule::SignificantDigits, 6}},
                       {kSliderSpeed, {1.25, -2.5, 0.0}, {Rounding::Rule::Decimals, 2}}};
        data = applied({Kind::HalfTurn, {kTheta3}, -180.0}, std::move(data));
        data = applied({Kind::LengthUnit, {kSliderSpeed}, 1e3}, std::move(data));
        QVERIFY(std::abs(data.series[0].values[1] + 125.5) < 1e-9);
        for (const double value : {24.624, 0.25, 180.25}) {
            QVERIFY(std::abs(data.series[0].rounding.stepAt(value) - 1e-3) < 1e-12);
        }
        QCOMPARE(data.series[1].values[1], -2500.0);
        QVERIFY(std::abs(data.series[1].rounding.stepAt(1.0) - 10.0) < 1e-9);
    }
};

const Suite<TestConventions> suite("tst_conventions");

} // namespace tst_conventions

#include "tst_conventions.moc"
