// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Pages of a tab: named buttons at the left edge, and the page of the checked button beside them.

#include <QWidget>

class QButtonGroup;
class QStackedWidget;
class QVBoxLayout;

namespace slidercrank
{

class SegmentedPages : public QWidget
{
    Q_OBJECT

public:
    /// `buttonName`: the object name of the buttons, followed by the index.
    explicit SegmentedPages(const QString &buttonName, QWidget *parent = nullptr);

    /// The same widget may be added under several titles. The first page is shown.
    void addPage(const QString &title, QWidget *page);

    int current() const;
    void setCurrent(int index);

signals:
    void currentChanged(int index);

private:
    QString m_buttonName;
    QButtonGroup *m_buttons;
    QVBoxLayout *m_column;
    QStackedWidget *m_stack;
};

} // namespace slidercrank
