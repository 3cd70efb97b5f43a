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
constexpr int kMostThreads = 1000; // a thread for each task, so that short tasks do not wait for long ones

} // namespace

BackgroundTask::~BackgroundTask()
{
    m_stop.request_stop();
}

void BackgroundTask::run(const Work &work, const std::function<void()> &done, const Failed &failed)
{
    const bool wasRunning = m_watcher;
    release();
    m_stop = std::stop_source();
    auto *const watcher = new QFutureWatcher<QString>(this);
    m_watcher = watcher;
    connect(watcher, &QFutureWatcherBase::progressValueChanged, this,
            [this](int value) { emit progressed(static_cast<double>(value) / kProgressSteps); });
    connect(watcher, &QFutureWatcherBase::finished, this, [this, watcher, done, failed] {
        const QPointer<BackgroundTask> self(this);
        const QString problem = watcher->result();
        problem.isEmpty() ? done() : failed(problem);
        if (self && m_watcher == watcher) { // otherwise the task was deleted, or has started other work
            discard();
        }
    });
    QThreadPool *const pool = QThreadPool::globalInstance(); // the application waits for it when it ends
    pool->setMaxThreadCount(kMostThreads);
    watcher->setFuture(QtConcurrent::run(pool, [work, stop = m_stop.get_token()](QPromise<QString> &promise) {
        promise.setProgressRange(0, kProgressSteps);
        QString problem;
        try {
            work(stop, [&promise](double part) { promise.setProgressValue(static_cast<int>(part * kProgressSteps)); });
        } catch (const std::bad_alloc &) {
            problem = tr("There is not enough memory: try fewer time steps, or a smaller file.");
        } catch (const std::exception &thrown) {
            problem = tr("The computation failed: %1.").arg(QString::fromLocal8Bit(thrown.what()));
        }
        promise.addResult(problem);
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

#include "moc_background_task.cpp"
