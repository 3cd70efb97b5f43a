// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/session.h"
#include "ui/panels/parameter_panel.h"
#include "ui/text/parameter_text.h"
#include "ui/text/theme.h"
#include "ui/widgets/number_box.h"

#include "tests/support/suite.h"
#include "tests/support/waiting.h"
#include "tests/support/widget_parts.h"

#include <QAbstractButton>
#include <QComboBox>
#include <QSlider>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace slidercrank;

namespace tst_parameter_panel
{

constexpr double kPi = std::numbers::pi;

/// Every value differs from every default, so that the test finds exchanged parameters.
Parameters givenParameters()
{
    return {.a = 21.0, .b = 66.0, .c = -26.0, .omega2 = 3.0, .theta20 = 0.5, .branch = Branch::Crossed};
}

struct ShownParameters {
    Session session;
    ParameterPanel panel{&session};

    explicit ShownParameters(const Parameters &parameters = givenParameters())
    {
        session.setParameters(parameters);
        session.endDrag(); // what follows is a new undo step
        panel.resize(430, panel.sizeHint().height());
        panel.show();
    }

    template <typename Widget>
    Widget *part(const char *kind, Parameter parameter) const
    {
        return child<Widget>(panel, QLatin1String(kind) + u'_' + QLatin1String(optionName(parameter)));
    }
    NumberBox *box(Parameter parameter) const { return part<NumberBox>("box", parameter); }
};

class TestParameterPanel : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void eachControlChangesItsOwnParameterOnly()
    {
        const QStringList texts{"21 mm", "66 mm", "−26 mm", "3", "28.6479"};
        for (const Parameter parameter : kAllParameters) {
            ShownParameters shown;
            QCOMPARE(shown.box(parameter)->text(), texts[static_cast<int>(parameter)]);
            const auto isOnlyChange = [&] {
                Parameters changed = shown.session.parameters();
                valueOf(changed, parameter) = valueOf(givenParameters(), parameter);
                return changed == givenParameters();
            };
            auto *slider = shown.part<QSlider>("slider", parameter);
            slider->setValue(slider->value() + 7);
            QVERIFY(valueOf(shown.session.parameters(), parameter) > valueOf(givenParameters(), parameter));
            QVERIFY(isOnlyChange());
            typeNumber(shown.box(parameter), "12.5");
            QVERIFY(isOnlyChange());
            auto *reset = shown.part<QAbstractButton>("reset", parameter);
            QVERIFY(reset->isEnabled());
            reset->click();
            QCOMPARE(valueOf(shown.session.parameters(), parameter), valueOf(Parameters(), parameter));
            QVERIFY(!reset->isEnabled());
        }
    }

    void storesNumbersExactlyAndConvertsUnitsExactly()
    {
        Parameters exact = givenParameters();
        exact.b = 60.12345678901234;
        exact.omega2 = std::nextafter(1.0 / 3.0, 1.0);
        exact.theta20 = 0.1234567890123456;
        const ShownParameters given(exact);
        for (const Parameter parameter : {Parameter::Omega2, Parameter::Theta20, Parameter::B}) {
            given.box(parameter)->setFocus();
            QTest::keyClick(given.box(parameter), Qt::Key_Return);
        }
        typeNumber(given.box(Parameter::A), "25");
        exact.a = 25.0;
        QVERIFY(given.session.parameters() == exact);
        struct Row {
            Parameter parameter;
            int shownUnit;
            const char *typed;
            double value; ///< rad/s, rad
        };
        for (const Row &row :
             {Row{Parameter::Omega2, 0, "60 rpm", 2.0 * kPi}, Row{Parameter::Omega2, 2, "120", 4.0 * kPi},
              Row{Parameter::Omega2, 1, "360", 2.0 * kPi}, Row{Parameter::Omega2, 2, "4 rad/s", 4.0},
              Row{Parameter::Omega2, 2, "−90 °/s", -kPi / 2.0}, Row{Parameter::Theta20, 0, "90", kPi / 2.0},
              Row{Parameter::Theta20, 1, "30 deg", kPi / 6.0}, Row{Parameter::Theta20, 0, "0.25rad", 0.25}}) {
            const ShownParameters shown;
            shown.part<QComboBox>("unit", row.parameter)->setCurrentIndex(row.shownUnit);
            QCOMPARE(shown.session.parameters(), givenParameters()); // a different unit does not change the number
            typeNumber(shown.box(row.parameter), QString::fromUtf8(row.typed));
            QVERIFY2(std::abs(valueOf(shown.session.parameters(), row.parameter) / row.value - 1.0) <= 1e-15,
                     row.typed);
        }
        for (const char *degrees : {"370", "10", "123", "-725"}) {
            const ShownParameters shown;
            typeNumber(shown.box(Parameter::Theta20), degrees);
            QCOMPARE(shown.box(Parameter::Theta20)->text(), QString(degrees).replace(u'-', u'−'));
        }
    }

