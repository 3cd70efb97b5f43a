// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// One sentence across the top of the window that can be dismissed, with at most one thing to do about it. Never a box
// in the way.

#include <QFrame>

#include <functional>

class QLabel;
class QPushButton;

namespace slidercrank
{

class MessageBar : public QFrame
{
    Q_OBJECT

public:
    explicit MessageBar(QWidget *parent = nullptr);

    enum class Kind { Hint, Problem };

    /// Replaces the sentence before. Without `remedy` there is only the button that dismisses, which says so, or
    /// `dismissText`.
    void showMessage(Kind kind, const QString &sentence, const QString &remedyText = {},
                     const std::function<void()> &remedy = {}, const QString &dismissText = {});

    QString text() const;

signals:
    void dismissed(); ///< by hand

protected:
    void changeEvent(QEvent *event) override;

private:
    void recolour();

    QLabel *m_symbol;
    QLabel *m_text;
    QPushButton *m_remedyButton;
    QPushButton *m_dismiss;
    std::function<void()> m_remedy;
    Kind m_kind = Kind::Hint;
};

} // namespace slidercrank
