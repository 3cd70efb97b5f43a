// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A combo box whose items stand for enumerators, in any order.

#include <QComboBox>
#include <QString>

namespace slidercrank
{

template <typename Enum>
void addChoice(QComboBox *box, Enum choice, const QString &text)
{
    box->addItem(text, static_cast<int>(choice));
}

template <typename Enum>
void choose(QComboBox *box, Enum choice)
{
    box->setCurrentIndex(box->findData(static_cast<int>(choice)));
}

template <typename Enum>
Enum chosen(const QComboBox *box)
{
    return static_cast<Enum>(box->currentData().toInt());
}

} // namespace slidercrank
