// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What `compare` and `identify` share: both answer a question about each of several reference files.

#include "app/option_groups.h"
#include "app/records.h"
#include "core/comparison/comparison.h"
#include "core/identification/convention.h"

#include <QJsonArray>

#include <memory>
#include <variant>

namespace slidercrank
{

/// What to read, and where the answers go.
struct ReferenceFiles {
    QList<QStringList> files; ///< each element is one reference, read from one file or joined from several
    std::vector<NamedChoice> columns;
    Format format = Format::Text;
    QString output; ///< empty: standard output
};

ReferenceFiles readReferenceOptions(const OptionReader &options);

/// The answer about one reference.
struct ReferenceAnswer {
    ExitStatus status = ExitStatus::Success;
    QString category;  ///< for the last line about several files: "identified", "differ"
    QString text;      ///< Format::Text
    QByteArray csv;    ///< Format::Csv: rows
    QJsonObject json;  ///< Format::Json
};

/// Reads each reference, writes the answers about all of them, and returns the most severe status. A file that cannot be read is
/// reported, and the others are still answered. `mechanism`: gives time stamps to files that count by the crank angle.
ExitStatus answerEach(const Streams &streams, const ReferenceFiles &references, const Mechanism &mechanism,
                      const QByteArray &csvHeading,
                      const std::function<ReferenceAnswer(const Reference &)> &answer);

/// The reference, with time stamps for this mechanism if the file counts by the crank angle; or the reason why not.
std::variant<std::shared_ptr<const Reference>, QString>
readTimedReference(const ReferenceSource &source, const std::vector<NamedChoice> &columns, const Mechanism &mechanism);

/// Reports rows that were skipped, columns that were not used, and columns whose meaning was guessed.
void reportDoubts(const Streams &streams, const Reference &reference);

/// "file.csv", or "a.csv + b.csv" if several files were joined.
QString joinedName(const QStringList &files);

/// "file.csv: t = 0 s to 1 s, 201 time stamps"
QString headline(const Reference &reference);

/// The JSON members that say which files the reference was read from: "file" and, for several, "joined".
QJsonObject jsonFileMembers(const Reference &reference);
QJsonArray jsonColumns(const FileLayout &layout);
QJsonArray jsonConventions(const std::vector<ConventionFinding> &findings, const ReferenceData &data);

/// The fields of the comparison of one channel. `data`: the reference data that were compared.
Fields<ChannelComparison> comparisonFields(const ReferenceData &data);
QJsonArray jsonComparisons(const std::vector<ChannelComparison> &channels, const ReferenceData &data);

/// "agrees", "close", "differs"
QString verdictName(Verdict verdict);

} // namespace slidercrank
