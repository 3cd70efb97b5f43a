// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mechanism/channel.h"
#include "core/mechanism/enum_table.h"
#include "core/mechanism/mechanism.h"
#include "core/mechanism/turn.h"
#include "core/study/cases.h"
#include "tests/support/all_cases.h"
#include "tests/support/suite.h"

#include <QTest>

#include <cmath>
#include <iterator>
#include <set>

using namespace slidercrank;

namespace tst_mechanism
{

class TestMechanism : public QObject
{
    Q_OBJECT

private slots:
    void defaultsAreTable1()
    {
        QVERIFY(Mechanism().parameters() == (Parameters{20.0, 65.0, 25.0, 2.0 * std::numbers::pi, 0.0, Branch::Open}));
        QVERIFY(!findFault({}));
    }

    void findsTheFirstFault()
    {
        using Reason = ParameterFault::Reason;
        for (const Parameter parameter :
             {Parameter::A, Parameter::B, Parameter::C, Parameter::Omega2, Parameter::Theta20}) {
            const bool isLink = parameter == Parameter::A || parameter == Parameter::B;
            const auto ofLink = [isLink](Reason reason) { return isLink ? std::optional(reason) : std::nullopt; };
            struct Row {
                double value;
                std::optional<Reason> reason;
            };
            for (const auto &[value, reason] :
                 {Row{kNone, Reason::NotFinite}, Row{kInfinity, Reason::NotFinite}, Row{-kInfinity, Reason::NotFinite},
                  Row{std::nextafter(1e12, kInfinity), Reason::TooLarge},
                  Row{-std::nextafter(1e12, kInfinity), Reason::TooLarge}, Row{1e12, std::nullopt},
                  Row{-1.0, ofLink(Reason::NotPositive)}, Row{-0.0, ofLink(Reason::NotPositive)},
                  Row{std::nextafter(1e-9, 0.0), ofLink(Reason::TooShort)}, Row{1e-9, std::nullopt}}) {
                Parameters parameters;
                parameters.theta20 =
                    parameter == Parameter::Theta20 || !reason ? 0.0 : kNone; // a second fault, in a later parameter
                valueOf(parameters, parameter) = value;
                const std::optional<ParameterFault> fault = findFault(parameters);
                QCOMPARE(fault.has_value(), reason.has_value());
                QVERIFY(!fault || (fault->parameter == parameter && fault->reason == *reason));
            }
        }
    }

    /// Also checks that at perpendicularTimes() cos θ2 = 0, or the height of B above A is b.
    void namedCasesAreMechanisms()
    {
        std::set<std::string_view> names;
        const std::vector<Case> cases = allCases();
        QCOMPARE(cases.size(), nominalCases().size() + hardCases().size());
        for (const Case &namedCase : cases) {
            const Parameters &p = namedCase.parameters;
            const std::string name(namedCase.name);
            QVERIFY2(!findFault(p) && names.insert(namedCase.name).second, name.c_str());
            const std::vector<double> times = timeStampsOf(namedCase);
            QVERIFY2(times.size() > std::size_t(namedCase.sampling.steps) && std::ranges::is_sorted(times),
                     name.c_str());
            QVERIFY2(times.front() >= namedCase.sampling.start, name.c_str());
            QVERIFY2(times.back() <= namedCase.sampling.start + namedCase.sampling.duration, name.c_str());
            QVERIFY2(!perpendicularTimes(namedCase).empty() || p.omega2 == 0.0, name.c_str());
            for (const double t : perpendicularTimes(namedCase)) {
                const double theta2 = p.omega2 * t + p.theta20;
                const double tolerance = 1e-15 * (8.0 + std::abs(theta2)); // rad
                const double height = std::abs(p.c - p.a * std::sin(theta2));
                QVERIFY2(std::abs(std::cos(theta2)) < tolerance || std::abs(height - p.b) < tolerance * (p.a + p.b),
                         name.c_str());
            }
        }
    }

