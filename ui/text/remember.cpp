// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/remember.h"

#include <QFile>
#include <QSettings>
#include <QTemporaryFile>

namespace slidercrank
{

namespace
{

/// QSettings of Qt 6.4 does not see that the disk is full, and leaves a part of its file or nothing.
bool hasRoomFor(const QSettings &settings)
{
    constexpr qsizetype kEnough = 1 << 16; // bytes, several times what there is to remember
    if (!QFile::exists(settings.fileName())) {
        return true; // nothing to lose, or it is no file but a registry
    }
    QTemporaryFile trial(settings.fileName());
    return trial.open() && trial.write(QByteArray(kEnough, ' ')) == kEnough && trial.flush();
}

} // namespace

void remember(const QVariantMap &choices)
{
    QSettings settings;
    if (!hasRoomFor(settings)) {
        return;
    }
    for (const auto &[key, value] : choices.asKeyValueRange()) {
        if (value.isValid()) {
            settings.setValue(key, value);
        } else {
            settings.remove(key);
        }
    }
}

} // namespace slidercrank
