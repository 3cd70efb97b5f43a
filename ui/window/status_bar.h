// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The status line. It describes the computed motion, and while a task takes longer than a quarter of a second it shows
// the progress and a button to cancel it.

#include <QStatusBar>
#include <QTimer>

class QProgressBar;
class QToolButton;

namespace slidercrank
{

class StatusBar : public QStatusBar
{
    Q_OBJECT

public:
    explicit StatusBar(QWidget *parent);

public slots:
    void setBusy(bool busy);           ///< called once for each start and each end of a task
    void setProgress(double fraction); ///< of the task, 0 … 1; 0 if unknown

signals:
    void cancelled();

private:
    void showProgress(bool shown);

    QProgressBar *m_progress;
    QToolButton *m_cancel;
    QTimer m_progressDelay{this};
    int m_tasks = 0;
};

} // namespace slidercrank
