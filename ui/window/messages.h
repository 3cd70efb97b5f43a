// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What the window says in its message bar. Each message is about something, by which it is replaced or removed.

#include "ui/document/result.h"
#include "ui/widgets/message_bar.h"

#include <QObject>
#include <QString>

#include <memory>

namespace slidercrank
{

class SceneFile;
class Session;

class Messages : public QObject
{
    Q_OBJECT

public:
    Messages(Session *session, SceneFile *scene, MessageBar *bar);

    void greetOnce(); ///< when the program is used for the first time

    /// A message about the result shown; it goes when another result comes.
    void showAboutResult(Message::Kind kind, const QString &sentence);

public slots:
    void confirm(const QString &sentence);
    void confirmCopiedRows(int count);
    void showProblem(const QString &sentence);

signals:
    void openReferenceRequested();
    void openSampleRequested();
    void columnsRequested(const QStringList &paths); ///< the meaning of the columns of these files

private:
    void showRefused(const QStringList &paths, const QString &sentence);
    void showReading(const std::shared_ptr<const Reference> &reference);
    void showTimeRange(const std::shared_ptr<const Reference> &reference, const Sampling &sampling);
    void followSampling(const Sampling &sampling);

    MessageBar *m_bar;
    QStringList m_refused; ///< files that could not be read
    Sampling m_followed;   ///< the time range that was taken from a file
};

} // namespace slidercrank
