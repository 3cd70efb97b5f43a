// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Finds the words that a misspelt one may stand for.

#include <QString>
#include <QStringList>

namespace slidercrank
{

/// Returns whether the typed word is the beginning of the known one, or continues it and is at most twice as long. A
/// known word of a single letter has no continuation. Upper and lower case are equal.
bool sharesBeginning(const QString &typed, const QString &known);

/// Returns those of `words` that share their beginning with the typed one. If there are none, or more than a reader
/// wants to choose from, returns those that differ from it by the fewest inserted, omitted, replaced or exchanged
/// neighbouring letters, and by at most one in three letters. Upper and lower case are equal.
QStringList similarWords(const QString &typed, const QStringList &words);

/// Returns the question "Did you mean …?" after a space, or an empty text if there are no words.
QString didYouMean(const QStringList &words);

} // namespace slidercrank
