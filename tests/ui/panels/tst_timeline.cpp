// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/session.h"
#include "ui/panels/timeline.h"
#include "ui/widgets/number_box.h"

#include "tests/support/suite.h"
#include "tests/support/waiting.h"
#include "tests/support/widget_parts.h"

#include <QMenu>
#include <QSignalSpy>
#include <QSlider>
#include <QTest>
#include <QToolButton>

#include <cmath>
#include <numbers>

using namespace slidercrank;

namespace tst_timeline
{

/// A timeline with its session. Its clock advances only in passTime().
struct Bench {
    Session session;
    Timeline timeline{&session};
    double clock = 1234.5; // s

    explicit Bench(const Parameters &parameters = {}, const Sampling &sampling = {})
    {
        session.setParameters(parameters);
        session.setSampling(sampling);
        session.setTime(sampling.start);
        session.endDrag(); // what follows is a new undo step
        timeline.setClock([this] { return clock; });
    }

    /// Advances the clock and shows the next frame.
    void passTime(double seconds)
    {
        clock += seconds;
        letTimePass(timeline);
    }
    bool shows(double time) const { return std::abs(session.time() - time) < 1e-9; }
    NumberBox *box(const QString &name) const { return child<NumberBox>(timeline, name); }
    void click(const QString &button) const { child<QToolButton>(timeline, button)->click(); }
};

class TestTimeline : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void playsByTheClock()
    {
        Bench bench({}, {0.0, 100.0, 200});
        bench.clock += 7.0; // before playback
        bench.click("playButton");
        QCOMPARE(child<QToolButton>(bench.timeline, "playButton")->accessibleName(), "Pause");
        double time = 0.0;
        for (const double speed : {1.0, 2.0, 0.1}) { // the speed changes while it plays
            bench.timeline.setSpeed(speed);
            for (const double frame : {0.016, 0.016, 0.2, 0.016}) { // one frame is late
                bench.passTime(frame);
                time += speed * frame;
                QVERIFY(bench.shows(time));
            }
        }
        bench.session.setTime(50.0); // the user scrubs
        bench.passTime(2.5);
        QVERIFY(bench.shows(50.25));
        bench.timeline.togglePlaying();
        bench.passTime(0.5);
        QVERIFY(bench.shows(50.25)); // playback is paused
    }

    void playsWithTheRealClock()
    {
        Session session;
        Timeline timeline(&session); // without setClock()
        session.setSampling({0.0, 1e6, 200});
        timeline.play();
        AWAIT(session.time() > 0.1); // several frames
    }

    void startsAgainOrStopsAtTheEnd()
    {
        Bench bench({}, {0.5, 0.1, 20});
        bench.timeline.play();
        for (const double time : {0.56, 0.52, 0.58, 0.54}) {
            bench.passTime(0.06);
            QVERIFY(bench.shows(time));
        }
        bench.click("loopButton");
        bench.passTime(0.09);
        QVERIFY(!bench.timeline.isPlaying());
        QCOMPARE(bench.session.time(), 0.6);
        bench.timeline.play(); // from the beginning
        bench.passTime(0.05);
        QVERIFY(bench.shows(0.55));
    }

    void buttonsStepFromSampleToSample()
    {
        Bench bench;
        struct Row {
            const char *button;
            double from;
            double to;
        };
        for (const Row &row :
             {Row{"forwardButton", 0.0, 0.005}, Row{"forwardButton", 0.0123, 0.015}, Row{"forwardButton", 0.3, 0.305},
              Row{"forwardButton", 1.0, 1.0}, Row{"backButton", 0.01, 0.005}, Row{"backButton", 0.0123, 0.01},
              Row{"backButton", 0.0, 0.0}, Row{"endButton", 0.3, 1.0}, Row{"startButton", 0.3, 0.0}}) {
            bench.session.setTime(row.from);
            bench.click(row.button);
            QCOMPARE(bench.session.time(), row.to);
        }
    }

