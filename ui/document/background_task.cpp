// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/background_task.h"

#include <QPointer>
#include <QPromise>
#include <QThreadPool>
#include <QtConcurrentRun>

#include <algorithm>
#include <exception>
#include <new>

namespace slidercrank
{

namespace
{

constexpr int kProgressSteps = 1000;

/// The application waits for this pool when it ends. The pool has an additional thread for each long task, so that
/// short tasks do not wait for long ones.
QThreadPool *threadPool()
{
    // The study, an export, the recovery file, the reference file, the identification, and tasks that are stopping.
    constexpr int kLongTasks = 8;
    QThreadPool *pool = QThreadPool::globalInstance();
    static const bool isLarge = (pool->setMaxThreadCount(pool->maxThreadCount() + kLongTasks), true);
    Q_UNUSED(isLarge)
    return pool;
}

} // namespace

BackgroundTask::~BackgroundTask()
{
    m_stop.request_stop();
}

void BackgroundTask::run(const Work &work, const std::function<void(const std::any &)> &done, const Failed &failed)
{
    const bool wasRunning = m_watcher;
    release();
    m_stop = std::stop_source();
    auto *const watcher = new QFutureWatcher<Outcome>(this);
    m_watcher = watcher;
    connect(watcher, &QFutureWatcherBase::progressValueChanged, this,
            [this](int value) { emit progressed(static_cast<double>(value) / kProgressSteps); });
    connect(watcher, &QFutureWatcherBase::finished, this, [this, watcher, done, failed] {
        const QPointer<BackgroundTask> self(this);
        const Outcome outcome = watcher->result();
        outcome.problem.isEmpty() ? done(outcome.value) : failed(outcome.problem);
        if (self && m_watcher == watcher) { // otherwise the task was deleted, or has started other work
            discard();
        }
    });
    watcher->setFuture(QtConcurrent::run(threadPool(), [work, stop = m_stop.get_token()](QPromise<Outcome> &promise) {
        promise.setProgressRange(0, kProgressSteps);
        Outcome outcome;
        try {
            outcome.value = work(
                stop, [&promise](double part) { promise.setProgressValue(static_cast<int>(part * kProgressSteps)); });
        } catch (const std::bad_alloc &) {
            outcome.problem = tr("There is not enough memory: try fewer time steps, or a smaller file.");
        } catch (const std::exception &thrown) {
            outcome.problem = tr("The computation failed: %1.").arg(QString::fromLocal8Bit(thrown.what()));
        }
        promise.addResult(std::move(outcome));
    }));
    if (!wasRunning) {
        emit runningChanged(true);
    }
}

/// Stops the work, and disconnects from it.
void BackgroundTask::release()
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
        release();
        emit runningChanged(false);
    }
}

} // namespace slidercrank
