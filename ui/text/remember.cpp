// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/remember.h"

#include <QFile>
#include <QSettings>
#include <QTemporaryFile>

namespace slidercrank
{

namespace
{

/// Returns true if the disk has space for the settings. QSettings of Qt 6.4 does not detect a full disk and would
/// truncate its file.
bool hasRoomFor(const QSettings &settings)
{
    constexpr qsizetype kEnough = 1 << 16; // bytes, several times the size of the settings
    if (!QFile::exists(settings.fileName())) {
        return true; // no settings to lose, or they are stored in the registry
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
