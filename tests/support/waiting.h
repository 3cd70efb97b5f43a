// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// How tests wait, on a machine of any speed: for a state, as long as it takes; for what is posted, until it is done;
// for a timer, not at all.

#include <QAbstractEventDispatcher>
#include <QCoreApplication>
#include <QTest>
#include <QThreadPool>
#include <QTimer>
#include <QTimerEvent>
#include <QWidget>

namespace slidercrank
{

/// Only a test that is red waits so long, ms.
inline constexpr int kPatience = 120'000;

/// As QTRY_VERIFY and its like, but with patience, and without their conversions.
#define AWAIT_THEN(state, verify)                                                                                      \
    do {                                                                                                               \
        static_cast<void>(QTest::qWaitFor([&] { return static_cast<bool>(state); }, slidercrank::kPatience));          \
        verify;                                                                                                        \
    } while (false)
#define AWAIT(state) AWAIT_THEN(state, QVERIFY(state))
#define AWAIT2(state, hint) AWAIT_THEN(state, QVERIFY2(state, hint))
#define AWAIT_COMPARE(actual, expected) AWAIT_THEN((actual) == (expected), QCOMPARE(actual, expected))

/// Lays out, paints and does all else that is posted, and what that posts in its turn.
inline void settle()
{
    constexpr int kMostRounds = 100; // what plays is never done
    auto *events = QAbstractEventDispatcher::instance();
    int round = 0;
    do {
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    } while (events->processEvents(QEventLoop::AllEvents) && ++round < kMostRounds);
}

/// What is done in other threads is over, and has been heard of.
inline void finishAside()
{
    QVERIFY(QThreadPool::globalInstance()->waitForDone(kPatience));
    settle();
}

/// What the object's own timers would do later they do now.
inline void letTimePass(QObject &object)
{
    for (QTimer *timer : object.findChildren<QTimer *>(QString(), Qt::FindDirectChildrenOnly)) {
        if (timer->isActive()) {
            QTimerEvent now(timer->timerId());
            QCoreApplication::sendEvent(timer, &now);
        }
    }
}

/// The same of the window and of all that we put into it.
inline void letTimePassIn(QWidget &window)
{
    letTimePass(window);
    for (QWidget *widget : window.findChildren<QWidget *>()) {
        if (QByteArrayView(widget->metaObject()->className()).startsWith("slidercrank::")) {
            letTimePass(*widget);
        }
    }
}

/// As settle(), with what the window was to show in a moment.
inline void settle(QWidget &window)
{
    settle();
    letTimePassIn(window);
    settle();
}

} // namespace slidercrank
