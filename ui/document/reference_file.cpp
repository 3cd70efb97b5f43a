// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/reference_file.h"

#include "core/import/crank_angles.h"
#include "core/import/unit_text.h"
#include "ui/document/byte_stream.h"
#include "ui/document/whole_file.h"
#include "ui/text/column_text.h"
#include "ui/text/finding_text.h"
#include "ui/text/read_fault_text.h"

#include <QCoreApplication>
#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <algorithm>
#include <cmath>
#include <functional>
#include <new>
#include <optional>
#include <set>
#include <span>

namespace slidercrank
{

namespace
{

std::string_view viewOf(const QByteArray &bytes)
{
    return {bytes.constData(), static_cast<std::size_t>(bytes.size())};
}

/// Gaps, which are NaN, are the same.
bool isSame(std::span<const double> x, std::span<const double> y)
{
    return std::ranges::equal(x, y, [](double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); });
}

/// Whether all that the convention changes reads the same in both.
bool isOfTheSame(const Convention &convention, const ReferenceData &x, const ReferenceData &y)
{
    const bool concernsTime =
        convention.kind == Convention::Kind::TimeUnit || convention.kind == Convention::Kind::TimeShift;
    return (!concernsTime || isSame(x.time, y.time)) && std::ranges::all_of(convention.channels, [&](Channel channel) {
               if (x.crank && y.crank && channel == Channel{Theta2, Order::Position}) {
                   return isSame(x.crank->degrees, y.crank->degrees);
               }
               const ReferenceSeries *of = x.find(channel);
               const ReferenceSeries *other = y.find(channel);
               return of && other && isSame(of->values, other->values);
           });
}

struct ReferenceFileText {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::ReferenceFileText)
};

FileState stateOf(const QFileInfo &info)
{
    return {info.size(), info.lastModified()};
}

QString cannotBeRead(const QString &file, const QString &reason)
{
    return ReferenceFileText::tr("%1 cannot be read: %2.").arg(file, reason);
}

const QString kTogether = QStringLiteral(" + "); // between the names of files that are joined

QStringList shownNamesOf(const QStringList &paths)
{
    QStringList names;
    for (const QString &path : paths) {
        names += shownNameOf(path);
    }
    return names;
}

QString nameOf(const QStringList &paths)
{
    const QString &first = paths.first();
    const QString name = isStandardInput(first) ? shownNameOf(first) : QFileInfo(first).fileName();
    return paths.size() == 1 ? name
                             : ReferenceFileText::tr("%1 + %2 more").arg(name, QString::number(paths.size() - 1));
}

/// The bytes of a file.
struct OpenedFile {
    QByteArray bytes;
    std::string name; ///< without its folder
};

/// Why the file cannot be read, as a sentence; its beginning and its size are looked at first.
std::optional<QString> readFile(const QString &path, QByteArray &bytes)
{
    const QString shown = shownNameOf(path);
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly | QIODevice::Unbuffered)) {
        return ReferenceFileText::tr("%1 cannot be opened: %2.").arg(shown, withoutFullStop(file.errorString()));
    }
    const qint64 size = std::max<qint64>(file.size(), 0);
    const bool isTooLarge = static_cast<std::size_t>(size) > kLargestReferenceFile;
    bytes = file.read(std::min(size, static_cast<qint64>(kFileBeginning)));
    if (isTooLarge) {
        const std::optional<ReadError> foreign = findForeignFormat(viewOf(bytes));
        return sentenceOf(foreign.value_or(ReadError{0, 0, {}, {ReadFault::Kind::TooLarge}}), {shown});
    }
    const qint64 beginning = bytes.size();
    bytes.resize(size);
    qint64 done = beginning;
    for (qint64 more = 1; done < size && more > 0; done += std::max<qint64>(more, 0)) {
        more = file.read(bytes.data() + done, size - done);
    }
    if (file.error() != QFileDevice::NoError) {
        return cannotBeRead(shown, withoutFullStop(file.errorString()));
    }
    return done < size ? std::optional(sentenceOf(ReadError{0, 0, {}, {ReadFault::Kind::Unreadable}}, {shown}))
                       : std::nullopt;
}

/// Where it cannot be read, a sentence. `goesOn`: whether a stream that begins so is worth reading to its end.
std::optional<QString> open(const QString &path, const std::stop_token &stop,
                            const std::function<bool(const QByteArray &beginning)> &goesOn, OpenedFile &opened)
{
    const QString shown = shownNameOf(path);
    const QFileInfo info(path);
    opened.name = info.fileName().toStdString();
    if (info.isDir()) {
        return ReferenceFileText::tr("%1 is a folder: choose a CSV file.").arg(shown);
    }
    if (!isStandardInput(path) && !isStream(info)) {
        return readFile(path, opened.bytes);
    }
    std::variant<QByteArray, QString> bytes = readStream(path, stop, goesOn);
    if (const QString *reason = std::get_if<QString>(&bytes)) {
        return cannotBeRead(shown, *reason);
    }
    opened.bytes = std::get<QByteArray>(std::move(bytes));
    return std::nullopt;
}

