// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/open_dialog.h"
#include "ui/widgets/question.h"
#include "ui/widgets/save_dialog.h"

#include <QCoreApplication>
#include <QFileDialog>
#include <QFileInfo>
#include <QSettings>
#include <QStandardPaths>

namespace slidercrank
{

namespace
{

const QString kLastFolder = "lastFolder";

struct NativeDialogText {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::NativeDialogText)
};

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
            const QString question =
                NativeDialogText::tr("%1 exists. Replace it?").arg(QFileInfo(completed).fileName());
            askBeforeReplacing(parent, request.title, question, save);
        } else {
            save();
        }
    });
    dialog->open();
}

void chooseFilesToOpen(QWidget *parent, const OpenRequest &request)
{
    auto *dialog = new QFileDialog(parent, request.title, request.folder, request.filters);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::ExistingFiles);
    QObject::connect(dialog, &QFileDialog::filesSelected, parent, request.open);
    dialog->open();
}

} // namespace slidercrank
