// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/save_dialog.h"

#include "ui/widgets/question.h"

#include <QCoreApplication>
#include <QFileDialog>
#include <QFileInfo>
#include <QSettings>
#include <QStandardPaths>

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

/// Returns the folder in which a file was last saved, or that for documents if there is none.
QString lastFolder()
{
    const QString last = QSettings().value(kLastFolder).toString();
    return QFileInfo(last).isDir() ? last : QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
}

} // namespace

void chooseFileToSave(QWidget *parent, const SaveRequest &request)
{
    auto *dialog = new QFileDialog(parent, request.title, request.folder.isEmpty() ? lastFolder() : request.folder);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setNameFilters(request.filters);
    dialog->selectFile(request.name);
    const auto followFilter = [dialog](const QString &filter) { dialog->setDefaultSuffix(suffixOf(filter)); };
    followFilter(request.filters.first());
    QObject::connect(dialog, &QFileDialog::filterSelected, dialog, followFilter);
    QObject::connect(dialog, &QFileDialog::fileSelected, parent, [parent, request, dialog](const QString &path) {
        const QString filter = dialog->selectedNameFilter();
        const QString completed = completedName(path, filter, request.filters);
        const auto save = [request, completed, filter] {
            QSettings().setValue(kLastFolder, QFileInfo(completed).absolutePath());
            request.save(completed, filter);
        };
        const bool isReplaced = completed != path && QFileInfo::exists(completed); // the dialog has not asked about it
        if (isReplaced) {
            const QString question = SaveDialogText::tr("%1 exists. Replace it?").arg(QFileInfo(completed).fileName());
            askBeforeReplacing(parent, request.title, question, save);
        } else {
            save();
        }
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

} // namespace slidercrank