FileLayout layoutIn(const std::variant<ReferenceData, ReadError> &outcome)
{
    const ReferenceData *data = std::get_if<ReferenceData>(&outcome);
    return data ? data->layout : std::get<ReadError>(outcome).layout;
}

/// One that is named more than once, whatever the way there.
std::optional<QString> namedTwice(const QStringList &paths)
{
    std::set<QString> before;
    for (const QString &path : paths) {
        const QString file = QFileInfo(path).canonicalFilePath(); // empty where there is none
        if (!file.isEmpty() && !before.insert(file).second) {
            return path;
        }
    }
    return std::nullopt;
}

} // namespace

QString shownNameOf(const QString &path)
{
    return isStandardInput(path) ? ReferenceFileText::tr("Standard input") : QDir::toNativeSeparators(path);
}

QString shownNameOf(const QStringList &paths)
{
    return shownNamesOf(paths).join(kTogether);
}

QString sentenceOf(const ReadError &error, const QStringList &files)
{
    const QString file = error.file ? files.value(static_cast<qsizetype>(*error.file)) : files.join(kTogether);
    ReadFault fault = error.fault;
    if (error.otherFile) {
        fault.heading = files.value(static_cast<qsizetype>(*error.otherFile)).toStdString();
    }
    QString reason = sentenceOf(fault);
    if (error.fault.kind == ReadFault::Kind::NoSuchColumn) {
        QStringList headings;
        for (std::size_t i = 0; i < error.layout.columns.size(); ++i) {
            headings += headingText(error.layout, i);
        }
        reason += u' ' + ReferenceFileText::tr("There are: %1.").arg(headings.join(QStringLiteral(", ")));
    }
    if (error.line == 0) {
        return QStringLiteral("%1: %2").arg(file, reason);
    }
    const QString line = QString::number(error.line);
    if (error.column == 0) {
        return ReferenceFileText::tr("%1, line %2: %3").arg(file, line, reason);
    }
    return ReferenceFileText::tr("%1, line %2, column %3 (\"%4\"): %5")
        .arg(file, line, QString::number(error.column), QString::fromStdString(error.text), reason);
}

std::variant<std::shared_ptr<const Reference>, QString> readReference(const ReferenceSource &source,
                                                                      std::stop_token stop, ReadOptions options)
{
    if (const std::optional<QString> path = namedTwice(source.paths)) {
        return ReferenceFileText::tr("%1 is named twice: give each file once.").arg(shownNameOf(*path));
    }
    options.columns = source.columns;
    const auto goesOn = [&](const QByteArray &beginning) {
        return source.paths.size() > 1 // what the choices say of this file, the others are needed for
                   ? !layoutOf(beginning).columns.empty()
                   : std::holds_alternative<ReferenceData>(
                         readReferenceData(viewOf(beginning), {}, {options.columns, {}, options.named}));
    };
    auto reference = std::make_shared<Reference>();
    std::vector<OpenedFile> files(static_cast<std::size_t>(source.paths.size()));
    std::vector<FileBytes> sources;
    for (OpenedFile &file : files) {
        const QString &path = source.paths[static_cast<qsizetype>(sources.size())];
        try {
            if (const std::optional<QString> sentence = open(path, stop, goesOn, file)) {
                return *sentence;
            }
        } catch (const std::bad_alloc &) {
            return sentenceOf(ReadError{0, 0, {}, {ReadFault::Kind::NoMemory}}, {shownNameOf(path)});
        }
        reference->states.push_back(stateOf(QFileInfo(path)));
        sources.push_back({viewOf(file.bytes), file.name});
    }
    std::variant<ReferenceData, ReadError> outcome = readFiles(sources, stop, options);
    files.clear();
    if (const ReadError *error = std::get_if<ReadError>(&outcome)) {
        return sentenceOf(*error, shownNamesOf(source.paths));
    }
    reference->paths = source.paths;
    reference->name = nameOf(source.paths);
    reference->data = std::move(std::get<ReferenceData>(outcome));
    reference->columns = source.columns;
    std::shared_ptr<const Reference> read = std::move(reference);
    for (const Convention &convention : source.conventions) {
        read = applied(convention, read);
    }
    return read;
}

std::variant<std::shared_ptr<const Reference>, QString> timedBy(const Mechanism &mechanism,
                                                                const std::shared_ptr<const Reference> &reference)
{
    if (!reference || !reference->data.crank) {
        return reference;
    }
    std::optional<ReferenceData> data = timedBy(mechanism, reference->data);
    if (!data) {
        return ReferenceFileText::tr("%1 is a table by crank angle, and with ω₂ = %2 the crank does not pass its "
                                     "angles in that order: choose another ω₂.")
            .arg(shownNameOf(reference->paths), parameterText(Parameter::Omega2, mechanism.omega2()));
    }
    auto timed = std::make_shared<Reference>(*reference);
    timed->data = *std::move(data);
    return timed;
}

