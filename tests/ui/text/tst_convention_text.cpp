// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/channels.h"
#include "tests/support/suite.h"
#include "ui/text/convention_text.h"

#include <QLocale>
#include <QTest>

using namespace slidercrank;

namespace tst_convention_text
{

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
        };
        const Row rows[] = {
            {{AngleUnit, {kTheta3}, kDegreesPerRadian}, "theta3: in radians, but read as degrees."},
            {{AngleUnit, {kTheta3}, 1.0 / kDegreesPerRadian}, "theta3: in degrees, but read as radians."},
            {{LengthUnit, {kSlider, kSliderSpeed}, 1000.0}, "R4_x and R4_x_diff: in metres, but read as millimetres."},
            {{LengthUnit, {kSlider}, 1.0 / 25.4}, "R4_x: in millimetres, but read as inches."},
            {{LengthUnit, {kSlider}, 0.1}, "R4_x: in millimetres, but read as centimetres."},
            {{LengthUnit, {kSlider}, 1.0 / 304.8}, "R4_x: in millimetres, but read as feet."},
            {{LengthUnit, {kSlider}, 1.0 / 914.4}, "R4_x: in millimetres, but read in a different unit."},
            {{TimeUnit, {kSliderSpeed}, 0.001}, "The time is in milliseconds, but read as seconds."},
            {{TimeUnit, {kSliderSpeed}, 1e6}, "The time is in seconds, but read as microseconds."},
            {{TimeUnit, {kSliderSpeed}, 1.0 / 60.0}, "The time is in seconds, but read as minutes."},
            {{TimeUnit, {kSliderSpeed}, 1e9}, "The time is in seconds, but read in a different unit."},
            {{Sign, {kTheta3}, -1.0}, "theta3: with the opposite sign."},
            {{HalfTurn, {kTheta3}, -180.0},
             "theta3: the angle of the coupler seen from B, as textbooks draw θ₃; θ³ = value in the file − 180°."},
            {{HalfTurn, {kTheta2}, -180.0},
             "theta2: measured from the opposite direction; θ₂ = value in the file − 180°."},
            {{WholeTurns, {kTheta2}, 360.0}, "theta2: off by whole turns; θ₂ = value in the file + 360°."},
            {{WholeTurns, {kTheta3}, 0.0}, "theta3: jumps by whole turns."},
            {{ZeroPoint, {kSlider}, -5.0},
             "R4_x: measured from a different origin; the zero of the file is at Rₓ⁴ = −5 mm."},
            {{ZeroPoint, {kTheta3}, 22.5},
             "theta3: measured from a different origin; the zero of the file is at θ³ = 22.5°."},
            {{SwappedColumns, {kTheta3, kSlider}, 1.0}, "theta3 and R4_x: the headings are swapped."},
            {{Axis, {{R4y, Order::Position}}, 1.0}, "The slider moves along y instead of x, as in an upright engine."},
            {{OtherAssembly, {}, 1.0},
             "The mechanism that produced the file has the other assembly: its slider is on the other side of A."},
            {{TimeShift, {}, -0.25}, "The time stamps are shifted: t = time in the file − 0.25 s."},
        };
        for (const auto &[convention, explanation] : rows) {
            QCOMPARE(explanationText(convention), QString::fromUtf8(explanation));
            QCOMPARE(findingText({convention, 98.25, 0.00076543}),
                     QString::fromUtf8(explanation) + " Largest error: 98.3 → 0.000765 % of peak.");
        }
    }

    void eachKindHasANameInFiles()
    {
        using Kind = Convention::Kind;
        const std::pair<Kind, const char *> names[] = {
            {Kind::AngleUnit, "angle-unit"},         {Kind::LengthUnit, "length-unit"},
            {Kind::TimeUnit, "time-unit"},           {Kind::Sign, "sign"},
            {Kind::HalfTurn, "half-turn"},           {Kind::WholeTurns, "whole-turns"},
            {Kind::ZeroPoint, "zero-point"},         {Kind::SwappedColumns, "swapped-columns"},
            {Kind::OtherAssembly, "branch"},         {Kind::TimeShift, "time-shift"},
            {Kind::NotDerivative, "not-derivative"}, {Kind::Axis, "axis"}};
        for (const auto &[kind, name] : names) {
            QCOMPARE(conventionName(kind), name);
            QCOMPARE(conventionNamed(name), std::optional(kind));
        }
        QCOMPARE(conventionNamed("another"), std::nullopt);
    }

    void statesTheUnitOfTheAmount()
    {
        using enum Convention::Kind;
        QCOMPARE(amountUnit({Sign, {kTheta3}, -1.0}), std::optional(QString()));
        QCOMPARE(amountUnit({HalfTurn, {kTheta3}, 180.0}), std::optional(QString("°")));
        QCOMPARE(amountUnit({TimeShift, {}, 0.1}), std::optional(QString("s")));
        QCOMPARE(amountUnit({ZeroPoint, {kSlider}, 5.0}), std::optional(QString("mm")));
        QCOMPARE(amountUnit({OtherAssembly, {}, 1.0}), std::nullopt);
    }

    /// The factors between units that the identification uses.
    void namesTheUnitsOfEachFactor()
    {
        const std::pair<Convention::Kind, std::span<const double>> kinds[] = {
            {Convention::Kind::AngleUnit, kAngleUnits},
            {Convention::Kind::LengthUnit, kLengthUnits},
            {Convention::Kind::TimeUnit, kTimeUnits}};
        for (const auto &[kind, factors] : kinds) {
            for (const double factor : factors.subspan(1)) { // the first one is 1
                QVERIFY(explanationText({kind, {kTheta3}, factor}).contains(", but read as "));
            }
        }
    }

    void leavesOutWhatIsNoDerivative()
    {
        const Convention none{Convention::Kind::NotDerivative, {kSliderSpeed}, 1.0};
        QCOMPARE(findingText({none, 98.25, 0.0}),
                 QString("R4_x_diff: not the time derivative of the position column."));

        FileLayout layout;
        QCOMPARE(finiteDifferenceSentence(layout), QString());
        layout.columns = {{.channel = kSlider}, {.channel = kSliderSpeed, .difference = Difference::Forward}};
        QCOMPARE(finiteDifferenceSentence(layout), QString("R4_x_diff: finite differences, not the time derivative."));
    }
};

const Suite<TestConventionText> suite("tst_convention_text");

} // namespace tst_convention_text

#include "tst_convention_text.moc"
