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

/// Returns the settings key for files with these headings. It is a hash, because headings may contain characters that
/// are not allowed in keys.
QString settingsKey(const FileLayout &layout, const QStringList &paths)
{
    QStringList parts;
    for (const std::string &file : layout.files) {
        parts += QString::fromStdString(file);
    }
    bool hasHeadings = false;
    for (const FileColumn &column : layout.columns) {
        parts << QString::fromStdString(column.heading) << QString::fromStdString(column.unit);
        hasHeadings = hasHeadings || !column.heading.empty();
    }
    for (const QString &path : paths) {
        parts += hasHeadings ? QString() : QFileInfo(path).absoluteFilePath();
    }
    const QByteArray hash = QCryptographicHash::hash(parts.join(u'\x1f').toUtf8(), QCryptographicHash::Sha256);
    return "columnChoices/" + QString::fromLatin1(hash.toHex());
}

} // namespace

std::vector<ColumnChoice> savedChoices(const FileLayout &layout, const QStringList &paths)
{
    std::vector<ColumnChoice> choices;
    const QByteArray json = QSettings().value(settingsKey(layout, paths)).toByteArray();
    for (const QJsonValue &value : QJsonDocument::fromJson(json).array()) {
        choices.push_back(fromJson<ColumnChoice>(value.toObject()));
    }
    std::erase_if(choices, [&](const ColumnChoice &choice) { return choice.column >= layout.columns.size(); });
    return choices;
}

void saveChoices(const FileLayout &layout, const QStringList &paths, const std::vector<ColumnChoice> &choices)
{
    QJsonArray array;
    std::ranges::transform(choices, std::back_inserter(array), toJson<ColumnChoice>);
    QSettings().setValue(settingsKey(layout, paths), QJsonDocument(array).toJson());
}

} // namespace slidercrank
