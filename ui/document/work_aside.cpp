// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/work_aside.h"

#include <QCoreApplication>
#include <QPointer>
#include <QThreadPool>

#include <exception>
#include <new>

namespace slidercrank
{

WorkAside::WorkAside(Kind kind, QObject *parent)
    : QObject(parent)
    , m_kind(kind)
{
}

WorkAside::~WorkAside()
{
    m_stop.request_stop();
}

void WorkAside::run(Work work)
{
    m_stop.request_stop();
    m_stop = std::stop_source();
    setRunning(true);
    const auto doIt = [aside = QPointer<WorkAside>(this), work = std::move(work), stop = m_stop.get_token()] {
        // Who asked may be gone, or wait for something else: that is seen in the GUI thread.
        const auto tell = [&](auto what) {
            auto there = [aside, stop, what = std::move(what)] {
                if (aside && aside->m_stop.get_token() == stop) {
                    what(*aside);
                }
            };
            QMetaObject::invokeMethod(QCoreApplication::instance(), std::move(there), Qt::QueuedConnection);
        };
        const auto progress = [&, told = 0](double part) mutable {
            constexpr int kSteps = 200; // more than a bar can show
            const int step = static_cast<int>(kSteps * part);
            if (step != std::exchange(told, step) && !stop.stop_requested()) {
                tell([part](WorkAside &running) { emit running.progressed(part); });
            }
        };
        std::any value;
        QString problem;
        try {
            value = work(stop, progress);
        } catch (const std::bad_alloc &) {
            problem = tr("There is not enough memory for that: try fewer steps, or a smaller file.");
        } catch (const std::exception &thrown) {
            problem = tr("That failed: %1.").arg(QString::fromLocal8Bit(thrown.what()));
        }
        tell([value = std::move(value), problem](WorkAside &running) { running.end(value, problem); });
    };
    QThreadPool *pool = QThreadPool::globalInstance(); // the application waits for it at its end
    if (m_kind == Kind::OfAnEdit) {
        pool->start(doIt);
        return;
    }
    pool->start([pool, doIt] {
        pool->releaseThread(); // this one does not count
        doIt();
        pool->reserveThread();
    });
}

/// What is called may start other work, or be the end of this.
void WorkAside::end(const std::any &value, const QString &problem)
{
    const QPointer<WorkAside> self(this);
    const std::stop_token ended = m_stop.get_token();
    const auto done = std::exchange(m_done, nullptr);
    const auto failed = std::exchange(m_failed, nullptr);
    if (problem.isEmpty()) {
        done(value);
    } else {
        failed(problem);
    }
    if (self && m_stop.get_token() == ended) {
        setRunning(false);
    }
}

void WorkAside::cancel()
{
    m_stop.request_stop();
}

void WorkAside::drop()
{
    if (!m_done) {
        return; // nobody waits; or what is called right now says so
    }
    m_stop.request_stop();
    m_stop = std::stop_source(); // nothing that is under way is awaited any more
    m_done = nullptr;
    m_failed = nullptr;
    setRunning(false);
}

void WorkAside::setRunning(bool running)
{
    if (std::exchange(m_running, running) != running) {
        emit runningChanged(running);
    }
}

} // namespace slidercrank
