// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/suite.h"
#include "ui/panels/parameter_panel.h"
#include "ui/text/theme.h"
#include "ui/widgets/number_box.h"

#include "tests/support/waiting.h"
#include "tests/support/widget_parts.h"

#include <QAbstractButton>
#include <QComboBox>
#include <QLabel>
#include <QSignalSpy>
#include <QSlider>
#include <QTest>

#include <cmath>
#include <numbers>

using namespace slidercrank;

namespace
{

constexpr double kPi = std::numbers::pi;

struct Field {
    const char *key;
    double Parameters::*member;
};
constexpr Field kFields[] = {{"a", &Parameters::a},
                             {"b", &Parameters::b},
                             {"c", &Parameters::c},
                             {"omega2", &Parameters::omega2},
                             {"theta20", &Parameters::theta20}};

/// Every value differs from every default, so that the test finds exchanged parameters.
Parameters givenParameters()
{
    return {.a = 21.0, .b = 66.0, .c = -26.0, .omega2 = 3.0, .theta20 = 0.5, .branch = Branch::Crossed};
}

struct Shown {
    ParameterPanel panel;
    QSignalSpy edits{&panel, &ParameterPanel::edited};

    explicit Shown(const Parameters &parameters = givenParameters())
    {
        panel.setParameters(parameters);
        panel.resize(430, panel.sizeHint().height());
        panel.show();
    }

    template <typename Widget>
    Widget *part(const QString &name) const
    {
        return child<Widget>(panel, name);
    }
    /// Returns the parameters of the only edit since the last call.
    Parameters received()
    {
        const auto parameters = edits.isEmpty() ? Parameters() : edits.last()[0].value<Parameters>();
        const bool isOne = edits.count() == 1;
        edits.clear();
        return isOne ? parameters : Parameters{.a = -1.0};
    }
};

} // namespace

