// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/panels/page.h"

#include <QStringList>

namespace slidercrank
{

/// Returns the texts of each row of a table: "stroke|43.82 mm||–".
inline QStringList rowTexts(const PageTable &table)
{
    QStringList rows;
    for (const TableRow &row : table.rows) {
        QStringList cells;
        for (const TableCell &cell : row.cells) {
            cells << cell.text;
        }
        rows << cells.join(u'|');
    }
    return rows;
}

} // namespace slidercrank
