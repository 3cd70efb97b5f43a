// SPDX-License-Identifier: GPL-3.0-or-later
// Tests what is said about files as students and engineers make them (tests/support/ordinary_files): tables over the
// crank angle, symbols of a textbook, finite differences, a crank whose speed varies, a scale read from a dead centre.
// Their mechanisms are known.

#include "core/identification/identification.h"
#include "tests/support/files.h"
#include "tests/support/reading.h"
#include "tests/support/suite.h"

#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <numbers>
#include <random>
#include <string>
#include <variant>

using namespace slidercrank;

namespace tst_ordinary_files
{

using enum Convention::Kind;
using Outcome = Identification::Outcome;
using Reason = LeftOutColumn::Reason;

constexpr Channel kSlider{R4x, Order::Position};
constexpr Channel kSliderVelocity{R4x, Order::Velocity};
constexpr Channel kSliderAcceleration{R4x, Order::Acceleration};
constexpr Channel kCoupler{Theta3, Order::Position};
constexpr double kTurnPerSecond = 2.0 * std::numbers::pi;
constexpr double kDegree = std::numbers::pi / 180.0;

Identification identifyFile(const QString &name, const Parameters &given = {})
{
    const QByteArray bytes = contentOf(SLIDERCRANK_SOURCE_DIR "/tests/support/ordinary_files/" + name + ".csv");
    const auto outcome = readReferenceData({bytes.data(), static_cast<std::size_t>(bytes.size())});
    return identify(std::get<ReferenceData>(outcome), Mechanism(given));
}

/// The position of the slider by the textbook's formula.
double sliderPosition(double a, double b, double c, double theta2)
{
    return a * std::cos(theta2) + std::sqrt(b * b - std::pow(c - a * std::sin(theta2), 2.0));
}

/// Identifies a table with two decimals. The first column contains multiples of `step`, in the unit of its heading, and
/// the second one `column` of these.
Identification identifyTable(const std::string &headings, double step, int rows,
                             const std::function<double(double)> &column, const Parameters &given = {})
{
    std::string text = headings + '\n';
    for (int i = 0; i < rows; ++i) {
        std::array<char, 80> line{};
        std::snprintf(line.data(), line.size(), "%.2f,%.2f\n", i * step, column(i * step));
        text += line.data();
    }
    return identify(std::get<ReferenceData>(readReferenceData(text)), Mechanism(given));
}

/// Returns whether the errors of the lengths (mm) are at most `tolerance` times the length of the crank.
bool hasLengths(const Identification &found, double a, double b, double c, double tolerance = 1e-3)
{
    const Parameters &p = found.parameters;
    const auto isNear = [=](double value, double truth) { return std::abs(value - truth) <= tolerance * a; };
    return found.hasMechanism() && isNear(p.a, a) && isNear(p.b, b) && isNear(p.c, c);
}

bool hasFinding(const Identification &found, Convention::Kind kind, Channel channel)
{
    return std::ranges::any_of(found.conventions, [=](const ConventionFinding &finding) {
        return finding.convention.kind == kind && concerns(finding.convention, channel);
    });
}

bool leavesOut(const Identification &found, Channel channel, Reason reason)
{
    return std::ranges::any_of(found.leftOut, [=](const LeftOutColumn &column) {
        return column.channel == channel && column.reason == reason;
    });
}

bool determines(const Identification &found, Parameter parameter)
{
    return found.identifiable[indexOf(parameter)];
}

class TestOrdinaryFiles : public QObject
{
    Q_OBJECT

private slots:
    /// θ3 is measured at B, and the angular rates are in rad/s without saying so.
    void findsTheSpeedFromTheRatesOfATextbook()
    {
        const Identification found = identifyFile("norton");
        QVERIFY(hasLengths(found, 20.0, 60.0, 25.0));
        QVERIFY(determines(found, Parameter::Omega2));
        QVERIFY(std::abs(found.parameters.omega2 / kTurnPerSecond - 1.0) < 1e-4);
        QVERIFY(hasFinding(found, HalfTurn, kCoupler));
        QVERIFY(!hasFinding(found, AngleUnit, {Theta3, Order::Velocity})); // ω and α are read in rad/s
        QVERIFY(!hasFinding(found, AngleUnit, {Theta3, Order::Acceleration}));
        QVERIFY(found.leftOut.empty());
    }

    /// A former defect: no mechanism was said to explain a table of 13 rows in which a minus sign was typed, or a
    /// decimal point was not.
    void namesTheLineOfATypingError()
    {
        constexpr double kStep = 30.0; // °
        for (const double row : {2.0, 6.0, 11.0}) {
            for (const double factor : {-1.0, 100.0}) {
                const auto position = [=](double degrees) {
                    const double x = sliderPosition(60.0, 200.0, -20.0, degrees * kDegree);
                    return degrees == row * kStep ? factor * x : x;
                };
                const Identification found = identifyTable("theta2 [deg],R4_x [mm]", kStep, 13, position);
                QVERIFY(found.outcome == Outcome::Identified);
                QVERIFY(hasLengths(found, 60.0, 200.0, -20.0));
                QVERIFY(found.conventions.empty());
                QCOMPARE(found.excludedRows, std::vector{static_cast<std::size_t>(row) + 2}); // line 1: the headings
            }
        }
    }

    /// Former defects: two errors in one table (digits exchanged, a lost sign or decimal point), or a wrong angle, led
    /// to no mechanism, or to one that was only approximate.
    void namesTheLinesOfSeveralTypingErrors()
    {
        constexpr double kStep = 10.0; // °
        struct WrongCell {
            int row;
            double value; // mm
        };
        struct WrongCells {
            WrongCell first;
            WrongCell second;
        };
        for (const WrongCells &wrong : {WrongCells{{8, -194.12}, {17, 138.85}}, WrongCells{{5, 27.38}, {30, 22743.0}},
                                        WrongCells{{20, 134.62}, {33, 251.17}}}) {
            const WrongCell &first = wrong.first;
            const WrongCell &second = wrong.second;
            const auto position = [&](double degrees) {
                const int row = static_cast<int>(std::lround(degrees / kStep));
                const double typed = row == first.row ? first.value : second.value;
                const bool isWrong = row == first.row || row == second.row;
                return isWrong ? typed : sliderPosition(60.0, 200.0, -20.0, degrees * kDegree);
            };
            const Identification found = identifyTable("theta2 [deg],R4_x [mm]", kStep, 37, position);
            QCOMPARE(found.outcome, Outcome::Identified);
            QVERIFY(hasLengths(found, 60.0, 200.0, -20.0));
            QVERIFY(found.conventions.empty());
            const std::vector lines{static_cast<std::size_t>(first.row) + 2, static_cast<std::size_t>(second.row) + 2};
            QCOMPARE(found.excludedRows, lines); // line 1: the headings
        }
    }

