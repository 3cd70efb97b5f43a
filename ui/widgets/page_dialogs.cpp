// SPDX-License-Identifier: GPL-3.0-or-later

// Files of a page in a browser. The browser chooses files to open, and they are copied into the memory of the page. A
// file to save is written there; app/browser.cpp then hands it over to the browser, which asks for the folder.

#include "ui/widgets/open_dialog.h"
#include "ui/widgets/save_dialog.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileInfo>
#include <QFormLayout>
#include <QLineEdit>
#include <QPointer>
#include <QPushButton>
#include <QRegularExpression>

#include <emscripten.h>
#include <utility>

namespace slidercrank
{

namespace
{

struct PageDialogText {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::PageDialogText)
};

/// The open request that waits for the browser's answer, and the widget that it belongs to.
struct WaitingRequest {
    QPointer<QWidget> parent;
    std::function<void(const QStringList &)> open;
};

WaitingRequest &waitingRequest()
{
    static WaitingRequest request;
    return request;
}

/// Returns ".csv,.txt" for "Tables (*.csv *.txt);;All files (*)".
QString suffixesOf(const QString &filters)
{
    QStringList suffixes;
    static const QRegularExpression kSuffix("\\*(\\.\\w+)");
    for (const QRegularExpressionMatch &match : kSuffix.globalMatch(filters)) {
        suffixes += match.captured(1);
    }
    return suffixes.join(u',');
}

} // namespace

extern "C" EMSCRIPTEN_KEEPALIVE void slidercrankOpenFiles(const char *names)
{
    QStringList paths;
    for (const QString &name : QString::fromUtf8(names).split(u'\n')) {
        paths += QDir::home().filePath(name);
    }
    if (const auto open = std::exchange(waitingRequest().open, {}); open && waitingRequest().parent) {
        open(paths);
    }
}

// clang-format off
EM_JS(void, slidercrankChooseFiles, (const char *suffixes, const char *folder), {
    const input = document.createElement("input");
    const into = UTF8ToString(folder);
    input.type = "file";
    input.multiple = true;
    // A phone would offer no file for suffixes that it does not know.
    input.accept = matchMedia("(pointer: coarse)").matches ? "" : UTF8ToString(suffixes);
    input.style.display = "none";
    document.body.append(input);
    input.onchange = async () => {
        const files = [...input.files];
        input.remove();
        for (const file of files) {
            FS.writeFile(into + "/" + file.name, new Uint8Array(await file.arrayBuffer()));
        }
        const names = stringToNewUTF8(files.map(file => file.name).join("\n"));
        _slidercrankOpenFiles(names);
        _free(names);
    };
    input.oncancel = () => input.remove();
    input.click();
});
// clang-format on

void chooseFilesToOpen(QWidget *parent, const OpenRequest &request)
{
    waitingRequest() = {parent, request.open};
    slidercrankChooseFiles(suffixesOf(request.filters).toUtf8(), QDir::homePath().toUtf8());
}

/// Asks for the name and the format.
void chooseFileToSave(QWidget *parent, const SaveRequest &request)
{
    auto *dialog = new QDialog(parent);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setObjectName("saveInPage");
    dialog->setWindowTitle(request.title);
    auto *name = new QLineEdit(request.name);
    auto *filter = new QComboBox;
    filter->addItems(request.filters);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Save | QDialogButtonBox::Cancel);
    QObject::connect(buttons, &QDialogButtonBox::accepted, dialog, &QDialog::accept);
    QObject::connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::reject);
    QPushButton *save = buttons->button(QDialogButtonBox::Save);
    QObject::connect(name, &QLineEdit::textChanged, save,
                     [save](const QString &text) { save->setEnabled(!QFileInfo(text).fileName().isEmpty()); });
    auto *form = new QFormLayout(dialog);
    form->addRow(PageDialogText::tr("Name"), name);
    form->addRow(PageDialogText::tr("Format"), filter);
    form->addRow(buttons);
    QObject::connect(dialog, &QDialog::accepted, parent, [request, name, filter] {
        const QString path = QDir::home().filePath(QFileInfo(name->text()).fileName());
        request.save(completedName(path, filter->currentText(), request.filters), filter->currentText());
    });
    name->selectAll();
    dialog->open();
}

} // namespace slidercrank
