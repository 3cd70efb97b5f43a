// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// How far what is under way has come, and a button that cancels it; there while it takes longer than a moment.

#include <QTimer>
#include <QWidget>

class QProgressBar;
class QToolButton;

namespace slidercrank
{

class BusyIndicator : public QWidget
{
    Q_OBJECT

public:
    explicit BusyIndicator(QWidget *parent = nullptr);

public slots:
    void setBusy(bool busy);       ///< counts what is under way
    void setProgress(double part); ///< 0 … 1
    void setProgressUnknown();

signals:
    void cancelled();

protected:
    void changeEvent(QEvent *event) override;

private:
    void setTexts();

    QProgressBar *m_progress;
    QToolButton *m_cancel;
    QTimer m_moment;
    int m_underWay = 0;
};

} // namespace slidercrank
