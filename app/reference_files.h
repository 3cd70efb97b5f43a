// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What `compare` and `identify` have in common: both answer a question about each of several reference files.

#include "app/answer.h"
#include "core/comparison/comparison.h"
#include "core/identification/convention.h"

#include <functional>

namespace slidercrank
{

struct ReferenceQuestion {
    Question question;        ///< the mechanism, the format and the output
    QList<QStringList> files; ///< each element is one reference: a file, or several files that are joined
    std::vector<ColumnChoice> columns;

    explicit ReferenceQuestion(const OptionReader &options);

    /// Reads each reference, writes the answers about all of them, and returns the most severe status. A file that
    /// cannot be read is reported, and the others are still answered. The rows and the JSON that `answerOne`
    /// returns need not describe the file: answerEach() adds its name and columns.
    using AnswerOne = std::function<Answer(const Reference &)>;
    ExitStatus answerEach(const Streams &streams, const AnswerOne &answerOne) const;
};

/// Reads a reference, and reports rows and columns that are not used or doubtful. An angle-indexed table gets the time
/// stamps of this mechanism. Reports the reason and returns null if the reference cannot be read.
std::shared_ptr<const Reference> readTimedReference(const Streams &streams, const ReferenceSource &source,
                                                    const std::vector<ColumnChoice> &columns,
                                                    const Mechanism &mechanism);

/// "file.csv: t = 0 … 1 s, 201 rows"
QString headline(const Reference &reference);

/// The name of a joined file; undefined if files are not joined.
QJsonValue jsonFile(const FileLayout &layout, std::size_t file);

/// Null unless the mechanism exists.
QJsonValue jsonMechanism(bool exists, const Parameters &parameters);

QJsonArray jsonConventions(const std::vector<ConventionFinding> &findings);

Record comparisonRecord(const ChannelComparison &channel);

/// "agrees", "close" or "differs".
const char *verdictName(Verdict verdict);

} // namespace slidercrank
