// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What the window says in its message bar: what a file says about itself, with the remedy at hand, what went wrong, and
// the first time ever what there is to do.

#include "ui/document/result.h"
#include "ui/panels/page.h"

#include <QObject>
#include <QString>

#include <memory>

namespace slidercrank
{

class MessageBar;
class SceneFile;
class Session;

class Messages : public QObject
{
    Q_OBJECT

public:
    Messages(Session *session, SceneFile *scene, MessageBar *bar);

    void greetOnce();

    /// In the language now in use; what was not of a file or of the program itself is gone.
    void sayAgain();

public slots:
    void tell(const QString &sentence);
    void tellForNow(const QString &sentence); ///< until something else is on show
    void tellProblem(const QString &sentence);
    void tellRowsCopied(int count);
    void remedy(const slidercrank::Finding &finding);

signals:
    void openReferenceRequested();
    void openSampleRequested();
    void columnsRequested(const QStringList &paths); ///< of that file

private:
    void greet();
    void announceReading();
    void followResult();
    void tellRefusal(const QString &sentence);
    void tellRefused(const QStringList &paths, const QString &sentence);
    QString runSentence() const;

    Session *m_session;
    MessageBar *m_bar;
    QString m_greeting;                       ///< as it was said; empty: it was not
    QString m_forNow;                         ///< likewise, of what is on show
    std::shared_ptr<const Reference> m_runOf; ///< the file whose run the session's became; null: it is another
    Sampling m_run;                           ///< that
};

} // namespace slidercrank
