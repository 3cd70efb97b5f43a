// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Session recovery: while there are unsaved changes, keeps a copy of the scene in the folder of the settings. The copy
// is written two seconds after the last edit, and removed when the scene is saved or the window is closed. After a
// crash the next start offers to restore it. Each copy has a lock file that is released when its process ends, so that
// a window does not offer the copy of another running window.

#include <QLockFile>
#include <QObject>
#include <QString>
#include <QTimer>

#include <memory>

namespace slidercrank
{

class MessageBar;
class SceneFile;
class Session;

class Recovery : public QObject
{
    Q_OBJECT

public:
    Recovery(Session *session, SceneFile *scene, MessageBar *messages, QObject *parent);
    ~Recovery() override; ///< removes the copy

private:
    /// The lock of a copy, which this window holds. Null if there is no copy.
    using Copy = std::unique_ptr<QLockFile>;
    static Copy claim(const QString &path);
    static QString pathOf(const Copy &copy);
    static void remove(Copy &copy);

    void followEdits();
    void write();
    void showOffer();
    void restore();

    Session *m_session;
    SceneFile *m_scene;
    MessageBar *m_messages;
    QTimer m_rest{this};
    Copy m_copy;  ///< of the current scene
    Copy m_offer; ///< was left by a crash, and can be restored
};

} // namespace slidercrank
