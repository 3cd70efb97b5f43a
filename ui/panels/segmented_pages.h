// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A tab with several pages: buttons at the left edge select the page that is shown beside them.

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
    /// `buttonName`: object name of the buttons, to which their index is appended.
    explicit SegmentedPages(const QString &buttonName, QWidget *parent = nullptr);

    /// Adds a page, which scrolls if there is too little space. The first page is shown at first.
    void addPage(const QString &title, QWidget *page);

    void setCurrent(int index);

private:
    QString m_buttonName;
    QButtonGroup *m_buttons;
    QVBoxLayout *m_column;
    QStackedWidget *m_stack;
};

} // namespace slidercrank
