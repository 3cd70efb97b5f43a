// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/suite.h"
#include "ui/text/convention_text.h"

#include <QLocale>
#include <QTest>

#include <cmath>

using namespace slidercrank;

namespace
{

constexpr Channel kTheta2{Theta2, Order::Position};
constexpr Channel kTheta3{Theta3, Order::Position};
constexpr Channel kSlider{R4x, Order::Position};
constexpr Channel kSliderSpeed{R4x, Order::Velocity};

} // namespace

class TestConventionText : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void explainsConventions()
    {
        using enum Convention::Kind;
        struct Row {
            Convention convention;
            const char *explanation;
            const char *action;
        };
        const Row rows[] = {
            {{AngleUnit, {kTheta3}, kDegreesPerRadian},
             "theta3: in radians, but read as degrees.",
             "Multiplies theta3 by 57.2958"},
            {{AngleUnit, {kTheta3}, 1.0 / kDegreesPerRadian},
             "theta3: in degrees, but read as radians.",
             "Multiplies theta3 by 0.0174533"},
            {{LengthUnit, {kSlider, kSliderSpeed}, 1000.0},
             "R4_x and R4_x_diff: in metres, but read as millimetres.",
             "Multiplies R4_x and R4_x_diff by 1000"},
            {{LengthUnit, {kSlider}, 1.0 / 2.54},
             "R4_x: in centimetres, but read as inches.",
             "Multiplies R4_x by 0.393701"},
            {{LengthUnit, {kSlider}, 304.8},
             "R4_x: in a unit of length 304.8 times as large as the one read.",
             "Multiplies R4_x by 304.8"},
            {{TimeUnit, {kSliderSpeed}, 0.001},
             "The time is in milliseconds, but read as seconds.",
             "Multiplies the time stamps by 0.001, and converts derivatives"},
            {{TimeUnit, {}, 0.5},
             "The unit of time is 0.5 times as large as the one read.",
             "Multiplies the time stamps by 0.5, and converts derivatives"},
            {{Sign, {kTheta3}, -1.0}, "theta3: with the opposite sign.", "Changes the sign of theta3"},
            {{HalfTurn, {kTheta3}, -180.0},
             "theta3: the angle of the coupler seen from B, as textbooks draw θ₃; θ³ is theta3 − 180°.",
             "Adds -180° to theta3, made continuous"},
            {{HalfTurn, {kTheta2}, -180.0},
             "theta2: measured from the opposite direction; θ₂ is theta2 − 180°.",
             "Adds -180° to theta2, made continuous"},
            {{WholeTurns, {kTheta2}, 360.0},
             "theta2: off by whole turns; θ₂ is theta2 + 360°.",
             "Adds 360° to theta2, made continuous"},
            {{WholeTurns, {kTheta3}, 0.0}, "theta3: jumps by whole turns.", "Makes theta3 continuous"},
            {{ZeroPoint, {kSlider}, -5.0},
             "R4_x: measured from another origin; Rₓ⁴ is R4_x − 5 mm.",
             "Adds -5 mm to R4_x"},
            {{ZeroPoint, {kTheta3}, 22.5},
             "theta3: measured from another origin; θ³ is theta3 + 22.5°.",
             "Adds 22.5° to theta3"},
            {{SwappedColumns, {kTheta3, kSlider}, 1.0},
             "theta3 and R4_x: each has the heading of the other.",
             "Exchanges theta3 and R4_x"},
            {{Axis, {{R4y, Order::Position}}, 1.0},
             "The slider moves along y instead of x, as in an upright engine.",
             "Turns R4_y by 90°, so that y becomes x"},
            {{Branch, {}, 1.0},
             "The file belongs to the other assembly: its slider is on the other side of A.",
             "Sets the model to the other assembly"},
            {{TimeShift, {}, -0.25},
             "The time stamps of the file are shifted by 0.25 s.",
             "Adds -0.25 s to the time stamps"},
        };
        for (const auto &[convention, explanation, action] : rows) {
            QVERIFY(!conventionName(convention).isEmpty());
            QCOMPARE(explanationText(convention, {}), QString::fromUtf8(explanation));
            QCOMPARE(effectText({convention, 98.25, 0.00076543}),
                     QString::fromUtf8(action) + ": largest error 0.000765 % of peak instead of 98.3 %.");
        }
    }

    void leavesOutWhatIsNoDerivative()
    {
        const Convention none{Convention::Kind::NotDerivative, {kSliderSpeed}, 1.0};
        QCOMPARE(explanationText(none, {}), QString("R4_x_diff: not the time derivative of the position column."));
        QCOMPARE(effectText({none, 98.25, 0.0}), QString("Leaves R4_x_diff out: its largest error is 98.3 % of peak."));

        // Differences are named, whether or not they are a finding.
        ReferenceData data;
        for (int i = 0; i < 40; ++i) {
            data.time.push_back(0.01 * i);
        }
        data.series = {{kSlider, {}, {}}, {kSliderSpeed, {}, {}}};
        for (const double t : data.time) {
            data.series[0].values.push_back(std::sin(9.0 * t));
            data.series[1].values.push_back((std::sin(9.0 * (t + 0.01)) - std::sin(9.0 * t)) / 0.01);
        }
        const QString sentence = "R4_x_diff: forward differences, not the time derivative.";
        QCOMPARE(explanationText(none, data), sentence);
        QCOMPARE(differenceSentences(data, {}), QStringList{sentence});
        QCOMPARE(differenceSentences(data, std::vector<ConventionFinding>{{none, 5.0, 0.0}}), QStringList());
    }
};

const Suite suite("tst_convention_text", runWithEventLoop<TestConventionText>);
#include "tst_convention_text.moc"
