// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QApplication>

namespace slidercrank
{

/// What a window has no memory for is given up, and the program goes on.
class Application : public QApplication
{
    Q_OBJECT

public:
    using QApplication::QApplication;

    bool notify(QObject *receiver, QEvent *event) override;

signals:
    void memoryEnded();
};

} // namespace slidercrank
