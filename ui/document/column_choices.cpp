// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/column_choices.h"

#include "ui/document/settings_fields.h"

#include <QCryptographicHash>
#include <QFileInfo>
#include <QJsonDocument>
#include <QSettings>

#include <algorithm>

namespace slidercrank
{

namespace
{

/// Returns the settings key for files of this layout. It is a hash, because headings may contain characters that
/// are not allowed in keys.
QString settingsKey(const FileLayout &layout, const QStringList &paths)
{
    QStringList parts;
    for (const FileColumn &column : layout.columns) {
        parts << QString::fromStdString(column.heading) << QString::fromStdString(column.unit);
    }
    const bool hasHeadings = !parts.join(QString()).isEmpty();
    for (const QString &path : paths) {
        const QFileInfo file(path);
        if (!hasHeadings) {
            parts += file.absoluteFilePath();
        } else {
            parts += paths.size() > 1 ? file.fileName() : QString();
        }
    }
    const QByteArray hash = QCryptographicHash::hash(parts.join(u'\x1f').toUtf8(), QCryptographicHash::Sha256);
    return "columnChoices/" + QString::fromLatin1(hash.toHex());
}

} // namespace

std::vector<ColumnChoice> savedChoices(const FileLayout &layout, const QStringList &paths)
{
    const QByteArray json = QSettings().value(settingsKey(layout, paths)).toByteArray();
    auto choices = fromJson<std::vector<ColumnChoice>>(QJsonDocument::fromJson(json).array());
    std::erase_if(choices, [&](const ColumnChoice &choice) { return choice.column >= layout.columns.size(); });
    return choices;
}

void saveChoices(const FileLayout &layout, const QStringList &paths, const std::vector<ColumnChoice> &choices)
{
    QSettings().setValue(settingsKey(layout, paths), QJsonDocument(toJson(choices).toArray()).toJson());
}

} // namespace slidercrank
