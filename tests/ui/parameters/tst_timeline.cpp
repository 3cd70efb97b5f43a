// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/controls/number_box.h"
#include "ui/document/session.h"
#include "ui/parameters/timeline.h"

#include <QComboBox>
#include <QElapsedTimer>
#include <QSignalSpy>
#include <QSlider>
#include <QTest>
#include <QThread>
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

/// A timeline in its place: what it asks for comes back as a pose.
struct Bench {
    Session session;
    Timeline timeline;
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
        session.setParameters(parameters);
        session.setSampling(sampling);
        session.setTime(sampling.start);
        requested.clear();
    }
};

double seconds(const QElapsedTimer &clock)
{
    return static_cast<double>(clock.nsecsElapsed()) * 1e-9;
}

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
        QTest::qWait(60);
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
        QElapsedTimer clock;
        clock.start();
        bench.timeline.play();
        QVERIFY(bench.timeline.isPlaying());
        QTest::qWait(300);
        const double before = seconds(clock);
        QThread::msleep(200); // a machine too slow for frames
        QCoreApplication::processEvents();
        QTest::qWait(40);
        const double after = seconds(clock);
        bench.timeline.pause();
        QVERIFY(bench.requested.size() > 3);
        const double shown = bench.requested.back();
        // Not behind by more than a few frames, and never ahead; the slept 200 ms must be in it.
        QVERIFY2(shown <= speed * after && shown > speed * (before + 0.1), qPrintable(QString::number(shown)));
    }

    void nothingRunsWhenPaused()
    {
        Bench bench;
        bench.timeline.play();
        QTest::qWait(60);
        bench.timeline.pause();
        const std::size_t count = bench.requested.size();
        QTest::qWait(80);
        QCOMPARE(bench.requested.size(), count);
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
        QTest::qWait(350);
        QVERIFY(bench.timeline.isPlaying());
        bench.timeline.pause();
        bool wrapped = false;
        for (std::size_t i = 0; i < bench.requested.size(); ++i) {
            QVERIFY(bench.requested[i] >= 0.0 && bench.requested[i] <= 0.1);
            wrapped = wrapped || (i > 0 && bench.requested[i] < bench.requested[i - 1]);
        }
        QVERIFY(wrapped);
    }

    void stopsAtTheEndWithoutLoop()
    {
        Bench bench({}, {0.0, 0.1, 20});
        child<QToolButton>(bench.timeline, "loopButton")->click();
        bench.timeline.play();
        QTRY_VERIFY_WITH_TIMEOUT(!bench.timeline.isPlaying(), 3000);
        QCOMPARE(bench.requested.back(), 0.1);
        // Played again, it starts from the beginning.
        bench.timeline.play();
        QTRY_VERIFY(bench.requested.back() < 0.1);
    }

    void goesOnFromWhereSomebodyScrubbed()
    {
        Bench bench({}, {0.0, 100.0, 200});
        bench.timeline.play();
        QTest::qWait(50);
        bench.session.setTime(50.0);
        bench.requested.clear();
        QTRY_VERIFY(!bench.requested.empty());
        QVERIFY(bench.timeline.isPlaying());
        QVERIFY(bench.requested.front() >= 50.0 && bench.requested.front() < 53.0);
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

    void theSpeedIsChosen()
    {
        Bench bench;
        auto *box = child<QComboBox>(bench.timeline, "speedBox");
        QCOMPARE(box->currentText(), QString("1×"));
        bench.timeline.setSpeed(0.1);
        QCOMPARE(box->currentText(), QString("0.1×"));
        bench.timeline.setSpeed(1000.0);
        QCOMPARE(box->currentText(), QString("10×"));
        QCOMPARE(box->itemText(0), QString("0.1×"));
        QCOMPARE(box->itemText(box->count() - 1), QString("10×"));
    }

    void aFocusedButtonLeavesSpaceToTheWindow()
    {
        class Window : public QWidget
        {
        public:
            int spaces = 0;

        protected:
            void keyPressEvent(QKeyEvent *event) override { spaces += event->key() == Qt::Key_Space ? 1 : 0; }
        };
        Window window;
        auto *timeline = new Timeline(&window);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        auto *loop = child<QToolButton>(*timeline, "loopButton");
        loop->setFocus();
        QTest::keyClick(loop, Qt::Key_Space);
        QCOMPARE(window.spaces, 1);
        QVERIFY(loop->isChecked());
        QTest::keyClick(loop, Qt::Key_Return);
        QVERIFY(!loop->isChecked());
    }

    void aRunningInstantLeavesAloneWhatSomebodyTypes()
    {
        Bench bench;
        bench.timeline.show();
        QVERIFY(QTest::qWaitForWindowExposed(&bench.timeline));
        bench.timeline.activateWindow();
        auto *box = child<NumberBox>(bench.timeline, "timeBox");
        box->setFocus();
        QTRY_VERIFY(box->hasFocus());
        box->selectAll();
        QTest::keyClicks(box, "0.5");
        bench.session.setTime(0.7);
        QTest::keyClick(box, Qt::Key_Return);
        QCOMPARE(bench.session.time(), 0.5);
    }
};

QTEST_MAIN(TestTimeline)
#include "tst_timeline.moc"
