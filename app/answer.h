// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The common part of the commands that answer a question about a mechanism as text, CSV or JSON.

#include "app/option_groups.h"
#include "app/option_words.h"
#include "ui/text/record.h"

namespace slidercrank
{

/// An answer in each of the formats, of which one is written.
struct Answer {
    QString text = {};
    std::vector<Record> rows = {};
    QJsonObject json = {};
    ExitStatus status = ExitStatus::Success;
};

struct Question {
    Mechanism mechanism;
    OutputFormat format;
    QString output; ///< path; empty: standard output

    /// Switches to English for JSON and CSV, which are the same in every language. Messages that follow are in English,
    /// too.
    explicit Question(const OptionReader &options);

    /// Writes the answer in the requested format. Writes nothing if the answer is empty in that format. Returns the
    /// status of the answer, or a more severe one if it cannot be written.
    ExitStatus write(const Streams &streams, const Answer &answer) const;
};

/// Returns the cells in columns that are as wide as their widest cell. All columns but the first are right-aligned.
QString alignedTable(const std::vector<QStringList> &rows);

/// Returns the text as a JSON string, or null if it is empty.
QJsonValue jsonText(const QString &text);

} // namespace slidercrank