    /// A former defect: a wrong angle leaves the curve of the positions smooth, and the mechanism was only approximate.
    void namesTheLineOfAWrongAngleInATable()
    {
        std::string text = "theta2 [deg],R4_x [mm]\n";
        for (int degrees = 0; degrees <= 360; degrees += 10) {
            std::array<char, 80> line{};
            std::snprintf(line.data(), line.size(), "%d,%.2f\n", degrees == 130 ? 133 : degrees,
                          sliderPosition(30.0, 105.0, 3.0, degrees * kDegree));
            text += line.data();
        }
        const Identification found =
            identify(std::get<ReferenceData>(readReferenceData(text)), Mechanism(Parameters()));
        QCOMPARE(found.outcome, Outcome::Identified);
        QVERIFY(hasLengths(found, 30.0, 105.0, 3.0));
        QCOMPARE(found.excludedRows, std::vector{std::size_t{15}});
    }

    /// A former defect: where the slider stands still, the rounding of an angle changes no position. The positions
    /// there deviate from a mechanism that was fitted to rounded angles, and they were called outliers, or the
    /// mechanism only approximate.
    void allowsForTheRoundingOfUnevenAnglesAtTheDeadCentres()
    {
        for (const int decimals : {0, 1}) {
            std::string text = "theta2 [deg],R4_x [mm]\n";
            for (int i = 0; i <= 48; ++i) {
                const double angle = (7.5 * i + 3.0 * std::sin(0.37 * i * i)) * kDegree; // set by hand
                std::array<char, 80> line{};
                std::snprintf(line.data(), line.size(), "%.*f,%.3f\n", decimals, angle / kDegree,
                              sliderPosition(50.0, 150.0, 10.0, angle));
                text += line.data();
            }
            const Identification found =
                identify(std::get<ReferenceData>(readReferenceData(text)), Mechanism(Parameters()));
            QCOMPARE(found.outcome, Outcome::Identified);
            QVERIFY(hasLengths(found, 50.0, 150.0, 10.0, 5e-3));
            QVERIFY(found.excludedRows.empty());
        }
    }

    /// A former defect: positions of a video that are noisy by 2 % of the crank were called the motion of a slider that
    /// does not move along x.
    void acceptsTheNoiseOfBothCoordinatesOfAVideo()
    {
        std::mt19937 random(5);
        std::normal_distribution<double> noise(0.0, 0.02 * 40.0); // mm
        std::string text = "t [s],x [mm],y [mm]\n";
        for (int i = 0; i <= 120; ++i) {
            const double angle = 0.7 + kTurnPerSecond * i / 30.0;
            std::array<char, 80> line{};
            std::snprintf(line.data(), line.size(), "%.3f,%.2f,%.2f\n", i / 30.0,
                          sliderPosition(40.0, 120.0, 10.0, angle) + noise(random), 10.0 + noise(random));
            text += line.data();
        }
        const Identification found =
            identify(std::get<ReferenceData>(readReferenceData(text)), Mechanism(Parameters()));
        QCOMPARE(found.outcome, Outcome::Approximate);
        QVERIFY(hasLengths(found, 40.0, 120.0, 10.0, 0.02));
    }

    /// Former defects: the lengths of a table by the approximate formula were those of a different mechanism, wrong by
    /// more than their standard errors, and the positions were said to be measured from a different origin.
    void namesTheApproximateFormula_data()
    {
        QTest::addColumn<QString>("headings");
        QTest::addColumn<double>("connectingRod");
        QTest::newRow("position") << "theta2 [deg],x [mm]" << 160.0;
        QTest::newRow("short rod") << "theta2 [deg],x [mm]" << 100.0;
        QTest::newRow("displacement") << "theta2 [deg],Displacement s (mm)" << 160.0;
        QTest::newRow("with velocity") << "theta2 [deg],x [mm],v [mm/s]" << 140.0;
        QTest::newRow("with acceleration") << "theta2 [deg],x [mm],v [mm/s],a [mm/s^2]" << 120.0;
    }
    void namesTheApproximateFormula()
    {
        QFETCH(QString, headings);
        QFETCH(double, connectingRod);
        constexpr double kCrank = 40.0;
        const double ratio = kCrank / connectingRod;
        const bool isDisplacement = headings.contains("Displacement");
        QString text = headings + '\n';
        for (int degrees = 0; degrees <= 360; degrees += 10) {
            const double angle = degrees * kDegree;
            const double s = kCrank * (1.0 - std::cos(angle) +
                                       0.25 * ratio * (1.0 - std::cos(2.0 * angle))); // from the outer dead centre
            const double v = -kCrank * kTurnPerSecond * (std::sin(angle) + 0.5 * ratio * std::sin(2.0 * angle));
            const double a =
                -kCrank * kTurnPerSecond * kTurnPerSecond * (std::cos(angle) + ratio * std::cos(2.0 * angle));
            const std::array<double, 3> values{isDisplacement ? s : kCrank + connectingRod - s, v, a};
            text += QString::number(degrees);
            for (int column = 0; column < headings.count(','); ++column) {
                text += ',' + QString::number(values.at(static_cast<std::size_t>(column)), 'f', 3);
            }
            text += '\n';
        }
        const auto outcome = readReferenceData(text.toStdString());
        const Identification found = identify(std::get<ReferenceData>(outcome), Mechanism(Parameters()));
        QCOMPARE(found.outcome, Outcome::Approximate); // of the exact motion
        QVERIFY(found.followsApproximateFormula);
        const ColumnResidual &ofPosition = found.residuals.front(); // that of the exact motion
        QCOMPARE(ofPosition.channel, kSlider);
        const double largest = connectingRod - 0.5 * kCrank * kCrank / connectingRod -
                               std::sqrt(connectingRod * connectingRod - kCrank * kCrank);
        QVERIFY(std::abs(ofPosition.max - largest) < 2e-3);
        QVERIFY(std::abs(ofPosition.percentOfRange - 100.0 * largest / (2.0 * kCrank)) < 3e-3);
        QVERIFY(hasLengths(found, kCrank, connectingRod, 0.0, 2e-4));
        QCOMPARE(hasFinding(found, ZeroPoint, kSlider), isDisplacement);
        QVERIFY(found.leftOut.empty());
        QVERIFY(found.excludedRows.empty());
    }

