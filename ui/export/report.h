// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What a report on paper says: the mechanism, how far a reference file is from it and whose motion that file is, the
// figure, the method; and from what it was made: date, program, file, checksum, guessed columns. Blocks of text and
// tables in their order, and places for the two drawings; ui/report_pages puts them on pages.

#include "core/identification/diagnosis.h"
#include "ui/document/result.h"

#include <QByteArrayList>
#include <QDateTime>
#include <QString>
#include <QStringList>

#include <memory>
#include <vector>

namespace slidercrank
{

struct ReportContent {
    std::shared_ptr<const Result> result; ///< not null; its reference may be
    Diagnosis diagnosis;                  ///< of the reference against the mechanism; without one, of no meaning
    bool hasGhost = false;                ///< the drawing shows the file's linkage, too
    QByteArrayList checksums = {};        ///< of the reference's files, in hexadecimal; empty: there is none
    QDateTime written = QDateTime::currentDateTime();
};

struct ReportTable {
    QStringList header;
    std::vector<QStringList> rows; ///< as many cells as the header has
    QString numeric;               ///< a letter a column: n for numbers, which stand to the right, t for text
};

struct ReportBlock {
    enum class Kind {
        Title,
        Heading, ///< stays with what follows it
        Text,
        Agreement, ///< the verdict, good
        Difference,
        Note,      ///< small
        Table,     ///< may go on on the next page
        Mechanism, ///< the drawing, under it the text, beside the table
        Figure     ///< the nine plots on the rest of the page, or on a page of their own
    };
    Kind kind = Kind::Text;
    QString text;
    ReportTable table;
};

std::vector<ReportBlock> reportOf(const ReportContent &content);

} // namespace slidercrank
