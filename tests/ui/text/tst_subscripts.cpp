// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/suite.h"
#include "ui/text/subscripts.h"

#include <QTest>

using namespace slidercrank;

namespace tst_subscripts
{

class TestSubscripts : public QObject
{
    Q_OBJECT

private slots:
    void writesSubscriptsAndNoOtherTags()
    {
        QCOMPARE(subscriptHtml("v_BA [mm/s]"), QString("v<sub>BA</sub> [mm/s]"));
        QCOMPARE(subscriptHtml("−R_y³ + a_Aⁿ"), QString("−R<sub>y</sub>³ + a<sub>A</sub>ⁿ"));
        QCOMPARE(subscriptHtml("a < b & c"), QString("a &lt; b &amp; c"));
    }

    void sentencesShowTheSymbolsOfTextbooksWithSubscripts()
    {
        QCOMPARE(symbolHtml("Left out: v_B and v_Ax (a < b)."),
                 QString("Left out: v<sub>B</sub> and v<sub>Ax</sub> (a &lt; b)."));
        QCOMPARE(symbolHtml("R_y⁴\nx_B"), QString("R<sub>y</sub>⁴<br>x<sub>B</sub>"));
        for (const char *plain : {"R4_x: with the opposite sign.", "slider_speed, max_Bx", "a < b\nand a_1"}) {
            QCOMPARE(symbolHtml(plain), QString(plain));
        }
    }
};

const Suite<TestSubscripts> suite("tst_subscripts");

} // namespace tst_subscripts

#include "tst_subscripts.moc"
