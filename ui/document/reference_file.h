// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A reference file on disk, or several that are joined: opened, read by the core, and each failure put into a sentence.

#include "core/identification/convention.h"
#include "core/import/reference_data.h"

#include <QByteArray>
#include <QByteArrayList>
#include <QDateTime>
#include <QString>
#include <QStringList>

#include <memory>
#include <stop_token>
#include <variant>
#include <vector>

namespace slidercrank
{

/// Changes whenever somebody writes to a file.
struct FileState {
    qint64 size = -1; ///< bytes
    QDateTime changed;

    friend bool operator==(const FileState &, const FileState &) = default;
};

FileState fileState(const QString &path);

/// A reference file that has been read, or several that are joined.
struct Reference {
    QStringList paths;             ///< as opened
    QString name;                  ///< file name, for legends and titles
    std::vector<FileState> states; ///< of the files when they were read
    ReferenceData data;            ///< with the conventions below applied

    std::vector<ColumnChoice> columns;          ///< chosen by a person
    std::vector<Convention> conventions;        ///< applied, in this order
    std::shared_ptr<const Reference> asPrinted; ///< without any convention; null: none is applied
};

/// Everything that is needed to read reference data again.
struct ReferenceSource {
    QStringList paths; ///< absolute, or in the program's resources; "-" is standard input
    std::vector<ColumnChoice> columns;
    std::vector<Convention> conventions;
};

ReferenceSource toSource(const Reference &reference);

/// The data, or one sentence that says what is wrong, where, and what to do.
using ReferenceOutcome = std::variant<std::shared_ptr<const Reference>, QString>;

/// Reads files, pipes or standard input. May run in any thread.
ReferenceOutcome readReference(const ReferenceSource &source, std::stop_token stop = {}, ReadOptions options = {});

/// Its choices of columns, with the time (or crank angle) column taken as `role`, which is Time or CrankAngle.
std::vector<ColumnChoice> withAbscissaAs(ColumnRole role, const Reference &reference);

/// A table by the crank angle with the time stamps at which that mechanism's crank reaches its angles, or a sentence if
/// it does not reach them in their order. Other data, and null, are returned as they are.
ReferenceOutcome timedBy(const Mechanism &mechanism, const std::shared_ptr<const Reference> &reference);

/// With one more convention applied; Branch changes nothing here.
std::shared_ptr<const Reference> applied(const Convention &convention, const std::shared_ptr<const Reference> &to);

/// The name of a file, or the names of joined files, in messages.
QString displayName(const QString &path);
QString displayName(const QStringList &paths);

/// "results.csv, line 3, column 2 ("abc"): …". `files`: their names in messages.
QString readErrorText(const ReadError &error, const QStringList &files);

/// SHA-256 of each file in hexadecimal; empty if the file has changed since it was read, and for a pipe. Reads the
/// whole files; may run in any thread.
QByteArrayList fileChecksums(const Reference &reference);

/// The first lines of each file, for a preview; empty if it cannot be read or is a pipe.
QByteArrayList readBeginnings(const QStringList &paths);

/// What these bytes would be read as if they were the files of those names, or their beginnings.
std::variant<ReferenceData, ReadError> readBytes(const QStringList &paths, const QByteArrayList &bytes,
                                                 const ReadOptions &options = {});

/// How a file is written, whether or not it could be read.
const FileLayout &layoutOf(const std::variant<ReferenceData, ReadError> &outcome);

/// The layout of the files, read from their beginnings; without columns if one of the files has none.
FileLayout readLayout(const QStringList &paths);

} // namespace slidercrank
