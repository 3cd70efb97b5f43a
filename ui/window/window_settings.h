// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What a window remembers beside its scene from one session to the next: recent files, the theme, how the views are
// arranged, the units, what is drawn beside the linkage and the playback speed.

#include "ui/text/theme.h"

#include <QString>
#include <QStringList>
#include <QVariantMap>

class QMainWindow;

namespace slidercrank
{

inline const QString kRecentScenes = QStringLiteral("recentScenes");
inline const QString kRecentReferences = QStringLiteral("recentReferences");

/// The latest first. `kind`: one of the two above.
QStringList recentFiles(const QString &kind);
void rememberFile(const QString &kind, const QString &path);

/// The same for references, which may be several files, joined.
QList<QStringList> recentReferences();
void rememberReference(const QStringList &paths);

Theme chosenTheme();
void rememberTheme(Theme theme);

/// How the person arranged the window, as settings.
QVariantMap layoutOf(const QMainWindow &window);
QVariantMap rememberedLayout();
void arrange(QMainWindow &window, const QVariantMap &layout);

} // namespace slidercrank
