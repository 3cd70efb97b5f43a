// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The values of a calculation by hand that a person types below the current position of the table, and their check. The
// values are kept for each position, and shown again when the crank returns to it.

#include "core/check/check.h"
#include "ui/text/typed_value.h"
#include "ui/widgets/number_table.h"

#include <QCoreApplication>
#include <QString>

#include <map>
#include <vector>

namespace slidercrank
{

/// Returns whether two crank angles (rad) are the same position, except for rounding.
bool isSamePosition(double x, double y);

class MyValues
{
    Q_DECLARE_TR_FUNCTIONS(slidercrank::MyValues)

public:
    /// What the table shows about the values that were typed at a position.
    struct CheckedRow {
        TableRow row;       ///< the typed texts, with the verdicts as colours
        QString conclusion; ///< the sentence below the table; empty if there is nothing to say
    };

    /// Keeps the text of a value at the crank angle theta2 (rad); an empty text removes the value.
    void setText(double theta2, const OutputChannel &channel, const QString &text);

    /// Compares the values that were typed at a position with the exact ones. `channels`: the columns of the table
    /// after t and θ₂.
    CheckedRow check(const CrankPosition &position, const std::vector<OutputChannel> &channels) const;

private:
    /// The values of one position, as they were typed. Only the crank angle identifies the position: the values stay
    /// when a length or a speed is corrected.
    struct TypedTexts {
        double theta2;                       ///< rad, within [-π, π)
        std::map<QString, QString> byColumn; ///< the key is the name of the column; no text is empty
    };

    const TypedTexts *textsAt(double theta2) const; ///< null if no values were typed at this position
    QString positionsText() const;                  ///< says at which crank angles values were typed

    std::vector<TypedTexts> m_positions;
};

} // namespace slidercrank
