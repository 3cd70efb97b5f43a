// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/reference_file.h"

#include "core/import/crank_angles.h"
#include "ui/text/column_text.h"
#include "ui/text/parameter_text.h"
#include "ui/text/read_fault_text.h"

#include <QCoreApplication>
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

constexpr auto kMaxFileSize = static_cast<qint64>(kLargestReferenceFile); // bytes
const QString kNameSeparator = " + ";                                     // between the names of joined files

/// Returns whether the file is so long that its beginning is read first, which shows at once if it is no table.
bool isLong(const QString &path)
{
    constexpr qint64 kMaxSizeAtOnce = 1 << 24; // bytes
    const QFileInfo file(path);
    return file.isFile() && file.size() > kMaxSizeAtOnce;
}

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
    return readErrorText(ReadError{.fault = {.kind = kind}}, {shownName});
}

/// Opens a file, a pipe, or standard input without a buffer.
bool openForReading(QFile &file)
{
    constexpr int kStandardInput = 0; // the descriptor; with `stdin`, the end of a pipe would be an error
    const QIODevice::OpenMode mode = QIODevice::ReadOnly | QIODevice::Unbuffered;
    return isStandardInput(file.fileName()) ? file.open(kStandardInput, mode) : file.open(mode);
}

/// Returns the name for legends: "results.csv", or "results.csv + 2 more".
QString shortName(const QStringList &paths)
{
    const QString name =
        displayName(isStandardInput(paths.first()) ? paths.first() : QFileInfo(paths.first()).fileName());
    return paths.size() == 1 ? name
                             : ReferenceFileText::tr("%1 + %2 more").arg(name, QString::number(paths.size() - 1));
}

QStringList displayNames(const QStringList &paths)
{
    QStringList names;
    for (const QString &path : paths) {
        names << displayName(path);
    }
    return names;
}

} // namespace

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
        reason += u' ' + ReferenceFileText::tr("The columns are: %1.").arg(headings.join(", "));
    }
    if (error.line == 0) {
        return QStringLiteral("%1: %2").arg(file, reason);
    }
    const QString line = QString::number(error.line);
    return error.column == 0
               ? ReferenceFileText::tr("%1, line %2: %3").arg(file, line, reason)
               : ReferenceFileText::tr("%1, line %2, column %3 (“%4”): %5")
                     .arg(file, line, QString::number(error.column), QString::fromStdString(error.text), reason);
}

std::variant<QByteArray, QString> readWhole(const QString &path, ExpectedContent expected)
{
    constexpr qint64 kBlock = 1 << 18; // bytes
    const QString name = displayName(path);
    if (QFileInfo(path).isDir()) {
        return ReferenceFileText::tr("%1 is a folder: choose a file in it.").arg(name);
    }
    QFile file(path);
    if (!openForReading(file)) {
        return ReferenceFileText::tr("%1 cannot be opened: %2.").arg(name, withoutFullStop(file.errorString()));
    }
    QByteArray bytes;
    const qint64 size = file.size(); // 0 for a pipe
    const auto isTooLarge = [&bytes, size] { return std::max<qint64>(size, bytes.size()) > kMaxFileSize; };
    try {
        bytes = file.read(kFileBeginning);
        if (const auto error = expected == ExpectedContent::Table ? findForeignFormat(toView(bytes)) : std::nullopt) {
            return readErrorText(*error, {name});
        }
        bytes.reserve(static_cast<qsizetype>(std::min(size, kMaxFileSize)));
        for (QByteArray block = bytes; !block.isEmpty() && !isTooLarge();) {
            block = file.read(kBlock);
            bytes += block;
        }
    } catch (const std::bad_alloc &) {
        return wholeFileFault(ReadFault::Kind::NoMemory, name);
    }
    if (file.error() != QFileDevice::NoError) {
        return ReferenceFileText::tr("%1 cannot be read: %2.").arg(name, withoutFullStop(file.errorString()));
    }
    if (isTooLarge()) {
        return wholeFileFault(ReadFault::Kind::TooLarge, name);
    }
    return bytes;
}

