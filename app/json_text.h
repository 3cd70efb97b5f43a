// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Numbers and strings as text that every program reads the same, whatever the locale; JSON written in the order of the
// contract, which a sorted document would lose.

#include "core/mechanism/mechanism.h"

#include <QByteArray>
#include <QString>

#include <optional>

namespace slidercrank
{

/// While there is one, sentences are English and their numbers have points: JSON is the same in every language.
class InEnglish
{
public:
    InEnglish();
    ~InEnglish();
    Q_DISABLE_COPY_MOVE(InEnglish)
};

/// 17 significant digits as in CSV, but null where there is none: JSON knows no nan.
void appendJsonNumber(QByteArray &text, double value);

/// The fewest digits that read back the same; null for what does not exist.
QByteArray jsonNumber(std::optional<double> value);

/// Quoted and escaped, UTF-8.
QByteArray jsonString(const QString &text);

/// {"a", "b", "c", "omega2", "theta20", "branch"}: mm and rad, as the options.
QByteArray jsonMechanism(const Mechanism &mechanism);

} // namespace slidercrank