    void showsTheTimeAndTakesAnother()
    {
        Bench bench;
        QSignalSpy changes(&bench.session, &Session::timeChanged);
        bench.session.setTime(0.25);
        QCOMPARE(bench.box("timeBox")->value(), 0.25);
        QVERIFY(std::abs(bench.box("angleBox")->value() - 90.0) < 1e-9);
        auto *slider = child<QSlider>(bench.timeline, "timeSlider");
        QCOMPARE(slider->value(), 50);
        QCOMPARE(changes.count(), 1); // no echo
        slider->setValue(150);
        QCOMPARE(bench.session.time(), 0.75);
        for (const auto &[typed, time] : {std::pair{"0.3217", 0.3217}, {"7", 1.0}, {"8", 1.0}, {"noon", 1.0}}) {
            typeNumber(bench.box("timeBox"), typed);
            QCOMPARE(bench.session.time(), time);
            QCOMPARE(bench.box("timeBox")->value(), time);
        }
    }

    void goesWhereTheCrankPassesAnAngle()
    {
        struct Row {
            double omega2;
            double theta20;
            double start;
            double duration;
            const char *typed; ///< degrees
            double time;
        };
        const double turn = 2.0 * std::numbers::pi; // rad/s: a revolution a second
        const double right = std::numbers::pi / 2.0;
        for (const Row &row :
             {Row{turn, 0, 0, 1, "60", 1.0 / 6.0}, Row{turn, 0, 0, 1, "0", 0.0}, Row{turn, 0, 0, 1, "360", 1.0},
              Row{turn, 0, 0, 1, "-300", 1.0 / 6.0}, Row{turn, 0, 0, 2, "420", 7.0 / 6.0},
              Row{turn, 0, 0, 2, "60", 1.0 / 6.0}, Row{turn, 0, 5.25, 1, "60", 6.0 + 1.0 / 6.0},
              Row{turn, right, 0, 1, "60", 11.0 / 12.0}, Row{-turn, 0, 0, 1, "60", 5.0 / 6.0},
              // Not passed: the nearer end.
              Row{turn, 0, 0, 0.25, "120", 0.25}, Row{turn, 0, 0, 0.25, "300", 0.0},
              Row{-turn, 0, 0, 0.25, "-120", 0.25}}) {
            Bench bench({.omega2 = row.omega2, .theta20 = row.theta20}, {row.start, row.duration, 200});
            bench.session.setTime(row.start + 0.4 * row.duration);
            typeNumber(bench.box("angleBox"), row.typed);
            QVERIFY2(bench.shows(row.time), row.typed);
        }
    }

    /// The table, the limits and the search also show angles from 0° to 360°.
    void showsTheCrankAngleWithinARevolution()
    {
        const double turn = 2.0 * std::numbers::pi; // rad/s
        Bench clockwise({.omega2 = -turn}, {0.0, 1.0, 200});
        typeNumber(clockwise.box("angleBox"), "60");
        QVERIFY(std::abs(clockwise.box("angleBox")->value() - 60.0) < 1e-9);
        QVERIFY(clockwise.shows(5.0 / 6.0));

        Bench twice({.omega2 = turn}, {0.0, 2.0, 200});
        twice.session.setTime(1.25);
        NumberBox *box = twice.box("angleBox");
        QVERIFY(std::abs(box->value() - 90.0) < 1e-9);
        box->stepUp(); // stays in the second revolution
        QVERIFY(std::abs(twice.session.time() - (1.25 + 1.0 / 360.0)) < 1e-9);
        QVERIFY(std::abs(box->value() - 91.0) < 1e-9);
    }

    void changesOnlyTheSettingOfEachBox()
    {
        Bench bench({}, {0.5, 2.5, 400});
        struct Row {
            const char *box;
            const char *typed;
            Sampling sampling;
        };
        for (const Row &row :
             {Row{"stepsBox", "500", {0.5, 2.5, 500}}, Row{"durationBox", "3.25", {0.5, 3.25, 500}},
              Row{"startBox", "-1", {-1.0, 3.25, 500}}, Row{"durationBox", "0", {-1.0, 3.25, 500}},
              Row{"durationBox", "-2", {-1.0, 3.25, 500}}, Row{"startBox", "1e13", {-1.0, 3.25, 500}}}) {
            typeNumber(bench.box(row.box), row.typed);
            QCOMPARE(bench.session.sampling(), row.sampling);
        }
        bench.session.undoStack().undo();
        QCOMPARE(bench.box("durationBox")->value(), 2.5); // the edits form one undo step
        QCOMPARE(bench.box("stepsBox")->value(), 400.0);
        QCOMPARE(bench.box("startBox")->value(), 0.5);
    }

