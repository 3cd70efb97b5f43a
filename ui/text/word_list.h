// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Joins words to a list or a choice, in the user's language.

#include <QString>
#include <QStringList>

namespace slidercrank
{

/// Joins words to a list: "x", "x and y", "x, y and z".
QString listed(const QStringList &words);

/// Joins words to a choice: "x", "x or y", "x, y or z".
QString anyOf(const QStringList &words);

} // namespace slidercrank
