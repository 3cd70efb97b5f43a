// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window_system.h"

#include <array>
#include <algorithm>

namespace slidercrank
{

namespace
{

/// Options of Qt that are followed by a value. Qt takes them with one dash or two.
constexpr std::array kWithValue{"display", "geometry", "platform", "platformtheme", "qwindowgeometry",
                                "qwindowtitle", "session", "style", "stylesheet", "title"};

bool isOptionOfQt(const QString &argument)
{
    return std::ranges::any_of(kWithValue, [&](const char *name) {
        return argument == u'-' + QLatin1String(name) || argument == QStringLiteral("--") + QLatin1String(name);
    });
}

} // namespace

QStringList withoutWindowSystemOptions(const QStringList &arguments)
{
    QStringList rest;
    for (qsizetype i = 0; i < arguments.size(); ++i) {
        if (isOptionOfQt(arguments[i])) {
            ++i;
        } else {
            rest += arguments[i];
        }
    }
    return rest;
}

bool choosesPlatform(const QStringList &arguments)
{
    return arguments.filter(QStringLiteral("-platform")).size() + arguments.filter(QStringLiteral("-display")).size() > 0;
}

} // namespace slidercrank
