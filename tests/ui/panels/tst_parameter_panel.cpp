// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/number_box.h"
#include "ui/panels/parameter_panel.h"
#include "ui/text/theme.h"

#include "tests/support/waiting.h"

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QSignalSpy>
#include <QSlider>
#include <QTest>
#include <QToolButton>

#include <cmath>
#include <numbers>

using namespace slidercrank;

namespace
{

template <typename Widget>
Widget *child(const QWidget &parent, const QString &name)
{
    auto *widget = parent.findChild<Widget *>(name);
    if (!widget) {
        qFatal("no %s", qPrintable(name));
    }
    return widget;
}

void type(NumberBox *box, const QString &text)
{
    box->setFocus();
    box->selectAll();
    for (const QChar sign : text) { // also those on no key
        QTest::sendKeyEvent(QTest::Click, box, Qt::Key_unknown, QString(sign), Qt::NoModifier);
    }
    QTest::keyClick(box, Qt::Key_Return);
}

QString textOf(const NumberBox *box)
{
    return box->findChild<QLineEdit *>()->text();
}

} // namespace

class TestParameterPanel : public QObject
{
    Q_OBJECT

private:
    Parameters m_received;
    int m_edits = 0;

    void listenTo(const ParameterPanel &panel)
    {
        m_edits = 0;
        m_received = Parameters();
        connect(&panel, &ParameterPanel::edited, this, [this](const Parameters &parameters) {
            m_received = parameters;
            ++m_edits;
        });
    }

private slots:
    void initTestCase()
    {
        QLocale::setDefault(QLocale::c());
        // Every number different from every default, so that a mix-up shows.
        m_given.a = 21.0;
        m_given.b = 66.0;
        m_given.c = -26.0;
        m_given.omega2 = 3.0;
        m_given.theta20 = 0.5;
        m_given.branch = Branch::Crossed;
    }

    void showsParametersWithoutEcho()
    {
        ParameterPanel panel;
        listenTo(panel);
        panel.setParameters(m_given);
        QCOMPARE(m_edits, 0);
        QCOMPARE(textOf(child<NumberBox>(panel, "box_a")), QString("21 mm"));
        QCOMPARE(textOf(child<NumberBox>(panel, "box_b")), QString("66 mm"));
        QCOMPARE(textOf(child<NumberBox>(panel, "box_c")), QString("-26 mm"));
        QCOMPARE(textOf(child<NumberBox>(panel, "box_omega2")), QString("3"));
        QCOMPARE(textOf(child<NumberBox>(panel, "box_theta20")), QString("28.6479"));
        QCOMPARE(child<QComboBox>(panel, "branchBox")->currentIndex(), 1);
    }

    void aSliderChangesItsOwnParameterOnly_data()
    {
        QTest::addColumn<QString>("key");
        QTest::addColumn<double Parameters::*>("field");
        QTest::newRow("a") << "a" << &Parameters::a;
        QTest::newRow("b") << "b" << &Parameters::b;
        QTest::newRow("c") << "c" << &Parameters::c;
        QTest::newRow("ω₂") << "omega2" << &Parameters::omega2;
        QTest::newRow("θ₂₀") << "theta20" << &Parameters::theta20;
    }
    void aSliderChangesItsOwnParameterOnly()
    {
        QFETCH(QString, key);
        using Field = double Parameters::*;
        QFETCH(Field, field);
        ParameterPanel panel;
        panel.setParameters(m_given);
        listenTo(panel);
        auto *slider = child<QSlider>(panel, "slider_" + key);
        slider->setValue(slider->value() + 7);
        QCOMPARE(m_edits, 1);
        Parameters expected = m_given;
        expected.*field = m_received.*field;
        QCOMPARE(m_received, expected);
        QVERIFY(m_received.*field > m_given.*field);
    }

    void aSliderEmitsAtEveryMove()
    {
        ParameterPanel panel;
        listenTo(panel);
        auto *slider = child<QSlider>(panel, "slider_b");
        const int start = slider->value();
        for (int i = 1; i <= 5; ++i) {
            slider->setValue(start + i);
        }
        QCOMPARE(m_edits, 5);
        QCOMPARE(m_received.b, 70.0);
    }

