// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/column_choices.h"

#include "ui/text/remember.h"

#include <QCryptographicHash>
#include <QFileInfo>
#include <QSettings>
#include <QStringList>

#include <algorithm>

namespace slidercrank
{

namespace
{

constexpr char kSeparator = '\x1f'; // of the parts of a key or a choice: no heading and no unit holds it

/// Headings may hold anything, and keys in the settings may not: so they are hashed.
QString keyOf(const FileLayout &layout, const QStringList &paths)
{
    QByteArray headings;
    const bool named = std::any_of(layout.columns.begin(), layout.columns.end(),
                                   [](const FileColumn &column) { return !column.heading.empty(); });
    for (const FileColumn &column : layout.columns) {
        headings += QByteArray::fromStdString(column.heading) + kSeparator;
        headings += QByteArray::fromStdString(column.unit) + kSeparator;
    }
    for (const std::string &file : layout.files) {
        headings += QByteArray::fromStdString(file) + kSeparator;
    }
    for (const QString &path : named ? QStringList() : paths) {
        headings += QFileInfo(path).absoluteFilePath().toUtf8();
    }
    const QByteArray hash = QCryptographicHash::hash(headings, QCryptographicHash::Sha256).left(16);
    return QStringLiteral("columnChoices/") + QString::fromLatin1(hash.toHex());
}

QString roleName(const ColumnChoice &choice)
{
    switch (choice.role) {
    case ColumnRole::Ignored: return QStringLiteral("ignored");
    case ColumnRole::Time: return QStringLiteral("time");
    case ColumnRole::CrankAngle: return QStringLiteral("crank-angle");
    case ColumnRole::Channel: return QString::fromUtf8(nameOf(choice.channel));
    }
    return {};
}

} // namespace

std::vector<ColumnChoice> rememberedChoices(const FileLayout &layout, const QStringList &paths)
{
    std::vector<ColumnChoice> choices;
    const QStringList lines = QSettings().value(keyOf(layout, paths)).toStringList();
    for (const QString &line : lines) {
        const QStringList parts = line.split(QLatin1Char(kSeparator));
        ColumnChoice choice;
        choice.column = parts.value(0).toULongLong();
        choice.unit = parts.value(2).toStdString();
        const QString role = parts.value(1);
        if (const std::optional<Channel> channel = channelNamed(role.toStdString())) {
            choice.role = ColumnRole::Channel;
            choice.channel = *channel;
        } else if (role == QLatin1String("time")) {
            choice.role = ColumnRole::Time;
        } else if (role == QLatin1String("crank-angle")) {
            choice.role = ColumnRole::CrankAngle;
        }
        if (choice.column < layout.columns.size()) {
            choices.push_back(choice);
        }
    }
    return choices;
}

void rememberChoices(const FileLayout &layout, const QStringList &paths, const std::vector<ColumnChoice> &choices)
{
    QStringList lines;
    for (const ColumnChoice &choice : choices) {
        lines << QStringList{QString::number(choice.column), roleName(choice), QString::fromStdString(choice.unit)}
                     .join(QLatin1Char(kSeparator));
    }
    remember({{keyOf(layout, paths), lines.isEmpty() ? QVariant() : lines}});
}

} // namespace slidercrank
