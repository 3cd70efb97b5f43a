// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/number_box.h"
#include "ui/document/session.h"
#include "ui/panels/timeline.h"

#include "tests/support/waiting.h"

#include <QLabel>
#include <QSignalSpy>
#include <QSlider>
#include <QTest>
#include <QToolButton>

#include <cmath>
#include <numbers>
#include <vector>

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
    QTest::keyClicks(box, text);
    QTest::keyClick(box, Qt::Key_Return);
}

/// A timeline in its place: what it asks for comes back as a pose. Its clock stands until it is put forward.
struct Bench {
    Session session;
    Timeline timeline;
    double clock = 1234.5; // s
    std::vector<double> requested;

    explicit Bench(const Parameters &parameters = {}, const Sampling &sampling = {})
    {
        QObject::connect(&timeline, &Timeline::timeRequested, &session, [this](double time) {
            requested.push_back(time);
            session.setTime(time);
        });
        QObject::connect(&session, &Session::timeChanged, &timeline, &Timeline::setPose);
        QObject::connect(&session, &Session::parametersChanged, &timeline, &Timeline::setParameters);
        QObject::connect(&session, &Session::settingsChanged, &timeline,
                         [this](const Sampling &changed) { timeline.setSampling(changed); });
        QObject::connect(&timeline, &Timeline::samplingEdited, &session, &Session::setSampling);
        session.setParameters(parameters);
        session.setSampling(sampling);
        session.setTime(sampling.start);
        requested.clear();
        timeline.setClock([this] { return clock; });
    }

    /// So long until the next frame.
    void passTime(double seconds)
    {
        clock += seconds;
        letTimePass(timeline);
    }
};

} // namespace

