// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/channels.h"
#include "tests/support/suite.h"
#include "ui/text/channel_text.h"

#include <QLocale>
#include <QSet>
#include <QTest>

using namespace slidercrank;

namespace tst_channel_text
{

class TestChannelText : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void namesEachChannelInWordsAndBySymbol()
    {
        struct Row {
            Channel channel;
            const char *symbol;
            const char *quantity;
            const char *unit;
        };
        const Row rows[] = {
            {kTheta3, "θ³", "coupler angle", "°"},
            {{Theta3, Order::Acceleration}, "α³", "coupler angular acceleration", "°/s²"},
            {{Theta2, Order::Position}, "θ₂", "crank angle", "°"}, // as in the controls
            {{Theta2, Order::Velocity}, "ω₂", "crank angular velocity", "°/s"},
            {{R4x, Order::Position}, "Rₓ⁴", "slider position", "mm"},
            {{R4x, Order::Velocity}, "v⁴", "slider velocity", "mm/s"},
            {{R4x, Order::Acceleration}, "a⁴", "slider acceleration", "mm/s²"},
            {{R3x, Order::Position}, "Rₓ³", "coupler centre in x", "mm"},
            {{R4y, Order::Velocity}, "v_y⁴", "slider centre's velocity in y", "mm/s"},
        };
        for (const auto &[channel, symbol, quantity, unit] : rows) {
            QCOMPARE(symbolText(channel), QString::fromUtf8(symbol));
            QCOMPARE(quantityName(channel), QString::fromUtf8(quantity));
            QCOMPARE(unitText(channel), QString::fromUtf8(unit));
        }
        QCOMPARE(columnName({R4x, Order::Velocity}), QString("R4_x_diff"));
        QSet<QString> quantities;
        QSet<QString> symbols;
        for (std::size_t i = 0; i < kChannelCount; ++i) {
            quantities.insert(quantityName(channelAt(i)));
            symbols.insert(symbolText(channelAt(i)));
        }
        QCOMPARE(quantities.size(), qsizetype(kChannelCount));
        QCOMPARE(symbols.size(), qsizetype(kChannelCount));
    }
};

const Suite<TestChannelText> suite("tst_channel_text");

} // namespace tst_channel_text

#include "tst_channel_text.moc"
