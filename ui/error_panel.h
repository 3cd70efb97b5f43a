// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// How far the reference data are from the model: a sentence that says whether they belong together, and a row a
// channel.

#include "ui/session.h"

#include <QWidget>

#include <memory>

class QLabel;
class QStackedWidget;
class QTableWidget;

namespace slidercrank
{

class ErrorPanel : public QWidget
{
    Q_OBJECT

public:
    explicit ErrorPanel(QWidget *parent = nullptr);

public slots:
    /// Kept, and filled in when the panel is on show.
    void setResult(const std::shared_ptr<const slidercrank::Result> &result);

signals:
    void timeRequested(double seconds); ///< somebody wants to see where an error is largest
    void openReferenceRequested();
    void openSampleRequested();

protected:
    void showEvent(QShowEvent *event) override;
    void changeEvent(QEvent *event) override;
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    QWidget *createEmptyPage();
    QWidget *createTablePage();
    void fill();
    void fitColumns(); ///< shares spare width out among them
    void goToError(int row, int column);

    std::shared_ptr<const Result> m_result;
    bool m_stale = false; ///< m_result is not on show yet
    QStackedWidget *m_pages = nullptr;
    QLabel *m_verdict = nullptr;
    QLabel *m_leftOut = nullptr;
    QTableWidget *m_table = nullptr;
};

} // namespace slidercrank
