// SPDX-License-Identifier: GPL-3.0-or-later

// Background tasks call back once, in the GUI thread, or not at all if they are discarded.

#include "tests/support/suite.h"
#include "tests/support/waiting.h"
#include "ui/document/background_task.h"

#include <QSemaphore>
#include <QSignalSpy>
#include <QTest>
#include <QThread>
#include <QThreadPool>

#include <algorithm>
#include <atomic>
#include <memory>
#include <new>
#include <stdexcept>
#include <vector>

using namespace slidercrank;

namespace tst_background_task
{

using Stop = std::stop_token;
using Progress = BackgroundTask::Progress;

const auto kFail = [](const auto &...) { QFAIL("must not be called"); };

const QList<QVariantList> kStartedAndEnded{{true}, {false}};

/// Work that waits until it is released and returns 1, or until it is stopped and returns -1.
struct WaitingWork {
    std::shared_ptr<QSemaphore> started = std::make_shared<QSemaphore>(0);
    std::shared_ptr<QSemaphore> released = std::make_shared<QSemaphore>(0);

    int operator()(const Stop &stop, const Progress &) const
    {
        const std::stop_callback wake(stop, [this] { released->release(); });
        started->release();
        released->acquire();
        return stop.stop_requested() ? -1 : 1;
    }
};

class TestBackgroundTask : public QObject
{
    Q_OBJECT

private slots:
    void doesPiecesUntilTheyEnd()
    {
        struct Pieces {
            int count = 0;
            bool advance() { return ++count < 5; }
            double progress() const { return count / 5.0; }
        };
        BackgroundTask task;
        int pieces = 0;
        task.startPieces(
            std::make_shared<Pieces>(), [&](const Pieces &done) { pieces = done.count; }, kFail);
        AWAIT_COMPARE(pieces, 5);
        AWAIT(!task.isRunning());
    }

    void handlesEventsBetweenPiecesInTheGuiThread()
    {
        struct Pieces {
            int count = 0;
            bool ranInOtherThread = false;
            bool advance()
            {
                ranInOtherThread = ranInOtherThread || QThread::currentThread() != qApp->thread();
                QThread::msleep(50); // longer than the 40 ms after which events are handled
                return ++count < 3;
            }
            double progress() const { return count / 3.0; }
        };
        BackgroundTask task;
        QSignalSpy running(&task, &BackgroundTask::runningChanged);
        std::vector<double> reportedProgress;
        connect(&task, &BackgroundTask::progressed, this, [&](double value) { reportedProgress.push_back(value); });
        bool ranInOtherThread = true;
        task.startPiecesInGuiThread(
            std::make_shared<Pieces>(), [&](const Pieces &done) { ranInOtherThread = done.ranInOtherThread; }, kFail);
        QVERIFY(task.isRunning() && reportedProgress.empty());
        QCoreApplication::processEvents();
        QVERIFY(task.isRunning());
        AWAIT(!task.isRunning());
        QVERIFY(!ranInOtherThread);
        QCOMPARE(reportedProgress, std::vector<double>({1.0 / 3.0, 2.0 / 3.0, 1.0}));
        QCOMPARE(QList<QVariantList>(running), kStartedAndEnded);
    }

    void leavesPiecesThatAreDiscarded()
    {
        struct Endless {
            std::atomic<int> count = 0;
            bool advance() { return ++count > 0; }
            double progress() const { return 0.5; }
        };
        BackgroundTask task;
        const auto pieces = std::make_shared<Endless>();
        task.startPieces(
            pieces, [](const Endless &) { QFAIL("must not be called"); }, kFail);
        AWAIT(pieces->count > 10);
        task.discard();
        AWAIT_COMPARE(pieces.use_count(), 1L);
    }

    void runsInAnotherThreadAndCallsBackInThisOne()
    {
        BackgroundTask task;
        QSignalSpy running(&task, &BackgroundTask::runningChanged);
        QThread *workThread = nullptr;
        QThread *doneThread = nullptr;
        const auto work = [](const Stop &, const Progress &) { return QThread::currentThread(); };
        const auto done = [&](QThread *value) {
            workThread = value;
            doneThread = QThread::currentThread();
            QVERIFY(task.isRunning());
        };
        task.start(work, done, kFail);
        QVERIFY(task.isRunning() && !doneThread);
        AWAIT(!task.isRunning());
        QVERIFY(workThread && workThread != thread());
        QCOMPARE(doneThread, thread());
        QCOMPARE(QList<QVariantList>(running), kStartedAndEnded);
    }