ReferenceOutcome readReference(const ReferenceSource &source, ReadOptions options, Advice advice)
{
    options.columns.insert(options.columns.begin(), source.columns.begin(), source.columns.end());
    const auto refusal = [&](const ReadError &error) {
        const QString sentence = readErrorText(error, displayNames(source.paths));
        return advice == Advice::None || error.advice.empty()
                   ? sentence
                   : ReferenceFileText::tr("%1 Or add %2").arg(sentence, optionText(error.advice));
    };
    if (source.paths.size() == 1 && isLong(source.paths.first())) {
        ReadOptions optionsOfBeginning = options;
        optionsOfBeginning.progress = {};
        const auto beginning = readBytes(source.paths, readBeginnings(source.paths), optionsOfBeginning);
        if (const ReadError *error = std::get_if<ReadError>(&beginning)) {
            return refusal(*error);
        }
    }
    QByteArrayList contents;
    std::vector<FileBytes> files;
    for (const QString &path : source.paths) {
        std::variant<QByteArray, QString> content = readWhole(path, ExpectedContent::Table);
        if (const QString *sentence = std::get_if<QString>(&content)) {
            return *sentence;
        }
        contents += std::get<QByteArray>(std::move(content));
        files.push_back({.bytes = toView(contents.last()), .name = fileName(path)});
    }
    std::variant<ReferenceData, ReadError> outcome = readFiles(files, options);
    contents.clear();
    if (const ReadError *error = std::get_if<ReadError>(&outcome)) {
        return refusal(*error);
    }
    auto reference = std::make_shared<Reference>();
    reference->source.paths = source.paths;
    reference->name = shortName(source.paths);
    reference->data = std::move(std::get<ReferenceData>(outcome));
    reference->source.columns = source.columns;
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
        return ReferenceFileText::tr("%1 lists crank angles in an order that a crank with ω₂ = %2 cannot reach: "
                                     "choose a different ω₂.")
            .arg(displayName(reference->source.paths), parameterText(Parameter::Omega2, mechanism.omega2()));
    }
    auto timed = std::make_shared<Reference>(*reference);
    timed->data = *std::move(data);
    return timed;
}

std::shared_ptr<const Reference> applied(const Convention &convention,
                                         const std::shared_ptr<const Reference> &reference)
{
    auto converted = std::make_shared<Reference>(*reference);
    converted->data = applied(convention, std::move(converted->data));
    converted->source.conventions.push_back(convention);
    if (!converted->asPrinted) {
        converted->asPrinted = reference;
    }
    return converted;
}

std::optional<ReferenceSource> sourceOverCrankAngle(const Reference &reference)
{
    const FileLayout &layout = reference.data.layout;
    ReferenceSource source = reference.source;
    bool hasTime = false;
    bool hasCrankAngle = false;
    const auto setRole = [&source](std::size_t column, ColumnRole role) {
        const auto chosen = std::ranges::find(source.columns, column, &ColumnChoice::column);
        ColumnChoice choice =
            chosen == source.columns.end() ? ColumnChoice{.column = column} : *chosen; // the chosen unit remains
        choice.role = role;
        source.columns.push_back(choice); // the last choice for a column applies
    };
    for (std::size_t i = 0; i < layout.columns.size(); ++i) {
        const FileColumn &column = layout.columns[i];
        if (column.role == ColumnRole::Time) {
            hasTime = true;
            setRole(i, ColumnRole::Ignored);
        } else if (column.role == ColumnRole::Channel && column.channel == kCrankAngle) {
            hasCrankAngle = true;
            setRole(i, ColumnRole::CrankAngle);
        }
    }
    return layout.files.empty() && hasTime && hasCrankAngle ? std::optional(std::move(source)) : std::nullopt;
}

QByteArrayList readBeginnings(const QStringList &paths)
{
    // Bytes: about 15 000 rows of seven columns, which are read in milliseconds.
    constexpr qint64 kSizeOfBeginning = 1 << 20;
    QByteArrayList beginnings;
    for (const QString &path : paths) {
        QFile file(path);
        QByteArray lines;
        if (QFileInfo(path).isFile() && file.open(QIODevice::ReadOnly)) {
            lines = file.read(kSizeOfBeginning);
            lines += file.readLine(kSizeOfBeginning); // the rest of the last line
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
        files.push_back({.bytes = toView(bytes[i]),
                         .name = fileName(paths[i]),
                         .isBeginning = bytes[i].size() < QFileInfo(paths[i]).size()});
    }
    return readFiles(files, options);
}

const FileLayout &layoutOf(const std::variant<ReferenceData, ReadError> &outcome)
{
    const ReferenceData *data = std::get_if<ReferenceData>(&outcome);
    return data ? data->layout : std::get<ReadError>(outcome).layout;
}

FileLayout readLayout(const QStringList &paths)
{
    return layoutOf(readBytes(paths, readBeginnings(paths)));
}

} // namespace slidercrank
