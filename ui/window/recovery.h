// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Session recovery: while there are unsaved changes, a copy of the scene lies beside the settings, written when the
// person rests for two seconds and removed at a regular end. A copy that a crash left is offered at the next start. Its
// lock ends with the process that wrote it, so that two windows do not offer each other's copies.

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
    ~Recovery() override; ///< a regular end

private:
    /// A file, and the lock that makes it this window's.
    struct Copy {
        QString path;
        std::unique_ptr<QLockFile> lock;
    };
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

    SceneFile *m_scene;
    MessageBar *m_messages;
    QTimer m_rest{this};
    std::optional<Copy> m_copy;
    std::optional<Offer> m_offer;
};

} // namespace slidercrank
