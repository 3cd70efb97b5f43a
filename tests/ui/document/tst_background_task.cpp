// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/suite.h"
#include "ui/document/background_task.h"

#include "tests/support/waiting.h"

#include <QSemaphore>
#include <QSignalSpy>
#include <QTest>
#include <QThread>

#include <algorithm>
#include <memory>
#include <new>
#include <stdexcept>
#include <vector>

using namespace slidercrank;

namespace
{

using Stop = std::stop_token;
using Progress = BackgroundTask::Progress;

const auto kNever = [](const auto &...) { QFAIL("is not to be called"); };

const QList<QVariantList> kOnAndOff{{true}, {false}};

/// Work that waits until it is released, or stopped: then it returns -1.
struct Held {
    std::shared_ptr<QSemaphore> begun = std::make_shared<QSemaphore>(0);
    std::shared_ptr<QSemaphore> released = std::make_shared<QSemaphore>(0);

    int operator()(const Stop &stop, const Progress &) const
    {
        const std::stop_callback wake(stop, [this] { released->release(); });
        begun->release();
        released->acquire();
        return stop.stop_requested() ? -1 : 1;
    }
};

} // namespace

class tst_background_task : public QObject
{
    Q_OBJECT

private slots:
    void worksInAnotherThreadAndCallsBackInThisOne()
    {
        BackgroundTask task;
        QSignalSpy running(&task, &BackgroundTask::runningChanged);
        QThread *there = nullptr;
        QThread *here = nullptr;
        QString value;
        const auto work = [&there](const Stop &, const Progress &) {
            there = QThread::currentThread();
            return QStringLiteral("done");
        };
        const auto done = [&](const QString &made) {
            here = QThread::currentThread();
            value = made;
            QVERIFY(task.isRunning());
        };
        task.start(work, done, kNever);
        QVERIFY(task.isRunning() && value.isEmpty());
        AWAIT(!task.isRunning());
        QCOMPARE(value, QStringLiteral("done"));
        QVERIFY(there && there != thread());
        QCOMPARE(here, thread());
        QCOMPARE(QList<QVariantList>(running), kOnAndOff);
    }

    void reportsProgressInOrderAndBeforeTheValue()
    {
        BackgroundTask task;
        QSemaphore heard(0);
        std::vector<double> parts;
        connect(&task, &BackgroundTask::progressed, this, [&](double part) {
            parts.push_back(part);
            heard.release();
        });
        std::size_t before = 0;
        const auto work = [&](const Stop &, const Progress &progress) {
            progress(0.5);
            heard.acquire(); // is heard of while the work goes on
            for (int i = 500'000; i <= 1'000'000; ++i) {
                progress(i * 1e-6);
            }
            return 0;
        };
        task.start(
            work, [&](int) { before = parts.size(); }, kNever);
        AWAIT(!task.isRunning());
        QCOMPARE(before, parts.size());
        QVERIFY(std::ranges::is_sorted(parts) && parts.size() <= 1001);
        QVERIFY(std::ranges::count(parts, 0.5) == 1 && parts.back() <= 1.0);
    }

    void givesItsValueWhenItIsCancelled()
    {
        BackgroundTask task;
        task.cancel(); // allowed at any time
        int value = 0;
        const auto done = [&value](int made) { value = made; };
        const Held held;
        task.start(held, done, kNever);
        held.begun->acquire();
        task.cancel();
        QVERIFY(task.isRunning());
        AWAIT(!task.isRunning());
        QCOMPARE(value, -1);
        const Held next; // is not stopped
        task.start(next, done, kNever);
        next.released->release();
        AWAIT_COMPARE(value, 1);
    }

    void callsNobodyWhenItIsDiscarded()
    {
        BackgroundTask task;
        QSignalSpy running(&task, &BackgroundTask::runningChanged);
        connect(&task, &BackgroundTask::progressed, this, [] { QFAIL("nobody listens any more"); });
        const Held held;
        const auto work = [held](const Stop &stop, const Progress &progress) {
            held(stop, progress);
            progress(1.0);
            return 0;
        };
        task.start(work, kNever, kNever);
        held.begun->acquire();
        task.discard();
        QVERIFY(!task.isRunning());
        finishAside();
        QCOMPARE(QList<QVariantList>(running), kOnAndOff);
    }

    /// Started while other work is running, or by the callback of other work.
    void theLastWorkCounts()
    {
        BackgroundTask task;
        QSignalSpy running(&task, &BackgroundTask::runningChanged);
        const Held held;
        task.start(held, kNever, kNever);
        held.begun->acquire();
        int value = 0;
        const auto two = [](const Stop &, const Progress &) { return 2; };
        const auto next = [&](int) {
            task.start(
                two, [&value](int made) { value = made; }, kNever);
        };
        task.start(two, next, kNever);
        AWAIT_COMPARE(value, 2);
        finishAside();
        QCOMPARE(QList<QVariantList>(running), kOnAndOff);
    }

    void mayBeDeletedWhileItRunsOrWhenItIsDone()
    {
        const Held held;
        const auto captured = std::make_shared<int>();
        auto task = std::make_unique<BackgroundTask>();
        task->start(
            held, [captured](int) { QFAIL("is not to be called"); }, kNever);
        held.begun->acquire();
        task.reset();
        QCOMPARE(captured.use_count(), 1L); // the callback is destroyed at once, in this thread
        finishAside();

        auto *other = new BackgroundTask;
        const QPointer<BackgroundTask> guard(other);
        other->start([](const Stop &, const Progress &) { return 1; }, [other](int) { delete other; }, kNever);
        AWAIT(!guard);
    }

    void reportsExceptionsAsSentences()
    {
        const std::pair<std::function<void()>, const char *> rows[] = {
            {[] { throw std::bad_alloc(); }, "not enough memory"},
            {[] { throw std::runtime_error("a reason"); }, "a reason."}};
        for (const auto &[fail, text] : rows) {
            BackgroundTask task;
            QString sentence;
            const auto work = [fail = fail](const Stop &, const Progress &) {
                fail();
                return 0;
            };
            task.start(work, kNever, [&sentence](const QString &problem) { sentence = problem; });
            AWAIT(!task.isRunning());
            QVERIFY2(sentence.contains(QLatin1String(text)), qPrintable(sentence));
        }
    }

    /// Not even on a computer with few processors.
    void noWorkWaitsForLongTasks()
    {
        std::vector<std::unique_ptr<BackgroundTask>> lasting;
        for (int i = 0; i < QThread::idealThreadCount() + 6; ++i) {
            const Held held;
            lasting.push_back(std::make_unique<BackgroundTask>());
            lasting.back()->start(held, kNever, kNever);
            held.begun->acquire();
        }
        BackgroundTask edit;
        bool isDone = false;
        edit.start([](const Stop &, const Progress &) { return 1; }, [&isDone](int) { isDone = true; }, kNever);
        AWAIT(isDone);
        lasting.clear();
        finishAside();
    }
};

const Suite suite("tst_background_task", runWithEventLoop<tst_background_task>);
#include "tst_background_task.moc"
