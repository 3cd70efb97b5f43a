// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <QString>

namespace slidercrank
{

/// The help in the language now in use, beside the window. Deletes itself when it is closed.
class HelpPage : public QDialog
{
    Q_OBJECT

public:
    /// `anchor`: the section that is shown first, "theory" or "keys".
    HelpPage(const QString &title, const QString &anchor, QWidget *window);
};

} // namespace slidercrank
