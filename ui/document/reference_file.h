// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A reference file on disk: opened under its Unicode name, read by the core, and its failure put into one sentence.

#include "core/diagnosis/convention.h"
#include "core/reading/reference_data.h"

#include <QByteArray>
#include <QDateTime>
#include <QString>

#include <memory>
#include <stop_token>
#include <variant>
#include <vector>

namespace slidercrank
{

/// What tells a file from the same one after somebody wrote to it.
struct FileState {
    qint64 size = -1; ///< bytes
    QDateTime changed;

    friend bool operator==(const FileState &, const FileState &) = default;
};

/// A loaded file and where it came from.
struct Reference {
    QString path;       ///< as opened
    QString name;       ///< file name, for legends and titles
    FileState state;    ///< of the file when it was read
    ReferenceData data; ///< as it reads with the conventions below

    std::vector<ColumnChoice> columns;          ///< a person's, over what the names say
    std::vector<Convention> conventions;        ///< applied, in this order
    std::shared_ptr<const Reference> asPrinted; ///< without any; null: this is it
};

/// Where data come from and how they were read: enough to read them again.
struct ReferenceSource {
    QString path; ///< absolute, or in the program's resources
    std::vector<ColumnChoice> columns;
    std::vector<Convention> conventions;
};

ReferenceSource sourceOf(const Reference &reference);

/// The data, or one sentence that says what is wrong, where, and what to do. May run in any thread. `path`: "-" is
/// standard input.
std::variant<std::shared_ptr<const Reference>, QString> readReference(const QString &path, std::stop_token stop = {},
                                                                      const ReadOptions &options = {});

/// The same, read as that says.
std::variant<std::shared_ptr<const Reference>, QString>
readReference(const ReferenceSource &source, std::stop_token stop = {}, ReadOptions options = {});

/// Its choices of columns, but with its instants, or what stands in their place, taken for that: Time or CrankAngle.
std::vector<ColumnChoice> withAbscissaAs(ColumnRole role, const Reference &reference);

/// The same with the instants at which that mechanism's crank comes to the angles that the file counts by; a file with
/// instants of its own as it is. Or a sentence, where there are no such instants.
std::variant<std::shared_ptr<const Reference>, QString> timedBy(const Mechanism &mechanism,
                                                                const std::shared_ptr<const Reference> &reference);

/// The same as they read with that convention; Branch changes nothing here.
std::shared_ptr<const Reference> applied(const Convention &convention, const std::shared_ptr<const Reference> &to);

/// The file as it was printed, read with those conventions of `before` whose columns it still reads as that did: what a
/// person said of the others was said of other data.
std::shared_ptr<const Reference> withConventionsOf(const Reference &before,
                                                   const std::shared_ptr<const Reference> &printed);

/// As messages call it.
QString shownNameOf(const QString &path);

/// "results.csv, line 3, column 2 ("abc"): …". `file`: how it is to be called.
QString sentenceOf(const ReadError &error, const QString &file);

/// SHA-256 of the file's bytes, in hexadecimal; empty where they are no longer those that were read, as of a pipe.
/// Reads the whole file: may run in any thread.
QByteArray checksumOf(const Reference &reference);

/// The first lines of the file: enough to see how it is written, and for a preview. Empty where it cannot be read.
QByteArray beginningOf(const QString &path);

/// How these bytes are written, whether or not the data are any good; no columns where they cannot be told apart.
FileLayout layoutOf(const QByteArray &bytes);

} // namespace slidercrank
