// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/background_task.h"

#include <QCoreApplication>
#include <QDeadlineTimer>
#include <QPointer>
#include <QTimer>
#if QT_CONFIG(future)
#include <QFutureWatcher>
#include <QPromise>
#include <QThreadPool>
#include <QtConcurrentRun>
#endif

#include <chrono>
#include <exception>
#include <new>

namespace slidercrank
{

namespace
{

#if QT_CONFIG(future)
constexpr int kProgressSteps = 1000; // Qt reports progress as a whole number
constexpr int kMaxThreads = 1000;    // enough for a thread for each task: short tasks do not wait for long ones
#else
constexpr std::chrono::milliseconds kPause{20}; // before the work starts: the window is painted
#endif
constexpr std::chrono::milliseconds kPaintInterval{40}; // the window is painted between two such intervals

#if QT_CONFIG(future)

/// Returns the thread pool of all tasks. QThreadPool::globalInstance() has too few threads, and Qt paints with
/// them. The application owns the pool, and waits for its threads before it
/// destroys anything else.
QThreadPool &taskThreads()
{
    static QPointer<QThreadPool> threads;
    if (!threads) {
        threads = new QThreadPool(QCoreApplication::instance());
        threads->setObjectName("taskThreads");
        threads->setMaxThreadCount(kMaxThreads);
        qAddPostRoutine([] { taskThreads().waitForDone(); });
    }
    return *threads;
}

#endif

} // namespace

BackgroundTask::~BackgroundTask()
{
    m_stop.request_stop();
}

/// Does the work. Returns a message if it threw an exception, otherwise an empty text.
QString BackgroundTask::runAndCatch(const std::function<void()> &work)
{
    try {
        work();
    } catch (const std::bad_alloc &) {
        return tr("There is not enough memory: try fewer time steps, or a smaller file.");
    } catch (const std::exception &thrown) {
        return tr("The computation failed: %1.").arg(QString::fromLocal8Bit(thrown.what()));
    }
    return {};
}

/// Discards what is running, and marks the task as running. Returns a new object that identifies the new work.
template <typename Watcher>
Watcher *BackgroundTask::beginWork()
{
    const bool wasRunning = m_watcher;
    abandonWork();
    m_stop = std::stop_source();
    auto *const watcher = new Watcher(this);
    m_watcher = watcher;
    if (!wasRunning) {
        emit runningChanged(true);
    }
    return watcher;
}

void BackgroundTask::finish(const QObject *watcher, const QString &problem, const std::function<void()> &done,
                            const Failed &failed)
{
    const QPointer<BackgroundTask> self(this);
    problem.isEmpty() ? done() : failed(problem);
    if (self && m_watcher == watcher) { // otherwise the task was deleted, or has started other work
        discard();
    }
}

#if QT_CONFIG(future)

void BackgroundTask::run(const WorkFunction &work, const std::function<void()> &done, const Failed &failed)
{
    auto *const watcher = beginWork<QFutureWatcher<QString>>();
    connect(watcher, &QFutureWatcherBase::progressValueChanged, this,
            [this](int value) { emit progressed(static_cast<double>(value) / kProgressSteps); });
    connect(watcher, &QFutureWatcherBase::finished, this,
            [this, watcher, done, failed] { finish(watcher, watcher->result(), done, failed); });
    watcher->setFuture(QtConcurrent::run(&taskThreads(), [work, stop = m_stop.get_token()](QPromise<QString> &promise) {
        promise.setProgressRange(0, kProgressSteps);
        promise.addResult(runAndCatch([&] {
            work(stop, [&promise](double part) { promise.setProgressValue(static_cast<int>(part * kProgressSteps)); });
        }));
    }));
}

void BackgroundTask::runPieces(const Pieces &pieces, const std::function<void()> &done, const Failed &failed)
{
    const auto work = [pieces](const std::stop_token &stop, const Progress &progress) {
        while (!stop.stop_requested() && pieces.advance()) {
            progress(pieces.progress());
        }
    };
    run(work, done, failed);
}

#else // there are no threads: the window waits for the work, but first shows what has changed

void BackgroundTask::run(const WorkFunction &work, const std::function<void()> &done, const Failed &failed)
{
    auto *const watcher = beginWork<QObject>();
    QTimer::singleShot(kPause, watcher, [this, watcher, work, done, failed, stop = m_stop.get_token()] {
        if (m_watcher == watcher) { // otherwise it has been discarded
            finish(watcher, runAndCatch([&] { work(stop, [](double) {}); }), done, failed);
        }
    });
}

void BackgroundTask::runPieces(const Pieces &pieces, const std::function<void()> &done, const Failed &failed)
{
    runPiecesInGuiThread(pieces, done, failed);
}

#endif

/// Between two pieces the event loop runs: the window is painted and handles input.
void BackgroundTask::runPiecesInGuiThread(const Pieces &pieces, const std::function<void()> &done, const Failed &failed)
{
    auto *const watcher = beginWork<QObject>();
    auto *const timer = new QTimer(watcher);
    connect(timer, &QTimer::timeout, this, [this, watcher, timer, pieces, done, failed] {
        if (m_watcher != watcher) { // it has been discarded
            return;
        }
        bool isDone = false;
        const QDeadlineTimer deadline(kPaintInterval);
        const QString problem = runAndCatch([&] {
            while (!isDone && !deadline.hasExpired()) {
                isDone = !pieces.advance();
            }
        });
        emit progressed(pieces.progress());
        if (m_watcher == watcher && (isDone || !problem.isEmpty())) {
            timer->stop();
            finish(watcher, problem, done, failed);
        }
    });
    timer->start(0);
}

/// Asks the work to stop, and disconnects from it.
void BackgroundTask::abandonWork()
{
    m_stop.request_stop();
    if (m_watcher) {
        m_watcher->disconnect(this);
        m_watcher->deleteLater();
        m_watcher = nullptr;
    }
}

void BackgroundTask::discard()
{
    if (m_watcher) {
        abandonWork();
        emit runningChanged(false);
    }
}

} // namespace slidercrank

#include "moc_background_task.cpp"
