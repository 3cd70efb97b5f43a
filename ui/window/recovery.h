// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Against a crash: while there are unsaved changes, the scene on show is kept in a file beside the settings, at most
// two seconds old, which is gone after a proper end. What is left of a crash is offered at the next start. A file's
// lock goes with the process that keeps it, so that two windows take nothing from each other.

#include "ui/document/scene.h"
#include "ui/document/work_aside.h"

#include <QLockFile>
#include <QObject>
#include <QString>
#include <QTimer>

#include <memory>
#include <vector>

class QVBoxLayout;

namespace slidercrank
{

class MessageBar;
class SceneFile;
class Session;

class Recovery : public QObject
{
    Q_OBJECT

public:
    /// `column`: on top of which there is a bar where there is something to offer.
    Recovery(Session *session, SceneFile *scene, QVBoxLayout *column, QObject *parent);
    ~Recovery() override; ///< a proper end

    /// In the language now in use.
    void sayAgain();

private:
    /// A file, and the lock that makes it this window's.
    struct Kept {
        QString path;
        std::unique_ptr<QLockFile> lock; ///< null: another has it
    };
    struct Offer {
        Kept kept;
        Scene scene;
        QString file;    ///< that the scene was of; empty: of none
        FileState state; ///< of that file then
    };
    static Kept claim(const QString &path);

    void follow();
    void keep();
    void forget();
    void findOffers();
    void dropWhatIsOnShow();
    void showOffer();
    void restore();
    void discard();

    SceneFile *m_scene;
    QVBoxLayout *m_column;
    MessageBar *m_bar = nullptr; ///< once there was something to offer
    QTimer m_soon{this};
    WorkAside m_writing;               ///< a disk may be slow
    std::shared_ptr<const Kept> m_own; ///< null: there is nothing to keep
    std::vector<Offer> m_offers;       ///< the one on show first
};

} // namespace slidercrank