    void takesTypedNumbers_data()
    {
        QTest::addColumn<QString>("typed");
        QTest::addColumn<double>("b");
        QTest::newRow("plain") << "70" << 70.0;
        QTest::newRow("all digits are kept") << "60.123456789012345" << 60.123456789012345;
        QTest::newRow("with its unit") << "70.5 mm" << 70.5;
        QTest::newRow("with its unit, no space") << "70.5mm" << 70.5;
        QTest::newRow("far beyond the slider") << "123456.5" << 123456.5;
        QTest::newRow("power of ten") << "1e-3" << 1e-3;
        QTest::newRow("power of ten as the program shows it") << QStringLiteral("1.5·10⁻⁷") << 1.5e-7;
        QTest::newRow("centimetres") << "2.5cm" << 25.0;
        QTest::newRow("an inch") << "1 in" << 25.4;
        QTest::newRow("groups of three") << "1 000" << 1000.0;
    }
    void takesTypedNumbers()
    {
        QFETCH(QString, typed);
        QFETCH(double, b);
        ParameterPanel panel;
        panel.setParameters(m_given);
        listenTo(panel);
        type(child<NumberBox>(panel, "box_b"), typed);
        QCOMPARE(m_edits, 1);
        Parameters expected = m_given;
        expected.b = b;
        QVERIFY(m_received == expected); // to the last bit
        QVERIFY(child<QSlider>(panel, "slider_b")->maximum() >= child<QSlider>(panel, "slider_b")->value());
    }

    void aDoubleClickTakesTheWholeNumber()
    {
        ParameterPanel panel;
        panel.setParameters(m_given);
        listenTo(panel);
        auto *box = child<NumberBox>(panel, "box_omega2");
        box->edit(6.25);
        auto *line = box->findChild<QLineEdit *>();
        const int digit = line->fontMetrics().horizontalAdvance(u'5');
        for (const int x : {line->width() - digit, line->width() - 4 * digit}) { // behind the point, before it
            QTest::mouseDClick(line, Qt::LeftButton, Qt::NoModifier, QPoint(x, line->height() / 2));
            QTRY_COMPARE(line->selectedText(), QStringLiteral("6.25"));
        }
    }

    void saysWhyNotAndKeepsTheText_data()
    {
        QTest::addColumn<QString>("typed");
        QTest::addColumn<QString>("says");
        QTest::newRow("nonsense") << "sixty"
                                  << "“sixty” is not a number.";
        QTest::newRow("ten without its power")
            << QStringLiteral("1.5·10") << QStringLiteral("“1.5·10” is not a number.");
        QTest::newRow("a quotient") << "20/3"
                                    << "“20/3” is not a number.";
        QTest::newRow("a comma") << "30,5"
                                 << "The decimal sign here is “.”: 30.5.";
        QTest::newRow("a comma and a point") << "1,234.5"
                                             << "“1,234.5” is not a number.";
        QTest::newRow("several commas") << "1,234,567"
                                        << "“1,234,567” is not a number.";
        QTest::newRow("endless") << QString(400, '9') << "“999999999999999999999999…” is too large.";
        QTest::newRow("another unit") << "30 s"
                                      << "“30 s”: the units here are mm, cm, m, in.";
        QTest::newRow("zero") << "0"
                              << "This must be greater than 0 mm.";
        QTest::newRow("negative") << "-5"
                                  << "This must be greater than 0 mm.";
        QTest::newRow("infinite") << "inf"
                                  << "“inf” is not a number.";
        QTest::newRow("not a number") << "nan"
                                      << "“nan” is not a number.";
        QTest::newRow("too large") << "1e13"
                                   << "This must be at most 10¹² mm.";
    }
    void saysWhyNotAndKeepsTheText()
    {
        QFETCH(QString, typed);
        QFETCH(QString, says);
        ParameterPanel panel;
        panel.setParameters(m_given);
        panel.show();
        QVERIFY(QTest::qWaitForWindowExposed(&panel));
        listenTo(panel);
        auto *box = child<NumberBox>(panel, "box_b");
        type(box, typed);
        QCOMPARE(m_edits, 0);
        QCOMPARE(textOf(box), typed);
        const auto *refusal = child<QLabel>(panel, "refusalLabel");
        QVERIFY(refusal->isVisible());
        QCOMPARE(refusal->text(), says);
        QCOMPARE(box->accessibleDescription(), says);
        QVERIFY(panel.rect().contains(refusal->geometry()) && !refusal->geometry().intersects(box->geometry()));
        QVERIFY(refusal->heightForWidth(refusal->width()) <= refusal->height());

        child<NumberBox>(panel, "box_a")->setFocus(); // it stays when the box is left, and when something else changes
        Parameters other = m_given;
        other.a = 30.0;
        panel.setParameters(other);
        QCOMPARE(textOf(box), typed);
        QVERIFY(refusal->isVisible());
        box->setFocus();
        QTest::keyClick(box, Qt::Key_Escape);
        QCOMPARE(textOf(box), QString("66 mm"));
        QVERIFY(!refusal->isVisible());
        QCOMPARE(box->accessibleDescription(), QString());
        QCOMPARE(m_edits, 0);
    }

