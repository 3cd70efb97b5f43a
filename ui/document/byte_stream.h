// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What can be read once only, and has no size: pipes, devices, what a system makes up while it is read.

#include <QByteArray>
#include <QString>

#include <functional>
#include <stop_token>
#include <variant>

class QFileInfo;

namespace slidercrank
{

/// What is read from standard input rather than from a file of that name: "-".
bool isStandardInput(const QString &path);

/// There, and neither a file nor a folder.
bool isPipeOrDevice(const QFileInfo &file);

/// Neither a file with something in it nor a folder.
bool isStream(const QFileInfo &file);

/// All of it, or a reason. Waits for who writes it; less where it is told to stop, and only a beginning where nobody
/// goes on with that: some have no end.
std::variant<QByteArray, QString> readStream(const QString &path, const std::stop_token &stop,
                                             const std::function<bool(const QByteArray &beginning)> &goesOn);

} // namespace slidercrank
