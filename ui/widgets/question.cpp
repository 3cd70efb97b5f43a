// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/question.h"

#include <QMessageBox>

namespace slidercrank
{

void askBeforeReplacing(QWidget *parent, const QString &title, const QString &question,
                        const std::function<void()> &replace)
{
    auto *box = new QMessageBox(QMessageBox::Question, title, question, QMessageBox::Yes | QMessageBox::No, parent);
    box->setObjectName("replaceQuestion");
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setDefaultButton(QMessageBox::No);
    QObject::connect(box, &QMessageBox::finished, parent, [replace](int answer) {
        if (answer == QMessageBox::Yes) {
            replace();
        }
    });
    box->open();
}

} // namespace slidercrank
