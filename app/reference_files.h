// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What `compare` and `identify` have in common: both report on each of several reference files.

#include "app/command_output.h"
#include "core/comparison/comparison.h"
#include "core/identification/convention.h"

#include <functional>

namespace slidercrank
{

struct ReferenceRequest {
    Request request;          ///< the mechanism, the format and the output
    QList<QStringList> files; ///< each element is one reference: a file, or several files that are joined
    std::vector<ColumnChoice> columns;

    explicit ReferenceRequest(const OptionReader &options);

    /// Reads each reference, writes what `reportOne` returns for each of them, and returns the most severe status. If a
    /// file cannot be read, reports the reason and continues with the next reference. The rows and the JSON that
    /// `reportOne` returns need not describe the file: reportEach() adds its name and columns.
    using ReportOne = std::function<CommandOutput(const Reference &)>;
    ExitStatus reportEach(const Streams &streams, const ReportOne &reportOne) const;
};

/// Reads a reference, and reports rows and columns that are not used or doubtful. An angle-indexed table gets the time
/// stamps of this mechanism. Reports the reason and returns null if the reference cannot be read.
std::shared_ptr<const Reference> readTimedReference(const Streams &streams, const ReferenceSource &source,
                                                    const std::vector<ColumnChoice> &columns,
                                                    const Mechanism &mechanism);

/// Returns the line "file.csv: t = 0 … 1 s, 201 rows".
QString headline(const Reference &reference);

/// Returns the name of a joined file, or undefined if files are not joined.
QJsonValue jsonFile(const FileLayout &layout, std::size_t file);

/// Returns the parameters, or null unless the mechanism exists.
QJsonValue jsonMechanism(bool exists, const Parameters &parameters);

QJsonArray jsonConventions(const std::vector<ConventionFinding> &findings);

Record comparisonRecord(const ChannelComparison &channel);

/// Returns "agrees", "close" or "differs".
const char *verdictName(Verdict verdict);

} // namespace slidercrank