    void nothingTypedIsNothingAsked()
    {
        ParameterPanel panel;
        panel.setParameters(m_given);
        listenTo(panel);
        auto *box = child<NumberBox>(panel, "box_b");
        type(box, " ");
        QCOMPARE(m_edits, 0);
        QCOMPARE(textOf(box), QString("66 mm"));
    }

    void aRightNumberTakesTheRefusalBack()
    {
        ParameterPanel panel;
        panel.setParameters(m_given);
        panel.show();
        listenTo(panel);
        auto *box = child<NumberBox>(panel, "box_b");
        type(box, "20/3");
        const auto *refusal = child<QLabel>(panel, "refusalLabel");
        QVERIFY(refusal->isVisible());
        type(box, "6.5 cm");
        QVERIFY(!refusal->isVisible());
        QCOMPARE(m_received.b, 65.0);
        QCOMPARE(textOf(box), QString("65 mm"));
    }

    void aNumberFromElsewhereTakesTheRefusalBack()
    {
        ParameterPanel panel;
        panel.setParameters(m_given);
        panel.show();
        QVERIFY(QTest::qWaitForWindowExposed(&panel));
        auto *box = child<NumberBox>(panel, "box_b");
        type(box, "20/3");
        child<NumberBox>(panel, "box_a")->setFocus();
        child<QSlider>(panel, "slider_b")->setValue(70);
        QCOMPARE(textOf(box), QString("70 mm"));
        QVERIFY(!child<QLabel>(panel, "refusalLabel")->isVisible());
    }

    void typingCountsWhenTheBoxIsLeft()
    {
        ParameterPanel panel;
        panel.show();
        QVERIFY(QTest::qWaitForWindowExposed(&panel));
        panel.activateWindow();
        listenTo(panel);
        auto *box = child<NumberBox>(panel, "box_a");
        box->setFocus();
        AWAIT(box->hasFocus());
        box->selectAll();
        QTest::keyClicks(box, "22");
        QCOMPARE(m_edits, 0);
        child<NumberBox>(panel, "box_b")->setFocus();
        QCOMPARE(m_edits, 1);
        QCOMPARE(m_received.a, 22.0);
    }

    void anExactValueSurvivesWhatIsShown()
    {
        Parameters exact;
        exact.b = 60.12345678901234;
        exact.omega2 = std::nextafter(1.0 / 3.0, 1.0);
        exact.theta20 = 0.1234567890123456;
        ParameterPanel panel;
        panel.show();
        QVERIFY(QTest::qWaitForWindowExposed(&panel));
        panel.setParameters(exact);
        QCOMPARE(textOf(child<NumberBox>(panel, "box_b")), QString("60.1235 mm"));
        listenTo(panel);
        panel.activateWindow();
        for (const char *name : {"box_omega2", "box_theta20", "box_b"}) { // looking at a box changes nothing
            auto *box = child<NumberBox>(panel, name);
            box->setFocus();
            AWAIT(box->hasFocus());
            QTest::keyClick(box, Qt::Key_Return);
        }
        QCOMPARE(m_edits, 0);
        // Who types sees every digit, and may change one of them.
        QCOMPARE(textOf(child<NumberBox>(panel, "box_b")), QString("60.12345678901234 mm"));
        type(child<NumberBox>(panel, "box_a"), "25");
        exact.a = 25.0;
        QVERIFY(m_received == exact);
    }

