// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/save_dialog.h"

#include "ui/text/remember.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QLineEdit>
#include <QMessageBox>
#include <QMimeDatabase>
#include <QPushButton>
#include <QSettings>

namespace slidercrank
{

namespace
{

const QString kLastFolder = QStringLiteral("lastFolder");

struct SaveDialogText {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::SaveDialogText)
};

/// "svg" of "SVG drawings (*.svg)".
QString suffixOf(const QString &filter)
{
    return filter.section(QStringLiteral("*."), -1).chopped(1);
}

QStringList suffixesOf(const QStringList &filters)
{
    QStringList suffixes;
    for (const QString &filter : filters) {
        suffixes += suffixOf(filter);
    }
    suffixes.removeDuplicates();
    return suffixes;
}

/// What was typed, also with quotation marks in it: of those Qt's own dialog would take what stands between two.
QString typedPath(const QFileDialog &dialog)
{
    const auto *edit = dialog.findChild<QLineEdit *>(QStringLiteral("fileNameEdit")); // null: the system's dialog
    const QString typed = edit ? edit->text().trimmed() : QString();
    const bool isQuoted = typed.startsWith(u'"') && typed.endsWith(u'"') && typed.count(u'"') == 2;
    return typed.contains(u'"') && !isQuoted ? dialog.directory().absoluteFilePath(typed)
                                             : dialog.selectedFiles().value(0);
}

/// The same again, with what the person has chosen so far.
SaveRequest again(SaveRequest request, const QString &path, const QString &filter)
{
    request.folder = QFileInfo(path).absolutePath();
    request.name = QFileInfo(path).fileName();
    request.filter = filter;
    return request;
}

void take(QWidget *parent, const SaveRequest &request, const QString &path, const QString &filter)
{
    const auto accept = [filter, save = request.save](const QString &name) {
        remember({{kLastFolder, QFileInfo(name).absolutePath()}});
        save(name, filter);
    };
    const std::optional<QString> name = completedName(path, filter, request.filters);
    if (name && !(request.replaces ? request.replaces(*name) : QFileInfo::exists(*name))) {
        accept(*name);
        return;
    }
    auto *box = new QMessageBox(parent);
    box->setWindowTitle(request.title);
    box->setAttribute(Qt::WA_DeleteOnClose);
    if (name) {
        box->setObjectName(QStringLiteral("replaceQuestion"));
        box->setIcon(QMessageBox::Question);
        box->setText(SaveDialogText::tr("%1 is there already. Replace it?").arg(QDir::toNativeSeparators(*name)));
        box->addButton(SaveDialogText::tr("Replace"), QMessageBox::AcceptRole);
        box->setDefaultButton(box->addButton(QMessageBox::Cancel));
        QObject::connect(box, &QDialog::accepted, parent, [accept, path = *name] { accept(path); });
    } else {
        box->setObjectName(QStringLiteral("suffixRefusal"));
        box->setIcon(QMessageBox::Warning);
        box->setText(SaveDialogText::tr("This cannot be written as .%1: choose a name that ends in .%2.")
                         .arg(QFileInfo(path).suffix(),
                              suffixesOf(request.filters)
                                  .join(SaveDialogText::tr(" or .", "between the endings of file names"))));
        box->addButton(QMessageBox::Close);
    }
    QObject::connect(box, &QDialog::rejected, parent,
                     [parent, next = again(request, path, filter)] { chooseFileToSave(parent, next); });
    box->open();
}

} // namespace

void chooseFileToSave(QWidget *parent, const SaveRequest &request)
{
    auto *dialog = new QFileDialog(parent, request.title, request.folder);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setOption(QFileDialog::DontConfirmOverwrite); // of the name as it is completed
    dialog->setNameFilters(request.filters);
    if (!request.filter.isEmpty()) {
        dialog->selectNameFilter(request.filter);
    }
    dialog->selectFile(request.name);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
#ifdef Q_OS_WIN // its own dialog lets the name follow the kind, and of Qt's names would show the whole path with "/"
    dialog->setDefaultSuffix(suffixOf(request.filter.isEmpty() ? request.filters.value(0) : request.filter));
#else
    QObject::connect(dialog, &QFileDialog::filterSelected, dialog, [dialog, request](const QString &filter) {
        const QFileInfo file(dialog->selectedFiles().value(0));
        if (suffixesOf(request.filters).contains(file.suffix(), Qt::CaseInsensitive)) {
            dialog->selectFile(file.completeBaseName() + u'.' + suffixOf(filter));
        }
    });
#endif
    QObject::connect(dialog, &QDialog::accepted, parent, [parent, request, dialog] {
        take(parent, request, typedPath(*dialog), dialog->selectedNameFilter());
    });
    dialog->open();
}

std::optional<QString> completedName(const QString &path, const QString &filter, const QStringList &filters)
{
    const QString suffix = QFileInfo(path).suffix();
    if (suffixesOf(filters).contains(suffix, Qt::CaseInsensitive)) {
        return path;
    }
    bool isNumber = false; // "b = 67.5", which by its name is a page of a Unix manual
    suffix.toUInt(&isNumber);
    if (!suffix.isEmpty() && !isNumber &&
        !QMimeDatabase().mimeTypesForFileName(QStringLiteral("a.") + suffix).isEmpty()) {
        return std::nullopt;
    }
    return path + (path.endsWith(u'.') ? QString() : QStringLiteral(".")) + suffixOf(filter);
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
