// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Messages over the upper right corner of a widget, whose layout they do not move. Hints fade; questions and problems
// wait for a click.

#include <QString>
#include <QWidget>

#include <functional>

class QFrame;
class QVBoxLayout;

namespace slidercrank
{

struct Message {
    enum class Kind { Hint, Question, Problem };
    QString id; ///< what the message is about: a newer one with the same id replaces it
    Kind kind = Kind::Hint;
    QString text;
    QString actionText = {};           ///< of the button that calls `action`
    std::function<void()> action = {}; ///< empty: there is only the button that dismisses the message
    QString dismissText = {};          ///< empty: "Dismiss"
    std::function<void()> dismissed = {};
};

class MessageBar : public QWidget
{
    Q_OBJECT

public:
    explicit MessageBar(QWidget *parent);

    void showMessage(const Message &message);
    void removeMessage(const QString &id);
    void clear();

    QString text() const; ///< of all messages, a line each, the newest first

    /// Shows no message until it is unmuted.
    void setMuted(bool muted);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    QFrame *row(int index) const;
    void remove(QFrame *row);
    void place();

    QVBoxLayout *m_rows;
    bool m_isMuted = false;
};

} // namespace slidercrank
