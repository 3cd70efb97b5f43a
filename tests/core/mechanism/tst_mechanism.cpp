// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mechanism/channel.h"
#include "core/mechanism/mechanism.h"
#include "core/study/cases.h"

#include <QTest>

#include <limits>
#include <set>

using namespace slidercrank;

namespace
{

constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinite = std::numeric_limits<double>::infinity();

} // namespace

Q_DECLARE_METATYPE(slidercrank::Parameter)
Q_DECLARE_METATYPE(std::optional<slidercrank::ParameterFault::Reason>)

class tst_mechanism : public QObject
{
    Q_OBJECT

private slots:
    void defaultsAreTable1();
    void findsTheFault_data();
    void findsTheFault();
    void namesTheFirstOfSeveralFaults();
    void namedCasesAreMechanismsWithNamesOfTheirOwn();
    void namedCasesLookWhereTheCouplerIsSquare();
    void namesAreThoseOfTheAuthorsFiles();
    void namesAndIndicesComeBack();
    void refusesOtherNames_data();
    void refusesOtherNames();
    void indicesAreInTheOrderOfSolve();
    void unitsAreThoseOfTheAuthor();
    void setsHoldTheirChannels();
    void naturalSizeFollowsLengthAndSpeed();
};

void tst_mechanism::defaultsAreTable1()
{
    const Mechanism mechanism;
    QCOMPARE(mechanism.a(), 20.0);
    QCOMPARE(mechanism.b(), 65.0);
    QCOMPARE(mechanism.c(), 25.0);
    QCOMPARE(mechanism.omega2(), 2.0 * std::numbers::pi);
    QCOMPARE(mechanism.theta20(), 0.0);
    QCOMPARE(mechanism.branch(), Branch::Open);
    QVERIFY(!findFault({}));
    QVERIFY(mechanism == Mechanism(Parameters{}));
}

void tst_mechanism::findsTheFault_data()
{
    using Reason = ParameterFault::Reason;
    using MaybeReason = std::optional<Reason>;
    QTest::addColumn<Parameter>("parameter");
    QTest::addColumn<double>("value");
    QTest::addColumn<MaybeReason>("reason");

    const std::pair<Parameter, const char *> parameters[] = {{Parameter::A, "a"},
                                                             {Parameter::B, "b"},
                                                             {Parameter::C, "c"},
                                                             {Parameter::Omega2, "omega2"},
                                                             {Parameter::Theta20, "theta20"}};
    const double beyond = std::nextafter(kLargestParameter, kInfinite);
    for (const auto &[parameter, name] : parameters) {
        const bool length = parameter == Parameter::A || parameter == Parameter::B;
        const MaybeReason notPositive = length ? MaybeReason(Reason::NotPositive) : std::nullopt;
        QTest::addRow("%s = nan", name) << parameter << kNotANumber << MaybeReason(Reason::NotFinite);
        QTest::addRow("%s = inf", name) << parameter << kInfinite << MaybeReason(Reason::NotFinite);
        QTest::addRow("%s = -inf", name) << parameter << -kInfinite << MaybeReason(Reason::NotFinite);
        QTest::addRow("%s > 1e12", name) << parameter << beyond << MaybeReason(Reason::TooLarge);
        QTest::addRow("%s < -1e12", name) << parameter << -beyond << MaybeReason(Reason::TooLarge);
        QTest::addRow("%s = 1e12", name) << parameter << kLargestParameter << MaybeReason();
        QTest::addRow("%s = 0", name) << parameter << 0.0 << notPositive;
        QTest::addRow("%s = -0", name) << parameter << -0.0 << notPositive;
        QTest::addRow("%s = -1", name) << parameter << -1.0 << notPositive;
        QTest::addRow("%s = 1e-12", name) << parameter << 1e-12 << MaybeReason();
    }
}

void tst_mechanism::findsTheFault()
{
    QFETCH(Parameter, parameter);
    QFETCH(double, value);
    QFETCH(std::optional<ParameterFault::Reason>, reason);
    Parameters parameters;
    valueOf(parameters, parameter) = value;
    const std::optional<ParameterFault> fault = findFault(parameters);
    QCOMPARE(fault.has_value(), reason.has_value());
    if (fault) {
        QVERIFY(fault->parameter == parameter);
        QVERIFY(fault->reason == *reason);
    }
}

void tst_mechanism::namesTheFirstOfSeveralFaults()
{
    Parameters parameters;
    parameters.b = -1.0;
    parameters.theta20 = kNotANumber;
    const std::optional<ParameterFault> fault = findFault(parameters);
    QVERIFY(fault);
    QVERIFY(fault->parameter == Parameter::B);
    QVERIFY(fault->reason == ParameterFault::Reason::NotPositive);
}

void tst_mechanism::namedCasesAreMechanismsWithNamesOfTheirOwn()
{
    std::set<std::string_view> names;
    const std::vector<Case> cases = allCases();
    QCOMPARE(cases.size(), nominalCases().size() + hardCases().size());
    for (const Case &which : cases) {
        const std::string name(which.name);
        QVERIFY2(!findFault(which.parameters), name.c_str());
        QVERIFY2(names.insert(which.name).second, name.c_str());
        const std::vector<double> instants = instantsOf(which);
        QVERIFY2(instants.size() > std::size_t(which.sampling.steps), name.c_str());
        QVERIFY2(std::is_sorted(instants.begin(), instants.end()), name.c_str());
        QVERIFY2(instants.front() >= which.sampling.start, name.c_str());
        QVERIFY2(instants.back() <= which.sampling.start + which.sampling.duration, name.c_str());
    }
}

