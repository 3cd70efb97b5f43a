// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A tab with several pages: a list at the left edge selects the page that is shown beside it.

#include <QWidget>

class QListWidget;
class QStackedWidget;

namespace slidercrank
{

class SegmentedPages : public QWidget
{
    Q_OBJECT

public:
    /// `listName`: object name of the list of titles.
    explicit SegmentedPages(const QString &listName, QWidget *parent = nullptr);

    /// Adds a page, which scrolls if there is too little space. The first page is shown at first.
    void addPage(const QString &title, QWidget *page);

    void setCurrent(int index);

private:
    QListWidget *m_titles;
    QStackedWidget *m_pages;
};

} // namespace slidercrank
