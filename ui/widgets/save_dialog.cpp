// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/save_dialog.h"

#include <QCoreApplication>

#include <algorithm>

namespace slidercrank
{

namespace
{

struct SaveDialogText {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::SaveDialogText)
};

} // namespace

QString suffixOf(const QString &filter)
{
    return filter.section(u'*', -1).chopped(1).mid(1);
}

QString completedName(const QString &path, const QString &filter, const QStringList &filters)
{
    const QString suffix = suffixOf(filter);
    const auto fits = [&path](const QString &known) {
        return path.endsWith(u'.' + suffixOf(known), Qt::CaseInsensitive);
    };
    if (suffix.isEmpty() || std::ranges::any_of(filters, fits)) {
        return path;
    }
    return path + (path.endsWith(u'.') ? QString() : ".") + suffix;
}

QStringList figureFilters()
{
    return {SaveDialogText::tr("PNG images (*.png)"), SaveDialogText::tr("SVG drawings (*.svg)"),
            SaveDialogText::tr("PDF documents (*.pdf)")};
}

} // namespace slidercrank