    void aNumberTooLongForItsBoxLosesDigitsNotItsExponent()
    {
        ParameterPanel panel;
        panel.resize(panel.minimumSizeHint());
        panel.show();
        QVERIFY(QTest::qWaitForWindowExposed(&panel));
        auto *box = child<NumberBox>(panel, "box_omega2");
        const auto *edit = box->findChild<QLineEdit *>();
        for (const double omega2 : {-3.81966e-7, 1.23456e11, -12.3456, 2.0 * std::numbers::pi, 0.0}) {
            Parameters parameters;
            parameters.omega2 = omega2;
            panel.setParameters(parameters);
            QString typed = edit->text();
            typed.replace(QStringLiteral("·10"), QStringLiteral("e")).replace(u'⁻', u'-');
            for (const QChar digit : QStringLiteral("⁰¹²³⁴⁵⁶⁷⁸⁹")) {
                typed.replace(digit, QString::number(digit.digitValue()));
            }
            const double shown = typed.toDouble();
            QVERIFY2(std::abs(shown - omega2) <= 0.05 * std::abs(omega2), qPrintable(edit->text()));
            QVERIFY2(edit->fontMetrics().horizontalAdvance(edit->text()) < edit->width(), qPrintable(edit->text()));
        }
        NumberBox angle;
        angle.setFixedDecimals(2);
        angle.resize(angle.minimumSizeHint());
        angle.show();
        angle.setValue(8676619541.25);
        QVERIFY2(textOf(&angle).endsWith(QStringLiteral("·10⁹")), qPrintable(textOf(&angle)));
        angle.setValue(62.5);
        QCOMPARE(textOf(&angle), QStringLiteral("62.50"));
    }

    void anArrowIsAStep()
    {
        ParameterPanel panel;
        listenTo(panel);
        auto *box = child<NumberBox>(panel, "box_b");
        QTest::keyClick(box, Qt::Key_Up);
        QCOMPARE(m_received.b, 66.0);
        QTest::keyClick(box, Qt::Key_Down);
        QTest::keyClick(box, Qt::Key_Down);
        QCOMPARE(m_received.b, 64.0);
        QCOMPARE(m_edits, 3);
    }

    void resetsOneParameter_data() { aSliderChangesItsOwnParameterOnly_data(); }
    void resetsOneParameter()
    {
        QFETCH(QString, key);
        using Field = double Parameters::*;
        QFETCH(Field, field);
        ParameterPanel panel;
        auto *reset = child<QToolButton>(panel, "reset_" + key);
        QVERIFY(!reset->isEnabled());
        panel.setParameters(m_given);
        QVERIFY(reset->isEnabled());
        listenTo(panel);
        reset->click();
        Parameters expected = m_given;
        expected.*field = Parameters().*field;
        QVERIFY(m_received == expected);
        QCOMPARE(m_edits, 1);
        QVERIFY(!reset->isEnabled());
    }

    void speedHasThreeUnits()
    {
        ParameterPanel panel;
        listenTo(panel);
        auto *unit = child<QComboBox>(panel, "unit_omega2");
        auto *box = child<NumberBox>(panel, "box_omega2");
        QCOMPARE(textOf(box), QString("6.28319"));
        unit->setCurrentIndex(1);
        QCOMPARE(textOf(box), QString("360"));
        unit->setCurrentIndex(2);
        QCOMPARE(textOf(box), QString("60"));
        QCOMPARE(m_edits, 0); // another unit is no other speed
        type(box, "120");
        QVERIFY(m_received.omega2 == 4.0 * std::numbers::pi);
        unit->setCurrentIndex(1);
        type(box, "360");
        QVERIFY(m_received.omega2 == 2.0 * std::numbers::pi);
    }

    void startAngleHasTwoUnits()
    {
        ParameterPanel panel;
        listenTo(panel);
        auto *box = child<NumberBox>(panel, "box_theta20");
        type(box, "90");
        QVERIFY(m_received.theta20 == std::numbers::pi / 2.0);
        child<QComboBox>(panel, "unit_theta20")->setCurrentIndex(1);
        QCOMPARE(textOf(box), QString("1.5708"));
        type(box, "0.25");
        QCOMPARE(m_received.theta20, 0.25);
    }

