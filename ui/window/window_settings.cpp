// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/window_settings.h"

#include "ui/document/settings_fields.h"
#include "ui/mechanism/mechanism_view.h"
#include "ui/panels/motion_table_panel.h"
#include "ui/panels/timeline.h"
#include "ui/widgets/folding_tabs.h"

#include <QAction>
#include <QComboBox>
#include <QDir>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <QMainWindow>
#include <QScreen>
#include <QSettings>
#include <QSplitter>
#include <QStandardPaths>

#include <algorithm>

namespace slidercrank
{

namespace
{

constexpr int kMaxRecentFiles = 10;

const QString kRecentFiles = "recentFiles";
const QString kSeparator = "\x1f"; // between the paths of joined files, which do not contain it
const QString kTheme = "theme";
const QString kWindow = "layout/window";
const QString kFolded = "layout/folded";
const QString kSplitterPrefix = "layout/";
const QString kSpeed = "view/speed";
const QString kViewPrefix = "view/";

const QString kNotation = "notation"; // JSON, as in a scene
const QString kTablePrefix = "table/";

const QStringList kUnitBoxes{"unit_theta20"};

/// Returns whether a part of the drawing is shown at the first start: the names, dimensions and angles are.
bool isShownAtFirst(const QString &choice)
{
    return QStringList{"showNames", "showDimensions", "showAngles"}.contains(choice);
}

void saveTable(QSettings &settings, const MotionTablePanel &panel)
{
    const MotionTableSettings &table = panel.settings();
    QStringList columns;
    for (const OutputChannel &channel : table.columns) {
        columns << columnName(channel);
    }
    settings.setValue(kTablePrefix + "columns", columns);
    settings.setValue(kTablePrefix + "angleStep", table.angleStep);
    settings.setValue(kTablePrefix + "everyDigit", panel.csvStyle().hasEveryDigit);
    settings.setValue(kTablePrefix + "localSeparators", panel.csvStyle().isLocal);
}

void restoreTable(const QSettings &settings, MotionTablePanel &panel)
{
    MotionTableSettings table = panel.settings();
    if (const QStringList columns = settings.value(kTablePrefix + "columns").toStringList(); !columns.isEmpty()) {
        table.columns.clear();
        for (const QString &column : columns) {
            if (const std::optional<OutputChannel> channel = outputChannelNamed(column.toStdString())) {
                table.columns.push_back(*channel);
            }
        }
    }
    const double step = settings.value(kTablePrefix + "angleStep", table.angleStep).toDouble();
    table.angleStep = step > 0.0 ? step : table.angleStep;
    panel.setSettings(table);
    panel.setCsvStyle({.hasEveryDigit = settings.value(kTablePrefix + "everyDigit", false).toBool(),
                       .isLocal = settings.value(kTablePrefix + "localSeparators", false).toBool()});
}

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
    QSettings().setValue(kRecentFiles, files.mid(0, kMaxRecentFiles));
}

QString recentFolder()
{
    const QList<QStringList> files = recentFiles();
    const QString folder = files.isEmpty() ? QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation)
                                           : QFileInfo(files.first().first()).absolutePath();
    return QDir(folder).exists() ? folder : QDir::homePath();
}

Notation chosenNotation()
{
    const QByteArray json = QSettings().value(kNotation).toByteArray();
    return fromJson<Notation>(QJsonDocument::fromJson(json).object());
}

bool isNotationChosen()
{
    return QSettings().contains(kNotation);
}

void rememberNotation(const Notation &notation)
{
    QSettings().setValue(kNotation, QJsonDocument(toJson(notation).toObject()).toJson(QJsonDocument::Compact));
}

Theme chosenTheme()
{
    const int last = static_cast<int>(Theme::Dark); // limits a damaged setting
    return static_cast<Theme>(std::clamp(QSettings().value(kTheme, 0).toInt(), 0, last));
}

void rememberTheme(Theme theme)
{
    QSettings().setValue(kTheme, static_cast<int>(theme));
}

void saveLayout(const QMainWindow &window)
{
    QSettings settings;
    const FoldingTabs &tabs = tabsIn(window);
    settings.setValue(kWindow, window.saveGeometry());
    settings.setValue(kSpeed, window.findChild<Timeline *>()->speed());
    settings.setValue(kFolded, tabs.isFolded());
    for (const auto *splitter : window.findChildren<QSplitter *>()) {
        if (splitter != tabs.parentWidget() || !tabs.isFolded()) { // while folded, its state contains no height
            settings.setValue(kSplitterPrefix + splitter->objectName(), splitter->saveState());
        }
    }
    for (const QAction *choice : window.findChild<MechanismView *>()->choices()) {
        settings.setValue(kViewPrefix + choice->objectName(), choice->isChecked());
    }
    saveTable(settings, *window.findChild<MotionTablePanel *>());
    for (const QString &name : kUnitBoxes) {
        settings.setValue(kViewPrefix + name, window.findChild<QComboBox *>(name)->currentIndex());
    }
}

void restoreLayout(QMainWindow &window)
{
    const QSettings settings;
    FoldingTabs &tabs = tabsIn(window);
    constexpr QSize kMaxSize(16'384, 16'384); // px: a larger size can only be a damaged one
    const QSize size = window.size();
    window.restoreGeometry(settings.value(kWindow).toByteArray());
    if (window.size() != window.size().boundedTo(kMaxSize)) {
        window.resize(size);
    }
    window.findChild<Timeline *>()->setSpeed(settings.value(kSpeed, 1.0).toDouble());
    for (auto *splitter : window.findChildren<QSplitter *>()) {
        splitter->restoreState(settings.value(kSplitterPrefix + splitter->objectName()).toByteArray());
    }
    constexpr int kMinHeightForTabs = 800; // px: on a lower screen the nine plots need all the space
    tabs.setFolded(settings.value(kFolded, window.screen()->availableSize().height() < kMinHeightForTabs).toBool());
    for (QAction *choice : window.findChild<MechanismView *>()->choices()) {
        const QString name = choice->objectName();
        if (choice->isChecked() != settings.value(kViewPrefix + name, isShownAtFirst(name)).toBool()) {
            choice->trigger();
        }
    }
    restoreTable(settings, *window.findChild<MotionTablePanel *>());
    for (const QString &name : kUnitBoxes) {
        auto *box = window.findChild<QComboBox *>(name);
        if (!settings.contains(kViewPrefix + name)) {
            continue; // the box has the unit of the notation
        }
        box->setCurrentIndex(std::clamp(settings.value(kViewPrefix + name).toInt(), 0, box->count() - 1));
        emit box->activated(box->currentIndex());
    }
}

} // namespace slidercrank
