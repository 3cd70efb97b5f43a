// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Functions that let tests wait independently of the speed of the machine: until a condition is true or until all
// posted events are processed. Timers are triggered at once instead of waited for.

#include <QAbstractEventDispatcher>
#include <QCoreApplication>
#include <QTest>
#include <QThreadPool>
#include <QTimer>
#include <QTimerEvent>
#include <QWidget>

namespace slidercrank
{

/// Timeout in ms, reached only by a test that fails.
inline constexpr int kPatience = 120'000;

/// Like QTRY_VERIFY and QTRY_COMPARE, but with the timeout above and without their type conversions.
#define AWAIT_THEN(state, verify)                                                                                      \
    do {                                                                                                               \
        static_cast<void>(QTest::qWaitFor([&] { return static_cast<bool>(state); }, slidercrank::kPatience));          \
        verify;                                                                                                        \
    } while (false)
#define AWAIT(state) AWAIT_THEN(state, QVERIFY(state))
#define AWAIT2(state, hint) AWAIT_THEN(state, QVERIFY2(state, hint))
#define AWAIT_COMPARE(actual, expected) AWAIT_THEN((actual) == (expected), QCOMPARE(actual, expected))

/// Processes all posted events, including layout, painting and the events that these post.
inline void settle()
{
    constexpr int kMaxRounds = 100; // an animation posts events without end
    auto *events = QAbstractEventDispatcher::instance();
    int round = 0;
    do {
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    } while (events->processEvents(QEventLoop::AllEvents) && ++round < kMaxRounds);
}

/// Waits until all background tasks have finished and their results have been delivered.
inline void finishBackgroundTasks()
{
    if (auto *threads = QCoreApplication::instance()->findChild<QThreadPool *>("taskThreads")) {
        QVERIFY(threads->waitForDone(kPatience));
    }
    settle();
}

/// Triggers the active timers of the object at once.
inline void letTimePass(QObject &object)
{
    for (QTimer *timer : object.findChildren<QTimer *>(QString(), Qt::FindDirectChildrenOnly)) {
        if (timer->isActive()) {
            QTimerEvent now(timer->timerId());
            QCoreApplication::sendEvent(timer, &now);
        }
    }
}

/// Triggers the active timers of the window and of all our widgets in it.
inline void letTimePassIn(QWidget &window)
{
    letTimePass(window);
    for (QWidget *widget : window.findChildren<QWidget *>()) {
        if (QByteArrayView(widget->metaObject()->className()).startsWith("slidercrank::")) {
            letTimePass(*widget);
        }
    }
}

/// Processes all posted events and triggers the timers of the window.
inline void settle(QWidget &window)
{
    settle();
    letTimePassIn(window);
    settle();
}

} // namespace slidercrank
