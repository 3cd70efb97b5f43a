// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// One piece of work that takes longer than a moment, off the GUI thread: value in, value out, with progress and cancel.

#include <QObject>
#include <QString>

#include <functional>
#include <optional>
#include <stop_token>

namespace slidercrank
{

class ExportJob : public QObject
{
    Q_OBJECT

public:
    /// Runs in another thread; a sentence where it failed. Ends early when stopped; may tell its progress, 0 … 1.
    using Work = std::function<std::optional<QString>(std::stop_token, const std::function<void(double)> &)>;

    explicit ExportJob(QObject *parent = nullptr);
    ~ExportJob() override; ///< cancels it

    /// Once.
    void start(const Work &work);

    bool isCancelled() const { return m_stop.stop_requested(); }

public slots:
    void cancel();

signals:
    void progressed(double part);

    /// `problem`: one sentence; empty when it is done, or cancelled.
    void finished(const QString &problem);

private:
    std::stop_source m_stop;
};

} // namespace slidercrank