    /// A former defect: with few digits, the exact motion of a longer rod agreed as well, if the positions were
    /// measured from a different origin.
    void prefersTheApproximateFormulaToAnOrigin()
    {
        constexpr double kCrank = 12.5;
        constexpr double kRod = 43.75;
        const auto position = [=](double degrees) {
            const double angle = degrees * kDegree;
            return kCrank * std::cos(angle) + kRod - kCrank * kCrank / (4.0 * kRod) * (1.0 - std::cos(2.0 * angle));
        };
        const Identification found = identifyTable("theta2 [deg],R4_x [mm]", 10.0, 37, position);
        QVERIFY(found.followsApproximateFormula);
        QVERIFY(hasLengths(found, kCrank, kRod, 0.0));
        QVERIFY(found.conventions.empty());
    }

    /// A former defect: beside exact positions and velocities by the approximate formula, c was 2·10⁻¹⁴ mm.
    void statesNoErrorOfTheArithmeticAsAnOffset()
    {
        constexpr double kCrank = 90.0;
        constexpr double kRod = 337.5;
        std::string text = "theta2 [deg],x [mm],v [mm/s]\n";
        for (int degrees = 0; degrees <= 360; degrees += 10) {
            const double angle = degrees * kDegree;
            const double velocity =
                -kCrank * kTurnPerSecond * (std::sin(angle) + kCrank / (2.0 * kRod) * std::sin(2.0 * angle));
            std::array<char, 80> line{};
            std::snprintf(line.data(), line.size(), "%d,%.2f,%.1f\n", degrees, sliderPosition(kCrank, kRod, 0.0, angle),
                          velocity);
            text += line.data();
        }
        const Identification found =
            identify(std::get<ReferenceData>(readReferenceData(text)), Mechanism(Parameters()));
        QCOMPARE(found.outcome, Outcome::Approximate);
        QVERIFY(found.hasSystematicResiduals); // so that no standard error tells how far the offset may be from zero
        QVERIFY(found.parameters.c == 0.0);
    }

    /// A former defect: a tenth of the given speed was found in velocities in cm/s under a heading that says mm/s.
    void doubtsATenthOfTheGivenSpeed()
    {
        std::string text = "theta2 [deg],R4_x [mm],v [mm/s]\n";
        for (int degrees = 0; degrees <= 360; degrees += 10) {
            const double angle = degrees * kDegree;
            const double x = sliderPosition(40.0, 120.0, 0.0, angle);
            const double v = -40.0 * kTurnPerSecond * std::sin(angle) * x / (x - 40.0 * std::cos(angle));
            std::array<char, 80> line{};
            std::snprintf(line.data(), line.size(), "%d,%.2f,%.2f\n", degrees, x, v / 10.0);
            text += line.data();
        }
        const Identification found =
            identify(std::get<ReferenceData>(readReferenceData(text)), Mechanism(Parameters()));
        QCOMPARE(found.outcome, Outcome::Identified);
        QVERIFY(!determines(found, Parameter::Omega2));
        QCOMPARE(found.possibleSpeeds.size(), 2U);
        QVERIFY(std::abs(found.possibleSpeeds[1] / kTurnPerSecond - 1.0) < 1e-3);
    }

    /// A former defect: the rounding of the angles bent the curve, so that the lengths were wrong by more than their
    /// standard errors, or the mechanism only approximate.
    void findsTheAnglesBeforeTheirRounding_data()
    {
        QTest::addColumn<QString>("unit");
        QTest::addColumn<double>("start"); // in this unit
        QTest::addColumn<double>("step");
        QTest::addColumn<int>("decimalsOfAngle");
        QTest::addColumn<int>("decimalsOfPosition");
        QTest::newRow("23 parts of a turn in whole degrees") << "deg" << 0.0 << 360.0 / 23.0 << 0 << 3;
        QTest::newRow("24 parts of a turn in radians") << "rad" << 0.0 << std::numbers::pi / 12.0 << 2 << 4;
        QTest::newRow("28 parts of a turn in radians") << "rad" << 0.3 << std::numbers::pi / 14.0 << 2 << 4;
        QTest::newRow("an odd start") << "rad" << 0.0123 << std::numbers::pi / 5.0 << 3 << 3;
    }
    void findsTheAnglesBeforeTheirRounding()
    {
        QFETCH(QString, unit);
        QFETCH(double, start);
        QFETCH(double, step);
        QFETCH(int, decimalsOfAngle);
        QFETCH(int, decimalsOfPosition);
        QString text = QStringLiteral("theta2 [%1],R4_x [mm]\n").arg(unit);
        for (int i = 0; i < 25; ++i) {
            const double angle = start + i * step;
            const double x = sliderPosition(40.0, 120.0, 0.0, unit == "deg" ? angle * kDegree : angle);
            text += QStringLiteral("%1,%2\n").arg(angle, 0, 'f', decimalsOfAngle).arg(x, 0, 'f', decimalsOfPosition);
        }
        const auto outcome = readReferenceData(text.toStdString());
        const Identification found = identify(std::get<ReferenceData>(outcome), Mechanism(Parameters()));
        QCOMPARE(found.outcome, Outcome::Identified);
        QVERIFY(hasLengths(found, 40.0, 120.0, 0.0, 5e-5));
        QVERIFY(found.conventions.empty());
    }

