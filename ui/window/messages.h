// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Shows the messages of the window in its message bar. Each message has a subject; a newer message with the same
// subject replaces it.

#include "ui/document/result.h"
#include "ui/widgets/message_bar.h"

#include <QObject>
#include <QString>

#include <memory>

namespace slidercrank
{

class MainWindow;

class Messages : public QObject
{
    Q_OBJECT

public:
    Messages(MainWindow *window, MessageBar *bar);

    void greetOnce(); ///< greets when the program is started for the first time

private:
    void showRefused(const QStringList &paths, const QString &sentence);
    void showReading(const std::shared_ptr<const Reference> &reference);
    void showTimeRange(const std::shared_ptr<const Reference> &reference, const Sampling &sampling);

    MainWindow *m_window;
    MessageBar *m_bar;
};

} // namespace slidercrank
