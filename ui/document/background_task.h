// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Runs a function in another thread, with progress and cancellation. Where there are no threads, as in a browser, the
// function runs in the event loop.

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

/// Runs one function at a time. Must be used in the GUI thread, and calls back in that thread. The destructor asks the
/// function to stop, without waiting for it; done() and failed() are not called afterwards.
class BackgroundTask : public QObject
{
    Q_OBJECT

public:
    using QObject::QObject;
    ~BackgroundTask() override;

    /// Receives the fraction of the work that is done, 0 … 1, in ascending order.
    using Progress = std::function<void(double fraction)>;
    using Failed = std::function<void(const QString &message)>;

    /// Discards what is running, and runs work(std::stop_token, const Progress &) in another thread. Then calls done()
    /// with the value that work() returned, or failed() if work() threw an exception.
    template <typename Work, typename Done>
    void start(Work work, Done done, Failed failed)
    {
        using Value = std::decay_t<std::invoke_result_t<Work &, std::stop_token, const Progress &>>;
        const auto value = std::make_shared<std::optional<Value>>();
        run([work, value](const std::stop_token &stop,
                          const Progress &progress) mutable { value->emplace(work(stop, progress)); },
            [done, value] { done(std::as_const(**value)); }, failed);
    }

    /// Discards what is running, and calls pieces->advance() until it returns false: in another thread or, if the
    /// program has no threads, in the GUI thread between events. Then calls done(*pieces), or failed() if advance()
    /// threw an exception. pieces->progress() returns the fraction of the work that is done.
    template <typename Work, typename Done>
    void startPieces(const std::shared_ptr<Work> &pieces, Done done, Failed failed)
    {
        runPieces(
            piecesOf(pieces), [pieces, done] { done(std::as_const(*pieces)); }, failed);
    }

    /// Does what startPieces() does, but always in the GUI thread between events: for work that uses widgets.
    template <typename Work, typename Done>
    void startPiecesInGuiThread(const std::shared_ptr<Work> &pieces, Done done, Failed failed)
    {
        runPiecesInGuiThread(
            piecesOf(pieces), [pieces, done] { done(std::as_const(*pieces)); }, failed);
    }

    bool isRunning() const { return m_watcher; }

public slots:
    void discard(); ///< asks the work to stop, without waiting for it; done() and failed() are not called

signals:
    void progressed(double fraction);
    void runningChanged(bool running); ///< false after done() or failed(), and when the work is discarded

private:
    using WorkFunction = std::function<void(const std::stop_token &stop, const Progress &progress)>;
    void run(const WorkFunction &work, const std::function<void()> &done, const Failed &failed);
    void abandonWork();
    static QString runAndCatch(const std::function<void()> &work);

    struct Pieces {
        std::function<bool()> advance;
        std::function<double()> progress;
    };
    template <typename Work>
    static Pieces piecesOf(const std::shared_ptr<Work> &work)
    {
        return {[work] { return work->advance(); }, [work] { return work->progress(); }};
    }
    void runPieces(const Pieces &pieces, const std::function<void()> &done, const Failed &failed);
    void runPiecesInGuiThread(const Pieces &pieces, const std::function<void()> &done, const Failed &failed);

    template <typename Watcher>
    Watcher *beginWork();
    void finish(const QObject *watcher, const QString &problem, const std::function<void()> &done,
                const Failed &failed);

    QObject *m_watcher = nullptr; ///< null: nothing runs
    std::stop_source m_stop;
};

} // namespace slidercrank