    /// A former defect: at 600 rpm, ten times the initial speed, the velocity was said to be in cm/s.
    void believesAStatedUnitMoreThanTheGivenSpeed()
    {
        const double speed = 10.0 * Parameters().omega2;
        std::string text = "theta2 [deg],R4_x [mm],v [mm/s]\n";
        for (int degrees = 0; degrees <= 180; degrees += 5) {
            const double angle = degrees * kDegree;
            const double x = sliderPosition(40.0, 120.0, 0.0, angle);
            const double v = -40.0 * speed * std::sin(angle) * x / (x - 40.0 * std::cos(angle));
            std::array<char, 80> line{};
            std::snprintf(line.data(), line.size(), "%d,%.3f,%.2f\n", degrees, x, v);
            text += line.data();
        }
        const Identification found =
            identify(std::get<ReferenceData>(readReferenceData(text)), Mechanism(Parameters()));
        QCOMPARE(found.outcome, Outcome::Identified);
        QVERIFY(determines(found, Parameter::Omega2));
        QVERIFY(std::abs(found.parameters.omega2 / speed - 1.0) < 1e-4);
        QVERIFY(found.conventions.empty());
    }

    /// A former defect: one wrong angle of the crank was said to be a speed between 6 and 14 rad/s.
    void namesTheLineOfAWrongCrankAngle()
    {
        std::string text = "t [s],theta2 [deg],R4_x [mm]\n";
        for (int i = 0; i <= 60; ++i) {
            const double angle = 0.1 * i;
            const double wrong = i == 20 ? 9.0 : 0.0; // °
            std::array<char, 80> line{};
            std::snprintf(line.data(), line.size(), "%.2f,%.1f,%.2f\n", 0.01 * i, angle / kDegree + wrong,
                          sliderPosition(40.0, 120.0, 10.0, angle));
            text += line.data();
        }
        const Identification found =
            identify(std::get<ReferenceData>(readReferenceData(text)), Mechanism(Parameters()));
        QCOMPARE(found.outcome, Outcome::Identified);
        QVERIFY(hasLengths(found, 40.0, 120.0, 10.0));
        QVERIFY(!found.drive);
        QVERIFY(std::abs(found.parameters.omega2 - 10.0) < 0.01);
        QCOMPARE(found.excludedRows, std::vector<std::size_t>{22}); // line 1: the headings
    }

    void leavesOutFiniteDifferences()
    {
        const Identification velocity = identifyFile("difference_velocity");
        QVERIFY(hasLengths(velocity, 37.5, 150.0, 0.0));
        QVERIFY(leavesOut(velocity, kSliderVelocity, Reason::FiniteDifferences));
        QVERIFY(!determines(velocity, Parameter::Omega2));
        QCOMPARE(velocity.parameters.omega2, Parameters().omega2);

        const Identification both = identifyFile("central_differences");
        QVERIFY(hasLengths(both, 20.0, 60.0, -5.0));
        QVERIFY(leavesOut(both, kSliderVelocity, Reason::FiniteDifferences));
        QVERIFY(leavesOut(both, kSliderAcceleration, Reason::FiniteDifferences));
    }

    void findsAVelocityThatIsCountedTheOtherWay()
    {
        for (const Parameters &given : {Parameters(), Parameters{.b = 60.0, .c = 0.0, .omega2 = 10.0}}) {
            const Identification found = identifyFile("reversed_velocity", given);
            QCOMPARE(found.outcome, Outcome::Identified);
            QVERIFY(hasLengths(found, 20.0, 60.0, 0.0));
            QVERIFY(std::abs(std::abs(found.parameters.omega2) - 10.0) < 0.01);
            QVERIFY(found.parameters.omega2 < 0.0 || hasFinding(found, Sign, kSliderVelocity));
        }
    }

    /// The file agrees with the given mechanism, so that no length is to blame.
    void readsAScaleFromTheDeadCentre()
    {
        const Identification found = identifyFile("lab", {.a = 37.5, .b = 150.0, .c = 0.0});
        QVERIFY(found.hasMechanism());
        QVERIFY(hasFinding(found, Sign, kSlider));
        QVERIFY(hasFinding(found, ZeroPoint, kSlider));
        QVERIFY(found.agreesWithGiven);
        QVERIFY(!found.change);
    }

    void findsTheLengthsInSpiteOfARunUp()
    {
        const Identification found = identifyFile("run_up");
        QVERIFY(hasLengths(found, 20.0, 60.0, 25.0));
        QVERIFY(found.drive && found.drive->alpha2);
        QVERIFY(std::abs(*found.drive->alpha2 - 10.0) < 0.05);
        QVERIFY(std::abs(found.drive->omega2) < 0.05);
    }

    void findsTheLengthsInSpiteOfAnUnevenSpeed()
    {
        const Identification found = identifyFile("uneven_speed_with_theta2");
        QVERIFY(hasLengths(found, 20.0, 60.0, -5.0));
        QVERIFY(found.drive && !found.drive->alpha2);
        QVERIFY(found.drive->least < found.drive->greatest);
    }

    /// Rows without θ2 are left out, and the remaining rows are compared with the found and the given mechanism.
    void comparesAnUnevenCrankAlthoughRowsLackItsAngle()
    {
        std::string text = "t (s),theta2 (deg),R4_x (mm)\n";
        for (int i = 0; i <= 120; ++i) {
            const double time = 0.01 * i;
            const double angle = 6.0 * time + 0.25 * std::sin(6.0 * time);
            std::array<char, 80> line{};
            std::snprintf(line.data(), line.size(), "%.2f,%.3f,%.3f\n", time, angle / kDegree,
                          sliderPosition(40.0, 120.0, 20.0, angle));
            std::string row = line.data();
            if (i % 40 == 17) { // no θ2
                row.erase(row.find(',') + 1, row.rfind(',') - row.find(',') - 1);
            }
            text += row;
        }
        const Mechanism other(Parameters{.a = 40.0, .b = 65.0, .c = 20.0});
        const Identification found = identify(std::get<ReferenceData>(readReferenceData(text)), other);
        QCOMPARE(found.channels.size(), 1U);
        QCOMPARE(found.channels[0].verdict, Verdict::Agrees);
        QVERIFY(!found.agreesWithGiven);
    }