std::vector<ColumnChoice> withAbscissaAs(ColumnRole role, const Reference &reference)
{
    const std::vector<FileColumn> &columns = reference.data.layout.columns;
    const auto found = std::ranges::find_if(columns, [](const FileColumn &column) {
        return column.role == ColumnRole::Time || column.role == ColumnRole::CrankAngle;
    });
    const auto abscissa = static_cast<std::size_t>(found - columns.begin());
    const std::string &printed = columns[abscissa].unit;
    const std::optional<Unit> unit = parseUnit(printed);
    const bool suits = printed.empty() || (role == ColumnRole::CrankAngle ? unitsPerDegree(printed).has_value()
                                                                          : unit && unit->dimension == Dimension::Time);
    std::vector<ColumnChoice> choices = reference.columns;
    std::erase_if(choices, [abscissa](const ColumnChoice &choice) { return choice.column == abscissa; });
    choices.push_back({abscissa, role, {}, suits ? "" : role == ColumnRole::CrankAngle ? "deg" : "s"});
    return choices;
}

ReferenceSource sourceOf(const Reference &reference)
{
    QStringList paths;
    for (const QString &path : reference.paths) {
        paths += QFileInfo(path).absoluteFilePath();
    }
    return {paths, reference.columns, reference.conventions};
}

std::shared_ptr<const Reference> applied(const Convention &convention, const std::shared_ptr<const Reference> &to)
{
    auto reference = std::make_shared<Reference>(*to);
    reference->data = applied(convention, std::move(reference->data));
    reference->conventions.push_back(convention);
    if (!reference->asPrinted) {
        reference->asPrinted = to;
    }
    return reference;
}

std::shared_ptr<const Reference> withConventionsOf(const Reference &before,
                                                   const std::shared_ptr<const Reference> &printed)
{
    const ReferenceData &printedBefore = before.asPrinted ? before.asPrinted->data : before.data;
    std::shared_ptr<const Reference> reference = printed;
    for (const Convention &convention : before.conventions) {
        if (isOfTheSame(convention, printedBefore, printed->data)) {
            reference = applied(convention, reference);
        }
    }
    return reference;
}

QByteArrayList checksumsOf(const Reference &reference)
{
    QByteArrayList checksums;
    for (std::size_t i = 0; i < reference.states.size(); ++i) {
        const QString &path = reference.paths[static_cast<qsizetype>(i)];
        const QFileInfo info(path);
        QFile file(path);
        QCryptographicHash hash(QCryptographicHash::Sha256);
        const bool isRead = !isStream(info) && stateOf(info) == reference.states[i] && file.open(QIODevice::ReadOnly) &&
                            hash.addData(&file) && stateOf(QFileInfo(path)) == reference.states[i];
        checksums += isRead ? hash.result().toHex() : QByteArray();
    }
    return checksums;
}

QByteArray beginningOf(const QString &path)
{
    constexpr qint64 kMost = 1 << 20; // some 15 000 rows of seven columns, read again in milliseconds
    if (isStream(QFileInfo(path))) {
        return {}; // what is taken from it is gone
    }
    QFile file(path);
    QByteArray bytes = file.open(QIODevice::ReadOnly) ? file.read(kMost) : QByteArray();
    const qsizetype lines = bytes.lastIndexOf('\n') + 1;
    if (!file.atEnd() && lines > 0) {
        // In little-endian UTF-16 half of the line's end is still to come.
        const bool half = lines % 2 == 1 && lines < bytes.size() && bytes[lines] == '\0';
        bytes.truncate(half ? lines + 1 : lines);
    }
    return bytes;
}

QByteArrayList beginningsOf(const QStringList &paths)
{
    QByteArrayList beginnings;
    for (const QString &path : paths) {
        beginnings += beginningOf(path);
    }
    return beginnings;
}

std::variant<ReferenceData, ReadError> readBytes(const QStringList &paths, const QByteArrayList &bytes,
                                                 const ReadOptions &options)
{
    std::vector<FileBytes> files;
    for (qsizetype i = 0; i < paths.size(); ++i) {
        const QFileInfo info(paths[i]);
        files.push_back({viewOf(bytes[i]), info.fileName().toStdString(), bytes[i].size() < info.size()});
    }
    return readFiles(files, {}, options);
}

FileLayout layoutOf(const QByteArray &bytes)
{
    return layoutIn(readReferenceData(viewOf(bytes)));
}

FileLayout layoutOf(const QStringList &paths)
{
    const FileLayout layout = layoutIn(readBytes(paths, beginningsOf(paths)));
    for (std::size_t i = 0; i < layout.files.size(); ++i) {
        if (std::ranges::count(layout.columns, i, &FileColumn::file) == 0) {
            return {};
        }
    }
    return layout;
}

} // namespace slidercrank
