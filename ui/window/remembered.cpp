// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/remembered.h"

#include "ui/mechanism/mechanism_view.h"
#include "ui/panels/timeline.h"
#include "ui/text/remember.h"
#include "ui/widgets/folding_tabs.h"

#include <QAbstractButton>
#include <QComboBox>
#include <QMainWindow>
#include <QSettings>
#include <QSplitter>

#include <array>
#include <utility>

namespace slidercrank
{

namespace
{

constexpr int kMostRecentFiles = 8;

const QString kJoined = QStringLiteral("\x1f"); // between the paths of files that are joined: they hold none

const QString kTheme = QStringLiteral("theme");
const QString kLayout = QStringLiteral("layout");
const QString kWindow = QStringLiteral("window");
const QString kFolded = QStringLiteral("folded");
const QString kTab = QStringLiteral("view/tab");
const QString kSpeed = QStringLiteral("view/speed");
const QString kView = QStringLiteral("view/%1");

/// What is drawn beside the linkage, by name.
constexpr std::array<std::pair<const char *, bool MechanismSettings::*>, 7> kDrawn{{
    {"velocity", &MechanismSettings::velocity},
    {"acceleration", &MechanismSettings::acceleration},
    {"path", &MechanismSettings::path},
    {"names", &MechanismSettings::names},
    {"dimensions", &MechanismSettings::dimensions},
    {"angles", &MechanismSettings::angles},
    {"instantCentre", &MechanismSettings::instantCentre},
}};

const QStringList kUnitBoxes{QStringLiteral("unit_omega2"), QStringLiteral("unit_theta20")};

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

WindowLayout windowLayoutOf(const QMainWindow &window, bool foldedByHand)
{
    const QWidget &rooms = *window.centralWidget(); // no dialogs
    const auto &tabs = *rooms.findChild<FoldingTabs *>();
    WindowLayout layout;
    layout.window = window.saveGeometry();
    for (const auto *splitter : rooms.findChildren<QSplitter *>()) {
        if (splitter != tabs.parentWidget() || !tabs.isFolded()) { // else it tells no height
            layout.splitters[splitter->objectName()] = splitter->saveState();
        }
    }
    if (foldedByHand) {
        layout.folded = tabs.isFolded();
    }
    layout.tab = tabs.current();
    layout.speed = rooms.findChild<Timeline *>()->speed();
    layout.drawing = rooms.findChild<MechanismView *>()->settings();
    for (const auto *box : rooms.findChildren<QComboBox *>()) {
        layout.choices[box->objectName()] = box->currentIndex();
    }
    for (const auto *button : rooms.findChildren<QAbstractButton *>()) {
        if (button->isCheckable()) {
            layout.choices[button->objectName()] = button->isChecked();
        }
    }
    if (const QWidget *focus = window.focusWidget()) {
        layout.focus = focus->objectName();
    }
    return layout;
}

void arrange(QMainWindow &window, const WindowLayout &layout)
{
    QWidget &rooms = *window.centralWidget();
    auto &tabs = *rooms.findChild<FoldingTabs *>();
    window.restoreGeometry(layout.window);
    tabs.setCurrent(layout.tab); // first: its controls are made now
    rooms.findChild<Timeline *>()->setSpeed(layout.speed);
    rooms.findChild<MechanismView *>()->setSettings(layout.drawing);
    for (auto *splitter : rooms.findChildren<QSplitter *>()) {
        splitter->restoreState(layout.splitters.value(splitter->objectName()));
    }
    if (layout.folded) {
        tabs.setFolded(*layout.folded);
    }
    for (auto *box : rooms.findChildren<QComboBox *>()) {
        const int index = layout.choices.value(box->objectName(), box->currentIndex());
        if (index != box->currentIndex() && index >= 0 && index < box->count()) {
            box->setCurrentIndex(index);
            emit box->activated(index);
        }
    }
    for (auto *button : rooms.findChildren<QAbstractButton *>()) {
        if (button->isChecked() != static_cast<bool>(layout.choices.value(button->objectName(), button->isChecked()))) {
            button->click(); // of an exclusive group only the one that goes down has an effect
        }
    }
    if (auto *focus = layout.focus.isEmpty() ? nullptr : rooms.findChild<QWidget *>(layout.focus)) {
        focus->setFocus();
    }
}

void rememberLayout(const WindowLayout &layout)
{
    const QString group = kLayout + u'/';
    QVariantMap choices{{group + kWindow, layout.window}};
    for (const auto &[name, state] : layout.splitters.asKeyValueRange()) {
        if (!name.isEmpty()) {
            choices.insert(group + name, state);
        }
    }
    if (layout.folded) {
        choices.insert(group + kFolded, *layout.folded);
    }
    choices.insert(kTab, layout.tab);
    choices.insert(kSpeed, layout.speed);
    for (const auto &[name, member] : kDrawn) {
        choices.insert(kView.arg(QLatin1String(name)), layout.drawing.*member);
    }
    for (const QString &box : kUnitBoxes) {
        choices.insert(kView.arg(box), layout.choices.value(box));
    }
    remember(choices);
}

WindowLayout rememberedLayout()
{
    QSettings settings;
    settings.beginGroup(kLayout);
    WindowLayout layout;
    layout.window = settings.value(kWindow).toByteArray();
    for (const QString &name : settings.childKeys()) {
        if (name != kWindow && name != kFolded) {
            layout.splitters[name] = settings.value(name).toByteArray();
        }
    }
    if (const QVariant folded = settings.value(kFolded); folded.isValid()) {
        layout.folded = folded.toBool();
    }
    settings.endGroup();
    layout.tab = settings.value(kTab, layout.tab).toInt();
    layout.speed = settings.value(kSpeed, layout.speed).toDouble();
    for (const auto &[name, member] : kDrawn) {
        layout.drawing.*member = settings.value(kView.arg(QLatin1String(name)), false).toBool();
    }
    for (const QString &box : kUnitBoxes) {
        layout.choices[box] = settings.value(kView.arg(box), 0).toInt();
    }
    return layout;
}

} // namespace slidercrank
