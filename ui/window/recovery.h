// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Session recovery: while there are unsaved changes, keeps a copy of the scene in the folder of the settings. The copy is
// written two seconds after the last edit, and removed when the scene is saved or the window is closed. After a crash the
// next start offers to restore it. Each copy has a lock file that is released when its process ends, so that a window
// does not offer the copy of another running window.

#include "ui/document/scene.h"

#include <QLockFile>
#include <QObject>
#include <QString>
#include <QTimer>

#include <memory>
#include <optional>

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
    /// The copy of a scene, locked by this window.
    struct Copy {
        QString path;
        std::unique_ptr<QLockFile> lock;
    };
    /// A copy left by a crash, which the user can restore.
    struct Offer {
        Copy copy;
        Scene scene;
    };
    static std::optional<Copy> claim(const QString &path);

    void followEdits();
    void write();
    void removeCopy();
    void findOffer();
    void showOffer();
    void restore();

    Session *m_session;
    SceneFile *m_scene;
    MessageBar *m_messages;
    QTimer m_rest{this};
    std::optional<Copy> m_copy;
    std::optional<Offer> m_offer;
};

} // namespace slidercrank