    void takesSpeedsAndAnglesInAnyUnit_data()
    {
        QTest::addColumn<QString>("key");
        QTest::addColumn<int>("shown"); // unit
        QTest::addColumn<QString>("typed");
        QTest::addColumn<double>("value"); // rad/s, rad
        const double pi = std::numbers::pi;
        QTest::newRow("rpm among rad/s") << "omega2" << 0 << "60 rpm" << 2.0 * pi;
        QTest::newRow("deg/s among rad/s") << "omega2" << 0 << "360deg/s" << 2.0 * pi;
        QTest::newRow("rad/s among rpm") << "omega2" << 2 << "4 rad/s" << 4.0;
        QTest::newRow("backwards, with a minus sign") << "omega2" << 2 << "−90 °/s" << -pi / 2.0;
        QTest::newRow("degrees as displayed") << "theta20" << 0 << "30°" << pi / 6.0;
        QTest::newRow("degrees among radians") << "theta20" << 1 << "30 deg" << pi / 6.0;
        QTest::newRow("radians among degrees") << "theta20" << 0 << "0.25rad" << 0.25;
    }
    void takesSpeedsAndAnglesInAnyUnit()
    {
        QFETCH(const QString, key);
        QFETCH(const int, shown);
        QFETCH(const QString, typed);
        QFETCH(const double, value);
        ParameterPanel panel;
        panel.setParameters(m_given);
        child<QComboBox>(panel, "unit_" + key)->setCurrentIndex(shown);
        listenTo(panel);
        type(child<NumberBox>(panel, "box_" + key), typed);
        QCOMPARE(m_edits, 1);
        const double received = key == "omega2" ? m_received.omega2 : m_received.theta20;
        QVERIFY2(std::abs(received - value) <= 1e-15 * std::abs(value), qPrintable(QString::number(received, 'g', 17)));
    }

    void anAngleReadsAsItWasTypedAlsoWhileEdited()
    {
        for (const int degrees : {370, 10, 30, 100, 123, -725}) {
            ParameterPanel panel;
            panel.show();
            QVERIFY(QTest::qWaitForWindowExposed(&panel));
            panel.activateWindow();
            listenTo(panel);
            auto *box = child<NumberBox>(panel, "box_theta20");
            type(box, QString::number(degrees));
            panel.setParameters(m_received);
            QCOMPARE(textOf(box), QString::number(degrees));
            AWAIT(box->hasFocus());
            child<NumberBox>(panel, "box_a")->setFocus();
            QCOMPARE(textOf(box), QString::number(degrees));
            box->setFocus();
            QCOMPARE(textOf(box), QString::number(degrees));
        }
    }

    void aLongNumberShowsItsFirstDigits()
    {
        Parameters exact;
        exact.b = 60.12345678901234;
        ParameterPanel panel;
        panel.show();
        QVERIFY(QTest::qWaitForWindowExposed(&panel));
        panel.activateWindow();
        panel.setParameters(exact);
        auto *box = child<NumberBox>(panel, "box_b");
        const auto *edit = box->findChild<QLineEdit *>();
        for (const Qt::FocusReason reason : {Qt::TabFocusReason, Qt::OtherFocusReason}) {
            box->setFocus(reason);
            AWAIT(box->hasFocus());
            QCOMPARE(edit->text(), QString("60.12345678901234 mm"));
            QVERIFY(edit->fontMetrics().horizontalAdvance(edit->text()) > edit->width());
            QCOMPARE(edit->cursorPosition(), 0);
            QTest::keyClick(box, Qt::Key_Return);
            QCOMPARE(edit->cursorPosition(), 0);
            child<NumberBox>(panel, "box_a")->setFocus();
            QCOMPARE(edit->cursorPosition(), 0);
        }
    }

