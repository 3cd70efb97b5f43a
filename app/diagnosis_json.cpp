// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/diagnosis_json.h"

#include "app/json_text.h"
#include "ui/text/column_text.h"
#include "ui/text/convention_text.h"
#include "ui/text/finding_text.h"

#include <optional>

namespace slidercrank
{

namespace
{

const char *wordOf(Convention::Kind kind)
{
    switch (kind) {
    case Convention::Kind::AngleUnit: return "angle-unit";
    case Convention::Kind::LengthUnit: return "length-unit";
    case Convention::Kind::TimeUnit: return "time-unit";
    case Convention::Kind::Sign: return "sign";
    case Convention::Kind::HalfTurn: return "half-turn";
    case Convention::Kind::WholeTurns: return "whole-turns";
    case Convention::Kind::ZeroPoint: return "zero-point";
    case Convention::Kind::SwappedColumns: return "swapped-columns";
    case Convention::Kind::Branch: return "branch";
    case Convention::Kind::TimeShift: return "time-shift";
    case Convention::Kind::NotDerivative: return "not-derivative";
    case Convention::Kind::Axis: return "axis";
    }
    return "";
}

const char *wordOf(Identification::Alternative::Why why)
{
    using Why = Identification::Alternative::Why;
    switch (why) {
    case Why::MirrorImage: return "mirror-image";
    case Why::Reversed: return "reversed";
    case Why::OtherAssembly: return "other-assembly";
    case Why::Alias: return "alias";
    case Why::AnotherMechanism: return "another-mechanism";
    }
    return "";
}

/// By how much, and in what unit; a factor has none, and some conventions have no amount.
struct Amount {
    std::optional<double> value;
    QString unit;
};

Amount amountOf(const Convention &convention)
{
    switch (convention.kind) {
    case Convention::Kind::AngleUnit:
    case Convention::Kind::LengthUnit:
    case Convention::Kind::TimeUnit:
    case Convention::Kind::Sign: return {convention.amount, {}};
    case Convention::Kind::HalfTurn:
    case Convention::Kind::WholeTurns:
    case Convention::Kind::ZeroPoint: return {convention.amount, unitOf(convention.channels.front())};
    case Convention::Kind::TimeShift: return {convention.amount, QStringLiteral("s")};
    case Convention::Kind::SwappedColumns:
    case Convention::Kind::Branch:
    case Convention::Kind::NotDerivative:
    case Convention::Kind::Axis: break;
    }
    return {};
}

QByteArray stringOrNull(const QString &text)
{
    return text.isEmpty() ? QByteArray("null") : jsonString(text);
}

/// "theta3,R4_x", as in options.
QString channelsOf(const Convention &convention)
{
    QStringList names;
    for (const Channel channel : convention.channels) {
        names << columnNameOf(channel);
    }
    return names.join(u',');
}

QString roleOf(const FileColumn &column)
{
    switch (column.role) {
    case ColumnRole::Ignored: return {};
    case ColumnRole::Time: return QStringLiteral("time");
    case ColumnRole::CrankAngle: return QStringLiteral("crank-angle");
    case ColumnRole::Channel: return columnNameOf(column.channel);
    }
    return {};
}

} // namespace

const char *wordOf(Identification::Outcome outcome)
{
    switch (outcome) {
    case Identification::Outcome::Identified: return "identified";
    case Identification::Outcome::Ambiguous: return "ambiguous";
    case Identification::Outcome::Approximate: return "approximate";
    case Identification::Outcome::Insufficient: return "insufficient";
    case Identification::Outcome::Nearest: return "nearest";
    case Identification::Outcome::None: return "none";
    }
    return "";
}

QByteArray jsonFile(const FileLayout &layout, std::size_t file)
{
    return file < layout.files.size() ? "\"file\":" + jsonString(QString::fromUtf8(layout.files[file])) + ','
                                      : QByteArray();
}

QByteArray jsonColumns(const FileLayout &layout)
{
    QByteArrayList columns;
    for (std::size_t i = 0; i < layout.columns.size(); ++i) {
        const FileColumn &column = layout.columns[i];
        columns += '{' + jsonFile(layout, column.file) +
                   "\"heading\":" + stringOrNull(QString::fromUtf8(column.heading)) +
                   ",\"unit\":" + stringOrNull(QString::fromUtf8(column.unit)) +
                   ",\"channel\":" + stringOrNull(roleOf(column)) +
                   ",\"guessed\":" + (isGuess(column.reason) ? "true" : "false") +
                   ",\"why\":" + jsonString(reasonText(layout, i)) + '}';
    }
    return '[' + columns.join(',') + ']';
}

QByteArray jsonOf(const std::vector<ConventionFinding> &findings, const ReferenceData &data)
{
    QByteArrayList conventions;
    for (const ConventionFinding &finding : findings) {
        const Amount amount = amountOf(finding.convention);
        conventions += "{\"name\":\"" + QByteArray(wordOf(finding.convention.kind)) +
                       "\",\"channel\":" + stringOrNull(channelsOf(finding.convention)) +
                       ",\"amount\":" + jsonNumber(amount.value) + ",\"unit\":" + stringOrNull(amount.unit) +
                       ",\"explanation\":" + jsonString(explanationOf(finding.convention, data)) +
                       ",\"before\":" + jsonNumber(finding.before) + ",\"after\":" + jsonNumber(finding.after) + '}';
    }
    return '[' + conventions.join(',') + ']';
}

QByteArray jsonOf(const std::vector<Identification::Alternative> &alternatives)
{
    QByteArrayList mechanisms;
    for (const Identification::Alternative &alternative : alternatives) {
        mechanisms += "{\"mechanism\":" + jsonMechanism(Mechanism(alternative.parameters)) + ",\"why\":\"" +
                      wordOf(alternative.why) + "\"}";
    }
    return '[' + mechanisms.join(',') + ']';
}

QByteArray jsonOf(const std::vector<Identification::Noise> &noise)
{
    QByteArrayList channels;
    for (const Identification::Noise &one : noise) {
        channels += jsonString(columnNameOf(one.channel)) + ':' + jsonNumber(one.rms);
    }
    return '{' + channels.join(',') + '}';
}

QByteArray jsonOf(const std::vector<Identification::LeftOut> &columns)
{
    QByteArrayList channels;
    for (const Identification::LeftOut &column : columns) {
        channels += "{\"channel\":" + jsonString(columnNameOf(column.channel)) +
                    ",\"percentOfPeak\":" + jsonNumber(column.percentOfPeak) + '}';
    }
    return '[' + channels.join(',') + ']';
}

} // namespace slidercrank
