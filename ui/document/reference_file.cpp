// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/reference_file.h"

#include "core/reading/crank_angles.h"
#include "ui/document/byte_stream.h"
#include "ui/document/whole_file.h"
#include "ui/words/column_text.h"
#include "ui/words/finding_text.h"
#include "ui/words/read_fault_text.h"

#include <QCoreApplication>
#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <optional>
#include <span>

namespace slidercrank
{

namespace
{

std::string_view viewOf(const QByteArray &bytes)
{
    return {bytes.constData(), static_cast<std::size_t>(bytes.size())};
}

/// The file, for several threads. It outlives what is returned.
ByteSource piecesOf(QFile &file)
{
    const auto mutex = std::make_shared<std::mutex>();
    const auto read = [&file, mutex](std::size_t offset, std::span<char> room) {
        const std::lock_guard lock(*mutex);
        const auto wanted = static_cast<qint64>(room.size());
        return file.seek(static_cast<qint64>(offset)) && file.read(room.data(), wanted) == wanted;
    };
    return {static_cast<std::size_t>(std::max<qint64>(file.size(), 0)), read};
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

} // namespace

QString shownNameOf(const QString &path)
{
    return isStandardInput(path) ? ReferenceFileText::tr("Standard input") : QDir::toNativeSeparators(path);
}

QString sentenceOf(const ReadError &error, const QString &file)
{
    QString reason = sentenceOf(error.fault);
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

std::variant<std::shared_ptr<const Reference>, QString> readReference(const QString &path, std::stop_token stop,
                                                                      const ReadOptions &options)
{
    const QString shown = shownNameOf(path);
    const QFileInfo info(path);
    if (info.isDir()) {
        return ReferenceFileText::tr("%1 is a folder: choose a CSV file.").arg(shown);
    }
    std::variant<ReferenceData, ReadError> outcome;
    QFile file(path);
    if (isStandardInput(path) || isStream(info)) {
        const ReadOptions asChosen{options.columns, {}, options.named};
        std::variant<QByteArray, QString> bytes = readStream(path, stop, [&](const QByteArray &beginning) {
            return std::holds_alternative<ReferenceData>(readReferenceData(viewOf(beginning), {}, asChosen));
        });
        if (const QString *reason = std::get_if<QString>(&bytes)) {
            return cannotBeRead(shown, *reason);
        }
        outcome = readReferenceData(viewOf(std::get<QByteArray>(bytes)), stop, options);
    } else if (file.open(QIODevice::ReadOnly | QIODevice::Unbuffered)) {
        outcome = readReferenceData(piecesOf(file), stop, options);
        if (file.error() != QFileDevice::NoError) {
            return cannotBeRead(shown, withoutFullStop(file.errorString()));
        }
    } else {
        return ReferenceFileText::tr("%1 cannot be opened: %2.").arg(shown, withoutFullStop(file.errorString()));
    }
    if (const ReadError *error = std::get_if<ReadError>(&outcome)) {
        return sentenceOf(*error, shown);
    }
    auto reference = std::make_shared<Reference>();
    reference->path = path;
    reference->name = isStandardInput(path) ? shown : info.fileName();
    reference->state = stateOf(info);
    reference->data = std::move(std::get<ReferenceData>(outcome));
    reference->columns = options.columns;
    return reference;
}

std::variant<std::shared_ptr<const Reference>, QString> readReference(const ReferenceSource &source,
                                                                      std::stop_token stop, ReadOptions options)
{
    options.columns = source.columns;
    std::variant<std::shared_ptr<const Reference>, QString> outcome = readReference(source.path, stop, options);
    if (auto *reference = std::get_if<std::shared_ptr<const Reference>>(&outcome)) {
        for (const Convention &convention : source.conventions) {
            *reference = applied(convention, *reference);
        }
    }
    return outcome;
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
            .arg(shownNameOf(reference->path), parameterText(Parameter::Omega2, mechanism.omega2()));
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
    const std::optional<Unit> unit = unitOf(printed);
    const bool suits = printed.empty() || (role == ColumnRole::CrankAngle ? unitsPerDegree(printed).has_value()
                                                                          : unit && unit->dimension == Dimension::Time);
    std::vector<ColumnChoice> choices = reference.columns;
    std::erase_if(choices, [abscissa](const ColumnChoice &choice) { return choice.column == abscissa; });
    choices.push_back({abscissa, role, {}, suits ? "" : role == ColumnRole::CrankAngle ? "deg" : "s"});
    return choices;
}

ReferenceSource sourceOf(const Reference &reference)
{
    return {QFileInfo(reference.path).absoluteFilePath(), reference.columns, reference.conventions};
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

QByteArray checksumOf(const Reference &reference)
{
    const QFileInfo info(reference.path);
    QFile file(reference.path);
    QCryptographicHash hash(QCryptographicHash::Sha256);
    const bool isRead = !isStream(info) && stateOf(info) == reference.state && file.open(QIODevice::ReadOnly) &&
                        hash.addData(&file) && stateOf(QFileInfo(reference.path)) == reference.state;
    return isRead ? hash.result().toHex() : QByteArray();
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

FileLayout layoutOf(const QByteArray &bytes)
{
    const std::variant<ReferenceData, ReadError> outcome = readReferenceData(viewOf(bytes));
    const ReferenceData *data = std::get_if<ReferenceData>(&outcome);
    return data ? data->layout : std::get<ReadError>(outcome).layout;
}

} // namespace slidercrank
