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
struct TestedTimeline {
    Session session;
    Timeline timeline{&session};
    double clock = 1234.5; // s

    explicit TestedTimeline(const Parameters &parameters = {}, const Sampling &sampling = {})
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
        TestedTimeline tested({}, {0.0, 100.0, 200});
        tested.clock += 7.0; // before playback
        tested.click("playButton");
        QCOMPARE(child<QToolButton>(tested.timeline, "playButton")->accessibleName(), "Pause");
        double time = 0.0;
        for (const double speed : {1.0, 2.0, 0.1}) { // the speed changes while it plays
            tested.timeline.setSpeed(speed);
            for (const double frame : {0.016, 0.016, 0.2, 0.016}) { // one frame is late
                tested.passTime(frame);
                time += speed * frame;
                QVERIFY(tested.shows(time));
            }
        }
        tested.session.setTime(50.0); // the user scrubs
        tested.passTime(2.5);
        QVERIFY(tested.shows(50.25));
        tested.timeline.togglePlaying();
        tested.passTime(0.5);
        QVERIFY(tested.shows(50.25)); // playback is paused
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
        TestedTimeline tested({}, {0.5, 0.1, 20});
        tested.timeline.play();
        for (const double time : {0.56, 0.52, 0.58, 0.54}) {
            tested.passTime(0.06);
            QVERIFY(tested.shows(time));
        }
        tested.click("loopButton");
        tested.passTime(0.09);
        QVERIFY(!tested.timeline.isPlaying());
        QCOMPARE(tested.session.time(), 0.6);
        tested.timeline.play(); // from the beginning
        tested.passTime(0.05);
        QVERIFY(tested.shows(0.55));
    }

    void buttonsStepFromSampleToSample()
    {
        TestedTimeline tested;
        struct Row {
            const char *button;
            double from;
            double to;
        };
        for (const Row &row :
             {Row{"forwardButton", 0.0, 0.005}, Row{"forwardButton", 0.0123, 0.015}, Row{"forwardButton", 0.3, 0.305},
              Row{"forwardButton", 1.0, 1.0}, Row{"backButton", 0.01, 0.005}, Row{"backButton", 0.0123, 0.01},
              Row{"backButton", 0.0, 0.0}, Row{"endButton", 0.3, 1.0}, Row{"startButton", 0.3, 0.0}}) {
            tested.session.setTime(row.from);
            tested.click(row.button);
            QCOMPARE(tested.session.time(), row.to);
        }
    }

    void showsAndChangesTheTime()
    {
        TestedTimeline tested;
        QSignalSpy changes(&tested.session, &Session::timeChanged);
        tested.session.setTime(0.25);
        QCOMPARE(tested.box("timeBox")->value(), 0.25);
        QVERIFY(std::abs(tested.box("angleBox")->value() - 90.0) < 1e-9);
        auto *slider = child<QSlider>(tested.timeline, "timeSlider");
        QCOMPARE(slider->value(), 50);
        QCOMPARE(changes.count(), 1); // no echo
        slider->setValue(150);
        QCOMPARE(tested.session.time(), 0.75);
        for (const auto &[typed, time] : {std::pair{"0.3217", 0.3217}, {"7", 1.0}, {"8", 1.0}, {"noon", 1.0}}) {
            typeNumber(tested.box("timeBox"), typed);
            QCOMPARE(tested.session.time(), time);
            QCOMPARE(tested.box("timeBox")->value(), time);
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
              // An angle that the crank does not pass leads to the nearer end of the time range.
              Row{turn, 0, 0, 0.25, "120", 0.25}, Row{turn, 0, 0, 0.25, "300", 0.0},
              Row{-turn, 0, 0, 0.25, "-120", 0.25}}) {
            TestedTimeline tested({.omega2 = row.omega2, .theta20 = row.theta20}, {row.start, row.duration, 200});
            tested.session.setTime(row.start + 0.4 * row.duration);
            typeNumber(tested.box("angleBox"), row.typed);
            QVERIFY2(tested.shows(row.time), row.typed);
        }
    }

    /// The table, the limits and the search also show angles from 0° to 360°.
    void showsTheCrankAngleWithinARevolution()
    {
        const double turn = 2.0 * std::numbers::pi; // rad/s
        TestedTimeline clockwise({.omega2 = -turn}, {0.0, 1.0, 200});
        typeNumber(clockwise.box("angleBox"), "60");
        QVERIFY(std::abs(clockwise.box("angleBox")->value() - 60.0) < 1e-9);
        QVERIFY(clockwise.shows(5.0 / 6.0));

        TestedTimeline twice({.omega2 = turn}, {0.0, 2.0, 200});
        twice.session.setTime(1.25);
        NumberBox *box = twice.box("angleBox");
        QVERIFY(std::abs(box->value() - 90.0) < 1e-9);
        box->stepUp(); // stays in the second revolution
        QVERIFY(std::abs(twice.session.time() - (1.25 + 1.0 / 360.0)) < 1e-9);
        QVERIFY(std::abs(box->value() - 91.0) < 1e-9);
    }

    void changesOnlyTheSettingOfEachBox()
    {
        TestedTimeline tested({}, {0.5, 2.5, 400});
        struct Row {
            const char *box;
            const char *typed;
            Sampling sampling;
        };
        for (const Row &row :
             {Row{"stepsBox", "500", {0.5, 2.5, 500}}, Row{"durationBox", "3.25", {0.5, 3.25, 500}},
              Row{"startBox", "-1", {-1.0, 3.25, 500}}, Row{"durationBox", "0", {-1.0, 3.25, 500}},
              Row{"durationBox", "-2", {-1.0, 3.25, 500}}, Row{"startBox", "1e13", {-1.0, 3.25, 500}}}) {
            typeNumber(tested.box(row.box), row.typed);
            QCOMPARE(tested.session.sampling(), row.sampling);
        }
        tested.session.undoStack().undo();
        QCOMPARE(tested.box("durationBox")->value(), 2.5); // the edits form one undo step
        QCOMPARE(tested.box("stepsBox")->value(), 400.0);
        QCOMPARE(tested.box("startBox")->value(), 0.5);
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
            TestedTimeline tested({.omega2 = row.omega2}, {0.25, 7.0, 300});
            tested.click("oneTurnButton");
            const Sampling &sampling = tested.session.sampling();
            QCOMPARE(sampling.start, 0.25);
            QCOMPARE(sampling.steps, 300);
            QVERIFY(std::abs(sampling.duration - row.seconds) < 1e-12);
        }
    }

    /// A former defect: a slow crank does not reach every angle in a second, and 330° led to 0° without a message.
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
            TestedTimeline tested({.omega2 = row.omega2}, {0.0, row.duration, 200});
            auto *offer = child<QToolButton>(tested.timeline, "oneTurnOffer");
            QCOMPARE(!offer->isHidden(), row.isOffered);
            if (row.isOffered) {
                tested.click("oneTurnOffer");
                QVERIFY(offer->isHidden());
                typeNumber(tested.box("angleBox"), "330");
                QVERIFY(std::abs(tested.box("angleBox")->value() - 330.0) < 1e-9);
            }
        }
    }

    /// In a narrow window, the offer is not cut off by the button beside it.
    void theOfferFitsBesideTheTimeRange()
    {
        TestedTimeline tested({.omega2 = -628.0}, {0.0, 1.0, 200});
        auto *offer = child<QToolButton>(tested.timeline, "oneTurnOffer");
        auto *timeRange = child<QToolButton>(tested.timeline, "runButton");
        tested.timeline.show();
        for (const int width : {400, 330, 600}) {
            tested.timeline.resize(width, tested.timeline.height());
            QCoreApplication::processEvents();
            QVERIFY(offer->width() >= offer->sizeHint().width());
            QVERIFY(timeRange->width() >= timeRange->sizeHint().width());
        }
        QVERIFY(timeRange->text().startsWith("1 s"));
    }

    void setsTheSpeed()
    {
        TestedTimeline tested({}, {0.0, 2.5, 200});
        for (const auto &[typed, speed] : {std::pair{"0.5×", 0.5}, {"-1", 0.5}, {"1e12", 0.5}, {"0.005", 0.005}}) {
            typeNumber(tested.box("speedBox"), QString::fromUtf8(typed));
            QCOMPARE(tested.timeline.speed(), speed);
        }
        QCOMPARE(child<QToolButton>(tested.timeline, "runButton")->text(), "2.5 s · 0.005× ▾");
        tested.session.setParameter(Parameter::Omega2, 0.0);
        QVERIFY(tested.box("angleBox")->isEnabled()); // it turns a crank at rest
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
