// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Tabs that can be folded to their bar, to leave more space for the plots in a small window.

#include <QHash>
#include <QTabWidget>

#include <functional>

namespace slidercrank
{

class FoldingTabs : public QTabWidget
{
    Q_OBJECT

public:
    explicit FoldingTabs(QWidget *parent = nullptr);

    /// Adds a page whose content is created when the page is first shown, so that the program starts faster.
    void addPage(const QString &title, const std::function<QWidget *()> &make);

    bool isFolded() const { return m_isFolded; }
    void setFolded(bool folded);

signals:
    void foldedChanged(bool folded);

private:
    void makeContent(int index);

    QHash<int, std::function<QWidget *()>> m_unmade; ///< functions that create the missing contents, by index
    bool m_isFolded = false;
};

} // namespace slidercrank