    void setsTheDurationToOneRevolution()
    {
        struct Row {
            double omega2;
            double seconds; ///< 7 (unchanged) if the crank is at rest or too slow
        };
        const double pi = std::numbers::pi;
        for (const Row &row :
             {Row{2.0 * pi, 1.0}, Row{-4.0 * pi, 0.5}, Row{100.0 * pi, 0.02}, Row{0.0, 7.0}, Row{1e-13, 7.0}}) {
            Bench bench({.omega2 = row.omega2}, {0.25, 7.0, 300});
            bench.click("oneTurnButton");
            const Sampling &run = bench.session.sampling();
            QCOMPARE(run.start, 0.25);
            QCOMPARE(run.steps, 300);
            QVERIFY(std::abs(run.duration - row.seconds) < 1e-12);
        }
    }

    /// A slow crank does not reach every angle in a second: 330° went to 0° without a word.
    void offersOneRevolutionIfThereAreManyOrLess()
    {
        const double turn = 2.0 * std::numbers::pi; // rad/s
        struct Row {
            double omega2;
            double duration;
            bool isOffered;
        };
        for (const Row &row : {Row{turn, 1.0, false}, Row{6.28, 1.0, false}, Row{2.0, 1.0, true}, Row{-2.0, 1.0, true},
                               Row{2.0, 4.0, false}, Row{100.0, 0.3, false}, Row{100.0, 1.0, true},
                               Row{100.0, 0.03, true}, Row{0.0, 1.0, false}, Row{1e-13, 1.0, false}}) {
            Bench bench({.omega2 = row.omega2}, {0.0, row.duration, 200});
            auto *offer = child<QToolButton>(bench.timeline, "oneTurnOffer");
            QCOMPARE(!offer->isHidden(), row.isOffered);
            if (row.isOffered) {
                bench.click("oneTurnOffer");
                QVERIFY(offer->isHidden());
                typeNumber(bench.box("angleBox"), "330");
                QVERIFY(std::abs(bench.box("angleBox")->value() - 330.0) < 1e-9);
            }
        }
    }

    /// In a narrow window, the offer is not cut off by the button beside it.
    void theOfferFitsBesideTheTimeRange()
    {
        Bench bench({.omega2 = -628.0}, {0.0, 1.0, 200});
        auto *offer = child<QToolButton>(bench.timeline, "oneTurnOffer");
        auto *timeRange = child<QToolButton>(bench.timeline, "runButton");
        bench.timeline.show();
        for (const int width : {400, 330, 600}) {
            bench.timeline.resize(width, bench.timeline.height());
            QCoreApplication::processEvents();
            QVERIFY(offer->width() >= offer->sizeHint().width());
            QVERIFY(timeRange->width() >= timeRange->sizeHint().width());
        }
        QVERIFY(timeRange->text().startsWith("1 s"));
    }

    void setsTheSpeed()
    {
        Bench bench({}, {0.0, 2.5, 200});
        for (const auto &[typed, speed] : {std::pair{"0.5×", 0.5}, {"-1", 0.5}, {"1e12", 0.5}, {"0.005", 0.005}}) {
            typeNumber(bench.box("speedBox"), QString::fromUtf8(typed));
            QCOMPARE(bench.timeline.speed(), speed);
        }
        QCOMPARE(child<QToolButton>(bench.timeline, "runButton")->text(), "2.5 s · 0.005× ▾");
        bench.session.setParameter(Parameter::Omega2, 0.0);
        QVERIFY(bench.box("angleBox")->isEnabled()); // it turns a crank at rest
    }

    void changesTheSpeedFromTheMenu()
    {
        Session session;
        Timeline timeline(&session);
        QMenu menu;
        timeline.fillMenu(&menu);
        struct Row {
            double before;
            const char *action;
            double after;
        };
        for (const Row &row : {Row{0.3, "Faster", 0.6}, Row{0.3, "Slower", 0.15}, Row{0.9e9, "Faster", 1e9},
                               Row{1.5e-9, "Slower", 1e-9}}) {
            timeline.setSpeed(row.before);
            for (QAction *action : timeline.findChildren<QAction *>()) {
                if (action->text().remove(u'&') == row.action) {
                    action->trigger();
                }
            }
            QCOMPARE(timeline.speed(), row.after);
        }
    }
};

const Suite<TestTimeline> suite("tst_timeline");

} // namespace tst_timeline

#include "tst_timeline.moc"
