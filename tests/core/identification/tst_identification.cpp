// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/identification.h"

#include "core/mechanism/turn.h"
#include "tests/support/channels.h"
#include "tests/support/files.h"
#include "tests/support/long_tests.h"
#include "tests/support/printed_motion.h"
#include "tests/support/random_mechanisms.h"
#include "tests/support/suite.h"

#include <QFile>
#include <QTest>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <new>
#include <vector>

using namespace slidercrank;

namespace tst_identification
{

/// Largest allocation in bytes since the last reset to 0. Atomic, because QtTest's watchdog thread allocates, too.
std::atomic<std::size_t> largestAllocation = 0;

} // namespace tst_identification

void *operator new(std::size_t size)
{
    tst_identification::largestAllocation = std::max(tst_identification::largestAllocation.load(), size);
    if (void *memory = std::malloc(std::max<std::size_t>(size, 1))) {
        return memory;
    }
    throw std::bad_alloc();
}

void *operator new(std::size_t size, const std::nothrow_t &) noexcept
{
    tst_identification::largestAllocation = std::max(tst_identification::largestAllocation.load(), size);
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

namespace tst_identification
{

constexpr std::uint64_t kSeed = 20240611;
const Parameters kOrdinary{20.0, 60.0, 25.0, 6.25, 0.25, Branch::Open};

using Outcome = Identification::Outcome;
using Symmetry = AlternativeMechanism::Symmetry;

Printing printingOfTurns(const Parameters &p, double turns, int rows, const std::vector<Channel> &channels)
{
    Printing printing;
    printing.to = turns * kTurn / std::abs(p.omega2);
    printing.rows = rows;
    printing.channels = channels;
    return printing;
}

/// Returns the largest difference of the parameters: lengths relative to a, the relative speed, angles in rad. If
/// `images`, the closest mirror image of `truth` counts.
double distance(const Parameters &found, const Parameters &truth, bool images = false)
{
    double least = kInfinity;
    for (const Parameters &p : mirrorImages(truth)) {
        if (found.branch == p.branch && (images || p == truth)) {
            least = std::min(least, std::max({std::abs(found.a - p.a) / p.a, std::abs(found.b - p.b) / p.a,
                                              std::abs(found.c - p.c) / p.a, std::abs(found.omega2 / p.omega2 - 1.0),
                                              std::abs(std::remainder(found.theta20 - p.theta20, kTurn))}));
        }
    }
    return least;
}

QByteArray described(const Parameters &p)
{
    QByteArray text = p.branch == Branch::Open ? "open" : "crossed";
    for (const double value : {p.a, p.b, p.c, p.omega2, p.theta20}) {
        text += ' ' + QByteArray::number(value, 'g', 10);
    }
    return text;
}

Identification identified(const ReferenceData &data, const Parameters &given = {})
{
    return identify(data, Mechanism(given));
}

class TestIdentification : public QObject
{
    Q_OBJECT

private slots:
    void findsTheMechanismOfTheReferenceReport()
    {
        const QByteArray bytes = contentOf(qEnvironmentVariable("SLIDERCRANK_REFERENCE_FILE"));
        if (bytes.isEmpty()) {
            QSKIP("The reference report's file is not here.");
        }
        const auto outcome = readReferenceData(bytes.toStdString());
        const ReferenceData &data = std::get<ReferenceData>(outcome);
        const Identification result = identified(data);
        QCOMPARE(result.outcome, Outcome::Identified);
        QCOMPARE(result.rounded, (Parameters{20.0, 60.0, 25.0, kTurn, 0.0, Branch::Open}));
        QVERIFY(result.conventions.empty() && result.leftOut.empty() && result.excludedRows.empty());
        QCOMPARE(result.channels.size(), std::size_t{6});
        QVERIFY(std::ranges::count(result.channels, Verdict::Agrees, &ChannelComparison::verdict) == 6);
        for (std::size_t i = 0; i < kParameterCount; ++i) {
            QVERIFY(result.identifiable[i] && result.standardErrors[i] > 0.0 && result.standardErrors[i] < 1e-5);
        }
        QVERIFY(result.conditionNumber > 5.0 && result.conditionNumber < 20.0);
        QCOMPARE(result.change->parameter, Parameter::B);
        QCOMPARE(result.change->value, 60.0);

        const Identification same = identified(data, result.rounded);
        QVERIFY(same.agreesWithGiven && same.conventions.empty() && !same.change);
        const Convention halfTurn{Convention::Kind::HalfTurn, {kTheta3}, 180.0};
        const Identification turned = identified(applied(halfTurn, data));
        QCOMPARE(turned.conventions.size(), std::size_t{1});
        QVERIFY(turned.conventions[0].convention == (Convention{Convention::Kind::HalfTurn, {kTheta3}, -180.0}));
    }

    void findsRandomMechanisms()
    {
        struct Row {
            std::vector<Channel> channels;
            std::vector<Symmetry> images{};
            bool onlyRatios = false;
        };
        const std::vector<Symmetry> mirrored{Symmetry::MirrorImage};
        for (const auto &[channels, images, onlyRatios] :
             {Row{kSixChannels}, Row{kAngleAndPosition}, Row{{kSlider}, mirrored}, Row{{kTheta3, kSliderSpeed}},
              Row{{kSlider, kTheta3Speed}}, Row{{kTheta3Speed, kSliderSpeed}}, Row{kSliderChannels, mirrored},
              Row{{kSliderSpeed}, mirrored}, Row{{kTheta3Acceleration, kSliderAcceleration}},
              Row{{kTheta3}, {Symmetry::ReversedCrank}, true}, Row{kCouplerChannels, {Symmetry::ReversedCrank}, true},
              Row{{kTheta3Speed}, {Symmetry::ReversedCrank, Symmetry::OtherAssembly, Symmetry::OtherAssembly}, true}}) {
            RandomMechanisms random(kSeed);
            for (int i = 0; i < numericCaseCount(8, 300); ++i) {
                const Parameters truth = random.ordinary();
                const double turns = random.uniform(0.6, 3.0);
                const int rows = static_cast<int>(random.uniform(80.0, 500.0));
                Parameters given;
                Parameters expected = truth;
                if (onlyRatios) { // the given crank is kept, and the other lengths are found for it
                    given.branch = truth.branch;
                    expected.a = given.a;
                    expected.b *= given.a / truth.a;
                    expected.c *= given.a / truth.a;
                }
                const Identification result =
                    identified(printedData(truth, printingOfTurns(truth, turns, rows, channels)), given);
                QVERIFY2(result.outcome == Outcome::Identified, namesOf(channels).c_str() + (": " + described(truth)));
                QVERIFY2(distance(result.parameters, expected, !images.empty()) <= 1e-3, described(truth));
                QVERIFY(!onlyRatios || result.parameters.a == given.a);
                QVERIFY2(std::ranges::is_permutation(result.alternatives, images, {}, &AlternativeMechanism::symmetry),
                         namesOf(channels).c_str() + (": " + described(truth)));
                QCOMPARE(result.lengthScale == Identification::LengthScale::GivenCrank, onlyRatios);
                QCOMPARE(result.identifiable, (std::array{!onlyRatios, !onlyRatios, !onlyRatios, true, true}));
            }
        }
    }

    void findsAMechanismOfAnySizeAtAnyTime()
    {
        for (const double size : {1e-6, 1e9}) {
            Parameters truth{20.0 * size, 60.0 * size, -25.0 * size, -1e3, 1.0, Branch::Crossed};
            Printing printing;
            printing.from = 1e4;
            printing.to = 1e4 + 0.01;
            printing.timeFormat = "%.12g";
            const Identification result = identified(printedData(truth, printing));
            QCOMPARE(result.outcome, Outcome::Identified);
            // The uncertainty of the angle at t = 0 is that of the speed times 1e4 s.
            const double off = std::remainder(result.parameters.theta20 - truth.theta20, kTurn);
            QVERIFY(std::abs(off) < 5.0 * result.standardErrors[indexOf(Parameter::Theta20)]);
            truth.theta20 = result.parameters.theta20;
            QVERIFY2(distance(result.parameters, truth) < 1e-5, described(result.parameters));
        }
    }

    void findsAThousandTurnsInManyRows()
    {
        const Parameters truth{20.0, 60.0, 25.0, -7.0, 2.0, Branch::Open};
        ReferenceData data = printedData(truth, printingOfTurns(truth, 1000.0, 50000, kAngleAndPosition));
        valuesOf(data, kSlider)[30000] = 500.0;
        const Identification result = identified(data);
        QCOMPARE(result.outcome, Outcome::Identified);
        QVERIFY2(distance(result.parameters, truth) < 1e-5, described(result.parameters));
        QCOMPARE(result.excludedRows, std::vector<std::size_t>{30002}); // the heading is line 1
    }

    void findsTheSpeedAlthoughGapsHideTurns()
    {
        const auto isGap = [](int row, Channel) { return row % 50 >= 12; };
        const Identification result =
            identified(printedData(kOrdinary, printingOfTurns(kOrdinary, 16.0, 600, kAngleAndPosition), isGap));
        QCOMPARE(result.outcome, Outcome::Identified);
        QVERIFY(distance(result.parameters, kOrdinary) < 1e-4);
    }

    void claimsNoChangeOfSpeedIfAWrapWasInterpolated()
    {
        ReferenceData data = printedData(kOrdinary);
        std::vector<double> angles; // °, from 0 to 360
        for (const double t : data.time) {
            const double turns = kOrdinary.omega2 * t / kTurn * 3.3;
            angles.push_back(360.0 * (turns - std::floor(turns)));
        }
        for (std::size_t i = angles.size() - 1; i > 0; --i) {
            angles[i] = angles[i] < angles[i - 1] ? 180.0 : angles[i];
        }
        data.series.push_back({kTheta2, angles, {}});
        QVERIFY(!identified(data).drive);
    }

    void usesOnlySomeOfManyRows()
    {
        if (kIsSanitized) {
            QSKIP("It would take a minute, and findsAThousandTurnsInManyRows() checks the memory of a long file.");
        }
        for (const double turns : {1.0, 1e4}) {
            const Parameters p;
            ReferenceData data;
            for (const Channel channel : kPlottedChannels) {
                data.series.push_back({channel, {}, {Rounding::Rule::SignificantDigits, 17}});
            }
            for (int i = 0; i < 200'000; ++i) {
                data.time.push_back(turns * i * 5e-6);
                const PrintedRow row = textbookMotion(p, data.time.back());
                for (std::size_t k = 0; k < row.size(); ++k) {
                    data.series[k].values.push_back(static_cast<double>(row[k]));
                }
            }
            const std::vector<Channel> angles{kTheta3, {Theta3, Order::Velocity}, {Theta3, Order::Acceleration}};
            data = applied({Convention::Kind::AngleUnit, angles, 1.0 / kDegreesPerRadian}, std::move(data));
            largestAllocation = 0;
            const Identification found = identified(data, p);
            const std::size_t largest = largestAllocation;
            QCOMPARE(found.conventions.size(), std::size_t{1});
            QVERIFY(found.conventions[0].convention ==
                    (Convention{Convention::Kind::AngleUnit, angles, kDegreesPerRadian}));
            QVERIFY(found.conventions[0].before > 1.0 && found.conventions[0].after < 0.1);
            // Applying a convention copies the file column by column, so no allocation exceeds one column.
            QVERIFY2(largest <= sizeof(double) * data.time.size(), QByteArray::number(largest));
        }
    }

    void leavesOutAColumnOfAnotherMechanism()
    {
        ReferenceData data = printedData(kOrdinary);
        Parameters other = kOrdinary;
        other.b *= 1.01;
        ReferenceData second = printedData(other);
        valuesOf(data, kSliderSpeed) = valuesOf(second, kSliderSpeed);
        const Identification found = identified(data);
        QCOMPARE(found.outcome, Outcome::Identified);
        QVERIFY(distance(found.parameters, kOrdinary) < 1e-5);
        QCOMPARE(found.leftOut.size(), std::size_t{1});
        QVERIFY(found.leftOut[0].channel == kSliderSpeed);
        QCOMPARE(found.leftOut[0].reason, LeftOutColumn::Reason::OtherMotion);
        QVERIFY(found.leftOut[0].percentOfPeak > 0.1 && found.conventions.empty());
    }

    /// A person chose θ2 every 15° and computed the times from it. Taken for angles that were rounded to whole degrees,
    /// they would allow a mechanism without a different origin of x: b = 161 mm.
    void takesChosenAnglesAsExact()
    {
        const Parameters p{.a = 45.0, .b = 153.6, .c = -13.5, .omega2 = 12.0};
        std::string text = "t [s],theta2 [deg],R4_x [mm],R4_x_diff [mm/s]\n";
        for (int degrees = 30; degrees <= 390; degrees += 15) {
            const double angle = degrees / kDegreesPerRadian;
            const auto value = [&](Order order) { return static_cast<double>(textbookValue(p, {R4x, order}, angle)); };
            std::array<char, 80> line{};
            std::snprintf(line.data(), line.size(), "%.6g,%d,%.1f,%.0f\n",
                          (angle - 30.0 / kDegreesPerRadian) / p.omega2, degrees, value(Order::Position) + 7.5,
                          value(Order::Velocity));
            text += line.data();
        }
        const Identification found = identified(std::get<ReferenceData>(readReferenceData(text)));
        QCOMPARE(found.outcome, Outcome::Identified);
        QVERIFY(std::abs(found.parameters.b - p.b) < 0.5 && std::abs(found.parameters.c - p.c) < 0.1);
        QCOMPARE(found.rounded.omega2, p.omega2);
    }

    /// The rounding errors of θ2 have the same sign in many rows. They must not excuse the errors of a noisy x: without
    /// its origin, no mechanism explains it.
    void findsTheOriginOfANoisyColumnBesideARoundedAngle()
    {
        RandomMechanisms random(5);
        Parameters p{.a = 20.0, .b = 60.0, .c = 0.0, .omega2 = 0.5 * kTurn};
        std::string text = "t [s],theta2 [deg],R4_x [mm]\n";
        for (int degrees = 107; degrees <= 467; degrees += 10) {
            const double angle = degrees / kDegreesPerRadian;
            const double x = static_cast<double>(textbookValue(p, {R4x, Order::Position}, angle));
            std::array<char, 80> line{};
            std::snprintf(line.data(), line.size(), "%.6g,%d,%.3f\n", (degrees - 107) / 180.0, degrees,
                          x + 100.0 + random.uniform(-0.1, 0.1));
            text += line.data();
        }
        const Identification found = identified(std::get<ReferenceData>(readReferenceData(text)));
        QVERIFY(found.hasMechanism());
        QVERIFY(std::abs(found.parameters.a - p.a) < 0.1 && std::abs(found.parameters.b - p.b) < 3.0);
        QCOMPARE(found.conventions.size(), std::size_t{1});
        QVERIFY(std::abs(found.conventions[0].convention.amount + 100.0) < 2.0);
    }

    /// Velocities over the angle show only a ω2. A column of time shows ω2, and thus the size and the sign.
    void findsTheSizeFromVelocitiesAndTheDrive()
    {
        for (const double omega2 : {12.0, -1.0}) {
            Parameters p = kOrdinary;
            p.omega2 = omega2;
            p.theta20 = 0.0;
            std::string text = "t [s],theta2 [deg],R4_x_diff [mm/s]\n";
            for (int row = 0; row <= 24; ++row) {
                const double degrees = std::copysign(15.0 * row, omega2);
                const double velocity =
                    static_cast<double>(textbookValue(p, {R4x, Order::Velocity}, degrees / kDegreesPerRadian));
                std::array<char, 80> line{};
                std::snprintf(line.data(), line.size(), "%.7g,%g,%.5f\n", degrees / kDegreesPerRadian / omega2, degrees,
                              velocity);
                text += line.data();
            }
            const ReferenceData data = std::get<ReferenceData>(readReferenceData(text));
            for (const double givenSpeed : {Parameters().omega2, 0.0}) {
                Parameters given;
                given.omega2 = givenSpeed;
                const Identification found = identified(data, given);
                QCOMPARE(found.outcome, Outcome::Identified);
                QVERIFY(distance(found.parameters, p) < 1e-3 && found.conventions.empty());
            }
        }
    }

    /// θ3 measured at B in the crossed assembly is θ3 in the open one with the opposite sign. Only the velocity of the
    /// slider distinguishes the assemblies.
    void findsTheAssemblyFromTheVelocityBesideTheCouplerAngle()
    {
        for (const Branch branch : {Branch::Open, Branch::Crossed}) {
            const Parameters p{
                .a = 45.0, .b = 158.0, .c = 10.0, .omega2 = kOrdinary.omega2, .theta20 = 0.0, .branch = branch};
            std::string text = "theta2 [deg],theta3 [deg],R4_x_diff [mm/s]\n";
            for (int degrees = 0; degrees <= 360; degrees += 15) {
                const auto value = [&](Channel channel) {
                    return static_cast<double>(textbookValue(p, channel, degrees / kDegreesPerRadian));
                };
                std::array<char, 80> line{};
                std::snprintf(line.data(), line.size(), "%d,%.3f,%.3f\n", degrees,
                              value(kTheta3) * kDegreesPerRadian + 180.0, value(kSliderSpeed));
                text += line.data();
            }
            Parameters given;
            given.omega2 = p.omega2;
            const Identification found = identified(std::get<ReferenceData>(readReferenceData(text)), given);
            QCOMPARE(found.outcome, Outcome::Identified);
            QVERIFY(found.leftOut.empty());
            QCOMPARE(found.parameters.branch, branch);
            QVERIFY(std::abs(found.parameters.b / found.parameters.a - p.b / p.a) < 1e-3);
        }
    }

    /// Velocities of a crank with a ripple do not show the size of the mechanism, so that no lengths may be stated.
    void doesNotFindLengthsFromVelocitiesOfAnUnevenCrank()
    {
        std::string text = "t [s],theta2 [deg],R4_x_diff [mm/s]\n";
        for (int row = 0; row <= 60; ++row) {
            const double t = 0.01 * row;
            const double angle = 12.0 * t + 0.05 * std::sin(12.0 * t);
            Parameters p = kOrdinary;
            p.omega2 = 12.0 + 0.6 * std::cos(12.0 * t);
            std::array<char, 80> line{};
            std::snprintf(line.data(), line.size(), "%.2f,%.4f,%.4f\n", t, angle * kDegreesPerRadian,
                          static_cast<double>(textbookValue(p, {R4x, Order::Velocity}, angle)));
            text += line.data();
        }
        const Identification found = identified(std::get<ReferenceData>(readReferenceData(text)));
        QCOMPARE(found.outcome, Outcome::Insufficient);
        QCOMPARE(found.lack, Identification::Lack::UnevenSpeed);
    }

    /// Without θ2, a speed that varies once per turn looks like different lengths and a different origin.
    void statesNoLengthsThatAVaryingSpeedMayImitate()
    {
        for (const double amplitude : {0.02, 0.05}) { // rad
            for (const bool hasPosition : {true, false}) {
                std::string text = hasPosition ? "t [s],R4_x_diff [mm/s],R4_x [mm]\n" : "t [s],R4_x_diff [mm/s]\n";
                for (int row = 0; row <= 60; ++row) {
                    const double t = row / 60.0;
                    const double phase = kTurn * t;
                    const double angle = phase + amplitude * std::sin(phase);
                    Parameters p = kOrdinary;
                    p.omega2 = kTurn * (1.0 + amplitude * std::cos(phase));
                    std::array<char, 80> line{};
                    std::snprintf(line.data(), line.size(), hasPosition ? "%.6f,%.3f,%.3f\n" : "%.6f,%.3f\n", t,
                                  static_cast<double>(textbookValue(p, {R4x, Order::Velocity}, angle)),
                                  static_cast<double>(textbookValue(p, {R4x, Order::Position}, angle)));
                    text += line.data();
                }
                const Identification found = identified(std::get<ReferenceData>(readReferenceData(text)));
                const Parameters &lengths = found.parameters;
                const double error = std::abs(lengths.b / lengths.a / (kOrdinary.b / kOrdinary.a) - 1.0);
                QVERIFY2(!found.hasMechanism() || error < 0.05, qPrintable(QString::number(amplitude)));
            }
        }
    }

    void usesTheAngleOfAnUnevenCrank()
    {
        struct Row {
            const char *name;
            double acceleration;
            double ripple;
        };
        for (const Row &row : {Row{"run-up", 10.0, 0.0}, Row{"ripple", 0.0, 0.2}}) {
            std::string text = "time [s],theta2 [deg],R4_x [mm],R4_x_diff2 [mm/s^2]\n";
            for (int i = 0; i <= 200; ++i) {
                const double t = 0.005 * i;
                const double angle = 2.0 * t + 0.5 * row.acceleration * t * t + row.ripple * std::sin(9.0 * t);
                const double speed = 2.0 + row.acceleration * t;
                const auto derivative = [&](Order order) { // by the angle
                    Parameters unit = kOrdinary;
                    unit.omega2 = 1.0;
                    return static_cast<double>(textbookValue(unit, {R4x, order}, angle));
                };
                const double acceleration =
                    derivative(Order::Acceleration) * speed * speed + derivative(Order::Velocity) * row.acceleration;
                std::array<char, 120> line{};
                std::snprintf(line.data(), line.size(), "%.3f,%.5f,%.5f,%.4f\n", t, angle * kDegreesPerRadian,
                              derivative(Order::Position), acceleration);
                text += line.data();
            }
            const Identification found = identified(std::get<ReferenceData>(readReferenceData(text)));
            QCOMPARE(found.outcome, Outcome::Identified);
            QVERIFY2(std::abs(found.parameters.b - kOrdinary.b) < 1e-3, row.name);
            QVERIFY2(found.drive && found.drive->alpha2.has_value() == (row.acceleration > 0.0), row.name);
            if (row.acceleration > 0.0) {
                QVERIFY(std::abs(*found.drive->alpha2 - 10.0) < 0.01 && std::abs(found.drive->omega2 - 2.0) < 0.01);
                QVERIFY(found.leftOut.empty() && found.residuals.size() == 2);
            } else {
                QCOMPARE(found.leftOut.size(), std::size_t{1});
                QCOMPARE(found.leftOut[0].reason, LeftOutColumn::Reason::UnevenSpeed);
            }
        }
    }

    void findsNoMechanismInAnotherMotion()
    {
        ReferenceData data = printedData(kOrdinary, printingOfTurns(kOrdinary, 2.0, 240, {kSlider}));
        std::vector<double> &values = valuesOf(data, kSlider);
        for (std::size_t i = 0; i < values.size(); ++i) { // a damped oscillation
            values[i] = 80.0 * std::exp(-0.01 * static_cast<double>(i)) * std::cos(0.3 * static_cast<double>(i));
        }
        const Identification result = identified(data);
        QCOMPARE(result.outcome, Outcome::None);
        QVERIFY(!result.residuals.empty() && result.conventions.empty() && result.alternatives.empty());
        QCOMPARE(result.parameters, Parameters());
    }

    void reportsWhatIsMissing()
    {
        using Lack = Identification::Lack;
        Parameters standing;
        standing.omega2 = 0.0;
        standing.theta20 = 0.3;
        Printing printing;
        printing.rows = 4;
        printing.channels = {kSlider};
        QCOMPARE(identified(printedData(standing)).lack, Lack::NothingMoves);
        QCOMPARE(identified(printedData(Parameters(), printing)).lack, Lack::FewValues);
        QCOMPARE(identified(ReferenceData()).lack, Lack::FewValues);
        const char *oneRow = "t [s],theta2 [deg],R4_x [mm]\n0,30,80\n1,40,\n2,50,\n";
        QCOMPARE(identified(std::get<ReferenceData>(readReferenceData(oneRow))).lack, Lack::FewValues);
        printing.rows = 7; // five parameters fit seven numbers of six digits by chance
        QCOMPARE(identified(printedData(Parameters(), printing)).outcome, Outcome::Insufficient);
    }

    void stopsWhenAsked()
    {
        std::stop_source source;
        source.request_stop();
        const Identification found = identify(printedData(Parameters()), Mechanism(), source.get_token());
        QVERIFY(found.stopped && !found.hasMechanism() && found.conventions.empty());
    }

    void blamesALengthOnlyIfItAloneExplainsTheFile()
    {
        RandomMechanisms random(kSeed);
        for (const Parameter length : {Parameter::A, Parameter::B, Parameter::C}) {
            for (int i = 0; i < numericCaseCount(6, 50); ++i) {
                const Parameters truth = random.ordinary();
                const ReferenceData data = printedData(truth, printingOfTurns(truth, 2.0, 201, kSixChannels));
                Parameters given = truth;
                valueOf(given, length) *= random.uniform(1.05, 1.3);
                const Identification found = identified(data, given);
                QVERIFY2(found.change && found.change->parameter == length, described(truth));
                QVERIFY(std::abs(found.change->value - valueOf(truth, length)) <= 1e-3 * truth.b);
                valueOf(given, length == Parameter::A ? Parameter::B : Parameter::A) *= 1.1;
                QVERIFY2(!identified(data, given).change, described(truth));
            }
        }
    }
};

const Suite<TestIdentification> suite("tst_identification");

} // namespace tst_identification

#include "tst_identification.moc"
