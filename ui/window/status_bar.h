// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// One line about the motion shown; and while something takes longer than a moment, its progress and a button that
// cancels it.

#include <QStatusBar>
#include <QTimer>

class QProgressBar;
class QToolButton;

namespace slidercrank
{

struct Result;

class StatusBar : public QStatusBar
{
    Q_OBJECT

public:
    explicit StatusBar(QWidget *parent);

    void showResult(const Result &result);

public slots:
    void setBusy(bool busy);       ///< counts the tasks that run
    void setProgress(double part); ///< 0 … 1; negative: unknown

signals:
    void cancelled();

private:
    void showProgress(bool shown);

    QProgressBar *m_progress;
    QToolButton *m_cancel;
    QTimer m_moment{this};
    int m_tasks = 0;
};

} // namespace slidercrank
