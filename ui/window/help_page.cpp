// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/help_page.h"

#include <QDialogButtonBox>
#include <QTextBrowser>
#include <QUrl>
#include <QVBoxLayout>

namespace slidercrank
{

HelpPage::HelpPage(const QString &title, const QString &anchor, QWidget *window)
    : QDialog(window)
{
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(title);
    auto *text = new QTextBrowser;
    text->setAccessibleName(title);
    text->setSource(QUrl(tr("qrc:/help/english.html", "a resource of the program") + u'#' + anchor));
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
    auto *rows = new QVBoxLayout(this);
    rows->addWidget(text);
    rows->addWidget(buttons);
    constexpr int kLetters = 90;
    resize(kLetters * fontMetrics().averageCharWidth(), kLetters * fontMetrics().averageCharWidth());
}

} // namespace slidercrank