    /// c = -5 mm with θ3 counted clockwise explains the file, and so does the mirror image with θ2 counted clockwise.
    void namesNoMirrorImageThatNeedsAnotherReading()
    {
        const Identification found = identifyFile("mirror_alternative");
        const bool isMirrored = found.parameters.c > 0.0;
        QVERIFY(hasLengths(found, 20.0, 60.0, isMirrored ? 5.0 : -5.0));
        QCOMPARE(found.conventions.size(), 1U);
        QVERIFY(hasFinding(found, Sign, isMirrored ? Channel{Theta2, Order::Position} : kCoupler));
        QVERIFY(found.alternatives.empty());
    }

    void findsAnOriginBesideASmoothError()
    {
        const Identification found = identifyFile("nearest_without_origin");
        QCOMPARE(found.outcome, Outcome::Approximate);
        QVERIFY(hasFinding(found, ZeroPoint, kSlider));
        QCOMPARE(found.residuals.size(), 1U);
        QVERIFY(found.residuals[0].percentOfRange < 0.6);
    }

    /// A few hundred noisy rows cannot distinguish the given b = 65 mm from 65.8 mm, but all rows together can.
    void keepsTheLengthsOfManyRowsBesideNearlyEqualGivenOnes()
    {
        std::mt19937 random(5);
        const auto noise = [&random] { // a standard deviation of 0.5 mm, nearly normal
            double sum = -6.0;
            for (int i = 0; i < 12; ++i) {
                sum += static_cast<double>(random()) / static_cast<double>(std::mt19937::max());
            }
            return 0.5 * sum;
        };
        constexpr int kRows = 20000;
        std::string text = "theta2 (deg),x (mm)\n";
        for (int i = 0; i < kRows; ++i) {
            const double degrees = 720.0 * i / kRows;
            std::array<char, 80> line{};
            std::snprintf(line.data(), line.size(), "%.6f,%.4f\n", degrees,
                          sliderPosition(20.0, 65.8, 25.0, degrees * kDegree) + 30.0 + noise());
            text += line.data();
        }
        const Identification found =
            identify(std::get<ReferenceData>(readReferenceData(text)), Mechanism(Parameters{20.0, 65.0, 25.0}));
        const double error = found.standardErrors[indexOf(Parameter::B)];
        QVERIFY(found.hasMechanism() && error < 0.3);
        QVERIFY(std::abs(found.parameters.b - 65.8) < 4.0 * error);
    }

    void ignoresTheRotationOfTheSlider()
    {
        const Identification found = identifyFile("slider_rotation");
        QCOMPARE(found.outcome, Outcome::Identified);
        QVERIFY(hasLengths(found, 20.0, 60.0, 25.0));
    }

    void takesTimeStampsWithGapsAsExact()
    {
        const Identification found = identifyFile("gaps_lower_precision");
        QCOMPARE(found.outcome, Outcome::Identified);
        QVERIFY(found.standardErrors[indexOf(Parameter::B)] < 1e-3);
    }

    /// Time stamps every 0.025 s, rounded up to 0.01 s, leave the start of the clock uncertain by 2.5 ms.
    void statesTheErrorOfCoarseTimeStamps()
    {
        constexpr double kStart = 0.25; // rad
        constexpr double kSpeed = 6.25; // rad/s
        std::string text = "time (s),R4_x (mm),theta3 (deg)\n";
        for (int i = 0; i <= 100; ++i) {
            const double angle = kStart + kSpeed * 0.025 * i;
            const double coupler = std::asin((25.0 - 20.0 * std::sin(angle)) / 65.0);
            std::array<char, 80> line{};
            std::snprintf(line.data(), line.size(), "%.2f,%.3f,%.4f\n", 0.01 * std::ceil(2.5 * i),
                          sliderPosition(20.0, 65.0, 25.0, angle), coupler / kDegree);
            text += line.data();
        }
        const Identification found = identify(std::get<ReferenceData>(readReferenceData(text)), Mechanism());
        QVERIFY(hasLengths(found, 20.0, 65.0, 25.0));
        const double error = found.standardErrors[indexOf(Parameter::Theta20)];
        QVERIFY(std::abs(found.parameters.theta20 - kStart) < 3.0 * error && error < 0.03);
        const double errorOfSpeed = found.standardErrors[indexOf(Parameter::Omega2)];
        QVERIFY(std::abs(found.parameters.omega2 - kSpeed) < 3.0 * errorOfSpeed && errorOfSpeed < 0.01 * kSpeed);
    }

    /// A former defect: coarse time stamps leave the speed uncertain, and thus the length of the crank, which a
    /// velocity shows only as a product with the speed. The standard error of this length was too small.
    void statesTheErrorOfLengthsFromVelocitiesAtCoarseTimeStamps()
    {
        constexpr double kSpeed = 4.7124; // rad/s
        std::string text = "t [s],v [mm/s]\n";
        for (int i = 0; i <= 50; ++i) {
            const double angle = kSpeed * 0.0133 * i;
            const double x = sliderPosition(39.0, 120.0, 0.0, angle);
            const double v = -39.0 * kSpeed * std::sin(angle) * x / (x - 39.0 * std::cos(angle));
            std::array<char, 80> line{};
            std::snprintf(line.data(), line.size(), "%.2f,%.3f\n", 0.0133 * i, v);
            text += line.data();
        }
        const Identification found =
            identify(std::get<ReferenceData>(readReferenceData(text)), Mechanism(Parameters()));
        QCOMPARE(found.outcome, Outcome::Identified);
        QVERIFY(std::abs(found.parameters.a - 39.0) < 3.0 * found.standardErrors[indexOf(Parameter::A)]);
        QVERIFY(found.standardErrors[indexOf(Parameter::A)] < 0.01 * found.parameters.a);
    }

    void findsThatTheOffsetIsZero()
    {
        const Identification found = identifyFile("c_of_1e-12");
        QCOMPARE(found.outcome, Outcome::Identified);
        QCOMPARE(found.rounded.c, 0.0);
    }

