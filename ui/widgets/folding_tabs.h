// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Tabs that can be folded up to their bar, so that the plots of a small window get the space.

#include <QTabWidget>

#include <functional>
#include <map>

namespace slidercrank
{

class FoldingTabs : public QTabWidget
{
    Q_OBJECT

public:
    explicit FoldingTabs(QWidget *parent = nullptr);

    void addPage(QWidget *page, const QString &title) { addTab(page, title); }

    /// A page that is made when it is shown for the first time: the program starts faster.
    void addPage(const std::function<QWidget *()> &make, const QString &title);
    void setTitle(QWidget *page, const QString &title);

    /// Unfolds and shows it.
    void showPage(QWidget *page);

    int current() const { return currentIndex(); }
    void setCurrent(int index) { setCurrentIndex(index); } ///< folded or not

    bool isFolded() const { return m_isFolded; }
    void setFolded(bool folded);

signals:
    void foldedChanged(bool folded);

private:
    void makePage(int index);

    std::map<int, std::function<QWidget *()>> m_unmade; ///< by index
    bool m_isFolded = false;
};

} // namespace slidercrank
