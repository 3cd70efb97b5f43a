// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/window_settings.h"

#include "ui/mechanism/mechanism_view.h"
#include "ui/panels/timeline.h"
#include "ui/text/remember.h"
#include "ui/widgets/folding_tabs.h"

#include <QAction>
#include <QComboBox>
#include <QFileInfo>
#include <QMainWindow>
#include <QSettings>
#include <QSplitter>
#include <QStandardPaths>

#include <algorithm>

namespace slidercrank
{

namespace
{

constexpr int kMostRecentFiles = 10;

const QString kRecentFiles = QStringLiteral("recentFiles");
const QString kSeparator = QStringLiteral("\x1f"); // between the paths of joined files, which do not contain it
const QString kTheme = QStringLiteral("theme");
const QString kWindow = QStringLiteral("layout/window");
const QString kFolded = QStringLiteral("layout/folded");
const QString kSplitterState = QStringLiteral("layout/%1");
const QString kTab = QStringLiteral("view/tab");
const QString kSpeed = QStringLiteral("view/speed");
const QString kChoice = QStringLiteral("view/%1");

const QStringList kUnitBoxes{QStringLiteral("unit_omega2"), QStringLiteral("unit_theta20")};

FoldingTabs &tabsIn(const QMainWindow &window)
{
    return *window.centralWidget()->findChild<FoldingTabs *>();
}

} // namespace

QList<QStringList> recentFiles()
{
    QList<QStringList> files;
    for (const QString &paths : QSettings().value(kRecentFiles).toStringList()) {
        files += paths.split(kSeparator);
    }
    return files;
}

void rememberFiles(const QStringList &paths)
{
    QStringList files = QSettings().value(kRecentFiles).toStringList();
    files.removeAll(paths.join(kSeparator));
    files.prepend(paths.join(kSeparator));
    remember({{kRecentFiles, files.mid(0, kMostRecentFiles)}});
}

QString recentFolder()
{
    const QList<QStringList> files = recentFiles();
    return files.isEmpty() ? QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation)
                           : QFileInfo(files.first().first()).absolutePath();
}

Theme chosenTheme()
{
    return static_cast<Theme>(QSettings().value(kTheme, 0).toInt());
}

void rememberTheme(Theme theme)
{
    remember({{kTheme, static_cast<int>(theme)}});
}

void saveLayout(const QMainWindow &window)
{
    const FoldingTabs &tabs = tabsIn(window);
    QVariantMap layout{{kWindow, window.saveGeometry()},
                       {kTab, tabs.currentIndex()},
                       {kSpeed, window.findChild<Timeline *>()->speed()}};
    if (tabs.chosen()) {
        layout[kFolded] = *tabs.chosen();
    }
    for (const auto *splitter : window.findChildren<QSplitter *>()) {
        if (splitter != tabs.parentWidget() || !tabs.isFolded()) { // while folded, its state contains no height
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
    remember(layout);
}

void restoreLayout(QMainWindow &window)
{
    const QSettings settings;
    FoldingTabs &tabs = tabsIn(window);
    window.restoreGeometry(settings.value(kWindow).toByteArray());
    tabs.setCurrentIndex(settings.value(kTab, 0).toInt());
    window.findChild<Timeline *>()->setSpeed(settings.value(kSpeed, 1.0).toDouble());
    for (auto *splitter : window.findChildren<QSplitter *>()) {
        splitter->restoreState(settings.value(kSplitterState.arg(splitter->objectName())).toByteArray());
    }
    if (settings.contains(kFolded)) {
        tabs.choose(settings.value(kFolded).toBool());
    }
    for (QAction *choice : window.findChild<MechanismView *>()->choices()) {
        if (choice->isCheckable() && choice->isChecked() != settings.value(kChoice.arg(choice->objectName())).toBool()) {
            choice->trigger();
        }
    }
    for (const QString &name : kUnitBoxes) {
        auto *box = window.findChild<QComboBox *>(name);
        box->setCurrentIndex(std::clamp(settings.value(kChoice.arg(name)).toInt(), 0, box->count() - 1));
        emit box->activated(box->currentIndex());
    }
}

} // namespace slidercrank