class TestTimeline : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void standsStillAtFirst()
    {
        Bench bench;
        QVERIFY(!bench.timeline.isPlaying());
        bench.passTime(0.5);
        settle();
        QVERIFY(bench.requested.empty());
        QVERIFY(child<QToolButton>(bench.timeline, "loopButton")->isChecked());
    }

    void playsByTheClock_data()
    {
        QTest::addColumn<double>("speed");
        QTest::newRow("1×") << 1.0;
        QTest::newRow("2×") << 2.0;
        QTest::newRow("0.1×") << 0.1;
    }
    void playsByTheClock()
    {
        QFETCH(double, speed);
        Bench bench({}, {0.0, 100.0, 200});
        bench.timeline.setSpeed(speed);
        bench.clock += 7.0; // before it begins
        bench.timeline.play();
        QVERIFY(bench.timeline.isPlaying());
        double played = 0.0;
        for (const double frame : {0.016, 0.016, 0.2, 0.016}) { // once a machine too slow for frames
            bench.passTime(frame);
            played += frame;
            const double shown = bench.requested.back();
            QVERIFY2(std::abs(shown - speed * played) < 1e-9, qPrintable(QString::number(shown)));
        }
        QCOMPARE(bench.requested.size(), std::size_t(4));
    }

    void playsByItself()
    {
        Bench bench({}, {0.0, 1e6, 200});
        Timeline timeline; // with the clock it has
        double last = 0.0;
        connect(&timeline, &Timeline::timeRequested, &timeline, [&last](double time) { last = time; });
        timeline.setSampling(bench.session.sampling());
        timeline.play();
        AWAIT(last > 0.0);
        const double before = last;
        AWAIT(last > before);
    }

    void goesOnFromThereAtAnotherSpeed()
    {
        Bench bench({}, {0.0, 100.0, 200});
        bench.timeline.play();
        bench.passTime(3.0);
        bench.timeline.setSpeed(2.0);
        bench.passTime(0.5);
        QVERIFY(std::abs(bench.requested.back() - 4.0) < 1e-9);
    }

    void nothingRunsWhenPaused()
    {
        Bench bench;
        bench.timeline.play();
        bench.passTime(0.06);
        bench.timeline.pause();
        QCOMPARE(bench.requested.size(), std::size_t(1));
        bench.passTime(0.5);
        settle();
        QCOMPARE(bench.requested.size(), std::size_t(1));
    }

    void tellsWhenItPlays()
    {
        Bench bench;
        QSignalSpy spy(&bench.timeline, &Timeline::playingChanged);
        child<QToolButton>(bench.timeline, "playButton")->click();
        QVERIFY(bench.timeline.isPlaying());
        bench.timeline.play(); // already
        bench.timeline.togglePlaying();
        bench.timeline.pause(); // already
        QCOMPARE(spy.count(), 2);
        QCOMPARE(spy[0][0].toBool(), true);
        QCOMPARE(spy[1][0].toBool(), false);
    }

    void beginsAgainAtTheEnd()
    {
        Bench bench({}, {0.0, 0.1, 20});
        bench.timeline.play();
        for (const double shown : {0.06, 0.02, 0.08, 0.04}) {
            bench.passTime(0.06);
            QVERIFY(std::abs(bench.requested.back() - shown) < 1e-9);
        }
        bench.passTime(7.0); // many times round at once
        QVERIFY(bench.requested.back() >= 0.0 && bench.requested.back() <= 0.1);
        QVERIFY(bench.timeline.isPlaying());
    }

    void stopsAtTheEndWithoutLoop()
    {
        Bench bench({}, {0.0, 0.1, 20});
        child<QToolButton>(bench.timeline, "loopButton")->click();
        bench.timeline.play();
        bench.passTime(0.09);
        QVERIFY(bench.timeline.isPlaying());
        bench.passTime(0.09);
        QVERIFY(!bench.timeline.isPlaying());
        QCOMPARE(bench.requested.back(), 0.1);
        // Played again, it starts from the beginning.
        bench.timeline.play();
        bench.passTime(0.05);
        QVERIFY(std::abs(bench.requested.back() - 0.05) < 1e-9);
    }

    void goesWhereItsLineIsClicked_data()
    {
        QTest::addColumn<int>("steps");
        QTest::newRow("many steps") << 200;
        QTest::newRow("few steps") << 3;
    }
    void goesWhereItsLineIsClicked()
    {
        QFETCH(const int, steps);
        Bench bench({}, {0.0, 1.0, steps});
        bench.timeline.resize(430, bench.timeline.sizeHint().height());
        bench.timeline.show();
        QVERIFY(QTest::qWaitForWindowExposed(&bench.timeline));
        auto *slider = child<QSlider>(bench.timeline, "timeSlider");
        const int middle = slider->height() / 2;
        const double handle = 13.0 / slider->width(); // of its way, s
        const auto isAt = [&](double part) { return std::abs(bench.session.time() - part) < handle + 0.5 / steps; };
        QTest::mousePress(slider, Qt::LeftButton, Qt::NoModifier, {slider->width() * 7 / 10, middle});
        QVERIFY2(isAt(0.7), qPrintable(QString::number(bench.session.time())));
        QTest::mouseMove(slider, {slider->width() * 2 / 10, middle}); // and is dragged on
        QVERIFY2(isAt(0.2), qPrintable(QString::number(bench.session.time())));
        QTest::mouseRelease(slider, Qt::LeftButton, Qt::NoModifier, {slider->width() * 2 / 10, middle});
        QVERIFY(isAt(0.2));
        QTest::mouseClick(slider, Qt::LeftButton, Qt::NoModifier, {slider->width() - 2, middle});
        QCOMPARE(bench.session.time(), 1.0);
    }

    void goesOnFromWhereSomebodyScrubbed()
    {
        Bench bench({}, {0.0, 100.0, 200});
        bench.timeline.play();
        bench.passTime(0.05);
        bench.session.setTime(50.0);
        bench.passTime(0.25);
        QVERIFY(bench.timeline.isPlaying());
        QVERIFY(std::abs(bench.requested.back() - 50.25) < 1e-9);
    }

    void stepsFromSampleToSample()
    {
        Bench bench;
        bench.timeline.stepForward();
        QCOMPARE(bench.session.time(), 0.005);
        bench.timeline.stepForward();
        QCOMPARE(bench.session.time(), 0.01);
        bench.timeline.stepBack();
        QCOMPARE(bench.session.time(), 0.005);
        bench.session.setTime(0.0123); // between two samples
        bench.timeline.stepForward();
        QCOMPARE(bench.session.time(), 0.015);
        bench.session.setTime(0.0123);
        bench.timeline.stepBack();
        QCOMPARE(bench.session.time(), 0.01);
        bench.timeline.toStart();
        bench.timeline.stepBack();
        QCOMPARE(bench.session.time(), 0.0);
        bench.timeline.toEnd();
        QCOMPARE(bench.session.time(), 1.0);
        bench.timeline.stepForward();
        QCOMPARE(bench.session.time(), 1.0);
    }

    void stepsThroughEverySampleOnce()
    {
        Bench bench({}, {0.3, 0.7, 70});
        for (int i = 1; i <= 70; ++i) {
            bench.timeline.stepForward();
            QCOMPARE(bench.session.time(), bench.session.sampling().instant(i));
        }
        for (int i = 69; i >= 0; --i) {
            bench.timeline.stepBack();
            QCOMPARE(bench.session.time(), bench.session.sampling().instant(i));
        }
    }

    void showsTheInstantAndTheAngle()
    {
        Bench bench;
        bench.session.setTime(0.25);
        QCOMPARE(child<NumberBox>(bench.timeline, "timeBox")->value(), 0.25);
        QVERIFY(std::abs(child<NumberBox>(bench.timeline, "angleBox")->value() - 90.0) < 1e-9);
        QCOMPARE(child<QSlider>(bench.timeline, "timeSlider")->value(), 50);
        QVERIFY(bench.requested.empty()); // no echo
    }

    void scrubsBySlider()
    {
        Bench bench;
        child<QSlider>(bench.timeline, "timeSlider")->setValue(150);
        QCOMPARE(bench.session.time(), 0.75);
    }

    void takesATypedInstant()
    {
        Bench bench;
        auto *box = child<NumberBox>(bench.timeline, "timeBox");
        type(box, "0.3217");
        QCOMPARE(bench.session.time(), 0.3217);
        type(box, "7");
        QCOMPARE(bench.session.time(), 1.0);
        QCOMPARE(box->value(), 1.0);
        type(box, "noon");
        QCOMPARE(bench.session.time(), 1.0);
    }

    void goesWhereTheCrankPassesAnAngle_data()
    {
        QTest::addColumn<double>("omega2");
        QTest::addColumn<double>("theta20");
        QTest::addColumn<double>("start");
        QTest::addColumn<double>("duration");
        QTest::addColumn<QString>("typed");
        QTest::addColumn<double>("time");
        const double turn = 2.0 * std::numbers::pi; // rad/s: a turn a second
        const double right = std::numbers::pi / 2.0;
        QTest::newRow("the report's run") << turn << 0.0 << 0.0 << 1.0 << "60" << 1.0 / 6.0;
        QTest::newRow("the start") << turn << 0.0 << 0.0 << 1.0 << "0" << 0.0;
        QTest::newRow("the end") << turn << 0.0 << 0.0 << 1.0 << "360" << 1.0;
        QTest::newRow("modulo a turn") << turn << 0.0 << 0.0 << 1.0 << "-300" << 1.0 / 6.0;
        QTest::newRow("in the second turn, by whole turns") << turn << 0.0 << 0.0 << 2.0 << "420" << 7.0 / 6.0;
        QTest::newRow("the first of two turns") << turn << 0.0 << 0.0 << 2.0 << "60" << 1.0 / 6.0;
        QTest::newRow("a run that starts later") << turn << 0.0 << 5.25 << 1.0 << "60" << 6.0 + 1.0 / 6.0;
        QTest::newRow("with a start angle") << turn << right << 0.0 << 1.0 << "60" << 11.0 / 12.0;
        QTest::newRow("clockwise") << -turn << 0.0 << 0.0 << 1.0 << "60" << 5.0 / 6.0;
        QTest::newRow("not passed, the end is nearer") << turn << 0.0 << 0.0 << 0.25 << "120" << 0.25;
        QTest::newRow("not passed, the start is nearer") << turn << 0.0 << 0.0 << 0.25 << "300" << 0.0;
        QTest::newRow("clockwise, not passed, the end is nearer") << -turn << 0.0 << 0.0 << 0.25 << "-120" << 0.25;
    }
    void goesWhereTheCrankPassesAnAngle()
    {
        QFETCH(double, omega2);
        QFETCH(double, theta20);
        QFETCH(double, start);
        QFETCH(double, duration);
        QFETCH(QString, typed);
        QFETCH(double, time);
        Parameters parameters;
        parameters.omega2 = omega2;
        parameters.theta20 = theta20;
        Bench bench(parameters, {start, duration, 200});
        bench.session.setTime(start + 0.4 * duration);
        type(child<NumberBox>(bench.timeline, "angleBox"), typed);
        QVERIFY2(std::abs(bench.session.time() - time) < 1e-9,
                 qPrintable(QString::number(bench.session.time(), 'g', 12)));
    }

    void aCrankThatStandsStillHasNoAngleToGoTo()
    {
        Parameters parameters;
        parameters.omega2 = 0.0;
        Bench bench(parameters);
        QVERIFY(!child<NumberBox>(bench.timeline, "angleBox")->isEnabled());
        bench.session.setParameters({});
        QVERIFY(child<NumberBox>(bench.timeline, "angleBox")->isEnabled());
    }

    void theButtonSaysRunAndSpeed()
    {
        Bench bench({}, {0.0, 2.5, 200});
        const auto *button = child<QToolButton>(bench.timeline, "runButton");
        QCOMPARE(button->text(), QString("2.5 s · 1× ▾"));
        bench.timeline.setSpeed(0.1);
        QCOMPARE(button->text(), QString("2.5 s · 0.1× ▾"));
    }

    void theRunOpensFromItsButton()
    {
        Bench bench;
        bench.timeline.show();
        QVERIFY(QTest::qWaitForWindowExposed(&bench.timeline));
        auto *form = child<QWidget>(bench.timeline, "runForm");
        QVERIFY(!form->isVisible());
        child<QToolButton>(bench.timeline, "runButton")->click();
        QVERIFY(form->isVisible() && child<NumberBox>(bench.timeline, "startBox")->hasFocus());
        for (const char *next : {"durationBox", "oneTurnButton", "stepsBox", "speedBox", "turnBox"}) {
            QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
            QCOMPARE(QApplication::focusWidget()->objectName(), QString(next));
        }
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
        QVERIFY(!form->isVisible());
    }

    void eachBoxOfTheRunChangesItsOwnOnly()
    {
        Bench bench({}, {0.5, 2.5, 400});
        const Session &session = bench.session;
        bench.session.endDrag(); // what follows is another step
        QCOMPARE(child<NumberBox>(bench.timeline, "stepsBox")->value(), 400.0);
        QCOMPARE(child<NumberBox>(bench.timeline, "durationBox")->value(), 2.5);
        QCOMPARE(child<NumberBox>(bench.timeline, "startBox")->value(), 0.5);
        type(child<NumberBox>(bench.timeline, "stepsBox"), "500");
        QCOMPARE(session.sampling(), (Sampling{0.5, 2.5, 500}));
        type(child<NumberBox>(bench.timeline, "durationBox"), "3.25");
        QCOMPARE(session.sampling(), (Sampling{0.5, 3.25, 500}));
        type(child<NumberBox>(bench.timeline, "startBox"), "-1");
        QCOMPARE(session.sampling(), (Sampling{-1.0, 3.25, 500}));
        for (const char *impossible : {"0", "-2"}) {
            type(child<NumberBox>(bench.timeline, "durationBox"), impossible);
        }
        type(child<NumberBox>(bench.timeline, "startBox"), "1e13");
        QCOMPARE(session.sampling(), (Sampling{-1.0, 3.25, 500}));
        bench.session.undoStack().undo();
        QCOMPARE(child<NumberBox>(bench.timeline, "durationBox")->value(), 2.5); // all in one: typed at once
    }

    void stepsBeyondTheLimitAreRefusedWithTheLimit_data()
    {
        QTest::addColumn<QString>("typed");
        QTest::newRow("one too many") << "1000001";
        QTest::newRow("in groups") << "1 000 001";
        QTest::newRow("none") << "0";
        QTest::newRow("not whole") << "12.5";
    }

    void stepsBeyondTheLimitAreRefusedWithTheLimit()
    {
        QFETCH(const QString, typed);
        Bench bench;
        bench.timeline.show();
        bench.timeline.openRun();
        auto *box = child<NumberBox>(bench.timeline, "stepsBox");
        type(box, typed);
        QCOMPARE(bench.session.sampling().steps, 200);
        QCOMPARE(box->text(), typed);
        const auto *refusal = child<QLabel>(bench.timeline, "refusalLabel");
        QVERIFY(refusal->isVisible());
        QCOMPARE(refusal->text(), QString("This must be a whole number from 1 to 1000000."));
        type(box, "1 000 000");
        QCOMPARE(bench.session.sampling().steps, 1'000'000);
        QVERIFY(!refusal->isVisible());
    }

    void oneTurnIsAsLongAsTheCrankTakes_data()
    {
        QTest::addColumn<double>("omega2");
        QTest::addColumn<double>("seconds"); // 0: there is none
        QTest::newRow("a turn a second") << 2.0 * std::numbers::pi << 1.0;
        QTest::newRow("the other way round") << -4.0 * std::numbers::pi << 0.5;
        QTest::newRow("an engine at 3000 rpm") << 100.0 * std::numbers::pi << 0.02;
        QTest::newRow("standing still") << 0.0 << 0.0;
        QTest::newRow("as good as that") << 1e-13 << 0.0;
    }

    void oneTurnIsAsLongAsTheCrankTakes()
    {
        QFETCH(const double, omega2);
        QFETCH(const double, seconds);
        Parameters parameters;
        parameters.omega2 = omega2;
        Bench bench(parameters, {0.25, 7.0, 300});
        child<QToolButton>(bench.timeline, "oneTurnButton")->click();
        const Sampling &run = bench.session.sampling();
        QCOMPARE(run.start, 0.25);
        QCOMPARE(run.steps, 300);
        QVERIFY(std::abs(run.duration - (seconds > 0.0 ? seconds : 7.0)) < 1e-12);
    }

    void theSpeedIsAFactorOrSecondsATurn()
    {
        Parameters engine;
        engine.omega2 = 100.0 * std::numbers::pi; // a turn in 20 ms
        Bench bench(engine);
        auto *factor = child<NumberBox>(bench.timeline, "speedBox");
        auto *turn = child<NumberBox>(bench.timeline, "turnBox");
        QSignalSpy changed(&bench.timeline, &Timeline::speedChanged);
        type(turn, "4");
        QVERIFY(std::abs(bench.timeline.speed() - 0.005) < 1e-12);
        QVERIFY(std::abs(factor->value() - 0.005) < 1e-12);
        type(factor, "0.5");
        QCOMPARE(bench.timeline.speed(), 0.5);
        QVERIFY(std::abs(turn->value() - 0.04) < 1e-12);
        QCOMPARE(changed.count(), 2);
        bench.session.setParameter(Parameter::Omega2, 0.0);
        QVERIFY(!turn->isEnabled() && factor->isEnabled());
        type(factor, "-1");
        QCOMPARE(bench.timeline.speed(), 0.5);
    }

    void aSpeedIsReadAsItIsShown()
    {
        Bench bench;
        bench.timeline.show();
        bench.timeline.openRun();
        auto *factor = child<NumberBox>(bench.timeline, "speedBox");
        type(factor, "2×");
        QCOMPARE(bench.timeline.speed(), 2.0);
        type(factor, "1e12"); // refused, not cut
        QCOMPARE(bench.timeline.speed(), 2.0);
        QCOMPARE(child<QLabel>(bench.timeline, "refusalLabel")->text(), QString("This must be at most 10⁹×."));
        auto *turn = child<NumberBox>(bench.timeline, "turnBox");
        type(turn, "3500");
        QCOMPARE(turn->value(), 3500.0); // to the last digit
        QVERIFY(turn->text().startsWith("3500 "));
    }

    void fasterAndSlowerGoFromOneSpeedToTheNext()
    {
        Bench bench;
        bench.timeline.setSpeed(0.3);
        bench.timeline.faster();
        QCOMPARE(bench.timeline.speed(), 0.5);
        bench.timeline.slower();
        QCOMPARE(bench.timeline.speed(), 0.25);
        for (int i = 0; i < 20; ++i) {
            bench.timeline.faster();
        }
        QCOMPARE(bench.timeline.speed(), 10.0);
        bench.timeline.setSpeed(100.0);
        bench.timeline.faster();
        QCOMPARE(bench.timeline.speed(), 100.0);
        bench.timeline.setSpeed(0.001);
        bench.timeline.slower();
        QCOMPARE(bench.timeline.speed(), 0.001);
    }

    void aRunningInstantLeavesAloneWhatSomebodyTypes()
    {
        Bench bench;
        bench.timeline.show();
        QVERIFY(QTest::qWaitForWindowExposed(&bench.timeline));
        bench.timeline.activateWindow();
        auto *box = child<NumberBox>(bench.timeline, "timeBox");
        box->setFocus();
        AWAIT(box->hasFocus());
        box->selectAll();
        bench.session.setTime(0.6);
        QTest::keyClicks(box, "0.5");
        bench.session.setTime(0.7);
        QTest::keyClick(box, Qt::Key_Return);
        QCOMPARE(bench.session.time(), 0.5);
    }
};

QTEST_MAIN(TestTimeline)
#include "tst_timeline.moc"
