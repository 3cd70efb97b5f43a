// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/convention_text.h"

#include <QLocale>
#include <QTest>

#include <cmath>

using namespace slidercrank;

namespace
{

constexpr Channel kTheta3{Theta3, Order::Position};
constexpr Channel kSlider{R4x, Order::Position};
constexpr Channel kSliderSpeed{R4x, Order::Velocity};

} // namespace

class TestConventionText : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void explainsConventions_data()
    {
        QTest::addColumn<Convention>("convention");
        QTest::addColumn<QString>("explanation");
        QTest::addColumn<QString>("action");
        using Kind = Convention::Kind;
        QTest::newRow("radians") << Convention{Kind::AngleUnit, {kTheta3}, kDegreesPerRadian}
                                 << "theta3: in radians, but read as degrees."
                                 << "Multiplies theta3 by 57.2958";
        QTest::newRow("degrees") << Convention{Kind::AngleUnit, {kTheta3}, 1.0 / kDegreesPerRadian}
                                 << "theta3: in degrees, but read as radians."
                                 << "Multiplies theta3 by 0.0174533";
        QTest::newRow("metres") << Convention{Kind::LengthUnit, {kSlider, kSliderSpeed}, 1000.0}
                                << "R4_x and R4_x_diff: in metres, but read as millimetres."
                                << "Multiplies R4_x and R4_x_diff by 1000";
        QTest::newRow("feet") << Convention{Kind::LengthUnit, {kSlider}, 304.8}
                              << "R4_x: in a unit of length 304.8 times as large as the one read."
                              << "Multiplies R4_x by 304.8";
        QTest::newRow("milliseconds") << Convention{Kind::TimeUnit, {kSliderSpeed}, 0.001}
                                      << "The time is in milliseconds, but was read as seconds; so are the derivatives "
                                         "R4_x_diff."
                                      << "Multiplies the instants by 0.001, and brings R4_x_diff to the same unit";
        QTest::newRow("sense of rotation")
            << Convention{Kind::Sign, {kTheta3}, -1.0} << "theta3: measured clockwise, against the sense of the model."
            << "Changes the sign of theta3";
        QTest::newRow("axis") << Convention{Kind::Sign, {kSlider}, -1.0}
                              << "R4_x: along an axis that points the other way."
                              << "Changes the sign of R4_x";
        QTest::newRow("textbook's angle") << Convention{Kind::HalfTurn, {kTheta3}, -180.0}
                                          << "theta3: the coupler's angle seen from B, as textbooks draw θ₃; θ³ is "
                                             "theta3 − 180°."
                                          << "Adds -180° to theta3, made continuous";
        QTest::newRow("the crank's angle, half a turn off")
            << Convention{Kind::HalfTurn, {{Theta2, Order::Position}}, -180.0}
            << "theta2: measured from the opposite direction; θ₂ is theta2 − 180°."
            << "Adds -180° to theta2, made continuous";
        QTest::newRow("the crank's angle, whole turns off")
            << Convention{Kind::WholeTurns, {{Theta2, Order::Position}}, 360.0}
            << "theta2: off by whole turns; θ₂ is theta2 + 360°."
            << "Adds 360° to theta2, made continuous";
        QTest::newRow("whole turns") << Convention{Kind::WholeTurns, {kTheta3}, 360.0}
                                     << "theta3: off by whole turns; θ³ is theta3 + 360°."
                                     << "Adds 360° to theta3, made continuous";
        QTest::newRow("jumps") << Convention{Kind::WholeTurns, {kTheta3}, 0.0} << "theta3: jumps by whole turns."
                               << "Makes theta3 continuous";
        QTest::newRow("origin to the left") << Convention{Kind::ZeroPoint, {kSlider}, -5.0}
                                            << "R4_x: measured from another origin, 5 mm to the left of O₂."
                                            << "Subtracts 5 mm from R4_x";
        QTest::newRow("origin to the right") << Convention{Kind::ZeroPoint, {kSlider}, 74.5436}
                                             << "R4_x: measured from another origin, 74.5436 mm to the right of O₂."
                                             << "Adds 74.5436 mm to R4_x";
        QTest::newRow("origin below") << Convention{Kind::ZeroPoint, {{R4y, Order::Position}}, -25.0}
                                      << "R4_y: measured from another origin, 25 mm below O₂."
                                      << "Subtracts 25 mm from R4_y";
        QTest::newRow("another direction") << Convention{Kind::ZeroPoint, {kTheta3}, 22.5}
                                           << "theta3: measured from another direction; θ³ is theta3 + 22.5°."
                                           << "Adds 22.5° to theta3";
        QTest::newRow("swapped") << Convention{Kind::SwappedColumns, {kTheta3, kSlider}, 1.0}
                                 << "theta3 and R4_x: each has the other's name."
                                 << "Exchanges theta3 and R4_x";
        QTest::newRow("along y") << Convention{Kind::Axis, {{R4y, Order::Position}}, 1.0}
                                 << "The slider moves along y and not along x: y is its axis, as in an upright engine."
                                 << "Turns R4_y by 90°, so that y becomes x";
        QTest::newRow("assembly") << Convention{Kind::Branch, {}, 1.0}
                                  << "The file is of the other assembly: its slider is on the other side of A."
                                  << "Sets the model to the other assembly";
        QTest::newRow("late") << Convention{Kind::TimeShift, {}, -0.25}
                              << "The file's clock is 0.25 s ahead: what it has at t happens that much earlier."
                              << "Adds -0.25 s to the instants";
    }

    void explainsConventions()
    {
        QFETCH(Convention, convention);
        QFETCH(QString, explanation);
        QFETCH(QString, action);
        QVERIFY(!nameOf(convention).isEmpty());
        QCOMPARE(explanationOf(convention, {}), explanation);
        QCOMPARE(effectOf({convention, 98.25, 0.00076543}),
                 action + ": largest error 0.000765 % of peak instead of 98.3 %.");
    }

    void saysThatAColumnIsCountedFromWhereItBegan()
    {
        ReferenceData data;
        data.series = {{kSlider, {0.0, -1.5, -3.0}, {}}, {kTheta3, {kNone, 0.0, 1.5}, {}}};
        QCOMPARE(explanationOf({Convention::Kind::ZeroPoint, {kSlider}, 74.5436}, data),
                 QString("R4_x: measured from where it began, 74.5436 mm to the right of O₂."));
        const Convention angle{Convention::Kind::ZeroPoint, {kTheta3}, -22.5};
        QCOMPARE(explanationOf(angle, data), // a gap is no beginning
                 QString("theta3: measured from another direction; θ³ is theta3 − 22.5°."));
        data.series[1].values.front() = 0.0;
        QCOMPARE(explanationOf(angle, data), QString("theta3: measured from where it began; θ³ is theta3 − 22.5°."));
    }

    void leavesOutWhatIsNoDerivative()
    {
        const Convention none{Convention::Kind::NotDerivative, {kSliderSpeed}, 1.0};
        QCOMPARE(explanationOf(none, {}), QString("R4_x_diff: not the time derivative of its position column."));
        QCOMPARE(effectOf({none, 98.25, 0.0}), QString("Leaves R4_x_diff out: its largest error is 98.3 % of peak."));

        // Of differences it says that they are, whether or not they are a finding.
        ReferenceData data;
        for (int i = 0; i < 40; ++i) {
            data.time.push_back(0.01 * i);
        }
        data.series = {{kSlider, {}, {}}, {kSliderSpeed, {}, {}}};
        for (const double t : data.time) {
            data.series[0].values.push_back(std::sin(9.0 * t));
            data.series[1].values.push_back((std::sin(9.0 * (t + 0.01)) - std::sin(9.0 * t)) / 0.01);
        }
        const QString sentence =
            "R4_x_diff: forward differences, from each row to the next, and not the time derivative.";
        QCOMPARE(explanationOf(none, data), sentence);
        QCOMPARE(differenceSentences(data, {}), QStringList{sentence});
        const std::vector<ConventionFinding> found{{none, 5.0, 0.0}};
        QCOMPARE(differenceSentences(data, found), QStringList());
    }
};

QTEST_GUILESS_MAIN(TestConventionText)
#include "tst_convention_text.moc"
