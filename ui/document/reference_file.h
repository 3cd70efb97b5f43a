// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A reference file on disk, or several that are joined: opened under their Unicode names, read by the core, and their
// failure put into one sentence.

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

/// What tells a file from the same one after somebody wrote to it.
struct FileState {
    qint64 size = -1; ///< bytes
    QDateTime changed;

    friend bool operator==(const FileState &, const FileState &) = default;
};

/// A loaded file and where it came from; or several, a plot each, joined.
struct Reference {
    QStringList paths;             ///< as opened
    QString name;                  ///< file name, for legends and titles
    std::vector<FileState> states; ///< of the files when they were read
    ReferenceData data;            ///< as it reads with the conventions below

    std::vector<ColumnChoice> columns;          ///< a person's, over what the names say
    std::vector<Convention> conventions;        ///< applied, in this order
    std::shared_ptr<const Reference> asPrinted; ///< without any; null: this is it
};

/// Where data come from and how they were read: enough to read them again.
struct ReferenceSource {
    QStringList paths; ///< absolute, or in the program's resources
    std::vector<ColumnChoice> columns;
    std::vector<Convention> conventions;
};

ReferenceSource sourceOf(const Reference &reference);

/// The data, or one sentence that says what is wrong, where, and what to do. May run in any thread. A path "-" is
/// standard input.
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

/// As messages call them.
QString shownNameOf(const QString &path);
QString shownNameOf(const QStringList &paths);

/// "results.csv, line 3, column 2 ("abc"): …". `files`: how they are to be called.
QString sentenceOf(const ReadError &error, const QStringList &files);

/// SHA-256 of each file's bytes, in hexadecimal; empty where they are no longer those that were read, as of a pipe.
/// Reads the whole files: may run in any thread.
QByteArrayList checksumsOf(const Reference &reference);

/// The first lines of a file: enough to see how it is written, and for a preview. Empty where it cannot be read.
QByteArray beginningOf(const QString &path);
QByteArrayList beginningsOf(const QStringList &paths);

/// What files of those names read as that hold these bytes, or begin with them.
std::variant<ReferenceData, ReadError> readBytes(const QStringList &paths, const QByteArrayList &bytes,
                                                 const ReadOptions &options = {});

/// How these bytes are written, whether or not the data are any good; no columns where they cannot be told apart.
FileLayout layoutOf(const QByteArray &bytes);

/// The same of the beginnings of those files; no columns either where one of them has none.
FileLayout layoutOf(const QStringList &paths);

} // namespace slidercrank
