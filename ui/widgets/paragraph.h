// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>

namespace slidercrank
{

/// A label that wraps its text. A word longer than a line, such as a file name, is cut off instead of widening the
/// window.
class Paragraph : public QLabel
{
public:
    explicit Paragraph(const QString &text = {}, QWidget *parent = nullptr);
};

/// Creates a paragraph of plain text that can be selected and copied.
Paragraph *plainText(const QString &text = {});

QLabel *boldLabel(const QString &text);

} // namespace slidercrank
