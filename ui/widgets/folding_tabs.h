// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Tabs whose pages fold away under their bar, so that a small window keeps its room for the plots.

#include <QWidget>

#include <functional>
#include <map>

class QStackedWidget;
class QTabBar;

namespace slidercrank
{

class FoldingTabs : public QWidget
{
    Q_OBJECT

public:
    explicit FoldingTabs(QWidget *parent = nullptr);

    void addPage(QWidget *page, const QString &title);

    /// A page that is made when it is shown for the first time: nobody waits at the start for what they may never open.
    void addPage(const std::function<QWidget *()> &make, const QString &title);
    void setTitle(QWidget *page, const QString &title);

    /// Unfolds and shows it.
    void showPage(QWidget *page);

    int indexOf(QWidget *page) const;
    int current() const;
    void setCurrent(int index); ///< folded away or not

    bool isFolded() const;
    void setFolded(bool folded);

signals:
    void foldedChanged(bool folded);

private:
    void showCurrent();

    QTabBar *m_bar;
    QStackedWidget *m_pages;
    std::map<int, std::function<QWidget *()>> m_unmade; ///< by index
};

} // namespace slidercrank
