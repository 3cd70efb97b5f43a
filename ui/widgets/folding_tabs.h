// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Tabs that can be folded up to their bar, so that the plots of a small window get the space.

#include <QHash>
#include <QTabWidget>

#include <functional>
#include <optional>

namespace slidercrank
{

class FoldingTabs : public QTabWidget
{
    Q_OBJECT

public:
    explicit FoldingTabs(QWidget *parent = nullptr);

    /// A page whose content is made when it is shown for the first time: the program starts faster.
    void addPage(const QString &title, const std::function<QWidget *()> &make);

    /// Unfolds the tabs, and shows that page.
    void showPage(QWidget *page);

    bool isFolded() const { return m_isFolded; }

    /// What the person chose; nullopt: nothing yet.
    const std::optional<bool> &chosen() const { return m_chosen; }
    void choose(bool folded);

    /// Folds or unfolds them unless the person has chosen.
    void suggest(bool folded);

signals:
    void foldedChanged(bool folded);

private:
    void setFolded(bool folded);
    void makeContent(int index);

    QHash<int, std::function<QWidget *()>> m_unmade; ///< by index
    std::optional<bool> m_chosen;
    bool m_isFolded = false;
};

} // namespace slidercrank
