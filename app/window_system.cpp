// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window_system.h"

namespace slidercrank
{

namespace
{

/// Qt takes them with one dash or two.
QString nameOf(const QString &argument)
{
    if (!argument.startsWith(u'-')) {
        return {};
    }
    return argument.mid(argument.startsWith(QStringLiteral("--")) ? 2 : 1);
}

/// The value is the next argument.
bool takesValue(const QString &name)
{
    static const QStringList names{
        QStringLiteral("display"),       QStringLiteral("geometry"),     QStringLiteral("icon"),
        QStringLiteral("name"),          QStringLiteral("platform"),     QStringLiteral("platformpluginpath"),
        QStringLiteral("platformtheme"), QStringLiteral("plugin"),       QStringLiteral("qwindowgeometry"),
        QStringLiteral("qwindowicon"),   QStringLiteral("qwindowtitle"), QStringLiteral("session"),
        QStringLiteral("style"),         QStringLiteral("stylesheet"),   QStringLiteral("title")};
    return names.contains(name);
}

bool standsAlone(const QString &name)
{
    static const QStringList names{QStringLiteral("reverse"), QStringLiteral("nograb"), QStringLiteral("dograb"),
                                   QStringLiteral("widgetcount")};
    return names.contains(name) || name.startsWith(QStringLiteral("style=")) ||
           name.startsWith(QStringLiteral("stylesheet="));
}

} // namespace

QStringList withoutWindowSystemOptions(const QStringList &arguments)
{
    QStringList own;
    for (qsizetype i = 0; i < arguments.size(); ++i) {
        const QString name = nameOf(arguments[i]);
        if (takesValue(name) && i + 1 < arguments.size()) {
            ++i;
        } else if (!standsAlone(name)) {
            own += arguments[i];
        }
    }
    return own;
}

bool chooseDisplay(const QStringList &arguments)
{
    for (const QString &argument : arguments) {
        const QString name = nameOf(argument);
        if (name == QStringLiteral("platform") || name == QStringLiteral("display")) {
            return true;
        }
    }
    return false;
}

} // namespace slidercrank
