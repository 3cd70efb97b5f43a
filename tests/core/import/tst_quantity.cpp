// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/import/quantity.h"

#include <QTest>

#include <cmath>
#include <numbers>

using namespace slidercrank;

Q_DECLARE_METATYPE(slidercrank::Unit)
Q_DECLARE_METATYPE(slidercrank::QuantityFault)

namespace
{

Quantity read(const QString &text, const std::optional<Unit> &wanted)
{
    const QByteArray bytes = text.toUtf8();
    return readQuantity({bytes.constData(), static_cast<std::size_t>(bytes.size())}, wanted);
}

} // namespace

class TestQuantity : public QObject
{
    Q_OBJECT

private slots:
    void readsWhatPeopleWrite_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<Unit>("wanted");
        QTest::addColumn<double>("value");
        const double pi = std::numbers::pi;
        QTest::newRow("a number alone") << "25" << kMillimetre << 25.0;
        QTest::newRow("as displayed") << "25 mm" << kMillimetre << 25.0;
        QTest::newRow("every digit") << "60.123456789012345 mm" << kMillimetre << 60.123456789012345;
        QTest::newRow("centimetres") << "2.5cm" << kMillimetre << 25.0;
        QTest::newRow("metres, no binary tail") << "4.35m" << kMillimetre << 4350.0;
        QTest::newRow("an inch") << "1 in" << kMillimetre << 25.4;
        QTest::newRow("inches, no binary tail") << "1.1in" << kMillimetre << 27.94;
        QTest::newRow("a minus sign") << "−25 mm" << kMillimetre << -25.0;
        QTest::newRow("a minus sign in the exponent") << "1e−3" << kMillimetre << 1e-3;
        QTest::newRow("a plus sign") << "+5" << kMillimetre << 5.0;
        QTest::newRow("no whole part") << ".5" << kMillimetre << 0.5;
        QTest::newRow("no decimals") << "5." << kMillimetre << 5.0;
        QTest::newRow("a power of ten") << "1e3mm" << kMillimetre << 1000.0;
        QTest::newRow("a power of ten, as the program writes it") << "1.5·10⁻⁷" << kMillimetre << 1.5e-7;
        QTest::newRow("a power of ten and nothing else") << "10⁻⁸" << kMillimetre << 1e-8;
        QTest::newRow("a power of ten, crossed") << "−2.50 × 10¹² mm" << kMillimetre << -2.5e12;
        QTest::newRow("a power of ten, on a keyboard") << "1.5·10^-7" << kMillimetre << 1.5e-7;
        QTest::newRow("a power of ten with its minus sign") << "10^−3 m" << kMillimetre << 1.0;
        QTest::newRow("a power of ten in a unit") << "1.5·10⁻³ m" << kMillimetre << 1.5;
        QTest::newRow("a number above ten") << "60.1·10²" << kMillimetre << 6010.0;
        QTest::newRow("groups of three") << "1 000 001" << kMillimetre << 1'000'001.0;
        QTest::newRow("groups of three, narrow spaces") << "-12\u202F500.5 mm" << kMillimetre << -12500.5;
        QTest::newRow("turns a minute") << "60 rpm" << kRadianPerSecond << 2.0 * pi;
        QTest::newRow("degrees a second") << "360deg/s" << kRadianPerSecond << 2.0 * pi;
        QTest::newRow("degrees a second, by their sign") << "-360 °/s" << kTurnPerMinute << -60.0;
        QTest::newRow("radians a second") << "2.5 rad/s" << kRadianPerSecond << 2.5;
        QTest::newRow("degrees") << "90deg" << kRadian << pi / 2.0;
        QTest::newRow("degrees, by their sign") << "370°" << kDegree << 370.0;
        QTest::newRow("radians") << "1 rad" << kDegree << 180.0 / pi;
        QTest::newRow("seconds") << "0.5 s" << kSecond << 0.5;
        QTest::newRow("milliseconds") << "5ms" << kSecond << 0.005;
    }

    void readsWhatPeopleWrite()
    {
        QFETCH(const QString, text);
        QFETCH(const Unit, wanted);
        QFETCH(const double, value);
        const Quantity quantity = read(text, wanted);
        QVERIFY(!quantity.fault);
        QVERIFY2(quantity.value == value, qPrintable(QString::number(quantity.value, 'g', 17))); // to the last bit
    }

    void saysWhyNot_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QuantityFault>("fault");
        QTest::newRow("nothing") << "" << QuantityFault::NotANumber;
        QTest::newRow("a space first") << " 5" << QuantityFault::NotANumber;
        QTest::newRow("a word") << "sixty" << QuantityFault::NotANumber;
        QTest::newRow("infinite") << "inf" << QuantityFault::NotANumber;
        QTest::newRow("not a number") << "nan" << QuantityFault::NotANumber;
        QTest::newRow("a unit alone") << "mm" << QuantityFault::NotANumber;
        QTest::newRow("a point alone") << "." << QuantityFault::NotANumber;
        QTest::newRow("two signs") << "+-5" << QuantityFault::NotANumber;
        QTest::newRow("a quotient") << "20/3" << QuantityFault::NotANumber;
        QTest::newRow("a sum") << "20 + 3" << QuantityFault::NotANumber;
        QTest::newRow("two numbers") << "20 3" << QuantityFault::NotANumber;
        QTest::newRow("two points") << "1.234.5" << QuantityFault::NotANumber;
        QTest::newRow("groups, not of three") << "1234 567" << QuantityFault::NotANumber;
        QTest::newRow("ten without its power") << "1.5·10" << QuantityFault::NotANumber;
        QTest::newRow("a power without its number") << "·10⁻⁷" << QuantityFault::NotANumber;
        QTest::newRow("a power without digits") << "10⁻" << QuantityFault::NotANumber;
        QTest::newRow("a power without digits, on a keyboard") << "10^-" << QuantityFault::NotANumber;
        QTest::newRow("a power of another number") << "2⁵" << QuantityFault::NotANumber;
        QTest::newRow("a power of a number that ends in ten") << "110²" << QuantityFault::NotANumber;
        QTest::newRow("a power of ten of a power of ten") << "1e3·10⁻⁷" << QuantityFault::NotANumber;
        QTest::newRow("a product") << "1.5·20" << QuantityFault::NotANumber;
        QTest::newRow("a comma in front of a power") << "1,5·10⁻⁷" << QuantityFault::CommaForPoint;
        QTest::newRow("a power beyond a double") << "10⁹⁹⁹" << QuantityFault::TooLarge;
        QTest::newRow("a comma") << "30,5" << QuantityFault::CommaForPoint;
        QTest::newRow("a comma, with a unit") << "30,5 mm" << QuantityFault::CommaForPoint;
        QTest::newRow("a comma and a point") << "1,234.5" << QuantityFault::NotANumber;
        QTest::newRow("a point and a comma") << "1.234,5" << QuantityFault::NotANumber;
        QTest::newRow("several commas") << "1,234,567" << QuantityFault::NotANumber;
        QTest::newRow("beyond a double") << "1e999" << QuantityFault::TooLarge;
        QTest::newRow("a unit nobody knows") << "12abc" << QuantityFault::UnknownUnit;
        QTest::newRow("a number of C") << "0x10" << QuantityFault::UnknownUnit;
        QTest::newRow("another dimension") << "3 s" << QuantityFault::WrongUnit;
        QTest::newRow("another order") << "3 mm/s" << QuantityFault::WrongUnit;
    }

    void saysWhyNot()
    {
        QFETCH(const QString, text);
        QFETCH(const QuantityFault, fault);
        const Quantity quantity = read(text, kMillimetre);
        QVERIFY(quantity.fault && *quantity.fault == fault);
        QVERIFY(std::isnan(quantity.value));
    }

    void aBareNumberHasNoUnit()
    {
        QCOMPARE(read(QStringLiteral("1e-8"), {}).value, 1e-8);
        const Quantity quantity = read(QStringLiteral("5 mm"), {});
        QVERIFY(quantity.fault && *quantity.fault == QuantityFault::WrongUnit);
    }
};

QTEST_GUILESS_MAIN(TestQuantity)
#include "tst_quantity.moc"