    /// The file determines only a · ω2.
    void findsTheLengthsForTheGivenSpeedFromAVelocityOverTheAngle()
    {
        constexpr double kSpeed = 10.0; // rad/s
        constexpr double kDifferenceStep = 1e-6;
        const auto velocity = [](double degrees) {
            const double angle = degrees * kDegree;
            return kSpeed *
                   (sliderPosition(40.0, 140.0, 10.0, angle + kDifferenceStep) -
                    sliderPosition(40.0, 140.0, 10.0, angle - kDifferenceStep)) /
                   (2.0 * kDifferenceStep);
        };
        for (const double given : {kSpeed, 2.0 * kSpeed, -2.0 * kSpeed}) {
            const Identification found =
                identifyTable("theta2 (deg),R4_x_diff (mm/s)", 10.0, 37, velocity, {.omega2 = given});
            const double scale = kSpeed / std::abs(given);
            QCOMPARE(found.lengthScale, Identification::LengthScale::GivenSpeed);
            QVERIFY(hasLengths(found, 40.0 * scale, 140.0 * scale, 10.0 * scale));
            QVERIFY(!determines(found, Parameter::A) && !determines(found, Parameter::Omega2));
            QCOMPARE(found.parameters.omega2, given);
            QCOMPARE(found.conventions.size(), given < 0.0 ? 1U : 0U); // the velocity with the opposite sign
        }
    }

    void findsTheSpeedFromVelocityAndAccelerationOverTheAngle()
    {
        constexpr double kDifferenceStep = 1e-4;
        for (const double speed : {10.0, -10.0}) {
            std::string text = "theta2 (deg),v (mm/s),a (mm/s^2)\n";
            for (int i = 0; i <= 36; ++i) {
                const double angle = 10.0 * i * kDegree;
                const double before = sliderPosition(40.0, 140.0, 10.0, angle - kDifferenceStep);
                const double at = sliderPosition(40.0, 140.0, 10.0, angle);
                const double after = sliderPosition(40.0, 140.0, 10.0, angle + kDifferenceStep);
                const double velocity = speed * (after - before) / (2.0 * kDifferenceStep);
                const double acceleration =
                    speed * speed * (before - 2.0 * at + after) / (kDifferenceStep * kDifferenceStep);
                std::array<char, 80> line{};
                std::snprintf(line.data(), line.size(), "%d,%.2f,%.1f\n", 10 * i, velocity, acceleration);
                text += line.data();
            }
            const Identification found = identify(std::get<ReferenceData>(readReferenceData(text)), Mechanism());
            QCOMPARE(found.outcome, Outcome::Identified);
            QCOMPARE(found.lengthScale, Identification::LengthScale::Measured);
            QVERIFY(hasLengths(found, 40.0, 140.0, 10.0));
            QVERIFY(std::abs(found.parameters.omega2 - speed) < 0.01);
            QCOMPARE(found.conventions.size(), 0U);
        }
    }

    /// If a program writes angles in radians under headings without units, the rates of angles are in rad/s.
    void findsTheSpeedOfTablesInRadiansWithoutUnits()
    {
        constexpr double kSpeed = 6.0; // rad/s
        for (const bool isOverTime : {false, true}) {
            for (const std::string names : {"theta2,theta2_dot,theta3,x", "theta2,theta3,theta3_dot,x"}) {
                std::string text = (isOverTime ? "time," : "") + names + '\n';
                for (int i = 0; i <= 72; ++i) {
                    const double angle = 5.0 * i * kDegree;
                    const double sine = (20.0 - 40.0 * std::sin(angle)) / 120.0; // of θ3
                    const double rate = -40.0 * kSpeed * std::cos(angle) / (120.0 * std::sqrt(1.0 - sine * sine));
                    const bool hasSpeed = names.find("theta2_dot") != std::string::npos;
                    std::array<char, 160> line{};
                    std::snprintf(line.data(), line.size(), "%.8f,%.6f,%.6f,%.6f,%.4f\n", angle / kSpeed, angle,
                                  hasSpeed ? kSpeed : std::asin(sine), hasSpeed ? std::asin(sine) : rate,
                                  sliderPosition(40.0, 120.0, 20.0, angle));
                    const std::string row = line.data();
                    text += isOverTime ? row : row.substr(row.find(',') + 1);
                }
                const Identification found = identify(std::get<ReferenceData>(readReferenceData(text)), Mechanism());
                QCOMPARE(found.outcome, Outcome::Identified);
                QVERIFY(found.leftOut.empty() && hasLengths(found, 40.0, 120.0, 20.0));
                QVERIFY2(std::abs(found.parameters.omega2 - kSpeed) < 1e-3, names.c_str());
            }
        }
    }

    /// Difference quotients of the velocity resemble the acceleration of a slower crank.
    void takesNoSpeedFromDifferencesOfTheVelocityOverTheAngle()
    {
        constexpr double kSpeed = 10.0; // rad/s
        constexpr double kDifferenceStep = 1e-6;
        for (const int step : {2, 5, 10}) { // °; at 1°, the quotients equal the acceleration within their rounding
            const auto velocity = [](double degrees) {
                const double angle = degrees * kDegree;
                const double change = sliderPosition(40.0, 120.0, 20.0, angle + kDifferenceStep) -
                                      sliderPosition(40.0, 120.0, 20.0, angle - kDifferenceStep);
                return 0.01 * std::round(100.0 * kSpeed * change / (2.0 * kDifferenceStep));
            };
            std::string text = "theta2 (deg),v (mm/s),a (mm/s^2)\n";
            for (int degrees = 0; degrees <= 360; degrees += step) {
                const double quotient =
                    kSpeed * (velocity(degrees + step) - velocity(degrees - step)) / (2.0 * step * kDegree);
                std::array<char, 80> line{};
                std::snprintf(line.data(), line.size(), "%d,%.2f,%.1f\n", degrees, velocity(degrees), quotient);
                text += line.data();
            }
            const Identification found = identify(std::get<ReferenceData>(readReferenceData(text)), Mechanism());
            QCOMPARE(found.lengthScale, Identification::LengthScale::GivenSpeed);
            QCOMPARE(found.leftOut.size(), 1U);
            QCOMPARE(found.leftOut[0].reason, LeftOutColumn::Reason::FiniteDifferences);
        }
    }

