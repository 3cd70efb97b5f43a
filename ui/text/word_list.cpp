// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/word_list.h"

#include <QCoreApplication>

namespace slidercrank
{

namespace
{

struct WordList {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::WordList)
};

/// Joins words by a pattern such as "%1 and %2", and all but the last one by commas.
QString joined(const QStringList &words, const QString &pattern)
{
    return words.size() < 2 ? words.join(QString())
                            : pattern.arg(words.first(words.size() - 1).join(", "), words.last());
}

} // namespace

QString listed(const QStringList &words)
{
    return joined(words, WordList::tr("%1 and %2"));
}

QString anyOf(const QStringList &words)
{
    return joined(words, WordList::tr("%1 or %2"));
}

} // namespace slidercrank