    void reportsProgressInOrderAndBeforeTheValue()
    {
        BackgroundTask task;
        QSemaphore reported(0);
        std::vector<double> reportedProgress;
        connect(&task, &BackgroundTask::progressed, this, [&](double value) {
            reportedProgress.push_back(value);
            reported.release();
        });
        std::size_t reportsBeforeValue = 0;
        const auto work = [&](const Stop &, const Progress &progress) {
            progress(0.5);
            reported.acquire(); // is reported while the work continues
            for (int i = 500'000; i <= 1'000'000; ++i) {
                progress(i * 1e-6);
            }
            return 0;
        };
        task.start(
            work, [&](int) { reportsBeforeValue = reportedProgress.size(); }, kFail);
        AWAIT(!task.isRunning());
        QCOMPARE(reportsBeforeValue, reportedProgress.size());
        QVERIFY(std::ranges::is_sorted(reportedProgress) && reportedProgress.size() <= 1001);
        QVERIFY(std::ranges::count(reportedProgress, 0.5) == 1 && reportedProgress.back() <= 1.0);
    }

    void callsNothingAfterBeingDiscarded()
    {
        BackgroundTask task;
        QSignalSpy running(&task, &BackgroundTask::runningChanged);
        connect(&task, &BackgroundTask::progressed, this, [] { QFAIL("must not be emitted"); });
        const WaitingWork waiting;
        const auto work = [waiting](const Stop &stop, const Progress &progress) {
            waiting(stop, progress);
            progress(1.0);
            return 0;
        };
        task.start(work, kFail, kFail);
        waiting.started->acquire();
        task.discard();
        QVERIFY(!task.isRunning());
        finishBackgroundTasks();
        QCOMPARE(QList<QVariantList>(running), kStartedAndEnded);
    }

    /// The new work may be started while other work is running, or by the callback of other work.
    void newWorkReplacesRunningWork()
    {
        BackgroundTask task;
        QSignalSpy running(&task, &BackgroundTask::runningChanged);
        const WaitingWork waiting;
        task.start(waiting, kFail, kFail);
        waiting.started->acquire();
        int value = 0;
        const auto two = [](const Stop &, const Progress &) { return 2; };
        const auto next = [&](int) {
            task.start(
                two, [&value](int result) { value = result; }, kFail);
        };
        task.start(two, next, kFail);
        AWAIT_COMPARE(value, 2);
        finishBackgroundTasks();
        QCOMPARE(QList<QVariantList>(running), kStartedAndEnded);
    }

    void canBeDeletedWhileRunningAndInItsCallback()
    {
        const WaitingWork waiting;
        const auto captured = std::make_shared<int>();
        auto task = std::make_unique<BackgroundTask>();
        task->start(
            waiting, [captured](int) { QFAIL("must not be called"); }, kFail);
        waiting.started->acquire();
        task.reset();
        QCOMPARE(captured.use_count(), 1L); // the callback is destroyed at once, in this thread
        finishBackgroundTasks();

        auto *deletedTask = new BackgroundTask;
        const QPointer<BackgroundTask> guard(deletedTask);
        deletedTask->start([](const Stop &, const Progress &) { return 1; }, [deletedTask](int) { delete deletedTask; },
                           kFail);
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
            task.start(work, kFail, [&sentence](const QString &problem) { sentence = problem; });
            AWAIT(!task.isRunning());
            QVERIFY2(sentence.contains(text), qPrintable(sentence));
        }
    }

    /// A short task starts at once also on a computer with few processors.
    void shortTasksDoNotWaitForLongTasks()
    {
        std::vector<std::unique_ptr<BackgroundTask>> longTasks;
        for (int i = 0; i < QThread::idealThreadCount() + 6; ++i) {
            const WaitingWork waiting;
            longTasks.push_back(std::make_unique<BackgroundTask>());
            longTasks.back()->start(waiting, kFail, kFail);
            waiting.started->acquire();
        }
        BackgroundTask shortTask;
        bool isDone = false;
        shortTask.start([](const Stop &, const Progress &) { return 1; }, [&isDone](int) { isDone = true; }, kFail);
        AWAIT(isDone);
        longTasks.clear();
        finishBackgroundTasks();
    }

    /// Tasks must not occupy the threads of Qt's global pool, with which Qt paints.
    void leavesTheThreadsOfQtAlone()
    {
        const WaitingWork waiting;
        BackgroundTask task;
        task.start(waiting, kFail, kFail);
        waiting.started->acquire();
        const QThreadPool &threadsOfQt = *QThreadPool::globalInstance();
        QCOMPARE(threadsOfQt.activeThreadCount(), 0);
        QCOMPARE(threadsOfQt.maxThreadCount(), QThread::idealThreadCount());
        task.discard();
        finishBackgroundTasks();
    }
};

const Suite<TestBackgroundTask> suite("tst_background_task");

} // namespace tst_background_task

#include "tst_background_task.moc"
