// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFont>
#include <QHash>
#include <QLabel>

namespace slidercrank
{

/// A label that breaks its text into lines. Layouts ask such a label for its height dozens of times, and QLabel sets
/// the whole text anew each time; this one remembers. A word longer than its lines, as a file's name may be, is cut
/// off: the window does not grow for it.
class Paragraph : public QLabel
{
    Q_OBJECT

public:
    explicit Paragraph(const QString &text = {}, QWidget *parent = nullptr);

    int heightForWidth(int width) const override;
    QSize minimumSizeHint() const override;

private:
    // Of which text in which font the heights are.
    mutable QString m_text;
    mutable QFont m_font;
    mutable QHash<int, int> m_heights; ///< by width, px
};

/// A paragraph that can be marked and copied.
Paragraph *plainText(const QString &text = {});

/// In bold.
QLabel *boldLabel(const QString &text);

} // namespace slidercrank