    /// Difference quotients of the position resemble the velocity of a crank that is half a percent slower. No other
    /// unit explains them.
    void differencesBesideADerivativeLeaveTheSpeedClear()
    {
        constexpr double kSpeed = 10.0; // rad/s
        constexpr int kStep = 10;       // °
        const auto position = [](double degrees) {
            return 0.001 * std::round(1000.0 * sliderPosition(40.0, 120.0, 20.0, degrees * kDegree));
        };
        std::string text = "theta2 (deg),omega3 (rad/s),x (mm),v (mm/s)\n";
        for (int degrees = 0; degrees <= 360; degrees += kStep) {
            const double angle = degrees * kDegree;
            const double sine = (20.0 - 40.0 * std::sin(angle)) / 120.0; // of θ3
            const double couplerSpeed = -40.0 * kSpeed * std::cos(angle) / (120.0 * std::sqrt(1.0 - sine * sine));
            const double quotient =
                kSpeed * (position(degrees + kStep) - position(degrees - kStep)) / (2.0 * kStep * kDegree);
            std::array<char, 80> line{};
            std::snprintf(line.data(), line.size(), "%d,%.3f,%.3f,%.2f\n", degrees, couplerSpeed, position(degrees),
                          quotient);
            text += line.data();
        }
        const Identification found = identify(std::get<ReferenceData>(readReferenceData(text)), Mechanism());
        QVERIFY(hasLengths(found, 40.0, 120.0, 20.0));
        QVERIFY(found.possibleSpeeds.empty() && std::abs(found.parameters.omega2 - kSpeed) < 0.01);
        QCOMPARE(found.leftOut.size(), 1U);
        QCOMPARE(found.leftOut[0].reason, LeftOutColumn::Reason::FiniteDifferences);
    }

    /// Former defects: the quotients, whose values have more digits than the positions, decided about the geometry (a =
    /// 23.87 ± 0.003 mm for 25 mm, or no mechanism), or were used because their values have large steps, too.
    void differencesOverTheTimeDoNotChangeTheGeometry()
    {
        struct File {
            double a, b, c;           // mm
            int degrees;              // between rows
            int decimals;             // of x
            bool areOfPrintedNumbers; // whether the quotients are those of rounded positions
        };
        for (const File &file : {File{25.0, 82.5, 0.0, 30, 1, true}, File{60.0, 300.0, -6.0, 10, 2, false},
                                 File{20.0, 80.0, 0.0, 5, 2, true}, File{38.1, 152.4, -9.525, 5, 2, false},
                                 File{40.0, 120.0, 20.0, 15, 2, false}}) {
            const double start = sliderPosition(file.a, file.b, file.c, 0.0);
            const double perMillimetre = std::pow(10.0, file.decimals);
            const auto printed = [&](double degrees) { // from the start of the motion
                const double x = sliderPosition(file.a, file.b, file.c, degrees * kDegree) - start;
                return std::round(perMillimetre * x) / perMillimetre;
            };
            const auto position = [&](double degrees) {
                return file.areOfPrintedNumbers ? printed(degrees)
                                                : sliderPosition(file.a, file.b, file.c, degrees * kDegree);
            };
            std::string text = "t (s),x (mm),v (mm/s)\n";
            for (int degrees = 0; degrees <= 360; degrees += file.degrees) { // one turn per second
                const double quotient = 360.0 * (position(degrees + file.degrees) - position(degrees - file.degrees)) /
                                        (2.0 * file.degrees);
                std::array<char, 80> line{};
                std::snprintf(line.data(), line.size(), "%.6f,%.*f,%.3f\n", degrees / 360.0, file.decimals,
                              printed(degrees), quotient);
                text += line.data();
            }
            const Identification found = identify(std::get<ReferenceData>(readReferenceData(text)), Mechanism());
            QCOMPARE(found.outcome, Outcome::Identified);
            QVERIFY2(leavesOut(found, kSliderVelocity, Reason::FiniteDifferences), text.c_str());
            QVERIFY2(std::abs(found.parameters.a - file.a) < 5.0 * found.standardErrors[0], text.c_str());
        }
    }

    /// A former defect: over the time, θ3 at B and a displacement were taken for those of the crossed assembly, with
    /// the displacement in the opposite direction, as if a convention that is seldom used were simpler than a usual
    /// one.
    void aDisplacementBesideThetaAtBKeepsItsDirection()
    {
        for (const double origin : {30.0, 80.0, 150.0}) { // mm
            std::string text = "t (s),theta3 (deg),x (mm)\n";
            for (int degrees = 0; degrees <= 360; degrees += 10) { // one turn per second
                const double angle = degrees * kDegree;
                const double atB = 180.0 + std::asin((20.0 - 40.0 * std::sin(angle)) / 120.0) / kDegree;
                std::array<char, 80> line{};
                std::snprintf(line.data(), line.size(), "%.6f,%.2f,%.2f\n", degrees / 360.0, atB,
                              sliderPosition(40.0, 120.0, 20.0, angle) - origin);
                text += line.data();
            }
            const Identification found = identify(std::get<ReferenceData>(readReferenceData(text)), Mechanism());
            QVERIFY(hasLengths(found, 40.0, 120.0, 20.0));
            QCOMPARE(found.parameters.branch, Branch::Open);
            QVERIFY(hasFinding(found, HalfTurn, kCoupler));
            QVERIFY(!hasFinding(found, Sign, kSlider));
        }
    }

    /// A former defect: the irregular speed of a crank that is turned by hand was taken for errors of θ2 at a constant
    /// speed, although θ2 explains the positions exactly, and b was 18 % too small.
    void aCrankTurnedByHandHasAnUnevenSpeed()
    {
        std::mt19937 random(20241130);
        const auto between = [&](double least, double greatest) {
            return least + (greatest - least) * static_cast<double>(random()) / static_cast<double>(random.max());
        };
        for (const double noise : {0.0, 0.1}) { // mm
            double time = 0.0;
            std::string text = "t (s),theta2 (deg),x (mm)\n";
            for (int degrees = 0; degrees <= 360; degrees += 15) {
                std::array<char, 80> line{};
                const double x = sliderPosition(40.0, 160.0, 20.0, degrees * kDegree) + between(-noise, noise);
                std::snprintf(line.data(), line.size(), "%.3f,%d,%.3f\n", time, degrees, x - 100.0);
                text += line.data();
                time += 0.04 * between(0.7, 1.3);
            }
            const Identification found = identify(std::get<ReferenceData>(readReferenceData(text)), Mechanism());
            QCOMPARE(found.outcome, noise > 0.0 ? Outcome::Approximate : Outcome::Identified);
            QVERIFY2(hasLengths(found, 40.0, 160.0, 20.0, noise > 0.0 ? 0.03 : 1e-3), text.c_str());
            QVERIFY(found.drive && !found.drive->alpha2);
        }
    }

