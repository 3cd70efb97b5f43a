// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The common part of the commands that print results for a mechanism as text, CSV or JSON.

#include "app/option_groups.h"
#include "app/option_words.h"
#include "ui/text/record.h"

namespace slidercrank
{

/// The significant digits of the parameters of a mechanism in a result: enough to tell two mechanisms apart.
inline constexpr int kMechanismDigits = 9;

/// What a command prints in each of the formats, of which one is written, and its exit status.
struct CommandOutput {
    QString text = {};
    std::vector<Record> rows = {};
    QJsonObject json = {};
    ExitStatus status = ExitStatus::Success;
};

/// The mechanism, and the format and the path of the output, as the options state them.
struct Request {
    Mechanism mechanism;
    OutputFormat format;
    QString outputPath; ///< empty: standard output

    /// Switches to English for JSON and CSV, which are the same in every language. Messages that follow are in English,
    /// too.
    explicit Request(const OptionReader &options);

    /// Writes the output in the requested format. Writes nothing if it is empty in that format. Returns the exit status
    /// of the output, or a more severe one if it cannot be written.
    ExitStatus write(const Streams &streams, const CommandOutput &output) const;
};

/// Returns a line for each row. Columns are as wide as their widest cell; all but the first are right-aligned.
QStringList alignedLines(const std::vector<QStringList> &rows);

/// Returns the lines of alignedLines() as one text.
QString alignedTable(const std::vector<QStringList> &rows);

/// Returns the text as a JSON string, or null if it is empty.
QJsonValue jsonText(const QString &text);

} // namespace slidercrank
