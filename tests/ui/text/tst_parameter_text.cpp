// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/suite.h"
#include "ui/text/parameter_text.h"

#include <QLocale>
#include <QTest>

#include <numbers>

using namespace slidercrank;

namespace tst_parameter_text
{

class TestParameterText : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void writesAMechanismWithUnits()
    {
        Parameters parameters;
        parameters.theta20 = -std::numbers::pi / 6.0;
        parameters.branch = Branch::Crossed;
        QCOMPARE(mechanismText(Mechanism(parameters)),
                 QString("a = 20 mm, b = 65 mm, c = 25 mm, ω₂ = 6.28319 rad/s, θ₂₀ = −30°, crossed assembly"));
    }

    void namesAPinnedMechanismByWhatDiffers()
    {
        const Parameters present;
        Parameters pinned;
        QCOMPARE(pinnedText(pinned, present), QString("pinned"));
        pinned.b = 80.0;
        QCOMPARE(pinnedText(pinned, present), QString("b = 80 mm"));
        pinned.theta20 = 1.0;
        pinned.branch = Branch::Crossed;
        QCOMPARE(pinnedText(pinned, present), QString("b = 80 mm, θ₂₀ = 57.2958°, crossed assembly"));
        QCOMPARE(pinnedText(present, pinned), QString("b = 65 mm, θ₂₀ = 0°, open assembly"));
    }
};

const Suite<TestParameterText> suite("tst_parameter_text");

} // namespace tst_parameter_text

#include "tst_parameter_text.moc"
