// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Tabs whose pages fold away under their bar, so that a small window keeps its room for the plots.

#include <QWidget>

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
    void setTitle(QWidget *page, const QString &title);

    /// Unfolds and shows it.
    void showPage(QWidget *page);

    bool isFolded() const;
    void setFolded(bool folded);

signals:
    void foldedChanged(bool folded);

private:
    QTabBar *m_bar;
    QStackedWidget *m_pages;
};

} // namespace slidercrank
