// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/save_dialog.h"

#include <QCoreApplication>
#include <QFileDialog>
#include <QFileInfo>
#include <QSettings>

#include <algorithm>

namespace slidercrank
{

namespace
{

const QString kLastFolder = "lastFolder";

struct SaveDialogText {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::SaveDialogText)
};

/// Returns "svg" for "SVG drawings (*.svg)", and an empty text for "(*)".
QString suffixOf(const QString &filter)
{
    return filter.section(u'*', -1).chopped(1).mid(1);
}

} // namespace

void chooseFileToSave(QWidget *parent, const SaveRequest &request)
{
    auto *dialog = new QFileDialog(parent, request.title, request.folder);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setNameFilters(request.filters);
    dialog->selectFile(request.name);
    const auto followFilter = [dialog, request](const QString &filter) {
        const QString suffix = suffixOf(filter);
        dialog->setDefaultSuffix(suffix);
        const QFileInfo file(dialog->selectedFiles().value(0));
        const auto isSuffix = [&file](const QString &other) { return suffixOf(other) == file.suffix(); };
        if (!file.suffix().isEmpty() && std::ranges::any_of(request.filters, isSuffix)) {
            dialog->selectFile(file.completeBaseName() + (suffix.isEmpty() ? QString() : u'.' + suffix));
        }
    };
    followFilter(request.filters.first());
    QObject::connect(dialog, &QFileDialog::filterSelected, dialog, followFilter);
    QObject::connect(dialog, &QFileDialog::fileSelected, parent, [parent, request, dialog](const QString &path) {
        const QString filter = dialog->selectedNameFilter();
        const QString completed = completedName(path, filter, request.filters);
        QSettings().setValue(kLastFolder, QFileInfo(completed).absolutePath());
        if (completed == path || !QFileInfo::exists(completed)) {
            request.save(completed, filter);
            return;
        }
        SaveRequest again = request; // the dialog has not asked whether to replace this file
        again.filters.move(again.filters.indexOf(filter), 0);
        again.folder = QFileInfo(completed).absolutePath();
        again.name = QFileInfo(completed).fileName();
        chooseFileToSave(parent, again);
    });
    dialog->open();
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

QString lastFolder(QStandardPaths::StandardLocation otherwise)
{
    const QString last = QSettings().value(kLastFolder).toString();
    return !last.isEmpty() && QFileInfo(last).isDir() ? last : QStandardPaths::writableLocation(otherwise);
}

} // namespace slidercrank