    /// A former defect: no mechanism was found, because second differences of positions with one decimal are so coarse
    /// that they agree with an acceleration as well as with quotients.
    void secondDifferencesOfCoarsePositionsAreNoAcceleration()
    {
        constexpr double kSpeed = 12.566; // rad/s
        constexpr int kStep = 10;         // °
        const auto printed = [](double degrees) {
            return std::round(10.0 * sliderPosition(30.0, 90.0, -3.0, degrees * kDegree)) / 10.0;
        };
        std::string text = "theta2 (deg),x (mm),a (mm/s^2)\n";
        for (int degrees = 0; degrees <= 360; degrees += kStep) {
            const double difference = printed(degrees + kStep) - 2.0 * printed(degrees) + printed(degrees - kStep);
            std::array<char, 80> line{};
            std::snprintf(line.data(), line.size(), "%d,%.1f,%.1f\n", degrees, printed(degrees),
                          difference * std::pow(kSpeed / (kStep * kDegree), 2.0));
            text += line.data();
        }
        const Identification found =
            identify(std::get<ReferenceData>(readReferenceData(text)), Mechanism({.omega2 = kSpeed}));
        QCOMPARE(found.outcome, Outcome::Identified);
        QVERIFY(hasLengths(found, 30.0, 90.0, -3.0, 0.02));
        QVERIFY(leavesOut(found, kSliderAcceleration, Reason::FiniteDifferences));
    }

    void roundsTheOriginOfTheAngleTogetherWithTheLengths()
    {
        const Identification found = identifyTable("crank angle (deg),x (mm)", 10.0, 37, [](double degrees) {
            return sliderPosition(40.0, 140.0, 10.0, (degrees + 90.0) * kDegree);
        });
        QCOMPARE(found.outcome, Outcome::Identified);
        QCOMPARE(found.conventions.size(), 1U);
        QCOMPARE(found.conventions[0].convention.amount, 90.0);
        QCOMPARE(found.rounded.a, 40.0);
        QCOMPARE(found.rounded.b, 140.0);
        QCOMPARE(found.rounded.c, 10.0);
    }

    void roundsTheLengthsTogetherWithTheOriginOfTheSlider()
    {
        const Identification found = identifyTable("crank angle (deg),x (mm)", 10.0, 37, [](double degrees) {
            return sliderPosition(37.5, 150.0, 12.0, degrees * kDegree) - 110.0;
        });
        QCOMPARE(found.outcome, Outcome::Identified);
        QCOMPARE(found.conventions.size(), 1U);
        QVERIFY(std::abs(found.conventions[0].convention.amount - 110.0) < 0.005);
        QCOMPARE(found.rounded.a, 37.5);
        QCOMPARE(found.rounded.b, 150.0);
        QCOMPARE(found.rounded.c, 12.0);
    }

    /// The mirror image of c = 0 has the same c, but its crank starts at -θ20 and not at 180° - θ20.
    void namesTheMirrorImageOfASliderOnTheAxis()
    {
        const Identification found = identifyTable("time (s),R4_x (mm)", 0.02, 61, [](double time) {
            return 250.0 - sliderPosition(50.0, 200.0, 0.0, kTurnPerSecond * time);
        });
        QCOMPARE(found.outcome, Outcome::Identified);
        QCOMPARE(found.parameters.c, 0.0);
        QCOMPARE(found.alternatives.size(), 1U);
        QCOMPARE(found.alternatives[0].symmetry, AlternativeMechanism::Symmetry::MirrorImage);
    }

    /// With the time in s, the velocities would agree with a crank that makes 20 turns from row to row.
    void takesAClockInMillisecondsForAnotherUnitAndNoFasterCrank()
    {
        constexpr double kDifferenceStep = 1e-6;
        const auto position = [](double time) { return sliderPosition(40.0, 140.0, 10.0, kTurnPerSecond * time); };
        std::string text = "t,x (mm),v (mm/s)\n";
        for (int i = 0; i < 61; ++i) {
            const double time = 0.02 * i;
            const double velocity =
                (position(time + kDifferenceStep) - position(time - kDifferenceStep)) / (2.0 * kDifferenceStep);
            std::array<char, 80> line{};
            std::snprintf(line.data(), line.size(), "%d,%.2f,%.1f\n", 20 * i, position(time), velocity);
            text += line.data();
        }
        const Identification found = identify(std::get<ReferenceData>(readReferenceData(text)), Mechanism());
        QCOMPARE(found.outcome, Outcome::Identified);
        QVERIFY(hasLengths(found, 40.0, 140.0, 10.0));
        QCOMPARE(found.conventions.size(), 1U);
    }

    /// The crank speeds up during half a turn, which looks like a different mechanism at constant speed.
    void claimsNothingFromAnArcThatNoMechanismExplainsExactly()
    {
        const Identification found = identifyTable("time (s),R4_x (mm)", 0.02, 61, [](double time) {
            return sliderPosition(30.0, 75.0, 20.0, 1.5 * time * time + time);
        });
        QCOMPARE(found.outcome, Outcome::Insufficient);
        QVERIFY(found.openParameters[indexOf(Parameter::B)]);
    }

    void findsTheCrossedAssemblyOrSaysWhatIsOpen()
    {
        const Identification found = identifyFile("crossed_part_of_a_turn");
        const bool isOpen = found.outcome == Outcome::Insufficient && found.lack != Identification::Lack::Nothing;
        QVERIFY(isOpen || hasLengths(found, 20.0, 65.0, found.parameters.c > 0.0 ? 25.0 : -25.0, 0.05));
    }
};

const Suite<TestOrdinaryFiles> suite("tst_ordinary_files");

} // namespace tst_ordinary_files

#include "tst_ordinary_files.moc"