    void adaptsTheSliderRangeToTheMechanism()
    {
        ShownParameters shown{Parameters()};
        auto *slider = shown.part<QSlider>("slider", Parameter::B);
        const int usual = slider->maximum();
        shown.session.setParameters({.b = 5000.0});
        QVERIFY(slider->value() < slider->maximum());
        shown.session.setParameters({});
        QCOMPARE(slider->maximum(), usual);
        shown.session.setParameters({.a = 0.02, .b = 0.065, .c = 0.025}); // a slider of 200 mm would be of no use
        QVERIFY(slider->value() > slider->maximum() / 10);
    }

    void shadesTheLengthsWithoutAFullTurn()
    {
        struct Row {
            double b;
            Parameter parameter;
            QList<double> clear; ///< parts of the length of the slider
            QList<double> shaded;
            const char *tip;
        };
        for (const Row &row : {Row{65.0, Parameter::A, {0.1, 0.38}, {0.42, 0.9}, "a ≤ 40 mm"},
                               Row{65.0, Parameter::B, {0.24, 0.9}, {0.05, 0.21}, "b ≥ 45 mm"},
                               Row{65.0, Parameter::C, {0.29, 0.5, 0.71}, {0.1, 0.26, 0.74, 0.9}, "−45 mm ≤ c ≤ 45 mm"},
                               Row{65.0, Parameter::Omega2, {0.1, 0.9}, {}, ""},
                               Row{15.0, Parameter::A, {}, {0.05, 0.5, 0.9}, "no value of a"},
                               Row{15.0, Parameter::C, {}, {0.1, 0.5, 0.9}, "no value of c"}}) {
            for (const Theme theme : {Theme::Light, Theme::Dark}) {
                ShownParameters shown({.b = row.b});
                shown.panel.setPalette(paletteFor(theme));
                auto *slider = shown.part<QSlider>("slider", row.parameter);
                const QImage image = slider->grab().toImage();
                const QColor plain = shown.panel.palette().color(QPalette::Window);
                const auto isShaded = [&](double part) {
                    constexpr int kHandle = 13;
                    const int x = kHandle / 2 + static_cast<int>(part * (image.width() - kHandle));
                    const QColor there = image.pixelColor(x, image.height() / 2 + 4); // below the groove
                    return std::abs(there.red() - plain.red()) + std::abs(there.blue() - plain.blue()) > 40;
                };
                QVERIFY2(std::ranges::none_of(row.clear, isShaded), row.tip);
                QVERIFY2(std::ranges::all_of(row.shaded, isShaded), row.tip);
                QVERIFY2(slider->toolTip().contains(QString::fromUtf8(row.tip)), qPrintable(slider->toolTip()));
            }
        }
    }
};

const Suite<TestParameterPanel> suite("tst_parameter_panel");

} // namespace tst_parameter_panel

#include "tst_parameter_panel.moc"
