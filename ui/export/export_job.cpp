// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/export_job.h"

#include <QCoreApplication>
#include <QPointer>
#include <QThreadPool>

#include <utility>

namespace slidercrank
{

ExportJob::ExportJob(QObject *parent)
    : QObject(parent)
{
}

ExportJob::~ExportJob()
{
    m_stop.request_stop();
}

void ExportJob::start(const Work &work)
{
    QThreadPool::globalInstance()->start([job = QPointer<ExportJob>(this), work, stop = m_stop.get_token()] {
        const auto tell = [&job](const std::function<void(ExportJob *)> &what) {
            QMetaObject::invokeMethod(
                QCoreApplication::instance(),
                [job, what] {
                    if (job) {
                        what(job);
                    }
                },
                Qt::QueuedConnection);
        };
        const auto progress = [&tell, told = -1](double part) mutable {
            constexpr int kSteps = 100; // as many as the bar shows
            const int step = static_cast<int>(kSteps * part);
            if (step != std::exchange(told, step)) {
                tell([part](ExportJob *running) { emit running->progressed(part); });
            }
        };
        const std::optional<QString> problem = work(stop, progress);
        tell([problem](ExportJob *running) { emit running->finished(problem.value_or(QString())); });
    });
}

void ExportJob::cancel()
{
    m_stop.request_stop();
}

} // namespace slidercrank
