// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Session recovery: while there are unsaved changes, every window keeps a copy of its scene in the folder of the
// settings. The copy is written two seconds after the last edit, and removed when the scene is saved or the window is
// closed. After a crash the next start offers to restore a copy that was left. Each copy has a lock file that is
// released when its process ends, so that a window never offers or replaces the copy of another one that still runs.

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
    ~Recovery() override; ///< removes the copy of this window; a copy that is still offered remains

private:
    /// A copy of a scene that no other process can use while this object exists.
    struct LockedCopy {
        explicit LockedCopy(const QString &scenePath);

        QString path;
        QLockFile lock; ///< check isLocked(): another process may have the copy
    };

    void findOffer();
    void showOffer();
    void restore();
    void discardOffer();
    void followEdits();
    void writeCopy();
    void removeCopy();

    Session *m_session;
    SceneFile *m_scene;
    MessageBar *m_messages;
    std::unique_ptr<LockedCopy> m_copy;  ///< of this window; null as long as nothing has been edited
    std::unique_ptr<LockedCopy> m_offer; ///< left by a crash; the user has not answered the offer yet
    QTimer m_writeDelay{this};
};

} // namespace slidercrank
