// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Reads reference files from the disk, from a pipe or from standard input, and puts each failure into a sentence.

#include "core/identification/convention.h"
#include "core/import/reference_data.h"
#include "ui/document/whole_file.h"

#include <QByteArray>
#include <QByteArrayList>
#include <QString>
#include <QStringList>

#include <memory>
#include <optional>
#include <variant>
#include <vector>

namespace slidercrank
{

/// Everything that is needed to read reference data again: one file, or several files of one motion that are joined.
struct ReferenceSource {
    QStringList paths;                        ///< as given; "-" is standard input
    std::vector<ColumnChoice> columns = {};   ///< the columns whose meaning the user chose
    std::vector<Convention> conventions = {}; ///< applied to the data, in this order

    friend bool operator==(const ReferenceSource &, const ReferenceSource &) = default;
};

/// Reference data that have been read.
struct Reference {
    ReferenceSource source;
    QString name;                               ///< file name, for legends and titles
    ReferenceData data;                         ///< with the conventions applied
    std::shared_ptr<const Reference> asPrinted; ///< the data without the conventions; null if there are none
};

/// The data, or one sentence that says what is wrong, where, and what to do.
using ReferenceOutcome = std::variant<std::shared_ptr<const Reference>, QString>;

enum class ExpectedContent { Table, Scene };

/// Returns the content of a file, a pipe or standard input; or a message on failure, if the content is too large, or if
/// a table is expected and the bytes have a different format. May run in any thread.
std::variant<QByteArray, QString> readWhole(const QString &path, ExpectedContent expected);

/// What the message about a file that cannot be read ends with: nothing, or the option of the command line that would
/// help.
enum class Advice { None, Option };

/// Reads files, pipes or standard input. May run in any thread.
ReferenceOutcome readReference(const ReferenceSource &source, ReadOptions options = {}, Advice advice = Advice::None);

/// Returns an angle-indexed table with the time stamps at which the crank of the mechanism reaches the angles of the
/// rows, or a sentence if the crank does not reach them in the order of the rows. Returns null, and data that are not
/// angle-indexed, unchanged.
ReferenceOutcome timedBy(const Mechanism &mechanism, const std::shared_ptr<const Reference> &reference);

/// Returns the reference with one more convention applied. Convention::Kind::OtherAssembly does not change the data.
std::shared_ptr<const Reference> applied(const Convention &convention,
                                         const std::shared_ptr<const Reference> &reference);

/// Returns how to read a file that contains both the time and θ2 as a table over the crank angle, as needed for a crank
/// whose speed is not constant. Returns nullopt if it does not contain both, or if several files are joined.
std::optional<ReferenceSource> sourceOverCrankAngle(const Reference &reference);

/// Returns the names of joined files for messages.
QString displayName(const QStringList &paths);

/// Returns a sentence such as "results.csv, line 3, column 2 ("abc"): …". `files`: the names of the files in messages.
QString readErrorText(const ReadError &error, const QStringList &files);

/// Returns the first lines of each file, for a preview; empty for a pipe, and for a file that cannot be read.
QByteArrayList readBeginnings(const QStringList &paths);

/// Reads `bytes` as if they were the content, or the beginning, of the files at `paths`.
std::variant<ReferenceData, ReadError> readBytes(const QStringList &paths, const QByteArrayList &bytes,
                                                 const ReadOptions &options = {});

/// Returns the layout of a file, whether or not the file could be read.
const FileLayout &layoutOf(const std::variant<ReferenceData, ReadError> &outcome);

/// Reads the layout of the files from their first lines.
FileLayout readLayout(const QStringList &paths);

} // namespace slidercrank
