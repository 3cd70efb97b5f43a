// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/reference_file.h"

#include "core/import/crank_angles.h"
#include "ui/text/column_text.h"
#include "ui/text/finding_text.h"
#include "ui/text/read_fault_text.h"

#include <QCoreApplication>
#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <algorithm>
#include <new>
#include <optional>

namespace slidercrank
{

namespace
{

struct ReferenceFileText {
    Q_DECLARE_TR_FUNCTIONS(slidercrank::ReferenceFileText)
};

constexpr auto kLargest = static_cast<qint64>(kLargestReferenceFile);
const QString kNameSeparator = " + "; // between the names of joined files

std::string_view toView(const QByteArray &bytes)
{
    return {bytes.constData(), static_cast<std::size_t>(bytes.size())};
}

std::string fileName(const QString &path)
{
    return QFileInfo(path).fileName().toStdString();
}

/// Returns the message about a fault that concerns the whole file.
QString wholeFileFault(ReadFault::Kind kind, const QString &shownName)
{
    return readErrorText(ReadError{0, 0, {}, {kind}}, {shownName});
}

/// Reads a file, a pipe or standard input. Returns a message if that fails. Reads only the beginning if that is not
/// text or if the file is too large.
std::optional<QString> readFile(const QString &path, const std::stop_token &stop, QByteArray &bytes)
{
    constexpr qsizetype kBlock = 1 << 22; // bytes
    QFile file;
    if (const std::optional<QString> sentence = openForReading(file, path)) {
        return sentence;
    }
    const qint64 size = file.size(); // 0 for a pipe
    bytes = file.read(kFileBeginning);
    if (const std::optional<ReadError> error = findForeignFormat(toView(bytes))) {
        return readErrorText(*error, {displayName(path)});
    }
    const auto isTooLarge = [&bytes, size] { return std::max<qint64>(size, bytes.size()) > kLargest; };
    bytes.reserve(static_cast<qsizetype>(std::min(size, kLargest)) + kBlock);
    for (qint64 count = 1; count > 0 && !isTooLarge() && !stop.stop_requested();) {
        const qsizetype done = bytes.size();
        bytes.resize(done + kBlock);
        count = file.read(bytes.data() + done, kBlock);
        bytes.resize(done + std::max<qint64>(count, 0));
    }
    if (const std::optional<QString> sentence = readFailure(file, path)) {
        return sentence;
    }
    if (isTooLarge()) {
        return wholeFileFault(ReadFault::Kind::TooLarge, displayName(path));
    }
    const bool isComplete = bytes.size() >= size || stop.stop_requested();
    return isComplete ? std::nullopt : std::optional(wholeFileFault(ReadFault::Kind::Unreadable, displayName(path)));
}

/// Returns the name for legends: "results.csv", or "results.csv + 2 more".
QString shortName(const QStringList &paths)
{
    const QString name =
        isStandardInput(paths.first()) ? displayName(paths.first()) : QFileInfo(paths.first()).fileName();
    return paths.size() == 1 ? name
                             : ReferenceFileText::tr("%1 + %2 more").arg(name, QString::number(paths.size() - 1));
}

QStringList displayNames(const QStringList &paths)
{
    QStringList names;
    std::ranges::transform(paths, std::back_inserter(names), [](const QString &path) { return displayName(path); });
    return names;
}

} // namespace

FileState fileState(const QString &path)
{
    const QFileInfo file(path);
    return {file.size(), file.lastModified()};
}

QString displayName(const QStringList &paths)
{
    return displayNames(paths).join(kNameSeparator);
}

QString readErrorText(const ReadError &error, const QStringList &files)
{
    const QString file = error.file ? files.value(static_cast<qsizetype>(*error.file)) : files.join(kNameSeparator);
    QString reason = faultText(error.fault);
    if (error.fault.kind == ReadFault::Kind::NoSuchColumn) {
        QStringList headings;
        for (std::size_t i = 0; i < error.layout.columns.size(); ++i) {
            headings += headingText(error.layout, i);
        }
        reason += u' ' + ReferenceFileText::tr("There are: %1.").arg(headings.join(", "));
    }
    if (error.line == 0) {
        return QStringLiteral("%1: %2").arg(file, reason);
    }
    const QString line = QString::number(error.line);
    return error.column == 0
               ? ReferenceFileText::tr("%1, line %2: %3").arg(file, line, reason)
               : ReferenceFileText::tr("%1, line %2, column %3 (\"%4\"): %5")
                     .arg(file, line, QString::number(error.column), QString::fromStdString(error.text), reason);
}

ReferenceOutcome readReference(const ReferenceSource &source, std::stop_token stop, ReadOptions options)
{
    options.columns.insert(options.columns.begin(), source.columns.begin(), source.columns.end());
    auto reference = std::make_shared<Reference>();
    QByteArrayList bytes(source.paths.size());
    std::vector<FileBytes> files;
    for (qsizetype i = 0; i < bytes.size(); ++i) {
        const QString &path = source.paths[i];
        try {
            if (const std::optional<QString> sentence = readFile(path, stop, bytes[i])) {
                return *sentence;
            }
        } catch (const std::bad_alloc &) {
            return wholeFileFault(ReadFault::Kind::NoMemory, displayName(path));
        }
        reference->states.push_back(fileState(path));
        files.push_back({toView(bytes[i]), fileName(path)});
    }
    std::variant<ReferenceData, ReadError> outcome = readFiles(files, stop, options);
    bytes.clear();
    if (const ReadError *error = std::get_if<ReadError>(&outcome)) {
        return readErrorText(*error, displayNames(source.paths));
    }
    reference->paths = source.paths;
    reference->name = shortName(source.paths);
    reference->data = std::move(std::get<ReferenceData>(outcome));
    reference->columns = source.columns;
    std::shared_ptr<const Reference> result = std::move(reference);
    for (const Convention &convention : source.conventions) {
        result = applied(convention, result);
    }
    return result;
}

ReferenceOutcome timedBy(const Mechanism &mechanism, const std::shared_ptr<const Reference> &reference)
{
    if (!reference || !reference->data.crank) {
        return reference;
    }
    std::optional<ReferenceData> data = timedBy(mechanism, reference->data);
    if (!data) {
        return ReferenceFileText::tr("%1 is a table by crank angle, and with ω₂ = %2 the crank does not pass its "
                                     "angles in that order: choose another ω₂.")
            .arg(displayName(reference->paths), parameterText(Parameter::Omega2, mechanism.omega2()));
    }
    auto timed = std::make_shared<Reference>(*reference);
    timed->data = *std::move(data);
    return timed;
}

ReferenceSource toSource(const Reference &reference)
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

QByteArrayList fileChecksums(const Reference &reference)
{
    QByteArrayList checksums;
    for (std::size_t i = 0; i < reference.states.size(); ++i) {
        const QString &path = reference.paths[static_cast<qsizetype>(i)];
        QFile file(path);
        QCryptographicHash hash(QCryptographicHash::Sha256);
        const bool isRead = QFileInfo(path).isFile() && file.open(QIODevice::ReadOnly) && hash.addData(&file) &&
                            fileState(path) == reference.states[i];
        checksums += isRead ? hash.result().toHex() : QByteArray();
    }
    return checksums;
}

QByteArrayList readBeginnings(const QStringList &paths)
{
    constexpr qint64 kLimit = 1 << 20; // bytes: about 15 000 rows of seven columns, which are read in milliseconds
    QByteArrayList beginnings;
    for (const QString &path : paths) {
        QFile file(path);
        QByteArray lines;
        const bool isOpen = QFileInfo(path).isFile() && file.open(QIODevice::ReadOnly);
        while (isOpen && !file.atEnd() && lines.size() < kLimit) {
            lines += file.readLine(kLimit);
        }
        beginnings += lines;
    }
    return beginnings;
}

std::variant<ReferenceData, ReadError> readBytes(const QStringList &paths, const QByteArrayList &bytes,
                                                 const ReadOptions &options)
{
    std::vector<FileBytes> files;
    for (qsizetype i = 0; i < paths.size(); ++i) {
        files.push_back({toView(bytes[i]), fileName(paths[i]), bytes[i].size() < QFileInfo(paths[i]).size()});
    }
    return readFiles(files, {}, options);
}

const FileLayout &layoutOf(const std::variant<ReferenceData, ReadError> &outcome)
{
    const ReferenceData *data = std::get_if<ReferenceData>(&outcome);
    return data ? data->layout : std::get<ReadError>(outcome).layout;
}

FileLayout readLayout(const QStringList &paths)
{
    const FileLayout layout = layoutOf(readBytes(paths, readBeginnings(paths)));
    for (std::size_t i = 0; i < layout.files.size(); ++i) {
        if (std::ranges::count(layout.columns, i, &FileColumn::file) == 0) {
            return {};
        }
    }
    return layout;
}

} // namespace slidercrank
