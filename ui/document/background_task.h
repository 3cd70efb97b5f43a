// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Work that may take longer than a moment, in another thread: value in, value out, with progress and cancellation.

#include <QFutureWatcher>
#include <QObject>
#include <QString>

#include <any>
#include <functional>
#include <stop_token>
#include <type_traits>
#include <utility>

namespace slidercrank
{

/// Runs one piece of work at a time. It is used in the GUI thread, and calls back in that thread only. The destructor
/// stops the work, and nobody is called any more.
class BackgroundTask : public QObject
{
    Q_OBJECT

public:
    using QObject::QObject;
    ~BackgroundTask() override;

    /// To be called with 0 … 1, ascending.
    using Progress = std::function<void(double part)>;
    using Failed = std::function<void(const QString &sentence)>;

    /// Runs work(std::stop_token, const Progress &) in another thread, and discards what was running. Then calls
    /// done(its value), or failed() if it threw an exception.
    template <typename Work, typename Done>
    void start(Work work, Done done, Failed failed)
    {
        using Value = std::decay_t<std::invoke_result_t<Work &, std::stop_token, const Progress &>>;
        run(
            [work = std::move(work)](std::stop_token stop, const Progress &progress) mutable -> std::any {
                return work(std::move(stop), progress);
            },
            [done = std::move(done)](const std::any &value) { done(std::any_cast<const Value &>(value)); }, failed);
    }

    bool isRunning() const { return m_watcher; }

public slots:
    void cancel() { m_stop.request_stop(); } ///< the work ends early, and done() is called with its value
    void discard();                          ///< the work ends early, and nobody is called

signals:
    void progressed(double part);
    void runningChanged(bool running); ///< false: after done() or failed(), or when the work is discarded

private:
    struct Outcome {
        std::any value;
        QString problem;
    };
    using Work = std::function<std::any(std::stop_token stop, const Progress &progress)>;
    void run(const Work &work, const std::function<void(const std::any &)> &done, const Failed &failed);
    void release();

    QFutureWatcher<Outcome> *m_watcher = nullptr; ///< null: nothing runs
    std::stop_source m_stop;
};

} // namespace slidercrank
