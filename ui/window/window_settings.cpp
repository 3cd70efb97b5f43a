// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/window_settings.h"

#include "ui/mechanism/mechanism_view.h"
#include "ui/panels/timeline.h"
#include "ui/text/remember.h"
#include "ui/widgets/folding_tabs.h"

#include <QAction>
#include <QComboBox>
#include <QMainWindow>
#include <QSettings>
#include <QSplitter>

namespace slidercrank
{

namespace
{

constexpr int kMostRecentFiles = 8;

const QString kJoined = QStringLiteral("\x1f"); // between the paths of joined files, which do not contain it

const QString kTheme = QStringLiteral("theme");
const QString kWindow = QStringLiteral("layout/window");
const QString kFolded = QStringLiteral("layout/folded");
const QString kTab = QStringLiteral("view/tab");
const QString kSpeed = QStringLiteral("view/speed");
const QString kSplitterState = QStringLiteral("layout/%1");
const QString kChoice = QStringLiteral("view/%1");

const QStringList kUnitBoxes{QStringLiteral("unit_omega2"), QStringLiteral("unit_theta20")};

FoldingTabs &tabsIn(const QMainWindow &window)
{
    return *window.centralWidget()->findChild<FoldingTabs *>();
}

} // namespace

QStringList recentFiles(const QString &kind)
{
    return QSettings().value(kind).toStringList();
}

void rememberFile(const QString &kind, const QString &path)
{
    QStringList paths = recentFiles(kind);
    paths.removeAll(path);
    paths.prepend(path);
    remember({{kind, paths.mid(0, kMostRecentFiles)}});
}

QList<QStringList> recentReferences()
{
    QList<QStringList> references;
    for (const QString &paths : recentFiles(kRecentReferences)) {
        references += paths.split(kJoined);
    }
    return references;
}

void rememberReference(const QStringList &paths)
{
    rememberFile(kRecentReferences, paths.join(kJoined));
}

Theme chosenTheme()
{
    return static_cast<Theme>(QSettings().value(kTheme, 0).toInt());
}

void rememberTheme(Theme theme)
{
    remember({{kTheme, static_cast<int>(theme)}});
}

QVariantMap layoutOf(const QMainWindow &window)
{
    const FoldingTabs &tabs = tabsIn(window);
    QVariantMap layout{{kWindow, window.saveGeometry()},
                       {kTab, tabs.currentIndex()},
                       {kSpeed, window.findChild<Timeline *>()->speed()}};
    if (tabs.chosen()) {
        layout[kFolded] = *tabs.chosen();
    }
    for (const auto *splitter : window.findChildren<QSplitter *>()) {
        if (splitter != tabs.parentWidget() || !tabs.isFolded()) { // folded, its state contains no height
            layout[kSplitterState.arg(splitter->objectName())] = splitter->saveState();
        }
    }
    for (const QAction *choice : window.findChild<MechanismView *>()->choices()) {
        if (choice->isCheckable()) {
            layout[kChoice.arg(choice->objectName())] = choice->isChecked();
        }
    }
    for (const QString &name : kUnitBoxes) {
        layout[kChoice.arg(name)] = window.findChild<QComboBox *>(name)->currentIndex();
    }
    return layout;
}

QVariantMap rememberedLayout()
{
    const QSettings settings;
    QVariantMap layout;
    for (const QString &key : settings.allKeys()) {
        layout[key] = settings.value(key);
    }
    return layout;
}

void arrange(QMainWindow &window, const QVariantMap &layout)
{
    FoldingTabs &tabs = tabsIn(window);
    window.restoreGeometry(layout.value(kWindow).toByteArray());
    tabs.setCurrentIndex(layout.value(kTab, 0).toInt());
    window.findChild<Timeline *>()->setSpeed(layout.value(kSpeed, 1.0).toDouble());
    for (auto *splitter : window.findChildren<QSplitter *>()) {
        splitter->restoreState(layout.value(kSplitterState.arg(splitter->objectName())).toByteArray());
    }
    if (layout.contains(kFolded)) {
        tabs.choose(layout.value(kFolded).toBool());
    }
    for (QAction *choice : window.findChild<MechanismView *>()->choices()) {
        if (choice->isCheckable() && choice->isChecked() != layout.value(kChoice.arg(choice->objectName())).toBool()) {
            choice->trigger();
        }
    }
    for (const QString &name : kUnitBoxes) {
        auto *box = window.findChild<QComboBox *>(name);
        const int index = layout.value(kChoice.arg(name), 0).toInt();
        if (index != box->currentIndex() && index >= 0 && index < box->count()) {
            box->setCurrentIndex(index);
            emit box->activated(index);
        }
    }
}

} // namespace slidercrank