class TestParameterPanel : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void showsTheParametersWithoutEmittingThem()
    {
        const Shown shown;
        QVERIFY(shown.edits.isEmpty());
        for (const auto &[key, text] : {std::pair{"a", "21 mm"}, std::pair{"b", "66 mm"}, std::pair{"c", "-26 mm"},
                                        std::pair{"omega2", "3"}, std::pair{"theta20", "28.6479"}}) {
            QCOMPARE(shown.part<NumberBox>(QString("box_") + key)->text(), QString(text));
        }
    }

    void eachControlChangesItsOwnParameterOnly()
    {
        for (const auto &[key, member] : kFields) {
            Shown shown;
            auto *slider = shown.part<QSlider>(QString("slider_") + key);
            slider->setValue(slider->value() + 7);
            Parameters received = shown.received();
            QVERIFY2(received.*member > givenParameters().*member, key);
            received.*member = givenParameters().*member;
            QCOMPARE(received, givenParameters());
            typeNumber(shown.part<NumberBox>(QString("box_") + key), "12.5");
            received = shown.received();
            received.*member = givenParameters().*member;
            QCOMPARE(received, givenParameters());

            auto *reset = shown.part<QAbstractButton>(QString("reset_") + key);
            QVERIFY(reset->isEnabled());
            reset->click();
            QCOMPARE(shown.received().*member, Parameters().*member);
            QVERIFY(!reset->isEnabled());
        }
    }

    void reportsTheBeginAndEndOfADrag()
    {
        Shown shown;
        QSignalSpy began(&shown.panel, &ParameterPanel::dragBegan);
        QSignalSpy ended(&shown.panel, &ParameterPanel::dragEnded);
        auto *slider = shown.part<QSlider>("slider_b");
        connect(&shown.panel, &ParameterPanel::edited, this, [&began] { QCOMPARE(began.count(), 1); });
        QTest::mousePress(slider, Qt::LeftButton, {}, QPoint(slider->width() - 10, slider->height() / 2));
        QCOMPARE(shown.edits.count(), 1); // the handle moves to the click
        QTest::mouseRelease(slider, Qt::LeftButton, {}, QPoint(slider->width() - 10, slider->height() / 2));
        QCOMPARE(ended.count(), 1);
    }

    void storesNumbersExactlyAndConvertsUnitsExactly()
    {
        Parameters exact = givenParameters();
        exact.b = 60.12345678901234;
        exact.omega2 = std::nextafter(1.0 / 3.0, 1.0);
        exact.theta20 = 0.1234567890123456;
        Shown given(exact);
        for (const char *name : {"box_omega2", "box_theta20", "box_b"}) {
            given.part<NumberBox>(name)->setFocus();
            QTest::keyClick(given.part<NumberBox>(name), Qt::Key_Return);
        }
        typeNumber(given.part<NumberBox>("box_a"), "25");
        exact.a = 25.0;
        QVERIFY(given.received() == exact);
        struct Row {
            Parameter parameter;
            int shownUnit;
            const char *typed;
            double value; ///< rad/s, rad
        };
        for (const Row &row : {Row{Parameter::Omega2, 0, "60 rpm", 2.0 * kPi}, Row{Parameter::Omega2, 2, "120", 4.0 * kPi},
                               Row{Parameter::Omega2, 1, "360", 2.0 * kPi}, Row{Parameter::Omega2, 2, "4 rad/s", 4.0},
                               Row{Parameter::Omega2, 2, "−90 °/s", -kPi / 2.0}, Row{Parameter::Theta20, 0, "90", kPi / 2.0},
                               Row{Parameter::Theta20, 1, "30 deg", kPi / 6.0}, Row{Parameter::Theta20, 0, "0.25rad", 0.25}}) {
            Shown shown;
            const QString key = row.parameter == Parameter::Omega2 ? "omega2" : "theta20";
            shown.part<QComboBox>("unit_" + key)->setCurrentIndex(row.shownUnit);
            QVERIFY(shown.edits.isEmpty()); // another unit does not change the number
            typeNumber(shown.part<NumberBox>("box_" + key), QString::fromUtf8(row.typed));
            QVERIFY2(std::abs(valueOf(shown.received(), row.parameter) / row.value - 1.0) <= 1e-15, row.typed);
        }
        for (const int degrees : {370, 10, 123, -725}) {
            Shown shown;
            auto *box = shown.part<NumberBox>("box_theta20");
            typeNumber(box, QString::number(degrees));
            shown.panel.setParameters(shown.received());
            QCOMPARE(box->text(), QString::number(degrees));
        }
    }

    void adaptsTheSliderRangeToTheMechanism()
    {
        Shown shown{Parameters()};
        auto *slider = shown.part<QSlider>("slider_b");
        const int usual = slider->maximum();
        shown.panel.setParameters({.b = 5000.0});
        QVERIFY(slider->value() < slider->maximum());
        shown.panel.setParameters({});
        QCOMPARE(slider->maximum(), usual);
        shown.panel.setParameters({.a = 0.02, .b = 0.065, .c = 0.025}); // a slider of 200 mm would be of no use
        QVERIFY(slider->value() > slider->maximum() / 10);
    }

    void shadesTheLengthsWithoutAFullTurn()
    {
        struct Row {
            double b;
            const char *slider;
            QList<double> clear; ///< parts of the length of the slider
            QList<double> shaded;
            const char *tip;
        };
        for (const Row &row :
             {Row{65.0, "a", {0.1, 0.38}, {0.42, 0.9}, "a ≤ 40 mm"},
              Row{65.0, "b", {0.24, 0.9}, {0.05, 0.21}, "b ≥ 45 mm"},
              Row{65.0, "c", {0.29, 0.5, 0.71}, {0.1, 0.26, 0.74, 0.9}, "-45 ≤ c ≤ 45 mm"},
              Row{65.0, "omega2", {0.1, 0.9}, {}, ""}, Row{15.0, "a", {}, {0.05, 0.5, 0.9}, "no value of a"},
              Row{15.0, "c", {}, {0.1, 0.5, 0.9}, "no value of c"}}) {
            for (const Theme theme : {Theme::Light, Theme::Dark}) {
                Shown shown({.b = row.b});
                shown.panel.setPalette(paletteFor(theme));
                auto *slider = shown.part<QSlider>(QString("slider_") + row.slider);
                const QImage image = slider->grab().toImage();
                const QColor plain = shown.panel.palette().color(QPalette::Window);
                const auto isShaded = [&](double part) {
                    constexpr int kHandle = 13;
                    const int x = kHandle / 2 + static_cast<int>(part * (image.width() - kHandle));
                    const QColor there = image.pixelColor(x, image.height() / 2 + 4); // below the groove
                    return std::abs(there.red() - plain.red()) + std::abs(there.blue() - plain.blue()) > 40;
                };
                for (const double part : row.clear) {
                    QVERIFY2(!isShaded(part), row.slider);
                }
                for (const double part : row.shaded) {
                    QVERIFY2(isShaded(part), row.slider);
                }
                QVERIFY2(slider->toolTip().contains(QString::fromUtf8(row.tip)), qPrintable(slider->toolTip()));
            }
        }
    }

    void requestsTheResponseOnAClickOnAName()
    {
        const Shown shown;
        QSignalSpy asked(&shown.panel, &ParameterPanel::responseRequested);
        for (QLabel *label : shown.panel.findChildren<QLabel *>()) {
            QTest::mouseClick(label, Qt::LeftButton);
        }
        QCOMPARE(asked.size(), 4); // nothing depends on θ₂₀
        QCOMPARE(asked[1][0].value<Parameter>(), Parameter::B);
    }

    void showsOneParameterWhileBrief()
    {
        Shown shown;
        shown.panel.setBrief(true);
        QVERIFY(shown.part<QWidget>("box_b")->isVisible() && !shown.part<QWidget>("box_a")->isVisible());
        shown.part<QComboBox>("parameterBox")->setCurrentIndex(2);
        QVERIFY(shown.part<QWidget>("box_c")->isVisible() && !shown.part<QWidget>("box_b")->isVisible());
        shown.panel.setBrief(false);
        QVERIFY(shown.part<QWidget>("box_a")->isVisible() && !shown.part<QWidget>("parameterBox")->isVisible());
    }
};

const Suite suite("tst_parameter_panel", runWithWidgets<TestParameterPanel>);
#include "tst_parameter_panel.moc"