    void theBranchIsChosen()
    {
        ParameterPanel panel;
        panel.setParameters(m_given);
        listenTo(panel);
        auto *branch = child<QComboBox>(panel, "branchBox");
        branch->setFocus();
        QTest::keyClick(branch, Qt::Key_Up);
        QCOMPARE(m_edits, 1);
        Parameters expected = m_given;
        expected.branch = Branch::Open;
        QVERIFY(m_received == expected);
    }

    void sliderRangesSuitTheMechanism()
    {
        ParameterPanel panel;
        auto *slider = child<QSlider>(panel, "slider_b");
        const int usual = slider->maximum();
        Parameters parameters;
        parameters.b = 5000.0;
        panel.setParameters(parameters);
        QVERIFY(slider->value() < slider->maximum());
        panel.setParameters(Parameters());
        QCOMPARE(slider->maximum(), usual);
        // In a mechanism of hundredths of a millimetre a slider of 200 mm would be of no use.
        parameters.a = 0.02;
        parameters.b = 0.065;
        parameters.c = 0.025;
        panel.setParameters(parameters);
        QVERIFY(slider->value() > slider->maximum() / 10);
    }

    void shadesWhereTheCrankCannotTurnRound_data()
    {
        QTest::addColumn<Parameters>("parameters");
        QTest::addColumn<QString>("slider");
        QTest::addColumn<QList<double>>("clear"); // parts of the slider's length
        QTest::addColumn<QList<double>>("shaded");
        QTest::addColumn<QString>("tip");
        const Parameters table1;
        Parameters rocker;
        rocker.b = 40.0; // from -48.6° to 228.6°, that is not from -131.4° to -48.6°
        Parameters shortCoupler;
        shortCoupler.b = 15.0;
        QTest::newRow("a up to b - |c| = 40")
            << table1 << "a" << QList<double>{0.1, 0.38} << QList<double>{0.42, 0.9} << "above 40 mm";
        QTest::newRow("b from a + |c| = 45")
            << table1 << "b" << QList<double>{0.24, 0.9} << QList<double>{0.05, 0.21} << "below 45 mm";
        QTest::newRow("|c| up to b - a = 45") << table1 << "c" << QList<double>{0.29, 0.5, 0.71}
                                              << QList<double>{0.1, 0.26, 0.74, 0.9} << "beyond ±45 mm";
        QTest::newRow("ω₂ never") << rocker << "omega2" << QList<double>{0.1, 0.9} << QList<double>{} << "";
        QTest::newRow("θ₂₀ of a crank that turns round")
            << table1 << "theta20" << QList<double>{0.1, 0.25, 0.9} << QList<double>{} << "";
        QTest::newRow("θ₂₀ of a rocker") << rocker << "theta20" << QList<double>{0.05, 0.12, 0.39, 0.9}
                                         << QList<double>{0.15, 0.25, 0.35} << "cannot be assembled";
        QTest::newRow("no crank") << shortCoupler << "a" << QList<double>{} << QList<double>{0.05, 0.5, 0.9}
                                  << "no crank can turn round";
        QTest::newRow("no offset") << shortCoupler << "c" << QList<double>{} << QList<double>{0.1, 0.5, 0.9}
                                   << "no offset";
    }
    void shadesWhereTheCrankCannotTurnRound()
    {
        QFETCH(Parameters, parameters);
        QFETCH(QString, slider);
        QFETCH(QList<double>, clear);
        QFETCH(QList<double>, shaded);
        QFETCH(QString, tip);
        for (const Theme theme : {Theme::Light, Theme::Dark}) {
            ParameterPanel panel;
            panel.setPalette(paletteFor(theme));
            panel.resize(430, panel.sizeHint().height());
            panel.show();
            panel.setParameters(parameters);
            auto *shown = child<QSlider>(panel, "slider_" + slider);
            const QImage image = shown->grab().toImage();
            const int between = image.height() / 2 + 4; // below the groove, within the handle's height
            const auto isShaded = [&](double part) {
                const int handle = 13;
                const int x = handle / 2 + static_cast<int>(part * (image.width() - handle));
                const QColor there = image.pixelColor(x, between);
                const QColor plain = panel.palette().color(QPalette::Window);
                return std::abs(there.red() - plain.red()) + std::abs(there.blue() - plain.blue()) > 40;
            };
            for (const double part : clear) {
                QVERIFY2(!isShaded(part), qPrintable(QString::number(part)));
            }
            for (const double part : shaded) {
                QVERIFY2(isShaded(part), qPrintable(QString::number(part)));
            }
            QVERIFY2(shown->toolTip().contains(tip), qPrintable(shown->toolTip()));
            QCOMPARE(shown->toolTip().contains("Shaded"), !shaded.isEmpty());
        }
    }