    /// The channels are numbered in the order of q, q̇ and q̈, each with x, y and θ of each body.
    void channelsHaveTheNamesAndUnitsOfFiles()
    {
        struct Derivative {
            const char *ending;
            const char *unit;
        };
        std::size_t index = 0;
        for (const auto &[ending, unit] :
             {Derivative{"", ""}, Derivative{"_diff", "/s"}, Derivative{"_diff2", "/s²"}}) {
            for (const char *body : {"1", "2", "3", "4"}) {
                const std::string r = std::string("R") + body;
                for (const std::string &name : {r + "_x", r + "_y", std::string("theta") + body}) {
                    const Channel channel = channelAt(index);
                    const bool angle = name[0] == 't';
                    QCOMPARE(indexOf(channel), index);
                    QCOMPARE(std::string(nameOf(channel)), name + ending);
                    QVERIFY(channelNamed(name + ending) == channel);
                    QCOMPARE(std::string(fileUnit(channel)), std::string(angle ? "°" : "mm") + unit);
                    QCOMPARE(toFileUnit(channel, std::numbers::pi), angle ? 180.0 : std::numbers::pi);
                    const bool isPlotted = name == "theta3" || name == "R4_x";
                    QCOMPARE(plottedChannels().test(index), isPlotted);
                    ++index;
                }
            }
        }
        QCOMPARE(index, kChannelCount);
        QCOMPARE(allChannels().count(), kChannelCount);
        for (const char *name :
             {"", "time", "theta", "Theta3", "theta3 ", "theta3_diff3", "R5_x", "R4_x_diff2x", "R4x"}) {
            QVERIFY2(!channelNamed(name), name);
        }
    }

    void naturalSizeFollowsLengthAndSpeed()
    {
        const Parameters parameters{.c = -25.0, .omega2 = -3.0};
        QCOMPARE(naturalSize(parameters, {R4x, Order::Position}), 110.0);
        QCOMPARE(naturalSize(parameters, {R4x, Order::Velocity}), 330.0);
        QCOMPARE(naturalSize(parameters, {R1y, Order::Acceleration}), 990.0);
        QCOMPARE(naturalSize(parameters, {Theta3, Order::Position}), 1.0);
        QCOMPARE(naturalSize(parameters, {Theta4, Order::Acceleration}), 9.0);
    }

    void wrapsAnglesIntoOneTurn()
    {
        for (int halfTurns = -2000; halfTurns <= 2000; ++halfTurns) {
            const double middle = halfTurns * std::numbers::pi;
            for (const double angle : {std::nextafter(middle, -kInfinity), middle, std::nextafter(middle, kInfinity)}) {
                const double wrapped = wrapToPi(angle);
                const double positive = wrapToTwoPi(angle);
                QVERIFY2(wrapped >= -std::numbers::pi && wrapped < std::numbers::pi,
                         qPrintable(QString::number(angle)));
                QVERIFY2(positive >= 0.0 && positive < kTurn, qPrintable(QString::number(angle)));
                QVERIFY(std::abs(std::remainder(wrapped - angle, kTurn)) < 1e-12 * (1.0 + std::abs(angle)));
                QVERIFY(std::abs(std::remainder(positive - angle, kTurn)) < 1e-12 * (1.0 + std::abs(angle)));
            }
        }
        QVERIFY(std::isnan(wrapToPi(kNone)) && std::isnan(wrapToTwoPi(kInfinity)));
    }

    /// A former defect: the motion at such an angle ended the program, or was that of an impossible parameter.
    void aCrankMayHaveMadeVeryManyTurns()
    {
        constexpr double kAngle = 3.0 * kLargestParameter; // rad
        const Mechanism mechanism = withCrankAt(Mechanism(Parameters()), kAngle);
        QVERIFY(!findFault(mechanism.parameters()));
        const double spacing = std::nextafter(kAngle, kInfinity) - kAngle; // of the doubles near this angle
        QVERIFY(std::abs(std::remainder(mechanism.theta20() - kAngle, kTurn)) < spacing);
        QCOMPARE(withCrankAt(mechanism, 7.0).theta20(), 7.0);
    }

    void tablesHaveARowForEachEnumerator()
    {
        struct OrderRow {
            Order key;
        };
        static constexpr OrderRow kComplete[] = {{Order::Position}, {Order::Velocity}, {Order::Acceleration}};
        static constexpr OrderRow kShort[] = {{Order::Position}, {Order::Velocity}};
        static constexpr OrderRow kExchanged[] = {{Order::Velocity}, {Order::Position}, {Order::Acceleration}};
        static_assert(isCompleteTable(kComplete, Order::Acceleration));
        static_assert(!isCompleteTable(kShort, Order::Velocity), "an enumerator follows the last row");
        static_assert(!isCompleteTable(kShort, Order::Acceleration), "the last row is missing");
        static_assert(!isCompleteTable(kExchanged, Order::Acceleration));
        static_assert(hasRowForEachUpTo(kShort, Order::Velocity));
        static_assert(enumeratorCount<Order::Acceleration>() == std::size(kComplete));
        QVERIFY(rowOf(kComplete, Order::Velocity).key == Order::Velocity);
    }
};

const Suite<TestMechanism> suite("tst_mechanism");

} // namespace tst_mechanism

#include "tst_mechanism.moc"
