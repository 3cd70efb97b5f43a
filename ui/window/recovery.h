// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Session recovery: while there are unsaved changes, keeps a copy of the scene in the folder of the settings. The copy
// is written two seconds after the last edit, and removed when the scene is saved or the window is closed. After a
// crash the next start offers to restore it. The copy has a lock file that is released when its process ends, so that
// only one window at a time keeps or offers a copy.

#include <QLockFile>
#include <QObject>
#include <QString>
#include <QTimer>

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
    ~Recovery() override; ///< removes the copy, unless it is still offered

private:
    bool lock();
    void followEdits();
    void showOffer();
    void restore();
    void removeCopy();

    Session *m_session;
    SceneFile *m_scene;
    MessageBar *m_messages;
    QString m_path;
    QLockFile m_lock;
    QTimer m_rest{this};
    bool m_isOffered = false; ///< the copy was left by a crash and waits for an answer
};

} // namespace slidercrank
