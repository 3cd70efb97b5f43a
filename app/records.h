// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Tables of text, and the language of JSON and CSV.

#include "app/option_groups.h"
#include "ui/text/record.h"

namespace slidercrank
{

/// A column of a table of text.
struct Column {
    const char *key;
    QString heading;
    int digits = 3; ///< significant digits of a number
};

QString recordTable(const std::vector<Column> &columns, const std::vector<Record> &records);

/// Returns the cells in columns that are as wide as their widest cell. The first row contains the headings. Columns are
/// right-aligned unless one of their cells begins with a letter.
QString alignedTable(const std::vector<QStringList> &rows);

/// Formats a number as one would type it, such as 5.03e-6; a dash if there is none.
QString roundedText(std::optional<double> value, int digits = 3);

/// Null if the text is empty.
QJsonValue jsonText(const QString &text);

/// Switches to English for JSON and CSV, which are the same in every language. Messages that follow are in English,
/// too.
void useLanguageOf(Format format);

} // namespace slidercrank