/// cos θ2 = 0, or the height of B above A is b.
void tst_mechanism::namedCasesLookWhereTheCouplerIsSquare()
{
    for (const Case &which : allCases()) {
        const Parameters &p = which.parameters;
        const std::vector<double> instants = squareInstants(which);
        QVERIFY2(!instants.empty() || p.omega2 == 0.0, std::string(which.name).c_str());
        for (const double t : instants) {
            const double theta2 = p.omega2 * t + p.theta20;
            const double tolerance = 1e-15 * (8.0 + std::abs(theta2)); // rad
            const double height = std::abs(p.c - p.a * std::sin(theta2));
            QVERIFY2(std::abs(std::cos(theta2)) < tolerance || std::abs(height - p.b) < tolerance * (p.a + p.b),
                     std::string(which.name).c_str());
        }
    }
}

void tst_mechanism::namesAreThoseOfTheAuthorsFiles()
{
    QCOMPARE(nameOf({R1x, Order::Position}), "R1_x");
    QCOMPARE(nameOf({Theta3, Order::Position}), "theta3");
    QCOMPARE(nameOf({Theta3, Order::Velocity}), "theta3_diff");
    QCOMPARE(nameOf({R4x, Order::Acceleration}), "R4_x_diff2");
    QCOMPARE(nameOf({R4y, Order::Velocity}), "R4_y_diff");
    QCOMPARE(nameOf({Theta4, Order::Acceleration}), "theta4_diff2");
}

void tst_mechanism::namesAndIndicesComeBack()
{
    std::set<std::string_view> names;
    for (std::size_t index = 0; index < kChannelCount; ++index) {
        const Channel channel = channelAt(index);
        QCOMPARE(indexOf(channel), index);
        QVERIFY(channelNamed(nameOf(channel)) == channel);
        QVERIFY(names.insert(nameOf(channel)).second);
    }
}

void tst_mechanism::refusesOtherNames_data()
{
    QTest::addColumn<QByteArray>("name");
    for (const char *name : {"", "time", "theta", "Theta3", "theta3 ", "theta3_diff3", "R5_x", "R4_x_diff2x", "R4x"}) {
        QTest::addRow("\"%s\"", name) << QByteArray(name);
    }
}

void tst_mechanism::refusesOtherNames()
{
    QFETCH(QByteArray, name);
    QVERIFY(!channelNamed(std::string_view(name.constData(), std::size_t(name.size()))));
}

/// All of q, then q̇, then q̈; each body x, y, θ.
void tst_mechanism::indicesAreInTheOrderOfSolve()
{
    QCOMPARE(indexOf({R1x, Order::Position}), std::size_t(0));
    QCOMPARE(indexOf({Theta2, Order::Position}), std::size_t(5));
    QCOMPARE(indexOf({Theta4, Order::Position}), std::size_t(11));
    QCOMPARE(indexOf({R1x, Order::Velocity}), std::size_t(12));
    QCOMPARE(indexOf({R4x, Order::Acceleration}), std::size_t(33));
    std::size_t index = 0;
    for (const char *derivative : {"", "_diff", "_diff2"}) {
        for (const char *body : {"1", "2", "3", "4"}) {
            const std::string r = std::string("R") + body;
            for (const std::string &name : {r + "_x", r + "_y", std::string("theta") + body}) {
                QCOMPARE(std::string(nameOf(channelAt(index))), name + derivative);
                ++index;
            }
        }
    }
    QCOMPARE(index, kChannelCount);
}

void tst_mechanism::unitsAreThoseOfTheAuthor()
{
    QCOMPARE(fileUnit({R4x, Order::Position}), "mm");
    QCOMPARE(fileUnit({R4x, Order::Velocity}), "mm/s");
    QCOMPARE(fileUnit({R4x, Order::Acceleration}), "mm/s\u00b2");
    QCOMPARE(fileUnit({Theta3, Order::Position}), "\u00b0");
    QCOMPARE(fileUnit({Theta3, Order::Velocity}), "\u00b0/s");
    QCOMPARE(fileUnit({Theta3, Order::Acceleration}), "\u00b0/s\u00b2");
    for (std::size_t index = 0; index < kChannelCount; ++index) {
        const Channel channel = channelAt(index);
        const bool angle = nameOf(channel).starts_with("theta");
        QCOMPARE(isAngle(channel.coordinate), angle);
        QCOMPARE(toFileUnit(channel, std::numbers::pi), angle ? 180.0 : std::numbers::pi);
    }
}

void tst_mechanism::setsHoldTheirChannels()
{
    QCOMPARE(allChannels().count(), kChannelCount);
    QCOMPARE(plottedChannels().count(), std::size_t(6));
    for (const char *name : {"theta3", "theta3_diff", "theta3_diff2", "R4_x", "R4_x_diff", "R4_x_diff2"}) {
        QVERIFY(plottedChannels().test(indexOf(*channelNamed(name))));
    }
}

void tst_mechanism::naturalSizeFollowsLengthAndSpeed()
{
    const Parameters parameters{.c = -25.0, .omega2 = -3.0};
    QCOMPARE(naturalSize(parameters, {R4x, Order::Position}), 110.0);
    QCOMPARE(naturalSize(parameters, {R4x, Order::Velocity}), 330.0);
    QCOMPARE(naturalSize(parameters, {R1y, Order::Acceleration}), 990.0);
    QCOMPARE(naturalSize(parameters, {Theta3, Order::Position}), 1.0);
    QCOMPARE(naturalSize(parameters, {Theta4, Order::Acceleration}), 9.0);
}

QTEST_APPLESS_MAIN(tst_mechanism)
#include "tst_mechanism.moc"
