// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Along the bottom of the window: the run on show in one line; and while something takes longer than a moment, how far
// it has come, with a button that cancels it.

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
    explicit StatusBar(QWidget *parent = nullptr);

    void retranslate(); ///< into the language now in use
    void showRun(const Result &result);

public slots:
    void setBusy(bool busy);       ///< counts what is under way
    void setProgress(double part); ///< 0 … 1
    void setProgressUnknown();

signals:
    void cancelled();

private:
    void setBusyShown(bool shown);

    QProgressBar *m_progress;
    QToolButton *m_cancel;
    QTimer m_moment{this};
    int m_underWay = 0;
};

} // namespace slidercrank
