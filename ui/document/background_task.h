// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Runs a function in another thread, with progress and cancellation.

#include <QFutureWatcher>
#include <QObject>
#include <QString>

#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <type_traits>
#include <utility>

namespace slidercrank
{

/// Runs one function at a time. Must be used in the GUI thread, and calls back in that thread. The destructor stops the
/// function; after it nothing is called any more.
class BackgroundTask : public QObject
{
    Q_OBJECT

public:
    using QObject::QObject;
    ~BackgroundTask() override;

    /// Takes the part that is done, 0 … 1, in ascending order.
    using Progress = std::function<void(double part)>;
    using Failed = std::function<void(const QString &sentence)>;

    /// Discards what is running, and runs work(std::stop_token, const Progress &) in another thread. Then calls done()
    /// with the value that it returned, or failed() if it threw an exception.
    template <typename Work, typename Done>
    void start(Work work, Done done, Failed failed)
    {
        using Value = std::decay_t<std::invoke_result_t<Work &, std::stop_token, const Progress &>>;
        const auto value = std::make_shared<std::optional<Value>>();
        run([work, value](const std::stop_token &stop,
                          const Progress &progress) mutable { value->emplace(work(stop, progress)); },
            [done, value] { done(std::as_const(**value)); }, failed);
    }

    bool isRunning() const { return m_watcher; }

public slots:
    void discard(); ///< stops the work early; neither done() nor failed() is called

signals:
    void progressed(double part);
    void runningChanged(bool running); ///< false after done() or failed(), and when the work is discarded

private:
    using Work = std::function<void(const std::stop_token &stop, const Progress &progress)>;
    void run(const Work &work, const std::function<void()> &done, const Failed &failed);
    void release();

    QFutureWatcher<QString> *m_watcher = nullptr; ///< null: nothing runs
    std::stop_source m_stop;
};

} // namespace slidercrank
