// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Work that takes longer than a moment, off the GUI thread: value in, value out, with progress and cancel. All of it is
// used from the GUI thread, and calls back there only.

#include <QObject>
#include <QString>

#include <any>
#include <functional>
#include <stop_token>
#include <type_traits>
#include <utility>

namespace slidercrank
{

/// One piece of work at a time. When this is gone, what is under way is told to stop and nobody hears of it.
class WorkAside : public QObject
{
    Q_OBJECT

public:
    /// What lasts has a thread for itself, so that no edit waits behind it. What an edit asks for is soon done, or out
    /// of date with the next edit: it shares as many threads as there are processors.
    enum class Kind { Lasting, OfAnEdit };

    explicit WorkAside(Kind kind = Kind::Lasting, QObject *parent = nullptr);
    ~WorkAside() override;

    /// To be told 0 … 1, ascending, from one thread.
    using Progress = std::function<void(double part)>;
    using Failed = std::function<void(const QString &sentence)>;

    /// Runs work(std::stop_token, const Progress &) in another thread, in place of what was under way, then
    /// done(its value) in this one; failed() where it threw.
    template <typename Work, typename Done>
    void start(Work work, Done done, Failed failed)
    {
        using Value = std::decay_t<std::invoke_result_t<Work &, std::stop_token, const Progress &>>;
        m_done = [done = std::move(done)](const std::any &value) { done(std::any_cast<const Value &>(value)); };
        m_failed = std::move(failed);
        run([work = std::move(work)](std::stop_token stop, const Progress &progress) mutable -> std::any {
            return work(std::move(stop), progress);
        });
    }

    bool isRunning() const { return m_running; }

public slots:
    void cancel(); ///< it ends early, and done() gets what there is by then
    void drop();   ///< it ends early, and nobody is called; it no longer counts as running

signals:
    void progressed(double part);
    void runningChanged(bool running); ///< false: done() has been called, or failed(), or neither of them will be

private:
    using Work = std::function<std::any(std::stop_token stop, const Progress &progress)>;
    void run(Work work);
    void end(const std::any &value, const QString &problem);
    void setRunning(bool running);

    Kind m_kind;
    bool m_running = false;
    std::stop_source m_stop;                           ///< of the work that this waits for, and only of that
    std::function<void(const std::any &value)> m_done; ///< never leaves the GUI thread, whatever it holds
    Failed m_failed;
};

} // namespace slidercrank
