// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/suite.h"
#include "ui/text/expression.h"

#include <QTest>

#include <cmath>

using namespace slidercrank;

namespace tst_expression
{

class TestExpression : public QObject
{
    Q_OBJECT

private slots:
    void computesWhatPeopleType()
    {
        constexpr double kPi = std::numbers::pi;
        struct Row {
            const char *text;
            Unit unit;
            double value;
        };
        for (const Row &row : {Row{"2*pi", kRadianPerSecond, 2.0 * kPi},
                               Row{"2π", kRadianPerSecond, 2.0 * kPi},
                               Row{"2 pi rad/s", kRadianPerSecond, 2.0 * kPi},
                               Row{"60*2pi/60", kRadianPerSecond, 2.0 * kPi},
                               Row{"1/2π", kRadianPerSecond, 0.5 / kPi},
                               Row{"1/2*π", kRadianPerSecond, 0.5 * kPi},
                               Row{"2*π rad/s", kRadianPerSecond, 2.0 * kPi},
                               Row{"40*1.2", kMillimetre, 48.0},
                               Row{"1/2 in", kMillimetre, 12.7},
                               Row{"(3+4)/2 cm", kMillimetre, 35.0},
                               Row{"−3·2", kMillimetre, -6.0},
                               Row{"1e2/4", kMillimetre, 25.0},
                               Row{"PI/6", kRadian, kPi / 6.0},
                               Row{"2-3-4", kMillimetre, -5.0},
                               Row{"8/2/2", kMillimetre, 2.0},
                               Row{"2+3*4", kMillimetre, 14.0},
                               Row{"-(1+2)", kMillimetre, -3.0},
                               Row{"60 rpm", kRadianPerSecond, 2.0 * kPi},
                               Row{"1.5·10⁻⁸", kMillimetre, 1.5e-8},
                               Row{"20/3", kMillimetre, 20.0 / 3.0},
                               Row{"6 1/2 in", kMillimetre, 165.1},
                               Row{"-6 1/2 in", kMillimetre, -165.1},
                               Row{"2*(3 11/64)", kMillimetre, 6.34375},
                               Row{"1 200/50", kMillimetre, 24.0},
                               Row{"1 200 / 500", kMillimetre, 2.4}}) {
            const Quantity quantity = readExpression(QString::fromUtf8(row.text), row.unit, QLocale::c());
            QVERIFY2(std::abs(quantity.value - row.value) <= 1e-15 * std::abs(row.value), row.text);
        }
        const QLocale spanish(QLocale::Spanish, QLocale::Colombia);
        QCOMPARE(readExpression("1,5*2", kMillimetre, spanish).value, 3.0);
    }

    void refusesWhatIsNoExpression()
    {
        for (const char *text : {"", "2*", "*2", "pi pi", "1/0", "2**3", "(1", "1)", "a*b", "2*3*", "1..2*3", "p*2",
                                 "2 5*3", "2pi pi", "pi2", "6 1/2 1/2", "1. 5*2"}) {
            QVERIFY2(readExpression(QString::fromUtf8(text), kMillimetre, QLocale::c()).fault, text);
        }
        QCOMPARE(readExpression("2*3 s", kMillimetre, QLocale::c()).fault, QuantityFault::WrongUnit);
        QCOMPARE(readExpression("3 miles", kMillimetre, QLocale::c()).fault, QuantityFault::UnknownUnit);
        QVERIFY(readExpression(QString(5000, u'('), kMillimetre, QLocale::c()).fault);
        QVERIFY(readExpression(QString(5000, u'-') + "1*2", kMillimetre, QLocale::c()).fault);
    }
};

const Suite<TestExpression> suite("tst_expression");

} // namespace tst_expression

#include "tst_expression.moc"