    void theShadeFollowsTheUnit()
    {
        Parameters rocker;
        rocker.b = 40.0;
        ParameterPanel panel;
        panel.resize(430, panel.sizeHint().height());
        panel.show();
        panel.setParameters(rocker);
        auto *slider = child<QSlider>(panel, "slider_theta20");
        const auto shadedPixels = [slider] {
            const QImage image = slider->grab().toImage();
            const QRgb plain = image.pixel(image.width() - 10, image.height() / 2 + 4);
            int count = 0;
            for (int x = 10; x < image.width() - 10; ++x) {
                count += image.pixel(x, image.height() / 2 + 4) != plain ? 1 : 0;
            }
            return count;
        };
        const int inDegrees = shadedPixels();
        QVERIFY(inDegrees > 20);
        child<QComboBox>(panel, "unit_theta20")->setCurrentIndex(1);
        QVERIFY(std::abs(shadedPixels() - inDegrees) <= 3); // 3.2 rad are 183°
    }

    void readsTheUsersLocale()
    {
        QLocale::setDefault(QLocale(QLocale::German));
        Parameters parameters;
        parameters.b = 60.5;
        ParameterPanel panel;
        panel.setParameters(parameters);
        auto *box = child<NumberBox>(panel, "box_b");
        const QString shown = textOf(box);
        listenTo(panel);
        type(box, "61,25");
        const double comma = m_received.b;
        type(box, "1.234"); // a decimal point, never a separator of thousands
        QLocale::setDefault(QLocale::c());
        QCOMPARE(shown, QString("60,5 mm"));
        QCOMPARE(comma, 61.25);
        QCOMPARE(m_received.b, 1.234);
    }

    void readsTheNumbersOfEveryLocale_data()
    {
        QTest::addColumn<QLocale>("locale");
        QTest::newRow("Swedish: another minus, another exponent") << QLocale(QLocale::Swedish);
        QTest::newRow("Arabic: other digits") << QLocale(QLocale::Arabic, QLocale::Egypt);
        QTest::newRow("Persian: other digits, another minus") << QLocale(QLocale::Persian);
        QTest::newRow("Swiss German") << QLocale(QLocale::German, QLocale::Switzerland);
    }
    void readsTheNumbersOfEveryLocale()
    {
        QFETCH(const QLocale, locale);
        QLocale::setDefault(locale);
        ParameterPanel panel;
        listenTo(panel);
        auto *box = child<NumberBox>(panel, "box_c");
        QList<double> read;
        for (const double value : {-26.5, -1.5e-7, 1234.5}) {
            type(box, QLocale(locale).toString(value, 'g', 6).remove(locale.groupSeparator()) + " mm");
            read << m_received.c;
        }
        QLocale::setDefault(QLocale::c());
        QCOMPARE(read, (QList<double>{-26.5, -1.5e-7, 1234.5}));
    }

    void everyControlHasANameForThoseWhoCannotSee()
    {
        ParameterPanel panel;
        for (const QString key : {"a", "b", "c", "omega2", "theta20"}) {
            for (const QString prefix : {"slider_", "box_", "reset_"}) {
                QVERIFY2(!child<QWidget>(panel, prefix + key)->accessibleName().isEmpty(), qPrintable(prefix + key));
            }
        }
        QVERIFY(!child<QWidget>(panel, "branchBox")->accessibleName().isEmpty());
    }

    void isCompact()
    {
        ParameterPanel panel;
        QVERIFY2(panel.minimumSizeHint().width() <= 330, qPrintable(QString::number(panel.minimumSizeHint().width())));
        QVERIFY2(panel.sizeHint().height() <= 190, qPrintable(QString::number(panel.sizeHint().height())));
    }

private:
    Parameters m_given;
};

QTEST_MAIN(TestParameterPanel)
#include "tst_parameter_panel.moc"
