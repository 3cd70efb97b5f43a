// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What a window remembers beside its scene: from one run to the next the files, the theme, how the panes were arranged,
// the units, what is drawn beside the linkage and the speed of playing; while it is made anew in another language also
// what else is chosen in its controls.

#include "ui/document/view_settings.h"
#include "ui/text/theme.h"

#include <QByteArray>
#include <QHash>
#include <QString>
#include <QStringList>

#include <optional>

class QMainWindow;

namespace slidercrank
{

inline const QString kRecentScenes = QStringLiteral("recentScenes");
inline const QString kRecentReferences = QStringLiteral("recentReferences");

/// The latest first. `kind`: one of the two above.
QStringList recentFiles(const QString &kind);
void rememberFile(const QString &kind, const QString &path);

/// The same of references, which may be several files, joined.
QList<QStringList> recentReferences();
void rememberReference(const QStringList &paths);

Theme chosenTheme();
void rememberTheme(Theme theme);

/// How a person arranged a window, by the names of its widgets.
struct WindowLayout {
    QByteArray window; ///< its place and size
    QHash<QString, QByteArray> splitters;
    std::optional<bool> folded; ///< the tabs; none: as the height has it
    int tab = 0;
    double speed = 1.0; ///< of playing
    MechanismSettings drawing;
    QHash<QString, int> choices; ///< of combo boxes, and of buttons that stay down; for the next run those of units

    // While the window is there:
    QString focus;
};

/// `foldedByHand`: whether it was a person who folded the tabs, or did not.
WindowLayout windowLayoutOf(const QMainWindow &window, bool foldedByHand);

/// As if the person had chosen it all again.
void arrange(QMainWindow &window, const WindowLayout &layout);

/// For the next run.
void rememberLayout(const WindowLayout &layout);
WindowLayout rememberedLayout();

} // namespace slidercrank
