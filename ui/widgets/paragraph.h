// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>

namespace slidercrank
{

/// A label that breaks its text into lines. Of a word longer than a line, as a file's name may be, the end is cut off:
/// the window does not grow for it.
class Paragraph : public QLabel
{
public:
    explicit Paragraph(const QString &text = {}, QWidget *parent = nullptr);
};

/// A paragraph that can be selected and copied.
Paragraph *plainText(const QString &text = {});

QLabel *boldLabel(const QString &text);

} // namespace slidercrank
