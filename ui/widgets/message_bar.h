// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Shows messages over the upper left corner of its parent without changing the layout. Hints disappear by themselves;
// questions and problems wait for a click.

#include <QString>
#include <QWidget>

#include <functional>

class QFrame;
class QVBoxLayout;

namespace slidercrank
{

struct Message {
    enum class Kind { Hint, Question, Problem };
    QString id; ///< a message replaces an older message with the same id
    Kind kind = Kind::Hint;
    QString text;
    QString actionText = {};           ///< text of the button that calls `action`
    std::function<void()> action = {}; ///< if empty, there is only the button that dismisses the message
    QString dismissText = {};          ///< if empty, "Dismiss"
    std::function<void()> dismissed = {};
};

class MessageBar : public QWidget
{
    Q_OBJECT

public:
    explicit MessageBar(QWidget *parent);

    void showMessage(const Message &message);
    void removeMessage(const QString &id);

    /// Hides all messages while muted.
    void setMuted(bool muted);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void remove(QFrame *row);
    void updateGeometryAndVisibility();

    QVBoxLayout *m_rows;
    bool m_isMuted = false;
};

} // namespace slidercrank
